//! Derivatives of the properties of sections: against differences of whole analyses,
//! closed forms, and stored values of an independent program.

use nalgebra::{Matrix6, Vector3};
use section_analyzer::analysis::Analysis;
use section_analyzer::material::{Constant, ElasticLaw, EngineeringConstants, Material};
use section_analyzer::mesh::generate::Rectangle;
use section_analyzer::section::Section;
use section_analyzer::sensitivity::{
    Axis, Cells, Derivative, Motion, NodeVelocity, Parameter, SensitivityProblem,
};
use section_analyzer::solution::SectionSolution;
use shared_geom::mesh::{CellKind, Mesh};
use shared_geom::section::InitialCurvature;

use crate::record;
use crate::sections::{isotropic, material, of_two, orthotropic, relative_error, solved, uniform};

const DIFFERENCES: &str = "Central differences of the analysis";
const CLOSED_FORMS: &str = "Closed forms of derivatives";
const STORED: &str = "Derivatives of a second program, by differences";

/// The ply of the stored values, [GPa, -].
const PLY: EngineeringConstants = EngineeringConstants {
    e1: 181.0,
    e2: 10.3,
    e3: 10.3,
    g12: 7.17,
    g13: 7.17,
    g23: 3.7,
    nu12: 0.28,
    nu13: 0.28,
    nu23: 0.4,
};

fn rectangle(cells_y: usize, cells_z: usize) -> Mesh {
    let rectangle = Rectangle {
        width: 2.0,
        height: 1.0,
        cells_y,
        cells_z,
        kind: CellKind::Quadrilateral9,
        name: "bar".into(),
    };
    rectangle.generate().expect("sound measures")
}

fn derivatives(section: &Section, parameters: &[Parameter]) -> Vec<Derivative> {
    let analysis = Analysis::new(section).unwrap_or_else(|failure| panic!("{failure}"));
    let found = analysis.sensitivities(parameters);
    found.unwrap_or_else(|problem| panic!("{problem}"))
}

fn one(section: &Section, parameter: Parameter) -> Derivative {
    derivatives(section, &[parameter]).remove(0)
}

/// A section of two materials and many plies, off the origin, with curved sides: no entry
/// is zero by symmetry.
fn general(line: InitialCurvature) -> Section {
    let full = ElasticLaw::Orthotropic(PLY).stiffness();
    let full = Matrix6::from_fn(|i, j| full[(i, j)] + 0.05 * (1 + (i + 1) * (j + 1)) as f64);
    let materials = [orthotropic(PLY), isotropic(20.0, 0.3)];
    let mut section = of_two(&rectangle(4, 2), materials, |[_, z]| z < 0.0);
    section.materials.push(Material {
        density: 3.0,
        ..material(ElasticLaw::Full(full))
    });
    for (index, cell) in section.cells.iter_mut().enumerate() {
        cell.fiber_angle = 0.3 + 0.4 * index as f64;
        cell.plane_angle = 0.2 * index as f64;
        if index % 3 == 2 {
            cell.material = 2;
        }
    }
    for [y, z] in &mut section.mesh.nodes {
        (*y, *z) = (*y + 0.7 + 0.1 * *z * *z, *z - 0.4 + 0.05 * *y * *y);
    }
    section.initial_curvature = line;
    section
}

/// Changes a section by a step.
type Change = Box<dyn Fn(&mut Section, f64)>;

/// A parameter, and a function that changes it in the section.
struct Moved {
    name: &'static str,
    parameter: Parameter,
    /// A reference amount of the parameter: its value, a radian, a meter.
    unit: f64,
    /// Step of the differences.
    step: f64,
    by: Change,
}

fn of_constant(
    name: &'static str,
    material: usize,
    constant: Constant,
    unit: f64,
    by: impl Fn(&mut Material, f64) + 'static,
) -> Moved {
    Moved {
        name,
        parameter: Parameter::Constant { material, constant },
        unit,
        step: 0.01 * unit,
        by: Box::new(move |section, amount| by(&mut section.materials[material], amount)),
    }
}

fn constants(material: &mut Material) -> &mut EngineeringConstants {
    match &mut material.law {
        ElasticLaw::Orthotropic(constants) => constants,
        _ => panic!("an orthotropic law"),
    }
}

fn moves() -> Vec<Moved> {
    let mut moves = moved_constants();
    moves.extend(moved_angles());
    moves.extend(moved_nodes());
    moves
}

fn moved_constants() -> Vec<Moved> {
    let engineering = Constant::Engineering;
    vec![
        of_constant("e1", 0, engineering("e1"), PLY.e1, |m, by| {
            constants(m).e1 += by
        }),
        of_constant("g13", 0, engineering("g13"), PLY.g13, |m, by| {
            constants(m).g13 += by;
        }),
        of_constant("nu12", 0, engineering("nu12"), PLY.nu12, |m, by| {
            constants(m).nu12 += by;
        }),
        of_constant("poisson", 1, Constant::Poisson, 0.3, |m, by| {
            let ElasticLaw::Isotropic { poisson, .. } = &mut m.law else {
                panic!("an isotropic law");
            };
            *poisson += by;
        }),
        of_constant(
            "stiffness[1,6]",
            2,
            Constant::Stiffness(0, 5),
            10.0,
            |m, by| {
                let ElasticLaw::Full(stiffness) = &mut m.law else {
                    panic!("a full law");
                };
                stiffness[(0, 5)] += by;
                stiffness[(5, 0)] += by;
            },
        ),
        of_constant("density", 2, Constant::Density, 3.0, |m, by| {
            m.density += by
        }),
    ]
}

fn moved_angles() -> [Moved; 2] {
    [
        Moved {
            name: "fiber angle",
            parameter: Parameter::FiberAngle(Cells::List(vec![0, 2, 5])),
            unit: 1.0,
            step: 0.002,
            by: Box::new(|section, by| {
                for cell in [0, 2, 5] {
                    section.cells[cell].fiber_angle += by;
                }
            }),
        },
        Moved {
            name: "plane angle",
            parameter: Parameter::PlaneAngle(Cells::Region(0)),
            unit: 1.0,
            step: 0.002,
            by: Box::new(|section, by| {
                for cell in &mut section.cells {
                    cell.plane_angle += by;
                }
            }),
        },
    ]
}

fn moved_nodes() -> [Moved; 2] {
    [
        Moved {
            name: "y of a node",
            parameter: Parameter::Node {
                node: 17,
                axis: Axis::Y,
            },
            unit: 1.0,
            step: 0.001,
            by: Box::new(|section, by| section.mesh.nodes[17][0] += by),
        },
        Moved {
            name: "motion of all nodes",
            parameter: Parameter::Motion(Motion::of_nodes((0..45).map(swing).collect())),
            unit: 1.0,
            step: 0.001,
            by: Box::new(|section, by| {
                for (node, position) in section.mesh.nodes.iter_mut().enumerate() {
                    let NodeVelocity { y, z, .. } = swing(node);
                    *position = [position[0] + by * y, position[1] + by * z];
                }
            }),
        },
    ]
}

fn swing(node: usize) -> NodeVelocity {
    let phase = node as f64;
    NodeVelocity {
        node,
        y: phase.sin(),
        z: (2.0 * phase).cos(),
    }
}

/// Largest `|a_ij - b_ij| unit / sqrt(s_ii s_jj)`.
fn error(a: &Matrix6<f64>, b: &Matrix6<f64>, of: &Matrix6<f64>, unit: f64) -> f64 {
    let down = of.diagonal().map(|value| 1.0 / value.sqrt());
    (a - b).component_mul(&(down * down.transpose())).amax() * unit
}

/// All 36 entries of K, F and M and the three centers, straight and curved.
///
/// Errors are relative to the largest entry of the derivative itself, entries scaled by
/// `sqrt(Kii Kjj)`; the errors of the centers to the largest of their six coordinates. The
/// errors of the differences are step^4/30 of the fifth derivative, for constants 1e-8/30
/// times a few units; the ratio 18 of the moduli gives large derivatives with respect to
/// angles (fifth derivatives of 1e4), and nodes move in cells of 0.25: smaller steps.
/// Round-off is 1e-12 over the step and over the derivative, 1e-3 and more: 1e-6 is
/// sufficient.
#[test]
fn derivatives_are_those_of_differences() {
    let curved = InitialCurvature {
        curvature: Vector3::new(0.2, -0.15, 0.1),
        slope: Vector3::new(0.95, 0.1, -0.05),
    };
    for (beam, line) in [
        ("straight", InitialCurvature::STRAIGHT),
        ("curved and twisted", curved),
    ] {
        let section = general(line);
        let moves = moves();
        let parameters: Vec<_> = moves.iter().map(|moved| moved.parameter.clone()).collect();
        let solution = solved(&section);
        for (moved, found) in moves.iter().zip(derivatives(&section, &parameters)) {
            compare(beam, (&section, &solution), moved, &found);
        }
    }
}

fn compare(
    beam: &str,
    (section, solution): (&Section, &SectionSolution),
    moved: &Moved,
    found: &Derivative,
) {
    let Moved { unit, step, .. } = *moved;
    let around = [-2.0, -1.0, 1.0, 2.0].map(|steps| {
        let mut section = section.clone();
        (moved.by)(&mut section, steps * step);
        solved(&section)
    });
    let matrix = |of: fn(&SectionSolution) -> Matrix6<f64>| {
        let [far, near, next, last] = around.each_ref().map(of);
        (8.0 * (next - near) - (last - far)) / (12.0 * step)
    };
    let changes = |derivative: &Matrix6<f64>, of: &Matrix6<f64>| {
        error(derivative, &Matrix6::zeros(), of, unit)
    };
    // moduli and angles do not change the mass, densities not the stiffness
    let relative = |found: &Matrix6<f64>, expected: Matrix6<f64>, of: &Matrix6<f64>| {
        let (size, off) = (changes(&expected, of), changes(&(found - expected), of));
        if size < 1e-9 { off } else { off / size }
    };
    let SectionSolution {
        stiffness: k,
        compliance: f,
        mass: m,
        ..
    } = solution;
    let differences = [
        ("dK", relative(&found.stiffness, matrix(|s| s.stiffness), k)),
        (
            "dF",
            relative(&found.compliance, matrix(|s| s.compliance), f),
        ),
        ("dM", relative(&found.mass, matrix(|s| s.mass), m)),
    ];
    let is_large = changes(&found.stiffness, k) > 1e-3 || moved.name == "density";
    assert!(is_large, "{beam}, {}", moved.name);
    let positions = [
        found.tension,
        found.shear,
        found.mass_center.expect("a mass"),
    ];
    let [far, near, next, last] = around.each_ref().map(centers);
    let expected: [f64; 6] =
        std::array::from_fn(|i| (8.0 * (next[i] - near[i]) - (last[i] - far[i])) / (12.0 * step));
    let size = expected.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
    let off = positions.iter().flatten().zip(expected);
    let off = off.map(|(position, expected)| (position - expected).abs() / size);
    let off = ("centers", off.fold(0.0, f64::max));
    for (quantity, error) in differences.into_iter().chain([off]) {
        assert!(error < 1e-6, "{beam}, {}: {quantity} {error:e}", moved.name);
        record::largest(DIFFERENCES, beam, quantity, error, 1e-6);
    }
}

/// Tension, shear and mass center.
fn centers(solution: &SectionSolution) -> [f64; 6] {
    let c = &solution.centers;
    let ([a, b], [c, d], [e, f]) = (c.tension, c.shear, c.mass.expect("a mass"));
    [a, b, c, d, e, f]
}

/// Stiffness is proportional to the modulus, and to powers 2 and 4 of the size, exactly:
/// round-off, 1e-10.
#[test]
fn scales() {
    let section = uniform(&rectangle(8, 6), isotropic(7.0, 0.3), 0.0);
    let solution = solved(&section);
    let nodes = section.mesh.nodes.iter().enumerate();
    let grow = nodes.map(|(node, &[y, z])| NodeVelocity { node, y, z });
    let young = Parameter::Constant {
        material: 0,
        constant: Constant::Young,
    };
    let found = derivatives(
        &section,
        &[young, Parameter::Motion(Motion::of_nodes(grow.collect()))],
    );
    let worst = error(
        &(7.0 * found[0].stiffness),
        &solution.stiffness,
        &solution.stiffness,
        1.0,
    );
    assert!(worst < 1e-10, "{worst:e}");
    record::largest(CLOSED_FORMS, "modulus", "dK E = K", worst, 1e-10);
    for (i, power) in [2.0, 2.0, 2.0, 4.0, 4.0, 4.0].into_iter().enumerate() {
        let slope = found[1].stiffness[(i, i)] / solution.stiffness[(i, i)];
        let error = relative_error(slope, power);
        assert!(error < 1e-10, "{i}: {error:e}");
        let quantity = format!("d ln K{0}{0}", i + 1);
        record::value(
            CLOSED_FORMS,
            "size",
            &quantity,
            [slope, power],
            error,
            1e-10,
        );
    }
}

/// Stretched along y: area and I about y increase with the first power of the width, I
/// about z with the third; exact for cells that contain the solution of Saint-Venant
/// (nu = 0.3: quadratic).
#[test]
fn stretch_along_y() {
    let section = uniform(&rectangle(8, 6), isotropic(1.0, 0.3), 0.0);
    let k = solved(&section).stiffness;
    let nodes = section.mesh.nodes.iter().enumerate();
    let stretch = nodes.map(|(node, &[y, _])| NodeVelocity { node, y, z: 0.0 });
    let found = one(
        &section,
        Parameter::Motion(Motion::of_nodes(stretch.collect())),
    );
    for (i, power) in [(0, 1.0), (4, 1.0), (5, 3.0)] {
        let slope = found.stiffness[(i, i)] / k[(i, i)];
        let error = relative_error(slope, power);
        assert!(error < 1e-10, "{i}: {error:e}");
        let quantity = format!("d ln K{0}{0}", i + 1);
        record::value(
            CLOSED_FORMS,
            "stretch",
            &quantity,
            [slope, power],
            error,
            1e-10,
        );
    }
}

/// dS11 and dS16 of a ply turned by `angle`, per radian (Lekhnitskii).
fn turned_compliance_rates(k: &EngineeringConstants, angle: f64) -> (f64, f64) {
    let (s11, s22, s12, s66) = (1.0 / k.e1, 1.0 / k.e2, -k.nu12 / k.e1, 1.0 / k.g12);
    let (s, c) = angle.sin_cos();
    let mixed = 2.0 * s12 + s66;
    // S11 = c^4 S11 + c^2 s^2 (2 S12 + S66) + s^4 S22
    let of_11 = -4.0 * c.powi(3) * s * s11
        + 2.0 * c * s * (c * c - s * s) * mixed
        + 4.0 * s.powi(3) * c * s22;
    // S16 = (2 S11 - 2 S12 - S66) c^3 s - (2 S22 - 2 S12 - S66) c s^3
    let first = 2.0 * s11 - mixed;
    let second = 2.0 * s22 - mixed;
    let of_16 =
        first * (c.powi(4) - 3.0 * c * c * s * s) - second * (3.0 * c * c * s * s - s.powi(4));
    (of_11, of_16)
}

/// The strip of 25 deg: closed forms to round-off (the cells contain the solution), and the
/// stored differences to their accuracy, 1e-8.
#[test]
fn off_axis_strip() {
    let angle = 25f64.to_radians();
    let section = uniform(&rectangle(8, 6), orthotropic(PLY), angle);
    let solution = solved(&section);
    let found = one(&section, Parameter::FiberAngle(Cells::Region(0)));
    let df = found.compliance;
    let (of_11, of_16) = turned_compliance_rates(&PLY, angle);
    let (area, i_y, i_z) = (2.0, 2.0 / 12.0, 8.0 / 12.0);
    for (quantity, at, expected) in [
        ("dF11 = dS11/A", (0, 0), of_11 / area),
        ("dF55 = dS11/Iy", (4, 4), of_11 / i_y),
        ("dF66 = dS11/Iz", (5, 5), of_11 / i_z),
        ("dF12 = dS16/A", (0, 1), of_16 / area),
        ("dF45 = -dS16/(2 Iy)", (3, 4), -of_16 / (2.0 * i_y)),
    ] {
        let error = relative_error(df[at], expected);
        assert!(error < 1e-10, "{quantity}: {error:e}");
        record::value(
            CLOSED_FORMS,
            "off-axis strip",
            quantity,
            [df[at], expected],
            error,
            1e-10,
        );
    }

    let text = include_str!("../reference/theory/section_sensitivities.json");
    let stored: serde_json::Value = serde_json::from_str(text).expect("JSON");
    for (key, found, of) in [
        ("dF_per_degree", df, solution.compliance),
        ("dK_per_degree", found.stiffness, solution.stiffness),
    ] {
        let rows = &stored["ply_angle"][key];
        let stored = Matrix6::from_fn(|i, j| rows[i][j].as_f64().expect("a number"));
        let per_degree = found * 1f64.to_radians();
        let error = error(&per_degree, &stored, &of, 1.0);
        assert!(error < 1e-8, "{key}: {error:e}");
        record::largest(STORED, "off-axis strip", key, error, 1e-8);
    }
}

/// Two bars side by side, along y: the tension center is the center of the moduli, the mass
/// center the center of the densities.
#[test]
fn centers_of_two_materials() {
    let (e, rho) = ([3.0, 1.0], [5.0, 2.0]);
    let materials = [0, 1].map(|i| Material {
        density: rho[i],
        ..isotropic(e[i], 0.25)
    });
    let section = of_two(&rectangle(8, 6), materials, |[y, _]| y < 0.0);
    let first = |constant| Parameter::Constant {
        material: 0,
        constant,
    };
    let found = derivatives(
        &section,
        &[first(Constant::Young), first(Constant::Density)],
    );
    // halves of area 1 about -1/2 and 1/2: y = (a2 - a1)/(2 (a1 + a2)), dy/da1 = -a2/(a1 + a2)^2
    let slope = |[first, second]: [f64; 2]| -second / (first + second).powi(2);
    for (quantity, found, expected) in [
        ("tension center", found[0].tension[0], slope(e)),
        (
            "mass center",
            found[1].mass_center.expect("a mass")[0],
            slope(rho),
        ),
        ("mass", found[1].mass[(0, 0)], 1.0),
        // polar: int y^2 + z^2 of the half
        ("inertia", found[1].mass[(3, 3)], 1.0 / 3.0 + 1.0 / 12.0),
    ] {
        let error = relative_error(found, expected);
        assert!(error < 1e-10, "{quantity}: {found} {error:e}");
        record::value(
            CLOSED_FORMS,
            "two bars",
            quantity,
            [found, expected],
            error,
            1e-10,
        );
    }
}

/// Parameters that the section does not have are refused with a message.
#[test]
fn parameters_that_are_not_there() {
    let section = uniform(&rectangle(2, 1), isotropic(1.0, 0.3), 0.0);
    let analysis = Analysis::new(&section).expect("sound section");
    let constant = |material, constant| Parameter::Constant { material, constant };
    for (parameter, expected) in [
        (
            constant(1, Constant::Young),
            "material number 1: the section has 1",
        ),
        (
            constant(0, Constant::Engineering("e1")),
            "constant \"e1\": material \"material\" has young, poisson, density",
        ),
        (
            Parameter::FiberAngle(Cells::Region(1)),
            "region number 1: the mesh has 1",
        ),
        (
            Parameter::PlaneAngle(Cells::List(vec![0, 2])),
            "cell number 2: the mesh has 2",
        ),
        (
            Parameter::Node {
                node: 99,
                axis: Axis::Y,
            },
            "node number 99: no cell of the section has it",
        ),
        (
            Parameter::Motion(Motion::of_nodes(vec![NodeVelocity {
                node: 1,
                y: f64::NAN,
                z: 0.0,
            }])),
            "the motion of node number 1 is not finite",
        ),
    ] {
        let both = [
            analysis.sensitivities(std::slice::from_ref(&parameter)),
            analysis.sensitivities_direct(std::slice::from_ref(&parameter)),
        ];
        for found in both {
            let problem: SensitivityProblem = found.expect_err("nothing to differentiate");
            assert_eq!(problem.to_string(), expected);
        }
    }
}
