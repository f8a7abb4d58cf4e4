//! Rods, springs and forces between nodes against closed forms; a rigid motion causes no force, and
//! their forces balance.

use nalgebra::{Matrix1, Matrix3, Matrix6, Vector3};
use shared_geom::rotation::{skew, vector};

use super::{End, Measure, Rod, Spring, SpringLaw};
use crate::elements::laws::{Cubic, Driven, Law, LawKind, Term};
use crate::elements::loads::{Between, InternalForce, LoadFactor};
use crate::elements::{Element, Local, LocalResidual, LocalSize, Observations, Queries, Signal};
use crate::model::{
    Conditions, Drive, NODE_UNKNOWNS, Node, NodeMotion, Ramp, Scalars, TurningFrame,
};

fn nodes() -> Vec<Node> {
    let node = |label: &str, position: [f64; 3], turn: [f64; 3]| Node {
        label: label.to_owned(),
        position: position.into(),
        rotation: vector::to_rotation(&turn.into()),
    };
    vec![
        node("a", [0.0, 0.0, 0.0], [0.1, -0.4, 0.3]),
        node("b", [2.0, 0.3, -0.4], [-0.5, 0.2, 0.6]),
    ]
}

/// A state in which everything moves.
fn moved(nodes: &[Node]) -> Vec<NodeMotion> {
    let mut motion: Vec<_> = nodes.iter().map(NodeMotion::at_rest).collect();
    for (i, node) in motion.iter_mut().enumerate() {
        let i = i as f64;
        node.position += Vector3::new(0.2 - 0.1 * i, 0.3 * i, -0.1);
        node.rotation = vector::to_rotation(&Vector3::new(0.3 * i, -0.2, 0.4 * i)) * node.rotation;
        node.velocity = Vector3::new(0.5, -0.7 * i, 0.2);
        node.angular_velocity = Vector3::new(-0.3 * i, 0.8, 0.6 * i);
    }
    motion
}

/// Constant loads in full.
fn loaded() -> Conditions {
    let mut conditions = Conditions::at_rest();
    conditions.loading.constant = 1.0;
    conditions
}

/// Force and moment on each node.
fn forces(element: &dyn Element, motion: &[NodeMotion]) -> Vec<[Vector3<f64>; 2]> {
    let mut out = LocalResidual::new(LocalSize::without_scalars(motion.len(), 0));
    element.residual(&local(motion, &loaded()), &mut out);
    let part = |first: usize| Vector3::from_column_slice(&out.values()[first..first + 3]);
    let first = (0..motion.len()).map(|node| NODE_UNKNOWNS * node);
    first
        .map(|first| [part(first + 6), part(first + 9)])
        .collect()
}

fn local<'a>(motion: &'a [NodeMotion], conditions: &'a Conditions) -> Local<'a> {
    Local {
        nodes: motion,
        multipliers: &[],
        scalars: Scalars::NONE,
        memory: &[],
        frame: &conditions.frame,
        loading: &conditions.loading,
    }
}

fn viscoelastic<const N: usize>() -> Law<N> {
    let cubic = Cubic {
        first: 2.0,
        second: 0.5,
        third: 3.0,
    };
    let viscosity = 0.7 * nalgebra::SMatrix::identity();
    Law::sum(vec![
        LawKind::Cubic([cubic; N]).into(),
        LawKind::Viscous { viscosity }.into(),
    ])
}

/// Each kind of element between two nodes.
fn elements(nodes: &[Node]) -> Vec<Box<dyn Element>> {
    let ends = [0, 1].map(|node| End::Node {
        node,
        offset: Vector3::new(0.1, -0.2, 0.05),
    });
    let (position, axes) = (Vector3::new(1.0, 0.5, 0.2), nodes[0].rotation);
    let on = || (&[0, 1][..], nodes);
    let line = Between::Line { ends, tension: 1.5 };
    let between_axes = Between::Axes {
        nodes: [0, 1],
        offset: Vector3::new(0.3, 0.1, 0.0),
        force: Vector3::new(1.0, -2.0, 0.5),
        moment: Vector3::new(0.2, 0.4, -0.6),
    };
    let force = |between| {
        InternalForce::new(
            "force",
            nodes,
            between,
            LoadFactor::Constant,
            Signal::default(),
        )
    };
    let coupled = Law::linear(Matrix6::from_fn(|i, j| if i == j { 3.0 } else { 0.4 }));
    let [along, about] = [SpringLaw::of_displacement, SpringLaw::of_rotation];
    vec![
        Box::new(Rod::new(
            "rod",
            ends,
            nodes,
            None,
            (Measure::Strain, viscoelastic()),
        )),
        Box::new(Spring::new(
            "along",
            on(),
            &position,
            &axes,
            along(viscoelastic()),
        )),
        Box::new(Spring::new(
            "about",
            on(),
            &position,
            &axes,
            about(viscoelastic()),
        )),
        Box::new(Spring::new("coupled", on(), &position, &axes, coupled)),
        Box::new(force(line)),
        Box::new(force(between_axes)),
    ]
}

/// Forces of size three at arms of size two: round-off is a few times 1e-15 of them.
#[test]
fn forces_on_both_nodes_balance() {
    let nodes = nodes();
    let motion = moved(&nodes);
    for element in elements(&nodes) {
        let found = forces(element.as_ref(), &motion);
        let force = found[0][0] + found[1][0];
        let about_origin = |i: usize| found[i][1] + motion[i].position.cross(&found[i][0]);
        let moment = about_origin(0) + about_origin(1);
        let size = found[0][0].norm() + found[0][1].norm();
        assert!(size > 0.01, "{} {size}", element.label());
        let off = force.norm().max(moment.norm());
        assert!(off < 3e-14, "{} {off:e}", element.label());
    }
}

/// A superposed rigid motion, with its velocities, only turns the forces: positions of order ten,
/// round-off 1e-15 of them.
#[test]
fn a_superposed_rigid_motion_turns_the_forces() {
    let nodes = nodes();
    let motion = moved(&nodes);
    let turn = vector::to_rotation(&Vector3::new(1.0, -2.0, 0.7));
    let shift = Vector3::new(3.0, -1.0, 2.0);
    let (speed, spin) = (Vector3::new(0.3, 0.9, -0.4), Vector3::new(0.7, -1.1, 0.4));
    let mut superposed = motion.clone();
    for node in &mut superposed {
        node.position = turn * node.position + shift;
        node.rotation = turn * node.rotation;
        node.velocity = turn * node.velocity + speed + spin.cross(&node.position);
        node.angular_velocity = turn * node.angular_velocity + spin;
    }
    for element in elements(&nodes) {
        let before = forces(element.as_ref(), &motion);
        let after = forces(element.as_ref(), &superposed);
        for (before, after) in before.iter().zip(&after) {
            for (before, after) in before.iter().zip(after) {
                let error = (turn * before - after).norm();
                assert!(error < 3e-14, "{} {error:e}", element.label());
            }
        }
        if element.label() == "force" {
            continue;
        }
        let at_rest: Vec<_> = nodes.iter().map(NodeMotion::at_rest).collect();
        let carried = at_rest.into_iter().map(|mut node| {
            node.position = turn * node.position + shift;
            node.rotation = turn * node.rotation;
            node.velocity = speed + spin.cross(&node.position);
            node.angular_velocity = spin;
            node
        });
        let carried = forces(element.as_ref(), &carried.collect::<Vec<_>>());
        let none = |force: &[Vector3<f64>; 2]| force.iter().all(|f| f.norm() < 3e-14);
        assert!(carried.iter().all(none), "{}", element.label());
    }
}

/// EA e along the line, with the moments of the offsets; the length is 5, 4 relaxed.
#[test]
fn a_rod_pulls_with_the_force_of_its_law() {
    let nodes = nodes();
    let [first, second] = [Vector3::new(0.0, 0.2, 0.0), Vector3::new(-0.1, 0.0, 0.3)];
    let ends = [(0, first), (1, second)].map(|(node, offset)| End::Node { node, offset });
    let law = LawKind::Viscoelastic {
        stiffness: Matrix1::new(100.0),
        viscosity: Matrix1::new(8.0),
    };
    for (measure, scale) in [(Measure::Strain, 4.0), (Measure::Elongation, 1.0)] {
        let law = (measure, Law::from(law.clone()));
        let rod = Rod::new("rod", ends, &nodes, Some(Drive::Constant(4.0).into()), law);
        let mut motion: Vec<_> = nodes.iter().map(NodeMotion::at_rest).collect();
        let along = Vector3::new(3.0, 0.0, 4.0);
        motion[0].position = -(motion[0].rotation * first);
        motion[1].position = along - motion[1].rotation * second;
        motion[1].velocity = Vector3::new(1.0, 7.0, 0.5);
        let tension = (100.0 * 1.0 + 8.0 * (0.6 * 1.0 + 0.8 * 0.5)) / scale;
        let pull = tension * along / 5.0;
        let found = forces(&rod, &motion);
        let arms = [motion[0].rotation * first, motion[1].rotation * second];
        for (node, sign) in [(0, 1.0), (1, -1.0)] {
            assert!((found[node][0] - sign * pull).norm() < 1e-12);
            assert!((found[node][1] - sign * arms[node].cross(&pull)).norm() < 1e-12);
        }
        let mut seen = Observations::default();
        let conditions = Conditions::at_rest();
        rod.observe(&local(&motion, &conditions), &mut seen);
        let state = &seen.springs[0];
        assert!((state.force.x - tension).abs() < 1e-12);
        assert!((state.displacement.x - 1.0).abs() < 1e-14);
        assert!((state.axes.column(0) - along / 5.0).norm() < 1e-15);
        let energy = rod.energy(&local(&motion, &conditions)).elastic;
        assert!((energy - 0.5 * 100.0 / scale).abs() < 1e-12);
    }
}

/// A relaxed length that grows by 0.3 m/s changes the elongation and its rate; a strain is also
/// relative to it: e = l/l_0 - 1, e' = l'/l_0 - l l_0'/l_0^2.
#[test]
fn a_rod_whose_relaxed_length_grows() {
    let nodes = nodes();
    let ends = [0, 1].map(|node| End::Node {
        node,
        offset: Vector3::zeros(),
    });
    let law = LawKind::Viscoelastic {
        stiffness: Matrix1::new(100.0),
        viscosity: Matrix1::new(8.0),
    };
    let ramp = Drive::Ramp(Ramp {
        from: 4.0,
        to: 7.0,
        start: 0.0,
        end: 10.0,
        smooth: false,
    });
    let mut conditions = loaded();
    conditions.loading.time = 2.0;
    let (l, l_rate, rest, rest_rate) = (5.0, 1.4, 4.6, 0.3);
    let strain = [
        l / rest - 1.0,
        l_rate / rest - l * rest_rate / (rest * rest),
    ];
    let elongation = [l - rest, l_rate - rest_rate];
    for (measure, [e, e_rate]) in [(Measure::Strain, strain), (Measure::Elongation, elongation)] {
        let law = (measure, Law::from(law.clone()));
        let rod = Rod::new("rod", ends, &nodes, Some(ramp.clone().into()), law);
        let mut motion: Vec<_> = nodes.iter().map(NodeMotion::at_rest).collect();
        motion[0].position = Vector3::zeros();
        motion[1].position = Vector3::new(3.0, 0.0, 4.0);
        motion[1].velocity = Vector3::new(1.0, 7.0, 1.0);
        let mut seen = Observations::default();
        rod.observe(&local(&motion, &conditions), &mut seen);
        let tension = 100.0 * e + 8.0 * e_rate;
        assert!((seen.springs[0].force.x - tension).abs() < 1e-12);
        assert!((seen.springs[0].displacement.x - (l - rest)).abs() < 1e-14);
        assert_eq!(rod.domain(), Drive::ALWAYS);
        assert_eq!(rod.next_corner(3.0), 10.0);
    }
}

/// If its relaxed length is zero or less, the force of a rod is undefined, and the reason is
/// reported.
#[test]
fn a_rod_without_a_relaxed_length_has_no_value() {
    let nodes = nodes();
    let ends = [0, 1].map(|node| End::Node {
        node,
        offset: Vector3::zeros(),
    });
    let motion: Vec<_> = nodes.iter().map(NodeMotion::at_rest).collect();
    let ramp = Drive::Ramp(Ramp {
        from: 1.0,
        to: -1.0,
        start: 0.0,
        end: 1.0,
        smooth: false,
    });
    for measure in [Measure::Strain, Measure::Elongation] {
        let law = (measure, viscoelastic());
        let rod = Rod::new("rod", ends, &nodes, Some(ramp.clone().into()), law);
        for (time, has_value) in [(0.4, true), (0.5, false), (0.75, false)] {
            let mut conditions = loaded();
            conditions.loading.time = time;
            let at = local(&motion, &conditions);
            let mut out = LocalResidual::new(LocalSize::without_scalars(2, 0));
            rod.residual(&at, &mut out);
            let found = out.values().iter().all(|value| value.is_finite());
            assert_eq!(found, has_value, "{time}");
            assert_eq!(rod.without_value(&at).is_none(), has_value, "{time}");
        }
        let mut conditions = loaded();
        conditions.loading.time = 0.75;
        let why = rod.without_value(&local(&motion, &conditions));
        let expected = "its relaxed length is zero or less: -5.000e-1 m at 0.75 s";
        assert_eq!(why.as_deref(), Some(expected));
    }
}

/// About one axis the moment is k phi at every angle, and the force is in the axes of the
/// turned first node.
#[test]
fn a_spring_acts_in_the_axes_of_its_first_node() {
    let nodes = nodes();
    let (position, axes) = (nodes[1].position, Matrix3::identity());
    let law = SpringLaw::Apart {
        displacement: Some(Law::linear(Matrix3::from_diagonal(&Vector3::new(
            2.0, 3.0, 5.0,
        )))),
        rotation: Some(Law::linear(Matrix3::identity() * 7.0)),
    };
    let spring = Spring::new("spring", (&[0, 1], &nodes), &position, &axes, law);
    let turn = vector::to_rotation(&Vector3::new(0.0, 0.0, 0.5));
    let relative = vector::to_rotation(&(turn * Vector3::new(0.0, 2.5, 0.0)));
    let displacement = Vector3::new(0.1, -0.2, 0.3);
    let mut motion: Vec<_> = nodes.iter().map(NodeMotion::at_rest).collect();
    motion[0].rotation = turn * motion[0].rotation;
    motion[1].position = turn * (motion[1].position + displacement);
    motion[1].rotation = relative * turn * motion[1].rotation;
    let found = forces(&spring, &motion);
    let force = turn * Vector3::new(0.2, -0.6, 1.5);
    let moment = turn * Vector3::new(0.0, 17.5, 0.0);
    assert!((found[1][0] + force).norm() < 1e-14);
    assert!((found[1][1] + moment).norm() < 1e-13);
    assert!((found[0][1] - motion[1].position.cross(&force) - moment).norm() < 1e-13);
}

/// A prestrain shifts the relaxed position, a prestress pushes away from it: the spring is at rest
/// at x = 0.1 - 0.6 / 2.
#[test]
fn prestrain_and_prestress_move_the_position_of_rest() {
    let nodes = nodes();
    let driven = |x: f64| {
        Some(Driven {
            vector: Vector3::new(x, 0.0, 0.0),
            signal: Drive::Constant(1.0).into(),
        })
    };
    let law = Law::sum(vec![Term {
        kind: LawKind::Linear {
            stiffness: Matrix3::identity() * 2.0,
        },
        prestrain: driven(0.1),
        prestress: driven(0.6),
    }]);
    let axes = Matrix3::identity();
    let law = SpringLaw::of_displacement(law);
    let spring = Spring::new("spring", (&[1], &nodes), &nodes[1].position, &axes, law);
    let mut motion = vec![NodeMotion::at_rest(&nodes[1])];
    assert!((forces(&spring, &motion)[0][0].x + 0.4).abs() < 1e-15);
    motion[0].position.x += 0.1 - 0.3;
    let found = forces(&spring, &motion);
    assert!(found[0][0].norm() < 1e-15 && found[0][1].norm() < 1e-15);
}

/// A spring to the frame is the support of the same stiffness and damping, to round-off.
#[test]
fn a_spring_to_the_frame_is_a_support() {
    use super::{SupportFrame, SupportLaw, SupportSpring};
    let nodes = nodes();
    let axes = vector::to_rotation(&Vector3::new(0.4, 0.1, -0.3));
    let stiffness = [1.0, 2.0, 3.0, 0.5, 0.7, 0.9];
    let damping = [0.4, 0.3, 0.2, 0.6, 0.5, 0.1];
    let support = SupportLaw::along(&axes, &stiffness, &damping);
    let support = SupportSpring::new("support", 1, &nodes[1], support, SupportFrame::Frame);
    let matrix = |values: [f64; 6]| Matrix6::from_diagonal(&values.into());
    let law = LawKind::Viscoelastic {
        stiffness: matrix(stiffness),
        viscosity: matrix(damping),
    };
    let position = nodes[1].position;
    let spring = Spring::new("s", (&[1], &nodes), &position, &axes, Law::from(law));
    let motion = [moved(&nodes)[1]];
    let [found, expected] = [&spring as &dyn Element, &support].map(|e| forces(e, &motion));
    for k in 0..2 {
        assert!(expected[0][k].norm() > 0.1);
        assert!((found[0][k] - expected[0][k]).norm() < 1e-14);
    }
    let energy = |element: &dyn Element| {
        let conditions = Conditions::turning(TurningFrame::at_rest());
        element.energy(&local(&motion, &conditions)).elastic
    };
    assert!((energy(&spring) - energy(&support)).abs() < 1e-14);
}

/// A tension pulls the points together; forces in axes turn with the first node.
#[test]
fn forces_between_nodes_follow_their_line_and_their_node() {
    let nodes = nodes();
    let force = Vector3::new(1.0, 0.0, 0.0);
    let moment = Vector3::new(0.0, 2.0, 0.0);
    let between = Between::Axes {
        nodes: [0, 1],
        offset: Vector3::zeros(),
        force,
        moment,
    };
    let drive = Signal::Drive(Drive::Constant(3.0));
    let internal = InternalForce::new("f", &nodes, between, LoadFactor::Proportional, drive);
    let turn = vector::to_rotation(&Vector3::new(0.0, 0.0, 0.8));
    let mut motion: Vec<_> = nodes.iter().map(NodeMotion::at_rest).collect();
    motion[0].rotation = turn * motion[0].rotation;
    let mut conditions = Conditions::at_rest();
    conditions.loading.proportional = 0.5;
    let mut out = LocalResidual::new(LocalSize::without_scalars(2, 0));
    internal.residual(&local(&motion, &conditions), &mut out);
    let part = |first: usize| Vector3::from_column_slice(&out.values()[first..first + 3]);
    let [force, moment] = [force, moment].map(|vector| 1.5 * (turn * vector));
    assert!((part(18) - force).norm() < 1e-15 && (part(21) - moment).norm() < 1e-15);
    let arm = skew(&(motion[1].position - motion[0].position));
    assert!((part(6) + force).norm() < 1e-15);
    assert!((part(9) + moment + arm * force).norm() < 1e-14);
}
