//! Unstructured grids in the XML format of VTK, `.vtu`, as ParaView, meshio and Helicoid
//! write them: arrays as text or base 64 in place, or appended, raw or as base 64, also
//! compressed with zlib; see [`super::grid`] for the groups.
//!
//! # References
//! - Layout of files, arrays and compressed blocks: "VTK XML formats", documentation of VTK
//!   9; checked by files of VTK and of meshio.

use super::grid::{Array, Grid, Listed};
use super::problem::{FileProblem, Problems};
use crate::error::Diagnostics;
use crate::mesh::Mesh;
use data::{Content, Encoded, Encoding};
use xml::{Element, Elements};

mod data;
mod xml;

/// Whether the file is one of VTK's XML format, by its beginning or its name.
pub(super) fn recognize(content: &[u8], file: &str) -> bool {
    let head = content.trim_ascii_start();
    let is_xml = head.starts_with(b"<?xml") || head.starts_with(b"<VTKFile");
    is_xml || file.to_lowercase().ends_with(super::VTU)
}

/// Reads the mesh of an XML file of VTK.
///
/// # Errors
/// All problems of the file, each with its line.
pub(super) fn read(content: &[u8], file: &str) -> Result<Mesh, Diagnostics> {
    let mut reader = Reader::new(content);
    let mut problems = Problems::default();
    let read = reader.arrays();
    let line = reader.elements.line();
    let grid = problems.keep(line, read).and_then(|()| {
        let grid = reader.grid();
        grid.map_err(|(line, problem)| problems.push(line, problem))
            .ok()
    });
    let mesh = grid.map(|grid| grid.finish(1, &mut problems));
    problems.into_result(file, mesh.unwrap_or_default())
}

/// Reads arrays of values at the points of an XML file of VTK, by their names.
///
/// # Errors
/// All problems of these arrays, each with its line.
pub(super) fn read_point_values(
    content: &[u8],
    file: &str,
    names: &[String],
) -> Result<Vec<Vec<f64>>, Diagnostics> {
    let mut reader = Reader {
        has_point_data: true,
        ..Reader::new(content)
    };
    let mut problems = Problems::default();
    let read = reader.arrays();
    let line = reader.elements.line();
    let found = problems.keep(line, read).map(|()| {
        let found = names.iter().map(|name| {
            let values = reader.point_values(name);
            let values = values.map_err(|(line, problem)| problems.push(line, problem));
            values.unwrap_or_default()
        });
        found.collect()
    });
    problems.into_result(file, found.unwrap_or_default())
}

/// Section of the file that contains an array.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Section {
    Points,
    Cells,
    PointData,
    CellData,
    FieldData,
}

/// An array of the file, not decoded.
#[derive(Debug)]
struct Described<'a> {
    section: Section,
    /// The piece of the grid, from one.
    piece: usize,
    name: String,
    components: usize,
    encoded: Encoded<'a>,
}

struct Reader<'a> {
    elements: Elements<'a>,
    encoding: Encoding<'a>,
    /// Names of the open elements.
    inside: Vec<String>,
    pieces: usize,
    arrays: Vec<Described<'a>>,
    /// Whether arrays at the points are kept.
    has_point_data: bool,
}

impl<'a> Reader<'a> {
    fn new(content: &'a [u8]) -> Self {
        Self {
            elements: Elements::new(content),
            encoding: Encoding::default(),
            inside: Vec::new(),
            pieces: 0,
            arrays: Vec::new(),
            has_point_data: false,
        }
    }

    /// Reads the descriptions of all arrays, and where the appended data begin.
    fn arrays(&mut self) -> Result<(), FileProblem> {
        while let Some(element) = self.elements.next()? {
            if element.is_end {
                self.inside.pop();
                continue;
            }
            match element.name.as_str() {
                "VTKFile" => self.head(&element)?,
                "Piece" => self.pieces += 1,
                "DataArray" => self.array(&element)?,
                "AppendedData" => {
                    let is_raw = element.get("encoding") == Some("raw");
                    self.encoding.appended = self.elements.appended(is_raw)?;
                    return Ok(());
                }
                _ => {}
            }
            if !element.is_empty {
                self.inside.push(element.name);
            }
        }
        match self.pieces {
            0 => Err(FileProblem::CutOff("the first Piece")),
            _ => Ok(()),
        }
    }

    /// Reads the attributes of the file.
    fn head(&mut self, element: &Element) -> Result<(), FileProblem> {
        let found = element.get("type").unwrap_or("absent");
        if found != "UnstructuredGrid" {
            return Err(FileProblem::Header {
                found: format!("the data are \"{found}\""),
                expected: "UnstructuredGrid",
            });
        }
        self.encoding.is_big_endian = element.get("byte_order") == Some("BigEndian");
        self.encoding.is_wide = element.get("header_type") == Some("UInt64");
        self.encoding.is_compressed = match element.get("compressor") {
            None | Some("") => false,
            Some("vtkZLibDataCompressor") => true,
            Some(other) => {
                return Err(FileProblem::Header {
                    found: format!("the arrays are compressed by {other}"),
                    expected: "vtkZLibDataCompressor or none",
                });
            }
        };
        Ok(())
    }

    /// Keeps the description of an array that the mesh needs.
    fn array(&mut self, element: &Element) -> Result<(), FileProblem> {
        let line = self.elements.line();
        let content = if element.is_empty {
            &[][..]
        } else {
            self.elements.text()
        };
        let section = match self.inside.last().map(String::as_str) {
            Some("Points") => Section::Points,
            Some("Cells") => Section::Cells,
            Some("PointData") if self.has_point_data => Section::PointData,
            Some("CellData") => Section::CellData,
            Some("FieldData") => Section::FieldData,
            _ => return Ok(()),
        };
        let number = |key: &'static str| -> Result<Option<usize>, FileProblem> {
            let found = element.get(key);
            found.map(|word| super::words::whole(word, key)).transpose()
        };
        let content = match element.get("format") {
            None | Some("ascii") => Content::Text(content),
            Some("binary") => Content::Base64(content),
            Some("appended") => {
                Content::Appended(number("offset")?.ok_or(FileProblem::Header {
                    found: "an appended array without \"offset\"".to_owned(),
                    expected: "its position in the appended data",
                })?)
            }
            Some(other) => {
                return Err(FileProblem::Header {
                    found: format!("an array has the format \"{other}\""),
                    expected: "ascii, binary or appended",
                });
            }
        };
        self.arrays.push(Described {
            section,
            piece: self.pieces,
            name: element.get("Name").unwrap_or_default().to_owned(),
            components: number("NumberOfComponents")?.unwrap_or(1),
            encoded: Encoded {
                line,
                kind: element.get("type").unwrap_or_default().to_owned(),
                content,
            },
        });
        Ok(())
    }

    /// The values of an array.
    fn values(&self, array: &Described<'a>) -> Result<Vec<f64>, (usize, FileProblem)> {
        let ends = self
            .arrays
            .iter()
            .filter_map(|other| other.encoded.offset());
        let values = self.encoding.values(&array.encoded, ends);
        values.map_err(|problem| (array.encoded.line, problem))
    }

    /// The values of all pieces of an array at the points.
    fn point_values(&self, name: &str) -> Result<Vec<f64>, (usize, FileProblem)> {
        let arrays = self.arrays.iter();
        let mut own = arrays
            .filter(|array| array.section == Section::PointData && array.name == name)
            .peekable();
        if own.peek().is_none() {
            let problem = FileProblem::Header {
                found: format!("the points have no array \"{name}\""),
                expected: "a field file of this program",
            };
            return Err((1, problem));
        }
        let pieces = own.map(|array| self.values(array));
        Ok(pieces.collect::<Result<Vec<_>, _>>()?.concat())
    }

    /// The grid of all pieces.
    fn grid(&self) -> Result<Grid, (usize, FileProblem)> {
        let mut grid = Grid::default();
        for piece in 1..=self.pieces {
            let (points, cells) = (grid.points.len(), grid.cells.len());
            self.points(piece, &mut grid)?;
            self.cells((piece, points), &mut grid)?;
            self.data((piece, cells), &mut grid)?;
        }
        let cells = grid.cells.len();
        grid.arrays.retain(|array| array.values.len() == cells);
        let fields = self.arrays.iter();
        for field in fields.filter(|array| array.section == Section::FieldData) {
            if let Ok([number]) = self.values(field).as_deref()
                && let Some([number]) = Grid::whole([*number].into_iter()).as_deref()
            {
                grid.names.push((field.name.clone(), *number));
            }
        }
        Ok(grid)
    }

    /// The arrays of a section of a piece.
    fn of(&self, section: Section, piece: usize) -> impl Iterator<Item = &Described<'a>> {
        let is_of = move |array: &&Described| array.section == section && array.piece == piece;
        self.arrays.iter().filter(is_of)
    }

    /// Adds the points of a piece.
    fn points(&self, piece: usize, grid: &mut Grid) -> Result<(), (usize, FileProblem)> {
        let Some(array) = self.of(Section::Points, piece).next() else {
            return Ok(());
        };
        let line = array.encoded.line;
        let values = self.values(array)?;
        if let Some(bad) = values.iter().find(|value| !value.is_finite()) {
            let problem = FileProblem::Field {
                what: "coordinate",
                found: bad.to_string(),
                expected: "a finite number",
            };
            return Err((line, problem));
        }
        let positions = values.chunks_exact(3);
        if array.components != 3 || !positions.remainder().is_empty() {
            let problem = FileProblem::Header {
                found: format!(
                    "{} coordinates with {} components",
                    values.len(),
                    array.components
                ),
                expected: "three for each point",
            };
            return Err((line, problem));
        }
        grid.points
            .extend(positions.map(|position| (line, [position[0], position[1], position[2]])));
        Ok(())
    }

    /// Adds the cells of a piece, whose points begin at `base`.
    fn cells(
        &self,
        (piece, base): (usize, usize),
        grid: &mut Grid,
    ) -> Result<(), (usize, FileProblem)> {
        let list = |name: &'static str| {
            let array = self
                .of(Section::Cells, piece)
                .find(|array| array.name == name);
            let array = array.ok_or((1, FileProblem::CutOff(name)))?;
            let line = array.encoded.line;
            let to_index = |value: f64| {
                let is_index = value >= 0.0 && value.fract() == 0.0 && value < 2.0_f64.powi(53);
                is_index.then_some(value as u64).ok_or_else(|| {
                    let problem = FileProblem::Field {
                        what: name,
                        found: value.to_string(),
                        expected: "a whole number that is not negative",
                    };
                    (line, problem)
                })
            };
            let values = self.values(array)?.into_iter().map(to_index);
            Ok((line, values.collect::<Result<Vec<_>, _>>()?))
        };
        if self.of(Section::Cells, piece).next().is_none() {
            return Ok(());
        }
        let (line, points) = list("connectivity")?;
        let (_, ends) = list("offsets")?;
        let (at, types) = list("types")?;
        let mut first = 0;
        for end in ends {
            let range = first..usize::try_from(end).unwrap_or(usize::MAX);
            let of_cell = points.get(range).ok_or_else(|| {
                let problem = FileProblem::Length {
                    what: "the list of points",
                    found: points.len(),
                    expected: usize::try_from(end).unwrap_or(usize::MAX),
                };
                (line, problem)
            })?;
            let of_cell = of_cell.iter().map(|point| point + base as u64);
            let points = of_cell.collect();
            grid.cells.push(Listed { line, points });
            first = usize::try_from(end).unwrap_or(usize::MAX);
        }
        let types = types.into_iter();
        grid.types
            .extend(types.map(|kind| (at, u32::try_from(kind).unwrap_or(u32::MAX))));
        Ok(())
    }

    /// Adds the arrays of whole numbers by cell of a piece, whose cells begin at `base`.
    fn data(
        &self,
        (piece, base): (usize, usize),
        grid: &mut Grid,
    ) -> Result<(), (usize, FileProblem)> {
        let arrays = self.of(Section::CellData, piece);
        for array in arrays.filter(|array| array.components == 1) {
            if array.encoded.kind == "String" {
                continue;
            }
            let Some(values) = Grid::whole(self.values(array)?.into_iter()) else {
                continue;
            };
            let known = grid
                .arrays
                .iter_mut()
                .find(|known| known.name == array.name);
            match known {
                Some(known) if known.values.len() == base => known.values.extend(values),
                None if base == 0 => grid.arrays.push(Array {
                    name: array.name.clone(),
                    values,
                }),
                _ => {}
            }
        }
        Ok(())
    }
}
