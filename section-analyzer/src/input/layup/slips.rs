//! Values that mostly have a wrong unit or sign.

use shared_geom::line::ReferenceLine;

use super::problem::{LayupFileProblem, Located};
use super::resolve::Resolver;
use super::{Layup, WrittenLayer};
use crate::mesh::short;

/// Positions along the span at which layers are compared with their tapers.
const COMPARED: usize = 20;
/// Difference of ratios that counts [-].
const SAME: f64 = 1e-9;

impl Layup {
    /// The problem of cells that are longer than the largest chord.
    pub(super) fn coarse(&self) -> Option<Located> {
        let chords = self.shape.chord.points().map(|(_, chord)| chord);
        let (size, chord) = (self.size?, chords.fold(0.0, f64::max));
        let problem = LayupFileProblem::Coarse { size, chord };
        (size > chord).then_some((self.size_line, problem))
    }

    /// Remarks on tapers that are longer than their layers, on origins outside of the chord, and on chords that are
    /// longer than the blade.
    pub(super) fn slips(&self) -> Vec<String> {
        let tapered = || self.layers.iter().filter(|layer| layer.taper.is_some());
        let mut remarks = Vec::new();
        if tapered().next().is_some() {
            let etas = (0..=COMPARED).map(|i| i as f64 / COMPARED as f64);
            let resolvers = etas.filter_map(|eta| Some((eta, Resolver::new(self, eta).ok()?)));
            let resolvers: Vec<(f64, Resolver<'_>)> = resolvers.collect();
            remarks.extend(tapered().filter_map(|layer| long_taper(layer, &resolvers)));
        }
        let outside = |(_, origin): &(f64, f64)| !(0.0..=1.0).contains(origin);
        if let Some((eta, origin)) = self.shape.origin.points().find(outside) {
            remarks.push(format!(
                "line {}: the origin of the section is at {} of the chord at eta {eta}, {}",
                self.shape_line,
                short(origin),
                if origin < 0.0 {
                    "ahead of the leading edge"
                } else {
                    "behind the trailing edge"
                }
            ));
        }
        let chords = self.shape.chord.points().map(|(_, chord)| chord);
        let chord = chords.fold(0.0, f64::max);
        let length = self.line.as_ref().map(ReferenceLine::length);
        remarks.extend(length.filter(|length| chord > *length).map(|length| {
            format!(
                "line {}: the largest chord, {} m, is longer than the blade, {} m",
                self.shape_line,
                short(chord),
                short(length)
            )
        }));
        remarks
    }
}

/// The remark on a layer with a taper that is longer than the layer is wide.
fn long_taper(layer: &WrittenLayer, resolvers: &[(f64, Resolver<'_>)]) -> Option<String> {
    let taper = layer.taper?;
    let there = resolvers.iter().filter(|(_, resolver)| resolver.has(layer));
    let lengths = there.filter_map(|(eta, resolver)| {
        let [from, to] = [&layer.from, &layer.to].map(|place| resolver.place(place));
        let width = (to?[0] - from?[0]) * resolver.perimeter();
        let length = taper.length(resolver.thickness(layer));
        (width > 0.0).then_some((*eta, length, width))
    });
    let (eta, length, width) =
        lengths
            .filter(|(_, length, width)| length > width)
            .reduce(|worst, one| {
                if one.1 / one.2 > worst.1 / worst.2 * (1.0 + SAME) {
                    one
                } else {
                    worst
                }
            })?;
    Some(format!(
        "line {}: the taper of layer \"{}\" is {} m long at eta {eta}, more than the layer is wide, {} m: \
         it is shortened",
        layer.line,
        layer.name,
        short(length),
        short(width)
    ))
}
