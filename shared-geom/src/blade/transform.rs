//! The same blade with its properties about another point, or in other axes.

use nalgebra::{Matrix6, Vector2, Vector3};

use super::{Blade, BladeDamping};
use crate::line::about_x;
use crate::wrench;

impl Blade {
    /// The same blade with its properties about the reference point moved by `by` =
    /// (y, z), in section axes [m].
    ///
    /// Exact, and everywhere: `K' = U K U^T` with [`wrench::shift_matrix`] `U` is the
    /// same for all stations, hence between them. The line stays; the reference axis,
    /// [`Blade::reference_point`] off the line, is moved.
    pub fn shift(&self, by: Vector2<f64>) -> Self {
        let d = Vector3::new(0.0, by.x, by.y);
        let mut moved = self.transform(|matrix| wrench::shift(matrix, &d));
        moved.reference_point += by;
        moved
    }

    /// The same blade with its properties about its line.
    pub fn on_line(&self) -> Self {
        let mut moved = self.shift(-self.reference_point);
        moved.reference_point = Vector2::zeros();
        moved
    }

    /// The same blade in section axes turned by `angle` about the line, nose up [rad]:
    /// its twist is larger by `angle`, and the properties are in the new axes.
    ///
    /// Exact, and everywhere, as [`Blade::shift`].
    pub fn rotate(&self, angle: f64) -> Self {
        let q = about_x(angle);
        let mut turned = self.transform(|matrix| wrench::rotate(matrix, &q));
        turned.line = self.line.twisted(angle);
        let plane = q.fixed_view::<2, 2>(1, 1).transpose();
        turned.reference_point = plane * self.reference_point;
        turned
    }

    /// Applies a congruence to all matrices.
    fn transform(&self, congruence: impl Fn(&Matrix6<f64>) -> Matrix6<f64>) -> Self {
        let mut result = self.clone();
        for station in &mut result.stations {
            station.stiffness = congruence(&station.stiffness);
            station.mass = congruence(&station.mass);
        }
        // Times for each component belong to point and axes: the resulting damping is
        // moved.
        result.damping = match &self.damping {
            Some(BladeDamping::Times(_) | BladeDamping::Viscous(_)) => {
                let damping = self.damping.as_ref();
                let stations = 0..self.stations.len();
                let of = |damping| {
                    let moved = |k| congruence(&self.station_damping(damping, k));
                    BladeDamping::Viscous(stations.map(moved).collect())
                };
                damping.map(of)
            }
            other => other.clone(),
        };
        result
    }
}
