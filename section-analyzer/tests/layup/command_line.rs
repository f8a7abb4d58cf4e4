//! Malformed files through the command line, in the process of the test: a sound mesh, or a message with
//! the file and its line, or the name of a layer or web.

use std::ffi::OsString;
use std::path::Path;
use std::time::{Duration, Instant};

use section_analyzer::cli;

use crate::effort;
use crate::random::Random;

/// Files of each input: the first is given to the program, all of them are changed.
const INPUTS: [&[&str]; 9] = [
    &["wind_blade.layup.toml"],
    &["rotor_blade.layup.toml"],
    &["words_wind_blade.layup.toml", "demo61.csv"],
    &["words_propeller.layup.toml"],
    &["tube.windio.yaml"],
    &["windio1_iea15.yaml"],
    &["box.xml"],
    &["pipe.xml"],
    &[
        "mh104.xml",
        "mh104_layups.xml",
        "mh104_lines.xml",
        "mh104_materials.xml",
        "mh104.dat",
    ],
];
/// The longest time of a command without optimization; 2 s are expected with it.
const LONGEST: Duration = Duration::from_secs(60);

/// The text of a file of the tests.
fn text(name: &str) -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let folders = [
        "tests/layup/files",
        "tests/layup/files/prevabs",
        "../tests/reference/layups",
    ];
    let mut paths = folders.iter().map(|folder| root.join(folder).join(name));
    let path = paths.find(|path| path.exists()).expect("a file");
    std::fs::read_to_string(path).expect("a text")
}

/// Exit code, output and messages of a command.
struct Ended {
    code: u8,
    err: String,
}

/// Runs the program.
fn run(arguments: &[&str]) -> Ended {
    let all = ["section-analyzer"].iter().chain(arguments);
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let code = cli::run(all.map(OsString::from), &mut out, &mut err);
    let err = String::from_utf8(err).expect("a text");
    Ended { code, err }
}

/// The ranges of the numbers in a text.
fn numbers(text: &str) -> Vec<std::ops::Range<usize>> {
    let is_part = |byte: u8| byte.is_ascii_digit() || b".+-eE".contains(&byte);
    let bytes = text.as_bytes();
    let mut found = Vec::new();
    let mut at = 0;
    while at < bytes.len() {
        let length = bytes[at..]
            .iter()
            .take_while(|byte| is_part(**byte))
            .count();
        let is_word = at > 0 && (bytes[at - 1].is_ascii_alphanumeric() || bytes[at - 1] == b'_');
        if !is_word && text[at..at + length].parse::<f64>().is_ok() {
            found.push(at..at + length);
        }
        at += length.max(1);
    }
    found
}

/// A number in place of another one.
fn other_number(number: &str, random: &mut Random) -> String {
    let value: f64 = number.parse().expect("a number");
    match random.below(8) {
        0 => (-value).to_string(),
        1 => "nan".into(),
        2 => "1e300".into(),
        3 => "0".into(),
        4 => "-1e-300".into(),
        5 => (value * 10.0_f64.powf(random.range(-3.0, 3.0))).to_string(),
        6 => (value + random.range(-0.3, 0.3)).to_string(),
        _ => "99999999999999999999".into(),
    }
}

/// The text with one change.
fn damaged(text: &str, random: &mut Random) -> String {
    let pick = |all: Vec<usize>, random: &mut Random| all[random.below(all.len())];
    match random.below(13) {
        kind @ 0..=2 => with_other_lines(text, kind, random),
        // as by a full disk
        3 => text.chars().take(random.below(text.len())).collect(),
        // a list without its last value
        4 => {
            let commas = text.match_indices(',').map(|one| one.0);
            let at = pick(commas.chain([text.len()]).collect(), random);
            let end = text[at..]
                .find([']', '\n'])
                .map_or(text.len(), |end| at + end);
            [&text[..at], &text[end..]].concat()
        }
        // a word without one of its letters
        5 => {
            let letters = text
                .char_indices()
                .filter(|one| one.1.is_ascii_alphabetic());
            let at = pick(letters.map(|one| one.0).collect(), random);
            [&text[..at], &text[at + 1..]].concat()
        }
        kind => with_other_number(text, kind, random),
    }
}

/// The text without a line, with a line twice, or without some lines.
fn with_other_lines(text: &str, kind: usize, random: &mut Random) -> String {
    let lines: Vec<&str> = text.lines().collect();
    let line = random.below(lines.len());
    let [end, again] = match kind {
        0 => [line + 1, line + 1],
        1 => [line + 1, line],
        _ => [(line + 1 + random.below(6)).min(lines.len()); 2],
    };
    let start = if kind == 1 { end } else { line };
    [&lines[..start], &lines[again..]].concat().join("\n")
}

/// The text with another number, with two numbers exchanged, or with a number that differs by up to a third
/// of it, from which meshes follow.
fn with_other_number(text: &str, kind: usize, random: &mut Random) -> String {
    let all = numbers(text);
    let at = random.below(all.len() - 1);
    let (a, b) = (all[at].clone(), all[at + 1].clone());
    let number = &text[a.clone()];
    let (first, second) = match kind {
        6 | 7 => (other_number(number, random), &text[b.clone()]),
        8 => (text[b.clone()].to_owned(), number),
        _ => {
            let value: f64 = number.parse().expect("a number");
            (
                (value * random.range(0.67, 1.33)).to_string(),
                &text[b.clone()],
            )
        }
    };
    [
        &text[..a.start],
        &first,
        &text[a.end..b.start],
        second,
        &text[b.end..],
    ]
    .concat()
}

/// Whether a message has a file with a line, or the name of a part in quotation marks.
fn is_located(message: &str, files: &[&str]) -> bool {
    let is_line = |file: &&str| {
        let name = format!("{file}:");
        let mut all = message.match_indices(&name).map(|one| one.0 + name.len());
        all.any(|at| message[at..].starts_with(|one: char| one.is_ascii_digit()))
    };
    // a key that is missing in the whole file has no line
    let whole = files.iter().any(|file| message.contains(file));
    let of_file = ["this is no layup", "the file ends", " more problems"];
    let is_other = of_file.iter().any(|words| message.contains(words));
    files.iter().any(is_line) || whole && (is_other || message.contains(['"', '[']))
}

/// Checks the end of a command; returns whether it is done.
fn check_end(ended: &Ended, files: &[&str], of: &str) -> bool {
    let errors: Vec<&str> = ended
        .err
        .lines()
        .filter(|line| line.starts_with("error"))
        .collect();
    assert!(ended.code <= 2, "{of}: {}", ended.code);
    assert_eq!(
        ended.code == 0,
        errors.is_empty(),
        "{of}: {} {}",
        ended.code,
        ended.err
    );
    for error in errors {
        assert!(is_located(error, files), "{of}: {error}");
    }
    ended.code == 0
}

/// Meshes a section of a file, and checks the mesh and its section file; whether both are sound.
fn is_meshed(folder: &Path, files: &[&str], eta: &str, of: &str) -> bool {
    let path = |name: &str| folder.join(name).display().to_string();
    let (file, mesh, section) = (path(files[0]), path("a.msh"), path("a.section.toml"));
    let made = [
        "mesh",
        "layup",
        &file,
        "--eta",
        eta,
        "--out",
        &mesh,
        "--section",
        &section,
    ];
    let is_done = check_end(&run(&[&made[..], &["--force"]].concat()), files, of);
    if is_done {
        let checked = run(&["check", &section]);
        assert_eq!(checked.code, 0, "{of}: {}", checked.err);
    }
    is_done
}

/// 30 files (300 in the long form) with a change: keys removed, given twice or misspelled,
/// numbers negative, no number, huge, zero or exchanged, lists shortened, files cut. `mesh layup` ends
/// with a mesh that passes `check`, or refuses the file; so do `layup` and `blade --check`. A third of
/// the files is refused at least, and a fifth meshed: else the changes are too harsh, or have no effect.
#[test]
fn malformed_files_are_meshed_or_refused() {
    let (mut meshed, mut refused, mut longest) = (0, 0, Duration::ZERO);
    let count = effort::cases(30);
    for seed in 0..count {
        let mut random = Random::new(52_000 + seed as u64);
        let files = INPUTS[seed % INPUTS.len()];
        let mut texts: Vec<String> = files.iter().map(|file| text(file)).collect();
        let which = random.below(files.len());
        texts[which] = damaged(&texts[which], &mut random);
        let folder = tempfile::tempdir().expect("a folder");
        for (file, text) in files.iter().zip(&texts) {
            std::fs::write(folder.path().join(file), text).expect("a file");
        }
        let of = format!("seed {seed}, {}", files[0]);
        println!("{of}");
        let eta = format!("{:.3}", random.unit());
        let start = Instant::now();
        let is_sound = is_meshed(folder.path(), files, &eta, &of);
        longest = longest.max(start.elapsed());
        let file = folder.path().join(files[0]).display().to_string();
        let other = match seed % 2 {
            0 => run(&["layup", &file, "--eta", &eta]),
            _ => run(&[
                "blade",
                &file,
                "--check",
                "--stations",
                &eta,
                "--threads",
                "1",
            ]),
        };
        // one section has no line
        let is_done = check_end(&other, files, &of);
        assert!(
            is_done == is_sound || !is_done && seed % 2 == 1,
            "{of}: {}",
            other.err
        );
        *[&mut refused, &mut meshed][usize::from(is_sound)] += 1;
    }
    println!("{meshed} meshed, {refused} refused, longest {longest:?}");
    assert!(
        3 * refused >= count && 5 * meshed >= count,
        "{meshed} {refused}"
    );
    assert!(longest < LONGEST, "{longest:?}");
}
