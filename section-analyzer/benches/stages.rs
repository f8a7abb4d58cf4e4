//! Time of each stage of a section analysis: a rectangle of 64 x 32 cells with eight
//! nodes, 19 000 unknowns. The factorization should be most of it.

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use section_analyzer::analysis::analyze;
use section_analyzer::assembly::{Domain, Pattern, SectionMatrices};
use section_analyzer::material::{ElasticLaw, Material};
use section_analyzer::mesh::SectionMesh;
use section_analyzer::mesh::generate::Rectangle;
use section_analyzer::section::{CellMaterial, Section};
use section_analyzer::solve::{CentralSolution, CentralSystems, Pins, in_elimination_order};
use shared_geom::error::Place;
use shared_geom::mesh::CellKind;
use shared_geom::section::InitialCurvature;

fn section() -> Option<Section> {
    let rectangle = Rectangle {
        width: 0.2,
        height: 0.1,
        cells_y: 64,
        cells_z: 32,
        kind: CellKind::Quadrilateral8,
        name: "bar".to_owned(),
    };
    let mesh = rectangle.generate().ok()?;
    let (mesh, _) = SectionMesh::from_mesh(&mesh, 1.0, &Place::file("bar")).ok()?;
    let steel = Material {
        name: "steel".to_owned(),
        law: ElasticLaw::Isotropic {
            young: 210e9,
            poisson: 0.3,
        },
        density: 7850.0,
        expansion: None,
        electric: None,
    };
    let cell = CellMaterial {
        material: 0,
        fiber_angle: 0.0,
        plane_angle: 0.0,
    };
    Some(Section {
        name: "bar".to_owned(),
        cells: vec![cell; mesh.cells.len()],
        mesh,
        materials: vec![steel],
        initial_curvature: InitialCurvature::STRAIGHT,
        electrodes: Vec::new(),
    })
}

/// The domain and pattern of the section, in the order of elimination.
fn prepared(section: &Section) -> Option<(Domain, Pattern)> {
    let domain = Domain::new(section).ok()?;
    let pattern = Pattern::new(&domain);
    in_elimination_order(domain, &pattern)
}

fn stages(criterion: &mut Criterion) {
    let Some(section) = section() else { return };
    let Some((domain, pattern)) = prepared(&section) else {
        return;
    };
    let Ok(matrices) = SectionMatrices::assemble(&domain, &pattern) else {
        return;
    };
    let Ok(pins) = Pins::choose(&domain.nodes) else {
        return;
    };
    let Ok(system) = CentralSystems::new(&domain, &pattern, matrices.clone(), pins.clone()) else {
        return;
    };

    let mut group = criterion.benchmark_group("section");
    group.sample_size(10);
    group.bench_function("domain and pattern", |b| {
        b.iter(|| black_box(prepared(&section).is_some()));
    });
    group.bench_function("assembly", |b| {
        b.iter(|| black_box(SectionMatrices::assemble(&domain, &pattern).is_ok()));
    });
    group.bench_function("factorization", |b| {
        b.iter(|| {
            black_box(
                CentralSystems::new(&domain, &pattern, matrices.clone(), pins.clone()).is_ok(),
            )
        });
    });
    group.bench_function("central solutions", |b| {
        b.iter(|| black_box(CentralSolution::solve(&domain, &system).is_some()));
    });
    group.bench_function("whole analysis", |b| {
        b.iter(|| black_box(analyze(&section).is_ok()))
    });
    group.finish();
}

criterion_group!(benches, stages);
criterion_main!(benches);
