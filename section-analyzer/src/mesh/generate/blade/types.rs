//! Sections of blades as requested.

use std::f64::consts::PI;

use shared_geom::mesh::CellKind;

use super::contour::Contour;

/// A section of a blade.
#[derive(Debug, Clone)]
pub struct Blade {
    /// The outer surface.
    pub contour: Contour,
    /// Plies of the skin, from the outside in.
    pub skin: Vec<Ply>,
    /// Whether the skin is closed at the trailing edge: a blunt one by a wall of its
    /// plies, a sharp one by plies that meet on the line between both surfaces.
    pub is_closed: bool,
    /// The spar, if there is one.
    pub spar: Option<Spar>,
    /// The fillings of the section.
    pub cores: Cores,
    /// Sizes of cells.
    pub sizes: Sizes,
}

/// A layer of one material.
#[derive(Debug, Clone, PartialEq)]
pub struct Ply {
    /// The physical surface of its cells.
    pub name: String,
    /// Thickness [unit of the mesh].
    pub thickness: f64,
    /// Cells through the thickness.
    pub cells: usize,
    /// Whether its faces become physical curves, `NAME/outer` and `NAME/inner`.
    pub has_faces: bool,
}

/// A ply of the spar, and its position.
#[derive(Debug, Clone, PartialEq)]
pub struct SparPly {
    /// The ply.
    pub ply: Ply,
    /// Chordwise range on the upper surface; infinite if it continues into a web or
    /// around the nose [-].
    pub upper: Option<[f64; 2]>,
    /// The same on the lower surface [-].
    pub lower: Option<[f64; 2]>,
    /// Whether it is in the front and in the rear web.
    pub webs: [bool; 2],
    /// The physical surface of a filler of the same thickness that replaces it elsewhere;
    /// without it the plies inside move outward, and it ends in a wedge one cell long.
    pub filler: Option<String>,
}

/// Plies inside of the skin with one web or two.
#[derive(Debug, Clone, PartialEq)]
pub struct Spar {
    /// Part of the chord of the outer face of the front web [-]; without it the spar goes
    /// around the nose.
    pub front_web: Option<f64>,
    /// Part of the chord of the outer face of the rear web [-].
    pub rear_web: f64,
    /// From the outside in.
    pub plies: Vec<SparPly>,
}

/// The physical surfaces of the fillings of a section.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Cores {
    /// Ahead of the front web.
    pub nose: Option<String>,
    /// In the spar.
    pub spar: Option<String>,
    /// Behind the rear web; the whole section if there is no spar.
    pub aft: Option<String>,
    /// From the nose to a part of the chord [-], instead of the core there.
    pub nose_mass: Option<(f64, String)>,
}

/// Sizes of cells.
#[derive(Debug, Clone, PartialEq)]
pub struct Sizes {
    /// Largest length along walls [unit of the mesh].
    pub size: f64,
    /// Length of the cells of cores across the section [unit of the mesh].
    pub core: f64,
    /// Largest turn of the surface along one cell \[rad\].
    pub turn: f64,
    /// Kind of the quadrilaterals; triangles are of the same order.
    pub kind: CellKind,
}

impl Sizes {
    /// Sizes with this length of cells, with 9 nodes, and at most 12 degrees of turn.
    pub fn new(size: f64) -> Self {
        Self {
            size,
            core: size,
            turn: PI / 15.0,
            kind: CellKind::Quadrilateral9,
        }
    }
}
