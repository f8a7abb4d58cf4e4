//! The requested equilibria under loads and critical loads.

use nalgebra::Vector3;
use shared_geom::document::Table;
use shared_geom::units::Dimension;

use super::counts::at_most;
use super::loads::{LoadProblem, flag};
use super::problem::InputProblem;
use super::speeds::{self, RPM};
use super::transient;
use crate::case::{BucklingQuestion, ModesQuestion, Spin, StaticQuestion, TransientQuestion};

/// Default of the largest number of steps along a path.
const DEFAULT_MOST_STEPS: usize = 500;
/// Steps of one run: more are treated as an error.
const MOST_STEPS: usize = 100_000;
/// Default number of critical loads.
const DEFAULT_COUNT: usize = 4;
/// Largest number of critical loads of one run.
const MOST_LOADS: usize = 1000;
/// Part of gravity across the axis below which gravity is treated as axial: digits lost in
/// the input.
const ALONG: f64 = 1e-9;

/// All analyses of a model.
#[derive(Debug, Clone, Default)]
pub(super) struct Questions {
    pub modes: Option<ModesQuestion>,
    pub statics: Option<StaticQuestion>,
    pub buckling: Option<BucklingQuestion>,
    pub transient: Option<TransientQuestion>,
}

/// Reads the cards of all analyses.
pub(super) fn read(root: &Table<'_>) -> Option<Questions> {
    let modes = match root.has("modes") {
        true => speeds::read(root).map(Some),
        false => Some(None),
    };
    let (statics, buckling) = (statics(root), buckling(root));
    let transient = transient::read(root);
    Some(Questions {
        modes: modes?,
        statics: statics?,
        buckling: buckling?,
        transient: transient?,
    })
}

/// Reads `[static]`; `Some(None)` without the card.
fn statics(root: &Table<'_>) -> Option<Option<StaticQuestion>> {
    if !root.has("static") {
        return Some(None);
    }
    let table = root.table("static")?;
    let speed = speed(&table);
    let to = match table.has("to") {
        true => table.quantity("to", Dimension::NUMBER),
        false => Some(1.0),
    };
    let steps = match table.has("steps") {
        true => at_most(&table, "steps", table.count("steps"), MOST_STEPS).map(Some),
        false => Some(None),
    };
    let arc_length = flag(&table, "arc_length");
    let most_steps = match table.has("most_steps") {
        true => at_most(&table, "most_steps", table.count("most_steps"), MOST_STEPS),
        false => Some(DEFAULT_MOST_STEPS),
    };
    table.finish();
    let steps = steps?;
    Some(Some(StaticQuestion {
        speed: speed?,
        to: to?,
        steps,
        arc_length: arc_length?,
        // Requested steps are always allowed.
        most_steps: most_steps?.max(steps.unwrap_or(0)),
    }))
}

/// Reads `[buckling]`; `Some(None)` without the card.
fn buckling(root: &Table<'_>) -> Option<Option<BucklingQuestion>> {
    if !root.has("buckling") {
        return Some(None);
    }
    let table = root.table("buckling")?;
    let speed = speed(&table);
    let count = match table.has("count") {
        true => at_most(&table, "count", table.count("count"), MOST_LOADS),
        false => Some(DEFAULT_COUNT),
    };
    table.finish();
    Some(Some(BucklingQuestion {
        speed: speed?,
        count: count?,
    }))
}

fn speed(table: &Table<'_>) -> Option<f64> {
    if !table.has("speed") {
        return Some(0.0);
    }
    let speed = table.quantity("speed", Dimension::ROTATION_SPEED)?;
    if speed < 0.0 {
        let (key, rpm) = ("speed", speed / RPM);
        table.note(key, &InputProblem::NegativeSpeed { key, rpm });
        return None;
    }
    Some(speed)
}

impl Questions {
    /// The first and the last time at which drives are evaluated \[s\]: equilibria and
    /// modes are at time zero.
    pub fn times(&self) -> Option<[f64; 2]> {
        let at_rest = self.modes.is_some() || self.statics.is_some() || self.buckling.is_some();
        let run = self.transient.as_ref().map(|run| [run.from, run.to]);
        match (at_rest, run) {
            (true, Some([from, to])) => Some([from.min(0.0), to.max(0.0)]),
            (true, None) => Some([0.0; 2]),
            (false, run) => run,
        }
    }

    /// Notes gravity across the axis of a rotating model: it has no steady equilibrium. Runs in time
    /// start from the mean of it.
    pub fn check(&self, root: &Table<'_>, gravity: &Vector3<f64>, spin: &Spin) {
        let of_modes = self.modes.iter().flat_map(|modes| modes.speeds.iter());
        let of_statics = self.statics.iter().map(|statics| &statics.speed);
        let of_buckling = self.buckling.iter().map(|buckling| &buckling.speed);
        let speeds = of_modes.chain(of_statics).chain(of_buckling);
        let highest = speeds.copied().map(f64::abs).fold(0.0, f64::max);
        let across = (gravity - spin.axis * spin.axis.dot(gravity)).norm();
        if highest > 0.0 && across > ALONG * gravity.norm() {
            let rpm = highest / RPM;
            root.note("gravity", &LoadProblem::GravityGoesRound { across, rpm });
        }
    }
}
