//! Arcs without a layer: nothing joins the shell there, and a section that is open has the torsional
//! stiffness of an open one.

use section_analyzer::mesh::generate::blade::naca;
use section_analyzer::mesh::generate::layup::{Hole, Layer, LayupProblem, LayupSection};

use crate::windio::{read, tube};

fn layer(name: &str, arcs: [f64; 2]) -> Layer {
    Layer {
        name: name.into(),
        thickness: 0.003,
        from: arcs[0],
        to: arcs[1],
        taper: None,
        profile: Vec::new(),
    }
}

/// Problem of a section with these layers; a circle or an airfoil.
fn holes(is_circle: bool, layers: Vec<Layer>) -> Vec<Hole> {
    let turn = |i: i32| std::f64::consts::TAU * f64::from(i) / 120.0;
    let circle = (0..120).map(|i| [-0.5 * turn(i).cos(), 0.5 * turn(i).sin()]);
    let airfoil = naca("0018", false).expect("an airfoil");
    let airfoil = airfoil.iter().map(|[x, z]| [0.25 - x, *z]);
    let section = LayupSection {
        contour: if is_circle {
            circle.collect()
        } else {
            airfoil.collect()
        },
        layers,
        webs: Vec::new(),
        spar: None,
        fills: Vec::new(),
        size: None,
    };
    match section.generate() {
        Ok(_) => Vec::new(),
        Err(LayupProblem::Holes { holes }) => holes,
        Err(problem) => panic!("{problem}"),
    }
}

fn hole(layers: [&str; 2], arcs: [f64; 2]) -> Hole {
    let layers = layers.map(str::to_owned);
    Hole { layers, arcs }
}

/// All holes have the arcs at which the layers beside them end: they are the given numbers.
#[test]
fn holes_are_errors() {
    let chain = |third: f64| {
        vec![
            layer("a", [0.0, 0.3]),
            layer("b", [0.302, 0.6]),
            layer("c", [third, 1.0]),
        ]
    };
    let first = hole(["a", "b"], [0.302 - 0.002, 0.302]);
    let second = hole(["b", "c"], [0.6, 0.7]);
    for is_circle in [false, true] {
        let close = |found: &[Hole], expected: &[Hole]| {
            let is_close = |(a, b): (&Hole, &Hole)| {
                let arcs = a.arcs.iter().zip(b.arcs);
                a.layers == b.layers && arcs.into_iter().all(|(a, b)| (a - b).abs() < 1e-9)
            };
            found.len() == expected.len() && found.iter().zip(expected).all(is_close)
        };
        let found = holes(is_circle, chain(0.6));
        assert!(close(&found, std::slice::from_ref(&first)), "{found:?}");
        let found = holes(is_circle, chain(0.7));
        assert!(close(&found, &[first.clone(), second.clone()]), "{found:?}");
        // a layer over a hole closes it
        let over = vec![layer("over", [0.25, 0.35])];
        let found = holes(is_circle, [chain(0.6), over].concat());
        assert!(found.is_empty(), "{found:?}");
        let joined = vec![layer("a", [0.0, 0.302]), layer("b", [0.302, 1.0])];
        assert_eq!(holes(is_circle, joined), []);
    }
    // a hole through the trailing edge of a circle is one
    let found = holes(true, vec![layer("a", [0.1, 0.9])]);
    let [Hole { layers, arcs }] = &found[..] else {
        panic!("{found:?}");
    };
    assert_eq!(layers, &["a", "a"]);
    assert!(
        (arcs[0] - 0.9).abs() < 1e-9 && (arcs[1] - 0.1).abs() < 1e-9,
        "{arcs:?}"
    );
}

/// A layer whose thickness is zero in its middle has a hole where it is below 3 % of the whole one: with
/// straight lines from arc 0.4 to 0.5 and to 0.6, from 0.497 to 0.503.
#[test]
fn a_profile_has_holes() {
    let profile = vec![[0.0, 1.0], [0.4, 1.0], [0.5, 0.0], [0.6, 1.0], [1.0, 1.0]];
    let one = Layer {
        profile,
        ..layer("a", [0.0, 1.0])
    };
    let found = holes(false, vec![one]);
    assert_eq!(found.len(), 1, "{found:?}");
    let off = [found[0].arcs[0] - 0.497, found[0].arcs[1] - 0.503];
    assert!(off.iter().all(|off| off.abs() < 1e-9), "{found:?}");
}

/// The skin of the tube in two parts, of which the second one ends at 60 % of the span: a section
/// farther out is refused, with its position and the layers.
#[test]
fn a_chain_that_loses_a_member_is_an_error() {
    let (_, text) = tube();
    let start = text.find("        - name: skin").expect("the skin");
    let end = text
        .find("        - name: cap\n          material")
        .expect("the cap");
    let part = |name: &str, arcs: [f64; 2], to: f64| {
        let [from, end] = arcs;
        format!(
            "        - name: {name}\n          material: glass\n          \
             start_nd_arc: {{grid: *ends, values: [{from}, {from}]}}\n          \
             end_nd_arc: {{grid: *ends, values: [{end}, {end}]}}\n          \
             thickness: {{grid: [0, {to}], values: [0.02, 0.01]}}\n"
        )
    };
    let parts = part("one", [0.0, 0.45], 1.0) + &part("two", [0.45, 0.5], 0.6);
    let parts = parts + &part("three", [0.5, 1.0], 1.0);
    let layup = read(&format!("{}{parts}{}", &text[..start], &text[end..]));
    let layup = layup.unwrap_or_else(|problems| panic!("{problems}"));
    layup
        .mesh(0.5)
        .unwrap_or_else(|problems| panic!("{problems}"));
    let problem = match layup.mesh(0.9) {
        Ok(_) => panic!("no problem"),
        Err(problems) => problems.to_string(),
    };
    for part in [
        "eta 0.9",
        "no layer lies from arc 0.45 to arc 0.5, between layers \"one\" and \"three\"",
        "nothing joins them there",
        "begin where the first one ends",
    ] {
        assert!(problem.contains(part), "{problem}");
    }
}
