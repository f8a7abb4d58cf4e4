//! The description of a layup: its layers and webs at stations along the span.

use std::fmt::Write;

use crate::input::layup::{Layup, LayupMesh};
use crate::mesh::short;

/// Layers and webs of a meshed section: arcs, thickness, and areas as given and of the cells.
pub fn layup_report(layup: &Layup, eta: f64, meshed: &LayupMesh) -> String {
    let mut text = String::new();
    // writing to a string cannot fail
    let _ = write_report(&mut text, layup, eta, meshed);
    text
}

fn write_report(
    text: &mut String,
    layup: &Layup,
    eta: f64,
    meshed: &LayupMesh,
) -> std::fmt::Result {
    let unit = layup.unit;
    writeln!(
        text,
        "eta {}: chord {}, {} nodes, {} cells",
        short(eta),
        short(layup.shape.chord.at(eta) / unit),
        meshed.mesh.nodes.len(),
        meshed.mesh.cells.len()
    )?;
    writeln!(
        text,
        "  {:<24} {:<16} {:>9} {:>9} {:>12} {:>12} {:>9}",
        "layer", "material", "from arc", "to arc", "thickness", "area", "of nominal"
    )?;
    let material = |name: &str| {
        layup
            .layer(name)
            .map_or("", |layer| layer.material.as_str())
    };
    let mut areas = meshed.areas.iter();
    let mut row = |text: &mut String, name: &str, arcs: [f64; 2], thickness: f64| {
        let area = areas.next();
        let [meshed, nominal] = area.map_or([0.0; 2], |area| [area.meshed, area.nominal]);
        writeln!(
            text,
            "  {:<24} {:<16} {:>9.4} {:>9.4} {:>12.5e} {:>12.5e} {:>9.2}%",
            name,
            material(name),
            arcs[0],
            arcs[1],
            thickness / unit,
            meshed / (unit * unit),
            100.0 * meshed / nominal
        )
    };
    for layer in &meshed.section.layers {
        row(text, &layer.name, [layer.from, layer.to], layer.thickness)?;
    }
    for web in &meshed.section.webs {
        for ply in &web.plies {
            row(text, &ply.name, web.arcs, ply.thickness)?;
        }
    }
    Ok(())
}
