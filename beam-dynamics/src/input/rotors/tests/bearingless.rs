//! Bearingless hubs: frequencies, pitch by torsion, forces and damping against closed forms.

use std::f64::consts::TAU;

use nalgebra::{Complex, Matrix2, Matrix3, Vector2, Vector3};
use shared_geom::rotation::vector;
use shared_geom::section::{
    self, Centers, CubicTable, Engineering, Prestress, Provenance, SectionProperties, StrainMeasure,
};

use super::{Run, STRIP, read, refused};
use crate::analysis::modes::modes;
use crate::analysis::statics::statics;
use crate::analysis::trim::trim;
use crate::input::parse_with;
use crate::input::rotors::damper_law::DamperLaw;
use crate::input::rotors::distributor::Links;
use crate::result::StaticStep;

/// A light flexbeam, stiff in tension and shear, of torsional stiffness 20 N m^2.
const FLEX: &str = "
[properties.flex]
ea = 7e7
gay = 2e9
gaz = 2e9
gj = 20
eiy = 200
eiz = 2000
m = 1e-6
iy = 1e-12
iz = 1e-12
";

/// Offset, length and end of the flexbeam [m].
const INNER: f64 = 0.1;
const LENGTH: f64 = 0.5;
const ROOT: f64 = 0.6;

/// A rotor with flexbeams from 0.1 m to 0.6 m and stiff blades of 1 m.
fn rotor(blades: usize, keys: &str, cards: &str) -> String {
    format!(
        "units = \"SI\"\n{STRIP}{FLEX}[[rotor]]\nname = \"r\"\nhub = \"bearingless\"\n\
         blades = {blades}\n{keys}\n[rotor.blade]\nhub_radius = {ROOT}\nproperties = \"strip\"\n\
         piece = [{{ length = 1, elements = 2 }}]\n[rotor.flexbeam]\noffset = {INNER}\n\
         properties = \"flex\"\npiece = [{{ length = {LENGTH}, elements = 4 }}]\n{cards}"
    )
}

/// Frequencies [Hz] and growths [1/s] of all modes at all speeds.
fn found_modes(text: &str) -> Vec<[f64; 2]> {
    let input = read(text);
    let outcome = modes(&input.model, &input.modes.unwrap());
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    let speeds = 0..outcome.table.speeds.len();
    let points = speeds.flat_map(|speed| outcome.table.at_speed(speed).into_iter());
    points
        .map(|(_, point)| [point.frequency, point.growth])
        .collect()
}

// The flexbeam with a tube and a link of no stiffness is the inner piece of the blade of a hingeless
// rotor: the same nodes but for the one that is doubled, so that the frequencies are the same to
// round-off of the iteration. The multiblade coordinates count the three blades.
#[test]
fn a_flexbeam_is_a_piece_of_the_blade() {
    const MODES: &str = "[modes]\nspeeds = [0, 300]\ncount = 9\n";
    let soft =
        "speed = 300\n[rotor.swashplate]\ncollective = 0\n[rotor.pitch_link]\nstiffness = 1e-6\n";
    let text = rotor(3, soft, MODES);
    let hingeless = format!(
        "units = \"SI\"\n{STRIP}{FLEX}[[rotor]]\nname = \"r\"\nhub = \"hingeless\"\nblades = 3\n\
         speed = 300\n[rotor.blade]\nhub_radius = {INNER}\npiece = [\n\
         {{ length = {LENGTH}, elements = 4, properties = \"flex\" }},\n\
         {{ length = 1, elements = 2, properties = \"strip\" }}]\n{MODES}"
    );
    let [found, expected] = [&text, &hingeless].map(|text| found_modes(text));
    assert_eq!(found.len(), expected.len());
    for ([found, _], [expected, _]) in found.iter().zip(&expected) {
        let off = (found - expected).abs();
        assert!(off < 1e-7 * expected.max(1.0), "{found} {expected}");
    }
    assert_eq!(read(&text).model.blades.len(), 3);
}

/// The last equilibrium, and a position with axes of a node in it.
fn equilibrium(text: &str, node: &str) -> (StaticStep, Vector3<f64>, Matrix3<f64>) {
    let input = read(text);
    let outcome = statics(&input.model, &input.statics.unwrap());
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    let nodes = input.model.system.nodes();
    let index = nodes.iter().position(|own| own.label == node).unwrap();
    let last = outcome.result.steps.last().unwrap().clone();
    let (position, rotation) = (last.positions[index], last.rotations[index]);
    (last, position, rotation * nodes[index].rotation.transpose())
}

/// Link of the plates of the tests: above the horn of the pin at 0.15 m, or outboard of it.
fn links(x: f64) -> Links {
    Links {
        below: 0.3,
        horn: [x, 0.1],
        precone: 0.0,
        undersling: 0.0,
    }
}

/// Keys of a plate of collective pitch [deg] with a snubber at 0.15 m, and further keys of the plate.
fn plate(x: f64, collective: f64, more: &str) -> String {
    format!(
        "speed = 300\n[rotor.torque_tube]\noffset = 0.15\n[rotor.snubber]\n[rotor.swashplate]\n\
         collective = {collective}\n[rotor.swashplate.plate]\nbelow = 0.3\nhorn = [{x}, 0.1]\n{more}"
    )
}

// A flexbeam of constant section twists by M L / (G J), with tension too: the beam is exact in its
// kinematics, and its section has no effect of tension on torsion without a table of prestress. With
// the link of the stiffness k in series, above the pin, so that it does not bend the flexbeam,
//
//   G J / L phi = k (l - l_0) y (cos phi n_z - sin phi n_y) ,  n the direction of the link
#[test]
fn pitch_twists_the_flexbeam_against_the_link() {
    const STIFFNESS: f64 = 2e4;
    const PULL: f64 = 2e3;
    let load = format!("[[load]]\nnode = \"r 1/tip\"\nforce = [{PULL}, 0, 0]\n[static]\n");
    let keys = plate(0.15, 12.0, &format!("stiffness = {STIFFNESS}\n"));
    let (step, _, turn) = equilibrium(&rotor(1, &keys, &load), "r 1/root");
    let found = vector::from_rotation(&turn);
    let links = links(0.15);
    let height = links.exact([12.0_f64.to_radians(), 0.0, 0.0]).unwrap()[0];
    let horn = links.horn[1];
    let moment = |phi: f64| {
        let link = Vector2::new(
            horn * (phi.cos() - 1.0),
            horn * phi.sin() + links.below - height,
        );
        let tension = STIFFNESS * (link.norm() - links.below);
        -tension * horn * (phi.cos() * link.y - phi.sin() * link.x) / link.norm()
    };
    // Bisection: the moment of the link falls with the pitch, the one of the flexbeam grows.
    let (mut low, mut high) = (0.0, 0.5);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if moment(middle) > 20.0 / LENGTH * middle {
            low = middle
        } else {
            high = middle
        }
    }
    // A tenth of the displacement of the horn is in the link: 20/0.5 against 2e4 0.1^2.
    assert!(low < 0.95 * 12.0_f64.to_radians() && low > 0.15, "{low}");
    // The pull stretches the flexbeam by 1.4e-5 m, the link leans by this part of its length.
    assert!((found.x / low - 1.0).abs() < 1e-6, "{found} {low}");
    let torsion: Vec<_> = step
        .sections
        .iter()
        .filter(|own| own.beam.contains("flexbeam"))
        .collect();
    for section in &torsion {
        let [tension, twist] = [section.internal_force[0], section.internal_force[3]];
        assert!((twist / moment(low) - 1.0).abs() < 1e-6, "{twist}");
        // The link leans by 5e-5 under 80 N.
        assert!((tension / PULL - 1.0).abs() < 4e-6, "{tension}");
    }
    assert_eq!(torsion.len(), 8);
}

// With rigid links the pitch is the kinematics of the links, and by a rotation joint without links it
// is the control, in rotation too; the flexbeam carries the whole centrifugal force of the blade,
// m Omega^2 (R^2 - r^2)/2 of undeformed radii (the stretch is 2e-5 of them).
#[test]
fn rigid_controls_prescribe_the_pitch() {
    let speed = 10.0 * std::f64::consts::PI;
    let still = "speed = 300\n[rotor.snubber]\n[rotor.swashplate]\ncollective = 8\nsine = -3\n";
    let position = links(0.15).exact([8.0_f64.to_radians(), 0.0, 0.0]).unwrap();
    let of_link = links(0.15).pitch(&position, 0.0).unwrap();
    for (keys, expected) in [
        (still.to_owned(), 8.0_f64.to_radians()),
        (plate(0.15, 8.0, ""), of_link),
    ] {
        let (step, _, turn) = equilibrium(&rotor(1, &keys, "[static]\nspeed = 300\n"), "r 1/root");
        let pitch = vector::from_rotation(&turn);
        assert!((pitch.x - expected).abs() < 1e-6, "{pitch} {expected}");
        let force = 2.0 * speed * speed * (1.6_f64.powi(2) - ROOT * ROOT) / 2.0;
        let beams = step
            .sections
            .iter()
            .filter(|own| &*own.beam == "r 1/flexbeam/beam 1");
        for section in beams {
            let tension = section.internal_force[0];
            assert!((tension / force - 1.0).abs() < 1e-4, "{tension} {force}");
        }
    }
}

// The tube turns about the pin of the snubber, and the horn stays on its rigid link, whatever the
// flexbeam does: theta = -(x_horn - x_pin) / y_horn beta, up to the squares of the angles.
#[test]
fn the_snubber_couples_pitch_and_flap() {
    for horn in [0.15, 0.3, 0.05] {
        let load = "[[load]]\nnode = \"r 1/tip\"\nforce = [0, 0, 1]\n[static]\n";
        let text = rotor(1, &plate(horn, 0.0, ""), load);
        let (_, _, turn) = equilibrium(&text, "r 1/root");
        let turn = vector::from_rotation(&turn);
        let (flap, pitch) = (-turn.y, turn.x);
        let expected = -(horn - 0.15) / 0.1 * flap;
        assert!(flap > 1e-4 && flap < 3e-3, "{flap}");
        assert!(
            (pitch - expected).abs() < 5.0 * flap * flap,
            "{horn}: {pitch} {expected}"
        );
    }
}

// A rigid snubber between the tube and a node of the flexbeam holds their distance across the blade at
// this node, where a load at the tip bends the flexbeam away from the tube without it.
#[test]
fn snubbers_hold_the_tube_on_the_flexbeam() {
    let load = "[[load]]\nnode = \"r 1/tip\"\nforce = [0, 5, 3]\n[static]\n";
    let gap = |snubber: &str| {
        let keys = format!("speed = 0\n[rotor.torque_tube]\noffset = 0.225\n{snubber}");
        let text = rotor(1, &keys, load);
        let [node, tube] = ["r 1/flexbeam/2", "r 1/pitch"].map(|node| equilibrium(&text, node).1);
        (tube - node).yz().norm()
    };
    assert!(gap("") > 1e-5, "{}", gap(""));
    let held = gap("[rotor.snubber]\nto = \"flexbeam\"\n");
    assert!(held < 1e-9, "{held}");
}

// A damper c across the snubber at the distance a from the root damps a motion with the shape
// q = (v, zeta) of the root by the growth -c (v - a zeta)^2 / (2 q M q). Without rotation the rigid
// blade of the mass m per length on the flexbeam without mass has, with l its length,
//
//   K = EI [12/L^3, -6/L^2; -6/L^2, 4/L]      M = m [l, l^2/2; l^2/2, l^3/3]
//
// The blade bends and has rotary inertia by 1e-4 and 1e-5, the elements of the flexbeam are as stiff
// as the closed form to 1e-3.
#[test]
fn a_lag_damper_in_the_snubber_damps_by_its_modal_work() {
    const DAMPER: f64 = 40.0;
    let keys = format!("speed = 0\n[rotor.snubber]\noffset = 0.3\ndamping = [0, {DAMPER}, 0]\n");
    let text = rotor(1, &keys, "[modes]\nspeeds = [0]\ncount = 3\n");
    let [l, m, stiffness] = [LENGTH, 2.0, 2000.0];
    let k = Matrix2::new(
        12.0 / l.powi(3),
        -6.0 / l.powi(2),
        -6.0 / l.powi(2),
        4.0 / l,
    ) * stiffness;
    let mass = Matrix2::new(1.0, 0.5, 0.5, 1.0 / 3.0) * m;
    let product = mass.try_inverse().unwrap() * k;
    let (half, determinant) = (0.5 * product.trace(), product.determinant());
    let square = half - (half * half - determinant).sqrt();
    let shape = Vector2::new(product[(0, 1)], square - product[(0, 0)]);
    let across = shape.x - (ROOT - 0.3) * shape.y;
    let growth = -DAMPER * across * across / (2.0 * (shape.transpose() * mass * shape).x);
    let frequency = square.sqrt() / std::f64::consts::TAU;
    let found = found_modes(&text);
    let lag = found.iter().min_by(|a, b| {
        (a[0] - frequency)
            .abs()
            .total_cmp(&(b[0] - frequency).abs())
    });
    let [found, decay] = *lag.unwrap();
    assert!(
        (found / frequency - 1.0).abs() < 5e-3,
        "{found} {frequency}"
    );
    assert!((decay / growth - 1.0).abs() < 1e-2, "{decay} {growth}");
}

/// Stations of a blade in the air.
const AIR: &str = "[rotor.inflow]\nkind = \"uniform\"\n[rotor.blade.aerodynamics]\nsection = \"quasi_steady\"\n\
    strips = 2\nstations = [{ at = 0.1, chord = 0.1, airfoil = \"naca0012\" },\n\
    { at = 1, chord = 0.1, airfoil = \"naca0012\" }]\n[air]\ndensity = 1.225\n";

// A collective pitch of the swashplate, which twists the flexbeams, for a thrust in hover.
#[test]
fn a_bearingless_rotor_is_trimmed_in_hover() {
    let keys = "speed = 600\n[rotor.torque_tube]\noffset = 0.15\nmass = 0.2\n[rotor.snubber]\n\
                stiffness = [0, 2e5, 5e6]\ndamping = [0, 200, 0]\n[rotor.swashplate]\n\
                collective = \"collective\"\n[rotor.pitch_link]\nstiffness = 2000\n";
    let rest = "[sensors.up]\nquantity = \"thrust\"\n[trim]\nmethod = \"equilibrium\"\nspeed = 600\n\
                [[trim.control]]\nname = \"collective\"\nguess = 3\n[[trim.target]]\nname = \"thrust\"\n\
                signal = \"up\"\nvalue = 300\nscale = 300\n";
    let text = rotor(3, keys, &format!("{AIR}{rest}"));
    let input = read(&text);
    let read_with = |given: &[(String, f64)]| parse_with(&text, "a.dynamics.toml", given);
    let outcome = trim("r", input.trim.as_ref().unwrap(), &read_with);
    let point = outcome.result.points.last().unwrap();
    assert_eq!(point.failure, None);
    assert!(
        (point.targets[0][0] / 300.0 - 1.0).abs() < 1e-6,
        "{point:?}"
    );
    // The link and the flexbeam, 2000 against 40 N m, share the control: without moments of the
    // air about the axis of the flexbeam the pitch is 2 % less.
    assert!(
        point.controls[0] > 1.0 && point.controls[0] < 20.0,
        "{point:?}"
    );
}

// Without air and dampers a push at a tip leaves a motion of constant energy: no remark on a growth.
#[test]
fn no_energy_is_gained_in_vacuum() {
    let keys = "speed = 300\n[rotor.snubber]\n[rotor.swashplate]\ncollective = 0\n[rotor.pitch_link]\n\
                stiffness = 900\n";
    let rest = "[[load]]\nnode = \"r 1/tip\"\nforce = [0, 20, 30]\ndrive = \"= if(t<0.01,1,0)\"\n\
                [transient]\nto = 0.2\nstep = 1e-3\n";
    let run = Run::new(&rotor(2, keys, rest));
    let input = read(&rotor(2, keys, rest));
    assert_eq!(run.model.fingerprint(), input.model.fingerprint());
    assert!(
        run.remarks
            .iter()
            .all(|remark| !remark.contains("energy grows")),
        "{:?}",
        run.remarks
    );
}

#[test]
fn a_snubber_is_not_at_the_outer_end() {
    let keys = "speed = 1\n[rotor.snubber]\nto = \"flexbeam\"\noffset = 0.6";
    let shown = refused(&rotor(3, keys, "[modes]\nspeeds = [60]\n"));
    let expected =
        "the snubber is at 0.6 m, where the flexbeam has no node: the nearest is at 0.5375 m";
    assert!(shown.contains(expected), "{shown}");
}

// Wrong bearingless rotors, and the whole report.
#[test]
fn wrong_parts_are_explained() {
    const RUN: &str = "[transient]\nto = 0.1\nstep = 1e-3\n";
    let sound = rotor(3, "speed = 1", RUN);
    let hinged = sound.replace(
        "[rotor.flexbeam]",
        "[[rotor.hinge]]\nkind = \"flap\"\n[rotor.flexbeam]",
    );
    for (text, expected) in [
        (
            hinged,
            "a hub of the kind \"bearingless\" has no \"hinge\"\n  help: kinds that have it: \"rigid\", \
             \"hingeless\", \"articulated\", \"teetering\", \"gimballed\"",
        ),
        (
            sound.replace("hub = \"bearingless\"", "hub = \"hingeless\""),
            "a hub of the kind \"hingeless\" has no \"flexbeam\"\n  help: kinds that have it: \
             \"bearingless\"",
        ),
        (
            sound.replace("length = 0.5,", "length = 0.6,"),
            "the outer end of the flexbeam is at 0.7 m from the center of the hub, expected from 0.1 m \
             to 0.6 m\n  help: list hinges from the hub outward; \"hub_radius\" of [rotor.blade] is the \
             radius of the root, to which flexbeam and torque tube reach",
        ),
        (
            rotor(3, "speed = 1\n[rotor.snubber]\noffset = 0.7", RUN),
            "the snubber is at 0.7 m from the center of the hub, expected from 0 m to 0.6 m",
        ),
        (
            rotor(3, "speed = 1\n[rotor.snubber]\nstiffness = [-1, 0, 0]", RUN),
            "\"stiffness\" is an array of 3, expected three numbers, zero or more",
        ),
        (
            rotor(
                3,
                "speed = 1\n[rotor.snubber]\nto = \"flexbeam\"\noffset = 0.22",
                RUN,
            ),
            "the snubber is at 0.22 m, where the flexbeam has no node: the nearest is at 0.225 m\n  help: \
             end a piece of [rotor.flexbeam] there, or give the snubber the \"offset\" of a node",
        ),
        (
            rotor(3, "speed = 1\n[rotor.torque_tube]\ncenter = 0.2", RUN),
            "rotor \"r\" has \"center\" without \"mass of [rotor.torque_tube]\"",
        ),
    ] {
        let shown = refused(&text);
        assert!(shown.contains(expected), "{shown}");
        assert_eq!(shown.matches("error").count(), 1, "{shown}");
    }
    let bare = sound.split("[rotor.flexbeam]").next().unwrap().to_owned() + RUN;
    let shown = refused(&bare);
    let expected = "a hub of the kind \"bearingless\" has no \"flexbeam\", expected [rotor.flexbeam], the \
                    beam between hub and blade";
    assert!(shown.contains(expected), "{shown}");
}

// Nodes of a flexbeam that could not be read are not unknown.
#[test]
fn a_wrong_flexbeam_is_one_error() {
    let wrong = rotor(3, "speed = 0", "").replace("properties = \"flex\"", "properties = \"flux\"");
    let shown = refused(&wrong);
    assert!(
        shown.contains("unknown properties \"flux\" in blade \"r/flexbeam\""),
        "{shown}"
    );
    assert_eq!(shown.matches("error:").count(), 1, "{shown}");
}

/// Lag of blades on flexbeams with a snubber forward at 0.3 m, by its keys.
fn snubbed(keys: &str) -> String {
    let snubber =
        format!("speed = 0\n[rotor.torque_tube]\noffset = 0.3\n[rotor.snubber]\n{keys}\n");
    rotor(1, &snubber, "[modes]\nspeeds = [0]\ncount = 3\n")
}

// A snubber that relaxes has the complex stiffness `k + k_1 s tau / (1 + s tau)` in a motion exp(s t):
// springs and dampers with `K + c s` of the same complex number have the same root s. Without a static
// stiffness the damper is eta K / w.
#[test]
fn snubbers_relax() {
    let elastomer = "stiffness = [0, 4e4, 9e4]\nloss_factor = 0.4\nfrequency = 5";
    let relaxing = format!("{elastomer}\nstatic_stiffness = [0, 3e4, 8e4]");
    for [_, growth] in found_modes(&snubbed(&relaxing)) {
        assert!(growth < 0.0);
    }
    let laws = [(4e4, 3e4), (9e4, 8e4)]
        .map(|(stiffness, rest)| DamperLaw::elastomer([stiffness, 0.4], 5.0 * TAU, Some(rest)));
    let found = found_modes(&snubbed(&relaxing));
    for [frequency, growth] in &found {
        let s = Complex::new(*growth, TAU * frequency);
        let both = laws.clone().map(|law| match law {
            DamperLaw::Relaxing { rest, series, time } => {
                let complex = s * time * series / (s * time + 1.0) + rest;
                let damping = complex.im / s.im;
                [complex.re - damping * s.re, damping]
            }
            _ => panic!("it relaxes"),
        });
        let [[k_y, c_y], [k_z, c_z]] = both;
        let plain = format!("stiffness = [0, {k_y:?}, {k_z:?}]\ndamping = [0, {c_y:?}, {c_z:?}]");
        let nearest = found_modes(&snubbed(&plain))
            .into_iter()
            .map(|[f, g]| (Complex::new(g, TAU * f) - s).norm());
        let off = nearest.fold(f64::INFINITY, f64::min);
        assert!(off < 1e-6 * s.norm(), "{s} {off}");
    }
    let damping = [4e4, 9e4].map(|stiffness| stiffness * 0.4 / (5.0 * TAU));
    let plain = format!(
        "stiffness = [0, 4e4, 9e4]\ndamping = [0, {:?}, {:?}]",
        damping[0], damping[1]
    );
    let [one, other] = [elastomer, &plain].map(|keys| found_modes(&snubbed(keys)));
    for (one, other) in one.iter().flatten().zip(other.iter().flatten()) {
        assert!(
            (one - other).abs() < 1e-6 * one.abs().max(1.0),
            "{one} {other}"
        );
    }
}

#[test]
fn wrong_elastomers_of_snubbers_are_explained() {
    for (keys, expected) in [
        (
            "stiffness = [0, 1e4, 1e4]\nloss_factor = 0.4",
            "rotor \"r\" has \"loss_factor\" without \"frequency\", expected both",
        ),
        (
            "stiffness = [0, 1e4, 1e4]\nloss_factor = 0.4\nfrequency = 4\ndamping = [1, 1, 1]",
            "rotor \"r\" has \"damping\" and \"loss_factor\", expected one of them",
        ),
        (
            "stiffness = [0, 1e4, 1e4]\nloss_factor = 0.4\nfrequency = 4\nstatic_stiffness = [0, 2e4, 0]",
            "expected numbers less than \"stiffness\"",
        ),
    ] {
        let shown = refused(&snubbed(keys));
        assert!(shown.contains(expected), "{shown}");
        assert_eq!(shown.matches("error:").count(), 1, "{shown}");
    }
}

// A flexbeam with a table of the third derivatives of its energy, of which T144 is not zero: under the
// tension N and the torque M at the root of the blade its constant strain e and twist k fulfill
//
//   N = EA e + T144 k^2 / 2        M = GJ k + T144 e k
#[test]
fn tension_stiffens_the_twist_of_a_flexbeam() {
    const EA: f64 = 7e7;
    const GJ: f64 = 20.0;
    const T144: f64 = 7e4;
    const PULL: f64 = 2e4;
    const TORQUE: f64 = 2.0;
    let written = Engineering {
        stiffness: [EA, 2e9, 2e9, GJ, 200.0, 2000.0],
        mass: [1e-6, 1e-12, 1e-12],
        centers: Centers {
            tension: Vector2::zeros(),
            shear: Vector2::zeros(),
            mass: Vector2::zeros(),
        },
        stiffness_angle: 0.0,
        inertia_angle: 0.0,
    };
    let third = CubicTable::from_fn(|at| if at == [0, 1, 1] { T144 } else { 0.0 });
    let section = SectionProperties {
        prestress: Some(Prestress {
            strain_measure: StrainMeasure::Biot,
            third,
            per_kelvin: None,
        }),
        ..written.section("flex", Provenance::default())
    };
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("flex.properties.json");
    std::fs::write(&file, section::write(&section)).unwrap();
    let loads = format!(
        "[[load]]\nnode = \"r 1/root\"\nforce = [{PULL:?}, 0, 0]\nmoment = [{TORQUE:?}, 0, 0]\n[static]\n"
    );
    let soft =
        "speed = 0\n[rotor.swashplate]\ncollective = 0\n[rotor.pitch_link]\nstiffness = 1e-6\n";
    let filed = format!("[properties.filed]\nfile = {:?}\nprestress = true\n", file);
    let text = rotor(1, soft, &loads).replace("properties = \"flex\"", "properties = \"filed\"");
    let text = text.replace("[[rotor]]", &format!("{filed}[[rotor]]"));
    let (_, _, turn) = equilibrium(&text, "r 1/root");
    let found = vector::from_rotation(&turn).x;
    let mut twist = 0.0;
    for _ in 0..100 {
        let strain = (PULL - 0.5 * T144 * twist * twist) / EA;
        twist = TORQUE / (GJ + T144 * strain);
    }
    assert!(twist * GJ < 0.6 * TORQUE);
    assert!(
        (found / (twist * LENGTH) - 1.0).abs() < 1e-6,
        "{found} {}",
        twist * LENGTH
    );
}
