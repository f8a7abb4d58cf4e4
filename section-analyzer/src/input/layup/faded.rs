//! Layers that fade out: cells far longer than thick have no reliable stiffness.

use super::resolve::{ABSENT, Resolver};
use super::{Layup, WrittenLayer};
use crate::mesh::generate::layup::AROUND;

/// Part of the size of cells below which a layer may be absent.
const THIN: f64 = 1e-3;
/// Part of its largest thickness along the span below which it fades out.
const FADING: f64 = 0.02;

impl Resolver<'_> {
    /// Whether a layer is so thin that it is absent: a thousandth of the size of cells, and a fiftieth
    /// of its largest thickness.
    pub fn is_faded(&self, layer: &WrittenLayer) -> bool {
        let thickness = self.thickness(layer);
        let largest = layer.thickness.points().map(|(_, value)| value);
        thickness > ABSENT
            && thickness < THIN * self.size()
            && thickness < FADING * largest.fold(0.0, f64::max)
    }

    /// The size of cells, as meshed.
    fn size(&self) -> f64 {
        let usual = || self.perimeter() / AROUND;
        self.layup().size.unwrap_or_else(usual)
    }
}

impl Layup {
    /// Remarks on layers and plies that fade out, and are absent at some of these positions along the
    /// span.
    pub fn faded_layers(&self, etas: &[f64]) -> Vec<String> {
        let plies = self.webs.iter().flat_map(|web| &web.plies);
        let all: Vec<&WrittenLayer> = self.layers.iter().chain(plies).collect();
        let mut found: Vec<Vec<String>> = vec![Vec::new(); all.len()];
        for eta in etas {
            let Ok(resolver) = Resolver::new(self, *eta) else {
                continue;
            };
            for (layer, found) in all.iter().zip(&mut found) {
                if resolver.is_faded(layer) {
                    found.push(crate::mesh::short(*eta));
                }
            }
        }
        let faded = all.iter().zip(found).filter(|(_, etas)| !etas.is_empty());
        let remark = |(layer, etas): (&&WrittenLayer, Vec<String>)| {
            format!(
                "line {}: layer \"{}\" is thinner than a thousandth of the cells, and absent: eta {}",
                layer.line,
                layer.name,
                etas.join(", ")
            )
        };
        faded.map(remark).collect()
    }
}
