//! `linearize`: writes the linear model of each file.

use std::f64::consts::PI;
use std::path::{Path, PathBuf};

use clap::ValueEnum;

use super::arguments::Results;
use super::blade_options::speed;
use super::result_locations::result_locations;
use super::terminal::Terminal;
use super::{WRONG_INPUT, add_remarks, files, finish};
use crate::analysis::linear::linearize;
use crate::input::{self, Input, LinearChoice, LinearRequest};
use crate::output::{self, ResultLocation};

/// Equilibria about which models are linearized.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum AboutWord {
    /// Of [modes]
    Modes,
    /// Of [static], with its factor of the proportional loads
    Static,
    /// Of [trim]
    Trim,
}

/// Files, inputs, outputs and the equilibrium.
#[derive(Debug, clap::Args)]
pub(super) struct LinearizeArguments {
    /// Dynamics files, NAME.dynamics.toml; several run side by side
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// Inputs: names of drives and of controls of [trim], with commas between
    #[arg(long, value_name = "NAME", value_delimiter = ',')]
    input: Vec<String>,
    /// Outputs: names of sensors, outputs of systems, actuators and columns, with commas between
    #[arg(long, value_name = "NAME", value_delimiter = ',')]
    output: Vec<String>,
    /// Rotor speed in rpm, or with a unit as in "0.8 rad/s"; of the analysis if not given
    #[arg(long, value_parser = speed, value_name = "RPM")]
    speed: Option<f64>,
    /// The analysis whose equilibrium is meant; the one that the file has if not given
    #[arg(long, value_name = "WORD")]
    about: Option<AboutWord>,
    #[command(flatten)]
    pub results: Results,
}

impl LinearizeArguments {
    fn request(&self) -> LinearRequest {
        let named = |names: &[String]| names.iter().map(|name| name.trim().to_owned()).collect();
        LinearRequest {
            inputs: named(&self.input),
            outputs: named(&self.output),
            speed: self.speed.map(|rpm| rpm * PI / 30.0),
            about: self.about.map(|word| match word {
                AboutWord::Modes => LinearChoice::Modes,
                AboutWord::Static => LinearChoice::Static,
                AboutWord::Trim => LinearChoice::Trim,
            }),
        }
    }
}

/// `linearize FILE...`
pub(super) fn linearize_files(arguments: &LinearizeArguments, terminal: &mut Terminal<'_>) -> u8 {
    let (request, paths) = (arguments.request(), &arguments.files);
    let locations = match result_locations(paths, &arguments.results) {
        Ok(locations) => locations,
        Err(problem) => {
            terminal.report(&problem);
            return WRONG_INPUT;
        }
    };
    let read = files::each(paths, terminal, |path, terminal| {
        let input = input::read_linear(path, &request, &[]);
        input
            .map_err(|problems| terminal.report_text(&problems.to_string()))
            .ok()
    });
    let Some(inputs) = read.into_iter().collect::<Option<Vec<_>>>() else {
        return WRONG_INPUT;
    };
    let jobs: Vec<_> = paths.iter().zip(&inputs).zip(&locations).collect();
    files::worst_of(&jobs, terminal, |((path, input), location), terminal| {
        linear_of((path, &request), input, location, terminal)
    })
}

fn linear_of(
    (path, request): (&Path, &LinearRequest),
    input: &Input,
    location: &ResultLocation,
    terminal: &mut Terminal<'_>,
) -> u8 {
    let read = |given: &[(String, f64)]| input::read_linear(path, request, given);
    match linearize(input, &read) {
        Ok(mut model) => {
            add_remarks(&mut model.remarks, input, None);
            terminal.show(&output::linear_text(&model));
            finish(None, output::write_linear(&model, location), terminal)
        }
        Err(failure) => {
            let (name, remedy) = (&location.name, failure.remedy());
            terminal.report_text(&format!("error: {name}: {failure}\n  help: {remedy}"));
            super::NOT_REACHED
        }
    }
}
