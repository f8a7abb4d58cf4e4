//! A grid of VTK, from its legacy or its XML file: points, plane cells, lines, and an array
//! of whole numbers by cell as groups.
//!
//! The array is called `group`, or `region` beside numbers of the cells, or is the only one with another of the [`USUAL`] names, or the only
//! one of whole numbers. Each of its values is a group of this number, or of the name that the file
//! gives to the number. A grid in a plane `x = constant` is read as (y, z).

use std::collections::{HashMap, HashSet};

use super::parts::{Parts, Shape};
use super::problem::{FileProblem, Problems};
use crate::mesh::{CellKind, GroupForm, LineKind, Mesh};

/// The name of the array of groups, whatever others there are; in results of Helicoid, which have
/// [`TAGS`], the second one.
const OWN: [&str; 2] = ["group", "region"];
/// Usual names of arrays of groups.
const USUAL: [&str; 8] = [
    "gmsh:physical",
    "PhysicalIds",
    "physical",
    "region",
    "CellEntityIds",
    "MaterialIds",
    "material",
    "elset",
];
/// The array with the numbers of the cells, if the file has one.
const TAGS: &str = "tag";
/// The type of rectangles whose corners are listed by rows.
const PIXEL: u32 = 8;

/// An array of whole numbers by cell.
#[derive(Debug)]
pub(super) struct Array {
    pub name: String,
    pub values: Vec<i32>,
}

/// A cell as listed: its line and the indices of its points.
#[derive(Debug)]
pub(super) struct Listed {
    pub line: usize,
    pub points: Vec<u64>,
}

/// The content of a file.
#[derive(Debug, Default)]
pub(super) struct Grid {
    /// Points, each with its line.
    pub points: Vec<(usize, [f64; 3])>,
    pub cells: Vec<Listed>,
    /// Types of the cells, each with its line.
    pub types: Vec<(usize, u32)>,
    pub arrays: Vec<Array>,
    /// Numbers with names, as `region skin`: the array, a space, the name of the number.
    pub names: Vec<(String, i32)>,
}

impl Grid {
    /// The values of an array as whole numbers, if they are.
    pub(super) fn whole(values: impl Iterator<Item = f64>) -> Option<Vec<i32>> {
        let is_whole = |value: f64| value.fract() == 0.0 && value.abs() < f64::from(i32::MAX);
        values
            .map(|value| is_whole(value).then_some(value as i32))
            .collect()
    }

    /// The mesh. Points are numbered from one, cells too unless the file numbers them;
    /// `line` is the line of problems of the file as a whole.
    pub(super) fn finish(self, line: usize, problems: &mut Problems) -> Mesh {
        let mut parts = Parts::default();
        let turned = self.is_across_x();
        for (tag, (line, [x, y, z])) in (1..).zip(&self.points) {
            let position = if turned { [*y, *z, 0.0] } else { [*x, *y, *z] };
            problems.keep(*line, parts.node(tag, position));
        }
        if self.types.len() != self.cells.len() {
            let problem = FileProblem::Length {
                what: "the types of the cells",
                found: self.types.len(),
                expected: self.cells.len(),
            };
            problems.push(line, problem);
            return Mesh::default();
        }
        let groups = problems.keep(line, self.groups()).flatten();
        let tags = self.tags(groups);
        let mut sets: HashMap<i32, usize> = HashMap::new();
        for (index, (cell, (_, kind))) in self.cells.iter().zip(&self.types).enumerate() {
            let Some(shape) = problems.keep(cell.line, shape_of(*kind)).flatten() else {
                continue;
            };
            let value = groups.and_then(|array| Some((&array.name, *array.values.get(index)?)));
            let set = value.map(|(array, value)| {
                let new = || parts.set(self.name_of(array, value), Some(value));
                *sets.entry(value).or_insert_with(new)
            });
            let tag = tags.and_then(|tags| tags.values.get(index));
            let tag = tag.map_or(index as u64 + 1, |tag| tag.unsigned_abs().into());
            let added = cell
                .nodes(*kind, shape, tag)
                .and_then(|nodes| parts.element((cell.line, tag), shape, nodes, set));
            problems.keep(cell.line, added);
        }
        Mesh {
            group_form: GroupForm::Values,
            ..parts.finish(problems)
        }
    }

    /// Whether the points are in a plane `x = constant`, and in no plane `z = constant`.
    fn is_across_x(&self) -> bool {
        let is_constant = |axis: usize| {
            let mut values = self.points.iter().map(|(_, position)| position[axis]);
            let first = values.next();
            values.all(|value| Some(value) == first)
        };
        is_constant(0) && !is_constant(2)
    }

    /// The array whose values are the groups.
    fn groups(&self) -> Result<Option<&Array>, FileProblem> {
        let named = |name: &&str| {
            let mut arrays = self.arrays.iter();
            arrays.find(|array| array.name.eq_ignore_ascii_case(name))
        };
        let own = named(&OWN[0]).or_else(|| {
            named(&TAGS)?;
            named(&OWN[1])
        });
        if own.is_some() {
            return Ok(own);
        }
        let mut usual: Vec<&Array> = USUAL.iter().filter_map(named).collect();
        if usual.is_empty() {
            usual = self.arrays.iter().collect();
        }
        // equal ones are one
        usual.dedup_by(|next, kept| next.values == kept.values);
        match usual[..] {
            [] => Ok(None),
            [array] => Ok(Some(array)),
            _ => {
                let names = usual.iter().map(|array| array.name.clone());
                Err(FileProblem::Arrays(names.collect()))
            }
        }
    }

    /// The array with the numbers of the cells: positive, each once, and not the groups.
    fn tags(&self, groups: Option<&Array>) -> Option<&Array> {
        let tags = self.arrays.iter().find(|array| array.name == TAGS)?;
        let distinct: HashSet<_> = tags.values.iter().filter(|tag| **tag > 0).collect();
        let are_tags = distinct.len() == self.cells.len();
        (are_tags && groups.is_none_or(|groups| groups.name != TAGS)).then_some(tags)
    }

    /// The name of a group: the name of its number in the file; physical numbers are
    /// positive, others become names.
    fn name_of(&self, array: &str, value: i32) -> Option<String> {
        let named = self.names.iter().find_map(|(name, number)| {
            let name = name.strip_prefix(array)?.strip_prefix(' ')?;
            (*number == value).then(|| name.to_owned())
        });
        named.or_else(|| (value < 1).then(|| value.to_string()))
    }
}

impl Listed {
    /// Numbers of its nodes, in the order of the shape.
    fn nodes(&self, kind: u32, shape: Shape, tag: u64) -> Result<Vec<u64>, FileProblem> {
        let points = self.points.iter();
        let mut nodes: Vec<_> = points.map(|point| point.saturating_add(1)).collect();
        if kind == PIXEL && nodes.len() == 4 {
            nodes.swap(2, 3);
        }
        if nodes.len() == shape.node_count() {
            Ok(nodes)
        } else {
            Err(FileProblem::Count {
                what: format!("cell {tag} of type {kind}"),
                found: nodes.len(),
                expected: shape.node_count().to_string(),
            })
        }
    }
}

/// The shape of a type of cells of VTK; `None` for points, which are skipped.
fn shape_of(kind: u32) -> Result<Option<Shape>, FileProblem> {
    Ok(Some(match kind {
        1 | 2 => return Ok(None),
        3 => Shape::Line(LineKind::Line2),
        21 => Shape::Line(LineKind::Line3),
        5 => Shape::Cell(CellKind::Triangle3),
        22 => Shape::Cell(CellKind::Triangle6),
        PIXEL | 9 => Shape::Cell(CellKind::Quadrilateral4),
        23 => Shape::Cell(CellKind::Quadrilateral8),
        28 => Shape::Cell(CellKind::Quadrilateral9),
        other => return Err(FileProblem::Unsupported(other.to_string())),
    }))
}

#[cfg(test)]
mod tests {
    use super::{Array, Grid};

    /// The array of the groups among these, or the problem.
    fn groups(arrays: &[(&str, i32)]) -> String {
        let array = |(name, value): &(&str, i32)| Array {
            name: (*name).to_owned(),
            values: vec![*value, 2],
        };
        let grid = Grid {
            arrays: arrays.iter().map(array).collect(),
            ..Grid::default()
        };
        match grid.groups() {
            Ok(found) => found.map_or_else(String::new, |array| array.name.clone()),
            Err(problem) => problem.to_string(),
        }
    }

    /// Two usual arrays with other values are no groups, unless one is Helicoid's own or `group`.
    #[test]
    fn two_arrays_are_doubtful() {
        let doubt = "2 arrays of whole numbers by cell could be groups: region, MaterialIds";
        let two = [("MaterialIds", 1), ("region", 3)];
        assert_eq!(groups(&two), doubt);
        assert_eq!(groups(&[two[0], two[1], ("group", 4)]), "group");
        assert_eq!(groups(&[two[0], two[1], ("tag", 4)]), "region");
        assert_eq!(groups(&[two[0], ("region", 1)]), "region");
        assert_eq!(groups(&[two[0], ("other", 4)]), "MaterialIds");
        assert_eq!(groups(&[]), "");
    }
}
