//! Critical loads by linearized prestress.
//!
//! About an equilibrium under rotation and constant loads, the proportional loads give the linear
//! solution `y_1 = -K_0^-1 F_lambda`. Its internal forces, the reactions and the loads themselves
//! make the tangent grow, at fixed geometry, by `K_1` per unit of the factor. The model buckles if
//!
//! ```text
//! (K_0 + lambda K_1) v = 0
//! ```
//!
//! # Example
//!
//! ```
//! use beam_dynamics::analysis::buckling::buckling;
//! use beam_dynamics::input;
//!
//! // a clamped strip of 2 m under a force of 1 N along it
//!
//! let text = r#"
//! units = "SI"
//! [properties.strip]
//! ea = 2.8e7
//! gay = 9e6
//! gaz = 9e6
//! gj = 300
//! eiy = 240
//! eiz = 3700
//! m = 1.08
//! iy = 1e-6
//! iz = 1e-6
//! [[blade]]
//! name = "blade"
//! properties = "strip"
//! [[blade.piece]]
//! length = 2
//! elements = 8
//! [[load]]
//! node = "blade/tip"
//! force = [-1, 0, 0]
//! [buckling]
//! count = 1
//! "#;
//! let input = input::parse(text, "strip.dynamics.toml").expect("a sound file");
//! let settings = input.buckling.as_ref().expect("a card [buckling]");
//!
//! let outcome = buckling(&input.model, settings);
//! // pi^2 EI / (4 L^2)
//! let slender = std::f64::consts::PI.powi(2) * 240.0 / 16.0;
//! assert!((outcome.result.modes[0].factor / slender - 1.0).abs() < 1e-3);
//! ```
//!
//! References: [Masarati], buckling by the prestress of the finite-volume beam.

use nalgebra::Vector3;

use crate::assembly::{MasslessMotions, Sparse, Tangent};
use crate::case::{BucklingSettings, Model};
use crate::model::{Conditions, NODE_UNKNOWNS, State};
use crate::modes::{EigenProblem, Eigenpair, Factors};
use crate::result::{BucklingMode, BucklingResult};
use crate::solver::LinearSolver;

use super::balance::Balance;
use super::critical::critical_part;
use super::deformation::deformation;
use super::first_order::first_order;
use super::statics::{base, static_step};
use super::steady::NoEquilibrium;

/// Multiplicity of a critical load that is resolved: both bending directions of a round column.
const COPIES: usize = 4;
/// Relative error of factor and shape above which a remark is given.
const TRUSTED: f64 = 1e-6;
/// Relative difference below which factors are treated as equal.
const SAME: f64 = 1e-6;
/// Growth of the tangent below this part of the loads is round-off.
const ROUND_OFF: f64 = 1e-9;

/// Reasons for missing critical loads.
#[derive(Debug, Clone, thiserror::Error)]
pub enum BucklingFailure {
    /// No equilibrium under rotation and constant loads.
    #[error("load factor 0: {0}")]
    Base(#[from] Box<NoEquilibrium>),
    /// The model has a motion without stiffness before the loads act.
    #[error("load factor 0: the tangent is singular: a motion has no stiffness")]
    Singular,
    /// Nothing grows with the factor.
    #[error("no load grows with the load factor, so that no critical load exists")]
    NoLoad,
    /// The loads cause no stress that could make the model buckle.
    #[error("the loads cause no internal force that could make the model buckle")]
    NoPrestress,
    /// Forces act, but no real factor of them makes the tangent singular.
    #[error(
        "no real factor of the loads is critical: the model does not buckle at rest \
         under loads of any size; follower loads may make it flutter instead"
    )]
    NoRealFactor,
    /// No factor was found, but it is not proven that none exists.
    #[error(
        "no critical load was found, but in a model of this size and with follower loads or \
         finite volumes it is not certain that none exists"
    )]
    NotFound,
    /// Factors outside the range of floating-point numbers.
    #[error("the loads or the stiffnesses are so large or small that the factors are not finite")]
    OutOfRange,
}

impl BucklingFailure {
    /// The remedy.
    pub fn remedy(&self) -> &'static str {
        match self {
            Self::NoLoad => {
                "add a [[load]], [[distributed_load]] or [[imposed]] that is not constant"
            }
            Self::NoPrestress => {
                "linearized buckling needs forces at the factor one; bending alone needs [static]"
            }
            Self::NoRealFactor => {
                "flutter shows in [modes] under the loads: raise them until a motion grows"
            }
            Self::NotFound => {
                "take fewer elements, or loads that keep their direction, or raise the loads in \
                 [static] until a critical point is reported"
            }
            Self::OutOfRange => "give loads for which the factors are near one",
            Self::Base(_) | Self::Singular => {
                "constrain the free motion with [[clamp]] or [[imposed]]"
            }
        }
    }
}

/// Critical loads, and the reason if there are none.
#[derive(Debug)]
pub struct BucklingOutcome {
    /// The critical loads found.
    pub result: BucklingResult,
    /// Reason for an incomplete result.
    pub failure: Option<BucklingFailure>,
}

/// The critical loads of `model` of smallest magnitude.
pub fn buckling(model: &Model, settings: &BucklingSettings) -> BucklingOutcome {
    let mut result = BucklingResult {
        name: model.name.clone(),
        speed: settings.speed,
        nodes: model.system.nodes().to_vec(),
        beams: model.beams.clone(),
        base: None,
        modes: Vec::new(),
        remarks: Vec::new(),
    };
    let failure = run(model, settings, &mut result).err();
    let base = result.base.as_ref();
    let when = "under rotation and constant loads";
    let remark = base.and_then(|step| first_order(&step.sections, when));
    let deformed = base.map(|step| deformation(&step.sections, when));
    let deformed = deformed.into_iter().flatten().flatten();
    result.remarks.extend(deformed.chain(remark));
    BucklingOutcome { result, failure }
}

fn run(
    model: &Model,
    settings: &BucklingSettings,
    result: &mut BucklingResult,
) -> Result<(), BucklingFailure> {
    let system = &model.system;
    let solver = LinearSolver::new(system.pattern());
    let conditions = model.conditions(settings.speed, 1.0, 0.0);
    let point = base(model, &solver, &conditions)?;
    let state = point.state.clone();
    result.base = Some(static_step(model, &conditions, point));

    let load = system.by_factor(&state, &conditions);
    if load.iter().all(|value| *value == 0.0) {
        return Err(BucklingFailure::NoLoad);
    }
    let balance = Balance::new(system, &solver, conditions, state);
    let tangent = balance.factorize().ok_or(BucklingFailure::Singular)?;
    let along = balance.rate(&tangent).ok_or(BucklingFailure::Singular)?;
    let growth = system.prestress(&balance.state, &conditions, &along);
    let largest = |values: &[f64]| values.iter().fold(0.0_f64, |a, b| a.max(b.abs()));
    if largest(growth.values()) <= ROUND_OFF * largest(&load) {
        return Err(BucklingFailure::NoPrestress);
    }
    let pencil = Tangent {
        by_unknowns: system.by_unknowns(&balance.state, &conditions),
        by_rates: growth,
    };
    let all = MasslessMotions::none(system.nodes().len());
    let copies = COPIES.max(settings.count);
    let problem = EigenProblem::about_zero(&solver, &pencil, &all, copies);
    let problem = problem.ok_or(BucklingFailure::OutOfRange)?;
    let factors = problem.factors(settings.count);
    let pairs = &factors.pairs;
    if pairs.is_empty() {
        return Err(if factors.is_complete {
            BucklingFailure::NoRealFactor
        } else {
            BucklingFailure::NotFound
        });
    }
    if pairs.iter().any(|pair| !pair.residual.is_finite()) {
        return Err(BucklingFailure::OutOfRange);
    }
    result.modes = pairs.iter().map(mode).collect();
    result.remarks = remarks(&result.modes, &factors, settings.count);
    result.remarks.extend(beyond(
        model,
        &solver,
        &conditions,
        (&balance.state, &pencil.by_unknowns),
    ));
    Ok(())
}

fn remarks(modes: &[BucklingMode], factors: &Factors, requested: usize) -> Vec<String> {
    let mut remarks = Vec::new();
    if modes.len() < requested {
        let why = match (factors.is_complete, factors.uncertain) {
            (true, _) => "the model has no more".to_owned(),
            (false, 0) => "whether more exist is unknown for a model of this size".to_owned(),
            (false, n) => format!("{n} more have too large an error to be listed"),
        };
        let found = modes.len();
        remarks.push(format!(
            "{found} critical loads were found of {requested} requested: {why}"
        ));
    }
    remarks.extend(copies(modes));
    let worst = modes.iter().map(|mode| mode.residual);
    let worst = worst.fold(0.0, |a: f64, b| if b > a || b.is_nan() { b } else { a });
    if worst > TRUSTED || worst.is_nan() {
        remarks.push(format!(
            "digits are lost (relative residual {worst:.1e}): stiffnesses or lengths of very \
             different size occur in the model"
        ));
    }
    remarks
}

/// A remark on rotations of sections at one factor: if all sections lose their torsional stiffness
/// together, each of them has a shape.
fn copies(modes: &[BucklingMode]) -> Option<String> {
    let turns: Vec<_> = modes.iter().filter(|mode| mode.is_rotation()).collect();
    let same = |a: &BucklingMode, b: &BucklingMode| (a.factor / b.factor - 1.0).abs() < SAME;
    let of = |mode: &BucklingMode| turns.iter().filter(|other| same(mode, other)).count();
    let most = turns.iter().map(|mode| (of(mode), mode.factor));
    let (count, factor) = most
        .max_by_key(|(count, _)| *count)
        .filter(|most| most.0 > 1)?;
    Some(format!(
        "{count} of the shapes turn sections at the same factor, {factor:.6}: there the sections lose \
         their torsional stiffness, and every shape of torsion is critical; request more \
         critical loads if others are needed"
    ))
}

/// A remark if rotation and constant loads alone are past a critical point.
fn beyond(
    model: &Model,
    solver: &LinearSolver,
    conditions: &Conditions,
    (state, tangent): (&State, &Sparse),
) -> Option<String> {
    let rest = model.system.rest();
    let undeformed = || model.system.by_unknowns(&rest, &Conditions::at_rest());
    let deformed = || tangent.clone();
    let part = critical_part(solver, (&rest, undeformed), (state, deformed))?;
    let cause = if conditions.frame.angular_velocity.norm() > 0.0 {
        "rotation and constant loads"
    } else {
        "the constant loads"
    };
    Some(format!(
        "the model buckles under about {part:.4} of {cause} already: the factors belong \
         to an unstable equilibrium"
    ))
}

/// A critical load with its shape, whose largest displacement is one.
fn mode(pair: &Eigenpair) -> BucklingMode {
    let part = |i: usize| -> Vec<Vector3<f64>> {
        let of_nodes = pair.real.chunks(NODE_UNKNOWNS);
        of_nodes
            .map(|node| Vector3::from_column_slice(&node[i..i + 3]))
            .collect()
    };
    let (mut displacements, mut rotations) = (part(0), part(3));
    let largest = |vectors: &[Vector3<f64>]| {
        let longest = vectors.iter().max_by(|a, b| a.norm().total_cmp(&b.norm()));
        longest.map_or_else(Vector3::zeros, |vector| *vector)
    };
    let (moved, turned) = (largest(&displacements), largest(&rotations));
    // If no node is displaced, the shape consists of rotations.
    let by = if moved.norm() > 1e-9 * turned.norm() {
        moved
    } else {
        displacements.fill(Vector3::zeros());
        turned
    };
    let sign = by.iamax();
    let scale = by.norm() * by.get(sign).copied().unwrap_or(1.0).signum();
    if scale != 0.0 {
        displacements.iter_mut().for_each(|value| *value /= scale);
        rotations.iter_mut().for_each(|value| *value /= scale);
    }
    BucklingMode {
        factor: pair.growth,
        displacements,
        rotations,
        residual: pair.residual,
    }
}
