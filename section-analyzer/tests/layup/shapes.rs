//! Shapes of sections that no blade has are errors, not other shapes.

use std::path::Path;

use section_analyzer::input::layup;

/// A layup of one layer, with a table of its shape.
fn parse(shape: &str) -> Result<(), String> {
    let text = format!(
        "units = \"SI\"\n[shape]\n{shape}\n[[layer]]\nname = \"skin\"\nmaterial = \"glass\"\n\
         thickness = 0.002\n[material.glass]\nyoung = 40e9\npoisson = 0.3\ndensity = 1900\n"
    );
    let read = layup::parse(&text, Path::new("a.layup.toml"));
    read.map(|_| ()).map_err(|problems| problems.to_string())
}

const AIRFOILS: &str = "[[shape.airfoils]]\nthickness = 0.12\nnaca = \"0012\"\n\
     [[shape.airfoils]]\nthickness = 0.3\nnaca = \"0030\"";

// Percent for parts of the chord, thicknesses beyond the airfoils, negative chords, keys without effect.
#[test]
fn shapes_that_no_blade_has_are_errors() {
    let table = |value: &str| {
        format!("chord = 1\nthickness = {{ eta = [0, 1], value = {value} }}\n{AIRFOILS}")
    };
    let cases = [
        (table("[30, 12]"), "thickness is 30 at the position 0"),
        (table("[0.6, 0.3]"), "expected about 0.12 to 0.3"),
        (
            "chord = { eta = [0, 1], value = [1, -0.5] }\nnaca = \"0012\"".into(),
            "chord is -0.5 at the position 1 along the span, expected a length greater than zero",
        ),
        (
            "chord = -1\nnaca = \"0012\"".into(),
            "\"chord\" is -1, expected a length greater than zero",
        ),
        (
            table("[0.3, 0.12]") + "\neta = 1",
            "eta has no effect: [shape] has \"thickness\", by which airfoils are placed",
        ),
        (
            "chord = 1\n[[shape.airfoils]]\neta = 0\nthickness = 0.2\nnaca = \"0012\"".into(),
            "help: remove it, or add to [shape] thickness = { eta = [0, 1], value = [1, 0.2] }",
        ),
        (
            "chord = 1\norigin = { eta = [0, 1], value = [0.3, 25] }\nnaca = \"0012\"".into(),
            "origin is 25 at the position 1",
        ),
        (
            "chord = 1\nnaca = \"0030\"\nthickness = 0.12".into(),
            "thickness",
        ),
        (
            "chord = 1\n[[shape.airfoils]]\neta = 0\ncircle = false".into(),
            "circle",
        ),
        (
            "chord = 1\npoints = [[3, 0], [2, 0.1], [1, 0], [2, -0.1], [3, 0]]".into(),
            "points from x/c = 1 to 3",
        ),
        (
            "chord = 1\npoints = [[100, 0], [50, 10], [0, 0], [50, -10], [100, 0]]".into(),
            "points from x/c = 0 to 100",
        ),
    ];
    for (shape, expected) in cases {
        let message = parse(&shape).expect_err(&shape);
        assert!(message.contains(expected), "{shape}\n{message}");
        assert!(message.contains("a.layup.toml:"), "{message}");
    }
    for fine in [table("[0.32, 0.12]"), "chord = 1\nnaca = \"0012\"".into()] {
        assert_eq!(parse(&fine), Ok(()), "{fine}");
    }
}
