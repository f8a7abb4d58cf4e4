//! Entities, nodes and elements of MSH 4.1: nodes and elements come in blocks, one
//! for each entity.
//!
//! ```text
//! $Entities
//! point-count curve-count surface-count volume-count
//! tag x y z physical-count physical ...                                  (point)
//! tag box(6) physical-count physical ... boundary-count boundary ...     (others)
//! $EndEntities
//! $Nodes                                      $Elements
//! blocks count smallest-tag largest-tag       blocks count smallest-tag largest-tag
//! dimension entity parametric count           dimension entity type count
//! tag                                         tag node ...
//! ...                                         ...
//! x y z <u> <v>
//! ...
//! $EndNodes                                   $EndElements
//! ```
//!
//! In binary files counts and the tags of nodes and elements are integers of eight bytes,
//! all others of four, without separators.

use super::build::{ElementKind, Membership};
use super::cursor::Cursor;
use super::element::{ElementShape, other_node_count};
use super::fields::Fields;
use super::problem::ReadProblem;
use super::reader::{Outcome, Progress, Reader, dimension_of, header, item};

/// Bytes of the shortest node: a line `1` and a line `0 0 0`. Here and below,
/// binary ones are longer.
const LEAST_NODE_BYTES: usize = 8;
/// Bytes of the shortest element, `1 1`.
const LEAST_ELEMENT_BYTES: usize = 4;
/// Bytes of the shortest block head, `0 1 0 0`.
const LEAST_BLOCK_BYTES: usize = 8;
/// Bytes of the shortest entity, `1 0 0 0 0`.
const LEAST_ENTITY_BYTES: usize = 10;

const INT: usize = 4;
const FLOAT: usize = 8;
const TAG: usize = 8;

/// Reads the entities and their physical groups.
pub(super) fn read_entities(reader: &mut Reader) -> Outcome {
    let expected = "the numbers of points, curves, surfaces and volumes";
    let mut fields = header(&mut reader.cursor, expected)?;
    let mut counts = [0; 4];
    for count in &mut counts {
        *count = fields.count("entities", LEAST_ENTITY_BYTES)?;
    }
    fields.end()?;
    reader.mesh.begin_entities();
    for (dimension, announced) in (0..).zip(counts) {
        for found in 0..announced {
            let progress = Progress {
                what: "entities",
                announced,
                found,
            };
            let entity = read_entity(&mut reader.cursor, progress, dimension)?;
            let entity =
                entity.and_then(|(tag, physical)| reader.mesh.entity(dimension, tag, physical));
            if reader.keep_unless(entity, |_| false)?.is_none() {
                reader.mesh.lose_entities();
            }
        }
    }
    Ok(())
}

/// Tag of an entity and the signed tags of its physical groups.
type Entity = (i32, Vec<i32>);

/// Reads an entity; the outer error is a missing entity.
fn read_entity(
    cursor: &mut Cursor,
    progress: Progress,
    dimension: u8,
) -> Result<Result<Entity, ReadProblem>, ReadProblem> {
    let (offset, expected) = match dimension {
        0 => (
            3,
            "a point: tag, x, y, z, number of physical tags, these tags",
        ),
        _ => (
            6,
            "an entity: tag, 6 bounds, number of physical tags, these tags, \
             number of bounding entities, their tags",
        ),
    };
    let fields = item(cursor, progress, expected)?;
    Ok(entity_of(fields, dimension, offset))
}

fn entity_of(mut fields: Fields, dimension: u8, offset: usize) -> Result<Entity, ReadProblem> {
    let tag = fields.int("entity tag")?;
    fields.skip(offset, FLOAT)?;
    let count = fields.size("number of physical tags")?;
    let mut physical = Vec::new();
    for _ in 0..count {
        physical.push(fields.int("physical tag")?);
    }
    if dimension > 0 {
        let bounds = fields.size("number of bounding entities")?;
        fields.skip(usize::try_from(bounds).unwrap_or(usize::MAX), INT)?;
    }
    fields.end()?;
    Ok((tag, physical))
}

/// The record that opens the nodes and the elements: numbers of blocks and of items.
fn read_totals(
    reader: &mut Reader,
    what: &'static str,
    least_bytes: usize,
) -> Result<(usize, usize), ReadProblem> {
    let expected = "4 numbers: blocks, count, smallest tag, largest tag";
    let mut fields = header(&mut reader.cursor, expected)?;
    let blocks = fields.count("blocks", LEAST_BLOCK_BYTES)?;
    let count = fields.count(what, least_bytes)?;
    fields.size("smallest tag")?;
    fields.size("largest tag")?;
    fields.end()?;
    Ok((blocks, count))
}

/// The total of a section must be the sum of its blocks.
fn check_total(what: &'static str, announced: usize, found: usize) -> Outcome {
    if announced == found {
        return Ok(());
    }
    Err(ReadProblem::CountMismatch {
        what,
        announced: announced as u64,
        found: found as u64,
    })
}

/// Reads the nodes.
pub(super) fn read_nodes(reader: &mut Reader) -> Outcome {
    let (announced, count) = read_totals(reader, "nodes", LEAST_NODE_BYTES)?;
    reader.mesh.reserve_nodes(count);
    let mut total = 0;
    let mut tags = Vec::new();
    for found in 0..announced {
        let progress = Progress {
            what: "node blocks",
            announced,
            found,
        };
        let expected = "a node block: dimension, entity, parametric, count";
        let mut fields = item(&mut reader.cursor, progress, expected)?;
        let dimension = dimension_of(fields.natural("dimension")?, 3)?;
        fields.int("entity tag")?;
        let parametric = fields.natural("parametric")?;
        let size = fields.count("nodes", LEAST_NODE_BYTES)?;
        fields.end()?;
        let parameters = match parametric {
            0 => 0,
            _ => usize::from(dimension),
        };
        read_node_tags(reader, size, &mut tags)?;
        read_coordinates(reader, &tags, parameters)?;
        total += size;
    }
    check_total("nodes", count, total)
}

/// Reads the tags of a block; `None` for tags that are no number.
fn read_node_tags(reader: &mut Reader, size: usize, tags: &mut Vec<Option<u64>>) -> Outcome {
    tags.clear();
    for found in 0..size {
        let progress = Progress {
            what: "nodes",
            announced: size,
            found,
        };
        let mut fields = item(&mut reader.cursor, progress, "a node tag")?;
        let tag = fields.size("node tag");
        // several fields on the line mean that the block is shorter than announced
        fields.end()?;
        tags.push(reader.keep_unless(tag, |_| false)?);
    }
    Ok(())
}

/// Reads the coordinates of the nodes of a block.
fn read_coordinates(reader: &mut Reader, tags: &[Option<u64>], parameters: usize) -> Outcome {
    for (found, &tag) in tags.iter().enumerate() {
        let progress = Progress {
            what: "node coordinates",
            announced: tags.len(),
            found,
        };
        let expected = "coordinates x, y, z and the parameters of the block";
        let fields = item(&mut reader.cursor, progress, expected)?;
        let position = read_position(fields, parameters);
        let node = match (tag, reader.keep_unless(position, is_misplaced)?) {
            (Some(tag), Some(position)) => {
                let added = reader.mesh.node(tag, position);
                reader.keep(added)
            }
            _ => None,
        };
        if node.is_none() {
            reader.mesh.lose_nodes();
        }
    }
    Ok(())
}

/// Whether a line does not belong to the block that is being read.
fn is_misplaced(problem: &ReadProblem) -> bool {
    matches!(problem, ReadProblem::FieldCount { .. })
}

fn read_position(mut fields: Fields, parameters: usize) -> Result<[f64; 3], ReadProblem> {
    let position = fields.position();
    if matches!(position, Ok(_) | Err(ReadProblem::NotACoordinate(_))) {
        fields.skip(parameters, FLOAT)?;
    }
    if position.is_ok() {
        fields.end()?;
    }
    position
}

/// Reads the elements.
pub(super) fn read_elements(reader: &mut Reader) -> Outcome {
    let (announced, count) = read_totals(reader, "elements", LEAST_ELEMENT_BYTES)?;
    let mut total = 0;
    for found in 0..announced {
        let progress = Progress {
            what: "element blocks",
            announced,
            found,
        };
        let expected = "an element block: dimension, entity, type, count";
        let mut fields = item(&mut reader.cursor, progress, expected)?;
        let dimension = fields.natural("dimension")?;
        let entity = fields.int("entity tag")?;
        let number = fields.natural("element type")?;
        let size = fields.count("elements", LEAST_ELEMENT_BYTES)?;
        fields.end()?;
        match ElementShape::from_gmsh(number) {
            Some(shape) => {
                let checked = check_dimension(shape, dimension);
                reader.keep(checked);
                let kind = ElementKind {
                    shape,
                    entity,
                    membership: Membership::Entity,
                };
                read_element_block(reader, kind, size)?;
            }
            None => skip_element_block(reader, number, size)?,
        }
        total += size;
    }
    check_total("elements", count, total)
}

fn check_dimension(shape: ElementShape, found: u64) -> Outcome {
    if found == u64::from(shape.dimension()) {
        return Ok(());
    }
    Err(ReadProblem::BlockDimension {
        name: shape.name(),
        found,
    })
}

fn read_element_block(reader: &mut Reader, kind: ElementKind, size: usize) -> Outcome {
    for found in 0..size {
        let progress = Progress {
            what: "elements",
            announced: size,
            found,
        };
        let expected = "an element: tag and as many nodes as its type has";
        let fields = item(&mut reader.cursor, progress, expected)?;
        let mut nodes = [0; 9];
        let nodes = &mut nodes[..kind.shape.node_count()];
        let tag = read_element(fields, nodes);
        let at = reader.cursor.location();
        if let Some(tag) = reader.keep_unless(tag, is_misplaced)? {
            reader.mesh.element(at, tag, kind, nodes);
        }
    }
    Ok(())
}

/// Reads an element into `nodes`; returns its tag.
fn read_element(mut fields: Fields, nodes: &mut [u64]) -> Result<u64, ReadProblem> {
    let tag = fields.size("element tag")?;
    for node in nodes {
        *node = fields.size("node tag")?;
    }
    fields.end()?;
    Ok(tag)
}

/// Skips a block of elements that are not read.
fn skip_element_block(reader: &mut Reader, number: u64, size: usize) -> Outcome {
    if size > 0 {
        let at = reader.cursor.location();
        reader.mesh.unsupported(at, number, size as u64);
    }
    if reader.cursor.is_binary() {
        let nodes = other_node_count(number).ok_or(ReadProblem::UnknownType(number))?;
        let fields = header(&mut reader.cursor, "elements of a block");
        return fields?.skip((1 + nodes).saturating_mul(size), TAG);
    }
    for found in 0..size {
        let progress = Progress {
            what: "elements",
            announced: size,
            found,
        };
        item(&mut reader.cursor, progress, "an element")?;
    }
    Ok(())
}
