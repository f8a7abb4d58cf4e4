use super::*;
use crate::assembly::{Rate, State, section_forces};
use crate::material::ElasticLaw;
use crate::properties::scaled_difference;
use crate::section::samples::{coupled_rectangle, of_quadrilaterals, strip_of};
use approx::assert_relative_eq;
use nalgebra::Matrix6;
use shared_geom::error::Explain;
use shared_geom::mesh::CellKind;

/// A 2 x 2 grid of unit squares, from (y0, z0): its nodes, row by row.
fn grid(y0: f64, z0: f64) -> Vec<[f64; 2]> {
    let rows = (0..3).flat_map(|j| (0..3).map(move |i| (i, j)));
    rows.map(|(i, j)| [y0 + f64::from(i), z0 + f64::from(j)])
        .collect()
}

const GRID_CELLS: [[u32; 4]; 4] = [[0, 1, 4, 3], [1, 2, 5, 4], [3, 4, 7, 6], [4, 5, 8, 7]];

/// Every check of a fully coupled section on a curved mesh off the origin is at
/// round-off.
#[test]
fn checks_are_at_round_off() {
    for kind in CellKind::ALL {
        let solution = analyze(&coupled_rectangle(kind)).expect("sound section");
        let checks = solution.checks;
        for error in checks.identities {
            assert!(error < 1e-13, "{kind:?}: {checks:?}");
        }
        assert!(checks.equilibrium < 1e-13, "{kind:?}: {checks:?}");
        assert!(checks.asymmetry < 1e-13, "{kind:?}: {checks:?}");
        assert!(checks.decoupling < 1e-13, "{kind:?}: {checks:?}");
        assert!(checks.correction < 1e-9, "{kind:?}: {checks:?}");
        assert!(checks.smallest_pivot > 1e-4, "{kind:?}: {checks:?}");
    }
}

/// Stiffness and compliance are each other's inverse, computed and moved to the origin
/// separately; the strains of the solutions equal the compliance.
#[test]
fn stiffness_inverts_compliance_about_the_origin() {
    let solution = analyze(&coupled_rectangle(CellKind::Quadrilateral9)).expect("sound section");
    assert_relative_eq!(
        solution.stiffness * solution.compliance,
        Matrix6::identity(),
        epsilon = 1e-12
    );
    assert_relative_eq!(
        solution.strain,
        solution.compliance,
        epsilon = 1e-13 * solution.compliance.amax()
    );
}

/// Warping in SI about the origin: with the strains it reproduces the energy, i.e. the
/// compliance, when the stresses are integrated in SI without any scaling.
#[test]
fn warping_and_strain_belong_together_in_si() {
    let mut section = coupled_rectangle(CellKind::Quadrilateral8);
    // dimensions and moduli far from one
    for node in &mut section.mesh.nodes {
        *node = node.map(|x| 7e-3 * x);
    }
    section.materials[0].law = ElasticLaw::Full(3e9 * section.materials[0].law.stiffness());
    let solution = analyze(&section).expect("sound section");

    let mut plain = Domain::new(&section).expect("sound section");
    let unit = plain.scaling.modulus;
    plain.laws.iter_mut().for_each(|law| *law *= unit);
    for (position, &mesh_node) in plain.nodes.iter_mut().zip(&plain.mesh_nodes) {
        *position = section.mesh.nodes[mesh_node as usize];
    }
    let state = State {
        rate: Rate::Central,
        warping: Some(&solution.warping),
        strain: &solution.strain,
    };
    let compliance = section_forces(&plain, state).work;
    let down = compliance.diagonal().map(|c| 1.0 / c.sqrt());
    let error = scaled_difference(&compliance, &solution.compliance, &down, &down);
    assert!(error < 1e-11, "{error:e}");
}

#[test]
fn an_empty_section_is_refused() {
    let section = of_quadrilaterals(&[], &[]);
    assert_eq!(analyze(&section).err(), Some(Failure::NoCells));
}

#[test]
fn lists_that_do_not_fit_are_refused() {
    let mut section = of_quadrilaterals(&grid(0.0, 0.0), &GRID_CELLS);
    section.cells.pop();
    assert!(matches!(
        analyze(&section),
        Err(Failure::CellsWithoutMaterial {
            cells: 4,
            materials: 3
        })
    ));
    let mut section = of_quadrilaterals(&grid(0.0, 0.0), &GRID_CELLS);
    section.cells[2].material = 7;
    assert_eq!(
        analyze(&section).err(),
        Some(Failure::DanglingCell { tag: 3 })
    );
    let section = of_quadrilaterals(&grid(0.0, 0.0), &[[0, 1, 99, 3]]);
    assert_eq!(
        analyze(&section).err(),
        Some(Failure::DanglingCell { tag: 1 })
    );
}

#[test]
fn inverted_and_flat_cells_are_refused() {
    let section = of_quadrilaterals(&grid(0.0, 0.0), &[[0, 1, 4, 3], [1, 4, 5, 2]]);
    assert_eq!(
        analyze(&section).err(),
        Some(Failure::CellWithoutArea { tag: 2 })
    );

    let line = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [3.0, 0.0]];
    let section = of_quadrilaterals(&line, &[[0, 1, 2, 3]]);
    assert!(matches!(
        analyze(&section),
        Err(Failure::NoScale { what: "area" })
    ));
    let point = [[1.0, 1.0]; 4];
    let section = of_quadrilaterals(&point, &[[0, 1, 2, 3]]);
    assert!(matches!(
        analyze(&section),
        Err(Failure::NoScale { what: "area" })
    ));
}

#[test]
fn numbers_that_are_none_are_refused() {
    let mut nodes = grid(0.0, 0.0);
    nodes[4][1] = f64::NAN;
    let section = of_quadrilaterals(&nodes, &GRID_CELLS);
    assert!(matches!(analyze(&section), Err(Failure::NoScale { .. })));
    let mut section = of_quadrilaterals(&grid(0.0, 0.0), &GRID_CELLS);
    section.materials[0].law = ElasticLaw::Isotropic {
        young: 1.0,
        poisson: 0.5,
    };
    assert!(matches!(
        analyze(&section),
        Err(Failure::NoScale { what: "stiffness" })
    ));
    section.materials[0].law = ElasticLaw::Full(Matrix6::zeros());
    assert!(matches!(
        analyze(&section),
        Err(Failure::NoScale { what: "stiffness" })
    ));
}

/// Moduli out of range in SI but not in the units of the domain, and an origin so far away
/// that the stiffness about it has no digits.
#[test]
fn results_beyond_all_numbers_are_refused() {
    let mut section = of_quadrilaterals(&grid(0.0, 0.0), &GRID_CELLS);
    for node in &mut section.mesh.nodes {
        *node = node.map(|x| 1e80 * x);
    }
    assert_eq!(
        analyze(&section).err(),
        Some(Failure::NoScale { what: "stiffness" })
    );
    let section = of_quadrilaterals(&grid(1e9, 1e9), &GRID_CELLS);
    assert_eq!(
        analyze(&section).err(),
        Some(Failure::ComplianceNotPositive)
    );
}

/// A law that releases energy in shear: not positive definite, found by the factor.
#[test]
fn a_law_without_energy_is_refused() {
    let mut section = of_quadrilaterals(&grid(0.0, 0.0), &GRID_CELLS);
    let mut stiffness = section.materials[0].law.stiffness();
    for i in 3..6 {
        stiffness[(i, i)] = -0.1;
    }
    section.materials[0].law = ElasticLaw::Full(stiffness);
    assert!(matches!(analyze(&section), Err(Failure::Loose { .. })));
}

#[test]
fn parts_that_share_no_node_are_refused() {
    let nodes = [grid(0.0, 0.0), grid(5.0, 0.0)].concat();
    let second = GRID_CELLS.map(|cell| cell.map(|node| node + 9));
    let cells: Vec<[u32; 4]> = GRID_CELLS.into_iter().chain(second).collect();
    let failure = analyze(&of_quadrilaterals(&nodes, &cells)).expect_err("two parts");
    assert_eq!(
        failure,
        Failure::Disconnected {
            parts: 2,
            node: 1,
            other: 10
        }
    );
    assert!(failure.help().is_some_and(|help| help.contains("merge")));
}

/// Two squares joined at one node turn about it freely.
#[test]
fn parts_that_share_one_node_are_refused() {
    let nodes = [grid(0.0, 0.0), grid(2.0, 2.0)].concat();
    let second = GRID_CELLS.map(|cell| cell.map(|node| if node == 0 { 8 } else { node + 9 }));
    let cells: Vec<[u32; 4]> = GRID_CELLS.into_iter().chain(second).collect();
    let failure = analyze(&of_quadrilaterals(&nodes, &cells)).expect_err("a hinge");
    assert!(matches!(failure, Failure::Loose { .. }), "{failure}");
    assert!(
        failure
            .help()
            .is_some_and(|help| help.contains("single node"))
    );
}

/// The same, but the second square is connected by a filler 1e13 times softer: beyond
/// double precision, and reported as an error.
#[test]
fn parts_that_hardly_hang_together_are_refused_or_exact() {
    let nodes = grid(0.0, 0.0);
    let mut section = of_quadrilaterals(&nodes, &[[0, 1, 4, 3], [3, 4, 7, 6], [4, 5, 8, 7]]);
    let stiff = section.materials[0].clone();
    let mut soft = stiff.clone();
    soft.law = ElasticLaw::Full(1e-17 * stiff.law.stiffness());
    section.materials.push(soft);
    section.cells[1].material = 1;
    match analyze(&section) {
        Ok(solution) => {
            assert!(solution.checks.decoupling < OF_CELLS.check);
        }
        Err(failure) => assert!(
            matches!(failure, Failure::Loose { .. } | Failure::Inaccurate { .. }),
            "{failure}"
        ),
    }
}

/// Thinner and thinner plates end in an error, never in a panic or a wrong number: every
/// result has the exact axial stiffness.
#[test]
fn thin_plates_are_exact_or_refused() {
    for exponent in 1..12 {
        let t = 10_f64.powi(-exponent);
        let columns = 20_u32;
        let nodes: Vec<[f64; 2]> = (0..=columns)
            .flat_map(|i| [[f64::from(i) / 20.0, 0.0], [f64::from(i) / 20.0, t]])
            .collect();
        let cells: Vec<[u32; 4]> = (0..columns)
            .map(|i| [2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1])
            .collect();
        let mut section = of_quadrilaterals(&nodes, &cells);
        section.materials[0].law = ElasticLaw::Isotropic {
            young: 1.0,
            poisson: 0.0,
        };
        match analyze(&section) {
            Ok(solution) => assert_relative_eq!(solution.stiffness[(0, 0)], t, max_relative = 1e-6),
            Err(failure) => assert!(t < 1e-3, "t = {t}: {failure}"),
        }
    }
}

/// Strips of 40 x 2 cells, 100 times longer than thick: the torsion of Saint-Venant's series,
/// `G b t^3/3 (1 - 0.630 t/b)`, whose last term is of the ends, much smaller than these cells,
/// and therefore the error; bending `E b t^3/12`, and `E b^3 t/12`. Linear cells lock: through
/// two of them the bending about y is a fifth too stiff.
#[test]
fn strips_of_stretched_cells_have_the_closed_form() {
    let t = 5e-4;
    for kind in [
        CellKind::Quadrilateral4,
        CellKind::Quadrilateral8,
        CellKind::Quadrilateral9,
    ] {
        let section = strip_of(1.0, t, [40, 2], kind);
        let solution = analyze(&section).expect("digits suffice");
        let is = |row: usize, expected: f64, tolerance: f64| {
            let found = solution.stiffness[(row, row)];
            assert_relative_eq!(found, expected, max_relative = tolerance);
        };
        let torsion = t.powi(3) / 3.0 * (1.0 - 0.630 * t) / (2.0 * 1.33);
        let locking = if kind == CellKind::Quadrilateral4 {
            0.25
        } else {
            1e-6
        };
        is(0, t, 1e-3);
        is(3, torsion, 0.7 * t);
        is(4, t.powi(3) / 12.0, locking);
        is(5, t / 12.0, 1e-3);
    }
}
