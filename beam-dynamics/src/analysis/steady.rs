//! Steady equilibrium in the turning frame: `F(y, 0) = 0`.

use nalgebra::Vector3;

use crate::assembly::{Residual, System};
use crate::case::Model;
use crate::model::{Conditions, Equation, Loading, NODE_UNKNOWNS, State, TurningFrame};
use crate::solver::{Equations, LinearSolver, Newton, NewtonReport, NewtonStatus, Worst, solve};

/// Smallest step, as a part of the way to the wanted speed, before giving up.
const SMALLEST_STEP: f64 = 1.0 / 256.0;

/// The equilibrium equations of a system at one speed.
struct Steady<'a> {
    system: &'a System,
    solver: &'a LinearSolver,
    conditions: Conditions,
    state: State,
    /// Size of the model, by which displacements are measured [m].
    size: f64,
}

/// An equilibrium and the effort that it took.
#[derive(Debug, Clone)]
pub struct Equilibrium {
    /// The state, at rest in the turning frame.
    pub state: State,
    /// What acts.
    pub conditions: Conditions,
    /// Newton iterations, those of intermediate speeds included.
    pub iterations: usize,
    /// Largest residual relative to the largest term of its kind [-].
    pub residual: f64,
}

/// Why no equilibrium was found.
#[derive(Debug, Clone, thiserror::Error)]
#[error(
    "no steady equilibrium at {}: {reason}; worst equation: {equation}, relative residual {residual:.1e}",
    rpm(*speed)
)]
pub struct NoEquilibrium {
    /// Speed of rotation [rad/s].
    pub speed: f64,
    /// How the iteration ended, in words.
    pub reason: &'static str,
    /// The worst equation in words.
    pub equation: String,
    /// Its residual relative to the largest term of its kind [-].
    pub residual: f64,
    /// The last iteration's history.
    pub report: NewtonReport,
}

/// A speed in the unit of messages, with the digits that a reader needs.
pub(super) fn rpm(speed: f64) -> String {
    let speed = speed * 30.0 / std::f64::consts::PI;
    if speed.abs() < 1e7 {
        format!("{} rpm", (1e3 * speed).round() / 1e3)
    } else {
        format!("{speed:.3e} rpm")
    }
}

/// Conditions at a part of the way between two.
fn between(from: &Conditions, to: &Conditions, part: f64) -> Conditions {
    if part == 1.0 {
        return *to;
    }
    let (a, b) = (&from.loading, &to.loading);
    let mix = |a: f64, b: f64| a + part * (b - a);
    Conditions {
        frame: TurningFrame {
            angular_velocity: from
                .frame
                .angular_velocity
                .lerp(&to.frame.angular_velocity, part),
            center: to.frame.center,
        },
        loading: Loading {
            gravity: a.gravity.lerp(&b.gravity, part),
            constant: mix(a.constant, b.constant),
            proportional: mix(a.proportional, b.proportional),
        },
    }
}

/// Finds the equilibrium under the conditions `to` from a state known under `from`, in
/// steps that are halved where Newton's method fails.
///
/// # Errors
/// [`NoEquilibrium`] with the worst equation of the smallest step tried.
pub fn equilibrium(
    model: &Model,
    solver: &LinearSolver,
    from: (&Conditions, &State),
    to: &Conditions,
) -> Result<Equilibrium, Box<NoEquilibrium>> {
    let system = &model.system;
    let (mut reached, mut state) = (0.0, from.1.clone());
    let mut step = 1.0;
    let mut iterations = 0;
    // `reached` and `step` are parts of the way: no step is below SMALLEST_STEP.
    loop {
        let next: f64 = f64::min(reached + step, 1.0);
        let conditions = between(from.0, to, next);
        let mut steady = Steady::new(system, solver, conditions, state.clone());
        let report = solve(&mut steady, &Newton::default());
        iterations += report.history.len();
        if report.status != NewtonStatus::Converged {
            step *= 0.5;
            if step < SMALLEST_STEP || from.0 == to {
                let speed = conditions.frame.angular_velocity.norm();
                return Err(Box::new(no_equilibrium(system, speed, report)));
            }
        } else if next < 1.0 {
            (reached, state) = (next, steady.state);
        } else {
            return Ok(Equilibrium {
                state: steady.state,
                conditions,
                iterations,
                residual: report.worst.relative,
            });
        }
    }
}

fn no_equilibrium(system: &System, speed: f64, report: NewtonReport) -> NoEquilibrium {
    let reason = match report.status {
        NewtonStatus::Singular => "the tangent is singular",
        _ => "Newton's method did not converge",
    };
    NoEquilibrium {
        speed,
        reason,
        equation: system.describe_equation(report.worst.place),
        residual: report.worst.relative,
        report,
    }
}

impl<'a> Steady<'a> {
    fn new(
        system: &'a System,
        solver: &'a LinearSolver,
        conditions: Conditions,
        state: State,
    ) -> Self {
        let first = system
            .nodes()
            .first()
            .map_or_else(Vector3::zeros, |n| n.position);
        let reach = system
            .nodes()
            .iter()
            .map(|node| (node.position - first).norm());
        let size = reach.fold(0.0, f64::max);
        Self {
            system,
            solver,
            conditions,
            state,
            size: if size > 0.0 { size } else { 1.0 },
        }
    }
}

impl Equations for Steady<'_> {
    fn residual(&mut self) -> (Vec<f64>, Worst) {
        let residual = self.system.residual(&self.state, &self.conditions);
        let worst = worst(&residual, self.system.nodes().len());
        (residual.values, worst)
    }

    fn correction(&mut self, residual: &[f64]) -> Option<Vec<f64>> {
        let tangent = self.system.tangent(&self.state, &self.conditions);
        let factorization = self.solver.factorize(tangent.by_unknowns)?;
        let mut correction: Vec<_> = residual.iter().map(|value| -value).collect();
        factorization.solve(&mut correction)?;
        Some(correction)
    }

    /// Largest displacement in sizes of the model, and largest rotation in radians.
    fn size(&self, correction: &[f64]) -> f64 {
        let nodes = self.state.nodes.len();
        let of_nodes = correction[..NODE_UNKNOWNS * nodes].chunks(NODE_UNKNOWNS);
        let size = |node: &[f64]| {
            let part = |i: usize| Vector3::new(node[i], node[i + 1], node[i + 2]).norm();
            (part(0) / self.size).max(part(3))
        };
        of_nodes
            .map(size)
            .fold(0.0, |a: f64, b| if b.is_nan() { b } else { a.max(b) })
    }

    fn correct(&mut self, correction: &[f64]) {
        self.state.correct(correction);
    }
}

/// The worst equation: residual against the largest term of its kind.
fn worst(residual: &Residual, nodes: usize) -> Worst {
    // Kinds: the four vector equations of the nodes, and the constraints.
    let kind = |place: usize| {
        if place < NODE_UNKNOWNS * nodes {
            place % NODE_UNKNOWNS / 3
        } else {
            Equation::ALL.len()
        }
    };
    let mut largest = [0.0_f64; Equation::ALL.len() + 1];
    for (place, size) in residual.sizes.iter().enumerate() {
        largest[kind(place)] = largest[kind(place)].max(*size);
    }
    // The terms of a constraint vanish with it: they are measured against one.
    largest[Equation::ALL.len()] = 1.0;
    let relative = |place: usize| {
        let size = largest[kind(place)];
        if size > 0.0 {
            residual.values[place].abs() / size
        } else {
            0.0
        }
    };
    let places = (0..residual.values.len()).map(|place| Worst {
        relative: relative(place),
        place,
    });
    places
        .max_by(|a, b| a.relative.total_cmp(&b.relative))
        .unwrap_or_default()
}
