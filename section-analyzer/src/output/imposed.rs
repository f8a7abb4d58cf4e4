//! Report of temperature and other imposed strains: force per kelvin, and named states.

use nalgebra::Vector6;
use shared_geom::section::{ImposedState, SectionProperties};
use shared_geom::wrench::COMPONENTS;

use super::round_off::without_round_off;
use super::text::{number, table};
use crate::properties::radius_of_gyration;

/// The part of the report on temperature and imposed strains; empty without them.
pub fn imposed_report(properties: &SectionProperties) -> String {
    let length = radius_of_gyration(properties);
    let thermal = thermal(properties.thermal_force.as_ref(), length);
    let states = states(&properties.imposed, length);
    if thermal.is_empty() || states.is_empty() {
        thermal + &states
    } else {
        format!("{thermal}\n{states}")
    }
}

/// The force per kelvin of a uniform temperature rise; empty if unknown. Moments divided by
/// `length`, the size of the section \[m\], are comparable with forces.
fn thermal(force: Option<&Vector6<f64>>, length: f64) -> String {
    let Some(forces) = force else {
        return String::new();
    };
    let forces = without_round_off(forces, 1.0 / length, 0.0);
    let rows = COMPONENTS.iter().zip(forces.iter());
    let rows = rows.map(|(name, force)| vec![(*name).to_owned(), number(*force)]);
    let rows: Vec<_> = rows.collect();
    format!(
        "Thermal force, per kelvin when fully restrained [N/K, N m/K]\n{}",
        table(&rows, "lr")
    )
}

/// Free strain and restrained force of each state, side by side; empty without states.
fn states(states: &[ImposedState], length: f64) -> String {
    let of_state = |state: &ImposedState| {
        let heading = ["", "free strain [-, 1/m]", "restrained force [N, N m]"];
        let mut rows = vec![heading.map(str::to_owned).to_vec()];
        let strain = without_round_off(&state.free_strain, length, 0.0);
        let force = without_round_off(&state.restrained_force, 1.0 / length, 0.0);
        for (i, name) in COMPONENTS.iter().enumerate() {
            let values = [strain[i], force[i]].map(number);
            rows.push([vec![(*name).to_owned()], values.to_vec()].concat());
        }
        format!("Imposed state \"{}\"\n{}", state.name, table(&rows, "lr"))
    };
    let all: Vec<_> = states.iter().map(of_state).collect();
    all.join("\n")
}
