//! Beams with electrodes, and circuits.

use nalgebra::{DMatrix, Vector6};

use super::{Random, beam_nodes, check, geometries};
use crate::elements::Element;
use crate::elements::beams::{Beam, BeamElectrode, Potential};
use crate::elements::circuits::{Circuit, Electrode};
use crate::model::Drive;

fn coupling(random: &mut Random) -> Vector6<f64> {
    Vector6::from_fn(|_, _| random.number())
}

/// A symmetric matrix of unit size.
fn capacitance(random: &mut Random, count: usize) -> DMatrix<f64> {
    let any = DMatrix::from_fn(count, count, |_, _| random.number());
    &any * any.transpose() + DMatrix::identity(count, count)
}

#[test]
fn beams_with_electrodes_of_all_kinds() {
    let mut random = Random(60);
    let nodes = beam_nodes(&mut random);
    for geometry in geometries(&mut random) {
        let stiffness = [random.stiffness(), random.stiffness()];
        let undeformed = [&nodes[0], &nodes[1], &nodes[2]];
        let beam = Beam::elastic("beam", [0, 1, 2], geometry, undeformed, stiffness);
        let held = Drive::Constant(0.7).scaled(random.number());
        let open = || {
            Circuit::Open { charge: 0.0 }
                .scalars("electrode", 1.0)
                .remove(0)
        };
        let free = [open(), open()];
        let potentials = [
            Potential::Free(free[1].clone()),
            Potential::Held(held.into()),
            Potential::Free(free[0].clone()),
        ];
        let electrodes = potentials.into_iter().enumerate();
        let electrodes = electrodes.map(|(number, potential)| BeamElectrode {
            number,
            potential,
            coupling: [coupling(&mut random), coupling(&mut random)],
            capacitance: 1.0 + number as f64,
        });
        let electrodes: Vec<_> = electrodes.collect();
        let capacitance = [capacitance(&mut random, 3), capacitance(&mut random, 3)];
        let piezo = beam.with_electrodes(electrodes, capacitance);
        assert_eq!(piezo.scalars(), [free[1].clone(), free[0].clone()]);
        check(&piezo, &nodes, &mut random);
    }
}

#[test]
fn circuits() {
    let mut random = Random(61);
    let source = || Drive::Constant(0.4);
    for circuit in [
        Circuit::Held(source().into()),
        Circuit::Open { charge: 0.3 },
        Circuit::Shunt {
            source: source().into(),
            resistance: 0.8,
            inductance: 0.0,
        },
        Circuit::Shunt {
            source: source().into(),
            resistance: 0.8,
            inductance: 0.6,
        },
    ] {
        let scalars = circuit.scalars("electrode", 0.5);
        let electrode = Electrode::new("electrode", 0, circuit, scalars, 0.5);
        check(&electrode, &[], &mut random);
    }
}
