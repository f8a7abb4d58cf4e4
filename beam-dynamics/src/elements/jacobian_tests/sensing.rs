//! Sensors, and loads that depend on scalars.

use shared_geom::expression::{Expression, Names};

use super::{Random, beam_nodes, check, geometries, kinds};
use crate::elements::beams::DistributedLoad;
use crate::elements::loads::{NodalForce, NodalLoad};
use crate::elements::{Element, Input, Post, Sensed, Sensor, Signal};
use crate::model::{Node, Quantity, Scalar, ScalarSpec, ScalarStart};

/// Everything that can be sensed, of three nodes against each other.
fn sensors(nodes: &[Node]) -> Vec<Sensor> {
    let kinds = [
        Sensed::Position,
        Sensed::Displacement,
        Sensed::Velocity,
        Sensed::AngularVelocity,
    ];
    let post = |node, against, axes| Post {
        node,
        against,
        axes,
    };
    let anywhere = [
        post(0, None, None),
        post(1, Some(0), None),
        post(1, Some(0), Some(2)),
        post(2, None, Some(1)),
        post(2, Some(1), Some(1)),
    ];
    let turning = [
        post(1, None, None),
        post(1, None, Some(1)),
        post(0, Some(2), Some(2)),
    ];
    let mut posts: Vec<_> = anywhere
        .into_iter()
        .flat_map(|post| kinds.map(|kind| (kind, post)))
        .collect();
    posts.extend(turning.map(|post| (Sensed::Rotation, post)));
    let sensor = |(i, (kind, post)): (usize, (Sensed, Post))| {
        let label = format!("sensor {i}");
        let of = (Sensor::output(&label, kind), kind);
        Sensor::new(label, of, post, i % 3, nodes)
    };
    posts.into_iter().enumerate().map(sensor).collect()
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
    for sensor in sensors(&nodes) {
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
