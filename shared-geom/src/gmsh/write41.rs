//! Writes MSH 4.1, ascii.
//!
//! Reading the text gives the same mesh again, to the last bit, if its groups are in the
//! order in which the reader makes them: the named ones, then the used ones without a
//! name in the order of their first use by points, lines, cells. Two things cannot be
//! kept: an entity whose elements are in different groups is split (in MSH 4.1 the groups
//! belong to the entity), and the further parts get new entity tags; and control
//! characters in names become blanks.

use std::collections::{HashMap, HashSet};
use std::fmt::Write;

use nalgebra::Vector3;

use super::element::POINT_TYPE;
use crate::mesh::{GroupSet, Mesh, PhysicalGroup};

/// An element as it is written.
struct Element<'a> {
    tag: u64,
    /// Number of its type in gmsh files.
    number: u32,
    owner: Owner<'a>,
    nodes: &'a [u32],
}

/// Data that define a separate entity in the file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
struct Owner<'a> {
    dimension: u8,
    /// Entity in the mesh.
    entity: i32,
    groups: &'a [usize],
    /// Groups in which its lines run the other way.
    against: &'a [usize],
}

/// An entity as it is written.
struct Entity {
    dimension: u8,
    tag: i32,
    /// Signed tags of its groups.
    physical: Vec<i32>,
    low: Vector3<f64>,
    high: Vector3<f64>,
}

/// Text of `mesh` as an MSH 4.1 file in ascii; the digits of the coordinates are exact.
pub fn write(mesh: &Mesh) -> String {
    let elements = elements(mesh);
    let (entities, tags) = entities(mesh, &elements);
    let mut text = String::with_capacity(64 * (mesh.nodes.len() + elements.len()));
    text.push_str("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n");
    // writing to a string cannot fail
    let _ = write_names(&mut text, mesh);
    let _ = write_entities(&mut text, &entities);
    let _ = write_nodes(&mut text, mesh, &entities);
    let _ = write_elements(&mut text, mesh, &elements, &tags);
    text
}

/// All elements: points, lines, cells, each in the order of the mesh.
fn elements(mesh: &Mesh) -> Vec<Element<'_>> {
    let points = mesh.points.iter().map(|point| Element {
        tag: point.tag,
        number: POINT_TYPE,
        owner: owner(0, point.entity, &point.groups),
        nodes: std::slice::from_ref(&point.node),
    });
    let cells = mesh.cells.iter().map(|cell| Element {
        tag: cell.tag,
        number: cell.kind.gmsh_type(),
        owner: owner(2, cell.entity, &cell.groups),
        nodes: cell.nodes(),
    });
    points.chain(lines(mesh)).chain(cells).collect()
}

fn owner(dimension: u8, entity: i32, groups: &GroupSet) -> Owner<'_> {
    Owner {
        dimension,
        entity,
        groups: groups.as_slice(),
        against: &[],
    }
}

/// The lines; one that is listed in both directions is written once.
fn lines(mesh: &Mesh) -> impl Iterator<Item = Element<'_>> {
    let mut rest = mesh.lines.iter().peekable();
    std::iter::from_fn(move || {
        let line = rest.next()?;
        let back = rest.next_if(|next| {
            let mut back = next.reversed();
            back.groups = line.groups.clone();
            back == *line && !line.groups.is_empty() && !next.groups.is_empty()
        });
        Some(Element {
            tag: line.tag,
            number: line.kind.gmsh_type(),
            owner: Owner {
                against: back.map_or(&[], |back| back.groups.as_slice()),
                ..owner(1, line.entity, &line.groups)
            },
            nodes: line.nodes(),
        })
    })
}

/// The entities, sorted by dimension and tag, and the tag of each owner's entity.
fn entities<'a>(mesh: &Mesh, elements: &[Element<'a>]) -> (Vec<Entity>, HashMap<Owner<'a>, i32>) {
    let mut used: HashSet<(u8, i32)> = elements
        .iter()
        .map(|element| (element.owner.dimension, element.owner.entity))
        .collect();
    let mut taken = HashSet::new();
    let mut entities: Vec<Entity> = Vec::new();
    let mut index_of = HashMap::new();
    for element in elements {
        let dimension = element.owner.dimension;
        let index = *index_of.entry(element.owner).or_insert_with(|| {
            let mut tag = element.owner.entity;
            while !taken.insert((dimension, tag)) {
                tag = free_tag(dimension, &mut used);
            }
            entities.push(Entity {
                dimension,
                tag,
                physical: physical_tags(mesh, element.owner),
                low: Vector3::repeat(f64::INFINITY),
                high: Vector3::repeat(f64::NEG_INFINITY),
            });
            entities.len() - 1
        });
        let entity = &mut entities[index];
        for node in element
            .nodes
            .iter()
            .filter_map(|&n| mesh.nodes.get(n as usize))
        {
            entity.low = entity.low.inf(&node.position);
            entity.high = entity.high.sup(&node.position);
        }
    }
    let tags = index_of
        .into_iter()
        .map(|(owner, index)| (owner, entities[index].tag))
        .collect();
    entities.sort_by_key(|entity| (entity.dimension, entity.tag));
    (entities, tags)
}

/// The signed tags of the groups of an owner.
fn physical_tags(mesh: &Mesh, owner: Owner) -> Vec<i32> {
    let tag = |&group: &usize| mesh.groups.get(group).map(|group| group.tag);
    let with = owner.groups.iter().filter_map(tag);
    let against = owner.against.iter().filter_map(tag);
    with.chain(against.map(|tag| -tag)).collect()
}

/// The smallest positive tag that no entity of the mesh has.
fn free_tag(dimension: u8, used: &mut HashSet<(u8, i32)>) -> i32 {
    let tag = (1..i32::MAX)
        .find(|&tag| !used.contains(&(dimension, tag)))
        .unwrap_or(i32::MAX);
    used.insert((dimension, tag));
    tag
}

fn write_names(text: &mut String, mesh: &Mesh) -> std::fmt::Result {
    let name = |group: &PhysicalGroup| {
        let name = group.name.as_ref()?.replace(char::is_control, " ");
        Some((group.dimension, group.tag, name))
    };
    let named: Vec<_> = mesh.groups.iter().filter_map(name).collect();
    if named.is_empty() {
        return Ok(());
    }
    writeln!(text, "$PhysicalNames\n{}", named.len())?;
    for (dimension, tag, name) in named {
        writeln!(text, "{dimension} {tag} \"{name}\"")?;
    }
    writeln!(text, "$EndPhysicalNames")
}

fn write_entities(text: &mut String, entities: &[Entity]) -> std::fmt::Result {
    let count = |dimension| entities.iter().filter(|e| e.dimension == dimension).count();
    writeln!(text, "$Entities\n{} {} {} 0", count(0), count(1), count(2))?;
    for entity in entities {
        write!(text, "{}", entity.tag)?;
        write_position(text, &entity.low)?;
        if entity.dimension > 0 {
            write_position(text, &entity.high)?;
        }
        write!(text, " {}", entity.physical.len())?;
        for tag in &entity.physical {
            write!(text, " {tag}")?;
        }
        // number of bounding entities: unknown
        writeln!(text, "{}", if entity.dimension > 0 { " 0" } else { "" })?;
    }
    writeln!(text, "$EndEntities")
}

/// All nodes in one block, in the order of the mesh; the block belongs to the last
/// entity, one of the highest dimension.
fn write_nodes(text: &mut String, mesh: &Mesh, entities: &[Entity]) -> std::fmt::Result {
    let count = mesh.nodes.len();
    let tags = || mesh.nodes.iter().map(|node| node.tag);
    let (low, high) = (tags().min().unwrap_or(0), tags().max().unwrap_or(0));
    writeln!(text, "$Nodes\n{} {count} {low} {high}", count.min(1))?;
    if count > 0 {
        let (dimension, tag) = entities.last().map_or((2, 1), |e| (e.dimension, e.tag));
        writeln!(text, "{dimension} {tag} 0 {count}")?;
    }
    for tag in tags() {
        writeln!(text, "{tag}")?;
    }
    for node in &mesh.nodes {
        let p = node.position;
        writeln!(text, "{:?} {:?} {:?}", p.x, p.y, p.z)?;
    }
    writeln!(text, "$EndNodes")
}

fn write_position(text: &mut String, p: &Vector3<f64>) -> std::fmt::Result {
    write!(text, " {:?} {:?} {:?}", p.x, p.y, p.z)
}

/// The elements in blocks of consecutive ones of one entity and type.
fn write_elements(
    text: &mut String,
    mesh: &Mesh,
    elements: &[Element],
    tags: &HashMap<Owner<'_>, i32>,
) -> std::fmt::Result {
    let all = || elements.iter().map(|element| element.tag);
    let (low, high) = (all().min().unwrap_or(0), all().max().unwrap_or(0));
    let alike = |a: &Element, b: &Element| a.owner == b.owner && a.number == b.number;
    let blocks = elements.chunk_by(alike).count();
    writeln!(text, "$Elements\n{blocks} {} {low} {high}", elements.len())?;
    for block in elements.chunk_by(alike) {
        let Some(first) = block.first() else { continue };
        let tag = tags
            .get(&first.owner)
            .copied()
            .unwrap_or(first.owner.entity);
        writeln!(
            text,
            "{} {tag} {} {}",
            first.owner.dimension,
            first.number,
            block.len()
        )?;
        for element in block {
            write!(text, "{}", element.tag)?;
            for &node in element.nodes {
                let tag = mesh.nodes.get(node as usize).map_or(0, |node| node.tag);
                write!(text, " {tag}")?;
            }
            writeln!(text)?;
        }
    }
    writeln!(text, "$EndElements")
}
