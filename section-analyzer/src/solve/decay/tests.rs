use super::super::tests::{Problem, problem, problem_along, problems, random_triangles, systems};
use super::super::{CentralSolution, Decoupled, Pins};
use super::*;
use crate::assembly::{Domain, Pattern, SectionMatrices, section_forces};
use crate::material::{ElasticLaw, EngineeringConstants};
use crate::mesh::SectionMesh;
use crate::mesh::generate::Rectangle;
use crate::section::Section;
use crate::section::samples::{Random, coupled_rectangle};
use shared_geom::error::SourceLocation;
use shared_geom::mesh::CellKind;

fn rates(p: &Problem, pins: Pins, wanted: usize) -> DecayRates {
    let systems = systems(p, pins.clone());
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

/// Oracle: all eigenvalues of the whole pencil as a dense matrix. With psi included in the
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
    let mut found = eigenvalues_of(companion.as_slice());
    found.sort_by(|a, b| a.norm().total_cmp(&b.norm()));
    found
}

/// The eigenvalues nearest to zero of a section without any symmetry, on straight and
/// curved lines, without the twelve that are not end effects.
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
        // curvature the eigenvalues at +-i |k| to eps^(1/2)
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
        // none is missing: the rates found are the slowest of all
        let first = all.iter().filter(|value| !is_trivial(value));
        let first = first.filter(|value| value.re > 0.0 && value.im >= -1e-9);
        let mut first: Vec<_> = first.collect();
        first.sort_by(|a, b| a.re.total_cmp(&b.re));
        for (rate, expected) in found.rates.iter().zip(first) {
            let error = (rate - expected).norm();
            assert!(error < 1e-8 * rate.norm(), "{rate} {expected}");
        }
    }
}

/// The choice of pins has no influence.
#[test]
fn rates_do_not_depend_on_the_pins() {
    for p in problems() {
        let nodes = &p.domain.nodes;
        let one = rates(&p, Pins::choose(nodes).expect("wide"), 4);
        for triangle in random_triangles(nodes).into_iter().take(2) {
            let other = rates(&p, Pins::at(nodes, triangle), 4);
            for (a, b) in one.rates.iter().zip(&other.rates) {
                assert!((a - b).norm() < 1e-9 * a.norm(), "{a} {b}");
            }
        }
    }
}

/// Copies and conjugates are one rate, and pairs next to the real axis are real.
#[test]
fn copies_are_reported_once() {
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
    assert_eq!(change(&[], &found), f64::INFINITY);
    assert_eq!(change(&found, &found), 0.0);
    // of the new one sqrt(5), from the other by 1
    assert!((change(&found[..1], &found) - 0.2_f64.sqrt()).abs() < 1e-8);
}

/// All rates that may decay as slowly as the requested ones are evaluated: up to 2.2 times
/// the real part, or 1.25 times the ratio of other rates.
#[test]
fn rates_are_looked_at_as_far_as_slow_ones_may_be() {
    let real = |re: f64| Complex::new(re, 0.0);
    let rates = [1.0, 2.0, 2.1, 2.3, 3.0, 5.0].map(real);
    assert_eq!(needed(&rates, 1), Some(4));
    assert_eq!(needed(&rates, 2), Some(6));
    assert_eq!(needed(&rates, 3), Some(6));
    assert_eq!(needed(&rates, 4), None);
    assert_eq!(needed(&rates[..2], 3), None);
    assert_eq!(needed(&[], 1), None);
    // |lambda| = 5/3 of the real part: up to 2.2; 5/2: up to 3.125
    let waves = |re: f64, im: f64| [real(1.0), Complex::new(re, im), real(3.0), real(3.2)];
    assert_eq!(needed(&waves(1.2, 1.6), 1), Some(3));
    assert_eq!(needed(&waves(1.0, 21.0_f64.sqrt() / 2.0), 1), Some(4));
}

/// Moduli over two decades and Poisson's ratios of any sign, admissible, shear moduli far
/// from isotropic ones: end effects with wavelengths shorter than their decay length.
fn random_law(random: &mut Random) -> ElasticLaw {
    loop {
        let [e1, e2, e3] = [0; 3].map(|_| 10_f64.powf(random.next()));
        let [r12, r13, r23] = [0; 3].map(|_| 0.9 * random.next());
        if 1.0 - r12 * r12 - r13 * r13 - r23 * r23 - 2.0 * r12 * r13 * r23 < 1e-3 {
            continue;
        }
        let mut shear = |a: f64, b: f64| (a * b).sqrt() * 10_f64.powf(0.35 + 0.85 * random.next());
        let (g12, g13, g23) = (shear(e1, e2), shear(e1, e3), shear(e2, e3));
        return ElasticLaw::Orthotropic(EngineeringConstants {
            e1,
            e2,
            e3,
            g12,
            g13,
            g23,
            nu12: r12 * (e1 / e2).sqrt(),
            nu13: r13 * (e1 / e3).sqrt(),
            nu23: r23 * (e2 / e3).sqrt(),
        });
    }
}

/// A rectangle of the law, of 3 by 3 cells.
fn orthotropic_rectangle(law: ElasticLaw, width: f64) -> Problem {
    let mesh = Rectangle {
        width,
        height: 1.0,
        cells_y: if width < 0.5 { 1 } else { 3 },
        cells_z: if width < 0.5 { 8 } else { 3 },
        kind: CellKind::Quadrilateral8,
        name: "bar".into(),
    };
    let mesh = mesh.generate().expect("sound measures");
    let (mesh, _) =
        SectionMesh::from_mesh(&mesh, 1.0, &SourceLocation::file("test")).expect("sound");
    let mut section = coupled_rectangle(CellKind::Quadrilateral8);
    section.cells.truncate(1);
    section.cells[0].fiber_angle = 0.0;
    section.cells[0].plane_angle = 0.0;
    let cell = section.cells[0];
    section.materials[0].law = law;
    let section = Section {
        cells: vec![cell; mesh.cells.len()],
        mesh,
        ..section
    };
    let domain = Domain::new(&section).expect("sound");
    let pattern = Pattern::new(&domain);
    let matrices = SectionMatrices::assemble(&domain, &pattern).expect("sound");
    Problem {
        domain,
        pattern,
        matrices,
    }
}

/// None of the slowest rates of random orthotropic sections is missed, for any requested
/// number: against all eigenvalues of the pencil.
#[test]
fn none_of_the_slowest_is_missed() {
    let mut random = Random(7);
    for number in 0..8 {
        let width = if number % 2 == 0 { 1.0 } else { 0.05 };
        let p = orthotropic_rectangle(random_law(&mut random), width);
        let pins = Pins::choose(&p.domain.nodes).expect("wide");
        // the eigenvalues of rigid motions and central solutions come first
        let inverse = |value: &Complex<f64>| (value * value).inv();
        let mut all = distinct(all_rates(&p).iter().skip(12).map(inverse).collect());
        all.sort_by(|a, b| a.re.total_cmp(&b.re));
        for wanted in [1, 3, 10] {
            let found = rates(&p, pins.clone(), wanted);
            assert!(found.is_converged, "{number} {wanted}: {found:?}");
            assert_eq!(found.rates.len(), wanted);
            for (rate, expected) in found.rates.iter().zip(&all) {
                // the dense eigenvalues lambda^2, down to 0.1, have the round-off of M^-1 E,
                // of norm 1e9 in thin cells of stiff fibers
                let error = (rate - expected).norm() / expected.norm();
                assert!(error < 1e-6, "{number} {wanted}: {rate} {expected}");
            }
        }
    }
}
