//! Lifting rotors in hover against measurements and an independent program.

use std::f64::consts::PI;
use std::path::Path;
use std::sync::Arc;

use rotor_aero::airfoil::{Airfoil, Interpolation, LinearLift, built_in, files};
use rotor_aero::momentum::Options;
use rotor_aero::rotor::{AnnulusRadius, Machine, OperatingPoint, Performance, RigidRotor, Station};

use crate::compare::Compared;
use crate::support::{Shared, json, number, numbers};

/// NACA 0012 of the reference data, with Mach numbers.
fn naca0012() -> Shared {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../tests/reference/theory-rotor/naca0012_eq.c81"
    );
    let reading = files::read(Path::new(path)).expect("a table");
    let data = &reading.airfoils[0].data;
    Shared(Arc::new(
        Airfoil::new(data, Interpolation::Monotone).expect("an airfoil"),
    ))
}

fn built_in_naca0012() -> Shared {
    Shared(Arc::new(built_in("naca0012").expect("built in")))
}

fn linear(slope: f64) -> Shared {
    Shared(Arc::new(Airfoil::linear(LinearLift {
        slope,
        drag_0: 0.01,
        ..LinearLift::default()
    })))
}

/// Losses at the tips alone, and without swirl; and with all parts of annular momentum.
fn options() -> [Options; 2] {
    let simple = Options {
        hub_loss: false,
        swirl: false,
        ..Options::default()
    };
    [simple, Options::default()]
}

/// A rotor of constant chord from `root` to `tip` \[m\], with a linear twist that is zero at three
/// quarters of the radius, in `count` stations.
fn rotor(
    (blades, count): (usize, u32),
    [root, tip]: [f64; 2],
    chord: f64,
    twist_per_radius: f64,
    (section, options): (&Shared, Options),
) -> RigidRotor<Shared> {
    let stations = (0..count).map(|i| {
        let radius = root + (tip - root) * (f64::from(i) + 0.5) / f64::from(count);
        Station {
            radius,
            chord,
            twist: twist_per_radius * (radius / tip - 0.75),
            prebend: 0.0,
            section: section.clone(),
        }
    });
    RigidRotor {
        machine: Machine::Propeller,
        blades,
        hub_radius: root,
        tip_radius: tip,
        precone: 0.0,
        tilt: 0.0,
        yaw: 0.0,
        hub_height: 0.0,
        stations: stations.collect(),
        options,
        annulus_radius: AnnulusRadius::ToShaft,
        skewed_wake: false,
        sectors: 1,
    }
}

/// Speed of rotation of the compared measurements of Caradonna and Tung \[rad/s\].
const SPEED: f64 = 1250.0 * PI / 30.0;

fn caradonna(pitch_deg: f64, section: &Shared, options: Options) -> Performance {
    let data = json("theory-rotor/hover_caradonna_tung.json");
    let (radius, chord) = (number(&data["R_m"]), number(&data["c_m"]));
    let rotor = rotor((2, 60), [chord, radius], chord, 0.0, (section, options));
    let found = rotor.performance(&OperatingPoint {
        omega: SPEED,
        pitch: pitch_deg.to_radians(),
        ..OperatingPoint::default()
    });
    assert_eq!(found.unsolved, 0);
    found
}

const CARADONNA: &str = "NASA TM 81232 (Caradonna and Tung), measured";

/// Measured thrust of the two-blade rotor of Caradonna and Tung (NASA TM 81232). Annular momentum does
/// not have the tip vortex of the blade before: programs of this kind are 15 to 50 % high, and the ratio
/// of the thrusts at 12 and 8 degrees is met. The band belongs to the theory, not to the numbers.
#[test]
fn thrust_of_caradonna_and_tung_is_a_band() {
    let data = json("theory-rotor/hover_caradonna_tung.json");
    let measured = ["5", "8", "12"].map(|pitch| {
        let speeds = data["CT"][pitch].as_object().expect("speeds");
        number(speeds.values().next().expect("a speed"))
    });
    for (name, section) in [
        ("C81 table", naca0012()),
        ("built-in table", built_in_naca0012()),
        ("slope 5.73", linear(5.73)),
    ] {
        for options in options() {
            let found = [5.0, 8.0, 12.0]
                .map(|pitch| caradonna(pitch, &section, options).helicopter().thrust);
            let case = format!("two blades in hover, {name}");
            let with = Compared {
                source: CARADONNA,
                case: &case,
            };
            for ((pitch, found), expected) in [5, 8, 12].iter().zip(found).zip(measured) {
                let over = found / expected - 1.0;
                assert!((0.15..0.5).contains(&over), "{case} {pitch} {found} {over}");
                with.relative(&format!("CT at {pitch} deg"), [found, expected], 0.5);
            }
            let numbers = [found[2] / found[1], measured[2] / measured[1]];
            with.relative("CT at 12 deg over CT at 8 deg", numbers, 0.03);
        }
    }
}

/// Lift of the sections of the same rotor at five radii, over the dynamic pressure of the rotation, which
/// the report lists. It scatters along the span by a fifth; the sections have 3 to 67 % too much lift, as
/// the rotor has too much thrust.
#[test]
fn section_lift_of_caradonna_and_tung_is_a_band() {
    let data = &json("theory-rotor/hover_caradonna_tung.json")["section_CL_1250rpm"];
    let radii = numbers(&data["r/R"]);
    let with = Compared {
        source: CARADONNA,
        case: "two blades in hover, lift of sections",
    };
    for pitch in ["5", "8", "12"] {
        let angle: f64 = pitch.parse().expect("a number");
        let found = caradonna(angle, &built_in_naca0012(), Options::default());
        let loads = &found.sectors[0].stations;
        for (ratio, measured) in radii.iter().zip(numbers(&data[pitch])) {
            let after = loads.partition_point(|load| load.radius < ratio * found.disk_radius);
            let load = loads[after.min(loads.len() - 1)];
            let pressure = 0.5 * found.operating.density * (SPEED * load.radius).powi(2);
            let lift = load.normal / (pressure * found.disk_radius / 6.0);
            let quantity = format!("lift coefficient at {pitch} deg, {ratio} R");
            assert!(
                (1.0..1.7).contains(&(lift / measured)),
                "{quantity}: {lift}"
            );
            with.relative(&quantity, [lift, measured], 0.7);
        }
    }
}

/// Four blades of the active-twist rotor in hover: an independent program has 3679 (slope 5.73) and
/// 3993 lbf (table) with annuli, at 4 degrees at three quarters of the radius; the thesis' 5133 lbf belong
/// to 4.73 (table) to 5.08 degrees (slope).
///
/// The program's blades begin at the hinge, .027 of the radius, and its annuli have the loss at the tip
/// alone. The root at a fifth
/// of the radius costs a further 1.2 %, the loss at the hub and swirl are parts that the program does not
/// have: 3 % are granted for these rotors. A tenth of a degree of pitch, of which the two angles are known,
/// is 2.7 % of the thrust.
#[test]
fn active_twist_rotor_in_hover() {
    const FOOT: f64 = 0.3048;
    const POUND: f64 = 4.448_221_615;
    let data = json("theory-rotor/hover_atr.json");
    let listed = &data["thrust_lb_at_theta75_4deg"];
    let target = numbers(&data["target_lb"])[1];
    let radius = 28.0 * FOOT;
    let chord = 0.0488 * radius;
    let twist = (-8f64).to_radians();
    let thrust = |section: &Shared, root: f64, options: Options, pitch: f64| {
        let ends = [root * radius, radius];
        let rotor = rotor((4, 600), ends, chord, twist, (section, options));
        let found = rotor.performance(&OperatingPoint {
            omega: 22.25,
            pitch: pitch.to_radians(),
            density: 0.002378 * 515.379,
            ..OperatingPoint::default()
        });
        assert_eq!(found.unsolved, 0);
        found.thrust.abs() / POUND
    };
    for (name, section, needed) in [
        ("annulus+Prandtl, 5.73", linear(5.73), 5.08),
        ("annulus+Prandtl, table", naca0012(), 4.73),
        ("annulus+Prandtl, table", built_in_naca0012(), 4.73),
    ] {
        let with = Compared {
            source: "independent program (hover_atr.json)",
            case: "active-twist rotor in hover",
        };
        let [simple, all] = options();
        for (root, options, within) in [
            (0.027, simple, 0.005),
            (0.2, simple, 0.03),
            (0.1, all, 0.03),
        ] {
            let at = |pitch: f64| thrust(&section, root, options, pitch);
            println!("{name} {root} {} {}", at(4.0), at(needed));
            if root < 0.05 {
                assert!((3670.0..4020.0).contains(&at(4.0)), "{name}: {}", at(4.0));
            }
            let quantity = format!("thrust at 4 deg, {name}, root at {root} R [lbf]");
            with.relative(&quantity, [at(4.0), number(&listed[name])], within);
            let quantity = format!("thrust at {needed} deg, {name}, root at {root} R [lbf]");
            with.relative(&quantity, [at(needed), target], within + 0.01);
        }
    }
}
