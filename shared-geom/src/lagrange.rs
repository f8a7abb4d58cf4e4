//! Shape functions of lines, triangles and quadrilaterals on reference cells.
//!
//! Node orders are Gmsh's. A function of the nodal values `v_i` is
//! `v(r, s) = sum n_i v_i`; `dr` and `ds` hold the derivatives of the shape functions
//! with respect to the reference coordinates.
//!
//! ```text
//! triangle3 / triangle6             quadrilateral4 / 8 / 9
//!
//! s                                       s
//! |                                  3----6----2
//! 2                                  |    |    |
//! |  \                               7    8    5-- r
//! 5    4                             |         |
//! |      \                           0----4----1
//! 0---3---1-- r
//!
//! r, s >= 0, r + s <= 1              -1 <= r, s <= 1
//! line2: 0-------1     line3: 0---2---1     -1 <= xi <= 1
//! ```
//!
//! # References
//! - Gmsh reference manual, section "Node ordering".
//! - O. C. Zienkiewicz, R. L. Taylor, "The finite element method", volume 1,
//!   chapter on shape functions.

/// Shape functions of a plane cell at one point, with their derivatives.
///
/// Entries from `count` on are zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShapeValues {
    /// Number of nodes.
    pub count: usize,
    /// Shape functions in node order [-].
    pub n: [f64; 9],
    /// Derivatives with respect to `r` [-].
    pub dr: [f64; 9],
    /// Derivatives with respect to `s` [-].
    pub ds: [f64; 9],
}

/// Shape functions of a line at one point, with their derivatives.
///
/// Entries from `count` on are zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LineValues {
    /// Number of nodes.
    pub count: usize,
    /// Shape functions in node order [-].
    pub n: [f64; 3],
    /// Derivatives with respect to `xi` [-].
    pub d: [f64; 3],
}

/// Reference coordinates `(r, s)` of the nodes of triangles: corners, then mid-sides.
///
/// The first three are the nodes of [`triangle3`], all six the nodes of [`triangle6`].
pub const TRIANGLE_NODES: [(f64, f64); 6] = [
    (0.0, 0.0),
    (1.0, 0.0),
    (0.0, 1.0),
    (0.5, 0.0),
    (0.5, 0.5),
    (0.0, 0.5),
];

/// Reference coordinates `(r, s)` of the nodes of quadrilaterals: corners,
/// mid-sides, center.
///
/// The first four are the nodes of [`quadrilateral4`], the first eight the nodes of
/// [`quadrilateral8`], all nine the nodes of [`quadrilateral9`].
pub const QUADRILATERAL_NODES: [(f64, f64); 9] = [
    (-1.0, -1.0),
    (1.0, -1.0),
    (1.0, 1.0),
    (-1.0, 1.0),
    (0.0, -1.0),
    (1.0, 0.0),
    (0.0, 1.0),
    (-1.0, 0.0),
    (0.0, 0.0),
];

/// Nodes of the line in each direction whose product is a node of the quadrilateral.
const TENSOR: [(usize, usize); 9] = [
    (0, 0),
    (1, 0),
    (1, 1),
    (0, 1),
    (2, 0),
    (1, 2),
    (2, 1),
    (0, 2),
    (2, 2),
];

impl ShapeValues {
    fn zeros(count: usize) -> Self {
        Self {
            count,
            n: [0.0; 9],
            dr: [0.0; 9],
            ds: [0.0; 9],
        }
    }

    fn set(&mut self, node: usize, n: f64, dr: f64, ds: f64) {
        self.n[node] = n;
        self.dr[node] = dr;
        self.ds[node] = ds;
    }
}

/// Linear triangle: `n = (1 - r - s, r, s)`.
pub fn triangle3(r: f64, s: f64) -> ShapeValues {
    let mut shape = ShapeValues::zeros(3);
    shape.set(0, 1.0 - r - s, -1.0, -1.0);
    shape.set(1, r, 1.0, 0.0);
    shape.set(2, s, 0.0, 1.0);
    shape
}

/// Quadratic triangle: corners, then the middles of sides 01, 12, 20.
///
/// With the area coordinates `l` of [`triangle3`]: `l_i (2 l_i - 1)` at the
/// corners, `4 l_i l_j` at the middles.
pub fn triangle6(r: f64, s: f64) -> ShapeValues {
    let ShapeValues { n: l, dr, ds, .. } = triangle3(r, s);
    let mut shape = ShapeValues::zeros(6);
    for i in 0..3 {
        let slope = 4.0 * l[i] - 1.0;
        shape.set(i, l[i] * (2.0 * l[i] - 1.0), slope * dr[i], slope * ds[i]);

        let j = (i + 1) % 3;
        shape.set(
            i + 3,
            4.0 * l[i] * l[j],
            4.0 * (dr[i] * l[j] + l[i] * dr[j]),
            4.0 * (ds[i] * l[j] + l[i] * ds[j]),
        );
    }
    shape
}

/// Bilinear quadrilateral: `n_i = 1/4 (1 + r_i r)(1 + s_i s)`.
pub fn quadrilateral4(r: f64, s: f64) -> ShapeValues {
    tensor_product(4, &line2(r), &line2(s))
}

/// Serendipity quadrilateral: corners, then the middles of sides 01, 12, 23, 30.
///
/// Corners: `1/4 (1 + r_i r)(1 + s_i s)(r_i r + s_i s - 1)`. Middles:
/// `1/2 (1 - r^2)(1 + s_i s)` if `r_i = 0`, `1/2 (1 + r_i r)(1 - s^2)` if `s_i = 0`.
pub fn quadrilateral8(r: f64, s: f64) -> ShapeValues {
    let mut shape = ShapeValues::zeros(8);
    for (node, &(ri, si)) in QUADRILATERAL_NODES[..8].iter().enumerate() {
        let (a, b) = (1.0 + ri * r, 1.0 + si * s);
        if node < 4 {
            let c = ri * r + si * s - 1.0;
            shape.set(
                node,
                0.25 * a * b * c,
                0.25 * ri * b * (c + a),
                0.25 * si * a * (c + b),
            );
        } else if ri == 0.0 {
            let e = 1.0 - r * r;
            shape.set(node, 0.5 * e * b, -r * b, 0.5 * e * si);
        } else {
            let e = 1.0 - s * s;
            shape.set(node, 0.5 * a * e, 0.5 * ri * e, -s * a);
        }
    }
    shape
}

/// Biquadratic quadrilateral: corners, middles of sides 01, 12, 23, 30, center.
///
/// Products of the functions of [`line3`] in `r` and `s`.
pub fn quadrilateral9(r: f64, s: f64) -> ShapeValues {
    tensor_product(9, &line3(r), &line3(s))
}

/// `n_ij(r, s) = n_i(r) n_j(s)`, in the node order of quadrilaterals.
fn tensor_product(count: usize, along_r: &LineValues, along_s: &LineValues) -> ShapeValues {
    let mut shape = ShapeValues::zeros(count);
    for (node, &(i, j)) in TENSOR[..count].iter().enumerate() {
        shape.set(
            node,
            along_r.n[i] * along_s.n[j],
            along_r.d[i] * along_s.n[j],
            along_r.n[i] * along_s.d[j],
        );
    }
    shape
}

/// Linear line: `n = ((1 - xi)/2, (1 + xi)/2)`, `xi` from -1 to 1.
pub fn line2(xi: f64) -> LineValues {
    LineValues {
        count: 2,
        n: [0.5 * (1.0 - xi), 0.5 * (1.0 + xi), 0.0],
        d: [-0.5, 0.5, 0.0],
    }
}

/// Quadratic line, ends then middle: `n = (xi (xi - 1)/2, xi (xi + 1)/2, 1 - xi^2)`.
pub fn line3(xi: f64) -> LineValues {
    LineValues {
        count: 3,
        n: [0.5 * xi * (xi - 1.0), 0.5 * xi * (xi + 1.0), 1.0 - xi * xi],
        d: [xi - 0.5, xi + 0.5, -2.0 * xi],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rotation::samples::Samples;

    /// A plane cell: its functions, nodes, and the monomials `r^a s^b` it contains.
    struct Plane {
        shape: fn(f64, f64) -> ShapeValues,
        nodes: &'static [(f64, f64)],
        complete: &'static [(i32, i32)],
        missing: (i32, i32),
    }

    const QUADRATIC: [(i32, i32); 6] = [(0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2)];
    const SERENDIPITY: [(i32, i32); 8] = [
        (0, 0),
        (1, 0),
        (0, 1),
        (2, 0),
        (1, 1),
        (0, 2),
        (2, 1),
        (1, 2),
    ];
    const BIQUADRATIC: [(i32, i32); 9] = [
        (0, 0),
        (1, 0),
        (0, 1),
        (2, 0),
        (1, 1),
        (0, 2),
        (2, 1),
        (1, 2),
        (2, 2),
    ];

    /// The space of each cell is the span of its monomials (Zienkiewicz and Taylor).
    fn planes() -> [Plane; 5] {
        let plane = |shape, nodes, complete, missing| Plane {
            shape,
            nodes,
            complete,
            missing,
        };
        let (t, q) = (&TRIANGLE_NODES, &QUADRILATERAL_NODES);
        [
            plane(triangle3, &t[..3], &QUADRATIC[..3], (1, 1)),
            plane(triangle6, &t[..], &QUADRATIC, (2, 1)),
            plane(
                quadrilateral4,
                &q[..4],
                &[(0, 0), (1, 0), (0, 1), (1, 1)],
                (2, 0),
            ),
            plane(quadrilateral8, &q[..8], &SERENDIPITY, (2, 2)),
            plane(quadrilateral9, &q[..], &BIQUADRATIC, (3, 0)),
        ]
    }

    // All values at the nodes are products of 0, 1/2 and 1: exact.
    #[test]
    fn each_function_is_one_at_its_node_and_zero_at_the_others() {
        for plane in planes() {
            for (i, &(r, s)) in plane.nodes.iter().enumerate() {
                let shape = (plane.shape)(r, s);
                assert_eq!(shape.count, plane.nodes.len());
                for (j, &n) in shape.n.iter().enumerate() {
                    assert_eq!(n, if i == j { 1.0 } else { 0.0 });
                }
            }
        }
        for (i, xi) in [-1.0, 1.0, 0.0].into_iter().enumerate() {
            for (j, (n2, n3)) in line2(xi).n.into_iter().zip(line3(xi).n).enumerate() {
                let delta = if i == j { 1.0 } else { 0.0 };
                assert_eq!(n3, delta);
                assert!(n2 == delta || i == 2);
            }
        }
    }

    // Mid-side nodes are between the corners given by the order.
    #[test]
    fn middles_lie_between_their_corners() {
        for (nodes, corners) in [(&TRIANGLE_NODES[..], 3), (&QUADRILATERAL_NODES[..8], 4)] {
            for side in 0..corners {
                let (a, b) = (nodes[side], nodes[(side + 1) % corners]);
                let middle = (0.5 * (a.0 + b.0), 0.5 * (a.1 + b.1));
                assert_eq!(nodes[corners + side], middle);
            }
        }
        for (node, &(i, j)) in TENSOR.iter().enumerate() {
            let line = [-1.0, 1.0, 0.0];
            assert_eq!(QUADRILATERAL_NODES[node], (line[i], line[j]));
        }
    }

    // Points in the square, so outside the triangles as well: the identities still hold
    // but values reach 20: a few roundings of these.
    #[test]
    fn functions_sum_to_one_and_derivatives_to_zero() {
        let mut samples = Samples::new(60);
        for _ in 0..100 {
            let (r, s) = (samples.scalar(), samples.scalar());
            for plane in planes() {
                let shape = (plane.shape)(r, s);
                assert!((shape.n.iter().sum::<f64>() - 1.0).abs() < 1e-14);
                assert!(shape.dr.iter().sum::<f64>().abs() < 1e-14);
                assert!(shape.ds.iter().sum::<f64>().abs() < 1e-14);
            }
            for line in [line2(r), line3(r)] {
                assert!((line.n.iter().sum::<f64>() - 1.0).abs() < 1e-15);
                assert!(line.d.iter().sum::<f64>().abs() < 1e-15);
            }
        }
    }

    // Central differences are exact for quadratics in one variable: only the rounding
    // 1e-16/h = 1e-12 with h = 1e-4 remains, times values of up to 20 (the points are in
    // the square, outside the triangles too) and a few operations.
    #[test]
    fn derivatives_agree_with_central_differences() {
        let (mut samples, h) = (Samples::new(61), 1e-4);
        for _ in 0..100 {
            let (r, s) = (samples.scalar(), samples.scalar());
            for Plane { shape, .. } in planes() {
                let (here, east, west) = (shape(r, s), shape(r + h, s), shape(r - h, s));
                let (north, south) = (shape(r, s + h), shape(r, s - h));
                for i in 0..9 {
                    assert!((here.dr[i] - (east.n[i] - west.n[i]) / (2.0 * h)).abs() < 1e-10);
                    assert!((here.ds[i] - (north.n[i] - south.n[i]) / (2.0 * h)).abs() < 1e-10);
                }
            }
            for line in [line2, line3] {
                for i in 0..3 {
                    let numeric = (line(r + h).n[i] - line(r - h).n[i]) / (2.0 * h);
                    assert!((line(r).d[i] - numeric).abs() < 1e-10);
                }
            }
        }
    }

    // The monomials of its space are interpolated exactly, the next one is not.
    #[test]
    fn spaces_are_complete_to_their_degree_and_no_further() {
        let mut samples = Samples::new(62);
        for _ in 0..100 {
            let (r, s) = (samples.scalar(), samples.scalar());
            for plane in planes() {
                let shape = (plane.shape)(r, s);
                let error = |&(a, b): &(i32, i32)| {
                    let nodal = plane.nodes.iter().map(|(r, s)| r.powi(a) * s.powi(b));
                    let value: f64 = shape.n.iter().zip(nodal).map(|(n, v)| n * v).sum();
                    (value - r.powi(a) * s.powi(b)).abs()
                };
                assert!(plane.complete.iter().all(|m| error(m) < 1e-14));
                assert!(error(&plane.missing) > 1e-9);
            }
            for (line, degree) in [(line2(r), 1), (line3(r), 2)] {
                for power in 0..=degree {
                    let ends: [f64; 3] = [-1.0, 1.0, 0.0];
                    let value: f64 = (0..3).map(|i| line.n[i] * ends[i].powi(power)).sum();
                    assert!((value - r.powi(power)).abs() < 1e-15);
                }
            }
        }
    }
}
