//! Problems of layup files, in addition to the problems of any input file and of the meshing.

use shared_geom::error::{Explain, nearest_name, quoted};
use shared_geom::units::rounded;

use super::angle::WITHIN_A_TURN;
use crate::mesh::generate::layup::LayupProblem;

/// A problem of a layup file.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum LayupFileProblem {
    /// A text that is no layup.
    #[error(
        "this is no layup{}, expected NAME.layup.toml, a windIO or a PreVABS file",
        .format.map(|title| format!(", but the format {title}")).unwrap_or_default()
    )]
    Format {
        /// The format of a blade that it has.
        format: Option<&'static str>,
    },
    /// No airfoil, or several.
    #[error("[shape] has {found} of \"naca\", \"file\" and \"airfoils\", expected one of them")]
    Airfoil {
        /// Number of them.
        found: usize,
    },
    /// Airfoils that are not in the order of the span.
    #[error("the airfoils are at {found}, expected ascending positions or thicknesses from 0 to 1")]
    AirfoilOrder {
        /// The first value that is not right.
        found: String,
    },
    /// A quantity of the shape that no blade has.
    #[error("{key} is {} at the position {} along the span, expected {expected}", rounded(*.found), rounded(*.at))]
    Shape {
        /// The key.
        key: &'static str,
        /// The value, in SI units.
        found: f64,
        /// The position, eta or a length [m].
        at: f64,
        /// Possible values.
        expected: String,
    },
    /// A quantity along the span with a wrong sign, or an angle that is too large.
    #[error("{key} is {found} at the position {} along the span, expected {expected}", rounded(*.at))]
    Value {
        /// The key.
        key: &'static str,
        /// The value, in SI units or deg.
        found: String,
        /// The position, eta or a length [m].
        at: f64,
        /// Possible values.
        expected: String,
    },
    /// A place of an airfoil that has no effect.
    #[error("{key} has no effect: {reason}")]
    IdlePlace {
        /// The key.
        key: &'static str,
        /// The reason, as text.
        reason: &'static str,
        /// The remedy, as text.
        remedy: &'static str,
    },
    /// Digits or points that are not an airfoil.
    #[error("{0}")]
    Points(String),
    /// Both sides from the nose on.
    #[error(
        "the points begin at the nose, and begin there again in row {row}, expected the trailing edge, the \
         upper side, the nose and the lower side in one line"
    )]
    NoseFirst {
        /// The row of the second side, from one.
        row: usize,
    },
    /// A name that the file does not have.
    #[error("{kind} \"{found}\" is not in the file")]
    Unknown {
        /// Kind of the thing.
        kind: &'static str,
        /// The name.
        found: String,
        /// The names of the file.
        known: Vec<String>,
    },
    /// One name twice.
    #[error(
        "\"{name}\" is the name of another layer, web or fill on line {line}, expected a name of its own"
    )]
    NameTwice {
        /// The name.
        name: String,
        /// Line of the other one.
        line: usize,
    },
    /// No thickness of a layer, or several.
    #[error(
        "layer \"{layer}\" has {found} of \"thickness\", \"count\" and \"plies\", expected one of them"
    )]
    Stack {
        /// The layer.
        layer: String,
        /// Number of them.
        found: usize,
    },
    /// Angles of plies and of the layer.
    #[error(
        "layer \"{layer}\" has the angles of its plies and \"fiber_angle\", expected one of them"
    )]
    Angles {
        /// The layer.
        layer: String,
    },
    /// Plies of a material without their thickness.
    #[error(
        "layer \"{layer}\" is given by plies, and material \"{material}\" has no ply thickness"
    )]
    NoPly {
        /// The layer.
        layer: String,
        /// The material.
        material: String,
    },
    /// A ramp of a layer whose profile needs none.
    #[error(
        "layer \"{layer}\" has a \"taper\" beside a \"profile\" that is zero at both ends, expected one \
         of them"
    )]
    Ramp {
        /// The layer.
        layer: String,
    },
    /// A ramp of a layer that has no ends.
    #[error(
        "layer \"{layer}\" continues along its web at both ends, and has a \"taper\" without effect"
    )]
    RampOfSpar {
        /// The layer.
        layer: String,
    },
    /// A web of nothing.
    #[error("web \"{web}\" has no plies, and no layer continues along it: it is nowhere")]
    NoPlies {
        /// The web.
        web: String,
    },
    /// Places of a web that are missing or doubled.
    #[error("web \"{web}\": expected \"suction\" and \"pressure\", or \"at\"")]
    WebPlaces {
        /// The web.
        web: String,
    },
    /// A place of no form, or of several.
    #[error(
        "expected one of \"arc\", \"x\", \"distance\", \"plane\" and \"at\"; a \"side\" with \"x\", \
         \"distance\" and \"plane\" alone, an \"angle\" with \"plane\" alone, \"from\" with \"distance\" \
         alone"
    )]
    Place,
    /// Layers that continue along two webs.
    #[error("layers continue along webs \"{}\" and \"{}\", expected one web at each position along the span", .webs[0], .webs[1])]
    TwoSpars {
        /// The webs.
        webs: [String; 2],
    },
    /// A web with plies, along which layers continue.
    #[error(
        "web \"{web}\" has plies of its own, and layers that continue along it, expected one of them"
    )]
    PliesOfSpar {
        /// The web.
        web: String,
    },
    /// A form of the trailing edge in the table of the shape.
    #[error("the layers and the base close the trailing edge, its form is not a key of [shape]")]
    TrailingEdge,
    /// A width beside both ends, or without one.
    #[error("layer \"{layer}\" has a \"width\", expected one of \"from\" and \"to\" beside it")]
    Width {
        /// The layer.
        layer: String,
    },
    /// A layer around the nose that has no web to go back.
    #[error(
        "layer \"{layer}\" goes around the nose, expected the \"web\" along which it continues"
    )]
    Around {
        /// The layer.
        layer: String,
    },
    /// A foot of nothing.
    #[error(
        "the foot of web \"{web}\" has neither \"plies\" nor \"bond\", expected one of them or both"
    )]
    Foot {
        /// The web.
        web: String,
    },
    /// Positions that are given twice.
    #[error("expected \"eta\" and \"value\", \"span\" and \"value\", or \"file\" and \"column\"")]
    Positions,
    /// A layer, ply or fill without a key that it needs.
    #[error("\"{layer}\" has no \"{key}\", expected the name of a table [{key}.NAME]")]
    Lacks {
        /// Its name.
        layer: String,
        /// The key.
        key: &'static str,
    },
    /// Lengths along the span without a length of the blade.
    #[error("positions are given by \"span\", expected \"eta\" in a layup without [line]")]
    NoLine,
    /// Lengths along the span beyond the blade.
    #[error("a \"span\" goes to {found} m, expected at most {length} m, the length of the line")]
    Beyond {
        /// The largest one \[m\].
        found: f64,
        /// The length of the line \[m\].
        length: f64,
    },
    /// Places that refer to each other.
    #[error("places go in a circle: {}", .places.join(" -> "))]
    Circle {
        /// The places.
        places: Vec<String>,
    },
    /// A place that is not on the contour.
    #[error(
        "\"{place}\" of {of} is not on the contour at eta {eta}{}",
        .shift.map_or_else(String::new, |[by, length]| format!(
            ": it is shifted by {} m, and the contour is {} m long", rounded(by), rounded(length)
        ))
    )]
    OffContour {
        /// The layer, web or fill, with its kind.
        of: String,
        /// The place.
        place: String,
        /// The position along the span [-].
        eta: f64,
        /// A shift that is longer than the contour, and the length of the contour \[m\].
        shift: Option<[f64; 2]>,
    },
    /// A range along the span that is not one.
    #[error("\"eta\" of \"{name}\" is {found}, expected two ascending positions from 0 to 1")]
    Range {
        /// The web or fill.
        name: String,
        /// The positions.
        found: String,
    },
    /// A layer that ends before it starts.
    #[error(
        "layer \"{layer}\" at eta {eta} starts at arc {} and ends at {}, expected its start before its \
         end",
        .ends[0], .ends[1]
    )]
    Swapped {
        /// The layer.
        layer: String,
        /// The first position along the span at which it is compared [-].
        eta: f64,
        /// Its arcs, with the layers or places from which they are.
        ends: [String; 2],
    },
    /// Cells that are longer than any section.
    #[error(
        "\"size\" is {} m, expected at most {} m, the largest chord",
        rounded(*.size), rounded(*.chord)
    )]
    Coarse {
        /// The length of the cells \[m\].
        size: f64,
        /// The largest chord \[m\].
        chord: f64,
    },
    /// A section that cannot be meshed.
    #[error("eta {eta}: {problem}{}", if .problem.has_lengths() { "; lengths in m" } else { "" })]
    Section {
        /// The position along the span [-].
        eta: f64,
        /// The problem.
        problem: LayupProblem,
    },
}

impl LayupFileProblem {
    /// The problem of an angle \[rad\] beyond a turn.
    pub(super) fn turned(key: &'static str, angle: f64, at: f64) -> Self {
        Self::Value {
            key,
            found: format!("{} deg", rounded(angle.to_degrees())),
            at,
            expected: WITHIN_A_TURN.to_owned(),
        }
    }

    /// The problem of a place, with the layer, web or fill that has it.
    pub(super) fn of(mut self, kind: &str, name: &str) -> Self {
        if let Self::OffContour { of, .. } = &mut self {
            *of = format!("{kind} \"{name}\"");
        }
        self
    }
}

/// A problem, and the line of the file that it belongs to.
pub(super) type Located = (usize, LayupFileProblem);

/// The problems of a section.
#[derive(Debug, Default)]
pub(super) struct Wrong(Vec<Located>);

impl Wrong {
    /// Notes a problem, unless the same line has it already: a place that several layers use.
    pub fn note(&mut self, (line, problem): Located) {
        let place = |problem: &LayupFileProblem| match problem {
            LayupFileProblem::OffContour { place, .. } => Some(place.clone()),
            _ => None,
        };
        let is_it = |known: &Located| {
            let same_place = place(&known.1).is_some() && place(&known.1) == place(&problem);
            known.0 == line && (same_place || known.1 == problem)
        };
        if !self.0.iter().any(is_it) {
            self.0.push((line, problem));
        }
    }

    /// The value of a result, or a note of its problem.
    pub fn keep<T>(&mut self, result: Result<T, Located>) -> Option<T> {
        result.map_err(|problem| self.note(problem)).ok()
    }

    /// The value if there are no problems, else all of them.
    pub fn none<T>(self, value: T) -> Result<T, Vec<Located>> {
        if self.0.is_empty() {
            Ok(value)
        } else {
            Err(self.0)
        }
    }
}

impl Explain for LayupFileProblem {
    fn help(&self) -> Option<String> {
        match self {
            Self::Format { .. } => Some(
                "sections come from the layers of a blade; \"beam-dynamics describe\" shows a blade that \
                 has stiffnesses already"
                    .into(),
            ),
            Self::Airfoil { .. } => {
                Some("naca = \"4415\", file = \"airfoil.dat\", or [[shape.airfoils]]".into())
            }
            Self::Shape { .. } => {
                Some("check the unit: parts of the chord are numbers as 0.3, not percent".into())
            }
            Self::NoseFirst { .. } => Some(
                "reverse the rows of the upper side; a file whose first row has the numbers of points of both \
                 sides, as \"50. 50.\", is read as it is"
                    .into(),
            ),
            Self::Unknown { found, known, .. } => Some(help_of_unknown(found, known)),
            Self::NoPly { material, .. } => Some(format!(
                "add ply_thickness to [material.{material}], or give \"thickness\""
            )),
            Self::RampOfSpar { .. } => Some(
                "remove \"taper\", or give \"from\" or \"to\", the end at which the thickness drops"
                    .into(),
            ),
            Self::NoPlies { web } => Some(format!(
                "give its \"plies\", or web = \"{web}\" in the layers of a spar, or remove it; a \
                 place without a wall is a [place.NAME]"
            )),
            Self::TrailingEdge => Some(
                "a wall is a [[web]] with at = \"trailing_edge\", a tab behind a flat base such a web \
                 as thick as the tab is long, an adhesive bond = { material, to } in a table \
                 [trailing_edge], or a [[fill]]"
                    .into(),
            ),
            Self::AirfoilOrder { .. } => Some(
                "list them from root to tip, or from thin to thick; a thickness is a part of the \
                 chord, as 0.3"
                    .into(),
            ),
            Self::Section { problem, .. } => problem.help(),
            _ => self.help_of_place(),
        }
    }
}

/// The remedy for a name that is not known, or for a place of a layer or web that is.
fn help_of_unknown(found: &str, known: &[String]) -> String {
    let [own, part] = match found.split_once('.') {
        Some((name, part)) => [&found[..=name.len()], part],
        None => ["", found],
    };
    let of_it = known.iter().filter_map(|place| place.strip_prefix(own));
    let of_it: Vec<&str> = of_it.collect();
    let all = known.iter().map(String::as_str);
    let near = match nearest_name(part, of_it.iter().copied()) {
        Some(near) => Some(format!("{own}{near}")),
        None if own.is_empty() || of_it.is_empty() => nearest_name(found, all).map(str::to_owned),
        None => {
            let places: Vec<String> = of_it.iter().map(|part| format!("{own}{part}")).collect();
            return format!("its places are {}", quoted(&places));
        }
    };
    match near {
        Some(near) => format!("did you mean \"{near}\"?"),
        None => format!("the file has {}", quoted(known)),
    }
}

impl LayupFileProblem {
    /// The remedy of a problem of places and ranges.
    fn help_of_place(&self) -> Option<String> {
        match self {
            Self::OffContour { shift: Some(_), .. } => Some(
                "check the unit of the shift, or of the width of the layer: a layer around its middle is \
                 shifted by half of it; windIO has meters"
                    .into(),
            ),
            Self::OffContour { .. } => Some(
                "x is a part of the chord, and arc of the contour, from 0 to 1; distance is a length \
                 along the contour; in a shift, as \"nose - 45 mm\", a number without a unit is a part of the contour"
                    .into(),
            ),
            Self::Circle { places } => Some(format!(
                "give \"{}\" by a place of another form, as 0.31, {{ x = 0.3, side = \"suction\" }} or \"nose\"",
                places.first().map_or("one of them", String::as_str)
            )),
            Self::IdlePlace { remedy, .. } => Some((*remedy).into()),
            Self::Coarse { .. } => Some(
                "check its unit; without it 120 cells are around the contour".into(),
            ),
            Self::Range { .. } => Some(
                "eta = [0.1, 0.9]; without it, the web or fill has the whole span".into(),
            ),
            Self::Swapped { .. } => Some(
                "swap them? Or correct the layer to which one refers. Arcs grow from the trailing edge \
                 over the suction side to the nose, and on the pressure side from the nose to the trailing \
                 edge; a layer through the trailing edge is two layers"
                    .into(),
            ),
            _ => None,
        }
    }
}
