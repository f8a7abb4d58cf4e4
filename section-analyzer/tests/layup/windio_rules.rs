//! Rules for places in windIO files, complete and not, and values that files give twice or in other
//! units.

use std::f64::consts::TAU;

use section_analyzer::input::layup::{self, Layup};
use section_analyzer::output::{layup_file, layup_section};

use crate::sections::close;
use crate::windio::{read, tube};

/// The tube, of radius 1 m, as a file of version 1: a skin, and a layer with further lines.
fn version_1(lines: &str) -> String {
    let (_, text) = tube();
    let (_, rest) = text.split_once("\nairfoils:\n").expect("airfoils");
    let flat = |value: f64| format!("{{grid: [0, 1], values: [{value}, {value}]}}");
    let (zero, half) = (flat(0.0), flat(0.5));
    let axis = format!("{{x: {zero}, y: {zero}, z: {{grid: [0, 1], values: [0, 40]}}}}");
    let lines: String = lines
        .lines()
        .map(|line| format!("          {line}\n"))
        .collect();
    format!(
        "components:
  blade:
    outer_shape_bem:
      airfoil_position: {{grid: [0, 1], labels: [circle, circle]}}
      chord: {{grid: [0, 1], values: [2, 2]}}
      twist: {zero}
      pitch_axis: {half}
      reference_axis: {axis}
    internal_structure_2d_fem:
      webs:
        - name: web
          start_nd_arc: {{grid: [0, 1], values: [0.3, 0.3]}}
          end_nd_arc: {{grid: [0, 1], values: [0.7, 0.7]}}
      layers:
        - name: skin
          material: glass
          thickness: {{grid: [0, 1], values: [0.01, 0.01]}}
        - name: part
          material: glass
          thickness: {{grid: [0, 1], values: [0.002, 0.002]}}
{lines}airfoils:
{rest}"
    )
}

/// Lines of tables with one value each.
fn flat(values: &[(&str, f64)]) -> String {
    let line = |(key, value): &(&str, f64)| {
        format!("{key}: {{grid: [0, 1], values: [{value}, {value}]}}\n")
    };
    values.iter().map(line).collect()
}

fn blade(lines: &str) -> Layup {
    read(&version_1(lines)).unwrap_or_else(|problems| panic!("{lines}: {problems}"))
}

/// The one remark about a word.
fn remark(layup: &Layup, word: &str) -> String {
    let all = layup.remarks.iter().filter(|one| one.contains(word));
    let all: Vec<&String> = all.collect();
    assert_eq!(all.len(), 1, "{word}: {:?}", layup.remarks);
    all[0].clone()
}

/// A web of the file without a layer is not meshed, which is a remark; the layup file without it is read.
#[test]
fn webs_without_layers_are_named() {
    let layup = blade(&flat(&[("start_nd_arc", 0.1), ("end_nd_arc", 0.2)]));
    let found = remark(&layup, "web \"web\" has no plies");
    assert!(found.ends_with("it is not meshed"), "{found}");
    assert!(layup.webs.is_empty());
    let text = layup_file(&layup, "a.yaml");
    layup::parse(&text, std::path::Path::new("a.layup.toml"))
        .unwrap_or_else(|problems| panic!("{problems}\n{text}"));
}

/// On a circle of radius R a width w is the arc w / (2 pi R): each complete rule has the places of
/// its closed form.
#[test]
fn complete_rules_have_their_places() {
    let plane = [("offset_y_pa", 0.0), ("rotation", 0.0), ("width", 0.8)];
    let by_plane = flat(&plane) + "side: suction\n";
    let width = 0.8 / TAU;
    let cases = [
        (
            flat(&[("start_nd_arc", 0.2), ("width", 0.8)]),
            [0.2, 0.2 + width],
        ),
        (
            flat(&[("end_nd_arc", 0.4), ("width", 0.8)]),
            [0.4 - width, 0.4],
        ),
        (
            flat(&[("midpoint_nd_arc", 0.3), ("width", 0.8)]),
            [0.3 - 0.5 * width, 0.3 + 0.5 * width],
        ),
        (by_plane.clone(), [0.25 - 0.5 * width, 0.25 + 0.5 * width]),
        (
            flat(&[("start_nd_arc", 0.2), ("end_nd_arc", 0.4)]),
            [0.2, 0.4],
        ),
        (String::new(), [0.0, 1.0]),
    ];
    for (lines, expected) in cases {
        let layup = blade(&lines);
        let section = layup
            .section(0.5)
            .unwrap_or_else(|problems| panic!("{problems}"));
        let part = section.layers.iter().find(|layer| layer.name == "part");
        let part = part.expect("the layer");
        close(1.0 + part.from, 1.0 + expected[0], 1e-6, &lines);
        close(part.to, expected[1], 1e-6, &lines);
        assert!(
            layup.remarks.iter().all(|one| !one.contains("rules")),
            "{lines}"
        );
    }
}

/// Where two rules differ by more than 0.02 chords, an arc of 0.00637, both values are named.
#[test]
fn rules_that_differ_are_named() {
    let width = 0.8 / TAU;
    let both = |end: f64| flat(&[("start_nd_arc", 0.2), ("end_nd_arc", end), ("width", 0.8)]);
    assert!(
        blade(&both(0.2 + width + 0.0053))
            .remarks
            .iter()
            .all(|one| !one.contains("rules"))
    );
    let far = blade(&both(0.2 + width + 0.0073));
    let expected = "line 18: of two rules for end_nd_arc of layer \"part\" the first is used; they differ \
                    by 2 % of the chord: 0.3346 by arcs, 0.3273 by start_nd_arc and width at eta 0";
    assert_eq!(remark(&far, "rules"), expected);
    let padded = both(0.2 + width) + &flat(&[("midpoint_nd_arc", 0.0)]);
    let padded = blade(&padded).remarks;
    assert!(
        padded.iter().all(|one| !one.contains("rules")),
        "{padded:?}"
    );
    let middle = flat(&[
        ("start_nd_arc", 0.2),
        ("end_nd_arc", 0.4),
        ("midpoint_nd_arc", 0.32),
    ]);
    let expected = "0.3000 by arcs, 0.3200 by midpoint_nd_arc at eta 0";
    assert!(remark(&blade(&middle), "rules").ends_with(expected));
    let plane = [("offset_y_pa", 0.0), ("rotation", 0.0), ("width", 0.8)];
    let by_plane = flat(&plane) + "side: suction\n";
    let other = flat(&[("midpoint_nd_arc", 0.3)]) + &by_plane;
    let expected = "by midpoint_nd_arc and width, 0.3137 by offset_y_pa at eta 0";
    assert!(remark(&blade(&other), "end_nd_arc of layer").ends_with(expected));
}

/// The tube without a web, with a layer from the end of the other one.
fn with_next(lines: &str) -> String {
    let next = "        - name: next
          material: glass
          thickness: {grid: [0, 1], values: [0.002, 0.002]}
          start_nd_arc: {fixed: part}
          end_nd_arc: {grid: [0, 1], values: [0.2, 0.2]}
airfoils:\n";
    let web = "        - name: web
          start_nd_arc: {grid: [0, 1], values: [0.3, 0.3]}
          end_nd_arc: {grid: [0, 1], values: [0.7, 0.7]}\n";
    let text = version_1(lines)
        .replace("      webs:\n", "")
        .replace(web, "");
    text.replace("airfoils:\n", next)
}

/// A layer through the trailing edge, by both arcs, also beside its middle there, or by its middle and
/// its width, is two layers; others may lie between its ends. Its area is the area of the layer.
#[test]
fn a_layer_through_the_trailing_edge_is_two() {
    let arcs = flat(&[("start_nd_arc", 0.947), ("end_nd_arc", 0.053)]);
    let fixed = "midpoint_nd_arc: {fixed: TE}\n";
    let width = flat(&[("width", 0.106 * TAU)]);
    let cases = [
        arcs.clone(),
        arcs.clone() + fixed,
        arcs.clone() + &flat(&[("midpoint_nd_arc", 1.0), ("width", 0.5)]),
        width + fixed,
    ];
    for lines in cases {
        let text = with_next(&lines);
        let layup = read(&text).unwrap_or_else(|problems| panic!("{lines}: {problems}"));
        remark(&layup, "layer \"part\" goes through the trailing edge");
        let section = layup.section(0.5);
        let section = section.unwrap_or_else(|problems| panic!("{problems}"));
        let arcs = section
            .layers
            .iter()
            .map(|one| (&one.name[..], one.from, one.to));
        let expected = [
            ("skin", 0.0, 1.0),
            ("part_suction", 0.0, 0.053),
            ("part_pressure", 0.947, 1.0),
            ("next", 0.053, 0.2),
        ];
        for (found, expected) in arcs.zip(expected) {
            assert_eq!(found.0, expected.0, "{lines}");
            close(1.0 + found.1, 1.0 + expected.1, 1e-6, &lines);
            close(found.2, expected.2, 1e-6, &lines);
        }
        let meshed = layup
            .mesh(0.5)
            .unwrap_or_else(|problems| panic!("{problems}"));
        let parts = meshed
            .areas
            .iter()
            .filter(|area| area.name.starts_with("part"));
        let area: f64 = parts.map(|area| area.meshed).sum();
        // in the skin of 10 mm on the circle of 1 m
        close(area, 0.106 * TAU * 0.002 * (1.0 - 0.011), 2e-3, &lines);
        let written = layup_file(&layup, "a.yaml");
        let again = layup::parse(&written, std::path::Path::new("a.layup.toml"));
        let again = again.unwrap_or_else(|problems| panic!("{problems}"));
        assert_eq!(
            again.section(0.5).ok(),
            layup.section(0.5).ok(),
            "{written}"
        );
    }
}

/// A layer that ends before it starts and does not go through the trailing edge, by its arcs or by the
/// ends of other layers, is an error that names it.
#[test]
fn swapped_ends_are_refused() {
    let swapped = [[0.71, 0.29], [0.4, 0.2], [0.9, 0.8], [1.0, 0.0]];
    for [from, to] in swapped {
        let lines = flat(&[("start_nd_arc", from), ("end_nd_arc", to)]);
        let problem = read(&version_1(&lines)).expect_err("swapped ends");
        let expected = format!(
            "a.yaml:18: layer \"part\" at eta 0 starts at arc {from} and ends at {to}, expected"
        );
        assert!(
            problem.contains(&expected) && problem.contains("swap them?"),
            "{problem}"
        );
    }
    // version 2: both handles of the anchor of a layer
    let (_, text) = tube();
    let handle = |key: &str, handle: &str| {
        format!("          {key}: {{anchor: {{name: cap, handle: {handle}}}}}\n")
    };
    let (start, end) = ("start_nd_arc", "end_nd_arc");
    let turned = text.replace(&handle(start, start), &handle(start, end));
    let turned = turned.replace(&handle(end, end), &handle(end, start));
    assert_ne!(turned, text);
    let problem = read(&turned).expect_err("swapped anchors");
    assert!(
        problem.contains("layer \"cap\" at eta 0.1 starts at arc 0.24"),
        "{problem}"
    );
}

/// A handle that no anchor has was treated as the end.
#[test]
fn unknown_handles_are_refused() {
    let (_, text) = tube();
    for wrong in ["startt_nd_arc", "start", "nd_arc"] {
        let turned = text.replacen("handle: start_nd_arc", &format!("handle: {wrong}"), 1);
        assert_ne!(turned, text);
        let problem = read(&turned).expect_err("unknown handle");
        for words in [format!("\"{wrong}\""), "a handle of an anchor".to_owned()] {
            assert!(problem.contains(&words), "{words}: {problem}");
        }
    }
}

/// Round-off below zero is zero, and reported; other negative thicknesses are errors.
#[test]
fn round_off_of_thicknesses_is_zero() {
    let with = |thickness: &str| {
        let own = "values: [0.002, 0.002]}";
        version_1("").replacen(own, &format!("values: [0.002, {thickness}]}}"), 1)
    };
    let layup = read(&with("-1.44e-20")).unwrap_or_else(|problems| panic!("{problems}"));
    remark(
        &layup,
        "thickness of layer \"part\" is -1.44e-20 at 1: 0 is taken",
    );
    let section = layup.section(1.0).expect("a section");
    assert_eq!(section.layers.len(), 1);
    let problem = read(&with("-1e-5")).expect_err("a negative thickness");
    assert!(
        problem.contains("thickness of layer \"part\": found -0.00001 at 1"),
        "{problem}"
    );
}

/// A part of a rule names what it lacks.
#[test]
fn half_rules_are_refused() {
    let plane = flat(&[("offset_y_pa", 0.0), ("rotation", 0.0)]) + "side: suction\n";
    let cases = [
        (
            flat(&[("width", 0.8)]),
            "width alone, expected start_nd_arc, end_nd_arc, midpoint",
        ),
        (
            flat(&[("start_nd_arc", 0.2)]),
            "start_nd_arc alone, expected end_nd_arc or width too",
        ),
        (
            flat(&[("end_nd_arc", 0.2)]),
            "end_nd_arc alone, expected start_nd_arc or width too",
        ),
        (
            flat(&[("midpoint_nd_arc", 0.2)]),
            "midpoint_nd_arc alone, expected width too",
        ),
        (plane, "offset_y_pa, rotation, side, expected width too"),
        (
            flat(&[("rotation", 0.0)]),
            "rotation alone, expected offset_y_pa, width and side",
        ),
    ];
    let whole = version_1("");
    for (lines, expected) in cases {
        let problem = read(&version_1(&lines)).err();
        let problem = problem.unwrap_or_else(|| panic!("{lines} is read"));
        let expected = format!("a.yaml:18: the place of layer \"part\": found {expected}");
        assert!(problem.contains(&expected), "{problem}");
    }
    let start = "          start_nd_arc: {grid: [0, 1], values: [0.3, 0.3]}\n";
    let web = read(&whole.replace(start, "")).expect_err("half a web");
    assert!(
        web.contains("the place of web \"web\": found end_nd_arc alone, expected start_nd_arc too")
    );
    // version 2
    let (_, text) = tube();
    let start = "          start_nd_arc: {anchor: {name: cap, handle: start_nd_arc}}\n";
    assert!(text.contains(start));
    let half = read(&text.replace(start, "")).expect_err("half a rule");
    assert!(
        half.contains("the place of layer \"cap\": found end_nd_arc alone"),
        "{half}"
    );
}

/// Angles of version 1 are in rad: degrees are an error, and more than a right angle a remark.
#[test]
fn angles_of_version_1_are_in_rad() {
    let fibers = |angle: f64| version_1(&flat(&[("fiber_orientation", angle)]));
    let problem = read(&fibers(20.0)).expect_err("degrees");
    let expected = "fiber_orientation of layer \"part\": found 20 at 1, expected an angle in rad";
    assert!(problem.contains(expected), "{problem}");
    let wide = read(&fibers(2.0)).unwrap_or_else(|problems| panic!("{problems}"));
    remark(&wide, "is 2 rad = 114.6 deg");
    let zero = "twist: {grid: [0, 1], values: [0, 0]}";
    let turned = version_1("").replace(zero, "twist: {grid: [0, 1], values: [10, 0]}");
    assert!(
        read(&turned)
            .expect_err("degrees")
            .contains("twist: found 10 at 0, expected")
    );
    let plane = flat(&[("offset_y_pa", 0.0), ("rotation", 10.0), ("width", 0.8)]);
    let plane = read(&version_1(&(plane + "side: suction\n"))).expect_err("degrees");
    assert!(
        plane.contains("rotation of layer \"part\": found 10 at 1"),
        "{plane}"
    );
}

/// Fiber angles that change along the span are taken at each section: 30 degrees at the root and 10 at the tip
/// are 20 in the middle, where the section has a layer of 20 degrees; the layup file keeps them.
#[test]
fn fiber_angles_may_change_along_the_span() {
    let text = |angles: [f64; 2]| {
        let angles = angles.map(f64::to_radians);
        version_1(&format!(
            "fiber_orientation: {{grid: [0, 1], values: [{}, {}]}}\n",
            angles[0], angles[1]
        ))
    };
    let section = |layup: &Layup| {
        let meshed = layup
            .mesh(0.5)
            .unwrap_or_else(|problems| panic!("{problems}"));
        layup_section(layup, &meshed, "a.msh")
    };
    let [changing, constant] = [[30.0, 10.0], [20.0, 20.0]]
        .map(|angles| read(&text(angles)).unwrap_or_else(|problems| panic!("{problems}")));
    assert!(section(&constant).contains("fiber_angle = \"-20 deg\""));
    assert_eq!(section(&changing), section(&constant));
    let written = layup_file(&changing, "a.yaml");
    let again = layup::parse(&written, std::path::Path::new("a.layup.toml"));
    let again = again.unwrap_or_else(|problems| panic!("{problems}"));
    assert_eq!(section(&again), section(&changing));
}

/// Versions, unknown keys, positions of airfoils and two thicknesses.
#[test]
fn other_contents_are_named() {
    let (_, text) = tube();
    let cases = [
        (
            "'2.0'",
            "'3.0'",
            "windIO_version: found \"3.0\", expected 1 or 2",
        ),
        (
            "'2.0'",
            "'1.0'",
            "expected 2, whose tables are outer_shape and structure",
        ),
        (
            "position: 1}",
            "position: 0}",
            "airfoil \"circle\": found 0 after 0, expected",
        ),
        (
            "position: 1}",
            "position: 1.5}",
            "airfoil \"circle\": found 1.5, expected",
        ),
    ];
    for (from, to, expected) in cases {
        let problem = read(&text.replacen(from, to, 1)).err();
        let problem = problem.unwrap_or_else(|| panic!("{to} is read"));
        assert!(problem.contains(expected), "{to}: {problem}");
    }
    // positions are not needed beside relative thicknesses
    let without = text
        .replace(", spanwise_position: 0}", "}")
        .replace(", spanwise_position: 1}", "}");
    let [given, without] =
        [&text, &without].map(|text| read(text).unwrap_or_else(|text| panic!("{text}")));
    assert_eq!(given.section(0.3).ok(), without.section(0.3).ok());
    let light = read(&text.replace("rho: 1900", "rho: -1900")).expect_err("a density");
    assert!(
        light.contains("is -1900 kg/m^3, expected 0 or more"),
        "{light}"
    );
    assert!(!light.contains("--repair-materials"), "{light}");
    let other = read(&text.replace("fiber_orientation", "fibre_orientation"));
    let other = other.unwrap_or_else(|problems| panic!("{problems}"));
    let expected = "\"fibre_orientation\" of layers (skin) is no key of windIO and has no effect; \
                    did you mean \"fiber_orientation\"?";
    remark(&other, expected);
    // two plies of 1 mm are the thickness, three are not
    assert!(
        blade(&flat(&[("n_plies", 2.0)]))
            .remarks
            .iter()
            .all(|one| !one.contains("plies") || one.contains("web"))
    );
    let three = blade(&flat(&[("n_plies", 3.0)]));
    let expected = "the thickness of layer \"part\" is used, 2.0000 mm at 1; n_plies times ply_t of \
                    the material is 3.0000 mm";
    remark(&three, expected);
}

/// An airfoil whose points are 1.5 times as thick as it states is reported.
#[test]
fn airfoils_of_another_thickness_are_named() {
    let (_, text) = tube();
    let thick = "    rthick: 1\n";
    assert!(text.contains(thick));
    let along = "rthick: {grid: *ends, values: [1, 1]}";
    let thinner = text.replace(thick, "    rthick: 0.6667\n");
    let problem = read(&thinner).expect_err("another thickness along the span");
    let expected = "a.yaml:14: rthick: found 1 at 0, expected about 0.6667, as the airfoil has";
    assert!(problem.contains(expected), "{problem}");
    let layup = read(&thinner.replace(along, &along.replace("1, 1", "0.6667, 0.6667")));
    let layup = layup.unwrap_or_else(|problems| panic!("{problems}"));
    let expected = "airfoil \"circle\" has a rthick of 0.6667, and its points are 1.0000 thick";
    remark(&layup, expected);
    for name in [
        "windio1_iea15",
        "windio2_iea22",
        "windio2_iea34",
        "windio2_iea10",
    ] {
        let remarks = crate::windio::blade(name).remarks;
        assert!(
            remarks.iter().all(|one| !one.contains("its points are")),
            "{name}: {remarks:?}"
        );
    }
}

/// Tabulators separate keys and values as blanks do.
#[test]
fn tabulators_separate() {
    let (_, text) = tube();
    let tabs = text
        .replace("name: ", "name:\t")
        .replace(", values: ", ",\tvalues:\t");
    let [plain, tabs] =
        [&text, &tabs].map(|text| read(text).unwrap_or_else(|text| panic!("{text}")));
    assert_eq!(plain.section(0.5).ok(), tabs.section(0.5).ok());
}

/// Public files have no key that is not read, and rules that differ only where their numbers do.
#[test]
fn public_files_have_no_other_remarks() {
    let differing = [
        ("windio1_iea15", 0),
        ("windio2_iea15", 0),
        ("windio2_iea22", 2),
        ("windio2_iea34", 10),
    ];
    for (name, count) in differing {
        let layup = crate::windio::blade(name);
        assert!(layup.remarks.iter().all(|one| !one.contains("no key")));
        let rules = layup.remarks.iter();
        let rules: Vec<_> = rules.filter(|one| one.contains("two rules")).collect();
        assert_eq!(rules.len(), count, "{name}: {rules:?}");
        assert!(layup.remarks.iter().all(|one| one.len() < 300), "{name}");
    }
}

/// A layer that starts at itself, and layers that start and end at each other.
#[test]
fn places_of_version_1_do_not_go_in_circles() {
    let message = |lines: &str| read(&version_1(lines)).map(|_| ()).expect_err(lines);
    let end = flat(&[("end_nd_arc", 0.4)]);
    let own = message(&format!("start_nd_arc: {{fixed: part}}\n{end}"));
    let expected = "start_nd_arc of layer \"part\": found \"part\", expected TE, LE or the name of another layer";
    assert!(own.contains(expected), "{own}");
    let arc = "{grid: [0, 1], values: [0.2, 0.2]}";
    let next = format!("start_nd_arc: {{fixed: part}}\n          end_nd_arc: {arc}");
    let back = format!("start_nd_arc: {arc}\n          end_nd_arc: {{fixed: part}}");
    let text =
        with_next(&format!("start_nd_arc: {{fixed: next}}\n{end}")).replacen(&next, &back, 1);
    let circle = read(&text).map(|_| ()).expect_err("a circle");
    assert!(
        circle.contains("places go in a circle: next.end -> part.start -> next.end"),
        "{circle}"
    );
}
