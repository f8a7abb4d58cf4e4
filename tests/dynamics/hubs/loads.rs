//! Loads of rotors of equal blades on the fixed frame.

use beam_dynamics::result::Harmonics;

use super::{over_period, parsed};

/// Steps in a revolution: a multiple of the numbers of blades.
const STEPS: usize = 24;

/// A rotor with elastic blades in forward flight under gravity, and the part between hub and blade.
fn text(hub: &str, blades: usize, joint: &str) -> String {
    let hinge = if hub == "articulated" {
        "[[rotor.hinge]]\nkind = \"flap\"\noffset = 0.1\nstiffness = 20\n"
    } else {
        ""
    };
    let column = |name: &str, quantity: &str, of: &str| {
        format!("[[output.column]]\nname = \"{name}\"\nquantity = \"{quantity}\"\nof = \"{of}\"\n")
            + "component = [\"x\", \"y\", \"z\"]\n"
    };
    let columns = column("f", "reaction_force", "r/shaft")
        + &column("m", "reaction_moment", "r/shaft")
        + &column("bf", "reaction_force", joint)
        + &column("bm", "reaction_moment", joint)
        + &column("x", "position", joint);
    format!(
        "units = \"SI\"\n[properties.spar]\nea = 7e7\ngay = 2e7\ngaz = 2e7\ngj = 4e4\neiy = 3e3\neiz = 2e4\n\
         m = 2\niy = 1e-4\niz = 1e-3\ndamping = {{ time = 1e-3 }}\n\
         [gravity]\nacceleration = [0, 0, -9.81]\n[air]\ndensity = 1.225\nwind = [15, 0, 0.5]\n\
         [airfoils.section]\nslope = 5.7\ndrag = 0.01\n\
         [[rotor]]\nname = \"r\"\nhub = \"{hub}\"\nblades = {blades}\nspeed = 300\n{hinge}\
         [rotor.swashplate]\ncollective = 6\ncosine = 1\nsine = -2\n\
         [rotor.blade]\nhub_radius = 0.2\nproperties = \"spar\"\npiece = [{{ length = 1.8, elements = 1 }}]\n\
         [rotor.blade.aerodynamics]\nsection = \"quasi_steady\"\nstrips = 3\nstations = [\n\
         {{ at = 0, chord = 0.12, airfoil = \"section\" }}, {{ at = 1.8, chord = 0.12, airfoil = \"section\" }} ]\n\
         [periodic]\nspeed = 300\nsteps = {STEPS}\n[output]\n{columns}"
    )
}

// The hub has no mass, so that the reaction of the shaft is the sum of the forces of the hub on the blades, about
// its center; blade k has the loads of the first one a part k/N of a revolution later, so that one blade gives
// all. Its loads have all harmonics, the sum only multiples of N: to the tolerance of the periodic motion, 1e-9,
// relative to the loads of a blade, times the stiffness of the blades: 1e-6.
#[test]
fn equal_blades_pass_only_multiples_of_their_number() {
    for (hub, blades, joint) in [
        ("rigid", 3, "r 1/pitch"),
        ("articulated", 4, "r 1/flap"),
        ("rigid", 2, "r 1/pitch"),
    ] {
        let input = parsed(&text(hub, blades, joint));
        let rows = over_period(&input);
        assert_eq!(rows.rows.len(), STEPS);
        let of_blade = |row: &[f64]| {
            let [fx, fy, fz, mx, my, mz, x, y, z] = row[6..15].try_into().unwrap();
            let about = [
                mx + y * fz - z * fy,
                my + z * fx - x * fz,
                mz + x * fy - y * fx,
            ];
            [fx, fy, fz, about[0], about[1], about[2]]
        };
        let one: Vec<_> = rows.rows.iter().map(|row| of_blade(row)).collect();
        for component in 0..6 {
            let blade: Vec<_> = one.iter().map(|loads| loads[component]).collect();
            let shaft = rows.column(component);
            let size = blade
                .iter()
                .fold(0.0_f64, |most, load| most.max(load.abs()));
            assert!(size > 1.0, "{hub} {component}: {size}");
            for (step, found) in shaft.iter().enumerate() {
                let at = |k: usize| blade[(step + k * STEPS / blades) % STEPS];
                let expected: f64 = (0..blades).map(at).sum();
                let off = (found - expected).abs();
                assert!(
                    off < 1e-6 * size,
                    "{hub} {component} {step}: {found} {expected}"
                );
            }
            let waves = |of: &[f64]| {
                let found = Harmonics::of(of, 2 * blades);
                let parts = found.parts.iter();
                parts.map(|[c, s]| c.hypot(*s)).collect::<Vec<_>>()
            };
            let (rotating, fixed) = (waves(&blade), waves(&shaft));
            assert!(rotating[0] > 1e-3 * size, "{hub} {component}: {rotating:?}");
            for (index, wave) in fixed.iter().enumerate() {
                match (index + 1) % blades {
                    0 if index < blades => {
                        assert!(*wave > 1e-5 * size, "{hub} {component}: {fixed:?} {size}");
                    }
                    0 => {}
                    _ => assert!(*wave < 1e-6 * size, "{hub} {component}: {fixed:?} {size}"),
                }
            }
        }
    }
}
