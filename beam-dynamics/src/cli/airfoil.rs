//! `airfoil`: describes, draws and converts tables of airfoils.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use rotor_aero::airfoil::files::blade::recognize_blade;
use rotor_aero::airfoil::files::{self, Format, ReadAirfoil, Reading, Writing};
use rotor_aero::airfoil::{AirfoilProblem, BUILT_IN, Viterna};
use shared_geom::error::{Diagnostics, Explain, nearest_name};
use shared_geom::figure::Figure;
use shared_geom::files::{OutputProblem, make_folder, write_figure, write_text};

use super::{DONE, NOT_REACHED, Terminal, WRONG_INPUT};
use crate::output::{AirfoilPlot, airfoil_text, list};

/// A written format.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum Target {
    /// C81 table, for all Mach numbers
    C81,
    /// Polar file of AeroDyn 15
    Aerodyn15,
    /// Profile coefficients of HAWC2, pc
    Hawc2,
    /// Columns with a header, which hold everything
    Csv,
}

impl Target {
    fn format(self) -> Format {
        match self {
            Self::C81 => Format::C81,
            Self::Aerodyn15 => Format::AeroDyn15,
            Self::Hawc2 => Format::Hawc2Pc,
            Self::Csv => Format::Csv,
        }
    }

    /// The format of the ending of a name.
    fn of_path(path: &Path) -> Option<Self> {
        let ending = path.extension()?.to_str()?.to_ascii_lowercase();
        match ending.as_str() {
            "c81" => Some(Self::C81),
            "csv" => Some(Self::Csv),
            "pc" => Some(Self::Hawc2),
            _ => None,
        }
    }
}

/// Files, changes and results of `airfoil`.
#[derive(Debug, Args)]
pub(super) struct AirfoilArguments {
    /// Airfoil files of any known format, several of one airfoil for its Reynolds numbers; or the name of a built-in airfoil
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// The airfoil of FILE, if it has several; all if not given
    #[arg(long, value_name = "NAME")]
    name: Option<String>,
    /// Extend tables to the full circle by the method of Viterna and Corrigan, for a blade of this aspect ratio; 10 if not given
    #[arg(long, value_name = "ASPECT_RATIO", value_parser = ratio, num_args = 0..=1, require_equals = true, default_missing_value = "10")]
    viterna: Option<f64>,
    /// Turn the section upside down
    #[arg(long)]
    mirror: bool,
    /// File to write, with the changes of the options
    #[arg(long, value_name = "NEW")]
    out: Option<PathBuf>,
    /// Format to write; if not given, by the ending of NEW
    #[arg(long, value_name = "FORMAT", requires = "out")]
    to: Option<Target>,
    /// Folder for the figure; the folder of NEW, or the folder "results" next to FILE, if not given
    #[arg(long, value_name = "DIR", conflicts_with = "no_figures")]
    figures: Option<PathBuf>,
    /// Draw no figure
    #[arg(long)]
    no_figures: bool,
}

/// An aspect ratio.
fn ratio(text: &str) -> Result<f64, String> {
    let value: Option<f64> = text.parse().ok();
    let value = value.filter(|value| value.is_finite() && *value > 0.0);
    value.ok_or_else(|| "expected an aspect ratio above zero, such as --viterna=12".to_owned())
}

/// Reason for refusing a table or a conversion.
#[derive(Debug, thiserror::Error)]
enum AirfoilRefusal {
    #[error("\"{file}\" is neither a file nor a built-in airfoil")]
    NoFile { file: String },
    #[error("\"{file}\" is {what}, expected tables of an airfoil")]
    Blade {
        file: String,
        what: String,
        help: String,
    },
    #[error("no airfoil \"{name}\" in the file, which has {count}")]
    NoName {
        name: String,
        count: usize,
        known: Vec<String>,
    },
    #[error("the ending of \"{file}\" belongs to no written format of airfoils")]
    NoEnding { file: String },
    #[error("\"{file}\" would be overwritten, but it is the input")]
    Input { file: String },
    #[error("airfoil \"{name}\" cannot be changed: {problem}")]
    Change {
        name: String,
        problem: AirfoilProblem,
    },
}

impl Explain for AirfoilRefusal {
    fn help(&self) -> Option<String> {
        let names = || BUILT_IN.iter().map(|one| one.name);
        match self {
            Self::NoFile { file } => Some(match nearest_name(file, names()) {
                Some(near) => format!("did you mean \"{near}\"?"),
                None => {
                    let names: Vec<_> = names().collect();
                    format!("correct the path; built-in airfoils: {}", names.join(", "))
                }
            }),
            Self::NoName { name, known, .. } => {
                let near = nearest_name(name, known.iter().map(String::as_str));
                Some(match near {
                    Some(near) => format!("did you mean \"{near}\"?"),
                    None => format!("known: {}", known.join(", ")),
                })
            }
            Self::NoEnding { .. } => Some(
                "give the format with --to: c81, aerodyn15, hawc2, csv; or an ending: .c81, \
                 .csv, .pc"
                    .to_owned(),
            ),
            Self::Blade { help, .. } => Some(help.clone()),
            Self::Input { .. } => Some("give the output another name".to_owned()),
            Self::Change { problem, .. } => problem.help(),
        }
    }
}

/// Reasons for stopping.
enum Stop {
    Refusal(Vec<AirfoilRefusal>),
    File(Diagnostics),
}

impl From<AirfoilRefusal> for Stop {
    fn from(refusal: AirfoilRefusal) -> Self {
        Self::Refusal(vec![refusal])
    }
}

impl From<Diagnostics> for Stop {
    fn from(problems: Diagnostics) -> Self {
        Self::File(problems)
    }
}

/// The tables of a command, and their source.
struct Tables {
    /// Files or built-in airfoil, as text.
    source: String,
    format: Option<Format>,
    airfoils: Vec<ReadAirfoil>,
    remarks: Vec<String>,
}

/// `airfoil FILE...`
pub(super) fn airfoil(arguments: &AirfoilArguments, terminal: &mut Terminal<'_>) -> u8 {
    let prepared = prepare(arguments).and_then(|tables| {
        let writing = converted(&tables, arguments)?;
        Ok((tables, writing))
    });
    let (tables, writing) = match prepared {
        Ok(prepared) => prepared,
        Err(Stop::Refusal(problems)) => {
            for problem in &problems {
                terminal.report(problem);
            }
            return WRONG_INPUT;
        }
        Err(Stop::File(problems)) => {
            terminal.report_text(&problems.to_string());
            return WRONG_INPUT;
        }
    };
    let format = tables.format.map_or("built-in airfoil", Format::title);
    let plot = AirfoilPlot::new(&title(&tables, &arguments.files), &tables.airfoils);
    let mut remarks = tables.remarks.clone();
    remarks.extend(plot.remark().filter(|_| !arguments.no_figures));
    let head = format!("{}: {format}", tables.source);
    let (mut text, is_wrong) = airfoil_text(&head, &tables.airfoils, &remarks);
    if let Some((_, writing)) = &writing {
        list(&mut text, "Cannot be represented", &writing.lost);
        if writing.lost.is_empty() {
            text.push_str("\nEverything is converted\n");
        }
    }
    terminal.show(&text);
    match write(arguments, writing.as_ref(), &plot) {
        Ok(written) => {
            if !written.is_empty() {
                terminal.show("\nWritten\n");
            }
            for file in written {
                terminal.show(&format!("  {}\n", file.display()));
            }
            if is_wrong { WRONG_INPUT } else { DONE }
        }
        Err(problem) => {
            terminal.report(&problem);
            NOT_REACHED
        }
    }
}

/// Title of the figure: the only airfoil, or the files.
fn title(tables: &Tables, files: &[PathBuf]) -> String {
    if let [only] = &tables.airfoils[..] {
        return only.data.name.clone();
    }
    let first = files.first().and_then(|path| path.file_name());
    let first = first.unwrap_or_default().to_string_lossy().into_owned();
    match files.len() {
        1 => first,
        count => format!("{first} and {} more files", count - 1),
    }
}

/// The tables of the files or of a built-in airfoil, with the changes of the options.
fn prepare(arguments: &AirfoilArguments) -> Result<Tables, Stop> {
    let mut tables = read(&arguments.files)?;
    if let Some(name) = &arguments.name {
        let known = tables.airfoils.iter();
        let known: Vec<_> = known.map(|airfoil| airfoil.data.name.clone()).collect();
        tables.airfoils.retain(|airfoil| airfoil.data.name == *name);
        if tables.airfoils.is_empty() {
            let (name, count) = (name.clone(), known.len());
            return Err(AirfoilRefusal::NoName { name, count, known }.into());
        }
    }
    let mut refused = Vec::new();
    for airfoil in &mut tables.airfoils {
        if let Some(ratio) = arguments.viterna {
            match airfoil.data.extended(&Viterna::of_aspect_ratio(ratio)) {
                Ok(extended) => airfoil.data = extended,
                Err(problems) => {
                    let name = airfoil.data.name.clone();
                    refused.extend(problems.into_iter().map(|problem| AirfoilRefusal::Change {
                        name: name.clone(),
                        problem,
                    }));
                }
            }
        }
        if arguments.mirror {
            airfoil.data = airfoil.data.mirrored();
            // Their angles and slopes are of the upright section.
            airfoil.unsteady.clear();
        }
    }
    if refused.is_empty() {
        Ok(tables)
    } else {
        Err(Stop::Refusal(refused))
    }
}

/// Reads all files, several as one family; a single name may be a built-in airfoil.
fn read(paths: &[PathBuf]) -> Result<Tables, Stop> {
    let names: Vec<_> = paths
        .iter()
        .map(|path| path.display().to_string())
        .collect();
    let source = names.join(", ");
    if let [name] = &names[..]
        && let Some(found) = BUILT_IN.iter().find(|one| one.name == *name)
        && !paths[0].exists()
    {
        let airfoil = ReadAirfoil {
            data: found.data(),
            ..ReadAirfoil::default()
        };
        return Ok(Tables {
            source,
            format: None,
            airfoils: vec![airfoil],
            remarks: vec![found.description.to_owned()],
        });
    }
    let missing = paths.iter().filter(|path| !path.exists());
    let missing: Vec<_> = missing
        .map(|path| AirfoilRefusal::NoFile {
            file: path.display().to_string(),
        })
        .collect();
    if !missing.is_empty() {
        return Err(Stop::Refusal(missing));
    }
    let readings = paths.iter().map(|path| {
        let refused = |problems| blade(path).map_or(Stop::File(problems), Stop::from);
        files::read(path).map_err(refused)
    });
    let readings = readings.collect::<Result<Vec<Reading>, Stop>>()?;
    let reading = match <[Reading; 1]>::try_from(readings) {
        Ok([only]) => only,
        Err(several) => files::merge(several)?,
    };
    Ok(Tables {
        source,
        format: Some(reading.format),
        airfoils: reading.airfoils,
        remarks: reading.remarks,
    })
}

/// The refusal of a file that describes a blade.
fn blade(path: &Path) -> Option<AirfoilRefusal> {
    let file = path.display().to_string();
    if file.ends_with(".blade.toml") {
        let help = format!("run \"beam-dynamics check {file}\"");
        let what = "a blade file, of stiffness and mass".to_owned();
        return Some(AirfoilRefusal::Blade { file, what, help });
    }
    let text = std::fs::read(path).ok()?;
    let text = String::from_utf8_lossy(&text);
    // A file with tables of airfoils is one, whatever else it contains.
    let is_open = matches!(files::recognize(&text, path), None | Some(Format::Csv));
    let format = recognize_blade(&text).filter(|_| is_open)?;
    Some(AirfoilRefusal::Blade {
        file,
        what: format!("the geometry of a blade ({})", format.title()),
        help: "name it as \"file\" of [rotor] in a rotor file, NAME.rotor.toml, and run \
               \"beam-dynamics performance NAME.rotor.toml\""
            .to_owned(),
    })
}

/// The file to write, and its content.
fn converted(
    tables: &Tables,
    arguments: &AirfoilArguments,
) -> Result<Option<(PathBuf, Writing)>, Stop> {
    let Some(out) = &arguments.out else {
        return Ok(None);
    };
    let file = out.display().to_string();
    let Some(target) = arguments.to.or_else(|| Target::of_path(out)) else {
        return Err(AirfoilRefusal::NoEnding { file }.into());
    };
    let is_it = |input: &PathBuf| matches!((input.canonicalize(), out.canonicalize()), (Ok(a), Ok(b)) if a == b);
    if arguments.files.iter().any(is_it) {
        return Err(AirfoilRefusal::Input { file }.into());
    }
    let writing = files::write(&tables.airfoils, target.format(), &file)?;
    Ok(Some((out.clone(), writing)))
}

/// Writes the converted file and the figures; returns their names.
fn write(
    arguments: &AirfoilArguments,
    writing: Option<&(PathBuf, Writing)>,
    plot: &AirfoilPlot,
) -> Result<Vec<PathBuf>, OutputProblem> {
    let mut written = Vec::new();
    if let Some((file, writing)) = writing {
        if let Some(folder) = folder_of(file) {
            make_folder(folder)?;
        }
        write_text(file, &writing.text)?;
        written.push(file.clone());
    }
    if arguments.no_figures {
        return Ok(written);
    }
    let first = arguments
        .files
        .first()
        .map_or(Path::new(""), PathBuf::as_path);
    let folder = match (&arguments.figures, &arguments.out) {
        (Some(folder), _) => folder.clone(),
        (None, Some(out)) => folder_of(out).unwrap_or(Path::new("")).to_owned(),
        (None, None) => first.with_file_name("results"),
    };
    if !folder.as_os_str().is_empty() {
        make_folder(&folder)?;
    }
    let named = arguments.out.as_deref().unwrap_or(first);
    let stem = named.file_stem().unwrap_or_default().to_string_lossy();
    let drawing = plot.drawing();
    for ending in ["png", "svg"] {
        let path = folder.join(format!("{stem}.airfoil.{ending}"));
        write_figure(&path, &drawing)?;
        written.push(path);
    }
    Ok(written)
}

/// The folder of a file, if its name has one.
fn folder_of(file: &Path) -> Option<&Path> {
    file.parent()
        .filter(|folder| !folder.as_os_str().is_empty())
}
