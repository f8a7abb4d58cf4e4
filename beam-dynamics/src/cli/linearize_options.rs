//! Options of `linearize`: files, inputs, outputs and the equilibrium.

use std::f64::consts::PI;
use std::path::PathBuf;

use clap::ValueEnum;

use super::blade_options::speed;
use crate::input::{LinearChoice, LinearRequest};

/// Equilibria about which models are linearized.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum AboutWord {
    /// Of [modes]
    Modes,
    /// Of [static], with its factor of the proportional loads
    Static,
    /// Of [trim]
    Trim,
    /// The motion of [periodic], in multiblade coordinates averaged over it
    Periodic,
}

/// Files, inputs, outputs and the equilibrium.
#[derive(Debug, clap::Args)]
pub(super) struct LinearizeOptions {
    /// Dynamics files, NAME.dynamics.toml; several run side by side
    #[arg(required = true, value_name = "FILE")]
    pub files: Vec<PathBuf>,
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
}

impl LinearizeOptions {
    /// The request to the input.
    pub fn request(&self) -> LinearRequest {
        let named = |names: &[String]| names.iter().map(|name| name.trim().to_owned()).collect();
        LinearRequest {
            inputs: named(&self.input),
            outputs: named(&self.output),
            speed: self.speed.map(|rpm| rpm * PI / 30.0),
            about: self.about.map(|word| match word {
                AboutWord::Modes => LinearChoice::Modes,
                AboutWord::Static => LinearChoice::Static,
                AboutWord::Trim => LinearChoice::Trim,
                AboutWord::Periodic => LinearChoice::Periodic,
            }),
        }
    }
}
