//! Laminates along lines against cells of the same geometry.
//!
//! # References
//! - [bredt] Bredt's formulas of thin closed walls, `GJ = 4 A^2 / oint ds/(G t)`, with A the
//!   area within the middle of the wall, and a shear stress of `T / (2 A t)`.

use std::f64::consts::{PI, TAU};

use nalgebra::Vector6;
use section_analyzer::material::{EngineeringConstants, Material};
use section_analyzer::mesh::LaminaSide;
use section_analyzer::mesh::generate::{Ellipse, Rectangle, Tube};
use section_analyzer::recovery::{LoadCase, recover};
use section_analyzer::section::{CellMaterial, Section};
use shared_geom::mesh::{CellKind, Mesh};
use shared_geom::section::InitialCurvature;

use crate::lines::{Ply, Wall, add_curve, alone, graded_to_ends, laminated, nearest, polygon};
use crate::quads::{Quads, joined, steps};
use crate::record;
use crate::sections::{
    isotropic, of_two, orthotropic, relative_error, scaled_error, section_mesh, solved, uniform,
};

// The sources as named on the validation page.
const CELLS: &str = "Cells of the same geometry";
const BREDT: &str = "Bredt's thin closed walls";

pub const PLY: EngineeringConstants = EngineeringConstants {
    e1: 142e9,
    e2: 9.8e9,
    e3: 9.8e9,
    g12: 6e9,
    g13: 6e9,
    g23: 4.8e9,
    nu12: 0.3,
    nu13: 0.34,
    nu23: 0.42,
};

const RADIUS: f64 = 0.1;
const AROUND: usize = 48;
/// Thickness over radius.
const THIN: [f64; 3] = [0.1, 0.05, 0.025];

/// A circle run clockwise, as ends and middles.
fn circle(radius: f64) -> Vec<[f64; 2]> {
    let point = |i: usize| {
        let (s, c) = (TAU * (i % (2 * AROUND)) as f64 / (2 * AROUND) as f64).sin_cos();
        [radius * c, -radius * s]
    };
    (0..=2 * AROUND).map(point).collect()
}

/// The angle of the wall in the middle of each cell, of a tube run clockwise.
fn around(section: &mut Section, fiber_angle: impl Fn(f64) -> f64) {
    for (cell, made_of) in section.mesh.cells.iter().zip(&mut section.cells) {
        let [y, z] = section.mesh.middle(cell);
        made_of.plane_angle = z.atan2(y) - 0.5 * PI;
        made_of.fiber_angle = fiber_angle(y.hypot(z));
    }
}

/// Two plies, the inner one wound at 20 and the outer one at 50 degrees.
pub fn wound(thickness: f64) -> [Ply; 2] {
    [
        (0.5 * thickness, 20_f64.to_radians(), 0),
        (0.5 * thickness, 50_f64.to_radians(), 0),
    ]
}

/// The normals of two adjacent parabolas differ from the normal of the circle by a quarter
/// of the cube of half the angle of a line, 0.065 rad, and the length of the mitre by half
/// of its square: at most 1e-8, for any thickness.
#[test]
fn a_tube_of_lines_is_that_of_cells() {
    for ratio in THIN {
        let thickness = ratio * RADIUS;
        let tube = Tube {
            outer_radius: RADIUS + 0.5 * thickness,
            thickness,
            cells_around: AROUND,
            cells_through: 2,
            kind: CellKind::Quadrilateral9,
            curved: true,
        };
        let mesh = tube.generate().expect("sound measures");
        let plies = wound(thickness);
        for (name, material, winding) in [
            ("isotropic", isotropic(70e9, 0.3), 0.0),
            ("wound plies", orthotropic(PLY), 1.0),
        ] {
            let mut solid = uniform(&mesh, material.clone(), 0.0);
            let inner = |radius: f64| if radius < RADIUS { 0 } else { 1 };
            around(&mut solid, |radius| winding * plies[inner(radius)].1);
            let plies = plies.map(|(t, angle, material)| (t, winding * angle, material));
            let lines = alone(&circle(RADIUS), &[material], &plies);
            let error = scaled_error(&solved(&lines).stiffness, &solved(&solid).stiffness);
            println!("tube t/R = {ratio}, {name}: {error:.1e}");
            let case = format!("tube of {name}, t/R = {ratio}");
            record::largest(CELLS, &case, "stiffness", error, 1e-8);
            assert!(error < 1e-8, "{case}: {error:e}");
        }
    }
}

/// Bredt's torsion of a tube neglects `(t / 2 R)^2`; for a tube whose wall lies beside its
/// line, treated as on its line, `3 t / 2 R` (S-128). The limits are the exact first and
/// second order, 1 and 2, minus a tenth for the next order at t/R = 0.1.
#[test]
fn a_thin_tube_tends_to_the_closed_form() {
    let (young, nu) = (70e9, 0.3);
    let shear = young / (2.0 * (1.0 + nu));
    for (side, name, least) in [
        (LaminaSide::Center, "on its line", 1.9),
        (LaminaSide::Left, "beside its line", 0.9),
    ] {
        let errors = THIN.map(|ratio| {
            let t = ratio * RADIUS;
            let mut mesh = Mesh::default();
            add_curve(&mut mesh, "wall", &circle(RADIUS));
            let wall = Wall {
                curve: "wall",
                side: Some(side),
                plies: vec![(t, 0.0, 0)],
            };
            let (section, _) = laminated(mesh, &[isotropic(young, nu)], &[wall]);
            let bredt = shear * TAU * RADIUS.powi(3) * t;
            relative_error(solved(&section).stiffness[(3, 3)], bredt)
        });
        println!("thin tube {name}: {errors:?}");
        check_orders(&format!("tube, wall {name}"), "GJ", errors, least);
    }
}

fn check_orders(case: &str, what: &str, errors: [f64; 3], least: f64) {
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        let quantity = format!("{what}, order in t");
        record::order(BREDT, case, &quantity, order, least);
        assert!(order >= least, "{case}, {what}: order {order}");
    }
}

pub const HALF: [f64; 2] = [0.05, 0.025];

/// The corners of the middle of a box, clockwise.
pub fn corners([y, z]: [f64; 2]) -> [[f64; 2]; 5] {
    [[-y, -z], [-y, z], [y, z], [y, -z], [-y, -z]]
}

/// A mitred box of cells: the cells of the lines, by hand. Walls run clockwise, layers
/// outward; group is 4 times the layer plus the wall.
fn box_of_cells(first: f64, levels: &[f64]) -> Quads {
    let corners = corners(HALF);
    let mut shape = Quads::default();
    let mut walls = Vec::new();
    for &level in levels {
        walls.clear();
        for wall in 0..4 {
            let (a, b) = (corners[wall], corners[wall + 1]);
            let length = (b[0] - a[0]).hypot(b[1] - a[1]);
            let t = [0, 1].map(|i| (b[i] - a[i]) / length);
            let positions = graded_to_ends(length, first);
            for (i, along) in positions[..positions.len() - 1].iter().enumerate() {
                // at the corner the level is the level of both walls
                let back = if i == 0 { level } else { 0.0 };
                shape.points.push([
                    a[0] + (along - back) * t[0] - level * t[1],
                    a[1] + (along - back) * t[1] + level * t[0],
                ]);
                walls.push(wall);
            }
        }
    }
    let around = walls.len();
    for layer in 0..levels.len() - 1 {
        for (i, wall) in walls.iter().enumerate() {
            let point = |level: usize, i: usize| level * around + i % around;
            let quad = [
                point(layer, i),
                point(layer, i + 1),
                point(layer + 1, i + 1),
                point(layer + 1, i),
            ];
            shape.quads.push((quad, 4 * layer + wall));
        }
    }
    shape
}

pub fn solid_box(thickness: f64, plies: &[Ply], material: &Material) -> Section {
    let levels: Vec<f64> = steps(-0.5 * thickness, 0.5 * thickness, plies.len());
    let mesh = box_of_cells(thickness, &levels).mesh(|_| CellKind::Quadrilateral9);
    let mesh = section_mesh(&mesh);
    let walls = [0.5 * PI, 0.0, -0.5 * PI, PI];
    let cells = mesh.cells.iter().map(|cell| {
        let group: usize = mesh.groups[cell.group].parse().expect("a number");
        CellMaterial {
            material: 0,
            fiber_angle: plies[group / 4].1,
            plane_angle: walls[group % 4],
        }
    });
    Section {
        name: "box".into(),
        cells: cells.collect(),
        materials: vec![material.clone()],
        mesh,
        initial_curvature: InitialCurvature::STRAIGHT,
        electrodes: Vec::new(),
    }
}

/// The mitred box of lines has the cells of the mitred box: round-off. One layup couples
/// tension and torsion (all fibers in the same sense around the box).
#[test]
fn a_box_of_lines_is_the_mitred_box_of_cells() {
    for ratio in THIN {
        let t = ratio * HALF[1];
        for (name, material, turned) in [
            ("isotropic", isotropic(70e9, 0.3), 0.0),
            ("wound plies", orthotropic(PLY), 1.0),
        ] {
            let plies = wound(t).map(|(t, angle, material)| (t, turned * angle, material));
            let solid = solved(&solid_box(t, &plies, &material)).stiffness;
            let curve = polygon(&corners(HALF), t);
            let lines = solved(&alone(&curve, &[material], &plies)).stiffness;
            let error = scaled_error(&lines, &solid);
            println!("box t/h = {ratio}, {name}: {error:.1e}");
            let case = format!("box of {name}, t/h = {ratio}");
            record::largest(CELLS, &case, "stiffness", error, 1e-11);
            assert!(error < 1e-11, "{case}: {error:e}");
            let coupling = lines[(0, 3)] / (lines[(0, 0)] * lines[(3, 3)]).sqrt();
            assert_eq!(coupling.abs() > 0.1, turned > 0.0, "{case}: {coupling}");
        }
    }
}

/// Tension and bending of a thin box from its middle line: the area of mitred walls is `t`
/// times their length, exactly; bending about y and torsion converge to the closed forms
/// with at least the first order (the moments of mitred corners with the second).
#[test]
fn a_thin_box_tends_to_the_closed_forms() {
    let (young, nu) = (70e9, 0.3);
    let shear = young / (2.0 * (1.0 + nu));
    let [y, z] = HALF.map(|half| 2.0 * half);
    let mut errors = [[0.0; 3]; 2];
    for (i, ratio) in THIN.into_iter().enumerate() {
        let t = ratio * HALF[1];
        let curve = polygon(&corners(HALF), t);
        let section = alone(&curve, &[isotropic(young, nu)], &[(t, 0.0, 0)]);
        let stiffness = solved(&section).stiffness;
        let axial = young * t * 2.0 * (y + z);
        assert!(relative_error(stiffness[(0, 0)], axial) < 1e-11);
        let bending = young * t * (y * z * z / 2.0 + z.powi(3) / 6.0);
        errors[0][i] = relative_error(stiffness[(4, 4)], bending);
        let bredt = shear * t * 4.0 * (y * z).powi(2) / (2.0 * (y + z));
        errors[1][i] = relative_error(stiffness[(3, 3)], bredt);
    }
    println!("thin box: {errors:?}");
    for (what, errors) in ["EI", "GJ"].into_iter().zip(errors) {
        check_orders("box", what, errors, 0.9);
    }
}

fn slab(height: f64, cells: usize) -> Mesh {
    let rectangle = Rectangle {
        width: 1.0,
        height,
        cells_y: 10,
        cells_z: cells,
        kind: CellKind::Quadrilateral9,
        name: "core".into(),
    };
    rectangle.generate().expect("sound measures")
}

fn facing(curve: &'static str, plies: &[Ply]) -> Wall {
    Wall {
        curve,
        side: None,
        plies: plies.to_vec(),
    }
}

/// A sandwich: facings as lines on the border of the core, against the same in cells.
/// The cells are the same ones.
#[test]
fn facings_on_a_core_are_those_of_cells() {
    let (core, t) = (0.1, 0.01);
    let materials = [isotropic(1e9, 0.3), isotropic(70e9, 0.25)];
    let facings = ["bottom", "top"].map(|curve| facing(curve, &[(t, 0.0, 1)]));
    let (lines, _) = laminated(slab(core, 4), &materials, &facings);

    let z = joined(&[
        steps(-0.5 * core - t, -0.5 * core, 1),
        steps(-0.5 * core, 0.5 * core, 4),
        steps(0.5 * core, 0.5 * core + t, 1),
    ]);
    let mesh = Quads::lattice(&steps(-0.5, 0.5, 10), &z, |_| Some(0));
    let mesh = mesh.mesh(|_| CellKind::Quadrilateral9);
    let solid = of_two(&mesh, materials, |[_, z]| z.abs() < 0.5 * core);
    let error = scaled_error(&solved(&lines).stiffness, &solved(&solid).stiffness);
    println!("sandwich: {error:.1e}");
    record::largest(CELLS, "facings of a core", "stiffness", error, 1e-11);
    assert!(error < 1e-11, "{error:e}");
}

/// A ply that ends on a core, where the facing continues with the ply below it.
#[test]
fn a_ply_that_ends_is_that_of_cells() {
    let (core, t) = (0.1, 0.02);
    let material = isotropic(70e9, 0.3);
    let mut mesh = slab(core, 4);
    let top = mesh.group(1, "top").expect("the curve");
    // the right half of the top is another curve
    mesh.groups.push(shared_geom::mesh::PhysicalGroup {
        dimension: 1,
        tag: 77,
        name: Some("right half".into()),
    });
    let half = mesh.groups.len() - 1;
    for line in mesh.lines.iter_mut().filter(|l| l.groups.contains(top)) {
        if mesh.nodes[line.nodes()[0] as usize].position.x > -1e-9 {
            line.groups = half.into();
        }
    }
    let walls = [
        facing("top", &[(0.5 * t, 0.0, 0), (0.5 * t, 0.0, 0)]),
        // not the thickness of the ply before: its cells are cut there
        facing("right half", &[(0.75 * t, 0.0, 0)]),
    ];
    let (lines, cells) = laminated(mesh, std::slice::from_ref(&material), &walls);
    // three layers of the left half, two of the right
    assert_eq!(cells.len(), 5 * 3 + 5 * 2);

    let faces = [0.0, 0.5, 0.75, 1.0].map(|part| 0.5 * core + part * t);
    let z = joined(&[steps(-0.5 * core, 0.5 * core, 4), faces.to_vec()]);
    let mesh = Quads::lattice(&steps(-0.5, 0.5, 10), &z, |[y, z]| {
        (y < 0.0 || z < faces[2]).then_some(0)
    });
    let solid = uniform(&mesh.mesh(|_| CellKind::Quadrilateral9), material, 0.0);
    let error = scaled_error(&solved(&lines).stiffness, &solved(&solid).stiffness);
    println!("ply drop: {error:.1e}");
    record::largest(CELLS, "ply that ends on a core", "stiffness", error, 1e-11);
    assert!(error < 1e-11, "{error:e}");
}

/// A skin around a solid ellipse with curved sides, against cells whose nodes lie on the
/// exact normals of the ellipse. At joints of lines the parabolas turn by the cube of the
/// length of a line, and the error of the length of the mitre is the square of that: the
/// sixth order, minus a tenth for the next order on coarse meshes.
#[test]
fn a_skin_on_a_curved_border_is_that_of_cells() {
    let (a, b, t) = (1.0, 0.5, 0.05);
    let materials = [isotropic(1.0, 0.3), isotropic(10.0, 0.3)];
    let errors = [2, 4, 8].map(|cells| {
        let ellipse = Ellipse {
            semi_y: a,
            semi_z: b,
            cells,
            kind: CellKind::Quadrilateral9,
            curved: true,
        };
        let mesh = ellipse.generate().expect("sound measures");
        let (lines, _) = laminated(mesh, &materials, &[facing("boundary", &[(t, 0.0, 1)])]);
        let found = solved(&lines).stiffness;
        let mut exact = lines;
        for [y, z] in &mut exact.mesh.nodes {
            // outside the ellipse: the same distance along its normal
            if (*y / a).powi(2) + (*z / b).powi(2) < 1.0 + 1e-6 {
                continue;
            }
            let (foot, normal, way) = nearest([*y, *z], [a, b]);
            let way = if way > 0.75 * t { t } else { 0.5 * t };
            [*y, *z] = [0, 1].map(|i| foot[i] + way * normal[i]);
        }
        scaled_error(&found, &solved(&exact).stiffness)
    });
    println!("ellipse: {errors:?}");
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        record::order(
            CELLS,
            "skin of an ellipse",
            "stiffness, order in h",
            order,
            5.9,
        );
        assert!(order >= 5.9, "{errors:?}");
    }
}

/// A box with a web of lines that ends on its walls, against cells of the same area on
/// another mesh. Tension and bending without a Poisson ratio are sums over the areas, to
/// round-off: no area is missing or included twice. In torsion a corner line of length L
/// causes an error of L/h times a small number, here L = 5 mm of 50 mm: 5e-3.
#[test]
fn a_web_that_ends_on_walls_is_that_of_cells() {
    let (t, web) = (0.004, 0.006);
    let material = isotropic(70e9, 0.0);
    let [y, z] = HALF;
    let mut mesh = Mesh::default();
    let outline = [
        [-y, -z],
        [-y, z],
        [0.0, z],
        [y, z],
        [y, -z],
        [0.0, -z],
        [-y, -z],
    ];
    add_curve(&mut mesh, "wall", &polygon(&outline, 0.005));
    add_curve(&mut mesh, "web", &polygon(&[[0.0, -z], [0.0, z]], 0.004));
    let wall = |curve, plies: &[Ply]| Wall {
        curve,
        side: None,
        plies: plies.to_vec(),
    };
    let walls = [
        wall("wall", &[(t, 0.0, 0)]),
        wall("web", &[(0.5 * web, 0.0, 0), (0.5 * web, 0.0, 0)]),
    ];
    let (lines, _) = laminated(mesh, std::slice::from_ref(&material), &walls);
    let found = solved(&lines).stiffness;

    let half = |size: f64| {
        joined(&[
            steps(-size - 0.5 * t, -size + 0.5 * t, 2),
            steps(-size + 0.5 * t, size - 0.5 * t, 16),
            steps(size - 0.5 * t, size + 0.5 * t, 2),
        ])
    };
    let y_lines = joined(&[
        steps(-y - 0.5 * t, -y + 0.5 * t, 2),
        steps(-y + 0.5 * t, -0.5 * web, 10),
        steps(-0.5 * web, 0.5 * web, 2),
        steps(0.5 * web, y - 0.5 * t, 10),
        steps(y - 0.5 * t, y + 0.5 * t, 2),
    ]);
    let mesh = Quads::lattice(&y_lines, &half(z), |[at_y, at_z]| {
        let inside = at_y.abs() < y - 0.5 * t && at_z.abs() < z - 0.5 * t;
        (!inside || at_y.abs() < 0.5 * web).then_some(0)
    });
    let solid = uniform(&mesh.mesh(|_| CellKind::Quadrilateral9), material, 0.0);
    let expected = solved(&solid).stiffness;
    for entry in [0, 4, 5] {
        let error = relative_error(found[(entry, entry)], expected[(entry, entry)]);
        assert!(error < 1e-11, "{entry}: {error:e}");
    }
    let error = scaled_error(&found, &expected);
    println!("web: {error:.1e}");
    record::largest(CELLS, "box with a web", "stiffness", error, 5e-3);
    assert!(error < 5e-3, "{error:e}");
}

/// Stresses of plies along lines: the resultants are the load, and in a thin tube under
/// torsion the shear of each ply is the shear of the exact tube at its middle radius. The
/// plane angle is constant in a cell, which spans a = 2 pi / 48: the mean of the shear
/// along it is reduced by the factor 1 - (a/2)^2 / 6, 7e-4; the rest, (t/R)^2 / 48, is
/// 5e-5.
#[test]
fn stresses_of_plies_are_those_of_the_wall() {
    let t = 0.05 * RADIUS;
    let half = [(0.5 * t, 0.0, 0), (0.5 * t, 0.0, 0)];
    let section = alone(&circle(RADIUS), &[isotropic(70e9, 0.3)], &half);
    let solution = solved(&section);
    let torque = 1000.0;
    let mut force = Vector6::zeros();
    force[3] = torque;
    let load = LoadCase::at_point("torsion", &force, [0.0; 2]);
    let recovery = recover(&section, &solution, &load).expect("a recovery");
    assert!(recovery.resultant_error < 1e-12);
    let [outer, inner] = [RADIUS + 0.5 * t, RADIUS - 0.5 * t];
    let polar = 0.5 * PI * (outer.powi(4) - inner.powi(4));
    let mut worst = 0.0_f64;
    for (cell, state) in section.mesh.cells.iter().zip(&recovery.cells) {
        // the mean over the ply, whose shear is linear in the radius up to (t/R)^2
        let [y, z] = section.mesh.middle(cell);
        let side = if y.hypot(z) > RADIUS { 1.0 } else { -1.0 };
        let expected = torque * (RADIUS + side * 0.25 * t) / polar;
        // 12 of the material: along x and the wall, which runs clockwise
        let found = -state.tensors.material_stress[5];
        worst = worst.max((found / expected - 1.0).abs());
    }
    println!("shear of plies: {worst:.1e}");
    record::largest(BREDT, "thin tube", "shear of each ply", worst, 1e-3);
    assert!(worst < 1e-3, "{worst:e}");
}
