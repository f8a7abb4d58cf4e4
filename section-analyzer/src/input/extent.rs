//! Size of the section, and its distance from the origin of its mesh.

use super::problem::InputProblem;
use crate::mesh::{SectionCell, SectionMesh};

/// Smallest and largest size of a section \[m\]: far beyond all structures; the sixth
/// power of a length is still finite.
const SIZES: (f64, f64) = (1e-30, 1e30);

/// Largest distance of a section from the origin, in sizes. Torsion about the origin
/// contains the shear stiffness times the square of the distance: at 1e5 sizes, six
/// digits of the torsional stiffness remain, at 1e8 none.
const FARTHEST: f64 = 1e5;

/// Checks that the results of the section of `mesh` about the origin of the mesh have
/// accurate digits.
///
/// # Errors
/// [`InputProblem::Size`], [`InputProblem::Far`].
pub(super) fn check(mesh: &SectionMesh) -> Result<(), InputProblem> {
    let (low, high) = bounds(mesh);
    let size = (high[0] - low[0]).hypot(high[1] - low[1]);
    if !(SIZES.0..=SIZES.1).contains(&size) {
        let (smallest, largest) = SIZES;
        return Err(InputProblem::Size {
            size,
            smallest,
            largest,
        });
    }
    let distance = (0.5 * (low[0] + high[0])).hypot(0.5 * (low[1] + high[1]));
    if distance > FARTHEST * size {
        let ratio = distance / size;
        return Err(InputProblem::Far {
            distance,
            ratio,
            limit: FARTHEST,
        });
    }
    Ok(())
}

/// The larger extent of a section along its axes \[m\].
pub(super) fn size(mesh: &SectionMesh) -> f64 {
    let (low, high) = bounds(mesh);
    (high[0] - low[0]).max(high[1] - low[1])
}

/// The least height of a cell of a section, infinite without cells: its area over its longest side, and
/// twice this for a triangle \[m\].
pub(super) fn thinnest(mesh: &SectionMesh) -> f64 {
    let height = |cell: &SectionCell| {
        let corners: Vec<_> = cell
            .corners()
            .iter()
            .map(|&at| mesh.nodes[at as usize])
            .collect();
        let next = corners.iter().cycle().skip(1);
        let sides = corners.iter().zip(next);
        let (area, longest) = sides.fold((0.0, 0.0_f64), |(area, longest), (a, b)| {
            let side = (b[0] - a[0]).hypot(b[1] - a[1]);
            (area + 0.5 * (a[0] * b[1] - a[1] * b[0]), longest.max(side))
        });
        let height = area / longest;
        if corners.len() == 3 {
            2.0 * height
        } else {
            height
        }
    };
    mesh.cells.iter().map(height).fold(f64::INFINITY, f64::min)
}

/// The smallest and the largest coordinates of the nodes of cells \[m\].
fn bounds(mesh: &SectionMesh) -> ([f64; 2], [f64; 2]) {
    let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for &node in mesh.cells.iter().flat_map(|cell| cell.nodes()) {
        for axis in 0..2 {
            let position = mesh.nodes[node as usize][axis];
            low[axis] = low[axis].min(position);
            high[axis] = high[axis].max(position);
        }
    }
    (low, high)
}
