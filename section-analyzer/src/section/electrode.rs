//! Electrodes: parts with one voltage, and their location.

use nalgebra::Vector3;

/// An electrode of the section.
#[derive(Debug, Clone, PartialEq)]
pub struct Electrode {
    /// Name, different from all others.
    pub name: String,
    /// Its location.
    pub shape: ElectrodeShape,
    /// Its connection.
    pub circuit: Circuit,
}

/// Location of an electrode.
#[derive(Debug, Clone, PartialEq)]
pub enum ElectrodeShape {
    /// A conductor: all its nodes have its voltage.
    Conductor {
        /// Indices into the nodes of the mesh.
        nodes: Vec<u32>,
    },
    /// Fingers across the beam, of alternate sign: its voltage gives a field inside of
    /// cells.
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

/// Connection of an electrode.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Circuit {
    /// A prescribed voltage, which the beam may drive.
    Driven,
    /// Zero voltage.
    Ground,
    /// None: its charge per length stays zero.
    Floating,
}
