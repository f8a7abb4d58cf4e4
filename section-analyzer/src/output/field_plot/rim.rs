//! The boundary of a section: its outline, and for walls too thin to be seen, a band outside of
//! it in the colors of the adjacent surface.

use std::collections::HashMap;

use shared_geom::figure::ValueTriangle;

use super::field::Field;
use crate::output::outline::{Side, SideRole};
use crate::output::plane::Plane;
use crate::section::Section;

/// Number of pieces in which a quadratic side is drawn.
const PIECES: usize = 8;
/// Largest growth of the band at corners.
const MITER: f64 = 2.5;

/// The outline of a section, and the bands outside of it.
#[derive(Debug, Default)]
pub(super) struct Rim {
    /// Lines around the section as drawn, one per side of a cell [figure pixels].
    pub outlines: Vec<Vec<[f64; 2]>>,
    bands: Vec<Band>,
}

/// The band outside of one side.
#[derive(Debug)]
struct Band {
    node: [u32; 2],
    inner: Vec<[f64; 2]>,
    outer: Vec<[f64; 2]>,
    values: Vec<f64>,
}

impl Rim {
    /// The boundary with bands of `width` [figure pixels].
    pub fn new(
        section: &Section,
        plane: &Plane,
        field: &Field,
        sides: &[Side],
        width: f64,
    ) -> Self {
        let boundary = sides.iter().filter(|side| side.role == SideRole::Boundary);
        let mut bands: Vec<_> = boundary
            .map(|side| Band::new(section, plane, field, side))
            .collect();
        let mut at_node: HashMap<u32, [f64; 2]> = HashMap::new();
        for band in &bands {
            for (node, normal) in band.node.into_iter().zip(band.end_normals()) {
                let sum = at_node.entry(node).or_default();
                *sum = [sum[0] + normal[0], sum[1] + normal[1]];
            }
        }
        for band in &mut bands {
            let ends = band.node.map(|node| at_node[&node]);
            band.grow(width, ends);
        }
        let outlines = bands.iter().map(|band| band.outer.clone()).collect();
        if width == 0.0 {
            bands.clear();
        }
        Self { outlines, bands }
    }

    /// The bands in triangles.
    pub fn triangles(&self) -> Vec<ValueTriangle> {
        let mut triangles = Vec::new();
        for band in &self.bands {
            for k in 1..band.inner.len() {
                let (a, b) = (band.values[k - 1], band.values[k]);
                let corners = [band.inner[k - 1], band.inner[k], band.outer[k - 1]];
                let values = [a, b, a];
                triangles.push(ValueTriangle { corners, values });
                let corners = [band.inner[k], band.outer[k], band.outer[k - 1]];
                let values = [b, b, a];
                triangles.push(ValueTriangle { corners, values });
            }
        }
        triangles
    }
}

impl Band {
    /// A band without width: positions and values along the side.
    fn new(section: &Section, plane: &Plane, field: &Field, side: &Side) -> Self {
        let cell = &section.mesh.cells[side.cell];
        let nodes = cell.kind.reference_nodes();
        let (first, second, _) = cell.kind.side(side.local);
        let pieces = if cell.kind.is_quadratic() { PIECES } else { 1 };
        let mut inner = Vec::with_capacity(pieces + 1);
        let mut values = Vec::with_capacity(pieces + 1);
        for k in 0..=pieces {
            let t = k as f64 / pieces as f64;
            let [r, s] =
                [0, 1].map(|axis| (1.0 - t) * nodes[first][axis] + t * nodes[second][axis]);
            let shape = cell.kind.shape(r, s);
            let (mut position, mut value) = ([0.0; 2], 0.0);
            for (i, &node) in cell.nodes().iter().enumerate() {
                let node = section.mesh.nodes[node as usize];
                position = [0, 1].map(|axis| position[axis] + shape.n[i] * node[axis]);
                value += shape.n[i] * field.values[side.cell][i];
            }
            inner.push(plane.position(position));
            values.push(value);
        }
        Self {
            node: side.ends,
            outer: inner.clone(),
            inner,
            values,
        }
    }

    fn end_normals(&self) -> [[f64; 2]; 2] {
        let last = self.inner.len() - 1;
        [
            normal(self.inner[0], self.inner[1]),
            normal(self.inner[last - 1], self.inner[last]),
        ]
    }

    /// Moves the outer line by `width`; at the ends along `ends`, which neighbors
    /// share, so that there is no gap between them.
    fn grow(&mut self, width: f64, ends: [[f64; 2]; 2]) {
        let last = self.inner.len() - 1;
        let own = self.end_normals();
        for k in 0..=last {
            let direction = match k {
                0 => miter(own[0], ends[0]),
                k if k == last => miter(own[1], ends[1]),
                k => normal(self.inner[k - 1], self.inner[k + 1]),
            };
            self.outer[k] = [0, 1].map(|axis| self.inner[k][axis] + width * direction[axis]);
        }
    }
}

/// The unit normal on the outside of a line that has the section on its left on the figure:
/// figure pixels count y down.
fn normal(from: [f64; 2], to: [f64; 2]) -> [f64; 2] {
    unit([from[1] - to[1], to[0] - from[0]])
}

/// The multiple of `shared` that is one unit away from the line of `own`.
fn miter(own: [f64; 2], shared: [f64; 2]) -> [f64; 2] {
    let shared = unit(shared);
    let cosine = own[0] * shared[0] + own[1] * shared[1];
    let length = (1.0 / cosine.max(1.0 / MITER)).min(MITER);
    shared.map(|part| length * part)
}

fn unit([x, y]: [f64; 2]) -> [f64; 2] {
    let length = x.hypot(y);
    if length > 0.0 {
        [x / length, y / length]
    } else {
        [0.0; 2]
    }
}
