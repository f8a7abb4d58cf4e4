//! Vlasov's constant and shear-flow center against closed forms.
//!
//! # References
//! - [Vlasov1961] V. Z. Vlasov, *Thin-walled elastic beams*, 2nd ed. 1961, chapter 1:
//!   warping constants of open thin walls from the sectorial area.
//! - [TimoshenkoGere] Timoshenko, Gere, *Theory of elastic stability*, 2nd ed. 1961, appendix, table
//!   A-3: the formulas of channel, I, Z and angle used here, in center line lengths.
//! - [TimoshenkoGoodier] chapter 10: torsion functions of ellipse and rectangle.

use std::f64::consts::PI;

use section_analyzer::mesh::generate::{Ellipse, Rectangle};
use section_analyzer::properties::RestrainedWarping;
use section_analyzer::section::Section;
use shared_geom::mesh::{CellKind, Mesh};

use crate::quads::{Quads, graded, joined, steps};
use crate::record;
use crate::sections::{isotropic, of_two, relative_error, solved, uniform};

/// Formulas of center lines, for walls of t/h = 1/100 here.
const THIN_WALLS: &str = "Formulas for thin walls";
const SERIES: &str = "Saint-Venant's solutions";

const YOUNG: f64 = 70e9;
const NU: f64 = 0.3;

const VLASOV: &str = "Vlasov's constant";
const CENTER: &str = "shear-flow center y";

fn constants(section: &Section) -> RestrainedWarping {
    let solution = solved(section);
    RestrainedWarping::new(section, &solution.warping, &solution.strain)
        .unwrap_or_else(|reason| panic!("{reason}"))
}

fn of_mesh(mesh: &Mesh) -> RestrainedWarping {
    constants(&uniform(mesh, isotropic(YOUNG, NU), 0.0))
}

fn gamma(found: &RestrainedWarping) -> f64 {
    found.constant.expect("one material")
}

/// A wall: a rectangle between two corners (y, z).
#[derive(Debug, Clone, Copy)]
struct Wall([f64; 2], [f64; 2]);

/// Thin walls of thickness `t`, as a lattice whose lines are `t / 2` apart in the walls
/// and graded between them.
fn walls(walls: &[Wall], t: f64, cells: usize) -> Mesh {
    let lines = |axis: usize| {
        let mut ends: Vec<f64> = walls.iter().flat_map(|w| [w.0[axis], w.1[axis]]).collect();
        ends.sort_by(f64::total_cmp);
        ends.dedup_by(|a, b| (*a - *b).abs() < 1e-9);
        let pieces: Vec<_> = ends
            .windows(2)
            .map(|ends| {
                if ends[1] - ends[0] < 1.01 * t {
                    steps(ends[0], ends[1], 2)
                } else {
                    graded(ends[0], ends[1], cells)
                }
            })
            .collect();
        joined(&pieces)
    };
    let inside = |[y, z]: [f64; 2]| {
        walls
            .iter()
            .any(|w| w.0[0] < y && y < w.1[0] && w.0[1] < z && z < w.1[1])
    };
    Quads::lattice(&lines(0), &lines(1), |center| inside(center).then_some(0))
        .mesh(|_| CellKind::Quadrilateral9)
}

/// A wall from one point of the center line to another, along y or z, extended by half a
/// thickness at the ends given by `ends`.
fn wall(from: [f64; 2], to: [f64; 2], t: f64, ends: [bool; 2]) -> Wall {
    let along = usize::from(from[0] == to[0]);
    let (mut low, mut high) = (from, to);
    low[1 - along] -= t / 2.0;
    high[1 - along] += t / 2.0;
    low[along] -= if ends[0] { t / 2.0 } else { 0.0 };
    high[along] += if ends[1] { t / 2.0 } else { 0.0 };
    Wall(low, high)
}

const H: f64 = 1.0;
const B: f64 = 0.6;
const T: f64 = H / 100.0;

fn channel() -> Mesh {
    let z = H / 2.0;
    walls(
        &[
            wall([0.0, -z], [0.0, z], T, [true, true]),
            wall([0.0, -z], [B, -z], T, [true, false]),
            wall([0.0, z], [B, z], T, [true, false]),
        ],
        T,
        24,
    )
}

/// `Gamma = t b^3 h^2 (3 b + 2 h) / (12 (6 b + h))`, and the center at `3 b^2 / (6 b + h)`
/// behind the web. Center lines neglect terms of t/h: the tolerance is 1 % at t/h = 1/100.
#[test]
fn thin_channel() {
    let found = of_mesh(&channel());
    let expected = T * B.powi(3) * H * H / 12.0 * (3.0 * B + 2.0 * H) / (6.0 * B + H);
    let error = relative_error(gamma(&found), expected);
    let center = -3.0 * B * B / (6.0 * B + H);
    let position = found.center;
    println!("channel: {error:.1e}, center {position:?} against {center}");
    let of_constant = [gamma(&found), expected];
    record::value(THIN_WALLS, "channel", VLASOV, of_constant, error, 0.01);
    assert!(error < 0.01, "{error:e}");
    let error = relative_error(position[0], center);
    let compared = [position[0], center];
    record::value(THIN_WALLS, "channel", CENTER, compared, error, 0.01);
    assert!(error < 0.01, "{position:?}");
    assert!(position[1].abs() < 1e-9, "{position:?}");
    assert!(relative_error(found.stiffness, YOUNG * gamma(&found)) < 1e-14);
}

/// Flanges stiffer than the web by n, each wall weighted by its modulus. The corners belong
/// to the flanges here, (n - 1) t^2/2 more than with center lines; with the corners as
/// points, from the sectorial area h/2 (s - e) of a flange and -e z of the web,
///
/// ```text
/// e (h^3/12 + n b h^2/2 + (n - 1) t h^2/4) = n b^2 h^2/4
/// E Gamma = E t [ e^2 h^3/12 + n h^2/6 ((b - e)^3 + e^3) + (n - 1) t (e h/2)^2 ]
/// ```
///
/// which for n = 1 is the formula above.
#[test]
fn thin_channel_of_two_materials() {
    let n = 3.0;
    let stiff = [isotropic(n * YOUNG, NU), isotropic(YOUNG, NU)];
    let section = of_two(&channel(), stiff, |[_, z]| z.abs() > H / 2.0 - T / 2.0);
    let found = constants(&section);
    let e = n * B * B / 4.0 / (H / 12.0 + n * B / 2.0 + (n - 1.0) * T / 4.0);
    let flanges = n * H * H / 6.0 * ((B - e).powi(3) + e.powi(3));
    let corners = (n - 1.0) * T * (0.5 * e * H).powi(2);
    let expected = YOUNG * T * (e * e * H.powi(3) / 12.0 + flanges + corners);
    let error = relative_error(found.stiffness, expected);
    println!("channel of two materials: {error:.1e}");
    let case = "channel of two materials";
    let stiffness = [found.stiffness, expected];
    record::value(
        THIN_WALLS,
        case,
        "warping stiffness",
        stiffness,
        error,
        0.01,
    );
    assert!(error < 0.01, "{error:e}");
    assert_eq!(found.constant, None);
    let error = relative_error(found.center[0], -e);
    record::value(THIN_WALLS, case, CENTER, [found.center[0], -e], error, 0.01);
    assert!(error < 0.01, "{error:e}");
}

/// An I section with walls of 1/100 of its height.
pub fn thin_i_mesh() -> Mesh {
    let (y, z) = (B / 2.0, H / 2.0);
    walls(
        &[
            wall([0.0, -z], [0.0, z], T, [true, true]),
            wall([-y, -z], [y, -z], T, [false, false]),
            wall([-y, z], [y, z], T, [false, false]),
        ],
        T,
        24,
    )
}

/// `Gamma = t b^3 h^2 / 24`; the center is the center of symmetry.
#[test]
fn thin_i_section() {
    let found = of_mesh(&thin_i_mesh());
    let expected = T * B.powi(3) * H * H / 24.0;
    let error = relative_error(gamma(&found), expected);
    println!("I: {error:.1e}");
    let compared = [gamma(&found), expected];
    record::value(THIN_WALLS, "I", VLASOV, compared, error, 0.01);
    assert!(error < 0.01, "{error:e}");
    assert!(found.center.iter().all(|x| x.abs() < 1e-9), "{found:?}");
}

/// `Gamma = t b^3 h^2 (b + 2 h) / (12 (2 b + h))`; the center is in the middle of the web,
/// but the warping there is not zero: the zero mean of the warping makes it unique.
#[test]
fn thin_z_section() {
    let z = H / 2.0;
    let mesh = walls(
        &[
            wall([0.0, -z], [0.0, z], T, [true, true]),
            wall([-B, -z], [0.0, -z], T, [false, true]),
            wall([0.0, z], [B, z], T, [true, false]),
        ],
        T,
        24,
    );
    let found = of_mesh(&mesh);
    let expected = T * B.powi(3) * H * H / 12.0 * (B + 2.0 * H) / (2.0 * B + H);
    let error = relative_error(gamma(&found), expected);
    println!("Z: {error:.1e}");
    let compared = [gamma(&found), expected];
    record::value(THIN_WALLS, "Z", VLASOV, compared, error, 0.01);
    assert!(error < 0.01, "{error:e}");
    assert!(found.center.iter().all(|x| x.abs() < 1e-9), "{found:?}");
}

/// An angle: the walls meet at the center, so that center lines do not warp, and only the
/// warping through the walls remains, `Gamma = t^3 (a^3 + b^3) / 36`. The corner, next to
/// the pole, contributes little: 1 % as for the others.
#[test]
fn thin_angle_warps_through_its_walls_only() {
    let (a, b) = (H, B);
    let mesh = walls(
        &[
            wall([0.0, 0.0], [a, 0.0], T, [true, false]),
            wall([0.0, 0.0], [0.0, b], T, [true, false]),
        ],
        T,
        24,
    );
    let found = of_mesh(&mesh);
    let expected = T.powi(3) * (a.powi(3) + b.powi(3)) / 36.0;
    let error = relative_error(gamma(&found), expected);
    println!("angle: {error:.1e}, center {:?}", found.center);
    let compared = [gamma(&found), expected];
    record::value(THIN_WALLS, "angle", VLASOV, compared, error, 0.01);
    assert!(error < 0.01, "{error:e}");
    assert!(
        found.center.iter().all(|x| x.abs() < T),
        "{:?}",
        found.center
    );
}

/// Rectangle b x t: warping by de Saint-Venant's series about its center,
///
/// ```text
/// omega = -y z + sum a_n sinh(k_n y) sin(k_n z)       k_n = (2 n + 1) pi / t
/// a_n = 8 (-1)^n / (t k_n^3 cosh(k_n b/2))
/// ```
///
/// squared and integrated; the terms decrease as k^-5.
fn rectangle_constant(b: f64, t: f64) -> f64 {
    let mut sum = b.powi(3) * t.powi(3) / 144.0;
    for n in 0..200 {
        let k = (2 * n + 1) as f64 * PI / t;
        let tanh = (0.5 * k * b).tanh();
        // int y sinh(k y) dy / cosh(k b/2) and int sinh^2(k y) dy / cosh^2(k b/2)
        let mixed = b / k - 2.0 * tanh / (k * k);
        let squared = tanh / k - 0.5 * b * (1.0 - tanh * tanh);
        let a = 8.0 / (t * k.powi(3));
        sum += a * a * 0.5 * t * squared - 2.0 * a * mixed * 2.0 / (k * k);
    }
    sum
}

/// Relative to the `b^3 t^3 / 144` of a thin strip: quadratic cells of a twelfth of the
/// height, whose torsion converges as h^4 (5e-5), agree with the series to 1e-5. The strip
/// differs by 4.8 (t/b)^2, the first term of the series.
#[test]
fn rectangles() {
    for ratio in [1.0, 2.0, 10.0, 100.0] {
        let mesh = Rectangle {
            width: ratio,
            height: 1.0,
            cells_y: 24 * (1.0 + ratio.log2()) as usize,
            cells_z: 12,
            kind: CellKind::Quadrilateral9,
            name: "bar".into(),
        };
        let found = of_mesh(&mesh.generate().expect("sound measures"));
        let expected = rectangle_constant(ratio, 1.0);
        let strip = ratio.powi(3) / 144.0;
        let error = (gamma(&found) - expected).abs() / strip;
        let thin = relative_error(expected, strip);
        println!("rectangle {ratio}: {error:.1e}, from the thin strip {thin:.1e}");
        let case = format!("rectangle, width / depth = {ratio}");
        let compared = [gamma(&found), expected];
        record::value(SERIES, &case, VLASOV, compared, error, 1e-5);
        assert!(error < 1e-5, "rectangle {ratio}: {error:e}");
        if ratio >= 10.0 {
            assert!(thin < 5.0 / (ratio * ratio));
        }
        assert!(found.center.iter().all(|x| x.abs() < 1e-9 * ratio));
    }
}

/// Ellipse: `omega = (a^2 - b^2)/(a^2 + b^2) y z` up to its sign, so that
/// `Gamma = ((a^2 - b^2)/(a^2 + b^2))^2 pi a^3 b^3 / 24`; the circle does not warp. The
/// outline consists of parabolas, with errors of h^4: 1e-6 of the ellipse.
#[test]
fn ellipses() {
    for (a, b) in [(2.0_f64, 1.0_f64), (1.0, 1.0)] {
        let mesh = Ellipse {
            semi_y: a,
            semi_z: b,
            cells: 16,
            kind: CellKind::Quadrilateral9,
            curved: true,
        };
        let found = of_mesh(&mesh.generate().expect("sound measures"));
        let product = PI * (a * b).powi(3) / 24.0;
        let expected = ((a * a - b * b) / (a * a + b * b)).powi(2) * product;
        let error = (gamma(&found) - expected).abs() / product;
        println!("ellipse {a} x {b}: {error:.1e}");
        let case = format!("ellipse, semi-axes {a} and {b}");
        let compared = [gamma(&found), expected];
        record::value(SERIES, &case, VLASOV, compared, error, 1e-6);
        assert!(error < 1e-6, "ellipse {a} x {b}: {error:e}");
    }
}

/// With one Poisson ratio the shear-flow center is the shear center of the compliance:
/// Betti's theorem, on a section without symmetry, to round-off.
#[test]
fn shear_flow_center_is_the_shear_center_of_one_material() {
    let t = 0.1;
    let mesh = walls(
        &[
            wall([0.3, -0.5], [0.3, 0.5], t, [true, true]),
            wall([0.3, -0.5], [1.3, -0.5], t, [true, false]),
            wall([0.3, 0.5], [0.8, 0.5], t, [true, false]),
        ],
        t,
        8,
    );
    let section = uniform(&mesh, isotropic(YOUNG, NU), 0.0);
    let (found, shear) = (constants(&section), solved(&section).centers.shear);
    for axis in 0..2 {
        let error = (found.center[axis] - shear[axis]).abs();
        let quantity = "shear-flow center at the shear center";
        record::largest(
            "Betti's theorem",
            "channel of unequal flanges",
            quantity,
            error,
            1e-9,
        );
        assert!(error < 1e-9, "{:?} against {shear:?}", found.center);
    }
    assert!(
        shear[1].abs() > 0.1,
        "a section without symmetry: {shear:?}"
    );
    // two elastic lengths of the same beam: GJ agrees with the compliance
    let free = 1.0 / solved(&section).compliance[(3, 3)];
    assert!(relative_error(found.torsional_stiffness, free) < 1e-9);
}
