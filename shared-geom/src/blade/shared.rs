//! Equal problems of many stations in one.

use std::mem::discriminant;

use super::{Blade, BladeProblem};
use crate::section::{self, PropertyProblem};

/// Fewest stations with problems of one kind that are reported together.
const FEWEST: usize = 3;
/// Most stations that a message names.
const NAMED: usize = 5;

impl Blade {
    /// The problems of the blade, problems of one kind at three stations or more as one, with
    /// the index of its first station; see [`Blade::problems`].
    pub(crate) fn shared_problems(&self) -> Vec<PlacedProblem> {
        shared(&self.placed_problems(), self.stations.len())
    }

    /// As [`Blade::shared_problems`], only the numbers with which no computation is possible.
    pub(crate) fn shared_unusable(&self) -> Vec<PlacedProblem> {
        let stations = self.stations.iter().enumerate();
        let unusable = stations.filter_map(|(k, station)| {
            let problem = BladeProblem::Station {
                station: k + 1,
                position: station.arc_length,
                problem: section::unusable(&station.stiffness, &station.mass)?,
            };
            Some((Some(k), problem))
        });
        shared(&unusable.collect::<Vec<_>>(), self.stations.len())
    }

    /// The problems of the blade for a list; problems of one kind at three stations or more
    /// as one.
    pub fn summarized_problems(&self) -> Vec<BladeProblem> {
        self.shared_problems().into_iter().map(|p| p.1).collect()
    }
}

/// A problem with the index of its station; `None` for the blade as a whole.
pub(crate) type PlacedProblem = (Option<usize>, BladeProblem);

/// The problems of a blade of `stations` stations, problems of one kind at three stations or
/// more as one.
fn shared(placed: &[PlacedProblem], stations: usize) -> Vec<PlacedProblem> {
    let count = |kind: &PropertyProblem| {
        let kinds = placed.iter().filter_map(|(_, problem)| property(problem));
        kinds.filter(|other| is_alike(kind, other)).count()
    };
    let mut shared: Vec<PlacedProblem> = Vec::new();
    let mut done: Vec<PropertyProblem> = Vec::new();
    for (station, problem) in placed {
        let kind = property(problem).filter(|kind| count(kind) >= FEWEST);
        let Some(kind) = kind else {
            shared.push((*station, problem.clone()));
            continue;
        };
        if done.iter().any(|other| is_alike(&kind, other)) {
            continue;
        }
        shared.push((*station, of_kind(&kind, placed, stations)));
        done.push(kind);
    }
    shared
}

/// All problems of a kind as one.
fn of_kind(kind: &PropertyProblem, placed: &[PlacedProblem], stations: usize) -> BladeProblem {
    let same = placed.iter().filter_map(|(station, problem)| {
        let found = property(problem).filter(|found| is_alike(kind, found))?;
        Some((station.map_or(0, |station| station + 1), found))
    });
    let same: Vec<_> = same.collect();
    BladeProblem::Stations {
        stations: names(&same, stations),
        differ: if same.iter().all(|(_, found)| found == kind) {
            String::new()
        } else {
            format!(" (station {})", same.first().map_or(0, |one| one.0))
        },
        problem: kind.clone(),
    }
}

/// The stations as text: "all 30 stations", or the first ones.
fn names(same: &[(usize, PropertyProblem)], all: usize) -> String {
    if same.len() == all {
        return format!("all {all} stations");
    }
    let shown = same
        .iter()
        .take(NAMED)
        .map(|(station, _)| station.to_string());
    let shown = shown.collect::<Vec<_>>().join(", ");
    match same.len().saturating_sub(NAMED) {
        0 => format!("stations {shown}"),
        more => format!("stations {shown} and {more} more of {all}"),
    }
}

/// The problem of the properties of a station.
fn property(problem: &BladeProblem) -> Option<PropertyProblem> {
    match problem {
        BladeProblem::Station { problem, .. } => Some(problem.clone()),
        BladeProblem::IndefiniteStation { value, .. } => Some(PropertyProblem::Indefinite {
            field: "stiffness",
            expected: "positive definite",
            value: *value,
        }),
        _ => None,
    }
}

/// Whether two problems are of one kind, of the same entry or matrix.
fn is_alike(a: &PropertyProblem, b: &PropertyProblem) -> bool {
    use PropertyProblem::{Asymmetric, Diagonal, Indefinite, NotFinite, TooLarge};
    let same = match (a, b) {
        (
            Diagonal {
                field: a, index: i, ..
            },
            Diagonal {
                field: b, index: j, ..
            },
        ) => (a, i) == (b, j),
        (
            Asymmetric {
                field: a,
                row: i,
                column: k,
                ..
            },
            Asymmetric {
                field: b,
                row: j,
                column: l,
                ..
            },
        ) => (a, i, k) == (b, j, l),
        (Indefinite { field: a, .. }, Indefinite { field: b, .. })
        | (NotFinite { field: a }, NotFinite { field: b })
        | (TooLarge { field: a, .. }, TooLarge { field: b, .. }) => a == b,
        _ => true,
    };
    discriminant(a) == discriminant(b) && same
}
