//! The description of a layup: its layers and webs at stations along the span.

use std::fmt::Write;

use crate::input::layup::{Layup, LayupMesh};
use crate::mesh::short;

/// A layer or ply of a web in a meshed section.
#[derive(Debug, Clone, PartialEq)]
pub struct LayerRow {
    /// Its name.
    pub layer: String,
    /// The name of its material.
    pub material: String,
    /// Arcs at which it starts and ends; of a ply of a web, arcs of the web [-].
    /// None of a fill.
    pub arcs: Option<[f64; 2]>,
    /// Its thickness, none of a fill \[m\].
    pub thickness: Option<f64>,
    /// Its area as given \[m^2\].
    pub nominal: f64,
    /// The area of its cells \[m^2\].
    pub meshed: f64,
    /// The part of its area that is cut where both sides meet \[m^2\].
    pub cut: f64,
    /// The area that it has in addition where it fills the space between both sides \[m^2\].
    pub filled: f64,
}

/// The layers of a meshed section, then the plies of its webs, then its fills.
pub fn layer_rows(layup: &Layup, meshed: &LayupMesh) -> Vec<LayerRow> {
    let layers = meshed.section.layers.iter();
    let layers = layers.map(|layer| {
        let place = ([layer.from, layer.to], layer.thickness);
        (&layer.name, Some(place))
    });
    let plies = meshed.section.webs.iter().flat_map(|web| {
        let plies = web.plies.iter();
        plies.map(|ply| (&ply.name, Some((web.arcs, ply.thickness))))
    });
    let fills = meshed.section.fills.iter().map(|fill| (&fill.name, None));
    let rows = layers.chain(plies).chain(fills).zip(&meshed.areas);
    let rows = rows.map(|((name, place), area)| LayerRow {
        layer: name.clone(),
        material: layup.material_of(name).unwrap_or_default().to_owned(),
        arcs: place.map(|place| place.0),
        thickness: place.map(|place| place.1),
        nominal: area.nominal,
        meshed: area.meshed,
        cut: area.cut,
        filled: area.filled,
    });
    rows.collect()
}

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
    for row in layer_rows(layup, meshed) {
        let arc = |i: usize| {
            row.arcs
                .map_or("-".into(), |arcs| format!("{:.4}", arcs[i]))
        };
        let thickness = row.thickness.map(|thickness| thickness / unit);
        writeln!(
            text,
            "  {:<24} {:<16} {:>9} {:>9} {:>12} {:>12.5e} {:>9.2}%",
            row.layer,
            row.material,
            arc(0),
            arc(1),
            thickness.map_or("-".into(), |value| format!("{value:.5e}")),
            row.meshed / (unit * unit),
            100.0 * row.meshed / row.nominal
        )?;
    }
    Ok(())
}
