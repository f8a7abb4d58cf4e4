//! Main files of OpenFAST lead to the files of the blade.

use std::fs;
use std::path::{Path, PathBuf};

use crate::error::Diagnostics;
use crate::exchange::{Format, Options, Reading, read_with};

const MAIN: &str = include_str!("../../../../fuzz/corpus/blade_file/plain_elastodyn.fst");

fn seed(name: &str) -> PathBuf {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/fuzz/corpus/blade_file");
    Path::new(folder).join(name)
}

/// Reads `a.fst` with this text, next to the files that it names.
fn read(text: &str) -> Result<Reading, Diagnostics> {
    let folder = tempfile::tempdir().unwrap();
    for name in [
        "plain_ElastoDyn.dat",
        "plain_ElastoDyn_blade.dat",
        "plain_BeamDyn.dat",
        "plain_BeamDyn_Blade.dat",
    ] {
        fs::copy(seed(name), folder.path().join(name)).unwrap();
    }
    let path = folder.path().join("a.fst");
    fs::write(&path, text).unwrap();
    let (format, reading) = read_with(&path, &Options::default())?;
    assert_eq!(format, Format::OpenFast);
    Ok(reading)
}

/// The stations of a blade read directly.
fn direct(name: &str) -> Vec<crate::blade::Station> {
    let (_, reading) = read_with(&seed(name), &Options::default()).unwrap();
    reading.blade.stations
}

#[test]
fn the_switch_selects_the_module() {
    let elastodyn = read(MAIN).unwrap();
    assert_eq!(elastodyn.blade.stations, direct("plain_ElastoDyn.dat"));
    assert!(elastodyn.remarks[0].starts_with("the blade is read from the file of ElastoDyn"));
    let beamdyn = read(&MAIN.replace("1  CompElast", "2  CompElast")).unwrap();
    assert_eq!(beamdyn.blade.stations, direct("plain_BeamDyn.dat"));
    assert!(beamdyn.remarks[0].starts_with("the blade is read from the file of BeamDyn"));
    assert!(
        !beamdyn
            .remarks
            .iter()
            .any(|remark| remark.contains("different files"))
    );
    let other = MAIN.replace("1  CompElast", "2  CompElast").replace(
        "\"plain_BeamDyn.dat\"  BDBldFile(3)",
        "\"other.dat\"  BDBldFile(3)",
    );
    let remarks = read(&other).unwrap().remarks;
    assert!(
        remarks
            .iter()
            .any(|remark| remark.contains("blade 1 is read")),
        "{remarks:?}"
    );
}

#[test]
fn wrong_main_files_are_refused_with_their_line() {
    for (from, to, expected) in [
        (
            "1  CompElast",
            "4  CompElast",
            "a.fst:4: CompElast: found \"4\"",
        ),
        ("CompElast", "Comp", "the line of \"CompElast\" is missing"),
        (
            "plain_ElastoDyn.dat",
            "plain_ElastoDin.dat",
            "did you mean \"plain_ElastoDyn.dat\"?",
        ),
        (
            "\"plain_ElastoDyn.dat\"",
            "\"\"",
            "expected the name of a file",
        ),
    ] {
        let message = read(&MAIN.replace(from, to)).unwrap_err().to_string();
        assert!(message.contains(expected), "{expected} in {message}");
    }
}
