//! Unstructured grids in the legacy text format of VTK, versions 1 to 5; see [`super::grid`]
//! for the groups.

use super::grid::{Array, Grid, Listed};
use super::problem::{FileProblem, Problems, text};
use super::words::{Words, whole};
use crate::error::Diagnostics;
use crate::mesh::Mesh;

/// Largest number of values that are reserved before they are read.
const RESERVED: usize = 1 << 20;

/// A line of the head of the file: its expected text, and the test of a line.
type HeadLine = (&'static str, fn(&str) -> bool);

/// Reads the mesh of a legacy file of VTK.
///
/// # Errors
/// All problems of the file, each with its line.
pub(super) fn read(content: &[u8], file: &str) -> Result<Mesh, Diagnostics> {
    let head = content.get(..content.len().min(1024)).unwrap_or_default();
    let mut problems = Problems::default();
    if is_binary(head) {
        let problem = FileProblem::Header {
            found: "the file is BINARY".to_owned(),
            expected: "ASCII",
        };
        problems.push(3, problem);
        return problems.into_result(file, Mesh::default());
    }
    let mut reader = Reader {
        words: Words::new(text(content, file)?),
        grid: Grid::default(),
    };
    let read = reader.sections();
    let line = reader.words.line();
    problems.keep(line, read);
    let mesh = reader.grid.finish(line, &mut problems);
    problems.into_result(file, mesh)
}

/// Whether the third line of a file has the word `BINARY`.
fn is_binary(head: &[u8]) -> bool {
    let line = head.split(|&byte| byte == b'\n').nth(2);
    line.is_some_and(|line| line.trim_ascii().eq_ignore_ascii_case(b"BINARY"))
}

struct Reader<'a> {
    words: Words<'a>,
    grid: Grid,
}

impl Reader<'_> {
    /// Reads all sections; the first problem ends the reading, as later words have no
    /// meaning without the earlier ones.
    fn sections(&mut self) -> Result<(), FileProblem> {
        let head: [HeadLine; 3] = [
            ("# vtk DataFile Version", is_version),
            ("a title", |_| true),
            ("ASCII", |line| line.eq_ignore_ascii_case("ASCII")),
        ];
        for (expected, is_good) in head {
            let line = self
                .words
                .next_line()
                .ok_or(FileProblem::CutOff(expected))?;
            if !is_good(line) {
                let found = format!("\"{}\"", line.chars().take(40).collect::<String>());
                return Err(FileProblem::Header { found, expected });
            }
        }
        let mut of_cells = false;
        while let Some(word) = self.words.word() {
            match word.to_uppercase().as_str() {
                "DATASET" => self.dataset()?,
                "POINTS" => self.read_points()?,
                "CELLS" => self.read_cells()?,
                "CELL_TYPES" => {
                    let count: usize = self.words.number("the number of types")?;
                    for _ in 0..count {
                        let kind = self.words.number("the type of a cell")?;
                        self.grid.types.push((self.words.line(), kind));
                    }
                }
                "CELL_DATA" => {
                    of_cells = true;
                    self.words.number::<usize>("the number of cells")?;
                }
                "POINT_DATA" => {
                    of_cells = false;
                    self.words.number::<usize>("the number of points")?;
                }
                "SCALARS" => self.scalars(of_cells)?,
                "FIELD" => self.field(of_cells)?,
                "VECTORS" | "NORMALS" => self.skip_named(3, of_cells)?,
                "TENSORS" => self.skip_named(9, of_cells)?,
                // metadata of newer versions, to the end of the line
                _ => {
                    self.words.next_line();
                }
            }
        }
        Ok(())
    }

    fn dataset(&mut self) -> Result<(), FileProblem> {
        let found = self.words.word().unwrap_or_default();
        if found.eq_ignore_ascii_case("UNSTRUCTURED_GRID") {
            Ok(())
        } else {
            Err(FileProblem::Header {
                found: format!("the data are \"{found}\""),
                expected: "UNSTRUCTURED_GRID",
            })
        }
    }

    fn read_points(&mut self) -> Result<(), FileProblem> {
        let count: usize = self.words.number("the number of points")?;
        self.words.word();
        self.grid.points.reserve(count.min(RESERVED));
        for _ in 0..count {
            let mut position = [0.0; 3];
            for point in &mut position {
                *point = self.words.real("coordinate")?;
            }
            self.grid.points.push((self.words.line(), position));
        }
        Ok(())
    }

    /// Reads the cells: `n i j k` each; from version 5 on as offsets and a list of points.
    fn read_cells(&mut self) -> Result<(), FileProblem> {
        let count: usize = self.words.number("the number of cells")?;
        let size: usize = self.words.number("the size of the list of cells")?;
        let first = self
            .words
            .word()
            .ok_or(FileProblem::CutOff("the first cell"))?;
        if first.eq_ignore_ascii_case("OFFSETS") {
            return self.read_offsets(count, size);
        }
        let mut length = whole::<usize>(first, "the number of points of a cell")?;
        for cell in 0..count {
            if cell > 0 {
                length = self.words.number("the number of points of a cell")?;
            }
            let line = self.words.line();
            let mut points = Vec::new();
            for _ in 0..length {
                points.push(self.words.number("a point of a cell")?);
            }
            self.grid.cells.push(Listed { line, points });
        }
        Ok(())
    }

    fn read_offsets(&mut self, offsets: usize, size: usize) -> Result<(), FileProblem> {
        self.words.word();
        let mut ends = Vec::new();
        for _ in 0..offsets {
            ends.push(self.words.number::<usize>("an offset")?);
        }
        let word = self.words.word().unwrap_or_default();
        if !word.eq_ignore_ascii_case("CONNECTIVITY") {
            return Err(FileProblem::Header {
                found: format!("\"{word}\" after the offsets"),
                expected: "CONNECTIVITY",
            });
        }
        self.words.word();
        let line = self.words.line();
        let mut all = Vec::new();
        for _ in 0..size {
            all.push(self.words.number::<u64>("a point of a cell")?);
        }
        for pair in ends.windows(2) {
            let points = all.get(pair[0]..pair[1]).ok_or(FileProblem::Length {
                what: "the list of points",
                found: size,
                expected: pair[1],
            })?;
            let points = points.to_vec();
            self.grid.cells.push(Listed { line, points });
        }
        Ok(())
    }

    /// Reads `SCALARS name type [components]`, the table of colors and the values.
    fn scalars(&mut self, of_cells: bool) -> Result<(), FileProblem> {
        let name = self.words.word().unwrap_or_default().to_owned();
        self.words.word();
        let next = self.words.word().ok_or(FileProblem::CutOff("the values"))?;
        let components = if next.eq_ignore_ascii_case("LOOKUP_TABLE") {
            1
        } else {
            let components = whole::<usize>(next, "the number of components")?;
            self.words.word();
            components
        };
        self.words.word();
        let count = self.count(of_cells);
        self.values((name.as_str(), of_cells), components, count)
    }

    /// Reads `FIELD name n`, then `name components values type` and the values, n times.
    fn field(&mut self, of_cells: bool) -> Result<(), FileProblem> {
        self.words.word();
        let arrays: usize = self.words.number("the number of arrays")?;
        let mut read = 0;
        while read < arrays {
            let name = self.words.word().ok_or(FileProblem::CutOff("an array"))?;
            if name.eq_ignore_ascii_case("METADATA") {
                while self.words.next_line().is_some_and(|line| !line.is_empty()) {}
                continue;
            }
            let components = self.words.number("the number of components")?;
            let count = self.words.number("the number of values")?;
            let kind = self.words.word().unwrap_or_default();
            if kind.eq_ignore_ascii_case("string") {
                for _ in 0..count {
                    if self.words.next_line().is_none() {
                        break;
                    }
                }
            } else {
                self.values(
                    (name, of_cells && count == self.grid.cells.len()),
                    components,
                    count,
                )?;
            }
            read += 1;
        }
        Ok(())
    }

    fn skip_named(&mut self, components: usize, of_cells: bool) -> Result<(), FileProblem> {
        self.words.word();
        self.words.word();
        let count = self.count(of_cells);
        self.values(("", false), components, count)
    }

    /// Number of values of an array by cell or by point.
    fn count(&self, of_cells: bool) -> usize {
        if of_cells {
            self.grid.cells.len()
        } else {
            self.grid.points.len()
        }
    }

    /// Reads the values of an array; one of whole numbers by cell is kept.
    fn values(
        &mut self,
        (name, of_cells): (&str, bool),
        components: usize,
        count: usize,
    ) -> Result<(), FileProblem> {
        let mut values = Vec::new();
        let is_kept = of_cells && components == 1;
        for _ in 0..components.saturating_mul(count) {
            let value = self.words.real("a value")?;
            if is_kept {
                values.push(value);
            }
        }
        let values = is_kept.then(|| Grid::whole(values.into_iter()));
        if let Some(values) = values.flatten() {
            let name = name.to_owned();
            self.grid.arrays.push(Array { name, values });
        }
        Ok(())
    }
}

fn is_version(line: &str) -> bool {
    line.to_lowercase().starts_with("# vtk datafile version")
}
