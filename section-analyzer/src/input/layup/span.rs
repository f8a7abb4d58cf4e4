//! Positions along the span at which the sections of a blade are solved.
//!
//! At a jump (a layer or web that begins or ends, a thickness or chord that jumps) there are two
//! sections, a millionth of the length inside and outside of it.

use std::collections::BTreeSet;

use shared_geom::document::Table;
use shared_geom::line::Side;
use shared_geom::units::Dimension;

use super::course::disorder;
use super::keys::STATIONS;
use super::resolve::ABSENT;
use super::{Layup, WrittenLayer};
use crate::mesh::generate::layup::LayupSection;

/// Distance of the sections at a jump from it, part of the length [-].
const BESIDE: f64 = 1e-6;
/// Positions that are closer are one; chosen ones need more distance [-].
const SAME: f64 = 1e-9;
const NEAR: f64 = 1e-4;
/// Relative change of a quantity across a position that is a jump.
const JUMP: f64 = 0.01;
/// Largest distance of chosen positions [-].
const STEP: f64 = 0.05;
/// Largest number of chosen positions before jumps are doubled.
const MOST: usize = 60;

/// A section of a blade to be solved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpanStation {
    /// Position along the span [-].
    pub eta: f64,
    /// Its side of a jump.
    pub side: Option<Side>,
}

impl SpanStation {
    /// The position at which the section is meshed [-].
    pub fn meshed_at(&self) -> f64 {
        match self.side {
            None => self.eta,
            Some(Side::Inner) => self.eta - BESIDE,
            Some(Side::Outer) => self.eta + BESIDE,
        }
    }

    /// Names of stations for files, `eta_0.2500`, at jumps `eta_0.2500_inner` and
    /// `eta_0.2500_outer`; with more digits where four do not distinguish them.
    pub fn names(stations: &[Self]) -> Vec<String> {
        let named = |digits: usize| -> Vec<String> {
            let name = |station: &Self| {
                let side = match station.side {
                    None => "",
                    Some(Side::Inner) => "_inner",
                    Some(Side::Outer) => "_outer",
                };
                format!("eta_{:.digits$}{side}", station.eta)
            };
            stations.iter().map(name).collect()
        };
        let is_distinct = |names: &Vec<String>| {
            let mut sorted = names.clone();
            sorted.sort();
            sorted.windows(2).all(|pair| pair[0] != pair[1])
        };
        let all = (4..12).map(named).find(is_distinct);
        all.unwrap_or_else(|| named(12))
    }
}

/// A layer, ply, web or fill that no station has.
#[derive(Debug, Clone, PartialEq)]
pub struct MissedLayer {
    /// `layer`, `web` or another word for it.
    kind: &'static str,
    name: String,
    line: usize,
    /// First and last position at which it is there [-].
    range: [f64; 2],
}

impl std::fmt::Display for MissedLayer {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self {
            kind,
            name,
            line,
            range,
        } = self;
        let [from, to] = range.map(crate::mesh::short);
        write!(
            f,
            "line {line}: {kind} \"{name}\" is there from eta {from} to {to}, and at no station"
        )
    }
}

/// The requested stations.
#[derive(Debug, Clone, PartialEq)]
pub enum Selection {
    /// The stations of the file, or else chosen ones: all positions at which the layup has
    /// values, at most 60, none farther from the next one than a twentieth of the length.
    Chosen,
    /// So many, at equal distances, and all jumps.
    Equal(usize),
    /// At these positions [-].
    Given(Vec<f64>),
}

/// Reads the key of the stations; `None` if it is wrong, which has been noted.
pub(super) fn stations(root: &Table<'_>) -> Option<Vec<f64>> {
    if !root.has(&STATIONS) {
        return Some(Vec::new());
    }
    let all = root.quantities(STATIONS.name(), Dimension::NUMBER)?;
    let expected = "ascending positions from 0 to 1";
    if all.is_empty() {
        root.wrong(&STATIONS, expected);
        return None;
    }
    if let Some(found) = disorder(&all, false) {
        root.wrong(&STATIONS, &format!("{expected}, not {found}"));
        return None;
    }
    Some(all)
}

/// Names of the layers, plies, webs and fills of sections.
fn present(sections: &[LayupSection]) -> BTreeSet<&str> {
    let mut found = BTreeSet::new();
    for section in sections {
        found.extend(section.layers.iter().map(|layer| layer.name.as_str()));
        let webs = section.webs.iter().filter(|web| !web.plies.is_empty());
        found.extend(webs.clone().map(|web| web.name.as_str()));
        found.extend(webs.flat_map(|web| &web.plies).map(|ply| ply.name.as_str()));
        let webs = section.spar.iter().flat_map(|spar| &spar.webs);
        found.extend(webs.map(|web| web.name.as_str()));
        found.extend(section.fills.iter().map(|fill| fill.name.as_str()));
    }
    found
}

/// First and last position between which a layer has a thickness; the whole span without a table
/// [-].
fn range_of(layer: &WrittenLayer) -> [f64; 2] {
    let points: Vec<(f64, f64)> = layer.thickness.points().collect();
    let is_there = |point: &(f64, f64)| point.1 > ABSENT;
    let (first, last) = (
        points.iter().position(is_there),
        points.iter().rposition(is_there),
    );
    match first.zip(last) {
        Some((first, last)) if !layer.thickness.is_held() => {
            let after = (last + 1).min(points.len() - 1);
            [points[first.saturating_sub(1)].0, points[after].0]
        }
        _ => [0.0, 1.0],
    }
}

impl Layup {
    /// The stations of a selection, from the root to the tip; both sides of a jump.
    pub fn span_stations(&self, selection: &Selection) -> Vec<SpanStation> {
        let jumps = self.jumps();
        let all = match selection {
            Selection::Given(all) => all.clone(),
            Selection::Chosen if !self.stations.is_empty() => self.stations.clone(),
            Selection::Chosen => self.chosen(&jumps),
            Selection::Equal(count) => {
                let last = count.saturating_sub(1).max(1) as f64;
                let equal = (0..*count).map(|i| i as f64 / last);
                equal.chain(jumps.iter().copied()).collect()
            }
        };
        let sides = |eta: f64| match jumps.iter().find(|jump| (**jump - eta).abs() < BESIDE) {
            None => vec![SpanStation { eta, side: None }],
            Some(&eta) => [Side::Inner, Side::Outer]
                .map(|side| SpanStation {
                    eta,
                    side: Some(side),
                })
                .to_vec(),
        };
        ordered(all, SAME).into_iter().flat_map(sides).collect()
    }

    /// The layers and plies that are absent in all sections, with their lines: at all positions of
    /// its tables and all chosen stations. None if a section does not exist there.
    pub fn absent_layers(&self) -> Vec<(&str, usize)> {
        let stations = self.span_stations(&Selection::Chosen);
        let stations = stations.iter().map(SpanStation::meshed_at);
        let sections = stations
            .chain(self.positions())
            .map(|eta| self.section(eta));
        let Ok(sections) = sections.collect::<Result<Vec<_>, _>>() else {
            return Vec::new();
        };
        let found = present(&sections);
        let plies = self.webs.iter().flat_map(|web| &web.plies);
        let all = self.layers.iter().chain(plies);
        let absent = all.filter(|layer| !found.contains(layer.name.as_str()));
        absent
            .map(|layer| (layer.name.as_str(), layer.line))
            .collect()
    }

    /// The layers, plies, webs and fills that are present between `stations`, at none of them; a web
    /// has the names of its plies.
    pub fn missed_layers(&self, stations: &[SpanStation]) -> Vec<MissedLayer> {
        let sections = stations
            .iter()
            .map(|station| self.section(station.meshed_at()));
        let Ok(sections) = sections.collect::<Result<Vec<_>, _>>() else {
            return Vec::new();
        };
        let found = present(&sections);
        let is_missed = |name: &str| !found.contains(name);
        let all = self
            .layers
            .iter()
            .chain(self.webs.iter().flat_map(|web| &web.plies));
        let webs = self.webs.iter().map(|web| web.name.as_str());
        let fills = self.fills.iter().map(|fill| fill.name.as_str());
        let mut names = all
            .map(|layer| layer.name.as_str())
            .chain(webs)
            .chain(fills);
        if !names.any(is_missed) {
            return Vec::new();
        }
        let absent = self.absent_layers();
        let is_there = |layer: &&WrittenLayer| !absent.contains(&(layer.name.as_str(), layer.line));
        let mut missed = Vec::new();
        let mut note = |kind, (name, line): (&String, usize), range| {
            missed.extend(is_missed(name).then(|| MissedLayer {
                kind,
                name: name.clone(),
                line,
                range,
            }));
        };
        for layer in self.layers.iter().filter(is_there) {
            note("layer", (&layer.name, layer.line), range_of(layer));
        }
        for web in &self.webs {
            let plies: Vec<&WrittenLayer> = web.plies.iter().filter(is_there).collect();
            if is_missed(&web.name) {
                if !plies.is_empty() || self.is_of_spar(web) {
                    note("web", (&web.name, web.line), web.range);
                }
                continue;
            }
            for ply in plies {
                let [from, to] = range_of(ply);
                let range = [from.max(web.range[0]), to.min(web.range[1])];
                note("layer", (&ply.name, ply.line), range);
            }
        }
        for fill in &self.fills {
            note("fill", (&fill.name, fill.line), fill.range);
        }
        missed
    }

    /// Positions between root and tip at which the layup jumps, ascending [-].
    pub fn jumps(&self) -> Vec<f64> {
        let mut all = ordered(self.changes(), SAME);
        all.retain(|eta| *eta > BESIDE && *eta < 1.0 - BESIDE && self.is_jump(*eta));
        all
    }

    /// Positions at which a quantity has a value, a web or fill begins or ends.
    fn changes(&self) -> Vec<f64> {
        let mut all = self.positions();
        all.extend(self.ranges().flatten());
        all
    }

    /// First and last positions of webs and fills.
    fn ranges(&self) -> impl Iterator<Item = [f64; 2]> {
        let webs = self.webs.iter().map(|web| web.range);
        webs.chain(self.fills.iter().map(|fill| fill.range))
    }

    fn is_jump(&self, eta: f64) -> bool {
        let differs = |value: &dyn Fn(f64) -> f64| {
            let [a, b] = [eta - BESIDE, eta + BESIDE].map(value);
            (a - b).abs() > JUMP * a.abs().max(b.abs())
        };
        let thickness = |layer: &WrittenLayer, eta: f64| {
            let is_there = layer.thickness.covers(eta) && layer.thickness.at(eta) > ABSENT;
            if is_there {
                layer.thickness.at(eta)
            } else {
                0.0
            }
        };
        let plies = self.webs.iter().flat_map(|web| &web.plies);
        let mut layers = self.layers.iter().chain(plies);
        let is_in = |[from, to]: [f64; 2], eta: f64| f64::from(eta >= from && eta <= to);
        layers.any(|layer| differs(&|eta| thickness(layer, eta)))
            || self.ranges().any(|range| differs(&|eta| is_in(range, eta)))
            || differs(&|eta| self.shape.chord.at(eta))
    }

    /// Positions of changes, thinned, with others between distant ones.
    fn chosen(&self, jumps: &[f64]) -> Vec<f64> {
        let mut all = self.changes();
        all.extend([0.0, 1.0]);
        let mut all = ordered(all, NEAR);
        let is_jump = |eta: f64| jumps.iter().any(|jump| (jump - eta).abs() < NEAR);
        while all.len() > MOST {
            let inner = (1..all.len() - 1).filter(|i| !is_jump(all[*i]));
            let gap = |i: &usize| all[i + 1] - all[i - 1];
            let Some(least) = inner.min_by(|a, b| gap(a).total_cmp(&gap(b))) else {
                break;
            };
            all.remove(least);
        }
        let mut refined = all.clone();
        for pair in all.windows(2) {
            let parts = ((pair[1] - pair[0]) / STEP - SAME).ceil().max(1.0);
            let between = (1..parts as usize).map(|i| i as f64 / parts);
            refined.extend(between.map(|part| pair[0] + part * (pair[1] - pair[0])));
        }
        // some of them may have been near other positions
        refined.extend(jumps);
        refined
    }
}

/// Positions from 0 to 1 in order; of those that are closer than `near` the first.
fn ordered(mut all: Vec<f64>, near: f64) -> Vec<f64> {
    all.retain(|eta| (0.0..=1.0).contains(eta));
    all.sort_by(f64::total_cmp);
    all.dedup_by(|next, kept| *next - *kept < near);
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    /// A cap that begins with a thickness and ends with none, a web, a skin with a kink.
    const LAYUP: &str = "\
units = \"SI\"
[shape]
naca = \"0018\"
chord = 1.0
[[layer]]
name = \"skin\"
material = \"a\"
thickness = { eta = [0, 0.5, 1], value = [0.01, 0.005, 0.005] }
[[layer]]
name = \"cap\"
material = \"a\"
thickness = { eta = [0.12, 0.7], value = [0.01, 0] }
from = 0.3
to = 0.4
[[web]]
name = \"web\"
suction = 0.35
pressure = 0.65
eta = [0.3, 1]
plies = [{ name = \"ply\", material = \"a\", thickness = 0.002 }]
[material.a]
young = 1e9
poisson = 0.3
density = 1
";

    fn layup(text: &str) -> Layup {
        let read = super::super::parse(text, Path::new("a.layup.toml"));
        read.unwrap_or_else(|problems| panic!("{problems}"))
    }

    #[test]
    fn jumps_are_ends_with_a_thickness() {
        assert_eq!(layup(LAYUP).jumps(), [0.12, 0.3]);
    }

    #[test]
    fn chosen_stations_have_all_changes_and_no_wide_gap() {
        let stations = layup(LAYUP).span_stations(&Selection::Chosen);
        let at = |eta: f64| stations.iter().filter(|one| one.eta == eta).count();
        for (eta, count) in [(0.0, 1), (0.12, 2), (0.3, 2), (0.5, 1), (0.7, 1), (1.0, 1)] {
            assert_eq!(at(eta), count, "{eta}");
        }
        let gaps = stations.windows(2).map(|pair| pair[1].eta - pair[0].eta);
        assert!(gaps.fold(0.0, f64::max) <= STEP * (1.0 + 1e-9));
        let inner = stations.iter().find(|one| one.side == Some(Side::Inner));
        assert_eq!(inner.map(SpanStation::meshed_at), Some(0.12 - BESIDE));
    }

    /// The file has priority over the choice, the option over the file.
    #[test]
    fn stations_are_those_of_the_option_or_of_the_file() {
        let text = LAYUP.replacen("units", "stations = [0.1, 0.3]\nunits", 1);
        let eta = |selection| -> Vec<f64> {
            let stations = layup(&text).span_stations(&selection);
            stations.iter().map(|one| one.eta).collect()
        };
        assert_eq!(eta(Selection::Chosen), [0.1, 0.3, 0.3]);
        assert_eq!(
            eta(Selection::Equal(3)),
            [0.0, 0.12, 0.12, 0.3, 0.3, 0.5, 1.0]
        );
        assert_eq!(eta(Selection::Given(vec![0.9, 0.2])), [0.2, 0.9]);
        for wrong in ["[0.3, 0.1]", "[0, 2]", "[]", "[0.1, 0.1]"] {
            let text = text.replacen("[0.1, 0.3]", wrong, 1);
            let read = super::super::parse(&text, Path::new("a.layup.toml"));
            let shown = read.expect_err("wrong").to_string();
            assert!(shown.contains("a.layup.toml:1: "), "{shown}");
            assert!(shown.contains("ascending positions from 0 to 1"), "{shown}");
        }
    }

    /// 200 random tables: at most [`MOST`] positions and the refinement, all jumps among them.
    #[test]
    fn many_positions_are_thinned() {
        let values = |from: usize, count: usize| {
            let eta: Vec<String> = (0..count)
                .map(|i| format!("{}", (from + 7 * i) as f64 / 1500.0))
                .collect();
            let value: Vec<String> = (0..count)
                .map(|i| format!("{}", 0.01 + 1e-5 * i as f64))
                .collect();
            format!(
                "{{ eta = [{}], value = [{}] }}",
                eta.join(", "),
                value.join(", ")
            )
        };
        for seed in 0..200 {
            let (from, count) = (1 + seed % 100, 2 + seed % 200);
            let text = LAYUP.replacen(
                "{ eta = [0.12, 0.7], value = [0.01, 0] }",
                &values(from, count),
                1,
            );
            let layup = layup(&text);
            let jumps = layup.jumps();
            assert!(jumps.len() >= 2, "{seed}: {jumps:?}");
            let stations = layup.span_stations(&Selection::Chosen);
            assert!(
                stations.len() < MOST + 25 + jumps.len(),
                "{seed}: {}",
                stations.len()
            );
            let doubled = stations.iter().filter(|one| one.side == Some(Side::Outer));
            assert_eq!(
                doubled.map(|one| one.eta).collect::<Vec<_>>(),
                jumps,
                "{seed}"
            );
        }
    }

    #[test]
    fn names_distinguish_stations() {
        let station = |eta, side| SpanStation { eta, side };
        let jump = [Side::Inner, Side::Outer].map(|side| station(0.25, Some(side)));
        let names = SpanStation::names(&jump);
        assert_eq!(names, ["eta_0.2500_inner", "eta_0.2500_outer"]);
        let near = [station(0.123_41, None), station(0.123_42, None)];
        assert_eq!(SpanStation::names(&near), ["eta_0.12341", "eta_0.12342"]);
    }
}
