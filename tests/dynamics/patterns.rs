//! Modes of rotors of three to six equal blades are one pattern of the blades each, however near their
//! frequencies are: on hubs that move, in turning axes, and on rigid ones with air, by all methods of stability.

use beam_dynamics::analysis::modes::modes;
use beam_dynamics::analysis::stability::stability;
use beam_dynamics::input;

use crate::effort::is_long;
use crate::periodic::Random;

fn between(random: &mut Random, low: f64, high: f64) -> f64 {
    low + 0.5 * (high - low) * (1.0 + random.next())
}

/// Blades on a hub with a mass and springs, at a speed \[rpm\].
fn on_springs(random: &mut Random, blades: usize) -> String {
    let mass = 10_f64.powf(between(random, 1.0, 6.0));
    let spring = 10_f64.powf(between(random, 3.0, 9.0));
    let [flap, lag] = [1e3, 4e3].map(|own| own * between(random, 1.0, 10.0));
    format!(
        "units = \"SI\"\n[properties.p]\nea = 1e7\ngay = 3e6\ngaz = 3e6\ngj = 500\n\
         eiy = {flap}\neiz = {lag}\nm = 2.0\niy = 0.001\niz = 0.004\n\
         [hub]\nmass = {mass}\ninertia = [{mass}, {mass}, {mass}]\n\
         support = {{ in_plane = {spring}, axial = {spring}, tilt = {spring}, torsion = {spring} }}\n\
         [[blade]]\nname = \"b\"\ncount = {blades}\nhub_radius = 0.3\nproperties = \"p\"\n\
         [[blade.piece]]\nlength = 3\nelements = 2\n\
         [modes]\nspeeds = [{}]\ncount = {}\n",
        between(random, 0.0, 300.0),
        5 * blades
    )
}

// Equal blades on a hub that is alike in both directions across the axis: the turn by a blade is a symmetry of the
// equations, and each mode has one pattern. The shares are one to the round-off of the vectors over the distance
// of the frequencies, which is small for heavy hubs on stiff springs.
#[test]
fn modes_on_moving_hubs_have_one_pattern() {
    let mut random = Random(22);
    for case in 0..100 {
        let blades = 3 + case % 4;
        let text = on_springs(&mut random, blades);
        let input = input::parse(&text, "rotor.dynamics.toml");
        let input = input.unwrap_or_else(|problems| panic!("{problems}"));
        let outcome = modes(&input.model, &input.modes.unwrap());
        for branch in &outcome.table.branches {
            let point = branch.points[0].as_ref().unwrap();
            let Some(whirl) = point.whirl else { continue };
            assert!(whirl.share > 0.999, "{} {whirl:?}\n{text}", branch.name);
        }
    }
}

/// Blades on a rigid hub in the wind along the shaft.
fn rigid(random: &mut Random, blades: usize, by: &str) -> String {
    let speed = between(random, 15.0, 40.0);
    let [flap, lag] = [1e5, 4e5].map(|own| own * between(random, 0.5, 2.0));
    format!(
        "[units]\nangle = \"rad\"\nrotation_speed = \"rad/s\"\n[parameters]\np = {}\n\
         [properties.spar]\nea = 7e8\ngay = 2e8\ngaz = 2e8\ngj = 3e5\neiy = {flap}\neiz = {lag}\nm = 9\n\
         iy = 1e-2\niz = 3e-2\ndamping = {{ time = 1e-3 }}\n[air]\ndensity = 1.225\nwind = [0, 0, \"= -p\"]\n\
         [[rotor]]\nname = \"r\"\nhub = \"rigid\"\nblades = {blades}\nspeed = {speed}\n\
         [rotor.swashplate]\ncollective = 0.1\n[rotor.blade]\nhub_radius = 0.3\nproperties = \"spar\"\n\
         piece = [{{ length = 4.7, elements = 2 }}]\n\
         [rotor.blade.aerodynamics]\nsection = \"quasi_steady\"\nstrips = 3\nstations = [\n\
         {{ at = 0.6, chord = 0.3, airfoil = \"naca0012\" }},\n\
         {{ at = 4.7, chord = 0.3, airfoil = \"naca0012\" }} ]\n\
         [periodic]\nspeed = {speed}\nsteps = 48\n[periodic.floquet]\nerror_estimate = false\n\
         [modes]\nspeeds = [{speed}]\ncount = {}\n\
         [stability]\nby = \"{by}\"\nparameter = \"p\"\nvalues = [3, 4]\nboundaries = false\ncount = {}\n",
        between(random, 2.0, 6.0),
        3 * blades,
        6 * blades,
    )
}

// Blades on a rigid hub do not act on each other: all patterns of a mode have one value in the axes of the blades.
// First and second flap modes are named once in each pattern by every method.
#[test]
fn modes_on_rigid_hubs_are_named_once_in_each_pattern() {
    let words = [
        &["collective", "progressive", "regressive"][..],
        &["collective", "progressive", "regressive", "differential"],
        &[
            "collective",
            "progressive",
            "regressive",
            "progressive x2",
            "regressive x2",
        ],
        &[
            "collective",
            "progressive",
            "regressive",
            "progressive x2",
            "regressive x2",
            "differential",
        ],
    ];
    for by in ["modes", "averaged", "Floquet"] {
        let mut random = Random(3);
        // The slower methods in the long form with five and six blades.
        let most = if by == "modes" || is_long() { 4 } else { 2 };
        for case in 0..most {
            let blades = 3 + case % 4;
            let text = rigid(&mut random, blades, by);
            let name = "rotor.dynamics.toml";
            let parsed = input::parse(&text, name).unwrap_or_else(|problems| panic!("{problems}"));
            let read = |given: &[(String, f64)]| input::parse_with(&text, name, given);
            let result = stability("rotor", parsed.stability.as_ref().unwrap(), None, &read);
            assert!(result.failures.is_empty(), "{:#?}", result.failures);
            let names: Vec<_> = result.points[0]
                .modes
                .iter()
                .map(|mode| &result.modes[*mode])
                .collect();
            let kinds: std::collections::BTreeSet<_> = names
                .iter()
                .filter_map(|name| name.split_once(' '))
                .filter_map(|(kind, rest)| Some(format!("{kind} {}", rest.split_once(' ')?.0)))
                .collect();
            assert!(kinds.len() >= 3, "{names:#?}");
            for kind in kinds {
                for pattern in words[blades - 3] {
                    let wanted = format!("{kind} {pattern}");
                    let found = names.iter().filter(|name| ***name == wanted).count();
                    assert_eq!(found, 1, "{by} {wanted} {blades} {names:#?}");
                }
            }
        }
    }
}
