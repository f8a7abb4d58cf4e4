//! A resolved section of a layup, and its mesh.

use shared_geom::mesh::Mesh;

use super::problem::{LayupProblem, Upright};

/// Names of the sides.
pub(super) const SIDES: [&str; 2] = ["suction", "pressure"];
/// Largest number of cells of a section.
pub(super) const MOST_CELLS: usize = 200_000;

/// A section given by its layup. Lengths are in one unit, the unit of the mesh.
///
/// Arcs are fractions of the length of the contour: 0 in the middle of the
/// trailing-edge base, growing over the suction side, about 0.5 at the nose, 1 again in
/// the middle of the base.
#[derive(Debug, Clone, PartialEq)]
pub struct LayupSection {
    /// Points (y, z) of the contour, y toward the nose, z toward the suction side: from the
    /// trailing edge over the suction side to the nose and back over the pressure side. An
    /// open end is a flat base [unit of the mesh].
    pub contour: Vec<[f64; 2]>,
    /// Layers of the shell, from the outside in.
    pub layers: Vec<Layer>,
    /// Webs.
    pub webs: Vec<Web>,
    /// The spar that turns into a web, if there is one.
    pub spar: Option<Spar>,
    /// Fills of the spaces between shell and webs.
    pub fills: Vec<Fill>,
    /// Largest length of cells along the contour; 1/120 of its length without it
    /// [unit of the mesh].
    pub size: Option<f64>,
}

/// A layer of the shell.
#[derive(Debug, Clone, PartialEq)]
pub struct Layer {
    /// Its name, and the physical surface of its cells.
    pub name: String,
    /// Thickness, normal to the surface [unit of the mesh].
    pub thickness: f64,
    /// Arc at which it starts [-].
    pub from: f64,
    /// Arc at which it ends [-].
    pub to: f64,
    /// Length over which its thickness drops to zero at its ends; about the thickness
    /// without it [unit of the mesh].
    pub taper: Option<f64>,
    /// Parts of its thickness over parts of its width, from 0 to 1 in ascending order, straight lines
    /// between them; the whole thickness without them [-].
    pub profile: Vec<[f64; 2]>,
}

/// A web, a stack of plies between two points of the contour.
#[derive(Debug, Clone, PartialEq)]
pub struct Web {
    /// Its name.
    pub name: String,
    /// Arcs of its middle line on the suction and the pressure side; 0 and 1 for the web at the
    /// trailing edge, which lies behind the base and on which both sides end [-].
    pub arcs: [f64; 2],
    /// Its plies, from the leading edge aft.
    pub plies: Vec<WebPly>,
}

impl Web {
    /// Whether it is at the trailing edge.
    pub(super) fn is_at_edge(&self) -> bool {
        self.arcs[0] <= 0.0 && self.arcs[1] >= 1.0
    }
}

impl LayupSection {
    /// The webs at the trailing edge that have plies; a section can have one.
    pub(super) fn at_edge(&self) -> impl Iterator<Item = &Web> {
        let webs = self.webs.iter().filter(|web| web.is_at_edge());
        webs.filter(|web| !web.plies.is_empty())
    }
}

/// A ply of a web.
#[derive(Debug, Clone, PartialEq)]
pub struct WebPly {
    /// Its name, and the physical surface of its cells.
    pub name: String,
    /// Thickness [unit of the mesh].
    pub thickness: f64,
}

/// Arcs that differ by less are equal.
pub(super) const SAME_ARC: f64 = 1e-9;

/// A spar: layers of the shell that turn into webs, mitred at their corners. The layers after its
/// first one are inside of it, or beyond its webs.
#[derive(Debug, Clone, PartialEq)]
pub struct Spar {
    /// Number of its first layer.
    pub first: usize,
    /// Its aft web; and its fore web, without which it goes around the nose.
    pub webs: Vec<SparWeb>,
}

/// A web of a spar.
#[derive(Debug, Clone, PartialEq)]
pub struct SparWeb {
    /// Its name.
    pub name: String,
    /// Arcs of its outer face on the suction and the pressure side [-].
    pub arcs: [f64; 2],
    /// Numbers of the layers along it, from the outside in.
    pub layers: Vec<usize>,
    /// Numbers of the layers inside of the spar that continue each of them on the suction and the
    /// pressure side, those that none continues end there; without it all continue in their order.
    pub feet: Option<[Vec<Option<usize>>; 2]>,
}

impl Spar {
    /// A spar around the nose with one web, along which these layers continue.
    pub fn around_nose(name: String, arcs: [f64; 2], layers: Vec<usize>) -> Self {
        let web = SparWeb {
            name,
            arcs,
            layers,
            feet: None,
        };
        Self {
            first: web.layers.first().copied().unwrap_or(0),
            webs: vec![web],
        }
    }

    /// Whether a layer is inside of it, at least in part.
    pub(super) fn has(&self, number: usize, layer: &Layer) -> bool {
        let ranges: Vec<[f64; 2]> = self.webs.iter().map(|web| web.arcs).collect();
        let is_ahead = ranges.first().is_none_or(|[suction, pressure]| {
            layer.to > suction + SAME_ARC && layer.from < pressure - SAME_ARC
        });
        let is_aft = ranges.get(1).is_none_or(|[suction, pressure]| {
            layer.from < suction - SAME_ARC || layer.to > pressure + SAME_ARC
        });
        number >= self.first && is_ahead && is_aft
    }

    /// Whether an end of a layer is at one of its webs.
    pub(super) fn ends_at(&self, arc: f64) -> bool {
        let arcs = self.webs.iter().flat_map(|web| web.arcs);
        arcs.into_iter()
            .any(|of_web| (of_web - arc).abs() < SAME_ARC)
    }
}

/// A material that fills the spaces between shell and webs, those that the fills before it leave.
#[derive(Debug, Clone, PartialEq)]
pub struct Fill {
    /// Its name, and the physical surface of its cells.
    pub name: String,
    /// The web or line behind it; without it it goes to the trailing edge.
    pub ahead_of: Option<Bound>,
    /// The web or line ahead of it; without it it goes to the nose.
    pub aft_of: Option<Bound>,
}

/// A bound of a fill.
#[derive(Debug, Clone, PartialEq)]
pub enum Bound {
    /// The web of this name.
    Web(String),
    /// The line between two arcs, on the suction and the pressure side [-].
    Line([f64; 2]),
}

/// The mesh of a section.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshedLayup {
    /// The mesh.
    pub mesh: Mesh,
    /// Areas of the layers, in the order of the section.
    pub areas: Vec<LayerArea>,
}

/// Area of a layer [unit of the mesh^2].
#[derive(Debug, Clone, PartialEq)]
pub struct LayerArea {
    /// Name of the layer.
    pub name: String,
    /// Area of the layer on the curved surface, `int t (1 - k (d + t/2)) ds`, with k the
    /// curvature and d the depth of its outer face [unit of the mesh^2].
    pub nominal: f64,
    /// Area of its cells [unit of the mesh^2].
    pub meshed: f64,
    /// The part of its area that is cut where the layers of both sides meet
    /// [unit of the mesh^2].
    pub cut: f64,
    /// The area that it has in addition where it fills the space between both sides, as the innermost
    /// layer [unit of the mesh^2].
    pub filled: f64,
}

/// Checks names, numbers and arcs.
pub(super) fn check(section: &LayupSection) -> Result<(), LayupProblem> {
    let mut names: Vec<&str> = Vec::new();
    let plies = section.webs.iter().flat_map(|web| &web.plies);
    let thick = section
        .layers
        .iter()
        .map(|layer| (&layer.name, layer.thickness));
    let thick = thick.chain(plies.map(|ply| (&ply.name, ply.thickness)));
    for (name, thickness) in thick {
        if names.contains(&name.as_str()) {
            return Err(LayupProblem::NameTwice {
                layer: name.clone(),
            });
        }
        names.push(name);
        if !(thickness > 0.0 && thickness.is_finite()) {
            let layer = name.clone();
            return Err(LayupProblem::Thickness { layer, thickness });
        }
    }
    for fill in &section.fills {
        let name = fill.name.as_str();
        if names.contains(&name) {
            let layer = name.to_owned();
            return Err(LayupProblem::NameTwice { layer });
        }
        names.push(name);
        check_bounds(section, fill)?;
    }
    if section.layers.is_empty() {
        return Err(LayupProblem::NoLayers);
    }
    for layer in &section.layers {
        let is_in = |arc: f64| (0.0..=1.0).contains(&arc);
        if !(is_in(layer.from) && is_in(layer.to) && layer.to - layer.from > 1e-4) {
            return Err(LayupProblem::Arcs {
                layer: layer.name.clone(),
                arcs: [layer.from, layer.to],
            });
        }
    }
    if let Some(spar) = &section.spar {
        check_spar(section, spar)?;
    }
    let mut at_edge = section.at_edge().map(|web| web.name.clone());
    if let (Some(first), Some(second)) = (at_edge.next(), at_edge.next()) {
        let webs = [first, second];
        return Err(LayupProblem::TwoAtEdge { webs });
    }
    for web in section.webs.iter().filter(|web| !web.is_at_edge()) {
        let [suction, pressure] = web.arcs;
        if !(suction > 0.0 && pressure < 1.0 && suction < pressure) {
            return Err(LayupProblem::WebArcs {
                web: Upright::Web(web.name.clone()),
                arcs: web.arcs,
            });
        }
    }
    Ok(())
}

/// Checks that the layers of a spar exist, and that those inside of it end at its webs.
fn check_spar(section: &LayupSection, spar: &Spar) -> Result<(), LayupProblem> {
    for web in &spar.webs {
        let count = section.layers.len();
        let are_there = web.layers.iter().all(|layer| *layer < count);
        let [suction, pressure] = web.arcs;
        let is_in_order = suction > 0.0 && pressure < 1.0 && suction < pressure;
        if web.layers.is_empty() || !are_there || !is_in_order {
            return Err(LayupProblem::WebArcs {
                web: Upright::Web(web.name.clone()),
                arcs: web.arcs,
            });
        }
    }
    for (number, layer) in section.layers.iter().enumerate() {
        let is_beyond = |(number, web): &(usize, &SparWeb)| {
            let [suction, pressure] = web.arcs;
            match number {
                0 => layer.from < suction - SAME_ARC || layer.to > pressure + SAME_ARC,
                _ => layer.to > suction + SAME_ARC && layer.from < pressure - SAME_ARC,
            }
        };
        let mut webs = spar.webs.iter().enumerate();
        let passed = webs.find(|web| spar.has(number, layer) && is_beyond(web));
        if let Some((_, web)) = passed {
            return Err(LayupProblem::BehindSpar {
                layer: layer.name.clone(),
                web: web.name.clone(),
            });
        }
    }
    Ok(())
}

/// Checks that the webs of the bounds of a fill stand, and that its lines go from side to side.
fn check_bounds(section: &LayupSection, fill: &Fill) -> Result<(), LayupProblem> {
    let is_behind = |bound: &Bound| {
        let mut webs = section.at_edge();
        matches!(bound, Bound::Web(name) if webs.any(|web| web.name == *name))
    };
    if fill.aft_of.as_ref().is_some_and(is_behind) {
        let fill = fill.name.clone();
        return Err(LayupProblem::NoSpace { fill });
    }
    for bound in [&fill.ahead_of, &fill.aft_of].into_iter().flatten() {
        match bound {
            Bound::Web(name) => {
                let is_it = |web: &Web| web.name == *name && !web.plies.is_empty();
                let mut spars = section.spar.iter().flat_map(|spar| &spar.webs);
                let is_spar = spars.any(|web| web.name == *name);
                if !is_spar && !section.webs.iter().any(is_it) {
                    return Err(LayupProblem::FillBound {
                        fill: fill.name.clone(),
                        web: name.clone(),
                    });
                }
            }
            Bound::Line([suction, pressure]) => {
                if !(*suction > 0.0 && *pressure < 1.0 && suction < pressure) {
                    return Err(LayupProblem::WebArcs {
                        web: Upright::Bound(fill.name.clone()),
                        arcs: [*suction, *pressure],
                    });
                }
            }
        }
    }
    Ok(())
}
