//! Lengths of steps, corners, failures, kept Jacobians and restarts.

use beam_dynamics::integrator::{
    Integrator, Jacobians, Reason, Scheme, StepControl, StepFailure, StepLimits, Stepping,
};
use nalgebra::DMatrix;

use super::system::{Bathe, Equations, Linear, Pendulum, System};
use super::{no_clock, run, tight};

const RADAU: Scheme = Scheme::Parabolic { zeta: -2.0 / 3.0 };
const TWO_STEP: Scheme = Scheme::TwoStep { radius: 0.6 };
const CUBIC: Scheme = Scheme::Cubic { radius: 0.6 };

fn variable(tolerance: f64) -> Stepping {
    Stepping::Variable(StepControl {
        first: 1e-4,
        least: 1e-9,
        most: 1.0,
        tolerance,
    })
}

fn new<E: Equations>(system: &System<E>, scheme: Scheme, stepping: Stepping) -> Integrator {
    Integrator::new(system, scheme, stepping, tight(), 0.0)
}

/// Times of all steps to `until`, and the integrator.
fn times<E: Equations>(
    system: &mut System<E>,
    mut integrator: Integrator,
    until: f64,
) -> (Vec<f64>, Integrator) {
    let mut times = Vec::new();
    while integrator.time() < until {
        let stepped = integrator.step(system, until, &no_clock).unwrap();
        assert_eq!(stepped.time, integrator.time());
        times.push(stepped.time);
    }
    (times, integrator)
}

fn swing() -> System<Bathe> {
    let pendulum = Bathe {
        length: 1.0,
        mass: 1.0,
        gravity: 9.8,
        stiffness: 100.0,
    };
    System::new(pendulum, &[0.0; 4], &[0.0, 0.0, 9.8, 0.0])
}

/// Constant steps are counted: the time is n times the step, not a sum.
#[test]
fn constant_steps_are_counted_and_end_where_they_must() {
    let mut system = swing();
    let integrator = new(&system, TWO_STEP, Stepping::Constant { step: 0.001 });
    let (found, integrator) = times(&mut system, integrator, 0.9995);
    assert_eq!(found.len(), 1000);
    for (i, time) in found.iter().take(999).enumerate() {
        assert_eq!(*time, (i + 1) as f64 * 0.001);
    }
    assert_eq!(found[999], 0.9995);
    assert_eq!(integrator.counters().steps, 1000);
    // The grid continues from there.
    let (later, _) = times(&mut system, integrator, 1.1);
    assert_eq!(later[..2], [1.0, 1001.0 * 0.001]);
    assert_eq!(later.last(), Some(&1.1));
    assert_eq!(later.len(), 101);
}

/// No step ends at or before the present time.
#[test]
fn nothing_happens_when_the_end_is_reached() {
    let mut system = swing();
    let mut integrator = new(&system, TWO_STEP, Stepping::Constant { step: 0.1 });
    for until in [0.0, -1.0, f64::NAN] {
        let stepped = integrator.step(&mut system, until, &no_clock).unwrap();
        assert_eq!((stepped.length, stepped.iterations), (0.0, 0));
    }
    assert_eq!(system.latest, swing().latest);
}

/// The error at the end follows the tolerance: of a method of order p the local error is h^(p+1),
/// the error at the end h^p, so that a tolerance of 1/100 makes it 100^(p/(p+1)) times smaller, or,
/// where the local error is less than its estimate, as sometimes for Radau IIA, up to 100 times
/// smaller. The step length is kept while the wished length is within a tenth of it: p ln 1.1 / ln
/// 100 of the exponent. At 1e-6 the cubic scheme takes 30 steps, the first of which are short
/// because there are no previous ones; the exponent is for many steps.
#[test]
fn variable_steps_keep_the_local_error() {
    let exact = [0.134_994_926_127_77, 0.990_846_289_754_25];
    for (scheme, order) in [
        (Scheme::ImplicitEuler, 1.0),
        (Scheme::Bdf2, 2.0),
        (TWO_STEP, 2.0),
        (CUBIC, 3.0),
        (RADAU, 3.0),
    ] {
        let at = |tolerance: f64| {
            let mut system = Pendulum::consistent();
            let integrator = new(&system, scheme, variable(tolerance));
            let (times, _) = times(&mut system, integrator, 1.0);
            let y = &system.latest.y;
            let error = (y[0] - exact[0]).hypot(y[1] - exact[1]);
            (error, times.len())
        };
        let ((coarse, few), (fine, many)) = (at(1e-7), at(1e-9));
        let slope = (coarse / fine).ln() / 100.0_f64.ln();
        let expected = order / (order + 1.0);
        let kept = order * 1.1_f64.ln() / 100.0_f64.ln();
        assert!(
            slope > expected - kept && slope < 1.0 + kept,
            "{scheme:?} {slope} {expected} {coarse:e}"
        );
        assert!(few < many, "{scheme:?} {few} {many}");
        // The tolerance is for each coordinate, the error of the position is root 2 times it; the
        // error of the velocity is this times the rate of the motion, at most 2/s, for at most a
        // second.
        let sum = 2.0_f64.sqrt() * 3.0 * many as f64 * 1e-9;
        assert!(fine < sum, "{scheme:?} {fine:e} {many}");
    }
}

/// The order with steps that change in every step: lengths in a fixed pattern of ratios 0.8 and
/// 1.25, scaled by 1, 1/2, 1/4, through `until`.
#[test]
fn the_order_is_kept_on_variable_steps() {
    let exact = (-0.5_f64).exp() * 3.0_f64.cos();
    for (scheme, order) in [
        (Scheme::Bdf2, 2.0),
        (TWO_STEP, 2.0),
        (Scheme::TwoStep { radius: 0.9 }, 2.0),
        (CUBIC, 3.0),
    ] {
        let error = |scale: f64| {
            let lambda = [-0.5, 3.0];
            let mut system = System::new(Linear { lambda }, &[1.0, 0.0], &lambda);
            let stepping = Stepping::Constant { step: 10.0 };
            let mut integrator = new(&system, scheme, stepping);
            let (mut time, mut length, mut growing) = (0.0, 0.02 * scale, true);
            while integrator.time() < 1.0 {
                time = f64::min(1.0, time + length);
                integrator.step(&mut system, time, &no_clock).unwrap();
                growing = if growing {
                    length < 0.04 * scale
                } else {
                    length < 0.025 * scale
                };
                length *= if growing { 1.25 } else { 0.8 };
            }
            (system.latest.y[0] - exact).abs()
        };
        let order_found = (error(0.5) / error(0.25)).log2();
        assert!(order_found > order - 0.2, "{scheme:?} {order_found}");
    }
}

/// `y'' = f`, f jumping from 1 to -2 at t = 0.30001.
#[derive(Debug)]
struct Jump {
    renews: bool,
}

const CORNER: f64 = 0.30001;

impl Jump {
    fn force(time: f64) -> f64 {
        if time < CORNER { 1.0 } else { -2.0 }
    }

    fn system(renews: bool) -> System<Self> {
        System::new(Self { renews }, &[0.0; 2], &[0.0, 1.0])
    }
}

impl Equations for Jump {
    const ALGEBRAIC: &'static [bool] = &[false; 2];
    const POSITIONS: &'static [usize] = &[0];

    fn terms(&self, time: f64, y: &[f64], rates: &[f64]) -> Vec<Vec<f64>> {
        vec![vec![rates[0], -y[1]], vec![rates[1], -Self::force(time)]]
    }

    fn derivatives(&self, _time: f64, _y: &[f64], _rates: &[f64]) -> [DMatrix<f64>; 2] {
        let by_y = DMatrix::from_row_slice(2, 2, &[0.0, -1.0, 0.0, 0.0]);
        [by_y, DMatrix::identity(2, 2)]
    }

    fn next_corner(&self, time: f64) -> f64 {
        if time < CORNER { CORNER } else { f64::INFINITY }
    }

    fn renew(&self, time: f64, _y: &mut [f64], rates: &mut [f64]) -> bool {
        if self.renews {
            rates[1] = Self::force(time);
        }
        self.renews
    }
}

/// The velocity after the jump is piecewise linear: a scheme of second order that steps over no
/// jump, and has the rates on both sides, is exact to round-off.
#[test]
fn corners_are_landed_on_and_jumps_lose_no_order() {
    let exact = CORNER - 2.0 * (1.0 - CORNER);
    for stepping in [Stepping::Constant { step: 0.01 }, variable(1e-4)] {
        for scheme in [TWO_STEP, Scheme::Bdf2, Scheme::CrankNicolson, CUBIC, RADAU] {
            for renews in [true, false] {
                let mut system = Jump::system(renews);
                let integrator = new(&system, scheme, stepping);
                let (times, _) = times(&mut system, integrator, 1.0);
                assert!(times.contains(&CORNER), "{scheme:?}");
                // Implicit Euler, the step without rates, is exact here too.
                let error = (system.latest.y[1] - exact).abs();
                assert!(error < 1e-13, "{scheme:?} {renews} {error:e}");
            }
        }
    }
}

/// Momenta of a heavy body under a large force that changes all the time, and of a light
/// one on which a force of 1 N begins to act at the corner.
#[derive(Debug)]
struct Beside;

impl Beside {
    fn rates(time: f64, momentum: f64) -> [f64; 3] {
        let on_light = if time < CORNER { 0.0 } else { 1.0 };
        [1e-3 * momentum, 1e5 * (10.0 * time).cos(), on_light]
    }
}

impl Equations for Beside {
    const ALGEBRAIC: &'static [bool] = &[false; 3];
    const POSITIONS: &'static [usize] = &[0];

    fn terms(&self, time: f64, y: &[f64], rates: &[f64]) -> Vec<Vec<f64>> {
        let given = Self::rates(time, y[1]);
        (0..3).map(|i| vec![rates[i], -given[i]]).collect()
    }

    fn derivatives(&self, _time: f64, _y: &[f64], _rates: &[f64]) -> [DMatrix<f64>; 2] {
        let mut by_y = DMatrix::zeros(3, 3);
        by_y[(0, 1)] = -1e-3;
        [by_y, DMatrix::identity(3, 3)]
    }

    fn next_corner(&self, time: f64) -> f64 {
        if time < CORNER { CORNER } else { f64::INFINITY }
    }

    fn renew(&self, time: f64, y: &mut [f64], rates: &mut [f64]) -> bool {
        rates.copy_from_slice(&Self::rates(time, y[1]));
        true
    }
}

/// The momentum of the light body is piecewise linear, so that a scheme that detects the jump is
/// exact to the round-off of a hundred steps; otherwise the error is a part of a step.
#[test]
fn a_small_jump_is_seen_beside_a_large_force() {
    for scheme in [TWO_STEP, Scheme::Bdf2] {
        let mut system = System::new(Beside, &[0.0; 3], &Beside::rates(0.0, 0.0));
        let integrator = new(&system, scheme, Stepping::Constant { step: 0.01 });
        times(&mut system, integrator, 1.0);
        let error = (system.latest.y[2] - (1.0 - CORNER)).abs();
        assert!(error < 1e-12, "{scheme:?} {error:e}");
    }
}

/// `y'' = -w^2 y + f` with a force f that has a kink every 0.01 s, and no jump.
#[derive(Debug)]
struct Kinks;

const STIFF: f64 = 1e4;
const EVERY: f64 = 0.01;

impl Kinks {
    fn force(time: f64) -> f64 {
        let part = (time / EVERY).rem_euclid(2.0);
        part.min(2.0 - part)
    }
}

impl Equations for Kinks {
    const ALGEBRAIC: &'static [bool] = &[false; 2];
    const POSITIONS: &'static [usize] = &[0];

    fn terms(&self, time: f64, y: &[f64], rates: &[f64]) -> Vec<Vec<f64>> {
        let spring = STIFF * STIFF * y[0];
        vec![
            vec![rates[0], -y[1]],
            vec![rates[1], spring, -Self::force(time)],
        ]
    }

    fn derivatives(&self, _time: f64, _y: &[f64], _rates: &[f64]) -> [DMatrix<f64>; 2] {
        let by_y = DMatrix::from_row_slice(2, 2, &[0.0, -1.0, STIFF * STIFF, 0.0]);
        [by_y, DMatrix::identity(2, 2)]
    }

    fn next_corner(&self, time: f64) -> f64 {
        ((time / EVERY + 1e-6).floor() + 1.0) * EVERY
    }

    fn renew(&self, time: f64, y: &mut [f64], rates: &mut [f64]) -> bool {
        rates[1] = Self::force(time) - STIFF * STIFF * y[0];
        true
    }
}

/// Steps from kink to kink use the scheme itself, not Crank-Nicolson's first steps: each damps the
/// stiff motion by the radius, 0.6. At w h = 100 the radius is within 1e-2 of its limit; after 40
/// steps less than 0.62^40 of the start remains, and the response to the force, about 1 / w^2 at
/// most.
#[test]
fn kinks_of_a_force_do_not_stop_the_damping() {
    // Small: corrections beyond the size of the system are rejected.
    let start = 1e-7;
    let rate = -STIFF * STIFF * start;
    let mut system = System::new(Kinks, &[start, 0.0], &[0.0, rate]);
    let integrator = new(&system, TWO_STEP, Stepping::Constant { step: EVERY });
    let (found, _) = times(&mut system, integrator, 42.0 * EVERY);
    assert_eq!(found.len(), 42);
    let left = 40.0 * start * 0.62_f64.powi(40) + 1.1 / (STIFF * STIFF);
    assert!(system.latest.y[0].abs() < left, "{:e}", system.latest.y[0]);
}

/// Cubic Gauss restarts by Radau IIA of three stages; the following steps use the scheme itself.
#[test]
fn cubic_gauss_passes_a_jump() {
    let mut system = Jump::system(false);
    let integrator = new(
        &system,
        Scheme::CubicGauss,
        Stepping::Constant { step: 0.01 },
    );
    times(&mut system, integrator, 1.0);
    let exact = CORNER - 2.0 * (1.0 - CORNER);
    assert!((system.latest.y[1] - exact).abs() < 1e-13);
}

/// Modified Newton ends at the same states, with a tenth of the Jacobians at most.
#[test]
fn kept_jacobians_change_the_effort_and_not_the_answer() {
    for scheme in [TWO_STEP, CUBIC, RADAU] {
        let at = |jacobians: Jacobians| {
            let mut system = swing();
            let limits = StepLimits {
                jacobians,
                ..tight()
            };
            let stepping = Stepping::Constant { step: 0.002 };
            let integrator = Integrator::new(&system, scheme, stepping, limits, 0.0);
            let (_, integrator) = times(&mut system, integrator, 1.0);
            (system.latest.y, *integrator.counters())
        };
        let ((full, all), (modified, kept)) = (at(Jacobians::Full), at(Jacobians::Modified));
        for (full, modified) in full.iter().zip(&modified) {
            assert!(
                (full - modified).abs() < 1e-10,
                "{scheme:?} {full} {modified}"
            );
        }
        assert_eq!(all.jacobians, all.iterations);
        assert!(10 * kept.jacobians < all.jacobians, "{kept:?} {all:?}");
        assert!(kept.iterations < 4 * all.iterations, "{kept:?} {all:?}");
    }
}

/// A stiff rod whose residual has a floor of round-off far above the limit: the corrections are
/// small, so that the steps are accepted, with at most one more iteration.
#[test]
fn round_off_of_stiff_forces_does_not_stall_the_iteration() {
    let effort = |noise: f64| {
        let mut system = swing();
        system.equations.stiffness = 1e10;
        system.noise = noise;
        let stepping = Stepping::Constant { step: 0.01 };
        let limits = StepLimits::default();
        let integrator = Integrator::new(&system, TWO_STEP, stepping, limits, 0.0);
        let (_, integrator) = times(&mut system, integrator, 1.0);
        (system.latest.y[0], *integrator.counters())
    };
    let ((clean, without), (noisy, with)) = (effort(0.0), effort(1e-9));
    assert_eq!(with.rejected, 0);
    assert!(
        with.iterations <= without.iterations + 2 * with.steps,
        "{with:?}"
    );
    assert!((clean - noisy).abs() < 1e-6);
}

/// `y' = sqrt(0.5 - t)`, which ends at t = 0.5.
#[derive(Debug)]
struct Ending;

impl Equations for Ending {
    const ALGEBRAIC: &'static [bool] = &[false];
    const POSITIONS: &'static [usize] = &[0];

    fn terms(&self, time: f64, _y: &[f64], rates: &[f64]) -> Vec<Vec<f64>> {
        vec![vec![rates[0], -(0.5 - time).sqrt()]]
    }

    fn derivatives(&self, _time: f64, _y: &[f64], _rates: &[f64]) -> [DMatrix<f64>; 2] {
        [DMatrix::zeros(1, 1), DMatrix::identity(1, 1)]
    }
}

fn failure<E: Equations>(mut system: System<E>, stepping: Stepping) -> (System<E>, StepFailure) {
    let mut integrator = new(&system, TWO_STEP, stepping);
    loop {
        let before = system.latest.clone();
        if let Err(failure) = integrator.step(&mut system, 1.0, &no_clock) {
            assert_eq!(system.latest, before);
            return (system, failure);
        }
    }
}

/// The step is cut down to the least, then the failure states location, reason and remedies.
#[test]
fn a_step_that_underflows_reports_why() {
    for stepping in [Stepping::Constant { step: 0.03 }, variable(1e-3)] {
        let (_, failure) = failure(System::new(Ending, &[0.0], &[0.5_f64.sqrt()]), stepping);
        assert_eq!(failure.reason, Reason::NotFinite);
        assert!(0.49 < failure.time && failure.time <= 0.5, "{failure}");
        assert!(failure.length <= failure.least);
        assert_eq!(failure.equation.to_string(), "equation 0");
        assert!(!failure.reason.remedies().is_empty());
        let text = failure.to_string();
        assert!(text.contains("equation 0") && text.contains("not a finite number"));
    }
}

/// `y' + lambda = 0` with a constraint that no position fulfills: no other equation contains
/// `lambda`.
#[derive(Debug)]
struct Loose;

impl Equations for Loose {
    const ALGEBRAIC: &'static [bool] = &[false, true];
    const POSITIONS: &'static [usize] = &[0];

    fn terms(&self, _time: f64, y: &[f64], rates: &[f64]) -> Vec<Vec<f64>> {
        vec![vec![rates[0], -1.0], vec![y[0]]]
    }

    fn derivatives(&self, _time: f64, _y: &[f64], _rates: &[f64]) -> [DMatrix<f64>; 2] {
        let by_y = DMatrix::from_row_slice(2, 2, &[0.0, 0.0, 1.0, 0.0]);
        let by_rates = DMatrix::from_row_slice(2, 2, &[1.0, 0.0, 0.0, 0.0]);
        [by_y, by_rates]
    }
}

#[test]
fn a_multiplier_that_acts_on_nothing_is_singular() {
    let system = System::new(Loose, &[0.0, 0.0], &[1.0, 0.0]);
    let (_, failure) = failure(system, Stepping::Constant { step: 0.1 });
    assert_eq!(failure.reason, Reason::Singular);
}

/// A run that is stopped and continued from its snapshot, in a new integrator and system, has the
/// same final bits as the run that took the snapshot.
#[test]
fn a_restart_continues_bit_for_bit() {
    for scheme in [TWO_STEP, Scheme::Bdf2, CUBIC, RADAU] {
        for stepping in [Stepping::Constant { step: 0.003 }, variable(1e-5)] {
            let limits = StepLimits {
                jacobians: Jacobians::Modified,
                ..StepLimits::default()
            };
            let mut system = swing();
            let mut integrator = Integrator::new(&system, scheme, stepping, limits, 0.0);
            for _ in 0..40 {
                integrator.step(&mut system, 1.0, &no_clock).unwrap();
            }
            let text = serde_json::to_string(&integrator.snapshot()).unwrap();
            let mut other = swing();
            (other.latest, other.before) = (system.latest.clone(), system.before.clone());
            let mut again = Integrator::new(&other, scheme, stepping, limits, 0.0);
            again.restore(&serde_json::from_str(&text).unwrap());
            let (first, integrator) = times(&mut system, integrator, 1.0);
            let (second, again) = times(&mut other, again, 1.0);
            assert_eq!(first, second);
            assert_eq!(system.latest, other.latest);
            assert_eq!(integrator.counters(), again.counters());
        }
    }
}

/// The times of the phases are clock times: one tick per reading.
#[test]
fn phases_are_timed_by_the_clock_given() {
    let ticks = std::cell::Cell::new(0.0);
    let clock = || {
        ticks.set(ticks.get() + 1.0);
        ticks.get()
    };
    let mut system = swing();
    let mut integrator = new(&system, TWO_STEP, Stepping::Constant { step: 0.01 });
    integrator.step(&mut system, 1.0, &clock).unwrap();
    let counters = integrator.counters();
    assert_eq!(counters.jacobian_time, counters.jacobians as f64);
    assert_eq!(counters.factorization_time, counters.jacobians as f64);
    assert_eq!(counters.solution_time, counters.iterations as f64);
    assert!(counters.residual_time >= counters.iterations as f64);
}

/// Step lengths of a variable run: they grow from the first, never beyond the bound of
/// zero-stability from step to step, and stay below the largest.
#[test]
fn steps_grow_within_bounds() {
    for (scheme, most) in [
        (TWO_STEP, 1.5),
        (Scheme::TwoStep { radius: 0.9 }, 1.236),
        (CUBIC, 2.0),
    ] {
        let mut system = swing();
        let integrator = new(&system, scheme, variable(1e-4));
        let (found, integrator) = times(&mut system, integrator, 1.0);
        let lengths: Vec<_> = found.windows(2).map(|pair| pair[1] - pair[0]).collect();
        for pair in lengths.windows(2) {
            assert!(pair[1] < (most + 1e-6) * pair[0], "{scheme:?} {pair:?}");
        }
        assert!(integrator.counters().most_step > 50.0 * 1e-4, "{scheme:?}");
        // The same state as with constant steps, to the tolerance times the steps.
        let constant = run(swing(), scheme, 1e-3, 1.0);
        let difference = (constant[0] - system.latest.y[0]).abs();
        assert!(
            difference < 1e-4 * found.len() as f64,
            "{scheme:?} {difference:e}"
        );
    }
}
