//! Small sections for the unit tests of this crate.

use crate::material::{ElasticLaw, EngineeringConstants, Material};
use crate::mesh::generate::Rectangle;
use crate::mesh::{SectionCell, SectionMesh};
use crate::section::{CellMaterial, FreeStrain, ImposedStrain, Section};
use nalgebra::Vector6;
use shared_geom::error::SourceLocation;
use shared_geom::mesh::CellKind;
use shared_geom::section::InitialCurvature;

/// A ply without simple ratios between its constants, stiffness of order one.
pub(crate) const PLY: EngineeringConstants = EngineeringConstants {
    e1: 9.0,
    e2: 1.4,
    e3: 1.1,
    g12: 0.8,
    g13: 0.6,
    g23: 0.5,
    nu12: 0.3,
    nu13: 0.25,
    nu23: 0.35,
};

/// A carbon ply with three different axes [Pa, -].
pub(crate) const CARBON: EngineeringConstants = EngineeringConstants {
    e1: 142e9,
    e2: 9.8e9,
    e3: 11.2e9,
    g12: 6.0e9,
    g13: 5.5e9,
    g23: 4.8e9,
    nu12: 0.3,
    nu13: 0.34,
    nu23: 0.42,
};

/// Numbers in [-1, 1] from a fixed linear congruential sequence (Knuth's MMIX).
pub(crate) struct Random(pub u64);

impl Random {
    pub fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    pub fn point(&mut self) -> [f64; 2] {
        [self.next(), self.next()]
    }
}

/// A rectangle whose cells are plies of many directions: no coupling is zero.
pub(crate) fn coupled_rectangle(kind: CellKind) -> Section {
    let mesh = Rectangle {
        width: 1.6,
        height: 1.0,
        cells_y: 3,
        cells_z: 2,
        kind,
        name: "bar".into(),
    }
    .generate()
    .expect("sound measures");
    let (mut mesh, _) =
        SectionMesh::from_mesh(&mesh, 1.0, &SourceLocation::file("test")).expect("sound");
    // off the origin, sides curved
    for [y, z] in &mut mesh.nodes {
        (*y, *z) = (*y + 0.7 + 0.1 * *z * *z, *z - 0.4 + 0.05 * *y * *y);
    }
    of_cells(mesh, ElasticLaw::Orthotropic(PLY))
}

/// A strip of isotropic material with unit modulus, with these cells along and through it.
pub(crate) fn strip_of(width: f64, height: f64, cells: [usize; 2], kind: CellKind) -> Section {
    let mesh = Rectangle {
        width,
        height,
        cells_y: cells[0],
        cells_z: cells[1],
        kind,
        name: "strip".into(),
    }
    .generate()
    .expect("sound measures");
    let (mesh, _) =
        SectionMesh::from_mesh(&mesh, 1.0, &SourceLocation::file("test")).expect("sound");
    let (young, poisson) = (1.0, 0.33);
    of_cells(mesh, ElasticLaw::Isotropic { young, poisson })
}

/// A section of isotropic material with unit modulus, given its nodes and
/// quadrilaterals.
pub(crate) fn of_quadrilaterals(nodes: &[[f64; 2]], cells: &[[u32; 4]]) -> Section {
    let cell = |(index, nodes): (usize, &[u32; 4])| {
        SectionCell::new(index as u64 + 1, CellKind::Quadrilateral4, 0, |i| nodes[i])
    };
    let mesh = SectionMesh {
        nodes: nodes.to_vec(),
        node_tags: (1..=nodes.len() as u64).collect(),
        cells: cells.iter().enumerate().map(cell).collect(),
        groups: vec!["all".into()],
        curves: Vec::new(),
    };
    of_cells(
        mesh,
        ElasticLaw::Isotropic {
            young: 1.0,
            poisson: 0.3,
        },
    )
}

/// Strains without any pattern, linear in each cell.
pub(crate) fn random_strain(section: &Section, name: &str, random: &mut Random) -> ImposedStrain {
    let mut any = || Vector6::from_fn(|_, _| random.next());
    let mut cell = |_| FreeStrain {
        at_origin: any(),
        by_y: any(),
        by_z: any(),
    };
    ImposedStrain {
        name: name.into(),
        cells: section.cells.iter().map(&mut cell).collect(),
    }
}

fn of_cells(mesh: SectionMesh, law: ElasticLaw) -> Section {
    let material = Material {
        name: "material".into(),
        law,
        density: 2.0,
        expansion: None,
        electric: None,
    };
    let cell = |index: usize| CellMaterial {
        material: 0,
        fiber_angle: 0.3 + 0.4 * index as f64,
        plane_angle: 0.2 * index as f64,
    };
    Section {
        name: "sample".into(),
        cells: (0..mesh.cells.len()).map(cell).collect(),
        materials: vec![material],
        mesh,
        initial_curvature: InitialCurvature::STRAIGHT,
        electrodes: Vec::new(),
    }
}
