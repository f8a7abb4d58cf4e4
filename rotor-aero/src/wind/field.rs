//! The wind at a point and a time: a sum of parts, changed by towers.

use nalgebra::{Matrix3, Vector3};
use num_dual::DualSVec64;

use super::event::Event;
use super::frame::WindFrame;
use super::gust::TravelingGust;
use super::problem::WindProblem;
use super::profile::MeanWind;
use super::table::Mean;
use super::tower::Tower;
use super::turbulence::TurbulenceBox;
use crate::real::Real;

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
    /// The same velocity \[m/s\] everywhere and at all times; `up` is the vertical, of any length.
    ///
    /// # Errors
    /// A velocity or a vertical that is not finite, or no vertical.
    pub fn uniform(velocity: &Vector3<f64>, up: Vector3<f64>) -> Result<Self, WindProblem> {
        let frame = WindFrame::along(Vector3::zeros(), velocity, up)?;
        let [speed, _, vertical] = frame.components(velocity);
        let mean = MeanWind {
            speed,
            vertical,
            ..MeanWind::default()
        };
        Ok(Self {
            frame,
            mean: Mean::Steady(mean),
            ..Self::default()
        })
    }

    /// Its velocity if it is the same everywhere and at all times \[m/s\].
    pub fn constant(&self) -> Option<Vector3<f64>> {
        let changes = matches!(self.mean, Mean::Function(_)) || self.variation().is_some();
        (!changes).then(|| self.velocity(&Vector3::zeros(), 0.0))
    }

    /// The first part that varies in space, or in time other than by a function of the mean wind,
    /// as text.
    pub fn variation(&self) -> Option<&'static str> {
        match &self.mean {
            Mean::Table(_) => return Some("a table over time"),
            Mean::Steady(_) | Mean::Function(_) if !self.mean.at(0.0).is_uniform() => {
                return Some("shear or veer");
            }
            Mean::Steady(_) | Mean::Function(_) => {}
        }
        let parts = [
            (self.events.is_empty(), "an event"),
            (self.gusts.is_empty(), "a gust"),
            (self.boxes.is_empty(), "turbulence"),
            (self.towers.is_empty(), "a tower"),
        ];
        let found = parts.into_iter().find(|(is_empty, _)| !is_empty);
        found.map(|(_, part)| part)
    }

    /// The first time after `time` \[s\] at which an event or a gust begins, culminates or ends at
    /// a point \[m\] of the inertial frame, or the mean wind has a row of its table or a corner;
    /// infinite without one. Planes of turbulence boxes are not among these times.
    pub fn next_corner(&self, at: &Vector3<f64>, time: f64) -> f64 {
        let at = self.frame.point(&[at.x, at.y, at.z]);
        let events = self.events.iter().flat_map(Event::corners);
        let gusts = self.gusts.iter().flat_map(|gust| gust.corners(&at));
        let after = events.chain(gusts).filter(|corner| *corner > time);
        after.fold(self.mean.next_corner(time), f64::min)
    }

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
