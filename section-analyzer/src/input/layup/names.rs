//! Names of places: those that are not in the file or go in circles, and those without a use.

use super::place::{Place, PlaceForm, SIDES};
use super::problem::{LayupFileProblem, Located};
use super::{Layup, WrittenFill, WrittenLayer, WrittenWeb};

/// Points of the contour by their names.
pub(super) const POINTS: [&str; 4] = ["nose", "leading_edge", "base.suction", "base.pressure"];

/// A place with a name.
pub(super) enum Found<'a> {
    Place(&'a Place),
    /// Face of a web on a side, fore 1 or aft -1.
    Face(&'a WrittenWeb, usize, f64),
}

impl Found<'_> {
    /// The names that it refers to.
    fn names(&self) -> Vec<&str> {
        let places = match self {
            Self::Place(place) => std::slice::from_ref(*place),
            Self::Face(web, ..) => &web.places[..],
        };
        places.iter().filter_map(Place::name).collect()
    }
}

impl Place {
    /// The name of the place that it refers to.
    pub(super) fn name(&self) -> Option<&str> {
        match &self.form {
            PlaceForm::Named(name) => Some(name),
            _ => None,
        }
    }
}

impl Layup {
    /// The places that have names.
    pub(super) fn known_places(&self) -> Vec<(String, Found<'_>)> {
        let mut all = Vec::new();
        for layer in &self.layers {
            // plies of a layer have its places
            let layer_name = layer.name.split('/').next().unwrap_or_default();
            let names = [layer.name.as_str(), layer_name];
            for name in &names[..1 + usize::from(names[0] != names[1])] {
                all.push((format!("{name}.start"), Found::Place(&layer.from)));
                all.push((format!("{name}.end"), Found::Place(&layer.to)));
            }
        }
        for web in &self.webs {
            for (side, word) in SIDES.iter().enumerate() {
                let name = format!("{}.{word}", web.name);
                all.push((format!("{name}.fore"), Found::Face(web, side, 1.0)));
                all.push((format!("{name}.aft"), Found::Face(web, side, -1.0)));
                all.push((name, Found::Place(&web.places[side])));
            }
        }
        let named = self.places.iter();
        all.extend(named.map(|(name, place)| (name.clone(), Found::Place(place))));
        all
    }

    /// The web under which a layer lies: both of its ends are places of one side of it.
    pub(super) fn web_under(&self, layer: &WrittenLayer) -> Option<&WrittenWeb> {
        let known = self.known_places();
        let [from, to] = [&layer.from, &layer.to].map(|place| self.foot(place, &known));
        let (web, side) = from?;
        let (other, other_side) = to?;
        (web.name == other.name && side == other_side).then_some(web)
    }

    /// The web and the side of a place that is given by a face of it or its middle.
    fn foot(&self, place: &Place, known: &[(String, Found<'_>)]) -> Option<(&WrittenWeb, usize)> {
        let mut place = place;
        // no circle is longer
        for _ in 0..=known.len() {
            let name = place.name()?;
            for web in &self.webs {
                let rest = name.strip_prefix(web.name.as_str());
                let Some(rest) = rest.and_then(|rest| rest.strip_prefix('.')) else {
                    continue;
                };
                let side = SIDES.iter().position(|side| {
                    let rest = rest.strip_prefix(side);
                    rest.is_some_and(|rest| matches!(rest, "" | ".fore" | ".aft"))
                });
                if let Some(side) = side {
                    return Some((web, side));
                }
            }
            let (_, found) = known.iter().find(|one| one.0 == name)?;
            match found {
                Found::Place(next) => place = next,
                Found::Face(..) => return None,
            }
        }
        None
    }

    /// Webs without plies that nothing refers to.
    pub(super) fn idle_webs(&self) -> Vec<Located> {
        let names: Vec<&str> = self.all_places().filter_map(Place::name).collect();
        let is_used = |web: &WrittenWeb| {
            let is_of_it = |name: &&str| {
                let rest = name.strip_prefix(web.name.as_str());
                rest.is_some_and(|rest| rest.starts_with('.'))
            };
            let mut fills = self.fills.iter().flat_map(WrittenFill::webs);
            self.is_of_spar(web) || names.iter().any(is_of_it) || fills.any(|of| of.0 == web.name)
        };
        let idle = self.webs.iter();
        let idle = idle.filter(|web| web.plies.is_empty() && !is_used(web));
        let problem = |web: &WrittenWeb| {
            let web_name = web.name.clone();
            (web.line, LayupFileProblem::NoPlies { web: web_name })
        };
        idle.map(problem).collect()
    }

    /// Names that places refer to.
    pub(super) fn place_names(&self) -> impl Iterator<Item = &str> {
        self.all_places().filter_map(Place::name)
    }

    /// All places that are given.
    fn all_places(&self) -> impl Iterator<Item = &Place> {
        let layers = self.layers.iter();
        let layers = layers.flat_map(|layer| [&layer.from, &layer.to]);
        let webs = self.webs.iter().flat_map(|web| &web.places);
        let fills = self.fills.iter().flat_map(WrittenFill::places);
        let named = self.places.iter().map(|(_, place)| place);
        layers.chain(webs).chain(fills).chain(named)
    }

    /// Names that the file does not have, and circles of names, with the lines that they are on.
    pub(super) fn wrong_places(&self) -> Vec<Located> {
        let known = self.known_places();
        let mut problems: Vec<Located> = Vec::new();
        let mut seen: Vec<String> = Vec::new();
        for place in self.all_places() {
            let mut path = Vec::new();
            let problem = place.name().and_then(|name| wrong(name, &known, &mut path));
            let Some(problem) = problem else {
                continue;
            };
            // the plies of a layer have one place, and all places of a circle lead into it
            let is_seen = match &problem {
                LayupFileProblem::Circle { places } => places.iter().any(|one| seen.contains(one)),
                _ => problems.contains(&(place.line, problem.clone())) || path.len() > 1,
            };
            if let LayupFileProblem::Circle { places } = &problem {
                seen.extend(places.iter().cloned());
            }
            if !is_seen {
                problems.push((place.line, problem));
            }
        }
        problems
    }

    /// Remarks on tables of places that nothing refers to, or whose name another place has.
    pub(super) fn idle_places(&self) -> Vec<String> {
        let all: Vec<&str> = self.all_places().filter_map(Place::name).collect();
        let known = self.known_places();
        let mut remarks = Vec::new();
        for (name, place) in &self.places {
            let others = known.iter().filter(|one| one.0 == *name).count();
            let at = format!("line {}: place \"{name}\"", place.line);
            if POINTS.contains(&name.as_str()) {
                remarks.push(format!(
                    "{at} has the name of a point of the contour, which is used"
                ));
            } else if others > 1 {
                remarks.push(format!(
                    "{at} has the name of a place of a layer or web, which is used"
                ));
            } else if !all.contains(&name.as_str()) {
                remarks.push(format!("{at} is not used"));
            }
        }
        remarks
    }
}

/// Names that are given twice, and unknown webs of fills, with their lines.
pub(super) fn wrong_names(
    layers: &[WrittenLayer],
    webs: &[WrittenWeb],
    fills: &[WrittenFill],
) -> Vec<(usize, LayupFileProblem)> {
    let mut known: Vec<(&str, usize)> = Vec::new();
    let mut problems = Vec::new();
    let plies = webs.iter().flat_map(|web| &web.plies);
    let names = layers
        .iter()
        .chain(plies)
        .map(|layer| (layer.name.as_str(), layer.line));
    let names = names.chain(webs.iter().map(|web| (web.name.as_str(), web.line)));
    for (name, line) in names.chain(fills.iter().map(|fill| (fill.name.as_str(), fill.line))) {
        match known.iter().find(|one| one.0 == name) {
            Some((_, first)) => {
                let name = name.to_owned();
                problems.push((line, LayupFileProblem::NameTwice { name, line: *first }));
            }
            None => known.push((name, line)),
        }
    }
    let of_layers = layers.iter().filter_map(|layer| layer.web.as_ref());
    let of_layers = of_layers.map(|(name, line)| (name.as_str(), *line));
    problems.extend(wrong_spars(of_layers.clone(), webs));
    for (name, line) in fills.iter().flat_map(WrittenFill::webs).chain(of_layers) {
        if webs.iter().all(|web| web.name != name) {
            let problem = LayupFileProblem::Unknown {
                kind: "web",
                found: name.to_owned(),
                known: webs.iter().map(|web| web.name.clone()).collect(),
            };
            problems.push((line, problem));
        }
    }
    problems
}

/// Webs of layers that have plies of their own, or that stand at positions along the span of the web
/// of another such layer.
fn wrong_spars<'a>(
    mut of_layers: impl Iterator<Item = (&'a str, usize)> + Clone,
    webs: &[WrittenWeb],
) -> Vec<(usize, LayupFileProblem)> {
    let range = |name: &str| {
        webs.iter()
            .find(|web| web.name == name)
            .map(|web| web.range)
    };
    let is_beside = |a: &str, b: &str| match (range(a), range(b)) {
        (Some(a), Some(b)) => a[0] < b[1] && b[0] < a[1],
        _ => false,
    };
    let all = of_layers.clone();
    let problem = |(name, line): (&'a str, usize)| {
        let mut before = all.clone().take_while(|other| other.1 != line);
        let first = before.find(|other| other.0 != name && is_beside(other.0, name));
        let first = first.map(|first| first.0);
        let has_plies = || {
            webs.iter()
                .any(|web| web.name == name && !web.plies.is_empty())
        };
        let problem = match first {
            Some(first) => LayupFileProblem::TwoSpars {
                webs: [first, name].map(str::to_owned),
            },
            None if has_plies() => LayupFileProblem::PliesOfSpar {
                web: name.to_owned(),
            },
            None => return None,
        };
        Some((line, problem))
    };
    // one of a kind is enough
    of_layers.find_map(problem).into_iter().collect()
}

/// The problem of a name: it, or one that it leads to, is unknown or in a circle; `path` are the
/// names that led to it.
fn wrong(
    name: &str,
    known: &[(String, Found<'_>)],
    path: &mut Vec<String>,
) -> Option<LayupFileProblem> {
    if POINTS.contains(&name) {
        return None;
    }
    let first = path.iter().position(|one| one == name);
    path.push(name.to_owned());
    if let Some(first) = first {
        let places = path[first..].to_vec();
        return Some(LayupFileProblem::Circle { places });
    }
    let Some((_, found)) = known.iter().find(|one| one.0 == name) else {
        let points = POINTS.iter().map(|one| (*one).to_owned());
        return Some(LayupFileProblem::Unknown {
            kind: "place",
            found: name.to_owned(),
            known: points
                .chain(known.iter().map(|one| one.0.clone()))
                .collect(),
        });
    };
    for next in found.names() {
        if let Some(problem) = wrong(next, known, path) {
            return Some(problem);
        }
    }
    path.pop();
    None
}
