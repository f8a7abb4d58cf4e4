//! Output of the air at the strips of blades: tables, figures over the span, maps of the disk.

mod disk;
mod equal;
mod record;
mod span;
mod tables;
mod text;

pub use disk::DiskPlot;
pub(super) use record::AirRecord;
pub(super) use span::span_plot;
pub(super) use tables::air_csv;
pub(super) use text::rotor_text;

use crate::elements::AirState;

/// Names of the rotors of strips, in their order.
fn rotors<'a>(states: impl IntoIterator<Item = &'a AirState>) -> Vec<&'a str> {
    let mut names: Vec<&str> = Vec::new();
    for rotor in states.into_iter().flat_map(|state| &state.location.rotor) {
        if !names.contains(&rotor.as_str()) {
            names.push(rotor);
        }
    }
    names
}

#[cfg(test)]
mod tests;
