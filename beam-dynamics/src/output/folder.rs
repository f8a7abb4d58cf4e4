//! The files of one name in a folder of results: written, listed, and removed when
//! they are out of date.

use std::path::{Path, PathBuf};

use shared_geom::files::{OutputProblem, make_folder, write_text};
use shared_geom::vtk::FieldFile;

use super::Written;

/// Endings of what a folder of field files holds; nothing else is removed from it.
const FIELD_ENDINGS: [&str; 2] = ["vtu", "pvd"];

/// Files `NAME.*` in a folder.
#[derive(Debug)]
pub(super) struct Results<'a> {
    folder: &'a Path,
    name: &'a str,
    /// What was written so far; of many field files their folder.
    pub written: Written,
}

impl<'a> Results<'a> {
    /// Files of `name` in `folder`, which exists.
    pub fn new(folder: &'a Path, name: &'a str) -> Self {
        Self {
            folder,
            name,
            written: Written::default(),
        }
    }

    /// Path of the file `NAME.ENDING`.
    pub fn path(&self, ending: &str) -> PathBuf {
        self.folder.join(format!("{}.{ending}", self.name))
    }

    /// Removes files of an earlier run.
    pub fn remove<'e>(&self, endings: impl IntoIterator<Item = &'e str>) {
        for ending in endings {
            // One that does not exist is no problem.
            let _ = std::fs::remove_file(self.path(ending));
        }
    }

    /// Removes the files of an earlier run whose endings begin and end like this.
    pub fn remove_between(&self, first: &str, last: &str) {
        let first = format!("{}.{first}", self.name);
        remove_files(self.folder, |name| {
            name.starts_with(&first) && name.ends_with(last)
        });
    }

    /// Removes the field files in the folder `NAME.FIELDS`, and the folder if that was
    /// all in it.
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

    /// Writes one figure in two formats.
    pub fn figures(
        &mut self,
        endings: [&str; 2],
        save: impl Fn(&Path) -> Result<(), OutputProblem>,
    ) -> Result<(), OutputProblem> {
        for ending in endings {
            let path = self.path(ending);
            save(&path)?;
            self.written.files.push(path);
        }
        Ok(())
    }

    /// Writes a grid into the folder `NAME.FIELDS`; gives its path from the folder of
    /// the results, for a series.
    pub fn field(
        &mut self,
        fields: &str,
        file: &str,
        grid: FieldFile,
    ) -> Result<String, OutputProblem> {
        let folder = self.path(fields);
        make_folder(&folder)?;
        grid.write(&folder.join(file))?;
        Ok(format!("{}.{fields}/{file}", self.name))
    }

    /// Writes a series into the folder `NAME.FIELDS`, beside its grids.
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
        let results = Results::new(folder.path(), "x");
        let fields = folder.path().join("x.static");
        std::fs::create_dir(&fields).unwrap();
        for file in [
            "x.a_1.png",
            "x.a_2.png",
            "x.b.png",
            "y.a_1.png",
            "x.static/1.vtu",
        ] {
            write_text(&folder.path().join(file), "").unwrap();
        }
        write_text(&fields.join("notes.txt"), "").unwrap();
        results.remove_between("a_", ".png");
        results.remove_fields("static");
        let exists = |file: &str| folder.path().join(file).exists();
        assert!(!exists("x.a_1.png") && !exists("x.a_2.png") && !exists("x.static/1.vtu"));
        assert!(exists("x.b.png") && exists("y.a_1.png") && exists("x.static/notes.txt"));
    }
}
