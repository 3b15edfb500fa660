//! The curvature table of a mesh: found, cut down to the columns that somebody can use, and written.

use std::io::{Read, Seek, Write};

use barchan_asset::{ColumnLayout, CurvatureTable, EncodedCurvature, EncodingLoss, SurfaceForms, VertexFlags};
use barchan_bakers::Exec;
use barchan_bakers::curvature::{self, MeshCurvature, VertexForms};

use crate::clock::Clock;
use crate::curvature_part::column_unit;
use crate::error::refused;
use crate::layout::length_unit;
use crate::mesh_provenance::CurvatureProvenance;
use crate::provenance::EncodingProvenance;
use crate::sink::Sink;
use crate::{CurvaturePart, CurvatureRecipe, MeshInput, PipelineError, Plan, Run, Table, swept_range};

/// What was found of a mesh.
pub(crate) struct FoundCurvature {
    found: MeshCurvature,
    forms: Option<Vec<VertexForms>>,
    /// All remarks on each vertex, those on texture coordinates too.
    flags: Vec<VertexFlags>,
    pub(crate) provenance: CurvatureProvenance,
}

/// The table in the file, and what is not in it.
pub(crate) struct WrittenCurvature {
    pub(crate) encoded: EncodedCurvature,
    /// The parts that are not there, and why.
    pub(crate) left_out: Vec<(CurvaturePart, &'static str)>,
}

impl WrittenCurvature {
    /// What storing cost each column.
    pub(crate) fn encodings(&self) -> impl Iterator<Item = EncodingProvenance> {
        let descriptor = self.encoded.descriptor();
        self.encoded.losses().iter().map(|(column, loss)| EncodingProvenance {
            table: format!("{}.{}", Table::Curvature.name(), column.name()),
            format: descriptor.column(*column).map_or("", |layout| layout.format.name()).to_owned(),
            unit: column_unit(*column, descriptor.length_unit()).to_owned(),
            rms: loss.rms,
            max: loss.max,
        })
    }

    /// The columns in the file, with what storing cost them: nothing, for flags.
    pub(crate) fn columns(&self) -> impl Iterator<Item = (&ColumnLayout, EncodingLoss)> {
        let losses = self.encoded.losses();
        self.encoded.descriptor().columns().map(|layout| {
            let loss = losses.iter().find(|(column, _)| *column == layout.column);
            (layout, loss.map(|(_, loss)| *loss).unwrap_or_default())
        })
    }
}

/// Finds the curvature of a mesh, with progress of its own.
pub(crate) fn find(
    plan: &Plan,
    input: &MeshInput,
    run: &Run<'_>,
    clock: &mut Clock<'_>,
) -> Result<FoundCurvature, PipelineError> {
    let recipe = &plan.recipe.curvature;
    if recipe.uv_directions && input.mesh.uvs().is_none() {
        return Err(PipelineError::NoTextureCoordinates);
    }
    let progress = |done, total| (run.progress)("curvature", done, total);
    let exec = Exec::new(run.threads).map_err(|error| refused("-j", error))?.with_progress(&progress);
    clock.announce("curvature", 0, 1);
    let bake = || curvature::bake(&input.mesh, &recipe.params(), &exec);
    let found = clock.time("curvature", bake).map_err(|error| refused("curvature", error))?;
    let forms = clock.time("forms", || curvature::forms(&input.mesh, &found, &exec));
    let flags = all_flags(&found, forms.as_deref());
    let provenance = CurvatureProvenance::new(recipe, &found, &flags);
    Ok(FoundCurvature { found, forms, flags, provenance })
}

fn all_flags(found: &MeshCurvature, forms: Option<&[VertexForms]>) -> Vec<VertexFlags> {
    let of_surface = found.vertices.iter().map(|vertex| vertex.flags);
    match forms {
        Some(forms) => of_surface.zip(forms).map(|(flags, forms)| flags | forms.flags).collect(),
        None => of_surface.collect(),
    }
}

impl FoundCurvature {
    /// The range of curvatures for relief that lies on the mesh.
    pub(crate) fn range(&self) -> Option<(f64, f64)> {
        swept_range::of_mesh(&self.found)
    }

    /// Encodes and writes the table.
    pub(crate) fn write<W: Read + Write + Seek>(
        &self,
        plan: &Plan,
        input: &MeshInput,
        sink: &mut Sink<'_, W>,
    ) -> Result<WrittenCurvature, PipelineError> {
        let left_out: Vec<_> = CurvaturePart::ALL
            .into_iter()
            .filter_map(|part| Some((part, self.reason_against(part, &plan.recipe.curvature)?)))
            .collect();
        let has = |part| left_out.iter().all(|(absent, _)| *absent != part);
        let encoded = sink.clock.time("encode", || {
            let principal: Vec<_> =
                self.found.vertices.iter().map(|vertex| vertex.principal.map(|curvature| curvature as f32)).collect();
            let directions = has(CurvaturePart::Directions).then(|| self.directions());
            let forms = has(CurvaturePart::Forms).then(|| self.surface_forms());
            let uv_directions = has(CurvaturePart::UvDirections).then(|| self.uv_directions());
            let table = CurvatureTable {
                length_unit: length_unit(input.unit),
                principal: &principal,
                directions: directions.as_deref(),
                forms: forms.as_deref(),
                uv_directions: uv_directions.as_deref(),
                flags: &self.flags,
            };
            table.encode(plan.recipe.curvature.encoding.into())
        });
        let encoded = encoded.map_err(|error| PipelineError::Encode { table: Table::Curvature.name(), error })?;
        sink.curvature(&encoded)?;
        Ok(WrittenCurvature { encoded, left_out })
    }

    /// Why a part is of no use; `None` if it is of some.
    fn reason_against(&self, part: CurvaturePart, recipe: &CurvatureRecipe) -> Option<&'static str> {
        const NO_UVS: &str = "the mesh has no texture coordinates";
        match part {
            CurvaturePart::Principal => None,
            CurvaturePart::Directions => match (recipe.directions, &self.forms) {
                (Some(true), _) | (None, None) => None,
                (Some(false), _) => Some("the recipe does without them"),
                (None, Some(_)) => Some("the forms hold them, in texture coordinates"),
            },
            CurvaturePart::Forms => self.forms.is_none().then_some(NO_UVS),
            CurvaturePart::UvDirections if self.forms.is_none() => Some(NO_UVS),
            CurvaturePart::UvDirections => {
                (!recipe.uv_directions).then_some("the recipe does not ask for them: the forms are what to interpolate")
            }
            CurvaturePart::Flags => {
                let is_plain = self.flags.iter().all(|&flags| flags == VertexFlags::NONE);
                is_plain.then_some("there is nothing to remark on any vertex")
            }
        }
    }

    fn directions(&self) -> Vec<[[f32; 3]; 2]> {
        let vertices = self.found.vertices.iter();
        vertices.map(|vertex| vertex.directions.map(|direction| direction.to_array().map(|x| x as f32))).collect()
    }

    fn surface_forms(&self) -> Vec<SurfaceForms> {
        self.forms.iter().flatten().map(|forms| SurfaceForms::nearest(forms.first, forms.second)).collect()
    }

    fn uv_directions(&self) -> Vec<[[f32; 2]; 2]> {
        let forms = self.forms.iter().flatten();
        forms.map(|forms| forms.uv_directions.map(|direction| direction.to_array().map(|x| x as f32))).collect()
    }
}
