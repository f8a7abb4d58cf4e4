//! Histories of loads over time, and the cycles in them.

use std::collections::BTreeMap;
use std::path::Path;

use nalgebra::RowVector6;
use shared_geom::error::{Diagnostics, Explain, SourceLocation};
use shared_geom::wrench::COMPONENTS;

use crate::input::case_durations::read_durations;
use crate::input::span_loads::{ListedStation, LoadInstant};
use crate::output::FatigueRow;
use crate::recovery::fatigue::LoadHistory;
use crate::recovery::rainflow::equivalent_range;

/// A reason for which durations cannot be used.
#[derive(Debug, thiserror::Error)]
enum NoDurations {
    #[error("the loads have no cases over time, expected columns case and time")]
    Cases,
    #[error("case \"{case}\" has the times of one instant, expected two or more")]
    Instant { case: String },
}

impl Explain for NoDurations {
    fn help(&self) -> Option<String> {
        let text = "durations are the times of histories: omit --durations, or complete the \
                    loads";
        Some(text.to_owned())
    }
}

/// The instants of a case in the order of their times.
struct Case {
    instants: Vec<(f64, usize)>,
    /// How often it occurs.
    repetitions: f64,
}

impl Case {
    /// Time from its first to its last instant.
    fn duration(&self) -> f64 {
        let [first, last] = [self.instants.first(), self.instants.last()];
        last.map_or(0.0, |last| last.0) - first.map_or(0.0, |first| first.0)
    }
}

/// The histories of all cases with times.
pub(super) struct Histories<'a> {
    loads: &'a [LoadInstant],
    cases: Vec<Case>,
}

impl<'a> Histories<'a> {
    /// The histories of `loads`, each once, or with the time that it lasts by the table
    /// `durations`.
    ///
    /// # Errors
    /// All problems of the durations.
    pub fn new(loads: &'a [LoadInstant], durations: Option<&Path>) -> Result<Self, Diagnostics> {
        let mut cases: BTreeMap<Option<&str>, Vec<(f64, usize)>> = BTreeMap::new();
        for (number, load) in loads.iter().enumerate() {
            if let Some(time) = load.time {
                let case = cases.entry(load.case.as_deref()).or_default();
                case.push((time, number));
            }
        }
        let (names, instants): (Vec<_>, Vec<_>) = cases.into_iter().unzip();
        let case = |mut instants: Vec<(f64, usize)>| {
            instants.sort_by(|a, b| a.0.total_cmp(&b.0));
            Case {
                instants,
                repetitions: 1.0,
            }
        };
        let mut cases: Vec<Case> = instants.into_iter().map(case).collect();
        if let Some(path) = durations {
            let wrong = |problem: NoDurations| {
                let location = SourceLocation::file(path.display().to_string());
                Diagnostics::one(location, &problem)
            };
            let names: Vec<String> = names.into_iter().flatten().map(str::to_owned).collect();
            if names.is_empty() {
                return Err(wrong(NoDurations::Cases));
            }
            let durations = read_durations(path, &names)?;
            for ((case, name), seconds) in cases.iter_mut().zip(names).zip(durations) {
                case.repetitions = match case.duration() {
                    length if length > 0.0 => seconds / length,
                    _ => return Err(wrong(NoDurations::Instant { case: name })),
                };
            }
        }
        Ok(Self { loads, cases })
    }

    pub fn is_empty(&self) -> bool {
        self.cases.is_empty()
    }

    /// The time of all histories, as often as they occur \[s\].
    pub fn duration(&self) -> f64 {
        let times = self.cases.iter();
        times.fold(0.0, |sum, case| sum + case.repetitions * case.duration())
    }

    /// The histories at a station.
    pub fn at(&self, station: &ListedStation) -> Vec<LoadHistory> {
        let history = |case: &Case| {
            let instants = case.instants.iter();
            let forces = instants.filter_map(|(_, number)| self.loads[*number].at(station.eta));
            LoadHistory {
                forces: forces.collect(),
                repetitions: case.repetitions,
            }
        };
        self.cases.iter().map(history).collect()
    }

    /// Damage-equivalent ranges of each component at each station for each exponent, by the
    /// cycles of all cases together; `equal` cycles, or one each second. None at stations without
    /// forces.
    pub fn equivalent_ranges(
        &self,
        stations: &[ListedStation],
        exponents: &[f64],
        equal: Option<f64>,
    ) -> Vec<FatigueRow> {
        let equal = equal.unwrap_or_else(|| self.duration());
        let mut rows = Vec::new();
        for station in stations.iter().filter(|_| !self.is_empty()) {
            let histories = self.at(station);
            if histories.iter().all(|history| history.forces.is_empty()) {
                continue;
            }
            for (i, component) in COMPONENTS.iter().enumerate() {
                let unit = RowVector6::from_fn(|_, j| f64::from(u8::from(i == j)));
                let counted = LoadHistory::cycles(&histories, &unit);
                let largest = counted
                    .iter()
                    .fold(0.0, |most: f64, one| most.max(one.range));
                let unit = if i < 3 { "N" } else { "N m" };
                rows.extend(exponents.iter().map(|&exponent| FatigueRow {
                    eta: station.eta,
                    section: station.section.clone(),
                    component: format!("{component} [{unit}]"),
                    // a sum of nothing is -0
                    cycles: counted.iter().fold(0.0, |sum, one| sum + one.count),
                    largest,
                    exponent,
                    equivalent: equivalent_range(&counted, exponent, equal),
                }));
            }
        }
        rows
    }
}
