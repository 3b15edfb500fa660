//! The curvature of a mesh: what is stored, what is left out, and what is said of it.

use std::io::Cursor;
use std::path::Path;

use barchan_asset::{Asset, CurvatureColumn, CurvatureView, Limits, validate};
use barchan_field::surfaces::{Pattern, Tessellation};
use barchan_field::{LengthUnit, ParametricSurface, Shape};
use barchan_pipeline::{
    BakeReport, CurvatureEncoding, CurvatureMethod, CurvaturePart, CurvatureProvenance, MeshOrigin, MeshSource,
    PipelineError, Plan, Provenance, Recipe, Run, Scene, ShapeSource, Source, SurfaceSource, Table, bake,
};

const TORUS: ParametricSurface = ParametricSurface::Torus { major: 2.0, minor: 0.5 };

fn torus(uv_seam: bool) -> SurfaceSource {
    let tessellation = Tessellation { vertices: 2000, pattern: Pattern::Jittered, seed: 3, uv_seam };
    SurfaceSource { surface: TORUS, tessellation }
}

/// A torus in centimetres, stored exactly.
fn recipe(uv_seam: bool) -> Recipe {
    let mut recipe = Recipe::bare_mesh(MeshSource::Surface(Box::new(torus(uv_seam))));
    recipe.unit = Some(LengthUnit::Centimetre);
    recipe.curvature.encoding = CurvatureEncoding::F32;
    recipe
}

/// [`recipe`] with gentle relief beside the mesh.
fn recipe_with_relief() -> Recipe {
    let level = Shape::Plane(barchan_field::shapes::Plane { slope_u: 0.1, slope_v: 0.0 });
    let mut recipe = recipe(false);
    recipe.source = Some(Source::Shape(ShapeSource { shape: level, width: 8, height: 8 }));
    recipe.spacing = barchan_field::Spacing::new(0.05, 0.05).unwrap();
    recipe.horizon.directions = 4;
    recipe
}

/// A file in memory, and what was said of it.
struct Baked {
    bytes: Vec<u8>,
    report: BakeReport,
}

fn bake_on(threads: usize, recipe: Recipe, only: Option<&[Table]>) -> Result<Baked, PipelineError> {
    let run = Run { folder: Path::new("meshes"), threads, progress: &|_, _, _| {} };
    let baked = bake(&Plan::new(recipe, only), &run, Cursor::new(Vec::new()))?;
    Ok(Baked { bytes: baked.out.into_inner(), report: baked.report })
}

fn baked(recipe: Recipe) -> Baked {
    bake_on(2, recipe, None).unwrap()
}

/// Calls `look` with the curvature table of a file.
fn with_table<T>(bytes: &[u8], look: impl FnOnce(&CurvatureView<'_>) -> T) -> T {
    let section = Asset::open(bytes).unwrap().section(Table::Curvature.kind()).unwrap();
    let payload = section.payload(&Limits::default()).unwrap();
    look(&CurvatureView::new(section.curvature().unwrap(), &payload).unwrap())
}

fn provenance(bytes: &[u8]) -> Provenance {
    let asset = Asset::open(bytes).unwrap();
    serde_json::from_slice(&asset.sections().last().unwrap().payload(&Limits::default()).unwrap()).unwrap()
}

#[test]
fn what_is_baked_is_valid_and_said_in_the_report() {
    let Baked { bytes, report } = baked(recipe(true));
    assert_eq!(validate(&bytes, &Limits::default()), []);
    let mesh = TORUS.tessellate(&torus(true).tessellation).unwrap().mesh;
    let said = report.mesh.unwrap();
    assert_eq!((said.source.as_str(), said.path, said.unit), ("generated torus", None, "cm"));
    assert_eq!((said.vertices, said.triangles), (mesh.positions().len() as u64, mesh.triangles().len() as u64));
    let [table] = &report.tables[..] else { panic!("{:?}", report.tables) };
    assert_eq!((table.table, table.unit, table.reason), ("curvature", "1/cm", "what the mesh is there for"));
    let section = Asset::open(&bytes).unwrap().section(Table::Curvature.kind()).unwrap();
    assert_eq!((table.stored_bytes, table.raw_bytes), (section.stored_length(), section.raw_length()));
    let columns: Vec<_> =
        table.columns.iter().map(|column| (column.column, column.unit, column.encoding_max)).collect();
    assert_eq!(columns, [("principal", "1/cm", 0.0), ("first_form", "cm²", 0.0), ("second_form", "cm", 0.0)]);
    assert_eq!((report.source, report.grid, report.horizon, report.swept), (None, None, None, None));
}

#[test]
fn curvature_is_that_of_the_closed_form() {
    for uv_seam in [false, true] {
        let truth = TORUS.tessellate(&torus(uv_seam).tessellation).unwrap().parameters;
        let Baked { bytes, .. } = baked(recipe(uv_seam));
        with_table(&bytes, |table| {
            let (mut errors, mut sizes) = (0.0, 0.0);
            for (vertex, uv) in (0..).zip(&truth) {
                let [k1, k2] = TORUS.jet(uv.x, uv.y).curvature().principal;
                let [found1, found2] = table.principal(vertex).map(f64::from);
                errors += 0.5 * ((found1 - k1).powi(2) + (found2 - k2).powi(2));
                sizes += k1.abs().max(k2.abs()).powi(2);
            }
            assert_eq!(table.vertices() as usize, truth.len());
            let error = f64::sqrt(errors / sizes);
            assert!(error < 0.005, "{error}");
        });
    }
}

/// Along any direction of texture space the forms say what Euler's formula says with principal curvatures and their images.
#[test]
fn forms_and_principal_curvatures_agree() {
    let mut recipe = recipe(true);
    recipe.curvature.uv_directions = true;
    let Baked { bytes, .. } = baked(recipe);
    with_table(&bytes, |table| {
        for vertex in 0..table.vertices() {
            let forms = table.forms(vertex).unwrap();
            for (curvature, [du, dv]) in table.principal(vertex).into_iter().zip(table.uv_directions(vertex).unwrap()) {
                let along = |[a, b, c]: [f32; 3]| a * du * du + 2.0 * b * du * dv + c * dv * dv;
                assert!((along(forms.first) - 1.0).abs() < 1e-3, "unit directions: {}", along(forms.first));
                let found = along(forms.second) / along(forms.first);
                assert!((found - curvature).abs() < 1e-3 * 2.0, "vertex {vertex}: {found} and {curvature}");
            }
        }
    });
}

/// The parts that a report leaves out.
fn left_out(report: &BakeReport) -> Vec<(&'static str, &'static str, u64)> {
    report.left_out.iter().map(|left| (left.table, left.reason, left.bytes_saved)).collect()
}

#[test]
fn parts_are_baked_where_somebody_can_use_them() {
    let parts = |bytes: &[u8]| {
        with_table(bytes, |table| {
            let has = |part: &CurvaturePart| part.columns().iter().all(|&column| table.column(column).is_some());
            CurvaturePart::ALL.into_iter().filter(has).map(CurvaturePart::name).collect::<Vec<_>>()
        })
    };
    let baked_with = |uv_seam, directions, uv_directions| {
        let mut recipe = recipe(uv_seam);
        (recipe.curvature.directions, recipe.curvature.uv_directions) = (directions, uv_directions);
        parts(&baked(recipe).bytes)
    };
    assert_eq!(baked_with(false, None, false), ["principal", "directions"]);
    assert_eq!(baked_with(false, Some(false), false), ["principal"]);
    assert_eq!(baked_with(true, None, false), ["principal", "forms"]);
    assert_eq!(baked_with(true, Some(true), true), ["principal", "directions", "forms", "uv_directions"]);
}

#[test]
fn what_is_left_out_is_said_with_what_it_saves() {
    let no_uvs = "the mesh has no texture coordinates";
    let mut recipe = recipe(false);
    for (encoding, [forms, uv_directions]) in [(CurvatureEncoding::F32, [24, 16]), (CurvatureEncoding::F16, [16, 8])] {
        recipe.curvature.encoding = encoding;
        let Baked { report, .. } = baked(recipe.clone());
        let vertices = report.mesh.as_ref().unwrap().vertices;
        let expected = [
            ("curvature.forms", no_uvs, vertices * forms),
            ("curvature.uv_directions", no_uvs, vertices * uv_directions),
            ("curvature.flags", "there is nothing to remark on any vertex", vertices * 4),
        ];
        assert_eq!(left_out(&report), expected);
    }
}

#[test]
fn an_open_surface_has_its_border_flagged() {
    let surface = ParametricSurface::Saddle { valley_radius: 2.0, ridge_radius: 3.0, size: 1.0 };
    let tessellation = Tessellation { vertices: 400, ..torus(false).tessellation };
    let mut recipe = recipe(false);
    recipe.mesh = Some(MeshSource::Surface(Box::new(SurfaceSource { surface, tessellation })));
    let Baked { bytes, report } = baked(recipe);
    let CurvatureProvenance { flagged, .. } = report.curvature.unwrap();
    let [border] = &flagged[..] else { panic!("{flagged:?}") };
    assert_eq!(border.flag, "boundary");
    assert!((40..200).contains(&border.vertices), "{}", border.vertices);
    assert!(with_table(&bytes, |table| table.column(CurvatureColumn::Flags).is_some()));
}

#[test]
fn provenance_reads_back_as_it_was_written() {
    let mut recipe = recipe(true);
    recipe.curvature.method = CurvatureMethod::Fast;
    recipe.curvature.hard_edge_degrees = 12.5;
    let (settings, Baked { bytes, report }) = (recipe.curvature, baked(recipe));
    let provenance = provenance(&bytes);
    let mesh = provenance.mesh.unwrap();
    assert_eq!(mesh.source, MeshOrigin::Surface(Box::new(torus(true))));
    assert_eq!(mesh.vertices, report.mesh.unwrap().vertices);
    let curvature = provenance.curvature.unwrap();
    assert_eq!(Some(&curvature), report.curvature.as_ref());
    assert_eq!((curvature.algorithm.as_str(), curvature.method), ("curvature-jets-1", CurvatureMethod::Fast));
    assert_eq!(curvature.hard_edge_degrees, 12.5);
    assert_eq!(provenance.recipe.curvature, Some(settings));
    assert_eq!((provenance.recipe.tables, provenance.input), (vec!["curvature".to_owned()], None));
    let encodings: Vec<_> = provenance.encodings.iter().map(|encoding| encoding.table.as_str()).collect();
    assert_eq!(encodings, ["curvature.principal", "curvature.first_form", "curvature.second_form"]);
}

#[test]
fn the_same_bytes_on_one_thread_and_on_several() {
    for recipe in [recipe(true), recipe_with_relief()] {
        let on = |threads| bake_on(threads, recipe.clone(), None).unwrap().bytes;
        let one = on(1);
        assert!(on(2) == one && on(3) == one);
    }
}

#[test]
fn relief_on_a_mesh_is_swept_over_its_curvatures() {
    let Baked { bytes, report } = baked(recipe_with_relief());
    assert_eq!(validate(&bytes, &Limits::default()), []);
    let range = report.swept.unwrap().on_mesh.unwrap();
    // κ2 = −1 / (R − r) on the inner equator, κ1 = 1 / r everywhere.
    assert!((range.mesh.0 + 1.0 / 1.5).abs() < 0.07 && (range.mesh.1 - 2.0).abs() < 0.2, "{range:?}");
    assert_eq!(range.mesh, range.swept);

    let mut named = recipe_with_relief();
    named.scene = Some(Scene { curvature: Some((0.0, 0.5)), ..Scene::default() });
    assert_eq!(baked(named).report.swept.unwrap().on_mesh, None);
    // For the range the mesh is looked at, though its table is not wanted.
    let only = bake_on(1, recipe_with_relief(), Some(&[Table::SweptHorizon, Table::SweptDistance])).unwrap().report;
    assert_eq!(only.swept.unwrap().on_mesh, Some(range));
}

#[test]
fn a_range_is_cut_to_what_texels_and_radius_allow() {
    let mut recipe = recipe_with_relief();
    recipe.spacing = barchan_field::Spacing::new(1.0, 1.0).unwrap();
    recipe.horizon.radius = Some(8.0);
    let range = baked(recipe).report.swept.unwrap().on_mesh.unwrap();
    assert!((range.swept.0 + std::f64::consts::PI / 8.0).abs() < 1e-6, "half round a hollow: {range:?}");
    assert!((range.swept.1 - 1.0).abs() < 1e-6, "one texel: {range:?}");
}

#[test]
fn what_cannot_be_is_refused_and_named() {
    let fails = |recipe: Recipe, only: Option<&[Table]>| bake_on(1, recipe, only).err().unwrap();
    let no_heights = fails(recipe(true), Some(&[Table::Curvature, Table::Horizon]));
    assert_eq!(no_heights.to_string(), "horizon cannot be baked: there is no height map");
    let mut no_mesh = recipe_with_relief();
    no_mesh.mesh = None;
    assert_eq!(fails(no_mesh, Some(&[Table::Curvature])).to_string(), "curvature cannot be baked: there is no mesh");
    let mut no_uvs = recipe(false);
    no_uvs.curvature.uv_directions = true;
    assert!(matches!(fails(no_uvs, None), PipelineError::NoTextureCoordinates));
    let mut steep = recipe(false);
    steep.curvature.hard_edge_degrees = f64::NAN;
    let words = "curvature: hard_edge_degrees is NaN; an angle from 0 to 180 is accepted";
    assert_eq!(fails(steep, None).to_string(), words);
    let missing = Recipe::parse("(mesh: (path: \"none.obj\"))").unwrap();
    assert!(fails(missing, None).is_io());
}
