//! Problems of layups to be meshed.

use shared_geom::error::Explain;

use super::super::super::short;

/// Thickness of layers, in lengths that the section leaves, from which one of both is likely in another unit.
const FAR: f64 = 20.0;
/// Remedy of shells with holes.
const CLOSED: &str = "let the second layer begin where the first one ends, or let a layer run over both ends: \
     shells of layups are closed";
/// The remedy.
const OTHER_UNIT: &str = "check the units of the thickness and of the chord: a thickness in another unit than the \
                          one of the file has its unit, as \"8 mm\"; or let thick layers end before it";

/// A part between both sides.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Upright {
    /// The web of this name.
    Web(String),
    /// A bound of the fill of this name.
    Bound(String),
}

impl Upright {
    /// The name of the web or fill.
    pub fn name(&self) -> &str {
        match self {
            Self::Web(name) | Self::Bound(name) => name,
        }
    }
}

impl std::fmt::Display for Upright {
    fn fmt(&self, to: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Web(name) => write!(to, "web \"{name}\""),
            Self::Bound(name) => write!(to, "the bound of fill \"{name}\""),
        }
    }
}

/// Arcs of the shell without a layer.
#[derive(Debug, Clone, PartialEq)]
pub struct Hole {
    /// The layers before and behind it.
    pub layers: [String; 2],
    /// Its arcs [-].
    pub arcs: [f64; 2],
}

impl std::fmt::Display for Hole {
    fn fmt(&self, to: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let [from, end] = self.arcs.map(short);
        let [before, behind] = &self.layers;
        write!(
            to,
            "from arc {from} to arc {end}, between layers \"{before}\" and \"{behind}\""
        )
    }
}

/// Texts of holes in a sentence.
fn list(holes: &[Hole]) -> String {
    let texts: Vec<String> = holes.iter().map(ToString::to_string).collect();
    texts.join(", and ")
}

/// A layup that cannot be meshed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum LayupProblem {
    /// Nothing to mesh.
    #[error("the section has no layers, expected one or more")]
    NoLayers,
    /// One name for two layers.
    #[error("two layers are called \"{layer}\", expected a name of its own for each")]
    NameTwice {
        /// The name.
        layer: String,
    },
    /// A thickness that is no length.
    #[error("the thickness of layer \"{layer}\" is {}, expected a positive length", short(*.thickness))]
    Thickness {
        /// The layer.
        layer: String,
        /// Its thickness.
        thickness: f64,
    },
    /// A size of cells that is no length.
    #[error("the size of cells is {}, expected more than {}, a ten-thousandth of the contour", short(*.size), short(*.least))]
    Size {
        /// The size [unit of the mesh].
        size: f64,
        /// The least size [unit of the mesh].
        least: f64,
    },
    /// Arcs that are not in order.
    #[error("layer \"{layer}\" starts at arc {} and ends at {}, expected 0 <= start < end <= 1", short(.arcs[0]), short(.arcs[1]))]
    Arcs {
        /// The layer.
        layer: String,
        /// Its arcs [-].
        arcs: [f64; 2],
    },
    /// Arcs of a web that are not in order.
    #[error("{web} stands at arc {} and {}, expected 0 < suction side < pressure side < 1", short(.arcs[0]), short(.arcs[1]))]
    WebArcs {
        /// The web, or the bound of a fill.
        web: Upright,
        /// Its arcs [-].
        arcs: [f64; 2],
    },
    /// Two webs at the trailing edge.
    #[error("webs \"{}\" and \"{}\" are both at the trailing edge", .webs[0], .webs[1])]
    TwoAtEdge {
        /// The webs.
        webs: [String; 2],
    },
    /// A web at a trailing edge whose base is too short for it.
    #[error("web \"{web}\" at the trailing edge stands on a flat base of {}, of which the layers of both sides take {}", short(*.base), short(*.taken))]
    NoRoomAtEdge {
        /// The web.
        web: String,
        /// Length of the base [unit of the mesh].
        base: f64,
        /// Length that the layers of both sides take of it [unit of the mesh].
        taken: f64,
    },
    /// Layers of both sides that meet before a web at the trailing edge.
    #[error("the layers of both sides meet from arc {} to {}, ahead of web \"{web}\" at the trailing edge, which stands between them", short(.contact[0]), short(.contact[1]))]
    ContactAtEdge {
        /// The web.
        web: String,
        /// Arcs of the contact on the suction side [-].
        contact: [f64; 2],
    },
    /// Points that are no contour.
    #[error("the contour {why}")]
    Contour {
        /// The problem.
        why: String,
    },
    /// No layer at the trailing edge.
    #[error("no layer reaches the trailing edge: nothing joins the two sides there")]
    Open,
    /// Arcs without a layer.
    #[error("no layer lies {}: nothing joins them there", list(.holes))]
    Holes {
        /// The holes.
        holes: Vec<Hole>,
    },
    /// Layers thicker than the radius of the largest inscribed circle.
    #[error("the layers are {} thick at arc {}, where the section leaves {}: layer \"{layer}\" does not fit; the thickest one there is \"{}\" with {}", short(*.thickness), short(*.arc), short(*.radius), .thickest.0, short(.thickest.1))]
    Tight {
        /// The innermost layer.
        layer: String,
        /// The arc [-].
        arc: f64,
        /// Thickness of all layers [unit of the mesh].
        thickness: f64,
        /// Radius of the inscribed circle [unit of the mesh].
        radius: f64,
        /// The thickest layer there, and its thickness [unit of the mesh].
        thickest: (String, f64),
    },
    /// Layers of both sides that meet ahead.
    #[error("the layers of both sides take {} of the {} between arc {} and arc {}: layer \"{layer}\" does not fit; the thickest one there is \"{}\" with {}", short(*.taken), short(*.length), short(.arcs[0]), short(.arcs[1]), .thickest.0, short(.thickest.1))]
    Meeting {
        /// The innermost layer of the side with the thicker layers.
        layer: String,
        /// The arcs of the points on both sides [-].
        arcs: [f64; 2],
        /// Length of the line between both that the layers take [unit of the mesh].
        taken: f64,
        /// Length of the line [unit of the mesh].
        length: f64,
        /// The thickest layer of this side there, and its thickness [unit of the mesh].
        thickest: (String, f64),
    },
    /// Layers with too little space that are cut where both sides meet, whose cells fail.
    #[error("{space}; without the part that has no space, {cells}")]
    Crowded {
        /// The layers and the space.
        space: Box<LayupProblem>,
        /// The problem of the cells.
        cells: Box<LayupProblem>,
    },
    /// A web that leaves the contour.
    #[error("{web} does not meet the inner face of the {side} side near arc {}", short(*.arc))]
    WebOutside {
        /// The web, or the bound of a fill.
        web: Upright,
        /// The side.
        side: &'static str,
        /// Its arc [-].
        arc: f64,
    },
    /// A web where the plies of both sides meet.
    #[error("{web} stands at arc {} of the {side} side, where the layers of both sides meet (from arc {} to {}); the thickest one there is \"{}\" with {}", short(*.arc), short(.contact[0]), short(.contact[1]), .thickest.0, short(.thickest.1))]
    WebInContact {
        /// The web, or the bound of a fill.
        web: Upright,
        /// The side.
        side: &'static str,
        /// Arc of its foot [-].
        arc: f64,
        /// Arcs between which the layers meet [-].
        contact: [f64; 2],
        /// The thickest layer at its foot, and its thickness [unit of the mesh].
        thickest: (String, f64),
    },
    /// A web whose feet are on one side.
    #[error("the place of {web} on the {side} side is arc {}, which is on the other side: the nose is at arc {}", short(*.arc), short(*.nose))]
    OneSide {
        /// The web, or the bound of a fill.
        web: Upright,
        /// The side of its place.
        side: &'static str,
        /// The arc of the place [-].
        arc: f64,
        /// The arc of the nose [-].
        nose: f64,
    },
    /// Two webs whose feet overlap.
    #[error("the feet of {} and {} overlap on the {side} side by {}", .webs[0], .webs[1], short(*.overlap))]
    WebsOverlap {
        /// The webs, or bounds of fills.
        webs: [Upright; 2],
        /// The side.
        side: &'static str,
        /// Length of the overlap [unit of the mesh].
        overlap: f64,
    },
    /// Two webs that cross.
    #[error("{} and {} cross: they are in another order on the pressure side", .webs[0], .webs[1])]
    WebsCross {
        /// The webs, or bounds of fills.
        webs: [Upright; 2],
    },
    /// A layer inside of a spar that goes behind its web.
    #[error("layer \"{layer}\" is inside of the spar with web \"{web}\", and goes behind the web")]
    BehindSpar {
        /// The layer.
        layer: String,
        /// The web.
        web: String,
    },
    /// A layer behind the web of a spar that reaches it.
    #[error("layer \"{layer}\" behind the spar with web \"{web}\" reaches the web")]
    AtSpar {
        /// The layer.
        layer: String,
        /// The web.
        web: String,
    },
    /// Layers of a spar that do not continue along its web.
    #[error(
        "the layers along web \"{web}\" are {expected} thick, those inside of the spar at its {side} end {found}, expected the same"
    )]
    SparPlies {
        /// The web.
        web: String,
        /// The side.
        side: &'static str,
        /// Thicknesses at its end [unit of the mesh].
        found: String,
        /// Thicknesses along it [unit of the mesh].
        expected: String,
    },
    /// A fill whose bound is a web that does not stand.
    #[error("fill \"{fill}\" is bounded by web \"{web}\", which has no plies here")]
    FillBound {
        /// The fill.
        fill: String,
        /// The web.
        web: String,
    },
    /// A fill without a space.
    #[error("there is no space for fill \"{fill}\" between shell and webs")]
    NoSpace {
        /// The fill.
        fill: String,
    },
    /// A space that cannot be divided into triangles.
    #[error("the sides of a space of fill \"{fill}\" touch each other; a node of it is at ({}, {})", short(.position[0]), short(.position[1]))]
    SpaceShape {
        /// The fill.
        fill: String,
        /// A node of the space [unit of the mesh].
        position: [f64; 2],
    },
    /// Cells that fold.
    #[error("{count} cells fold, the worst one in layer \"{layer}\" at ({}, {})", short(.position[0]), short(.position[1]))]
    Folded {
        /// The layer of the worst one.
        layer: String,
        /// Their number.
        count: usize,
        /// Center of the worst one [unit of the mesh].
        position: [f64; 2],
    },
    /// Cells with more area than the layers.
    #[error("the cells of layer \"{layer}\" have {} times its area", short(*.part))]
    Area {
        /// The layer.
        layer: String,
        /// Area of the cells in areas of the layer [-].
        part: f64,
    },
    /// Too many cells.
    #[error("cells of this size are {found} in all, expected at most {most}")]
    TooManyCells {
        /// Their number.
        found: usize,
        /// The largest number.
        most: usize,
    },
    /// A mesh that the checks of meshes refuse.
    #[error("{} cannot be meshed soundly: {text}", .layer.as_ref().map_or("the layers".into(), |layer| format!("layer \"{layer}\"")))]
    Unsound {
        /// The layer at the first problem, if that has a position.
        layer: Option<String>,
        /// The problems of the mesh, which name the layers.
        text: String,
    },
}

impl LayupProblem {
    /// The layer or web with the problem.
    pub fn about(&self) -> Option<&str> {
        match self {
            Self::NameTwice { layer }
            | Self::Thickness { layer, .. }
            | Self::Arcs { layer, .. }
            | Self::Tight { layer, .. }
            | Self::Meeting { layer, .. }
            | Self::Folded { layer, .. }
            | Self::Area { layer, .. }
            | Self::BehindSpar { layer, .. }
            | Self::AtSpar { layer, .. } => Some(layer),
            Self::Unsound { layer, .. } => layer.as_deref(),
            Self::Crowded { space, .. } => space.about(),
            Self::SparPlies { web, .. }
            | Self::NoRoomAtEdge { web, .. }
            | Self::ContactAtEdge { web, .. } => Some(web),
            Self::Holes { holes } => holes.first().map(|hole| hole.layers[0].as_str()),
            Self::TwoAtEdge { webs } => Some(&webs[1]),
            Self::WebArcs { web, .. }
            | Self::WebOutside { web, .. }
            | Self::OneSide { web, .. }
            | Self::WebInContact { web, .. } => Some(web.name()),
            Self::WebsOverlap { webs, .. } | Self::WebsCross { webs } => Some(webs[0].name()),
            Self::NoSpace { fill }
            | Self::SpaceShape { fill, .. }
            | Self::FillBound { fill, .. } => Some(fill),
            _ => None,
        }
    }

    /// Whether its text has lengths, in the unit of the mesh.
    pub fn has_lengths(&self) -> bool {
        matches!(
            self,
            Self::Thickness { .. }
                | Self::Size { .. }
                | Self::NoRoomAtEdge { .. }
                | Self::Tight { .. }
                | Self::Meeting { .. }
                | Self::Crowded { .. }
                | Self::WebInContact { .. }
                | Self::WebsOverlap { .. }
                | Self::SparPlies { .. }
                | Self::SpaceShape { .. }
                | Self::Folded { .. }
        )
    }

    /// The position of its cells, if it has one [unit of the mesh].
    pub(super) fn position(&self) -> Option<[f64; 2]> {
        match self {
            Self::Folded { position, .. } | Self::SpaceShape { position, .. } => Some(*position),
            _ => None,
        }
    }

    /// Whether other cells may solve the problem.
    pub(super) fn is_of_cells(&self) -> bool {
        matches!(
            self,
            Self::Folded { .. } | Self::Unsound { .. } | Self::SpaceShape { .. }
        )
    }
}

impl Explain for LayupProblem {
    fn help(&self) -> Option<String> {
        let help = match self {
            Self::Arcs { .. } => {
                "arcs grow from the trailing edge over the suction side, the nose and the pressure \
                 side; a layer through the trailing edge is two layers"
            }
            Self::WebArcs { .. } => {
                "the first arc is on the suction side, the second on the pressure side"
            }
            Self::TwoAtEdge { .. } => "put the plies of both in one web",
            Self::NoRoomAtEdge { .. } | Self::ContactAtEdge { .. } => {
                "thinner layers there, a contour that is cut off where it is thicker, or no web at the \
                 trailing edge: the layers are then closed as its base allows"
            }
            Self::Open => "let a layer run all around, from arc 0 to 1",
            Self::Tight {
                thickness, radius, ..
            } if *thickness > FAR * radius => OTHER_UNIT,
            Self::Holes { .. } => CLOSED,
            Self::Tight { .. } | Self::Meeting { .. } | Self::Crowded { .. } => {
                "thinner layers there, or layers that end before it"
            }
            Self::Size { .. } => {
                "check the unit of \"size\"; without it 120 cells are around the contour"
            }
            Self::WebOutside { .. } => "move the web, or leave it out",
            Self::WebInContact { .. } => {
                "move the web out of these arcs, or use thinner layers there"
            }
            Self::OneSide { .. } => {
                "a web stands between both sides: arcs of the suction side are below the one of the nose, \
                 arcs of the pressure side above it"
            }
            Self::WebsOverlap { .. } | Self::WebsCross { .. } => {
                "move one of them, or leave it out"
            }
            Self::Folded { .. } | Self::Unsound { .. } => {
                "a longer \"taper\" of the layers that end there, thinner layers, or other cells (size)"
            }
            Self::Area { .. } => {
                "begin the contour at a corner of its rear, give its corners twice, or use thinner layers"
            }
            Self::BehindSpar { .. } => {
                "list it before the layers of the spar, or end it at the web"
            }
            Self::AtSpar { .. } => "end it before the web, by half the length of its drop or more",
            Self::SparPlies { .. } => {
                "a layer inside of the spar that is not along the web needs one of its thickness along \
                 the web, which may be elsewhere on the surfaces"
            }
            Self::NoSpace { .. } => {
                "fills before it may have taken it, its bounds may be in the wrong order, or the layers \
                 of both sides meet there"
            }
            Self::SpaceShape { .. } => "thinner layers, or other cells (size)",
            Self::TooManyCells { .. } => "larger cells",
            _ => return None,
        };
        Some(help.into())
    }
}
