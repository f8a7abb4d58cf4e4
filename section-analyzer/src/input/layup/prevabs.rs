//! Sections of PreVABS as layups.
//!
//! | PreVABS | here |
//! | --- | --- |
//! | axes x1 toward the reader, x2 to the right, x3 up | x, y, z: the same |
//! | base lines of the segments that close a loop | the contour, run clockwise |
//! | layups inward of them, from the base line | layers from the outside in |
//! | fiber angle from x1 toward the direction of the base line | `toward = "contour"`, with the other sign where the line runs counterclockwise |
//! | a straight segment between both sides | a web |
//! | a component of the type "fill" with a location | a fill between the nearest webs |
//!
//! The points z of the file become x = R(rotate) scale (z + translate); thicknesses are not scaled.
//!
//! # References
//! - PreVABS 2.1, user manual: guide, <https://wenbinyugroup.github.io/prevabs>.

use std::path::Path;

use shared_geom::error::Diagnostics;

use super::{Layup, Materials};
use files::{Element, Files, Notes};
use geometry::Geometry;

mod assembly;
mod components;
mod contour;
mod files;
mod fills;
mod geometry;
mod layups;
mod materials;
mod rules;
mod stack;
mod webs;

/// Points of the plane of the section, (x2, x3).
type Points = Vec<[f64; 2]>;

/// Whether a text is the main file of a section of PreVABS.
pub(super) fn recognize(text: &str) -> bool {
    let text = text.trim_start_matches('\u{feff}').trim_start();
    text.starts_with('<')
        && ["<cross_section", "<sg"]
            .iter()
            .any(|tag| text.contains(tag))
}

/// Reads the section whose main file is `text`, and the files that it includes.
///
/// # Errors
/// All problems of these files.
pub(super) fn read(text: &str, path: &Path, materials: Materials) -> Result<Layup, Diagnostics> {
    let mut notes = Notes::new(path);
    let layup = Files::load(text, path, &mut notes).and_then(|files| {
        files.parsed(&mut notes, |main, all, notes| {
            section(main, all, (path, materials), notes)
        })
    });
    let remarks = notes.remarks;
    notes
        .problems
        .finish(layup.map(|layup| Layup { remarks, ..layup }))
}

/// The section of a main file; `all` has the roots of all files, the main file last.
fn section<'x>(
    main: Element<'x>,
    all: &[Element<'x>],
    (path, treatment): (&Path, Materials),
    notes: &mut Notes,
) -> Option<Layup> {
    for root in all {
        rules::check(*root, notes);
    }
    rules::refuse(main, notes);
    let place = geometry::Placement::read(main, notes);
    let parts = |name: &str| files::parts(all, name);
    let known = materials::Known::read(&parts("materials"), notes);
    let layups = layups::read(&parts("layups"), &known, notes);
    let mut geometry = Geometry::new(&parts("baselines"), path, notes);
    let components = components::read(main, &mut geometry, &layups, notes);
    let fills = fills::read(main, &mut geometry, &known, notes);
    let of_plies = components.iter().flat_map(components::List::materials);
    let of_fills = fills.iter().flatten().map(|fill| fill.material.as_str());
    let mut used = Vec::new();
    for material in of_plies.chain(of_fills) {
        if !used.contains(&material) {
            used.push(material);
        }
    }
    let constants = known.constants(&used, treatment, notes);
    let place = place?;
    let placed = components?.placed(&place, notes)?;
    let fills = fills?.into_iter().map(|fill| fill.placed(&place));
    let made = assembly::assemble(placed, fills.collect(), notes)?;
    notes.remarks.push(
        "the file has no units: its numbers are taken as SI units, and results are in the units \
         of the file if these are consistent"
            .to_owned(),
    );
    Some(Layup {
        name: None,
        shape: made.shape,
        places: Vec::new(),
        layers: made.layers,
        webs: made.webs,
        fills: made.fills,
        size: None,
        line: None,
        stations: Vec::new(),
        constants: super::constants::constants(&constants?),
        unit: 1.0,
        remarks: Vec::new(),
        file: path.display().to_string(),
        shape_line: made.line,
        size_line: made.line,
    })
}
