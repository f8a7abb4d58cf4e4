//! The mirror image of a blade in the plane of rotation.
//!
//! With `S = diag(1, 1, -1)` in the axes of the blade, positions, axes, and stiffness or mass of a section by
//! translations and rotations, which are axial, are
//!
//! ```text
//! S x ,     S R S ,     T K T ,     T = diag(1, 1, -1, -1, -1, 1)                              (D-351)
//! ```

use nalgebra::{Matrix3, Matrix6, Vector3, Vector6};
use shared_geom::document::Table;

use super::layout::BladeLayout;
use super::{BladeProblem, HINGES, MIRROR};
use crate::elements::bodies::RigidInertia;
use crate::input::strips::BladeAir;

/// Nodes and beams of a blade, the masses on its nodes, and its strips.
type Parts = (BladeLayout, Vec<(usize, RigidInertia)>, Option<BladeAir>);

/// Whether a card is a mirror image; hinges have axes of their own.
pub(super) fn read(table: &Table<'_>, name: &str) -> Option<bool> {
    let mirrors = table.get(&MIRROR)?;
    if mirrors && table.has(&HINGES) {
        let problem = BladeProblem::Both {
            blade: format!("blade \"{name}\""),
            first: MIRROR.name(),
            second: HINGES.name(),
        };
        table.note(&MIRROR, &problem);
        return None;
    }
    Some(mirrors)
}

/// The mirror image of a blade; notes sections with more than stiffness, mass and damping.
pub(super) fn mirrored(
    (layout, masses, air): Parts,
    table: &Table<'_>,
    name: &str,
) -> Option<Parts> {
    let mut layout = layout;
    for node in &mut layout.nodes {
        node.position.z = -node.position.z;
        node.axes = of_axes(&node.axes);
    }
    for beam in &mut layout.beams {
        beam.orientations = beam.orientations.map(|axes| of_axes(&axes));
        let own = beam.properties.mirrored(&of_section);
        beam.properties = own
            .map_err(|found| {
                let blade = name.to_owned();
                table.note(&MIRROR, &BladeProblem::NoMirror { blade, found });
            })
            .ok()?;
    }
    let of_mass = |(node, inertia): (usize, RigidInertia)| {
        let first = inertia.first_moment;
        let own = RigidInertia {
            mass: inertia.mass,
            first_moment: Vector3::new(first.x, first.y, -first.z),
            inertia: of_axes(&inertia.inertia),
        };
        (node, own)
    };
    let masses = masses.into_iter().map(of_mass).collect();
    Some((layout, masses, air.map(BladeAir::mirrored)))
}

/// S R S.
fn of_axes(axes: &Matrix3<f64>) -> Matrix3<f64> {
    let s = Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, -1.0));
    s * axes * s
}

/// T K T.
fn of_section(matrix: &Matrix6<f64>) -> Matrix6<f64> {
    let t = Matrix6::from_diagonal(&Vector6::new(1.0, 1.0, -1.0, -1.0, -1.0, 1.0));
    t * matrix * t
}

#[cfg(test)]
mod tests {
    use super::*;

    // A force and a moment in a section and in its image do the same work on strains of the image.
    #[test]
    fn an_image_of_an_image_is_the_section() {
        for seed in 0..100 {
            let number = |i: usize, j: usize| (1.7 * (i * 6 + j + 40 * seed) as f64).sin();
            let matrix = Matrix6::from_fn(|i, j| number(i, j) + number(j, i));
            let image = of_section(&matrix);
            assert_eq!(of_section(&image), matrix);
            // Coupling of lag bending and torsion changes its sign, the one of flap bending does not.
            assert_eq!(image[(3, 5)], -matrix[(3, 5)]);
            assert_eq!(image[(3, 4)], matrix[(3, 4)]);
            assert_eq!(image[(2, 4)], matrix[(2, 4)]);
            assert_eq!(image[(0, 4)], -matrix[(0, 4)]);
        }
    }
}
