//! The undeformed beam as written: `[initial_curvature]`.
//!
//! Fibers of a curved beam are longer or shorter than its reference line by
//!
//! ```text
//! J = l1 + k2 z - k3 y                                                        (S-71)
//! ```
//!
//! and a section that reaches the center of curvature, J = 0, would overlap itself.

use nalgebra::Vector3;
use shared_geom::document::schema::ValueKind::{Table as OneTable, Vector};
use shared_geom::document::{Document, Nested, Table};
use shared_geom::keys;
use shared_geom::section::InitialCurvature;
use shared_geom::units::Dimension;

use super::problem::InputProblem;
use super::summary::InputWarning;
use crate::mesh::SectionMesh;

keys! {
    /// Curvature and twist of the undeformed beam.
    pub(super) BEAM: Nested = "initial_curvature", [OneTable(&INITIAL_CURVATURE)], optional, "";
}

keys! {
    /// Twist and curvature of the undeformed beam at this section, constant along it, in the axes
    /// of the section: all matrices are then for this beam, per length of its reference line,
    /// which goes through the origin of the mesh.
    INITIAL_CURVATURE = "[initial_curvature]";
    /// Twist about x and curvature about y and z, k1, k2, k3: rotation of the section per length
    /// of the reference line. Twist is positive from y toward z; k2 > 0 bends the beam toward -z,
    /// k3 > 0 toward +y.
    CURVATURE: Vector3<f64> = "curvature", [Vector(3, Dimension::CURVATURE)], required,
        "[\"5 deg/m\", 0, 0]";
    /// Direction of the reference line, of any length, the first number greater than zero;
    /// [1, 0, 0] if the line is normal to the section.
    SLOPE: Vector3<f64> = "slope", [Vector(3, Dimension::NUMBER)], or "[1, 0, 0]" = Vector3::x(),
        "[0.99, 0.1, 0]";
}

/// Curvature times the size of the section above which a mistake is likely: the direction
/// of the fibers at the edge of the section then differs by 27 degrees from the line, or
/// their length by half.
const STRONG: f64 = 0.5;

/// Angle between the line and the normal of the section above which a mistake is likely
/// \[deg\]: sheared layups and sheared slices are far below.
const OBLIQUE: f64 = 75.0;

/// The table, and the line of its curvature.
#[derive(Debug, Clone, Copy)]
pub(super) struct WrittenCurvature {
    pub initial: InitialCurvature,
    line: usize,
}

/// Reads `[initial_curvature]`; a straight beam if it is absent.
pub(super) fn read(root: &Table<'_>) -> Option<WrittenCurvature> {
    let written = root.nested(&BEAM, |table| {
        let expected = "an array of 3: twist about x, curvature about y and z";
        let curvature = table.require_item(&CURVATURE, expected);
        let curvature = curvature.and_then(|_| table.get(&CURVATURE));
        let slope = slope(table);
        let initial = InitialCurvature {
            curvature: curvature?,
            slope: slope?,
        };
        let line = table.line_of(&CURVATURE);
        Some(WrittenCurvature { initial, line })
    });
    let initial = InitialCurvature::STRAIGHT;
    Some(written?.unwrap_or(WrittenCurvature { initial, line: 0 }))
}

/// A direction out of the section, as a unit vector.
fn slope(table: &Table<'_>) -> Option<Vector3<f64>> {
    // Safe for huge and for tiny numbers.
    let scaled = |slope: &Vector3<f64>| slope / slope.amax();
    let slope = table.get_if(
        &SLOPE,
        |slope| scaled(slope).x > 0.0,
        "a direction [x, y, z] whose first number is greater than zero: [1, 0, 0] if the line is \
         normal to the section",
    )?;
    Some(scaled(&slope).normalize())
}

/// The beam of the section, if the section does not reach its center of curvature; adds
/// to `warnings`.
pub(super) fn checked(
    written: &WrittenCurvature,
    mesh: &SectionMesh,
    document: &Document,
    warnings: &mut Vec<InputWarning>,
) -> Option<InitialCurvature> {
    let initial = written.initial;
    let least = least_length(&initial, mesh)?;
    if least.length <= 0.0 {
        document.note(written.line, &folded(&initial, mesh, &least, document));
        return None;
    }
    let size = mesh.nodes.iter().map(|[y, z]| y.hypot(*z));
    let strength = initial.curvature.amax() * size.fold(0.0, f64::max);
    if strength > STRONG {
        warnings.push(InputWarning::StrongCurvature { strength });
    }
    let angle = initial.slope.x.acos().to_degrees();
    if angle > OBLIQUE {
        warnings.push(InputWarning::Oblique { angle });
    }
    Some(initial)
}

/// The node with the shortest fiber.
struct Least {
    /// J at this node.
    length: f64,
    cell: u64,
    node: u64,
    /// (y, z) [m].
    position: [f64; 2],
}

/// The least J of (S-71), which is linear over the section: its minimum is at a node.
fn least_length(initial: &InitialCurvature, mesh: &SectionMesh) -> Option<Least> {
    let of_cells = mesh.cells.iter().flat_map(|cell| {
        cell.nodes().iter().map(move |&node| {
            let position = mesh.nodes[node as usize];
            Least {
                length: initial.tangent_at(position[0], position[1]).x,
                cell: cell.tag,
                node: mesh.node_tag(node as usize),
                position,
            }
        })
    });
    of_cells.min_by(|a, b| a.length.total_cmp(&b.length))
}

fn folded(
    initial: &InitialCurvature,
    mesh: &SectionMesh,
    least: &Least,
    document: &Document,
) -> InputProblem {
    // J = l1 - s by the whole curvature, l1 - part s by a part of it.
    let part = initial.slope.x / (initial.slope.x - least.length);
    let bending = initial.curvature.y.hypot(initial.curvature.z);
    let size = mesh.nodes.iter().map(|[y, z]| y.hypot(*z));
    let unit = document.factor(Dimension::LENGTH);
    InputProblem::Folded {
        cell: least.cell,
        node: least.node,
        position: least.position.map(|x| x / unit),
        length: least.length,
        curvature: bending.to_degrees(),
        largest: (part * bending).to_degrees(),
        factor: document.factor(Dimension::CURVATURE).to_degrees(),
        far: size.fold(0.0, f64::max) / unit,
    }
}
