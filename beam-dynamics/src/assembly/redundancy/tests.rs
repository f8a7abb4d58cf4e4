//! Mechanisms whose redundant constraints are known by Gruebler's count.

use super::*;
use crate::elements::joints::{ConstraintJoint, JointEnds, Placing, axes_along};
use crate::model::Node;
use nalgebra::Matrix3;

/// A link: a node in the middle of its ends.
fn link(label: &str, ends: [Vector3<f64>; 2]) -> Node {
    Node {
        label: label.to_owned(),
        position: 0.5 * (ends[0] + ends[1]),
        rotation: Matrix3::identity(),
    }
}

/// Revolutes (name, first link or the frame, second link, position, axis).
type Revolute<'a> = (&'a str, Option<usize>, usize, Vector3<f64>, Vector3<f64>);

fn system(nodes: &[Node], revolutes: &[Revolute<'_>]) -> System {
    let joints = revolutes.iter().map(|(name, a, b, position, axis)| {
        let ends = JointEnds {
            a: a.map(|a| (a, &nodes[a])),
            b: (*b, &nodes[*b]),
        };
        let at = Placing::at(position, &axes_along(axis));
        Box::new(ConstraintJoint::revolute(*name, &ends, &at, None)) as Box<dyn Element>
    });
    System::new(nodes.to_vec(), joints.collect())
}

fn find_at_rest(system: &System) -> Vec<Redundant> {
    find(system, &system.rest(), &Conditions::at_rest())
}

/// Checks that nothing is redundant without the found constraints.
fn check_removal(system: &System, found: &[Redundant]) {
    let removed: Vec<_> = found.iter().map(|found| found.constraint).collect();
    let reduced = system.without(&removed);
    let left: Vec<_> = find_at_rest(&reduced)
        .into_iter()
        .filter(|found| !removed.contains(&found.constraint))
        .collect();
    assert_eq!(left, []);
}

fn four_bar(third_axis: Vector3<f64>) -> (Vec<Node>, [Vector3<f64>; 4], Vector3<f64>) {
    let [o, a, b, c] =
        [[0.0, 0.0], [0.0, 1.0], [3.0, 2.0], [3.5, 0.0]].map(|[x, y]| Vector3::new(x, y, 0.0));
    let nodes = vec![
        link("crank", [o, a]),
        link("coupler", [a, b]),
        link("rocker", [b, c]),
    ];
    (nodes, [o, a, b, c], third_axis)
}

// A plane four-bar with four revolutes: 3 links have 18 freedoms, 20 constraints leave one freedom,
// so that 3 are redundant: the closing joint constrains the distance along z and the two tilts
// again.
#[test]
fn a_plane_four_bar_with_revolutes_has_three() {
    let (nodes, [o, a, b, c], z) = four_bar(Vector3::z());
    let system = system(
        &nodes,
        &[
            ("A", None, 0, o, z),
            ("B", Some(0), 1, a, z),
            ("C", Some(1), 2, b, z),
            ("D", None, 2, c, z),
        ],
    );
    let found = find_at_rest(&system);
    assert_eq!(found.len(), 3, "{found:?}");
    for found in &found {
        assert_eq!(found.joint, "D");
        assert_eq!(found.from, ["A", "B", "C"]);
    }
    assert_eq!(
        found[0].to_string(),
        "constraint 1 (along z) of \"D\" follows from \"A\", \"B\" and \"C\""
    );
    assert!(
        found[1].direction.starts_with("rotation about "),
        "{found:?}"
    );
    check_removal(&system, &found);
}

// A second revolute at the same position doubles all five constraints.
#[test]
fn a_doubled_revolute_is_reported_by_name() {
    let (nodes, [o, ..], z) = four_bar(Vector3::z());
    let joints = [("A", None, 0, o, z), ("again", None, 0, o, z)];
    let system = system(&nodes[..1], &joints);
    let found = find_at_rest(&system);
    assert_eq!(found.len(), 5);
    let directions: Vec<_> = found.iter().map(|found| found.direction.as_str()).collect();
    assert_eq!(directions[..3], ["along z", "along y", "along x"]);
    assert!(
        found
            .iter()
            .all(|found| found.joint == "again" && found.from == ["A"])
    );
    check_removal(&system, &found);
}

// A door on two hinges on one line turns: 6 - 10 = -4 by the count, 5 are redundant.
#[test]
fn a_door_on_two_hinges_has_five() {
    let door = link("door", [Vector3::zeros(), Vector3::new(1.0, 0.0, 2.0)]);
    let [low, high] = [0.2, 1.8].map(|z| Vector3::new(0.0, 0.0, z));
    let z = Vector3::z();
    let joints = [("low", None, 0, low, z), ("high", None, 0, high, z)];
    let system = system(&[door], &joints);
    let found = find_at_rest(&system);
    assert_eq!(found.len(), 5);
    check_removal(&system, &found);
}

// Off one line, the hinges hold the door: 6 constraints of 10 are independent.
#[test]
fn a_door_on_hinges_out_of_line_has_four() {
    let door = link("door", [Vector3::zeros(), Vector3::new(1.0, 0.0, 2.0)]);
    let low = Vector3::new(0.0, 0.0, 0.2);
    let high = Vector3::new(0.1, 0.0, 1.8);
    let z = Vector3::z();
    let joints = [("low", None, 0, low, z), ("high", None, 0, high, z)];
    let found = find_at_rest(&system(&[door], &joints));
    assert_eq!(found.len(), 4, "{found:?}");
}

/// A Bennett linkage by the positions of its axes: lengths a, b, a, b along the common normals and
/// twists alpha, beta, alpha, beta with `a sin(beta) = b sin(alpha)`.
fn bennett(angle: f64, error: f64) -> System {
    let (a, alpha, beta) = (1.0_f64, 0.6_f64, 1.1_f64);
    let b = a * beta.sin() / alpha.sin() * (1.0 + error);
    // tan(theta/2) tan(phi/2) = sin((beta + alpha)/2) / sin((beta - alpha)/2).
    let ratio = (0.5 * (beta + alpha)).sin() / (0.5 * (beta - alpha)).sin();
    let other = 2.0 * (ratio / (0.5 * angle).tan()).atan();
    let mut position = Vector3::zeros();
    let mut axes = Matrix3::identity();
    let about =
        |axis: Vector3<f64>, by: f64| shared_geom::rotation::vector::to_rotation(&(by * axis));
    let mut joints = vec![(position, axes.column(2).into_owned())];
    for (theta, length, twist) in [(angle, a, alpha), (other, b, beta), (-angle, a, alpha)] {
        axes *= about(Vector3::z(), theta);
        position += length * axes.column(0);
        axes *= about(Vector3::x(), twist);
        joints.push((position, axes.column(2).into_owned()));
    }
    let [p, q, r, s] = [0, 1, 2, 3].map(|i| joints[i].0);
    let nodes = [link("1", [p, q]), link("2", [q, r]), link("3", [r, s])];
    let [one, two, three, four] = [0, 1, 2, 3].map(|i| joints[i]);
    system(
        &nodes,
        &[
            ("A", None, 0, one.0, one.1),
            ("B", Some(0), 1, two.0, two.1),
            ("C", Some(1), 2, three.0, three.1),
            ("D", None, 2, four.0, four.1),
        ],
    )
}

// Bennett's linkage: 18 - 20 = -2 by the count, but it moves with one freedom: three
// redundant constraints. With other lengths it is rigid: two.
#[test]
fn bennetts_linkage_moves_and_has_three() {
    for angle in [0.4, 1.0, 2.2] {
        let system = bennett(angle, 0.0);
        let found = find_at_rest(&system);
        assert_eq!(found.len(), 3, "{angle}: {found:?}");
        assert!(found.iter().all(|found| found.joint == "D"));
        check_removal(&system, &found);
    }
    assert_eq!(find_at_rest(&bennett(1.0, 0.1)).len(), 2);
}

// A chain of 200 four-bars side by side, each on the coupler of the previous one: all sparse.
#[test]
fn thousands_of_constraints_are_searched() {
    let z = Vector3::z();
    let count = 200;
    let mut nodes = Vec::new();
    let mut joints: Vec<(String, Option<usize>, usize, Vector3<f64>)> = Vec::new();
    for i in 0..count {
        let shift = Vector3::new(4.0 * f64::from(i as u32), 0.3 * f64::from(i as u32), 0.0);
        let (links, positions, _) = four_bar(z);
        let [o, a, b, c] = positions.map(|point| point + shift);
        let first = nodes.len();
        nodes.extend(links.into_iter().map(|link| Node {
            position: link.position + shift,
            ..link
        }));
        let ground = (i > 0).then(|| first - 2);
        joints.push((format!("A{i}"), ground, first, o));
        joints.push((format!("B{i}"), Some(first), first + 1, a));
        joints.push((format!("C{i}"), Some(first + 1), first + 2, b));
        joints.push((format!("D{i}"), ground, first + 2, c));
    }
    let joints: Vec<_> = joints
        .iter()
        .map(|(name, a, b, point)| (name.as_str(), *a, *b, *point, z))
        .collect();
    let system = system(&nodes, &joints);
    assert_eq!(system.numbering().multipliers(), 4000);
    let found = find_at_rest(&system);
    assert_eq!(found.len(), 3 * count);
}

// Two links in the same position, far from the origin, where positions have a round-off of 1e-8 m:
// it is not their size, and no constraint of the chain follows from others.
#[test]
fn nothing_is_redundant_far_from_the_origin() {
    let far = Vector3::new(1e8, 1e8, 0.0);
    let mut nodes = vec![link("1", [far, far]), link("2", [far, far])];
    nodes[1].position.x += 1.5e-8;
    let arm = Vector3::new(0.0, 0.0, 1.0);
    let (y, z) = (Vector3::y(), Vector3::z());
    let system = system(
        &nodes,
        &[
            ("A", None, 0, far + arm, y),
            ("B", Some(0), 1, far + 0.5 * arm, z),
        ],
    );
    assert_eq!(find_at_rest(&system), []);
}
