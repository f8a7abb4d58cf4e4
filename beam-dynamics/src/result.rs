//! Results of an analysis, as values: the input of the output stage.

use nalgebra::{Complex, Matrix3};

mod buckling;
mod columns;
mod statics;
mod transient;

pub use buckling::{BucklingMode, BucklingResult};
pub use columns::ColumnValues;
pub use statics::{StaticResult, StaticStep};
pub use transient::{Effort, Moment, Recorder, Snapshot};

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
    /// No kind holds enough of the kinetic energy.
    Coupled,
}

impl ModeKind {
    /// The four pure kinds, in the order of [`Shares`].
    pub const PURE: [Self; 4] = [Self::Flap, Self::Lag, Self::Torsion, Self::Axial];

    /// The word for the kind.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Flap => "flap",
            Self::Lag => "lag",
            Self::Torsion => "torsion",
            Self::Axial => "axial",
            Self::Coupled => "coupled",
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
    /// Number of blades.
    pub blades: usize,
    /// Share of the kinetic energy of the blades in this pattern; the hub is ignored [-].
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

impl Whirl {
    /// The pattern as a word, relative to the turning axes.
    pub fn word(&self) -> String {
        let waves = self.harmonic.unsigned_abs() as usize;
        let several = |word: &str| match waves {
            1 => word.to_owned(),
            _ => format!("{word} x{waves}"),
        };
        match self.harmonic {
            0 => "collective".to_owned(),
            _ if 2 * waves == self.blades => "differential".to_owned(),
            1.. => several("progressive"),
            _ => several("regressive"),
        }
    }

    /// Frequency in the fixed system of a mode of `frequency` in the turning axes at a
    /// rotor speed, both [Hz], `|f + h n|`, and its direction around the rotor; `None` for
    /// collective and differential modes, which have no direction.
    pub fn in_fixed_system(&self, frequency: f64, speed: f64) -> Option<(f64, Direction)> {
        let waves = self.harmonic.unsigned_abs() as usize;
        if waves == 0 || 2 * waves == self.blades {
            return None;
        }
        let seen = frequency + f64::from(self.harmonic) * speed;
        let forward = (seen >= 0.0) == (self.harmonic > 0);
        let direction = match forward {
            true => Direction::Forward,
            false => Direction::Backward,
        };
        Some((seen.abs(), direction))
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
    /// Pattern of motion of the blades; `None` without a rotor of equal blades.
    pub whirl: Option<Whirl>,
    /// Modal assurance criterion with the same mode at the previous speed; `None` where the
    /// mode begins [-].
    pub assurance: Option<f64>,
    /// Motion of the nodes, at the speeds at which it was requested.
    pub shape: Option<ModeShape>,
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
    /// Name: kind and number, for example `flap 2`; given at the first speed of the branch
    /// and kept while the mode is followed.
    pub name: String,
    /// Kind at the first speed of the branch.
    pub kind: ModeKind,
    /// Waves around the rotor at the first speed; `None` without a rotor of equal blades
    /// and if no pattern prevails.
    pub harmonic: Option<i32>,
    /// The mode at each speed; `None` where it was not computed.
    pub points: Vec<Option<ModePoint>>,
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
    /// Remarks for the user, for example on an unstable equilibrium.
    pub remarks: Vec<String>,
}

impl FrequencyTable {
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
