//! The internal force of recovered stresses, and its difference from the load.
//!
//! ```text
//! theta = int [I, -t x]' (sigma_xx, sigma_xy, sigma_xz) dA
//! error = max(|dF|, |dM| / l) / max(|F|, |M| / l)                                (S-52)
//! ```
//!
//! Moments are about the area centroid, and l is the largest distance of a node from it: a
//! force at that distance has a moment equal to the force times l. The error depends
//! neither on the axes nor on the reference point.

use super::state::PointState;
use crate::assembly::largest;
use crate::element::rigid_displacement;
use crate::properties::AreaMoments;
use crate::section::Section;
use nalgebra::{Vector3, Vector6};

/// Resultant about `center` \[N, N m\].
pub(super) fn resultant(points: &[PointState], center: [f64; 2]) -> Vector6<f64> {
    let mut sum = Vector6::zeros();
    for point in points {
        let stress = &point.tensors.stress;
        let face = Vector3::new(stress[0], stress[5], stress[4]);
        let [y, z] = [point.position[0] - center[0], point.position[1] - center[1]];
        sum += rigid_displacement(1.0, y, z).tr_mul(&(point.area * face));
    }
    sum
}

/// The larger of force and moment over the length `size` \[N\].
pub(super) fn force_size(force: &Vector6<f64>, size: f64) -> f64 {
    let moment = force.fixed_rows::<3>(3).norm() / size;
    largest(force.fixed_rows::<3>(0).norm(), moment)
}

/// Integral of the size of the stress on the face \[N\].
pub(super) fn face_stress(points: &[PointState]) -> f64 {
    let sizes = points.iter().map(|point| {
        let stress = &point.tensors.stress;
        point.area * Vector3::new(stress[0], stress[5], stress[4]).norm()
    });
    sizes.sum()
}

/// Error of the internal force `found` relative to `expected`, both about the centroid;
/// `size` is l \[m\]. If the force `least` \[N\] is larger, the error is relative to
/// `least`: the size of the self-equilibrated forces of imposed states and distributed
/// loads.
pub(super) fn resultant_error(
    found: &Vector6<f64>,
    expected: &Vector6<f64>,
    size: f64,
    least: f64,
) -> f64 {
    let error = force_size(&(found - expected), size);
    if error == 0.0 {
        0.0
    } else {
        error / largest(force_size(expected, size), least)
    }
}

/// Area centroid (y, z) of the section, and the largest distance of a node of a cell
/// from it \[m\].
pub(super) fn centroid_and_size(section: &Section) -> ([f64; 2], f64) {
    let mesh = &section.mesh;
    let Some(first) = mesh.cells.first() else {
        return ([0.0; 2], 0.0);
    };
    // the first node as origin keeps the digits of a mesh far from its origin
    let base = mesh.nodes[first.nodes()[0] as usize];
    let mut sum = AreaMoments::default();
    for cell in &mesh.cells {
        sum += AreaMoments::of_cell(mesh, cell, base);
    }
    let from_base = sum.centroid();
    let center = [base[0] + from_base[0], base[1] + from_base[1]];
    let nodes = mesh.cells.iter().flat_map(|cell| cell.nodes());
    let distance = nodes.map(|&node| {
        let [y, z] = mesh.nodes[node as usize];
        (y - center[0]).hypot(z - center[1])
    });
    (center, distance.fold(0.0, largest))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A moment of 2 N m, compared with a force of 10 N, counts as 2 N at l = 1 m and as
    /// 20 N at l = 0.1 m, where it is larger than the force.
    #[test]
    fn moments_are_made_comparable_by_the_size() {
        let expected = Vector6::new(10.0, 0.0, 0.0, 2.0, 0.0, 0.0);
        let found = Vector6::new(10.0, 0.0, 0.0, 2.1, 0.0, 0.0);
        let error = |size| resultant_error(&found, &expected, size, 0.0);
        assert!((error(1.0) - 0.1 / 10.0).abs() < 1e-15);
        assert!((error(0.1) - 1.0 / 20.0).abs() < 1e-15);
    }

    #[test]
    fn no_number_is_no_agreement() {
        let expected = Vector6::repeat(1.0);
        let error = resultant_error(&Vector6::repeat(f64::NAN), &expected, 1.0, 0.0);
        assert!(error.is_nan());
        assert_eq!(
            resultant_error(&Vector6::zeros(), &Vector6::zeros(), 1.0, 0.0),
            0.0
        );
    }
}
