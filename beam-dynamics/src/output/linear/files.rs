//! The files of a linear model.

use shared_geom::files::{OutputProblem, make_folder};

use super::json::linear_json;
use super::table::linear_csv;
use super::text::linear_text;
use crate::output::Written;
use crate::output::folder::{ResultLocation, Results};
use crate::result::LinearModel;

const JSON: &str = "linear.json";
const TABLE: &str = "linear.csv";
const TEXT: &str = "linear.txt";

/// Writes `NAME.linear.json`, `NAME.linear.csv` and `NAME.linear.txt`.
///
/// # Errors
/// [`OutputProblem`]: the folder or a file cannot be made.
pub fn write_linear(
    model: &LinearModel,
    location: &ResultLocation,
) -> Result<Written, OutputProblem> {
    make_folder(&location.folder)?;
    let mut results = Results::new(location);
    results.remove([JSON, TABLE, TEXT]);
    results.text(JSON, &linear_json(model))?;
    results.text(TABLE, &linear_csv(model))?;
    results.text(TEXT, &linear_text(model))?;
    Ok(results.written)
}
