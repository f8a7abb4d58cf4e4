//! `matrices`: sections given by matrices, from correct and wrong files.

use crate::workplace::Workplace;

/// Four nodes of a square; wrong matrices, but of the right form.
fn workplace() -> Workplace {
    let workplace = Workplace::with(&[], &[]);
    workplace.write("nodes.csv", "node,y,z\n1,0,0\n2,1,0\n3,1,1\n4,0,1\n");
    workplace.write(
        "unit.mtx",
        "%%MatrixMarket matrix coordinate real symmetric\n12 12 1\n1 1 1.0\n",
    );
    workplace
}

const BLOCKS: &str = "\
units = \"SI\"
nodes = \"nodes.csv\"
[matrices]
m = \"unit.mtx\"
c = \"unit.mtx\"
e = \"unit.mtx\"
";

fn refused(workplace: &Workplace, text: &str) -> String {
    workplace.write("a.matrices.toml", text);
    let run = workplace.run(&["matrices", "a.matrices.toml"]);
    assert_eq!(run.code, 2, "{}{}", run.out, run.err);
    assert!(!workplace.path("results/a.properties.json").exists());
    run.err
}

/// All problems of the files are reported together, with file and line.
#[test]
fn wrong_files_are_all_reported() {
    let workplace = workplace();
    workplace.write(
        "short.mtx",
        "%%MatrixMarket matrix coordinate real general\n3 3 2\n4 1 1.0\n",
    );
    let text = BLOCKS
        .replace("m = \"unit", "m = \"short")
        .replace("e = \"unit.mtx\"\n", "");
    let reported = refused(&workplace, &text);
    for words in [
        "short.mtx:3: an entry at row 4, column 1 of a matrix of 3 x 3",
        "the file has 1 lines of values, expected 2",
        "\"e\"",
    ] {
        assert!(reported.contains(words), "{words}: {reported}");
    }
    workplace.write(
        "small.mtx",
        "%%MatrixMarket matrix array real general\n1 1\n1\n",
    );
    let reported = refused(&workplace, &BLOCKS.replace("c = \"unit", "c = \"small"));
    assert!(
        reported.contains("a.matrices.toml:5: \"small.mtx\" is 1 x 1, expected 12 x 12"),
        "{reported}"
    );
    assert!(reported.contains("ux, uy, uz"), "{reported}");
    let reported = refused(&workplace, &BLOCKS.replace("nodes.csv", "node.csv"));
    assert!(
        reported.contains("node table \"node.csv\" cannot be read: no such file"),
        "{reported}"
    );
    let reported = refused(&workplace, "units = \"SI\"\nnodes = \"nodes.csv\"\n");
    assert!(
        reported.contains("neither [matrices] nor [slice]"),
        "{reported}"
    );
    let both = format!("{BLOCKS}[slice]\nstiffness = \"unit.mtx\"\nthickness = 1\n");
    assert!(refused(&workplace, &both).contains("both [matrices] and [slice] are given"));
    let reported = refused(&workplace, &format!("{BLOCKS}k = \"unit.mtx\"\n"));
    assert!(reported.contains("\"k\""), "{reported}");
}

/// Reports the identities that the matrices violate, with their errors.
#[test]
fn broken_identities_are_reported() {
    let reported = refused(&workplace(), BLOCKS);
    for words in [
        "C H = L T is violated by",
        "expected less than 1e-6",
        "rows of C belong to u'",
        "[initial_curvature]",
        "degrees per length",
    ] {
        assert!(reported.contains(words), "{words}: {reported}");
    }
}

const SLICE: &str = "\
units = \"SI\"
nodes = \"nodes.csv\"
[slice]
stiffness = \"k.mtx\"
thickness = 0.1
";

/// A matrix of 24 x 24 with a unit diagonal and one more entry.
fn slice(workplace: &Workplace, file: &str, symmetry: &str, more: &str) {
    let diagonal: String = (1..=24).map(|i| format!("{i} {i} 1.0\n")).collect();
    let head = format!("%%MatrixMarket matrix coordinate real {symmetry}\n24 24");
    workplace.write(file, &format!("{head} 25\n{diagonal}{more}\n"));
}

/// Invalid slices: unsymmetric, of a curved beam, with two masses, or with an invalid
/// mass. Each is reported with its line.
#[test]
fn wrong_slices_are_reported_with_their_lines() {
    let workplace = workplace();
    slice(&workplace, "k.mtx", "general", "7 3 0.5");
    let reported = refused(&workplace, SLICE);
    for words in [
        "a.matrices.toml:4: the matrix has 0e0 at row 3, column 7 and 5e-1 at row 7, column 3",
        "a file with one triangle needs \"symmetric\"",
    ] {
        assert!(reported.contains(words), "{words}: {reported}");
    }
    slice(&workplace, "k.mtx", "symmetric", "7 3 0.5");
    let reported = refused(
        &workplace,
        &format!("{SLICE}[initial_curvature]\ncurvature = [0.1, 0, 0]\n"),
    );
    assert!(
        reported.contains("a slice is from a straight beam"),
        "{reported}"
    );

    let rows = |first: f64| {
        let row = |i: usize| {
            let mut row = [0.0; 6];
            row[i] = [first, 3.0, 3.0, 5.0, 2.0, 3.0][i];
            format!("{row:?}")
        };
        let rows: Vec<_> = (0..6).map(row).collect();
        format!("mass = [{}]\n", rows.join(", "))
    };
    let reported = refused(&workplace, &format!("{}{SLICE}", rows(-3.0)));
    assert!(reported.contains("a.matrices.toml:1: mass"), "{reported}");
    assert!(
        reported.contains("expected three equal masses"),
        "{reported}"
    );
    workplace.write("m.mtx", &workplace.read("k.mtx"));
    let both = format!("{}{SLICE}mass = \"m.mtx\"\n", rows(3.0));
    assert!(refused(&workplace, &both).contains("\"mass\" is given above too"));
    slice(&workplace, "m.mtx", "general", "7 3 0.5");
    let reported = refused(&workplace, &format!("{SLICE}mass = \"m.mtx\"\n"));
    assert!(
        reported.contains("a.matrices.toml:6: the matrix has 0e0 at row 3"),
        "{reported}"
    );

    let reported = refused(
        &workplace,
        "units = \"SI\"\nnodes = \"nodes.csv\"\nslice = \"k.mtx\"\n",
    );
    assert!(reported.contains("slice"), "{reported}");
    assert!(!reported.contains("neither"), "{reported}");
}

/// Each command names the other for a file of the other kind.
#[test]
fn files_of_the_other_kind() {
    let workplace = Workplace::with(&[], &[]);
    workplace.write("b.matrices.toml", SLICE);
    for (command, file, other) in [
        ("matrices", "a.section.toml", "analyze"),
        ("analyze", "b.matrices.toml", "matrices"),
        ("check", "b.matrices.toml", "matrices"),
    ] {
        let run = workplace.run(&[command, file]);
        assert_eq!(run.code, 2, "{}", run.err);
        let words = format!("use \"section-analyzer {other}\"");
        assert!(run.err.contains(&words), "{}", run.err);
        assert_eq!(run.err.lines().count(), 2, "{}", run.err);
    }
}
