//! Electrodes: what has one voltage, and where.

use nalgebra::Vector3;

/// An electrode of the section.
#[derive(Debug, Clone, PartialEq)]
pub struct Electrode {
    /// Name, unlike those of the others.
    pub name: String,
    /// Where it is.
    pub shape: ElectrodeShape,
    /// What it is joined to.
    pub circuit: Circuit,
}

/// Where an electrode is.
#[derive(Debug, Clone, PartialEq)]
pub enum ElectrodeShape {
    /// A conductor: all its nodes have its voltage.
    Conductor {
        /// Indices into the nodes of the mesh.
        nodes: Vec<u32>,
    },
    /// Fingers across the beam, of alternate sign: its voltage is a field inside of cells.
    Interdigitated {
        /// The cells, each once.
        cells: Vec<FingeredCell>,
    },
}

/// A cell between the fingers of an interdigitated electrode.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FingeredCell {
    /// Index into the cells of the mesh.
    pub cell: u32,
    /// Electric field per volt, in material axes \[1/m\]: one over the effective spacing of
    /// the fingers, along the poled direction.
    pub field: Vector3<f64>,
}

/// What an electrode is joined to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Circuit {
    /// A voltage of its own, which the beam may drive.
    Driven,
    /// The voltage zero.
    Ground,
    /// Nothing: its charge per length stays zero.
    Floating,
}
