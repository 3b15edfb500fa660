//! Curvature from a mesh: baked per vertex, uploaded as vertex buffers, interpolated by the rasteriser.

use barchan_asset::{
    Asset, AssetWriter, Azimuths, Codec, CurvatureColumn, CurvatureTable, CurvatureView, DistanceTable, Encoding,
    HeightTable, HorizonTable, LengthUnit, SectionKind, SurfaceForms, VertexFormat, Wrap,
};
use barchan_bakers::Exec;
use barchan_bakers::curvature::{CurvatureParams, bake, forms};
use barchan_field::Mesh;
use barchan_field::surfaces::{ParametricSurface, Pattern, Tessellation};
use barchan_shade::FundamentalForms;
use barchan_wgpu::Technique;
use glam::DVec2;

use super::draw::{Drawing, vertex_buffer};
use crate::compare::agree;
use crate::support::{Loaded, grid, numbers};

/// Pixels along each side; texture coordinates from 0 to 1¼ are drawn.
const SIDE: u32 = 128;

/// A torus of some hundred vertices: convex outside, a saddle inside.
fn torus() -> Mesh {
    let tessellation = Tessellation { vertices: 400, pattern: Pattern::Jittered, seed: 3, uv_seam: true };
    ParametricSurface::Torus { major: 1.0, minor: 0.4 }.tessellate(&tessellation).unwrap().mesh
}

/// The least map there is, and the curvature of a mesh.
fn file(mesh: &Mesh, encoding: Encoding) -> Vec<u8> {
    let exec = Exec::new(1).unwrap();
    let found = bake(mesh, &CurvatureParams::default(), &exec).unwrap();
    let forms: Vec<_> =
        forms(mesh, &found, &exec).unwrap().iter().map(|form| SurfaceForms::nearest(form.first, form.second)).collect();
    let principal: Vec<_> = found.vertices.iter().map(|vertex| vertex.principal.map(|k| k as f32)).collect();
    let curvature = CurvatureTable {
        length_unit: LengthUnit::Metre,
        principal: &principal,
        directions: None,
        forms: Some(&forms),
        uv_directions: None,
        flags: &[],
    };
    let (grid, azimuths) = (grid((1, 1), (1.0, 1.0), (Wrap::Clamp, Wrap::Clamp)), Azimuths::full_circle(1));
    let radius = 1.0;
    let mut writer = AssetWriter::new();
    for table in [
        HeightTable { grid, values: &[0.0] }.encode(Encoding::F32).unwrap(),
        HorizonTable { grid, azimuths, radius, values: &[0.0] }.encode(Encoding::F32).unwrap(),
        DistanceTable { grid, azimuths, radius, values: &[0.0] }.encode(Encoding::F32).unwrap(),
    ] {
        writer.add_table(table, Codec::Raw).unwrap();
    }
    writer.add_curvature(curvature.encode(encoding).unwrap(), Codec::Raw).unwrap();
    writer.finish().unwrap()
}

/// Pixels of texture coordinates, where a rasteriser that keeps a 16th of a pixel keeps them exactly.
fn pixels(mesh: &Mesh) -> Vec<DVec2> {
    let pixel = |uv: &DVec2| (*uv * f64::from(SIDE) / 1.25 * 16.0).round() / 16.0;
    mesh.uvs().unwrap().iter().map(pixel).collect()
}

fn drawn(loaded: &Loaded, mesh: &Mesh, direction: DVec2) -> Vec<[f32; 4]> {
    let columns = loaded.plan.curvature().unwrap();
    let scale = |column| columns.column(column).unwrap().scale;
    let stages = format!(
        "
struct Corner {{
    @builtin(position) position: vec4<f32>,
    @location(0) first: vec3<f32>,
    @location(1) second: vec3<f32>,
}}

@vertex
fn vertices(@location(0) pixel: vec2<f32>, @location(1) first: vec3<f32>, @location(2) second: vec3<f32>) -> Corner {{
    let position = vec2<f32>(pixel.x, -pixel.y) * {:?} + vec2<f32>(-1.0, 1.0);
    return Corner(vec4<f32>(position, 0.0, 1.0), {:?} * first, {:?} * second);
}}

@fragment
fn fragments(in: Corner) -> @location(0) vec4<f32> {{
    return vec4<f32>(barchan_curvature_along(in.first, in.second, vec2<f32>({:?}, {:?})), 1.0, in.first.x, in.second.x);
}}
",
        2.0 / f64::from(SIDE),
        scale(CurvatureColumn::FirstForm),
        scale(CurvatureColumn::SecondForm),
        direction.x,
        direction.y,
    );
    let bytes = |pixel: &DVec2| [pixel.x, pixel.y].map(|number| (number as f32).to_le_bytes()).concat();
    let positions = vertex_buffer(&pixels(mesh).iter().flat_map(bytes).collect::<Vec<_>>());
    let attribute = |format, shader_location| [wgpu::VertexAttribute { format, offset: 0, shader_location }];
    let format = |column| match columns.column(column).unwrap().format {
        VertexFormat::Float32x3 => wgpu::VertexFormat::Float32x3,
        VertexFormat::Float16x4 => wgpu::VertexFormat::Float16x4,
        other => panic!("{other:?} holds no form"),
    };
    let attributes = [
        attribute(wgpu::VertexFormat::Float32x2, 0),
        attribute(format(CurvatureColumn::FirstForm), 1),
        attribute(format(CurvatureColumn::SecondForm), 2),
    ];
    let layout = |k: usize| wgpu::VertexBufferLayout {
        array_stride: attributes[k][0].format.size(),
        step_mode: wgpu::VertexStepMode::Vertex,
        attributes: &attributes[k],
    };
    let column = |column| loaded.asset.column(column).unwrap();
    let buffers = [
        (layout(0), &positions),
        (layout(1), column(CurvatureColumn::FirstForm)),
        (layout(2), column(CurvatureColumn::SecondForm)),
    ];
    let indices: Vec<u8> = mesh.triangles().as_flattened().iter().flat_map(|index| index.to_le_bytes()).collect();
    let drawing = Drawing {
        stages: &stages,
        topology: wgpu::PrimitiveTopology::TriangleList,
        buffers: &buffers,
        vertices: mesh.triangles().as_flattened().len() as u32,
        indices: Some(&vertex_buffer(&indices)),
        size: (SIDE, SIDE),
    };
    drawing.draw(loaded, &[Technique::CurvedShadow]).unwrap()
}

/// By barycentric coordinates of pixels' centres; nothing where no triangle is, or a pixel's centre nearly on its border.
fn expected(loaded: &Loaded, mesh: &Mesh, direction: DVec2) -> Vec<Option<f64>> {
    let asset = Asset::open(&loaded.bytes).unwrap();
    let section = asset.section(SectionKind::CURVATURE).unwrap();
    let view = CurvatureView::new(section.curvature().unwrap(), section.raw_payload().unwrap()).unwrap();
    let form = |vertex: u32| {
        let forms = view.forms(vertex).unwrap();
        FundamentalForms { first: forms.first.map(f64::from), second: forms.second.map(f64::from) }
    };
    let pixels = pixels(mesh);
    let mut curvatures = vec![None; (SIDE * SIDE) as usize];
    for triangle in mesh.triangles() {
        let [a, b, c] = triangle.map(|vertex| pixels[vertex as usize]);
        let corners = triangle.map(form);
        let area = (b - a).perp_dot(c - a);
        let (low, high) = (a.min(b).min(c).max(DVec2::ZERO), a.max(b).max(c).min(DVec2::splat(f64::from(SIDE))));
        for row in low.y as u32..high.y.ceil() as u32 {
            for pixel in low.x as u32..high.x.ceil() as u32 {
                let p = DVec2::new(f64::from(pixel) + 0.5, f64::from(row) + 0.5);
                let weights =
                    [(b - p).perp_dot(c - p), (c - p).perp_dot(a - p), (a - p).perp_dot(b - p)].map(|w| w / area);
                if weights.iter().all(|&weight| weight > 1e-3) {
                    let between = FundamentalForms::interpolated(corners.each_ref(), weights);
                    curvatures[(row * SIDE + pixel) as usize] = Some(between.along(direction.x, direction.y));
                }
            }
        }
    }
    curvatures
}

#[test]
fn forms_of_vertices_are_interpolated_to_the_curvature_of_every_pixel() {
    let mesh = torus();
    for encoding in [Encoding::F32, Encoding::F16] {
        let loaded = Loaded::new(file(&mesh, encoding));
        for direction in [DVec2::new(1.0, 0.0), DVec2::new(0.9, -0.4)] {
            let expected = expected(&loaded, &mesh, direction);
            let drawn = drawn(&loaded, &mesh, direction);
            let (mut found, mut known) = (numbers(&drawn, 0), Vec::new());
            for (found, expected) in found.iter_mut().zip(&expected) {
                *found = expected.map_or(0.0, |_| *found);
                known.push(expected.unwrap_or(0.0));
            }
            let covered = expected.iter().flatten().count();
            assert!(covered * 2 > expected.len(), "{covered} pixels are covered");
            let (least, greatest) = known.iter().fold((0.0_f64, 0.0_f64), |(lo, hi), &k| (lo.min(k), hi.max(k)));
            assert!(least < -0.3 && greatest > 0.5, "curvatures of both signs: {least} to {greatest}");
            let name = format!("mesh_{encoding:?}_{}", direction.y);
            let worst = agree(&name, (SIDE, SIDE), &found, &known, 1e-5, 0.0);
            eprintln!("{name}: {worst:e} of {covered} pixels, {least} to {greatest}");
        }
    }
}
