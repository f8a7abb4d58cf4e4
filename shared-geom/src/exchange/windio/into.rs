//! Writes a blade into a copy of a windIO file: its reference axis, its twist and its
//! elastic properties. All other lines stay as they are, so that a complete file stays complete:
//! the validator of windIO 2.1.1 accepts copies of its examples with other blades. Tables in the
//! flow style around a replaced one are written as blocks, with their entries as they are.

use std::ops::Range;
use std::path::{Path, PathBuf};

use super::super::plain::Plain;
use super::super::problem::{ExchangeProblem, Problems};
use super::super::{Options, Writing};
use super::block::{self, Block, Lines};
use super::write;
use super::{VERSION_1, is_version_1};
use super::{anchors, flow};
use crate::blade::Blade;
use crate::error::{Diagnostics, shortened};

/// The reference axis of version 2.
const AXIS: [&str; 3] = ["components", "blade", "reference_axis"];
/// The twist of version 2.
const TWIST: [&str; 4] = ["components", "blade", "outer_shape", "twist"];
/// The elastic properties of version 2.
const ELASTIC: [&str; 4] = ["components", "blade", "structure", "elastic_properties"];

/// A file with the text of `existing`, the content of the file at `path`, in which the axis
/// and the elastic properties of `blade` replace its own.
///
/// # Errors
/// A text that is not a windIO file, or whose tables are not where they can be replaced.
pub(in crate::exchange) fn write_into(
    blade: &Blade,
    existing: &str,
    path: &Path,
) -> Result<Writing, Diagnostics> {
    let mut problems = Problems::new(&path.display().to_string());
    if !super::recognize(existing) {
        problems.push(0, &not_windio());
        return Err(problems.into_diagnostics());
    }
    let plain = Plain::of(blade);
    let mut editor = Editor {
        // Ends of lines stay as they are.
        lines: existing.split('\n').map(str::to_owned).collect(),
        problems,
    };
    let mut lost = plain.lost.clone();
    if is_version_1(existing) {
        version_1(&mut editor, blade, &plain, &mut lost)
    } else {
        version_2(&mut editor, blade, &plain, &mut lost)
    }
    let Editor { lines, problems } = editor;
    let text = problems.finish(Some(lines))?.join("\n");
    // The written text must be readable.
    super::read(&text, path, &Options::default())?;
    let name = path.file_name().map_or_else(PathBuf::new, PathBuf::from);
    Ok(Writing {
        files: vec![(name, text)],
        lost,
    })
}

fn not_windio() -> ExchangeProblem {
    ExchangeProblem::Other {
        what: "the file to write into".to_owned(),
        found: "another format".to_owned(),
        expected: "a windIO file with components.blade".to_owned(),
        help: "give a complete windIO file with --into".to_owned(),
    }
}

/// Version 1 has axis, twist and matrices in one table.
fn version_1(editor: &mut Editor, blade: &Blade, plain: &Plain, lost: &mut Vec<String>) {
    let keys = [VERSION_1[0], VERSION_1[1], VERSION_1[2], "six_x_six"];
    editor.replace_or_add(&VERSION_1, |_| Vec::new());
    editor.replace_or_add(&keys, |margin| write::six_by_six(plain, margin));
    lost.extend(write::lost_damping(blade));
    lost.push(
        "the reference axis and the twist of outer_shape_bem: they stay as they are".to_owned(),
    );
}

/// Version 2 has axis, twist and matrices in three tables.
fn version_2(editor: &mut Editor, blade: &Blade, plain: &Plain, lost: &mut Vec<String>) {
    editor.replace(&AXIS, |margin| write::axis_columns(plain, margin));
    // The sections are in axes that the twist turns; a grid of its own would add points.
    editor.replace(&TWIST, |margin| write::twist_columns(plain, margin));
    editor.replace_or_add(&ELASTIC, |_| Vec::new());
    for (key, lines) in write::elastic_tables(blade, plain, lost) {
        let keys = [&ELASTIC[..], &[key]].concat();
        editor.replace_or_add(&keys, |margin| write::indented(&lines, margin));
    }
    let masses = [&ELASTIC[..], &["point_mass"]].concat();
    if editor.find(&masses).is_ok() {
        lost.push("point_mass of the existing file: it stays as it is".to_owned());
    }
}

/// The lines of the file, and the problems of its tables.
struct Editor {
    lines: Lines,
    problems: Problems,
}

impl Editor {
    /// Replaces the content of an existing table by the lines for a margin.
    fn replace(&mut self, keys: &[&str], content: impl Fn(&str) -> Vec<String>) {
        match self.find(keys) {
            Ok(block) => self.fill(block, keys, content),
            Err(found) => self.missing(keys, found),
        }
    }

    /// The block under `keys`. Tables in the flow style on the way to it become blocks.
    fn find(&mut self, keys: &[&str]) -> Result<Block, usize> {
        loop {
            match block::find(&self.lines, keys) {
                Err(found) if self.open(&keys[..found]) => {}
                found => return found,
            }
        }
    }

    /// Writes the table under `keys` as a block, its entries on lines of their own, if it is in
    /// the flow style.
    fn open(&mut self, keys: &[&str]) -> bool {
        let Ok(block) = block::find(&self.lines, keys) else {
            return false;
        };
        let start = block::value_at(&self.lines[block.key]);
        let Some((end, table)) = flow::value(&self.lines, (block.key, start)) else {
            return false;
        };
        let Some(entries) = flow::entries(&table) else {
            return false;
        };
        let body = self.cut(&block, start, end);
        let margin = " ".repeat(block.indent + block::USUAL);
        let entries = entries.iter().map(|entry| format!("{margin}{entry}"));
        self.lines.splice(body, entries);
        true
    }

    /// Removes the value of a block from the byte `start` of its key to `end`; a comment after it
    /// stays. Returns the lines below the key that were a part of it.
    fn cut(&mut self, block: &Block, start: usize, end: flow::At) -> Range<usize> {
        let comment = self.lines[end.0][end.1..].trim().to_owned();
        let line = &mut self.lines[block.key];
        line.truncate(start);
        line.truncate(line.trim_end().len());
        if !comment.is_empty() {
            line.push(' ');
            line.push_str(&comment);
        }
        block.key + 1..block.body.end.max(end.0 + 1)
    }

    /// As [`Editor::replace`]; a missing table is added at the end of its parent. Keeps
    /// the entries of a table for which there is no content.
    fn replace_or_add(&mut self, keys: &[&str], content: impl Fn(&str) -> Vec<String>) {
        let found = match self.find(keys) {
            Ok(_) if content("").is_empty() && self.open(keys) => return,
            Ok(block) if content("").is_empty() => {
                let start = block::value_at(&self.lines[block.key]);
                let is_alias = self.lines[block.key][start..].starts_with('*');
                match self.word(&block, start).filter(|_| !is_alias) {
                    Some(end) => drop(self.cut(&block, start, end)),
                    None => drop(self.check_inline(&block, keys)),
                }
                return;
            }
            Ok(block) => return self.fill(block, keys, content),
            Err(found) => found,
        };
        let Some((key, parents)) = keys.split_last().filter(|_| found + 1 == keys.len()) else {
            return self.missing(keys, found);
        };
        let Ok(parent) = block::find(&self.lines, parents) else {
            return self.missing(keys, found);
        };
        let depth = block::depth(&self.lines, &parent);
        let at = parent.body.end;
        self.lines
            .insert(at, format!("{}{key}:", " ".repeat(depth)));
        let added = Block {
            key: at,
            indent: depth,
            body: at + 1..at + 1,
        };
        self.fill(added, keys, content);
    }

    /// Replaces the content of a block.
    fn fill(&mut self, mut block: Block, keys: &[&str], content: impl Fn(&str) -> Vec<String>) {
        let start = block::value_at(&self.lines[block.key]);
        let value = flow::value(&self.lines, (block.key, start));
        let end = value
            .map(|(end, _)| end)
            .or_else(|| self.word(&block, start));
        let last = end.map_or(block.body.end, |end| block.body.end.max(end.0 + 1));
        if let Err(name) = anchors::rescue(&mut self.lines, &(block.key..last), start) {
            let problem = ExchangeProblem::Other {
                what: keys.join("."),
                found: format!("the anchor &{name}, to which other tables refer"),
                expected: "a table that only its own key refers to".to_owned(),
                help: format!("write the value instead of *{name} there"),
            };
            return self.problems.push(block.key + 1, &problem);
        }
        let mut depth = block.indent + block::USUAL;
        match end {
            Some(end) => block.body = self.cut(&block, start, end),
            None if !self.check_inline(&block, keys) => return,
            None => depth = block::depth(&self.lines, &block).max(block.indent + 1),
        }
        self.lines.splice(block.body, content(&" ".repeat(depth)));
    }

    /// The end of an alias, or of the absence of a value, in place of a table.
    fn word(&self, block: &Block, start: usize) -> Option<flow::At> {
        let value = block::inline_value(&self.lines[block.key]);
        let word = value.split_whitespace().next()?;
        let is_replaced = word.starts_with('*') || ["~", "null", "Null", "NULL"].contains(&word);
        is_replaced.then_some((block.key, start + word.len()))
    }

    /// Whether the value of a block begins below its key; notes other values.
    fn check_inline(&mut self, block: &Block, keys: &[&str]) -> bool {
        let value = block::inline_value(&self.lines[block.key]);
        if value.is_empty() {
            return true;
        }
        let problem = ExchangeProblem::Other {
            what: keys.join("."),
            found: format!("\"{}\" on the line of the key", shortened(value)),
            expected: "a table on the lines below the key".to_owned(),
            help: "write the table as a block".to_owned(),
        };
        self.problems.push(block.key + 1, &problem);
        false
    }

    /// Notes that a table is missing after `found` keys.
    fn missing(&mut self, keys: &[&str], found: usize) {
        let (parents, rest) = keys.split_at(found.min(keys.len()));
        let at = block::find(&self.lines, parents).map_or(0, |block| block.key + 1);
        let problem = ExchangeProblem::Missing {
            what: format!("the table {} of the file to write into", keys.join(".")),
            help: format!("add {}", rest.join(".")),
        };
        self.problems.push(at, &problem);
    }
}
