//! Electrodes of beams: results of runs, and problems of their cards.

use nalgebra::DMatrix;
use shared_geom::section::{self, Piezo};

use super::{Folder, strip};

/// Two strips in a row and a separate one without electrodes.
const STRIPS: &str = "\
units = \"SI\"
[properties.strip]
file = \"piezo.properties.json\"
[properties.plain]
file = \"strip.properties.json\"
[[blade]]
name = \"blade\"
properties = \"strip\"
[[blade.piece]]
length = 1
elements = 2
[[blade]]
name = \"other\"
properties = \"plain\"
azimuth = 90
[[blade.piece]]
length = 1
elements = 2
[static]
[modes]
speeds = [0]
count = 2
";

fn folder(capacitance: [f64; 3]) -> Folder {
    let folder = Folder::new();
    let mut properties = strip();
    let mut coupling = DMatrix::zeros(6, 2);
    (coupling[(4, 0)], coupling[(0, 1)]) = (1e-4, 0.2);
    let [a, b, c] = capacitance;
    properties.piezo = Some(Piezo {
        electrodes: vec!["top".to_owned(), "bottom".to_owned()],
        coupling,
        capacitance: DMatrix::from_row_slice(2, 2, &[a, b, b, c]),
    });
    folder.write("piezo.properties.json", &section::write(&properties));
    folder
}

const SOUND: [f64; 3] = [1e-6, 0.0, 1e-6];

fn card(lines: &str) -> String {
    format!("[[electrode]]\n{lines}\n")
}

/// The report of statics has voltages and charges, the remarks list the sources and the
/// electrodes without a card; `theta^2 / EI + c` is 1e-8 / 0.634 + 1e-6 C per volt.
#[test]
fn statics_reports_electrodes() {
    let folder = folder(SOUND);
    let cards = card("name = \"top\"\nblade = \"blade\"\nvoltage = \"50 V\"");
    folder.write("a.dynamics.toml", &format!("{STRIPS}{cards}"));
    let run = folder.run(&["static", "a.dynamics.toml"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    let charge = 50.0 * (1e-6 + 1e-8 / 0.634);
    for reported in [
        "Electrodes under the constant loads",
        "electrode \"top\": voltage 50 V",
        "no [[electrode]] names electrode \"bottom\" of \"blade/beam 1\", \"blade/beam 2\": its \
         voltage is zero",
    ] {
        assert!(run.out.contains(reported), "{reported}\n{}", run.out);
    }
    let table = folder.read("results/a.electrodes.csv");
    let last = table.lines().last().unwrap();
    let cells: Vec<_> = last.split(',').collect();
    assert_eq!(cells[1..4], ["0", "top", "50"]);
    let found: f64 = cells[4].parse().unwrap();
    assert!((found / charge - 1.0).abs() < 1e-8, "{table}");
}

/// A run in time has the columns of its electrodes unless it requests others, and continues
/// from a restart file with their charges, to the last bit where both runs wrote one.
#[test]
fn runs_in_time_write_and_continue_circuits() {
    let folder = folder(SOUND);
    let cards = card("name = \"top\"\nblade = \"blade\"\nvoltage = \"= 50*cos(300*t)\"")
        + &card("name = \"bottom\"\nblade = \"blade\"\nresistance = \"2 kOhm\"\ninductance = 0.5");
    let input = |to: f64| {
        let all_settings = format!("[transient]\nto = {to}\nstep = 1e-4\n");
        let text = STRIPS.split("[static]").next().unwrap();
        format!("{text}{cards}{all_settings}[output]\nrestart_every = 20\n")
    };
    folder.write("a.dynamics.toml", &input(4e-3));
    let run = folder.run(&["transient", "a.dynamics.toml"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""), "{}", run.out);
    let whole = folder.read("results/a.transient.csv");
    for name in [
        "voltage_top [V]",
        "charge_bottom [C]",
        "current_bottom [A]",
        "electric_energy [J]",
    ] {
        assert!(whole.lines().next().unwrap().contains(name), "{name}");
    }
    folder.write("a.dynamics.toml", &input(2e-3));
    let run = folder.run(&["transient", "a.dynamics.toml"]);
    assert_eq!(run.code, 0, "{}", run.err);
    folder.write("a.dynamics.toml", &input(4e-3));
    let restart = ["--restart", "results/a.restart.json"];
    let run = folder.run(&["transient", "a.dynamics.toml", restart[0], restart[1]]);
    assert_eq!(run.code, 0, "{}", run.err);
    assert!(folder.read("results/a.transient.csv") == whole);
}

/// Expects the cards to be refused with the message at the line, and nothing else.
#[track_caller]
fn refuses(cards: &str, line: usize, message: &str) {
    let expected = format!("error: a.dynamics.toml:{line}: {message}");
    folder(SOUND).refuses(&format!("{STRIPS}{cards}"), &expected);
}

/// Problems of the names and beams of a card, with their remedies.
#[test]
fn wrong_names_and_beams_are_reported() {
    let top = "name = \"top\"\nblade = \"blade\"\n";
    for (cards, line, message) in [
        (
            card("name = \"tpo\"\nblade = \"blade\"\nvoltage = 1"),
            25,
            "no beam of blade \"blade\" has an electrode \"tpo\"\n  \
             help: did you mean \"top\"? write electrode = \"top\"",
        ),
        (
            card("name = \"a\"\nelectrode = \"topp\"\nbeams = [\"blade/beam 1\"]\nvoltage = 1"),
            26,
            "beam \"blade/beam 1\" has no electrode \"topp\"\n  \
             help: did you mean \"top\"? write electrode = \"top\"",
        ),
        (
            card("name = \"top\"\nbeams = [\"other/beam 1\"]\nvoltage = 1"),
            25,
            "beam \"other/beam 1\" of electrode \"top\" has no electrodes: its properties have \
             no \"piezo\"\n  help: name beams whose property file has electrodes, or analyze the \
             section with electrodes",
        ),
        (
            card("name = \"top\"\nblade = \"other\"\nvoltage = 1"),
            25,
            "no beam of blade \"other\" has an electrode \"top\"\n  \
             help: property files with \"piezo\" have electrodes; blades from blade files have none",
        ),
        (
            card(&format!("{top}voltage = 1"))
                + &card(
                    "name = \"b\"\nelectrode = \"top\"\nbeams = [\"blade/beam 2\"]\ncharge = 0",
                ),
            29,
            "electrode \"top\" of beam \"blade/beam 2\" belongs to \"top\" on line 24 already, \
             expected one card\n  help: remove the beam from one of the cards, or remove the card",
        ),
    ] {
        refuses(&cards, line, message);
    }
}

/// Problems of a circuit, with their remedies.
#[test]
fn wrong_circuits_are_reported() {
    let top = "name = \"top\"\nblade = \"blade\"\n";
    for (cards, line, message) in [
        (
            card(top.trim_end()),
            24,
            "electrode \"top\" has no circuit, expected \"voltage\", \"charge\", \"resistance\" \
             or \"inductance\"\n  help: voltage = 0 connects it to ground, charge = 0 leaves it \
             open, resistance = 1e4 is a resistor to ground",
        ),
        (
            card(&format!("{top}charge = 0\nresistance = 5")),
            27,
            "\"charge\" holds the charge of electrode \"top\", and \"resistance\" would let it \
             flow, expected one of them\n  help: without \"charge\", the charge follows from the \
             circuit and begins with the charge at the voltage of its source",
        ),
        (
            card(&format!("{top}resistance = 0")),
            26,
            "\"resistance\" of electrode \"top\" is zero, expected more than zero if there is \
             no \"inductance\"\n  help: leave \"resistance\" out: the voltage is then the voltage \
             of its source",
        ),
        (
            card(&format!("{top}resistance = -5")),
            26,
            "\"resistance\" is -5, expected a resistance, zero or more",
        ),
        (
            "[drives.sway]\nkind = \"harmonic\"\namplitude = 1\nfrequency = 2\n".to_owned()
                + &card(&format!("{top}voltage = \"swya\"")),
            30,
            "unknown drive \"swya\" in \"voltage\"\n  help: did you mean \"sway\"?",
        ),
        (
            card("name = \"top\"\nvoltage = 1"),
            23,
            "the card has neither \"blade\" nor \"beams\", expected one of them",
        ),
    ] {
        refuses(&cards, line, message);
    }
}

/// Capacitances that do not determine a voltage, each on the line of its card.
#[test]
fn charges_need_a_capacitance() {
    let open = |name: &str| card(&format!("name = \"{name}\"\nblade = \"blade\"\ncharge = 0"));
    let help = "correct \"capacitance\" in the property file, charge per length and volt at \
                constant strain; only electrodes with a given voltage work without it";
    let negative = folder([-1e-6, 0.0, 1e-6]);
    negative.refuses(
        &format!("{STRIPS}{}", open("top")),
        &format!(
            "error: a.dynamics.toml:24: the capacitance of electrode \"top\", -1.000000e-6 F with \
             all beams of the card, is not positive\n  help: {help}"
        ),
    );
    let indefinite = folder([1e-6, 2e-6, 1e-6]);
    let cards = open("top") + &open("bottom");
    indefinite.refuses(
        &format!("{STRIPS}{cards}"),
        &format!(
            "error: a.dynamics.toml:24: the capacitances of electrodes \"top\", \"bottom\" are not \
             positive definite: some voltages would give charges of the opposite \
             sign\n  help: {help}"
        ),
    );
    // A given voltage needs no capacitance.
    let text = card("name = \"top\"\nblade = \"blade\"\nvoltage = 3");
    negative.write("a.dynamics.toml", &format!("{STRIPS}{text}"));
    assert_eq!(negative.run(&["check", "a.dynamics.toml"]).code, 0);
}

/// All problems are reported at once.
#[test]
fn several_cards_are_reported_together() {
    let folder = folder(SOUND);
    let cards = card("name = \"tpo\"\nblade = \"blade\"\nvoltage = 1")
        + &card("name = \"bottom\"\nblade = \"blade\"\nresistance = -1");
    let output = "[transient]\nto = 1\nstep = 0.1\n[[output.column]]\nname = \"v\"\n\
                  quantity = \"voltage\"\nof = \"botom\"\n";
    folder.write("a.dynamics.toml", &format!("{STRIPS}{cards}{output}"));
    let run = folder.run(&["check", "a.dynamics.toml"]);
    assert_eq!(run.code, 2);
    for reported in [
        "a.dynamics.toml:25: no beam of blade \"blade\" has an electrode \"tpo\"",
        "a.dynamics.toml:30: \"resistance\" is -1, expected a resistance, zero or more",
        "a.dynamics.toml:37: unknown electrode \"botom\" in column \"v\"\n  \
         help: did you mean \"bottom\"?",
    ] {
        assert!(run.err.contains(reported), "{reported}\n{}", run.err);
    }
}
