//! Layers whose ends are swapped.

use shared_geom::units::rounded;

use super::course::Course;
use super::place::{Place, PlaceForm};
use super::problem::{LayupFileProblem, Located};
use super::resolve::{ABSENT, Resolver};
use super::{Layup, WrittenLayer};

/// Positions along the span at which ends of layers are compared.
const COMPARED: usize = 20;
/// Part of the contour by which a layer ends before its start, at least: layers between two others
/// may have no width.
const LEAST: f64 = 5e-3;

impl Layup {
    /// Names of places that are wrong, webs without a use, and if all are right swapped ends of layers,
    /// with their lines.
    pub(super) fn wrong_ends(&self) -> Vec<Located> {
        let mut problems = self.wrong_places();
        problems.extend(self.idle_webs());
        match problems[..] {
            [] => self.swapped_layers(),
            _ => problems,
        }
    }

    /// Layers that end before they start at all positions along the span at which they are, with
    /// their lines.
    pub(super) fn swapped_layers(&self) -> Vec<Located> {
        let etas: Vec<f64> = (0..=COMPARED).map(|i| i as f64 / COMPARED as f64).collect();
        let is_any = self.layers.iter().any(|layer| plain(layer).is_none());
        let resolvers = etas.iter().filter(|_| is_any);
        let resolvers = resolvers.filter_map(|eta| Some((*eta, Resolver::new(self, *eta).ok()?)));
        let resolvers: Vec<(f64, Resolver<'_>)> = resolvers.collect();
        let mut problems = Vec::new();
        for layer in &self.layers {
            let arcs: Vec<(f64, [f64; 2])> = match plain(layer) {
                Some(courses) => {
                    let there = etas.iter().filter(|eta| layer.thickness_at(**eta) > ABSENT);
                    there
                        .map(|eta| (*eta, courses.map(|course| course.at(*eta))))
                        .collect()
                }
                None => {
                    let there = resolvers.iter().filter(|(_, resolver)| resolver.has(layer));
                    let arcs = there.filter_map(|(eta, resolver)| {
                        let [from, to] =
                            [&layer.from, &layer.to].map(|place| resolver.place(place));
                        Some((*eta, [from?[0], to?[0]]))
                    });
                    arcs.collect()
                }
            };
            let is_swapped = |(_, [from, to]): &(f64, [f64; 2])| from - to > LEAST;
            if let Some((eta, arcs)) = arcs.first().filter(|_| arcs.iter().all(is_swapped)) {
                let places = [&layer.from, &layer.to];
                let problem = LayupFileProblem::Swapped {
                    layer: layer.name.clone(),
                    eta: *eta,
                    ends: [0, 1].map(|end| shown(arcs[end], places[end])),
                };
                problems.push((layer.line, problem));
            }
        }
        problems
    }
}

/// An arc, with the layer or place from which it is.
fn shown(arc: f64, place: &Place) -> String {
    let arc = rounded(arc);
    match place.name().map(|name| (name, name.rsplit_once('.'))) {
        Some((_, Some((layer, end @ ("start" | "end"))))) => {
            format!("{arc} (the {end} of \"{layer}\")")
        }
        Some((name, _)) => format!("{arc} (\"{name}\")"),
        None => arc.to_string(),
    }
}

/// The arcs of a layer whose places need no contour.
fn plain(layer: &WrittenLayer) -> Option<[&Course; 2]> {
    Some([arc(&layer.from)?, arc(&layer.to)?])
}

/// The arc of a place without a shift.
fn arc(place: &Place) -> Option<&Course> {
    match &place.form {
        PlaceForm::Arc(arc) if place.shift.is_zero() => Some(arc),
        _ => None,
    }
}
