//! Blades without air: cards of the air without strips change nothing, and strips in air without
//! density change nothing but round-off. Random blades of a hub in rest, rotation and motion.

use beam_dynamics::analysis::modes::modes;
use beam_dynamics::analysis::statics::statics;
use beam_dynamics::input::{self, Input};

use crate::effort::cases;
use crate::in_time::Run;
use crate::record;
use crate::variational_beam::spectra::Random;

/// Random blades.
const BLADES: usize = 25;
/// Round-off of the equilibrium and of the eigenvalues, relative.
const TOLERANCE: f64 = 1e-8;

/// The cards of a random blade at a random speed.
fn blade(random: &mut Random) -> String {
    let mut between = |from: f64, to: f64| random.between(from, to);
    let stiffness = [between(1e5, 1e6), between(2e5, 2e6), between(5e4, 5e5)];
    let [eiy, eiz, gj] = stiffness;
    let (mass, rpm, cone) = (between(5.0, 20.0), between(20.0, 200.0), between(-5.0, 5.0));
    let (pitch, weight, twist) = (between(-5.0, 10.0), between(0.0, 50.0), between(-8.0, 8.0));
    let degrees = 6.0 * rpm;
    format!(
        "units = \"SI\"\n[properties.p]\nea = 4e8\ngay = 1e8\ngaz = 1e8\ngj = {gj}\neiy = {eiy}\n\
         eiz = {eiz}\nm = {mass}\niy = 0.2\niz = 1\n[hub]\naxis = [0, 0, 1]\nmass = 10\n\
         inertia = [1, 1, 1]\nsupport = {{ torsion = 0 }}\n\
         [[blade]]\nname = \"b\"\nhub_radius = 0.5\npitch = {pitch}\nprecone = {cone}\n\
         properties = \"p\"\npiece = [{{ length = 5, elements = 2, twist = [{twist}, 0] }}]\n\
         STRIPS[[load]]\nnode = \"b/tip\"\nforce = [0, 0, {weight}]\n\
         [[joint]]\nname = \"drive\"\nkind = \"spin\"\nnodes = [\"hub\"]\naxis = [0, 0, 1]\n\
         angle = \"= {degrees} * t\"\n[static]\nspeed = {rpm}\n[modes]\nspeeds = [{rpm}]\ncount = 8\n\
         [transient]\nto = 0.01\nstep = 1e-3\nstart = \"rotating\"\nspeed = {rpm}\n"
    )
}

/// Positions of all nodes at rest, frequencies and growths of the first four modes, and positions at
/// the end of a run. Modes of the states of the air alone, which are damped, are left out.
fn results(text: &str) -> [Vec<f64>; 3] {
    let read = || -> Input { input::parse(text, "blade.dynamics.toml").unwrap() };
    let input = read();
    let rest = statics(&input.model, &input.statics.unwrap());
    assert!(rest.failure.is_none(), "{:?}\n{text}", rest.failure);
    let positions = rest.result.steps.last().unwrap().positions.iter();
    let positions = positions.flat_map(|at| [at.x, at.y, at.z]).collect();
    let found = modes(&input.model, &input.modes.unwrap());
    assert!(found.failure.is_none(), "{:?}\n{text}", found.failure);
    let points = found.table.at_speed(0).into_iter();
    let points = points.filter(|(_, point)| point.growth > -1e-3 * point.frequency);
    let points = points
        .take(4)
        .flat_map(|(_, point)| [point.frequency, point.growth]);
    let points = points.collect();
    let input = read();
    let run = Run::of_any(input.model, &input.transient.unwrap(), 1);
    run.check_end();
    let last = &run.instants.last().unwrap().1;
    let ends = last.nodes.iter().map(|node| node.position);
    [
        positions,
        points,
        ends.flat_map(|at| [at.x, at.y, at.z]).collect(),
    ]
}

/// Largest difference of numbers, relative to the largest.
fn apart(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    let size = b.iter().fold(0.0_f64, |size, value| size.max(value.abs()));
    let pairs = a.iter().zip(b);
    pairs.map(|(a, b)| (a - b).abs() / size).fold(0.0, f64::max)
}

const STRIPS: &str = "[blade.aerodynamics]\ninflow = \"rotor\"\nsection = \"SECTION\"\nstations = [\n\
    { at = 0, chord = 0.4, airfoil = \"naca0012\" },\n\
    { at = 5, chord = 0.3, airfoil = \"naca0012\" },\n]\n";

#[test]
fn air_without_strips_or_without_density_is_vacuum() {
    let mut random = Random(17);
    let sections = ["quasi_steady", "lagged", "separation_lag", "oye", "hgm"];
    let mut largest = [0.0_f64; 3];
    for number in 0..cases(BLADES) {
        let text = blade(&mut random);
        let vacuum = results(&text.replace("STRIPS", ""));
        let cards = |density: &str| {
            format!("[air]\ndensity = {density}\nwind = [0, 0, 5]\n[[inflow]]\nname = \"rotor\"\n")
        };
        let unused = results(&(text.replace("STRIPS", "") + &cards("1.225")));
        assert_eq!(unused, vacuum, "{text}");
        let strips = STRIPS.replace("SECTION", sections[number % sections.len()]);
        let thin = results(&(text.replace("STRIPS", &strips) + &cards("1e-10")));
        for ((largest, thin), vacuum) in largest.iter_mut().zip(&thin).zip(&vacuum) {
            *largest = largest.max(apart(thin, vacuum));
        }
    }
    for (word, largest) in ["equilibria", "modes", "runs in time"].iter().zip(largest) {
        let case = format!("{} random blades in air without density", cases(BLADES));
        record::largest(
            "the same blades without air",
            &case,
            word,
            largest,
            TOLERANCE,
        );
        assert!(largest < TOLERANCE, "{word}: {largest:.1e}");
    }
}
