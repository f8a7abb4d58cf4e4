//! Rules of the tree that a machine can check.
//!
//! Each test reads the tree, collects all breaches of one rule as
//! `file:line: what was found and what was expected`, and fails with the whole list. The
//! rules are in `CONTRIBUTING.md`; the order of the stages is [`imports::CRATES`].

mod circles;
mod documents;
#[path = "../../docs/math/render.rs"]
mod formulas;
mod habits;
mod imports;
mod lengths;
mod source;
mod tree;
mod units;
mod words;

use tree::Tree;

/// Fails with the list if there is a breach.
fn expect_none(rule: &str, breaches: Vec<String>) {
    assert!(
        breaches.is_empty(),
        "{rule}: {} breach(es)\n  {}\n",
        breaches.len(),
        breaches.join("\n  ")
    );
}

#[test]
fn stages_import_only_what_is_before_them() {
    expect_none("import order", imports::order(&Tree::read()));
}

#[test]
fn programs_do_not_import_each_other() {
    expect_none("separate programs", imports::separation(&Tree::read()));
}

#[test]
fn files_import_each_other_in_no_circle() {
    expect_none("circles of files", circles::circles(&Tree::read()));
}

#[test]
fn files_are_short() {
    expect_none("file length", lengths::files(&Tree::read()));
}

#[test]
fn functions_are_short() {
    expect_none("function length", lengths::functions(&Tree::read()));
}

#[test]
fn nothing_unwraps_outside_tests() {
    expect_none("unwrap", habits::unwraps(&Tree::read()));
}

#[test]
fn imports_name_what_they_take() {
    expect_none("glob imports", habits::globs(&Tree::read()));
}

#[test]
fn nothing_is_left_to_do() {
    expect_none("unfinished code", habits::unfinished(&Tree::read()));
}

#[test]
fn no_file_names_a_path_of_one_machine() {
    expect_none("machine paths", habits::machine_paths(&Tree::read()));
}

#[test]
fn public_numbers_state_their_unit() {
    expect_none("units", units::fields(&Tree::read()));
}

#[test]
fn architecture_names_only_what_exists() {
    expect_none("ARCHITECTURE.md", documents::architecture(&Tree::read()));
}

#[test]
fn citations_are_in_the_bibliography() {
    expect_none("citations", documents::citations(&Tree::read()));
}

#[test]
fn cited_equations_are_in_the_book() {
    expect_none("equations", documents::equations(&Tree::read()));
}

#[test]
fn equations_of_the_sections_are_cited_by_a_source() {
    let breaches = documents::equations_without_source(&Tree::read());
    expect_none("equations without source", breaches);
}

#[test]
fn links_lead_somewhere() {
    expect_none("links", documents::links(&Tree::read()));
}

#[test]
fn the_book_lists_every_page() {
    expect_none("pages", documents::pages(&Tree::read()));
}

#[test]
fn formulas_of_the_book_are_latex_that_renders() {
    let tree = Tree::read();
    let pages = tree.files.iter().filter(|page| page.is_markdown());
    let wrong = pages.flat_map(|page| {
        let problems = formulas::rendered(&page.text).err().unwrap_or_default();
        let breach = |(line, text): (usize, String)| page.breach(line - 1, &text);
        problems.into_iter().map(breach).collect::<Vec<_>>()
    });
    expect_none("formulas", wrong.collect());
}

#[test]
fn words_that_are_out_stay_out() {
    expect_none("words", words::out(&Tree::read()));
}
