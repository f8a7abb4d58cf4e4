//! Free bodies and beams, in `cases/dynamics/free_body` and `cases/dynamics/flying_beam`: conserved
//! quantities are conserved.

use beam_dynamics::integrator::{Scheme, Stepping};

use nalgebra::Vector3;

use crate::case_files::Case;
use crate::in_time::{Run, Table, momenta};
use crate::record;

const BALANCE: &str = "balance of momentum";

/// Schemes that must conserve momenta.
const SCHEMES: [(&str, Scheme); 4] = [
    ("two steps, radius 0.6", Scheme::TwoStep { radius: 0.6 }),
    ("Crank-Nicolson", Scheme::CrankNicolson),
    ("Radau IIA", Scheme::Parabolic { zeta: -2.0 / 3.0 }),
    ("cubic, radius 0.6", Scheme::Cubic { radius: 0.6 }),
];

fn body(scheme: Scheme, step: f64) -> Run {
    Run::new("free_body", "free_body.dynamics.toml", 1, |settings| {
        settings.scheme = scheme;
        settings.stepping = Stepping::Constant { step };
    })
}

/// The momentum of a node is an unknown of its own and its rate is zero; the angular momentum about
/// the origin is linear in the unknowns once the momentum is constant: every scheme conserves both
/// to round-off, for any error of the motion.
#[test]
fn a_free_body_keeps_its_momenta() {
    for (name, scheme) in SCHEMES {
        let run = body(scheme, 0.02);
        let start = momenta(&run.instants[0].1);
        for (number, quantity) in ["momentum", "angular momentum"].iter().enumerate() {
            let size = start[number].norm();
            let changes = run
                .instants
                .iter()
                .map(|(_, state)| (momenta(state)[number] - start[number]).norm() / size);
            let change = changes.fold(0.0, f64::max);
            let case = format!("free body, {name}");
            record::largest(
                BALANCE,
                &case,
                &format!("{quantity}, relative"),
                change,
                1e-10,
            );
            assert!(change < 1e-10, "{case}: {quantity} {change:e}");
        }
    }
}

/// Largest error of position and angular velocity, and the largest change of the energy.
fn body_errors(step: f64) -> [f64; 3] {
    let run = body(Scheme::default(), step);
    let table = Table::new("free_body.csv");
    let mut errors = [0.0_f64; 3];
    for row in &table.rows {
        let motion = run.motion("body", row[0]);
        let position = (motion.position - table.vector(row, "x")).norm();
        let turning = (motion.angular_velocity - table.vector(row, "omega_x")).norm();
        errors[0] = errors[0].max(position);
        errors[1] = errors[1].max(turning);
    }
    let energy = |number: usize| {
        let (time, state) = &run.instants[number];
        run.energy(state, *time).kinetic
    };
    let changes = (0..run.instants.len()).map(|n| (energy(n) / energy(0) - 1.0).abs());
    errors[2] = changes.fold(0.0, f64::max);
    errors
}

/// Position, angular velocity and energy at second order, against Euler's equations.
#[test]
fn a_free_body_tumbles_as_euler_says() {
    let [coarse, fine] = [0.01, 0.005].map(body_errors);
    for (number, quantity) in ["position", "angular velocity", "energy"]
        .iter()
        .enumerate()
    {
        let order = (coarse[number] / fine[number]).log2();
        record::order("Euler's equations", "free body", quantity, order, 1.9);
        assert!(
            order > 1.9,
            "{quantity}: {:e} {:e}",
            coarse[number],
            fine[number]
        );
    }
    // Four turns at 10 ms: an error of a thousandth of a turn.
    let source = "Euler's equations";
    record::largest(
        source,
        "free body",
        "position to 10 s, step 5 ms [m]",
        fine[0],
        2e-3,
    );
    assert!(fine[0] < 2e-3, "{:e}", fine[0]);
}

/// The momentum after the push is its impulse, 8 N for 2.5 s along x: lines are integrated without
/// error, and at the kinks between them the error of two steps is a part of `slope h^2`, 4e-3 N s.
/// From the next half second on it does not change at all.
#[test]
fn a_flying_beam_gets_the_impulse_of_its_push() {
    let run = Run::new("flying_beam", "flying_beam.dynamics.toml", 10, |settings| {
        settings.stepping = Stepping::Constant { step: 0.025 };
    });
    let momentum = |time: f64| momenta(run.at(time))[0];
    let impulse = Vector3::new(20.0, 0.0, 0.0);
    let error = (momentum(5.5) - impulse).norm() / 20.0;
    let case = "flying beam";
    record::largest(BALANCE, case, "impulse, step 25 ms", error, 1e-5);
    assert!(error < 1e-5, "{}", momentum(5.5));
    let later = run.instants.iter().filter(|(time, _)| *time > 5.5);
    let changes = later.map(|(_, state)| (momenta(state)[0] - momentum(5.5)).norm() / 20.0);
    let change = changes.fold(0.0, f64::max);
    record::largest(BALANCE, case, "momentum in free flight", change, 1e-10);
    assert!(change < 1e-10, "{change:e}");
}

/// The push without kinks, which would cause waves faster than the steps resolve.
const SMOOTH: &str = r#"kind = "sum"
terms = [
  { kind = "ramp", to = 1, start = 0, end = 2.5, shape = "smooth" },
  { kind = "ramp", to = -1, start = 2.5, end = 5, shape = "smooth" },
]"#;

/// Changes of energy and angular momentum from 5 to 6.5 s, relative.
fn drift(step: f64) -> [f64; 2] {
    let case = Case::new("flying_beam");
    let file = "flying_beam.dynamics.toml";
    let text = std::fs::read_to_string(case.path(file)).unwrap();
    let push = text.split("[drives.push]\n").nth(1).unwrap();
    let push = push.split("\n\n").next().unwrap();
    case.replace(file, push, SMOOTH);
    let run = Run::of_file(&case.path(file), 1, |settings| {
        settings.to = 6.5;
        settings.stepping = Stepping::Constant { step };
    });
    run.check_end();
    let measured = |time: f64| {
        let state = run.at(time);
        let energy = run.energy(state, time);
        (energy.kinetic + energy.elastic, momenta(state)[1])
    };
    let (before, after) = (measured(5.0), measured(6.5));
    let turning = (after.1 - before.1).norm() / before.1.norm();
    [after.0 / before.0 - 1.0, turning]
}

/// In free flight the steps change both at second order. Angular momentum is conserved by the
/// elements themselves; energy by their forces up to the discretization error of eight elements, a
/// part of 1e-6, which cancels in the differences between steps.
#[test]
fn a_flying_beam_keeps_energy_and_angular_momentum() {
    let [coarse, middle, fine] = [0.02, 0.01, 0.005].map(drift);
    let source = "free flight";
    let energy = (coarse[0] - middle[0]) / (middle[0] - fine[0]);
    for (quantity, ratio) in [
        ("energy", energy.abs()),
        ("angular momentum", middle[1] / fine[1]),
    ] {
        let order = ratio.log2();
        record::order(source, "flying beam", quantity, order, 1.9);
        assert!(order > 1.9, "{quantity}: {coarse:?} {middle:?} {fine:?}");
    }
    for (quantity, change) in ["energy", "angular momentum"].into_iter().zip(fine) {
        let quantity = format!("{quantity} from 5 to 6.5 s, step 5 ms");
        record::largest(source, "flying beam", &quantity, change.abs(), 5e-6);
        assert!(change.abs() < 5e-6, "{quantity}: {change:e}");
    }
}
