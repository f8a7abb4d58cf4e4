//! Files for tests: a text with other files in its folder, and the problems reported.

use std::fs;

use super::{Input, read};

/// A strip in SI units: 2 kg/m.
pub(super) const STRIP: &str = "
[properties.strip]
ea = 7e6
gay = 2e6
gaz = 1e6
gj = 30
eiy = 40
eiz = 900
m = 2
iy = 0.01
iz = 0.04
";

/// Reads `text` as `a.dynamics.toml`, with other files in its folder; problems as they are
/// shown, with the names of files as written.
pub(super) fn read_beside(text: &str, files: &[(&str, &str)]) -> Result<Input, String> {
    let folder = tempfile::tempdir().expect("a folder");
    for (name, text) in files {
        let path = folder.path().join(name);
        fs::create_dir_all(path.parent().expect("within the folder")).expect("a folder");
        fs::write(path, text).expect("a file");
    }
    let path = folder.path().join("a.dynamics.toml");
    fs::write(&path, text).expect("a file");
    let prefix = format!("{}/", folder.path().display());
    read(&path).map_err(|problems| problems.to_string().replace(&prefix, ""))
}

/// The problems reported for a text that must not be accepted.
#[track_caller]
pub(super) fn reported(found: Result<Input, String>) -> String {
    match found {
        Err(shown) => shown,
        Ok(_) => panic!("accepted"),
    }
}
