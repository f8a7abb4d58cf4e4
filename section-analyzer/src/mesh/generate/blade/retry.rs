//! Cell sizes with which a section can be meshed whose cells fold at the requested one.

use shared_geom::mesh::Mesh;

use super::problem::BladeProblem;
use super::types::{Blade, Sizes};

/// Multiples of the requested size that are tried, the nearest first.
const FACTORS: [f64; 6] = [2.0, 0.5, 4.0, 0.25, 8.0, 16.0];

/// The first multiple of the requested size of cells with which `generate` makes a mesh
/// [unit of the mesh].
pub(super) fn unfolded_size(
    blade: &Blade,
    generate: impl Fn(&Blade) -> Result<Mesh, Vec<BladeProblem>>,
) -> Option<f64> {
    let sizes = &blade.sizes;
    let tried = FACTORS.iter().map(|factor| {
        let size = factor * sizes.size;
        // cells of cores have the size of the cells of walls unless another one is requested
        let core = if sizes.core == sizes.size {
            size
        } else {
            sizes.core
        };
        Sizes {
            size,
            core,
            ..sizes.clone()
        }
    });
    let mut tried = tried.map(|sizes| Blade {
        sizes,
        ..blade.clone()
    });
    let found = tried.find(|blade| generate(blade).is_ok())?;
    Some(found.sizes.size)
}
