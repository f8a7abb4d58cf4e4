//! Meshes with lines and sections of laminates along them.

use section_analyzer::material::Material;
use section_analyzer::mesh::{Lamina, LaminaCell, LaminaFace, LaminaSide, add_laminae};
use section_analyzer::section::{CellMaterial, Section};
use shared_geom::mesh::{Line, LineKind, Mesh, Node, PhysicalGroup};
use shared_geom::section::InitialCurvature;

use crate::quads::{joined, steps};
use crate::sections::section_mesh;

/// A ply: thickness [m], fiber angle [rad], material.
pub type Ply = (f64, f64, usize);

/// A laminate along the curve of a name.
#[derive(Debug, Clone)]
pub struct Wall {
    pub curve: &'static str,
    pub side: Option<LaminaSide>,
    pub plies: Vec<Ply>,
}

/// A curve made of quadratic lines: `points` are ends and middles in turn, the first
/// again at the end of a closed curve.
pub fn add_curve(mesh: &mut Mesh, name: &str, points: &[[f64; 2]]) {
    let nodes: Vec<u32> = points
        .iter()
        .map(|&[y, z]| {
            let same = |node: &Node| {
                (node.position.x - y).abs() < 1e-12 && (node.position.y - z).abs() < 1e-12
            };
            let known = mesh.nodes.iter().position(same);
            known.unwrap_or_else(|| {
                mesh.nodes.push(Node {
                    tag: mesh.nodes.len() as u64 + 1,
                    position: [y, z, 0.0].into(),
                });
                mesh.nodes.len() - 1
            }) as u32
        })
        .collect();
    for ends in nodes.windows(3).step_by(2) {
        let tag = 1000 + mesh.lines.len() as u64;
        let mut line = Line::new(tag, LineKind::Line3, 1, |i| ends[[0, 2, 1][i]]);
        line.groups = mesh.groups.len().into();
        mesh.lines.push(line);
    }
    mesh.groups.push(PhysicalGroup {
        dimension: 1,
        tag: mesh.groups.len() as i32 + 1,
        name: Some(name.to_owned()),
    });
}

/// Straight lines between corners, with their middles: at each corner a line of length
/// `first`, then twice that and so on, up to an eighth of the distance between corners.
pub fn polygon(corners: &[[f64; 2]], first: f64) -> Vec<[f64; 2]> {
    let mut points = vec![corners[0]];
    for ends in corners.windows(2) {
        let length = (ends[1][0] - ends[0][0]).hypot(ends[1][1] - ends[0][1]);
        for parts in graded_to_ends(length, first).windows(2) {
            for part in [0.5 * (parts[0] + parts[1]), parts[1]] {
                let part = part / length;
                points.push(
                    [0, 1].map(|axis| ends[0][axis] + part * (ends[1][axis] - ends[0][axis])),
                );
            }
        }
    }
    points
}

/// Positions from 0 to `length`, as in [`polygon`].
pub fn graded_to_ends(length: f64, first: f64) -> Vec<f64> {
    let mut near = vec![0.0];
    let mut step = first;
    while step < length / 8.0 {
        near.push(near[near.len() - 1] + step);
        step *= 2.0;
    }
    let reach = near[near.len() - 1];
    let between = ((length - 2.0 * reach) / (length / 8.0)).ceil() as usize;
    let far = near.iter().rev().map(|x| length - x).collect();
    joined(&[near, steps(reach, length - reach, between), far])
}

/// The section of `mesh` with these laminates, and the laminate part of each of their
/// cells; the cells of the mesh itself are of the first material, at zero angles. The faces
/// are the curves `CURVE/left` and `CURVE/right`.
pub fn laminated(
    mut mesh: Mesh,
    materials: &[Material],
    walls: &[Wall],
) -> (Section, Vec<LaminaCell>) {
    let mut laminae = Vec::new();
    for wall in walls {
        let curve = mesh.group(1, wall.curve).expect("the curve");
        let groups = wall.plies.iter().map(|_| {
            mesh.groups.push(PhysicalGroup {
                dimension: 2,
                tag: mesh.groups.len() as i32 + 100,
                name: Some(format!("ply {}", mesh.groups.len())),
            });
            mesh.groups.len() - 1
        });
        laminae.push(Lamina {
            curve,
            side: wall.side,
            groups: groups.collect(),
            thicknesses: wall.plies.iter().map(|ply| ply.0).collect(),
        });
    }
    let solid = mesh.cells.len();
    let found = add_laminae(&mut mesh, &laminae).expect("sound laminates");
    add_faces(&mut mesh, walls, &found.faces);
    let core = CellMaterial {
        material: 0,
        fiber_angle: 0.0,
        plane_angle: 0.0,
    };
    let mut cells = vec![core; solid];
    cells.extend(found.cells.iter().map(|cell| {
        let (_, fiber_angle, material) = walls[cell.lamina].plies[cell.ply];
        CellMaterial {
            material,
            fiber_angle,
            plane_angle: cell.direction,
        }
    }));
    let section = Section {
        name: "laminated".into(),
        mesh: section_mesh(&mesh),
        materials: materials.to_vec(),
        cells,
        initial_curvature: InitialCurvature::STRAIGHT,
        electrodes: Vec::new(),
    };
    (section, found.cells)
}

/// Adds the faces of laminates as curves.
fn add_faces(mesh: &mut Mesh, walls: &[Wall], faces: &[LaminaFace]) {
    for face in faces {
        let name = format!("{}/{}", walls[face.lamina].curve, face.side.name());
        let group = mesh.group(1, &name).unwrap_or_else(|| {
            mesh.groups.push(PhysicalGroup {
                dimension: 1,
                tag: mesh.groups.len() as i32 + 100,
                name: Some(name),
            });
            mesh.groups.len() - 1
        });
        let mut line = face.line.clone();
        line.groups = group.into();
        mesh.lines.push(line);
    }
}

/// The laminate centered on a curve, without other cells.
pub fn alone(curve: &[[f64; 2]], materials: &[Material], plies: &[Ply]) -> Section {
    let mut mesh = Mesh::default();
    add_curve(&mut mesh, "wall", curve);
    let wall = Wall {
        curve: "wall",
        side: None,
        plies: plies.to_vec(),
    };
    laminated(mesh, materials, &[wall]).0
}

/// The point of an ellipse nearest to a point near it, the normal there, and the distance.
pub fn nearest(p: [f64; 2], [a, b]: [f64; 2]) -> ([f64; 2], [f64; 2], f64) {
    let mut angle = (p[1] / b).atan2(p[0] / a);
    for _ in 0..50 {
        let (s, c) = angle.sin_cos();
        let off = [p[0] - a * c, p[1] - b * s];
        let slope = off[0] * -a * s + off[1] * b * c;
        let bend = (a * s).powi(2) + (b * c).powi(2) + off[0] * a * c + off[1] * b * s;
        angle += slope / bend;
    }
    let (s, c) = angle.sin_cos();
    let length = (b * c).hypot(a * s);
    let (foot, normal) = ([a * c, b * s], [b * c / length, a * s / length]);
    let way = (p[0] - foot[0]) * normal[0] + (p[1] - foot[1]) * normal[1];
    (foot, normal, way)
}
