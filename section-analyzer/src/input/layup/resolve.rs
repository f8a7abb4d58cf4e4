//! The section at a position along the span: places become arcs.

use std::cell::OnceCell;

use shared_geom::units::rounded;

use super::fills::{FillBound, WrittenFill};
use super::names::{Found, POINTS};
use super::place::{Place, PlaceForm};
use super::problem::{LayupFileProblem, Located, Wrong};
use super::{Layup, WrittenLayer, WrittenWeb};
use crate::mesh::generate::layup::{Bound, Fill, Layer, LayupSection, Outline, Spar, Web, WebPly};

/// Thickness below which a layer is absent \[m\].
pub(super) const ABSENT: f64 = 1e-6;
/// Width below which a layer is absent \[m\].
const NARROW: f64 = 1e-3;
/// Part of the contour below which the width of a layer is none.
const NO_WIDTH: f64 = 1.01e-4;

/// Numbers of the layers that continue along webs, with the webs.
type Along<'a> = Vec<(&'a str, usize)>;

/// Resolves the places of a section.
pub(super) struct Resolver<'a> {
    layup: &'a Layup,
    eta: f64,
    outline: Outline,
    /// Arc length of the foremost point, once it is needed.
    foremost: OnceCell<f64>,
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
            foremost: OnceCell::new(),
        })
    }

    /// The section, lengths in meters, or all its problems.
    pub fn section(&self) -> Result<LayupSection, Vec<Located>> {
        let mut wrong = Wrong::default();
        let (layers, along) = self.layers(&mut wrong);
        let (webs, spar) = self.webs(&along, &mut wrong);
        let fills = self.layup.fills.iter();
        let fills = fills.filter(|fill| self.eta >= fill.range[0] && self.eta <= fill.range[1]);
        let fills = fills
            .filter_map(|fill| self.fill(fill, &mut wrong))
            .collect();
        wrong.none(LayupSection {
            contour: self.layup.shape.contour(self.eta),
            layers,
            webs,
            spar,
            fills,
            size: self.layup.size,
        })
    }

    /// The arcs of two places; notes the problems of both.
    fn both(
        &self,
        line: usize,
        places: [&Place; 2],
        (kind, name): (&str, &str),
        wrong: &mut Wrong,
    ) -> Option<[f64; 2]> {
        let [first, second] = places.map(|place| {
            let arc = self.arc(line, place, &mut Vec::new());
            wrong.keep(arc.map_err(|(line, problem)| (line, problem.of(kind, name))))
        });
        Some([first?, second?])
    }

    /// The layers of the shell, and the numbers of those that continue along webs, with the webs.
    fn layers(&self, wrong: &mut Wrong) -> (Vec<Layer>, Along<'_>) {
        let mut layers = Vec::new();
        let mut along = Vec::new();
        let present = self.layup.layers.iter();
        for layer in present.filter(|layer| self.has(layer) && !self.lacks_web(layer)) {
            let (ends, of) = ([&layer.from, &layer.to], ("layer", layer.name.as_str()));
            let Some([from, to]) = self.both(layer.line, ends, of, wrong) else {
                continue;
            };
            let perimeter = self.outline.perimeter();
            let width = (to - from) * perimeter;
            // other layers may leave no length between them
            let is_between = [&layer.from, &layer.to]
                .iter()
                .any(|place| matches!(place.form, PlaceForm::Named(_)));
            let is_narrow = width < NARROW.min(NO_WIDTH * perimeter);
            if is_narrow && (is_between || width > -NARROW) {
                continue;
            }
            let thickness = layer.thickness.at(self.eta);
            if let Some((web, _)) = &layer.web {
                along.push((web.as_str(), layers.len()));
            }
            layers.push(Layer {
                name: layer.name.clone(),
                thickness,
                from,
                to,
                taper: layer.taper.map(|taper| taper.length(thickness)),
                profile: layer.profile.clone(),
            });
        }
        (layers, along)
    }

    /// The webs, and the spar of the layers `along` one of them.
    fn webs(&self, along: &[(&str, usize)], wrong: &mut Wrong) -> (Vec<Web>, Option<Spar>) {
        let mut webs = Vec::new();
        let mut spar: Option<Spar> = None;
        for web in &self.layup.webs {
            if self.eta < web.range[0] || self.eta > web.range[1] {
                continue;
            }
            let Some(made) = self.web(web, wrong) else {
                continue;
            };
            if self.layup.is_of_spar(web) {
                let of_it = along.iter().filter(|(of, _)| *of == web.name);
                let layers: Vec<usize> = of_it.map(|(_, number)| *number).collect();
                if layers.is_empty() {
                    continue;
                }
                let others = spar.iter().flat_map(|spar| &spar.webs);
                if let Some(other) = others.map(|web| web.name.clone()).next() {
                    let webs = [other, made.name];
                    wrong.note((web.line, LayupFileProblem::TwoSpars { webs }));
                    continue;
                }
                spar = Some(Spar::around_nose(made.name, made.arcs, layers));
            } else {
                webs.push(made);
            }
        }
        (webs, spar)
    }

    fn web(&self, web: &WrittenWeb, wrong: &mut Wrong) -> Option<Web> {
        let arcs = self.both(web.line, web.places.each_ref(), ("web", &web.name), wrong)?;
        let plies = web.plies.iter().filter(|ply| self.has(ply));
        Some(Web {
            name: web.name.clone(),
            arcs,
            plies: plies
                .map(|ply| WebPly {
                    name: ply.name.clone(),
                    thickness: ply.thickness.at(self.eta),
                })
                .collect(),
        })
    }

    fn fill(&self, fill: &WrittenFill, wrong: &mut Wrong) -> Option<Fill> {
        let mut bound = |bound: &Option<FillBound>| match bound {
            None => Some(None),
            Some(FillBound::Web(name, _)) => Some(Some(Bound::Web(name.clone()))),
            Some(FillBound::Plane(places)) => {
                let of = ("fill", fill.name.as_str());
                let arcs = self.both(fill.line, places.each_ref(), of, wrong)?;
                Some(Some(Bound::Line(arcs)))
            }
        };
        let [ahead_of, aft_of] = [bound(&fill.bounds[0]), bound(&fill.bounds[1])];
        Some(Fill {
            name: fill.name.clone(),
            ahead_of: ahead_of?,
            aft_of: aft_of?,
        })
    }

    /// Whether a layer is present.
    pub fn has(&self, layer: &WrittenLayer) -> bool {
        self.thickness(layer) > ABSENT && !self.is_faded(layer)
    }

    /// The thickness of a layer; 0 outside of its table.
    pub fn thickness(&self, layer: &WrittenLayer) -> f64 {
        layer.thickness_at(self.eta)
    }

    /// Length of the contour.
    pub fn perimeter(&self) -> f64 {
        self.outline.perimeter()
    }

    /// The layup.
    pub fn layup(&self) -> &Layup {
        self.layup
    }

    /// Whether the web under which a layer lies does not stand here.
    fn lacks_web(&self, layer: &WrittenLayer) -> bool {
        let web = self.layup.web_under(layer);
        web.is_some_and(|web| !self.stands(web))
    }

    /// Whether a web is present; one without plies of its own has the plies of a spar, or is a
    /// plane.
    fn stands(&self, web: &WrittenWeb) -> bool {
        let layers = self.layup.layers.iter();
        let along = layers.filter(|layer| layer.web.as_ref().is_some_and(|of| of.0 == web.name));
        let mut plies = along.chain(&web.plies).peekable();
        let is_in = self.eta >= web.range[0] && self.eta <= web.range[1];
        is_in && (plies.peek().is_none() || plies.any(|ply| self.has(ply)))
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
        let line = if place.line > 0 { place.line } else { line };
        let long_shift = Some(place.shift.at(eta)).filter(|by| by.abs() > perimeter);
        let off = |place: String| {
            let (of, shift) = (String::new(), long_shift.map(|by| [by, perimeter]));
            let problem = LayupFileProblem::OffContour {
                of,
                place,
                eta,
                shift,
            };
            (line, problem)
        };
        let s = match &place.form {
            PlaceForm::Arc(course) => course.at(eta) * perimeter,
            PlaceForm::X(course, side) => {
                let x = course.at(eta);
                let y = (self.layup.shape.origin.at(eta) - x) * self.layup.shape.chord.at(eta);
                outline
                    .at_y(*side, y)
                    .ok_or_else(|| off(format!("x = {}", rounded(x))))?
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
                place.ok_or_else(|| off(format!("plane = {}", rounded(distance))))?
            }
            PlaceForm::Named(name) => self.named(line, name, places)? * perimeter,
        };
        let s = s + place.shift.at(eta) + place.part * perimeter;
        if !(s >= -1e-9 * perimeter && s <= perimeter * (1.0 + 1e-9)) {
            return Err(off(match &place.form {
                PlaceForm::Distance(course, _) => {
                    format!("distance = {} m", rounded(course.at(eta)))
                }
                _ => format!("arc {}", rounded(s / perimeter)),
            }));
        }
        Ok((s / perimeter).clamp(0.0, 1.0))
    }

    fn named(&self, line: usize, name: &str, places: &mut Vec<String>) -> Result<f64, Located> {
        let points = self.points();
        if let Some((_, s)) = points.iter().find(|one| one.0 == name) {
            return Ok(s / self.outline.perimeter());
        }
        if places.iter().any(|known| known == name) {
            places.push(name.to_owned());
            let places = places.clone();
            return Err((line, LayupFileProblem::Circle { places }));
        }
        let all = self.layup.known_places();
        let Some((_, found)) = all.iter().find(|one| one.0 == name) else {
            let points = points.iter().map(|one| one.0.to_owned());
            let problem = LayupFileProblem::Unknown {
                kind: "place",
                found: name.to_owned(),
                known: points.chain(all.into_iter().map(|one| one.0)).collect(),
            };
            return Err((line, problem));
        };
        places.push(name.to_owned());
        let arc = match found {
            Found::Place(place) => self.arc(line, place, places)?,
            Found::Face(web, side, sign) => {
                let arcs = [0, 1].map(|side| self.arc(line, &web.places[side], places));
                let [suction, pressure] = arcs;
                let face = self.face(web, [suction?, pressure?], (*side, *sign));
                let off = LayupFileProblem::OffContour {
                    of: String::new(),
                    place: name.to_owned(),
                    eta: self.eta,
                    shift: None,
                };
                face.ok_or((line, off))?
            }
        };
        places.pop();
        Ok(arc)
    }

    /// Arc lengths of points of the contour by their names.
    fn points(&self) -> [(&'static str, f64); 4] {
        let outline = &self.outline;
        let [suction, pressure] = outline.corners();
        let [nose, foremost, first, second] = POINTS;
        [
            (nose, outline.nose()),
            (foremost, *self.foremost.get_or_init(|| outline.foremost())),
            (first, suction),
            (second, pressure),
        ]
    }

    /// The arc at which the fore face (sign 1) or the aft face (-1) of a web meets a side: its
    /// plies are parallel to the line between its places.
    fn face(&self, web: &WrittenWeb, arcs: [f64; 2], (side, sign): (usize, f64)) -> Option<f64> {
        let perimeter = self.outline.perimeter();
        let points = arcs.map(|arc| self.outline.position(arc * perimeter));
        let line = [0, 1].map(|i| points[1][i] - points[0][i]);
        let height = line[0].hypot(line[1]);
        let normal = [-line[1] / height, line[0] / height];
        let sum = |plies: &mut dyn Iterator<Item = &WrittenLayer>| -> f64 {
            let here = plies.filter(|ply| self.has(ply));
            here.map(|ply| ply.thickness.at(self.eta)).sum()
        };
        // the place of the web of a spar is its aft face
        let along = self.layup.layers.iter();
        let mut along = along.filter(|layer| layer.web.as_ref().is_some_and(|of| of.0 == web.name));
        let offset = if self.layup.is_of_spar(web) {
            sum(&mut along) * sign.max(0.0)
        } else {
            0.5 * sign * sum(&mut web.plies.iter())
        };
        let ahead = |p: [f64; 2]| {
            (p[0] - points[0][0]) * normal[0] + (p[1] - points[0][1]) * normal[1] > offset
        };
        Some(self.outline.first_behind(side, ahead)? / perimeter)
    }
}
