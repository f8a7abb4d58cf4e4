//! Loads that sense the motion of nodes.

use shared_geom::expression::{Expression, Names};

use super::{Random, beam_nodes, check, geometries, kinds};
use crate::elements::beams::DistributedLoad;
use crate::elements::loads::{NodalForce, NodalLoad};
use crate::elements::{Element, Post, Sensed, Sensor, Signal};
use crate::model::Node;

/// A signal of everything that can be sensed, of three nodes against each other.
pub(super) fn sensing(nodes: &[Node]) -> Signal {
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
        Sensor::new(kind, post, i % 3, 0.5 + 0.1 * i as f64, nodes)
    };
    let sensors: Vec<_> = posts.into_iter().enumerate().map(sensor).collect();
    let names: Vec<_> = (0..sensors.len()).map(|i| format!("q{i}")).collect();
    let text: Vec<_> = names
        .iter()
        .enumerate()
        .map(|(i, name)| format!("sin({name}*{})/(2 + t^2)", 0.2 + 0.03 * i as f64))
        .collect();
    let variables: Vec<_> = ["t"]
        .into_iter()
        .chain(names.iter().map(String::as_str))
        .collect();
    let names = Names {
        variables: &variables,
        constants: &[],
    };
    let expression = Expression::parse(&text.join(" + "), &names).expect("a sum of known names");
    Signal::sensing(expression, sensors, [0.3, 0.7])
}

#[test]
fn loads_that_sense_nodes() {
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
        let load = NodalLoad::new("load", 0, &nodes[0], load).driven(sensing(&nodes));
        assert_eq!(load.nodes(), [0, 1, 2]);
        check(&load, &nodes, &mut random);
        let undeformed = [&nodes[0], &nodes[1], &nodes[2]];
        let [a, b] = [(); 2].map(|()| random.vector(1.0));
        let kind = (turning, factor);
        for geometry in geometries(&mut random) {
            let on = [0, 1, 2];
            let load =
                DistributedLoad::new("load", on, geometry, undeformed, kind, &[], |_| [a, b]);
            check(&load.driven(sensing(&nodes)), &nodes, &mut random);
        }
    }
}
