//! Jacobians of strips with flaps, whose deflection reads scalars.

use std::f64::consts::PI;
use std::sync::Arc;

use rotor_aero::airfoil::{Airfoil, AirfoilData, Curve, Interpolation, PlainFlap, Section};
use rotor_aero::strip::{Flap, Strip, StripInflow};

use super::super::{Random, check_within, nodes};
use super::{WITHIN, air, designs, disks, geometry, rotor};
use crate::elements::Element;
use crate::elements::joints::samples;
use crate::elements::strips::AirStrip;

/// An airfoil of a table with deflections of up to 60 deg.
fn flapped() -> Section {
    let curves = |lift: f64, rise: f64| {
        let of = |flap: f64| {
            let alpha: Vec<f64> = (-36..=36).map(|k| PI / 36.0 * f64::from(k)).collect();
            Curve {
                flap: Some(flap),
                values: alpha.iter().map(|a| lift * a.sin() + rise * flap).collect(),
                alpha,
                ..Curve::default()
            }
        };
        vec![of(-1.0), of(1.0)]
    };
    let data = AirfoilData {
        name: "flapped".to_owned(),
        lift: curves(1.2, 0.8),
        drag: curves(0.1, 0.05),
        moment: curves(-0.1, -0.3),
        ..AirfoilData::default()
    };
    let airfoil = Airfoil::new(&data, Interpolation::Monotone).expect("a sound table");
    Section::single(Arc::new(airfoil))
}

/// Flaps of both kinds whose deflection reads scalars: wings, rotors, and in disks.
#[test]
fn strips_with_flaps() {
    let mut random = Random(68);
    let plain = Flap::Plain(PlainFlap::new(0.3).expect("a part"));
    let mut all: Vec<_> = designs().into_iter().map(|design| (design, None)).collect();
    let (shaft, disk) = disks(&mut random).remove(0);
    let mut in_disk = all[0].0.clone();
    in_disk.inflow = Some(StripInflow::Disk);
    all.push((in_disk, Some((shaft, disk))));
    for (mut design, disk) in all {
        for flap in [plain, Flap::OfTables] {
            if flap == Flap::OfTables {
                design.section = flapped();
            }
            let undeformed = nodes(&mut random, 2);
            let (_, mut own) = rotor(&mut random, 0, Some(1));
            if let Some((shaft, disk)) = &disk {
                own.shaft = *shaft;
                own.disk = Some(Arc::clone(disk));
            }
            let rotor = (design.inflow.is_some() || random.number() > 0.0).then_some(own);
            let element = AirStrip::on_body(
                "strip",
                (0, &undeformed[0], random.vector(1.0)),
                (
                    Arc::new(Strip::new(design.clone()).with_flap(flap)),
                    geometry(&mut random),
                ),
                rotor,
                air(&mut random),
            );
            let before = element.scalars().len();
            let element = element.deflected(samples::signal(0.2));
            assert!(element.scalars().len() > before);
            check_within(
                WITHIN,
                &element,
                &undeformed[..element.nodes().len()],
                &mut random,
            );
        }
    }
}
