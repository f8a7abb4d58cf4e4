//! Round trips: mesh, text, the same mesh.

use nalgebra::Vector3;

use super::read_tests::{V22, V41, parsed};
use super::*;
use crate::mesh::{Cell, CellKind, Node, PhysicalGroup};

#[test]
fn what_was_read_is_written_and_read_back_to_the_last_bit() {
    for text in [V22, V41] {
        let mesh = parsed(text);
        assert_eq!(parsed(&write(&mesh)), mesh);
    }
}

#[test]
fn coordinates_of_any_size_come_back() {
    // numbers with long, short, huge and tiny decimal forms
    let values = [
        0.1 + 0.2,
        -1.0 / 3.0,
        1e-300,
        6.02214076e23,
        f64::MAX,
        5e-324,
        7.0,
    ];
    let nodes = (0..)
        .zip(values)
        .map(|(i, x)| Node {
            tag: 100 - i,
            position: Vector3::new(x, -x, x / 3.0),
        })
        .collect();
    let mut cell = Cell::new(5, CellKind::Triangle3, 1, |i| 2 * i as u32);
    cell.groups = 0.into();
    let mesh = Mesh {
        nodes,
        cells: vec![cell],
        groups: vec![PhysicalGroup {
            dimension: 2,
            tag: 9,
            name: Some("a \"quoted\" name, 90\u{b0}".into()),
        }],
        ..Mesh::default()
    };
    assert_eq!(parsed(&write(&mesh)), mesh);
}

#[test]
fn an_entity_with_two_groups_is_split() {
    let mesh = parsed(V22);
    let group = |tag| PhysicalGroup {
        dimension: 2,
        tag,
        name: Some(format!("g{tag}")),
    };
    let cell = |tag, kind, group: Option<usize>| {
        let mut cell = Cell::new(tag, kind, 1, |i| (i + tag as usize) as u32);
        cell.groups = group.into_iter().collect();
        cell
    };
    let mesh = Mesh {
        nodes: mesh.nodes,
        cells: vec![
            cell(1, CellKind::Triangle3, Some(0)),
            cell(2, CellKind::Triangle3, Some(1)),
            cell(3, CellKind::Triangle3, None),
        ],
        groups: vec![group(4), group(6)],
        ..Mesh::default()
    };
    let again = parsed(&write(&mesh));
    let entity_and_group = |c: &Cell| (c.entity, c.groups.first());
    let found: Vec<_> = again.cells.iter().map(entity_and_group).collect();
    assert_eq!(found, [(1, Some(0)), (2, Some(1)), (3, None)]);
    assert!(
        again
            .cells
            .iter()
            .zip(&mesh.cells)
            .all(|(a, b)| a.nodes() == b.nodes())
    );
}

#[test]
fn an_empty_mesh_is_written_as_one() {
    assert_eq!(parsed(&write(&Mesh::default())), Mesh::default());
}
