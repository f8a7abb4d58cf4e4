//! Statements of htc files outside of the blade: the end of the file, other files,
//! unknown statements.

use std::fs;

use crate::blade::Blade;
use crate::error::Diagnostics;
use crate::exchange::{Format, Options, Reading, read_with};

const CLASSIC: &str = include_str!("../../../../tests/reference/exchange/hawc2_dtu10_st.dat");
const HTC: &str = include_str!("../../../../tests/reference/exchange/hawc2_dtu10.htc");

/// Result of `a.htc` in a folder of these files and the st file.
fn read(files: &[(&str, &str)]) -> Result<Reading, Diagnostics> {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| {
        let path = folder.path().join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    };
    write("hawc2_dtu10_st.dat", CLASSIC);
    for (name, text) in files {
        write(name, text);
    }
    let (format, reading) = read_with(&folder.path().join("a.htc"), &Options::default())?;
    assert_eq!(format, Format::Hawc2);
    Ok(reading)
}

fn reported(files: &[(&str, &str)]) -> String {
    read(files).unwrap_err().to_string()
}

/// The blade except its hash, which is the hash of the files.
fn plain(reading: &Reading) -> Blade {
    let mut blade = reading.blade.clone();
    blade.provenance.input_hash = String::new();
    blade
}

/// The text before the points of the line, these points, and the rest.
fn parts() -> [&'static str; 3] {
    let (from, to) = (
        HTC.find("begin c2_def").unwrap(),
        HTC.find("end c2_def").unwrap(),
    );
    [&HTC[..from], &HTC[from..to], &HTC[to..]]
}

#[test]
fn exit_ends_the_file() {
    let expected = plain(&read(&[("a.htc", HTC)]).unwrap());
    let text = format!("{HTC}exit;\nbegin main_body;\nanything at all\n");
    let reading = read(&[("a.htc", &text)]).unwrap();
    assert_eq!(plain(&reading), expected);
    assert!(
        !reading
            .remarks
            .iter()
            .any(|remark| remark.contains("outside"))
    );
    // Within a block the block has no end.
    let text = HTC.replacen("end main_body;", "exit;\nend main_body;", 1);
    assert!(reported(&[("a.htc", &text)]).contains("ends within the block \"main_body\""));
}

#[test]
fn statements_outside_of_all_blocks_are_reported_and_skipped() {
    let expected = plain(&read(&[("a.htc", HTC)]).unwrap());
    let text = format!("version 3 ;\n{HTC}sec 28 0 0 90 0 ;\na ;\nb ;\n");
    let reading = read(&[("a.htc", &text)]).unwrap();
    assert_eq!(plain(&reading), expected);
    let remark = reading
        .remarks
        .iter()
        .find(|remark| remark.contains("outside"));
    let remark = remark.unwrap();
    assert!(
        remark.contains("\"version\" (") && remark.contains("a.htc:1)"),
        "{remark}"
    );
    assert!(
        remark.contains("\"sec\"") && remark.ends_with(" and 1 more"),
        "{remark}"
    );
}

// At the top, in a block, from a folder below that names its st file from the folder
// above, and a file that only includes the others.
#[test]
fn continue_in_file_continues_there_and_comes_back() {
    let expected = plain(&read(&[("a.htc", HTC)]).unwrap());
    let [head, line, tail] = parts();
    let again = |files: &[(&str, &str)]| assert_eq!(plain(&read(files).unwrap()), expected);
    again(&[("a.htc", "continue_in_file ./b.htc ;\n"), ("b.htc", HTC)]);
    again(&[
        ("a.htc", "continue_in_file htc\\b.htc ;\n"),
        ("htc/b.htc", HTC),
    ]);
    let text = format!("{head}continue_in_file \"b.htc\" ;\n{tail}");
    let below = format!("{line}\nexit ;\nend ;\n");
    again(&[("a.htc", &text), ("b.htc", &below)]);
    let whole = "begin simulation;\nend simulation;\nContinue_In_File b.htc;\n\
                 continue_in_file c.htc;\n";
    again(&[("a.htc", whole), ("b.htc", "version 3;\n"), ("c.htc", HTC)]);
}

#[test]
fn what_is_wrong_in_another_file_is_reported_there() {
    let [head, line, tail] = parts();
    let text = format!("{head}continue_in_file b.htc ;\n{tail}");
    let slip = line.replacen("sec 3 ", "sec 3 x ", 1);
    let shown = reported(&[("a.htc", &text), ("b.htc", &slip)]);
    assert!(
        shown.contains("b.htc:5: the statement sec: expected a finite number"),
        "{shown}"
    );
    let short = line.replacen("nsec 27", "nsec 28", 1);
    let shown = reported(&[("a.htc", &text), ("b.htc", &short)]);
    assert!(
        shown.contains("b.htc:2: the file ends within c2_def"),
        "{shown}"
    );
    let shown = reported(&[("a.htc", &text)]);
    assert!(
        shown.contains("a.htc:15: the file of continue_in_file: found no file \"b.htc\""),
        "{shown}"
    );
}

// A file that includes itself, directly or by another; files that multiply.
#[test]
fn files_that_lead_back_to_themselves_are_refused() {
    let shown = reported(&[("a.htc", &format!("{HTC}continue_in_file ./a.htc ;\n"))]);
    assert!(
        shown.contains("a.htc:51: ") && shown.contains("is being read"),
        "{shown}"
    );
    let to = |name: &str| format!("continue_in_file {name} ;\n");
    let shown = reported(&[("a.htc", &to("b.htc")), ("b.htc", &to("a.htc"))]);
    assert!(
        shown.contains("b.htc:1: ") && shown.contains("is being read"),
        "{shown}"
    );
    let twice = |name: &str| to(name).repeat(2);
    let names: Vec<_> = (0..20).map(|i| format!("b{i}.htc")).collect();
    let texts: Vec<_> = (1..20).map(|i| twice(&names[i])).collect();
    let mut files: Vec<_> = names
        .iter()
        .map(String::as_str)
        .zip(texts.iter().map(String::as_str))
        .collect();
    let first = to("b0.htc");
    files.extend([("a.htc", first.as_str()), ("b19.htc", HTC)]);
    assert!(reported(&files).contains("more than 100 files"));
}

// The meaning of this damping is not public: its numbers are shown, not used.
#[test]
fn damping_that_is_not_converted_is_remarked_with_its_numbers() {
    let line = HTC
        .lines()
        .find(|line| line.contains("damping_posdef"))
        .unwrap();
    let other = "damping_aniso_v2 0 0 0 4.4e-3 6.5e-4 2.5e-4 ;";
    let reading = read(&[("a.htc", &HTC.replace(line, other))]).unwrap();
    assert!(reading.has_other_damping && reading.blade.damping.is_none());
    let reported = "\"damping_aniso_v2 0 0 0 4.4e-3 6.5e-4 2.5e-4\" is not read";
    assert!(
        reading
            .remarks
            .iter()
            .any(|remark| remark.starts_with(reported)),
        "{:?}",
        reading.remarks
    );
    // With damping_posdef, both are stated.
    let reading = read(&[("a.htc", &HTC.replace(line, &format!("{line}\n{other}")))]).unwrap();
    assert!(reading.has_other_damping && reading.blade.damping.is_some());
    assert!(!read(&[("a.htc", HTC)]).unwrap().has_other_damping);
}
