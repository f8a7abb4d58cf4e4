//! A checked problem for the engine: the model and the requested analyses.

use std::collections::{BTreeMap, BTreeSet};

use nalgebra::{Matrix3, Vector3};
use shared_geom::hash::sha256_of;

use crate::assembly::System;
use crate::model::{Conditions, Drive, Loading, NamingAxes, TurningFrame};

mod columns;
mod linear;
mod mode_style;
mod performance;
mod periodic;
mod stability;
mod sweep;
mod transient;
mod trim;

pub use columns::{Column, ElectrodeQuantity, Every, OutputSettings, Quantity};
pub use linear::{LinearAbout, LinearPort, LinearSettings};
pub use mode_style::{FrequencyUnit, ModeStyle, Words};
pub use performance::{
    Abscissa, MachineKind, OperatingSetting, PerformanceCase, PerformancePart, PerformanceRequest,
    PowerCurve, RatedPower, RotorSpeedLaw, linear_between,
};
pub use periodic::{FloquetSettings, PeriodicMethod, PeriodicSettings};
pub use stability::{StabilityMethod, StabilitySettings};
pub use sweep::Sweep;
pub use transient::{
    InitialMotion, Redundant, Start, StartAccelerations, StartShape, TransientSettings,
};
pub use trim::{AutoPilot, TrimControl, TrimMethod, TrimSettings, TrimTarget};

/// Rotation of the model's frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrameRotation {
    /// Axis of rotation, of unit length [-].
    pub axis: Vector3<f64>,
    /// A point of the axis [m].
    pub center: Vector3<f64>,
}

impl Default for FrameRotation {
    /// About z through the origin.
    fn default() -> Self {
        Self {
            axis: Vector3::z(),
            center: Vector3::zeros(),
        }
    }
}

/// A blade of a model, for all that concerns blades: naming, multiblade coordinates, output
/// along the span.
#[derive(Debug, Clone, PartialEq)]
pub struct BladeNodes {
    /// Name of the blade.
    pub name: String,
    /// Azimuth on the rotor, positive about the axis [rad].
    pub azimuth: f64,
    /// Nodes from the root to the tip.
    pub nodes: Vec<usize>,
    /// Axes (columns) of the undeformed blade in the model's frame, precone and pitch included: along
    /// the span, toward the leading edge, up [-].
    pub axes: Matrix3<f64>,
    /// The file of its sections and the fingerprint of the file, if it has one.
    pub file: Option<String>,
}

/// Arms of a model without blades: parts that only nodes on the axis of rotation connect.
#[derive(Debug, Clone, PartialEq, Default)]
pub enum Arms {
    /// There are not several.
    #[default]
    None,
    /// Equal ones at equal distances around the axis, by azimuth from the first.
    Equal(Vec<BladeNodes>),
    /// Several that are not equal, and why not.
    Unequal(String),
}

/// A checked model.
#[derive(Debug, Clone)]
pub struct Model {
    /// Name, for tables and plots.
    pub name: String,
    /// The equations.
    pub system: System,
    /// Axes for naming, one a node.
    pub naming: Vec<NamingAxes>,
    /// The rotation of the frame.
    pub frame_rotation: FrameRotation,
    /// Acceleration of gravity, in the model's frame [m/s^2].
    pub gravity: Vector3<f64>,
    /// Factor of gravity [-].
    pub gravity_drive: Drive,
    /// Nodes of each beam, for drawing.
    pub beams: Vec<[usize; 3]>,
    /// Blades, in the order of the input.
    pub blades: Vec<BladeNodes>,
    /// Arms, if there are no blades.
    pub arms: Arms,
    /// How the nodes move at the start of a run in time, one a node.
    pub initial: Vec<InitialMotion>,
    /// Whether remarks on the operation of rotors are for helicopters or for wind turbines.
    pub words: Words,
}

impl Model {
    /// A model without blades and gravity, turning about z, whose modes are named by
    /// the model's axes.
    pub fn new(name: impl Into<String>, system: System) -> Self {
        Self {
            name: name.into(),
            naming: vec![NamingAxes::default(); system.nodes().len()],
            initial: vec![InitialMotion::default(); system.nodes().len()],
            system,
            frame_rotation: FrameRotation::default(),
            gravity: Vector3::zeros(),
            gravity_drive: Drive::Constant(1.0),
            beams: Vec::new(),
            blades: Vec::new(),
            arms: Arms::None,
            words: Words::default(),
        }
    }

    /// Blades around the axis: the blades or, if there are none and the model turns, equal arms. At rest
    /// two equal arms may be a wing.
    pub fn around_the_axis(&self, turns: bool) -> &[BladeNodes] {
        match &self.arms {
            Arms::Equal(arms) if turns && self.blades.is_empty() => arms,
            _ => &self.blades,
        }
    }

    /// Numbers of blades of the rotors with several, each number once: blades of one rotor have the same
    /// name before their number.
    pub fn blades_of_rotors(&self) -> Vec<usize> {
        let stem = |blade: &BladeNodes| {
            let name = blade
                .name
                .trim_end_matches(|letter: char| letter.is_ascii_digit());
            name.to_owned()
        };
        let mut rotors: BTreeMap<String, usize> = BTreeMap::new();
        for blade in &self.blades {
            *rotors.entry(stem(blade)).or_default() += 1;
        }
        let counts: BTreeSet<usize> = match rotors.len() {
            // Blades with names of their own are of one rotor.
            count if count == self.blades.len() => [count].into(),
            _ => rotors.into_values().collect(),
        };
        counts.into_iter().filter(|count| *count > 1).collect()
    }

    /// A fingerprint of everything that determines the motion of the model: nodes, elements
    /// with their laws and drives, gravity and the axis of rotation. Names of the model,
    /// drawing and the initial motion are ignored.
    pub fn fingerprint(&self) -> String {
        let of = |part: &dyn std::fmt::Debug| sha256_of(&[format!("{part:?}").as_bytes()]);
        let mut parts = vec![
            of(&self.system.nodes()),
            of(&(&self.frame_rotation, &self.gravity, &self.gravity_drive)),
        ];
        parts.extend(self.system.elements().map(|element| of(&element)));
        let parts: Vec<_> = parts.iter().map(String::as_bytes).collect();
        sha256_of(&parts)
    }

    /// All that acts at a rotor speed [rad/s] with the constant and the proportional
    /// loads at the given factors; gravity is a constant load.
    pub fn conditions(&self, speed: f64, constant: f64, proportional: f64) -> Conditions {
        Conditions {
            frame: TurningFrame {
                angular_velocity: speed * self.frame_rotation.axis,
                center: self.frame_rotation.center,
            },
            loading: Loading {
                gravity: constant * self.gravity_at(0.0),
                constant,
                proportional,
                released: 0.0,
                resting: 0.0,
                time: 0.0,
                turns: 1.0,
                voltages: 1.0,
                air: 1.0,
            },
        }
    }
}

/// Damping ratios of modes that are given instead of computed from the model.
#[derive(Debug, Clone, PartialEq, Default)]
pub enum ModalDamping {
    /// No ratios are given.
    #[default]
    Found,
    /// The same ratio for all modes [-].
    All(f64),
    /// Ratios of the lowest modes, in the order of their frequencies at the first
    /// speed [-].
    ByOrder(Vec<f64>),
    /// Ratios by the name of the mode [-].
    ByName(Vec<(String, f64)>),
}

impl ModalDamping {
    /// The ratio given for the mode called `name`, whose index among the modes at the first
    /// speed is `order` (from zero) [-].
    pub fn ratio(&self, order: usize, name: &str) -> Option<f64> {
        match self {
            Self::Found => None,
            Self::All(ratio) => Some(*ratio),
            Self::ByOrder(ratios) => ratios.get(order).copied(),
            Self::ByName(ratios) => {
                let own = ratios.iter().find(|named| named.0 == name);
                own.map(|named| named.1)
            }
        }
    }
}

/// The requested modes.
#[derive(Debug, Clone, PartialEq)]
pub struct ModesSettings {
    /// Rotor speeds, ascending, without doubles [rad/s].
    pub speeds: Vec<f64>,
    /// Number of modes to report at each speed.
    pub count: usize,
    /// Damping ratios that are given.
    pub damping: ModalDamping,
    /// Speeds, among `speeds`, at which the shapes of the modes are returned [rad/s].
    pub shapes: Vec<f64>,
    /// Whether these shapes are animated as field files.
    pub animate: bool,
    /// Words, units and multiples of tables and figures.
    pub style: ModeStyle,
    /// Whether parts of the model may move as rigid bodies, at rest; their motions are modes of
    /// frequency zero.
    pub free: bool,
}

impl ModesSettings {
    /// The lowest `count` modes at each of `speeds` \[rad/s\], without shapes.
    pub fn new(speeds: Vec<f64>, count: usize) -> Self {
        Self {
            speeds,
            count,
            shapes: Vec::new(),
            animate: false,
            damping: ModalDamping::Found,
            style: ModeStyle::default(),
            free: false,
        }
    }

    /// The first and the last speed, at which shapes are shown unless speeds are chosen
    /// \[rad/s\].
    pub fn ends(&self) -> Vec<f64> {
        let last = self.speeds.last().filter(|_| self.speeds.len() > 1);
        self.speeds
            .first()
            .into_iter()
            .chain(last)
            .copied()
            .collect()
    }
}

/// The requested equilibria under loads.
#[derive(Debug, Clone, PartialEq)]
pub struct StaticSettings {
    /// Rotor speed [rad/s].
    pub speed: f64,
    /// Factor of the proportional loads at the end [-].
    pub to: f64,
    /// Number of equal load steps, each shortened where the iteration requires it; `None`:
    /// as large as the iteration allows.
    pub steps: Option<usize>,
    /// Whether the path is followed by arc length, past limit points.
    pub arc_length: bool,
    /// Largest number of steps along the path.
    pub most_steps: usize,
    /// Values of a parameter at which the equilibria are found in turn, if they are requested.
    pub sweep: Option<Sweep>,
}

/// The requested critical loads.
#[derive(Debug, Clone, PartialEq)]
pub struct BucklingSettings {
    /// Rotor speed [rad/s].
    pub speed: f64,
    /// Number of critical loads to report.
    pub count: usize,
}
