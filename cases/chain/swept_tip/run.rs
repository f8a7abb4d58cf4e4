//! The main job: from the mesh of a strip to the frequencies of four rotating
//! swept-tip blades beside the experiment of Epps and Chandra.
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
    ExitCode::SUCCESS
}

/// The case below the present folder, or below the one in which the runner was built.
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
