//! Control laws between sensors and loads: an inverted pendulum.
//!
//! With J the moment of inertia about the joint, the law `u = C(s) q` of the tilt q with
//! `C = ( (p T + d) s + p ) / ( T s + 1 )` in observer form, and small angles,
//!
//! ```text
//! J q'' = m g l q - u ,    u = x + ( p + d / T ) q ,    x' = -( x + d / T q ) / T
//! ```

use beam_dynamics::model::State;
use nalgebra::{Complex, Matrix3, Matrix4, Vector3};

use crate::case_files::{Case, table};
use crate::in_time::Run;
use crate::record;

const CASE: &str = "inverted_pendulum";
const FILE: &str = "torque.dynamics.toml";
const SOURCE: &str = "inverted pendulum, linear equations";

const J: f64 = 1.1;
const WEIGHT: f64 = 9.81;
const P: f64 = 37.31;
const D: f64 = 7.7;
const T: f64 = 0.01;

/// Rates of q, q' and x, independently.
fn closed_loop() -> Matrix3<f64> {
    let direct = P + D / T;
    Matrix3::new(
        0.0,
        1.0,
        0.0,
        (WEIGHT - direct) / J,
        0.0,
        -1.0 / J,
        -D / (T * T),
        0.0,
        -1.0 / T,
    )
}

fn tilt(state: &State) -> f64 {
    let axis = state.nodes[0].rotation.column(2).into_owned();
    axis.x.atan2(axis.z)
}

/// Rates of q, q', a and a' of the pendulum on an arm, for small angles: `a'' = w^2 (u - a) -
/// 2 z w a'` and `J q'' = m g l q - m l L a''`, with the command u.
fn on_an_arm() -> Matrix4<f64> {
    let (w, z, lever) = (30.0, 0.7, 0.5);
    let command = [0.8018, 0.2505, 1.0934, 0.1339];
    let mut arm = command.map(|gain| w * w * gain);
    arm[2] -= w * w;
    arm[3] -= 2.0 * z * w;
    let mut tilt = arm.map(|of| -lever / J * of);
    tilt[0] += WEIGHT / J;
    let rows = [[0.0, 1.0, 0.0, 0.0], tilt, [0.0, 0.0, 0.0, 1.0], arm];
    Matrix4::from_fn(|i, j| rows[i][j])
}

/// The case with a push by `rate` \[rad/s\].
fn pushed(rate: f64) -> Case {
    let case = Case::new(CASE);
    case.replace(
        FILE,
        "velocity = [3, 0, 0]",
        &format!("velocity = [{rate}, 0, 0]"),
    );
    case.replace(FILE, "\"3 rad/s\"", &format!("\"{rate} rad/s\""));
    case
}

/// Frequency \[Hz\] and damping ratio of every mode of a file at rest, against the poles of
/// positive frequency.
fn check_poles(file: &str, exact: &[Complex<f64>]) {
    let found = table(&Case::new(CASE).path(file));
    let mut pairs: Vec<_> = exact.iter().filter(|pole| pole.im > 0.0).collect();
    pairs.sort_by(|a, b| a.im.total_cmp(&b.im));
    assert_eq!(found.branches.len(), pairs.len());
    for (branch, pole) in found.branches.iter().zip(pairs) {
        let point = branch.points[0].as_ref().unwrap();
        let exact = [pole.im / std::f64::consts::TAU, -pole.re / pole.norm()];
        let reported = [point.frequency, point.damping_ratio];
        let quantities = ["frequency [Hz]", "damping ratio"].into_iter();
        for (quantity, (found, exact)) in quantities.zip(reported.into_iter().zip(exact)) {
            let error = (found / exact - 1.0).abs();
            record::value(SOURCE, file, quantity, [found, exact], error, 1e-9);
            assert!(error < 1e-9, "{file} {quantity}: {found} {exact}");
        }
    }
}

// With a torque the third pole is real and no oscillation; with an angle there are two pairs.
#[test]
fn poles_are_those_of_the_linear_equations() {
    check_poles(FILE, closed_loop().complex_eigenvalues().as_slice());
    let exact = on_an_arm().complex_eigenvalues();
    check_poles("angle.dynamics.toml", exact.as_slice());
}

// Seven degrees at most, and upright at the end; with a fixed arm it falls.
#[test]
fn a_driven_angle_holds_the_pendulum_upright() {
    let last = |case: &Case| {
        let run = Run::of_file(&case.path("angle.dynamics.toml"), 1, |_| ());
        assert!(run.outcome.failure.is_none(), "{:?}", run.outcome.failure);
        let tilts = run.instants.iter().map(|(_, state)| {
            let axis = state.nodes[1].rotation.column(2).into_owned();
            axis.x.atan2(axis.z).abs()
        });
        tilts.collect::<Vec<_>>()
    };
    let held = last(&Case::new(CASE));
    assert!(held.iter().all(|tilt| *tilt < 0.12) && held[held.len() - 1] < 0.005);
    let free = Case::new(CASE);
    free.replace("angle.dynamics.toml", "angle = \"arm_angle\"", "angle = 0");
    assert!(last(&free).iter().any(|tilt| *tilt > 3.0));
}

// A push of 1e-4 rad/s: the error of linearized sines is 1e-10 of the angle. The error of steps of
// 0.5 ms is the square of the step times the fast pole, 1e2/s: 1e-3 of this part of the motion.
#[test]
fn the_motion_is_that_of_the_linear_equations() {
    let case = pushed(1e-4);
    let run = Run::of_file(&case.path(FILE), 1, |settings| {
        settings.stepping = beam_dynamics::integrator::Stepping::Constant { step: 5e-4 };
    });
    assert!(run.outcome.failure.is_none(), "{:?}", run.outcome.failure);
    let start = Vector3::new(0.0, 1e-4, 0.0);
    let largest = run.instants.iter().map(|(time, state)| {
        let exact = ((closed_loop() * *time).exp() * start).x;
        (tilt(state) - exact).abs()
    });
    let largest = largest.fold(0.0, f64::max) / 1.4e-5;
    record::largest(SOURCE, "motion", "tilt, by its largest", largest, 2e-3);
    assert!(largest < 2e-3, "{largest:e}");
    let last = &run.instants.last().unwrap().1;
    assert!(tilt(last).abs() < 1e-7, "{}", tilt(last));
}

// Large angles, variable steps: it comes to rest upright, and without the law it falls.
#[test]
fn the_law_holds_the_pendulum_upright() {
    let run = Run::of_file(&Case::new(CASE).path(FILE), 1, |_| ());
    assert!(run.outcome.failure.is_none(), "{:?}", run.outcome.failure);
    let most = run.instants.iter().map(|(_, state)| tilt(state).abs());
    assert!(most.fold(0.0, f64::max) > 0.2);
    let (time, last) = run.instants.last().unwrap();
    assert!(
        (time - 2.0).abs() < 1e-12 && tilt(last).abs() < 1e-3,
        "{}",
        tilt(last)
    );
    let free = Case::new(CASE);
    free.replace(FILE, "\"= torque\"", "0");
    let run = Run::of_file(&free.path(FILE), 1, |_| ());
    let turned = run.instants.iter().map(|(_, state)| tilt(state).abs());
    assert!(turned.fold(0.0, f64::max) > 3.0);
}

// Matrices in the card and in a file, and a card for the single entry: equal to round-off.
#[test]
fn all_ways_to_write_the_law_are_one() {
    let written = "numerator = [\"= proportional*lag + derivative\", \"= proportional\"]\n\
                   denominator = [\"= lag\", 1]\n";
    let matrices = format!(
        "a = [[{}]]\nb = [[{}]]\nc = [[1]]\nd = [[{}]]\n",
        -1.0 / T,
        -D / (T * T),
        P + D / T
    );
    let transfer = format!("[[state_space.transfer]]\noutput = \"torque\"\ninput = 1\n{written}");
    let at_end = |text: &str| {
        let case = Case::new(CASE);
        case.replace(FILE, written, text);
        std::fs::write(case.path("law.toml"), &matrices).unwrap();
        let run = Run::of_file(&case.path(FILE), 1, |_| ());
        assert!(run.outcome.failure.is_none(), "{:?}", run.outcome.failure);
        tilt(&run.instants.last().unwrap().1)
    };
    let expected = at_end(written);
    for text in [&matrices[..], "file = \"law.toml\"\n", &transfer] {
        let found = at_end(text);
        // Steps of a tolerance of 1e-6 may differ by their last digits.
        assert!(
            (found - expected).abs() < 1e-8,
            "{text}: {found} {expected}"
        );
    }
}
