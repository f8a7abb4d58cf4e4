//! Messages of the readers about files with problems, and absence of panics.

use super::read_tests::{V22, V41, refused};
use super::*;

/// The messages for `text` with `from` replaced by `to`.
fn messages(text: &str, from: &str, to: &str) -> String {
    assert!(text.contains(from), "\"{from}\" is in the file");
    refused(&text.replacen(from, to, 1)).to_string()
}

fn assert_says(messages: &str, expected: &str) {
    assert!(
        messages.contains(expected),
        "expected {expected:?} in:\n{messages}"
    );
}

#[test]
fn other_formats_are_refused_with_the_way_out() {
    assert_says(
        &messages(V41, "4.1 0 8", "4.1 2 8"),
        "test.msh:2: file type \"2\" found, expected 0 (ascii) or 1 (binary)",
    );
    assert_says(
        &messages(V22, "2.2 0 8", "2.2 0 4"),
        "test.msh:2: numbers of 4 bytes announced, expected 8",
    );
    // the text that follows is no integer one
    assert_says(
        &messages(V22, "2.2 0 8", "2.2 1 8"),
        "the binary file should begin with the integer 1, found 1684948260",
    );
    assert_says(
        &messages(V22, "2.2 0 8", "2 1 8"),
        "gmsh FILE -save -format msh41 -o NEW.msh",
    );
    assert_says(
        &messages(V41, "4.1 0 8", "4 0 8"),
        "version \"4\" found, expected 2.2 or 4.1",
    );
    assert_says(
        &messages(V41, "4.1 0 8", "4.1 0"),
        "test.msh:2: expected version, file type",
    );
    assert_says(&refused("").to_string(), "the file is empty");
    assert_says(
        &refused("$NOD\n1\n1 0 0 0\n$ENDNOD\n").to_string(),
        "this is no mesh of gmsh (no section \"$MeshFormat\"), Abaqus (the name does not end in \
         \".inp\"), VTK or VABS",
    );
}

#[test]
fn names_in_another_encoding_are_reported() {
    let latin: Vec<u8> = V41
        .replace("p q", "\u{fc}")
        .chars()
        .map(|letter| letter as u8)
        .collect();
    let foreign = read(&latin, "test.msh").unwrap_err().to_string();
    assert_says(
        &foreign,
        "test.msh:6: the line holds bytes that are no UTF-8 text",
    );
}

#[test]
fn elements_that_are_not_read_are_counted_by_type() {
    let all = messages(
        V22,
        "4\n1 15",
        "7\n11 4 2 1 1 10 2 3 4\n12 4 2 1 1 2 3 4 5\n13 21 2 1 1 1 1 1 1 1 1 1 1 1 1\n1 15",
    );
    assert_says(
        &all,
        "test.msh:24: 2 elements of type \"tetrahedron with 4 nodes\" (gmsh type 4) found, \
         expected points, lines with 2 or 3 nodes, triangles with 3 or 6 nodes, \
         quadrilaterals with 4, 8 or 9 nodes",
    );
    assert_says(
        &all,
        "test.msh:26: 1 element of type \"triangle with 10 nodes\"",
    );
    assert_says(&all, "help: mesh with Mesh.ElementOrder = 1 or 2");

    let all = messages(
        V41,
        "4 4 1 4\n0 1 15 1",
        "5 6 1 6\n3 1 5 2\n8 1\n9 2\n0 1 15 1",
    );
    assert_says(
        &all,
        "2 elements of type \"hexahedron with 8 nodes\" (gmsh type 5)",
    );
}

#[test]
fn bad_numbers_are_reported_with_their_line() {
    let coordinate = messages(V22, "2 2 0 0", "2 2 nan 0");
    assert_says(
        &coordinate,
        "test.msh:13: coordinate: expected a finite number, found \"nan\"",
    );
    // the node exists, only its position is unknown: no further messages
    assert_eq!(coordinate.lines().count(), 1);
    let coordinate = messages(V41, "1 0.5 0 0.5 0.5", "1 inf 0 0.5 0.5");
    assert_says(
        &coordinate,
        "test.msh:46: coordinate: expected a finite number, found \"inf\"",
    );
    let tag = messages(V41, "\n900000000000\n", "\n-9\n");
    assert_says(
        &tag,
        "test.msh:45: node tag: expected a whole number, found \"-9\"",
    );
    let tag = messages(V22, "3 8 2 8 2 2", "3 8 2 x 2 2");
    assert_says(
        &tag,
        "test.msh:26: physical tag: expected a whole number, found \"x\"",
    );
}

#[test]
fn wrong_numbers_of_fields_are_reported() {
    assert_says(
        &messages(V22, "3 2 1 0", "3 2 1"),
        "expected a node: tag, x, y, z, found 3 fields",
    );
    assert_says(
        &messages(V22, "3 8 2 8 2 2 3 6", "3 8 2 8 2 2 3 6 7"),
        "found 9 fields",
    );
    assert_says(
        &messages(V41, "\n0 1 0\n1 1 1 4", "\n0 1\n1 1 1 4"),
        "found 2 fields",
    );
    assert_says(
        &messages(V41, "3 2 3 6", "3 2 3"),
        "test.msh:55: expected an element",
    );
    assert_says(&messages(V41, "1 10 \n", "1\n"), "found 1 field");
    assert_says(&messages(V41, "0 1 0 1\n10", "0 1 0\n10"), "a node block");
}

#[test]
fn counts_must_match() {
    let few = messages(V22, "$Nodes\n9", "$Nodes\n10");
    assert_says(&few, "10 nodes are announced, found 9");
    let many = messages(V22, "$Nodes\n9", "$Nodes\n8");
    assert_says(&many, "test.msh:20: expected the end of section \"$Nodes\"");
    let total = messages(V41, "4 9 2 900", "4 8 2 900");
    assert_says(&total, "8 nodes are announced, found 9");
    let block = messages(V41, "0 2 0 3\n", "0 2 0 4\n");
    assert_says(&block, "expected a node tag, found 3 fields");
    let block = messages(V41, "2 1 10 1\n", "2 1 10 2\n");
    assert_says(&block, "2 elements are announced, found 1");
    let names = messages(V41, "$PhysicalNames\n3", "$PhysicalNames\n4");
    assert_says(&names, "4 physical names are announced, found 3");
}

#[test]
fn a_count_beyond_the_file_is_refused_before_memory_is_reserved() {
    for count in ["5000", "18446744073709551615"] {
        for (text, from) in [
            (V22, "$Nodes\n9"),
            (V22, "$Elements\n4"),
            (V22, "$PhysicalNames\n3"),
            (V41, "$Entities\n5"),
            (V41, "$Nodes\n4"),
            (V41, "$Nodes\n4 9"),
            (V41, "0 2 0 3"),
            (V41, "$Elements\n4 4"),
            (V41, "1 2 8 1"),
        ] {
            let (head, _) = from.rsplit_once(['\n', ' ']).unwrap();
            let separator = &from[head.len()..=head.len()];
            let all = messages(text, from, &format!("{head}{separator}{count}"));
            assert_says(&all, "announced, more than the rest of the file can hold");
        }
    }
    // more than any integer: no number at all
    let all = messages(V22, "$Nodes\n9", "$Nodes\n99999999999999999999");
    assert_says(&all, "expected a whole number");
}

#[test]
fn sections_must_be_closed() {
    let open = messages(V22, "$EndNodes\n", "");
    assert_says(
        &open,
        "section \"$Nodes\" is not closed: expected \"$EndNodes\", found \"$Elements\"",
    );
    // the next section is read all the same
    assert!(!open.contains("missing"), "{open}");
    let wrong = messages(V41, "$EndNodes", "$EndNode");
    assert_says(&wrong, "expected \"$EndNodes\", found \"$EndNode\"");
    let cut = messages(V41, "$EndElements\n", "");
    assert_says(&cut, "expected \"$EndElements\", found the end of the file");
    assert_says(&cut, "help: the file may have been cut off");
    let slip = messages(V22, "$Nodes", "$Nods");
    assert_says(&slip, "section \"$Nods\" is not closed");
    assert_says(&slip, "help: did you mean \"$Nodes\"?");
    assert_says(&slip, "section \"$Nodes\" is missing");
    assert_says(
        &messages(V22, "$Elements", "1 2"),
        "text outside of any section: \"1 2\"",
    );
    assert_says(
        &messages(V22, "$PhysicalNames", "$EndX\n$PhysicalNames"),
        "\"$EndX\" found, but no",
    );
}

#[test]
fn a_section_that_is_listed_twice_is_reported_and_read_once() {
    let (_, nodes) = V22.split_once("$Nodes").unwrap();
    let (nodes, _) = nodes.split_once("$Elements").unwrap();
    let twice = refused(&format!("{V22}$Nodes{nodes}")).to_string();
    assert_says(
        &twice,
        "test.msh:29: section \"$Nodes\" found again, expected it once",
    );
    assert_eq!(twice.matches("error").count(), 1, "{twice}");
}

#[test]
fn all_unknown_nodes_are_reported_up_to_a_limit() {
    let all = messages(
        V22,
        "2 8 2 7 1 2 10 5\n3 8 2 8 2 2 3 6",
        "2 8 2 7 1 2 10 55\n3 8 2 8 2 2 3 66",
    );
    assert_says(
        &all,
        "test.msh:25: element 2 refers to node 55, which does not exist",
    );
    assert_says(
        &all,
        "test.msh:26: element 3 refers to node 66, which does not exist",
    );
    assert_eq!(all.lines().count(), 2);

    let lines: String = (0..30).map(|i| format!("{} 15 0 77\n", 100 + i)).collect();
    let all = messages(V22, "4\n1 15", &format!("34\n{lines}1 15"));
    assert_eq!(all.matches("refers to node 77").count(), 20);
    assert_says(&all, "and 10 more problems");
}

#[test]
fn doubled_tags_are_reported() {
    assert_says(
        &messages(V22, "3 2 1 0", "2 2 1 0"),
        "test.msh:14: node 2 is listed twice",
    );
    assert_says(
        &messages(V41, "\n3\n4\n", "\n3\n3\n"),
        "test.msh:34: node 3 is listed twice",
    );
    assert_says(
        &messages(V22, "3 8 2 8", "2 8 2 8"),
        "test.msh:26: element 2 is listed twice",
    );
    assert_says(
        &messages(V41, "\n3 2 3 6", "\n2 2 3 6"),
        "element 2 is listed twice",
    );
    assert_says(
        &messages(V41, "2 2 0 0 0", "1 2 0 0 0"),
        "entity 1 of dimension 0 is listed twice",
    );
    assert_says(
        &messages(V22, "2 1 \"a\"", "1 7 \"a\""),
        "physical group 7 of dimension 1 is named twice",
    );
}

#[test]
fn two_cells_on_the_same_corners_are_reported() {
    // not if gmsh has written one cell for each of its groups (2.2)
    let text = V22.replace("$Elements\n4", "$Elements\n5").replace(
        "$EndElements",
        "5 10 2 1 1 10 4 3 2 8 7 6 5 900000000000\n$EndElements",
    );
    let expected = "test.msh:28: cells 4 and 5 have the same corners";
    assert_says(&refused(&text).to_string(), expected);
    let no_group = text.replace("5 10 2 1 1", "5 10 2 0 1");
    assert_says(&refused(&no_group).to_string(), expected);
    let other_entity = text.replace("5 10 2 1 1", "5 10 2 2 2");
    assert_says(&refused(&other_entity).to_string(), expected);
    let other_kind = text
        .replace("5 10 2 1 1", "5 3 2 2 1")
        .replace("8 7 6 5 900000000000\n$End", "\n$End");
    assert_says(&refused(&other_kind).to_string(), expected);
}

#[test]
fn other_slips_of_4_1_files_are_reported() {
    let unknown = messages(V41, "2 1 10 1\n", "2 5 10 1\n");
    assert_says(
        &unknown,
        "entity 5 of dimension 2, which section \"$Entities\" does not list",
    );
    let dimension = messages(V41, "2 1 10 1\n", "1 1 10 1\n");
    assert_says(
        &dimension,
        "quadrilateral with 9 nodes in a block of dimension 1",
    );
    let parts = format!("{V41}$PartitionedEntities\n1\n$EndPartitionedEntities\n");
    let parts = refused(&parts.replace("2 1 10 1\n", "2 5 10 1\n")).to_string();
    assert_says(&parts, "the mesh is partitioned");
    assert_eq!(parts.matches("error").count(), 1, "{parts}");
    assert_says(
        &messages(V41, "1 7 \"the skin\"", "1 7 skin"),
        "name in double quotes",
    );
    assert_says(
        &messages(V41, "1 7 \"the skin\"", "4 7 \"the skin\""),
        "dimension 4 found",
    );
}

/// Reads every text that differs from `text` by its end or by one byte. The test is that
/// there are no panics (and no endless loops).
fn torture(text: &str) {
    let check = |bytes: &[u8]| {
        if let Ok(text) = std::str::from_utf8(bytes)
            && let Err(problems) = read(text, "test.msh")
        {
            assert!(!problems.is_empty());
        }
    };
    let bytes = text.as_bytes();
    for i in 0..bytes.len() {
        check(&bytes[..i]);
        check(&[&bytes[..i], &bytes[i + 1..]].concat());
        for bit in 0..7 {
            let mut flipped = bytes.to_vec();
            flipped[i] ^= 1 << bit;
            check(&flipped);
        }
        for other in *b"0-9$\" \n" {
            let mut changed = bytes.to_vec();
            changed[i] = other;
            check(&changed);
        }
    }
}

#[test]
fn no_cut_or_changed_byte_makes_the_reader_panic() {
    torture(V22);
    torture(V41);
}

#[test]
fn a_file_that_is_cut_off_is_refused() {
    for text in [V22, V41] {
        let whole = text.trim_end().len();
        for end in 0..whole {
            assert!(read(&text[..end], "test.msh").is_err(), "cut at byte {end}");
        }
    }
}
