//! The smallest reserve factors of the regions of a section under many internal forces.
//!
//! Stress and strain are linear in the internal force,
//!
//! ```text
//! sigma(theta) = sum_i theta_i sigma(e_i)
//! ```
//!
//! so that six recoveries serve all forces; the criteria, which are not linear, are evaluated at
//! every integration point for every force.

use nalgebra::{Matrix6, Vector6};

use super::criteria::{FailureIndex, failure_indices};
use super::recoverer::Recoverer;
use super::state::{LoadCase, PointState, Tensors};
use crate::failure::Failure;
use crate::material::MaterialLimits;
use crate::section::Section;

/// The governing point and force of a region.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RegionReserve {
    /// Region: index of the physical surface in the mesh of the section.
    pub group: usize,
    /// Index of the material.
    pub material: usize,
    /// The failure index with the smallest reserve factor.
    pub worst: FailureIndex,
    /// Index of the force.
    pub force: usize,
    /// Tag of the cell.
    pub tag: u64,
    /// Its position (y, z) \[m\].
    pub position: [f64; 2],
}

/// The smallest reserve factor of each region whose material has limits, over all integration
/// points, criteria and `forces` (about the reference point) \[N, N m\].
///
/// # Errors
/// As [`Recoverer::recover`].
pub fn region_reserves(
    section: &Section,
    limits: &[MaterialLimits],
    recoverer: &Recoverer<'_>,
    forces: &[Vector6<f64>],
) -> Result<Vec<RegionReserve>, Failure> {
    let mut unit = Vec::with_capacity(6);
    for i in 0..6 {
        let load = LoadCase::at_point("unit", &Vector6::ith(i, 1.0), [0.0; 2]);
        unit.push(recoverer.recover(&load)?.points);
    }
    let mut worst: Vec<RegionReserve> = Vec::new();
    for (number, point) in unit[0].iter().enumerate() {
        let cell = &section.mesh.cells[point.cell];
        let material = section.cells[point.cell].material;
        let of_force = UnitTensors::new(&unit, number);
        for (force, theta) in forces.iter().enumerate() {
            let found = failure_indices(&limits[material], &of_force.under(theta));
            let least = found
                .into_iter()
                .min_by(|a, b| a.reserve_factor.total_cmp(&b.reserve_factor));
            let Some(least) = least else { break };
            let here = RegionReserve {
                group: cell.group,
                material,
                worst: least,
                force,
                tag: cell.tag,
                position: point.position,
            };
            match worst.iter_mut().find(|known| known.group == cell.group) {
                Some(known) if least.reserve_factor < known.worst.reserve_factor => *known = here,
                Some(_) => {}
                None => worst.push(here),
            }
        }
    }
    worst.sort_by_key(|region| region.group);
    Ok(worst)
}

/// Tensors at a point per unit force, a column for each.
struct UnitTensors {
    strain: Matrix6<f64>,
    stress: Matrix6<f64>,
    material_strain: Matrix6<f64>,
    material_stress: Matrix6<f64>,
}

impl UnitTensors {
    fn new(unit: &[Vec<PointState>], point: usize) -> Self {
        let columns = |of: fn(&Tensors) -> Vector6<f64>| {
            let columns: Vec<_> = unit
                .iter()
                .map(|points| of(&points[point].tensors))
                .collect();
            Matrix6::from_columns(&columns)
        };
        Self {
            strain: columns(|tensors| tensors.strain),
            stress: columns(|tensors| tensors.stress),
            material_strain: columns(|tensors| tensors.material_strain),
            material_stress: columns(|tensors| tensors.material_stress),
        }
    }

    fn under(&self, theta: &Vector6<f64>) -> Tensors {
        Tensors {
            strain: self.strain * theta,
            stress: self.stress * theta,
            material_strain: self.material_strain * theta,
            material_stress: self.material_stress * theta,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::analyze;
    use crate::material::{
        DEFAULT_INTERACTION, DirectionalLimits, ElasticLaw, EngineeringConstants, Material,
        Strength,
    };
    use crate::mesh::SectionMesh;
    use crate::mesh::generate::Rectangle;
    use crate::recovery::region_failures;
    use crate::section::CellMaterial;
    use shared_geom::error::SourceLocation;
    use shared_geom::mesh::CellKind;
    use shared_geom::section::InitialCurvature;

    /// A bar of 0.2 x 0.1 m.
    fn bar(law: ElasticLaw) -> Section {
        let bar = Rectangle {
            width: 0.2,
            height: 0.1,
            cells_y: 3,
            cells_z: 2,
            kind: CellKind::Quadrilateral8,
            name: "bar".into(),
        };
        let mesh = bar.generate().unwrap();
        let (mesh, _) = SectionMesh::from_mesh(&mesh, 1.0, &SourceLocation::file("bar")).unwrap();
        let cell = CellMaterial {
            material: 0,
            fiber_angle: 0.3,
            plane_angle: 0.2,
        };
        Section {
            name: "bar".into(),
            cells: vec![cell; mesh.cells.len()],
            mesh,
            materials: vec![Material {
                name: "a".into(),
                law,
                density: 1.0,
                expansion: None,
                electric: None,
            }],
            initial_curvature: InitialCurvature::STRAIGHT,
            electrodes: Vec::new(),
        }
    }

    fn limits(strength: Strength) -> [MaterialLimits; 1] {
        [MaterialLimits {
            strength: Some(strength),
            strain: None,
        }]
    }

    /// Yielding under N: f A / N, for the largest of three forces.
    #[test]
    fn axial_forces_yield_at_their_stress() {
        let section = bar(ElasticLaw::Isotropic {
            young: 210e9,
            poisson: 0.3,
        });
        let solution = analyze(&section).unwrap();
        let recoverer = Recoverer::new(&section, &solution);
        let forces = [1e5, -3e5, 2e5].map(|force| Vector6::ith(0, force));
        let limits = limits(Strength::Yield(350e6));
        let found = region_reserves(&section, &limits, &recoverer, &forces).unwrap();
        assert_eq!((found.len(), found[0].force), (1, 1));
        let exact = 350e6 * 0.02 / 3e5;
        assert!((found[0].worst.reserve_factor / exact - 1.0).abs() < 1e-10);
        let none = [MaterialLimits {
            strength: None,
            strain: None,
        }];
        assert_eq!(
            region_reserves(&section, &none, &recoverer, &forces).unwrap(),
            []
        );
    }

    /// 200 random forces on a ply at an angle: the least of the reserve factors of single
    /// recoveries, to the round-off of sums of six stresses that may cancel.
    #[test]
    fn many_forces_at_once_are_single_recoveries() {
        let section = bar(ElasticLaw::Orthotropic(EngineeringConstants {
            e1: 140e9,
            e2: 10e9,
            e3: 9e9,
            g12: 5e9,
            g13: 5e9,
            g23: 3.5e9,
            nu12: 0.3,
            nu13: 0.3,
            nu23: 0.4,
        }));
        let solution = analyze(&section).unwrap();
        let recoverer = Recoverer::new(&section, &solution);
        let limits = limits(Strength::Ply {
            limits: DirectionalLimits {
                tension: [1.5e9, 4e7, 4e7],
                compression: [1.2e9, 1.8e8, 1.8e8],
                shear: [9e7, 8e7, 8e7],
            },
            interaction: [DEFAULT_INTERACTION; 3],
        });
        let mut state = 17_u64;
        let mut random = || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) as f64 / (1_u64 << 30) as f64 - 1.0
        };
        let scale = [1e6, 1e5, 1e5, 1e4, 1e4, 2e4];
        let forces: Vec<Vector6<f64>> = (0..200)
            .map(|_| Vector6::from_fn(|i, _| scale[i] * random()))
            .collect();
        let all = region_reserves(&section, &limits, &recoverer, &forces).unwrap();
        let single = |(index, force): (usize, &Vector6<f64>)| {
            let load = LoadCase::at_point("a", force, [0.0; 2]);
            let found = region_failures(&section, &limits, &recoverer.recover(&load).unwrap());
            let reserves = found.iter().map(|one| one.worst.reserve_factor);
            (index, reserves.fold(f64::INFINITY, f64::min))
        };
        let singles = forces.iter().enumerate().map(single);
        let least = singles.min_by(|a, b| a.1.total_cmp(&b.1)).unwrap();
        assert_eq!(all[0].force, least.0);
        assert!((all[0].worst.reserve_factor / least.1 - 1.0).abs() < 1e-9);
    }
}
