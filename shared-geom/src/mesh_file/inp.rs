//! Input files of Abaqus, CalculiX and programs that write them: nodes, plane elements,
//! lines, and sets of elements as groups.
//!
//! Keywords begin with `*`, comments with `**`; data are separated by commas, and a row of
//! an element continues until it has all nodes. `*ELEMENT, ELSET=` and `*ELSET` make groups.
//! Materials, sections, node sets, surfaces and steps are skipped, and so are nodes of the
//! assembly outside of instances, which are reference points.

use std::collections::HashMap;

use super::parts::{Parts, Shape};
use super::problem::{FileProblem, Problems, text};
use super::words::{real, whole};
use crate::error::Diagnostics;
use crate::mesh::{CellKind, GroupForm, LineKind, Mesh};

/// Families of plane elements: the number of nodes follows in their names.
const PLANE: [&str; 12] = [
    "CPS", "CPE", "CPEG", "CAX", "CGAX", "S", "STRI", "M3D", "SFM3D", "DC2D", "WARP2D", "WARPF2D",
];
/// Lines: the number of nodes follows in their names.
const TRUSSES: [&str; 2] = ["T2D", "T3D"];
/// Beams: their order follows in their names, 2 is quadratic, 1 and 3 have two nodes.
const BEAMS: [&str; 2] = ["B2", "B3"];
/// Keywords that make or move nodes and elements, which are not read.
const REFUSED: [&str; 9] = [
    "INCLUDE", "SYSTEM", "NGEN", "NFILL", "NCOPY", "NMAP", "ELGEN", "ELCOPY", "IMPORT",
];

/// Reads the mesh of an input file of Abaqus.
///
/// # Errors
/// All problems of the file, each with its line.
pub(super) fn read(content: &[u8], file: &str) -> Result<Mesh, Diagnostics> {
    let mut reader = Reader::default();
    for (at, line) in text(content, file)?.lines().enumerate() {
        reader.line(at + 1, line.trim());
    }
    reader.finish(file)
}

/// The block of data that is read.
#[derive(Debug, Default)]
enum Block {
    /// A block without a part of the mesh.
    #[default]
    Skipped,
    Nodes,
    /// Elements of a shape, in a set.
    Elements(Shape, Option<usize>),
    /// Members of a set; ranges if `true`.
    Set(usize, bool),
    /// The placement of an instance.
    Instance,
}

/// Rows of a set, resolved when all elements are known.
#[derive(Debug)]
struct Members {
    line: usize,
    set: usize,
    is_range: bool,
    fields: Vec<String>,
}

#[derive(Debug, Default)]
struct Reader {
    parts: Parts,
    problems: Problems,
    /// Sets by their name in lower case.
    sets: HashMap<String, usize>,
    names: Vec<String>,
    block: Block,
    members: Vec<Members>,
    /// The keyword that continues in the next line.
    keyword: String,
    /// The row of an element that continues, and its first line.
    row: (usize, Vec<u64>),
    in_assembly: bool,
    in_instance: bool,
}

impl Reader {
    fn line(&mut self, at: usize, line: &str) {
        if line.is_empty() || line.starts_with("**") {
            return;
        }
        if line.starts_with('*') || !self.keyword.is_empty() {
            self.end_row();
            self.keyword.push_str(line);
            if !line.ends_with(',') {
                let keyword = std::mem::take(&mut self.keyword);
                self.keyword(at, &keyword);
            }
            return;
        }
        let fields: Vec<_> = line.split(',').map(str::trim).collect();
        let fields = match fields.split_last() {
            Some((&"", before)) => before,
            _ => &fields[..],
        };
        match self.block {
            Block::Skipped => {}
            Block::Nodes => self.node(at, fields),
            Block::Elements(shape, set) => self.element(at, fields, (shape, set)),
            Block::Set(set, is_range) => self.members.push(Members {
                line: at,
                set,
                is_range,
                fields: fields.iter().map(|&field| field.to_owned()).collect(),
            }),
            Block::Instance => {
                let is_zero = |field: &&str| real(field, "translation") == Ok(0.0);
                if !fields.iter().all(is_zero) {
                    self.problems.push(at, FileProblem::Moved);
                }
            }
        }
    }

    /// Begins the block of a keyword with its options, `*ELEMENT, TYPE=CPS4, ELSET=skin`.
    fn keyword(&mut self, at: usize, line: &str) {
        let mut fields = line.trim_start_matches('*').split(',').map(str::trim);
        let name = fields.next().unwrap_or_default().to_uppercase();
        let options: Vec<_> = fields
            .map(|field| field.split_once('=').unwrap_or((field, "")))
            .map(|(key, value)| (key.trim().to_uppercase(), value.trim().trim_matches('"')))
            .collect();
        let option = |key: &str| {
            let found = options.iter().find(|option| option.0 == key);
            found.map(|option| option.1)
        };
        if let Some(refused) = REFUSED.iter().find(|refused| **refused == name) {
            self.problems.push(at, FileProblem::Keyword(refused));
        }
        self.block = match name.as_str() {
            "NODE" if option("SYSTEM").is_some_and(|system| !system.eq_ignore_ascii_case("R")) => {
                self.problems
                    .push(at, FileProblem::Keyword("NODE, SYSTEM="));
                Block::Skipped
            }
            "NODE" if self.in_assembly && !self.in_instance => Block::Skipped,
            "NODE" => Block::Nodes,
            "ELEMENT" => {
                let set = option("ELSET").map(|name| self.set(name));
                let kind = option("TYPE").unwrap_or_default().to_uppercase();
                match shape_of(&kind) {
                    Some(shape) => Block::Elements(shape, set),
                    None => {
                        self.problems.push(at, FileProblem::Unsupported(kind));
                        Block::Skipped
                    }
                }
            }
            "ELSET" => match option("ELSET") {
                Some(name) => Block::Set(self.set(name), option("GENERATE").is_some()),
                None => Block::Skipped,
            },
            "INSTANCE" => Block::Instance,
            _ => Block::Skipped,
        };
        match name.as_str() {
            "ASSEMBLY" => self.in_assembly = true,
            "END ASSEMBLY" => self.in_assembly = false,
            "INSTANCE" => self.in_instance = true,
            "END INSTANCE" => self.in_instance = false,
            _ => {}
        }
    }

    /// Index of the set called `name`, which is made if it does not exist.
    fn set(&mut self, name: &str) -> usize {
        if let Some(&set) = self.sets.get(&name.to_lowercase()) {
            return set;
        }
        let set = self.parts.set(Some(name.to_owned()), None);
        self.sets.insert(name.to_lowercase(), set);
        self.names.push(name.to_owned());
        set
    }

    /// Reads `12, 0.5, 1.0, 0.0`; absent coordinates are zero.
    fn node(&mut self, at: usize, fields: &[&str]) {
        let node = node_of(fields).and_then(|(tag, position)| self.parts.node(tag, position));
        self.problems.keep(at, node);
    }

    /// Reads a row `7, 1, 2, 5, 4` or a part of it.
    fn element(&mut self, at: usize, fields: &[&str], (shape, set): (Shape, Option<usize>)) {
        if self.row.1.is_empty() {
            self.row.0 = at;
        }
        for field in fields {
            let Some(number) = self.problems.keep(at, whole(field, "the number of a node")) else {
                // the rest of the row would be one of another element
                self.row.1.clear();
                return;
            };
            self.row.1.push(number);
        }
        let needed = 1 + shape.node_count();
        if self.row.1.len() < needed {
            return;
        }
        let (line, row) = std::mem::take(&mut self.row);
        let (tag, nodes) = (row[0], row[1..].to_vec());
        let added = if row.len() == needed {
            self.parts.element((line, tag), shape, nodes, set)
        } else {
            Err(row_length(&row, shape))
        };
        self.problems.keep(line, added);
    }

    /// Notes an element whose row ends too early.
    fn end_row(&mut self) {
        let (line, row) = std::mem::take(&mut self.row);
        if let (Block::Elements(shape, _), false) = (&self.block, row.is_empty()) {
            self.problems.push(line, row_length(&row, *shape));
        }
    }

    /// Adds the members of a row of a set.
    fn assign(&mut self, row: &Members) -> Result<(), FileProblem> {
        let name = self.names.get(row.set).cloned().unwrap_or_default();
        if row.is_range {
            let numbers = row
                .fields
                .iter()
                .map(|field| whole(field, "a range of elements"));
            let numbers: Vec<u64> = numbers.collect::<Result<_, _>>()?;
            let (first, last, step) = match numbers[..] {
                [first, last] => (first, last, 1),
                [first, last, step] if step > 0 => (first, last, step),
                _ => {
                    return Err(FileProblem::Count {
                        what: format!("the range of set \"{name}\""),
                        found: numbers.len(),
                        expected: "first, last and step".to_owned(),
                    });
                }
            };
            self.parts.assign_range((first, last, step), row.set);
            return Ok(());
        }
        for field in row.fields.iter().filter(|field| !field.is_empty()) {
            if let Ok(element) = field.parse() {
                if !self.parts.assign(element, row.set) {
                    return Err(FileProblem::UnknownElement { set: name, element });
                }
                continue;
            }
            let of = field.trim_matches('"').to_lowercase();
            let Some(&other) = self.sets.get(&of) else {
                let found = field.clone();
                return Err(FileProblem::UnknownSet { set: name, found });
            };
            for element in self.parts.members(other) {
                self.parts.assign(element, row.set);
            }
        }
        Ok(())
    }

    fn finish(mut self, file: &str) -> Result<Mesh, Diagnostics> {
        self.end_row();
        for row in std::mem::take(&mut self.members) {
            let assigned = self.assign(&row);
            self.problems.keep(row.line, assigned);
        }
        if self.parts.node_count() == 0 {
            self.problems
                .push(1, FileProblem::CutOff("the first *NODE"));
        }
        let mut mesh = self.parts.finish(&mut self.problems);
        mesh.group_form = GroupForm::Sets;
        self.problems.into_result(file, mesh)
    }
}

/// The number and the coordinates of a node.
fn node_of(fields: &[&str]) -> Result<(u64, [f64; 3]), FileProblem> {
    let (tag, positions) = fields.split_first().ok_or(FileProblem::CutOff("a node"))?;
    let tag: u64 = whole(tag, "the number of a node")?;
    if !(2..=3).contains(&positions.len()) {
        return Err(FileProblem::Count {
            what: format!("node {tag}"),
            found: fields.len(),
            expected: "its number and 2 or 3 coordinates".to_owned(),
        });
    }
    let mut position = [0.0; 3];
    for (axis, point) in positions.iter().enumerate() {
        position[axis] = match *point {
            "" => 0.0,
            point => real(point, "coordinate")?,
        };
    }
    Ok((tag, position))
}

/// A row of an element with the wrong number of nodes.
fn row_length(row: &[u64], shape: Shape) -> FileProblem {
    FileProblem::Count {
        what: format!("element {}", row.first().copied().unwrap_or_default()),
        found: row.len(),
        expected: format!("its number and {} nodes", shape.node_count()),
    }
}

/// The shape of an element of Abaqus by the name of its type, in capitals.
fn shape_of(kind: &str) -> Option<Shape> {
    let digit = |families: &[&str]| {
        let rests = families
            .iter()
            .filter_map(|family| kind.strip_prefix(family));
        rests
            .filter_map(|rest| rest.chars().next()?.to_digit(10))
            .next()
    };
    let cell = match digit(&PLANE) {
        Some(3) => Some(CellKind::Triangle3),
        Some(4) => Some(CellKind::Quadrilateral4),
        Some(6) => Some(CellKind::Triangle6),
        Some(8) => Some(CellKind::Quadrilateral8),
        Some(9) => Some(CellKind::Quadrilateral9),
        _ => None,
    };
    let line = match (digit(&TRUSSES), digit(&BEAMS)) {
        (Some(2), _) | (None, Some(1 | 3)) => Some(LineKind::Line2),
        (Some(3), _) | (None, Some(2)) => Some(LineKind::Line3),
        _ => None,
    };
    cell.map(Shape::Cell).or(line.map(Shape::Line))
}
