//! Folders in names of files that do not exist.

use std::path::Path;

use crate::error::nearest_name;

/// A folder that does not exist.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MissingFolder {
    /// Its path; the folder that would contain it exists.
    pub path: String,
    /// The name of a folder there that is near to its name.
    pub near: Option<String>,
}

impl MissingFolder {
    /// The first missing folder on the way to `path`, if there is one.
    pub fn before(path: &Path) -> Option<Self> {
        let folders = path.ancestors().skip(1);
        let named = folders.take_while(|folder| !folder.as_os_str().is_empty());
        let missing = named.take_while(|folder| !folder.exists()).last()?;
        let name = missing.file_name()?.to_string_lossy();
        let others = folders_beside(missing);
        Some(Self {
            path: missing.display().to_string(),
            near: nearest_name(&name, others.iter().map(String::as_str)).map(str::to_owned),
        })
    }

    /// The remedy, in messages about an input file that names files.
    pub fn help(&self) -> String {
        match &self.near {
            Some(near) => format!("did you mean the folder \"{near}\"?"),
            None => {
                "make the folder, or correct its name; names are relative to the folder of the \
                     naming file"
                    .to_owned()
            }
        }
    }
}

/// The names of the folders in the folder of `path`.
fn folders_beside(path: &Path) -> Vec<String> {
    let folder = path
        .parent()
        .filter(|folder| !folder.as_os_str().is_empty());
    let entries = std::fs::read_dir(folder.unwrap_or(Path::new(".")));
    let entries = entries.into_iter().flatten().filter_map(Result::ok);
    let folders = entries.filter(|entry| entry.path().is_dir());
    let mut names: Vec<_> = folders
        .filter_map(|entry| entry.file_name().into_string().ok())
        .collect();
    names.sort();
    names
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_missing_folder_is_found() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::create_dir(folder.path().join("tables")).unwrap();
        let before = |name: &str| MissingFolder::before(&folder.path().join(name));
        for present in ["a.csv", "tables/a.csv", "tables/../tables/a.csv"] {
            assert_eq!(before(present), None, "{present}");
        }
        let missing = before("table/deep/a.csv").unwrap();
        let path = folder.path().join("table").display().to_string();
        assert_eq!(missing.path, path);
        assert_eq!(missing.help(), "did you mean the folder \"tables\"?");
        let missing = before("tables/../elsewhere/a.csv").unwrap();
        assert!(missing.path.ends_with("elsewhere") && missing.near.is_none());
        assert_eq!(MissingFolder::before(Path::new("a.csv")), None);
    }
}
