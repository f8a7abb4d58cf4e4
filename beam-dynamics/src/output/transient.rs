//! Output of a run in time, during the run and at its end.

mod csv_rows;
mod effort;
mod files;
mod grids;
mod netcdf_rows;
mod netcdf_table;
mod plot;
mod problem;
mod restart;
mod span_record;
mod table;
mod writer;

#[cfg(test)]
mod plot_tests;
#[cfg(test)]
mod tests;

pub(in crate::output) use csv_rows::CsvRows;
pub use effort::effort_text;
pub use files::{RunFiles, not_drawn_text};
pub use plot::TimePlot;
pub use problem::RunFileProblem;
pub use restart::{parse_snapshot, read_snapshot, write_snapshot};
pub use table::TimeTable;
pub use writer::Heading;
