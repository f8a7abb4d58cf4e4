//! Full-field files of TurbSim, `.bts`.
//!
//! Little-endian: i16 id (7, periodic 8); i32 nz, ny, ntower, nt; f32 dz, dy, dt, U, z hub, z
//! bottom; f32 slope and offset of u, v, w; i32 length of a text, the text; then per step i16
//! `[z][y][3]` and `[tower][3]`: `V = (i - offset)/slope`. The mean is part of u. The format is
//! described in the user's guide of TurbSim (Jonkman, 2009).

use std::io::{BufWriter, Write};
use std::path::Path;

use shared_geom::error::Diagnostics;

use super::bytes::{Cursor, open, short_header, size_problem, total, unwritten};
use super::grid::{BoxGrid, BoxValues, report, wrong};
use super::planes::{Decode, PlaneFile, Planes};
use super::turbulence::TurbulenceBox;

const ID: i16 = 7;
const ID_PERIODIC: i16 = 8;
const COMPONENTS: [&str; 3] = ["u", "v", "w"];

/// Integers as velocities, per component.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Scale {
    slope: f64,
    offset: f64,
}

#[derive(Debug)]
struct Integers {
    values: usize,
    scales: [Scale; 3],
}

impl Decode for Integers {
    fn values(&self) -> usize {
        self.values
    }

    fn decode(&self, bytes: &[Vec<u8>], values: &mut [f64]) {
        let integers = bytes.iter().flat_map(|bytes| bytes.chunks_exact(2));
        for (index, (value, pair)) in values.iter_mut().zip(integers).enumerate() {
            let integer = f64::from(i16::from_le_bytes([pair[0], pair[1]]));
            let scale = self.scales[index % 3];
            *value = (integer - scale.offset) / scale.slope;
        }
    }
}

/// Opens a `.bts` file; planes are read when they are needed, and at most `cache` of them kept
/// (by default 64 MB).
///
/// # Errors
/// A file that cannot be read, is of another format, has another size than its header implies,
/// or numbers that are not usable.
pub fn read_bts(path: &Path, cache: Option<usize>) -> Result<TurbulenceBox, Diagnostics> {
    let opened = open(path)?;
    let mut cursor = Cursor::new(&opened.head);
    let id = cursor.i16();
    let grid = grid(&mut cursor, id == ID_PERIODIC);
    let scales = [0; 3].map(|_| Scale {
        slope: cursor.f32(),
        offset: cursor.f32(),
    });
    let text = cursor.count();
    if cursor.is_beyond() {
        return Err(short_header(&opened.name, opened.size));
    }
    let mut problems = Vec::new();
    if ![ID, ID_PERIODIC].contains(&id) {
        let expected = "7, or 8 for a periodic box";
        problems.push(wrong(
            "identification of a .bts file",
            f64::from(id),
            expected,
        ));
    }
    problems.extend(grid.problems());
    for (scale, name) in scales.iter().zip(COMPONENTS) {
        if !(scale.slope != 0.0 && scale.slope.is_finite() && scale.offset.is_finite()) {
            let what = format!("slope of {name} (offset {})", scale.offset);
            problems.push(wrong(&what, scale.slope, "finite numbers, not zero"));
        }
    }
    let start = cursor.at().saturating_add(text);
    let points = [grid.planes, 6, grid.lateral * grid.vertical + grid.tower];
    problems.extend(size_problem(opened.size, total(start, &points)));
    report(&opened.name, &problems)?;
    let file = PlaneFile {
        name: opened.name.clone(),
        file: opened.file,
        start: start as u64,
        bytes: 2 * grid.values(),
    };
    let values = grid.values();
    let decode = Box::new(Integers { values, scales });
    let planes = Planes::files(vec![file], decode, cache);
    Ok(TurbulenceBox::new(&opened.name, grid, planes))
}

fn grid(cursor: &mut Cursor<'_>, periodic: bool) -> BoxGrid {
    let [vertical, lateral, tower, planes] = [0; 4].map(|_| cursor.count());
    let [vertical_step, lateral_step, time_step] = [0; 3].map(|_| cursor.f32());
    let [speed, hub_height, bottom] = [0; 3].map(|_| cursor.f32());
    BoxGrid {
        planes,
        lateral,
        vertical,
        tower,
        time_step,
        lateral_step,
        vertical_step,
        speed,
        bottom,
        hub_height,
        periodic,
    }
}

/// Writes a `.bts` file; each component uses the whole range of integers.
///
/// # Errors
/// As [`BoxValues::check`]; a file that cannot be written.
pub fn write_bts(path: &Path, values: &BoxValues) -> Result<(), Diagnostics> {
    values.check(&path.display().to_string())?;
    let written = std::fs::File::create(path).and_then(|file| {
        let mut out = BufWriter::new(file);
        let scales = [0, 1, 2].map(|c| scale(values, c));
        write_header(&mut out, &values.grid, &scales)?;
        for plane in &values.planes {
            for (index, value) in plane.iter().enumerate() {
                let scale = scales[index % 3];
                let integer = (value * scale.slope + scale.offset).round();
                // saturates at the ends of the range
                out.write_all(&(integer as i16).to_le_bytes())?;
            }
        }
        out.flush()
    });
    written.map_err(|error| unwritten(path, &error))
}

fn write_header(out: &mut impl Write, grid: &BoxGrid, scales: &[Scale; 3]) -> std::io::Result<()> {
    const TEXT: &[u8] = b"Helicoid";
    let id = if grid.periodic { ID_PERIODIC } else { ID };
    out.write_all(&id.to_le_bytes())?;
    for count in [grid.vertical, grid.lateral, grid.tower, grid.planes] {
        let count = i32::try_from(count).map_err(std::io::Error::other)?;
        out.write_all(&count.to_le_bytes())?;
    }
    let numbers = [
        grid.vertical_step,
        grid.lateral_step,
        grid.time_step,
        grid.speed,
        grid.hub_height,
        grid.bottom,
    ];
    let pairs = scales.iter().flat_map(|scale| [scale.slope, scale.offset]);
    for number in numbers.into_iter().chain(pairs) {
        out.write_all(&(number as f32).to_le_bytes())?;
    }
    out.write_all(&(TEXT.len() as i32).to_le_bytes())?;
    out.write_all(TEXT)
}

/// The scale of a component in single precision: from the smallest to the largest value.
fn scale(values: &BoxValues, component: usize) -> Scale {
    let all = values.planes.iter();
    let all = all.flat_map(|plane| plane.iter().skip(component).step_by(3));
    let (low, high) = all.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
        (low.min(*value), high.max(*value))
    });
    // a margin for the rounding of the scale
    let slope = if high > low {
        65_500.0 / (high - low)
    } else {
        1.0
    };
    let slope = f64::from(slope as f32);
    let offset = f64::from((-0.5 * (low + high) * slope) as f32);
    Scale { slope, offset }
}

#[cfg(test)]
#[path = "bts_tests.rs"]
mod tests;
