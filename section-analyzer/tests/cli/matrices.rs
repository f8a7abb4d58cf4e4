//! `matrices`: sections given by matrices, from files that are right and wrong.

use crate::workplace::Workplace;

/// Four nodes of a square; wrong matrices, but of the right form.
fn place() -> Workplace {
    let place = Workplace::with(&[], &[]);
    place.write("nodes.csv", "node,y,z\n1,0,0\n2,1,0\n3,1,1\n4,0,1\n");
    place.write(
        "unit.mtx",
        "%%MatrixMarket matrix coordinate real symmetric\n12 12 1\n1 1 1.0\n",
    );
    place
}

const BLOCKS: &str = "\
units = \"SI\"
nodes = \"nodes.csv\"
[matrices]
m = \"unit.mtx\"
c = \"unit.mtx\"
e = \"unit.mtx\"
";

fn refused(place: &Workplace, text: &str) -> String {
    place.write("a.matrices.toml", text);
    let run = place.run(&["matrices", "a.matrices.toml"]);
    assert_eq!(run.code, 2, "{}{}", run.out, run.err);
    assert!(!place.path("results/a.properties.json").exists());
    run.err
}

/// All that is wrong with the files is told at once, with file and line.
#[test]
fn wrong_files_are_all_told() {
    let place = place();
    place.write(
        "short.mtx",
        "%%MatrixMarket matrix coordinate real general\n3 3 2\n4 1 1.0\n",
    );
    let text = BLOCKS
        .replace("m = \"unit", "m = \"short")
        .replace("e = \"unit.mtx\"\n", "");
    let told = refused(&place, &text);
    for words in [
        "short.mtx:3: an entry at row 4, column 1 of a matrix of 3 x 3",
        "the file has 1 lines of values, expected 2",
        "\"e\"",
    ] {
        assert!(told.contains(words), "{words}: {told}");
    }
    place.write(
        "small.mtx",
        "%%MatrixMarket matrix array real general\n1 1\n1\n",
    );
    let told = refused(&place, &BLOCKS.replace("c = \"unit", "c = \"small"));
    assert!(
        told.contains("a.matrices.toml:5: \"small.mtx\" is 1 x 1, expected 12 x 12"),
        "{told}"
    );
    assert!(told.contains("ux, uy, uz"), "{told}");
    let told = refused(&place, &BLOCKS.replace("nodes.csv", "node.csv"));
    assert!(
        told.contains("node table \"node.csv\" cannot be read: no such file"),
        "{told}"
    );
    let told = refused(&place, "units = \"SI\"\nnodes = \"nodes.csv\"\n");
    assert!(told.contains("neither [matrices] nor [slice]"), "{told}");
    let both = format!("{BLOCKS}[slice]\nstiffness = \"unit.mtx\"\nthickness = 1\n");
    assert!(refused(&place, &both).contains("[matrices] and [slice] are given"));
    let told = refused(&place, &format!("{BLOCKS}k = \"unit.mtx\"\n"));
    assert!(told.contains("\"k\""), "{told}");
}

/// Which identities the matrices break, and by how much.
#[test]
fn broken_identities_are_told() {
    let told = refused(&place(), BLOCKS);
    for words in [
        "C H = L T is broken by",
        "expected less than 1e-6",
        "rows of C belong to u'",
    ] {
        assert!(told.contains(words), "{words}: {told}");
    }
}
