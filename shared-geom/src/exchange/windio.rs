//! Blades of windIO turbine files, versions 1 and 2: the 6x6 matrices along the
//! reference axis.
//!
//! Both versions are numerically in the axes and order of BeamDyn, although the text of
//! the schema on x, y and K44 differs: the converter between the versions, the converter
//! to BeamDyn and the files of the reference turbines agree on this. Positions are parts
//! of the length of the reference axis. The twist of windIO is BeamDyn's: positive nose
//! down.
//!
//! | | version 1 | version 2 |
//! |---|---|---|
//! | under `components.blade` | `elastic_properties_mb.six_x_six` | `structure.elastic_properties` |
//! | stiffness | `stiff_matrix.values`: upper triangles | `stiffness_matrix`: K11 to K66 |
//! | mass | `inertia_matrix.values`: upper triangles | mass, cm_x, cm_y, i_edge, i_flap, i_plr, i_cp |
//! | axis | `reference_axis` there | `reference_axis` of the blade |
//! | twist | `twist` there [rad] | `outer_shape.twist` [deg] |
//! | damping | none | `structural_damping.mu` [s] |
//!
//! With the body `"tower"` the file is the one of its [tower].

use super::yaml;
use std::path::Path;

use super::problem::Problems;
use super::{Options, Reading, Writing};
use crate::blade::Blade;
use crate::error::Diagnostics;

mod anchors;
mod assemble;
mod block;
pub mod fields;
mod flow;
mod into;
mod length;
mod mass;
mod tower;
mod version1;
mod version2;
mod write;

#[cfg(test)]
mod into_tests;
#[cfg(test)]
mod tests;

pub use assemble::line as reference_line;
pub(super) use into::write_into;
pub use length::length_remark;
pub use write::PART as WINDIO_PART;

/// Table of the matrices of version 1.
const VERSION_1: [&str; 3] = ["components", "blade", "elastic_properties_mb"];

/// Whether `text` is a turbine file of windIO with a blade.
pub(super) fn recognize(text: &str) -> bool {
    let key = |line: &str, name: &str| line.trim_start().starts_with(name);
    let has = |name: &str| text.lines().any(|line| key(line, name));
    let marked = has("windIO_version") || has("elastic_properties") || has("outer_shape");
    has("components:") && has("blade:") && marked
}

/// Whether the blade of `text` is of version 1: other bodies may have these tables in version 2.
pub(super) fn is_version_1(text: &str) -> bool {
    let depth = |line: &str| line.len() - line.trim_start().len();
    let is_blade = |line: &&str| line.trim_start().starts_with("blade:");
    let has_table = |start: usize| {
        let mut lines = text.lines().skip(start);
        let own = lines.next().map_or(0, depth);
        let inside = lines.take_while(|line| line.trim().is_empty() || depth(line) > own);
        let mut keys = inside.map(str::trim_start);
        keys.any(|key| {
            key.starts_with("elastic_properties_mb") || key.starts_with("outer_shape_bem")
        })
    };
    let mut blades = text.lines().enumerate().filter(|(_, line)| is_blade(line));
    recognize(text) && blades.any(|(start, _)| has_table(start))
}

/// Whether `text` is of version 2.
pub(super) fn is_version_2(text: &str) -> bool {
    recognize(text) && !is_version_1(text)
}

/// Whether a body of `text` has its name: the tower of a turbine file.
pub(super) fn has_body(text: &str, body: &str) -> bool {
    body == tower::BODY && recognize(text)
}

/// Reads the blade of a turbine file of either version, or its tower as one.
///
/// # Errors
/// All errors of the required parts of the file.
pub(super) fn read(text: &str, file: &Path, options: &Options) -> Result<Reading, Diagnostics> {
    let mut problems = Problems::new(&file.display().to_string());
    let root = match yaml::parse(text) {
        Ok(root) => root,
        Err((line, problem)) => {
            problems.push(line, &problem);
            return Err(problems.into_diagnostics());
        }
    };
    if options.body.as_deref() == Some(tower::BODY) {
        let reading = tower::reading(&root, (text, file), &mut problems);
        return problems.finish(reading);
    }
    let tables = if root.path(&VERSION_1).is_some() || is_version_1(text) {
        version1::tables(&root, &mut problems)
    } else {
        version2::tables(&root, &mut problems)
    };
    let name = root.entry("name").and_then(yaml::Node::text);
    let reading = tables.map(|tables| {
        let name = name.unwrap_or("blade").to_owned();
        assemble::reading(tables, name, text)
    });
    problems.finish(reading)
}

/// The blade as a file of version 1.
pub(super) fn write_version_1(blade: &Blade, name: &str) -> Writing {
    write::version_1(blade, name)
}

/// The blade as a file of version 2.
pub(super) fn write_version_2(blade: &Blade, name: &str) -> Writing {
    write::version_2(blade, name)
}
