//! Entities, nodes and elements of MSH 4.1, ascii: nodes and elements come in
//! blocks, one for each entity.
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

use nalgebra::Vector3;

use super::build::Membership;
use super::cursor::Fields;
use super::element::ElementShape;
use super::problem::ReadProblem;
use super::sections::{Outcome, Reader, dimension_of};

/// Bytes of the shortest node: a line `1` and a line `0 0 0`.
const LEAST_NODE_BYTES: usize = 8;
/// Bytes of the shortest element, `1 1`.
const LEAST_ELEMENT_BYTES: usize = 4;
/// Bytes of the shortest block head, `0 1 0 0`.
const LEAST_BLOCK_BYTES: usize = 8;
/// Bytes of the shortest entity, `1 0 0 0 0`.
const LEAST_ENTITY_BYTES: usize = 10;

/// Reads the entities: which physical groups each of them stands in.
pub(super) fn read_entities(reader: &mut Reader) -> Outcome {
    let mut fields = reader.header("the numbers of points, curves, surfaces and volumes")?;
    let mut counts = [0; 4];
    for count in &mut counts {
        *count = reader.count(&mut fields, "entities", LEAST_ENTITY_BYTES)?;
    }
    fields.end()?;
    reader.mesh.begin_entities();
    for (dimension, count) in (0..).zip(counts) {
        for found in 0..count {
            let line = reader.item("entities", count, found)?;
            let entity = read_entity(reader, line, dimension);
            if reader.keep(entity).is_none() {
                reader.mesh.lose_entities();
            }
        }
    }
    Ok(())
}

fn read_entity(reader: &mut Reader, line: &str, dimension: u8) -> Outcome {
    let (place, expected) = match dimension {
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
    let mut fields = Fields::new(line, expected);
    let tag = fields.number("entity tag")?;
    fields.skip(place)?;
    let count: usize = fields.number("number of physical tags")?;
    let mut physical = Vec::new();
    for _ in 0..count {
        physical.push(fields.number("physical tag")?);
    }
    if dimension > 0 {
        let bounds: usize = fields.number("number of bounding entities")?;
        fields.skip(bounds)?;
    }
    fields.end()?;
    reader.mesh.entity(dimension, tag, physical)
}

/// The line that opens the nodes and the elements: numbers of blocks and of items.
fn read_totals(
    reader: &mut Reader,
    what: &'static str,
    least_bytes: usize,
) -> Result<(usize, usize), ReadProblem> {
    let mut fields = reader.header("4 numbers: blocks, count, smallest tag, largest tag")?;
    let blocks = reader.count(&mut fields, "blocks", LEAST_BLOCK_BYTES)?;
    let count = reader.count(&mut fields, what, least_bytes)?;
    fields.number::<u64>("smallest tag")?;
    fields.number::<u64>("largest tag")?;
    fields.end()?;
    Ok((blocks, count))
}

/// The total of a section must be that of its blocks.
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
    let (blocks, count) = read_totals(reader, "nodes", LEAST_NODE_BYTES)?;
    reader.mesh.reserve_nodes(count);
    let mut total = 0;
    let mut tags = Vec::new();
    for found in 0..blocks {
        let line = reader.item("node blocks", blocks, found)?;
        let mut fields = Fields::new(line, "a node block: dimension, entity, parametric, count");
        let dimension = dimension_of(fields.number("dimension")?, 3)?;
        fields.number::<i32>("entity tag")?;
        let parametric: u32 = fields.number("parametric")?;
        let size = reader.count(&mut fields, "nodes", LEAST_NODE_BYTES)?;
        fields.end()?;
        let parameters = if parametric == 0 {
            0
        } else {
            usize::from(dimension)
        };
        read_node_tags(reader, size, &mut tags)?;
        read_coordinates(reader, &tags, parameters)?;
        total += size;
    }
    check_total("nodes", count, total)
}

/// Reads the tags of a block; `None` for those that are no number.
fn read_node_tags(reader: &mut Reader, size: usize, tags: &mut Vec<Option<u64>>) -> Outcome {
    tags.clear();
    for found in 0..size {
        let line = reader.item("nodes", size, found)?;
        let mut fields = Fields::new(line, "a node tag");
        let tag = fields.number("node tag");
        // several fields on the line mean that the block is shorter than announced
        fields.end()?;
        tags.push(reader.keep(tag));
    }
    Ok(())
}

/// Reads the coordinates of the nodes of a block.
fn read_coordinates(reader: &mut Reader, tags: &[Option<u64>], parameters: usize) -> Outcome {
    for (found, &tag) in tags.iter().enumerate() {
        let line = reader.item("node coordinates", tags.len(), found)?;
        let position = read_position(line, parameters);
        if let Err(problem @ ReadProblem::FieldCount { .. }) = position {
            return Err(problem);
        }
        let node = match (tag, reader.keep(position)) {
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

fn read_position(line: &str, parameters: usize) -> Result<Vector3<f64>, ReadProblem> {
    let mut fields = Fields::new(line, "coordinates x, y, z and the parameters of the block");
    let x = fields.coordinate()?;
    let y = fields.coordinate()?;
    let z = fields.coordinate()?;
    fields.skip(parameters)?;
    fields.end()?;
    Ok(Vector3::new(x, y, z))
}

/// Reads the elements.
pub(super) fn read_elements(reader: &mut Reader) -> Outcome {
    let (blocks, count) = read_totals(reader, "elements", LEAST_ELEMENT_BYTES)?;
    let mut total = 0;
    for found in 0..blocks {
        let line = reader.item("element blocks", blocks, found)?;
        let mut fields = Fields::new(line, "an element block: dimension, entity, type, count");
        let dimension: u32 = fields.number("dimension")?;
        let entity = fields.number("entity tag")?;
        let number = fields.number("element type")?;
        let size = reader.count(&mut fields, "elements", LEAST_ELEMENT_BYTES)?;
        fields.end()?;
        match ElementShape::from_gmsh(number) {
            Some(shape) => {
                let checked = check_dimension(shape, dimension);
                reader.keep(checked);
                read_element_block(reader, shape, entity, size)?;
            }
            None => skip_element_block(reader, number, size)?,
        }
        total += size;
    }
    check_total("elements", count, total)
}

fn check_dimension(shape: ElementShape, found: u32) -> Outcome {
    if found == u32::from(shape.dimension()) {
        return Ok(());
    }
    Err(ReadProblem::BlockDimension {
        name: shape.name(),
        found,
    })
}

fn read_element_block(
    reader: &mut Reader,
    shape: ElementShape,
    entity: i32,
    size: usize,
) -> Outcome {
    for found in 0..size {
        let line = reader.item("elements", size, found)?;
        let at = reader.cursor.number();
        let mut nodes = [0; 9];
        let nodes = &mut nodes[..shape.node_count()];
        match read_element(line, nodes) {
            Ok(tag) => {
                let kind = (shape, entity, Membership::Entity);
                reader.mesh.element(at, tag, kind, nodes);
            }
            Err(problem @ ReadProblem::FieldCount { .. }) => return Err(problem),
            Err(problem) => reader.problems.push(at, problem),
        }
    }
    Ok(())
}

/// Reads an element into `nodes`; gives its tag.
fn read_element(line: &str, nodes: &mut [u64]) -> Result<u64, ReadProblem> {
    let mut fields = Fields::new(line, "an element: tag and as many nodes as its type has");
    let tag = fields.number("element tag")?;
    for node in nodes {
        *node = fields.number("node tag")?;
    }
    fields.end()?;
    Ok(tag)
}

/// Passes over a block of elements that are not read.
fn skip_element_block(reader: &mut Reader, number: u32, size: usize) -> Outcome {
    if size > 0 {
        let at = reader.cursor.number();
        reader.mesh.unsupported(at, number, size as u64);
    }
    for found in 0..size {
        reader.item("elements", size, found)?;
    }
    Ok(())
}
