//! Cost of strips in the air: a run in time of one rotor with and without them.

use beam_dynamics::input;

use crate::rows::{SPAN, US};
use crate::runs::run;
use crate::table::Row;
use crate::yardstick::Yardstick;

const BLADES: usize = 3;
/// Beams of a blade.
const BEAMS: usize = 10;
/// Steps of a run.
const STEPS: usize = 20;
/// Rotor of three elastic blades, turned by its hub at 300 rpm.
const ROTOR: &str = "units = \"SI\"
[properties.blade]
ea = 7e9
gay = 9e8
gaz = 9e8
gj = 8e5
eiy = 7e5
eiz = 7e6
m = 11
iy = 0.01
iz = 0.05
[hub]
axis = [0, 0, 1]
mass = 10
inertia = [1, 1, 1]
support = { torsion = 0 }
[[blade]]
name = \"blade\"
count = 3
hub_radius = 0.5
pitch = 8
properties = \"blade\"
piece = [{ length = 5, elements = 10 }]
[[joint]]
name = \"drive\"
kind = \"spin\"
nodes = [\"hub\"]
axis = [0, 0, 1]
angle = \"= 1800 * t\"
[transient]
to = 0.01
step = 5e-4
start = \"rotating\"
speed = 300
";
/// Strips of its blades: two on each beam, with the default section in its annulus.
const AIR: &str = "[air]
density = 1.225
[[inflow]]
name = \"rotor\"
[blade.aerodynamics]
inflow = \"rotor\"
stations = [
  { at = 0, chord = 0.4, airfoil = \"naca0012\" },
  { at = 5, chord = 0.4, airfoil = \"naca0012\" },
]
";

/// The file of the rotor: the table of the strips belongs to its blades.
fn text(air: &str) -> String {
    let (blades, rest) = ROTOR.split_once("[[joint]]").unwrap_or((ROTOR, ""));
    let (cards, strips) = air.split_once("[blade.aero").unwrap_or(("", ""));
    match strips {
        "" => ROTOR.to_owned(),
        _ => format!("{blades}[blade.aero{strips}\n{cards}[[joint]]{rest}"),
    }
}

/// Processor time of a run per beam and iteration [s], its iterations and its choices of pivots.
fn iteration(yardstick: &mut Yardstick, air: &str) -> Option<(f64, [usize; 2])> {
    let parsed = input::parse(&text(air), "rotor.dynamics.toml");
    let input = parsed.map_err(|problems| println!("{problems}")).ok()?;
    let settings = input.transient?;
    let mut counts = [0; 2];
    let time = yardstick.beside(SPAN, || {
        let run = run(&input.model, &settings, STEPS)?;
        counts = [run.effort.iterations, run.effort.pivotings];
        Some(run.steps)
    })?;
    Some((time / (BLADES * BEAMS * counts[0]) as f64, counts))
}

/// Time that strips add to a beam and an iteration of a run in time: residual, Jacobian, their part
/// of the factorization, and the rest of the step.
pub fn strips(yardstick: &mut Yardstick) -> Option<Vec<Row>> {
    let (alone, _) = iteration(yardstick, "")?;
    let (time, [iterations, pivotings]) = iteration(yardstick, AIR)?;
    let added = time - alone;
    Some(vec![Row {
        name: format!("strips, {BLADES} blades of {BEAMS} beams"),
        ratio: added / yardstick.time(),
        // 25 us, with the yardstick of 7.9 us on the machine of the documented times.
        limit: 3.1,
        meaning: "added, beam and iteration / yardstick",
        time: format!("{:.2} us, beams {:.2}", added / US, alone / US),
        accuracy: format!("{iterations} iterations, {pivotings} pivotings in {STEPS} steps"),
    }])
}
