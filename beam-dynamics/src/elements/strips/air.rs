//! The air of a model: its properties and its motion.

use std::fmt;
use std::sync::Arc;

use nalgebra::{Matrix3, Vector3};
use rotor_aero::wind::{Atmosphere, Wind, WindField};
use shared_geom::error::Explain;
use shared_geom::hash::sha256_of;

/// Remedy of Mach numbers beyond the tables of airfoils.
pub const LARGER_TABLES: &str = "add tables of larger Mach numbers to its file, or outside_mach = \"hold\" \
                                 to [air], which uses the last table beyond its Mach number";

/// The air in which a model moves.
#[derive(Clone)]
pub struct Air {
    /// The still air.
    pub atmosphere: Atmosphere,
    /// Its motion, in the axes of the model at rest.
    wind: Arc<Wind>,
    /// Velocity of a wind that is the same everywhere and at all times [m/s].
    constant: Option<Vector3<f64>>,
    /// Fingerprint of the wind.
    fingerprint: String,
    /// Whether strips have no values at Mach numbers beyond the tables of their airfoils.
    refuses_mach: bool,
}

/// Standard air at sea level, at rest.
impl Default for Air {
    fn default() -> Self {
        Self::new(Atmosphere::default(), Wind::default())
    }
}

/// The wind by its fingerprint: every strip has this text.
impl fmt::Debug for Air {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Air")
            .field("atmosphere", &self.atmosphere)
            .field("wind", &self.fingerprint)
            .field("refuses_mach", &self.refuses_mach)
            .finish()
    }
}

impl Air {
    /// Air with a wind.
    pub fn new(atmosphere: Atmosphere, wind: Wind) -> Self {
        Self {
            atmosphere,
            constant: wind.constant(),
            fingerprint: sha256_of(&[format!("{wind:?}").as_bytes()]),
            wind: Arc::new(wind),
            refuses_mach: false,
        }
    }

    /// The same, in which strips have no values at Mach numbers beyond the tables of their airfoils,
    /// rather than the ones of the last curves.
    #[must_use]
    pub fn refusing_mach(self) -> Self {
        Self {
            refuses_mach: true,
            ..self
        }
    }

    /// Whether strips have no values at Mach numbers beyond the tables of their airfoils.
    pub fn refuses_mach(&self) -> bool {
        self.refuses_mach
    }

    /// Its wind.
    pub fn wind(&self) -> &Arc<Wind> {
        &self.wind
    }

    /// Velocity of the wind if it is the same everywhere and at all times \[m/s\].
    pub fn constant(&self) -> Option<Vector3<f64>> {
        self.constant
    }

    /// Velocity of the air at a point and a time [m/s], and its derivatives by the point [1/s]; not
    /// numbers where there is no wind.
    pub(super) fn motion(&self, point: &Vector3<f64>, time: f64) -> (Vector3<f64>, Matrix3<f64>) {
        match self.constant {
            Some(velocity) => (velocity, Matrix3::zeros()),
            None => self.wind.velocity_and_gradient(point, time),
        }
    }

    /// Reason why there is no wind at a point and a time, with the remedy.
    pub(super) fn undefined(&self, point: &Vector3<f64>, time: f64) -> Option<String> {
        let problem = self.wind.sample(point, time).err()?;
        Some(match problem.help() {
            Some(help) => format!("{problem}; {help}"),
            None => problem.to_string(),
        })
    }
}
