//! Names of physical groups: lines of text in binary files too.

use super::fields::LineFields;
use super::problem::ReadProblem;
use super::reader::{Outcome, Reader, dimension_of, line_header};
use crate::mesh::PhysicalGroup;

/// Reads the names: a count, then a line `dimension tag "name"` each.
pub(super) fn read(reader: &mut Reader) -> Outcome {
    const LEAST_BYTES: usize = 7;
    let what = "physical names";
    let mut fields = line_header(&mut reader.cursor, "the number of physical names")?;
    let announced = fields.count(what, LEAST_BYTES)?;
    fields.end()?;
    for found in 0..announced {
        let missing = ReadProblem::CountMismatch {
            what,
            announced: announced as u64,
            found: found as u64,
        };
        let line = reader.cursor.content().ok_or(missing)?;
        if reader.cursor.is_foreign() {
            reader.keep(Err::<(), _>(ReadProblem::NotText));
            continue;
        }
        let group = physical_name(line).and_then(|group| reader.mesh.named_group(group));
        reader.keep(group);
    }
    Ok(())
}

/// Reads `2 1 "skin of the spar"`.
fn physical_name(line: &str) -> Result<PhysicalGroup, ReadProblem> {
    let (before, quoted) = line.split_once('"').ok_or(ReadProblem::NoName)?;
    let name = quoted.strip_suffix('"').ok_or(ReadProblem::NoName)?;
    let expected = "dimension, tag and the name in double quotes";
    let mut fields = LineFields::new(before, expected, 0);
    let dimension: u32 = fields.number("dimension")?;
    let tag: i32 = fields.number("physical tag")?;
    fields.end()?;
    Ok(PhysicalGroup {
        dimension: dimension_of(u64::from(dimension), 3)?,
        tag: tag.saturating_abs(),
        name: Some(name.to_string()),
    })
}
