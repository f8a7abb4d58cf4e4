//! The tutorials of the book: their files written into an empty folder, their commands run
//! there, and the output on the page compared with the programs' output.
//!
//! A block below a line that is only a file name in backticks and a colon is that file.
//! Blocks marked `sh` and `text` have the meaning that they have in the gallery; a block
//! marked `math` holds formulas.

use crate::gallery::{blocks, commands, missing};
use crate::workplace::{Workplace, root};

/// The file that a block of a page holds; `first` is the first line of its text, from one.
fn file_name(page: &str, first: usize) -> Option<&str> {
    let above: Vec<&str> = page.lines().take(first.saturating_sub(2)).collect();
    let label = above.iter().rev().find(|line| !line.is_empty())?;
    label.strip_prefix('`')?.strip_suffix("`:")
}

/// Runs a page in an empty folder; its files are all there before the first command. The page has
/// at least the given numbers of files, commands and compared outputs.
fn run(name: &str, least: [usize; 3]) {
    let path = format!("docs/src/{name}.md");
    let page = std::fs::read_to_string(root().join(&path)).unwrap();
    let folder = Workplace::new(&[], "");
    let (mut files, mut ran, mut compared) = (0, 0, 0);
    for (_, line, text) in blocks(&page) {
        if let Some(file) = file_name(&page, line) {
            std::fs::write(folder.path(file), text).unwrap();
            files += 1;
        }
    }
    let mut output = String::new();
    let mut wrong = Vec::new();
    for (mark, line, text) in blocks(&page) {
        if file_name(&page, line).is_some() {
            continue;
        }
        match mark {
            "sh" => {
                output.clear();
                for command in commands(&text) {
                    let run = folder.run(&command);
                    assert_eq!(run.code, 0, "{path}:{line}: {command}\n{}", run.err);
                    output += &run.out;
                    ran += 1;
                }
            }
            "text" => {
                compared += 1;
                if let Some(missing) = missing(&text, &output) {
                    wrong.push(format!(
                        "{path}:{line}: not in the output: {missing}\n{output}"
                    ));
                }
            }
            "math" => {}
            other => panic!("{path}:{line}: a block marked \"{other}\" without a file name"),
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(
        files >= least[0] && ran >= least[1] && compared >= least[2],
        "{path}: {files} files, {ran} commands, {compared} outputs"
    );
}

#[test]
fn a_beamdyn_blade_becomes_a_campbell_diagram() {
    run("tutorial-wind-blade", [2, 3, 3]);
}

#[test]
fn a_section_becomes_a_fan_plot() {
    run("tutorial-rotor-blade", [2, 3, 3]);
}

#[test]
fn a_beam_with_patches_bends_under_a_voltage() {
    run("tutorial-piezo-beam", [2, 3, 3]);
}

#[test]
fn a_turbine_has_a_power_curve() {
    run("tutorial-wind-turbine", [1, 2, 2]);
}

#[test]
fn a_propeller_has_thrust_and_power() {
    run("tutorial-propeller", [2, 2, 2]);
}

#[test]
fn files_of_a_page_are_found() {
    let page = "See `b.toml`:\n\n`a.toml`:\n\n```toml\nx = 1\n```\n\n```sh\nrun\n```\n";
    let found = blocks(page);
    assert_eq!(file_name(page, found[0].1), Some("a.toml"));
    assert_eq!(file_name(page, found[1].1), None);
}
