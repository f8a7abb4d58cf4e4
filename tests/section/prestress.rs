//! Stiffness of loaded sections against a prototype, closed forms and the nonlinear
//! energy of the section.
//!
//! # References
//! - `tests/reference/theory/prestress.json`: the tables of five sections by an independent
//!   program, on the same meshes; they agree there with differences of the forces of the
//!   section in large strain to at least 3e-6.
//! - [HouboltBrooks1958]: a strip under tension N gains N Ip/A in torsion.

use nalgebra::{Matrix4, Vector4, Vector6};
use section_analyzer::analysis::Analysis;
use section_analyzer::material::{EngineeringConstants, Material};
use section_analyzer::mesh::generate::Rectangle;
use section_analyzer::properties::{FreeState, prestress, prestress_of_imposed};
use section_analyzer::section::{FreeStrain, ImposedStrain, Section};
use section_analyzer::solution::SectionSolution;
use serde_json::Value;
use shared_geom::mesh::{CellKind, Mesh};
use shared_geom::section::{CubicTable, PRESTRESS_COMPONENTS, Prestress, StrainMeasure};

use crate::record;
use crate::sections::{isotropic, of_two, orthotropic, relative_error, solved, uniform};

const PROTOTYPE: &str = "Prototype of the cubic energy, on the same mesh";
const CLOSED: &str = "Closed forms of prestressed sections";

const NU: f64 = 0.3;

fn strip(width: f64, height: f64, cells: [usize; 2]) -> Mesh {
    let rectangle = Rectangle {
        width,
        height,
        cells_y: cells[0],
        cells_z: cells[1],
        kind: CellKind::Quadrilateral9,
        name: "strip".into(),
    };
    rectangle.generate().expect("sound measures")
}

fn isotropic_strip(width: f64, height: f64, cells: [usize; 2]) -> Section {
    uniform(&strip(width, height, cells), isotropic(1.0, NU), 0.0)
}

/// Plies of +30 degrees above the middle and of -30 below.
pub fn composite_strip(cells: [usize; 2]) -> Section {
    let ply = |g23: f64| -> Material {
        orthotropic(EngineeringConstants {
            e1: 181.0,
            e2: 10.3,
            e3: 10.3,
            g12: 7.17,
            g13: 7.17,
            g23,
            nu12: 0.28,
            nu13: 0.28,
            nu23: 0.4,
        })
    };
    let materials = [ply(3.7), ply(3.7)];
    let mut section = of_two(&strip(10.0, 1.0, cells), materials, |[_, z]| z > 0.0);
    for cell in &mut section.cells {
        cell.fiber_angle = match cell.material {
            0 => 30.0_f64.to_radians(),
            _ => -30.0_f64.to_radians(),
        };
    }
    section
}

fn of(section: &Section, measure: StrainMeasure) -> (SectionSolution, Prestress) {
    let solution = solved(section);
    let found = prestress(section, &solution.warping, &solution.strain, measure)
        .unwrap_or_else(|reason| panic!("{reason}"));
    (solution, found)
}

fn file() -> Value {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/tests/reference/theory/prestress.json"
    );
    let text = std::fs::read_to_string(path).expect("reference file");
    serde_json::from_str(&text).expect("JSON")
}

/// The table of a case; its indices are the indices of the six components, from zero.
fn expected(case: &Value) -> CubicTable {
    let entries = case["T"].as_object().expect("entries");
    CubicTable::from_fn(|indices| {
        let [i, j, k] = indices.map(|index| PRESTRESS_COMPONENTS[index]);
        entries
            .get(&format!("{i}{j}{k}"))
            .map_or(0.0, |value| value.as_f64().expect("a number"))
    })
}

fn largest(table: &CubicTable) -> f64 {
    table
        .entries()
        .map(|entry| entry.1.abs())
        .fold(0.0, f64::max)
}

fn difference(a: &CubicTable, b: &CubicTable) -> f64 {
    let differences = a.entries().map(|(at, value)| (value - b.at(at)).abs());
    differences.fold(0.0, f64::max)
}

/// The table of the prototype.
fn along_tangent(solution: &SectionSolution, table: &CubicTable) -> CubicTable {
    let tangent = table.along_tangent(&solution.compliance);
    tangent.expect("a sound section")
}

/// The three strips of the prototype, by both measures of strain. Both use the same mesh:
/// the difference is round-off, at most 1e-14.
#[test]
fn tables_of_the_prototype() {
    const TOLERANCE: f64 = 1e-11;
    let file = file();
    for (name, section) in [
        (
            "isotropic strip b/t=10",
            isotropic_strip(10.0, 1.0, [24, 4]),
        ),
        ("isotropic strip b/t=2", isotropic_strip(2.0, 1.0, [10, 6])),
        ("antisymmetric 30/-30 strip", composite_strip([24, 4])),
    ] {
        for measure in StrainMeasure::ALL {
            let name = format!("{name} {}", measure.name());
            let case = &file["cases"][&name];
            let (solution, found) = of(&section, measure);
            let expected = expected(case);
            let tangent = along_tangent(&solution, &found.third);
            let error = difference(&tangent, &expected) / largest(&expected);
            println!("{name} {error:e}");
            record::largest(
                PROTOTYPE,
                &name,
                "table T / largest entry",
                error,
                TOLERANCE,
            );
            assert!(error < TOLERANCE, "{name} {error:e}");

            let along_reference = Prestress {
                third: tangent,
                ..found
            };
            let gain = along_reference.by_force(&solution.compliance, 0)[(1, 1)];
            let square = radius_square(&section);
            let known = number(&case["dK44_dN_times_A_over_Ip"]);
            let error = (gain / square - known).abs();
            record::value(
                PROTOTYPE,
                &name,
                "dK44/dN A/Ip",
                [gain / square, known],
                error,
                TOLERANCE,
            );
            assert!(error < TOLERANCE, "{name}: {} {known}", gain / square);
        }
    }
}

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

/// Ip/A of a rectangle about its center, from its mesh.
fn radius_square(section: &Section) -> f64 {
    let nodes = &section.mesh.nodes;
    let size = |axis: usize| 2.0 * nodes.iter().map(|at| at[axis]).fold(0.0, f64::max);
    (size(0).powi(2) + size(1).powi(2)) / 12.0
}

/// GJ of a rectangle by de Saint-Venant's series, modulus of shear one.
fn torsion_constant(b: f64, t: f64) -> f64 {
    let term = |n: i32| {
        let n = f64::from(2 * n + 1);
        (n * std::f64::consts::PI * b / (2.0 * t)).tanh() / n.powi(5)
    };
    let sum: f64 = (0..40).map(term).sum();
    b * t.powi(3) / 3.0 * (1.0 - 192.0 * t / (std::f64::consts::PI.powi(5) * b) * sum)
}

/// Extension and bending of an isotropic strip change only by the measure of strain:
/// dEA/dN = 3, dEI/dN A/I = 3 - 2 nu by Green's strain, 0 and -2 nu by Biot's. The fields are
/// polynomials that the cells represent exactly: round-off.
#[test]
fn extension_and_bending_change_by_the_measure_alone() {
    const TOLERANCE: f64 = 1e-10;
    let section = isotropic_strip(10.0, 1.0, [24, 4]);
    for (measure, expected) in [
        (StrainMeasure::Green, [3.0, 3.0 - 2.0 * NU, 3.0 - 2.0 * NU]),
        (StrainMeasure::Biot, [0.0, -2.0 * NU, -2.0 * NU]),
    ] {
        let (solution, found) = of(&section, measure);
        let by_axial = found.by_force(&solution.compliance, 0);
        let found = [
            by_axial[(0, 0)],
            by_axial[(2, 2)] * 12.0,
            by_axial[(3, 3)] * 12.0 / 100.0,
        ];
        for (i, quantity) in ["dEA/dN", "dEIy/dN A/Iy", "dEIz/dN A/Iz"]
            .into_iter()
            .enumerate()
        {
            let error = (found[i] - expected[i]).abs();
            let case = format!("strip 10 x 1, {}", measure.name());
            let pair = [found[i], expected[i]];
            record::value(CLOSED, &case, quantity, pair, error, TOLERANCE);
            assert!(error < TOLERANCE, "{case} {quantity} {pair:?}");
        }
    }
}

/// `T144 = E Ip - c GJ`, c = 4 nu (Green) and 3/2 + 7/2 nu (Biot), with GJ of the series. The
/// relative error of GJ on the mesh is 1e-3, and GJ is up to a third of E Ip: 1e-3 of E Ip would
/// be safe; the error of the table is at most half the error of GJ on these meshes, 2e-4.
#[test]
fn torsion_gains_from_tension() {
    const TOLERANCE: f64 = 2e-4;
    for (b, cells) in [(10.0, [24, 4]), (2.0, [10, 6]), (1.0, [8, 8])] {
        let section = isotropic_strip(b, 1.0, cells);
        let polar = (b.powi(3) + b) / 12.0;
        let torsion = torsion_constant(b, 1.0) / (2.0 * (1.0 + NU));
        for (measure, c) in [
            (StrainMeasure::Green, 4.0 * NU),
            (StrainMeasure::Biot, 1.5 + 3.5 * NU),
        ] {
            let table = of(&section, measure).1.third;
            let (found, expected) = (table.at([0, 1, 1]), polar - c * torsion);
            let error = (found - expected).abs() / polar;
            let case = format!("strip {b} x 1, {}", measure.name());
            println!("{case} {found} {expected} {error:e}");
            let quantity = "T144 = E Ip - c GJ [N m^2]";
            record::value(CLOSED, &case, quantity, [found, expected], error, TOLERANCE);
            assert!(error < TOLERANCE, "{case} {found} {expected}");
        }
    }
}

/// A thin strip gains N Ip/A: the difference is `c GJ / E Ip -> 2 c/(1 + nu) (t/b)^2`, which
/// decreases with the square of the thickness. The end effects of GJ, .63 t/b of it, and the share
/// of t^2 in Ip change the last halving by 1 %.
#[test]
fn thin_strips_gain_the_polar_radius() {
    let missing = |b: f64, cells: usize| {
        let section = isotropic_strip(b, 1.0, [cells, 4]);
        let (solution, found) = of(&section, StrainMeasure::Green);
        1.0 - found.by_force(&solution.compliance, 0)[(1, 1)] / radius_square(&section)
    };
    let [wide, wider, widest] = [(10.0, 24), (20.0, 30), (40.0, 40)].map(|(b, n)| missing(b, n));
    let (first, last) = ((wide / wider).log2(), (wider / widest).log2());
    println!("{wide} {wider} {widest} {first} {last}");
    let limit = 8.0 * NU / (1.0 + NU) / 1600.0;
    let error = relative_error(widest, limit);
    record::order(CLOSED, "thin strips", "1 - dGJ/dN A/Ip, by t/b", last, 1.9);
    record::value(
        CLOSED,
        "strip 40 x 1, green",
        "1 - dGJ/dN A/Ip",
        [widest, limit],
        error,
        0.03,
    );
    assert!(first > 1.8 && last > 1.9 && error < 0.03, "{error}");
}

/// A strip of thickness t0 (1 + 1.2 y) over a width of one, about its centroid. In axes along the
/// tangent, bending in its plane changes its torsion by `-E int y (y^2 + z^2) dA`, as in the
/// prototype on another mesh: 2e-3 is the accuracy of GJ there. In the axes of the section it is
/// Wagner's coefficient, with the distance y_s of the shear center:
///
/// ```text
/// T446 = -E (int y r^2 dA - 2 y_s Iz)
/// ```
///
/// Both are for thin walls: the difference decreases with the square of the thickness.
#[test]
fn tapered_strips_have_the_effect_of_wagner() {
    const TOLERANCE: f64 = 2e-3;
    let file = file();
    let known = &file["wagner"];
    let known = known
        .as_object()
        .expect("cases")
        .values()
        .next()
        .expect("one");
    let mut missing = [f64::INFINITY; 2];
    for (t0, key) in [(0.1, "t0=.1"), (0.05, "t0=.05"), (0.02, "t0=.02")] {
        let center = 0.1;
        let thickness = |y: f64| t0 * (1.0 + 1.2 * y);
        let mut section = isotropic_strip(1.0, 1.0, [40, 4]);
        for node in &mut section.mesh.nodes {
            *node = [node[0] - center, node[1] * thickness(node[0])];
        }
        let (solution, found) = of(&section, StrainMeasure::Green);
        let integral = |f: &dyn Fn(f64, f64) -> f64| -> f64 {
            let positions = (0..400).map(|i| (f64::from(i) + 0.5) / 400.0 - 0.5);
            positions.map(|y| f(y - center, thickness(y)) / 400.0).sum()
        };
        let third = integral(&|y, t| t * y * (y * y + t * t / 12.0));
        let second = integral(&|y, t| t * y * y);
        let along = along_tangent(&solution, &found.third).at([1, 1, 3]);
        let ratio = along / -third;
        let expected = number(&known[key]);
        let error = (ratio - expected).abs();
        let case = format!("tapered strip, t0/b = {t0}");
        let quantity = "T446 / Wagner's integral, along the tangent";
        let pair = [ratio, expected];
        record::value(PROTOTYPE, &case, quantity, pair, error, TOLERANCE);
        assert!(error < TOLERANCE, "{case} {pair:?}");

        let wagner = -(third - 2.0 * solution.centers.shear[0] * second);
        let own = found.third.at([1, 1, 3]) / wagner;
        println!("{case} {ratio} {expected}, in section axes {own}");
        let now = [(ratio - 1.0).abs(), (own - 1.0).abs()];
        assert!(
            now[0] < missing[0] && now[1] < missing[1],
            "{now:?} {missing:?}"
        );
        missing = now;
    }
    for (missing, quantity) in missing.iter().zip(["along the tangent", "of the section"]) {
        let quantity = format!("T446, axes {quantity}");
        record::largest(
            CLOSED,
            "tapered strip, t0/b = 0.02",
            &quantity,
            *missing,
            5e-3,
        );
        assert!(*missing < 5e-3, "{quantity} {missing}");
    }
}

/// Change of the stiffness by a state without internal force.
fn change_by(section: &Section, state: ImposedStrain, measure: StrainMeasure) -> Matrix4<f64> {
    let analysis = Analysis::new(section).expect("sound");
    let solution = analysis.solution();
    let solved = &analysis.imposed(&[state]).expect("sound")[0];
    let free = FreeState {
        imposed: &solved.state,
        warping: &solved.warping,
        strain: &solved.free_strain,
    };
    let (warping, strain) = (&solution.warping, &solution.strain);
    prestress_of_imposed(section, warping, strain, measure, &[free]).expect("straight")[0]
}

/// A section of one material that is heated evenly has no stress, and expands: with
/// H_0 = eps I, (S-150) is the work of sigma_j on `eps kappa_k x t`,
///
/// ```text
/// T_0jk = 2 eps K_jk (Biot; none for extension),   4 eps K_jk and 2 eps EA (Green)
/// ```
///
/// to round-off of the solution.
#[test]
fn even_heat_of_one_material_only_makes_the_section_grow() {
    const TOLERANCE: f64 = 1e-10;
    let section = isotropic_strip(10.0, 1.0, [12, 4]);
    let stiffness = solved(&section).stiffness;
    let k = PRESTRESS_COMPONENTS.map(|component| stiffness[(component, component)]);
    let free = FreeStrain::constant(Vector6::new(1.0, 1.0, 1.0, 0.0, 0.0, 0.0));
    for (measure, [axial, turning]) in [
        (StrainMeasure::Biot, [0.0, 2.0]),
        (StrainMeasure::Green, [2.0, 4.0]),
    ] {
        let state = ImposedStrain {
            name: "even".into(),
            cells: vec![free; section.cells.len()],
        };
        let found = change_by(&section, state, measure);
        let factors = Vector4::new(axial, turning, turning, turning);
        let expected = Matrix4::from_diagonal(&factors.component_mul(&Vector4::from(k)));
        let root = Vector4::from(k.map(f64::sqrt));
        let error = (found - expected)
            .component_div(&(root * root.transpose()))
            .amax();
        let case = format!("strip heated evenly, {}", measure.name());
        record::largest(CLOSED, &case, "change of the stiffness", error, TOLERANCE);
        assert!(error < TOLERANCE, "{found} {expected}");
    }
}

/// A strip with hot edges, `eps = (y/b)^2`, is in compression there and in tension in the
/// middle, and loses torsional stiffness by its self-equilibrated stress along the beam:
///
/// ```text
/// sigma = E ( mean of eps - eps(y) )     T_044 -> int sigma r^2 dA = - E b^3 t / 180
/// ```
///
/// The difference is of the size of GJ times the strain and decreases with the square of
/// thickness over width. Strains are linear in each cell: 1e-3 of the integral on 40 cells.
#[test]
fn hot_edges_take_torsional_stiffness() {
    const TOLERANCE: f64 = 0.01;
    let missing = |b: f64| {
        let cells = 40;
        let section = isotropic_strip(b, 1.0, [cells, 2]);
        let chord = |cell: &[[f64; 2]]| {
            let ends = cell.iter().map(|position| position[0] / b);
            let (low, high) = ends.fold((1.0_f64, -1.0_f64), |(a, z), y| (a.min(y), z.max(y)));
            let even = Vector6::new(1.0, 1.0, 1.0, 0.0, 0.0, 0.0);
            FreeStrain {
                at_origin: -low * high * even,
                by_y: (low + high) / b * even,
                by_z: Vector6::zeros(),
            }
        };
        let mesh = &section.mesh;
        let of_cell = |cell| chord(&mesh.positions(cell).collect::<Vec<_>>());
        let state = ImposedStrain {
            name: "edges".into(),
            cells: mesh.cells.iter().map(of_cell).collect(),
        };
        let found = change_by(&section, state, StrainMeasure::Biot)[(1, 1)];
        (found, -b.powi(3) / 180.0)
    };
    let all = [10.0, 20.0, 40.0].map(missing);
    let [wide, wider, widest] = all.map(|(found, limit)| relative_error(found, limit));
    println!("{all:?} {wide} {wider} {widest}");
    let (found, limit) = all[2];
    let quantity = "loss of GJ by hot edges, int sigma r^2 dA [N m^2]";
    record::value(
        CLOSED,
        "strip 40 x 1",
        quantity,
        [found, limit],
        widest,
        TOLERANCE,
    );
    assert!(
        widest < TOLERANCE && wider < 0.4 * wide,
        "{wide} {wider} {widest}"
    );
}
