//! Problems of blade sections to be meshed.

use shared_geom::error::Explain;

use super::super::super::short;
use super::super::layup::LayupProblem;

/// Largest number of cells of a section: far beyond any need.
pub(super) const MOST_CELLS: usize = 400_000;

/// The part of the input with the problem.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BladePart {
    /// Shape and position of the airfoil.
    Airfoil,
    /// The skin.
    Skin,
    /// The plies of the spar.
    Spar,
    /// The front web.
    FrontWeb,
    /// The rear web.
    RearWeb,
    /// A ply of the spar: its number, outermost first.
    Ply(usize),
    /// The mass in the nose.
    NoseMass,
    /// Sizes of the cells.
    Mesh,
}

/// A blade section that cannot be meshed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum BladeProblem {
    /// Digits that are not an airfoil.
    #[error("\"{found}\" is not a NACA airfoil: expected {why}")]
    Naca {
        /// The digits.
        found: String,
        /// Description of the expected digits.
        why: &'static str,
    },
    /// Too few points for a curve.
    #[error("the airfoil has {found} points, expected {least} or more")]
    FewPoints {
        /// Points found.
        found: usize,
        /// The smallest number.
        least: usize,
    },
    /// Points that are not fractions of the chord.
    #[error("the x of the airfoil run from {} to {}, expected 0 at the nose to 1 at the trailing edge", short(*.low), short(*.high))]
    Range {
        /// The least x/c [-].
        low: f64,
        /// The largest x/c [-].
        high: f64,
    },
    /// Points that do not begin and end at the trailing edge.
    #[error("the points of the airfoil begin at x/c = {} and end at x/c = {}, expected both at the trailing edge", short(*.first), short(*.last))]
    Order {
        /// x/c of the first point [-].
        first: f64,
        /// x/c of the last point [-].
        last: f64,
    },
    /// A point twice in a row.
    #[error("point {number} of the airfoil is the same as the one before it")]
    Doubled {
        /// Its index, from one.
        number: usize,
    },
    /// Points in the opposite order.
    #[error("the points of the airfoil run over the lower surface first")]
    LowerFirst,
    /// Surfaces that cross.
    #[error("the upper surface of the airfoil lies on or below the lower one at x/c = {}", short(*.part))]
    Crossed {
        /// Chordwise position [-].
        part: f64,
    },
    /// An end ahead of the thickest point of the airfoil.
    #[error("the airfoil cannot end at x/c = {}: both surfaces do not reach it", short(*.end))]
    End {
        /// Part of the chord [-].
        end: f64,
    },
    /// A web outside of the airfoil.
    #[error("there is no space for a web at x/c = {} inside of the skin", short(*.part))]
    WebOutside {
        /// The web.
        web: BladePart,
        /// Part of the chord [-].
        part: f64,
    },
    /// A front web behind the rear web.
    #[error("the front web at x/c = {} is not ahead of the rear one at x/c = {}", short(*.front), short(*.rear))]
    WebOrder {
        /// Part of the chord of the front web [-].
        front: f64,
        /// Part of the chord of the rear web [-].
        rear: f64,
    },
    /// A web that shares no ply with the walls.
    #[error("no ply continues from the {} into the {surface} surface: the web would be joined to it along an edge only", web_name(*.web))]
    WebLoose {
        /// The web.
        web: BladePart,
        /// `upper` or `lower`.
        surface: &'static str,
    },
    /// A web whose plies fill the spar along the chord.
    #[error("the plies of the {} need {} of the {} surface of the spar, which is {} long", web_name(*.web), short(*.thickness), .surface, short(*.space))]
    WebThick {
        /// The web.
        web: BladePart,
        /// `upper` or `lower`.
        surface: &'static str,
        /// Required length of the surface [unit of the mesh].
        thickness: f64,
        /// Available length [unit of the mesh].
        space: f64,
    },
    /// A ply outside of the spar.
    #[error("ply \"{ply}\" runs from x/c = {} to {}, expected a range within the spar, x/c = {} to {}", short(.range[0]), short(.range[1]), short(.spar[0]), short(.spar[1]))]
    PlyRange {
        /// Its number, outermost first.
        number: usize,
        /// Its name.
        ply: String,
        /// Its chordwise range [-].
        range: [f64; 2],
        /// The chordwise range of the spar [-].
        spar: [f64; 2],
    },
    /// A mass that does not end ahead of the spar's rear or of the front web.
    #[error("the nose mass reaches back to x/c = {}, expected between 0 and {}", short(*.to), short(*.most))]
    NoseMass {
        /// Its end [-].
        to: f64,
        /// End of the space in the nose [-].
        most: f64,
    },
    /// Plies thicker than the radius of the surface.
    #[error("the plies are {} thick at x/c = {} of the {} surface, where its radius is {}: their inner face would fold", short(*.thickness), short(*.part), .surface, short(*.radius))]
    Tight {
        /// The part that they belong to.
        about: BladePart,
        /// `upper` or `lower`.
        surface: &'static str,
        /// Chordwise position [-].
        part: f64,
        /// Their thickness there [unit of the mesh].
        thickness: f64,
        /// Radius of the surface [unit of the mesh].
        radius: f64,
    },
    /// Plies of both surfaces that intersect.
    #[error("the plies of both surfaces intersect at x/c = {}: {} thick together, in a section {} thick there", short(*.part), short(*.thickness), short(*.space))]
    Collision {
        /// The part that they belong to.
        about: BladePart,
        /// Chordwise position [-].
        part: f64,
        /// Thickness of the plies of both surfaces [unit of the mesh].
        thickness: f64,
        /// Thickness of the airfoil [unit of the mesh].
        space: f64,
        /// The chordwise position ahead of which they fit [-].
        ahead: Option<f64>,
    },
    /// A skin that cannot be closed at the trailing edge.
    #[error("the skin, {} thick, cannot be closed at a trailing edge {} thick", short(*.thickness), short(*.edge))]
    EdgeThick {
        /// Thickness of the skin [unit of the mesh].
        thickness: f64,
        /// Thickness of the trailing edge [unit of the mesh].
        edge: f64,
        /// The chordwise position ahead of which there is enough space [-].
        ahead: Option<f64>,
    },
    /// A contour, or plies of a spar, that a layup cannot have.
    #[error("{0}")]
    Layup(LayupProblem),
    /// Too many cells.
    #[error("cells of this size are {found} in all, expected at most {MOST_CELLS}")]
    TooManyCells {
        /// Their number.
        found: usize,
    },
    /// Cells that fold.
    #[error("{count} cells fold, the worst one at x/c = {}, ({}, {})", short(*.part), short(.position[0]), short(.position[1]))]
    Folded {
        /// Their number.
        count: usize,
        /// Chordwise position of the worst one [-].
        part: f64,
        /// Its center [unit of the mesh].
        position: [f64; 2],
        /// A size of cells with which no cell folds [unit of the mesh].
        unfolded: Option<f64>,
    },
}

fn web_name(web: BladePart) -> &'static str {
    match web {
        BladePart::FrontWeb => "front web",
        _ => "rear web",
    }
}

impl BladeProblem {
    /// The part of the input with the problem.
    pub fn about(&self) -> BladePart {
        match self {
            Self::WebOutside { web, .. }
            | Self::WebLoose { web, .. }
            | Self::WebThick { web, .. } => *web,
            Self::WebOrder { .. } => BladePart::FrontWeb,
            Self::PlyRange { number, .. } => BladePart::Ply(*number),
            Self::NoseMass { .. } => BladePart::NoseMass,
            Self::Tight { about, .. } | Self::Collision { about, .. } => *about,
            Self::EdgeThick { .. } => BladePart::Skin,
            Self::Layup(problem) if !matches!(problem, LayupProblem::Contour { .. }) => {
                BladePart::Spar
            }
            Self::TooManyCells { .. } | Self::Folded { .. } => BladePart::Mesh,
            _ => BladePart::Airfoil,
        }
    }
}

impl Explain for BladeProblem {
    fn help(&self) -> Option<String> {
        let help = match self {
            Self::Range { .. } => "coordinates are fractions of the chord: divide them by it",
            Self::Order { .. } => {
                "list the points from the trailing edge over the upper surface to the nose and \
                 back over the lower one; in a file with both surfaces from the nose on, reverse \
                 the upper surface"
            }
            Self::Doubled { .. } => "remove one of the two",
            Self::LowerFirst => "reverse the list, so that the upper surface comes first",
            Self::WebLoose { .. } => {
                "let a ply of the web continue along the surface, all of it or a part: a flange \
                 on = [\"upper\", \"lower\", \"rear_web\"] with \"from\"; or give a ply a \
                 \"filler\""
            }
            Self::WebThick { .. } => "thinner plies in the web, or a longer spar",
            Self::Tight { about, radius, .. } => return Some(rounder(*about, *radius)),
            Self::Collision {
                ahead: Some(ahead), ..
            }
            | Self::EdgeThick {
                ahead: Some(ahead), ..
            } => return Some(space_ahead(*ahead)),
            Self::Collision { space, .. } => {
                return Some(format!(
                    "the plies of both surfaces together less than {} thick, by \"thickness\" or \
                     \"count\"; or plies that end ahead of it, by \"to\"",
                    below(*space)
                ));
            }
            Self::EdgeThick { .. } => "closure = \"open\" gives a skin without a wall there",
            Self::Layup(problem) => return problem.help(),
            Self::TooManyCells { .. } => "larger cells: [mesh] size",
            Self::Folded {
                unfolded: Some(size),
                ..
            } => return Some(format!("no cell folds with [mesh] size = {}", short(*size))),
            Self::Folded { .. } => {
                "thinner plies at the corner there; sizes of cells from a quarter of [mesh] size to \
                 16 times this size fold too"
            }
            _ => return None,
        };
        Some(help.into())
    }
}

/// Remedies for plies that are thicker than the radius of the surface.
fn rounder(about: BladePart, radius: f64) -> String {
    let thin = format!(
        "less than {} thick together, by \"thickness\" or \"count\"",
        below(radius)
    );
    match about {
        BladePart::Skin => format!(
            "plies of [skin] {thin}; no [skin], but [core.aft] up to the contour, as in a solid \
             section; or an airfoil with a rounder nose"
        ),
        _ => format!(
            "plies of [spar] that end behind the nose, as with from = 0.05 and without \"filler\"; \
             or all plies there {thin}"
        ),
    }
}

/// A length rounded down to three digits.
fn below(length: f64) -> String {
    let unit = 10f64.powf(length.log10().floor() - 2.0);
    short((length / unit).floor() * unit)
}

fn space_ahead(part: f64) -> String {
    // rounded, with a margin
    let part = (part * 1000.0).floor() / 1000.0;
    format!(
        "there is enough space ahead of x/c = {part}: [airfoil] end = {part} cuts the blade off there"
    )
}
