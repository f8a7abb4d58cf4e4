//! Random mechanisms: chains of rigid bodies and beams on joints of all kinds, with springs
//! parallel to the joints and a stretched rod between the ends.
//!
//! A superposed rigid motion changes no strain, no force of a spring and no reaction: in statics a
//! root that is moved and turned under follower loads, in time another position and attitude and a
//! uniform velocity. The momentum of free mechanisms grows by the impulse of their weight.
//!
//! The mechanisms are drawn from a fixed seed, so that every run has the same ones; a failure is
//! reported with the smallest recipe that causes it.

use std::cell::Cell;

use beam_dynamics::case::{InitialMotion, TransientSettings};
use beam_dynamics::elements::Observations;
use beam_dynamics::elements::loads::{ImposedMotion, LoadFactor, NodalForce, Turning};
use nalgebra::{Matrix3, Rotation3, Vector3};
use proptest::array::uniform3;
use proptest::collection::vec;
use proptest::prelude::{Strategy, any};
use proptest::test_runner::{Config, RngAlgorithm, TestCaseError, TestRng, TestRunner};

use crate::effort::cases;
use crate::in_time::{Run, gain, momenta};
use crate::record;

use self::recipe::{KINDS, Link, Parts, Recipe};

mod recipe;

/// Mechanisms for each property.
const CASES: usize = 48;

const SOURCE: &str = "objectivity";

/// The tolerances. Positions at 10 m have errors of 1e-15 m, which strain a beam of 0.3 m by 1e-14,
/// relative to strains of 1e-3; after iterations to 1e-13 of the size of the model the error of
/// constraint forces is `m / h^2` times this, 1e-9 N, relative to some Newtons. The margin for
/// random mechanisms is three digits and one digit.
const TOLERANCE: f64 = 1e-9;

const GRAVITY: Vector3<f64> = Vector3::new(1.0, -2.0, -4.0);

/// A position, an attitude, and a uniform velocity.
#[derive(Debug, Clone, Copy)]
struct Rigid {
    turn: Matrix3<f64>,
    shift: Vector3<f64>,
    velocity: Vector3<f64>,
}

impl Rigid {
    const NONE: Self = Self {
        turn: Matrix3::new(1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0),
        shift: Vector3::new(0.0, 0.0, 0.0),
        velocity: Vector3::new(0.0, 0.0, 0.0),
    };
}

fn vectors(most: f64) -> impl Strategy<Value = [f64; 3]> {
    uniform3(-most..most)
}

fn recipes() -> impl Strategy<Value = Recipe> {
    let link = (
        any::<bool>(),
        0.3..1.0_f64,
        vectors(1.2),
        0..KINDS,
        vectors(3.0),
        0..64_u32,
    );
    let link = link.prop_map(|(is_beam, length, turn, kind, axes, held)| Link {
        is_beam,
        length,
        turn: turn.into(),
        kind,
        axes: axes.into(),
        held,
    });
    let whole = (vec(link, 2..5), any::<[bool; 2]>(), vectors(2.0));
    whole.prop_map(|(links, [is_held, is_centered], spin)| Recipe {
        links,
        is_held,
        is_centered,
        spin: spin.into(),
        relaxed: 0.8,
    })
}

fn rigid_motions() -> impl Strategy<Value = Rigid> {
    let parts = (vectors(1.4), vectors(10.0), vectors(5.0));
    parts.prop_map(|(turn, shift, velocity)| Rigid {
        turn: *Rotation3::new(Vector3::from(turn)).matrix(),
        shift: shift.into(),
        velocity: velocity.into(),
    })
}

/// Strains, and all forces and moments of springs and joints, in axes that move with the mechanism.
struct Observed {
    strains: Vec<f64>,
    forces: Vec<f64>,
}

impl Observed {
    fn of(seen: &Observations, turn: &Matrix3<f64>) -> Self {
        let strains = seen.sections.iter().flat_map(|s| s.strain.iter().copied());
        let springs = seen.springs.iter().map(|s| match s.spring.as_str() {
            // Its axes across the line are arbitrary.
            "rod" => [Vector3::x() * s.force.x, Vector3::zeros()],
            _ => [s.force, s.moment],
        });
        let reactions = seen.reactions.iter();
        let reactions = reactions.map(|r| [r.force, r.moment].map(|v| turn.transpose() * v));
        let forces = springs.chain(reactions).flatten();
        let forces = forces.flat_map(|v| [v.x, v.y, v.z]).collect();
        Self {
            strains: strains.collect(),
            forces,
        }
    }

    /// Differences of strains and of forces, relative to the largest of each.
    fn apart(all: &[Self], others: &[Self]) -> [f64; 2] {
        assert_eq!(all.len(), others.len());
        let part = |of: fn(&Self) -> &Vec<f64>| {
            let numbers = |all: &[Self]| all.iter().flat_map(of).copied().collect::<Vec<_>>();
            let (one, two) = (numbers(all), numbers(others));
            assert_eq!(one.len(), two.len());
            let size = one.iter().fold(f64::MIN_POSITIVE, |a, b| a.max(b.abs()));
            let off = one.iter().zip(&two).map(|(a, b)| (a - b).abs());
            // NaN is not accepted.
            off.fold(0.0, |a: f64, b| if b <= a { a } else { b }) / size
        };
        [
            part(|observed| &observed.strains),
            part(|observed| &observed.forces),
        ]
    }
}

/// Five hundredths of a second; the mass of the whole.
fn in_time(recipe: &Recipe, moved: &Rigid, step: f64) -> (Run, f64) {
    let Parts { chain, mass, .. } = recipe.parts(&moved.turn, &moved.shift);
    let first = chain.nodes[0].position;
    let motions = chain.nodes.iter().map(|node| {
        let from_first = moved.turn.transpose() * (node.position - first);
        let velocity = moved.turn * recipe.spin.cross(&from_first);
        InitialMotion {
            velocity: Some(velocity + moved.velocity),
            angular_velocity: Some(moved.turn * recipe.spin),
            ..InitialMotion::default()
        }
    });
    let motions = motions.collect();
    let mut model = chain.model();
    model.initial = motions;
    model.gravity = moved.turn * GRAVITY;
    let mut settings = TransientSettings::new(0.05, step);
    settings.newton.correction = 1e-13;
    settings.newton.residual = 1e-14;
    let run = Run::of(model, &settings, 1);
    run.check_end();
    (run, mass)
}

/// Mechanisms that swing and are pushed for four tenths of a second, in steps of several lengths:
/// some fail when they lock, and no gain of energy is reported.
#[test]
fn no_mechanism_is_said_to_gain_energy() {
    let seed = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    let config = Config {
        cases: cases(2 * CASES) as u32,
        failure_persistence: None,
        ..Config::default()
    };
    let ended = Cell::new(0);
    let mut runner = TestRunner::new_with_rng(config, seed);
    let outcome = runner.run(&(recipes(), 0..3_usize), |(recipe, length)| {
        let parts = recipe.parts(&Matrix3::identity(), &Vector3::zeros());
        let mut chain = parts.chain;
        for (i, &node) in parts.ends.iter().enumerate() {
            let load = NodalForce {
                force: Vector3::new(0.3, -0.4, 0.5 - 0.3 * i as f64),
                moment: Vector3::new(0.05, 0.02 * i as f64, -0.04),
                offset: Vector3::new(0.02, -0.05, 0.03),
                turning: [Turning::Follower, Turning::Dead][i % 2],
                factor: LoadFactor::Constant,
            };
            chain.load(node, load);
        }
        let mut model = chain.model();
        model.gravity = GRAVITY;
        let settings = TransientSettings::new(0.4, [4e-3, 2e-3, 1e-3][length]);
        let run = Run::of_any(model, &settings, usize::MAX);
        ended.set(ended.get() + usize::from(run.outcome.failure.is_none()));
        match gain(&run.outcome) {
            None => Ok(()),
            Some(gain) => Err(TestCaseError::fail(gain)),
        }
    });
    outcome.unwrap_or_else(|failure| panic!("{failure}"));
    let all = cases(2 * CASES);
    println!("{} of {all} ran to their end", ended.get());
    assert!(2 * ended.get() > all, "{}", ended.get());
}

fn observed_in_time(run: &Run, turn: &Matrix3<f64>) -> Vec<Observed> {
    let observed = run.instants.iter().map(|(time, state)| {
        let conditions = run.model.conditions_at(*time);
        Observed::of(&run.model.system.observe(state, &conditions), turn)
    });
    observed.collect()
}

/// Differences of strains and forces; of the change of momentum from the impulse of the weight,
/// relative to all momenta, zero for held mechanisms.
fn errors_in_time(recipe: &Recipe, moved: &Rigid) -> [f64; 3] {
    // Held mechanisms do not fly; for masses off their nodes see below.
    let moved = if recipe.is_held || !recipe.is_centered {
        Rigid {
            velocity: Vector3::zeros(),
            ..*moved
        }
    } else {
        *moved
    };
    let (plain, _) = in_time(recipe, &Rigid::NONE, 0.01);
    let (other, mass) = in_time(recipe, &moved, 0.01);
    let [strains, forces] = Observed::apart(
        &observed_in_time(&plain, &Matrix3::identity()),
        &observed_in_time(&other, &moved.turn),
    );
    let weight = mass * (moved.turn * GRAVITY);
    let start = momenta(&other.instants[0].1)[0];
    let size = start.norm() + 0.05 * weight.norm();
    let off = other.instants.iter().map(|(time, state)| {
        let grown = momenta(state)[0] - start;
        (grown - *time * weight).norm() / size
    });
    let off = off.fold(0.0, |a: f64, b| if b <= a { a } else { b });
    [strains, forces, if recipe.is_held { 0.0 } else { off }]
}

/// Equilibrium under follower loads with a root that moves while they grow; the rod has no initial
/// strain, because its tension may buckle the chain.
fn at_rest(recipe: &Recipe, displacement: &Vector3<f64>, rotation: &Vector3<f64>) -> Observed {
    let recipe = Recipe {
        is_held: false,
        relaxed: 1.0,
        ..recipe.clone()
    };
    let parts = recipe.parts(&Matrix3::identity(), &Vector3::zeros());
    let mut chain = parts.chain;
    let motion = ImposedMotion {
        displacement: [0, 1, 2].map(|i| Some(displacement[i])),
        rotation: [0, 1, 2].map(|i| Some(rotation[i])),
        axes: Matrix3::identity(),
        factor: LoadFactor::Proportional,
    };
    chain.impose(0, motion);
    for (i, &node) in parts.ends.iter().enumerate() {
        let load = NodalForce {
            force: Vector3::new(0.3, -0.4, 0.5 - 0.3 * i as f64),
            moment: Vector3::new(0.05, 0.02 * i as f64, -0.04),
            offset: Vector3::new(0.02, -0.05, 0.03),
            turning: Turning::Follower,
            factor: LoadFactor::Proportional,
        };
        chain.load(node, load);
    }
    let step = chain.last();
    let turn = *Rotation3::new(*rotation).matrix();
    let seen = Observations {
        sections: step.sections,
        reactions: step.reactions,
        ..Observations::default()
    };
    Observed::of(&seen, &turn)
}

fn errors_at_rest(recipe: &Recipe, moved: &Rigid) -> [f64; 3] {
    let rotation = Rotation3::from_matrix_unchecked(moved.turn).scaled_axis();
    let zero = Vector3::zeros();
    let plain = at_rest(recipe, &zero, &zero);
    let other = at_rest(recipe, &moved.shift, &rotation);
    let [strains, forces] = Observed::apart(&[plain], &[other]);
    [strains, forces, 0.0]
}

/// Draws mechanisms and motions; the largest errors.
fn check(name: &str, property: impl Fn(&Recipe, &Rigid) -> [f64; 3], limits: [f64; 3]) -> [f64; 3] {
    let config = Config {
        cases: cases(CASES) as u32,
        failure_persistence: None,
        max_shrink_iters: 50,
        ..Config::default()
    };
    let seed = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    let worst = Cell::new([0.0_f64; 3]);
    let mut runner = TestRunner::new_with_rng(config, seed);
    let outcome = runner.run(&(recipes(), rigid_motions()), |(recipe, moved)| {
        let errors = property(&recipe, &moved);
        let before = worst.get();
        worst.set(std::array::from_fn(|i| before[i].max(errors[i])));
        if errors
            .iter()
            .zip(limits)
            .all(|(error, limit)| *error < limit)
        {
            Ok(())
        } else {
            Err(TestCaseError::fail(format!("{name}: {errors:?}")))
        }
    });
    outcome.unwrap_or_else(|failure| panic!("{failure}"));
    worst.get()
}

#[test]
fn a_superposed_motion_changes_nothing_in_time() {
    let limits = [TOLERANCE, TOLERANCE, 1e-10];
    let [strains, forces, momentum] = check("in time", errors_in_time, limits);
    let case = format!("{} random mechanisms in time", cases(CASES));
    record::largest(SOURCE, &case, "strains, of the largest", strains, TOLERANCE);
    record::largest(SOURCE, &case, "forces, of the largest", forces, TOLERANCE);
    let quantity = "momentum less the impulse of the weight, relative";
    record::largest("balance of momentum", &case, quantity, momentum, 1e-10);
}

#[test]
fn a_superposed_motion_changes_nothing_at_rest() {
    let limits = [TOLERANCE, TOLERANCE, TOLERANCE];
    let [strains, forces, _] = check("at rest", errors_at_rest, limits);
    let case = format!("{} random mechanisms at rest", cases(CASES));
    record::largest(SOURCE, &case, "strains, of the largest", strains, TOLERANCE);
    record::largest(
        SOURCE,
        &case,
        "reactions, of the largest",
        forces,
        TOLERANCE,
    );
}

/// The angular momentum of a body about its node contains, if the center is off the node, the
/// moment of the momentum of a uniform velocity, which turns with the body: the scheme integrates
/// it with its own error, so that a uniform velocity has an effect of the order of the square of
/// the step.
#[test]
fn a_uniform_velocity_shows_with_the_square_of_the_step() {
    let link = |is_beam| Link {
        is_beam,
        length: 0.7,
        turn: Vector3::new(0.3, -0.5, 0.8),
        kind: 1,
        axes: Vector3::new(-0.4, 0.9, 0.2),
        held: 0,
    };
    let recipe = Recipe {
        links: [false, true, false].map(link).to_vec(),
        is_held: false,
        is_centered: false,
        spin: Vector3::new(1.0, -2.0, 3.0),
        relaxed: 0.8,
    };
    let flying = Rigid {
        velocity: Vector3::new(4.0, -2.0, 3.0),
        ..Rigid::NONE
    };
    let last = |moved: &Rigid, step: f64| {
        let (run, _) = in_time(&recipe, moved, step);
        observed_in_time(&run, &Matrix3::identity()).pop().unwrap()
    };
    let differences = [0.005, 0.0025, 0.00125].map(|step| {
        let all = [Rigid::NONE, flying].map(|moved| last(&moved, step));
        let [strains, forces] = Observed::apart(&all[..1], &all[1..]);
        strains.max(forces)
    });
    let [_, coarse, fine] = differences;
    let order = (coarse / fine).log2();
    let case = "free mechanism with masses off the nodes";
    record::order(SOURCE, case, "influence of a uniform velocity", order, 1.8);
    assert!(order > 1.8 && fine < 1e-3, "{differences:?}");
}
