//! Tests of saving: endings, formats, fonts, averaging.

use plotters::style::{BLACK, RED};

use super::*;

/// A square, a line, a disc and two texts.
struct Sample;

impl Drawing for Sample {
    fn draw<B: DrawingBackend>(&self, canvas: &Canvas<B>) -> Result<(), FigureProblem> {
        assert_eq!(canvas.size(), (60.0, 40.0));
        canvas.polygon(&[[5.0, 5.0], [25.0, 5.0], [25.0, 25.0], [5.0, 25.0]], RED)?;
        canvas.line(&[[30.0, 5.0], [50.0, 5.0], [50.0, 9.0]], 2.0, BLACK)?;
        canvas.disc([40.0, 20.0], 5.0, BLACK)?;
        let label = Label::new(10.0).anchored(Anchor::Middle);
        canvas.text("a < b", [30.0, 35.0], label)?;
        canvas.text("up", [56.0, 20.0], label.upward().bold())
    }
}

#[test]
fn png_has_its_size_and_svg_its_text() {
    let folder = tempfile::tempdir().unwrap();
    let png = folder.path().join("a.png");
    save(&png, (60, 40), &Sample).unwrap();
    let bytes = std::fs::read(&png).unwrap();
    // PNG: signature of 8 bytes, then the header block: width and height at 16 and 20.
    assert_eq!(&bytes[..4], b"\x89PNG");
    assert_eq!(bytes[16..24], [0, 0, 0, 60, 0, 0, 0, 40]);

    let svg = folder.path().join("a.SVG");
    save(&svg, (60, 40), &Sample).unwrap();
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
    let wrong = save(Path::new("a.jpeg"), (60, 40), &Sample).unwrap_err();
    assert_eq!(
        wrong.to_string(),
        "figure \"a.jpeg\" ends in neither \".png\" nor \".svg\""
    );
    assert_eq!(wrong.help().unwrap(), "name the file .png or .svg");
    for file in ["no/such/folder/a.png", "no/such/folder/a.svg"] {
        let wrong = save(Path::new(file), (60, 40), &Sample).unwrap_err();
        assert!(matches!(wrong, FigureProblem::Unwritable { .. }), "{wrong}");
    }
}

#[test]
fn longer_texts_are_wider() {
    struct Widths;
    impl Drawing for Widths {
        fn draw<B: DrawingBackend>(&self, canvas: &Canvas<B>) -> Result<(), FigureProblem> {
            let (one, two) = (canvas.text_width("n", 20.0), canvas.text_width("nn", 20.0));
            assert!(one > 5.0 && (two - 2.0 * one).abs() <= 1.0, "{one} {two}");
            Ok(())
        }
    }
    let folder = tempfile::tempdir().unwrap();
    save(&folder.path().join("w.svg"), (60, 40), &Widths).unwrap();
}
