//! Output of a section that is given by its matrices.

use std::fmt::Write;

use nalgebra::DMatrix;
use shared_geom::section::SectionProperties;

use super::properties::{Source, properties_of};
use crate::section::ExternalSection;
use crate::solution::SectionSolution;

/// The properties of `section`, with the fingerprint of their input.
pub fn external_properties(
    section: &ExternalSection,
    solution: &SectionSolution,
    input_hash: &str,
) -> SectionProperties {
    let source = Source {
        name: &section.name,
        nodes: section.nodes.len(),
        cells: 0,
        initial_curvature: section.initial_curvature,
        input_hash,
    };
    properties_of(&source, solution)
}

/// The warping under each unit internal force: a row per node, with its number and position,
/// then ux, uy, uz under N, Vy, Vz, Mx, My, Mz, as `ux Mx [1/N]`.
pub fn external_warping_csv(section: &ExternalSection, solution: &SectionSolution) -> String {
    let mut text = "node,y [m],z [m]".to_owned();
    let forces = ["N", "Vy", "Vz", "Mx", "My", "Mz"];
    for (index, force) in forces.into_iter().enumerate() {
        let unit = if index < 3 { "m/N" } else { "1/N" };
        for axis in ["x", "y", "z"] {
            // writing to a string cannot fail
            let _ = write!(text, ",u{axis} {force} [{unit}]");
        }
    }
    text.push('\n');
    let warping: &DMatrix<f64> = &solution.warping;
    for (node, (tag, [y, z])) in section.tags.iter().zip(&section.nodes).enumerate() {
        let _ = write!(text, "{tag},{y:e},{z:e}");
        for value in warping.fixed_view::<3, 6>(3 * node, 0).iter() {
            let _ = write!(text, ",{value:e}");
        }
        text.push('\n');
    }
    text
}
