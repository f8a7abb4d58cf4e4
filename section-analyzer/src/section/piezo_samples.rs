//! Small piezoelectric sections for the unit tests of this crate.

use crate::material::{ElasticLaw, ElectricLaw, Material, VACUUM_PERMITTIVITY};
use crate::mesh::SectionMesh;
use crate::mesh::generate::Rectangle;
use crate::section::{
    CellMaterial, Circuit, Electrode, ElectrodeShape, FingeredCell, InitialCurvature, Section,
};
use nalgebra::{Matrix3, Matrix3x6, Matrix6, Vector3};
use shared_geom::error::SourceLocation;
use shared_geom::mesh::CellKind;

const S11: f64 = 16.5e-12;
const D31: f64 = -274e-12;
const EPS33: f64 = 3400.0 * VACUUM_PERMITTIVITY;

/// Height of the layer, and of each layer of the bimorph \[m\].
pub(crate) const LAYER: f64 = 0.001;

/// Square of the coupling factor of a bar, `d31^2 / (s11 epsT33)` \[-\].
pub(crate) fn k31() -> f64 {
    D31 * D31 / (S11 * EPS33)
}

/// PZT-5H, poled along its axis 3 if `sign` is one, opposite if it is minus one.
fn pzt(sign: f64) -> Material {
    let (s12, s13, s33, s44, s66) = (-4.78e-12, -8.45e-12, 20.7e-12, 43.5e-12, 42.6e-12);
    let mut s = Matrix6::zeros();
    for (i, j, value) in [
        (0, 0, S11),
        (1, 1, S11),
        (2, 2, s33),
        (0, 1, s12),
        (0, 2, s13),
        (1, 2, s13),
        (3, 3, s44),
        (4, 4, s44),
        (5, 5, s66),
    ] {
        s[(i, j)] = value;
        s[(j, i)] = value;
    }
    let mut d = Matrix3x6::zeros();
    for (i, j, value) in [
        (2, 0, D31),
        (2, 1, D31),
        (2, 2, 593e-12),
        (1, 3, 741e-12),
        (0, 4, 741e-12),
    ] {
        d[(i, j)] = sign * value;
    }
    let c = s.try_inverse().expect("a regular compliance");
    let c = 0.5 * (c + c.transpose());
    let at_stress = Matrix3::from_diagonal(&Vector3::new(
        3130.0 * VACUUM_PERMITTIVITY,
        3130.0 * VACUUM_PERMITTIVITY,
        EPS33,
    ));
    Material {
        name: "pzt".into(),
        electric: Some(ElectricLaw::of_strains(&d, &at_stress, &c)),
        law: ElasticLaw::Full(c),
        density: 7500.0,
        expansion: None,
    }
}

fn rectangle(height: f64, cells: usize) -> Section {
    let mesh = Rectangle {
        width: 0.002,
        height,
        cells_y: 4,
        cells_z: cells,
        kind: CellKind::Quadrilateral9,
        name: "layer".into(),
    };
    let mesh = mesh.generate().expect("sound measures");
    let (mesh, _) =
        SectionMesh::from_mesh(&mesh, 1.0, &SourceLocation::file("test")).expect("sound mesh");
    let cell = CellMaterial {
        material: 0,
        fiber_angle: 0.0,
        plane_angle: 0.0,
    };
    Section {
        name: "piezo".into(),
        cells: vec![cell; mesh.cells.len()],
        mesh,
        materials: vec![pzt(1.0)],
        initial_curvature: InitialCurvature::STRAIGHT,
        electrodes: Vec::new(),
    }
}

fn add_conductor(section: &mut Section, name: &str, circuit: Circuit, z: f64) {
    let positions = section.mesh.nodes.iter().enumerate();
    let there = positions.filter(|(_, position)| (position[1] - z).abs() < 1e-9 * LAYER);
    let nodes = there.map(|(node, _)| node as u32).collect();
    section.electrodes.push(Electrode {
        name: name.into(),
        circuit,
        shape: ElectrodeShape::Conductor { nodes },
    });
}

/// A layer of 2 mm by 1 mm between the electrodes `bottom`, grounded, and `top`, driven.
pub(crate) fn layer() -> Section {
    let mut section = rectangle(LAYER, 2);
    add_conductor(&mut section, "bottom", Circuit::Ground, -0.5 * LAYER);
    add_conductor(&mut section, "top", Circuit::Driven, 0.5 * LAYER);
    section
}

/// Two of these layers, poled in opposite directions: `middle`, grounded, `top` and
/// `bottom`, driven.
pub(crate) fn bimorph() -> Section {
    let mut section = rectangle(2.0 * LAYER, 4);
    section.materials.push(pzt(-1.0));
    for (cell, made_of) in section.mesh.cells.iter().zip(&mut section.cells) {
        made_of.material = usize::from(section.mesh.middle(cell)[1] > 0.0);
    }
    add_conductor(&mut section, "middle", Circuit::Ground, 0.0);
    add_conductor(&mut section, "top", Circuit::Driven, LAYER);
    add_conductor(&mut section, "bottom", Circuit::Driven, -LAYER);
    section
}

/// The layer with fingers over its upper half, the lower half without field.
pub(crate) fn fingered() -> Section {
    let mut section = rectangle(LAYER, 2);
    let cells = section.mesh.cells.iter().enumerate();
    let upper = cells.filter(|(_, cell)| section.mesh.middle(cell)[1] > 0.0);
    let cells = upper.map(|(cell, _)| FingeredCell {
        cell: cell as u32,
        field: Vector3::new(0.0, 0.6 / LAYER, 0.8 / LAYER),
    });
    section.electrodes = vec![Electrode {
        name: "fingers".into(),
        circuit: Circuit::Driven,
        shape: ElectrodeShape::Interdigitated {
            cells: cells.collect(),
        },
    }];
    section
}
