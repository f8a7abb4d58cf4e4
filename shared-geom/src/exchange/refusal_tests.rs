//! Messages of the readers about files with problems.

use std::path::Path;

use super::samples::{blade, written};
use super::{Format, Options, read_with};

/// The messages for the files of the sample blade, with a changed file at `index`.
fn refused(format: Format, index: usize, change: impl Fn(&str) -> String) -> String {
    let folder = tempfile::tempdir().unwrap();
    let first = written(&blade(), format, folder.path());
    let writing = super::write(&blade(), format, "sample").unwrap();
    let (name, text) = &writing.files[index];
    let changed = change(text);
    assert_ne!(&changed, text, "the change changes something");
    std::fs::write(folder.path().join(name), changed).unwrap();
    let problems = read_with(&first, &Options::default()).unwrap_err();
    let folder = format!("{}/", folder.path().display());
    problems.to_string().replace(&folder, "")
}

fn assert_says(messages: &str, expected: &str) {
    assert!(
        messages.contains(expected),
        "expected {expected:?} in:\n{messages}"
    );
}

/// `text` with line `number` (from one) replaced by `change`.
fn with_line(text: &str, number: usize, change: impl Fn(&str) -> String) -> String {
    let lines = text.lines().enumerate();
    let lines = lines.map(|(i, line)| {
        if i + 1 == number {
            change(line)
        } else {
            line.to_owned()
        }
    });
    lines.collect::<Vec<_>>().join("\n") + "\n"
}

fn until(text: &str, lines: usize) -> String {
    text.lines().take(lines).collect::<Vec<_>>().join("\n")
}

// The blade file has 13 lines of header, then 15 per station: eta, 6, blank, 6, blank.
#[test]
fn a_beamdyn_blade_file_cut_short_is_reported_with_line_and_count() {
    let messages = refused(Format::BeamDyn, 1, |text| until(text, 13 + 15 + 3));
    assert_says(
        &messages,
        "sample_blade.dat:31: the file ends within the stiffness of station 2, after 2 of 6 rows, \
         expected rows of six numbers",
    );
    assert_says(&messages, "help: the file may have been cut off");
    let messages = refused(Format::BeamDyn, 1, |text| until(text, 13 + 2 * 15));
    assert_says(
        &messages,
        "the file ends within the table of stations, after 2 of 5",
    );
}

#[test]
fn all_problems_of_a_beamdyn_blade_file_are_reported_at_once() {
    let messages = refused(Format::BeamDyn, 1, |text| {
        let text = with_line(text, 15, |line| format!("{line} 1.0"));
        let text = with_line(&text, 16, |_| "1 2 x 4 nan 6".to_owned());
        with_line(&text, 44, |_| "0.01".to_owned())
    });
    for expected in [
        "sample_blade.dat:15: stiffness of station 1, row 1: expected 6 numbers, found 7",
        "sample_blade.dat:16: stiffness of station 1, row 2: expected a finite number, found \"x\"",
        "sample_blade.dat:16: stiffness of station 1, row 2: expected a finite number, found \"nan\"",
        "sample_blade.dat:44: position eta of station 3 is 0.01, expected at least the value of \
         the previous station, 0.13",
        "help: put the stations in order from the root to the tip",
    ] {
        assert_says(&messages, expected);
    }
}

#[test]
fn problems_of_both_beamdyn_files_are_reported_at_once() {
    let folder = tempfile::tempdir().unwrap();
    let first = written(&blade(), Format::BeamDyn, folder.path());
    let primary = std::fs::read_to_string(&first).unwrap();
    std::fs::write(
        &first,
        until(&primary, 25) + "\n\"sample_blade.dat\" BldFile\n",
    )
    .unwrap();
    std::fs::write(folder.path().join("sample_blade.dat"), "x\n").unwrap();
    let messages = read_with(&first, &Options::default())
        .unwrap_err()
        .to_string();
    assert_says(&messages, "sample.inp");
    assert_says(&messages, "key point");
    assert_says(&messages, "the line of \"station_total\" is missing");
    assert_says(&messages, "the line of \"damp_type\" is missing");
}

#[test]
fn a_beamdyn_primary_with_points_out_of_order_or_without_blade_file_is_refused() {
    let messages = refused(Format::BeamDyn, 0, |text| {
        with_line(text, 27, |_| "0 0 1.0 0".to_owned())
    });
    assert_says(
        &messages,
        "sample.inp:27: kp_zr of key point 3: found 1, expected more than",
    );
    let messages = refused(Format::BeamDyn, 0, |text| text.replace("BldFile", "Other"));
    assert_says(&messages, "the name of the blade file is missing");
    let messages = refused(Format::BeamDyn, 0, |text| {
        text.replace("sample_blade.dat", "nowhere.dat")
    });
    assert_says(
        &messages,
        "BldFile: no file \"nowhere.dat\"\n  help: files there: sample_blade.dat",
    );
    let messages = refused(Format::BeamDyn, 0, |text| {
        text.replace("sample_blade.dat", "sampel_blade.dat")
    });
    assert_says(&messages, "help: did you mean \"sample_blade.dat\"?");
}

#[test]
fn a_matrix_that_is_not_symmetric_is_refused() {
    let messages = refused(Format::BeamDyn, 1, |text| {
        with_line(text, 15, |_| "1e9 5e8 0 0 0 0".to_owned())
    });
    assert_says(
        &messages,
        "sample_blade.dat:15: stiffness of station 1 at (1, 2) and (2, 1)",
    );
}

#[test]
fn a_dymore_table_with_other_columns_words_or_order_is_refused() {
    let messages = refused(Format::Dymore, 0, |text| {
        let text = with_line(text, 9, |line| format!("{line} 7"));
        let text = with_line(&text, 10, |line| line.replacen('e', "x", 1));
        with_line(&text, 11, |line| {
            let mut words: Vec<_> = line.split_whitespace().collect();
            words[28] = "-0.5";
            words.join(" ")
        })
    });
    assert_says(
        &messages,
        "sample.dym:9: station 2: expected 29 numbers, found 30",
    );
    assert_says(
        &messages,
        "sample.dym:10: station 3: expected a finite number, found",
    );
    assert_says(
        &messages,
        "sample.dym:11: eta of station 4 is -0.5, expected at least",
    );
    let messages = refused(Format::Dymore, 0, |text| {
        text.replace("# line:", "# lines:")
    });
    assert_says(
        &messages,
        "the reference line of the blade (a DYMORE table has the matrices only)",
    );
    let messages = refused(Format::Dymore, 0, |text| until(text, 8));
    assert_says(
        &messages,
        "the file ends within the table, which has 1 lines",
    );
}

#[test]
fn a_table_that_does_not_state_what_it_means_is_refused() {
    for (key, shown) in [
        ("units", "the statement of units is missing"),
        ("frame", "the statement of frame is missing"),
        ("order", "the statement of order is missing"),
        (
            "reference point",
            "the statement of reference point is missing",
        ),
    ] {
        let messages = refused(Format::Csv, 0, |text| {
            let stays = |line: &&str| !line.starts_with(&format!("# {key}:"));
            text.lines().filter(stays).collect::<Vec<_>>().join("\n")
        });
        assert_says(&messages, shown);
        assert_says(&messages, &format!("such as \"# {key}:"));
    }
    let messages = refused(Format::Csv, 0, |text| {
        text.replace("# frame: helicoid", "# frame: beamdin")
    });
    assert_says(&messages, "sample.csv:4: frame: found \"beamdin\"");
    assert_says(&messages, "did you mean \"beamdyn\"?");
    let messages = refused(Format::Csv, 0, |text| {
        text.replace("# units: SI", "# units: US")
    });
    assert_says(&messages, "units: found \"US\", expected \"SI\"");
}

#[test]
fn a_table_with_other_columns_or_order_is_refused() {
    let messages = refused(Format::Csv, 0, |text| {
        text.replace("K12 [N],K13 [N]", "K13 [N],K12 [N]")
    });
    assert_says(
        &messages,
        "43, of which number 3 is \"K13 [N]\", expected 43, with \"K12 [N]\" there",
    );
    let messages = refused(Format::Csv, 0, |text| {
        let rows = text.lines().count();
        with_line(text, rows, |line| {
            format!("1.02{}", line.trim_start_matches(|letter| letter != ','))
        })
    });
    assert_says(&messages, "arc length s of station 5 is 1.02");
    let messages = refused(Format::Csv, 0, |text| {
        text.replace("table,stations", "table,station")
    });
    assert_says(&messages, "did you mean \"stations\"?");
}

#[test]
fn a_vabs_output_cut_short_or_without_timoshenko_model_is_refused() {
    let messages = refused(Format::Vabs, 2, |text| {
        text.replace("Timoshenko Stiffness", "Classical Stiffness")
    });
    assert_says(
        &messages,
        "the block \"Timoshenko Stiffness Matrix\" is missing",
    );
    assert_says(&messages, "timoshenko flag 1");
    let messages = refused(Format::Vabs, 3, |text| until(text, 14));
    assert_says(
        &messages,
        "sample.003.K:14: the file ends within the block \"The 6X6 Mass Matrix\"",
    );
}

#[test]
fn a_file_of_no_known_format_is_reported_what_was_tried() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("notes.txt");
    std::fs::write(&path, "\n dear colleague\n").unwrap();
    let messages = read_with(&path, &Options::default())
        .unwrap_err()
        .to_string();
    assert_says(
        &messages,
        "it begins with \"dear colleague\", tried Helicoid blade file",
    );
    assert_says(&messages, "BeamDyn (OpenFAST) blade");
    std::fs::write(&path, "\n").unwrap();
    let messages = read_with(&path, &Options::default())
        .unwrap_err()
        .to_string();
    assert_says(
        &messages,
        "the file is empty, expected one of the formats Helicoid blade file",
    );
    assert!(read_with(Path::new("/no/such/file"), &Options::default()).is_err());
}

#[test]
fn a_table_cut_short_or_with_a_column_too_few_is_refused() {
    let messages = refused(Format::Csv, 0, |text| until(text, text.lines().count() - 1));
    assert_says(
        &messages,
        "the file ends within the table of stations, after 4 of 5, expected 5 stations, as the \
         header states",
    );
    let messages = refused(Format::Csv, 0, |text| {
        text.replace("stations: 5", "stations: 4")
    });
    assert_says(
        &messages,
        "found 5 stations, expected 4, as the header states",
    );
    let messages = refused(Format::Csv, 0, |text| {
        let rows = text.lines().count();
        with_line(text, rows, |line| {
            line.rsplit_once(',').unwrap().0.to_owned()
        })
    });
    assert_says(
        &messages,
        "station 5: expected 43 numbers, found 42\n  help: columns are separated by commas",
    );
    // The index of section files is checked too.
    let messages = refused(Format::Vabs, 0, |text| {
        until(text, text.lines().count() - 1)
    });
    assert_says(&messages, "the table of stations, after 4 of 5");
    let messages = refused(Format::Vabs, 0, |text| {
        text.replace("sample.002.K", "sample.02.K")
    });
    assert_says(
        &messages,
        "section 2: no file \"sample.02.K\"\n  help: did you mean \"sample.002.K\"?",
    );
}

// The line of eta of station 2 is the 29th: 13 lines of header, 15 of station 1.
#[test]
fn a_stiffness_that_is_not_positive_definite_is_reported_once_with_its_line() {
    let folder = tempfile::tempdir().unwrap();
    let first = written(&blade(), Format::BeamDyn, folder.path());
    let file = folder.path().join("sample_blade.dat");
    let text = std::fs::read_to_string(&file).unwrap();
    let negative = |line: &str| {
        let end = line.trim_start().split_once(' ').unwrap().1.to_owned();
        format!("-1e6 {end}")
    };
    std::fs::write(&file, with_line(&text, 30, negative)).unwrap();
    let problems = super::read(&first).unwrap_err();
    assert_eq!(problems.iter().count(), 1, "{problems}");
    let shown = problems.to_string();
    assert_says(&shown, "sample_blade.dat:29: station 2 at ");
    assert_says(&shown, "stiffness");
}

#[test]
fn a_length_that_is_not_used_is_remarked() {
    let folder = tempfile::tempdir().unwrap();
    let first = written(&blade(), Format::BeamDyn, folder.path());
    let remarks = |length: f64| {
        let options = Options {
            length: Some(length),
            ..Options::default()
        };
        read_with(&first, &options).unwrap().1.remarks
    };
    let reported =
        "the length 20 m that was given is not used: the file has a line of its own, 11.";
    assert!(
        remarks(20.0)
            .iter()
            .any(|remark| remark.starts_with(reported))
    );
    assert!(
        remarks(blade().length())
            .iter()
            .all(|remark| !remark.contains("not used"))
    );
}

// One number of each file at a time, except small ones, too large to be squared: it is
// refused, or, outside of matrices, nothing infinite results.
#[test]
fn numbers_that_cannot_be_squared_are_refused_in_every_format() {
    let mut refused = 0;
    for format in Format::ALL
        .into_iter()
        .filter(|format| format.is_read() && format.is_written())
    {
        let folder = tempfile::tempdir().unwrap();
        let first = written(&blade(), format, folder.path());
        for (name, text) in super::write(&blade(), format, "sample").unwrap().files {
            let is_number = |word: &&str| word.parse::<f64>().is_ok_and(|x| x.abs() > 1e3);
            let separators = |letter: char| letter.is_whitespace() || ",[]".contains(letter);
            let words: std::collections::BTreeSet<_> =
                text.split(separators).filter(is_number).collect();
            for word in words.into_iter().step_by(7) {
                let changed = text.replacen(word, "-1e308", 1);
                std::fs::write(folder.path().join(&name), changed).unwrap();
                match read_with(&first, &Options::default()) {
                    Err(problems) => {
                        assert!(!problems.to_string().contains("no reason was noted"));
                        refused += 1;
                    }
                    Ok((_, reading)) => {
                        let numbers = reading.blade.stations.iter();
                        let numbers = numbers.flat_map(|one| one.stiffness.iter().chain(&one.mass));
                        assert!(
                            numbers.copied().all(|x| x.abs() <= 1e100),
                            "{format:?} {word}"
                        );
                    }
                }
            }
            std::fs::write(folder.path().join(&name), &text).unwrap();
        }
    }
    assert!(refused > 50, "{refused}");
    let messages = refused_station(1e308);
    assert_says(
        &messages,
        "stiffness holds 1e308, expected numbers of at most 1e100 in magnitude",
    );
    assert_says(
        &messages,
        "help: the number may have lost its decimal point",
    );
}

/// Message on a stiffness in the last station of a table.
fn refused_station(entry: f64) -> String {
    let mut wrong = blade();
    if let Some(last) = wrong.stations.last_mut() {
        last.stiffness[(0, 0)] = entry;
    }
    let folder = tempfile::tempdir().unwrap();
    let first = written(&wrong, Format::Csv, folder.path());
    read_with(&first, &Options::default())
        .unwrap_err()
        .to_string()
}

/// Numbers of all stations that are too large are one problem, with its stations.
#[test]
fn numbers_that_many_stations_share_are_one_problem() {
    let folder = tempfile::tempdir().unwrap();
    let first = written(&blade(), Format::BeamDyn, folder.path());
    let path = folder.path().join("sample_blade.dat");
    let text = std::fs::read_to_string(&path).unwrap();
    // The first row of each stiffness, after the line of its station.
    let mut of_station = None;
    let lines = text.lines().enumerate().map(|(i, line)| {
        let numbers: Vec<_> = line.split_whitespace().collect();
        if i >= 13 && numbers.len() == 1 {
            of_station = Some(i);
        }
        if of_station == Some(i.wrapping_sub(1)) && numbers.len() == 6 {
            line.replacen(numbers[0], "1e150", 1)
        } else {
            line.to_owned()
        }
    });
    let changed: Vec<_> = lines.collect();
    std::fs::write(&path, changed.join("\n")).unwrap();
    let messages = read_with(&first, &Options::default()).unwrap_err();
    assert_eq!(messages.iter().count(), 1, "{messages}");
    assert_says(
        &messages.to_string(),
        "all 5 stations: stiffness holds 1e150, expected numbers of at most 1e100 in magnitude",
    );
}

/// Files of the other program and other kinds are recognized.
#[test]
fn files_of_another_kind_are_recognized() {
    let folder = tempfile::tempdir().unwrap();
    for (name, text, expected) in [
        (
            "r.msh",
            "$MeshFormat\n",
            "this is a mesh, expected a blade file",
        ),
        (
            "e.section.toml",
            "",
            "this is a section file, expected a blade file",
        ),
        (
            "m.dynamics.toml",
            "",
            "this is a dynamics file, expected a blade file",
        ),
    ] {
        let path = folder.path().join(name);
        std::fs::write(&path, text).unwrap();
        let messages = read_with(&path, &Options::default()).unwrap_err();
        assert_eq!(messages.iter().count(), 1, "{messages}");
        assert_says(&messages.to_string(), expected);
    }
}
