//! The active-twist rotor of Masarati's thesis, chapter 13, from the mesh of its section to tables
//! 13.6 and 13.7 and figures 13.6 to 13.9.
//!
//! ```sh
//! cargo run --example active_twist_rotor              # all conditions
//! cargo run --example active_twist_rotor -- --short   # a coarser model, one flight condition
//! ```
//!
//! It takes one to two minutes; both forms draw into `results`.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

mod figures;
mod flight;
mod harmonics;
mod hover;
mod motion;
mod response;
mod sections;

use figures::POUND;
use flight::{CONDITIONS, Condition, Flight, Sizes, flight, trimmed, vibration};
use hover::{Hover, MODES, frequencies, hover};
use motion::Motion;
use response::{Response, response};
use sections::SETS;

/// Results with problems as text.
pub type Result<T> = std::result::Result<T, String>;

/// Folder of the case, relative to the repository.
const CASE: &str = "cases/chain/active_twist_rotor";
/// The section.
const SECTION: &str = "cases/section/active_twist_section/active_twist_section.section.toml";

/// The model of the short form.
const COARSE: [(&str, f64); 4] = [
    ("elements", 2.0),
    ("strips", 2.0),
    ("steps", 24.0),
    ("tolerance", 1e-4),
];
/// The model of all conditions.
const FINE: [(&str, f64); 4] = [
    ("elements", 3.0),
    ("strips", 2.0),
    ("steps", 30.0),
    ("tolerance", 1e-5),
];

/// Twist of the root against 75 % of the radius \[deg\].
const ROOT_TWIST: f64 = 5.784;
/// Advance ratio of a trim without voltage.
const SLOW: f64 = 0.14;
/// Values of the thesis: Table 13.6 in the order of [`MODES`], by its own section and by reference 90.
const TABLE_13_6: [[f64; 6]; 2] = [
    [1.02, 2.58, 4.55, 6.89, 3.38, 10.0],
    [1.02, 2.59, 4.69, 7.31, 3.31, 9.65],
];
/// Table 13.7: tip \[ft\], flap \[deg\], twist \[deg\], thrust \[lbf\]; reference 90, diagonal, coupled.
const TABLE_13_7: [[f64; 4]; 3] = [
    [1.1053, 2.275, -0.006, 5119.0],
    [1.1057, 2.276, -0.005, 5133.0],
    [1.0343, 2.129, -0.120, 4906.0],
];

fn main() -> ExitCode {
    let mut arguments = std::env::args().skip(1);
    let is_long = match (arguments.next().as_deref(), arguments.next()) {
        (None, _) => true,
        (Some("--short"), None) => false,
        _ => {
            eprintln!("error: unknown arguments\n  help: no argument, or --short");
            return ExitCode::from(2);
        }
    };
    match run(is_long) {
        Ok(()) => ExitCode::SUCCESS,
        Err(problem) => {
            eprintln!("error: {problem}");
            ExitCode::from(1)
        }
    }
}

/// The repository: the current folder, or the one in which the runner was built.
fn root() -> PathBuf {
    if Path::new(CASE).is_dir() {
        PathBuf::new()
    } else {
        PathBuf::from(env!("CARGO_MANIFEST_DIR"))
    }
}

fn run(is_long: bool) -> Result<()> {
    let root = root();
    let case = root.join(CASE);
    analyze(&root.join(SECTION))?;
    sections::write(&case)?;
    show_frequencies(&case)?;
    show_hover(&case)?;
    let voltages = voltages(&case)?;
    let model = if is_long { FINE } else { COARSE };
    let (responses, flights) = std::thread::scope(|scope| {
        let other = scope.spawn(|| responses(&case, is_long));
        let flights = flights(&case, is_long, &model);
        let responses = other.join();
        let responses = responses.unwrap_or_else(|_| Err("the response ended".to_owned()));
        Ok::<_, String>((responses?, flights?))
    })?;
    show_responses(&responses);
    let folder = case.join("results");
    println!("\nFigures");
    figures::voltages(&folder, &voltages)?;
    figures::response(&folder, &responses)?;
    for own in &flights {
        figures::moments(&folder, own)?;
    }
    figures::phases(&folder, &flights)
}

/// Runs `section-analyzer analyze` as on the command line.
fn analyze(section: &Path) -> Result<()> {
    println!("$ section-analyzer analyze {}", section.display());
    let arguments = ["section-analyzer".into(), "analyze".into(), section.into()];
    let (mut out, mut err) = (Vec::new(), Vec::new());
    match section_analyzer::cli::run(arguments, &mut out, &mut err) {
        0 => Ok(()),
        _ => Err(String::from_utf8_lossy(&err).into_owned()),
    }
}

fn show_frequencies(case: &Path) -> Result<()> {
    println!("\nFrequencies in vacuum [1/rev]: Table 13.6, and found with the stiffness of");
    println!("the case, of Table 13.3 and, against the fifth column, of reference 90\n");
    println!(
        "{:12}{:>9}{:>9}{:>12}{:>9}{:>11}",
        "", "thesis", "case", "table 13.3", "ref. 90", "found"
    );
    let [own, table, reference] = [SETS[0], SETS[2], SETS[4]].map(|set| frequencies(case, set));
    let (own, table, reference) = (own?, table?, reference?);
    for (index, [name, _]) in MODES.iter().enumerate() {
        println!(
            "{name:12}{:9.2}{:9.3}{:12.3}{:9.2}{:11.3}",
            TABLE_13_6[0][index], own[index], table[index], TABLE_13_6[1][index], reference[index]
        );
    }
    Ok(())
}

/// The quantities of Table 13.7.
fn of_table(hover: &Hover) -> [f64; 4] {
    [
        hover.tip / 0.3048,
        hover.flap.to_degrees(),
        hover.twist.to_degrees(),
        hover.thrust / POUND,
    ]
}

fn show_hover(case: &Path) -> Result<()> {
    println!(
        "\nHover: Table 13.7 at \"4 deg\", and found at 4 and 5.06 deg at 75 % of the radius\n"
    );
    println!(
        "{:34}{:>10}{:>12}{:>12}{:>14}{:>20}",
        "", "tip [ft]", "flap [deg]", "twist [deg]", "thrust [lbf]", "pitch at 75 % [deg]"
    );
    let row = |name: &str, [tip, flap, twist, thrust]: [f64; 4], pitch: &str| {
        println!("{name:34}{tip:10.4}{flap:12.3}{twist:12.3}{thrust:14.0}{pitch:>20}");
    };
    for (name, values) in ["reference 90", "diagonal", "coupled"]
        .iter()
        .zip(TABLE_13_7)
    {
        row(&format!("thesis, {name}"), values, "");
    }
    for collective in [4.0, 5.06] {
        for set in [SETS[4], SETS[3], SETS[2], SETS[1], SETS[0]] {
            let found = hover(case, set, &[("collective", collective)])?;
            let pitch = format!("{:.3}", found.pitch.to_degrees() - ROOT_TWIST);
            let name = format!("found, {set}, {collective} deg");
            row(&name, of_table(&found), &pitch);
        }
    }
    Ok(())
}

/// Hover at 4 degrees over constant voltages \[V\].
fn voltages(case: &Path) -> Result<Vec<(f64, Hover)>> {
    println!("\nHover at 4 deg over a constant voltage\n");
    println!("{:>8}{:>14}{:>14}", "V", "twist [deg]", "thrust [lbf]");
    let mut all = Vec::new();
    for volts in [-250.0, -125.0, 0.0, 125.0, 250.0] {
        let found = hover(case, SETS[0], &[("volts", volts)])?;
        let [_, _, twist, thrust] = of_table(&found);
        println!("{volts:8.0}{twist:14.3}{thrust:14.0}");
        all.push((volts, found));
    }
    Ok(all)
}

fn responses(case: &Path, is_long: bool) -> Result<Vec<Response>> {
    // Of six frequencies in a revolution, or 24 in four revolutions.
    let (spacing, steps) = if is_long { (0.25, 128.0) } else { (1.0, 32.0) };
    let coarse = COARSE.into_iter();
    let given: Vec<_> = coarse
        .map(|(name, value)| (name, if name == "steps" { steps } else { value }))
        .collect();
    response(case, (spacing, is_long), &given)
}

fn show_responses(found: &[Response]) {
    println!("\nHover, 250 V: amplitude [deg] and phase [deg]\n");
    println!(
        "{:>6}{:>10}{:>10}{:>10}{:>10}",
        "1/rev", "twist", "phase", "flap", "phase"
    );
    for Response { order, twist, flap } in found {
        println!(
            "{order:6.2}{:10.3}{:10.1}{:10.3}{:10.1}",
            twist[0], twist[1], flap[0], flap[1]
        );
    }
}

/// The flights, each from the one before; of the short form the first condition only.
fn flights(case: &Path, is_long: bool, model: &[(&str, f64)]) -> Result<Vec<Flight>> {
    let slow = if is_long {
        Some(trimmed(case, model, SLOW, None)?)
    } else {
        None
    };
    if let Some(slow) = &slow {
        println!("\nForward flight, advance ratio {SLOW}");
        show_controls("without voltage", slow);
    }
    let count = if is_long { CONDITIONS.len() } else { 1 };
    let mut all: Vec<Flight> = Vec::new();
    for condition in CONDITIONS.into_iter().take(count) {
        let before = all.last().map(|own| &own.without).or(slow.as_ref());
        let own = flight(case, model, condition, before)?;
        show_flight(&own);
        all.push(own);
    }
    if let Some(first) = all.first().filter(|_| is_long) {
        let condition = first.condition;
        let found = harmonics::by_harmonic(case, model, condition, &first.without)?;
        harmonics::show(&found, condition);
    }
    Ok(all)
}

fn show_controls(name: &str, of: &Motion) {
    let [collective, cosine, sine] =
        std::array::from_fn(|i| of.controls.get(i).copied().unwrap_or(f64::NAN));
    println!(
        "  {name:16} collective {collective:.3}, cosine {cosine:.3}, sine {sine:.3} deg, residual {:.1e}",
        of.residual
    );
}

fn show_flight(of: &Flight) {
    let Flight {
        condition,
        without,
        controlled,
        vibration: over_phase,
    } = of;
    let Condition {
        advance,
        volts,
        phase,
    } = condition;
    println!("\nForward flight, advance ratio {advance}");
    show_controls("without voltage", without);
    show_controls("controlled", controlled);
    println!("  vibration at 4/rev   moment [lbf ft]   in plane [lbf]   vertical [lbf]");
    let row = |name: &str,
               Sizes {
                   moment,
                   in_plane,
                   vertical,
               }: Sizes| {
        println!("  {name:19}{moment:17.1}{in_plane:17.1}{vertical:17.1}");
    };
    row("without voltage", over_phase.without());
    for phase in [0.0, 45.0, 90.0, 135.0, 180.0, 225.0, 270.0, 315.0, *phase] {
        row(&format!("{volts} V at {phase} deg"), over_phase.at(phase));
    }
    let best = over_phase.best();
    row(&format!("best, {best} deg"), over_phase.at(best));
    row("the same in flight", vibration(controlled));
}
