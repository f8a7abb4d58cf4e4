//! The gallery of the book: its commands are run, its inputs agree with the cases, and
//! its output with the programs' output.
//!
//! A block marked `sh` holds commands, run in `cases/section` one after the other. The
//! next block marked `text` holds lines of their output, in their order and compared word
//! by word; a line `...` represents any number of others. A block marked `toml` is part
//! of a file of the cases.

use crate::workplace::{Workplace, root};

const PAGE: &str = "docs/src/gallery.md";

/// The blocks of a page: mark, first line (from one), text.
pub fn blocks(page: &str) -> Vec<(&str, usize, String)> {
    let mut blocks = Vec::new();
    let mut open = None;
    for (number, line) in page.lines().enumerate() {
        match (line.strip_prefix("```"), &mut open) {
            (Some(mark), None) => open = Some((mark, number + 2, String::new())),
            (Some(_), Some(_)) => blocks.extend(open.take()),
            (None, Some((_, _, text))) => {
                text.push_str(line);
                text.push('\n');
            }
            (None, None) => {}
        }
    }
    blocks
}

/// The commands of a block, with lines that end in a backslash joined.
pub fn commands(block: &str) -> Vec<String> {
    let joined = block.replace("\\\n", " ");
    let lines = joined.lines().map(str::trim);
    let commands = lines.filter(|line| !line.is_empty() && !line.starts_with('#'));
    commands.map(str::to_owned).collect()
}

/// The first line of `block` that is not in `output` in its order.
pub fn missing<'a>(block: &'a str, output: &str) -> Option<&'a str> {
    let mut rest = output.lines();
    let mut lines = block
        .lines()
        .filter(|line| !line.is_empty() && line.trim() != "...");
    let words = |line: &str| {
        line.split_whitespace()
            .map(str::to_owned)
            .collect::<Vec<_>>()
    };
    lines.find(|line| !rest.any(|found| words(found) == words(line)))
}

fn section_files(folder: &std::path::Path, texts: &mut Vec<String>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            section_files(&path, texts);
        } else if path.extension().is_some_and(|ending| ending == "toml") {
            texts.push(std::fs::read_to_string(path).unwrap());
        }
    }
}

#[test]
fn the_gallery_shows_what_the_programs_do() {
    let page = std::fs::read_to_string(root().join(PAGE)).unwrap();
    let mut inputs = Vec::new();
    section_files(&root().join("cases"), &mut inputs);
    let workplace = Workplace::new(&["cases", "meshes"], "cases/section");
    let mut output = String::new();
    let mut ran = 0;
    let mut wrong = Vec::new();
    for (mark, line, text) in blocks(&page) {
        match mark {
            "sh" => {
                output.clear();
                for command in commands(&text) {
                    let run = workplace.run(&command);
                    // 1: a goal that was not reached, such as a comparison that differs
                    assert!(run.code <= 1, "{PAGE}:{line}: {command}\n{}", run.err);
                    output += &run.out;
                    ran += 1;
                }
            }
            "text" => {
                if let Some(missing) = missing(&text, &output) {
                    wrong.push(format!(
                        "{PAGE}:{line}: not in the output: {missing}\n{output}"
                    ));
                }
            }
            "toml" => {
                let is_input = inputs.iter().any(|input| input.contains(&text));
                assert!(is_input, "{PAGE}:{line}: not part of a file of the cases");
            }
            other => panic!("{PAGE}:{line}: a block marked \"{other}\""),
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(ran >= 5, "{ran} commands");
}

#[test]
fn blocks_and_lines_are_found() {
    let page = "a\n```sh\n# why\nb \\\n  c\n\nd\n```\n```text\n  e\n...\nf\n```\n";
    let found = blocks(page);
    assert_eq!(found.len(), 2);
    assert_eq!((found[0].0, found[0].1), ("sh", 3));
    assert_eq!(commands(&found[0].2), ["b    c", "d"]);
    assert_eq!(missing(&found[1].2, "x\n  e\ny\nf\n"), None);
    assert_eq!(missing(&found[1].2, "f\n  e\n"), Some("f"));
    assert_eq!(missing(&found[1].2, "e e\nf\n"), Some("  e"));
}
