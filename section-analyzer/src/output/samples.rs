//! Sections with stresses in closed form, for the tests of the output.

use nalgebra::Vector6;
use shared_geom::error::SourceLocation;
use shared_geom::mesh::{CellKind, Mesh};
use shared_geom::section::InitialCurvature;

use crate::material::{ElasticLaw, Material};
use crate::mesh::generate::Rectangle;
use crate::mesh::{SectionCell, SectionMesh};
use crate::recovery::{CellState, LoadCase, NodalState, Recovery, Tensors};
use crate::section::{CellMaterial, Section};

/// Young's modulus of the samples \[Pa\].
pub(super) const YOUNG: f64 = 70e9;

/// A section of isotropic material on `mesh`, in meters; if `halves`, cells whose corners
/// have a mean z > 0 are a separate region.
pub(super) fn section(mesh: &Mesh, name: &str, halves: bool) -> Section {
    let (mut mesh, _) =
        SectionMesh::from_mesh(mesh, 1.0, &SourceLocation::file("test")).expect("a sound mesh");
    if halves {
        mesh.groups = vec!["lower".into(), "upper".into()];
        let corners = |cell: &SectionCell| cell.kind.corner_count();
        for cell in &mut mesh.cells {
            let nodes = &cell.nodes()[..corners(cell)];
            let z: f64 = nodes.iter().map(|&node| mesh.nodes[node as usize][1]).sum();
            cell.group = usize::from(z > 0.0);
        }
    }
    let made_of = CellMaterial {
        material: 0,
        fiber_angle: 0.0,
        plane_angle: 0.0,
    };
    Section {
        name: name.into(),
        cells: vec![made_of; mesh.cells.len()],
        materials: vec![Material {
            name: "aluminum".into(),
            law: ElasticLaw::Isotropic {
                young: YOUNG,
                poisson: 0.3,
            },
            density: 2700.0,
            expansion: None,
            electric: None,
        }],
        mesh,
        initial_curvature: InitialCurvature::STRAIGHT,
        electrodes: Vec::new(),
    }
}

/// A rectangle of two halves, one above the other, of cells of `kind`.
pub(super) fn rectangle(kind: CellKind) -> Section {
    let rectangle = Rectangle {
        width: 0.2,
        height: 0.1,
        cells_y: 4,
        cells_z: 2,
        kind,
        name: "bar".into(),
    };
    section(&rectangle.generate().expect("sound measures"), "bar", true)
}

/// The stress of a section in bending about y, `stress xx = z M / I`.
pub(super) fn bending(section: &Section, moment: f64, inertia: f64) -> Recovery {
    let force = Vector6::new(0.0, 0.0, 0.0, 0.0, moment, 0.0);
    recovery(section, "bending", force, |_, [_, z]| {
        Vector6::new(z * moment / inertia, 0.0, 0.0, 0.0, 0.0, 0.0)
    })
}

/// A recovery whose stress at a position in a region is `stress(region, position)`, with
/// strains of uniaxial stress.
pub(super) fn recovery(
    section: &Section,
    name: &str,
    force: Vector6<f64>,
    stress: impl Fn(usize, [f64; 2]) -> Vector6<f64>,
) -> Recovery {
    let mesh = &section.mesh;
    let tensors = |group, position| {
        let stress = stress(group, position);
        Tensors {
            stress,
            strain: stress / YOUNG,
            material_stress: stress,
            material_strain: stress / YOUNG,
        }
    };
    let mut nodes: Vec<NodalState> = Vec::new();
    let mut cell_nodes = vec![Vec::new(); mesh.cells.len()];
    for group in 0..mesh.groups.len() {
        let mut state_of = vec![None; mesh.nodes.len()];
        for (cell, states) in mesh.cells.iter().zip(&mut cell_nodes) {
            for &node in cell.nodes().iter().filter(|_| cell.group == group) {
                let node = node as usize;
                let state = *state_of[node].get_or_insert_with(|| {
                    let tensors = tensors(group, mesh.nodes[node]);
                    nodes.push(NodalState {
                        node,
                        group,
                        tensors,
                    });
                    nodes.len() as u32 - 1
                });
                states.push(state);
            }
        }
    }
    let cells = mesh.cells.iter().map(|cell| {
        let centroid = mesh.middle(cell);
        CellState {
            centroid,
            tensors: tensors(cell.group, centroid),
        }
    });
    Recovery {
        load: LoadCase::at_point(name, &force, [0.0; 2]),
        generalized_strain: Vector6::zeros(),
        is_distributed: false,
        stress_scale: 0.0,
        strain_scale: 0.0,
        points: Vec::new(),
        cells: cells.collect(),
        nodes,
        cell_nodes,
        resultant: force,
        resultant_error: 0.0,
        electric: None,
    }
}
