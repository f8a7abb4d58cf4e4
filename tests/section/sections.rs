//! Sections for the tests of this suite, and comparison of matrices.

use nalgebra::Matrix6;
use section_analyzer::analysis::analyze;
use section_analyzer::assembly::{Domain, IDENTITIES, Pattern, SectionMatrices, check_identities};
use section_analyzer::failure::Failure;
use section_analyzer::material::{ElasticLaw, EngineeringConstants, Material};
use section_analyzer::mesh::SectionMesh;
use section_analyzer::section::{CellMaterial, Section};
use section_analyzer::solution::SectionSolution;
use shared_geom::error::SourceLocation;
use shared_geom::mesh::Mesh;
use shared_geom::section::InitialCurvature;

/// A material of unit density.
pub fn material(law: ElasticLaw) -> Material {
    Material {
        name: "material".into(),
        law,
        density: 1.0,
        expansion: None,
        electric: None,
    }
}

/// An isotropic material of unit density.
pub fn isotropic(young: f64, poisson: f64) -> Material {
    material(ElasticLaw::Isotropic { young, poisson })
}

/// An orthotropic material of unit density.
pub fn orthotropic(constants: EngineeringConstants) -> Material {
    material(ElasticLaw::Orthotropic(constants))
}

/// The section mesh of a mesh in meters.
pub fn section_mesh(mesh: &Mesh) -> SectionMesh {
    let (mesh, _) = SectionMesh::from_mesh(mesh, 1.0, &SourceLocation::file("test"))
        .unwrap_or_else(|problems| panic!("{problems}"));
    mesh
}

/// The section of one material, fibers at `fiber_angle` [rad] from the beam axis
/// in planes z = constant.
pub fn uniform(mesh: &Mesh, material: Material, fiber_angle: f64) -> Section {
    let mesh = section_mesh(mesh);
    let cell = CellMaterial {
        material: 0,
        fiber_angle,
        plane_angle: 0.0,
    };
    Section {
        name: "uniform".into(),
        cells: vec![cell; mesh.cells.len()],
        mesh,
        materials: vec![material],
        initial_curvature: InitialCurvature::STRAIGHT,
        electrodes: Vec::new(),
    }
}

/// The section in which cells with a center that `is_first` accepts are of the first
/// material, all others of the second.
pub fn of_two(
    mesh: &Mesh,
    materials: [Material; 2],
    is_first: impl Fn([f64; 2]) -> bool,
) -> Section {
    let mut section = uniform(mesh, materials[0].clone(), 0.0);
    section.materials = materials.to_vec();
    for (cell, made_of) in section.mesh.cells.iter().zip(&mut section.cells) {
        let corners = &cell.nodes()[..cell.kind.corner_count()];
        let mean = |axis: usize| {
            let positions = corners
                .iter()
                .map(|&n| section.mesh.nodes[n as usize][axis]);
            positions.sum::<f64>() / corners.len() as f64
        };
        made_of.material = usize::from(!is_first([mean(0), mean(1)]));
    }
    section
}

/// Largest error of each of the [`IDENTITIES`] in all six rigid motions.
pub fn identity_errors(section: &Section) -> [f64; 6] {
    let fail = |failure: Failure| -> ! { panic!("{}: {failure}", section.name) };
    let domain = Domain::new(section).unwrap_or_else(|failure| fail(failure));
    let matrices = SectionMatrices::assemble(&domain, &Pattern::new(&domain));
    check_identities(&domain, &matrices.unwrap_or_else(|failure| fail(failure)))
}

/// Tolerance of the identities: round-off of sums of some thousand terms, and of the
/// derivatives in cells as thin as a thousandth of the section.
pub const IDENTITY: f64 = 1e-12;

/// The solution of a section that has one, after a check of all identities.
pub fn solved(section: &Section) -> SectionSolution {
    for (name, error) in IDENTITIES.iter().zip(identity_errors(section)) {
        assert!(error < IDENTITY, "{}, {name}: {error:e}", section.name);
    }
    analyze(section).unwrap_or_else(|failure| panic!("{}: {failure}", section.name))
}

/// Largest `|found_ij - expected_ij| / sqrt(expected_ii expected_jj)`.
pub fn scaled_error(found: &Matrix6<f64>, expected: &Matrix6<f64>) -> f64 {
    let mut worst = 0.0_f64;
    for i in 0..6 {
        for j in 0..6 {
            let scale = (expected[(i, i)] * expected[(j, j)]).sqrt();
            worst = worst.max((found[(i, j)] - expected[(i, j)]).abs() / scale);
        }
    }
    worst
}

/// `|found / expected - 1|`.
pub fn relative_error(found: f64, expected: f64) -> f64 {
    (found / expected - 1.0).abs()
}
