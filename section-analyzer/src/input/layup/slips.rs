//! Values that mostly have a wrong unit or sign.

use shared_geom::line::ReferenceLine;

use super::outliers::outlier;
use super::problem::{LayupFileProblem, Located};
use super::resolve::Resolver;
use super::{Layup, WrittenLayer};
use crate::mesh::short;

/// Positions along the span at which layers are compared with their tapers.
const COMPARED: usize = 20;
/// Difference of ratios that counts [-].
const SAME: f64 = 1e-9;
/// Length of a blade over its largest chord from which one of both is likely in another unit [-].
const SLENDER: f64 = 150.0;

impl Layup {
    /// The problem of cells that are longer than the largest chord.
    pub(super) fn coarse(&self) -> Option<Located> {
        let chords = self.shape.chord.points().map(|(_, chord)| chord);
        let (size, chord) = (self.size?, chords.fold(0.0, f64::max));
        let problem = LayupFileProblem::Coarse { size, chord };
        (size > chord).then_some((self.size_line, problem))
    }

    /// Remarks on tapers that are longer than their layers, and on origins outside of the chord.
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
        remarks
    }

    /// Remarks on a shape that no blade has: chords that are longer than the blade or far too short for
    /// it, and airfoils with a point that is off the line of its neighbors.
    pub(super) fn odd_shape(&self) -> Vec<String> {
        let chords = self.shape.chord.points().map(|(_, chord)| chord);
        let chord = chords.fold(0.0, f64::max);
        let length = self.line.as_ref().map(ReferenceLine::length);
        let proportion = length.and_then(|length| {
            let [of_chord, of_blade] = [chord, length].map(short);
            let line = self.shape_line;
            if chord > length {
                Some(format!(
                    "line {line}: the largest chord, {of_chord} m, is longer than the blade, {of_blade} m"
                ))
            } else if length > SLENDER * chord {
                Some(format!(
                    "line {line}: the blade is {of_blade} m long, {:.0} times its largest chord, \
                     {of_chord} m: check the units of both",
                    length / chord
                ))
            } else {
                None
            }
        });
        let is_one = self.shape.airfoils().count() == 1;
        let outliers = self.shape.airfoils().filter_map(|(at, points)| {
            let ([x, z], distance) = outlier(points)?;
            let which = if is_one {
                String::new()
            } else {
                format!(" at {at}")
            };
            Some(format!(
                "line {}: the point ({x}, {z}) of the airfoil{which} is {} of the chord off the line \
                 between its neighbors, unlike the points near it: check its numbers",
                self.shape_line,
                short(distance)
            ))
        });
        proportion.into_iter().chain(outliers).collect()
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
