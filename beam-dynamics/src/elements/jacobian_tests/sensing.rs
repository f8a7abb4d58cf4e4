//! Sensors, and loads that depend on scalars.

use shared_geom::expression::{Expression, Names};

use super::{Random, beam_nodes, check, geometries, kinds};
use crate::elements::beams::DistributedLoad;
use crate::elements::loads::{NodalForce, NodalLoad};
use crate::elements::{
    Axes, Element, Input, NodeQuantity, NodeReading, NodeVector, Part, Sensor, Signal,
};
use crate::model::{Node, Quantity, Scalar, ScalarSpec, ScalarStart};

/// Every vector, of three nodes relative to each other, in all axes, and every part.
fn sensors(nodes: &[Node], random: &mut Random) -> Vec<Sensor> {
    let vectors = [
        NodeVector::Position,
        NodeVector::Displacement,
        NodeVector::Velocity,
        NodeVector::VelocityInSpace,
        NodeVector::AngularVelocity,
        NodeVector::AngularVelocityInSpace,
        NodeVector::Momentum,
        NodeVector::AngularMomentum,
        NodeVector::Rotation,
        NodeVector::Attitude,
    ];
    let fixed = Axes::Fixed(random.rotation(1.0));
    let mut sensors = Vec::new();
    for vector in vectors {
        for against in [None, Some(0), Some(2)] {
            for axes in [Axes::Model, fixed, Axes::Node(1), Axes::Node(2)] {
                for part in [Part::Component(0), Part::Component(2), Part::Magnitude] {
                    let quantity = NodeQuantity {
                        node: 1,
                        vector,
                        part,
                        against,
                        axes,
                    };
                    let label = format!("{vector:?} {part:?} against {against:?} in {axes:?}");
                    let scalar = Sensor::output(&label, Quantity::new("number", "-", 1.0));
                    let reading = NodeReading::new(&quantity, nodes);
                    sensors.push(Sensor::new(label, scalar, reading));
                }
            }
        }
    }
    sensors
}

/// A signal of time and three scalars.
pub(super) fn sensing() -> Signal {
    let names = ["t", "a", "b", "c"];
    let inputs = names[1..].iter().zip([0.5, 0.6, 0.7]).map(|(name, unit)| {
        let quantity = Quantity::new(*name, "m", 1.0);
        let scalar = Scalar::new(ScalarSpec {
            owner: "sensor".to_owned(),
            unknown: quantity.clone(),
            equation: quantity,
            has_rate: false,
            rate: None,
            start: ScalarStart::Settled,
        });
        Input { scalar, unit }
    });
    let inputs = inputs.collect();
    let names = Names {
        variables: &names,
        constants: &[],
    };
    let text = "(sin(0.2*a) + b*cos(c))/(2 + t^2)";
    let expression = Expression::parse(text, &names).expect("a sum of known names");
    Signal::sensing(expression, inputs, [0.3, 0.7])
}

#[test]
fn sensors_of_all_kinds() {
    let mut random = Random(20);
    let nodes = beam_nodes(&mut random);
    for sensor in sensors(&nodes, &mut random) {
        let own: Vec<_> = sensor.nodes().iter().map(|&i| nodes[i].clone()).collect();
        check(&sensor, &own, &mut random);
    }
}

#[test]
fn loads_that_depend_on_scalars() {
    let mut random = Random(21);
    for (turning, factor) in kinds() {
        let nodes = beam_nodes(&mut random);
        let load = NodalForce {
            force: random.vector(1.0),
            moment: random.vector(1.0),
            offset: random.vector(0.5),
            turning,
            factor,
        };
        let load = NodalLoad::new("load", 0, &nodes[0], load).driven(sensing());
        check(&load, &nodes[..1], &mut random);
        let undeformed = [&nodes[0], &nodes[1], &nodes[2]];
        let [a, b] = [(); 2].map(|()| random.vector(1.0));
        let kind = (turning, factor);
        for geometry in geometries(&mut random) {
            let on = [0, 1, 2];
            let load =
                DistributedLoad::new("load", on, geometry, undeformed, kind, &[], |_| [a, b]);
            check(&load.driven(sensing()), &nodes, &mut random);
        }
    }
}
