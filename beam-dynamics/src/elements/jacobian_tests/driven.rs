//! Elements whose signals depend on scalars.

use nalgebra::DMatrix;

use super::{Random, beam_nodes, check, driven_law, geometries, nodes, prestressed_law};
use crate::elements::beams::{Beam, BeamElectrode, Potential};
use crate::elements::circuits::{Circuit, Electrode};
use crate::elements::joints::{Hinge, HingeSpring, samples};
use crate::elements::laws::Law;
use crate::elements::loads::{ImposedMotion, LoadFactor, imposed};
use crate::elements::springs::{End, Measure, Rod, Spring, SpringLaw};

#[test]
fn joints() {
    let mut random = Random(80);
    let nodes = nodes(&mut random, 2);
    for mut setting in samples::settings(&nodes, || random.vector(1.0)) {
        setting.drive = samples::signal;
        let count = 1 + usize::from(setting.ends.a.is_some());
        for joint in samples::all(&setting) {
            check(&joint, &nodes[..count], &mut Random(81));
        }
    }
    let motion = ImposedMotion {
        displacement: [Some(0.3), None, Some(-0.2)],
        rotation: [Some(0.4), Some(-0.5), Some(0.2)],
        axes: random.rotation(1.0),
        factor: LoadFactor::Proportional,
    };
    let imposed = imposed("imposed", 0, &nodes[0], motion);
    let imposed = imposed.scaled_by(samples::signal(0.8));
    check(&imposed, &nodes[..1], &mut random);
}

#[test]
fn hinges_and_rods() {
    let mut random = Random(82);
    let nodes = nodes(&mut random, 2);
    let ends = [&nodes[0], &nodes[1]];
    let (position, axis) = (random.vector(1.0), random.vector(1.0));
    for [stiffness, damping] in [[1.2, 0.0], [0.7, 0.4]] {
        let spring = HingeSpring {
            stiffness,
            damping,
            angle: 0.0,
        };
        let hinge = Hinge::new("hinge", [0, 1], ends, &position, &axis, spring);
        let hinge = hinge.relaxed_by(samples::signal(0.3));
        check(&hinge, &nodes, &mut random);
    }
    for measure in [Measure::Strain, Measure::Elongation] {
        let mut end = |node| End::Node {
            node,
            offset: random.vector(0.3),
        };
        let ends = [end(0), end(1)];
        let law = driven_law(&mut random, samples::signal);
        let relaxed = Some(samples::signal(0.8));
        let rod = Rod::new("rod", ends, &nodes, relaxed, (measure, law));
        check(&rod, &nodes, &mut random);
    }
}

#[test]
fn springs() {
    let mut random = Random(83);
    let nodes = nodes(&mut random, 2);
    let (position, axes) = (random.vector(1.0), random.rotation(1.0));
    let apart = SpringLaw::Apart {
        displacement: Some(driven_law(&mut random, samples::signal)),
        rotation: Some(driven_law(&mut random, samples::signal)),
    };
    let together = SpringLaw::Together(driven_law(&mut random, samples::signal));
    for law in [apart, together] {
        for on in [&[0, 1][..], &[0][..]] {
            let spring = Spring::new("spring", (on, &nodes), &position, &axes, law.clone());
            check(&spring, &nodes[..on.len()], &mut random);
        }
    }
}

#[test]
fn beams_and_their_electrodes() {
    let mut random = Random(84);
    let nodes = beam_nodes(&mut random);
    let undeformed = [&nodes[0], &nodes[1], &nodes[2]];
    for geometry in geometries(&mut random) {
        let law = |random: &mut Random| -> [Law<6>; 2] {
            let heated = prestressed_law(random, samples::signal);
            [driven_law(random, samples::signal), heated]
        };
        let beam = Beam::new("beam", [0, 1, 2], geometry, undeformed, law(&mut random));
        check(&beam, &nodes, &mut random);
        let open = Circuit::Open { charge: 0.0 };
        let electrode = |potential| BeamElectrode {
            number: 0,
            potential,
            coupling: [(); 2].map(|()| nalgebra::Vector6::from_fn(|i, _| 0.3 - 0.1 * i as f64)),
            capacitance: 1.3,
        };
        let electrodes = vec![
            electrode(Potential::Held(samples::signal(0.7))),
            electrode(Potential::Free(open.scalars("open", 1.0).remove(0))),
        ];
        let capacitance = [(); 2].map(|()| DMatrix::from_element(2, 2, 0.4));
        let piezo = beam.with_electrodes(electrodes, capacitance);
        check(&piezo, &nodes, &mut random);
    }
}

#[test]
fn circuits() {
    let mut random = Random(85);
    for inductance in [0.0, 0.6] {
        let circuit = Circuit::Shunt {
            source: samples::signal(0.4),
            resistance: 0.8,
            inductance,
        };
        let scalars = circuit.scalars("electrode", 0.5);
        let electrode = Electrode::new("electrode", 0, circuit, scalars, 0.5);
        check(&electrode, &[], &mut random);
    }
}
