//! Files of any content: an input is read completely, or its problems are reported.

use std::fs;
use std::path::{Path, PathBuf};

use beam_dynamics::input;
use shared_geom::exchange::{Format, write};

/// Number of changes of each file.
const CHANGES: usize = 50;

/// Words that are not valid numbers, and words that end an input or refer to other files.
const WORDS: [&str; 8] = [
    "-1",
    "0",
    "nan",
    "1e999",
    "1e308",
    "18446744073709551615",
    "x",
    ";",
];
const LINES: [&str; 5] = [
    "exit ;",
    "continue_in_file b ;",
    "begin main_body ;",
    "[",
    "sec 1 0 0 0 0 ;",
];

/// A strip, and a blade in a file.
const MODEL: &str = "
units = \"SI\"
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
[[blade]]
name = \"a\"
properties = \"strip\"
[[blade.piece]]
length = 1
elements = 2
[modes]
speeds = 0
[[blade]]
name = \"b\"
";

/// Pseudo-random numbers: splitmix64.
struct Random(u64);

/// A number below `end`.
fn below(random: &mut Random, end: usize) -> usize {
    random.0 = random.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let z = (random.0 ^ (random.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    (z >> 33) as usize % end.max(1)
}

/// `text` with one to three lines removed, doubled, cut or with another word.
fn changed(text: &str, random: &mut Random) -> String {
    let mut lines: Vec<_> = text.lines().map(str::to_owned).collect();
    for _ in 0..=below(random, 3) {
        let at = below(random, lines.len());
        match below(random, 5) {
            0 => drop(lines.remove(at)),
            1 => lines.insert(at, lines[at].clone()),
            2 => lines.insert(at, LINES[below(random, LINES.len())].to_owned()),
            3 => lines.truncate(at + 1),
            _ => {
                let mut words: Vec<_> = lines[at].split(' ').collect();
                let index = below(random, words.len());
                words[index] = WORDS[below(random, WORDS.len())];
                lines[at] = words.join(" ");
            }
        }
        if lines.is_empty() {
            break;
        }
    }
    lines.join("\n") + "\n"
}

/// The files of a valid blade in each input format; the first file refers to the others.
fn blades() -> Vec<Vec<(PathBuf, String)>> {
    let corpus = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/fuzz/corpus/blade_file/plain.blade.json"
    );
    let reading = shared_geom::exchange::read(Path::new(corpus)).unwrap();
    let read = Format::ALL
        .into_iter()
        .filter(|format| format.is_read() && format.is_written());
    let files = read.map(|format| write(&reading.blade, format, "b").unwrap().files);
    files.collect()
}

// A valid blade, and one of a file with errors: the model has both, or the reason is
// reported.
#[test]
fn no_blade_vanishes_from_a_model() {
    let mut random = Random(3);
    let mut counts = [0; 2];
    for files in blades() {
        for _ in 0..CHANGES {
            let mut files = files.clone();
            let which = below(&mut random, files.len());
            files[which].1 = changed(&files[which].1, &mut random);
            let folder = tempfile::tempdir().unwrap();
            for (name, text) in &files {
                let path = folder.path().join(name);
                fs::create_dir_all(path.parent().unwrap()).unwrap();
                fs::write(path, text).unwrap();
            }
            let model = folder.path().join("a.dynamics.toml");
            let first = files[0].0.to_str().unwrap();
            fs::write(&model, format!("{MODEL}file = \"{first}\"\n")).unwrap();
            match input::read(&model).map_err(|problems| problems.to_string()) {
                Ok(input) => {
                    assert_eq!(input.model.blades.len(), 2);
                    counts[0] += 1;
                }
                Err(reported) => {
                    assert!(reported.starts_with("error: "), "{reported}");
                    assert!(
                        !reported.contains("no reason was noted"),
                        "{reported}\n{}",
                        files[which].1
                    );
                    counts[1] += 1;
                }
            }
        }
    }
    assert!(counts.iter().all(|count| *count > 50), "{counts:?}");
}
