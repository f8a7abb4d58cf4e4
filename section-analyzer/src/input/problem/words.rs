//! Parts of messages.

use shared_geom::error::{nearest_name, quoted};
use shared_geom::mesh::{GroupForm, GroupKind};

/// Number of names that a message lists before it counts the rest.
const NAMES_SHOWN: usize = 5;
/// Dimensions of groups.
const CURVE: u8 = 1;
const SURFACE: u8 = 2;

/// Alternatives to a group that the mesh does not have; `is_other` if the mesh has a
/// group of the other kind, curve or surface, with this name.
pub(super) fn known_groups(
    kind: GroupKind,
    group: &str,
    known: &[String],
    is_other: bool,
) -> String {
    if is_other {
        let [curve, surface] = [CURVE, SURFACE].map(|dimension| kind.with_dimension(dimension));
        return match kind.dimension {
            CURVE => format!("\"{group}\" is a {surface}; give a {curve}"),
            _ => format!(
                "\"{group}\" is a {curve}; give a {surface}, or put plies along the curve by \
                 [[lamina]]"
            ),
        };
    }
    let all = match kind.form {
        GroupForm::Physical => format!("{kind}s of the mesh: {}", quoted(known)),
        _ => format!("of the mesh, each a {kind}: {}", quoted(known)),
    };
    match nearest_name(group, known.iter().map(String::as_str)) {
        Some(near) => format!("did you mean \"{near}\"? {all}"),
        None if known.is_empty() => format!("the mesh has no {kind}: add one, {}", form(kind)),
        None => all,
    }
}

/// The way in which a mesh file has groups of a kind.
fn form(kind: GroupKind) -> &'static str {
    match (kind.form, kind.dimension) {
        (GroupForm::Physical, _) => "in gmsh by a physical group",
        (GroupForm::Sets, 0) => "in Abaqus by *NSET",
        (GroupForm::Sets, _) => "in Abaqus by *ELSET",
        (GroupForm::Values, _) => "in VTK by an array of whole numbers by cell",
    }
}

/// How the cells of a mesh get groups.
pub(super) fn grouping(form: GroupForm) -> &'static str {
    match form {
        GroupForm::Sets => {
            "in Abaqus, put every element of the section in a set (*ELEMENT, ELSET=, or *ELSET)"
        }
        GroupForm::Values => {
            "give every cell a number in an array of whole numbers by cell called \"group\""
        }
        GroupForm::Physical => {
            "in gmsh, put every surface of the section in a physical surface, and set \
             Mesh.SaveAll = 0 (with 1, files of version 2.2 contain no groups)"
        }
    }
}

/// The keys of a table of strengths, as text.
pub(super) fn strength_keys(table: &str) -> &'static str {
    match table {
        "strength" => "\"xt\" to \"s23\", \"tension\" to \"shear\", or \"yield\"",
        _ => "\"xt\" to \"s23\", or \"tension\" to \"shear\"",
    }
}

pub(in crate::input) fn nearest_or_all(found: &str, known: &[String], what: &str) -> String {
    match nearest_name(found, known.iter().map(String::as_str)) {
        Some(near) => format!("did you mean \"{near}\"?"),
        None if known.is_empty() => format!("{what}: none"),
        None => format!("{what}: {}", quoted(known)),
    }
}

/// `lead cells 1, 2, 3 and 4 more`; nothing for no cells.
pub(super) fn listed(lead: &str, has_lines: bool, cells: &[u64]) -> String {
    if cells.is_empty() {
        return String::new();
    }
    let shown: Vec<_> = cells.iter().take(NAMES_SHOWN).map(u64::to_string).collect();
    let word = match (cells.len(), has_lines) {
        (1, false) => "cell",
        (1, true) => "cell or line",
        (_, false) => "cells",
        (_, true) => "cells or lines",
    };
    let rest = match cells.len() - shown.len() {
        0 => String::new(),
        rest => format!(" and {rest} more"),
    };
    format!("{lead} {word} {}{rest}", shown.join(", "))
}

/// The constants across the fiber that a transversely isotropic material has, and the
/// expected ones.
pub(super) fn across_fiber(has_both: bool) -> &'static str {
    if has_both {
        "\"nu23\" and \"g23\" without \"e3\", \"g13\" and \"nu13\": expected one of the two \
             (G23 = E2 / (2 (1 + nu23))), or all nine constants"
    } else {
        "neither \"nu23\" nor \"g23\", expected one of them"
    }
}
