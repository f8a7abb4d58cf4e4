//! The main job: from the mesh of a strip to the frequencies of four rotating swept-tip
//! blades, compared with the experiment of Epps and Chandra.
//!
//! Runs the two programs as a user would on the command line:
//!
//! ```sh
//! section-analyzer analyze strip.section.toml
//! beam-dynamics modes sweep_00.dynamics.toml sweep_15.dynamics.toml ...
//! ```

use std::ffi::OsString;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Folder of the case, relative to the repository.
const CASE: &str = "cases/chain/swept_tip";
/// Sweep angles of the blades [deg].
const SWEEPS: [&str; 4] = ["00", "15", "30", "45"];

/// A command of a program, without the program's name: arguments, output, errors.
type Program = fn(Vec<OsString>, &mut dyn Write, &mut dyn Write) -> u8;

fn main() -> ExitCode {
    let case = folder();
    let section = vec![case.join("strip.section.toml")];
    let blades = SWEEPS.map(|sweep| case.join(format!("sweep_{sweep}.dynamics.toml")));
    let steps: [(&str, Program, &str, Vec<PathBuf>); 2] = [
        (
            "section-analyzer",
            section_analyzer::cli::run,
            "analyze",
            section,
        ),
        (
            "beam-dynamics",
            beam_dynamics::cli::run,
            "modes",
            blades.to_vec(),
        ),
    ];
    for (name, program, command, files) in steps {
        let words = [OsString::from(name), OsString::from(command)];
        let arguments: Vec<_> = words
            .into_iter()
            .chain(files.into_iter().map(Into::into))
            .collect();
        println!("$ {}", shown(&arguments));
        let code = program(arguments, &mut std::io::stdout(), &mut std::io::stderr());
        if code != 0 {
            return ExitCode::from(code);
        }
        println!();
    }
    match summary(&case) {
        Ok(text) => print!("{text}"),
        Err(error) => {
            eprintln!("error: the comparisons cannot be read: {error}");
            return ExitCode::from(1);
        }
    }
    println!("\nAll files: {}", case.join("results").display());
    ExitCode::SUCCESS
}

/// All blades compared with the experiment, from the comparison files of the four runs.
fn summary(case: &Path) -> Result<String, csv::Error> {
    let mut rows: Vec<(String, [String; SWEEPS.len()])> = Vec::new();
    for (column, sweep) in SWEEPS.iter().enumerate() {
        let file = case.join(format!("results/sweep_{sweep}.comparison.csv"));
        for record in csv::Reader::from_path(file)?.deserialize() {
            let Comparison {
                speed,
                order,
                measured,
                computed,
            } = record?;
            let key = format!("{speed:>5}  {order:>4}");
            let entry = format!("{measured:>6.1}  {computed:>6.1}");
            let row = match rows.iter().position(|row| row.0 == key) {
                Some(row) => row,
                None => {
                    rows.push((key, std::array::from_fn(|_| String::new())));
                    rows.len() - 1
                }
            };
            rows[row].1[column] = entry;
        }
    }
    let mut text =
        String::from("Frequencies compared with the experiment [Hz], lag modes omitted\n\n");
    text += "speed  mode";
    SWEEPS
        .iter()
        .for_each(|sweep| text += &format!("   sweep {sweep:>2} deg  "));
    text += "\n[rpm]      ";
    SWEEPS.iter().for_each(|_| text += "   meas.  comp. ");
    text += "\n";
    for (key, entries) in rows {
        text += &format!(
            "{key}  {}\n",
            entries.map(|entry| format!("{entry:>14}")).join("  ")
        );
    }
    Ok(text)
}

/// The columns of a comparison file that the summary shows.
#[derive(serde::Deserialize)]
struct Comparison {
    #[serde(rename = "rotor_speed [rpm]")]
    speed: f64,
    order: usize,
    #[serde(rename = "measured [Hz]")]
    measured: f64,
    #[serde(rename = "computed [Hz]")]
    computed: f64,
}

/// The case below the current folder, or below the folder in which the runner was built.
fn folder() -> PathBuf {
    let here = PathBuf::from(CASE);
    if here.is_dir() {
        return here;
    }
    Path::new(env!("CARGO_MANIFEST_DIR")).join(CASE)
}

fn shown(arguments: &[OsString]) -> String {
    let words: Vec<_> = arguments
        .iter()
        .map(|word| word.to_string_lossy())
        .collect();
    words.join(" ")
}
