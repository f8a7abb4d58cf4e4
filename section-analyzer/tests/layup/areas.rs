//! Areas of the layers of a section.

use section_analyzer::mesh::generate::layup::LayerArea;

/// Layers of more than 1 % of a section.
pub fn large(areas: &[LayerArea]) -> impl Iterator<Item = &LayerArea> {
    let total: f64 = areas.iter().map(|area| area.meshed).sum();
    areas.iter().filter(move |area| area.meshed > 0.01 * total)
}

/// Difference of a meshed area from the one of the layer, without the part that contacts cut and with the space that
/// it fills between both sides, as a part of it.
pub fn error(area: &LayerArea) -> f64 {
    area.meshed / (area.nominal - area.cut + area.filled) - 1.0
}
