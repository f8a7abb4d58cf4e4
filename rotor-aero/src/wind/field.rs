//! The wind at a point and a time: a sum of parts, changed by towers.

use nalgebra::{Matrix3, Vector3};
use num_dual::DualSVec64;

use super::event::Event;
use super::frame::WindFrame;
use super::gust::TravelingGust;
use super::problem::WindProblem;
use super::table::Mean;
use super::tower::Tower;
use super::turbulence::TurbulenceBox;
use crate::Real;

/// Velocity of the air at points of an inertial frame.
pub trait WindField: std::fmt::Debug + Send + Sync {
    /// Velocity \[m/s\], and its gradient by position, `gradient[(i, j)] = d velocity_i/d at_j`
    /// \[1/s\], at a point \[m\] and a time \[s\].
    ///
    /// # Errors
    /// A point or time without wind; a file that can no longer be read.
    fn sample(
        &self,
        at: &Vector3<f64>,
        time: f64,
    ) -> Result<(Vector3<f64>, Matrix3<f64>), WindProblem>;

    /// Velocity alone; not a number where there is no wind.
    fn velocity(&self, at: &Vector3<f64>, time: f64) -> Vector3<f64> {
        self.velocity_and_gradient(at, time).0
    }

    /// Velocity and gradient; not a number where there is no wind ([`WindField::sample`] has the
    /// reason).
    fn velocity_and_gradient(&self, at: &Vector3<f64>, time: f64) -> (Vector3<f64>, Matrix3<f64>) {
        let nothing = (Vector3::repeat(f64::NAN), Matrix3::repeat(f64::NAN));
        self.sample(at, time).unwrap_or(nothing)
    }
}

/// The wind of its parts: mean with events, gusts and turbulence are added, then the towers
/// change the sum one after the other.
#[derive(Debug, Default)]
pub struct Wind {
    /// Axes of all parts.
    pub frame: WindFrame,
    /// Mean wind.
    pub mean: Mean,
    /// Transient events of the mean wind.
    pub events: Vec<Event>,
    /// Gusts that travel.
    pub gusts: Vec<TravelingGust>,
    /// Turbulence boxes. If the mean is part of a box (`.bts`, `.wnd`), the mean wind is zero.
    pub boxes: Vec<TurbulenceBox>,
    /// Towers.
    pub towers: Vec<Tower>,
}

impl Wind {
    /// Velocity at a point of the inertial frame \[m/s\]; with dual numbers, its derivatives.
    ///
    /// # Errors
    /// As [`WindField::sample`].
    pub fn evaluate<T: Real>(&self, at: &[T; 3], time: f64) -> Result<[T; 3], WindProblem> {
        let at = self.frame.point(at);
        let mut mean = self.mean.at(time);
        let mut extra = T::from(0.0);
        for event in &self.events {
            mean.direction += event.turn(time);
            extra += event.speed(&at, time);
        }
        let mut velocity = mean.velocity(&at, extra);
        for gust in &self.gusts {
            velocity = sum(velocity, gust.velocity(&at, time));
        }
        for turbulence in &self.boxes {
            velocity = sum(velocity, turbulence.velocity(&at, time)?);
        }
        for tower in &self.towers {
            velocity = tower.changed(&at, &velocity);
        }
        Ok(self.frame.vector(&velocity))
    }
}

fn sum<T: Real>(a: [T; 3], b: [T; 3]) -> [T; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

impl WindField for Wind {
    fn sample(
        &self,
        at: &Vector3<f64>,
        time: f64,
    ) -> Result<(Vector3<f64>, Matrix3<f64>), WindProblem> {
        let variable = |i: usize| DualSVec64::<3>::from_re(at[i]).derivative(i);
        let result = self.evaluate(&[variable(0), variable(1), variable(2)], time)?;
        let velocity = Vector3::from(result.map(|value| value.re));
        let rows = result.map(|value| value.eps.unwrap_generic(nalgebra::Const, nalgebra::U1));
        Ok((velocity, Matrix3::from_columns(&rows).transpose()))
    }

    fn velocity(&self, at: &Vector3<f64>, time: f64) -> Vector3<f64> {
        let result = self.evaluate(&[at.x, at.y, at.z], time);
        result.map_or(Vector3::repeat(f64::NAN), Vector3::from)
    }
}

#[cfg(test)]
#[path = "field_tests.rs"]
mod tests;
