//! Parts of windIO blades that begin or end within the span, and thicknesses that no layer can have.

use section_analyzer::input::layup::{Layup, Selection};

use crate::areas;
use crate::windio::{blade, read, tube};

/// The tube with changes.
fn changed(changes: &[(&str, &str)]) -> Result<Layup, String> {
    let (_, mut text) = tube();
    for (from, to) in changes {
        assert!(text.contains(from), "{from}");
        text = text.replacen(from, to, 1);
    }
    read(&text)
}

fn layup(changes: &[(&str, &str)]) -> Layup {
    changed(changes).unwrap_or_else(|problems| panic!("{problems}"))
}

/// Names of the layers and of the webs with plies that a mesh has at a position.
fn names(layup: &Layup, eta: f64) -> Vec<String> {
    let meshed = layup
        .mesh(eta)
        .unwrap_or_else(|problems| panic!("{eta}: {problems}"));
    let layers = meshed.section.layers.iter().map(|layer| layer.name.clone());
    let webs = meshed
        .section
        .webs
        .iter()
        .filter(|web| !web.plies.is_empty());
    layers.chain(webs.map(|web| web.name.clone())).collect()
}

const REAR: &str = "thickness: {grid: *ends, values: [0.006, 0.006]}";

/// A table over span and arc, with one row of positions and without: line, layer, value, remedy.
#[test]
fn thicknesses_along_the_arc_are_refused_by_name() {
    for grid in ["[[0, 1], [0, 1]]", "[0, 1]"] {
        let plane =
            format!("thickness: {{grid: {grid}, values: [[0.006, 0.006], [0.004, 0.004]]}}");
        let problem = changed(&[(REAR, &plane)]).expect_err("a table along the arc");
        let expected = "a.yaml:74: thickness of layer \"rear\": found a table along the span and the arc, \
                        expected a table along the span\n  help: split the layer into layers of one \
                        thickness each";
        assert!(problem.contains(expected), "{problem}");
        assert_eq!(problem.matches("error").count(), 1, "{problem}");
    }
}

/// A layer from 0.3 to 0.6, by its thickness table, by `start_nd_grid` and `end_nd_grid`, and by one of each.
#[test]
fn layers_begin_and_end_within_the_span() {
    let limits = "thickness: {grid: *ends, values: [0.006, 0.006]}\n          start_nd_grid: 0.3\n          end_nd_grid: 0.6";
    let both = "thickness: {grid: [0.3, 1], values: [0.006, 0.006]}\n          end_nd_grid: 0.6";
    let table = "thickness: {grid: [0.3, 0.6], values: [0.006, 0.006]}";
    for form in [limits, both, table] {
        let layup = layup(&[(REAR, form)]);
        for (eta, is_there) in [
            (0.1, false),
            (0.299, false),
            (0.3, true),
            (0.45, true),
            (0.6, true),
            (0.601, false),
            (1.0, false),
        ] {
            let has = names(&layup, eta).iter().any(|name| name == "rear");
            assert_eq!(has, is_there, "{form} {eta}");
        }
        // both sides of both ends are stations
        let stations = layup.span_stations(&Selection::Chosen);
        for end in [0.3, 0.6] {
            let there = stations
                .iter()
                .filter(|one| (one.eta - end).abs() < 1e-9)
                .count();
            assert_eq!(there, 2, "{form} {end}");
        }
    }
    let none = layup(&[(REAR, &limits.replace("0.3", "0.7"))]);
    let absent: Vec<&str> = none.absent_layers().iter().map(|one| one.0).collect();
    assert_eq!(absent, ["rear"]);
}

/// The web of the tube stands from 0.1 to 0.9, by the table of its plane; with limits of its own from 0.2
/// to 0.7; with plies from 0.3 to 0.5 only there. Beyond its ends the shell continues without it.
#[test]
fn webs_end_before_the_shell() {
    let ply = "thickness: {grid: *ends, values: [0.02, 0.02]}";
    let short = "thickness: {grid: [0.3, 0.5], values: [0.02, 0.02]}";
    let web = "        - name: main\n";
    let limits = "        - name: main\n          start_nd_grid: 0.2\n          end_nd_grid: 0.7\n";
    for (changes, [from, to]) in [
        (&[][..], [0.1, 0.9]),
        (&[(web, limits)], [0.2, 0.7]),
        (&[(ply, short)], [0.3, 0.5]),
        (&[(web, limits), (ply, short)], [0.3, 0.5]),
    ] {
        let layup = layup(changes);
        for (eta, is_there) in [
            (from - 0.01, false),
            (from + 0.01, true),
            (to - 0.01, true),
            (to + 0.01, false),
        ] {
            let names = names(&layup, eta);
            assert_eq!(
                names.iter().any(|name| name == "main"),
                is_there,
                "{changes:?} {eta}"
            );
            assert!(names.iter().any(|name| name == "skin"), "{eta}");
        }
        let stations = layup.span_stations(&Selection::Chosen);
        for end in [from, to] {
            let there = stations
                .iter()
                .filter(|one| (one.eta - end).abs() < 1e-9)
                .count();
            assert_eq!(there, 2, "{changes:?} {end}");
        }
    }
}

/// Plies of a web that end below its foot: line, web, value, remedy.
#[test]
fn plies_that_end_before_the_shell_are_refused_by_name() {
    let whole = "end_nd_arc: {grid: *ends, values: [1, 1]}}\n          flanges:";
    let problem =
        changed(&[(whole, &whole.replace("[1, 1]", "[1, 0.8]"))]).expect_err("a short ply");
    assert!(
        problem.contains(
            "a.yaml:51: end_nd_arc of an anchor of web \"main\": found 0.8 at 1, expected 1"
        ),
        "{problem}"
    );
    assert!(
        problem.contains("plies of webs have the whole height"),
        "{problem}"
    );
}

/// Limits that are no positions are no limits: they are refused, with their line.
#[test]
fn limits_that_are_no_positions_are_refused() {
    for (wrong, found) in [
        ("here", "\"here\""),
        ("1.3", "1.3"),
        ("-0.1", "-0.1"),
        (".nan", "\".nan\""),
    ] {
        let form = format!("{REAR}\n          start_nd_grid: {wrong}");
        let problem = changed(&[(REAR, &form)]).expect_err(wrong);
        let expected = format!(
            "a.yaml:75: start_nd_grid of layer \"rear\": found {found}, expected a position from 0 to 1"
        );
        assert!(problem.contains(&expected), "{problem}");
        let web = "        - name: main\n";
        let form = format!("{web}          end_nd_grid: {wrong}\n");
        let problem = changed(&[(web, &form)]).expect_err(wrong);
        let expected = format!(
            "a.yaml:48: end_nd_grid of web \"main\": found {found}, expected a position from 0 to 1"
        );
        assert!(problem.contains(&expected), "{problem}");
    }
}

/// From 0.7757 to 0.7768 of the span of IEA-15 the reinforcements of both sides of the trailing edge meet
/// within the ramps at their ends alone, over 1 mm, which is less than a step of the search. Layers have
/// their areas, without the part that is cut, within 0.5 %.
#[test]
fn short_contacts_are_meshed() {
    let layup = blade("windio1_iea15");
    for eta in [0.7757, 0.776, 0.7764, 0.7768] {
        let meshed = layup.mesh(eta);
        let meshed = meshed.unwrap_or_else(|problems| panic!("{problems}"));
        for area in areas::large(&meshed.areas) {
            let error = areas::error(area);
            assert!(error.abs() < 5e-3, "{eta}: {} {error:e}", area.name);
        }
    }
}
