//! Mass per length of the section.
//!
//! ```text
//! Mm = int rho [I, -t x]' [I, -t x] J dA   (S-28); its entries are (S-29), J = 1 straight
//! ```

use super::domain::Domain;
use crate::element::rule_points;
use nalgebra::{Matrix6, Vector3, Vector6};
use shared_geom::wrench;

/// Mass per length about the origin of the section axes \[kg/m, kg, kg m\]:
/// momentum and angular momentum per length from velocity and angular velocity,
/// order of [`wrench::COMPONENTS`].
pub fn mass_per_length(domain: &Domain) -> Matrix6<f64> {
    // sums of rho (1, y, z, y y, y z, z z) dA
    let mut sums = [0.0; 6];
    for cell in &domain.cells {
        let positions = domain.positions(cell);
        for point in rule_points(cell.kind) {
            let point = point.of_cell(&positions[..cell.kind.node_count()]);
            let volume = point.area * domain.line.metric(point.y, point.z).volume;
            let (y, z, rho) = (point.y, point.z, cell.density * volume);
            for (sum, term) in sums.iter_mut().zip([1.0, y, z, y * y, y * z, z * z]) {
                *sum += rho * term;
            }
        }
    }
    mass_of_moments(domain, &sums)
}

/// The mass per length whose sums of `rho (1, y, z, y y, y z, z z) dA` are `sums`, in
/// the units of length of `domain`; in SI about the origin of the section axes, as
/// [`mass_per_length`].
pub fn mass_of_moments(domain: &Domain, sums: &[f64; 6]) -> Matrix6<f64> {
    let &[m, my, mz, myy, myz, mzz] = sums;
    #[rustfmt::skip]
    let mass = Matrix6::new(
        m,   0.0, 0.0, 0.0,       mz,   -my,
        0.0, m,   0.0, -mz,       0.0,  0.0,
        0.0, 0.0, m,   my,        0.0,  0.0,
        0.0, -mz, my,  myy + mzz, 0.0,  0.0,
        mz,  0.0, 0.0, 0.0,       mzz,  -myz,
        -my, 0.0, 0.0, 0.0,       -myz, myy,
    );

    // from the units of the domain to SI, from the centroid to the origin
    let length = domain.scaling.length;
    let unit = Vector6::new(1.0, 1.0, 1.0, length, length, length) * length;
    let mass = mass.component_mul(&(unit * unit.transpose()));
    let [y, z] = domain.scaling.origin;
    wrench::shift(&mass, &Vector3::new(0.0, -y, -z))
}
