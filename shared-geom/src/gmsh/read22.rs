//! Nodes and elements of MSH 2.2, ascii: one line each.
//!
//! ```text
//! $Nodes                 $Elements
//! count                  count
//! tag x y z              tag type tag-count physical entity ... node ...
//! ...                    ...
//! $EndNodes              $EndElements
//! ```

use nalgebra::Vector3;

use super::build::Membership;
use super::cursor::Fields;
use super::element::ElementShape;
use super::problem::ReadProblem;
use super::sections::{Outcome, Reader};

/// Bytes of the shortest node line, `1 0 0 0`, and element line, `1 15 0 1`.
const LEAST_BYTES: usize = 8;

/// Reads the nodes. Those of `$ParametricNodes` carry further numbers behind
/// the coordinates, which are passed over.
pub(super) fn read_nodes(reader: &mut Reader, parametric: bool) -> Outcome {
    let mut fields = reader.header("the number of nodes")?;
    let count = reader.count(&mut fields, "nodes", LEAST_BYTES)?;
    fields.end()?;
    reader.mesh.reserve_nodes(count);
    for found in 0..count {
        let line = reader.item("nodes", count, found)?;
        let node =
            read_node(line, parametric).and_then(|(tag, position)| reader.mesh.node(tag, position));
        if reader.keep(node).is_none() {
            reader.mesh.lose_nodes();
        }
    }
    Ok(())
}

fn read_node(line: &str, parametric: bool) -> Result<(u64, Vector3<f64>), ReadProblem> {
    let mut fields = Fields::new(line, "a node: tag, x, y, z");
    let tag = fields.number("node tag")?;
    let x = fields.coordinate()?;
    let y = fields.coordinate()?;
    let z = fields.coordinate()?;
    if !parametric {
        fields.end()?;
    }
    Ok((tag, Vector3::new(x, y, z)))
}

/// Reads the elements.
pub(super) fn read_elements(reader: &mut Reader) -> Outcome {
    let mut fields = reader.header("the number of elements")?;
    let count = reader.count(&mut fields, "elements", LEAST_BYTES)?;
    fields.end()?;
    for found in 0..count {
        let line = reader.item("elements", count, found)?;
        let element = read_element(reader, line);
        reader.keep(element);
    }
    Ok(())
}

fn read_element(reader: &mut Reader, line: &str) -> Outcome {
    let mut fields = Fields::new(line, "an element: tag, type, number of tags, tags, nodes");
    let at = reader.cursor.number();
    let tag = fields.number("element tag")?;
    let number = fields.number("element type")?;
    let Some(shape) = ElementShape::from_gmsh(number) else {
        reader.mesh.unsupported(at, number, 1);
        return Ok(());
    };
    let tag_count: usize = fields.number("number of tags")?;
    let physical = optional_tag(&mut fields, tag_count > 0, "physical tag")?;
    let entity = optional_tag(&mut fields, tag_count > 1, "entity tag")?;
    fields.skip(tag_count.saturating_sub(2))?;
    let mut nodes = [0; 9];
    let nodes = &mut nodes[..shape.node_count()];
    for node in nodes.iter_mut() {
        *node = fields.number("node tag")?;
    }
    fields.end()?;
    let kind = (shape, entity, Membership::Tag(physical));
    reader.mesh.element(at, tag, kind, nodes);
    Ok(())
}

/// The next tag if the element has one, else 0 for none.
fn optional_tag(
    fields: &mut Fields,
    present: bool,
    what: &'static str,
) -> Result<i32, ReadProblem> {
    if present { fields.number(what) } else { Ok(0) }
}
