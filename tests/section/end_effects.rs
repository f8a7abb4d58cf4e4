//! Rates of decay of end effects against roots of the theory of elasticity.
//!
//! # References
//! - [TimoshenkoGoodier] article 26: ends of strips (Papkovich and Fadle); article 122
//!   for the torsion of a circular bar held by its end.
//! - [Vlasov1961]: decay of restrained warping in open thin walls.

use nalgebra::Complex;
use section_analyzer::analysis::Analysis;
use section_analyzer::material::EngineeringConstants;
use section_analyzer::mesh::generate::{Ellipse, Rectangle};
use section_analyzer::properties::RestrainedWarping;
use section_analyzer::section::Section;
use section_analyzer::solution::{DecayingMode, EndEffects};
use shared_geom::mesh::CellKind;

use crate::record;
use crate::restrained_warping::thin_i_mesh;
use crate::sections::{isotropic, orthotropic, relative_error, uniform};

const END_EFFECTS: &str = "End effects";

fn end_effects(section: &Section, wanted: usize) -> EndEffects {
    let analysis = Analysis::new(section).unwrap_or_else(|failure| panic!("{failure}"));
    let found = analysis.end_effects(wanted);
    let found = found.unwrap_or_else(|failure| panic!("{failure}"));
    println!("{found:#?}");
    assert!(found.is_converged, "{found:?}");
    assert_eq!(found.modes.len(), wanted);
    found
}

/// Distance of the nearest of the found rates from `expected`, relative.
fn nearest(found: &EndEffects, expected: Complex<f64>) -> f64 {
    let errors = found.modes.iter().map(|mode| {
        let rate = Complex::new(mode.rate, mode.wave_number);
        (rate - expected).norm() / expected.norm()
    });
    errors.fold(f64::INFINITY, f64::min)
}

/// Root of `f` near `start` by Newton's method.
fn root(f: impl Fn(Complex<f64>) -> [Complex<f64>; 2], start: Complex<f64>) -> Complex<f64> {
    let mut x = start;
    for _ in 0..50 {
        let [value, slope] = f(x);
        x -= value / slope;
    }
    let [value, _] = f(x);
    assert!(value.norm() < 1e-12 * (1.0 + x.norm()), "{x}");
    x
}

/// A narrow strip, h = 1 along z, nu = 0, so that plane stress and plane strain are equal.
/// End effects in its plane, of Papkovich and Fadle, with lambda h = x:
///
/// ```text
/// sin x + x = 0: extension      sin x - x = 0: bending
/// ```
///
/// and across it the end effects of a thin plate with free edges, of which the slowest is
/// `sin x = x/3` in Kirchhoff's theory, with an error of the order of width over height.
#[test]
fn strip() {
    let (width, height) = (0.05, 1.0);
    let mesh = Rectangle {
        width,
        height,
        cells_y: 1,
        cells_z: 32,
        kind: CellKind::Quadrilateral9,
        name: "strip".into(),
    };
    let mesh = mesh.generate().expect("sound measures");
    let section = uniform(&mesh, isotropic(1.0, 0.0), 0.0);
    let found = end_effects(&section, 10);
    let even = root(|x| [x.sin() + x, x.cos() + 1.0], Complex::new(4.2, 2.25));
    let odd = root(|x| [x.sin() - x, x.cos() - 1.0], Complex::new(7.5, 2.77));
    assert!((even - Complex::new(4.2124, 2.2507)).norm() < 1e-4);
    assert!((odd - Complex::new(7.4977, 2.7687)).norm() < 1e-4);
    // errors of the energy of quadratic cells: (x h/32)^4 or less, with factors of a
    // hundredth
    for (name, x, bound) in [("extension", even, 1e-5), ("bending", odd, 1e-4)] {
        let error = nearest(&found, x);
        println!("{name}: {error:e}");
        let what = format!("rate of decay, {name} of a strip");
        record::largest(END_EFFECTS, "Papkovich and Fadle", &what, error, bound);
        assert!(error < bound, "{name} {error:e}");
    }
    let plate = root(
        |x| [x.sin() - x / 3.0, x.cos() - 1.0 / 3.0],
        Complex::new(2.3, 0.0),
    );
    let error = nearest(&found, plate);
    println!("plate: {error:e}");
    record::largest(
        END_EFFECTS,
        "Kirchhoff's plate",
        "rate of decay, bending across a strip",
        error,
        width / height,
    );
    assert!(error < width / height, "{error:e}");
}

/// The Bessel function J2 and its derivative, by the series.
fn bessel(x: Complex<f64>) -> [Complex<f64>; 2] {
    let (mut value, mut slope) = (Complex::new(0.0, 0.0), Complex::new(0.0, 0.0));
    // (-1)^k / (k! (k + 2)!) (x/2)^(2k + 2)
    let mut factor = 0.5;
    for k in 0..40_i32 {
        let power = (0.5 * x).powi(2 * k + 2);
        value += factor * power;
        slope += factor * f64::from(2 * k + 2) * power / x;
        factor /= -f64::from((k + 1) * (k + 3));
    }
    [value, slope]
}

/// A circular bar: torsion whose end condition differs from de Saint-Venant's decays by
/// `u = J1(lambda r)`, free of stress on the surface if J2(lambda a) = 0.
#[test]
fn torsion_of_a_circular_bar() {
    let mesh = Ellipse {
        semi_y: 1.0,
        semi_z: 1.0,
        cells: 4,
        kind: CellKind::Quadrilateral9,
        curved: true,
    };
    let section = uniform(
        &mesh.generate().expect("sound measures"),
        isotropic(1.0, 0.3),
        0.0,
    );
    let found = end_effects(&section, 12);
    let expected = root(bessel, Complex::new(5.1, 0.0));
    assert!((expected.re - 5.135_622_301_840_683).abs() < 1e-12);
    let error = nearest(&found, expected);
    println!("{error:e}");
    record::largest(
        END_EFFECTS,
        "J2(lambda a) = 0",
        "rate of decay, torsion of a circular bar",
        error,
        1e-4,
    );
    assert!(error < 1e-4, "{error:e}");
}

/// A material whose slowest end effect is a wave that is not the nearest to zero: the first
/// modes are the same for any requested number.
#[test]
fn slowest_is_found_where_it_is_far_from_zero() {
    let mesh = Rectangle {
        width: 1.0,
        height: 1.0,
        cells_y: 4,
        cells_z: 4,
        kind: CellKind::Quadrilateral8,
        name: "square".into(),
    };
    let section = uniform(
        &mesh.generate().expect("sound measures"),
        orthotropic(EngineeringConstants {
            e1: 39.92,
            e2: 6.621,
            e3: 2.0023,
            g12: 6.112,
            g13: 31.338,
            g23: 1.3729,
            nu12: -0.911,
            nu13: 2.1603,
            nu23: 1.2201,
        }),
        0.0,
    );
    let many = end_effects(&section, 20);
    let by_distance = |a: &&DecayingMode, b: &&DecayingMode| {
        let distance = |mode: &DecayingMode| mode.rate.hypot(mode.wave_number);
        distance(a).total_cmp(&distance(b))
    };
    let nearest = many.modes.iter().min_by(by_distance).expect("twenty");
    assert!(nearest.rate > 1.02 * many.modes[0].rate, "{nearest:?}");
    for wanted in 1..5 {
        let few = end_effects(&section, wanted);
        for (mode, expected) in few.modes.iter().zip(&many.modes) {
            // both are converged to 1e-9
            let difference =
                (mode.rate - expected.rate).hypot(mode.wave_number - expected.wave_number);
            assert!(
                difference < 1e-8 * expected.rate,
                "{wanted}: {mode:?} {expected:?}"
            );
        }
    }
}

/// Restrained warping of an I section decays as in Vlasov's theory, to the order of
/// thickness over height; it is the slowest of all.
#[test]
fn restrained_warping_of_a_thin_i_section() {
    let section = uniform(&thin_i_mesh(), isotropic(70e9, 0.3), 0.0);
    let found = end_effects(&section, 2);
    let analysis = Analysis::new(&section).unwrap_or_else(|failure| panic!("{failure}"));
    let solution = analysis.solution();
    let vlasov = RestrainedWarping::new(&section, &solution.warping, &solution.strain)
        .unwrap_or_else(|reason| panic!("{reason}"));
    let slowest = &found.modes[0];
    assert_eq!(slowest.wave_number, 0.0);
    let length = slowest.distance((-1.0_f64).exp());
    let error = relative_error(length, vlasov.decay_length);
    println!("{length} {} {error:e}", vlasov.decay_length);
    let compared = [length, vlasov.decay_length];
    record::value(
        END_EFFECTS,
        "Vlasov",
        "decay length, thin I section",
        compared,
        error,
        0.01,
    );
    assert!(error < 0.01, "{error:e}");
}
