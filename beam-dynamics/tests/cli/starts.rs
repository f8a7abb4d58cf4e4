//! Starts of runs in time: rotation with gravity across the axis, shapes of modes, released loads,
//! moving blades.

use std::f64::consts::TAU;

use super::*;

/// Rows of a table of a run, time first.
fn rows(folder: &Folder, name: &str) -> Vec<Vec<f64>> {
    let table = folder.read(&format!("results/{name}.transient.csv"));
    let cells = |line: &str| line.split(',').map(|cell| cell.parse().unwrap()).collect();
    table.lines().skip(1).map(cells).collect()
}

/// Runs a file that must reach its end; the printed text.
fn done(folder: &Folder, text: &str) -> String {
    folder.write("a.dynamics.toml", text);
    let run = folder.run(&["transient", "a.dynamics.toml", "--no-figures"]);
    assert_eq!(run.code, 0, "{}{}", run.out, run.err);
    run.out
}

/// A uniform blade of 4 m and 2 kg/m along x.
const UNIFORM: &str = "\
units = \"SI\"
[properties.p]
ea = 1e9
gay = 1e8
gaz = 1e8
gj = 1e5
eiy = EI
eiz = EI
m = 2
iy = 1e-5
iz = 1e-5
";

/// A blade whose root a shaft turns at 30 rpm, with gravity across the shaft.
fn wheel() -> String {
    UNIFORM.replace("EI", "1e7")
        + "\
[[blade]]
name = \"b\"
root = [0, 0, 0]
properties = \"p\"
clamp_root = false
[[blade.piece]]
length = 4
elements = 4
[[joint]]
name = \"shaft\"
kind = \"revolute\"
nodes = [\"b/root\"]
at = [0, 0, 0]
axis = [0, 0, 1]
angle = \"= 180 * t\"
[gravity]
acceleration = [0, -9.81, 0]
[transient]
to = 2
step = 0.001
start = \"rotating\"
speed = \"30 rpm\"
[[output.column]]
name = \"edge\"
quantity = \"reaction_moment\"
of = \"shaft\"
component = \"z\"
"
}

// A stiff blade (first frequency EI 1e7, 2 kg/m, 4 m: 78 Hz, against 0.5 Hz): the torque of the
// shaft carries the moment of the weight, m g L^2/2 cos(W t) = 156.96 N m cos(W t), from the first
// instant on. Amplification (0.5/78)^2 = 4e-5; reactions of driven joints lag by a part of a step,
// here 157 N m * 0.003 rad = 0.5 N m at most.
#[test]
fn the_edgewise_moment_of_a_rotating_blade_follows_its_weight() {
    let folder = Folder::new();
    let text = done(&folder, &wheel());
    assert!(text.contains("across the axis of rotation"), "{text}");
    assert!(text.contains("(1.00 turns) of node"), "{text}");
    let rows = rows(&folder, "a");
    let sign = rows[0][1].signum();
    for row in rows {
        let expected = sign * 156.96 * (TAU * 0.5 * row[0]).cos();
        assert!((row[1] - expected).abs() < 1.0, "{row:?} {expected}");
    }
}

/// A cantilever along x that starts by `start`.
fn cantilever(start: &str, cards: &str) -> String {
    UNIFORM.replace("EI", "1e4")
        + &format!(
            "\
[[blade]]
name = \"b\"
root = [0, 0, 0]
properties = \"p\"
[[blade.piece]]
length = 4
elements = 8
{cards}
[transient]
to = 0.5
step = 5e-4
scheme = \"cubic\"
radius = 1
{start}
[[output.column]]
name = \"tip\"
quantity = \"displacement\"
of = \"b/tip\"
component = \"z\"
"
        )
}

/// Mean frequency of an oscillation by its first and last crossing of zero \[Hz\].
fn frequency(rows: &[Vec<f64>]) -> f64 {
    let pairs = rows.windows(2).filter(|pair| pair[0][1] * pair[1][1] < 0.0);
    let crossings = pairs.map(|pair| {
        let part = pair[0][1] / (pair[0][1] - pair[1][1]);
        pair[0][0] + part * (pair[1][0] - pair[0][0])
    });
    let crossings: Vec<_> = crossings.collect();
    let half_periods = (crossings.len() - 1) as f64;
    half_periods / (2.0 * (crossings[crossings.len() - 1] - crossings[0]))
}

// The second bending mode of a cantilever, lambda = 4.694091: f = lambda^2/(2 pi L^2)
// sqrt(EI/m) = 15.50 Hz. Eight elements, shear (EI/(GA L^2) = 6e-6) and the step of a 130th of the
// period change it by less than 1e-3. The modes are flap 1, lag 1, flap 2: it is the third. A pure
// mode crosses zero with its period and keeps its amplitude.
#[test]
fn a_start_in_the_second_bending_mode_oscillates_with_its_frequency() {
    let folder = Folder::new();
    let start = "start = \"equilibrium\"\nshape = { mode = 3, displacement = \"1 mm\" }";
    // Softer in flap than in lag, so that the modes are single.
    let text = cantilever(start, "").replace("eiz = 1e4", "eiz = 2.1e4");
    let printed = done(&folder, &text);
    let rows = rows(&folder, "a");
    assert!((rows[0][1].abs() - 1e-3).abs() < 1e-9, "{printed}");
    let expected = 4.694_091_f64.powi(2) / (TAU * 16.0) * (1e4_f64 / 2.0).sqrt();
    let found = frequency(&rows);
    assert!((found / expected - 1.0).abs() < 2e-3, "{found} {expected}");
    let late = rows.iter().filter(|row| row[0] > 0.4);
    let most = late.fold(0.0_f64, |most, row| most.max(row[1].abs()));
    assert!((most / 1e-3 - 1.0).abs() < 0.02, "{most}");
}

// P L^3/(3 EI) at the tip under 10 N, 21.33 mm, then released: the first mode contains nearly all
// of it and swings with lambda = 1.875104, 2.473 Hz. Higher modes move the crossings by some
// percent of a period of theirs, here 1e-2 of the first over one and a half periods.
#[test]
fn a_released_load_lets_the_beam_swing() {
    let folder = Folder::new();
    let load = "[[load]]\nnode = \"b/tip\"\nforce = [0, 0, 10]\nrelease = true";
    let text = cantilever("start = \"equilibrium\"", load);
    done(&folder, &text);
    let rows = rows(&folder, "a");
    let expected = 10.0 * 64.0 / 3e4;
    assert!((rows[0][1] / expected - 1.0).abs() < 1e-3, "{:?}", rows[0]);
    let period = TAU * 16.0 / (1.875_104_f64.powi(2) * (1e4_f64 / 2.0).sqrt());
    let at = |time: f64| rows.iter().find(|row| row[0] >= time).unwrap()[1];
    assert!((at(0.5 * period) / -expected - 1.0).abs() < 0.05);
    let idle = cantilever("", load);
    folder.write("a.dynamics.toml", &idle);
    let run = folder.run(&["check", "a.dynamics.toml"]);
    assert_eq!(run.code, 2);
    assert!(
        run.err.contains("\"release\" is for a run in time"),
        "{}",
        run.err
    );
    assert!(run.err.contains("start = \"equilibrium\""), "{}", run.err);
}

#[test]
fn a_shape_needs_an_equilibrium_and_a_mode_that_exists() {
    let folder = Folder::new();
    let shape = "shape = { mode = 2, displacement = 1e-3 }";
    folder.write("a.dynamics.toml", &cantilever(shape, ""));
    let run = folder.run(&["check", "a.dynamics.toml"]);
    assert_eq!(run.code, 2);
    let message = "\"shape\" is added to an equilibrium, but \"start\" is \"given\"";
    assert!(run.err.contains(message), "{}", run.err);
}

// A free blade that turns about a point of the model: v = w x r at every node, and the total
// momentum m L w L/2 = 2 * 4 * 3 * 2 = 48 kg m/s across it.
#[test]
fn a_blade_starts_with_its_velocities() {
    let folder = Folder::new();
    let text = UNIFORM.replace("EI", "1e4")
        + "\
[[blade]]
name = \"b\"
root = [0, 0, 0]
properties = \"p\"
clamp_root = false
velocity = [0, 0, 5]
angular_velocity = [0, 0, \"3 rad/s\"]
[[blade.piece]]
length = 4
elements = 2
[transient]
to = 0.01
step = 1e-3
[[output.column]]
name = \"tip\"
quantity = \"velocity\"
of = \"b/tip\"
[[output.column]]
name = \"root\"
quantity = \"velocity\"
of = \"b/root\"
";
    done(&folder, &text);
    let first = &rows(&folder, "a")[0];
    let expected = [0.0, 0.0, 12.0, 5.0, 0.0, 0.0, 5.0];
    for (found, expected) in first.iter().zip(expected) {
        assert!((found - expected).abs() < 1e-9, "{first:?}");
    }
    let without = text.split("[transient]").next().unwrap().to_owned();
    folder.write("a.dynamics.toml", &without);
    let run = folder.run(&["check", "a.dynamics.toml"]);
    assert_eq!(run.code, 2);
    assert_eq!(
        run.err.matches("has \"velocity\"").count(),
        1,
        "{}",
        run.err
    );
}

// One card for three blades gives the model of three cards.
#[test]
fn a_load_of_a_card_acts_on_all_its_blades() {
    let folder = Folder::new();
    let rotor = UNIFORM.replace("EI", "1e4")
        + "\
[[blade]]
name = \"b\"
count = 3
hub_radius = 0.5
properties = \"p\"
[[blade.piece]]
length = 4
elements = 2
[static]
";
    let cards = |blade: &str| {
        format!(
            "[[load]]\nnode = \"{blade}/tip\"\nforce = [0, 3, 5]\naxes = \"node\"\n\
             [[distributed_load]]\nblade = \"{blade}\"\nforce = [0, 2, 4]\naxes = \"section\"\n"
        )
    };
    let each: String = ["b 1", "b 2", "b 3"].map(cards).concat();
    folder.write("one.dynamics.toml", &(rotor.clone() + &cards("b")));
    folder.write("three.dynamics.toml", &(rotor.clone() + &each));
    let [one, three] = ["one", "three"].map(|name| {
        let file = format!("{name}.dynamics.toml");
        let run = folder.run(&["static", &file, "--no-figures"]);
        assert_eq!(run.code, 0, "{}", run.err);
        folder.read(&format!("results/{name}.displacements.csv"))
    });
    assert!(one == three, "{one}\n{three}");
    assert!(one.lines().count() > 12);
    let wrong = rotor + &cards("b").replace("b/tip", "b/tp");
    folder.write("a.dynamics.toml", &wrong);
    let run = folder.run(&["check", "a.dynamics.toml"]);
    assert_eq!(run.code, 2);
    assert_eq!(run.err.matches("unknown node").count(), 1, "{}", run.err);
}
