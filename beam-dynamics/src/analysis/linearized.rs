//! A model linearized about an equilibrium, and its modes as motions.

use std::cell::OnceCell;
use std::f64::consts::TAU;

use nalgebra::Complex;

use crate::assembly::{MasslessMotions, Sparse, Tangent};
use crate::case::Model;
use crate::modes::{
    EigenProblem, Eigenpair, MassMatrix, ModeMotion, Rotor, separate, separate_patterns,
    shaft_whirl,
};
use crate::result::{ModeKind, ModePoint};
use crate::solver::LinearSolver;

use super::around_the_axis::copies;
use super::steady::Equilibrium;

/// The linearized system with its masses.
pub(super) struct Linearized<'a> {
    model: &'a Model,
    steady: &'a Equilibrium,
    tangent: Tangent,
    massless: MasslessMotions,
    /// The system without the forces of the air, if any act, once it is needed.
    vacuum: OnceCell<Option<Tangent>>,
    mass: MassMatrix,
}

impl<'a> Linearized<'a> {
    /// Linearizes the model about an equilibrium.
    pub fn new(model: &'a Model, steady: &'a Equilibrium) -> Self {
        let system = &model.system;
        let tangent = system.tangent(&steady.state, &steady.conditions);
        let mass = MassMatrix::new(&tangent.by_rates, system.nodes().len());
        Self {
            model,
            massless: MasslessMotions::new(system, &tangent),
            vacuum: OnceCell::new(),
            steady,
            tangent,
            mass,
        }
    }

    /// The problem of its modes; `None` if something moves that neither mass nor stiffness determines.
    pub fn problem<'b>(&'b self, solver: &'b LinearSolver) -> Option<EigenProblem<'b>> {
        let copies = copies(self.model);
        let problem = EigenProblem::new(solver, &self.tangent, &self.massless, copies)?;
        // Only among slow states of the air modes are found from the ones without it.
        let has_states = !self.model.system.scalars().is_empty();
        Some(problem.with_vacuum(has_states.then(|| self.vacuum()).flatten()))
    }

    /// The problem of modes near a `size` \[1/s\], which are known of a similar system.
    pub fn problem_near<'b>(
        &'b self,
        solver: &'b LinearSolver,
        size: f64,
    ) -> Option<EigenProblem<'b>> {
        let copies = copies(self.model);
        EigenProblem::near(solver, &self.tangent, &self.massless, copies, size)
    }

    /// The same system without the forces of the air; `None` if no air acts.
    pub fn without_air(&self) -> Option<Self> {
        let (system, tangent) = (&self.model.system, self.vacuum()?.clone());
        Some(Self {
            model: self.model,
            massless: MasslessMotions::new(system, &tangent),
            vacuum: OnceCell::from(None),
            steady: self.steady,
            mass: MassMatrix::new(&tangent.by_rates, system.nodes().len()),
            tangent,
        })
    }

    /// The linearized system without the forces of the air; `None` if none act.
    fn vacuum(&self) -> Option<&Tangent> {
        let vacuum = || {
            let mut conditions = self.steady.conditions;
            conditions.loading.air = 0.0;
            let system = &self.model.system;
            let tangent = system.tangent(&self.steady.state, &conditions);
            let is_same =
                |of: fn(&Tangent) -> &Sparse| of(&tangent).values() == of(&self.tangent).values();
            let is_whole = is_same(|own| &own.by_unknowns) && is_same(|own| &own.by_rates);
            (!is_whole).then_some(tangent)
        };
        self.vacuum.get_or_init(vacuum).as_ref()
    }

    /// The motion of a pair.
    pub fn motion(&self, pair: &Eigenpair) -> ModeMotion {
        ModeMotion::new(pair, &self.mass)
    }

    /// The motions of pairs whose numbers ascend, pure ones of pairs of equal numbers.
    pub fn motions(
        &self,
        pairs: &[Eigenpair],
        number: impl Fn(&Eigenpair) -> f64,
        rotor: Option<&Rotor>,
    ) -> Vec<ModeMotion> {
        let mut motions: Vec<_> = pairs.iter().map(|pair| self.motion(pair)).collect();
        let numbers: Vec<_> = pairs.iter().map(number).collect();
        separate(&mut motions, &numbers, &self.model.naming, rotor);
        if let Some(rotor) = rotor {
            let value = |pair: &Eigenpair| Complex::new(pair.growth, pair.angular_frequency);
            let values: Vec<_> = pairs.iter().map(value).collect();
            separate_patterns(&mut motions, &values, rotor);
        }
        motions
    }
}

/// A mode of a growth \[1/s\] and an angular frequency \[rad/s\] that nothing else is known of.
pub(super) fn point_of(growth: f64, angular_frequency: f64) -> ModePoint {
    let magnitude = growth.hypot(angular_frequency);
    ModePoint {
        frequency: angular_frequency / TAU,
        damping_ratio: if magnitude > 0.0 {
            // A growth of zero has no sign.
            0.0 - growth / magnitude
        } else {
            0.0
        },
        growth,
        shares: [0.0; 4],
        lateral: 0.0,
        tower: [0.0; 2],
        whirl: None,
        assurance: None,
        shape: None,
    }
}

/// Adds the shares of the energy and the kind of motion of a mode.
pub(super) fn describe(
    (model, rotor): (&Model, Option<&Rotor>),
    motion: &ModeMotion,
    point: &mut ModePoint,
) {
    let naming = &model.naming;
    point.shares = motion.shares(naming);
    (point.lateral, point.tower) = (motion.lateral(naming), motion.of_tower(naming));
    let whirl = rotor.and_then(|rotor| rotor.whirl(motion));
    let whirl = whirl.or_else(|| shaft_whirl(motion, naming));
    point.whirl = whirl.filter(|_| ModeKind::of_tower(point.tower).is_none());
}
