//! Results of an analysis, as values: the input of the output stage.

use nalgebra::{Complex, Matrix3};

use crate::case::{ModeStyle, Words};

mod air_columns;
mod buckling;
mod columns;
mod critical;
mod fixed;
mod identification;
mod linear;
mod performance;
mod periodic;
mod stability;
mod static_sweep;
mod statics;
mod transient;
mod trim;

pub use buckling::{BucklingMode, BucklingResult};
pub use columns::ColumnValues;
pub use critical::CriticalSpeed;
pub use fixed::{FixedLine, FixedPoint, FixedTable};
pub use identification::{Identification, IdentificationMethod, IdentifiedMode};
pub use linear::{LinearModel, LinearVariable};
pub use performance::{PerformancePoint, PerformanceResult, PerformanceTable, PointStatus};
pub use periodic::{
    FloquetMode, FloquetTable, Harmonics, PeriodicPass, PeriodicResult, SeenFrequency, Stability,
    Stall,
};
pub use stability::{
    BoundaryKind, StabilityBoundary, StabilityPoint, StabilityResult, StabilityRoot, StableSide,
};
pub use static_sweep::{StaticSweep, StaticSweepPoint, TipMotion};
pub use statics::{StaticResult, StaticStep};
pub use transient::{AcceptedStep, Effort, Recorder, Snapshot};
pub use trim::{TrimPoint, TrimResult};

/// Least share of the kinetic energy for which a mode is named by one kind.
const PURE_SHARE: f64 = 0.6;
/// Least share of the kinetic energy that is most of it.
const MOST: f64 = 0.5;

/// The dominant motion of a mode.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum ModeKind {
    /// Bending out of the plane of rotation.
    Flap,
    /// Bending in the plane of rotation.
    Lag,
    /// Twist about the beam.
    Torsion,
    /// Extension.
    Axial,
    /// Across the axis of rotation, of nodes that belong to no blade: shafts and hubs.
    Lateral,
    /// Bending of the tower along the wind, with nacelle and hub.
    ForeAft,
    /// Bending of the tower across the wind, with nacelle and hub.
    SideSide,
    /// No kind holds enough of the kinetic energy.
    Coupled,
    /// Without strain, of parts that nothing holds: frequency zero.
    Rigid,
}

impl ModeKind {
    /// The four pure kinds, in the order of [`Shares`].
    pub const PURE: [Self; 4] = [Self::Flap, Self::Lag, Self::Torsion, Self::Axial];

    /// The kind that holds most of the energy, or coupled if none holds enough.
    pub fn of(shares: &Shares) -> Self {
        let pure = Self::PURE.into_iter().zip(shares);
        match pure.max_by(|a, b| a.1.total_cmp(b.1)) {
            Some((kind, &share)) if share >= PURE_SHARE => kind,
            _ => Self::Coupled,
        }
    }

    /// The kind that holds most of the energy.
    pub fn main(shares: &Shares) -> Self {
        let pure = Self::PURE.into_iter().zip(shares);
        let most = pure.max_by(|a, b| a.1.total_cmp(b.1));
        most.map_or(Self::Coupled, |(kind, _)| kind)
    }

    /// The kind of the tower, if motion fore-aft and from side to side of the parts outside the blades
    /// holds most of the energy.
    pub fn of_tower([fore_aft, side]: [f64; 2]) -> Option<Self> {
        Self::of_tower_from([fore_aft, side], PURE_SHARE)
    }

    /// The same if this motion holds half of the energy or more.
    pub fn main_of_tower(shares: [f64; 2]) -> Option<Self> {
        Self::of_tower_from(shares, MOST)
    }

    /// The kind of the tower, if motion fore-aft and from side to side has the share `least`.
    fn of_tower_from([fore_aft, side]: [f64; 2], least: f64) -> Option<Self> {
        (fore_aft + side >= least).then_some(match fore_aft > side {
            true => Self::ForeAft,
            false => Self::SideSide,
        })
    }

    /// The word for the kind among these words.
    pub fn word_in(self, words: Words) -> &'static str {
        match (self, words) {
            (Self::Lag, Words::Wind) => "edge",
            _ => self.word(),
        }
    }

    /// The word for the kind, for rotors.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Flap => "flap",
            Self::Lag => "lag",
            Self::Torsion => "torsion",
            Self::Axial => "axial",
            Self::Lateral => "lateral",
            Self::ForeAft => "tower fore-aft",
            Self::SideSide => "tower side-side",
            Self::Coupled => "coupled",
            Self::Rigid => "rigid",
        }
    }
}

/// Shares of the kinetic energy of a mode: flap, lag, torsion, axial; their sum is
/// one [-].
pub type Shares = [f64; 4];

/// Pattern of motion of the blades of a rotor in a mode.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Whirl {
    /// Waves around the rotor, positive in the direction of rotation.
    pub harmonic: i32,
    /// Number of blades; zero for the whirl of a shaft.
    pub blades: usize,
    /// Share of the kinetic energy of the blades in this pattern, the hub being ignored; of a
    /// shaft, of its nodes [-].
    pub share: f64,
}

/// Direction of a motion around the rotor as seen from the fixed system.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Direction {
    /// With the rotation.
    Forward,
    /// Against the rotation.
    Backward,
}

impl Direction {
    /// The direction as a word.
    pub fn word(self) -> &'static str {
        match self {
            Self::Forward => "forward",
            Self::Backward => "backward",
        }
    }
}

impl Whirl {
    /// The pattern among these words.
    pub fn word_in(&self, words: Words) -> String {
        let word = self.word();
        match words {
            Words::Rotor => word,
            Words::Wind => word
                .replace("progressive", "forward")
                .replace("regressive", "backward"),
        }
    }

    /// The pattern as a word, relative to the turning axes.
    pub fn word(&self) -> String {
        let waves = self.harmonic.unsigned_abs() as usize;
        let several = |word: &str| match waves {
            1 => word.to_owned(),
            _ => format!("{word} x{waves}"),
        };
        match self.harmonic {
            0 if self.blades == 0 => "no whirl".to_owned(),
            0 => "collective".to_owned(),
            _ if 2 * waves == self.blades => "differential".to_owned(),
            1.. => several("progressive"),
            _ => several("regressive"),
        }
    }

    /// Frequency in the fixed system of a mode of `frequency` in the turning axes at a
    /// rotor speed, both [Hz], `|f + h n|`, and its direction around the rotor; collective and
    /// differential modes keep their frequency and have no direction, see [`Self::is_double`] of two blades.
    pub fn in_fixed_system(&self, frequency: f64, speed: f64) -> (f64, Option<Direction>) {
        let seen = self.signed_in_fixed_system(frequency, speed);
        if !self.has_direction() {
            return (seen, None);
        }
        let direction = if seen >= 0.0 {
            Direction::Forward
        } else {
            Direction::Backward
        };
        (seen.abs(), Some(direction))
    }

    /// Frequency in the fixed system [Hz], positive if the motion runs forward around the rotor and
    /// negative if it runs backward: `sign(h) (f + h n)`.
    pub fn signed_in_fixed_system(&self, frequency: f64, speed: f64) -> f64 {
        if self.has_direction() {
            let harmonic = f64::from(self.harmonic);
            harmonic.signum() * (frequency + harmonic * speed)
        } else {
            frequency
        }
    }

    /// The pattern that names a mode of `frequency` in the turning axes at a rotor speed, both [Hz]: a
    /// shaft's as it runs in the fixed system, since beyond its critical speed its forward whirl runs
    /// backward in the turning axes; a rotor's as it is.
    pub fn named(&self, frequency: f64, speed: f64) -> Self {
        let waves = self.harmonic.abs();
        let harmonic = match self.blades {
            0 if self.signed_in_fixed_system(frequency, speed) < 0.0 => -waves,
            0 => waves,
            _ => self.harmonic,
        };
        Self { harmonic, ..*self }
    }

    /// Whether most of the energy is in this pattern, so that it names the mode.
    pub fn is_pure(&self) -> bool {
        self.share >= PURE_SHARE
    }

    /// Whether it is the one of two blades that move against each other, as in teetering: a wave that runs
    /// forward and one that runs backward, with two frequencies in the fixed system, `f + n` and `|f - n|`.
    pub fn is_double(&self) -> bool {
        self.blades == 2 && self.harmonic == 1
    }

    /// Whether the pattern runs around the rotor.
    pub fn has_direction(&self) -> bool {
        let waves = self.harmonic.unsigned_abs() as usize;
        waves > 0 && 2 * waves != self.blades
    }
}

/// One mode at one speed.
#[derive(Debug, Clone, PartialEq)]
pub struct ModePoint {
    /// Frequency `Im(s) / 2 pi` [Hz].
    pub frequency: f64,
    /// Damping ratio `-Re(s) / |s|` [-].
    pub damping_ratio: f64,
    /// Real part of s: positive if the motion grows [1/s].
    pub growth: f64,
    /// Shares of the motions at this speed [-].
    pub shares: Shares,
    /// Share of the motion across the axis of rotation of nodes that belong to no blade and are on
    /// the axis; part of flap and lag in `shares` [-].
    pub lateral: f64,
    /// Shares of the motion fore-aft and from side to side of nodes that belong to no blade, in a model
    /// with a tower [-].
    pub tower: [f64; 2],
    /// Pattern of motion of the blades; `None` without a rotor of equal blades.
    pub whirl: Option<Whirl>,
    /// Modal assurance criterion with the same mode at the previous speed; `None` where the
    /// mode begins [-].
    pub assurance: Option<f64>,
    /// Motion of the nodes, at the speeds at which it was requested.
    pub shape: Option<ModeShape>,
}

impl ModePoint {
    /// Kind at this speed.
    pub fn kind(&self) -> ModeKind {
        match ModeKind::of_tower(self.tower) {
            Some(kind) => kind,
            None if self.lateral >= PURE_SHARE => ModeKind::Lateral,
            None => ModeKind::of(&self.shares),
        }
    }

    /// The kind with most of the energy at this speed: where two modes exchange their shapes, one of them has
    /// it at every speed.
    pub fn main_kind(&self) -> ModeKind {
        match ModeKind::main_of_tower(self.tower) {
            Some(kind) => kind,
            None if self.lateral >= MOST => ModeKind::Lateral,
            None => ModeKind::main(&self.shares),
        }
    }
}

/// Motion of the nodes in a mode, of unit kinetic energy and with its largest entry
/// real: at the phase p each node is displaced by `Re(displacement e^(i p))` and turned
/// by the small rotation `Re(rotation e^(i p))` from its equilibrium, in the axes of
/// the model.
#[derive(Debug, Clone, PartialEq)]
pub struct ModeShape {
    /// Displacement of each node [m].
    pub displacements: Vec<[Complex<f64>; 3]>,
    /// Rotation of each node [rad].
    pub rotations: Vec<[Complex<f64>; 3]>,
}

/// One mode, followed over the speeds.
#[derive(Debug, Clone, PartialEq)]
pub struct ModeBranch {
    /// Name: kind and number, for example `flap 2`; given at the speed of names, or else at the
    /// first speed of the branch, and kept while the mode is followed.
    pub name: String,
    /// Kind at the speed of the name.
    pub kind: ModeKind,
    /// Waves around the rotor at the speed of the name; `None` without a rotor of equal blades
    /// and if no pattern prevails.
    pub harmonic: Option<i32>,
    /// The mode at each speed; `None` where it was not computed.
    pub points: Vec<Option<ModePoint>>,
}

impl ModeBranch {
    /// Kind at the speed of `point`: another kind than in the name only if it is distinct.
    pub fn kind_at(&self, point: &ModePoint) -> ModeKind {
        match (self.kind, point.kind()) {
            (ModeKind::Coupled | ModeKind::Rigid, _) | (_, ModeKind::Coupled) => self.kind,
            (_, kind) => kind,
        }
    }

    /// Name at the speed of `point`, for example `flap 2 (now torsion)` where the mode has changed
    /// its kind.
    pub fn name_at(&self, point: &ModePoint, words: Words) -> String {
        let kind = self.kind_at(point);
        if kind == self.kind {
            self.name.clone()
        } else {
            format!("{} (now {})", self.name, kind.word_in(words))
        }
    }

    /// Name without the pattern of the blades: `flap 1` of `flap 1 collective`.
    pub fn stem(&self) -> &str {
        let mut spaces = self.name.match_indices(' ');
        spaces
            .nth(1)
            .map_or(&self.name, |(position, _)| &self.name[..position])
    }
}

/// Effort and result of the steady equilibrium at one speed.
#[derive(Debug, Clone, PartialEq)]
pub struct EquilibriumReport {
    /// Newton iterations, including intermediate speeds.
    pub iterations: usize,
    /// Largest residual relative to the largest term of its kind [-].
    pub residual: f64,
    /// Position of each node [m].
    pub positions: Vec<[f64; 3]>,
    /// Orientation of each node: columns are its axes in the model's frame [-].
    pub rotations: Vec<Matrix3<f64>>,
}

/// A motion that decays without oscillation: a real eigenvalue.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DecayingMotion {
    /// The eigenvalue, below zero [1/s].
    pub growth: f64,
    /// Kind of the motion.
    pub kind: ModeKind,
}

impl DecayingMotion {
    /// The time in which it falls to 1/e of its size [s].
    pub fn time_constant(&self) -> f64 {
        -1.0 / self.growth
    }
}

/// Frequencies over rotor speed.
#[derive(Debug, Clone, PartialEq)]
pub struct FrequencyTable {
    /// Name of the model.
    pub name: String,
    /// Rotor speeds, ascending [rad/s].
    pub speeds: Vec<f64>,
    /// Modes, by the frequency at their first speed.
    pub branches: Vec<ModeBranch>,
    /// Equilibrium at each speed.
    pub equilibria: Vec<EquilibriumReport>,
    /// Motions that decay without oscillation at each speed, the slowest first, none faster than the modes.
    pub decaying: Vec<Vec<DecayingMotion>>,
    /// Remarks for the user, for example on an unstable equilibrium.
    pub remarks: Vec<String>,
    /// Words, units and multiples of tables and figures.
    pub style: ModeStyle,
    /// Whether the model has one blade, whose critical speeds belong to the turning axes.
    pub is_single_blade: bool,
    /// Files of the sections of the blades, each with its fingerprint.
    pub blade_files: Vec<String>,
}

impl FrequencyTable {
    /// Multiples of the rotor speed of figures and critical speeds: the chosen ones, or else 1, b,
    /// 2b and 3b for b blades, 1, 2 and 3 for a single blade, and 1 and 2 for a shaft.
    pub fn harmonics(&self) -> Vec<u32> {
        if !self.style.harmonics.is_empty() {
            return self.style.harmonics.clone();
        }
        match u32::try_from(self.blades()) {
            Ok(blades) if blades > 1 => vec![1, blades, 2 * blades, 3 * blades],
            _ if self.is_single_blade => vec![1, 2, 3],
            _ => vec![1, 2],
        }
    }

    /// Whether the patterns of all modes are whirls of a shaft.
    pub fn is_shaft(&self) -> bool {
        let mut points = self.branches.iter().flat_map(|b| b.points.iter().flatten());
        points.all(|point| point.whirl.is_some_and(|whirl| whirl.blades == 0))
    }

    /// Number of blades of the rotor; zero without a rotor of equal blades.
    pub fn blades(&self) -> usize {
        let points = self.branches.iter().flat_map(|b| b.points.iter().flatten());
        let whirls = points.filter_map(|point| point.whirl);
        whirls.map(|whirl| whirl.blades).max().unwrap_or(0)
    }

    /// Branches at index `speed` of the speeds with their points, ascending in frequency.
    pub fn at_speed(&self, speed: usize) -> Vec<(&ModeBranch, &ModePoint)> {
        let mut found: Vec<_> = self
            .branches
            .iter()
            .filter_map(|branch| Some((branch, branch.points.get(speed)?.as_ref()?)))
            .collect();
        found.sort_by(|a, b| a.1.frequency.total_cmp(&b.1.frequency));
        found
    }
}

/// A measured frequency.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeasuredPoint {
    /// Rotor speed [rad/s].
    pub speed: f64,
    /// Frequency [Hz].
    pub frequency: f64,
    /// Number of the mode in ascending order, from one, ignoring the kinds of
    /// [`Measured::leave_out`]; `None` for a point without a mode.
    pub order: Option<usize>,
}

/// Measurements to compare with the computed frequencies.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Measured {
    /// The points.
    pub points: Vec<MeasuredPoint>,
    /// Kinds of modes that were not measured and are ignored in the order.
    pub leave_out: Vec<ModeKind>,
}

/// A measured frequency with the computed one.
#[derive(Debug, Clone, PartialEq)]
pub struct Comparison {
    /// The measurement.
    pub measured: MeasuredPoint,
    /// Name of the computed mode.
    pub name: String,
    /// Computed frequency [Hz].
    pub computed: f64,
}

impl Measured {
    /// Compares each point that has an order and a computed speed (to 1e-6 of the largest)
    /// with the mode of that order in `table`.
    pub fn compare(&self, table: &FrequencyTable) -> Vec<Comparison> {
        let largest = table.speeds.iter().fold(1.0, |a: f64, b| a.max(*b));
        let beside = |point: &MeasuredPoint| {
            let near = |speed: &f64| (speed - point.speed).abs() <= 1e-6 * largest;
            let speed = table.speeds.iter().position(near)?;
            let modes = table.at_speed(speed);
            let counted = modes
                .into_iter()
                .filter(|(branch, _)| !self.leave_out.contains(&branch.kind));
            let (branch, mode) = counted.into_iter().nth(point.order?.checked_sub(1)?)?;
            Some(Comparison {
                measured: *point,
                name: branch.name.clone(),
                computed: mode.frequency,
            })
        };
        self.points.iter().filter_map(beside).collect()
    }
}
