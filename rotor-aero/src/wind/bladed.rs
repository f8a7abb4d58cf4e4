//! Turbulence files of Bladed, `.wnd`, with the identification -99.
//!
//! Little-endian: i16 -99, i16 type; type 4: i32 number of components, f32 latitude, z0, z
//! reference, intensities of u, v, w in per cent; types 7, 8: i32 size of the header, number of
//! components; types 1, 2 have one component, 3, 5 three. Then f32 dz, dy, dx; i32 nt/2; f32 U, 3
//! lengths; i32 2 numbers, nz, ny; with three components f32 6 lengths; type 7: 2 numbers, type 8:
//! 13. Data i16 `[z][y][components]` per plane: `V = 0.001 i U TI/100`, and U is added to u.
//! The layout is the one that OpenFAST reads (documentation of InflowWind).

use std::io::{BufWriter, Write};
use std::path::Path;

use shared_geom::error::Diagnostics;
use shared_geom::exchange::problem::ExchangeProblem;

use super::bytes::{Cursor, open, short_header, size_problem, total, unwritten};
use super::grid::{BoxGrid, BoxValues, report, wrong};
use super::planes::{Decode, PlaneFile, Planes};
use super::summary::BladedSummary;
use super::turbulence::TurbulenceBox;

const ID: i16 = -99;

/// Fraction of the standard deviation that an integer is.
const UNIT: f64 = 0.001;

/// Numbers that a `.wnd` file may not contain.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct BladedInput {
    /// The numbers of the `.sum` file, if there is one.
    pub summary: Option<BladedSummary>,
    /// Turbulence intensities of u, v, w in per cent, which replace all others \[-\].
    pub intensities: Option<[f64; 3]>,
    /// Height of the hub, which replaces all others \[m\].
    pub hub_height: Option<f64>,
    /// Whether the box is periodic; as in the `.sum` file if absent, else not.
    pub periodic: Option<bool>,
    /// Whether v has the sign of a left-handed system.
    pub left_handed: bool,
    /// Largest number of planes in memory; 64 MB of them if absent.
    pub cache: Option<usize>,
}

/// The header of a file.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Header {
    id: i16,
    kind: i16,
    components: usize,
    /// Reference height of type 4.
    reference: Option<f64>,
    /// Intensities of type 4, per cent.
    intensities: Option<[f64; 3]>,
    /// dz, dy, dx.
    steps: [f64; 3],
    planes: usize,
    speed: f64,
    vertical: usize,
    lateral: usize,
    size: usize,
    cut: bool,
}

#[derive(Debug)]
struct Scaled {
    lateral: usize,
    vertical: usize,
    components: usize,
    factors: [f64; 3],
    mean: f64,
    mirrored: bool,
}

impl Decode for Scaled {
    fn values(&self) -> usize {
        3 * self.lateral * self.vertical
    }

    fn decode(&self, bytes: &[Vec<u8>], values: &mut [f64]) {
        values.fill(0.0);
        let integers = bytes.iter().flat_map(|bytes| bytes.chunks_exact(2));
        for (index, pair) in integers.enumerate() {
            let (point, component) = (index / self.components, index % self.components);
            let (z, mut y) = (point / self.lateral, point % self.lateral);
            if self.mirrored {
                y = self.lateral - 1 - y;
            }
            let integer = f64::from(i16::from_le_bytes([pair[0], pair[1]]));
            let mean = if component == 0 { self.mean } else { 0.0 };
            values[3 * (z * self.lateral + y) + component] =
                integer * self.factors[component] + mean;
        }
    }
}

/// Opens a `.wnd` file; planes are read when they are needed. An intensity in the file has
/// precedence over the one of the `.sum` file if it is positive, as in InflowWind.
///
/// # Errors
/// A file that cannot be read, is of another format, has another size than its header implies;
/// intensities, a hub height or other numbers that are missing or not usable.
pub fn read_bladed(path: &Path, input: &BladedInput) -> Result<TurbulenceBox, Diagnostics> {
    let opened = open(path)?;
    let header = header(&opened.head);
    let mut problems = header.problems();
    if header.cut && problems.is_empty() {
        return Err(short_header(&opened.name, opened.size));
    }
    report(&opened.name, &problems)?;
    let intensities = header.intensities(input, &mut problems);
    let grid = header.grid(input, &mut problems);
    problems.extend(grid.problems());
    if let Some(summary) = &input.summary
        && !(-0.1..=0.1).contains(&(summary.speed - header.speed))
    {
        let expected = format!("{} m/s, as the .sum file states", summary.speed);
        problems.push(wrong(
            "mean speed of the .wnd file",
            header.speed,
            &expected,
        ));
    }
    let points = [
        header.planes,
        header.lateral,
        header.vertical,
        header.components,
        2,
    ];
    problems.extend(size_problem(opened.size, total(header.size, &points)));
    report(&opened.name, &problems)?;
    let factor = |c: usize| UNIT * 0.01 * header.speed * intensities[c];
    let sign = if input.left_handed { -1.0 } else { 1.0 };
    let decode = Scaled {
        lateral: grid.lateral,
        vertical: grid.vertical,
        components: header.components,
        factors: [factor(0), sign * factor(1), factor(2)],
        mean: header.speed,
        mirrored: input.summary.is_some_and(|summary| summary.clockwise),
    };
    let file = PlaneFile {
        name: opened.name.clone(),
        file: opened.file,
        start: header.size as u64,
        bytes: 2 * header.components * grid.lateral * grid.vertical,
    };
    let planes = Planes::files(vec![file], Box::new(decode), input.cache);
    Ok(TurbulenceBox::new(&opened.name, grid, planes))
}

fn header(bytes: &[u8]) -> Header {
    let mut cursor = Cursor::new(bytes);
    let [id, kind] = [0; 2].map(|_| cursor.i16());
    let (mut reference, mut intensities) = (None, None);
    let components = match kind {
        4 => {
            let components = cursor.count();
            cursor.skip(8);
            reference = Some(cursor.f32());
            intensities = Some([0; 3].map(|_| cursor.f32()));
            components
        }
        7 | 8 => {
            cursor.skip(4);
            cursor.count()
        }
        1 | 2 => 1,
        _ => 3,
    };
    let steps = [0; 3].map(|_| cursor.f32());
    let planes = cursor.count().saturating_mul(2);
    let speed = cursor.f32();
    cursor.skip(20);
    let [vertical, lateral] = [0; 2].map(|_| cursor.count());
    let lengths = if components == 3 { 24 } else { 0 };
    let end = match kind {
        7 => 8,
        8 => 52,
        _ => 0,
    };
    cursor.skip(lengths + end);
    Header {
        id,
        kind,
        components,
        reference,
        intensities,
        steps,
        planes,
        speed,
        vertical,
        lateral,
        size: cursor.at(),
        cut: cursor.is_beyond(),
    }
}

impl Header {
    /// Problems of the format.
    fn problems(&self) -> Vec<ExchangeProblem> {
        let mut problems = Vec::new();
        if self.id != ID {
            let what = "identification of a .wnd file";
            problems.push(wrong(what, f64::from(self.id), "-99"));
            return problems;
        }
        if !matches!(self.kind, 1..=5 | 7 | 8) {
            let what = "type of the spectrum in a .wnd file";
            problems.push(wrong(what, f64::from(self.kind), "1 to 5, 7 or 8"));
        } else if !matches!(self.components, 1..=3) {
            let what = "number of components in a .wnd file";
            problems.push(wrong(what, self.components as f64, "1 to 3"));
        }
        problems
    }

    fn intensities(&self, input: &BladedInput, problems: &mut Vec<ExchangeProblem>) -> [f64; 3] {
        let own = self.intensities;
        let summary = input.summary.map(|summary| summary.intensities);
        let one = |c: usize| {
            let own = own.map(|own| own[c]).filter(|own| *own > 0.0);
            let given = input.intensities.map(|given| given[c]);
            given.or(own).or(summary.map(|summary| summary[c]))
        };
        let mut values = [0.0; 3];
        for c in 0..self.components {
            match one(c) {
                Some(value) if value >= 0.0 && value.is_finite() => values[c] = value,
                Some(value) => {
                    let what = "turbulence intensity of the box";
                    problems.push(wrong(what, value, "per cent, zero or more"));
                }
                None => problems.push(missing("the turbulence intensities")),
            }
        }
        values
    }

    fn grid(&self, input: &BladedInput, problems: &mut Vec<ExchangeProblem>) -> BoxGrid {
        let [vertical_step, lateral_step, dx] = self.steps;
        let summary = input.summary;
        let hub = input
            .hub_height
            .or(summary.map(|summary| summary.hub_height));
        let hub = hub.or(self.reference).unwrap_or_else(|| {
            problems.push(missing("the hub height"));
            0.0
        });
        let offset = summary.map_or(0.0, |summary| summary.height_offset);
        let half = 0.5 * vertical_step * self.vertical.saturating_sub(1) as f64;
        let periodic = input.periodic.or(summary.map(|summary| summary.periodic));
        BoxGrid {
            planes: self.planes,
            lateral: self.lateral,
            vertical: self.vertical,
            tower: 0,
            time_step: dx / self.speed,
            lateral_step,
            vertical_step,
            speed: self.speed,
            bottom: hub - offset - half,
            hub_height: hub,
            periodic: periodic.unwrap_or(false),
        }
    }
}

fn missing(what: &str) -> ExchangeProblem {
    ExchangeProblem::Missing {
        what: format!("{what} of the .wnd file"),
        help: "this type of file does not contain it: give the .sum file, or the numbers"
            .to_owned(),
    }
}

/// Writes a `.wnd` file of type 4; the intensities are the ones of the box, about its speed.
///
/// # Errors
/// As [`BoxValues::check`]; tower points; an odd number of planes; a grid that is not centered
/// at the hub height; a file that cannot be written.
pub fn write_bladed(path: &Path, values: &BoxValues) -> Result<(), Diagnostics> {
    let name = path.display().to_string();
    values.check(&name)?;
    let grid = &values.grid;
    let mut problems = Vec::new();
    if grid.tower > 0 {
        let what = "tower points of the box";
        problems.push(wrong(what, grid.tower as f64, "0: the format has none"));
    }
    if !grid.planes.is_multiple_of(2) {
        let what = "number of planes of the box";
        problems.push(wrong(what, grid.planes as f64, "an even number"));
    }
    let middle = 0.5 * (grid.bottom + grid.top());
    if (middle - grid.hub_height).abs() > 1e-3 * grid.vertical_step {
        let expected = "the hub height: the format has no other";
        problems.push(wrong("middle of the box [m]", middle, expected));
    }
    report(&name, &problems)?;
    let intensities = [0, 1, 2].map(|c| intensity(values, c));
    let written = std::fs::File::create(path).and_then(|file| {
        let mut out = BufWriter::new(file);
        write_header(&mut out, grid, intensities)?;
        for plane in &values.planes {
            for (index, value) in plane.iter().enumerate() {
                let c = index % 3;
                let mean = if c == 0 { grid.speed } else { 0.0 };
                let integer = (value - mean) / (UNIT * 0.01 * grid.speed * intensities[c]);
                // saturates beyond 32 standard deviations
                out.write_all(&(integer.round() as i16).to_le_bytes())?;
            }
        }
        out.flush()
    });
    written.map_err(|error| unwritten(path, &error))
}

/// Intensity of a component about the mean speed, in single precision, per cent; at least the
/// one at which no value exceeds the range of the integers.
fn intensity(values: &BoxValues, c: usize) -> f64 {
    let speed = values.grid.speed;
    let mean = if c == 0 { speed } else { 0.0 };
    let (mut count, mut square, mut largest) = (0.0, 0.0, 0.0_f64);
    for plane in &values.planes {
        for value in plane.iter().skip(c).step_by(3) {
            count += 1.0;
            square += (value - mean).powi(2);
            largest = largest.max((value - mean).abs());
        }
    }
    let sigma = (square / count)
        .sqrt()
        .max(largest / 32.7)
        .max(1e-6 * speed);
    f64::from((100.0 * sigma / speed) as f32)
}

fn write_header(
    out: &mut impl Write,
    grid: &BoxGrid,
    intensities: [f64; 3],
) -> std::io::Result<()> {
    let integer = |number: usize| i32::try_from(number).map_err(std::io::Error::other);
    let mut bytes = Vec::new();
    let numbers = |bytes: &mut Vec<u8>, numbers: &[f64]| {
        for number in numbers {
            bytes.extend((*number as f32).to_le_bytes());
        }
    };
    bytes.extend(ID.to_le_bytes());
    bytes.extend(4_i16.to_le_bytes());
    bytes.extend(3_i32.to_le_bytes());
    // latitude and roughness are not known
    numbers(&mut bytes, &[0.0, 0.03, grid.hub_height]);
    numbers(&mut bytes, &intensities);
    let dx = grid.time_step * grid.speed;
    numbers(&mut bytes, &[grid.vertical_step, grid.lateral_step, dx]);
    bytes.extend(integer(grid.planes / 2)?.to_le_bytes());
    numbers(&mut bytes, &[grid.speed, 0.0, 0.0, 0.0]);
    for count in [0, 0, grid.vertical, grid.lateral] {
        bytes.extend(integer(count)?.to_le_bytes());
    }
    numbers(&mut bytes, &[0.0; 6]);
    out.write_all(&bytes)
}

#[cfg(test)]
#[path = "bladed_tests.rs"]
mod tests;
