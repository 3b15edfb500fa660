//! What is to be baked: the recipe that was named, or the one that the flags spell for a bare height map or mesh. `bake` and `plan`
//! have it from here.

use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};

use barchan_import::{Format, detect};
use barchan_pipeline::{
    CurvatureEncoding, HeightMapSource, MeshFile, MeshSource, PipelineError, Plan, Recipe, RecipeError, Source,
    TableEncoding,
};

use crate::args::{BareArguments, HeightMapArguments, MeshArguments, MethodName, WantedArguments};
use crate::failure::Failure;

/// From words to a decision on every table.
pub(crate) fn plan(arguments: &WantedArguments) -> Result<Plan, Failure> {
    Ok(Plan::new(recipe(arguments)?, arguments.only.as_deref()))
}

/// Where paths start: a bare file's is as typed, a recipe's at the recipe.
pub(crate) fn folder(input: &Path) -> &Path {
    input.parent().filter(|_| is_recipe(input)).unwrap_or(Path::new(""))
}

/// An import error names its file; any other complaint is about the file that was typed, or about --only where that file is no
/// recipe.
pub(crate) fn refused(input: &Path, error: PipelineError) -> Failure {
    match error {
        PipelineError::NoCurvature { table } if !is_recipe(input) => {
            let input = input.display();
            Failure::Usage(format!("{input}: {table} needs a recipe that names `scene: (curvature: (min, max))`"))
        }
        error @ PipelineError::NoInput { .. } => Failure::Usage(format!("{}: {error}", input.display())),
        error @ PipelineError::Import(_) => error.into(),
        error if error.is_io() => Failure::Io(format!("{}: {error}", input.display())),
        error => Failure::content(input, error),
    }
}

fn is_recipe(input: &Path) -> bool {
    input.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("ron"))
}

/// The recipe to bake. What a bare file is, its bytes tell.
fn recipe(arguments: &WantedArguments) -> Result<Recipe, Failure> {
    let input = &arguments.input;
    if is_recipe(input) {
        return match first_flag(arguments) {
            Some((flag, whose)) => {
                let input = input.display();
                Err(Failure::Usage(format!("{flag} is for {whose} without a recipe; set it in {input}")))
            }
            None => read(input),
        };
    }
    let shown = input.display();
    match mesh_format(input)? {
        Some(format) => match first_height_map_flag(&arguments.height_map) {
            Some(flag) => Err(Failure::Usage(format!("{flag} is for height maps; {shown} is a mesh ({format})"))),
            None => bare_mesh(arguments),
        },
        None => match first_mesh_flag(&arguments.mesh) {
            Some(flag) => Err(Failure::Usage(format!("{flag} is for meshes; {shown} is a height map"))),
            None => bare_height_map(input.clone(), &arguments.bare, &arguments.height_map),
        },
    }
}

/// The format of a file that is a mesh. What cannot be read is left to whoever reads all of it, and says why not.
fn mesh_format(path: &Path) -> Result<Option<Format>, Failure> {
    // Signatures are short; a text may begin with a page of comments.
    const HEAD_BYTES: u64 = 1 << 20;
    let is_file = path.metadata().is_ok_and(|about| about.is_file());
    let Some(file) = is_file.then(|| File::open(path).ok()).flatten() else { return Ok(None) };
    let mut head = Vec::new();
    if file.take(HEAD_BYTES).read_to_end(&mut head).is_err() {
        return Ok(None);
    }
    let format = detect(&head).map_err(|error| Failure::content(path, error))?;
    Ok(format.is_mesh().then_some(format))
}

fn read(path: &Path) -> Result<Recipe, Failure> {
    let text = std::fs::read(path).map_err(|error| Failure::io(path, "cannot be read", &error))?;
    let text = String::from_utf8(text).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        Failure::content(path, format!("byte {at} is not UTF-8; a recipe is a RON text"))
    })?;
    Recipe::parse(&text).map_err(|error| match error {
        RecipeError::Syntax { line, column, reason } => {
            Failure::BadInput(format!("{}:{line}:{column}: {reason}", path.display()))
        }
        error => Failure::content(path, error),
    })
}

/// The recipe that the flags spell for a height map.
fn bare_height_map(path: PathBuf, bare: &BareArguments, flags: &HeightMapArguments) -> Result<Recipe, Failure> {
    let mut source = HeightMapSource::new(path, flags.height_scale.unwrap_or(1.0));
    source.integers = flags.integers.unwrap_or_default();
    source.height_offset = flags.height_offset.unwrap_or(0.0);
    source.channel = flags.channel.clone();
    source.no_data = flags.no_data;
    source.fill = flags.fill;
    let mut recipe = Recipe::bare(Source::HeightMap(source));
    set_common(&mut recipe, bare);
    recipe.spacing = flags.spacing.unwrap_or(recipe.spacing);
    recipe.edge = flags.edge.unwrap_or(recipe.edge);
    recipe.horizon.directions = flags.directions.unwrap_or(recipe.horizon.directions);
    recipe.horizon.arc = flags.arc;
    recipe.horizon.radius = flags.radius;
    let hemisphere = &mut recipe.hemisphere;
    hemisphere.rings = flags.rings.unwrap_or(hemisphere.rings);
    hemisphere.azimuths = flags.azimuths.unwrap_or(hemisphere.azimuths);
    hemisphere.size = flags.size;
    hemisphere.mode = flags.depth_mode.unwrap_or(hemisphere.mode);
    if let Some(method) = bare.method {
        let accepted = "sweep, accurate and exact find the horizon of a height map";
        recipe.horizon.method = method.of_a_horizon().ok_or_else(|| wrong_method(method, accepted))?;
    }
    let encoding = bare.encoding.unwrap_or_default();
    (recipe.horizon.encoding, recipe.distance.encoding, recipe.sky.encoding) = (encoding, encoding, encoding);
    (recipe.hemisphere.encoding, recipe.cone_map.encoding, recipe.maximum_mip.encoding) =
        (encoding, encoding, encoding);
    if encoding == TableEncoding::F32 {
        recipe.height.encoding = encoding;
    }
    Ok(recipe)
}

/// The recipe that the flags spell for a mesh.
fn bare_mesh(arguments: &WantedArguments) -> Result<Recipe, Failure> {
    let bare = &arguments.bare;
    let file = MeshFile { path: arguments.input.clone(), mesh: arguments.mesh.mesh.clone() };
    let mut recipe = Recipe::bare_mesh(MeshSource::File(file));
    set_common(&mut recipe, bare);
    let curvature = &mut recipe.curvature;
    curvature.hard_edge_degrees = arguments.mesh.hard_edge.unwrap_or(curvature.hard_edge_degrees);
    if let Some(method) = bare.method {
        let accepted = "fast and accurate find the curvature of a mesh";
        curvature.method = method.of_curvature().ok_or_else(|| wrong_method(method, accepted))?;
    }
    if let Some(encoding) = bare.encoding {
        curvature.encoding = match encoding {
            TableEncoding::F32 => CurvatureEncoding::F32,
            // Halves are as compact as curvature gets: bytes would cut it into visible steps.
            TableEncoding::F16 | TableEncoding::Compact => CurvatureEncoding::F16,
            TableEncoding::U8 => {
                let accepted = "f32, f16 and compact, which is f16, store the curvature of a mesh";
                return Err(Failure::Usage(format!("--encoding is u8; {accepted}")));
            }
        };
    }
    Ok(recipe)
}

fn set_common(recipe: &mut Recipe, bare: &BareArguments) {
    recipe.unit = bare.unit;
    recipe.compression = bare.compression.unwrap_or(recipe.compression);
}

fn wrong_method(method: MethodName, accepted: &str) -> Failure {
    Failure::Usage(format!("--method is {}; {accepted}", method.name()))
}

/// A flag that was typed though a recipe says it, and what it is for.
fn first_flag(arguments: &WantedArguments) -> Option<(&'static str, &'static str)> {
    let bare = &arguments.bare;
    let common = first_typed(&[
        ("--method", bare.method.is_some()),
        ("--unit", bare.unit.is_some()),
        ("--encoding", bare.encoding.is_some()),
        ("--compression", bare.compression.is_some()),
    ]);
    let height_map = first_height_map_flag(&arguments.height_map).map(|flag| (flag, "a height map"));
    let mesh = first_mesh_flag(&arguments.mesh).map(|flag| (flag, "a mesh"));
    height_map.or(mesh).or(common.map(|flag| (flag, "a height map or a mesh")))
}

fn first_mesh_flag(flags: &MeshArguments) -> Option<&'static str> {
    first_typed(&[("--hard-edge", flags.hard_edge.is_some()), ("--mesh", flags.mesh.is_some())])
}

/// A height-map flag that was typed, if any was.
fn first_height_map_flag(flags: &HeightMapArguments) -> Option<&'static str> {
    first_typed(&[
        ("--directions", flags.directions.is_some()),
        ("--edge", flags.edge.is_some()),
        ("--spacing", flags.spacing.is_some()),
        ("--integers", flags.integers.is_some()),
        ("--height-scale", flags.height_scale.is_some()),
        ("--height-offset", flags.height_offset.is_some()),
        ("--arc", flags.arc.is_some()),
        ("--radius", flags.radius.is_some()),
        ("--rings", flags.rings.is_some()),
        ("--azimuths", flags.azimuths.is_some()),
        ("--size", flags.size.is_some()),
        ("--depth-mode", flags.depth_mode.is_some()),
        ("--channel", flags.channel.is_some()),
        ("--no-data", flags.no_data.is_some()),
        ("--fill", flags.fill.is_some()),
    ])
}

fn first_typed(flags: &[(&'static str, bool)]) -> Option<&'static str> {
    flags.iter().find(|(_, is_typed)| *is_typed).map(|(flag, _)| *flag)
}
