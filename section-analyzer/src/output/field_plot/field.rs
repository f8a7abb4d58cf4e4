//! A field: one value at each node of each cell.

use crate::section::Section;

/// Relative difference to the extreme up to which values are equally extreme: the first of them
/// is reported, independent of round-off in symmetric fields.
const SAME: f64 = 1e-6;

/// The quantity shown, which determines unit and colors.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::output) enum Quantity {
    /// A stress that may be negative [Pa].
    SignedStress,
    /// A stress that is at least zero [Pa].
    Stress,
    /// A failure index [-].
    Index,
    /// An electric potential [V].
    Potential,
    /// The size of an electric field [V/m].
    ElectricField,
}

/// A field over the cells of a section.
#[derive(Debug)]
pub(in crate::output) struct Field {
    /// Name for title and color bar.
    pub title: String,
    /// More text, for the line below the load case.
    pub note: String,
    pub quantity: Quantity,
    /// Values of each cell at its nodes, the rest zero [SI].
    pub values: Vec<[f64; 9]>,
    /// Vectors (y, z) of each cell at its nodes, drawn as arrows [SI].
    pub vectors: Option<Vec<[[f64; 2]; 9]>>,
    /// Magnitude below which values are zero [SI].
    pub negligible: f64,
}

/// The lowest or highest value and its position.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Extreme {
    pub value: f64,
    /// Position (y, z) [m].
    pub position: [f64; 2],
    /// Region: index of the physical surface.
    pub region: usize,
}

impl Field {
    /// A field of one value per cell.
    pub fn of_cells(quantity: Quantity, title: String, values: &[f64]) -> Self {
        Self {
            title,
            note: String::new(),
            quantity,
            values: values.iter().map(|value| [*value; 9]).collect(),
            vectors: None,
            negligible: 0.0,
        }
    }

    /// Lowest and highest value; cells without a number are ignored.
    pub(super) fn extremes(&self, section: &Section) -> [Extreme; 2] {
        let all = || {
            let cells = section.mesh.cells.iter().zip(&self.values).enumerate();
            cells.flat_map(|(index, (cell, values))| {
                let numbers = values[..cell.kind.node_count()].iter().enumerate();
                numbers
                    .filter(|(_, value)| value.is_finite())
                    .map(move |(local, value)| (index, local, *value))
            })
        };
        let values = || all().map(|(_, _, value)| value);
        let largest = values().fold(0.0_f64, |largest, value| largest.max(value.abs()));
        let first = |sign: f64| {
            let extreme = values().fold(f64::NEG_INFINITY, |most, value| most.max(sign * value));
            all()
                .find(|(_, _, value)| sign * value >= extreme - SAME * largest)
                .map_or_else(Extreme::none, |(cell, local, _)| {
                    let position = self.position(section, cell, local);
                    Extreme {
                        value: sign * extreme,
                        position,
                        region: section.mesh.cells[cell].group,
                    }
                })
        };
        [first(-1.0), first(1.0)]
    }

    /// The node, or the mean of the corners for a cell of one value.
    fn position(&self, section: &Section, cell: usize, local: usize) -> [f64; 2] {
        let values = &self.values[cell];
        let mesh = &section.mesh;
        let cell = &mesh.cells[cell];
        if values.iter().any(|value| *value != values[0]) {
            mesh.nodes[cell.nodes()[local] as usize]
        } else {
            mesh.middle(cell)
        }
    }
}

impl Extreme {
    fn none() -> Self {
        Self {
            value: 0.0,
            position: [0.0; 2],
            region: 0,
        }
    }
}
