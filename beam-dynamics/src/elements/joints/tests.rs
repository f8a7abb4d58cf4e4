//! Growth of the tangent with the moments of springs, at fixed geometry.

use nalgebra::{Matrix3, Vector3};
use shared_geom::rotation::vector;

use super::{Hinge, HingeSpring};
use crate::elements::springs::{SupportFrame, SupportLaw, SupportSpring};
use crate::elements::{
    Element, Local, LocalJacobian, LocalSize, Observations, Queries, SmallMotion,
};
use crate::model::{Conditions, Drive, Node, NodeMotion, Scalars};

fn node(x: f64) -> Node {
    Node {
        label: format!("at {x}"),
        position: Vector3::new(x, 0.0, 0.0),
        rotation: Matrix3::identity(),
    }
}

/// Jacobian by the unknowns, or with `motion` its growth.
fn tangent(
    element: &dyn Element,
    nodes: &[NodeMotion],
    motion: Option<&[[Vector3<f64>; 2]]>,
) -> nalgebra::DMatrix<f64> {
    let conditions = Conditions::at_rest();
    let multipliers = [0.3, -0.2, 0.5, 0.7, -0.4];
    let multipliers = &multipliers[..element.multipliers()];
    let at = Local {
        nodes,
        multipliers,
        scalars: Scalars::NONE,
        memory: &[],
        frame: &conditions.frame,
        loading: &conditions.loading,
    };
    let mut out = LocalJacobian::new(LocalSize::without_scalars(nodes.len(), multipliers.len()));
    match motion {
        None => element.jacobian(&at, &mut out),
        Some(nodes) => {
            let multipliers = &vec![0.0; multipliers.len()];
            let motion = SmallMotion {
                nodes,
                multipliers,
                scalars: &[],
            };
            element.prestress(&at, &motion, &mut out);
        }
    }
    out.by_unknowns().clone()
}

// The moment k (phi - phi_0) grows at fixed geometry when phi_0 falls: the growth along a relative
// rotation by delta about the hinge is the moment of a spring relaxed delta lower. Linear in the
// moment: round-off of terms of order one.
#[test]
fn growth_with_the_spring_of_a_hinge() {
    let nodes = [node(0.0), node(1.0)];
    let axis = Vector3::new(0.3, -0.5, 0.8);
    let hinge = |angle: f64| {
        let spring = HingeSpring {
            stiffness: 1.7,
            damping: 0.0,
            angle,
        };
        let ends = [&nodes[0], &nodes[1]];
        Hinge::new("hinge", [0, 1], ends, &nodes[1].position, &axis, spring)
    };
    let unit = axis.normalize();
    let mut motion = [
        NodeMotion::at_rest(&nodes[0]),
        NodeMotion::at_rest(&nodes[1]),
    ];
    motion[1].rotation = vector::to_rotation(&(0.6 * unit));
    let zero = Vector3::zeros();
    let along = [[zero, 0.1 * unit], [zero, 0.35 * unit]];
    let growth = tangent(&hinge(0.2), &motion, Some(&along));
    let expected = tangent(&hinge(0.2 - 0.25), &motion, None) - tangent(&hinge(0.2), &motion, None);
    assert!(expected.amax() > 0.1);
    assert!((growth - expected).amax() < 1e-14);
}

// J = -T^-T K T^-1 + (part linear in the moment q = K psi). Along theta = s psi the moment
// grows by s q, and the second part by s of itself.
#[test]
fn growth_with_the_moment_of_a_support() {
    let node = node(0.0);
    let axes = vector::to_rotation(&Vector3::new(0.2, 0.5, -0.3));
    let law = SupportLaw::along(&axes, &[1.0, 2.0, 3.0, 4.0, 5.0, 6.0], &[0.0; 6]);
    let support = SupportSpring::new("support", 0, &node, law, SupportFrame::Frame);
    let psi = Vector3::new(0.4, -0.3, 0.6);
    let mut motion = [NodeMotion::at_rest(&node)];
    motion[0].rotation = vector::to_rotation(&psi);
    let inverse = vector::tangent_inverse(&psi);
    let elastic = -inverse.transpose() * law.turning_stiffness * inverse;
    let whole = tangent(&support, &motion, None);
    let expected = 0.5 * (whole.fixed_view::<3, 3>(9, 3) - elastic);
    let growth = tangent(&support, &motion, Some(&[[Vector3::zeros(), 0.5 * psi]]));
    assert!(expected.amax() > 0.1);
    assert!((growth.fixed_view::<3, 3>(9, 3) - expected).amax() < 1e-14);
}

// The relaxed angle follows a drive, over any number of turns: the moment is the moment of the
// angle without full turns.
#[test]
fn the_relaxed_angle_of_a_spring_follows_a_drive() {
    let nodes = [node(0.0), node(1.0)];
    let axis = Vector3::z();
    let spring = HingeSpring {
        stiffness: 1.7,
        damping: 0.0,
        angle: 0.0,
    };
    let ends = [&nodes[0], &nodes[1]];
    let hinge = Hinge::new("hinge", [0, 1], ends, &nodes[1].position, &axis, spring);
    let mut motion = [
        NodeMotion::at_rest(&nodes[0]),
        NodeMotion::at_rest(&nodes[1]),
    ];
    motion[1].rotation = vector::to_rotation(&(0.6 * axis));
    let conditions = Conditions::at_rest();
    let at = Local {
        nodes: &motion,
        multipliers: &[0.0; 5],
        scalars: Scalars::NONE,
        memory: &[],
        frame: &conditions.frame,
        loading: &conditions.loading,
    };
    for turns in [-2.0, 0.0, 3.0] {
        let angle = 0.2 + turns * std::f64::consts::TAU;
        let driven = hinge.clone().relaxed_by(Drive::Constant(angle));
        let mut observed = Observations::default();
        driven.observe(&at, &mut observed);
        let moment = observed.joints[0].moment.z;
        assert!((moment + 1.7 * 0.4).abs() < 1e-14, "{moment}");
        let energy = driven.energy(&at).elastic;
        assert!((energy - 0.5 * 1.7 * 0.16).abs() < 1e-14, "{energy}");
    }
}
