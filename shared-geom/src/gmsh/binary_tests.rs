//! Binary files made by hand: their content, and the messages on problems. Files of gmsh
//! itself are read in the suites of the workspace.

use super::*;

/// Joins the parts of a file.
struct Bytes {
    bytes: Vec<u8>,
    big: bool,
}

impl Bytes {
    fn new(version: &str, big: bool) -> Self {
        let bytes = Vec::new();
        let head = format!("$MeshFormat\n{version} 1 8\n");
        Self { bytes, big }
            .text(&head)
            .ints(&[1])
            .text("\n$EndMeshFormat\n")
    }

    fn text(mut self, text: &str) -> Self {
        self.bytes.extend(text.bytes());
        self
    }

    fn put<const N: usize>(mut self, mut number: [u8; N]) -> Self {
        if self.big {
            number.reverse();
        }
        self.bytes.extend(number);
        self
    }

    fn ints(self, numbers: &[i32]) -> Self {
        let put = |to: Self, number: &i32| to.put(number.to_le_bytes());
        numbers.iter().fold(self, put)
    }

    fn sizes(self, numbers: &[u64]) -> Self {
        let put = |to: Self, number: &u64| to.put(number.to_le_bytes());
        numbers.iter().fold(self, put)
    }

    fn reals(self, numbers: &[f64]) -> Self {
        let put = |to: Self, number: &f64| to.put(number.to_le_bytes());
        numbers.iter().fold(self, put)
    }
}

const POSITIONS: [f64; 9] = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0];

/// Three nodes 7 8 9, the second at `x`, and a triangle 4 of `kind`, with a section of
/// another kind between them whose content looks like a section.
fn v41(big: bool, x: f64, kind: i32) -> Vec<u8> {
    let mut locations = POSITIONS;
    locations[3] = x;
    Bytes::new("4.1", big)
        .text("$Nodes\n")
        .sizes(&[1, 3, 7, 9])
        .ints(&[2, 1, 0])
        .sizes(&[3, 7, 8, 9])
        .reals(&locations)
        .text("\n$EndNodes\n$Other\n\n$Nodes\n$EndOthers\n\n$EndOther\n$Elements\n")
        .sizes(&[1, 1, 4, 4])
        .ints(&[2, 1, kind])
        .sizes(&[1, 4, 7, 8, 9])
        .text("\n$EndElements\n")
        .bytes
}

/// The same in version 2.2, and a line 3 between nodes 7 and 8 in physical curve -6.
fn v22(big: bool, tag: i32, blocks: &[i32]) -> Vec<u8> {
    Bytes::new("2.2", big)
        .text("$Nodes\n3\n")
        .ints(&[tag])
        .reals(&POSITIONS[..3])
        .ints(&[8])
        .reals(&POSITIONS[3..6])
        .ints(&[9])
        .reals(&POSITIONS[6..])
        .text("\n$EndNodes\n$Elements\n2\n")
        .ints(blocks)
        .text("\n$EndElements\n")
        .bytes
}

const BLOCKS: [i32; 17] = [1, 1, 2, 3, -6, 5, 7, 8, 2, 1, 3, 4, 0, 1, 99, 7, 8];

fn messages(bytes: &[u8]) -> String {
    let problems = read(bytes, "test.msh").expect_err("the file has a problem");
    problems.to_string()
}

#[test]
fn both_orders_and_versions_are_read() {
    for big in [false, true] {
        let new = read(&v41(big, 1.0, 2), "test.msh").unwrap();
        let mut blocks = BLOCKS.to_vec();
        blocks.push(9);
        let old = read(&v22(big, 7, &blocks), "test.msh").unwrap();
        assert_eq!(new.nodes, old.nodes);
        assert_eq!(new.cells, old.cells);
        assert_eq!(new.cells[0].nodes(), [0, 1, 2]);
        assert_eq!((old.lines[0].tag, old.lines[0].nodes()), (3, &[0, 1][..]));
        assert_eq!(old.groups[0].tag, 6);
    }
}

#[test]
fn problems_are_reported_with_their_byte() {
    for big in [false, true] {
        // format 40 bytes, "$Nodes" 7, counts 32, block 20, tags 24, first node 24
        assert_eq!(
            messages(&v41(big, f64::NAN, 2)),
            "error: test.msh: byte 147: coordinate: expected a finite number, found \"NaN\""
        );
        let mut blocks = BLOCKS.to_vec();
        blocks.push(9);
        let negative = messages(&v22(big, -7, &blocks));
        assert_eq!(
            negative,
            "error: test.msh: byte 49: node tag: expected a whole number, found \"-7\""
        );
        blocks[17] = 10;
        let unknown = messages(&v22(big, 7, &blocks));
        assert!(unknown.contains("element 4 refers to node 10"), "{unknown}");
    }
}

#[test]
fn elements_that_are_not_read_are_passed_over_if_their_size_is_known() {
    // type 20, a triangle with 9 nodes, takes more than the available bytes
    let known = messages(&v41(false, 1.0, 20));
    assert!(
        known.contains("1 element of type \"triangle with 9 nodes\""),
        "{known}"
    );
    assert!(
        known.contains("the file ends within elements of a block"),
        "{known}"
    );
    let strange = messages(&v41(false, 1.0, 99));
    assert!(
        strange.contains("the size of elements of gmsh type 99 is not known"),
        "{strange}"
    );
    // a tetrahedron before the triangle
    let blocks = [
        &[4, 1, 2, 3, 0, 1, 7, 8, 9, 7],
        &[2, 1, 3, 4, 0, 1, 99, 7, 8, 9][..],
    ];
    let volume = messages(&v22(true, 7, &blocks.concat()));
    assert_eq!(volume.matches("error").count(), 1, "{volume}");
    assert!(
        volume.contains("help: mesh the section as a plane surface"),
        "{volume}"
    );
}

#[test]
fn sections_that_hold_other_than_they_announce_are_reported() {
    let short = messages(&v22(false, 7, &BLOCKS));
    assert!(
        short.contains("expected the end of section \"$Elements\""),
        "{short}"
    );
    assert!(
        short.contains("help: the file may have been cut off"),
        "{short}"
    );
    let mut blocks = BLOCKS.to_vec();
    blocks.push(9);
    for (count, found) in [(0, "a block of 0 elements"), (3, "a block of 3 elements")] {
        blocks[1] = count;
        let reported = messages(&v22(false, 7, &blocks));
        assert!(
            reported.contains(found) && reported.contains("expected 1 to 2"),
            "{reported}"
        );
    }
    // the nodes end too early: the sections after their end are read all the same
    let mut bytes = v41(false, 1.0, 2);
    let at = bytes.windows(9).position(|w| w == b"$EndNodes").unwrap();
    bytes.drain(at - 9..at - 1);
    let nodes = messages(&bytes);
    assert_eq!(nodes.matches("error").count(), 1, "{nodes}");
    assert!(
        nodes.contains("expected the end of section \"$Nodes\""),
        "{nodes}"
    );
}

#[test]
fn unclosed_sections_of_other_things_end_the_file() {
    let bytes = v41(false, 1.0, 2);
    let text = String::from_utf8_lossy(&bytes).replace("$EndOther\n", "$EndOthr\n");
    let at = text.find("$Other").unwrap();
    let whole = bytes.windows(6).position(|w| w == b"$Other").unwrap();
    let changed = [&bytes[..whole], &text.as_bytes()[at..]].concat();
    let reported = messages(&changed);
    assert!(
        reported.contains("section \"$Other\" is not closed"),
        "{reported}"
    );
    assert!(
        reported.contains("section \"$Elements\" is missing"),
        "{reported}"
    );
}
