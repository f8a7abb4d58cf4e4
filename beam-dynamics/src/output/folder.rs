//! The files of one name in a folder of results: written, listed, and removed if they are out of
//! date.

use std::path::{Path, PathBuf};

use shared_geom::figure::Figure;
use shared_geom::files::{OutputProblem, make_folder, write_figure, write_text};
use shared_geom::vtk::FieldFile;

/// Endings of the files in a folder of field files; only these are removed from it.
const FIELD_ENDINGS: [&str; 2] = ["vtu", "pvd"];

/// Destination of the results of a file, and their kinds.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ResultLocation {
    /// Folder, created if it does not exist.
    pub folder: PathBuf,
    /// Beginning of the names of all files, before a dot.
    pub name: String,
    /// Whether figures are drawn. If not, figures of an earlier run are removed.
    pub figures: bool,
}

impl ResultLocation {
    /// Results called `name` in `folder`, with figures.
    pub fn new(folder: impl Into<PathBuf>, name: impl Into<String>) -> Self {
        Self {
            folder: folder.into(),
            name: name.into(),
            figures: true,
        }
    }

    /// The same, with or without figures.
    pub fn with_figures(self, figures: bool) -> Self {
        Self { figures, ..self }
    }
}

/// Files written, in order, and omitted ones.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Written {
    /// The files.
    pub files: Vec<PathBuf>,
    /// Reason for a missing fan plot that would otherwise be drawn.
    pub no_plot: Option<&'static str>,
    /// Columns omitted from the figure of a run.
    pub not_drawn: Vec<String>,
}

/// Files `NAME.*` in a folder.
#[derive(Debug)]
pub(super) struct Results<'a> {
    location: &'a ResultLocation,
    /// Files written so far; for many field files their folder.
    pub written: Written,
}

impl<'a> Results<'a> {
    /// Files at `location`, whose folder exists.
    pub fn new(location: &'a ResultLocation) -> Self {
        Self {
            location,
            written: Written::default(),
        }
    }

    /// Whether figures are drawn.
    pub fn draws(&self) -> bool {
        self.location.figures
    }

    /// Path of the file `NAME.ENDING`.
    pub fn path(&self, ending: &str) -> PathBuf {
        self.location
            .folder
            .join(format!("{}.{ending}", self.location.name))
    }

    /// Removes files of an earlier run.
    pub fn remove<'e>(&self, endings: impl IntoIterator<Item = &'e str>) {
        for ending in endings {
            // A missing file is not an error.
            let _ = std::fs::remove_file(self.path(ending));
        }
    }

    /// Removes the files of an earlier run whose endings begin and end like this, with a
    /// number between.
    pub fn remove_numbered(&self, first: &str, last: &str) {
        self.remove_between(first, last, |number| number.parse::<f64>().is_ok());
    }

    /// Removes the files of an earlier run whose endings begin and end like this, with a part
    /// between that `is_stale`.
    pub fn remove_between(&self, first: &str, last: &str, is_stale: impl Fn(&str) -> bool) {
        let first = format!("{}.{first}", self.location.name);
        remove_files(&self.location.folder, |name| {
            let part = name.strip_prefix(&first);
            let part = part.and_then(|rest| rest.strip_suffix(last));
            part.is_some_and(&is_stale)
        });
    }

    /// Removes the field files in the folder `NAME.FIELDS`, and the folder if it is then empty.
    pub fn remove_fields(&self, fields: &str) {
        let folder = self.path(fields);
        remove_files(&folder, |name| {
            let ending = Path::new(name)
                .extension()
                .and_then(|ending| ending.to_str());
            ending.is_some_and(|ending| FIELD_ENDINGS.contains(&ending))
        });
        let _ = std::fs::remove_dir(folder);
    }

    /// Writes a text.
    pub fn text(&mut self, ending: &str, text: &str) -> Result<(), OutputProblem> {
        let path = self.path(ending);
        write_text(&path, text)?;
        self.written.files.push(path);
        Ok(())
    }

    /// Saves one figure in two formats, if there is one. It is made only if figures are drawn.
    /// Returns whether it is drawn.
    pub fn figures<F: Figure>(
        &mut self,
        endings: [&str; 2],
        figure: impl FnOnce() -> Option<F>,
    ) -> Result<bool, OutputProblem> {
        let Some(figure) = self.draws().then(figure).flatten() else {
            return Ok(false);
        };
        let drawing = figure.drawing();
        for ending in endings {
            let path = self.path(ending);
            write_figure(&path, &drawing)?;
            self.written.files.push(path);
        }
        Ok(true)
    }

    /// Writes a grid into the folder `NAME.FIELDS`; returns its path from the folder of the
    /// results, for a series.
    pub fn field(
        &mut self,
        fields: &str,
        file: &str,
        grid: FieldFile,
    ) -> Result<String, OutputProblem> {
        let folder = self.path(fields);
        make_folder(&folder)?;
        grid.write(&folder.join(file))?;
        Ok(format!("{}.{fields}/{file}", self.location.name))
    }

    /// Writes a series into the folder `NAME.FIELDS`, next to its grids.
    pub fn series(&self, fields: &str, file: &str, text: &str) -> Result<(), OutputProblem> {
        write_text(&self.path(fields).join(file), text)
    }

    /// Lists the folder `NAME.FIELDS`, if there is one.
    pub fn list_fields(&mut self, fields: &str) {
        let path = self.path(fields);
        if path.is_dir() {
            self.written.files.push(path);
        }
    }
}

fn remove_files(folder: &Path, is_stale: impl Fn(&str) -> bool) {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    for entry in entries {
        if entry.file_name().to_str().is_some_and(&is_stale) {
            let _ = std::fs::remove_file(entry.path());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_own_files_are_removed() {
        let folder = tempfile::tempdir().unwrap();
        let location = ResultLocation::new(folder.path(), "x");
        let results = Results::new(&location);
        let fields = folder.path().join("x.static");
        std::fs::create_dir(&fields).unwrap();
        for file in [
            "x.a_1.png",
            "x.a_2.5.png",
            "x.a_1.a_3.png",
            "x.b.png",
            "y.a_1.png",
            "x.static/1.vtu",
        ] {
            write_text(&folder.path().join(file), "").unwrap();
        }
        write_text(&fields.join("notes.txt"), "").unwrap();
        results.remove_numbered("a_", ".png");
        results.remove_fields("static");
        let exists = |file: &str| folder.path().join(file).exists();
        assert!(!exists("x.a_1.png") && !exists("x.a_2.5.png") && !exists("x.static/1.vtu"));
        // Of a file called "x.a_1".
        assert!(exists("x.a_1.a_3.png"));
        assert!(exists("x.b.png") && exists("y.a_1.png") && exists("x.static/notes.txt"));
    }

    /// A figure without shapes.
    struct Empty;

    impl Figure for Empty {
        fn size(&self) -> (u32, u32) {
            (8, 8)
        }

        fn draw(&self, _: &mut shared_geom::figure::Drawing) {}
    }

    #[test]
    fn figures_are_not_even_made_where_they_are_left_out() {
        let folder = tempfile::tempdir().unwrap();
        let location = ResultLocation::new(folder.path(), "x");
        let mut results = Results::new(&location);
        let endings = ["png", "svg"];
        let none = results.figures(endings, || None::<Empty>);
        assert_eq!(none, Ok(false));
        assert_eq!(results.figures(endings, || Some(Empty)), Ok(true));
        assert_eq!(results.written.files, endings.map(|e| results.path(e)));
        let bare = location.clone().with_figures(false);
        let mut results = Results::new(&bare);
        let made = || -> Option<Empty> { panic!("a figure is made") };
        assert_eq!(results.figures(endings, made), Ok(false));
        assert!(results.written.files.is_empty());
        assert_eq!(folder.path().read_dir().unwrap().count(), 2);
    }
}
