//! The two methods for the derivatives against each other, on sections without any
//! symmetry.

use super::*;
use crate::analysis::Analysis;
use crate::material::{Constant, ElasticLaw};
use crate::section::samples::coupled_rectangle;
use nalgebra::Vector3;
use shared_geom::mesh::CellKind;
use shared_geom::section::InitialCurvature;

/// Straight, oblique, nearly straight, curved and twisted.
fn lines() -> [InitialCurvature; 4] {
    let line = |k: [f64; 3], l: [f64; 3]| InitialCurvature {
        curvature: Vector3::from(k),
        slope: Vector3::from(l),
    };
    [
        line([0.0; 3], [1.0, 0.0, 0.0]),
        line([0.0; 3], [0.9, 0.3, -0.2]),
        line([1e-7, -2e-7, 1e-7], [1.0, 0.0, 0.0]),
        line([0.2, -0.15, 0.1], [0.95, 0.1, -0.05]),
    ]
}

fn section(line: InitialCurvature) -> Section {
    let mut section = coupled_rectangle(CellKind::Quadrilateral8);
    section.initial_curvature = line;
    let mut second = section.materials[0].clone();
    second.law = ElasticLaw::Isotropic {
        young: 3.0,
        poisson: 0.3,
    };
    section.materials.push(second);
    section.cells[1].material = 1;
    section
}

fn parameters(section: &Section) -> Vec<Parameter> {
    let constant = |material, constant| Parameter::Constant { material, constant };
    let node = section.mesh.cells[2].nodes()[1] as usize;
    let swing = |(node, position): (usize, &[f64; 2])| NodeVelocity {
        node,
        y: position[0] * position[1],
        z: 0.3 - position[0],
    };
    let turn = |cell: usize| CellTurn {
        cell,
        rate: 0.7 - 0.4 * cell as f64,
    };
    vec![
        constant(0, Constant::Engineering("e1")),
        constant(0, Constant::Engineering("nu23")),
        constant(1, Constant::Poisson),
        constant(0, Constant::Density),
        Parameter::FiberAngle(Cells::List(vec![0, 4])),
        Parameter::PlaneAngle(Cells::Region(0)),
        Parameter::Node {
            node,
            axis: Axis::Z,
        },
        Parameter::Motion(Motion {
            nodes: section.mesh.nodes.iter().enumerate().map(swing).collect(),
            turns: (0..section.cells.len()).map(turn).collect(),
        }),
    ]
}

fn worst(a: &Matrix6<f64>, b: &Matrix6<f64>, scale: &Matrix6<f64>) -> f64 {
    let d = scale.diagonal().map(|value| 1.0 / value.sqrt());
    (a - b).component_mul(&(d * d.transpose())).amax()
}

/// Both solve the same equations with the same factors, so that they differ only by
/// round-off, a few hundred units of it: 1e-12 relative to `sqrt(Kii Kjj)`.
#[test]
fn both_ways_agree() {
    for line in lines() {
        let section = section(line);
        let analysis = Analysis::new(&section).expect("sound section");
        let parameters = parameters(&section);
        let dual = analysis.sensitivities(&parameters).expect("sound");
        let direct = analysis.sensitivities_direct(&parameters).expect("sound");
        let solution = analysis.solution();
        for ((parameter, a), b) in parameters.iter().zip(&dual).zip(&direct) {
            let name = parameter.name(&section);
            let error = worst(&a.stiffness, &b.stiffness, &solution.stiffness);
            assert!(error < 1e-12, "{line:?} {name}: {error:e}");
            let error = worst(&a.compliance, &b.compliance, &solution.compliance);
            assert!(error < 1e-12, "{line:?} {name}: {error:e}");
            assert_eq!(a.mass, b.mass);
            // all but the density change the stiffness
            let size = worst(&a.stiffness, &Matrix6::zeros(), &solution.stiffness);
            let is_density = name.starts_with("density");
            assert_eq!(size < 1e-4, is_density, "{name}: {size:e}");
        }
    }
}

/// `-W' dG W` alone, without `T S + S T'`: right for axial force and moments of a straight
/// beam, wrong by far more than round-off for its shear forces, and for every entry of a
/// curved one.
#[test]
fn the_work_of_the_face_counts() {
    let [straight, _, _, curved] = lines();
    for (line, is_straight) in [(straight, true), (curved, false)] {
        let section = section(line);
        let analysis = Analysis::new(&section).expect("sound section");
        let solved = analysis.parts();
        let parameters = parameters(&section);
        let changes = change::Change::of_parameters(&section, solved.domain, &parameters);
        let (fields, sums) =
            contraction::integrals(solved, &changes.expect("sound")).expect("memory");
        let (mut block, mut shears) = (0.0_f64, 0.0_f64);
        for sums in &sums {
            let difference = sums.compliance(&fields) + sums.of_central();
            let size = sums.compliance(&fields).amax();
            for (i, j) in (0..6).flat_map(|i| (0..6).map(move |j| (i, j))) {
                let is_shear = [1, 2].contains(&i) || [1, 2].contains(&j);
                let worst = if is_shear { &mut shears } else { &mut block };
                if size > 0.0 {
                    *worst = worst.max(difference[(i, j)].abs() / size);
                }
            }
        }
        assert!(shears > 1e-2, "{shears:e}");
        assert_eq!(block == 0.0, is_straight, "{block:e}");
        assert!(is_straight || block > 1e-3, "{block:e}");
    }
}
