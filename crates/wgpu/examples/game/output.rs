//! Where the game's pictures go: to a window, or to memory. As in any program on `wgpu`; nothing here knows of Barchan.

use std::sync::Arc;
use std::time::{Duration, Instant};

use anyhow::{Context, Result, bail};
use image::RgbaImage;
use wgpu::*;
use winit::application::ApplicationHandler;
use winit::dpi::PhysicalSize;
use winit::event::WindowEvent;
use winit::event_loop::{ActiveEventLoop, EventLoop};
use winit::window::WindowId;

use super::Game;

/// The device that draws, to a surface if there is one.
fn open(instance: &Instance, surface: Option<&Surface<'_>>) -> Result<(Adapter, Device, Queue)> {
    let options = RequestAdapterOptions { compatible_surface: surface, ..Default::default() };
    let adapter = pollster::block_on(instance.request_adapter(&options)).context(
        "no GPU was found; a software one is enough: on Debian, apt-get install -y mesa-vulkan-drivers libvulkan1",
    )?;
    let (device, queue) = pollster::block_on(adapter.request_device(&DeviceDescriptor::default()))?;
    Ok((adapter, device, queue))
}

/// A texture that is drawn on and not kept.
pub(super) fn attachment(device: &Device, size: Extent3d, sample_count: u32, format: TextureFormat) -> TextureView {
    texture(device, size, sample_count, format, TextureUsages::RENDER_ATTACHMENT).create_view(&Default::default())
}

fn texture(device: &Device, size: Extent3d, sample_count: u32, format: TextureFormat, usage: TextureUsages) -> Texture {
    device.create_texture(&TextureDescriptor {
        label: None,
        size,
        mip_level_count: 1,
        sample_count,
        dimension: TextureDimension::D2,
        format,
        usage,
        view_formats: &[],
    })
}

/// The picture of an asset after some seconds.
pub(super) fn picture(file: &[u8], [width, height]: [u32; 2], seconds: f32) -> Result<RgbaImage> {
    let instance = Instance::new(InstanceDescriptor::new_without_display_handle_from_env());
    let (_, device, queue) = open(&instance, None)?;
    let format = TextureFormat::Rgba8UnormSrgb;
    let game = Game::new(device.clone(), queue.clone(), file, format)?;
    let size = Extent3d { width, height, depth_or_array_layers: 1 };
    let target = texture(&device, size, 1, format, TextureUsages::RENDER_ATTACHMENT | TextureUsages::COPY_SRC);
    game.draw(&target, seconds);

    let row_bytes = (4 * width).next_multiple_of(COPY_BYTES_PER_ROW_ALIGNMENT);
    let buffer = device.create_buffer(&BufferDescriptor {
        label: None,
        size: u64::from(row_bytes) * u64::from(height),
        usage: BufferUsages::COPY_DST | BufferUsages::MAP_READ,
        mapped_at_creation: false,
    });
    let layout = TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(row_bytes), rows_per_image: None };
    let mut encoder = device.create_command_encoder(&Default::default());
    encoder.copy_texture_to_buffer(target.as_image_copy(), TexelCopyBufferInfo { buffer: &buffer, layout }, size);
    queue.submit([encoder.finish()]);
    let (sender, mapped) = std::sync::mpsc::channel();
    buffer.slice(..).map_async(MapMode::Read, move |result| drop(sender.send(result)));
    device.poll(PollType::wait_indefinitely())?;
    mapped.recv()??;
    let rows = buffer.slice(..).get_mapped_range()?;
    let pixels = rows.chunks_exact(row_bytes as usize).flat_map(|row| &row[..4 * width as usize]).copied().collect();
    RgbaImage::from_raw(width, height, pixels).context("the picture has fewer pixels than it should")
}

/// A window, and the game in it.
struct Shown {
    window: Arc<winit::window::Window>,
    surface: Surface<'static>,
    settings: SurfaceConfiguration,
    game: Game,
    device: Device,
    queue: Queue,
}

impl Shown {
    fn open(events: &ActiveEventLoop, file: &[u8], [width, height]: [u32; 2]) -> Result<Self> {
        let attributes = winit::window::Window::default_attributes().with_title("Barchan");
        let window = Arc::new(events.create_window(attributes.with_inner_size(PhysicalSize::new(width, height)))?);
        let display = Box::new(events.owned_display_handle());
        let instance = Instance::new(InstanceDescriptor::new_with_display_handle_from_env(display));
        let surface = instance.create_surface(Arc::clone(&window))?;
        let (adapter, device, queue) = open(&instance, Some(&surface))?;
        let settings = surface.get_default_config(&adapter, width, height);
        let mut settings = settings.context("the GPU does not draw on this window")?;
        // Colours are encoded as sRGB when they are written.
        let formats = surface.get_capabilities(&adapter).formats;
        settings.format = formats.into_iter().find(TextureFormat::is_srgb).context("the window has no sRGB format")?;
        let game = Game::new(device.clone(), queue.clone(), file, settings.format)?;
        surface.configure(&device, &settings);
        Ok(Self { window, surface, settings, game, device, queue })
    }

    fn resize(&mut self, size: PhysicalSize<u32>) {
        (self.settings.width, self.settings.height) = (size.width.max(1), size.height.max(1));
        self.surface.configure(&self.device, &self.settings);
    }

    fn draw(&mut self, seconds: f32) -> Result<()> {
        match self.surface.get_current_texture() {
            CurrentSurfaceTexture::Success(frame) | CurrentSurfaceTexture::Suboptimal(frame) => {
                self.game.draw(&frame.texture, seconds);
                self.window.pre_present_notify();
                self.queue.present(frame);
            }
            CurrentSurfaceTexture::Outdated => self.resize(self.window.inner_size()),
            // Nobody sees it.
            CurrentSurfaceTexture::Timeout | CurrentSurfaceTexture::Occluded => {
                std::thread::sleep(Duration::from_millis(50));
            }
            CurrentSurfaceTexture::Lost | CurrentSurfaceTexture::Validation => bail!("the window is lost"),
        }
        self.window.request_redraw();
        Ok(())
    }
}

/// The game's window, as the system opens, resizes and closes it.
struct App<'a> {
    file: &'a [u8],
    size: [u32; 2],
    seconds: f32,
    start: Instant,
    shown: Option<Shown>,
    result: Result<()>,
}

impl App<'_> {
    fn end(&mut self, events: &ActiveEventLoop, result: Result<()>) {
        self.result = result;
        events.exit();
    }
}

impl ApplicationHandler for App<'_> {
    fn resumed(&mut self, events: &ActiveEventLoop) {
        match Shown::open(events, self.file, self.size) {
            Ok(shown) => self.shown = Some(shown),
            Err(error) => self.end(events, Err(error)),
        }
    }

    fn window_event(&mut self, events: &ActiveEventLoop, _: WindowId, event: WindowEvent) {
        let Some(shown) = &mut self.shown else { return };
        match event {
            WindowEvent::CloseRequested => self.end(events, Ok(())),
            WindowEvent::Resized(size) => shown.resize(size),
            WindowEvent::RedrawRequested => {
                if let Err(error) = shown.draw(self.seconds + self.start.elapsed().as_secs_f32()) {
                    self.end(events, Err(error));
                }
            }
            _ => {}
        }
    }
}

/// Shows the game in a window until that is closed.
pub(super) fn window(file: &[u8], size: [u32; 2], seconds: f32) -> Result<()> {
    let events = EventLoop::new().context("no window can be opened here; -o draws a picture without one")?;
    let mut app = App { file, size, seconds, start: Instant::now(), shown: None, result: Ok(()) };
    events.run_app(&mut app)?;
    app.result
}
