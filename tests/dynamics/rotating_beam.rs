//! Uniform blade clamped at the axis of rotation.
//!
//! Source: `tests/reference/dynamics/rotating_beam_frequencies.csv`: a Ritz solution
//! with 16 polynomials of the Euler-Bernoulli beam, six digits; eta is the speed and
//! the columns are frequencies, both in units of sqrt(EI / (m L^4)).

use beam_dynamics::assembly::MasslessMotions;
use beam_dynamics::model::Conditions;
use beam_dynamics::modes::{EigenProblem, Lowest};
use beam_dynamics::solver::LinearSolver;

use crate::record;
use crate::uniform_beam::{Inertia, UniformBeam, frequencies};

// The names of the sources on the validation page.
const RITZ: &str = "Ritz solution with 16 polynomials, ten speeds";
const EXACT: &str = "Euler-Bernoulli beam and bar in torsion, closed forms";

/// Rows of the reference: eta, flap 1..3, lag 1..3.
fn reference() -> Vec<[f64; 7]> {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/tests/reference/dynamics/rotating_beam_frequencies.csv"
    );
    let mut rows = Vec::new();
    for record in csv::Reader::from_path(path).unwrap().records() {
        let numbers: Vec<f64> = record.unwrap().iter().map(|x| x.parse().unwrap()).collect();
        rows.push(numbers.try_into().unwrap());
    }
    assert_eq!(rows.len(), 10);
    rows
}

/// Largest relative error of mode `mode` (from 0) of flap and lag over all speeds.
fn errors(elements: usize, inertia: Inertia) -> [f64; 3] {
    let rows = reference();
    let speeds: Vec<_> = rows.iter().map(|row| row[0]).collect();
    let (model, settings) = UniformBeam::slender(elements, inertia).case(&speeds, 8);
    let outcome = beam_dynamics::analysis::modes::modes(&model, &settings);
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    let mut worst = [0.0_f64; 3];
    for (s, row) in rows.iter().enumerate() {
        for (first, word) in [(1, "flap"), (4, "lag")] {
            for mode in 0..3 {
                let name = format!("{word} {}", mode + 1);
                let branch = outcome
                    .table
                    .branches
                    .iter()
                    .find(|b| b.name == name)
                    .unwrap();
                let point = branch.points[s].as_ref().unwrap();
                let computed = 2.0 * std::f64::consts::PI * point.frequency;
                let error = (computed / row[first + mode] - 1.0).abs();
                worst[mode] = worst[mode].max(error);
            }
        }
    }
    worst
}

/// 8 elements over all ten speeds: of finite volumes 5e-3 in the third mode, of the default 1e-3;
/// the error of the lower modes falls as a power of the number of waves.
#[test]
fn eight_elements_meet_the_exact_frequencies() {
    for (inertia, tolerances) in [
        (Inertia::Portions, [5e-4, 2e-3, 5e-3]),
        (Inertia::Lumped, [2e-5, 1.5e-4, 1e-3]),
    ] {
        let found = errors(8, inertia);
        println!("{inertia:?} 8: {found:?}");
        let case = format!("8 elements, {inertia:?}").to_lowercase();
        for (mode, (error, tolerance)) in found.into_iter().zip(tolerances).enumerate() {
            let quantity = format!("flap {0} and lag {0}", mode + 1);
            record::largest(RITZ, &case, &quantity, error, tolerance);
            assert!(error < tolerance, "{case}, {quantity}: {error:e}");
        }
    }
}

/// Fourth order of both inertias. The third mode from 4 to 8 elements, where the error is well
/// above the six digits of the reference; a slope of 3.7 allows for the next term of the error. The
/// consistent one has twice the error of bodies.
#[test]
fn variational_beams_converge_with_fourth_order() {
    for (inertia, tolerance) in [(Inertia::Lumped, 1e-3), (Inertia::Consistent, 2e-3)] {
        let [.., coarse] = errors(4, inertia);
        let [.., fine] = errors(8, inertia);
        let slope = (coarse / fine).log2();
        println!("{inertia:?}: {coarse:e} {fine:e} slope {slope}");
        let case = format!("8 elements, {inertia:?}").to_lowercase();
        record::order(RITZ, &case, "mode 3, order", slope, 3.7);
        record::largest(RITZ, &case, "flap 3 and lag 3", fine, tolerance);
        assert!(slope > 3.7, "{coarse:e} {fine:e}: {slope}");
        assert!(fine < tolerance);
    }
}

/// Without rotation: 2, 4 and 8 elements; of finite volumes against `beam_static.json`, free
/// vibration, with order 2; others against `variational_beam`, with order 4, in the first mode.
#[test]
fn free_vibration_has_the_orders_two_and_four() {
    // Euler-Bernoulli, clamped-free: beta L = 1.8751040687 (any text on vibration).
    let exact = 1.875_104_068_711_961_f64.powi(2);
    let error = |elements, inertia| {
        let case = UniformBeam::slender(elements, inertia).case(&[0.0], 4);
        frequencies(&case, 0, "flap")[0] / exact - 1.0
    };
    for (inertia, order, reference) in [
        (Inertia::Portions, 2.0, [1.4e-3, 3.2e-4, 7.6e-5]),
        (Inertia::Lumped, 4.0, [8.7e-4, 5.1e-5, 3.1e-6]),
        (Inertia::Consistent, 4.0, [1.6e-3, 1.0e-4, 6.3e-6]),
    ] {
        let found = [2, 4, 8].map(|elements| error(elements, inertia));
        println!("{inertia:?}: {found:?}");
        for (error, expected) in found.iter().zip(reference) {
            // The reference errors are given with two digits; shear flexibility of
            // 1e-8 is allowed for with 1e-6 absolute.
            assert!(
                (error - expected).abs() < 0.1 * expected + 1e-6,
                "{found:?}"
            );
        }
        let slope = (found[0] / found[1]).log2();
        let case = format!("first flap frequency, {inertia:?} inertia").to_lowercase();
        record::order(EXACT, &case, "order", slope, order - 0.3);
        assert!((slope - order).abs() < 0.3, "{inertia:?}: {slope}");
    }
}

/// Uniform beam in torsion, GJ = 1, polar inertia 1, clamped-free: omega = pi/2.
/// Errors for two elements: finite volumes -3.5e-3 (second order, `beam_static.json`), bodies
/// by nodal weights -1.3e-4 and consistent 2.6e-4 (fourth order, `variational_beam`).
#[test]
fn torsion_converges_as_bending_does() {
    let exact = std::f64::consts::FRAC_PI_2;
    for (inertia, order) in [
        (Inertia::Portions, 2.0),
        (Inertia::Lumped, 4.0),
        (Inertia::Consistent, 4.0),
    ] {
        let error = |elements| {
            let mut beam = UniformBeam::slender(elements, inertia);
            beam.stiffness = nalgebra::Vector6::new(1e8, 1e8, 1e8, 1.0, 1e4, 1e4);
            beam.mass = nalgebra::Vector6::new(1.0, 1.0, 1.0, 1.0, 0.5, 0.5);
            let case = beam.case(&[0.0], 4);
            frequencies(&case, 0, "torsion")[0] / exact - 1.0
        };
        let (coarse, fine): (f64, f64) = (error(2), error(4));
        let slope = (coarse / fine).abs().log2();
        println!("torsion {inertia:?}: {coarse:e} {fine:e} {slope}");
        let case = format!("first torsion frequency, {inertia:?} inertia").to_lowercase();
        record::order(EXACT, &case, "order", slope, order - 0.3);
        assert!(
            (slope - order).abs() < 0.3,
            "{inertia:?}: {coarse:e} {fine:e}"
        );
    }
}

/// A model beyond the size for dense eigenvalues, solved by subspace iteration: 40 elements, 972
/// unknowns. A round beam at rest has every bending frequency twice, and both copies must be found.
/// Error of the elements: 3.1e-6 (8 elements) over 5^4, hence far below the 1e-6 of shear and
/// extension.
#[test]
fn large_models_have_all_copies_of_repeated_frequencies() {
    let case = UniformBeam::slender(40, Inertia::Lumped).case(&[0.0], 8);
    for word in ["flap", "lag"] {
        let found = frequencies(&case, 0, word);
        assert_eq!(found.len(), 4, "{word}: {found:?}");
        // beta L of the clamped-free beam: roots of cos x cosh x = -1.
        for (frequency, beta) in found.iter().zip([
            1.875_104_068_711_961_f64,
            4.694_091_132_974_175,
            7.854_757_438_237_613,
            10.995_540_734_875_467,
        ]) {
            let error = (frequency / beta.powi(2) - 1.0).abs();
            assert!(error < 3e-5, "{word}: {frequency} {error:e}");
        }
    }
}

/// A free beam: six motions without stiffness, whose frequency is zero, then both copies of the
/// bending frequencies, `cos x cosh x = 1`. Four elements are as coarse here as for the third
/// clamped mode (1.6e-2 in `variational_beam`); shear of 1e8 and a mesh of 20 elements change them
/// by less than 1e-4.
#[test]
fn a_free_beam_has_six_motions_without_stiffness() {
    for elements in [4, 20] {
        let mut beam = UniformBeam::slender(elements, Inertia::Lumped);
        beam.clamped = false;
        let system = beam.system();
        let tangent = system.tangent(&system.rest(), &Conditions::at_rest());
        let solver = LinearSolver::new(system.pattern());
        let massless = MasslessMotions::new(&system, &tangent);
        let problem = EigenProblem::new(&solver, &tangent, &massless, 6).unwrap();
        let Lowest { pairs, real, .. } = problem.lowest(10);
        assert!(real.is_empty(), "{real:?}");
        let found: Vec<_> = pairs.iter().map(|pair| pair.angular_frequency).collect();
        assert_eq!(found[..6], [0.0; 6]);
        // Each moves some node, and no two are equal.
        for (i, a) in pairs[..6].iter().enumerate() {
            for b in &pairs[..i] {
                let products = a.real.iter().zip(&b.real).map(|(a, b)| a * b);
                let imaginary = a.imaginary.iter().zip(&b.imaginary).map(|(a, b)| a * b);
                let overlap: f64 = products.chain(imaginary).sum();
                assert!(overlap.abs() < 0.9, "{overlap}");
            }
            assert!(a.real.iter().chain(&a.imaginary).any(|v| v.abs() > 0.01));
        }
        for (frequency, beta) in found[6..].iter().zip([
            4.730_040_744_862_704_f64,
            4.730_040_744_862_704,
            7.853_204_624_095_838,
            7.853_204_624_095_838,
        ]) {
            let error = (frequency / beta.powi(2) - 1.0).abs();
            let tolerance = if elements == 4 { 2e-2 } else { 1e-4 };
            assert!(error < tolerance, "{frequency} {error:e}");
        }
    }
}

/// Torsion of a rotating blade: the centrifugal ("propeller") moment stiffens a flat
/// section, `omega^2 = omega_0^2 + Omega^2 (iz - iy) / (iz + iy)` (any text on rotor
/// blades; it follows from Euler's equations of a slice). Mode shape and frequency at
/// rest are unchanged by it, so the difference of the squares is exact for any mesh up
/// to the gyroscopic coupling with the bending slopes, of the order of
/// `iz Omega^2 / EI = 2e-3` of it.
#[test]
fn the_propeller_moment_stiffens_torsion() {
    for inertia in [Inertia::Portions, Inertia::Lumped, Inertia::Consistent] {
        let mut beam = UniformBeam::slender(4, inertia);
        beam.stiffness = nalgebra::Vector6::new(1e6, 1e6, 1e6, 1.0, 1e3, 1e3);
        let (iy, iz) = (0.1, 0.5);
        beam.mass = nalgebra::Vector6::new(1.0, 1.0, 1.0, iy + iz, iy, iz);
        let speed = 2.0;
        let case = beam.case(&[0.0, speed], 6);
        let [rest, turning] = [0, 1].map(|s| frequencies(&case, s, "torsion 1")[0]);
        let found = turning.powi(2) - rest.powi(2);
        let expected = speed * speed * (iz - iy) / (iz + iy);
        let error = (found / expected - 1.0).abs();
        println!("propeller moment {inertia:?}: {found} {expected} {error:e}");
        let case = format!("flat section, {inertia:?} inertia").to_lowercase();
        let quantity = "propeller moment";
        record::value(
            "Euler's equations of a slice",
            &case,
            quantity,
            [found, expected],
            error,
            2e-3,
        );
        assert!(error < 2e-3, "{inertia:?}: {found}, {expected}");
    }
}
