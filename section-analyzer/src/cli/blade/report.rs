//! The report of a blade: its remarks, and the tables of other commands that it shows.

use std::collections::BTreeMap;

use shared_geom::blade::{self, Blade};
use shared_geom::hash::{fingerprint, sha256_of_content};

use crate::input::layup::Layup;
use crate::input::result_tables::{ListedReserve, ModeTable, read_reserves};
use crate::mesh::short;
use crate::output::{LayerRow, Remark, ReportPage, SolvedSpan, SolvedStation, SpanFiles};

/// Part of a layer that is cut or filled from which there is a remark [-].
const CUT: f64 = 0.01;

/// Contents of the report besides the sections.
#[derive(Debug)]
pub(super) struct Request {
    /// The modes of the blade.
    pub modes: Option<ModeTable>,
    /// The blade with which it is compared.
    pub other: Option<Blade>,
    /// Sections without a result.
    pub missing: Vec<String>,
}

impl Request {
    pub fn new(modes: Option<ModeTable>, other: Option<Blade>, missing: &[String]) -> Self {
        let missing = missing.to_vec();
        Self {
            modes,
            other,
            missing,
        }
    }

    /// The report of the solved sections; `None` if there are none.
    pub fn page(&self, layup: &Layup, span: &SolvedSpan<'_>, files: &SpanFiles) -> Option<String> {
        if span.stations.is_empty() {
            return None;
        }
        let about_blade = |text: String| Remark {
            text,
            sections: Vec::new(),
        };
        let mut remarks: Vec<Remark> = layup.remarks.iter().cloned().map(about_blade).collect();
        if !self.missing.is_empty() {
            remarks.push(about_blade(format!(
                "no section at {}: the messages of the run have the reason",
                self.missing.join(", ")
            )));
        }
        let reserves = match reserves(span, files) {
            Ok(reserves) => reserves,
            Err(reason) => {
                remarks.push(about_blade(reason));
                Vec::new()
            }
        };
        let modes = self.modes.iter();
        remarks.extend(
            modes
                .filter_map(|modes| other_modes(span, modes))
                .map(about_blade),
        );
        remarks.extend(cut_layers(span));
        remarks.extend(poor_cells(span));
        remarks.extend(warnings(span));
        let page = ReportPage {
            span,
            remarks: &remarks,
            reserves: &reserves,
            modes: self.modes.as_ref(),
            other: self.other.as_ref(),
        };
        Some(page.html())
    }
}

/// The reserve factors that `strength` found for these sections; none without its file.
///
/// # Errors
/// A file that cannot be read, or of which a section had other files than now.
fn reserves(span: &SolvedSpan<'_>, files: &SpanFiles) -> Result<Vec<ListedReserve>, String> {
    let file = files.strength();
    if !file.exists() {
        return Ok(Vec::new());
    }
    let shown = file.file_name().unwrap_or_default().to_string_lossy();
    let found =
        read_reserves(&file).map_err(|problems| format!("{shown} is not shown: {problems}"))?;
    let has_changed = |station: &&SolvedStation| {
        let mut rows = found.iter();
        rows.any(|row| {
            row.section == station.properties.name && row.fingerprint != station.fingerprint
        })
    };
    let changed = span.stations.iter().filter(has_changed);
    let changed: Vec<&str> = changed.map(|one| one.properties.name.as_str()).collect();
    if changed.is_empty() {
        return Ok(found);
    }
    Err(format!(
        "{shown} is not shown, sections have changed since ({}): run \"section-analyzer strength\" again",
        changed.join(", ")
    ))
}

/// The remark on modes that are not known to be of the blade of these sections.
fn other_modes(span: &SolvedSpan<'_>, modes: &ModeTable) -> Option<String> {
    let file = &modes.file;
    let Some(found) = &modes.blade_files else {
        return Some(format!(
            "{file} does not name the file of its blade: whether its modes are of this blade is unknown; \
             the table NAME.modes.csv of a blade from a file does"
        ));
    };
    let own = sha256_of_content(blade::write(&span.blade()).as_bytes());
    (!found.contains(fingerprint(&own))).then(|| {
        format!(
            "{file} has the modes of another blade, or of this one before a change ({found}): run \
             \"beam-dynamics modes\" again"
        )
    })
}

/// Layers whose cells have another area than the layer.
fn cut_layers(span: &SolvedSpan<'_>) -> Vec<Remark> {
    let remark = |(text, sections)| Remark { text, sections };
    cut_of_layers(span.layers())
        .into_iter()
        .map(remark)
        .collect()
}

/// Cause of the area of the cells of a layer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Cause {
    /// Both sides meet.
    Cut,
    /// The cells do not follow the layer.
    Less,
    /// It fills the space between both sides, as the innermost layer.
    Filled,
    /// The cells are longer than the layer.
    More,
}

impl Cause {
    /// The cause, and the part of the nominal area that is missing or more, if that is much.
    fn of(row: &LayerRow) -> Option<(Self, f64)> {
        let part = 1.0 - row.meshed / row.nominal;
        match part {
            part if part.abs() < CUT || !part.is_finite() => None,
            part if part < 0.0 && -part - row.filled / row.nominal < CUT => {
                Some((Self::Filled, -part))
            }
            part if part < 0.0 => Some((Self::More, -part)),
            part if part - row.cut / row.nominal < CUT => Some((Self::Cut, part)),
            part => Some((Self::Less, part)),
        }
    }
}

/// Layers whose cells have another area than the layer, with the names of the sections, by the
/// cause.
pub(super) fn cut_of_layers<'a>(
    sections: impl Iterator<Item = (&'a str, &'a [LayerRow])>,
) -> Vec<(String, Vec<String>)> {
    let mut worst: Vec<(&str, Cause, f64, Vec<String>)> = Vec::new();
    for (name, layers) in sections {
        for row in layers {
            let Some((cause, part)) = Cause::of(row) else {
                continue;
            };
            let is_it = |known: &&mut (&str, Cause, f64, Vec<String>)| {
                (known.0, known.1) == (row.layer.as_str(), cause)
            };
            match worst.iter_mut().find(is_it) {
                Some((_, _, most, sections)) => {
                    *most = most.max(part);
                    sections.push(name.to_owned());
                }
                None => worst.push((&row.layer, cause, part, vec![name.to_owned()])),
            }
        }
    }
    let text = |(layer, cause, part, sections): (&str, Cause, f64, Vec<String>)| {
        let percent = short((1000.0 * part).round() / 10.0);
        let text = match cause {
            Cause::Cut => format!(
                "layer \"{layer}\" is cut by up to {percent} % of its area where both sides meet, and behind, \
                 where the edge is thinner than their first layers"
            ),
            Cause::Less => format!(
                "layer \"{layer}\" has up to {percent} % less area in its cells than as given, more \
                 than is cut where both sides meet; a smaller \"size\" in [mesh] may bring it back"
            ),
            Cause::Filled => format!(
                "layer \"{layer}\" fills the space between both sides where they meet, by up to {percent} % more \
                 than its area, and has more mass and stiffness"
            ),
            Cause::More => format!(
                "layer \"{layer}\" has up to {percent} % more area in its cells than as given, and more \
                 mass and stiffness"
            ),
        };
        (text, sections)
    };
    worst.into_iter().map(text).collect()
}

/// Cells of poor shape, as one remark.
fn poor_cells(span: &SolvedSpan<'_>) -> Option<Remark> {
    let stations = span.stations.iter();
    let drawn = stations.filter_map(|station| Some((station, station.picture.as_ref()?)));
    let poor: Vec<_> = drawn
        .filter(|(_, picture)| picture.poor_cells > 0)
        .collect();
    let most = poor.iter().map(|(_, picture)| picture.poor_cells).max()?;
    Some(Remark {
        text: format!(
            "cells of poor shape, up to {most} in a section, near which results are less accurate; \
             the reports of the sections have their positions"
        ),
        sections: poor
            .iter()
            .map(|(station, _)| station.properties.name.clone())
            .collect(),
    })
}

/// Warnings about sections; equal ones are one.
fn warnings(span: &SolvedSpan<'_>) -> Vec<Remark> {
    let mut sections: BTreeMap<&str, Vec<String>> = BTreeMap::new();
    for station in &span.stations {
        for text in station.picture.iter().flat_map(|picture| &picture.warnings) {
            sections
                .entry(text)
                .or_default()
                .push(station.properties.name.clone());
        }
    }
    let remark = |(text, sections): (&str, Vec<String>)| Remark {
        text: text.to_owned(),
        sections,
    };
    sections.into_iter().map(remark).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An area of 1 of which 0.02 is cut or filled, with cells that have it and others.
    #[test]
    fn the_cause_of_an_area_is_what_explains_it() {
        for (meshed, cut, filled, expected) in [
            (1.005, 0.0, 0.0, None),
            (0.98, 0.02, 0.0, Some(Cause::Cut)),
            (0.98, 0.0, 0.0, Some(Cause::Less)),
            (0.98, 0.0, 0.02, Some(Cause::Less)),
            (1.02, 0.0, 0.02, Some(Cause::Filled)),
            (1.02, 0.0, 0.0, Some(Cause::More)),
            (1.02, 0.02, 0.0, Some(Cause::More)),
        ] {
            let row = LayerRow {
                layer: "skin".to_owned(),
                material: "glass".to_owned(),
                arcs: None,
                thickness: None,
                nominal: 1.0,
                meshed,
                cut,
                filled,
            };
            let found = Cause::of(&row).map(|found| found.0);
            assert_eq!(found, expected, "{row:?}");
        }
    }
}
