use std::f64::consts::FRAC_PI_2;

use approx::assert_relative_eq;
use nalgebra::{Matrix3, Vector3};
use shared_geom::rotation::vector;

use super::*;
use crate::assembly::System;
use crate::case::OutputSettings;
use crate::elements::bodies::{RigidBody, RigidInertia};
use crate::elements::joints::clamped;
use crate::elements::{Axes, Element, EnergyPart, NodeQuantity, NodeVector, Part};
use crate::model::{Conditions, Drive, Node, State};

fn node(label: &str, position: [f64; 3]) -> Node {
    Node {
        label: label.to_owned(),
        position: position.into(),
        rotation: Matrix3::identity(),
    }
}

/// A clamped node at the origin and a body at (1, 0, 0).
fn model() -> Model {
    let nodes = vec![node("root", [0.0; 3]), node("tip", [1.0, 0.0, 0.0])];
    let inertia = RigidInertia {
        mass: 2.0,
        first_moment: Vector3::zeros(),
        inertia: Matrix3::identity(),
    };
    let elements: Vec<Box<dyn Element>> = vec![
        Box::new(RigidBody::new("body", 1, inertia)),
        Box::new(clamped("clamp of root", 0, &nodes[0])),
    ];
    Model::new("columns", System::new(nodes, elements))
}

/// The tip at (1, 2, 3), turned by 90 degrees about z, in motion; a reaction at the root.
fn state(model: &Model) -> State {
    let mut state = model.system.rest();
    let tip = &mut state.nodes[1];
    tip.position = Vector3::new(1.0, 2.0, 3.0);
    tip.rotation = vector::to_rotation(&Vector3::new(0.0, 0.0, FRAC_PI_2));
    tip.velocity = Vector3::new(3.0, 4.0, 0.0);
    tip.angular_velocity = Vector3::new(0.0, 0.0, 5.0);
    tip.momentum = Vector3::new(6.0, 8.0, 0.0);
    tip.angular_momentum = Vector3::new(0.0, 0.0, 7.0);
    state.multipliers = vec![10.0, 20.0, 30.0, 40.0, 50.0, 60.0];
    state
}

fn of_tip(vector: NodeVector, part: Part, against: Option<usize>, axes: Axes) -> Quantity {
    Quantity::Node(NodeQuantity {
        node: 1,
        vector,
        part,
        against,
        axes,
    })
}

/// The value of a quantity in SI units.
fn value(quantity: Quantity) -> f64 {
    let model = model();
    let state = state(&model);
    let settings = OutputSettings {
        columns: vec![Column {
            name: "a".to_owned(),
            unit: "1".to_owned(),
            factor: 1.0,
            words: String::new(),
            quantity,
        }],
        ..OutputSettings::default()
    };
    let accepted = AcceptedStep {
        step: 3,
        time: 0.5,
        length: 0.125,
        iterations: 4,
        state: &state,
        conditions: &Conditions::at_rest(),
    };
    let mut out = [0.0];
    ColumnValues::new(&model, &settings).evaluate(&accepted, &mut out);
    out[0]
}

#[test]
fn vectors_of_nodes_are_those_of_the_state() {
    let y = Part::Component(1);
    for (vector, expected) in [
        (NodeVector::Position, 2.0),
        (NodeVector::Displacement, 2.0),
        (NodeVector::Velocity, 4.0),
        (NodeVector::VelocityInSpace, 4.0),
        (NodeVector::Momentum, 8.0),
    ] {
        assert_eq!(value(of_tip(vector, y, None, Axes::Model)), expected);
    }
    let speed = of_tip(NodeVector::Velocity, Part::Magnitude, None, Axes::Model);
    assert_eq!(value(speed), 5.0);
    let z = Part::Component(2);
    for (vector, expected) in [
        (NodeVector::Rotation, FRAC_PI_2),
        (NodeVector::Attitude, FRAC_PI_2),
        (NodeVector::AngularVelocity, 5.0),
        (NodeVector::AngularMomentum, 7.0),
    ] {
        let found = value(of_tip(vector, z, Some(0), Axes::Model));
        assert_relative_eq!(found, expected, epsilon = 1e-15);
    }
}

// The x axis of the turned tip is the y axis of the model.
#[test]
fn components_are_taken_in_the_axes_of_a_node() {
    let x = Part::Component(0);
    let found = value(of_tip(NodeVector::Position, x, None, Axes::Node(1)));
    assert_relative_eq!(found, 2.0, epsilon = 1e-15);
    let turned = Matrix3::new(0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0);
    let found = value(of_tip(NodeVector::Position, x, None, Axes::Fixed(turned)));
    assert_eq!(found, 2.0);
}

// About (0, 0, 1): 7 + (1, 2, 2) x (6, 8, 0) = (-16, 12, 3).
#[test]
fn momenta_of_the_model_are_sums() {
    assert_eq!(value(Quantity::Momentum(Part::Magnitude)), 10.0);
    for (k, expected) in [-16.0, 12.0, 3.0].into_iter().enumerate() {
        let found = value(Quantity::AngularMomentum {
            about: Vector3::z(),
            part: Part::Component(k),
        });
        assert_eq!(found, expected);
    }
}

#[test]
fn reactions_are_those_that_the_joint_reports() {
    let reaction = |moment, node, part| Quantity::Element {
        label: "clamp of root".to_owned(),
        reading: Reading::Reaction {
            node,
            moment,
            part,
            axes: Axes::Model,
        },
    };
    let model = model();
    let observed = model.system.observe(&state(&model), &Conditions::at_rest());
    let expected = &observed.reactions[0];
    assert!(expected.force.norm() > 30.0 && expected.moment.norm() > 80.0);
    for k in 0..3 {
        let part = Part::Component(k);
        assert_eq!(value(reaction(false, 0, part)), expected.force[k]);
        assert_eq!(value(reaction(true, 0, part)), expected.moment[k]);
    }
    // The clamp does not act on the tip.
    assert!(value(reaction(false, 1, Part::Magnitude)).is_nan());
}

#[test]
fn the_run_and_drives_are_reported() {
    assert_eq!(value(Quantity::StepLength), 0.125);
    assert_eq!(value(Quantity::Iterations), 4.0);
    assert_eq!(value(Quantity::Drive(Drive::Constant(9.0))), 9.0);
}

// Energies are sums over the elements; the total is the sum of the parts.
#[test]
fn energies_are_sums_of_the_elements() {
    let parts = [
        EnergyPart::Kinetic,
        EnergyPart::Elastic,
        EnergyPart::Gravity,
    ];
    let sum: f64 = parts.map(|part| value(Quantity::Energy(part))).iter().sum();
    assert_eq!(value(Quantity::Energy(EnergyPart::Total)), sum);
}
