//! Layers in a fan, whose columns all end in its center.

use super::column::THIN;
use super::wall::Wall;

/// Samples of each side of a fan.
const SAMPLES: usize = 24;

impl Wall {
    /// The layers of which something is left in a fan that is full.
    pub(super) fn found_in_fan(&self) -> Vec<bool> {
        let mut found = vec![false; self.stack.len()];
        let Some(end) = self.pairs.fan() else {
            return found;
        };
        for i in 0..=SAMPLES {
            let pair = self.pairs.pair(end * i as f64 / SAMPLES as f64);
            for side in 0..2 {
                let limit = pair.limit(side, &self.stack);
                let mut outer = 0.0;
                let faces = self.stack.depths(pair.s[side]).into_iter();
                for (layer, face) in faces.map(|face| face.min(limit)).enumerate() {
                    found[layer] |= face - outer > self.least_in_fan(layer, limit);
                    outer = face;
                }
            }
        }
        found
    }

    /// Least thickness of the rest of a layer in a fan.
    fn least_in_fan(&self, layer: usize, limit: f64) -> f64 {
        THIN * self.stack.full(layer).min(limit)
    }

    /// Cuts layers at the center of a fan, to which all of its columns have the same ones: where one
    /// column had a node of a layer beside the center, and the next one none, a cell would have no angle.
    pub(super) fn cut_in_fan(&self, faces: &mut [f64], limit: f64) {
        let mut most = limit;
        for layer in (0..faces.len()).rev() {
            let is_last = most >= limit;
            faces[layer] = if is_last {
                limit
            } else {
                faces[layer].min(most)
            };
            if self.in_fan.get(layer).is_some_and(|is_found| *is_found) {
                most -= self.least_in_fan(layer, limit);
            }
        }
    }
}
