//! Contacts of cells that do not fit: overlaps, doubled nodes along seams, hanging nodes,
//! narrow gaps.
//!
//! Positions and lengths are in the unit of the mesh file.

use std::fmt;

use super::words::{coordinates, counted, short};

/// Number of pairs of nodes listed in a message.
const LISTED: usize = 3;

/// Whether cells may touch without sharing nodes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum DoubledNodes {
    /// An error between regions.
    #[default]
    Error,
    /// A slit is intended, unless it separates the section into parts.
    Allow,
}

/// Cells that overlap.
#[derive(Debug, Clone, PartialEq)]
pub struct CellOverlap {
    /// Physical surfaces of the two cells of each pair; the same twice within one
    /// surface.
    pub groups: [String; 2],
    /// Tags of the pairs of cells found along the boundary of the mesh.
    pub cells: Vec<[u64; 2]>,
    /// A position in both cells of each pair [file unit].
    pub positions: Vec<[f64; 2]>,
}

impl fmt::Display for CellOverlap {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [one, other] = &self.groups;
        if one == other {
            write!(f, "cells of \"{one}\" overlap")?
        } else {
            write!(f, "cells of \"{one}\" overlap cells of \"{other}\"")?
        }
        let pairs = self.cells.iter().zip(&self.positions).take(LISTED);
        for (i, ([a, b], at)) in pairs.enumerate() {
            let lead = if i == 0 { ":" } else { "," };
            write!(f, "{lead} {a} and {b} at {}", coordinates(*at))?;
        }
        if let Some(more) = self.cells.len().checked_sub(LISTED + 1) {
            let positions = between(&self.positions);
            write!(
                f,
                " and {} like these{positions}",
                counted(more + 1, "pair")
            )?;
        }
        f.write_str("; the area there would be counted twice")
    }
}

/// A corner of one cell on the side of another, not connected to it.
#[derive(Debug, Clone, PartialEq)]
pub struct HangingNode {
    /// Tag of the node.
    pub node: u64,
    /// Its position [file unit].
    pub position: [f64; 2],
    /// Tag of the cell whose corner it is.
    pub corner_of: u64,
    /// Tag of the cell on whose side it lies.
    pub side_of: u64,
    /// Tags of the ends of that side.
    pub side: [u64; 2],
    /// Physical surfaces of the two cells.
    pub groups: [String; 2],
}

impl fmt::Display for HangingNode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "node {} at {}, a corner of cell {} in \"{}\", lies on the side from node {} to \
             node {} of cell {} in \"{}\", which has no node there: the cells are not joined",
            self.node,
            coordinates(self.position),
            self.corner_of,
            self.groups[0],
            self.side[0],
            self.side[1],
            self.side_of,
            self.groups[1],
        )
    }
}

/// Sides of cells that coincide but share no nodes.
#[derive(Debug, Clone, PartialEq)]
pub struct Seam {
    /// Physical surfaces on its two sides; the same twice within one surface.
    pub groups: [String; 2],
    /// Number of sides along it.
    pub sides: usize,
    /// Tags of the coincident nodes.
    pub pairs: Vec<[u64; 2]>,
    /// Their positions, parallel to `pairs` [file unit].
    pub positions: Vec<[f64; 2]>,
    /// Number of parts of the section, if seams separate it.
    pub parts: Option<usize>,
}

impl fmt::Display for Seam {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.groups {
            [one, other] if one == other => write!(f, "cells of \"{one}\" touch")?,
            [one, other] => write!(f, "\"{one}\" and \"{other}\" touch")?,
        }
        write!(
            f,
            " along {}{} but share no nodes there: {} doubled",
            counted(self.sides, "side"),
            between(&self.positions),
            match self.pairs.len() {
                1 => "1 node is".to_owned(),
                count => format!("{count} nodes are"),
            },
        )?;
        for (i, ([a, b], at)) in self
            .pairs
            .iter()
            .zip(&self.positions)
            .enumerate()
            .take(LISTED)
        {
            let lead = if i == 0 { ", as" } else { "," };
            write!(f, "{lead} {a} and {b} at {}", coordinates(*at))?;
        }
        match self.parts {
            Some(parts) => write!(f, "; so the section falls into {parts} parts"),
            None => Ok(()),
        }
    }
}

/// Sides of cells that are close to each other without touching.
#[derive(Debug, Clone, PartialEq)]
pub struct NarrowGap {
    /// Physical surfaces on its two sides; the same twice within one surface.
    pub groups: [String; 2],
    /// Number of sides along it.
    pub sides: usize,
    /// Least width [file unit].
    pub narrowest: f64,
    /// Largest width that is treated as narrow [file unit].
    pub widest: f64,
    /// Positions along it, two per side [file unit].
    pub positions: Vec<[f64; 2]>,
}

impl fmt::Display for NarrowGap {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.groups {
            [one, other] if one == other => write!(f, "cells of \"{one}\" run")?,
            [one, other] => write!(f, "\"{one}\" and \"{other}\" run")?,
        }
        write!(
            f,
            " within {} of each other along {}{} without touching: they are not connected across \
             this gap",
            short(self.widest),
            counted(self.sides, "side"),
            between(&self.positions),
        )
    }
}

/// ` between (0, 0) and (1, 0)`: the box of the positions.
fn between(positions: &[[f64; 2]]) -> String {
    let [low, high] = [f64::min, f64::max].map(|pick: fn(f64, f64) -> f64| {
        [0, 1].map(|axis| {
            positions
                .iter()
                .map(|p| p[axis])
                .reduce(pick)
                .unwrap_or(0.0)
        })
    });
    format!(" between {} and {}", coordinates(low), coordinates(high))
}
