//! Boxes of the Mann model, as HAWC2 reads them: one file per component, without a header.
//!
//! Little-endian f32 `[x][y][z]`, x slowest; y from the positive to the negative side, z from the
//! bottom up. Dimensions, distances and speed are not in the files. The mean is zero, or added by
//! the mean wind; the box is periodic. Whether the first plane of the file arrives first or last
//! is a matter of convention ([`PlaneOrder`]).

use std::io::{BufWriter, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use shared_geom::error::{Diagnostics, SourceLocation};
use shared_geom::exchange::problem::ExchangeProblem;

use super::bytes::{Opened, open, size_problem, total, unwritten};
use super::grid::{BoxGrid, BoxValues, report, wrong};
use super::planes::{Decode, PlaneFile, Planes};
use super::turbulence::TurbulenceBox;

/// The plane of a Mann box that arrives first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum PlaneOrder {
    /// The first of the file, as in InflowWind.
    #[default]
    FirstArrives,
    /// The last of the file.
    LastArrives,
}

/// A Mann box and the numbers that its files do not contain.
#[derive(Debug, Clone, PartialEq)]
pub struct MannInput {
    /// Files of u, v, w; a component without a file is zero.
    pub files: [Option<PathBuf>; 3],
    /// Number of points along x, y, z.
    pub points: [usize; 3],
    /// Distance of points along x, y, z \[m\].
    pub steps: [f64; 3],
    /// Speed at which the box is carried downwind \[m/s\].
    pub speed: f64,
    /// Height of the hub: the middle of the box \[m\].
    pub hub_height: f64,
    /// Standard deviations of u, v, w to which the box is scaled; as in the file if absent \[m/s\].
    pub sigma: Option<[f64; 3]>,
    /// The plane that arrives first.
    pub order: PlaneOrder,
    /// Largest number of planes in memory; 64 MB of them if absent.
    pub cache: Option<usize>,
}

/// Components of each file, and their factors.
#[derive(Debug)]
struct Singles {
    lateral: usize,
    vertical: usize,
    components: Vec<(usize, f64)>,
}

impl Decode for Singles {
    fn values(&self) -> usize {
        3 * self.lateral * self.vertical
    }

    fn decode(&self, bytes: &[Vec<u8>], values: &mut [f64]) {
        for (bytes, (component, factor)) in bytes.iter().zip(&self.components) {
            for (index, four) in bytes.chunks_exact(4).enumerate() {
                let (y, z) = (index / self.vertical, index % self.vertical);
                let y = self.lateral.saturating_sub(1 + y);
                values[3 * (z * self.lateral + y) + component] = factor * single(four);
            }
        }
    }
}

fn single(four: &[u8]) -> f64 {
    four.try_into()
        .map_or(0.0, |four| f64::from(f32::from_le_bytes(four)))
}

impl MannInput {
    fn grid(&self) -> BoxGrid {
        let [planes, lateral, vertical] = self.points;
        let [dx, lateral_step, vertical_step] = self.steps;
        let height = vertical_step * vertical.saturating_sub(1) as f64;
        BoxGrid {
            planes,
            lateral,
            vertical,
            tower: 0,
            time_step: dx / self.speed,
            lateral_step,
            vertical_step,
            speed: self.speed,
            bottom: self.hub_height - 0.5 * height,
            hub_height: self.hub_height,
            periodic: true,
        }
    }
}

/// Opens a Mann box. The files are read once to find numbers that are not finite and the
/// standard deviations; afterwards planes are read when they are needed.
///
/// # Errors
/// Files that are missing, have another size than the dimensions imply, or contain numbers that
/// are not finite; numbers that are not usable.
pub fn read_mann(input: &MannInput) -> Result<TurbulenceBox, Diagnostics> {
    let grid = input.grid();
    let name = input.files.iter().flatten().next();
    let name = name.map_or("Mann box".to_owned(), |path| path.display().to_string());
    let mut wrongs = grid.problems();
    if input.files.iter().all(Option::is_none) {
        wrongs.push(wrong("number of files of the Mann box", 0.0, "1 to 3"));
    }
    for sigma in input.sigma.iter().flatten() {
        if !(*sigma >= 0.0 && sigma.is_finite()) {
            wrongs.push(wrong("standard deviation", *sigma, "zero or more"));
        }
    }
    report(&name, &wrongs)?;
    let mut problems = Diagnostics::new();
    let (mut files, mut components) = (Vec::new(), Vec::new());
    for (component, path) in input.files.iter().enumerate() {
        let Some(path) = path else { continue };
        let sigma = input.sigma.map(|sigma| sigma[component]);
        if let Some((file, factor)) = problems.keep(component_file(path, &grid, sigma)) {
            files.push(file);
            components.push((component, factor));
        }
    }
    let decode = Singles {
        lateral: grid.lateral,
        vertical: grid.vertical,
        components,
    };
    let planes = Planes::files(files, Box::new(decode), input.cache);
    let last_first = input.order == PlaneOrder::LastArrives;
    problems.into_result(TurbulenceBox::new(&name, grid, planes).reversed(last_first))
}

/// The file of a component and the factor that gives it the deviation `sigma`.
fn component_file(
    path: &Path,
    grid: &BoxGrid,
    sigma: Option<f64>,
) -> Result<(PlaneFile, f64), Diagnostics> {
    let mut opened = open(path)?;
    let points = [grid.planes, grid.lateral, grid.vertical, 4];
    let size = size_problem(opened.size, total(0, &points));
    report(&opened.name, size.as_slice())?;
    let bytes = 4 * grid.lateral * grid.vertical;
    let found = deviation(&mut opened, bytes)?;
    let factor = match sigma {
        None => 1.0,
        Some(sigma) if found > 0.0 => sigma / found,
        Some(0.0) => 0.0,
        Some(_) => {
            let what = "standard deviation of the file, which is scaled";
            let location = SourceLocation::file(&opened.name);
            return Err(Diagnostics::one(
                location,
                &wrong(what, found, "more than 0"),
            ));
        }
    };
    let file = PlaneFile {
        name: opened.name,
        file: opened.file,
        start: 0,
        bytes,
    };
    Ok((file, factor))
}

/// The standard deviation about the mean, plane by plane; refuses numbers that are not finite.
fn deviation(opened: &mut Opened, bytes: usize) -> Result<f64, Diagnostics> {
    let (mut count, mut mean, mut square) = (0.0, 0.0, 0.0);
    let (mut first, mut wrongs) = (None, 0_u64);
    let mut buffer = vec![0; bytes];
    let mut at = 0_u64;
    while at < opened.size {
        let read = opened.file.seek(SeekFrom::Start(at));
        let read = read.and_then(|_| opened.file.read_exact(&mut buffer));
        read.map_err(|error| unreadable(&opened.name, &error))?;
        for (index, four) in buffer.chunks_exact(4).enumerate() {
            let value = single(four);
            if !value.is_finite() {
                wrongs += 1;
                first = first.or(Some(at + 4 * index as u64));
                continue;
            }
            count += 1.0;
            let change = value - mean;
            mean += change / count;
            square += change * (value - mean);
        }
        at += bytes as u64;
    }
    let Some(first) = first else {
        return Ok((square / count).sqrt());
    };
    let problem = ExchangeProblem::Other {
        what: "velocities of the box".to_owned(),
        found: format!("{wrongs} that are not finite"),
        expected: "finite numbers in single precision".to_owned(),
        help: "make the box again, or correct its format".to_owned(),
    };
    let byte = usize::try_from(first).unwrap_or(usize::MAX);
    Err(Diagnostics::one(
        SourceLocation::byte(&opened.name, byte),
        &problem,
    ))
}

fn unreadable(name: &str, error: &std::io::Error) -> Diagnostics {
    let problem = ExchangeProblem::Other {
        what: "turbulence box".to_owned(),
        found: error.to_string(),
        expected: "a file that can be read".to_owned(),
        help: "check the file".to_owned(),
    };
    Diagnostics::one(SourceLocation::file(name), &problem)
}

/// Writes the three files of a Mann box, without its mean `mean` of u \[m/s\].
///
/// # Errors
/// As [`BoxValues::check`]; tower points; a file that cannot be written.
pub fn write_mann(paths: &[PathBuf; 3], values: &BoxValues, mean: f64) -> Result<(), Diagnostics> {
    let name = paths[0].display().to_string();
    values.check(&name)?;
    let grid = &values.grid;
    if grid.tower > 0 {
        let what = "tower points of the box";
        report(
            &name,
            &[wrong(what, grid.tower as f64, "0: the format has none")],
        )?;
    }
    for (component, path) in paths.iter().enumerate() {
        let mean = if component == 0 { mean } else { 0.0 };
        let written = std::fs::File::create(path).and_then(|file| {
            let mut out = BufWriter::new(file);
            for plane in &values.planes {
                for y in (0..grid.lateral).rev() {
                    for z in 0..grid.vertical {
                        let value = plane[grid.index(y, z) + component] - mean;
                        out.write_all(&(value as f32).to_le_bytes())?;
                    }
                }
            }
            out.flush()
        });
        written.map_err(|error| unwritten(path, &error))?;
    }
    Ok(())
}

#[cfg(test)]
#[path = "mann_tests.rs"]
mod tests;
