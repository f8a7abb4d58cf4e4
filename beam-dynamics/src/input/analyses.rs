//! The requested equilibria under loads and critical loads.

use nalgebra::Vector3;
use shared_geom::document::schema::ValueKind::{
    Boolean, Count, NotNegative, Quantity, Table as OneTable,
};
use shared_geom::document::{ByHand, Table};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::loads::LoadProblem;
use super::rotor_speed::RPM;
use super::speeds;
use super::stability;
use super::sweep;
use super::transient;
use crate::case::{
    BucklingSettings, FrameRotation, ModesSettings, PeriodicSettings, StabilitySettings,
    StaticSettings, TransientSettings, TrimMethod, TrimSettings,
};

keys! {
    /// Equilibria under rotation and loads.
    pub(super) STATIC = "[static]";
    /// Load factor at the end of the path.
    TO: f64 = "to", [Quantity(Dimension::NUMBER)], or "1" = 1.0, "2.5";
    /// Number of equal steps to report.
    STEPS: Option<usize> = "steps", [Count(MOST_STEPS)], optional, "20";
    /// Whether to follow the path by its length, past limit points; no step is then longer than
    /// the first, `to` / `steps`.
    ARC_LENGTH: bool = "arc_length", [Boolean], or "false" = false, "true";
    /// Largest number of steps.
    MOST: usize = "most_steps", [Count(MOST_STEPS)], or "500" = DEFAULT_MOST_STEPS, "2000";
    /// Values of a parameter at which the equilibria are found.
    SWEEP: ByHand = "sweep", [OneTable(&sweep::STATIC_SWEEP)], optional, "";
    with SPEED.schema;
}

keys! {
    /// Factors of the proportional loads at which the model buckles, and the shapes.
    pub(super) BUCKLING = "[buckling]";
    /// Critical loads to report, nearest to zero first.
    COUNT: usize = "count", [Count(MOST_LOADS)], or "4" = DEFAULT_COUNT, "8";
    with SPEED.schema;
}

keys! {
    /// Rotor speed.
    SPEED: f64 = "speed", [NotNegative(Dimension::ROTATION_SPEED)], or "0" = 0.0, "300";
}

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
pub(super) struct Analyses {
    pub modes: Option<ModesSettings>,
    pub statics: Option<StaticSettings>,
    pub buckling: Option<BucklingSettings>,
    pub transient: Option<TransientSettings>,
    pub periodic: Option<PeriodicSettings>,
    pub trim: Option<TrimSettings>,
    pub stability: Option<StabilitySettings>,
}

/// Reads the cards of all analyses; `periodic` and `trim` are read with the model.
pub(super) fn read(
    root: &Table<'_>,
    periodic: Option<Option<PeriodicSettings>>,
    trim: Option<Option<TrimSettings>>,
) -> Option<Analyses> {
    let words = stability::words_alone(root);
    let modes = if root.has("modes") && words.is_none() {
        speeds::read(root).map(Some)
    } else {
        Some(None)
    };
    let (statics, buckling) = (statics(root), buckling(root));
    let transient = transient::read(root);
    let mut analyses = Analyses {
        modes: modes?,
        statics: statics?,
        buckling: buckling?,
        transient: transient?,
        periodic: periodic?,
        trim: trim?,
        stability: None,
    };
    let others = stability::Others {
        modes: analyses.modes.as_ref(),
        periodic: analyses.periodic.as_ref(),
        trim: analyses.trim.as_ref(),
    };
    let mut stability = stability::read(root, others)?;
    if let Some(own) = &mut stability {
        own.words = own.words.or(words);
    }
    analyses.stability = stability;
    Some(analyses)
}

/// Reads `[static]`; `Some(None)` without the card.
fn statics(root: &Table<'_>) -> Option<Option<StaticSettings>> {
    if !root.has("static") {
        return Some(None);
    }
    let table = root.table("static")?;
    let speed = table.get(&SPEED);
    let (to, steps) = (table.get(&TO), table.get(&STEPS));
    let (arc_length, most_steps) = (table.get(&ARC_LENGTH), table.get(&MOST));
    let sweep = sweep::under(&table, &SWEEP);
    table.finish();
    let steps = steps?;
    Some(Some(StaticSettings {
        speed: speed?,
        to: to?,
        steps,
        arc_length: arc_length?,
        // Requested steps are always allowed.
        most_steps: most_steps?.max(steps.unwrap_or(0)),
        sweep: sweep?,
    }))
}

/// Reads `[buckling]`; `Some(None)` without the card.
fn buckling(root: &Table<'_>) -> Option<Option<BucklingSettings>> {
    if !root.has("buckling") {
        return Some(None);
    }
    let table = root.table("buckling")?;
    let speed = table.get(&SPEED);
    let count = table.get(&COUNT);
    table.finish();
    Some(Some(BucklingSettings {
        speed: speed?,
        count: count?,
    }))
}

impl Analyses {
    /// The trim of an equilibrium, if one is requested.
    pub fn trimmed_equilibrium(&self) -> Option<&TrimSettings> {
        let trim = self.trim.as_ref();
        trim.filter(|trim| trim.method == TrimMethod::Equilibrium)
    }

    /// The cards of equilibria and modes, which are at time zero, with their lowest and highest rotor
    /// speed \[rad/s\].
    pub fn without_time(&self) -> Vec<(&'static str, [f64; 2])> {
        let of_modes =
            |modes: &ModesSettings| Some([*modes.speeds.first()?, *modes.speeds.last()?]);
        let one = |speed: f64| [speed; 2];
        let cards = [
            ("[modes]", self.modes.as_ref().and_then(of_modes)),
            ("[static]", self.statics.as_ref().map(|own| one(own.speed))),
            (
                "[buckling]",
                self.buckling.as_ref().map(|own| one(own.speed)),
            ),
            (
                "[trim]",
                self.trimmed_equilibrium().map(|own| one(own.speed)),
            ),
        ];
        let found = cards.into_iter();
        found
            .filter_map(|(card, speeds)| Some((card, speeds?)))
            .collect()
    }

    /// The first and the last time at which drives are evaluated \[s\]: equilibria and
    /// modes are at time zero.
    pub fn times(&self) -> Option<[f64; 2]> {
        let at_rest = !self.without_time().is_empty();
        let periodic = self.periodic.as_ref().map(|periodic| &periodic.start);
        let runs = self.transient.iter().chain(periodic);
        let runs = runs.map(|run| [run.from, run.to]);
        let run = runs.reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])]);
        match (at_rest, run) {
            (true, Some([from, to])) => Some([from.min(0.0), to.max(0.0)]),
            (true, None) => Some([0.0; 2]),
            (false, run) => run,
        }
    }

    /// The speed of a run that starts in rotation, other than zero [rad/s].
    pub fn rotating_speed(&self) -> Option<f64> {
        let periodic = self.periodic.as_ref().map(|periodic| &periodic.start);
        let mut runs = self.transient.iter().chain(periodic);
        runs.find_map(|run| run.rotating_speed().filter(|speed| *speed != 0.0))
    }

    /// The highest rotor speed of all analyses of steady states [rad/s].
    pub fn highest_speed(&self) -> f64 {
        let speeds = self.without_time().into_iter().flat_map(|card| card.1);
        speeds.map(f64::abs).fold(0.0, f64::max)
    }

    /// The highest rotor speed of all analyses, with the starts of runs that rotate [rad/s].
    pub fn highest_start(&self) -> f64 {
        let periodic = self.periodic.iter();
        let given = periodic.clone().filter_map(|periodic| periodic.speed);
        let runs = self
            .transient
            .iter()
            .chain(periodic.map(|periodic| &periodic.start));
        let starts = runs.filter_map(|run| run.rotating_speed());
        let speeds = given.chain(starts).map(f64::abs);
        speeds.fold(self.highest_speed(), f64::max)
    }

    /// Notes gravity across the axis of a rotating model: it has no steady equilibrium. Runs in time
    /// start from the mean of it.
    pub fn check(&self, root: &Table<'_>, gravity: &Vector3<f64>, frame_rotation: &FrameRotation) {
        let highest = self.highest_speed();
        let across = (gravity - frame_rotation.axis * frame_rotation.axis.dot(gravity)).norm();
        if highest > 0.0 && across > ALONG * gravity.norm() {
            let rpm = highest / RPM;
            root.note("gravity", &LoadProblem::GravityGoesRound { across, rpm });
        }
    }
}
