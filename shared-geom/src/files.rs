//! Files to read; result folders and files, with errors and their remedies.

use std::io;
use std::path::{Path, PathBuf};

use crate::error::{Explain, nearest_name};
use crate::figure::{Drawing, FigureProblem};

mod earlier;
mod folder;

pub use earlier::{Earlier, removed_remarks, removed_text};
pub use folder::MissingFolder;

/// Reason for which results could not be written.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum OutputProblem {
    /// The folder cannot be made.
    #[error("folder \"{folder}\" cannot be made: {reason}")]
    Folder {
        /// The folder.
        folder: String,
        /// The reason as text.
        reason: String,
    },
    /// A file cannot be written.
    #[error("file \"{file}\" cannot be written: {reason}")]
    File {
        /// The file.
        file: String,
        /// The reason as text.
        reason: String,
    },
    /// Files that another run is writing.
    #[error(
        "\"{file}\" is locked: {} is writing results of this name into this folder",
        process.map_or("another run".to_owned(), |id| format!("the run of process {id}"))
    )]
    InUse {
        /// The locked file.
        file: String,
        /// Process that has it, if it is known.
        process: Option<u32>,
    },
    /// A figure cannot be made.
    #[error(transparent)]
    Figure(#[from] FigureProblem),
}

impl Explain for OutputProblem {
    fn help(&self) -> Option<String> {
        match self {
            Self::Folder { .. } => Some("name another folder with --out".to_owned()),
            Self::InUse { .. } => Some(
                "wait for its end, or use another folder with --out; a run that was killed locks \
                 nothing"
                    .to_owned(),
            ),
            Self::Figure(problem) => problem.help(),
            Self::File { .. } => None,
        }
    }
}

/// Makes `folder` and its parents if they do not exist.
///
/// # Errors
/// [`OutputProblem::Folder`].
pub fn make_folder(folder: &Path) -> Result<(), OutputProblem> {
    std::fs::create_dir_all(folder).map_err(|error| OutputProblem::Folder {
        folder: folder.display().to_string(),
        reason: words(&error),
    })
}

/// The content of the file at `path`. A device, which may have no end, is not a file.
///
/// # Errors
/// Errors of the system.
pub fn read_bytes(path: &Path) -> io::Result<Vec<u8>> {
    if is_device(&std::fs::metadata(path)?) {
        return Err(io::Error::other("it is a device, expected a file"));
    }
    std::fs::read(path)
}

#[cfg(unix)]
fn is_device(metadata: &std::fs::Metadata) -> bool {
    use std::os::unix::fs::FileTypeExt;
    let kind = metadata.file_type();
    kind.is_char_device() || kind.is_block_device()
}

#[cfg(not(unix))]
fn is_device(_: &std::fs::Metadata) -> bool {
    false
}

/// Writes a text file.
///
/// # Errors
/// [`OutputProblem::File`].
pub fn write_text(file: &Path, text: &str) -> Result<(), OutputProblem> {
    std::fs::write(file, text).map_err(|error| unwritable(file, &error))
}

/// Writes a text file as a whole: into a file `FILE.part` beside it, which then takes its name, so
/// that a program that is stopped leaves the earlier file or the new one. A link or device is
/// written as it is.
///
/// # Errors
/// [`OutputProblem::File`].
pub fn write_whole(file: &Path, text: &str) -> Result<(), OutputProblem> {
    let is_other = std::fs::symlink_metadata(file).is_ok_and(|about| !about.is_file());
    if is_other {
        return write_text(file, text);
    }
    let mut part = file.as_os_str().to_owned();
    part.push(".part");
    let part = PathBuf::from(part);
    let written = std::fs::write(&part, text).and_then(|()| std::fs::rename(&part, file));
    written.map_err(|error| {
        // A missing file is ignored.
        let _ = std::fs::remove_file(&part);
        unwritable(file, &error)
    })
}

/// The problem that `file` cannot be written because of `error`.
pub(crate) fn unwritable(file: &Path, error: &io::Error) -> OutputProblem {
    OutputProblem::File {
        file: file.display().to_string(),
        reason: words(error),
    }
}

/// Writes a drawing to a file, as PNG or SVG by its ending.
///
/// # Errors
/// [`OutputProblem::File`] if the file cannot be made, else [`OutputProblem::Figure`].
pub fn write_figure(file: &Path, drawing: &Drawing) -> Result<(), OutputProblem> {
    // Made first, since messages of the system are clearer than messages of the backend;
    // with one character, since a full disk accepts an empty file.
    write_text(file, " ")?;
    Ok(drawing.save(file)?)
}

/// The name of `path` without folder and `ending`, or else without `.toml`: `blade`
/// for `cases/blade.section.toml`.
pub fn name_without(path: &Path, ending: &str) -> String {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let stem = name
        .strip_suffix(ending)
        .or_else(|| name.strip_suffix(".toml"));
    stem.filter(|stem| !stem.is_empty())
        .unwrap_or(&name)
        .to_owned()
}

/// The names of the files in the folder of `path`, in order.
pub fn names_beside(path: &Path) -> Vec<String> {
    let folder = path
        .parent()
        .filter(|folder| !folder.as_os_str().is_empty());
    let Ok(entries) = std::fs::read_dir(folder.unwrap_or(Path::new("."))) else {
        return Vec::new();
    };
    let files = entries.filter_map(Result::ok);
    let files = files.filter(|entry| entry.path().is_file());
    let mut names: Vec<_> = files
        .filter_map(|entry| entry.file_name().into_string().ok())
        .collect();
    names.sort();
    names
}

/// The remedy for a missing file: the nearest name among the files of its folder with its
/// extension, or among all of them if none has it.
pub fn nearest_file(written: &str, known: &[String]) -> String {
    const SHOWN: usize = 8;
    let name = written.rsplit(['/', '\\']).next().unwrap_or(written);
    let extension = Path::new(name).extension();
    let is_alike = |known: &&String| Path::new(known).extension() == extension;
    let mut names: Vec<_> = known.iter().filter(is_alike).map(String::as_str).collect();
    let is_alone = names.is_empty() && extension.is_some() && !known.is_empty();
    if names.is_empty() {
        names.extend(known.iter().map(String::as_str));
    }
    if let Some(near) = nearest_name(name, names.iter().copied()) {
        return format!("did you mean \"{near}\"?");
    }
    let shown = names[..names.len().min(SHOWN)].join(", ");
    let more = if names.len() > SHOWN {
        ", and more"
    } else {
        ""
    };
    match (is_alone, names.is_empty()) {
        (_, true) => {
            "names are relative to the folder of the naming file; there is no file".to_owned()
        }
        (true, _) => {
            let extension = extension.unwrap_or_default().to_string_lossy();
            format!("no file there ends in .{extension}; files there: {shown}{more}")
        }
        _ => format!("files there: {shown}{more}"),
    }
}

/// The same path for all ways to write `folder`: absolute, with links followed as far as
/// they exist.
pub fn true_path(folder: &Path) -> PathBuf {
    let absolute = std::path::absolute(folder).unwrap_or_else(|_| folder.to_owned());
    let found = absolute.ancestors().find_map(|above| {
        let true_above = above.canonicalize().ok()?;
        Some(true_above.join(absolute.strip_prefix(above).ok()?))
    });
    found.unwrap_or(absolute)
}

/// The reason of an error without its number.
fn words(error: &io::Error) -> String {
    match error.kind() {
        io::ErrorKind::PermissionDenied => "permission denied".to_owned(),
        io::ErrorKind::AlreadyExists | io::ErrorKind::NotADirectory => {
            "a file of this name exists".to_owned()
        }
        io::ErrorKind::IsADirectory => "it is a folder".to_owned(),
        io::ErrorKind::NotFound => "its folder does not exist".to_owned(),
        io::ErrorKind::StorageFull => "no space is left".to_owned(),
        _ => error.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_lose_folder_and_ending() {
        let name = |path| name_without(Path::new(path), ".section.toml");
        assert_eq!(name("a/blade.section.toml"), "blade");
        assert_eq!(name("blade.toml"), "blade");
        assert_eq!(name("blade.msh"), "blade.msh");
        assert_eq!(name(".section.toml"), ".section.toml");
    }

    #[test]
    fn what_is_in_the_way_is_reported() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("results");
        write_text(&file, "x").unwrap();
        let shown = make_folder(&file).unwrap_err().to_string();
        assert!(
            shown.ends_with("cannot be made: a file of this name exists"),
            "{shown}"
        );
        let shown = write_text(folder.path(), "x").unwrap_err().to_string();
        assert!(shown.ends_with("written: it is a folder"), "{shown}");
        let shown = write_text(&folder.path().join("no/such"), "x")
            .unwrap_err()
            .to_string();
        assert!(
            shown.ends_with("written: its folder does not exist"),
            "{shown}"
        );
    }

    /// A file that cannot be replaced keeps its content, and no part of the new one remains.
    #[test]
    fn whole_files_are_replaced_or_kept() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("a.csv");
        for text in ["one", "two"] {
            write_whole(&file, text).unwrap();
            assert_eq!(std::fs::read_to_string(&file).unwrap(), text);
        }
        assert_eq!(names_beside(&file), ["a.csv"]);
        let shown = write_whole(&folder.path().join("no/such"), "x")
            .unwrap_err()
            .to_string();
        assert!(
            shown.ends_with("written: its folder does not exist"),
            "{shown}"
        );
        #[cfg(unix)]
        {
            let link = folder.path().join("b.csv");
            std::os::unix::fs::symlink(&file, &link).unwrap();
            write_whole(&link, "three").unwrap();
            assert_eq!(std::fs::read_to_string(&file).unwrap(), "three");
        }
    }

    /// Files of the same extension are proposed before the others.
    #[test]
    fn near_files_are_proposed() {
        let help = |written: &str, known: &[&str]| {
            let known: Vec<_> = known.iter().map(|&name| name.to_owned()).collect();
            nearest_file(written, &known)
        };
        let both = ["points.png", "other.csv"];
        assert_eq!(help("a/points.csv", &both), "files there: other.csv");
        assert_eq!(help("othr.csv", &both), "did you mean \"other.csv\"?");
        assert_eq!(help("other.cvs", &both), "did you mean \"other.csv\"?");
        assert_eq!(
            help("x.csv", &["blade.toml", "hub.toml"]),
            "no file there ends in .csv; files there: blade.toml, hub.toml"
        );
        assert!(help("x.csv", &[]).ends_with("there is no file"));
        let many: Vec<_> = (0..9).map(|k| format!("blade{k}.csv")).collect();
        assert!(nearest_file("x.csv", &many).ends_with("blade7.csv, and more"));
    }

    #[test]
    fn links_to_one_folder_are_seen_through() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        std::fs::create_dir(at("a")).unwrap();
        std::fs::create_dir(at("a/deep")).unwrap();
        assert_eq!(
            true_path(&at("a/none/here")),
            true_path(&at("a/./none/here"))
        );
        assert_eq!(true_path(&at("a/deep/..")), true_path(&at("a")));
        #[cfg(unix)]
        {
            std::os::unix::fs::symlink(at("a"), at("b")).unwrap();
            assert_eq!(true_path(&at("b/results")), true_path(&at("a/results")));
        }
    }

    #[cfg(unix)]
    #[test]
    fn a_device_is_no_file() {
        let shown = read_bytes(Path::new("/dev/zero")).unwrap_err().to_string();
        assert_eq!(shown, "it is a device, expected a file");
    }

    /// A device of Linux that accepts nothing represents a full disk.
    #[cfg(target_os = "linux")]
    #[test]
    fn a_full_disk_is_reported_in_words() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("a.png");
        std::os::unix::fs::symlink("/dev/full", &file).unwrap();
        let shown = write_figure(&file, &Drawing::new((8, 8)))
            .unwrap_err()
            .to_string();
        assert!(
            shown.ends_with("a.png\" cannot be written: no space is left"),
            "{shown}"
        );
    }
}
