//! Mass per length of the section.
//!
//! ```text
//! Mm = int rho [I, -t x]' [I, -t x] dA     (S-28); its entries are (S-29)
//! ```

use super::domain::Domain;
use crate::element::{cell_points, rigid_displacement};
use nalgebra::{Matrix6, Vector3, Vector6};
use shared_geom::wrench;

/// Mass per length about the origin of the section axes \[kg/m, kg, kg m\]:
/// momentum and angular momentum per length from velocity and angular velocity,
/// order of [`wrench::COMPONENTS`].
pub fn mass_per_length(domain: &Domain) -> Matrix6<f64> {
    let mut mass = Matrix6::zeros();
    for cell in &domain.cells {
        let places = domain.places(cell);
        for point in cell_points(cell.kind, &places[..cell.kind.node_count()]) {
            let g = rigid_displacement(1.0, point.y, point.z);
            mass += cell.density * point.area * (g.transpose() * g);
        }
    }

    // from the domain's units to SI, from the centroid to the origin
    let length = domain.scaling.length;
    let unit = Vector6::new(1.0, 1.0, 1.0, length, length, length) * length;
    let mass = mass.component_mul(&(unit * unit.transpose()));
    let [y, z] = domain.scaling.origin;
    wrench::shift(&mass, &Vector3::new(0.0, -y, -z))
}
