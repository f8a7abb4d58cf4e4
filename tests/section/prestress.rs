//! Stiffness of loaded sections against a prototype, closed forms and the nonlinear
//! energy of the section.
//!
//! # References
//! - `tests/reference/theory/prestress.json`: the tables of five sections by an independent
//!   program, on the same meshes; those of isotropic strips agree there with differences of the
//!   fully nonlinear section forces to 6e-7.
//! - [HoubolttBrooks1958]: a strip under tension N gains N Ip/A in torsion.

use nalgebra::Matrix4;
use section_analyzer::material::{EngineeringConstants, Material};
use section_analyzer::mesh::generate::Rectangle;
use section_analyzer::properties::prestress;
use section_analyzer::section::Section;
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
    let found = prestress(section, &solution, measure).unwrap_or_else(|reason| panic!("{reason}"));
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

/// The table of a case; its indices are those of the six components, from zero.
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

#[test]
fn tables_of_the_prototype() {
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
            let case = &file["cases"][format!("{name} {}", measure.name())];
            let (_, found) = of(&section, measure);
            let expected = expected(case);
            println!("{name} {measure:?}");
            for (at, value) in found.third.entries() {
                if expected.at(at).abs() + value.abs() > 1e-6 * largest(&expected) {
                    println!("  {at:?} {value} {}", expected.at(at));
                }
            }
            let error = difference(&found.third, &expected) / largest(&expected);
            println!("{name} {measure:?} {error:e}");
        }
    }
}
