//! The loads that balance each other in random loops, against a dense decomposition.

use nalgebra::{DMatrix, Vector3};

use super::*;
use crate::assembly::redundancy;
use crate::effort::cases;
use crate::elements::joints::{ConstraintJoint, Freedom, JointEnds, Placing, axes_along};
use crate::elements::{Element, Level};
use crate::model::{NODE_UNKNOWNS, Node};

/// Numbers between zero and one that follow from a seed.
struct Numbers(u64);

impl Numbers {
    fn new(seed: u64) -> Self {
        let mut numbers = Self(seed);
        for _ in 0..5 {
            numbers.next();
        }
        numbers
    }

    fn next(&mut self) -> f64 {
        // Constants of Knuth's MMIX generator.
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005);
        self.0 = self.0.wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn below(&mut self, end: usize) -> usize {
        (end as f64 * self.next()) as usize
    }

    fn vector(&mut self) -> Vector3<f64> {
        Vector3::from_fn(|_, _| 2.0 * self.next() - 1.0)
    }
}

/// A joint between two nodes, or the frame and a node.
type Pair = (Option<usize>, usize);

fn revolute(nodes: &[Node], (a, b): Pair, at: &Placing) -> Box<dyn Element> {
    let ends = JointEnds {
        a: a.map(|a| (a, &nodes[a])),
        b: (b, &nodes[b]),
    };
    Box::new(ConstraintJoint::revolute("pin", &ends, at, None))
}

/// A joint of a random kind.
fn joint(numbers: &mut Numbers, nodes: &[Node], (a, b): Pair, at: &Placing) -> Box<dyn Element> {
    let ends = JointEnds {
        a: a.map(|a| (a, &nodes[a])),
        b: (b, &nodes[b]),
    };
    Box::new(match numbers.below(4) {
        0 => ConstraintJoint::clamp("clamp", &ends, at),
        1 => ConstraintJoint::spherical("ball", &ends, at),
        2 => ConstraintJoint::cylindrical("sleeve", &ends, at, Freedom::Free, None),
        _ => ConstraintJoint::revolute("pin", &ends, at, None),
    })
}

fn nodes(numbers: &mut Numbers, count: usize) -> Vec<Node> {
    let node = |i| Node {
        label: format!("n{i}"),
        position: numbers.vector(),
        rotation: shared_geom::rotation::vector::to_rotation(&(2.0 * numbers.vector())),
    };
    (0..count).map(node).collect()
}

/// A ring of 3 to 12 bodies, on the frame or not, with parallel axes; in random order.
fn ring(numbers: &mut Numbers) -> System {
    let count = 3 + numbers.below(10);
    let nodes = nodes(numbers, count);
    let axis = numbers.vector().normalize();
    let last = count - 1;
    let mut pairs: Vec<Pair> = (0..last).map(|i| (Some(i), i + 1)).collect();
    match numbers.below(2) {
        0 => pairs.push((Some(last), 0)),
        _ => pairs.extend([(None, 0), (None, last)]),
    }
    let mut joints = Vec::new();
    while !pairs.is_empty() {
        let pair = pairs.swap_remove(numbers.below(pairs.len()));
        let at = Placing::at(&numbers.vector(), &axes_along(&axis));
        joints.push(revolute(&nodes, pair, &at));
    }
    System::new(nodes, joints)
}

/// Bodies attached to others, or to the frame, with further random joints: joints of all kinds,
/// some about the same axes.
fn net(numbers: &mut Numbers) -> System {
    let count = 2 + numbers.below(5);
    let nodes = nodes(numbers, count);
    let axes = [Vector3::x(), Vector3::z(), numbers.vector().normalize()];
    let mut joints = Vec::new();
    for own in 0..count + 1 + numbers.below(5) {
        let b = if own < count {
            own
        } else {
            numbers.below(count)
        };
        let a = numbers.below(b + 1).checked_sub(1);
        let at = match numbers.below(2) {
            0 => numbers.vector(),
            _ => Vector3::zeros(),
        };
        let axis = axes[numbers.below(3)];
        let at = Placing::at(&at, &axes_along(&axis));
        joints.push(joint(numbers, &nodes, (a, b), &at));
    }
    System::new(nodes, joints)
}

/// The system with loops in which constraints share loads; `None` if none is redundant.
fn shared(system: &System) -> Option<System> {
    let found = redundancy::find(system, &system.rest(), &Conditions::at_rest());
    (!found.is_empty()).then(|| system.with_shared_loads(&found, 1e-3))
}

fn sharing(system: &System) -> Sharing {
    Sharing::new(system, &system.rest(), &Conditions::at_rest())
}

/// P for all constraints of a system, by forces.
fn projector(sharing: &mut Sharing, count: usize) -> DMatrix<f64> {
    let mut all = DMatrix::zeros(count, count);
    for part in &mut sharing.parts {
        for (j, column) in part.constraints.clone().into_iter().enumerate() {
            let own = part.constraints[j];
            part.project(|constraint, _| f64::from(u8::from(constraint == own)));
            for (row, value) in part.constraints.iter().zip(&part.found) {
                all[(*row, column)] = *value;
            }
        }
    }
    all
}

/// All of A, each row scaled to a unit displacement.
fn rows(system: &System) -> DMatrix<f64> {
    let tangent = system.tangent(&system.rest(), &Conditions::at_rest());
    let count = system.numbering().multipliers();
    let mut rows = DMatrix::zeros(count, 6 * system.nodes().len());
    for (row, column, value) in system.constraint_rows(&tangent, &[Level::Position]) {
        let index = column % NODE_UNKNOWNS;
        let size = if index < 3 { 1.0 } else { system.size() };
        rows[(row, 6 * (column / NODE_UNKNOWNS) + index)] = value / size;
    }
    for mut row in rows.row_iter_mut() {
        let own: Vec<f64> = row.iter().copied().collect();
        let norm = |first: usize| {
            let vectors = own.chunks(6).map(|node| {
                let vector = Vector3::from_column_slice(&node[first..first + 3]);
                vector.norm()
            });
            vectors.fold(0.0, f64::max)
        };
        let (along, about) = (norm(0), norm(3));
        row.unscale_mut(if along > 0.0 { along } else { about });
    }
    rows
}

/// Deviation of a matrix from the projector on the solutions of `A^T mu = 0`, of which there are
/// `loads`: these products determine the projector uniquely.
fn off(found: &DMatrix<f64>, rows: &DMatrix<f64>, loads: usize) -> f64 {
    let errors = [
        (found.transpose() - found).amax(),
        (found * found - found).amax(),
        (rows.transpose() * found).amax(),
        (found.trace() - loads as f64).abs(),
    ];
    errors.into_iter().fold(0.0, f64::max)
}

// Round-off of some fifty numbers of size one, for the tree method and for all rows together.
#[test]
fn loads_that_balance_each_other_are_those_of_a_dense_decomposition() {
    let (mut looked_at, mut loops) = (0, 0);
    for seed in 0..cases(120) as u64 {
        let mut numbers = Numbers::new(seed);
        let system = match seed % 2 {
            0 => ring(&mut numbers),
            _ => net(&mut numbers),
        };
        let Some(system) = shared(&system) else {
            continue;
        };
        let mut sharing = sharing(&system);
        let (rows, loads) = (rows(&system), system.surpluses());
        let found = projector(&mut sharing, rows.nrows());
        let error = off(&found, &rows, loads);
        assert!(error < 1e-12, "{seed}: {error:e}");
        looked_at += 1;
        loops += sharing.parts.len();
        for part in &mut sharing.parts {
            assert!(!part.looks_at_all(), "{seed}");
            part.look_at_all();
        }
        let dense = projector(&mut sharing, rows.nrows());
        let error = off(&dense, &rows, loads).max((&found - dense).amax());
        assert!(error < 1e-12, "{seed}: {error:e} of all together");
    }
    assert!(
        3 * looked_at > 2 * cases(120) && loops > looked_at,
        "{looked_at} {loops}"
    );
}

// Three of the constraints of a ring with parallel axes follow from others, and its loads
// vanish at every node: the tree has one cut.
#[test]
fn a_ring_has_three_loads_that_balance_each_other() {
    for seed in 0..20 {
        let system = shared(&ring(&mut Numbers::new(seed))).unwrap();
        assert_eq!(system.surpluses(), 3);
        let sharing = sharing(&system);
        let multipliers: Vec<_> = sharing.parts[0].balanced(0);
        let mut state = system.rest();
        state.multipliers.copy_from_slice(&multipliers);
        let residual = system.residual(&state, &Conditions::at_rest());
        let first = system.numbering().first_multiplier();
        let left = residual.values[..first].iter().map(|value| value.abs());
        assert!(left.fold(0.0, f64::max) < 1e-14, "{seed}");
    }
}

// The result for one position does not depend on the result for a previous one.
#[test]
fn the_same_state_gives_the_same_bits() {
    let system = shared(&ring(&mut Numbers::new(8))).unwrap();
    let (rest, conditions) = (system.rest(), Conditions::at_rest());
    let mut turned = rest.clone();
    let turn = shared_geom::rotation::vector::to_rotation(&Vector3::new(0.3, -0.2, 0.9));
    for node in &mut turned.nodes {
        node.position = turn * node.position;
        node.rotation = turn * node.rotation;
    }
    let mut work = system.workspace();
    let mut used = Sharing::new(&system, &turned, &conditions);
    used.update(&system, &rest, &conditions, &mut work);
    let mut fresh = sharing(&system);
    let count = system.numbering().multipliers();
    assert_eq!(projector(&mut used, count), projector(&mut fresh, count));
}

// Without the amplitudes of the loads, the entries of the matrix are the derivatives of the term
// added to the residual, which is linear in the multipliers.
#[test]
fn the_matrix_is_the_derivative_of_the_residual() {
    let system = shared(&ring(&mut Numbers::new(3))).unwrap();
    let mut sharing = sharing(&system);
    let numbering = system.numbering();
    let (first, unknowns) = (numbering.first_multiplier(), numbering.unknowns());
    let mut matrix = Sparse::zero(std::sync::Arc::clone(system.pattern()));
    let weight = 0.7;
    let sum = Combination {
        by_unknowns: 0.2,
        by_rates: 0.3,
        by_algebraic: weight,
        matrix: &mut matrix,
    };
    sharing.add_jacobian(&mut [sum]);
    let size = system.pattern().size();
    assert_eq!(size, unknowns + 3);
    for column in 0..numbering.multipliers() {
        let mut multipliers = vec![0.0; numbering.multipliers()];
        multipliers[column] = 1.0;
        sharing.take_surplus(&mut multipliers);
        let mut residual = Residual {
            values: vec![0.0; unknowns],
            sizes: vec![0.0; unknowns],
        };
        sharing.add_residual(first, &mut residual);
        for row in 0..numbering.multipliers() {
            let through = (unknowns..size).map(|k| {
                let takes = -matrix.entry(k, first + column) / matrix.entry(k, k);
                matrix.entry(first + row, k) * takes
            });
            let expected = weight * residual.values[first + row];
            let error = (through.sum::<f64>() - expected).abs();
            assert!(error < 1e-16, "{row} {column}: {error:e}");
        }
    }
}
