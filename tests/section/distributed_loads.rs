//! Distributed loads against polynomial solutions of the theory of elasticity.
//!
//! # References
//! - [TimoshenkoGoodier] article 22: narrow beam under uniform pressure, its stresses
//!   and the curvature of its center line; article 28: thick ring under pressure.
//!   `tests/reference/theory/distributed.json`.

use nalgebra::{Vector3, Vector6};
use section_analyzer::analysis::Analysis;
use section_analyzer::material::{EngineeringConstants, Material};
use section_analyzer::mesh::generate::Rectangle;
use section_analyzer::recovery::{LoadCase, Recoverer, Recovery};
use section_analyzer::section::{
    Action, DistributedForce, DistributedLoad, Section, Traction, VolumeForce,
};
use section_analyzer::solution::DistributedState;
use shared_geom::mesh::{CellKind, Mesh};
use shared_geom::section::InitialCurvature;

use crate::record;
use crate::reference_cases::number;
use crate::sections::{isotropic, of_two, orthotropic, relative_error, uniform};

const NARROW: &str = "Narrow beam under distributed load";
const RING: &str = "Thick ring";

fn rectangle(width: f64, height: f64, cells: [usize; 2]) -> Mesh {
    let rectangle = Rectangle {
        width,
        height,
        cells_y: cells[0],
        cells_z: cells[1],
        kind: CellKind::Quadrilateral9,
        name: "bar".into(),
    };
    rectangle.generate().expect("sound measures")
}

fn on_curve(section: &Section, label: &str, traction: Traction, along: &[f64]) -> DistributedLoad {
    let mesh = &section.mesh;
    let curve = mesh.curves.iter().find(|curve| curve.label == label);
    let sides = mesh.sides_of_curve(curve.expect("a curve of the generator"));
    let action = Action::Traction {
        sides: sides.expect("sides of cells"),
        traction,
    };
    load(action, along)
}

fn in_volume(force: VolumeForce, along: &[f64]) -> DistributedLoad {
    load(Action::Volume { group: None, force }, along)
}

fn load(action: Action, along: &[f64]) -> DistributedLoad {
    let along = along.to_vec();
    DistributedLoad {
        parts: vec![DistributedForce { action, along }],
    }
}

fn state(analysis: &Analysis<'_>, load: &DistributedLoad) -> DistributedState {
    let found = analysis.distributed(&[load]);
    let mut found = found.unwrap_or_else(|failure| panic!("{failure}"));
    let state = found.pop().expect("one load");
    // the work on the central solutions, at round-off
    assert!(state.error < 1e-10, "{:e}", state.error);
    state
}

fn analysis(section: &Section) -> Analysis<'_> {
    Analysis::new(section).unwrap_or_else(|failure| panic!("{failure}"))
}

/// Stresses under a load and the internal force `theta` at the section.
fn recovered(section: &Section, load: &DistributedLoad, theta: Vector6<f64>) -> Recovery {
    let analysis = analysis(section);
    let state = state(&analysis, load);
    let recovery = Recoverer::new(section, analysis.solution())
        .recover_with(&LoadCase::at_point("load", &theta, [0.0; 2]), &state)
        .unwrap_or_else(|failure| panic!("{failure}"));
    assert!(recovery.resultant_error < 1e-10);
    recovery
}

/// Largest difference of a stress (order xx yy zz yz xz xy) from `exact` at the
/// integration points, relative to the largest of `exact` there.
fn error(recovery: &Recovery, component: usize, exact: impl Fn([f64; 2]) -> f64) -> f64 {
    let (mut worst, mut scale) = (0.0_f64, 0.0_f64);
    for point in &recovery.points {
        let expected = exact(point.position);
        worst = worst.max((point.tensors.stress[component] - expected).abs());
        scale = scale.max(expected.abs());
    }
    worst / scale
}

/// Width and half height of the narrow beams, as in the reference.
const WIDTH: f64 = 0.5;
const C: f64 = 1.0;

fn beam(cells: usize, material: Material) -> Section {
    uniform(&rectangle(WIDTH, 2.0 * C, [1, cells]), material, 0.0)
}

/// A stress of a narrow beam: component (order xx yy zz yz xz xy), name, closed form, and
/// the bound of its error with 16 cells.
type Stress<'a> = (usize, &'a str, &'a dyn Fn([f64; 2]) -> f64, f64);

/// The stresses of a narrow beam under a load and no internal force, with 8, 16 and 32
/// cells: their errors at the integration points decrease with the square of the cell size
/// or faster, as expected for quadratic cells.
fn check_beam(
    case: &str,
    load: impl Fn(&Section) -> DistributedLoad,
    stresses: &[Stress<'_>],
) -> [Recovery; 3] {
    let found = [8, 16, 32].map(|cells| {
        let section = beam(cells, isotropic(1.0, 0.0));
        recovered(&section, &load(&section), Vector6::zeros())
    });
    for (component, name, exact, bound) in stresses {
        let errors = [0, 1, 2].map(|i: usize| error(&found[i], *component, exact));
        println!("{case} {name}: {errors:?}");
        record::largest(
            NARROW,
            &format!("{case}, 16 cells"),
            name,
            errors[1],
            *bound,
        );
        assert!(errors[1] < *bound, "{case} {name}: {errors:?}");
        for pair in errors.windows(2) {
            let order = (pair[0] / pair[1]).log2();
            record::order(NARROW, case, &format!("{name}, order"), order, 1.8);
            assert!(order > 1.8, "{case} {name}: {order}");
        }
    }
    found
}

/// sigma_xx and sigma_zz under a pressure of 1 per length on the upper face. sigma_xx, of
/// third degree, follows from the warping along x, of the third order, and is more accurate
/// in the middle of the cells: the prototype of the theory has 1.5e-5 and 1.8e-3 at a
/// column of points with 16 cells.
#[test]
fn uniform_pressure_on_a_narrow_beam() {
    let text = std::fs::read_to_string(concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/tests/reference/theory/distributed.json"
    ));
    let case: serde_json::Value =
        serde_json::from_str(&text.expect("the reference")).expect("the reference");
    assert_eq!([number(&case["E"]), number(&case["nu"])], [1.0, 0.0]);
    let q = 1.0 / WIDTH;
    let inertia = 2.0 * C.powi(3) / 3.0;
    let xx = |[_, z]: [f64; 2]| {
        let y = -z;
        q / (2.0 * inertia) * (2.0 / 3.0 * y.powi(3) - 2.0 / 5.0 * C * C * y)
    };
    let zz = |[_, z]: [f64; 2]| {
        let y = -z;
        -q / (2.0 * inertia) * (y.powi(3) / 3.0 - C * C * y + 2.0 / 3.0 * C.powi(3))
    };
    let load = |section: &Section| on_curve(section, "top", Traction::Pressure(q), &[1.0]);
    let stresses: [Stress<'_>; 2] = [(0, "sigma_xx", &xx, 3e-4), (2, "sigma_zz", &zz, 1.8e-3)];
    let [_, mut found, _] = check_beam("uniform pressure", load, &stresses);
    // the fifth of nine points is the middle of the cell
    let mut count = 0;
    found.points.retain(|_| {
        count += 1;
        count % 9 == 5
    });
    let worst = found.points.iter().map(|point| {
        let expected = xx(point.position);
        (point.tensors.stress[0] - expected).abs()
    });
    // relative to the largest over the height, which is at the faces
    let error = worst.fold(0.0, f64::max) / xx([0.0, C]).abs();
    println!("in the middle of cells: {error:e}");
    let name = "sigma_xx in the middle of cells";
    record::largest(NARROW, "uniform pressure, 16 cells", name, error, 1.5e-5);
    assert!(error < 1.5e-5, "{error:e}");
}

/// A pressure q1 x on the upper face, at x = 0, where load and internal force are zero:
/// only the shear remains, which balances the increase of sigma_xx = q1 x g(z),
///
/// ```text
/// tau_xz = q1/(2I) (z^4/6 - c^2 z^2/5 + c^4/30)
/// ```
#[test]
fn pressure_that_grows_along_a_narrow_beam() {
    let q = 3.0 / WIDTH;
    let inertia = 2.0 * C.powi(3) / 3.0;
    let xz = |[_, z]: [f64; 2]| {
        let polynomial = z.powi(4) / 6.0 - C * C * z * z / 5.0 + C.powi(4) / 30.0;
        q / (2.0 * inertia) * polynomial
    };
    let load = |section: &Section| on_curve(section, "top", Traction::Pressure(q), &[0.0, 1.0]);
    let stresses: [Stress<'_>; 1] = [(4, "tau_xz", &xz, 3e-2)];
    let [_, recovery, _] = check_beam("linear pressure", load, &stresses);
    let others = [0, 1, 2, 3, 5].map(|component| {
        let values = recovery.points.iter();
        values.fold(0.0_f64, |worst, p| {
            worst.max(p.tensors.stress[component].abs())
        })
    });
    assert!(others.iter().all(|value| *value < 1e-10 * q), "{others:?}");
}

/// A pressure q2 x^2/2 on the upper face, at x = 0, where load and internal force are zero.
/// The stress function of plane stress is a sum of functions of z times the bending moment
/// M and even derivatives of the load, with M,xx F0 = q G,
///
/// ```text
/// phi = M F0 + q F1 + q,xx F2        sigma_zz = phi,xx        sigma_xx = phi,zz
/// G,zzzz = 0 ,    F1,zzzz = -2 G,zz ,    F2,zzzz = -2 F1,zz - G
/// G  = -(1/2 + 3 z/(4c) - z^3/(4c^3))                 the pressure at z = c, none at z = -c
/// F1 = -z (z^2 - c^2)^2/(40 c^3)
/// F2,zz = z^2/4 - c^2/12 + 3 z^5/(80 c^3) + z^3/(40 c) - 87/2800 c^2 z/c
/// ```
///
/// where F1, F2 and their slopes are zero at both faces, so that they have no resultant
/// force or moment. Here sigma_xx = q2 F2,zz and sigma_zz = q2 F1.
#[test]
fn pressure_that_is_a_parabola_along_a_narrow_beam() {
    let q = 3.0;
    let xx = |[_, z]: [f64; 2]| {
        let even = z * z / 4.0 - C * C / 12.0;
        let odd = 3.0 * z.powi(5) / (80.0 * C.powi(3)) + z.powi(3) / (40.0 * C);
        q * (even + odd - 87.0 / 2800.0 * C * z)
    };
    let zz = |[_, z]: [f64; 2]| -q * z * (z * z - C * C).powi(2) / (40.0 * C.powi(3));
    let along = [0.0, 0.0, 0.5];
    let load = |section: &Section| on_curve(section, "top", Traction::Pressure(q), &along);
    // of fifth degree, the next one above the degree of the warping: a tenth of (1/16)^2
    let case = "parabolic pressure";
    let stresses: [Stress<'_>; 1] = [(0, "sigma_xx", &xx, 4e-4)];
    let found = check_beam(case, load, &stresses);
    // zero at the faces with its slope: the order of strains is not yet reached there, and
    // the error is about (1/16)^2 times five
    let errors = [0, 1, 2].map(|i: usize| error(&found[i], 2, zz));
    println!("{errors:?}");
    let name = "sigma_zz";
    record::largest(
        NARROW,
        "parabolic pressure, 16 cells",
        name,
        errors[1],
        2e-2,
    );
    assert!(errors[1] < 2e-2, "{errors:?}");
    let orders = [0, 1].map(|i: usize| (errors[i] / errors[i + 1]).log2());
    assert!(orders[0] > 1.5 && orders[1] > orders[0], "{orders:?}");
    let [_, recovery, _] = found;
    let others = [1, 3, 4, 5].map(|component| {
        let values = recovery.points.iter();
        values.fold(0.0_f64, |worst, p| {
            worst.max(p.tensors.stress[component].abs())
        })
    });
    assert!(others.iter().all(|value| *value < 1e-10 * q), "{others:?}");
}

/// Coefficients about x of the polynomial with the given coefficients about zero.
fn about(along: &[f64; 4], x: f64) -> [f64; 4] {
    let [c0, c1, c2, c3] = *along;
    [
        c0 + c1 * x + c2 * x * x + c3 * x.powi(3),
        c1 + 2.0 * c2 * x + 3.0 * c3 * x * x,
        c2 + 3.0 * c3 * x,
        c3,
    ]
}

/// A polynomial load of third degree described at any section is the same load: the warping
/// of neighboring stations, each with the polynomial about its own section and the internal
/// force due to the load there, changes along the beam at the rate of the state of this
/// section,
///
/// ```text
/// d/dx ( X theta(x) + w(x) ) = X T' theta + w'         theta' = T' theta - H' f
/// ```
///
/// theta is of fifth degree, so that differences over six stations are exact.
#[test]
fn polynomials_can_be_distinguished_from_any_section() {
    let section = beam(4, isotropic(1.0, 0.3));
    let analysis = analysis(&section);
    let traction = Traction::Force(Vector3::new(0.2, -0.5, 1.0));
    let along = [1.0, 2.0, -3.0, 1.5];
    let at = |x: f64| {
        let load = on_curve(&section, "right", traction, &about(&along, x));
        state(&analysis, &load)
    };
    let unit = state(&analysis, &on_curve(&section, "right", traction, &[1.0]));
    let tt = analysis.domain().line.equilibrium();
    let central = &analysis.solution().warping;
    let (s, force) = (0.7, Vector6::new(0.3, -0.2, 0.5, 0.1, -0.4, 0.2));
    // derivatives of the internal force at s
    let mut theta = vec![force];
    let mut factorial = 1.0;
    for (order, c) in about(&along, s).into_iter().chain([0.0]).enumerate() {
        factorial *= (order as f64).max(1.0);
        theta.push(tt * theta[order] - unit.force_per_length * (factorial * c));
    }
    let warping = |h: f64| {
        let mut there = Vector6::zeros();
        let mut power = 1.0;
        for (order, derivative) in theta.iter().enumerate() {
            there += derivative * power;
            power *= h / (order as f64 + 1.0);
        }
        central * there + at(s + h).warping
    };
    let h = 0.25;
    let weights = [(1.0, 45.0), (2.0, -9.0), (3.0, 1.0)];
    let parts = weights
        .map(|(steps, weight)| (warping(steps * h) - warping(-steps * h)) * (weight / (60.0 * h)));
    let mut found = nalgebra::DVector::zeros(central.nrows());
    for part in parts {
        found += part;
    }
    let of_force = central * (tt * force);
    let expected = &of_force + at(s).rate;
    // round-off of warpings about ten times as large, over h
    let error = (&found - &expected).amax() / expected.amax();
    println!("{error:e}");
    record::largest(
        NARROW,
        "cubic load from another section",
        "rate of the warping",
        error,
        1e-10,
    );
    assert!(error < 1e-10, "{error:e}");
    // the load itself contributes to it
    assert!((of_force - &expected).amax() > 0.1 * expected.amax());
}

/// Curvature of the center line of a narrow beam under uniform pressure, for any
/// Poisson ratio nu in its plane and none across it:
///
/// ```text
/// v'' = q/(E I) c^2 (4/5 + nu/2)      where the bending moment is zero
/// ```
///
/// In terms of the beam: the rate of the shear strain and the generalized curvature of the
/// load, and the deflection of the center due to the increasing moment,
/// `v'' = C_33 q - y_5 + X_z,M2(0) q`, of which the part of the load is
/// `y_5 = (2/5) nu q c^2/(E I)`.
#[test]
fn curvature_of_the_center_line_of_a_narrow_beam() {
    let (q, nu) = (2.0, 0.3);
    let inertia = WIDTH * 2.0 * C.powi(3) / 3.0;
    let shear = 1.0 / (2.0 * (1.0 + nu));
    let in_plane = orthotropic(EngineeringConstants {
        e1: 1.0,
        e2: 1.0,
        e3: 1.0,
        g12: shear,
        g13: shear,
        g23: shear,
        nu12: 0.0,
        nu13: nu,
        nu23: 0.0,
    });
    let section = beam(16, in_plane);
    let analysis = analysis(&section);
    let load = on_curve(&section, "top", Traction::Pressure(q / WIDTH), &[1.0]);
    let state = state(&analysis, &load);
    let solution = analysis.solution();
    let middle = section
        .mesh
        .nodes
        .iter()
        .position(|position| *position == [0.0; 2]);
    let bulge = solution.warping[(3 * middle.expect("a node in the middle") + 2, 4)];
    let found = solution.compliance[(2, 2)] * q - state.strain[4] + bulge * q;
    let unit = q * C * C / inertia;
    let expected = unit * (4.0 / 5.0 + nu / 2.0);
    // the warping of 16 quadratic cells, of third degree, is exact to h^4 = 2e-5
    let name = "curvature of the center line";
    let error = relative_error(found, expected);
    println!("{error:e}");
    record::value(
        NARROW,
        "uniform pressure, nu = 0.3",
        name,
        [found, expected],
        error,
        2e-5,
    );
    assert!(error < 2e-5, "{found} {expected}");
    let (found, expected) = (state.strain[4], 0.4 * nu * unit);
    let error = relative_error(found, expected);
    println!("{error:e}");
    let name = "bending strain of the load";
    record::value(
        NARROW,
        "uniform pressure, nu = 0.3",
        name,
        [found, expected],
        error,
        2e-5,
    );
    assert!(error < 2e-5, "{found} {expected}");
    // and the pressure across widens the beam: eps_xx = nu q/(2 E A / c) at the middle
    let expected = nu * q * C / (WIDTH * 2.0 * C);
    assert!(relative_error(state.strain[0], expected) < 1e-10);
}

/// A bar that hangs under its weight: sigma_xx = N/A everywhere, and no stress where N is
/// zero, although the bar narrows along the beam; polynomials of second degree, exact on
/// quadratic cells with straight sides.
#[test]
fn hanging_bar() {
    let section = uniform(&rectangle(2.0, 1.0, [3, 2]), isotropic(1.0, 0.3), 0.0);
    let g = 9.81;
    let weight = in_volume(
        VolumeForce::Acceleration(Vector3::new(-g, 0.0, 0.0)),
        &[1.0],
    );
    let force = Vector6::new(5.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    let recovery = recovered(&section, &weight, force);
    let worst = error(&recovery, 0, |_| 5.0 / 2.0);
    record::largest(NARROW, "hanging bar", "sigma_xx", worst, 1e-11);
    assert!(worst < 1e-11, "{worst:e}");
    let free = recovered(&section, &weight, Vector6::zeros());
    let stress = free.points.iter().map(|p| p.tensors.stress.amax());
    assert!(stress.fold(0.0, f64::max) < 1e-11 * g);
    let state = state(&analysis(&section), &weight);
    assert!((state.force_per_length[0] + 2.0 * g).abs() < 1e-12);
    // the warping of the axial force is across the section: no work of the weight
    assert!(state.strain.amax() < 1e-12 * g);
}

/// Weight across a narrow beam: b per volume, with
///
/// ```text
/// sigma_xx = b (z^3/c^2 - 3 z/5)      sigma_zz = b (z - z^3/c^2)/2
/// ```
///
/// from equilibrium and compatibility for nu = 0.
#[test]
fn weight_of_a_narrow_beam() {
    let b = -2.5;
    let xx = |[_, z]: [f64; 2]| b * (z.powi(3) / (C * C) - 0.6 * z);
    let zz = |[_, z]: [f64; 2]| 0.5 * b * (z - z.powi(3) / (C * C));
    let force = VolumeForce::Force(Vector3::new(0.0, 0.0, b));
    let stresses: [Stress<'_>; 2] = [(0, "sigma_xx", &xx, 3e-4), (2, "sigma_zz", &zz, 1e-2)];
    check_beam("weight", |_| in_volume(force, &[1.0]), &stresses);
}

/// Force and moment per length: a weight gives the mass matrix times the acceleration, on
/// curved beams too; a shear along a border gives its length times the shear, with its arm;
/// a pressure acts on the projection of the border.
#[test]
fn forces_per_length_are_resultants() {
    let mesh = rectangle(2.0, 1.0, [4, 2]);
    let mut heavy = isotropic(1.0, 0.3);
    heavy.density = 5.0;
    let mut section = of_two(&mesh, [heavy, isotropic(1.0, 0.3)], |[y, _]| y < 0.0);
    let acceleration = Vector3::new(0.3, -1.0, 2.0);
    let weight = in_volume(VolumeForce::Acceleration(acceleration), &[1.0]);
    for curvature in [[0.0; 3], [0.2, -0.1, 0.15]] {
        section.initial_curvature = InitialCurvature {
            curvature: curvature.into(),
            ..InitialCurvature::STRAIGHT
        };
        let analysis = analysis(&section);
        let found = state(&analysis, &weight).force_per_length;
        let expected = analysis.solution().mass.fixed_columns::<3>(0) * acceleration;
        assert!((found - expected).amax() < 1e-12 * expected.amax());
    }
    section.initial_curvature = InitialCurvature::STRAIGHT;
    let analysis = analysis(&section);
    let of = |label, traction| {
        state(&analysis, &on_curve(&section, label, traction, &[1.0])).force_per_length
    };
    // the upper border runs along +y, at z = 1/2; the lower one along -y
    let shear = of("top", Traction::Tangential(3.0));
    assert!((shear - Vector6::new(0.0, 6.0, 0.0, -3.0, 0.0, 0.0)).amax() < 1e-13);
    let shear = of("bottom", Traction::Tangential(3.0));
    assert!((shear - Vector6::new(0.0, -6.0, 0.0, -3.0, 0.0, 0.0)).amax() < 1e-13);
    let pressure = of("top", Traction::Pressure(3.0));
    assert!((pressure - Vector6::new(0.0, 0.0, -6.0, 0.0, 0.0, 0.0)).amax() < 1e-13);
    let force = of("right", Traction::Force(Vector3::new(1.0, 0.0, 2.0)));
    assert!((force - Vector6::new(1.0, 0.0, 2.0, 2.0, 0.0, -1.0)).amax() < 1e-13);
}

/// Radius of the reference line, height along the radius, and thickness of the ring.
const RADIUS: f64 = 1.0;
const HEIGHT: f64 = 0.5;
const THICK: f64 = 0.2;

/// The section of a ring that is curved toward +y, so that the radius is `1 - y` and the
/// inner face at the right.
fn ring(cells: usize) -> Section {
    let mut section = uniform(
        &rectangle(HEIGHT, THICK, [cells, 1]),
        isotropic(1.0, 0.0),
        0.0,
    );
    section.initial_curvature = InitialCurvature {
        curvature: Vector3::new(0.0, 0.0, 1.0 / RADIUS),
        ..InitialCurvature::STRAIGHT
    };
    section
}

/// N and M_z of the hoop stress of a closed ring, by Simpson's rule.
fn hoop_force(hoop: impl Fn(f64) -> f64) -> Vector6<f64> {
    let steps = 2000;
    let width = HEIGHT / f64::from(steps);
    let (mut force, mut moment) = (0.0, 0.0);
    for i in 0..=steps {
        let factor = match i {
            0 => 1.0,
            i if i == steps => 1.0,
            i if i % 2 == 1 => 4.0,
            _ => 2.0,
        };
        let y = -0.5 * HEIGHT + width * f64::from(i);
        let share = THICK * factor * width / 3.0 * hoop(RADIUS - y);
        force += share;
        moment -= y * share;
    }
    Vector6::new(force, 0.0, 0.0, 0.0, 0.0, moment)
}

/// Stresses of a ring under a load at 8, 16 and 32 cells along the radius, whose errors
/// decrease with the square of the cell size.
fn check_ring(
    case: &str,
    load: impl Fn(&Section) -> DistributedLoad,
    hoop: impl Fn(f64) -> f64 + Copy,
    radial: impl Fn(f64) -> f64 + Copy,
    bound: f64,
) {
    let errors = [8, 16, 32].map(|cells| {
        let section = ring(cells);
        let recovery = recovered(&section, &load(&section), hoop_force(hoop));
        [
            error(&recovery, 0, |[y, _]| hoop(RADIUS - y)),
            error(&recovery, 1, |[y, _]| radial(RADIUS - y)),
        ]
    });
    println!("{case}: {errors:?}");
    for (component, name) in ["hoop stress", "radial stress"].into_iter().enumerate() {
        let [_, middle, fine] = errors.map(|errors| errors[component]);
        record::largest(RING, &format!("{case}, 16 cells"), name, middle, bound);
        assert!(middle < bound, "{case} {name}: {errors:?}");
        let order = (middle / fine).log2();
        record::order(RING, case, &format!("{name}, order"), order, 1.8);
        assert!(order > 1.8, "{case} {name}: {order}");
    }
}

/// Lame's ring: `sigma = A (1 -+ ro^2/r^2)`, A = p ri^2/(ro^2 - ri^2), with the pressure on
/// a surface that is shorter than the reference line.
#[test]
fn ring_under_inner_pressure() {
    let (inner, outer) = (RADIUS - 0.5 * HEIGHT, RADIUS + 0.5 * HEIGHT);
    let p = 2.0;
    let a = p * inner * inner / (outer * outer - inner * inner);
    check_ring(
        "inner pressure",
        |section| on_curve(section, "right", Traction::Pressure(p), &[1.0]),
        |r| a * (1.0 + outer * outer / (r * r)),
        |r| a * (1.0 - outer * outer / (r * r)),
        1e-2,
    );
}

/// A force b per volume outward, the same everywhere: with nu = 0
///
/// ```text
/// u = A r + B/r - b r^2/(3 E)      sigma_hoop = E u/r      sigma_r = E u'
/// ```
#[test]
fn ring_under_a_radial_force() {
    let (inner, outer) = (RADIUS - 0.5 * HEIGHT, RADIUS + 0.5 * HEIGHT);
    let b = 3.0;
    // A - B/r^2 = 2/3 b r at both faces
    let large = 2.0 / 3.0 * b * (outer - inner) / (inner.powi(-2) - outer.powi(-2));
    let a = 2.0 / 3.0 * b * inner + large / (inner * inner);
    check_ring(
        "radial force",
        |_| in_volume(VolumeForce::Force(Vector3::new(0.0, -b, 0.0)), &[1.0]),
        |r| a + large / (r * r) - b * r / 3.0,
        |r| a - large / (r * r) - 2.0 / 3.0 * b * r,
        1e-2,
    );
}
