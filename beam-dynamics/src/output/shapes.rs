//! Output of the shapes of modes: plots along the span, animated field files.

use nalgebra::{Complex, Vector3};

use super::structure::{Member, Structure};
use crate::case::Model;
use crate::model::NamingAxes;
use crate::result::{FrequencyTable, ModeKind, ModeShape};

mod fields;
mod files;
mod plot;

pub use files::write_shapes;
pub use plot::ShapePlot;

/// Rotations are drawn as the displacement at this part of the length from the axis.
const LEVER: f64 = 0.1;

/// The motion of one node: flap, lag, torsion, axial.
type Components = [Complex<f64>; 4];

/// The motion along a member, scaled so that the largest component is one.
#[derive(Debug, Clone, PartialEq)]
struct MemberMotion {
    /// Index of the member.
    member: usize,
    /// Arc position \[m\] and motion of each node.
    points: Vec<(f64, Components)>,
}

/// The motion along the member with the largest motion; `None` without members or motion.
fn member_motion(
    structure: &Structure,
    naming: &[NamingAxes],
    shape: &ModeShape,
) -> Option<MemberMotion> {
    let motions = structure
        .members
        .iter()
        .enumerate()
        .map(|(number, member)| {
            let points = motion(structure, member, naming, shape);
            let largest = points.iter().flat_map(|point| point.1);
            let largest = largest.fold(Complex::new(0.0, 0.0), |a, b| {
                if b.norm_sqr() > a.norm_sqr() { b } else { a }
            });
            (number, points, largest)
        });
    // The first of equal ones, as blades at rest.
    let most = motions.reduce(|a, b| {
        if b.2.norm() > (1.0 + 1e-6) * a.2.norm() {
            b
        } else {
            a
        }
    });
    let (member, mut points, largest) = most.filter(|most| most.2.norm() > 0.0)?;
    for value in points.iter_mut().flat_map(|point| &mut point.1) {
        *value /= largest;
    }
    Some(MemberMotion { member, points })
}

/// Displacements along the axes of the blade, and rotation about its section axis times the lever,
/// at the nodes of a member.
fn motion(
    structure: &Structure,
    member: &Member,
    naming: &[NamingAxes],
    shape: &ModeShape,
) -> Vec<(f64, Components)> {
    let stations = structure.stations(member).into_iter();
    let along = |vector: &[Complex<f64>; 3], direction: Vector3<f64>| -> Complex<f64> {
        (0..3).map(|i| vector[i] * direction[i]).sum()
    };
    let motion = |(arc, node): (f64, usize)| {
        let axes = &naming[node];
        let displacement = &shape.displacements[node];
        let [axial, lag, flap] =
            [0, 1, 2].map(|axis| along(displacement, axes.blade.column(axis).into_owned()));
        let rotation = along(&shape.rotations[node], axes.section.column(0).into_owned());
        (arc, [flap, lag, LEVER * member.length * rotation, axial])
    };
    stations.map(motion).collect()
}

/// A mode with a shape at some speed.
#[derive(Debug, Clone)]
struct Shaped<'a> {
    /// Name of the mode, and of its files.
    name: &'a str,
    /// Name with the kind at this speed, if it is another one.
    shown: String,
    kind: ModeKind,
    /// Frequency \[Hz\].
    frequency: f64,
    damping_ratio: f64,
    shape: &'a ModeShape,
}

/// Modes with shapes at speed index `speed`, ascending in frequency.
fn shaped(table: &FrequencyTable, speed: usize) -> Vec<Shaped<'_>> {
    let modes = table.at_speed(speed).into_iter();
    let shaped = modes.filter_map(|(branch, point)| {
        Some(Shaped {
            name: &branch.name,
            shown: branch.name_at(point, table.style.words),
            kind: branch.kind,
            frequency: point.frequency,
            damping_ratio: point.damping_ratio,
            shape: point.shape.as_ref()?,
        })
    });
    shaped.collect()
}

/// The structure of a model.
fn structure(model: &Model) -> Structure {
    Structure::new(model.system.nodes(), &model.beams, &model.blades)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::samples;

    // A blade of 10 m whose tip moves by 2 up (flap), -1 aft (lag) and turns by 1:
    // relative to the flap of the tip that is 1, -0.5, and 0.1 10 m / 2 = 0.5.
    #[test]
    fn components_are_those_of_the_naming_axes() {
        let (nodes, beams, shape) = samples::tip_motion();
        let structure = Structure::new(&nodes, &beams, &[]);
        let naming = vec![NamingAxes::default(); nodes.len()];
        let found = member_motion(&structure, &naming, &shape).unwrap();
        let (arc, motion) = found.points[found.points.len() - 1];
        assert!((arc - 10.0).abs() < 1e-12);
        for (found, expected) in motion.iter().zip([1.0, -0.5, 0.5, 0.0]) {
            assert!(
                (found - Complex::new(expected, 0.0)).norm() < 1e-12,
                "{motion:?}"
            );
        }
        let mut still = shape.clone();
        still.displacements.fill([Complex::new(0.0, 0.0); 3]);
        still.rotations.fill([Complex::new(0.0, 0.0); 3]);
        assert_eq!(member_motion(&structure, &naming, &still), None);
    }
}
