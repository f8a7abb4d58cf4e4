//! Area and moments of area of a cell, from its sides.
//!
//! Each integral over a cell is one around it (Green's theorem), counterclockwise:
//!
//! ```text
//! area = 1/2 oint (y dz - z dy)
//! int y dA   =  1/2 oint y^2 dz      int z dA   = -1/2 oint z^2 dy
//! int z^2 dA = -1/3 oint z^3 dy      int y^2 dA =  1/3 oint y^3 dz
//! int y z dA =  1/2 oint y^2 z dz                                     (S-60)
//! ```
//!
//! A side is a polynomial of at most degree two in its parameter, an integrand a polynomial
//! of degree seven, which a Gauss rule of four points integrates exactly, also for curved
//! sides. (The rule of a quadratic cell over its area is exact for area and first moments,
//! but not for the second moments of a curved cell.)

use shared_geom::quadrature;

use crate::mesh::{SectionCell, SectionMesh};

/// Points of the rule on a side: exact up to degree seven.
const POINTS: usize = 4;

/// Second moments of area.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SecondMoments {
    /// Moment about the axis y, `int z^2 dA` \[m^4\].
    pub yy: f64,
    /// Moment about the axis z, `int y^2 dA` \[m^4\].
    pub zz: f64,
    /// Product, `int y z dA` \[m^4\].
    pub yz: f64,
}

/// Area and its moments about one point.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct AreaMoments {
    /// Area \[m^2\].
    pub area: f64,
    /// First moments, `int y dA` and `int z dA` \[m^3\].
    pub first: [f64; 2],
    /// Second moments \[m^4\].
    pub second: SecondMoments,
}

impl AreaMoments {
    /// Moments of a cell about `point`.
    ///
    /// They are taken about a node of the cell and moved, so that a cell far from
    /// the point keeps its digits.
    pub fn of_cell(mesh: &SectionMesh, cell: &SectionCell, point: [f64; 2]) -> Self {
        let near = mesh.nodes[cell.nodes()[0] as usize];
        let mut moments = Self::default();
        for side in 0..cell.kind.corner_count() {
            moments.add_side(&CellSide::new(mesh, cell, side), near);
        }
        moments.moved([near[0] - point[0], near[1] - point[1]])
    }

    /// Adds the integrals of (S-60) along one side, about `origin`.
    fn add_side(&mut self, side: &CellSide, origin: [f64; 2]) {
        for &(xi, weight) in quadrature::line(POINTS) {
            let SidePoint { position, tangent } = side.at(xi);
            let [y, z] = [position[0] - origin[0], position[1] - origin[1]];
            let [dy, dz] = tangent.map(|rate| weight * rate);
            self.area += 0.5 * (y * dz - z * dy);
            self.first[0] += 0.5 * y * y * dz;
            self.first[1] -= 0.5 * z * z * dy;
            self.second.yy -= z * z * z * dy / 3.0;
            self.second.zz += y * y * y * dz / 3.0;
            self.second.yz += 0.5 * y * y * z * dz;
        }
    }

    /// The moments about the point moved by -`d` \[m\]: positions from there are y + d.
    ///
    /// ```text
    /// int (y + dy) = Sy + A dy      int (y + dy)(z + dz) = Iyz + dz Sy + dy Sz + A dy dz   (S-61)
    /// ```
    pub fn moved(&self, [dy, dz]: [f64; 2]) -> Self {
        let Self {
            area,
            first: [y, z],
            second,
        } = *self;
        Self {
            area,
            first: [y + area * dy, z + area * dz],
            second: SecondMoments {
                yy: second.yy + dz * (2.0 * z + area * dz),
                zz: second.zz + dy * (2.0 * y + area * dy),
                yz: second.yz + dz * y + dy * z + area * dy * dz,
            },
        }
    }

    /// Centroid: the point where the first moments vanish, from the point of these moments
    /// \[m\].
    pub fn centroid(&self) -> [f64; 2] {
        self.first.map(|first| first / self.area)
    }
}

impl std::ops::AddAssign for AreaMoments {
    fn add_assign(&mut self, other: Self) {
        self.area += other.area;
        self.first[0] += other.first[0];
        self.first[1] += other.first[1];
        self.second.yy += other.second.yy;
        self.second.zz += other.second.zz;
        self.second.yz += other.second.yz;
    }
}

/// A side of a cell as a curve, counterclockwise.
#[derive(Debug, Clone, Copy)]
pub(super) struct CellSide {
    /// Ends, then the middle if there is one [m].
    nodes: [[f64; 2]; 3],
    kind: shared_geom::mesh::LineKind,
}

/// A point of a side.
#[derive(Debug, Clone, Copy)]
pub(super) struct SidePoint {
    /// Position (y, z) [m].
    pub position: [f64; 2],
    /// Its derivative with respect to the parameter of the side [m].
    pub tangent: [f64; 2],
}

impl CellSide {
    /// Side number `side` of a cell.
    pub fn new(mesh: &SectionMesh, cell: &SectionCell, side: usize) -> Self {
        let (first, second, middle) = cell.kind.side(side);
        let position = |local: usize| mesh.nodes[cell.nodes()[local] as usize];
        Self {
            nodes: [
                position(first),
                position(second),
                position(middle.unwrap_or(first)),
            ],
            kind: cell.kind.side_kind(),
        }
    }

    /// The point at `xi` in [-1, 1].
    pub fn at(&self, xi: f64) -> SidePoint {
        let shape = self.kind.shape(xi);
        let sum = |weights: &[f64; 3], axis: usize| -> f64 {
            let terms = self.nodes.iter().zip(weights);
            terms.map(|(node, weight)| node[axis] * weight).sum()
        };
        SidePoint {
            position: [sum(&shape.n, 0), sum(&shape.n, 1)],
            tangent: [sum(&shape.d, 0), sum(&shape.d, 1)],
        }
    }
}
