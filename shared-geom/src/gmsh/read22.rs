//! Nodes and elements of MSH 2.2.
//!
//! ```text
//! $Nodes                 $Elements
//! count                  count
//! tag x y z              tag type tag-count physical entity ... node ...
//! ...                    ...
//! $EndNodes              $EndElements
//! ```
//!
//! In binary files tags are integers of four bytes, and elements come in blocks
//! `type count tag-count`, followed by `tag physical entity ... node ...` for each.

use super::build::{ElementKind, Membership};
use super::element::{ElementShape, other_node_count};
use super::fields::Fields;
use super::problem::ReadProblem;
use super::reader::{Outcome, Progress, Reader, header, item, line_header};

/// Bytes of the shortest node line, `1 0 0 0`, and element line, `1 15 0 1`; binary
/// ones are longer.
const LEAST_BYTES: usize = 8;

const INT: usize = 4;
const FLOAT: usize = 8;

/// The count in the first line of a section.
fn read_count(
    reader: &mut Reader,
    what: &'static str,
    expected: &'static str,
) -> Result<usize, ReadProblem> {
    let mut fields = line_header(&mut reader.cursor, expected)?;
    let count = fields.count(what, LEAST_BYTES)?;
    fields.end()?;
    Ok(count)
}

/// Reads the nodes. Nodes of `$ParametricNodes` have further numbers after the
/// coordinates, which are skipped.
pub(super) fn read_nodes(reader: &mut Reader, parametric: bool) -> Outcome {
    let announced = read_count(reader, "nodes", "the number of nodes")?;
    reader.mesh.reserve_nodes(announced);
    for found in 0..announced {
        let progress = Progress {
            what: "nodes",
            announced,
            found,
        };
        let fields = item(&mut reader.cursor, progress, "a node: tag, x, y, z")?;
        let node = read_node(fields, parametric)
            .and_then(|(tag, position)| reader.mesh.node(tag, position));
        if reader.keep_unless(node, |_| false)?.is_none() {
            reader.mesh.lose_nodes();
        }
    }
    Ok(())
}

fn read_node(mut fields: Fields, parametric: bool) -> Result<(u64, [f64; 3]), ReadProblem> {
    let tag = fields.natural("node tag");
    let position = fields.position();
    if !parametric {
        fields.end()?;
    } else if matches!(fields, Fields::Bytes { .. }) {
        // dimension and tag of the entity, then its parameters: none for points
        // and volumes, one on curves, two on surfaces
        let dimension = fields.int("dimension")?;
        let parameters = match dimension {
            1 => 1,
            2 => 2,
            _ => 0,
        };
        fields.skip(1, INT)?;
        fields.skip(parameters, FLOAT)?;
    }
    Ok((tag?, position?))
}

/// Reads the elements.
pub(super) fn read_elements(reader: &mut Reader) -> Outcome {
    let announced = read_count(reader, "elements", "the number of elements")?;
    let mut found = 0;
    while found < announced {
        let progress = Progress {
            what: "elements",
            announced,
            found,
        };
        found += if reader.cursor.is_binary() {
            read_block(reader, announced - found)?
        } else {
            read_line(reader, progress)?
        };
    }
    Ok(())
}

/// Reads the element of a line of text.
fn read_line(reader: &mut Reader, progress: Progress) -> Result<usize, ReadProblem> {
    let expected = "an element: tag, type, number of tags, tags, nodes";
    let fields = item(&mut reader.cursor, progress, expected)?;
    let element = read_line_element(fields);
    if let Some((tag, number, element)) = reader.keep(element) {
        let at = reader.cursor.location();
        match element {
            Some((kind, nodes)) => {
                let count = kind.shape.node_count();
                reader.mesh.element(at, tag, kind, &nodes[..count]);
            }
            None => reader.mesh.unsupported(at, number, 1),
        }
    }
    Ok(1)
}

/// Kind of an element and its nodes.
type Content = (ElementKind, [u64; 9]);

/// Tag and type of the element of a line; its kind, if it is read.
fn read_line_element(mut fields: Fields) -> Result<(u64, u64, Option<Content>), ReadProblem> {
    let tag = fields.natural("element tag")?;
    let number = fields.natural("element type")?;
    let Some(shape) = ElementShape::from_gmsh(number) else {
        return Ok((tag, number, None));
    };
    let tag_count = fields.natural("number of tags")?;
    let tag_count = usize::try_from(tag_count).unwrap_or(usize::MAX);
    let content = read_content(&mut fields, shape, tag_count)?;
    fields.end()?;
    Ok((tag, number, Some(content)))
}

/// Reads the tags and nodes of an element.
fn read_content(
    fields: &mut Fields,
    shape: ElementShape,
    tag_count: usize,
) -> Result<Content, ReadProblem> {
    let physical = optional_tag(fields, tag_count > 0, "physical tag")?;
    let entity = optional_tag(fields, tag_count > 1, "entity tag")?;
    fields.skip(tag_count.saturating_sub(2), INT)?;
    let mut nodes = [0; 9];
    for node in &mut nodes[..shape.node_count()] {
        *node = fields.natural("node tag")?;
    }
    let kind = ElementKind {
        shape,
        entity,
        membership: Membership::Tag(physical),
    };
    Ok((kind, nodes))
}

/// The next tag if the element has one, else 0.
fn optional_tag(
    fields: &mut Fields,
    present: bool,
    what: &'static str,
) -> Result<i32, ReadProblem> {
    if present { fields.int(what) } else { Ok(0) }
}

/// Reads a block of a binary file, of at most `most` elements; returns their number.
fn read_block(reader: &mut Reader, most: usize) -> Result<usize, ReadProblem> {
    let expected = "a block of elements: type, count, number of tags";
    let mut fields = header(&mut reader.cursor, expected)?;
    let number = fields.natural("element type")?;
    let count = fields.natural("number of elements in a block")?;
    let tag_count = fields.natural("number of tags")?;
    let at = reader.cursor.location();
    let size = usize::try_from(count).unwrap_or(usize::MAX);
    if size == 0 || size > most {
        return Err(ReadProblem::BlockSize { count, most });
    }
    let tag_count = usize::try_from(tag_count).unwrap_or(usize::MAX);
    let Some(shape) = ElementShape::from_gmsh(number) else {
        reader.mesh.unsupported(at, number, count);
        let nodes = other_node_count(number).ok_or(ReadProblem::UnknownType(number))?;
        let numbers = (1 + nodes).saturating_add(tag_count).saturating_mul(size);
        header(&mut reader.cursor, "elements of a block")?.skip(numbers, INT)?;
        return Ok(size);
    };
    for _ in 0..size {
        let expected = "an element: tag, tags, nodes";
        let mut fields = header(&mut reader.cursor, expected)?;
        let tag = fields.natural("element tag")?;
        let (kind, nodes) = read_content(&mut fields, shape, tag_count)?;
        let at = reader.cursor.location();
        let nodes = &nodes[..shape.node_count()];
        reader.mesh.element(at, tag, kind, nodes);
    }
    Ok(size)
}
