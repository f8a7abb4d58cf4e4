//! The air of the last revolutions of a run in time.

use std::collections::VecDeque;
use std::f64::consts::TAU;

use shared_geom::files::OutputProblem;

use super::disk::{BladeRows, DiskPlot};
use super::equal::are_equal;
use super::{air_csv, rotors};
use crate::case::Model;
use crate::elements::{AirState, Observations};
use crate::output::folder::Results;
use crate::output::rows::number;
use crate::result::AcceptedStep;

/// Table of the last revolutions.
const TABLE: &str = "transient_air.csv";
/// Beginning of the names of figures, before the number of the rotor.
const DISK: &str = "disk_";
/// Most states of strips that are kept.
const MOST_STATES: usize = 300_000;
/// Round-off of the angle of a revolution \[rad\].
const ROUND_OFF: f64 = 1e-6;

/// The strips at a time.
#[derive(Debug, Clone, PartialEq)]
struct Row {
    /// \[s\].
    time: f64,
    /// Angle by which the rotor has turned since the first row \[rad\].
    turned: f64,
    states: Vec<AirState>,
}

/// The rows of the last revolutions.
#[derive(Debug)]
pub(in crate::output) struct AirRecord<'a> {
    model: &'a Model,
    /// Number of revolutions.
    revolutions: usize,
    rows: VecDeque<Row>,
}

impl<'a> AirRecord<'a> {
    /// No row yet.
    pub fn new(model: &'a Model, revolutions: usize) -> Self {
        Self {
            model,
            revolutions,
            rows: VecDeque::new(),
        }
    }

    /// Removes the files of an earlier run.
    pub fn remove_files(results: &Results<'_>) {
        results.remove([TABLE]);
        results.remove_numbered(DISK, ".png");
        results.remove_numbered(DISK, ".svg");
    }

    /// Adds the state of a row, and drops the ones that are too old.
    pub fn add(&mut self, accepted: &AcceptedStep<'_>) {
        let system = &self.model.system;
        let mut observed = Observations::default();
        for (index, element) in system.elements().enumerate() {
            if element.reports().is_some() {
                let (state, conditions) = (accepted.state, accepted.conditions);
                system.observe_element(index, state, conditions, &mut observed);
            }
        }
        self.push(accepted.time, observed.air);
    }

    fn push(&mut self, time: f64, states: Vec<AirState>) {
        let speed = |states: &[AirState]| {
            let rotor = states.iter().find_map(|state| state.rotor);
            rotor.map_or(0.0, |rotor| rotor.turning.abs())
        };
        let turned = match self.rows.back() {
            Some(last) => {
                let mean = 0.5 * (speed(&last.states) + speed(&states));
                last.turned + mean * (time - last.time)
            }
            None => 0.0,
        };
        let count = states.len();
        self.rows.push_back(Row {
            time,
            turned,
            states,
        });
        let first = turned - TAU * self.revolutions as f64 - ROUND_OFF;
        let is_old = |row: Option<&Row>| row.is_some_and(|row| row.turned < first);
        // The last row before the first revolution completes it.
        while is_old(self.rows.get(1)) || self.rows.len() * count > MOST_STATES {
            self.rows.pop_front();
        }
    }

    /// Writes the table and, if figures are drawn, the maps of the last revolution.
    pub fn write(&self, results: &mut Results<'_>) -> Result<(), OutputProblem> {
        let groups = self.rows.iter();
        let groups = groups.map(|row| (vec![number(row.time)], &row.states[..]));
        results.text(TABLE, &air_csv("time [s]", groups))?;
        let Some(last) = self.rows.back() else {
            return Ok(());
        };
        if !results.draws() {
            return Ok(());
        }
        let (mut numbers, mut plots) = (Vec::new(), Vec::new());
        for (index, name) in rotors(&last.states).into_iter().enumerate() {
            if let Some(plot) = self.maps(name) {
                numbers.push(index + 1);
                plots.push(plot);
            }
        }
        DiskPlot::share_colors(&mut plots);
        for (number, plot) in numbers.into_iter().zip(plots) {
            let endings = ["png", "svg"].map(|ending| format!("{DISK}{number}.{ending}"));
            results.figures([&endings[0], &endings[1]], || Some(plot))?;
        }
        Ok(())
    }

    /// The maps of a rotor, one of each quantity if its blades are equal.
    fn maps(&self, rotor: &str) -> Option<DiskPlot> {
        let title = format!("{}: {rotor}, last revolution", self.model.name);
        let plot = DiskPlot::new(title, &self.last_revolution(rotor))?;
        Some(if are_equal(&plot.maps) {
            plot.of_equal_blades()
        } else {
            plot
        })
    }

    /// The strips of each blade of a rotor, from the root to the tip, at each time of the last
    /// revolution.
    fn last_revolution(&self, rotor: &str) -> Vec<BladeRows<'_>> {
        let Some(last) = self.rows.back() else {
            return Vec::new();
        };
        let mut names: Vec<&str> = Vec::new();
        for location in last.states.iter().map(|state| &state.location) {
            if location.rotor.as_deref() == Some(rotor) && !names.contains(&location.blade.as_str())
            {
                names.push(&location.blade);
            }
        }
        let first = last.turned - TAU - ROUND_OFF;
        let count = self.rows.iter().filter(|row| row.turned < first).count();
        let of_blade = |name: &str| {
            let rows = self.rows.iter().skip(count.saturating_sub(1));
            let rows = rows.map(|row| {
                let states = row.states.iter();
                states
                    .filter(|state| state.location.blade == name)
                    .collect()
            });
            rows.collect()
        };
        names
            .into_iter()
            .map(|name| (name, of_blade(name)))
            .collect()
    }
}
