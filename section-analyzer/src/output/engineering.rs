//! The engineering values of a section, from its matrices at its centers.

use nalgebra::{Matrix6, Vector2, Vector3};
use shared_geom::section::SectionProperties;
use shared_geom::wrench;

use crate::properties::invert_symmetric;
use crate::solution::SectionSolution;

/// An engineering value: a diagonal entry of the matrices about one point.
#[derive(Debug, Clone, PartialEq)]
pub struct EngineeringValue {
    /// The usual symbol, as `GAy`.
    pub symbol: &'static str,
    /// Meaning, with the point.
    pub meaning: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// With all other generalized strains zero, `K_ii` \[N, N m^2\].
    pub restrained: f64,
    /// With all other internal forces zero, `1 / C_ii` \[N, N m^2\].
    pub free: f64,
}

/// EA, EIy, EIz about the tension center; GAy, GAz, GJ about the shear center.
///
/// ```text
/// about O + d, with U(d) = [I 0; -d x I]:    K' = U(d) K U(d)^T     C' = U(-d)^T C U(-d)
/// ```
pub fn engineering_values(solution: &SectionSolution) -> [EngineeringValue; 6] {
    let about = |[y, z]: [f64; 2]| {
        let d = Vector3::new(0.0, y, z);
        let back = wrench::shift_matrix(&-d);
        let stiffness = wrench::shift(&solution.stiffness, &d);
        (stiffness, back.transpose() * solution.compliance * back)
    };
    values(
        &about(solution.centers.tension),
        &about(solution.centers.shear),
    )
}

/// As [`engineering_values`], from a property file, which contains no compliance: the
/// compliance about a center is the inverse of the stiffness there. `None` if the
/// stiffness is not positive definite.
pub fn engineering_values_of(properties: &SectionProperties) -> Option<[EngineeringValue; 6]> {
    let about = |center: Vector2<f64>| {
        let d = Vector3::new(0.0, center.x, center.y);
        let stiffness = wrench::shift(&properties.stiffness, &d);
        Some((stiffness, invert_symmetric(&stiffness)?))
    };
    let tension = about(properties.centers.tension)?;
    Some(values(&tension, &about(properties.centers.shear)?))
}

/// The values from stiffness and compliance about the tension and the shear center.
fn values(
    tension: &(Matrix6<f64>, Matrix6<f64>),
    shear: &(Matrix6<f64>, Matrix6<f64>),
) -> [EngineeringValue; 6] {
    let value =
        |symbol, meaning, unit, (stiffness, compliance): &(Matrix6<f64>, Matrix6<f64>), i| {
            EngineeringValue {
                symbol,
                meaning,
                unit,
                restrained: stiffness[(i, i)],
                free: 1.0 / compliance[(i, i)],
            }
        };
    [
        value("EA", "extension at the tension center", "N", tension, 0),
        value("GAy", "shear along y at the shear center", "N", shear, 1),
        value("GAz", "shear along z at the shear center", "N", shear, 2),
        value("GJ", "torsion about the shear center", "N m^2", shear, 3),
        value(
            "EIy",
            "bending about y at the tension center",
            "N m^2",
            tension,
            4,
        ),
        value(
            "EIz",
            "bending about z at the tension center",
            "N m^2",
            tension,
            5,
        ),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::analyze;
    use crate::material::{ElasticLaw, Material};
    use crate::mesh::SectionMesh;
    use crate::mesh::generate::Rectangle;
    use crate::section::{CellMaterial, Section};
    use shared_geom::error::SourceLocation;
    use shared_geom::mesh::CellKind;
    use shared_geom::section::InitialCurvature;

    /// A bar of 0.2 x 0.1 m, far from the reference point: E A, E h b^3 / 12,
    /// E b h^3 / 12 wherever it lies; restrained and free values are the same in
    /// an isotropic section with two axes of symmetry. Shear and torsion are only
    /// compared with the values of the bar at the reference point. Moving by ten widths
    /// loses three digits of the fifteen.
    #[test]
    fn values_do_not_depend_on_the_reference_point() {
        let values = |y: f64, z: f64| engineering_values(&analyze(&bar(y, z)).unwrap());
        let (here, far) = (values(0.0, 0.0), values(2.0, -1.5));
        for (a, b) in here.iter().zip(&far) {
            assert!(
                (b.restrained / a.restrained - 1.0).abs() < 1e-10,
                "{}",
                a.symbol
            );
            assert!((b.free / a.restrained - 1.0).abs() < 1e-10, "{}", a.symbol);
        }
        let (young, width, height) = (210e9, 0.2_f64, 0.1_f64);
        let exact = [
            (0, young * width * height),
            (4, young * width * height.powi(3) / 12.0),
            (5, young * height * width.powi(3) / 12.0),
        ];
        for (i, value) in exact {
            assert!(
                (far[i].restrained / value - 1.0).abs() < 1e-10,
                "{}",
                far[i].symbol
            );
        }
    }

    fn bar(y: f64, z: f64) -> Section {
        let bar = Rectangle {
            width: 0.2,
            height: 0.1,
            cells_y: 4,
            cells_z: 2,
            kind: CellKind::Quadrilateral9,
            name: "bar".into(),
        };
        let mut mesh = bar.generate().unwrap();
        for node in &mut mesh.nodes {
            node.position.x += y;
            node.position.y += z;
        }
        let (mesh, _) = SectionMesh::from_mesh(&mesh, 1.0, &SourceLocation::file("bar")).unwrap();
        let law = ElasticLaw::Isotropic {
            young: 210e9,
            poisson: 0.3,
        };
        let cell = CellMaterial {
            material: 0,
            fiber_angle: 0.0,
            plane_angle: 0.0,
        };
        Section {
            name: "bar".into(),
            cells: vec![cell; mesh.cells.len()],
            mesh,
            materials: vec![Material {
                name: "steel".into(),
                law,
                density: 7850.0,
                expansion: None,
                electric: None,
            }],
            initial_curvature: InitialCurvature::STRAIGHT,
            electrodes: Vec::new(),
        }
    }
}
