//! Blade files of all formats, with the files that they name.

use std::fs;
use std::path::Path;

use shared_geom::error::Diagnostics;
use shared_geom::exchange::{Format, Options, parse, write};

use crate::mutation::{Random, mutated};
use crate::{alone, seeds, within_memory};

const MUTATIONS: usize = 200;

/// Reads `bytes` as the file `name` of `folder`.
fn read(folder: &Path, name: &str, bytes: &[u8]) -> bool {
    let text = String::from_utf8_lossy(bytes);
    let options = Options {
        length: Some(3.0),
        ..Options::default()
    };
    match parse(&text, &folder.join(name), &options) {
        Ok(_) => true,
        Err(problems) => {
            assert_explained(&problems, name);
            false
        }
    }
}

/// A reader that refuses a file must report a reason.
fn assert_explained(problems: &Diagnostics, name: &str) {
    let reported = problems.to_string();
    assert!(
        !reported.is_empty() && !reported.contains("no reason was noted"),
        "{name}: {reported}"
    );
}

/// Blades that are read are described and, if they have no problems, written in all
/// formats and read again from Helicoid's.
fn use_it(folder: &Path, name: &str, bytes: &[u8]) {
    let text = String::from_utf8_lossy(bytes);
    let options = Options {
        length: Some(3.0),
        ..Options::default()
    };
    let blade = match parse(&text, &folder.join(name), &options) {
        Ok((_, reading)) => reading.blade,
        Err(problems) => return assert_explained(&problems, name),
    };
    if !blade.problems().is_empty() {
        return;
    }
    assert!(blade.mass_moments().mass.is_finite(), "{name}");
    for format in Format::ALL.into_iter().filter(|format| format.is_written()) {
        let writing = write(&blade, format, "again").unwrap();
        assert!(!writing.files.is_empty());
        if format == Format::Helicoid {
            let again = parse(&writing.files[0].1, Path::new("again.blade.json"), &options);
            assert!(again.is_ok(), "{name}: {}", again.unwrap_err());
        }
    }
}

/// A folder with all seeds.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (name, bytes) in seeds("blade_file") {
        fs::write(folder.path().join(name), bytes).unwrap();
    }
    folder
}

#[test]
fn seeds_are_read_and_survive_being_cut() {
    let _alone = alone();
    let folder = folder();
    for (name, bytes) in seeds("blade_file") {
        let line_alone = name.ends_with(".line.csv");
        assert_ne!(read(folder.path(), &name, &bytes), line_alone, "{name}");
        for end in (0..bytes.len()).step_by(31) {
            let what = format!("{name} cut at byte {end}");
            // Files that are named in them are read too.
            let all: usize = seeds("blade_file").iter().map(|(_, seed)| seed.len()).sum();
            let mut cut = bytes[..end].to_vec();
            cut.resize(cut.len().max(1) + all, b' ');
            within_memory(&what, &cut, |bytes| read(folder.path(), &name, bytes));
        }
    }
}

#[test]
fn changed_files_are_read_or_refused() {
    let _alone = alone();
    let folder = folder();
    for (number, (name, bytes)) in seeds("blade_file").into_iter().enumerate() {
        let mut random = Random::new(number as u64);
        for _ in 0..MUTATIONS {
            let changed = mutated(&bytes, &mut random);
            use_it(folder.path(), &name, &changed);
        }
    }
}
