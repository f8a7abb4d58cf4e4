//! The checked section in SI: mesh, materials, and material of each cell. Values only;
//! reading and checking belong to the input stage.

use shared_geom::section::InitialCurvature;

mod electrode;
mod imposed;

pub use electrode::{Circuit, Electrode, ElectrodeShape, FingeredCell};
pub use imposed::{FreeStrain, ImposedStrain, TemperatureField};

use crate::material::{ElasticLaw, Material};
use crate::mesh::SectionMesh;

/// A section ready for analysis.
#[derive(Debug, Clone)]
pub struct Section {
    /// Name for reports.
    pub name: String,
    /// Nodes and cells in section axes.
    pub mesh: SectionMesh,
    /// The materials that cells refer to.
    pub materials: Vec<Material>,
    /// Material and orientation of each cell, parallel to `mesh.cells`.
    pub cells: Vec<CellMaterial>,
    /// Curvature and twist of the undeformed beam, and the slope of its reference line.
    pub initial_curvature: InitialCurvature,
    /// Electrodes, of different names; without electrodes, electric laws have no effect.
    pub electrodes: Vec<Electrode>,
}

impl Section {
    /// Whether the material of a cell has directions, so that its angles matter.
    pub fn has_directions(&self, cell: usize) -> bool {
        let material = self.materials.get(self.cells[cell].material);
        !material.is_none_or(|material| matches!(material.law, ElasticLaw::Isotropic { .. }))
    }
}

/// Material and orientation of one cell, constant over it.
///
/// The angles define the material axes as in [`crate::material::material_axes`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CellMaterial {
    /// Index into [`Section::materials`].
    pub material: usize,
    /// Angle of the fiber from the beam axis x towards the wall direction \[rad\].
    pub fiber_angle: f64,
    /// Angle of the wall direction from the section axis y towards z \[rad\].
    pub plane_angle: f64,
}

mod distributed;
mod external;
#[cfg(test)]
pub(crate) mod piezo_samples;
#[cfg(test)]
pub(crate) mod samples;

pub use distributed::{Action, DistributedForce, DistributedLoad, Traction, VolumeForce};
pub use external::{Blocks, ExternalSection, Reduced, Slice, Through};
