use super::super::tests::{Problem, problem, problem_along, problems, random_triangles, systems};
use super::super::{CentralSolution, Decoupled, Pins};
use super::*;
use crate::assembly::section_forces;

fn rates(p: &Problem, pins: Pins, wanted: usize) -> DecayRates {
    let systems = systems(p, pins);
    let central = CentralSolution::solve(&p.domain, &systems).expect("memory");
    let central = Decoupled::new(&p.domain, central);
    DecayRates::find(&p.domain, systems.steady(), &central.face, wanted).expect("memory")
}

/// M, C and E of a section, column by column from the forces of unit states.
fn matrices(p: &Problem) -> [DMatrix<f64>; 3] {
    let n = p.domain.unknowns();
    let zero = Matrix6::zeros();
    let (mut m, mut c, mut e) = (
        DMatrix::zeros(n, n),
        DMatrix::zeros(n, n),
        DMatrix::zeros(n, n),
    );
    for first in (0..n).step_by(6) {
        let count = 6.min(n - first);
        let unit = DMatrix::from_fn(n, count, |i, j| f64::from(u8::from(i == first + j)));
        let state = |rate, warping| State {
            rate,
            warping,
            strain: &zero,
        };
        let of_rate = section_forces(&p.domain, state(Rate::Given(&unit), None));
        let of_warping = section_forces(&p.domain, state(Rate::Zero, Some(&unit)));
        m.columns_mut(first, count)
            .copy_from(&of_rate.face.columns(0, count));
        c.columns_mut(first, count)
            .copy_from(&of_warping.face.columns(0, count));
        e.columns_mut(first, count)
            .copy_from(&of_warping.within.columns(0, count));
    }
    [m, c, e]
}

/// Oracle: all eigenvalues of the whole pencil as a dense matrix. With psi taken into the
/// rigid part of u it is `lambda^2 M u + lambda (C - C') u - E u = 0`, that is
///
/// ```text
/// lambda [ u; lambda u ] = [ 0, I ; M^-1 E, -M^-1 (C - C') ] [ u; lambda u ]
/// ```
fn all_rates(p: &Problem) -> Vec<Complex<f64>> {
    let [m, c, e] = matrices(p);
    let n = m.nrows();
    let m = m.cholesky().expect("positive definite");
    let mut companion = DMatrix::zeros(2 * n, 2 * n);
    companion.view_mut((0, n), (n, n)).fill_with_identity();
    companion.view_mut((n, 0), (n, n)).copy_from(&m.solve(&e));
    let turned = m.solve(&(c.transpose() - &c));
    companion.view_mut((n, n), (n, n)).copy_from(&turned);
    let mut found = dense::eigenvalues(&companion);
    found.sort_by(|a, b| a.norm().total_cmp(&b.norm()));
    found
}

/// The nearest to zero of all eigenvalues of a section without any symmetry, on
/// straight and curved lines; the twelve that are no end effects are left out.
#[test]
fn rates_are_those_of_the_whole_pencil() {
    for p in [
        problem(),
        problem_along([0.0; 3], [1.0, 0.3, -0.2]),
        problem_along([0.3, -0.2, 0.25], [0.9, 0.1, -0.05]),
    ] {
        let found = rates(&p, Pins::choose(&p.domain.nodes).expect("wide"), 6);
        assert!(found.is_converged, "{found:?}");
        assert_eq!(found.rates.len(), 6);
        assert!(found.rates.is_sorted_by_key(|rate| rate.re));
        let all = all_rates(&p);
        // four Jordan chains of length two and four at zero spread to eps^(1/4), and with
        // curvature those at +-i |k| to eps^(1/2)
        let w = p.domain.line.curvature.norm();
        let is_trivial = |value: &&Complex<f64>| {
            value.norm() < 1e-2 || (value.re.abs() < 1e-2 && (value.im.abs() - w).abs() < 1e-2)
        };
        assert_eq!(all.iter().filter(is_trivial).count(), 12);
        for rate in &found.rates {
            let nearest = all.iter().map(|value| (value - rate).norm());
            let nearest = nearest.fold(f64::INFINITY, f64::min);
            // the dense eigenvalues have the round-off of M^-1 E, of norm 1e4
            assert!(nearest < 1e-8 * rate.norm(), "{rate} {nearest:e}");
        }
        // none is missing: those found are the first decaying ones with another two
        let first = all.iter().filter(|value| !is_trivial(value));
        let first = first.filter(|value| value.re > 0.0 && value.im >= -1e-9);
        let mut first: Vec<_> = first.take(6 + SPARE).collect();
        first.sort_by(|a, b| a.re.total_cmp(&b.re));
        for (rate, expected) in found.rates.iter().zip(first) {
            let error = (rate - expected).norm();
            assert!(error < 1e-8 * rate.norm(), "{rate} {expected}");
        }
    }
}

/// Pins are a choice without consequence.
#[test]
fn rates_do_not_depend_on_the_pins() {
    for p in problems() {
        let nodes = &p.domain.nodes;
        let one = rates(&p, Pins::choose(nodes).expect("wide"), 4);
        for triangle in random_triangles(nodes).into_iter().take(3) {
            let other = rates(&p, Pins::at(nodes, triangle), 4);
            for (a, b) in one.rates.iter().zip(&other.rates) {
                assert!((a - b).norm() < 1e-9 * a.norm(), "{a} {b}");
            }
        }
    }
}

/// Copies and conjugates are one rate, and pairs next to the real axis are real.
#[test]
fn copies_are_told_once() {
    let one = Complex::new(1.0, 0.0);
    let a = Complex::new(2.0, 1.0);
    let squares = [
        one / (a * a),
        one / (a * a).conj(),
        Complex::new(0.25, 1e-9),
        Complex::new(0.25, -1e-9),
        Complex::new(0.0, 0.0),
    ];
    let found = distinct(squares.to_vec());
    assert_eq!(found.len(), 2);
    assert!((found[0] - Complex::new(2.0, 0.0)).norm() < 1e-8);
    assert!((found[1] - a).norm() < 1e-14);
    assert_eq!(change(&found[..1], &found), f64::INFINITY);
    assert_eq!(change(&found, &found), 0.0);
}
