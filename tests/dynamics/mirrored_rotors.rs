//! Rotors that turn clockwise: mirror images, in the plane of the shaft and azimuth zero, of the same rotors in
//! the other sense.

use beam_dynamics::analysis::periodic::periodic;
use beam_dynamics::analysis::statics::statics;
use beam_dynamics::elements::{RotorAir, StripQuantity};
use beam_dynamics::input::{self, Input};
use nalgebra::{Complex, Vector3};

use crate::effort::cases;
use crate::periodic::{Kept, Random};

/// A file in radians and SI units.
fn parsed(cards: &str) -> Input {
    let text = format!("[units]\nangle = \"rad\"\nrotation_speed = \"rad/s\"\n{cards}");
    input::parse(&text, "model.dynamics.toml")
        .unwrap_or_else(|problems| panic!("{problems}\n{text}"))
}

const HUBS: [&str; 5] = [
    "articulated",
    "hingeless",
    "teetering",
    "gimballed",
    "bearingless",
];

/// A number near a mean, by a part of it.
type About<'a> = dyn FnMut(f64, f64) -> f64 + 'a;

/// Sections that couple all motions, and cambered airfoils.
fn sections(about: &mut About<'_>) -> String {
    format!(
        "[airfoils.cambered]\nslope = {:?}\nzero_lift = {:?}\ndrag = 0.01\nmoment = {:?}\n\
         [properties.spar]\nea = 7e8\ngay = 2e8\ngaz = 1e8\ngj = {:?}\neiy = {:?}\neiz = 4e6\nm = 6\n\
         iy = 1e-3\niz = 1e-2\ntension_center = [{:?}, {:?}]\nshear_center = [{:?}, {:?}]\n\
         mass_center = [{:?}, {:?}]\ndamping = {{ time = 1e-2 }}\n",
        about(5.7, 0.1),
        about(-0.05, 0.5),
        about(-0.04, 0.5),
        about(2e5, 0.5),
        about(3e5, 0.5),
        about(0.02, 1.0),
        about(0.03, 1.0),
        about(0.02, 1.0),
        about(-0.02, 1.0),
        about(-0.02, 1.0),
        about(0.02, 1.0),
    )
}

/// Hinges, dampers, tilt or flexbeams of a hub.
fn parts(hub: &str, about: &mut About<'_>) -> String {
    match hub {
        "articulated" => format!(
            "[[rotor.hinge]]\nkind = \"flap\"\noffset = 0.2\nstop = {{ lower = 0.02, upper = 0.3, stiffness = 2e5 }}\n\
             [[rotor.hinge]]\nkind = \"lag\"\noffset = 0.3\n\
             [rotor.lag_damper]\nhub = [0.1, {:?}, {:?}]\nblade = [0.5, 0.12, {:?}]\ndamping = 9e3\n",
            about(0.1, 0.1),
            about(0.05, 0.5),
            about(0.08, 0.5)
        ),
        "hingeless" => format!(
            "[[rotor.hinge]]\nkind = \"flap\"\noffset = 0.2\nstiffness = {:?}\n",
            about(2e5, 0.3)
        ),
        "teetering" => format!(
            "undersling = {:?}\n[rotor.tilt]\nstiffness = 2e4\ndamping = 500\n[rotor.yoke]\nmass = 9\n\
             inertia = [0.1, 0.2, 0.3]\n",
            about(0.1, 0.5)
        ),
        "gimballed" => "link = 0.15\n[rotor.tilt]\nstiffness = 3e4\ndamping = 500\n[rotor.yoke]\nmass = 9\n\
                        inertia = [0.1, 0.1, 0.2]\n"
            .to_owned(),
        _ => "[rotor.flexbeam]\noffset = 0.1\nproperties = \"spar\"\npiece = [{ length = 0.3, elements = 1 }]\n\
              [rotor.torque_tube]\noffset = 0.15\n"
            .to_owned(),
    }
}

/// Pitch of the blades by bearings, links or plates.
fn controls(hub: &str, (number, cyclic): (usize, bool), about: &mut About<'_>) -> String {
    let cyclic = match cyclic {
        true => format!(
            "cosine = {:?}\nsine = {:?}\n",
            about(0.01, 1.0),
            about(-0.03, 0.5)
        ),
        false => String::new(),
    };
    let text = format!(
        "[rotor.swashplate]\ncollective = {:?}\n{cyclic}",
        about(0.1, 0.3)
    );
    let control = match number / 5 % 3 {
        0 if ["teetering", "gimballed"].contains(&hub) => 1,
        control => control,
    };
    text + &match control {
        0 => String::new(),
        1 => format!(
            "[rotor.pitch_link]\nstiffness = 2e4\ndelta_3 = {:?}\n",
            about(0.3, 0.5)
        ),
        _ => format!(
            "[rotor.swashplate.plate]\nbelow = {:?}\nhorn = [0.25, 0.2]\nstiffness = 2e6\n{}",
            about(0.3, 0.1),
            [
                "",
                "actuators = { radius = 0.2, base_radius = 0.15, base_below = 0.3 }\n"
            ][number / 15 % 2]
        ),
    }
}

/// A rotor with one of the hubs, controls and kinds of inflow, of random size.
fn rotor(random: &mut Random, number: usize, cyclic: bool) -> String {
    let mut about = |mean: f64, part: f64| mean * (1.0 + part * random.next());
    let hub = HUBS[number % HUBS.len()];
    let blades = if hub == "teetering" { 2 } else { 3 };
    let mut text = sections(&mut about);
    text += &format!(
        "[[rotor]]\nname = \"r\"\nhub = \"{hub}\"\nblades = {blades}\nspeed = 30\nazimuth = {:?}\n\
         direction = \"DIRECTION\"\nmass = 50\ninertia = [2, 2, 4]\n",
        about(0.0, 1.0) + 0.3
    );
    text += &parts(hub, &mut about);
    text += &controls(hub, (number, cyclic), &mut about);
    text += [
        "",
        "[rotor.inflow]\nkind = \"Drees\"\n",
        "[rotor.inflow]\nkind = \"annular momentum\"\n",
        "[rotor.inflow]\nkind = \"Pitt-Peters\"\n",
    ][number / 3 % 4];
    text + &format!(
        "[rotor.blade]\nhub_radius = 0.4\nprecone = {:?}\nproperties = \"spar\"\n\
         piece = [{{ length = 2, elements = 1 }}, {{ length = 2.6, elements = 1, sweep = 0.1, dihedral = {:?} }}]\n\
         mass = [{{ at = \"tip\", mass = 0.4, offset = [0, 0.05, {:?}] }}]\n\
         [rotor.blade.aerodynamics]\nsection = \"quasi_steady\"\nstrips = 2\nstations = [\n\
         {{ at = 0.6, chord = 0.3, twist = {:?}, axis = 0.3, airfoil = \"cambered\" }},\n\
         {{ at = 4.6, chord = 0.2, twist = {:?}, airfoil = \"cambered\" }} ]\n",
        about(0.05, 0.5),
        about(0.05, 1.0),
        about(0.03, 1.0),
        about(0.1, 0.5),
        about(-0.05, 0.5)
    )
}

/// The rotor in both senses.
fn both(text: &str) -> [Input; 2] {
    ["counterclockwise", "clockwise"].map(|word| parsed(&text.replace("DIRECTION", word)))
}

/// The mirror image of a position or a force.
fn mirrored(vector: &Vector3<f64>) -> Vector3<f64> {
    Vector3::new(vector.x, -vector.y, vector.z)
}

/// Quantities of a strip that are the same in both senses.
const QUANTITIES: [StripQuantity; 12] = [
    StripQuantity::AngleOfAttack,
    StripQuantity::InflowAngle,
    StripQuantity::InducedVelocity,
    StripQuantity::InducedSwirl,
    StripQuantity::FlowSpeed,
    StripQuantity::LiftCoefficient,
    StripQuantity::DragCoefficient,
    StripQuantity::MomentCoefficient,
    StripQuantity::NormalLoad,
    StripQuantity::TangentialLoad,
    StripQuantity::LiftLoad,
    StripQuantity::MomentLoad,
];

// Equilibria in hover: all nodes and quantities of strips, with thrust and torque, to 1e-9 of the size, which are the errors of Newton's
// method. Thrust and torque are about the shaft in the sense of rotation, the thrust positive upward.
#[test]
fn hover_in_both_senses() {
    let mut random = Random(7);
    for number in 0..cases(240) {
        let text =
            rotor(&mut random, number, false) + "[air]\ndensity = 1.225\n[static]\nspeed = 30\n";
        let found = both(&text).map(|input| {
            let outcome = statics(&input.model, input.statics.as_ref().unwrap());
            assert!(
                outcome.failure.is_none(),
                "{number}: {:?}\n{text}",
                outcome.failure
            );
            outcome.result.steps.into_iter().next_back().unwrap()
        });
        let [own, image] = &found;
        for (own, image) in own.positions.iter().zip(&image.positions) {
            let off = (mirrored(own) - image).norm();
            assert!(off < 1e-9 * 5.0, "{number}: {own:?} {image:?}\n{text}");
        }
        for (own, image) in own.air.iter().zip(&image.air) {
            for quantity in QUANTITIES {
                let [own, image] = [own, image].map(|state| quantity.of(state));
                let off = (own - image).abs();
                let size = own.abs().max(1.0);
                assert!(
                    off < 1e-6 * size,
                    "{number}: {quantity:?} {own} {image}\n{text}"
                );
            }
        }
        let [own, image] = found
            .each_ref()
            .map(|step| RotorAir::of(&step.air).unwrap());
        let off = (own.thrust - image.thrust).abs() + (own.torque - image.torque).abs();
        assert!(
            own.thrust > 100.0 && off < 1e-7 * own.thrust,
            "{number}: {own:?} {image:?}\n{text}"
        );
    }
}

// Periodic motion in forward flight with cyclic pitch, at all steps, and its multipliers: to the tolerance of
// Newton's method and of the multipliers.
#[test]
fn forward_flight_in_both_senses() {
    let mut random = Random(11);
    for number in 0..cases(15) {
        let text = rotor(&mut random, 4 * number + 1, true)
            + "[air]\ndensity = 1.225\nwind = [20, 0, 1]\n[periodic]\nspeed = 30\nsteps = 16\n\
               stages = \"two\"\ntolerance = 1e-10\n[periodic.floquet]\ncount = 6\nerror_estimate = false\n";
        let found = both(&text).map(|input| {
            let mut kept = Kept::default();
            let outcome = periodic(&input.model, input.periodic.as_ref().unwrap(), &mut kept);
            assert!(
                outcome.failure.is_none(),
                "{number}: {:?}\n{text}",
                outcome.failure
            );
            let modes = outcome.result.floquet.unwrap().modes;
            let multipliers: Vec<Complex<f64>> = modes.iter().map(|mode| mode.multiplier).collect();
            // Patterns of one multiplier are in any order.
            let mut names: Vec<_> = modes.iter().map(|mode| mode.label()).collect();
            names.sort();
            (kept.0, multipliers, names)
        });
        let [own, image] = &found;
        for ((_, own), (_, image)) in own.0.iter().zip(&image.0) {
            for (own, image) in own.nodes.iter().zip(&image.nodes) {
                let off = (mirrored(&own.position) - image.position).norm();
                assert!(off < 1e-8 * 5.0, "{number}: {off:e}\n{text}");
            }
        }
        for (own, image) in own.1.iter().zip(&image.1) {
            assert!(
                (own - image).norm() < 1e-7,
                "{number}: {own} {image}\n{text}"
            );
        }
        assert_eq!(own.2, image.2, "{number}");
    }
}
