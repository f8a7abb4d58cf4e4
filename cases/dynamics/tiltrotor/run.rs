//! A tiltrotor: hover, conversion, gusts and flutter of one proprotor on a half wing.
//!
//! Runs the program as a user would on the command line, and then the stability over the air speed,
//! with its table and figure:
//!
//! ```sh
//! beam-dynamics trim hover.dynamics.toml
//! beam-dynamics transient conversion.dynamics.toml gust_on.dynamics.toml gust_off.dynamics.toml
//! beam-dynamics plot gust_on.transient.csv gust_off.transient.csv
//! ```

use std::error::Error;
use std::f64::consts::TAU;
use std::ffi::OsString;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use beam_dynamics::analysis::periodic::periodic_from;
use beam_dynamics::input;
use shared_geom::figure::{Figure, Panel, PanelPlot};
use shared_geom::files::write_text;

/// Folder of the case, relative to the repository.
const CASE: &str = "cases/dynamics/tiltrotor";
/// Air speeds of the stability \[kt\].
const KNOTS: [f64; 8] = [150.0, 250.0, 300.0, 340.0, 370.0, 390.0, 410.0, 430.0];
/// Size of an exponent below which it is the azimuth of the rotor on its soft engine \[1/s\].
const AZIMUTH: f64 = 0.3;

fn main() -> ExitCode {
    let case = folder();
    let results = case.join("results");
    let file = |name: &&str| case.join(format!("{name}.dynamics.toml"));
    let table = |name: &&str| results.join(format!("{name}.transient.csv"));
    let (runs, gusts) = (
        ["conversion", "gust_on", "gust_off"],
        ["gust_on", "gust_off"],
    );
    let plot: Vec<_> = gusts.iter().map(table).map(OsString::from).collect();
    let options = ["--title", "A gust of 10 ft/s at 350 kt", "--out"].map(OsString::from);
    let plot = plot.into_iter().chain(options);
    let commands = [
        ("trim", vec![file(&"hover").into()]),
        (
            "transient",
            runs.iter().map(file).map(OsString::from).collect(),
        ),
        ("plot", plot.chain([results.join("gust").into()]).collect()),
    ];
    for (command, arguments) in commands {
        let words = ["beam-dynamics", command].map(OsString::from);
        let arguments: Vec<_> = words.into_iter().chain(arguments).collect();
        let shown: Vec<_> = arguments
            .iter()
            .map(|word| word.to_string_lossy())
            .collect();
        println!("$ {}\n", shown.join(" "));
        let code =
            beam_dynamics::cli::run(arguments, &mut std::io::stdout(), &mut std::io::stderr());
        if code != 0 {
            return ExitCode::from(code);
        }
        println!();
    }
    match flutter(&case, &results) {
        Ok(text) => println!("{text}\nAll files: {}", results.display()),
        Err(error) => {
            eprintln!("error: stability over the air speed: {error}");
            return ExitCode::from(1);
        }
    }
    ExitCode::SUCCESS
}

/// The stability over the air speed, on and off the downstop, as a text; writes its table and figure.
fn flutter(case: &Path, results: &Path) -> Result<String, Box<dyn Error>> {
    let mut text = String::from(
        "The motion that decays least, 458 rpm at sea level\n\n\
         air speed      on the downstop        off the downstop\n\
         \x20    [kt]   [1/s]      [Hz]        [1/s]      [Hz]\n",
    );
    let mut table = String::from(
        "air speed [kt],growth on [1/s],frequency on [Hz],growth off [1/s],frequency off [Hz]\n",
    );
    let mut growth = vec![Vec::new(), Vec::new()];
    let mut frequency = growth.clone();
    for knots in KNOTS {
        let mut row = Vec::new();
        for (index, off) in [0.0, 1.0].into_iter().enumerate() {
            let [rate, hz] = least_damped(case, &[("knots", knots), ("off_downstop", off)])?;
            growth[index].push([knots, rate]);
            frequency[index].push([knots, hz]);
            row.extend([rate, hz]);
        }
        writeln!(
            text,
            "{knots:9}{:8.3}{:10.3}{:13.3}{:10.3}",
            row[0], row[1], row[2], row[3]
        )?;
        let row: Vec<_> = row.iter().map(f64::to_string).collect();
        writeln!(table, "{knots},{}", row.join(","))?;
    }
    write_text(&results.join("flutter.csv"), &table)?;
    let panel = |title: &str, curves| Panel {
        title: title.to_owned(),
        curves,
    };
    let figure = PanelPlot {
        title: "Tiltrotor: the motion that decays least".to_owned(),
        across: "air speed [kt]".to_owned(),
        names: ["on the downstop", "off the downstop"]
            .map(str::to_owned)
            .to_vec(),
        panels: vec![
            panel("growth [1/s]", growth),
            panel("frequency [Hz]", frequency),
        ],
    };
    for ending in ["png", "svg"] {
        figure
            .drawing()
            .save(&results.join(format!("flutter.{ending}")))?;
    }
    Ok(text)
}

/// Growth \[1/s\] and frequency \[Hz\] of the motion that decays least, without the azimuth.
fn least_damped(case: &Path, parameters: &[(&str, f64)]) -> Result<[f64; 2], Box<dyn Error>> {
    let given = parameters.iter();
    let given: Vec<_> = given
        .map(|(name, value)| ((*name).to_owned(), *value))
        .collect();
    let path = case.join("flutter.dynamics.toml");
    let input = input::read_with(&path, &given).map_err(|problems| problems.to_string())?;
    let settings = input.periodic.as_ref().ok_or("no [periodic] in the file")?;
    let outcome = periodic_from(&input.model, settings, None);
    if let Some(failure) = outcome.failure {
        return Err(failure.to_string().into());
    }
    let table = outcome
        .result
        .floquet
        .ok_or("no [periodic.floquet] in the file")?;
    let mut modes = table.modes.iter();
    let mode = modes
        .find(|mode| mode.exponent.norm() > AZIMUTH)
        .ok_or("no motion was found")?;
    Ok([mode.exponent.re, mode.frequency() / TAU])
}

/// The case below the current folder, or below the folder in which the runner was built.
fn folder() -> PathBuf {
    let here = PathBuf::from(CASE);
    if here.is_dir() {
        return here;
    }
    Path::new(env!("CARGO_MANIFEST_DIR")).join(CASE)
}
