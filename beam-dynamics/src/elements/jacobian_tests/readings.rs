//! Readings of elements as scalars.

use std::sync::Arc;

use nalgebra::{DMatrix, Vector6};

use super::{Random, TOLERANCE, beam_nodes, check, check_states, driven_law, geometries, nodes};
use crate::elements::beams::{Beam, BeamElectrode, Potential};
use crate::elements::circuits::Circuit;
use crate::elements::joints::{Hinge, HingeSpring, samples};
use crate::elements::springs::{End, Measure, Rod, Spring, SpringLaw};
use crate::elements::{
    Adapted, Axes, Element, JointMotion, Local, LocalJacobian, LocalResidual, LocalSize,
    Observations, Part, Queries, Reading, Sensor, SmallMotion, SpringVector,
};
use crate::model::{Conditions, NODE_UNKNOWNS, Node, NodeMotion, Quantity, Scalar, Scalars};

const PARTS: [Part; 4] = [
    Part::Component(0),
    Part::Component(1),
    Part::Component(2),
    Part::Magnitude,
];

pub(super) fn scalar() -> Scalar {
    Sensor::output("sensor", Quantity::new("number", "-", 1.0))
}

/// The readings that an element reports.
fn reported(element: &dyn Element, readings: &[Reading], undeformed: &[Node]) -> Vec<Reading> {
    let rest: Vec<_> = undeformed.iter().map(NodeMotion::at_rest).collect();
    let all = readings.iter().copied();
    let known: Vec<_> = all
        .filter(|reading| Adapted::reports(element, reading, &rest))
        .collect();
    assert!(!known.is_empty(), "{}", element.label());
    known
}

/// An element, with readings.
fn adapted(element: Arc<dyn Element>, readings: &[Reading]) -> Adapted {
    let known = readings.iter().map(|reading| (*reading, scalar()));
    Adapted::read(element, known.collect())
}

/// Checks that the equations of all readings have the values of the columns, then the derivatives: of
/// a few readings at a time, each time in another state, since each scalar adds columns to all rows.
fn check_all(
    element: impl Element + 'static,
    readings: &[Reading],
    undeformed: &[Node],
    random: &mut Random,
) {
    let element: Arc<dyn Element> = Arc::new(element);
    let known = reported(element.as_ref(), readings, undeformed);
    check_values(
        &adapted(Arc::clone(&element), &known),
        &known,
        undeformed,
        random,
    );
    for few in known.chunks(8) {
        let read = adapted(Arc::clone(&element), few);
        check_states(1, TOLERANCE, &read, undeformed, random);
    }
}

/// Checks that the equations of the readings have the values of the columns.
pub(super) fn check_values(
    element: &Adapted,
    readings: &[Reading],
    undeformed: &[Node],
    random: &mut Random,
) {
    let motion: Vec<_> = undeformed
        .iter()
        .map(|node| super::moved(random, node))
        .collect();
    let size = LocalSize::of(element);
    let mut numbers = |count: usize| (0..count).map(|_| random.number()).collect::<Vec<_>>();
    let (multipliers, mut values) = (numbers(size.multipliers), numbers(size.scalars));
    let rates = numbers(size.scalars);
    let known = element.scalars().iter();
    let count = known.filter(|scalar| scalar.owner == "sensor").count();
    let first = size.scalars - count;
    values[first..].fill(0.0);
    let mut conditions = Conditions::at_rest();
    conditions.loading.air = 1.0;
    let at = Local {
        nodes: &motion,
        multipliers: &multipliers,
        scalars: Scalars {
            values: &values,
            rates: &rates,
        },
        memory: &[],
        frame: &conditions.frame,
        loading: &conditions.loading,
    };
    let mut residual = LocalResidual::new(size);
    element.residual(&at, &mut residual);
    let mut observed = Observations::default();
    element.observe(&at, &mut observed);
    let rotation = |node: usize| motion[node].rotation;
    let expected = readings
        .iter()
        .filter_map(|reading| reading.of(&observed, rotation));
    let expected: Vec<_> = expected.collect();
    assert_eq!(expected.len(), count, "{}", element.label());
    let found = &residual.values()[size.rows() - count..];
    for (found, expected) in found.iter().zip(expected) {
        let off = (-found - expected).abs();
        assert!(
            off < 1e-12 * expected.abs().max(1.0),
            "{}: {off:e}",
            element.label()
        );
    }
}

/// Reactions on nodes in all axes.
fn reactions(nodes: usize) -> Vec<Reading> {
    let turned = Axes::Fixed(shared_geom::rotation::vector::to_rotation(
        &nalgebra::Vector3::new(0.3, -0.8, 0.5),
    ));
    let mut axes = vec![Axes::Model, turned, Axes::End(0), Axes::End(1)];
    axes.extend((0..nodes).map(Axes::Node));
    let mut all = Vec::new();
    for node in 0..nodes {
        for moment in [false, true] {
            for part in PARTS {
                all.extend(axes.iter().map(|axes| Reading::Reaction {
                    node,
                    moment,
                    part,
                    axes: *axes,
                }));
            }
        }
    }
    all
}

fn of_joints() -> Vec<Reading> {
    let motions = [
        JointMotion::Displacement,
        JointMotion::Rotation,
        JointMotion::Velocity,
        JointMotion::AngularVelocity,
    ];
    let all = motions
        .into_iter()
        .flat_map(|motion| PARTS.map(|part| (motion, part)));
    let angle = (JointMotion::Angle, Part::Component(0));
    let all = all.chain([angle]);
    all.map(|(motion, part)| Reading::Joint { motion, part })
        .collect()
}

fn of_springs() -> Vec<Reading> {
    let vectors = [
        SpringVector::Displacement,
        SpringVector::Rotation,
        SpringVector::Force,
        SpringVector::Moment,
    ];
    let all = vectors
        .into_iter()
        .flat_map(|vector| PARTS.map(|part| (vector, part)));
    all.map(|(vector, part)| Reading::Spring { vector, part })
        .collect()
}

// Every 14th of the total joints: all have the same rows.
#[test]
fn joints_and_hinges() {
    let mut random = Random(90);
    let nodes = nodes(&mut random, 2);
    for mut setting in samples::settings(&nodes, || random.vector(1.0)) {
        setting.drive = samples::signal;
        let count = 1 + usize::from(setting.ends.a.is_some());
        let joints = samples::all(&setting).into_iter().enumerate();
        for (_, joint) in joints.filter(|(i, _)| *i < 21 || i % 14 == 0) {
            let mut readings = reactions(count);
            readings.extend(of_joints());
            let own = &nodes[..count];
            check_all(joint, &readings, own, &mut Random(91));
        }
    }
    let spring = HingeSpring {
        stiffness: 0.7,
        damping: 0.4,
        angle: 0.2,
    };
    let (position, axis) = (random.vector(1.0), random.vector(1.0));
    let ends = [&nodes[0], &nodes[1]];
    let hinge = Hinge::new("hinge", [0, 1], ends, &position, &axis, spring);
    let mut readings = reactions(2);
    readings.extend(of_joints());
    check_all(hinge, &readings, &nodes, &mut random);
}

#[test]
fn springs_and_rods() {
    let mut random = Random(92);
    let nodes = nodes(&mut random, 2);
    let (position, axes) = (random.vector(1.0), random.rotation(1.0));
    let is_end = |one: &Reading| {
        let end = |axes: &Axes| matches!(axes, Axes::End(_));
        matches!(one, Reading::Reaction { axes, .. } if end(axes))
    };
    let readings = |count: usize| {
        let all = reactions(count).into_iter().filter(|one| !is_end(one));
        all.chain(of_springs()).collect::<Vec<_>>()
    };
    let apart = SpringLaw::Apart {
        displacement: Some(driven_law(&mut random, samples::signal)),
        rotation: Some(driven_law(&mut random, samples::signal)),
    };
    let together = SpringLaw::Together(driven_law(&mut random, samples::signal));
    let about = SpringLaw::of_rotation(driven_law(&mut random, samples::signal));
    for law in [apart, together, about] {
        for on in [&[0, 1][..], &[0][..]] {
            let spring = Spring::new("spring", (on, &nodes), &position, &axes, law.clone());
            let (own, readings) = (&nodes[..on.len()], readings(on.len()));
            check_all(spring, &readings, own, &mut random);
        }
    }
    for measure in [Measure::Strain, Measure::Elongation] {
        let mut end = |node| End::Node {
            node,
            offset: random.vector(0.3),
        };
        let ends = [end(0), end(1)];
        let law = driven_law(&mut random, samples::signal);
        let rod = Rod::new(
            "rod",
            ends,
            &nodes,
            Some(samples::signal(0.8)),
            (measure, law),
        );
        let readings = readings(2);
        check_all(rod, &readings, &nodes, &mut random);
    }
}

#[test]
fn sections_of_beams() {
    let mut random = Random(93);
    let nodes = beam_nodes(&mut random);
    let undeformed = [&nodes[0], &nodes[1], &nodes[2]];
    let sections = (0..24).map(|i| Reading::Section {
        point: i / 12,
        strain: i % 2 == 1,
        component: i / 2 % 6,
    });
    let readings: Vec<_> = sections.collect();
    for geometry in geometries(&mut random) {
        let laws = [(); 2].map(|()| driven_law(&mut random, samples::signal));
        let beam = Beam::new("beam", [0, 1, 2], geometry, undeformed, laws);
        let open = Circuit::Open { charge: 0.0 };
        let electrode = |potential| BeamElectrode {
            number: 0,
            potential,
            coupling: [(); 2].map(|()| Vector6::from_fn(|i, _| 0.3 - 0.1 * i as f64)),
            capacitance: 1.3,
        };
        let electrodes = vec![
            electrode(Potential::Held(samples::signal(0.7))),
            electrode(Potential::Free(open.scalars("open", 1.0).remove(0))),
        ];
        let capacitance = [(); 2].map(|()| DMatrix::from_element(2, 2, 0.4));
        let piezo = beam.with_electrodes(electrodes, capacitance);
        check_all(piezo, &readings, &nodes, &mut random);
    }
}

// The growth of the Jacobian with the loads is the growth of the element without its readings.
#[test]
fn elements_that_are_read_grow_with_the_loads() {
    let mut random = Random(95);
    let nodes = nodes(&mut random, 2);
    let [setting, _] = samples::settings(&nodes, || random.vector(1.0));
    let joint = samples::all(&setting).swap_remove(0);
    let reading = reactions(2).remove(0);
    let read = Adapted::read(Arc::new(joint.clone()), vec![(reading, scalar())]);
    let motion: Vec<_> = nodes
        .iter()
        .map(|node| super::moved(&mut random, node))
        .collect();
    let conditions = Conditions::at_rest();
    let numbers = [0.3, -0.2, 0.5, 0.1, 0.7, -0.4];
    let grown = |element: &dyn Element, scalars: &[f64]| {
        let at = Local {
            nodes: &motion,
            multipliers: &numbers,
            scalars: Scalars {
                values: scalars,
                rates: scalars,
            },
            memory: &[],
            frame: &conditions.frame,
            loading: &conditions.loading,
        };
        let small_motion = SmallMotion {
            nodes: &[[nalgebra::Vector3::x(); 2]; 2],
            multipliers: &numbers,
            scalars,
        };
        let mut out = LocalJacobian::new(LocalSize::of(element));
        element.prestress(&at, &small_motion, &mut out);
        let n = NODE_UNKNOWNS * 2 + 6;
        out.by_unknowns().view((0, 0), (n, n)).into_owned()
    };
    assert_eq!(grown(&read, &[0.2]), grown(&joint, &[]));
}

// Without a constraint its reaction is read as zero, and the other readings do not change.
#[test]
fn elements_without_some_constraints_are_read() {
    let mut random = Random(94);
    let nodes = nodes(&mut random, 2);
    for setting in samples::settings(&nodes, || random.vector(1.0)) {
        let count = 1 + usize::from(setting.ends.a.is_some());
        let joint = samples::all(&setting).swap_remove(0);
        let readings: Vec<_> = reactions(count).into_iter().step_by(3).collect();
        let readings = reported(&joint, &readings, &nodes[..count]);
        let read = adapted(Arc::new(joint), &readings);
        let reduced = Adapted::reduced(Arc::new(read), vec![1, 4]);
        check(&reduced, &nodes[..count], &mut random);
    }
}
