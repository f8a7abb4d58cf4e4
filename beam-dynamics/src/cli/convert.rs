//! `convert`: a blade from one format to another.

use std::path::{Path, PathBuf};

use clap::Args;
use shared_geom::document::read_text;
use shared_geom::error::{Diagnostics, Explain, nearest_name};
use shared_geom::exchange::{self, ExchangeProblem, Format, Reading, Writing};
use shared_geom::files::{make_folder, read_bytes, write_text};
use shared_geom::hash::sha256_of_content;

use crate::output::list;

use super::reading_options::ReadingOptions;
use super::{DONE, NOT_REACHED, Terminal, WRONG_INPUT};

/// Reason for refusing a conversion.
#[derive(Debug, thiserror::Error)]
enum ConvertProblem {
    #[error("\"{found}\" is not a format, expected {}", names().join(", "))]
    NoFormat { found: String },
    #[error("the ending of \"{file}\" belongs to no format")]
    NoEnding { file: String },
    #[error("\"{file}\": blade files in TOML are written by people, expected one in JSON")]
    Toml { file: String, remedy: String },
    #[error("\"{file}\": --into writes a windIO file, expected the ending .yaml")]
    NotYaml { file: String },
    #[error("\"{file}\" would be overwritten, but it is the input")]
    Input { file: String },
    #[error(transparent)]
    Exchange(#[from] ExchangeProblem),
}

impl Explain for ConvertProblem {
    fn help(&self) -> Option<String> {
        match self {
            Self::NoFormat { found } => {
                nearest_name(found, names()).map(|name| format!("did you mean \"{name}\"?"))
            }
            Self::NoEnding { .. } => Some(format!(
                "give the format with --to: {}; or an ending: {}",
                names().join(", "),
                endings().join(", ")
            )),
            Self::Input { .. } => Some("give the output another name".to_owned()),
            Self::NotYaml { .. } => Some(
                "for another format leave --into out; or give the output this ending".to_owned(),
            ),
            Self::Toml { remedy, .. } => Some(format!(
                "convert to \"{remedy}\", which is read wherever one in TOML is"
            )),
            Self::Exchange(ExchangeProblem::NotWritten { .. }) => {
                Some(format!("formats that are written: {}", names().join(", ")))
            }
            Self::Exchange(problem) => problem.help(),
        }
    }
}

/// Names of the output formats.
fn names() -> Vec<&'static str> {
    let written = Format::ALL.into_iter().filter(|format| format.is_written());
    written.map(Format::name).collect()
}

/// Endings, each with its format.
fn endings() -> Vec<String> {
    let written = Format::ALL.into_iter().filter(|format| format.is_written());
    let endings = written.filter_map(|format| {
        let ending = format.endings().first()?;
        Some(format!("{ending} ({})", format.name()))
    });
    endings.collect()
}

/// The files of a conversion.
#[derive(Debug, Args)]
pub(super) struct ConvertArguments {
    /// Blade file to read
    #[arg(value_name = "FROM")]
    from: PathBuf,
    /// Blade file to write
    #[arg(value_name = "TO")]
    to: PathBuf,
    /// Format to write; if not given, by the ending of TO. With "all" TO is a folder, in which each
    /// format has a folder
    #[arg(long = "to", value_name = "NAME", id = "format")]
    format: Option<String>,
    /// windIO file of which TO becomes a copy, with reference axis, twist and elastic properties of the blade
    #[arg(long, value_name = "FILE", conflicts_with = "format")]
    into: Option<PathBuf>,
    #[command(flatten)]
    reading: ReadingOptions,
}

impl ConvertArguments {
    /// Whether all formats are written.
    fn is_all(&self) -> bool {
        self.format.as_deref() == Some(ALL)
    }
}

/// The word for all formats.
const ALL: &str = "all";

/// Reads FROM and writes TO, in the named format or the format of the ending, or into a
/// copy of a windIO file.
pub(super) fn convert(arguments: &ConvertArguments, terminal: &mut Terminal<'_>) -> u8 {
    let to = arguments.to.as_path();
    let (text, files) = match prepare(arguments) {
        Ok(prepared) => prepared,
        Err(Refusal::Problem(problem)) => {
            terminal.report(&problem);
            return WRONG_INPUT;
        }
        Err(Refusal::File(problems)) => {
            terminal.report_text(&problems.to_string());
            return WRONG_INPUT;
        }
    };
    terminal.show(&text);
    let code = write_files(&files, terminal);
    if let Some((first, _)) = files
        .first()
        .filter(|(first, _)| code == DONE && first != to && files.len() > 1 && !arguments.is_all())
    {
        terminal.show(&format!(
            "\n{} is the file for modes and describe: it refers to the others\n",
            first.display()
        ));
    }
    code
}

/// Reason for writing nothing.
enum Refusal {
    Problem(ConvertProblem),
    File(Diagnostics),
}

impl From<ConvertProblem> for Refusal {
    fn from(problem: ConvertProblem) -> Self {
        Self::Problem(problem)
    }
}

/// The report of the conversion, and the files to write.
fn prepare(arguments: &ConvertArguments) -> Result<(String, Vec<(PathBuf, String)>), Refusal> {
    let (from, to) = (arguments.from.as_path(), arguments.to.as_path());
    let format = match arguments.into {
        Some(_) => Format::WindIo2,
        None if arguments.is_all() => Format::Helicoid,
        None => format_of(to, arguments.format.as_deref())?,
    };
    if arguments.into.is_some() && Format::of_path(to) != Some(format) {
        let file = to.display().to_string();
        return Err(ConvertProblem::NotYaml { file }.into());
    }
    let is_toml = to
        .extension()
        .is_some_and(|ending| ending.eq_ignore_ascii_case("toml"));
    if format == Format::Helicoid && is_toml && !arguments.is_all() {
        let json = to.with_file_name(format!("{}.blade.json", name_of(to)));
        let (file, remedy) = (to.display().to_string(), json.display().to_string());
        return Err(ConvertProblem::Toml { file, remedy }.into());
    }
    let (seen, mut reading) = arguments.reading.read(from, None).map_err(Refusal::File)?;
    stamp(&mut reading, from);
    let (files, lost, title) = match &arguments.into {
        Some(existing) => {
            let text = read_text(existing).map_err(Refusal::File)?;
            let writing = exchange::write_into(&reading.blade, &text, existing);
            let Writing { files, lost } = writing.map_err(Refusal::File)?;
            let remark = exchange::length_remark(&reading.blade, &text);
            reading.remarks.extend(remark);
            let files = files.into_iter().map(|(_, text)| (to.to_owned(), text));
            let title = format!("a copy of {}", existing.display());
            (files.collect(), lost, title)
        }
        None if arguments.is_all() => {
            let (files, lost) = all_formats(&reading, &name_of(from), to);
            (files, lost, "all formats".to_owned())
        }
        None => {
            let writing = exchange::write(&reading.blade, format, &name_of(to));
            let Writing { files, lost } = writing.map_err(ConvertProblem::from)?;
            if format == Format::WindIo2 {
                reading.remarks.push(exchange::WINDIO_PART.join(" "));
            }
            (placed(files, to, format), lost, format.title().to_owned())
        }
    };
    if let Some(existing) = arguments.into.as_ref().filter(|file| is_same(to, file)) {
        let file = existing.display().to_string();
        return Err(ConvertProblem::Input { file }.into());
    }
    let input = files.iter().find(|(file, _)| is_input(file, from));
    if let Some((file, _)) = input {
        let file = file.display().to_string();
        return Err(ConvertProblem::Input { file }.into());
    }
    let text = format!("{}: {} -> {}\n", from.display(), seen.title(), title);
    Ok((described(text, &reading, &lost), files))
}

/// The report of a conversion after its first line.
fn described(mut text: String, reading: &Reading, lost: &[String]) -> String {
    list(&mut text, "Cannot be represented", lost);
    let problems = reading.blade.summarized_problems();
    let problems: Vec<_> = problems.iter().map(ToString::to_string).collect();
    if lost.is_empty() {
        text.push_str(if problems.is_empty() {
            "\nEverything is converted\n"
        } else {
            "\nEverything is converted, but the blade cannot be analyzed for the problems below\n"
        });
    }
    list(&mut text, "Remarks", &reading.remarks);
    list(&mut text, "Problems of the blade", &problems);
    text
}

/// The files of each format in a folder of its own below `to`, and the data that formats cannot hold.
fn all_formats(reading: &Reading, name: &str, to: &Path) -> (Vec<(PathBuf, String)>, Vec<String>) {
    let (mut files, mut lost) = (Vec::new(), Vec::new());
    for format in Format::ALL.into_iter().filter(|one| one.is_written()) {
        match exchange::write(&reading.blade, format, name) {
            Ok(writing) => {
                let folder = to.join(format.name());
                let placed = writing.files.into_iter();
                files.extend(placed.map(|(file, text)| (folder.join(file), text)));
                let named = |one: &String| format!("{}: {one}", format.name());
                lost.extend(writing.lost.iter().map(named));
            }
            Err(problem) => lost.push(format!("{} is not written: {problem}", format.name())),
        }
    }
    (files, lost)
}

/// Records the program and the source of the blade: readers of foreign files give the hash
/// of all files read, a blade file of our own the hash of its source.
fn stamp(reading: &mut Reading, source: &Path) {
    let provenance = &mut reading.blade.provenance;
    let own = provenance.program == env!("CARGO_PKG_NAME") || provenance.input_hash.is_empty();
    if let Some(bytes) = read_bytes(source).ok().filter(|_| own) {
        provenance.input_hash = sha256_of_content(&bytes);
    }
    provenance.program = env!("CARGO_PKG_NAME").to_owned();
    provenance.version = env!("CARGO_PKG_VERSION").to_owned();
}

fn format_of(to: &Path, format: Option<&str>) -> Result<Format, ConvertProblem> {
    let found = match format {
        Some(name) => Format::from_name(name).ok_or_else(|| ConvertProblem::NoFormat {
            found: name.to_owned(),
        }),
        None => Format::of_path(to).ok_or_else(|| ConvertProblem::NoEnding {
            file: to.display().to_string(),
        }),
    }?;
    Ok(found)
}

/// The name of a blade file without folder and endings.
fn name_of(file: &Path) -> String {
    let name = file.file_name().unwrap_or_default().to_string_lossy();
    let lower = name.to_lowercase();
    let endings = [".blade.json", ".blade.toml", ".sections.csv", ".line.csv"];
    let ending = endings.iter().find(|ending| lower.ends_with(*ending));
    let stem = match ending {
        Some(ending) => name.get(..name.len() - ending.len()),
        None => name.rsplit_once('.').map(|(stem, _)| stem),
    };
    stem.filter(|stem| !stem.is_empty())
        .unwrap_or(&name)
        .to_owned()
}

/// The files of `format` next to `to`; the first is `to` itself, unless the ending of `to` belongs
/// to another format or to another of the files.
fn placed(files: Vec<(PathBuf, String)>, to: &Path, format: Format) -> Vec<(PathBuf, String)> {
    let folder = to.parent().unwrap_or(Path::new(""));
    let extension = |path: &Path| path.extension().map(|ending| ending.to_ascii_lowercase());
    let of_ending = Format::of_path(to);
    // Both layouts of BeamDyn have the same names.
    let named = match format {
        Format::BeamDyn4 => Format::BeamDyn,
        other => other,
    };
    let is_of = |path: &Path| Format::of_path(path) == Some(named);
    let is_alone = is_of(to) && !files.iter().skip(1).any(|(name, _)| is_of(name));
    let beside = files.into_iter().enumerate().map(|(number, (name, text))| {
        let fits = extension(&name) == extension(to) || of_ending.is_none() || is_alone;
        if number == 0 && fits {
            (to.to_owned(), text)
        } else {
            (folder.join(name), text)
        }
    });
    beside.collect()
}

/// Whether two paths lead to one file that exists.
fn is_same(a: &Path, b: &Path) -> bool {
    matches!((a.canonicalize(), b.canonicalize()), (Ok(a), Ok(b)) if a == b)
}

/// Whether a file that would be written is the input, or is named in it.
fn is_input(file: &Path, input: &Path) -> bool {
    let Ok(file) = file.canonicalize() else {
        // A file that does not exist is not overwritten.
        return false;
    };
    let Ok(input) = input.canonicalize() else {
        return false;
    };
    let same_folder = file.parent() == input.parent();
    let name = file.file_name().unwrap_or_default().to_string_lossy();
    let named = || std::fs::read_to_string(&input).is_ok_and(|text| text.contains(&*name));
    file == input || same_folder && named()
}

fn write_files(files: &[(PathBuf, String)], terminal: &mut Terminal<'_>) -> u8 {
    let make = |file: &Path| {
        let folder = file
            .parent()
            .filter(|folder| !folder.as_os_str().is_empty());
        folder.map_or(Ok(()), make_folder)
    };
    if let Some(Err(problem)) = files.first().map(|(file, _)| make(file)) {
        terminal.report(&problem);
        return NOT_REACHED;
    }
    terminal.show("\nWritten\n");
    for (file, text) in files {
        if let Err(problem) = make(file).and_then(|()| write_text(file, text)) {
            terminal.report(&problem);
            return NOT_REACHED;
        }
        terminal.show(&format!("  {}\n", file.display()));
    }
    DONE
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_lose_folder_and_endings() {
        for (file, name) in [
            ("a/blade.blade.json", "blade"),
            ("blade.inp", "blade"),
            ("my.blade.inp", "my.blade"),
            ("blade", "blade"),
            (".csv", ".csv"),
        ] {
            assert_eq!(name_of(Path::new(file)), name);
        }
    }
}
