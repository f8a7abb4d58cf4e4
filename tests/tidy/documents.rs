//! References of the documents must exist: paths, links, citations, equations, pages.

use std::collections::BTreeSet;

use crate::source::is_word;
use crate::tree::{File, Tree};

const ARCHITECTURE: &str = "ARCHITECTURE.md";
const BIBLIOGRAPHY: &str = "docs/src/bibliography.md";
const BOOK: &str = "docs/src/";
const CRATES: [&str; 5] = [
    "shared-geom",
    "section-analyzer",
    "rotor-aero",
    "sparse-solver",
    "beam-dynamics",
];

/// Endings by which a name without a slash is recognized as a file.
const FILE_ENDINGS: [&str; 8] = [
    ".rs", ".md", ".toml", ".json", ".csv", ".msh", ".geo", ".cff",
];

/// Lines of a Markdown page outside code fences: number (from zero) and text.
fn prose_lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let mut fenced = false;
    text.lines().enumerate().filter(move |(_, line)| {
        let is_fence = line.trim_start().starts_with("```");
        fenced ^= is_fence;
        !fenced && !is_fence
    })
}

/// The line with its code spans blanked out.
fn without_code(line: &str) -> String {
    let pieces = line.split('`').enumerate();
    let kept = pieces.map(|(i, piece)| {
        if i % 2 == 0 {
            piece.to_owned()
        } else {
            " ".repeat(piece.len())
        }
    });
    kept.collect::<Vec<_>>().join("`")
}

/// Paths in backticks in ARCHITECTURE.md that do not exist, from the root or, below a
/// heading that names a crate, from that crate or its `src`.
pub fn architecture(tree: &Tree) -> Vec<String> {
    let Some(page) = tree.file(ARCHITECTURE) else {
        return vec![format!("{ARCHITECTURE}:1: the file is missing")];
    };
    let mut breaches = Vec::new();
    let mut owner = None;
    for (line, text) in prose_lines(&page.text) {
        if text.starts_with('#') {
            owner = CRATES.iter().find(|name| text.contains(**name));
        }
        for path in text
            .split('`')
            .skip(1)
            .step_by(2)
            .filter(|span| is_path(span))
        {
            let below = |folder: String| tree.has(&format!("{folder}/{path}"));
            let owned =
                owner.is_some_and(|name| below(format!("{name}/src")) || below(name.to_string()));
            if !tree.has(path) && !owned {
                breaches.push(page.breach(line, &format!("\"{path}\" does not exist")));
            }
        }
    }
    breaches
}

fn is_path(span: &str) -> bool {
    let is_plain = |c: char| is_word(c) || "./-".contains(c);
    let is_known = span.contains('/') || FILE_ENDINGS.iter().any(|ending| span.ends_with(ending));
    is_known && span.len() > 1 && span.chars().all(is_plain) && !span.starts_with(['.', '-', '/'])
        || span.starts_with(".ci/")
}

/// Citation keys missing in the bibliography, and uncited entries.
///
/// A key with a year, such as `Name1999` in brackets, is searched in every source and
/// page; a key without a year in the pages of the book and below `# References` in
/// sources.
pub fn citations(tree: &Tree) -> Vec<String> {
    let Some(bibliography) = tree.file(BIBLIOGRAPHY) else {
        return vec![format!("{BIBLIOGRAPHY}:1: the file is missing")];
    };
    let entries: BTreeSet<&str> = prose_lines(&bibliography.text)
        .filter_map(|(_, line)| line.strip_prefix("### "))
        .collect();
    let mut breaches = Vec::new();
    let mut cited = BTreeSet::new();
    for file in tree
        .files
        .iter()
        .filter(|file| file.is_rust() || file.is_markdown())
    {
        for (line, key) in keys(file) {
            if !entries.contains(key.as_str()) {
                let message = format!("citation [{key}] is not in {BIBLIOGRAPHY}");
                breaches.push(file.breach(line, &message));
            }
            cited.insert(key);
        }
    }
    for (line, text) in prose_lines(&bibliography.text) {
        if let Some(key) = text.strip_prefix("### ")
            && !cited.contains(key)
        {
            breaches.push(bibliography.breach(line, &format!("nothing cites [{key}]")));
        }
    }
    breaches
}

/// Citation keys of a file with their lines (from zero).
fn keys(file: &File) -> Vec<(usize, String)> {
    let mut found = Vec::new();
    let mut in_references = false;
    for (line, text) in written_lines(file) {
        let heading = text.trim_start().trim_start_matches(['/', '!', ' ']);
        if file.is_rust() && (heading.starts_with("# ") || !text.starts_with("//")) {
            in_references = heading.starts_with("# References");
        }
        let bare_counts = in_references || file.path.starts_with(BOOK);
        for (content, behind) in brackets(&text) {
            let key = content.trim_matches(['\\', '`']);
            let is_definition = text.starts_with('[') && behind.starts_with(": ");
            let is_link = behind.starts_with('(') || is_definition;
            if (has_year(key) || bare_counts && is_name(key)) && !is_link {
                found.push((line, key.to_owned()));
            }
        }
    }
    found
}

/// The text of a file: comments of a source, lines of a page outside code.
fn written_lines(file: &File) -> Vec<(usize, String)> {
    if file.is_markdown() {
        let lines = prose_lines(&file.text);
        return lines
            .map(|(line, text)| (line, without_code(text)))
            .collect();
    }
    let comments = file.text.lines().map(|text| {
        let start = text.trim_start();
        let behind = start.find(" // ").map_or("", |at| &start[at + 1..]);
        if start.starts_with("//") {
            start
        } else {
            behind
        }
    });
    comments.map(str::to_owned).enumerate().collect()
}

/// The content of each pair of brackets, and the text after them.
fn brackets(text: &str) -> Vec<(&str, &str)> {
    let opened = text.match_indices('[').map(|(at, _)| &text[at + 1..]);
    opened.filter_map(|rest| rest.split_once(']')).collect()
}

/// `Name1999` or `Name1999a`.
fn has_year(key: &str) -> bool {
    let stem = key.trim_end_matches(|c: char| c.is_ascii_lowercase());
    let name = stem.trim_end_matches(|c: char| c.is_ascii_digit());
    let year = &stem[name.len()..];
    let is_suffix = key.len() - stem.len() <= 1;
    is_suffix && is_name(name) && year.len() == 4 && year.starts_with(['1', '2'])
}

/// A capital and at least two more letters.
fn is_name(key: &str) -> bool {
    key.len() > 2
        && key.starts_with(|c: char| c.is_ascii_uppercase())
        && key.chars().all(|c| c.is_ascii_alphabetic())
}

/// Cited equations, `(S-7)` or `(D-7)`, missing in the book, and numbers given twice.
pub fn equations(tree: &Tree) -> Vec<String> {
    let mut breaches = Vec::new();
    let mut numbered = BTreeSet::new();
    for page in tree.files.iter().filter(|file| file.path.starts_with(BOOK)) {
        for (line, text) in page.text.lines().enumerate() {
            if let Some(number) = ending_number(text)
                && !numbered.insert(number)
            {
                breaches.push(page.breach(line, &format!("equation ({number}) is given twice")));
            }
        }
    }
    for file in tree
        .files
        .iter()
        .filter(|file| file.is_rust() || file.is_markdown())
    {
        for (line, text) in written_lines(file) {
            let cited = text.split('(').skip(1).filter_map(equation_number);
            for number in cited.filter(|number| !numbered.contains(number)) {
                breaches
                    .push(file.breach(line, &format!("equation ({number}) is not in the book")));
            }
        }
    }
    breaches
}

/// Equations of the section theory that no source evaluates or tests: a formula in the
/// code cites its equation.
///
/// The numbers of the dynamics are checked in the other direction only, by
/// [`equations`].
pub fn equations_without_source(tree: &Tree) -> Vec<String> {
    let sources = tree.files.iter().filter(|file| file.is_rust());
    // the examples of these rules are not formulas
    let sources = sources.filter(|file| !file.path.starts_with("tests/tidy/"));
    let mut cited = BTreeSet::new();
    for file in sources {
        for (_, text) in written_lines(file) {
            let numbers = text.split('(').skip(1).filter_map(equation_number);
            cited.extend(numbers.map(str::to_owned));
        }
    }
    let mut breaches = Vec::new();
    for page in tree.files.iter().filter(|file| file.path.starts_with(BOOK)) {
        for (line, text) in page.text.lines().enumerate() {
            if let Some(number) = ending_number(text)
                && number.starts_with("S-")
                && !cited.contains(number)
            {
                let message = format!("no source cites equation ({number})");
                breaches.push(page.breach(line, &message));
            }
        }
    }
    breaches
}

/// The number of a displayed equation: in LaTeX `\tag{D-7}`, in text at the end of its line,
/// after two spaces.
fn ending_number(line: &str) -> Option<&str> {
    if let Some((_, rest)) = line.split_once("\\tag{") {
        return rest.split_once('}').map(|(number, _)| number);
    }
    let (_, number) = line.trim_end().rsplit_once("  (")?;
    equation_number(number).filter(|found| number.len() == found.len() + 1)
}

/// The number at the start of `text`, when a closing bracket follows it.
fn equation_number(text: &str) -> Option<&str> {
    let (number, _) = text.split_once(')')?;
    let (series, digits) = number.split_once('-')?;
    let is_number = !digits.is_empty() && digits.chars().all(|c| c.is_ascii_digit());
    (["S", "D"].contains(&series) && is_number).then_some(number)
}

/// Relative links of Markdown pages to files or headings that do not exist, and of pages of the book
/// to files that are not in it.
pub fn links(tree: &Tree) -> Vec<String> {
    let mut breaches = Vec::new();
    for page in tree.files.iter().filter(|file| file.is_markdown()) {
        for (line, text) in prose_lines(&page.text) {
            for target in targets(&without_code(text)) {
                if !leads_somewhere(tree, page, &target) {
                    breaches.push(page.breach(line, &format!("link \"{target}\" leads nowhere")));
                }
            }
        }
    }
    breaches
}

/// Targets of the links of a line, also of a definition `[name]: target`.
fn targets(line: &str) -> Vec<String> {
    let inline = line
        .split("](")
        .skip(1)
        .filter_map(|rest| rest.split_once(')'));
    let mut found: Vec<String> = inline.map(|(target, _)| target.to_owned()).collect();
    if line.starts_with('[')
        && let Some((_, target)) = line.split_once("]: ")
    {
        found.push(target.trim().to_owned());
    }
    found.retain(|target| !target.contains("://") && !target.starts_with("mailto:"));
    found
}

fn leads_somewhere(tree: &Tree, page: &File, target: &str) -> bool {
    let (path, anchor) = target.split_once('#').unwrap_or((target, ""));
    let goal = if path.is_empty() {
        page.path.clone()
    } else {
        resolved(&page.path, path)
    };
    let has_anchor = |file: &File| headings(&file.text).any(|heading| heading == anchor);
    let leaves_book = page.path.starts_with(BOOK) && !goal.starts_with(BOOK);
    tree.has(&goal)
        && !leaves_book
        && (anchor.is_empty() || tree.file(&goal).is_some_and(has_anchor))
}

/// `target` from the folder of the page at `page`.
fn resolved(page: &str, target: &str) -> String {
    let mut parts: Vec<&str> = page.split('/').collect();
    parts.pop();
    for part in target.split('/') {
        match part {
            ".." => drop(parts.pop()),
            "." | "" => {}
            name => parts.push(name),
        }
    }
    parts.join("/")
}

/// Anchors of the headings of a page.
fn headings(text: &str) -> impl Iterator<Item = String> {
    let titles = prose_lines(text).filter_map(|(_, line)| {
        line.trim_start_matches('#')
            .strip_prefix(' ')
            .filter(|_| line.starts_with('#'))
    });
    titles.map(|title| {
        let kept = title.trim().to_lowercase().replace(' ', "-");
        kept.chars().filter(|c| is_word(*c) || *c == '-').collect()
    })
}

/// Pages of the book missing in its summary.
pub fn pages(tree: &Tree) -> Vec<String> {
    let summary = format!("{BOOK}SUMMARY.md");
    let listed = tree.file(&summary).map_or("", |file| file.text.as_str());
    let pages = tree.files.iter().filter(|file| file.path.starts_with(BOOK));
    pages
        .filter(|page| page.is_markdown() && page.path != summary)
        .filter(|page| !listed.contains(&format!("]({})", &page.path[BOOK.len()..])))
        .map(|page| page.breach(0, &format!("the page is not in {summary}")))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn architecture_paths_are_found_from_the_root_or_the_crate_of_the_heading() {
        let page = "See `docs/gone.md`, `a::b/c`.\n## section-analyzer\n`cli.rs` `gone.rs`\n```\n`x/y`\n```\n";
        let tree = Tree::of(&[(ARCHITECTURE, page), ("section-analyzer/src/cli.rs", "")]);
        assert_eq!(architecture(&tree).len(), 2);
        assert_eq!(architecture(&Tree::of(&[])).len(), 1);
    }

    #[test]
    fn citations_need_an_entry_and_entries_a_citation() {
        let source = "//! By \\[Abel1826\\], not [`Frame`] nor [Frame].\n//! # References\n//! \\[Gauss\\]\n";
        let entries = "### Abel1826\n### Euler\n";
        let tree = Tree::of(&[("a/src/b.rs", source), (BIBLIOGRAPHY, entries)]);
        assert_eq!(
            citations(&tree),
            [
                "a/src/b.rs:3: citation [Gauss] is not in docs/src/bibliography.md",
                "docs/src/bibliography.md:2: nothing cites [Euler]",
            ]
        );
    }

    #[test]
    fn keys_have_a_name_and_a_year() {
        assert!(has_year("Cowper1966") && has_year("Cowper1966a"));
        assert!(!has_year("Cowper") && !has_year("Cowper66") && !has_year("1966"));
    }

    #[test]
    fn equations_are_numbered_once_and_cited_by_their_number() {
        let book = "```text\na = b    (S-1)\n```\n```math\nc = d \\tag{S-1}\n```\n";
        let tree = Tree::of(&[("docs/src/a.md", book), ("a/src/b.rs", "// (S-1), (D-2)\n")]);
        assert_eq!(equations(&tree).len(), 2);
    }

    #[test]
    fn equations_of_the_sections_need_a_source() {
        let book = "```text\na = b    (S-1)\nc = d    (S-2)\ne = f    (D-1)\n```\n(S-2)\n";
        let code = "//! a = b (S-1)\nlet two = \"(S-2)\";\n";
        let files = [("docs/src/a.md", book), ("a/src/b.rs", code)];
        assert_eq!(
            equations_without_source(&Tree::of(&files)),
            ["docs/src/a.md:3: no source cites equation (S-2)"]
        );
    }

    #[test]
    fn links_need_a_file_and_a_heading() {
        let page = "# One two\n[a](b.md) [b](#one-two) [c](../c.md#x) [d](https://e.f) `[g](h)`\n[i]: j.md\n";
        let tree = Tree::of(&[("docs/a.md", page), ("docs/b.md", ""), ("c.md", "## y\n")]);
        assert_eq!(links(&tree).len(), 2);
        let page = "[out](../../c.md) [in](b.md)";
        let tree = Tree::of(&[("docs/src/a.md", page), ("docs/src/b.md", ""), ("c.md", "")]);
        assert_eq!(links(&tree).len(), 1);
    }

    #[test]
    fn pages_must_be_listed() {
        let summary = "- [a](a.md)\n";
        let files = [
            ("docs/src/SUMMARY.md", summary),
            ("docs/src/a.md", ""),
            ("docs/src/b.md", ""),
        ];
        assert_eq!(pages(&Tree::of(&files)).len(), 1);
    }
}
