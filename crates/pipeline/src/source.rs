//! The field a recipe names, read or generated.

use std::path::{Path, PathBuf};

use barchan_field::{Grid, HeightField};
use barchan_import::{HeightMapOptions, ImportError, check_file, decode_height_map, read_file};

use crate::provenance::InputProvenance;
use crate::{HeightMapSource, PipelineError, Recipe, ShapeSource, Source};

/// The most texels a generated field may have.
const MAX_SHAPE_TEXELS: u64 = 1 << 28;

/// A field and what is to be said of it.
pub(crate) struct Loaded {
    pub(crate) field: HeightField,
    pub(crate) words: String,
    pub(crate) filled_texels: u64,
    pub(crate) input: InputProvenance,
}

/// Reads or generates the field. Relative paths start at `folder`.
pub(crate) fn load(recipe: &Recipe, source: &Source, folder: &Path) -> Result<Loaded, PipelineError> {
    match source {
        Source::Shape(source) => generate(recipe, source),
        Source::HeightMap(source) => read(recipe, source, folder.join(&source.path)),
    }
}

/// The grid of the field that [`load`] would give, where no file has to be read for it; refuses what can be refused so.
pub(crate) fn foresee(recipe: &Recipe, source: &Source, folder: &Path) -> Result<Option<Grid>, PipelineError> {
    match source {
        Source::Shape(source) => shape_grid(recipe, source).map(Some),
        Source::HeightMap(source) => {
            let path = folder.join(&source.path);
            check_file(&path)?;
            let checked = options(recipe, source).check();
            checked.map_err(|cause| ImportError::Content { path, cause })?;
            Ok(None)
        }
    }
}

/// A source in words, its file as a path from the current folder.
pub(crate) fn words(source: &Source, folder: &Path) -> String {
    match source {
        Source::Shape(source) => shape_words(source),
        Source::HeightMap(source) => folder.join(&source.path).display().to_string(),
    }
}

fn shape_words(source: &ShapeSource) -> String {
    format!("generated {}", source.shape.name())
}

fn shape_grid(recipe: &Recipe, source: &ShapeSource) -> Result<Grid, PipelineError> {
    let &ShapeSource { shape, width, height } = source;
    let texels = u64::from(width) * u64::from(height);
    if texels > MAX_SHAPE_TEXELS {
        return Err(PipelineError::ShapeTooLarge { width, height, texels, limit: MAX_SHAPE_TEXELS });
    }
    let grid = Grid { width, height, spacing: recipe.spacing, unit: recipe.height_unit(), edge: recipe.edge };
    shape.check_over(&grid)?;
    Ok(grid)
}

fn generate(recipe: &Recipe, source: &ShapeSource) -> Result<Loaded, PipelineError> {
    let grid = shape_grid(recipe, source)?;
    Ok(Loaded {
        field: source.shape.rasterize(grid)?,
        words: shape_words(source),
        filled_texels: 0,
        input: InputProvenance::Shape(source.clone()),
    })
}

fn options(recipe: &Recipe, source: &HeightMapSource) -> HeightMapOptions {
    HeightMapOptions {
        integers: source.integers,
        height_scale: source.height_scale,
        height_offset: source.height_offset,
        spacing: recipe.spacing,
        unit: recipe.height_unit(),
        edge: recipe.edge,
        channel: source.channel.clone(),
        no_data: source.no_data,
        fill: source.fill,
        ..HeightMapOptions::default()
    }
}

fn read(recipe: &Recipe, source: &HeightMapSource, path: PathBuf) -> Result<Loaded, PipelineError> {
    let options = options(recipe, source);
    let bytes = read_file(&path)?;
    let blake3 = blake3::hash(&bytes).to_hex().to_string();
    let words = path.display().to_string();
    let map = decode_height_map(&bytes, &options).map_err(|cause| ImportError::Content { path, cause })?;
    let format = format!("{} {}", map.source.format, map.source.sample_type);
    Ok(Loaded {
        field: map.field,
        words: format!("{words} ({format})"),
        filled_texels: map.source.filled,
        input: InputProvenance::HeightMap {
            blake3,
            format,
            channel: source.channel.clone(),
            integers: source.integers,
            height_scale: source.height_scale,
            height_offset: source.height_offset,
            no_data: source.no_data,
            fill: source.fill,
            filled_texels: map.source.filled,
        },
    })
}
