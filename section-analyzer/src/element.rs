//! One cell: its geometry at integration points, the strain of the section, the blocks that
//! a cell adds to the matrices of the section, and the changes of strain and forces when
//! its nodes move.

mod blocks;
mod cases;
mod coupled;
mod curved_blocks;
mod forces;
mod gradient;
mod line;
mod moved;
mod point;
mod potential;
mod side;
mod strain;

pub use blocks::{CellBlocks, CellIntegrals, LawBlocks};
pub use cases::{
    CASES, CaseLoop, CellField, CellState, NO_FIELD, NO_ROWS, Product, Row, add_work,
    in_widest_registers, rows_of, strain_along, strain_in_cases, stress_in_cases,
};
pub use coupled::{CellCharges, CellPotential, PotentialState, add_coupled};
pub use curved_blocks::{CurvedCell, TurningLaw};
pub use forces::CellForces;
pub use gradient::PointGradient;
pub use line::{Line, Metric};
pub use moved::{MovedPoint, NodalForces, NodalState};
pub use point::{CellPoint, RulePoint, cell_points, rule_points};
pub use potential::{NodalPotential, gradient_at};
pub use side::{SidePoint, side_points};
pub use strain::{
    FACE_STRAINS, NO_COLUMNS, NodalColumns, Y_GRADIENT_STRAINS, Z_GRADIENT_STRAINS,
    rigid_displacement, strain_at,
};

#[cfg(test)]
mod helix_tests;
