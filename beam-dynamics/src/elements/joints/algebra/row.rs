//! One constraint of a joint: a form and its target.
//!
//! ```text
//! along, across     Phi = form - s(t)                 distance   Phi = form of l = s(t)
//! along, as rate    Phi = g . q' - s(t)               spin       Phi = g . q' - s(t)
//! ```

use nalgebra::{Matrix3, Vector3};

use super::form::sum_of_products;
use super::{Carrier, Ends, Form, Part, Parts, Turned};
use crate::elements::{Instant, Level, LocalJacobian, LocalResidual, Signal};
use crate::model::Equation::{Force, Moment};
use crate::model::{DriveValue, Equation, Variable};

/// A form by the indices of its axes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::elements::joints) enum Held {
    /// The distance along axis `axis` of the carrier; for the frame, of `a` undeformed.
    Along(Carrier, usize),
    /// The rate of this distance.
    Velocity(Carrier, usize),
    /// The cosine between an axis of a, turned by the drive, and one of b.
    Across(usize, usize),
    /// The distance of the points.
    Distance,
    /// The angular velocity of b against a about an axis of the carrier.
    AngularVelocity(Carrier, usize),
}

/// A constraint.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::elements::joints) struct Row {
    pub held: Held,
    /// s; zero if absent.
    pub target: Option<Signal>,
}

/// Data of a joint at a state for its rows.
#[derive(Debug, Clone, Copy)]
pub(in crate::elements::joints) struct Seen<'a> {
    pub ends: Ends,
    /// Axes fixed in the frame.
    pub frame: &'a Matrix3<f64>,
    /// The axes of a as turned by the drive.
    pub turned: Turned,
    pub now: Instant<'a>,
    /// The multiplier of the targets.
    pub scale: DriveValue,
}

/// A row at a state.
#[derive(Debug, Clone, Copy)]
pub(in crate::elements::joints) struct RowAtState<'a> {
    seen: &'a Seen<'a>,
    pub form: Form,
    /// Whether it constrains a rate.
    of_rates: bool,
    target: DriveValue,
    /// `e_a'` and `e_a''` of a form that depends on the turned axes.
    driven: [Vector3<f64>; 2],
}

impl Row {
    /// A row with a target of zero.
    pub fn zero(held: Held) -> Self {
        Self { held, target: None }
    }

    /// A row that follows a signal.
    pub fn driven(held: Held, target: impl Into<Signal>) -> Self {
        let target = Some(target.into());
        Self { held, target }
    }

    /// Whether the reaction of its multiplier depends on the target, or on the rotation by which a
    /// joint turns the axes of a.
    pub fn is_turned(&self) -> bool {
        matches!(self.held, Held::Across(..) | Held::Distance)
    }

    pub fn level(&self) -> Level {
        match self.held {
            Held::Velocity(..) | Held::AngularVelocity(..) => Level::Velocity,
            _ => Level::Position,
        }
    }

    pub fn at<'a>(&self, seen: &'a Seen<'a>) -> RowAtState<'a> {
        let target = self.target.as_ref();
        let target = target.map_or_else(DriveValue::default, |s| s.at(&seen.now));
        let target = target.times(seen.scale);
        let axis = |carrier: Carrier, axis: usize| match carrier {
            Carrier::Frame => seen.frame.column(axis).into_owned(),
            Carrier::A => seen.ends.a.axes.column(axis).into_owned(),
            Carrier::B => seen.ends.b.axes.column(axis).into_owned(),
        };
        let mut driven = [Vector3::zeros(); 2];
        let form = match self.held {
            Held::Along(carrier, i) | Held::Velocity(carrier, i) => Form::Along {
                axis: axis(carrier, i),
                carrier,
            },
            Held::Across(a, b) => {
                let a = seen.turned.axes.column(a).into_owned();
                driven = seen.turned.derivatives(&a);
                let b = axis(Carrier::B, b);
                Form::Across { a, b }
            }
            // The form has no value at zero length.
            Held::Distance => Form::Distance {
                length: if target.value > 0.0 {
                    target.value
                } else {
                    f64::NAN
                },
            },
            Held::AngularVelocity(carrier, i) => Form::AngularVelocity {
                axis: axis(carrier, i),
                carrier,
            },
        };
        RowAtState {
            seen,
            form,
            of_rates: self.level() == Level::Velocity,
            target,
            driven,
        }
    }
}

impl RowAtState<'_> {
    fn ends(&self) -> &Ends {
        &self.seen.ends
    }

    /// Force and moment on each end for a multiplier of one, by part.
    pub fn reaction(&self) -> Parts {
        self.form.gradient(self.ends()).map(|g| -g)
    }

    /// Whether the part of the reaction belongs to the row at every state.
    fn has(&self, part: Part) -> bool {
        part.is_turn() || self.form.has_positions()
    }

    fn value(&self) -> f64 {
        let value = if self.of_rates {
            sum_of_products(&self.form.gradient(self.ends()), &self.ends().rates())
        } else {
            self.form.value(self.ends())
        };
        match self.form {
            Form::Distance { .. } => value,
            _ => value - self.target.value,
        }
    }

    /// Adds constraint number `row` and its reactions to a residual, and their derivatives to a
    /// Jacobian if requested.
    pub fn evaluate(
        &self,
        row: usize,
        lambda: f64,
        out: &mut LocalResidual,
        jacobian: Option<&mut LocalJacobian>,
    ) {
        let reaction = self.reaction();
        self.residual((row, lambda), &reaction, out);
        if let Some(out) = jacobian {
            self.jacobian((row, lambda), &reaction, out);
        }
    }

    fn residual(&self, (row, lambda): (usize, f64), reaction: &Parts, out: &mut LocalResidual) {
        out.add_constraint(row, self.value());
        self.each_part(|part, node| {
            let equation = if part.is_turn() { Moment } else { Force };
            out.add(node, equation, &(lambda * reaction[part as usize]));
        });
    }

    /// Derivatives of [`Self::residual`].
    fn jacobian(&self, (row, lambda): (usize, f64), reaction: &Parts, out: &mut LocalJacobian) {
        self.each_part(|part, node| {
            let (equation, positions, rates) = names(part);
            let reaction = reaction[part as usize];
            out.add_multiplier((node, equation), row, &reaction);
            let by = if self.of_rates { rates } else { positions };
            out.add_constraint(row, (node, by), &-reaction.transpose());
        });
        let velocities = self.ends().rates();
        self.form.hessian(self.ends(), &mut |of, by, block| {
            let nodes = (self.ends().node(of.end()), self.ends().node(by.end()));
            let (Some(node), Some(column)) = nodes else {
                return;
            };
            let (equation, positions) = (names(of).0, names(by).1);
            out.add((node, equation), (column, positions), &(-lambda * block));
            if self.of_rates {
                let slope = velocities[of as usize].transpose() * block;
                out.add_constraint(row, (column, positions), &slope);
            }
        });
    }

    /// Calls with every part that belongs to a node, and the node.
    fn each_part(&self, mut with: impl FnMut(Part, usize)) {
        for part in Part::ALL.into_iter().filter(|part| self.has(*part)) {
            if let Some(node) = self.ends().node(part.end()) {
                with(part, node);
            }
        }
    }

    /// `Phi_t`, and the derivative of the gradient, for a change of the target by `rate` and of the
    /// driven direction by `turn`.
    fn by_change(&self, rate: f64, turn: &Vector3<f64>) -> (f64, Parts) {
        let (ends, zero) = (self.ends(), [Vector3::zeros(); 4]);
        match self.form {
            Form::Across { b, .. } => {
                let changed = Form::Across { a: *turn, b };
                (changed.value(ends) - rate, changed.gradient(ends))
            }
            Form::Distance { length } => {
                let square = ends.between().norm_squared() / (length * length);
                let slope = rate / length;
                let gradient = self.form.gradient(ends).map(|g| -slope * g);
                (-0.5 * (square + 1.0) * rate, gradient)
            }
            Form::Along { .. } | Form::AngularVelocity { .. } => (-rate, zero),
        }
    }

    /// `d Phi/dt` at fixed positions, and the part of the last derivative of Phi without
    /// accelerations.
    pub fn rates(&self) -> (f64, f64) {
        let curvature = self.form.curvature(self.ends());
        let DriveValue {
            rate, acceleration, ..
        } = self.target;
        if self.of_rates {
            return (0.0, curvature - rate);
        }
        let (by_time, of_gradient) = self.by_change(rate, &self.driven[0]);
        let (mut second, _) = self.by_change(acceleration, &self.driven[1]);
        if let Form::Distance { length } = self.form {
            second += self.ends().between().norm_squared() * rate * rate / length.powi(3);
        }
        let mixed = sum_of_products(&of_gradient, &self.ends().rates());
        (by_time, curvature + 2.0 * mixed + second)
    }

    /// The derivative of [`Self::residual`] by a number on which the targets depend, of the
    /// constraint and of the forces, which are passed to `force`: `turn` is w of the axes for a
    /// unit rate of that number, and `rate` the rate of the target.
    pub fn by_target(
        &self,
        lambda: f64,
        (rate, turn): (f64, &Vector3<f64>),
        mut force: impl FnMut(usize, Equation, &Vector3<f64>),
    ) -> f64 {
        let turned = match self.form {
            Form::Across { a, .. } => turn.cross(&a),
            _ => Vector3::zeros(),
        };
        let (change, of_gradient) = self.by_change(rate, &turned);
        self.each_part(|part, node| {
            force(node, names(part).0, &(-lambda * of_gradient[part as usize]));
        });
        change
    }
}

/// Equation, variable and rate of a part.
fn names(part: Part) -> (Equation, Variable, Variable) {
    if part.is_turn() {
        (Moment, Variable::Rotation, Variable::AngularVelocity)
    } else {
        (Force, Variable::Position, Variable::Velocity)
    }
}
