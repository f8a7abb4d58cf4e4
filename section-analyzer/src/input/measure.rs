//! Area and centroid of cells.

use crate::mesh::{SectionCell, SectionMesh};

/// Area and centroid of a cell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct CellMeasure {
    /// Area [m^2].
    pub area: f64,
    /// Centroid (y, z) [m].
    pub centroid: [f64; 2],
}

impl CellMeasure {
    /// Of one cell, by the integration rule of its kind.
    ///
    /// ```text
    /// area = sum w J      centroid = sum w J x / area      J = y,r z,s - y,s z,r
    /// ```
    pub fn of(mesh: &SectionMesh, cell: &SectionCell) -> Self {
        let (mut area, mut moment) = (0.0, [0.0, 0.0]);
        for point in cell.kind.rule() {
            let shape = cell.kind.shape(point.r, point.s);
            let (mut place, mut dr, mut ds) = ([0.0; 2], [0.0; 2], [0.0; 2]);
            for (i, &node) in cell.nodes().iter().enumerate() {
                let position = mesh.nodes[node as usize];
                for axis in 0..2 {
                    place[axis] += shape.n[i] * position[axis];
                    dr[axis] += shape.dr[i] * position[axis];
                    ds[axis] += shape.ds[i] * position[axis];
                }
            }
            let weight = point.weight * (dr[0] * ds[1] - dr[1] * ds[0]);
            area += weight;
            moment[0] += weight * place[0];
            moment[1] += weight * place[1];
        }
        Self {
            area,
            centroid: [moment[0] / area, moment[1] / area],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::generate::Ellipse;
    use shared_geom::error::Place;
    use shared_geom::mesh::CellKind;

    /// Half of a unit disk of 12 x 8^2 biquadratic cells: area pi/2 and centroid
    /// 4/(3 pi), up to the error of parabolas for arcs of 5.6 deg: (pi/64)^4 / 100,
    /// some 1e-7.
    #[test]
    fn areas_and_centroids_add_up_to_those_of_a_half_disk() {
        let disk = Ellipse {
            semi_y: 1.0,
            semi_z: 1.0,
            cells: 8,
            kind: CellKind::Quadrilateral9,
            curved: true,
        };
        let place = Place::file("disk");
        let (mesh, _) = SectionMesh::from_mesh(&disk.generate().unwrap(), 1.0, &place).unwrap();
        let measures = mesh.cells.iter().map(|cell| CellMeasure::of(&mesh, cell));
        let upper: Vec<_> = measures
            .filter(|measure| measure.centroid[1] > 0.0)
            .collect();
        let area: f64 = upper.iter().map(|measure| measure.area).sum();
        let moment: f64 = upper
            .iter()
            .map(|measure| measure.area * measure.centroid[1])
            .sum();
        assert!((area - std::f64::consts::FRAC_PI_2).abs() < 1e-6, "{area}");
        assert!((moment - 2.0 / 3.0).abs() < 1e-6, "{moment}");
    }
}
