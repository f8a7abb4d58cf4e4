//! The rate of the energy of each element is the power of its forces.
//!
//! Along a motion with the velocities v, omega the energy changes by central differences
//! with the step 1e-5: truncation 1e-10 of third derivatives of order one, round-off 1e-11
//! of energies of order ten.

use nalgebra::{Matrix1, Matrix3, Matrix6, Vector3, Vector6};
use shared_geom::rotation::vector;

use super::beams::{Beam, BeamGeometry, BeamInertia, BeamNode, MassAlong};
use super::bodies::{RigidBody, RigidInertia};
use super::joints::{Hinge, HingeSpring};
use super::laws::{Cubic, Driven, Law, LawKind, Term};
use super::springs::{
    End, Measure, Rod, Spring, SpringLaw, SupportFrame, SupportLaw, SupportSpring,
};
use super::{Element, Energy, Local, LocalResidual, LocalSize};
use crate::elements::Queries;
use crate::model::{Conditions, Drive, Harmonic, NODE_UNKNOWNS, Node, NodeMotion, Scalars};

const STEP: f64 = 1e-5;

fn node(x: f64, turn: [f64; 3]) -> Node {
    Node {
        label: format!("node at {x}"),
        position: Vector3::new(x, 0.0, 0.0),
        rotation: vector::to_rotation(&turn.into()),
    }
}

/// Velocities and accelerations of the nodes.
type Rates = Vec<[Vector3<f64>; 4]>;

/// Each node at a displaced position, with its velocities.
fn displaced(nodes: &[Node]) -> (Vec<NodeMotion>, Rates) {
    let mut motion: Vec<_> = nodes.iter().map(NodeMotion::at_rest).collect();
    let mut rates = Vec::new();
    for (i, node) in motion.iter_mut().enumerate() {
        let i = i as f64;
        node.position += Vector3::new(0.3, -0.2 * i, 0.1);
        node.rotation = vector::to_rotation(&Vector3::new(0.4 * i, 0.2, -0.3)) * node.rotation;
        rates.push([
            Vector3::new(0.7 - i, 0.4, -0.5 * i),
            Vector3::new(-0.6, 0.9 * i, 0.8),
            Vector3::new(0.3, -0.8, 0.5 + i),
            Vector3::new(0.2 * i, -0.4, 0.6),
        ]);
    }
    (motion, rates)
}

/// The motion at a time near zero, with the velocities there.
fn after(motion: &[NodeMotion], rates: &Rates, time: f64) -> Vec<NodeMotion> {
    let mut moved = motion.to_vec();
    for (node, [v, omega, a, alpha]) in moved.iter_mut().zip(rates) {
        node.position += time * v + 0.5 * time * time * a;
        node.rotation =
            vector::to_rotation(&(time * omega + 0.5 * time * time * alpha)) * node.rotation;
        node.velocity = v + time * a;
        node.angular_velocity = omega + time * alpha;
    }
    moved
}

fn conditions() -> Conditions {
    let mut conditions = Conditions::at_rest();
    conditions.loading.gravity = Vector3::new(0.5, -1.0, -2.0);
    conditions
}

fn energy(element: &dyn Element, motion: &[NodeMotion], conditions: &Conditions) -> Energy {
    element.energy(&local(element, motion, conditions))
}

fn local<'a>(
    element: &dyn Element,
    motion: &'a [NodeMotion],
    conditions: &'a Conditions,
) -> Local<'a> {
    const NONE: [f64; 5] = [0.0; 5];
    Local {
        nodes: motion,
        multipliers: &NONE[..element.multipliers()],
        scalars: Scalars::NONE,
        memory: &[],
        frame: &conditions.frame,
        loading: &conditions.loading,
    }
}

/// The residual, twelve numbers a node.
fn residual(element: &dyn Element, motion: &[NodeMotion]) -> Vec<[Vector3<f64>; 4]> {
    let mut out = LocalResidual::new(LocalSize::without_scalars(
        motion.len(),
        element.multipliers(),
    ));
    element.residual(&local(element, motion, &conditions()), &mut out);
    let of_node = |node: usize| {
        let part = |k: usize| {
            let first = NODE_UNKNOWNS * node + 3 * k;
            Vector3::from_column_slice(&out.values()[first..first + 3])
        };
        std::array::from_fn(part)
    };
    (0..motion.len()).map(of_node).collect()
}

/// Power of the forces and moments on the nodes.
fn power(element: &dyn Element, motion: &[NodeMotion]) -> f64 {
    let forces = residual(element, motion);
    let of_node = |(node, forces): (&NodeMotion, &[Vector3<f64>; 4])| {
        node.velocity.dot(&forces[2]) + node.angular_velocity.dot(&forces[3])
    };
    motion.iter().zip(&forces).map(of_node).sum()
}

/// Change of elastic energy and potential, per time.
fn stored_rate(element: &dyn Element, motion: &[NodeMotion], rates: &Rates) -> f64 {
    let at = |time: f64| {
        let Energy {
            elastic, gravity, ..
        } = energy(element, &after(motion, rates, time), &conditions());
        elastic + gravity
    };
    (at(STEP) - at(-STEP)) / (2.0 * STEP)
}

/// The rate of the stored energy is the power of the forces with the opposite sign.
fn check_stored(element: &dyn Element, nodes: &[Node]) {
    let (motion, rates) = displaced(nodes);
    let found = stored_rate(element, &motion, &rates);
    let power = power(element, &after(&motion, &rates, 0.0));
    assert!(power.abs() > 0.05, "{} {power}", element.label());
    assert!(
        (found + power).abs() < 1e-9,
        "{} {found} {power}",
        element.label()
    );
}

/// The kinetic energy comes from the rates of the momenta: with beta and gamma of the
/// element on each node, `T' = sum v . beta' + omega . (gamma' + v x beta)`.
fn check_kinetic(element: &dyn Element, motion: &[NodeMotion], rates: &Rates) {
    let at = |time: f64| {
        let motion = after(motion, rates, time);
        let momenta = residual(element, &motion);
        (energy(element, &motion, &conditions()).kinetic, momenta)
    };
    let (later, sooner, now) = (at(STEP), at(-STEP), at(0.0));
    let found = (later.0 - sooner.0) / (2.0 * STEP);
    let mut expected = 0.0;
    for (i, [v, omega, ..]) in rates.iter().enumerate() {
        let [beta_rate, gamma_rate] =
            [0, 1].map(|k| -(later.1[i][k] - sooner.1[i][k]) / (2.0 * STEP));
        let beta = -now.1[i][0];
        expected += v.dot(&beta_rate) + omega.dot(&(gamma_rate + v.cross(&beta)));
    }
    assert!(expected.abs() > 0.05, "{} {expected}", element.label());
    assert!(
        (found - expected).abs() < 1e-8,
        "{} {found} {expected}",
        element.label()
    );
}

fn body() -> RigidBody {
    let central = Matrix3::new(0.5, 0.1, 0.0, 0.1, 0.7, 0.0, 0.0, 0.0, 0.9);
    let inertia = RigidInertia::about_node(1.3, &Vector3::new(0.2, -0.3, 0.4), &central);
    RigidBody::new("body", 0, inertia)
}

#[test]
fn energy_of_a_rigid_body() {
    let nodes = [node(1.0, [0.3, 0.1, -0.2])];
    let (motion, rates) = displaced(&nodes);
    check_kinetic(&body(), &motion, &rates);
    check_stored(&body(), &nodes);
}

/// 1/2 m v^2 + 1/2 J omega^2 and m g h, with the center of mass at the node.
#[test]
fn energy_of_a_rigid_body_in_numbers() {
    let nodes = [node(0.0, [0.0; 3])];
    let inertia = RigidInertia::about_node(2.0, &Vector3::zeros(), &(3.0 * Matrix3::identity()));
    let body = RigidBody::new("body", 0, inertia);
    let mut motion = vec![NodeMotion::at_rest(&nodes[0])];
    motion[0].velocity.x = 4.0;
    motion[0].angular_velocity.y = 5.0;
    motion[0].position.z = 7.0;
    let found = energy(&body, &motion, &conditions());
    assert!((found.kinetic - (16.0 + 37.5)).abs() < 1e-13);
    assert!((found.gravity - 2.0 * 2.0 * 7.0).abs() < 1e-13);
    assert_eq!(found.elastic, 0.0);
}

/// Elastic laws with all their terms.
fn cubic<const N: usize>() -> Law<N> {
    let of = |i: usize| Cubic {
        first: 2.0 + 0.3 * i as f64,
        second: 0.5,
        third: 1.5,
    };
    LawKind::Cubic(std::array::from_fn(of)).into()
}

#[test]
fn energy_of_springs() {
    let nodes = [node(0.0, [0.3, 0.1, -0.2]), node(1.5, [-0.1, 0.2, 0.4])];
    let (position, axes) = (Vector3::new(0.5, 0.2, -0.1), nodes[1].rotation);
    let ends = [0, 1].map(|node| End::Node {
        node,
        offset: Vector3::new(0.1, 0.3, -0.2),
    });
    for measure in [Measure::Strain, Measure::Elongation] {
        let rod = Rod::new(
            "rod",
            ends,
            &nodes,
            Some(Drive::Constant(0.7).into()),
            (measure, cubic()),
        );
        check_stored(&rod, &nodes);
    }
    for law in [
        SpringLaw::of_displacement(cubic()),
        SpringLaw::of_rotation(cubic()),
        SpringLaw::Together(cubic()),
    ] {
        let between = Spring::new("between", (&[0, 1], &nodes), &position, &axes, law.clone());
        check_stored(&between, &nodes);
        let to_frame = Spring::new("to the frame", (&[0], &nodes), &position, &axes, law);
        check_stored(&to_frame, &nodes[..1]);
    }
    let law = SupportLaw::along(&axes, &[1.0, 2.0, 3.0, 0.5, 0.7, 0.9], &[0.0; 6]);
    let support = SupportSpring::new("support", 0, &nodes[0], law, SupportFrame::Frame);
    check_stored(&support, &nodes[..1]);
}

#[test]
fn energy_of_the_spring_of_a_hinge() {
    let nodes = [node(0.0, [0.0; 3]), node(1.0, [0.0; 3])];
    let spring = HingeSpring {
        stiffness: 3.0,
        damping: 0.0,
        angle: 0.2,
    };
    let ends = [&nodes[0], &nodes[1]];
    let position = nodes[1].position;
    let hinge = Hinge::new("hinge", [0, 1], ends, &position, &Vector3::z(), spring);
    // Turned about its axis only, so that the constraints hold.
    let mut motion: Vec<_> = nodes.iter().map(NodeMotion::at_rest).collect();
    motion[1].rotation = vector::to_rotation(&Vector3::new(0.0, 0.0, 0.9));
    let found = energy(&hinge, &motion, &conditions()).elastic;
    assert!((found - 0.5 * 3.0 * 0.7 * 0.7).abs() < 1e-14);
    let zero = Vector3::zeros();
    let rates = vec![[zero; 4], [zero, Vector3::new(0.0, 0.0, 1.1), zero, zero]];
    let power = power(&hinge, &after(&motion, &rates, 0.0));
    let found = stored_rate(&hinge, &motion, &rates);
    assert!(power < -1.0 && (found + power).abs() < 1e-9);
}

/// A drive with derivatives of order one.
fn moving() -> Drive {
    Drive::Harmonic(Harmonic {
        frequency: 0.3,
        amplitude: 0.4,
        mean: 0.9,
        phase: 0.7,
        start: -10.0,
        cycles: f64::INFINITY,
    })
}

/// A rod of each measure, a hinge and a spring about z, all of the stiffness `k` and relaxed by
/// a drive that moves.
fn relaxing(nodes: &[Node; 2], k: f64) -> [Box<dyn Element>; 4] {
    let ends = [0, 1].map(|node| End::Node {
        node,
        offset: Vector3::zeros(),
    });
    let rod = |measure| -> Box<dyn Element> {
        let law = (measure, Law::linear(Matrix1::new(k)));
        Box::new(Rod::new("rod", ends, nodes, Some(moving().into()), law))
    };
    let relaxed = HingeSpring {
        stiffness: k,
        ..HingeSpring::default()
    };
    let on = [&nodes[0], &nodes[1]];
    let position = nodes[1].position;
    let hinge = Hinge::new("hinge", [0, 1], on, &position, &Vector3::z(), relaxed);
    let law = Law::sum(vec![Term {
        kind: LawKind::Linear {
            stiffness: k * Matrix3::identity(),
        },
        prestrain: Some(Driven {
            vector: Vector3::z(),
            signal: moving().into(),
        }),
        prestress: None,
    }]);
    let (law, axes) = (SpringLaw::of_rotation(law), Matrix3::identity());
    let spring = Spring::new("spring", (&[0, 1], nodes), &position, &axes, law);
    [
        rod(Measure::Elongation),
        rod(Measure::Strain),
        Box::new(hinge.relaxed_by(moving())),
        Box::new(spring),
    ]
}

/// The energy is relative to the relaxed state of its time. With the nodes at rest only the drive
/// changes it, by its work against the force: `W' = - f . eps_0'`, by differences in time of 1e-5
/// s.
#[test]
fn energy_counts_from_the_relaxed_state_of_its_time() {
    let nodes = [node(0.0, [0.0; 3]), node(1.5, [0.0; 3])];
    let mut motion: Vec<_> = nodes.iter().map(NodeMotion::at_rest).collect();
    motion[1].position.x += 0.2;
    motion[1].rotation = vector::to_rotation(&Vector3::new(0.0, 0.0, 0.3));
    let (k, time) = (3.0, 0.4);
    let rest = moving().at(time);
    let stretch = 1.7 - rest.value;
    let [elongation, strain, hinge, spring] = relaxing(&nodes, k);
    let turned = 0.3 - rest.value;
    // Of a strain, k (l - l_0)^2 / (2 l_0), which l_0 scales too.
    let by_strain = -k * stretch / rest.value - 0.5 * k * (stretch / rest.value).powi(2);
    let cases: [(&dyn Element, f64, f64); 4] = [
        (&*elongation, k * stretch * stretch, -k * stretch),
        (&*strain, k * stretch * stretch / rest.value, by_strain),
        (&*hinge, k * turned * turned, -k * turned),
        (&*spring, k * turned * turned, -k * turned),
    ];
    for (element, twice, slope) in cases {
        let at = |time: f64| {
            let mut conditions = conditions();
            conditions.loading.time = time;
            energy(element, &motion, &conditions).elastic
        };
        let error = (at(time) - 0.5 * twice).abs();
        assert!(error < 1e-13, "{} {error:e}", element.label());
        let rate = (at(time + STEP) - at(time - STEP)) / (2.0 * STEP);
        let error = (rate - slope * rest.rate).abs();
        assert!(error < 1e-9, "{} {rate} {error:e}", element.label());
        assert!(rate.abs() > 0.05, "{} {rate}", element.label());
    }
}

const LENGTH: f64 = 2.0;

fn beam_nodes() -> [Node; 3] {
    [0.0, 1.0, LENGTH].map(|x| node(x, [0.0; 3]))
}

fn geometry() -> BeamGeometry {
    BeamGeometry::new([BeamNode::aligned(); 3])
}

/// Stretched and twisted evenly: 1/2 (EA e^2 + GJ k^2) L, exactly, since rotation vectors
/// about one axis add; with the power of the forces. Differences with the step 1e-6 of
/// numbers of order one.
#[test]
fn energy_of_a_beam_with_even_strain() {
    let nodes = beam_nodes();
    let undeformed = [&nodes[0], &nodes[1], &nodes[2]];
    let stiffness = Matrix6::from_diagonal(&Vector6::new(5.0, 2.0, 3.0, 1.7, 1.5, 2.5));
    let beam = Beam::elastic("elastic", [0, 1, 2], geometry(), undeformed, [stiffness; 2]);
    let (stretch, twist) = (0.3, 0.4);
    let mut motion: Vec<_> = nodes.iter().map(NodeMotion::at_rest).collect();
    let mut rates = Vec::new();
    for node in &mut motion {
        let x = node.position.x;
        node.position.x *= 1.0 + stretch;
        node.rotation = vector::to_rotation(&Vector3::new(twist * x, 0.0, 0.0));
        let zero = Vector3::zeros();
        rates.push([
            Vector3::new(x, 0.0, 0.0),
            Vector3::new(0.7 * x, 0.0, 0.0),
            zero,
            zero,
        ]);
    }
    let found = energy(&beam, &motion, &conditions()).elastic;
    let expected = 0.5 * LENGTH * (5.0 * stretch * stretch + 1.7 * twist * twist);
    assert!((found / expected - 1.0).abs() < 1e-14, "{found} {expected}");
    let rest = after(&motion, &rates, 0.0);
    let (rate, power) = (stored_rate(&beam, &motion, &rates), power(&beam, &rest));
    assert!(
        power < -1.0 && (rate + power).abs() < 1e-8,
        "{rate} {power}"
    );
}

/// The rate of the energy of an arbitrary motion is the power of the forces: the
/// variational beam is the gradient of its energy. Differences as above.
#[test]
fn energy_of_a_beam_is_the_work_of_its_forces() {
    let nodes = beam_nodes();
    let undeformed = [&nodes[0], &nodes[1], &nodes[2]];
    let stiffness = Matrix6::from_fn(|i, j| if i == j { 3.0 + i as f64 } else { 0.3 });
    let beam = Beam::elastic("elastic", [0, 1, 2], geometry(), undeformed, [stiffness; 2]);
    let (motion, rates) = displaced(&nodes);
    let rate = stored_rate(&beam, &motion, &rates);
    let power = power(&beam, &after(&motion, &rates, 0.0));
    assert!(
        power.abs() > 0.1 && (rate + power).abs() < 1e-8,
        "{rate} {power}"
    );
}

/// Viscous forces dissipate energy.
#[test]
fn a_viscous_beam_dissipates() {
    let nodes = beam_nodes();
    let undeformed = [&nodes[0], &nodes[1], &nodes[2]];
    let viscosity = Matrix6::from_fn(|i, j| if i == j { 2.0 } else { 0.1 });
    let laws = [(); 2].map(|()| LawKind::Viscous { viscosity }.into());
    let beam = Beam::new("viscous", [0, 1, 2], geometry(), undeformed, laws);
    let (motion, rates) = displaced(&nodes);
    assert!(power(&beam, &after(&motion, &rates, 0.0)) < -0.1);
}

fn inertia() -> BeamInertia {
    let nodes = beam_nodes();
    let undeformed = [&nodes[0], &nodes[1], &nodes[2]];
    let mass = Matrix6::from_diagonal(&Vector6::new(3.0, 3.0, 3.0, 0.5, 0.2, 0.3));
    let mass = |_| mass;
    let mass = MassAlong::smooth(&mass);
    BeamInertia::new("inertia", [0, 1, 2], geometry(), undeformed, &mass)
}

/// The velocities c x^2 of the nodes are interpolated exactly: `1/2 m c^2 L^5 / 5`; and a
/// weight along -z at the height z is m g L z.
#[test]
fn energy_of_the_inertia_of_a_beam() {
    let nodes = beam_nodes();
    let mut motion: Vec<_> = nodes.iter().map(NodeMotion::at_rest).collect();
    for node in &mut motion {
        node.velocity.z = 0.7 * node.position.x * node.position.x;
        node.position.z = 1.5;
    }
    let mut conditions = Conditions::at_rest();
    conditions.loading.gravity.z = -9.0;
    let found = energy(&inertia(), &motion, &conditions);
    let expected = 0.5 * 3.0 * 0.49 * LENGTH.powi(5) / 5.0;
    assert!((found.kinetic - expected).abs() < 1e-13, "{found:?}");
    assert!((found.gravity - 3.0 * 9.0 * LENGTH * 1.5).abs() < 1e-12);
}

/// In a rigid motion the momenta of the portions account for all of the energy.
#[test]
fn energy_of_the_inertia_of_a_beam_that_moves_as_one() {
    let nodes = beam_nodes();
    let turn = vector::to_rotation(&Vector3::new(0.3, -0.5, 0.8));
    let (omega, alpha) = (Vector3::new(0.4, -0.7, 0.9), Vector3::new(0.6, 0.2, -0.3));
    let (v, a) = (Vector3::new(0.5, 0.1, -0.8), Vector3::new(0.9, -0.4, 0.2));
    let mut motion: Vec<_> = nodes.iter().map(NodeMotion::at_rest).collect();
    let mut rates = Vec::new();
    for node in &mut motion {
        node.position = turn * node.position;
        node.rotation = turn * node.rotation;
        let carried = omega.cross(&node.position);
        let acceleration = alpha.cross(&node.position) + omega.cross(&carried);
        rates.push([v + carried, omega, a + acceleration, alpha]);
    }
    check_kinetic(&inertia(), &motion, &rates);
    let found = stored_rate(&inertia(), &motion, &rates);
    let power = power(&inertia(), &after(&motion, &rates, 0.0));
    assert!(
        power.abs() > 0.1 && (found + power).abs() < 1e-8,
        "{found} {power}"
    );
}
