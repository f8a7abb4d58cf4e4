//! The section at a position along the span: places become arcs.

use super::place::{Place, PlaceForm};
use super::problem::LayupFileProblem;
use super::{Layup, WrittenLayer, WrittenWeb};
use crate::mesh::generate::layup::{Layer, LayupSection, Outline, Web, WebPly};

/// Thickness below which a layer is absent \[m\].
pub(super) const ABSENT: f64 = 1e-6;
/// Width below which a layer is absent \[m\].
const NARROW: f64 = 1e-3;

/// A problem, and the line of the file that it belongs to.
pub(super) type Located = (usize, LayupFileProblem);

/// Resolves the places of a section.
pub(super) struct Resolver<'a> {
    layup: &'a Layup,
    eta: f64,
    outline: Outline,
}

impl<'a> Resolver<'a> {
    /// At a position along the span.
    pub fn new(layup: &'a Layup, eta: f64) -> Result<Self, Located> {
        let outline = Outline::new(&layup.shape.contour(eta));
        let problem = |problem| (layup.shape_line, LayupFileProblem::Section { eta, problem });
        Ok(Self {
            layup,
            eta,
            outline: outline.map_err(problem)?,
        })
    }

    /// The section, lengths in meters.
    pub fn section(&self) -> Result<LayupSection, Located> {
        let mut layers = Vec::new();
        for layer in self.layup.layers.iter().filter(|layer| self.has(layer)) {
            let mut places = Vec::new();
            let from = self.arc(layer.line, &layer.from, &mut places)?;
            let to = self.arc(layer.line, &layer.to, &mut places)?;
            let perimeter = self.outline.perimeter();
            let width = (to - from) * perimeter;
            // other layers may leave no length between them
            let is_between = [&layer.from, &layer.to]
                .iter()
                .any(|place| matches!(place.form, PlaceForm::Named(_)));
            let is_narrow = width < NARROW.min(1e-3 * perimeter);
            if is_narrow && (is_between || width > -NARROW) {
                continue;
            }
            layers.push(Layer {
                name: layer.name.clone(),
                thickness: layer.thickness.at(self.eta),
                from,
                to,
                taper: layer.taper,
            });
        }
        let mut webs = Vec::new();
        for web in &self.layup.webs {
            if self.eta < web.range[0] || self.eta > web.range[1] {
                continue;
            }
            webs.push(self.web(web)?);
        }
        Ok(LayupSection {
            contour: self.layup.shape.contour(self.eta),
            layers,
            webs,
            size: self.layup.size,
        })
    }

    fn web(&self, web: &WrittenWeb) -> Result<Web, Located> {
        let mut places = Vec::new();
        let suction = self.arc(web.line, &web.places[0], &mut places)?;
        let pressure = self.arc(web.line, &web.places[1], &mut places)?;
        let plies = web.plies.iter().filter(|ply| self.has(ply));
        Ok(Web {
            name: web.name.clone(),
            arcs: [suction, pressure],
            plies: plies
                .map(|ply| WebPly {
                    name: ply.name.clone(),
                    thickness: ply.thickness.at(self.eta),
                })
                .collect(),
        })
    }

    /// Whether a layer is present.
    fn has(&self, layer: &WrittenLayer) -> bool {
        layer.thickness.covers(self.eta) && layer.thickness.at(self.eta) > ABSENT
    }

    /// The part of the contour at a place, and the length of the contour over the chord.
    pub fn place(&self, place: &Place) -> Option<[f64; 2]> {
        let arc = self.arc(0, place, &mut Vec::new()).ok()?;
        let chord = self.layup.shape.chord.at(self.eta);
        Some([arc, self.outline.perimeter() / chord])
    }

    /// The part of the contour at a place; `places` are those that led to it.
    fn arc(&self, line: usize, place: &Place, places: &mut Vec<String>) -> Result<f64, Located> {
        let (outline, eta) = (&self.outline, self.eta);
        let perimeter = outline.perimeter();
        let off = |place: String| (line, LayupFileProblem::OffContour { place, eta });
        let s = match &place.form {
            PlaceForm::Arc(course) => course.at(eta) * perimeter,
            PlaceForm::X(course, side) => {
                let x = course.at(eta);
                let y = (self.layup.shape.origin.at(eta) - x) * self.layup.shape.chord.at(eta);
                outline
                    .at_y(*side, y)
                    .ok_or_else(|| off(format!("x = {x}")))?
            }
            PlaceForm::Distance(course, side) => {
                let distance = course.at(eta);
                let corner = outline.corners()[*side];
                if *side == 0 {
                    corner + distance
                } else {
                    corner - distance
                }
            }
            PlaceForm::Plane(course, angle, side) => {
                let (distance, (sine, cosine)) = (course.at(eta), angle.at(eta).sin_cos());
                // the direction behind the plane, y forward and z toward the suction side
                let ahead = |p: [f64; 2]| -cosine * p[0] - sine * p[1] < distance;
                let place = outline.first_behind(*side, ahead);
                place.ok_or_else(|| off(format!("plane = {distance}")))?
            }
            PlaceForm::Named(name) => self.named(line, name, places)? * perimeter,
        };
        let s = s + place.shift.at(eta);
        if !(s >= -1e-9 * perimeter && s <= perimeter * (1.0 + 1e-9)) {
            return Err(off(format!("arc {}", s / perimeter)));
        }
        Ok((s / perimeter).clamp(0.0, 1.0))
    }

    fn named(&self, line: usize, name: &str, places: &mut Vec<String>) -> Result<f64, Located> {
        match name {
            "nose" => return Ok(self.outline.nose() / self.outline.perimeter()),
            "leading_edge" => return Ok(self.outline.foremost() / self.outline.perimeter()),
            _ => {}
        }
        if places.iter().any(|known| known == name) {
            places.push(name.to_owned());
            let places = places.clone();
            return Err((line, LayupFileProblem::Circle { places }));
        }
        let mut all = vec![("nose".to_owned(), None), ("leading_edge".to_owned(), None)];
        for layer in &self.layup.layers {
            all.push((format!("{}.start", layer.name), Some(&layer.from)));
            all.push((format!("{}.end", layer.name), Some(&layer.to)));
        }
        for web in &self.layup.webs {
            all.push((format!("{}.suction", web.name), Some(&web.places[0])));
            all.push((format!("{}.pressure", web.name), Some(&web.places[1])));
        }
        let found = all.iter().find(|(known, _)| known == name);
        let Some((_, Some(place))) = found else {
            let problem = LayupFileProblem::Unknown {
                kind: "place",
                found: name.to_owned(),
                known: all.into_iter().map(|one| one.0).collect(),
            };
            return Err((line, problem));
        };
        places.push(name.to_owned());
        let arc = self.arc(line, place, places)?;
        places.pop();
        Ok(arc)
    }
}
