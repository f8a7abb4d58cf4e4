//! Sections with closed-form properties.
//!
//! # References
//! - [saint-venant] Timoshenko, Goodier, *Theory of Elasticity*, 3rd ed. 1970,
//!   chapters 10 and 11: torsion of elliptic and rectangular bars; bending of a
//!   circular bar by a shear force.
//! - [lekhnitskii] Lekhnitskii, *Theory of Elasticity of an Anisotropic Elastic
//!   Body*, 1963, chapters 3 and 4: extension, bending and torsion of bars that are
//!   anisotropic off their axis; torsion of an orthotropic rectangle.
//! - [renton] Renton, *Generalized beam theory applied to shear stiffness*, Int. J. Solids
//!   Structures 27 (1991) 1955-1967: shear stiffness from the energy of the Saint-Venant
//!   solution. (Cowper, J. Appl. Mech. 33 (1966) 335-340, averages displacements instead,
//!   `10 (1 + nu) / (12 + 11 nu)` for the rectangle; the stiffness that belongs to a
//!   compliance follows from the energy.)
//! - [schramm] Schramm, Kitis, Kang, Pilkey, *On the shear deformation coefficient in beam
//!   theory*, Finite Elements Anal. Des. 16 (1994) 141-162: the same for other shapes,
//!   including the tube.

use std::f64::consts::PI;

use nalgebra::Matrix6;
use section_analyzer::material::EngineeringConstants;
use section_analyzer::mesh::generate::{Ellipse, Rectangle, Tube};
use section_analyzer::section::Section;
use shared_geom::mesh::{CellKind, Mesh};
use shared_geom::quadrature;

use crate::record;
use crate::sections::{isotropic, of_two, orthotropic, relative_error, solved, uniform};

const NU: f64 = 0.3;

// The sources as named on the validation page.
const SAINT_VENANT: &str = "Saint-Venant's solutions";
const SHEAR: &str = "Shear stiffness from the energy of Saint-Venant's solution";
const OFF_AXIS: &str = "Lekhnitskii's solutions";
const SUMS: &str = "Sums over the areas";

const LINEAR: [CellKind; 2] = [CellKind::Triangle3, CellKind::Quadrilateral4];

const QUADRATIC: [CellKind; 3] = [
    CellKind::Triangle6,
    CellKind::Quadrilateral8,
    CellKind::Quadrilateral9,
];

/// Cells of one family: its kinds, and the least required order of convergence.
///
/// The theory has order 2 for linear cells and 4 for quadratic ones.
struct Family {
    kinds: &'static [CellKind],
    order: f64,
    /// Cells per side of three rectangles.
    rectangle: [usize; 3],
    /// Cells per quarter of three ellipses, and through the walls of tubes.
    round: [usize; 3],
}

const FAMILIES: [Family; 2] = [
    Family {
        kinds: &LINEAR,
        order: 1.9,
        rectangle: [8, 16, 32],
        round: [4, 8, 16],
    },
    Family {
        kinds: &QUADRATIC,
        order: 3.7,
        rectangle: [6, 12, 24],
        round: [4, 8, 16],
    },
];

/// Reduction of the order of torsion by a corner with quadratic triangles: the torsion
/// function varies as r^2 log r there, and the error as h^4 log(1/h). Between n and 2 n
/// cells the logarithm reduces the order by at most log2(log 2n / log n) = 0.47 (n = 6),
/// 0.36 (n = 12), if the error has no other part; observed are 0.38 and 0.30. Quadratic
/// quadrilaterals, with a quarter of the error, lose less (0.27, 0.23, within their bound),
/// and linear cells are not affected.
const CORNER_LOSS: f64 = 0.2;

/// Checks the observed orders of stiffness entries (name, index on the diagonal, closed
/// form) over three meshes for all kinds of cells; `loss` is the reduction of the least
/// order of quadratic triangles.
fn check_orders(
    what: &str,
    cells: impl Fn(&Family) -> [usize; 3],
    section: impl Fn(usize, CellKind) -> Section,
    loss: f64,
    entries: &[(&str, usize, f64)],
) {
    for family in &FAMILIES {
        for &kind in family.kinds {
            let sees_corner = kind == CellKind::Triangle6;
            let least = family.order - if sees_corner { loss } else { 0.0 };
            let stiffness = cells(family).map(|n| solved(&section(n, kind)).stiffness);
            for &(name, entry, expected) in entries {
                let [coarse, middle, fine] =
                    stiffness.map(|k| relative_error(k[(entry, entry)], expected));
                let orders = [(coarse / middle).log2(), (middle / fine).log2()];
                println!(
                    "{what} {name} {kind:?}: errors {coarse:.1e} {middle:.1e} {fine:.1e}, \
                     orders {orders:.2?}"
                );
                let source = match (what.starts_with("ortho"), name.starts_with("shear")) {
                    (true, _) => OFF_AXIS,
                    (_, true) => SHEAR,
                    _ => SAINT_VENANT,
                };
                let quantity = format!("{name}, order of {}", cells_of(kind));
                for order in orders {
                    record::order(source, what, &quantity, order, least);
                    assert!(order >= least, "{what} {name} {kind:?}: order {order}");
                }
            }
        }
    }
}

/// The kind of cell as named on the validation page.
pub fn cells_of(kind: CellKind) -> String {
    let shape = match kind.corner_count() {
        3 => "triangles",
        _ => "quadrilaterals",
    };
    format!("{}-node {shape}", kind.node_count())
}

pub fn rectangle(width: f64, height: f64, cells: [usize; 2], kind: CellKind) -> Mesh {
    Rectangle {
        width,
        height,
        cells_y: cells[0],
        cells_z: cells[1],
        kind,
        name: "bar".into(),
    }
    .generate()
    .expect("sound measures")
}

pub fn ellipse(semi_y: f64, semi_z: f64, cells: usize, kind: CellKind) -> Mesh {
    Ellipse {
        semi_y,
        semi_z,
        cells,
        kind,
        curved: true,
    }
    .generate()
    .expect("sound measures")
}

fn tube(inner: f64, outer: f64, cells: usize, kind: CellKind) -> Mesh {
    Tube {
        outer_radius: outer,
        thickness: outer - inner,
        cells_around: 8 * cells,
        cells_through: cells,
        kind,
        curved: true,
    }
    .generate()
    .expect("sound measures")
}

/// Saint-Venant torsion constant of a rectangle [m^4]:
/// `J = a b^3 (1/3 - 64/pi^5 b/a sum_{n odd} tanh(n pi a / 2b) / n^5)`, [saint-venant],
/// (S-35).
///
/// Terms decrease with n^-5: the error of 200 terms is less than 1e-12.
pub fn torsion_constant(a: f64, b: f64) -> f64 {
    let (a, b) = (a.max(b), a.min(b));
    let term = |n: f64| (n * PI * a / (2.0 * b)).tanh() / n.powi(5);
    let sum: f64 = (0..200).map(|k| term(f64::from(2 * k + 1))).sum();
    a * b.powi(3) * (1.0 / 3.0 - 64.0 / PI.powi(5) * (b / a) * sum)
}

/// Shear factor of a rectangle, r = size across the shear / size along it:
/// `1/k = 6/5 + (nu/(1+nu))^2 r^4 (1/5 - 18/pi^5 r sum tanh(m pi/r) / m^5)`, [renton].
fn rectangle_shear_factor(nu: f64, r: f64) -> f64 {
    let sum: f64 = (1..400)
        .map(|m| (f64::from(m) * PI / r).tanh() / f64::from(m).powi(5))
        .sum();
    let series = 0.2 - 18.0 / PI.powi(5) * r * sum;
    1.0 / (1.2 + (nu / (1.0 + nu)).powi(2) * r.powi(4) * series)
}

/// Shear factor of a circular tube, m = inner / outer radius, [schramm]; m = 0 is
/// the full circle, `6 (1+nu)^2 / (7 + 14 nu + 8 nu^2)`, [renton]; m = 1 the thin
/// tube, 1/2.
fn tube_shear_factor(nu: f64, m: f64) -> f64 {
    let n = (1.0 + m * m).powi(2);
    6.0 * (1.0 + nu).powi(2) * n
        / ((7.0 + 14.0 * nu + 8.0 * nu * nu) * n + 4.0 * m * m * (5.0 + 10.0 * nu + 4.0 * nu * nu))
}

/// Reciprocal shear factor of the full circle of radius 1 by definition,
/// `A int tau^2 dA` for a unit shear force, with the stresses of [saint-venant]:
///
/// ```text
/// tau_xz = (3 + 2 nu) / (8 (1 + nu) I) (1 - z^2 - (1 - 2 nu)/(3 + 2 nu) y^2)
/// tau_xy = -(1 + 2 nu) / (4 (1 + nu) I) y z
/// ```
///
/// Polynomials of degree 4: four Gauss points along the radius and sixteen steps
/// around integrate them exactly.
fn circle_shear_energy(nu: f64) -> f64 {
    let inertia = PI / 4.0;
    let mut energy = 0.0;
    for &(abscissa, weight) in quadrature::line(4) {
        let radius = 0.5 * (1.0 + abscissa);
        for step in 0..16 {
            let (sin, cos) = (f64::from(step) * PI / 8.0).sin_cos();
            let (y, z) = (radius * cos, radius * sin);
            let along = (3.0 + 2.0 * nu) / (8.0 * (1.0 + nu) * inertia)
                * (1.0 - z * z - (1.0 - 2.0 * nu) / (3.0 + 2.0 * nu) * y * y);
            let across = -(1.0 + 2.0 * nu) / (4.0 * (1.0 + nu) * inertia) * y * z;
            let area = 0.5 * weight * radius * PI / 8.0;
            energy += area * (along * along + across * across);
        }
    }
    PI * energy
}

/// The closed forms against printed values, limits, and for the circle against the
/// energy of its stresses. Torsion: 0.1406, 0.229, 0.291 for 1, 2, 5 in the table of
/// [saint-venant]. Rectangle without Poisson contraction: 5/6. Thin tube: 1/2.
#[test]
fn the_closed_forms_meet_their_tables() {
    for (ratio, expected) in [(1.0, 0.1406), (2.0, 0.229), (5.0, 0.291)] {
        assert!((torsion_constant(ratio, 1.0) / ratio - expected).abs() < 5e-4);
    }
    assert!((rectangle_shear_factor(0.0, 2.0) - 5.0 / 6.0).abs() < 1e-15);
    for nu in [0.0, 0.2, NU, 0.49] {
        assert!((tube_shear_factor(nu, 1.0) - 0.5).abs() < 1e-15);
        assert!((tube_shear_factor(nu, 0.0) * circle_shear_energy(nu) - 1.0).abs() < 1e-13);
    }
}

/// Square of side 1, E = 1: EA = 1, EI = 1/12. Quadratic cells contain the exact field
/// (Poisson contraction quadratic in y, z), so that the error is only round-off.
#[test]
fn square_extension_and_bending_are_exact() {
    for kind in QUADRATIC {
        for nu in [0.0, NU] {
            let mesh = rectangle(1.0, 1.0, [4, 4], kind);
            let k = solved(&uniform(&mesh, isotropic(1.0, nu), 0.0)).stiffness;
            for (i, name, expected) in [
                (0, "axial", 1.0),
                (4, "bending y", 1.0 / 12.0),
                (5, "bending z", 1.0 / 12.0),
            ] {
                let error = relative_error(k[(i, i)], expected);
                let compared = [k[(i, i)], expected];
                record::value(SAINT_VENANT, "square", name, compared, error, 1e-12);
                assert!(error < 1e-12, "{kind:?} nu {nu} {name}");
            }
        }
    }
}

/// Linear cells do not contain the Poisson contraction of bending: second order.
#[test]
fn square_bending_converges_with_linear_cells() {
    for kind in LINEAR {
        let errors = [8, 16].map(|n| {
            let mesh = rectangle(1.0, 1.0, [n, n], kind);
            let k = solved(&uniform(&mesh, isotropic(1.0, NU), 0.0)).stiffness;
            relative_error(k[(4, 4)], 1.0 / 12.0)
        });
        assert!(
            (errors[0] / errors[1]).log2() >= 1.9,
            "{kind:?}: {errors:?}"
        );
    }
}

/// Torsion and both shears of a square against the series of Saint-Venant
/// ([`torsion_constant`], [`rectangle_shear_factor`]).
#[test]
fn square_torsion_and_shear_converge() {
    let g = 1.0 / (2.0 * (1.0 + NU));
    let shear = g * rectangle_shear_factor(NU, 1.0);
    check_orders(
        "square",
        |family| family.rectangle,
        |n, kind| uniform(&rectangle(1.0, 1.0, [n, n], kind), isotropic(1.0, NU), 0.0),
        CORNER_LOSS,
        &[
            ("shear y", 1, shear),
            ("shear z", 2, shear),
            ("torsion", 3, g * torsion_constant(1.0, 1.0)),
        ],
    );
}

/// Rectangles of width/depth r: the shear factors along the depth of [renton] for nu = 0.3,
/// six digits, and the torsion series. The tolerance is the error of 16 quadratic cells per
/// side by the errors and orders above, 1e-5, and ten times that for cells stretched to
/// 5:1.
#[test]
fn rectangles_have_their_shear_factors_and_torsion() {
    let g = 1.0 / (2.0 * (1.0 + NU));
    for (r, factor, tolerance) in [
        (0.5, 0.832942, 2e-5),
        (1.0, 0.828217, 2e-5),
        (2.0, 0.784442, 2e-5),
        (5.0, 0.478054, 2e-4),
    ] {
        assert!((rectangle_shear_factor(NU, r) - factor).abs() < 1e-6);
        for kind in [CellKind::Quadrilateral8, CellKind::Quadrilateral9] {
            let mesh = rectangle(r, 1.0, [16, 16], kind);
            let k = solved(&uniform(&mesh, isotropic(1.0, NU), 0.0)).stiffness;
            let case = format!("rectangle, width / depth = {r}");
            for (i, source, name, expected) in [
                (2, SHEAR, "shear z", rectangle_shear_factor(NU, r) * g * r),
                (3, SAINT_VENANT, "torsion", g * torsion_constant(r, 1.0)),
            ] {
                let error = relative_error(k[(i, i)], expected);
                println!("{case} {kind:?}: {name} {error:.1e}");
                record::value(source, &case, name, [k[(i, i)], expected], error, tolerance);
                assert!(error < tolerance, "{case} {kind:?}: {name} {error:e}");
            }
        }
    }
}

/// Ellipse 2:1: `GJ = G pi a^3 b^3 / (a^2 + b^2)`, [saint-venant], (S-36), and EA, EI of the
/// area. Curved sides: the boundary is approximated to fourth order.
#[test]
fn ellipse_torsion_and_bending_converge() {
    let (a, b) = (2.0_f64, 1.0_f64);
    let g = 1.0 / (2.0 * (1.0 + NU));
    check_orders(
        "ellipse",
        |family| family.round,
        |n, kind| uniform(&ellipse(a, b, n, kind), isotropic(1.0, NU), 0.0),
        0.0,
        &[
            ("axial", 0, PI * a * b),
            ("torsion", 3, g * PI * (a * b).powi(3) / (a * a + b * b)),
            ("bending y", 4, PI * a * b.powi(3) / 4.0),
            ("bending z", 5, PI * a.powi(3) * b / 4.0),
        ],
    );
}

/// Shear of the ellipse 2:1, which has no closed form here: the order follows from the
/// differences of three meshes, `log2 |k(n) - k(2n)| / |k(2n) - k(4n)|`.
#[test]
fn ellipse_shear_converges() {
    for (kind, bound) in [
        (CellKind::Quadrilateral4, 1.9),
        (CellKind::Quadrilateral8, 3.7),
        (CellKind::Quadrilateral9, 3.7),
    ] {
        let [coarse, middle, fine] = [4, 8, 16].map(|n| {
            let mesh = ellipse(2.0, 1.0, n, kind);
            solved(&uniform(&mesh, isotropic(1.0, NU), 0.0)).stiffness
        });
        for i in [1, 2] {
            let at = |matrix: &nalgebra::Matrix6<f64>| matrix[(i, i)];
            let first = (at(&coarse) - at(&middle)).abs();
            let second = (at(&middle) - at(&fine)).abs();
            let order = (first / second).log2();
            println!("{kind:?} shear {i}: {} order {order:.2}", at(&fine));
            assert!(order >= bound, "{kind:?} shear {i}: order {order:.2}");
        }
    }
}

/// Circle: shear factor `6 (1+nu)^2 / (7 + 14 nu + 8 nu^2)`, [renton], and polar moment.
#[test]
fn circle_shear_and_torsion_converge() {
    let g = 1.0 / (2.0 * (1.0 + NU));
    let shear = g * PI * tube_shear_factor(NU, 0.0);
    check_orders(
        "circle",
        |family| family.round,
        |n, kind| uniform(&ellipse(1.0, 1.0, n, kind), isotropic(1.0, NU), 0.0),
        0.0,
        &[
            ("shear y", 1, shear),
            ("shear z", 2, shear),
            ("torsion", 3, g * PI / 2.0),
        ],
    );
}

/// Tube with inner / outer radius 0.8: shear factor of [schramm] (0.510133), polar
/// moment.
#[test]
fn tube_shear_and_torsion_converge() {
    let (inner, outer) = (0.8_f64, 1.0_f64);
    let g = 1.0 / (2.0 * (1.0 + NU));
    let area = PI * (outer.powi(2) - inner.powi(2));
    let polar = PI * (outer.powi(4) - inner.powi(4)) / 2.0;
    assert!((tube_shear_factor(NU, 0.8) - 0.510133).abs() < 1e-6);
    let shear = g * area * tube_shear_factor(NU, 0.8);
    check_orders(
        "tube",
        |family| family.round,
        |n, kind| uniform(&tube(inner, outer, n, kind), isotropic(1.0, NU), 0.0),
        0.0,
        &[
            ("shear y", 1, shear),
            ("shear z", 2, shear),
            ("torsion", 3, g * polar),
        ],
    );
}

/// A carbon ply; fiber in planes z = constant.
const PLY: EngineeringConstants = EngineeringConstants {
    e1: 20.0,
    e2: 1.4,
    e3: 1.3,
    g12: 0.8,
    g13: 0.7,
    g23: 0.5,
    nu12: 0.3,
    nu13: 0.32,
    nu23: 0.4,
};

/// Compliance of the ply turned by theta: along x, and between extension along x
/// and shear xy, [lekhnitskii].
fn off_axis_compliance(theta: f64) -> (f64, f64) {
    let (sin, cos) = theta.sin_cos();
    let mixed = 2.0 * PLY.nu12 / PLY.e1 - 1.0 / PLY.g12;
    let s11 = cos.powi(4) / PLY.e1 - mixed * (sin * cos).powi(2) + sin.powi(4) / PLY.e2;
    let s16 =
        (2.0 / PLY.e1 + mixed) * sin * cos.powi(3) - (2.0 / PLY.e2 + mixed) * sin.powi(3) * cos;
    (s11, s16)
}

/// Rectangle 2 x 1 with fibers off the axis, [lekhnitskii]: the fields of extension
/// and bending are quadratic, so that quadratic cells give the compliance exactly:
/// C11 = S11/A, C12 = S16/A, C55 = S11/Iy, C66 = S11/Iz, C45 = -S16/(2 Iy) (S-37).
#[test]
fn off_axis_rectangle_is_exact() {
    let (width, height) = (2.0_f64, 1.0_f64);
    let area = width * height;
    let (iy, iz) = (width * height.powi(3) / 12.0, width.powi(3) * height / 12.0);
    for kind in QUADRATIC {
        for degrees in [0.0_f64, 15.0, 30.0, 45.0] {
            let theta = degrees.to_radians();
            let mesh = rectangle(width, height, [6, 4], kind);
            let c = solved(&uniform(&mesh, orthotropic(PLY), theta)).compliance;
            let (s11, s16) = off_axis_compliance(theta);
            for (i, j, expected) in [
                (0, 0, s11 / area),
                (0, 1, s16 / area),
                (4, 4, s11 / iy),
                (5, 5, s11 / iz),
                (3, 4, -s16 / (2.0 * iy)),
                (0, 4, 0.0),
                (0, 5, 0.0),
            ] {
                let error = (c[(i, j)] - expected).abs() / (c[(i, i)] * c[(j, j)]).sqrt();
                let case = format!("rectangle, fibers at {degrees} degrees");
                let quantity = format!("compliance {}, {}", i + 1, j + 1);
                let compared = [c[(i, j)], expected];
                record::value(OFF_AXIS, &case, &quantity, compared, error, 1e-12);
                assert!(
                    error < 1e-12,
                    "{kind:?} {degrees} deg ({i}, {j}): {error:e}"
                );
            }
        }
    }
}

/// Torsion of an orthotropic rectangle, [lekhnitskii]: with s = sqrt(Gxz / Gxy) the
/// coordinate z / s makes the problem isotropic, `GJ = Gxy s^3 J(width, height / s)`.
#[test]
fn orthotropic_torsion_converges() {
    let ply = EngineeringConstants {
        g12: 2.0,
        g13: 1.0,
        ..PLY
    };
    let (width, height) = (1.5, 1.0);
    let s = (ply.g13 / ply.g12).sqrt();
    let expected = ply.g12 * s.powi(3) * torsion_constant(width, height / s);
    check_orders(
        "orthotropic rectangle",
        |family| family.rectangle,
        |n, kind| {
            uniform(
                &rectangle(width, height, [n, n], kind),
                orthotropic(ply),
                0.0,
            )
        },
        CORNER_LOSS,
        &[("torsion", 3, expected)],
    );
}

/// Extension and bending of a rectangle whose part `y < split` has modulus `first`
/// and the rest `second`, from the areas.
fn two_part_stiffness(width: f64, height: f64, split: f64, moduli: [f64; 2]) -> Matrix6<f64> {
    let mut k = Matrix6::zeros();
    let parts = [(-width / 2.0, split), (split, width / 2.0)];
    for ((left, right), e) in parts.into_iter().zip(moduli) {
        let area = (right - left) * height;
        let first = 0.5 * (right * right - left * left) * height;
        k[(0, 0)] += e * area;
        k[(0, 5)] -= e * first;
        k[(4, 4)] += e * area * height * height / 12.0;
        k[(5, 5)] += e * (right.powi(3) - left.powi(3)) / 3.0 * height;
    }
    k[(5, 0)] = k[(0, 5)];
    k
}

fn check_two_parts(moduli: [f64; 2], tolerance: f64) {
    let (width, height, split) = (2.0, 1.0, -0.25);
    let expected = two_part_stiffness(width, height, split, moduli);
    for kind in QUADRATIC {
        let mesh = rectangle(width, height, [16, 6], kind);
        let materials = moduli.map(|young| isotropic(young, NU));
        let k = solved(&of_two(&mesh, materials, |[y, _]| y < split)).stiffness;
        for i in [0, 4, 5] {
            for j in [0, 4, 5] {
                let scale = (expected[(i, i)] * expected[(j, j)]).sqrt();
                let error = (k[(i, j)] - expected[(i, j)]).abs() / scale;
                let [first, second] = moduli;
                let case = format!("two materials, moduli {first:e} and {second:e}");
                let quantity = "extension, bending, couplings";
                record::largest(SUMS, &case, quantity, error, tolerance);
                assert!(
                    error < tolerance,
                    "{kind:?} {moduli:?} ({i}, {j}): {error:e}"
                );
            }
        }
    }
}

/// Two materials of equal Poisson's ratio: the parts contract equally, so that extension
/// and bending are sums over the areas, exactly.
#[test]
fn two_materials_of_equal_poisson_ratio_add_up() {
    check_two_parts([10.0, 1.0], 1e-12);
}

/// The same with moduli in the ratio 1e9, in either order: only a few digits may be lost.
#[test]
fn moduli_far_apart_keep_the_digits() {
    check_two_parts([1e9, 1.0], 1e-11);
    check_two_parts([1.0, 1e9], 1e-11);
    check_two_parts([210e9, 210.0], 1e-11);
}

/// Two materials of unequal Poisson's ratio hinder each other's contraction: the stiffness
/// exceeds the sums, but by at most the factor of plane strain, `1 / (1 - nu^2)`.
#[test]
fn unequal_poisson_ratios_stiffen() {
    let mesh = rectangle(1.0, 2.0, [8, 16], CellKind::Quadrilateral9);
    let materials = [isotropic(10.0, 0.3), isotropic(1.0, 0.1)];
    let k = solved(&of_two(&mesh, materials, |[_, z]| z < 0.0)).stiffness;
    for (found, sum) in [(k[(0, 0)], 11.0), (k[(4, 4)], 11.0 / 3.0)] {
        assert!(found > sum * (1.0 + 1e-6), "{found} against {sum}");
        assert!(found < sum / (1.0 - 0.3 * 0.3), "{found} against {sum}");
    }
}

/// Principal axes of a parallelogram off the origin, by integration: about an axis at the
/// angle phi from y, through the centroid,
///
/// ```text
/// I(phi) = Iyy cos^2 + Izz sin^2 - 2 Iyz sin cos       I' = 0 where it is principal
/// Iyy = b h^3/12      Iyz = s Iyy      Izz = b^3 h/12 + s^2 Iyy      (y + s z, z)
/// ```
///
/// Bending stiffness E I without Poisson's ratio and inertia rho I are exact on cells of
/// degree two.
#[test]
fn principal_axes_are_those_of_the_moments_of_area() {
    let (b, h, slope, young, density) = (2.0, 0.5, 0.8, 3.0, 7.0);
    let mesh = rectangle(b, h, [4, 2], CellKind::Quadrilateral9);
    let mut material = isotropic(young, 0.0);
    material.density = density;
    let mut section = uniform(&mesh, material, 0.0);
    for [y, z] in &mut section.mesh.nodes {
        (*y, *z) = (*y + slope * *z + 0.4, *z - 0.7);
    }
    let iyy = b * f64::powi(h, 3) / 12.0;
    let (iyz, izz) = (
        slope * iyy,
        f64::powi(b, 3) * h / 12.0 + slope * slope * iyy,
    );
    let moment = |phi: f64| {
        let (s, c) = phi.sin_cos();
        iyy * c * c + izz * s * s - 2.0 * iyz * s * c
    };
    let rate = |phi: f64| (izz - iyy) * (2.0 * phi).sin() - 2.0 * iyz * (2.0 * phi).cos();
    let solution = solved(&section);
    let inertia = solution.principal_inertia.expect("has mass");
    for (name, axes, unit) in [
        ("bending", solution.principal_bending, young),
        ("inertia", inertia, density),
    ] {
        let found = [axes.first, axes.second].map(|value| value / unit);
        let expected = [moment(axes.angle), moment(axes.angle + 0.5 * PI)];
        for (found, expected) in found.into_iter().zip(expected) {
            let error = relative_error(found, expected);
            assert!(error < 1e-12, "{name}: {found} {expected}");
        }
        // round-off of the eigenvector of values that differ by a factor of twenty
        assert!(rate(axes.angle).abs() < 1e-13, "{name}: {}", axes.angle);
        assert!(axes.angle.abs() > 0.01, "the axes are turned");
    }
}

/// Principal axes of bending of a ply off the axis, [lekhnitskii]: bending alone, with all
/// other internal forces zero, has the stiffness I/S11 about the axes of symmetry of a
/// rectangle, for any position and angle. The block of the stiffness matrix, for zero twist
/// and shears, differs: about y by 60 % more.
#[test]
fn principal_axes_of_an_off_axis_ply_are_those_of_bending_alone() {
    let (width, height, degrees) = (2.0_f64, 1.0_f64, 25.0_f64);
    let (iy, iz) = (width * height.powi(3) / 12.0, width.powi(3) * height / 12.0);
    let (s11, _) = off_axis_compliance(degrees.to_radians());
    let mesh = rectangle(width, height, [6, 4], CellKind::Quadrilateral9);
    let bar = uniform(&mesh, orthotropic(PLY), degrees.to_radians());
    let held = solved(&bar).stiffness;
    assert!(held[(4, 4)] > 1.5 * iy / s11);
    for (turn, y0, z0) in [(0.0_f64, 0.0, 0.0), (0.0, 0.4, -0.7), (0.3, 0.4, -0.7)] {
        let (s, c) = turn.sin_cos();
        let mut section = bar.clone();
        for [y, z] in &mut section.mesh.nodes {
            (*y, *z) = (y0 + c * *y - s * *z, z0 + s * *y + c * *z);
        }
        for cell in &mut section.cells {
            cell.plane_angle = turn;
        }
        let axes = solved(&section).principal_bending;
        // the axis nearest to y, and the other
        let from_y = axes.angle - turn;
        let (about_y, about_z, angle) = if from_y.cos().abs() > 0.7 {
            (axes.first, axes.second, from_y)
        } else {
            (axes.second, axes.first, from_y - 0.5 * PI)
        };
        let case = format!("rectangle, fibers at 25 degrees, at ({y0}, {z0}), turned by {turn}");
        for (name, found, expected) in [
            ("principal bending about y, I/S11", about_y, iy / s11),
            ("principal bending about z, I/S11", about_z, iz / s11),
        ] {
            let error = relative_error(found, expected);
            record::value(OFF_AXIS, &case, name, [found, expected], error, 1e-10);
            assert!(error < 1e-10, "{case}, {name}: {found} {expected}");
        }
        assert!(angle.sin().abs() < 1e-10, "{case}: {angle}");
        record::largest(
            OFF_AXIS,
            &case,
            "principal axes, sine of the angle to the sides",
            angle.sin().abs(),
            1e-10,
        );
    }
}
