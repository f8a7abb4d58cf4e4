//! Words of windIO files before version 1.0, in which the first versions of reference turbines are written.

use section_analyzer::input::layup::Layup;

use crate::windio::{path, read};

/// A turbine in the words of version 1.0. Without arcs, webs and caps are placed by planes alone.
fn turbine(has_arcs: bool) -> String {
    let text = std::fs::read_to_string(path("windio1_iea15")).expect("a file");
    let items: Vec<String> = text
        .split("        - name: ")
        .map(|item| {
            let is_left_out = |line: &str| {
                let key = line.trim_start();
                let is_arc = key.starts_with("start_nd_arc") || key.starts_with("end_nd_arc");
                !has_arcs && is_arc && item.contains("offset_y_pa")
            };
            let lines = item.lines().filter(|line| !is_left_out(line));
            lines.map(|line| format!("{line}\n")).collect()
        })
        .collect();
    items.join("        - name: ")
}

/// The same with other words for its rotations of zero, and for its offsets.
fn reworded(text: &str, rotation: &str, offset: &str) -> String {
    let zero = "          rotation: {grid: [0, 1], values: [0, 0]}\n";
    assert_eq!(text.matches(zero).count(), 4);
    assert_eq!(text.matches("offset_y_pa").count(), 4);
    let text = text.replace(zero, rotation).replace("offset_y_pa", offset);
    text.replace("      twist: {", "      twist: &twist {")
}

fn layup(text: &str) -> Layup {
    read(text).unwrap_or_else(|problems| panic!("{problems}"))
}

/// Largest distance of the nodes of two layups, infinite if they are not as many.
fn distance(a: &Layup, b: &Layup, eta: f64) -> f64 {
    let [a, b] = [a, b].map(|layup| {
        let meshed = layup.mesh(eta);
        meshed
            .unwrap_or_else(|problems| panic!("{eta}: {problems}"))
            .mesh
    });
    if a.nodes.len() != b.nodes.len() {
        return f64::INFINITY;
    }
    let pairs = a.nodes.iter().zip(&b.nodes);
    let lengths = pairs.flat_map(|(a, b)| [0, 1].map(|i| (a.position[i] - b.position[i]).abs()));
    lengths.fold(0.0, f64::max)
}

/// Before version 1.0 the offset is along the chord line turned by the rotation, the twist for webs that are
/// straight along the span; in version 1.0 the rotation of the same webs is zero, and of planes normal to the
/// chord line the opposite of the twist. Nodes are equal but for round-off, of a chord of 6 m, and planes of the
/// other kind move them by more than a millimeter where the blade is twisted.
#[test]
fn former_offsets_are_along_the_turned_chord() {
    let text = turbine(false);
    let straight = layup(&text);
    let normal = layup(&reworded(
        &text,
        "          rotation: {fixed: twist}\n",
        "offset_y_pa",
    ));
    for (rotation, same, other) in [
        ("          rotation: *twist\n", &straight, &normal),
        ("          rotation: {fixed: twist}\n", &straight, &normal),
        ("", &normal, &straight),
        (
            "          rotation: {grid: [0, 1], values: [0, 0]}\n",
            &normal,
            &straight,
        ),
    ] {
        let former = layup(&reworded(&text, rotation, "offset_x_pa"));
        let remarks = |layup: &Layup| layup.remarks.len();
        assert_eq!(remarks(&former), remarks(same), "{:?}", former.remarks);
        for eta in [0.15, 0.3, 0.6, 0.9] {
            let found = distance(&former, same, eta);
            assert!(found < 1e-12, "{rotation} {eta}: {found}");
        }
        let moved = distance(&former, other, 0.15);
        assert!(moved > 1e-3, "{rotation}: {moved}");
    }
}

/// Beside arcs a former offset is compared with them, as the present one is: IEA-15 has webs that are straight along
/// the span, and planes normal to the chord line are elsewhere.
#[test]
fn former_offsets_are_compared_with_arcs() {
    let text = turbine(true);
    let doubts = |rotation: &str| -> Vec<String> {
        let former = layup(&reworded(&text, rotation, "offset_x_pa"));
        let all = former.remarks.iter();
        let doubts = all.filter(|remark| remark.contains("by offset_x_pa at eta"));
        doubts.cloned().collect()
    };
    let [straight, normal] = ["          rotation: *twist\n", ""].map(doubts);
    // two webs and two caps, each with a start and an end
    assert_eq!(
        (straight.len(), normal.len()),
        (0, 8),
        "{straight:?} {normal:?}"
    );
}

/// Without a side and a width an offset is no place of a layer.
#[test]
fn former_offsets_alone_are_no_place() {
    let text = turbine(false).replace("          side: suction\n", "");
    let problem = read(&reworded(
        &text,
        "          rotation: *twist\n",
        "offset_x_pa",
    ));
    let problem = problem.expect_err("a layer without a side");
    let expected = "key \"side\" of layer \"Spar_Cap_SS\" is missing";
    assert!(problem.contains(expected), "{problem}");
}
