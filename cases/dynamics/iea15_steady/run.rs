//! The IEA 15 MW rotor with elastic blades over the wind, beside published states.
//!
//! At the published pitch and speed of each wind: power, thrust and the bending of the tip. Above the
//! rated wind also the pitch at which the rotor has the published power. Writes `results/sweep.csv` and
//! the figure `results/sweep.png` and `.svg`.

use std::error::Error;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use beam_dynamics::analysis::statics::statics;
use beam_dynamics::input;
use nalgebra::Vector3;
use shared_geom::figure::{Figure, Panel, PanelPlot};
use shared_geom::files::{make_folder, write_text};

/// Folder of the case, relative to the repository.
const CASE: &str = "cases/dynamics/iea15_steady";
/// Wind above which the pitch controls the power \[m/s\].
const RATED: f64 = 10.9;
/// Precone, by which the blade leans upwind \[deg\].
const CONE: f64 = 4.0;
/// Difference of two pitches for the slope of the power \[deg\].
const APART: f64 = 0.2;
/// Largest error of the power at the pitch found \[-\].
const TOLERANCE: f64 = 1e-4;

/// A published state: wind \[m/s\], pitch to feather \[deg\], speed \[rpm\], power \[kW\], thrust \[kN\]
/// and bending of the tip normal to the blade at its root, which turns with the pitch \[m\].
type State = [f64; 6];

fn main() -> ExitCode {
    match run(&folder()) {
        Ok(text) => {
            println!("{text}");
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(1)
        }
    }
}

/// The table over the wind as text; writes it and the figure.
fn run(case: &Path) -> Result<String, Box<dyn Error>> {
    let mut table = String::from(
        "wind [m/s],power [kW],published [kW],thrust [kN],published [kN],pitch [deg],\
         published [deg],tip [m],published [m]\n",
    );
    let mut curves = vec![vec![Vec::new(), Vec::new()]; 4];
    for state in published(case)? {
        let [wind, feather, rpm, power, thrust, tip] = state;
        let found = steady(case, [wind, feather, rpm])?;
        let pitch = if wind > RATED {
            Some(pitch_of(case, &state)?)
        } else {
            None
        };
        let shown = pitch.map_or_else(String::new, |pitch| format!("{pitch:.4}"));
        writeln!(
            table,
            "{wind},{:.1},{power},{:.2},{thrust},{shown},{feather},{:.3},{tip}",
            found[0], found[1], found[2]
        )?;
        let of_state = [(found[0], power), (found[1], thrust), (found[2], tip)];
        for (panel, (own, other)) in [0, 1, 3].into_iter().zip(of_state) {
            curves[panel][0].push([wind, own]);
            curves[panel][1].push([wind, other]);
        }
        curves[2][0].extend(pitch.map(|pitch| [wind, pitch]));
        curves[2][1].push([wind, feather]);
    }
    let results = case.join("results");
    make_folder(&results)?;
    write_text(&results.join("sweep.csv"), &table)?;
    for ending in ["png", "svg"] {
        figure(&curves)
            .drawing()
            .save(&results.join(format!("sweep.{ending}")))?;
    }
    Ok(format!("{table}\nAll files: {}", results.display()))
}

/// Power, thrust, pitch and tip: this program and the published values.
fn figure(curves: &[Vec<Vec<[f64; 2]>>]) -> PanelPlot {
    let titles = [
        "power [kW]",
        "thrust [kN]",
        "pitch for the power [deg]",
        "tip downwind [m]",
    ];
    let panels = titles.into_iter().zip(curves).map(|(title, curves)| Panel {
        title: title.to_owned(),
        curves: curves.clone(),
    });
    PanelPlot {
        title: "IEA 15 MW, elastic blades".to_owned(),
        across: "wind [m/s]".to_owned(),
        names: ["this program", "HAWCStab2; tip: HAWC2 in time"]
            .map(str::to_owned)
            .to_vec(),
        panels: panels.collect(),
    }
}

/// The rows of `published.csv`.
fn published(case: &Path) -> Result<Vec<State>, Box<dyn Error>> {
    let text = std::fs::read_to_string(case.join("published.csv"))?;
    let rows = text.lines().filter(|line| !line.starts_with('#')).skip(1);
    let state = |line: &str| -> Result<State, Box<dyn Error>> {
        let cells: Result<Vec<f64>, _> = line.split(',').map(str::parse).collect();
        State::try_from(cells?).map_err(|cells| format!("{} cells in {line}", cells.len()).into())
    };
    rows.map(state).collect()
}

/// Power \[kW\], thrust \[kN\] and bending of the tip \[m\] at a wind \[m/s\], pitch \[deg\] and speed \[rpm\].
fn steady(case: &Path, [wind, feather, rpm]: [f64; 3]) -> Result<[f64; 3], Box<dyn Error>> {
    let given = [("wind", wind), ("feather", feather), ("rpm", rpm)];
    let given = given.map(|(name, value)| (name.to_owned(), value));
    let path = case.join("iea15_steady.dynamics.toml");
    let input = input::read_with(&path, &given).map_err(|problems| problems.to_string())?;
    let settings = input.statics.as_ref().ok_or("no [static] in the file")?;
    let outcome = statics(&input.model, settings);
    if let Some(failure) = outcome.failure {
        return Err(format!("{wind} m/s: {failure}").into());
    }
    let step = outcome.result.steps.first().ok_or("no state")?;
    let (mut force, mut moment) = (0.0, 0.0);
    for reaction in &step.reactions {
        let at = step.positions[reaction.node];
        force -= reaction.force.z;
        moment -= reaction.moment.z + at.cross(&reaction.force).z;
    }
    let nodes = input.model.system.nodes();
    let tip = nodes.iter().position(|node| node.label == "blade 1/tip");
    let tip = tip.ok_or("no node \"blade 1/tip\"")?;
    let (sin, cos) = CONE.to_radians().sin_cos();
    let (edge, flap) = feather.to_radians().sin_cos();
    let moved = step.positions[tip] - nodes[tip].position;
    Ok([
        1e-3 * moment * outcome.result.speed,
        1e-3 * force,
        moved.dot(&Vector3::new(sin * flap, edge, cos * flap)),
    ])
}

/// The pitch \[deg\] at which the rotor has the published power, by the secants of the power.
fn pitch_of(case: &Path, state: &State) -> Result<f64, Box<dyn Error>> {
    let [wind, feather, rpm, power, ..] = *state;
    let excess = |pitch: f64| -> Result<f64, Box<dyn Error>> {
        Ok(steady(case, [wind, pitch, rpm])?[0] / power - 1.0)
    };
    let (mut last, mut pitch) = (feather, feather - APART);
    let mut before = excess(last)?;
    for _ in 0..10 {
        let now = excess(pitch)?;
        if now.abs() < TOLERANCE {
            return Ok(pitch);
        }
        let next = pitch - now * (pitch - last) / (now - before);
        (last, before, pitch) = (pitch, now, next);
    }
    Err(format!("{wind} m/s: no pitch has the published power").into())
}

/// The case below the current folder, or below the folder in which the runner was built.
fn folder() -> PathBuf {
    let here = PathBuf::from(CASE);
    if here.is_dir() {
        return here;
    }
    Path::new(env!("CARGO_MANIFEST_DIR")).join(CASE)
}
