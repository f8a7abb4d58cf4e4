//! The faces of laminates, on which distributed loads act.
//!
//! A laminate on one side of its line has one face, the outer one; a laminate centered on
//! its line has one on either side. Lines on which another wall ends have no face.

use std::collections::HashMap;

use shared_geom::mesh::{Line, LineKind, Mesh};

use super::layers::{Bank, Ends, Layers};
use super::segments::Segment;
use super::{LaminaFace, LaminaSide};

/// The faces of a laminate at a line, given the end nodes and the middle nodes of its
/// levels.
pub(super) fn of_line(
    segment: &Segment,
    layers: &Layers,
    ends: &Ends,
    middles: &[u32],
) -> Vec<LaminaFace> {
    let last = layers.levels.len().saturating_sub(1);
    let (right, left) = ((LaminaSide::Right, 0), (LaminaSide::Left, last));
    let faces = match layers.bank {
        Bank::Left => vec![left],
        Bank::Right => vec![right],
        Bank::Middle => vec![right, left],
    };
    let face = |(side, level): (LaminaSide, usize)| {
        let middle = middles.get(level).copied();
        let kind = match middle {
            Some(_) => LineKind::Line3,
            None => LineKind::Line2,
        };
        let nodes = [ends[0][level], ends[1][level], middle.unwrap_or_default()];
        LaminaFace {
            lamina: segment.lamina,
            side,
            line: Line::new(segment.tag, kind, 0, |i| nodes[i]),
        }
    };
    faces.into_iter().map(face).collect()
}

/// Removes lines that have cells on both sides.
pub(super) fn keep_free(mesh: &Mesh, faces: &mut Vec<LaminaFace>) {
    let mut cells_at: HashMap<[u32; 2], usize> = HashMap::new();
    for face in faces.iter() {
        cells_at.insert(key(&face.line), 0);
    }
    for cell in &mesh.cells {
        for ([a, b], _) in cell.kind.sides(cell.nodes()) {
            if let Some(count) = cells_at.get_mut(&[a.min(b), a.max(b)]) {
                *count += 1;
            }
        }
    }
    faces.retain(|face| cells_at.get(&key(&face.line)) == Some(&1));
}

fn key(line: &Line) -> [u32; 2] {
    let nodes = line.nodes();
    [nodes[0].min(nodes[1]), nodes[0].max(nodes[1])]
}
