//! The smallest reserve factors of the regions of a section under many internal forces.
//!
//! Stress and strain are linear in the internal force, and the inverse of the reserve factor is
//! proportional to the load. For the criteria with a convex safe set this inverse g is convex, and
//! in a box of forces `|theta - c| <= h`
//!
//! ```text
//! g(sigma(theta)) <= g(sigma(c)) + sum_i h_i max(g(sigma(e_i)), g(-sigma(e_i)))       (S-171)
//! ```
//!
//! For Hashin each stress is between `sigma(c) -+ sum_i h_i |sigma(e_i)|`. Boxes in which no force
//! can govern are left out, without effect on the result.

use nalgebra::Vector6;
use shared_geom::quadrature::PlanePoint;

use super::criteria::{FailureIndex, convex_size, hashin_bound, worst_index};
use super::force_tree::ForceTree;
use super::unit::{UnitPoint, weights};
use crate::material::MaterialLimits;
use crate::mesh::{SectionCell, SectionMesh};
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
    /// Stress under this force in material axes, order 11 22 33 23 13 12 \[Pa\].
    pub stress: Vector6<f64>,
    /// Reserve factor of the mean stress and strain over the area of its cell under this force: an
    /// estimate of the dependence on the size of the cells \[-\].
    pub of_cell: f64,
}

/// The smallest reserve factor of each region whose material has limits, over all integration
/// points, criteria and `forces` (about the reference point) \[N, N m\].
pub fn region_reserves(
    section: &Section,
    limits: &[MaterialLimits],
    points: &[UnitPoint],
    forces: &[Vector6<f64>],
) -> Vec<RegionReserve> {
    let tree = ForceTree::new(forces, &weights(points));
    let mut worst: Vec<RegionReserve> = Vec::new();
    for point in points {
        let cell = &section.mesh.cells[point.cell];
        let material = section.cells[point.cell].material;
        let known = worst.iter().position(|known| known.group == cell.group);
        let reserve = known.map_or(f64::INFINITY, |at| worst[at].worst.reserve_factor);
        let Some((force, found)) = least(&limits[material], point, (&tree, forces), reserve) else {
            continue;
        };
        let here = RegionReserve {
            group: cell.group,
            material,
            worst: found,
            force,
            tag: cell.tag,
            position: point.position,
            stress: point.material_stress * forces[force],
            of_cell: f64::INFINITY,
        };
        match known {
            Some(at) => worst[at] = here,
            None => worst.push(here),
        }
    }
    for region in &mut worst {
        let is_of_cell = |point: &&UnitPoint| section.mesh.cells[point.cell].tag == region.tag;
        let of_cell: Vec<UnitPoint> = points.iter().filter(is_of_cell).copied().collect();
        let cell = of_cell.first().map(|point| &section.mesh.cells[point.cell]);
        let areas = cell.map_or_else(Vec::new, |cell| point_areas(&section.mesh, cell));
        let mean = UnitPoint::mean(&of_cell, &areas);
        let mean = mean.map(|mean| mean.under(&forces[region.force]));
        let found = mean.and_then(|mean| worst_index(&limits[region.material], &mean));
        region.of_cell = found.map_or(f64::INFINITY, |found| found.reserve_factor);
    }
    worst.sort_by_key(|region| region.group);
    worst
}

/// The area of each integration point of a cell \[m^2\].
fn point_areas(mesh: &SectionMesh, cell: &SectionCell) -> Vec<f64> {
    let of_point = |point: &PlanePoint| {
        let shape = cell.kind.shape(point.r, point.s);
        let mut slopes = [[0.0; 2]; 2];
        for (n, position) in mesh.positions(cell).enumerate() {
            for i in 0..2 {
                slopes[i][0] += shape.dr[n] * position[i];
                slopes[i][1] += shape.ds[n] * position[i];
            }
        }
        point.weight * (slopes[0][0] * slopes[1][1] - slopes[0][1] * slopes[1][0])
    };
    cell.kind.rule().iter().map(of_point).collect()
}

/// The force with the smallest reserve factor at a point, if it is smaller than `known`, or any if
/// this is infinite.
fn least(
    limits: &MaterialLimits,
    point: &UnitPoint,
    (tree, forces): (&ForceTree<'_>, &[Vector6<f64>]),
    known: f64,
) -> Option<(usize, FailureIndex)> {
    let worst = |theta: &Vector6<f64>| worst_index(limits, &point.under(theta));
    let size = |theta: &Vector6<f64>| convex_size(limits, &point.under(theta));
    let unit = Vector6::from_fn(|i, _| {
        let theta = Vector6::ith(i, 1.0);
        size(&theta).max(size(&-theta))
    });
    let sizes = point.material_stress.abs();
    let bound = |center: &Vector6<f64>, half: &Vector6<f64>| {
        let convex = size(center) + half.dot(&unit);
        let (stress, range) = (point.material_stress * center, sizes * half);
        convex.max(hashin_bound(limits, &(stress - range), &(stress + range)))
    };
    let value = |theta: &Vector6<f64>| {
        worst(theta).map_or(f64::NEG_INFINITY, |found| 1.0 / found.reserve_factor)
    };
    // without stress the reserve is infinite, and its inverse zero
    let known = if known < f64::INFINITY {
        1.0 / known
    } else {
        -1.0
    };
    let (force, _) = tree.largest(known, bound, value)?;
    Some((force, worst(&forces[force])?))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::analyze;
    use crate::material::{
        DEFAULT_INTERACTION, DirectionalLimits, ElasticLaw, EngineeringConstants, Material,
        Strength,
    };
    use crate::mesh::generate::Rectangle;
    use crate::recovery::{LoadCase, Recoverer, region_failures};
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
            ..MaterialLimits::default()
        }]
    }

    /// On a trapezoid 2 wide, 1 and 3 high, the integration points have its area, 4, and its centroid,
    /// `2/3 (1 + 2 * 3) / (1 + 3)` from the lower side.
    #[test]
    fn points_have_their_areas() {
        let law = ElasticLaw::Isotropic {
            young: 1.0,
            poisson: 0.0,
        };
        let mut mesh = bar(law).mesh;
        let ends = [f64::min, f64::max].map(|of| {
            let all = mesh.nodes.iter().copied();
            all.reduce(|a, b| [of(a[0], b[0]), of(a[1], b[1])]).unwrap()
        });
        let [low, high] = ends;
        for [y, z] in &mut mesh.nodes {
            let part = 2.0 * (*y - low[0]) / (high[0] - low[0]);
            let height = 1.0 + part;
            [*y, *z] = [part, height * (*z - low[1]) / (high[1] - low[1])];
        }
        let (mut area, mut moment) = (0.0, 0.0);
        for cell in &mesh.cells {
            let areas = point_areas(&mesh, cell);
            for (point, of_point) in cell.kind.rule().iter().zip(areas) {
                let shape = cell.kind.shape(point.r, point.s);
                let nodes = mesh.positions(cell).enumerate();
                let y: f64 = nodes.map(|(n, position)| shape.n[n] * position[0]).sum();
                area += of_point;
                moment += of_point * y;
            }
        }
        assert!((area - 4.0).abs() < 1e-12, "{area}");
        assert!(
            (moment / area - 7.0 / 6.0).abs() < 1e-12,
            "{}",
            moment / area
        );
    }

    /// Yielding under N: f A / N, for the largest of three forces.
    #[test]
    fn axial_forces_yield_at_their_stress() {
        let section = bar(ElasticLaw::Isotropic {
            young: 210e9,
            poisson: 0.3,
        });
        let solution = analyze(&section).unwrap();
        let points = Recoverer::new(&section, &solution).unit_points().unwrap();
        let forces = [1e5, -3e5, 2e5].map(|force| Vector6::ith(0, force));
        let limits = limits(Strength::Yield(350e6));
        let found = region_reserves(&section, &limits, &points, &forces);
        assert_eq!((found.len(), found[0].force), (1, 1));
        let exact = 350e6 * 0.02 / 3e5;
        assert!((found[0].worst.reserve_factor / exact - 1.0).abs() < 1e-10);
        assert!((found[0].stress[0] / 1.5e7 + 1.0).abs() < 1.0);
        assert!((found[0].of_cell / exact - 1.0).abs() < 1e-10);
        // under bending, stress is linear over the two cells of 50 mm: the outermost of three Gauss
        // points is at 25 + 25 sqrt(3/5) mm, the mean at 25 mm
        let bending = [Vector6::ith(4, 1e4)];
        let found = region_reserves(&section, &limits, &points, &bending);
        let ratio = found[0].of_cell / found[0].worst.reserve_factor;
        assert!((ratio - (1.0 + 0.6_f64.sqrt())).abs() < 1e-6, "{ratio}");
        let none = [MaterialLimits::default()];
        assert_eq!(region_reserves(&section, &none, &points, &forces), []);
    }

    /// 200 random forces on a ply at an angle: the least of the reserve factors of single
    /// recoveries, to the round-off of sums of six stresses that may cancel. With a small
    /// strength in shear 23 the safe set of Hashin has hollows.
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
        let points = recoverer.unit_points().unwrap();
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
        let recoveries: Vec<_> = forces
            .iter()
            .map(|force| {
                let load = LoadCase::at_point("a", force, [0.0; 2]);
                recoverer.recover(&load).unwrap()
            })
            .collect();
        for shear_23 in [9e7, 6e6] {
            let limits = limits(Strength::Ply {
                limits: DirectionalLimits {
                    tension: [1.5e9, 4e7, 4e7],
                    compression: [1.2e9, 1.8e8, 1.8e8],
                    shear: [shear_23, 8e7, 8e7],
                },
                interaction: [DEFAULT_INTERACTION; 3],
            });
            let all = region_reserves(&section, &limits, &points, &forces);
            let single = |(index, recovery)| {
                let found = region_failures(&section, &limits, recovery);
                let reserves = found.iter().map(|one| one.worst.reserve_factor);
                (index, reserves.fold(f64::INFINITY, f64::min))
            };
            let singles = recoveries.iter().enumerate().map(single);
            let least = singles.min_by(|a, b| a.1.total_cmp(&b.1)).unwrap();
            assert_eq!(all[0].force, least.0);
            assert!((all[0].worst.reserve_factor / least.1 - 1.0).abs() < 1e-9);
        }
    }
}
