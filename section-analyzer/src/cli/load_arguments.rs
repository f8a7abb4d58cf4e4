//! The arguments for an internal force.

use clap::{ArgGroup, Args};
use shared_geom::error::Explain;
use shared_geom::units::{Dimension, parse_quantity};

use crate::input::is_load_name;

/// Six components, their point of application, and the name of the load.
#[derive(Debug, Args)]
#[command(group(ArgGroup::new("component").multiple(true)))]
pub(super) struct LoadArguments {
    /// Axial force
    #[arg(long, value_name = "FORCE", group = "component", value_parser = force, allow_hyphen_values = true)]
    axial: Option<f64>,
    /// Shear force along y
    #[arg(long, value_name = "FORCE", group = "component", value_parser = force, allow_hyphen_values = true)]
    shear_y: Option<f64>,
    /// Shear force along z
    #[arg(long, value_name = "FORCE", group = "component", value_parser = force, allow_hyphen_values = true)]
    shear_z: Option<f64>,
    /// Torque about x
    #[arg(long, value_name = "MOMENT", group = "component", value_parser = moment, allow_hyphen_values = true)]
    torsion: Option<f64>,
    /// Bending moment about y
    #[arg(long, value_name = "MOMENT", group = "component", value_parser = moment, allow_hyphen_values = true)]
    bending_y: Option<f64>,
    /// Bending moment about z
    #[arg(long, value_name = "MOMENT", group = "component", value_parser = moment, allow_hyphen_values = true)]
    bending_z: Option<f64>,
    /// Point of application of the force, in m or with units; the origin of the mesh if
    /// not given
    #[arg(long, value_names = ["Y", "Z"], num_args = 2, requires = "component", value_parser = length, allow_hyphen_values = true)]
    pub point: Vec<f64>,
    /// Name of the load, in the names of its files
    #[arg(long, default_value = "load", requires = "component", value_parser = load_name)]
    pub name: String,
}

impl LoadArguments {
    /// The components in their order \[N, N m\]; `None` if not given.
    pub fn components(&self) -> [Option<f64>; 6] {
        [
            self.axial,
            self.shear_y,
            self.shear_z,
            self.torsion,
            self.bending_y,
            self.bending_z,
        ]
    }
}

fn force(text: &str) -> Result<f64, String> {
    quantity(text, Dimension::FORCE)
}

fn moment(text: &str) -> Result<f64, String> {
    quantity(text, Dimension::MOMENT)
}

fn length(text: &str) -> Result<f64, String> {
    quantity(text, Dimension::LENGTH)
}

/// A number in SI units, or one with its own unit.
fn quantity(text: &str, dimension: Dimension) -> Result<f64, String> {
    let value = match text.trim().parse::<f64>() {
        Ok(number) => number,
        Err(_) => parse_quantity(text, dimension).map_err(|problem| match problem.help() {
            Some(help) => format!("{problem} ({help})"),
            None => problem.to_string(),
        })?,
    };
    if value.is_finite() {
        Ok(value)
    } else {
        Err(format!("expected {dimension}, finite"))
    }
}

fn load_name(text: &str) -> Result<String, &'static str> {
    if is_load_name(text) {
        Ok(text.to_owned())
    } else {
        Err("expected letters, digits, \"-\" and \"_\": it becomes part of file names")
    }
}
