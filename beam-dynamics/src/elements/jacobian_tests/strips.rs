//! Jacobians of strips in the air: every model of the section and every inflow, in attached and
//! stalled flow, on beams of all formulations and on bodies, with and without a moving hub.

use std::sync::Arc;

use rotor_aero::airfoil::{Section, built_in};
use rotor_aero::inflow::{Disk, InflowModel};
use rotor_aero::momentum::{HighInduction, Options};
use rotor_aero::strip::{AnnularInflow, SectionModel, Strip, StripDesign, StripInflow, Wake};
use rotor_aero::wake::{Forcing, TimeScale};
use rotor_aero::wind::{
    Atmosphere, Event, EventShape, GustShape, Mean, MeanWind, Tower, TowerPotential, TowerShadow,
    TravelingGust, Wind,
};

use nalgebra::Vector3;

use super::{Random, beam_nodes, check, check_states, check_within, geometries, nodes};
use crate::elements::strips::{
    Air, AirStrip, DiskInflow, Ground, RotorDisk, Shaft, StripGeometry, StripRotor, TipRadius,
};
use crate::elements::{Adapted, Element, Reading, RotorSum};

mod flaps;

/// Tables of airfoils are continuous with their first derivatives only: a difference across a knot is
/// off by the step, 1e-6, times half of the jump of the curvature, which is some hundred per square
/// radian at the stall. A missing term is of the order of one.
const WITHIN: f64 = 1e-4;

/// Air of low speed of sound.
fn atmosphere() -> Atmosphere {
    Atmosphere {
        density: 1.2,
        sound_speed: 40.0,
        viscosity: 1e-5,
        ..Atmosphere::default()
    }
}

/// The air, with a wind.
fn air(random: &mut Random) -> Arc<Air> {
    let velocity = Vector3::new(8.0, 6.0, 2.0) + random.vector(1.0);
    let wind = Wind::uniform(&velocity, Vector3::z()).expect("a sound sample");
    Arc::new(Air::new(atmosphere(), wind))
}

/// The air with a wind that varies in space and time. Its speed is well above the velocities of
/// the nodes: at speeds near zero the third derivatives of the angle of attack, of the order of the
/// inverse speed cubed, exceed the tolerance of the differences.
fn gusty_air(random: &mut Random) -> Arc<Air> {
    let velocity = Vector3::new(8.0, 6.0, 2.0) + random.vector(1.0);
    let mut wind = Wind::uniform(&velocity, Vector3::z()).expect("a sound sample");
    if let Mean::Steady(mean) = &mut wind.mean {
        *mean = MeanWind {
            reference_height: 10.0,
            veer: 0.2,
            horizontal_shear: 0.5,
            vertical_shear: -0.7,
            upflow: 0.1,
            ..*mean
        };
    }
    wind.gusts.push(TravelingGust {
        shape: GustShape::OneMinusCosine { length: 40.0 },
        velocity: random.vector(1.0).into(),
        direction: random.vector(1.0).normalize().into(),
        convection: 2.0,
        front: 20.0,
    });
    wind.events.push(Event {
        start: -2.0,
        shape: EventShape::VerticalShear {
            amplitude: 2.0,
            diameter: 3.0,
            hub_height: 1.0,
        },
    });
    let radii = vec![[-20.0, 1.5], [20.0, 1.0]];
    let models = (TowerPotential::Cylinder, TowerShadow::None);
    wind.towers
        .push(Tower::new([6.0, 5.0], radii, 0.5, models.0, models.1).expect("a sound sample"));
    Arc::new(Air::new(atmosphere(), wind))
}

/// Designs of every model and inflow.
fn designs() -> Vec<StripDesign> {
    let annular = |wake, high_induction| {
        Some(StripInflow::Annular(AnnularInflow {
            blades: 3,
            hub_radius: 0.01,
            options: Options {
                high_induction,
                ..Options::default()
            },
            wake,
        }))
    };
    let hover = TimeScale::Hover {
        least_speed: 0.5,
        cap: 0.5,
    };
    let inflows = [
        None,
        annular(Wake::Equilibrium, HighInduction::Buhl),
        annular(
            Wake::Dynamic(TimeScale::Turbine, Forcing::Steady),
            HighInduction::BuhlOutside,
        ),
        annular(
            Wake::Dynamic(hover, Forcing::Lagged),
            HighInduction::Polynomial,
        ),
    ];
    let airfoils = ["naca0012", "flat_plate", "thin"];
    let mut all = Vec::new();
    for (number, word) in SectionModel::WORDS.iter().enumerate() {
        for (other, inflow) in inflows.into_iter().enumerate() {
            let airfoil =
                built_in(airfoils[(number + other) % airfoils.len()]).expect("a sound sample");
            all.push(StripDesign {
                chord: 0.7,
                section: Section::single(Arc::new(airfoil)),
                model: SectionModel::of_word(word).expect("a sound sample"),
                inflow,
                radial_drag: (number + other).is_multiple_of(2),
            });
        }
    }
    all
}

fn geometry(random: &mut Random) -> StripGeometry {
    StripGeometry {
        offset: random.vector(0.3),
        axes: random.rotation(1.0),
        length: 0.8,
    }
}

fn rotor(random: &mut Random, tip: usize, hub: Option<usize>) -> (TipRadius, StripRotor) {
    let shaft = Shaft {
        center: random.vector(0.5),
        axis: random.vector(1.0).normalize(),
    };
    let tip = TipRadius::new("tip", (tip, random.vector(0.3)), shaft, hub);
    let rotor = StripRotor {
        shaft,
        hub,
        tip_radius: tip.scalar().clone(),
        disk: None,
    };
    (tip, rotor)
}

// A hundred and more elements, each in a state of its own.
#[test]
fn strips_on_beams() {
    let mut random = Random(61);
    for design in designs() {
        let strip = Arc::new(Strip::new(design));
        let mut undeformed = beam_nodes(&mut random);
        undeformed.extend(nodes(&mut random, 1));
        for geometry_of_beam in geometries(&mut random) {
            for hub in [None, Some(3)] {
                let (_, rotor) = rotor(&mut random, 2, hub);
                let ends = [&undeformed[0], &undeformed[1], &undeformed[2]];
                let element = AirStrip::on_beam(
                    "strip",
                    ([0, 1, 2], geometry_of_beam, &ends),
                    0.9 * random.number(),
                    (Arc::clone(&strip), geometry(&mut random)),
                    Some(rotor),
                    air(&mut random),
                );
                let count = element.nodes().len();
                check_states(1, WITHIN, &element, &undeformed[..count], &mut random);
            }
        }
    }
}

#[test]
fn strips_on_bodies() {
    let mut random = Random(62);
    for design in designs() {
        let undeformed = nodes(&mut random, 2);
        let (_, rotor) = rotor(&mut random, 0, Some(1));
        let element = AirStrip::on_body(
            "strip",
            (0, &undeformed[0], random.vector(1.0)),
            (Arc::new(Strip::new(design)), geometry(&mut random)),
            Some(rotor),
            air(&mut random),
        );
        check_within(WITHIN, &element, &undeformed, &mut random);
    }
}

/// Wings: strips of bodies and beams without a rotor, whose flow has no shaft.
#[test]
fn strips_without_a_rotor() {
    let mut random = Random(65);
    for design in designs() {
        if design.inflow.is_some() {
            continue;
        }
        let strip = Arc::new(Strip::new(design));
        let undeformed = nodes(&mut random, 1);
        let body = AirStrip::on_body(
            "strip",
            (0, &undeformed[0], random.vector(1.0)),
            (Arc::clone(&strip), geometry(&mut random)),
            None,
            gusty_air(&mut random),
        );
        assert_eq!(body.scalars().len(), strip.states().len());
        check_within(WITHIN, &body, &undeformed, &mut random);
        let undeformed = beam_nodes(&mut random);
        let ends = [&undeformed[0], &undeformed[1], &undeformed[2]];
        for geometry_of_beam in geometries(&mut random) {
            let beam = AirStrip::on_beam(
                "strip",
                ([0, 1, 2], geometry_of_beam, &ends),
                0.9 * random.number(),
                (Arc::clone(&strip), geometry(&mut random)),
                None,
                air(&mut random),
            );
            check_within(WITHIN, &beam, &undeformed, &mut random);
        }
    }
}

#[test]
fn strips_in_wind_that_varies() {
    let mut random = Random(64);
    for design in designs() {
        let undeformed = nodes(&mut random, 2);
        let (_, rotor) = rotor(&mut random, 0, Some(1));
        let element = AirStrip::on_body(
            "strip",
            (0, &undeformed[0], random.vector(1.0)),
            (Arc::new(Strip::new(design)), geometry(&mut random)),
            Some(rotor),
            gusty_air(&mut random),
        );
        check_within(WITHIN, &element, &undeformed, &mut random);
    }
}

#[test]
fn radii_of_tips() {
    let mut random = Random(63);
    let undeformed = nodes(&mut random, 2);
    for hub in [None, Some(1)] {
        let (tip, _) = rotor(&mut random, 0, hub);
        check(&tip, &undeformed[..tip.nodes().len()], &mut random);
    }
}

/// A disk of every model with the ground below it; the last one without a skewed wake of its annuli.
fn disks(random: &mut Random) -> Vec<(Shaft, Arc<RotorDisk>)> {
    let words = InflowModel::WORDS.iter();
    let models = words.filter_map(|word| InflowModel::of_word(word));
    let skewed = models.map(|model| (model, true));
    let plain = InflowModel::of_word("none").map(|model| (model, false));
    skewed
        .chain(plain)
        .map(|(model, is_skewed)| {
            let shaft = Shaft {
                center: random.vector(0.5),
                axis: (Vector3::z() + random.vector(0.3)).normalize(),
            };
            let ground = Ground {
                up: (Vector3::z() + random.vector(0.2)).normalize(),
                level: -3.0,
            };
            let disk = Disk { model, radius: 2.0 };
            let disk = RotorDisk::new("rotor", disk, (shaft, &shaft.axis), Some(ground));
            (shaft, Arc::new(disk.skewed(is_skewed)))
        })
        .collect()
}

/// The sample points have scalars of the order of one: a rotor speed of one radian per second, and
/// velocities of some meters per second, so that derivatives are of the order of one to a hundred.
#[test]
fn disks_on_hubs_and_frames() {
    let mut random = Random(66);
    for _ in 0..10 {
        for (_, disk) in disks(&mut random) {
            for hub in [None, Some(0)] {
                let element = DiskInflow::new(Arc::clone(&disk), hub, gusty_air(&mut random));
                let undeformed = nodes(&mut random, element.nodes().len());
                check_within(WITHIN, &element, &undeformed, &mut random);
            }
        }
    }
}

#[test]
fn strips_in_disks() {
    let mut random = Random(67);
    let annulus = AnnularInflow {
        blades: 3,
        hub_radius: 0.01,
        options: Options::default(),
        wake: Wake::Dynamic(TimeScale::Turbine, Forcing::Lagged),
    };
    let design = |inflow| StripDesign {
        chord: 0.7,
        section: Section::single(Arc::new(built_in("naca0012").expect("a sound sample"))),
        model: SectionModel::of_word("separation_lag").expect("a sound sample"),
        inflow: Some(inflow),
        radial_drag: true,
    };
    for _ in 0..5 {
        for (shaft, disk) in disks(&mut random) {
            let inflow = match disk.scalars().len() {
                8 => StripInflow::Distributed(annulus),
                _ => StripInflow::Disk,
            };
            for hub in [None, Some(1)] {
                let undeformed = nodes(&mut random, 1 + usize::from(hub.is_some()));
                let tip = TipRadius::new("tip", (0, Vector3::zeros()), shaft, None);
                let rotor = StripRotor {
                    shaft,
                    hub,
                    tip_radius: tip.scalar().clone(),
                    disk: Some(Arc::clone(&disk)),
                };
                let element = AirStrip::on_body(
                    "strip",
                    (0, &undeformed[0], random.vector(1.0)),
                    (Arc::new(Strip::new(design(inflow))), geometry(&mut random)),
                    Some(rotor),
                    gusty_air(&mut random),
                );
                check_within(WITHIN, &element, &undeformed, &mut random);
            }
        }
    }
}

/// Thrust, torque and power as scalars: their values are the ones of the report, their derivatives the
/// differences.
#[test]
fn sums_of_rotors() {
    let mut random = Random(65);
    let sums = [RotorSum::Thrust, RotorSum::Torque, RotorSum::Power].map(Reading::Rotor);
    for design in designs() {
        let strip = Arc::new(Strip::new(design));
        let mut undeformed = beam_nodes(&mut random);
        undeformed.extend(nodes(&mut random, 1));
        let beams = geometries(&mut random).into_iter().map(Some);
        for (number, beam) in beams.chain([None]).enumerate() {
            let hub = (number % 2 == 0).then_some(if beam.is_some() { 3 } else { 1 });
            let (_, rotor) = rotor(&mut random, 0, hub);
            let placed = (Arc::clone(&strip), geometry(&mut random));
            let air = air(&mut random);
            let element = match beam {
                Some(beam) => {
                    let ends = [&undeformed[0], &undeformed[1], &undeformed[2]];
                    let xi = 0.9 * random.number();
                    let nodes = ([0, 1, 2], beam, &ends);
                    AirStrip::on_beam("strip", nodes, xi, placed, Some(rotor), air)
                }
                None => {
                    let node = (0, &undeformed[0], random.vector(1.0));
                    AirStrip::on_body("strip", node, placed, Some(rotor), air)
                }
            };
            let count = element.nodes().len();
            let scalars = sums.map(|sum| (sum, super::readings::scalar()));
            let adapted = Adapted::read(Arc::new(element), scalars.to_vec());
            check_states(1, WITHIN, &adapted, &undeformed[..count], &mut random);
            super::readings::check_values(&adapted, &sums, &undeformed[..count], &mut random);
        }
    }
}

/// Every quantity of the report as a scalar, with a weight: of strips with and without a rotor, on
/// beams and bodies, without inflow and in annuli.
#[test]
fn quantities_of_strips() {
    use crate::elements::StripQuantity as Of;
    let mut random = Random(68);
    let all = [
        (Of::AngleOfAttack, 1.0),
        (Of::InflowAngle, 0.3),
        (Of::InducedVelocity, 0.7),
        (Of::InducedSwirl, 0.3),
        (Of::FlowSpeed, 0.1),
        (Of::LiftCoefficient, 1.0),
        (Of::DragCoefficient, 1.0),
        (Of::MomentCoefficient, 1.0),
        (Of::Mach, 1.0),
        (Of::Reynolds, 1e-6),
        (Of::NormalLoad, 0.01),
        (Of::LiftLoad, 0.01),
        (Of::DragLoad, 0.01),
        (Of::MomentLoad, 0.01),
    ]
    .map(|(quantity, weight)| Reading::Strip(quantity, weight));
    // Five of the designs, among them all inflows.
    for design in designs().into_iter().step_by(5) {
        let has_inflow = design.inflow.is_some();
        let strip = Arc::new(Strip::new(design));
        let mut undeformed = beam_nodes(&mut random);
        undeformed.extend(nodes(&mut random, 1));
        let beam = geometries(&mut random).into_iter().next();
        for (beam, hub) in [(beam, Some(3)), (None, Some(1)), (None, None)] {
            let (_, rotor) = rotor(&mut random, 0, hub);
            let rotor = (has_inflow || hub.is_some()).then_some(rotor);
            let placed = (Arc::clone(&strip), geometry(&mut random));
            let air = air(&mut random);
            let element = match beam {
                Some(beam) => {
                    let ends = [&undeformed[0], &undeformed[1], &undeformed[2]];
                    let nodes = ([0, 1, 2], beam, &ends);
                    AirStrip::on_beam("strip", nodes, 0.4, placed, rotor, air)
                }
                None => {
                    let node = (0, &undeformed[0], random.vector(1.0));
                    AirStrip::on_body("strip", node, placed, rotor, air)
                }
            };
            let count = element.nodes().len();
            let scalars = all.map(|reading| (reading, super::readings::scalar()));
            let adapted = Adapted::read(Arc::new(element), scalars.to_vec());
            check_states(1, WITHIN, &adapted, &undeformed[..count], &mut random);
            super::readings::check_values(&adapted, &all, &undeformed[..count], &mut random);
        }
    }
}
