//! Linear systems: a forced oscillator, and random systems with periodic coefficients.

use std::f64::consts::TAU;

use beam_dynamics::result::Harmonics;
use nalgebra::{Complex, DMatrix};

use crate::effort::cases;

use super::{Random, analyzed, attempt, modes, monodromy, multipliers, off_by_sums};

const BODY: &str = "[[node]]\nname = \"mass\"\nposition = [0, 0, 0]\n\
    [[body]]\nname = \"mass\"\nnode = \"mass\"\nmass = 2\ninertia = [1, 1, 1]\n";

/// A mass of 2 kg on a guide along x with a spring of 50 N/m, the damping `c` \[N s/m\] and the force
/// `3 cos(4 t) + 1.5 sin(8 t) + 10` \[N\].
fn oscillator(c: f64, settings: &str) -> String {
    format!(
        "{BODY}[[joint]]\nname = \"guide\"\nkind = \"prismatic\"\nnodes = [\"mass\"]\n\
         axis = [1, 0, 0]\n\
         [[spring]]\nname = \"spring\"\nnode = \"mass\"\nstiffness = [50, 0, 0]\n\
         damping = [{c:?}, 0, 0]\n\
         [[load]]\nnode = \"mass\"\nforce = [1, 0, 0]\n\
         drive = \"= 3*cos(4*t) + 1.5*sin(8*t) + 10\"\n\
         [periodic]\nperiod = {:?}\n{settings}\n",
        TAU / 4.0
    )
}

/// Factors of cosine and sine of the response to `a cos(w t) + b sin(w t)`.
fn response(c: f64, w: f64, [a, b]: [f64; 2]) -> [f64; 2] {
    let x = Complex::new(a, -b) / Complex::new(50.0 - 2.0 * w * w, c * w);
    [x.re, -x.im]
}

// Closed form. At 96 steps a step is 0.065 of the forcing's radian and 0.13 of its second harmonic:
// errors of fifth order are below 1e-7 of the amplitude.
#[test]
fn a_forced_oscillator_by_both_methods() {
    for (c, method) in [(4.0, "shooting"), (4.0, "march"), (1e-3, "shooting")] {
        let settings = format!("method = \"{method}\"\n[periodic.floquet]\ncount = 4");
        let (outcome, kept) = analyzed(&oscillator(c, &settings));
        let xs: Vec<_> = kept.0[..96]
            .iter()
            .map(|(_, state)| state.nodes[0].position.x)
            .collect();
        let found = Harmonics::of(&xs, 4);
        assert!((found.mean - 0.2).abs() < 1e-8, "{}", found.mean);
        for (m, force) in [(1, [3.0, 0.0]), (2, [0.0, 1.5])] {
            let expected = response(c, 4.0 * m as f64, force);
            for (found, expected) in found.parts[m - 1].iter().zip(expected) {
                assert!(
                    (found - expected).abs() < 1e-7,
                    "{method} {m}: {found} {expected}"
                );
            }
        }
        assert!(found.parts[2][0].abs() < 1e-8);
        let mode = &modes(&outcome)[0];
        assert!(
            (mode.exponent.re + c / 4.0).abs() < 1e-7,
            "{}",
            mode.exponent
        );
        if method == "shooting" {
            // Linear: one correction, whatever the damping.
            assert!(
                outcome.result.passes.len() <= 3,
                "{:?}",
                outcome.result.passes
            );
        }
    }
}

// The natural frequency is 5 rad/s, outside of the half of the forcing's 4: the branch is the
// frequency of the motion, or the nearest to a given one.
#[test]
fn branches_by_content_and_by_given_frequencies() {
    let (outcome, _) = analyzed(&oscillator(0.1, "[periodic.floquet]\ncount = 2"));
    let mode = &modes(&outcome)[0];
    assert!(
        (mode.frequency() - 5.0).abs() < 1e-3 && mode.share > 0.999,
        "{mode:?}"
    );
    let near = format!("[periodic.floquet]\ncount = 2\nnear = [{:?}]", 8.8 / TAU);
    let (outcome, _) = analyzed(&oscillator(0.1, &near));
    assert!((modes(&outcome)[0].frequency() - 9.0).abs() < 1e-3);
}

// Without damping and at resonance nothing repeats; a march with little damping does not settle.
#[test]
fn motion_that_does_not_repeat_is_a_status() {
    let (outcome, _) = attempt(&oscillator(0.02, "method = \"march\"\nperiods = 30"));
    let failure = outcome.failure.unwrap();
    let text = failure.to_string();
    assert!(text.contains("does not repeat after 30 periods"), "{text}");
    assert!(text.contains("mass"), "{text}");
    assert!(
        failure.remedy().contains("shooting"),
        "{}",
        failure.remedy()
    );
    // A free mass without spring drifts.
    let free = oscillator(0.0, "").replace("stiffness = [50, 0, 0]", "stiffness = [0, 50, 0]");
    let (outcome, _) = attempt(&free);
    let text = outcome.failure.unwrap().to_string();
    assert!(text.contains("singular") && text.contains("mass"), "{text}");
}

// A pendulum of period 2 s with a damper that begins far from its motion: one iteration is too few after one
// period, in which the motion decays by exp(-4) only, and enough after five, by exp(-20): the search begins again
// there. With more periods before the first search there is no second one.
#[test]
fn a_search_that_does_not_converge_begins_again_after_five_periods() {
    let swing = |settings: &str| {
        format!(
            "[[node]]\nname = \"bob\"\nposition = [1, 0, 0]\n\
             [[body]]\nname = \"bob\"\nnode = \"bob\"\nmass = 2\ninertia = [1, 1, 1]\n\
             [[joint]]\nname = \"hinge\"\nkind = \"revolute\"\nnodes = [\"bob\"]\nat = [0, 0, 0]\n\
             axis = [0, 1, 0]\n\
             [[spring]]\nname = \"damper\"\nnode = \"bob\"\nrotational_damping = [0, 12, 0]\n\
             [[load]]\nnode = \"bob\"\nmoment = [0, 1, 0]\ndrive = \"= 4*cos(3.141592653589793*t)\"\n\
             [[load]]\nnode = \"bob\"\nforce = [0, 0, -40]\n\
             [periodic]\nperiod = 2\ntolerance = 1e-7\n{settings}\n"
        )
    };
    let exact = analyzed(&swing("")).0;
    let (again, _) = analyzed(&swing("iterations = 1"));
    assert!(again.result.passes.len() > 2, "{:#?}", again.result.passes);
    let [own, expected] = [&again, &exact].map(|own| own.state.as_ref().unwrap().nodes[0].position);
    assert!((own - expected).norm() < 1e-6, "{own} {expected}");
    // With little damping five periods are not enough, and there is no third search.
    let loose = swing("settle = 5\niterations = 1").replace("[0, 12, 0]", "[0, 0.5, 0]");
    let none = attempt(&loose.replace("tolerance = 1e-7", "tolerance = 1e-13")).0;
    assert_eq!(none.result.passes.len(), 2, "{:#?}", none.result.passes);
    let remedy = none.failure.unwrap().remedy();
    assert!(
        remedy.contains("more \"steps\"") && !remedy.contains("rotating"),
        "{remedy}"
    );
}

/// A system `x' = (A + B cos(w t)) x` of the given size and period two.
fn system(a: &DMatrix<f64>, b: &DMatrix<f64>) -> String {
    let n = a.nrows();
    let rows = |of: &DMatrix<f64>| {
        let row = |i: usize| {
            let row: Vec<_> = of.row(i).iter().map(|v| format!("{v:?}")).collect();
            format!("[{}]", row.join(", "))
        };
        format!("[{}]", (0..n).map(row).collect::<Vec<_>>().join(", "))
    };
    let names: Vec<_> = (0..n).map(|i| format!("x{i}")).collect();
    let inputs: Vec<_> = names
        .iter()
        .map(|x| format!("\"= cos({:?}*t)*{x}\"", TAU / 2.0))
        .collect();
    let outputs: Vec<_> = names.iter().map(|x| format!("\"{x}\"")).collect();
    format!(
        "{BODY}[[joint]]\nname = \"hold\"\nkind = \"clamp\"\nnodes = [\"mass\"]\n\
         [[state_space]]\nname = \"system\"\ninputs = [{}]\noutputs = [{}]\na = {}\nb = {}\n\
         c = {}\n[periodic]\nperiod = 2\nsteps = 64\n[periodic.floquet]\ncount = {n}\n\
         error_estimate = false\n",
        inputs.join(", "),
        outputs.join(", "),
        rows(a),
        rows(b),
        rows(&DMatrix::identity(n, n))
    )
}

// Systems of two to five states against the product of 1000 steps of fourth order, whose error is
// below 1e-10; entries of up to 1.5 1/s and steps of 1/32 s: errors of fifth order are below 1e-7.
#[test]
fn random_periodic_systems() {
    let mut random = Random(7);
    for case in 0..cases(60) {
        let n = 2 + case % 4;
        let a = DMatrix::from_fn(n, n, |i, j| random.next() - if i == j { 0.5 } else { 0.0 });
        let b = DMatrix::from_fn(n, n, |_, _| random.next());
        let (outcome, _) = analyzed(&system(&a, &b));
        let at = |t: f64| &a + &b * (0.5 * TAU * t).cos();
        let exact = monodromy(at, 2.0, 1000).complex_eigenvalues();
        let exact: Vec<_> = exact.iter().copied().collect();
        let found = multipliers(&outcome);
        assert_eq!(found.len(), n, "{case}: {found:?}");
        let off = off_by_sums(&found, &exact);
        assert!(off < 1e-6, "{case}: {off:e} {found:?} {exact:?}");
    }
}

// q'' = -K(t) q with symmetric K: for each multiplier its reciprocal.
#[test]
fn reciprocal_pairs_of_undamped_systems() {
    let mut random = Random(11);
    for case in 0..cases(40) {
        let m = 1 + case % 2;
        let mut symmetric = |size: f64| {
            let of = DMatrix::from_fn(m, m, |_, _| size * random.next());
            (&of + of.transpose()) * 0.5
        };
        let (stiffness, modulation) = (
            symmetric(1.0) + DMatrix::identity(m, m) * 3.0,
            symmetric(2.0),
        );
        let mut a = DMatrix::zeros(2 * m, 2 * m);
        let mut b = DMatrix::zeros(2 * m, 2 * m);
        a.view_mut((0, m), (m, m)).fill_with_identity();
        a.view_mut((m, 0), (m, m)).copy_from(&-stiffness);
        b.view_mut((m, 0), (m, m)).copy_from(&-modulation);
        let (outcome, _) = analyzed(&system(&a, &b));
        let found = multipliers(&outcome);
        let inverse: Vec<_> = found.iter().map(|mu| mu.inv()).collect();
        let off = off_by_sums(&found, &inverse);
        assert!(off < 1e-5, "{case}: {off:e} {found:?}");
    }
}
