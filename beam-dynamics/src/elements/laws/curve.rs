//! Tables of force over strain.
//!
//! Between the points straight or a natural cubic spline; outside of them constant, or extrapolated
//! with the slope of the end, or undefined:
//!
//! ```text
//! hold      f = f_n                               e > e_n, and so at the other end
//! extend    f = f_n + f'(e_n) (e - e_n)
//! ```

use std::sync::Arc;

use shared_geom::spline::Spline;

/// Interpolation of a curve between its points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Between {
    /// Straight.
    Linear,
    /// By a natural cubic spline.
    Spline,
}

/// Extrapolation of a curve beyond its points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Extrapolation {
    /// The force of the end.
    Hold,
    /// Straight on with the slope of the end.
    Extend,
    /// The force is undefined (NaN).
    Error,
}

/// A force over a strain.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    points: Arc<Points>,
    extrapolation: Extrapolation,
}

#[derive(Debug, PartialEq)]
struct Points {
    line: Spline,
    /// Integral from the first point to each.
    sums: Vec<f64>,
    /// The same to the strain zero.
    to_zero: f64,
}

impl Curve {
    /// The curve through at least two points of `strain`, strictly ascending, and `force`.
    pub fn new(
        strain: &[f64],
        force: &[f64],
        between: Between,
        extrapolation: Extrapolation,
    ) -> Self {
        let line = match between {
            Between::Linear => Spline::straight(strain, force),
            Between::Spline => Spline::new(strain, force),
        };
        let mut sums = vec![0.0];
        for (i, end) in strain.iter().skip(1).enumerate() {
            sums.push(sums[i] + line.integral(i, *end));
        }
        let points = |to_zero| {
            Arc::new(Points {
                line: line.clone(),
                sums: sums.clone(),
                to_zero,
            })
        };
        let unset = Self {
            points: points(0.0),
            extrapolation,
        };
        Self {
            points: points(unset.sum_to(0.0)),
            extrapolation,
        }
    }

    /// Force and slope at a strain.
    pub fn at(&self, e: f64) -> (f64, f64) {
        let line = &self.points.line;
        let (i, inside) = self.interval_at(e);
        let (force, slope) = (line.value(i, inside), line.slope(i, inside));
        match self.extrapolation {
            _ if inside == e => (force, slope),
            Extrapolation::Hold => (force, 0.0),
            Extrapolation::Error => (f64::NAN, f64::NAN),
            Extrapolation::Extend => (force + slope * (e - inside), slope),
        }
    }

    /// Integral of the force from the strain zero.
    pub fn integral(&self, e: f64) -> f64 {
        self.sum_to(e) - self.points.to_zero
    }

    /// Interval, and the nearest strain in it.
    fn interval_at(&self, e: f64) -> (usize, f64) {
        let line = &self.points.line;
        let positions = line.positions();
        let ends = (positions.first(), positions.last());
        let inside = match ends {
            (Some(first), Some(last)) => e.max(*first).min(*last),
            _ => e,
        };
        (line.interval(inside), inside)
    }

    /// Integral from the first point.
    fn sum_to(&self, e: f64) -> f64 {
        let (i, inside) = self.interval_at(e);
        let within = self.points.sums[i] + self.points.line.integral(i, inside);
        let beyond = e - inside;
        let slope = self.at(e).1;
        let bent = match self.extrapolation {
            _ if beyond == 0.0 => 0.0,
            Extrapolation::Hold => 0.0,
            Extrapolation::Error => f64::NAN,
            Extrapolation::Extend => 0.5 * slope * beyond * beyond,
        };
        within + self.points.line.value(i, inside) * beyond + bent
    }
}
