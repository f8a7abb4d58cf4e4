//! Checks sections with cells that have no stiffness.

use shared_geom::document::Document;
use shared_geom::error::Explain;

use crate::material::ElasticLaw;
use crate::mesh::{counted, short};
use crate::section::Section;

/// Number of parts that a message describes; the others are counted.
const PARTS_SHOWN: usize = 3;

/// A section that is not connected by its cells with stiffness.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum StiffnessProblem {
    /// No cell has a stiffness.
    #[error(
        "no cell of the section has a stiffness: all regions are of materials with stiffness = \"none\""
    )]
    None,
    /// Parts that no cells with stiffness connect.
    #[error(
        "only cells without stiffness connect the section: the others are in {count} parts, {}, \
         expected one part, connected through whole sides",
        .parts.join(", ")
    )]
    Parts {
        /// Their number.
        count: usize,
        /// Descriptions of the largest parts.
        parts: Vec<String>,
    },
}

impl Explain for StiffnessProblem {
    fn help(&self) -> Option<String> {
        let text = match self {
            Self::None => "a beam needs at least one region with a stiffness",
            Self::Parts { .. } => {
                "give the filler between them a small modulus, such as 1e-6 of the modulus of the \
                 others"
            }
        };
        Some(text.to_owned())
    }
}

/// Notes at `line` a section whose cells with stiffness are not connected.
pub(super) fn check(document: &Document, line: usize, section: &Section) {
    let is_stiff = |cell: usize| {
        let material = section.cells.get(cell).map(|cell| cell.material);
        let material = material.and_then(|material| section.materials.get(material));
        material.is_some_and(|material| material.law != ElasticLaw::Absent)
    };
    if (0..section.mesh.cells.len()).all(is_stiff) {
        return;
    }
    let parts = section.mesh.parts(is_stiff);
    match parts.len() {
        0 => document.note(line, &StiffnessProblem::None),
        1 => {}
        count => {
            let parts = parts
                .iter()
                .take(PARTS_SHOWN)
                .map(|part| words(section, part));
            let parts = parts.collect();
            document.note(line, &StiffnessProblem::Parts { count, parts });
        }
    }
}

/// `4 cells around cell 7 in "skin" at (0.1, 0.2) m`.
fn words(section: &Section, part: &[usize]) -> String {
    let mesh = &section.mesh;
    let cell = &mesh.cells[part[0]];
    let [y, z] = mesh.middle(cell).map(short);
    let count = counted(part.len(), "cell");
    format!(
        "{count} with cell {} in \"{}\" at ({y}, {z}) m",
        cell.tag, mesh.groups[cell.group]
    )
}
