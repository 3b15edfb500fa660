//! The run-time equations on the CPU, one file per technique, with the plain baseline a user would pick instead.
//!
//! Everything here reads baked tables through `barchan_asset`'s views: values are decoded in f32, as a shader decodes
//! them, and computed with in f64, so that what differs from the traced truth is the table's doing. What it is fed it treats as *the* surface: it knows nothing of source files, recipes or bakers.
//!
//! # Conventions
//!
//! The frame is the asset's: u right, v up the picture, height towards the viewer. A place on a table is given in texels
//! from the centre of texel (0, 0): `x` counts columns, `y` rows downwards, so texel centres are whole numbers.

mod base;
mod camera;
mod curved;
mod curved_picture;
mod curved_shadow;
mod disc_light;
mod forms;
mod horizon;
mod light;
mod mesh_cover;
mod mesh_normals;
mod mesh_picture;
mod mesh_view;
mod oracle;
mod penumbra;
mod picture;
mod place;
mod principal;
mod relief;
mod sky;
mod surface;
mod tangent;
mod texture;
mod traced;
mod traced_penumbra;

pub use base::{BaseSurface, Cylinder, Foot, Patch, Plane, Ray, Sphere, SphereChart, SurfacePoint};
pub use camera::{Camera, Lens, ParallelRays};
pub use curved::{
    CLOSED, Correction, NO_HORIZON, StoredPoint, curved_horizon, geometric_horizon, geometric_horizon_as_printed,
    paper_horizon,
};
pub use curved_picture::CurvedPixels;
pub use curved_shadow::{CurvedMethod, CurvedShadow, MismatchedTables};
pub use disc_light::DiscLight;
pub use forms::FundamentalForms;
pub use horizon::HorizonShadow;
pub use light::DirectionalLight;
pub use mesh_picture::{ColouredMesh, MAX_MESH_PICTURE};
pub use mesh_view::{MeshView, UpAxis};
pub use oracle::DisplacedShadow;
pub use penumbra::Penumbra;
pub use picture::{BACKGROUND, Palette, Picture, Pixels};
pub use place::Place;
pub use principal::PrincipalUv;
pub use relief::{
    ConeSteps, DepthMapStart, Fetches, Found, HemisphereCell, HemisphereOcclusion, HemisphereQuadrature, LinearSearch,
    MAP_TOLERANCE, MaximumMipTraversal, MismatchedRelief, Occlusion, ParallaxOcclusion, RelaxedConeSteps, Relief,
    ReliefLight, ReliefPixel, ReliefPixels, ReliefRay, ReliefRoad, ReliefSearch, ReliefShadow, ReliefStage,
    SHADOW_TOLERANCE, ShadowAnswer, StageBase, StageEye, Start, TracedRelief, heat_map, relief_direction,
};
pub use sky::SkyLight;
pub use surface::Surface;
pub use tangent::{TangentFrame, TangentLight};
pub use texture::Texture;
pub use traced::TracedShadow;
pub use traced_penumbra::TracedPenumbra;
