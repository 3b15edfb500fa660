// A height field seen from straight above.

struct PictureView {
    // Texels per pixel across and down.
    texels: vec2<f32>,
    unused: vec2<f32>,
}

@group(1) @binding(1) var<uniform> picture_view: PictureView;

fn picture_place(position: vec4<f32>) -> vec2<f32> {
    return picture_centre(position) * picture_view.texels - 0.5;
}
