//! Tests of saving: endings, formats, fonts, averaging.

use super::*;

/// A square, a line, a disc and two texts.
struct Sample;

impl Figure for Sample {
    fn size(&self) -> (u32, u32) {
        (60, 40)
    }

    fn draw(&self, drawing: &mut Drawing) {
        let red = Color(255, 0, 0);
        drawing.polygon(&[[5.0, 5.0], [25.0, 5.0], [25.0, 25.0], [5.0, 25.0]], red);
        drawing.line(&[[30.0, 5.0], [50.0, 5.0], [50.0, 9.0]], 2.0, BLACK);
        drawing.disc([40.0, 20.0], 5.0, BLACK);
        let label = Label::new(10.0).anchored(Anchor::Middle);
        drawing.text("a < b", [30.0, 35.0], label);
        drawing.text("up", [56.0, 20.0], label.upward().bold());
    }
}

#[test]
fn png_has_its_size_and_svg_its_text() {
    let folder = tempfile::tempdir().unwrap();
    let png = folder.path().join("a.png");
    Sample.drawing().save(&png).unwrap();
    let bytes = std::fs::read(&png).unwrap();
    // PNG: signature of 8 bytes, then the header block: width and height at 16 and 20.
    assert_eq!(&bytes[..4], b"\x89PNG");
    assert_eq!(bytes[16..24], [0, 0, 0, 60, 0, 0, 0, 40]);

    let svg = folder.path().join("a.SVG");
    Sample.drawing().save(&svg).unwrap();
    let text = std::fs::read_to_string(&svg).unwrap();
    assert!(
        text.starts_with(
            "<svg width=\"60\" height=\"40\" stroke-linejoin=\"round\" viewBox=\"0 0 480 320\""
        ),
        "{text}"
    );
    assert!(text.contains("a &lt; b"));
}

#[test]
fn wrong_endings_and_folders_are_reported() {
    let wrong = Sample.drawing().save(Path::new("a.jpeg")).unwrap_err();
    assert_eq!(
        wrong.to_string(),
        "figure \"a.jpeg\" ends in neither \".png\" nor \".svg\""
    );
    assert_eq!(wrong.help().unwrap(), "name the file .png or .svg");
    for file in ["no/such/folder/a.png", "no/such/folder/a.svg"] {
        let wrong = Sample.drawing().save(Path::new(file)).unwrap_err();
        assert!(matches!(wrong, FigureProblem::Unwritable { .. }), "{wrong}");
    }
}

#[test]
fn longer_texts_are_wider() {
    let [one, two] = ["n", "nn"].map(|text| text_width(text, Label::new(20.0)));
    assert!(one > 5.0 && (two - 2.0 * one).abs() <= 0.2, "{one} {two}");
    let bold = text_width("n", Label::new(20.0).bold());
    assert!(bold > one && bold < 1.2 * one, "{bold}");
}

#[test]
fn texts_are_recorded_in_their_order() {
    let drawing = Sample.drawing();
    assert_eq!(drawing.size(), (60.0, 40.0));
    assert_eq!(drawing.texts().collect::<Vec<_>>(), ["a < b", "up"]);
}

/// A region is its polygons in an SVG, and the pixels within its border in a PNG.
#[test]
fn regions_are_the_same_in_both_formats() {
    let square = [[5.0, 5.0], [25.0, 5.0], [25.0, 25.0], [5.0, 25.0]];
    let border = [0, 1, 2, 3].map(|k| [square[k], square[(k + 1) % 4]]);
    let mut region = Drawing::new((30, 30));
    region.region(vec![square.to_vec()], border.to_vec(), BLACK);
    let mut polygon = Drawing::new((30, 30));
    polygon.polygon(&square, BLACK);
    let folder = tempfile::tempdir().unwrap();
    for name in ["a.png", "a.svg"] {
        let [one, two] = [&region, &polygon].map(|drawing| {
            let path = folder.path().join(name);
            drawing.save(&path).unwrap();
            std::fs::read(path).unwrap()
        });
        assert_eq!(one, two, "{name}");
    }
}

/// A field of 50 by 50 squares between two texts is one image of an SVG, and a field of 40 by 40 is
/// not: its squares are elements.
#[test]
fn large_fields_are_images_of_an_svg() {
    let folder = tempfile::tempdir().unwrap();
    let saved = |count: usize| {
        let mut drawing = Drawing::new((300, 300));
        drawing.text("above", [10.0, 10.0], Label::new(10.0));
        let ends = |k: usize| [20.0 + 5.0 * k as f64, 25.0 + 5.0 * k as f64];
        for ([left, right], [top, bottom]) in
            (0..count).flat_map(|i| (0..count).map(move |j| (ends(i), ends(j))))
        {
            let corners = [[left, top], [right, top], [right, bottom], [left, bottom]];
            drawing.polygon(&corners, Color(200, 0, 0));
        }
        drawing.text("below", [10.0, 290.0], Label::new(10.0));
        drawing.line(&[[10.0, 280.0], [290.0, 280.0]], 2.0, BLACK);
        let path = folder.path().join("a.svg");
        drawing.save(&path).unwrap();
        std::fs::read_to_string(path).unwrap()
    };
    let [few, many] = [40, 50].map(saved);
    let counts = |text: &str| {
        ["<image ", "<polygon ", "<polyline ", "<text "].map(|tag| text.matches(tag).count())
    };
    assert_eq!(counts(&few), [0, 1600, 1601, 2]);
    assert_eq!(counts(&many), [1, 0, 1, 2]);
    let image = "<image x=\"160\" y=\"160\" width=\"2000\" height=\"2000\" ";
    assert!(many.contains(image) && many.ends_with("</svg>\n"));
}
