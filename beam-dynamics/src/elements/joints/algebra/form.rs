//! The forms of two ends, of which constraints consist.
//!
//! With d from the point of a to the point of b, e a unit vector that turns with end k (or is fixed
//! in the frame: then without the terms of `theta_k`), and l a length:
//!
//! ```text
//!            Phi                g on x_b   on theta_b   on x_a   on theta_a     on theta_k
//! along      e . d              e          f_b x e      -e       -f_a x e       + e x d
//! across     e_a . e_b          0          -e_a x e_b   0        e_a x e_b
//! distance   (d.d/l - l)/2      n          f_b x n      -n       -f_a x n       with n = d/l
//! spin       velocities only    0          e            0        -e
//! ```
//!
//! with the variations
//!
//! ```text
//! d e = -[e]x theta_k     d f = -[f]x theta     d d = x_b - [f_b]x theta_b - x_a + [f_a]x theta_a
//! d(f x e) = [e]x [f]x theta_f - [f]x [e]x theta_k
//! d(e x d) = [d]x [e]x theta_k + [e]x d d
//! ```

use nalgebra::{Matrix3, Vector3};
use shared_geom::rotation::skew;

use super::{Ends, Part, Parts};

/// Carrier of a direction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::elements::joints) enum Carrier {
    /// Fixed in the frame of the model.
    Frame,
    /// End a.
    A,
    /// End b.
    B,
}

impl Carrier {
    /// The rotation that turns the direction.
    fn part(self) -> Option<Part> {
        match self {
            Self::Frame => None,
            Self::A => Some(Part::TurnA),
            Self::B => Some(Part::TurnB),
        }
    }
}

/// A form at a state: its vectors in the model's axes.
#[derive(Debug, Clone, Copy)]
pub(in crate::elements::joints) enum Form {
    /// The distance of the points along a direction; the constraint prescribes it, or its rate.
    Along {
        /// The direction e [-].
        axis: Vector3<f64>,
        /// Carrier of the direction.
        carrier: Carrier,
    },
    /// The cosine between two directions.
    Across {
        /// The direction on a [-].
        a: Vector3<f64>,
        /// The direction on b [-].
        b: Vector3<f64>,
    },
    /// The difference between the distance of the points and a length.
    Distance {
        /// The length l [m].
        length: f64,
    },
    /// The angular velocity about a direction.
    AngularVelocity {
        /// The direction e [-].
        axis: Vector3<f64>,
        /// Carrier of the direction.
        carrier: Carrier,
    },
}

impl Form {
    /// The form itself; zero for forms of velocities.
    pub fn value(&self, ends: &Ends) -> f64 {
        let d = ends.between();
        match self {
            Self::Along { axis, .. } => axis.dot(&d),
            Self::Across { a, b } => a.dot(b),
            Self::Distance { length } => 0.5 * (d.norm_squared() / length - length),
            Self::AngularVelocity { .. } => 0.0,
        }
    }

    /// g.
    pub fn gradient(&self, ends: &Ends) -> Parts {
        let d = ends.between();
        let (f_a, f_b) = (&ends.a.arm, &ends.b.arm);
        let zero = Vector3::zeros();
        let along = |e: &Vector3<f64>| [-e, -f_a.cross(e), *e, f_b.cross(e)];
        match self {
            Self::Along { axis, carrier } => {
                let mut g = along(axis);
                if let Some(part) = carrier.part() {
                    g[part as usize] += axis.cross(&d);
                }
                g
            }
            Self::Across { a, b } => {
                let couple = a.cross(b);
                [zero, couple, zero, -couple]
            }
            Self::Distance { length } => along(&(d / *length)),
            Self::AngularVelocity { axis, .. } => [zero, -axis, zero, *axis],
        }
    }

    /// Whether the form depends on displacements.
    pub fn has_positions(&self) -> bool {
        matches!(self, Self::Along { .. } | Self::Distance { .. })
    }

    /// Passes the blocks of H to `add`; the same blocks at every state, some repeatedly.
    pub fn hessian(&self, ends: &Ends, add: &mut impl FnMut(Part, Part, Matrix3<f64>)) {
        let d = ends.between();
        let [f_a, f_b] = [skew(&ends.a.arm), skew(&ends.b.arm)];
        match self {
            Self::Along { axis, carrier } => {
                let e = skew(axis);
                add(Part::TurnB, Part::TurnB, e * f_b);
                add(Part::TurnA, Part::TurnA, -e * f_a);
                let Some(k) = carrier.part() else {
                    return;
                };
                add(Part::PositionB, k, -e);
                add(Part::TurnB, k, -f_b * e);
                add(Part::PositionA, k, e);
                add(Part::TurnA, k, f_a * e);
                add(k, k, skew(&d) * e);
                by_between(k, &e, &f_a, &f_b, add);
            }
            Self::Across { a, b } => {
                let (a, b) = (skew(a), skew(b));
                for (part, sign) in [(Part::TurnA, 1.0), (Part::TurnB, -1.0)] {
                    add(part, Part::TurnA, sign * b * a);
                    add(part, Part::TurnB, -sign * a * b);
                }
            }
            Self::Distance { length } => {
                let n = skew(&(d / *length));
                add(Part::TurnB, Part::TurnB, n * f_b);
                add(Part::TurnA, Part::TurnA, -n * f_a);
                let unit = Matrix3::identity();
                for (part, factor) in [
                    (Part::PositionA, -unit),
                    (Part::TurnA, -f_a),
                    (Part::PositionB, unit),
                    (Part::TurnB, f_b),
                ] {
                    by_between(part, &(factor / *length), &f_a, &f_b, add);
                }
            }
            Self::AngularVelocity { axis, carrier } => {
                if let Some(k) = carrier.part() {
                    add(Part::TurnB, k, -skew(axis));
                    add(Part::TurnA, k, skew(axis));
                }
            }
        }
    }

    /// `q' . H q'`.
    pub fn curvature(&self, ends: &Ends) -> f64 {
        let rates = ends.rates();
        let mut sum = 0.0;
        self.hessian(ends, &mut |row, column, block| {
            sum += rates[row as usize].dot(&(block * rates[column as usize]));
        });
        sum
    }
}

/// Blocks of `factor d d`.
fn by_between(
    row: Part,
    factor: &Matrix3<f64>,
    f_a: &Matrix3<f64>,
    f_b: &Matrix3<f64>,
    add: &mut impl FnMut(Part, Part, Matrix3<f64>),
) {
    add(row, Part::PositionB, *factor);
    add(row, Part::TurnB, -factor * f_b);
    add(row, Part::PositionA, -factor);
    add(row, Part::TurnA, factor * f_a);
}

/// `g . q'`.
pub(in crate::elements::joints) fn sum_of_products(g: &Parts, rates: &Parts) -> f64 {
    g.iter().zip(rates).map(|(g, rate)| g.dot(rate)).sum()
}
