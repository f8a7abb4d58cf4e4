//! The estimate of the discretization error against true errors.
use nalgebra::Matrix6;
use section_analyzer::analysis::discretization_error;
use section_analyzer::mesh::refined;
use section_analyzer::section::{CellMaterial, Section};
use section_analyzer::solution::DiscretizationError;
use shared_geom::mesh::CellKind;

use crate::closed_forms::{cells_of, ellipse, rectangle, torsion_constant};
use crate::quads::Quads;
use crate::reference_cases::{self, material, number, read_case, read_mesh};
use crate::sections::{isotropic, section_mesh, solved, uniform};

fn show(what: &str, section: &Section, exact: &Matrix6<f64>) {
    let k = solved(section).stiffness;
    let e = discretization_error(section, &k).unwrap();
    let mut line = String::new();
    for i in 0..6 { for j in i..6 {
        let t = k[(i,j)] - exact[(i,j)];
        let root = (exact[(i,i)]*exact[(j,j)]).sqrt();
        if DiscretizationError::is_of_entry(exact,(i,j)) {
            line += &format!("  {}{} {:.1e} eff {:.2};", i+1, j+1, t/exact[(i,j)].abs(), e.stiffness[(i,j)]/t);
        } else if t.abs()/root > 1e-9 {
            line += &format!("  ({}{} {:.1e} eff {:.2});", i+1, j+1, t/root, e.stiffness[(i,j)]/t);
        }
    }}
    println!("{what}: {} cells\n{line}", section.mesh.cells.len());
}
fn finer(section: &Section) -> Section {
    let r = refined(&section.mesh);
    Section { cells: r.originals.iter().map(|&o| section.cells[o]).collect(), mesh: r.mesh, ..section.clone() }
}
#[test]
fn proto_smooth() {
    for kind in CellKind::ALL { for n in [2, 4,8,16] {
        let s = uniform(&rectangle(2.0,1.0,[2*n,n],kind), isotropic(1.0,0.3),0.0);
        let fine = uniform(&rectangle(2.0,1.0,[96,48],CellKind::Quadrilateral9), isotropic(1.0,0.3),0.0);
        let mut x = solved(&fine).stiffness;
        x[(3,3)] = torsion_constant(2.0,1.0)/2.6;
        show(&format!("rectangle {kind:?} {n}"), &s, &x);
        if !kind.is_quadratic() {continue}
        let s = uniform(&ellipse(2.0,1.0,n,kind), isotropic(1.0,0.3),0.0);
        let x = solved(&uniform(&ellipse(2.0,1.0,24,CellKind::Quadrilateral9), isotropic(1.0,0.3),0.0)).stiffness;
        show(&format!("ellipse {kind:?} {n}"), &s, &x);
    }}
}
fn bx(per_ply: usize, along: [usize;2], kind: CellKind) -> Section {
    let case = read_case("box_CUS_45_m45");
    let (outline, inner) = ([0.0121031, 0.006731], [0.0113411, 0.005969]);
    let through = per_ply*6;
    let line = |k: usize| [0, 1].map(|axis| outline[axis] + (inner[axis] - outline[axis]) * k as f64 / through as f64);
    let lines: Vec<_> = (0..=through).map(line).collect();
    let mesh = section_mesh(&Quads::rings(&lines, along).mesh(|_| kind));
    let cells = mesh.cells.iter().map(|cell| {
        let group = cell.group;
        let tag = 10 * (group % 4 + 1) + group / 4 / per_ply;
        let group = &case["groups"][tag.to_string()];
        CellMaterial { material: group["material"].as_u64().unwrap() as usize,
            fiber_angle: number(&group["fibre_deg"]).to_radians(), plane_angle: number(&group["plane_deg"]).to_radians() }
    }).collect();
    Section { name: "box".into(), cells, materials: case["materials"].as_array().unwrap().iter().map(material).collect(), mesh,
        initial_curvature: shared_geom::section::InitialCurvature::STRAIGHT, electrodes: Vec::new() }
}
#[test]
fn proto_box() {
    let t = std::time::Instant::now();
    let a = solved(&bx(2,[64,44],CellKind::Quadrilateral9)).stiffness;
    let b = solved(&bx(4,[128,88],CellKind::Quadrilateral9)).stiffness;
    println!("fine {:?}; change {:e}", t.elapsed(), (a-b).component_div(&b).abs().max());
    let x = b + (b-a)*0.5;
    for kind in CellKind::ALL { for (p,n) in [(1,[8,6]),(1,[16,12]),(2,[32,22])] {
        show(&format!("box {kind:?} {p} {n:?} {}", cells_of(kind)), &bx(p,n,kind), &x);
    }}
}
#[test]
fn proto_blade() {
    let case = read_case("blade_naca");
    let mesh = read_mesh("blade_naca", "v22");
    for linear in [false, true] {
        let mesh = if linear { reference_cases::with_corners_only(&mesh) } else { mesh.clone() };
        let s = reference_cases::section("blade_naca", &case, &mesh);
        let one = finer(&finer(&s));
        let two = if linear { finer(&one) } else { one.clone() };
        let t = std::time::Instant::now();
        let x1 = solved(&finer(&s)).stiffness;
        let x = solved(&two).stiffness;
        println!("{} cells {:?}", two.mesh.cells.len(), t.elapsed());
        let _ = x1;
        show(&format!("blade linear {linear}"), &s, &x);
        if !linear { show("blade finer", &finer(&s), &(x + (x - x1)*0.2)); }
    }
}
