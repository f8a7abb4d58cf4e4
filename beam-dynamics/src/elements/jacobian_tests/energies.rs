//! Energies of elements as scalars.

use std::sync::Arc;

use nalgebra::{Matrix3, Vector3};

use super::{Random, beam_nodes, check, geometries, laws, nodes};
use crate::elements::beams::{Beam, BeamInertia, MassAlong};
use crate::elements::bodies::{RigidBody, RigidInertia};
use crate::elements::joints::{Hinge, HingeSpring, samples};
use crate::elements::laws::Law;
use crate::elements::springs::{End, Measure, Rod, Spring, SpringLaw};
use crate::elements::springs::{SupportFrame, SupportLaw, SupportSpring};
use crate::elements::{
    Adapted, Element, EnergyPart, EnergySlope, Local, LocalResidual, LocalSize, Queries, Reading,
    Sensor,
};
use crate::model::{Conditions, Node, Quantity, Scalars};

const PARTS: [EnergyPart; 4] = [
    EnergyPart::Kinetic,
    EnergyPart::Elastic,
    EnergyPart::Gravity,
    EnergyPart::Total,
];

/// Checks the shares of an element in energies, and their derivatives.
fn check_shares(element: impl Element + 'static, undeformed: &[Node], random: &mut Random) {
    let slope = element.energetic().map(|own| own.slope());
    assert_ne!(slope, Some(EnergySlope::Unknown), "{}", element.label());
    let scalar = || Sensor::output("sensor", Quantity::new("energy", "J", 1.0));
    let readings = PARTS.map(|part| (Reading::Energy(part), scalar()));
    let read = Adapted::read(Arc::new(element), readings.into());
    check(&read, undeformed, random);

    let motion: Vec<_> = undeformed
        .iter()
        .map(|node| super::moved(random, node))
        .collect();
    let multipliers = vec![0.3; read.multipliers()];
    let scalars = vec![0.7; read.scalars().len()];
    let conditions = Conditions::at_rest();
    let at = Local {
        nodes: &motion,
        multipliers: &multipliers,
        scalars: Scalars {
            values: &scalars,
            rates: &scalars,
        },
        memory: &[],
        frame: &conditions.frame,
        loading: &conditions.loading,
    };
    let size = LocalSize::of(&read);
    let mut residual = LocalResidual::new(size);
    read.residual(&at, &mut residual);
    let energy = read.energy(&at);
    let found = &residual.values()[size.rows() - PARTS.len()..];
    for (found, part) in found.iter().zip(PARTS) {
        assert_eq!(*found, -energy.part(part), "{} {part:?}", read.label());
    }
}

#[test]
fn of_motion() {
    let mut random = Random(120);
    for _ in 0..10 {
        let own = nodes(&mut random, 1);
        let central = Matrix3::from_diagonal(&Vector3::new(0.5, 0.7, 0.9));
        let inertia = RigidInertia::about_node(1.3, &random.vector(0.5), &central);
        check_shares(RigidBody::new("body", 0, inertia), &own, &mut random);

        let own = beam_nodes(&mut random);
        let [geometry, ..] = geometries(&mut random);
        let (root, tip) = (random.mass(), random.mass());
        let ends = [&own[0], &own[1], &own[2]];
        let mass = |xi: f64| 0.5 * (1.0 - xi) * root + 0.5 * (1.0 + xi) * tip;
        let mass = MassAlong::smooth(&mass);
        let inertia = BeamInertia::new("inertia", [0, 1, 2], geometry, ends, &mass);
        check_shares(inertia, &own, &mut random);
    }
}

#[test]
fn of_beams() {
    let mut random = Random(121);
    let [elastic, viscous] = laws(&mut random);
    for law in [elastic, viscous] {
        let own = beam_nodes(&mut random);
        let ends = [&own[0], &own[1], &own[2]];
        let laws = || [law.clone(), Law::linear(Random(122).stiffness())];
        let [variational, volumes, _] = geometries(&mut random);
        let beam = Beam::new("beam", [0, 1, 2], variational, ends, laws());
        check_shares(beam, &own, &mut random);
        let volumes = Beam::new("beam", [0, 1, 2], volumes, ends, laws());
        let slope = volumes.energetic().map(|own| own.slope());
        assert_eq!(slope, Some(EnergySlope::Unknown));
    }
}

#[test]
fn of_springs() {
    let mut random = Random(123);
    let own = nodes(&mut random, 2);
    let (position, axes) = (random.vector(1.0), random.rotation(1.0));
    let [elastic, viscous] = laws(&mut random);
    let apart = SpringLaw::Apart {
        displacement: Some(laws(&mut random)[1].clone()),
        rotation: Some(laws(&mut random)[0].clone()),
    };
    let together = [elastic, viscous].map(SpringLaw::Together);
    for law in together.into_iter().chain([apart]) {
        for on in [&[0, 1][..], &[0][..]] {
            let spring = Spring::new("spring", (on, &own), &position, &axes, law.clone());
            check_shares(spring, &own[..on.len()], &mut random);
        }
    }
    for law in laws(&mut random) {
        let ends = [0, 1].map(|node| End::Node {
            node,
            offset: random.vector(0.3),
        });
        let rod = Rod::new("rod", ends, &own, None, (Measure::Strain, law));
        check_shares(rod, &own, &mut random);
    }
    let spring = HingeSpring {
        stiffness: 0.7,
        damping: 0.4,
        angle: 0.2,
    };
    let ends = [&own[0], &own[1]];
    let hinge = Hinge::new(
        "hinge",
        [0, 1],
        ends,
        &position,
        &random.vector(1.0),
        spring,
    );
    check_shares(hinge.clone(), &own, &mut random);
    check_shares(hinge.relaxed_by(samples::signal(0.4)), &own, &mut random);
    let law = SupportLaw::along(&axes, &[1.0, 2.0, 3.0, 0.5, 0.7, 0.9], &[0.4; 6]);
    for support_frame in [SupportFrame::Frame, SupportFrame::World] {
        let support = SupportSpring::new("support", 0, &own[0], law, support_frame);
        check_shares(support, &own[..1], &mut random);
    }
}
