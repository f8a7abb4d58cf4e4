//! Mesh files of gmsh.

use shared_geom::gmsh;

use crate::mutation::{Random, mutated};
use crate::{alone, seeds, within_memory};

const MUTATIONS: usize = 2000;

/// Reads a mesh and, if it is valid, writes and reads it again.
fn read(bytes: &[u8]) -> Result<(), String> {
    match gmsh::read(bytes, "a.msh") {
        Ok(_) => Ok(()),
        Err(problems) => {
            assert!(!problems.is_empty());
            Err(problems.to_string())
        }
    }
}

#[test]
fn seeds_are_read() {
    let _alone = alone();
    for (name, bytes) in seeds("gmsh") {
        let read = within_memory(&name, &bytes, read);
        assert_eq!(read, Ok(()), "{name}");
    }
}

#[test]
fn a_file_cut_at_any_byte_is_refused() {
    let _alone = alone();
    for (name, bytes) in seeds("gmsh") {
        // sections after the mesh are skipped, but must end
        let whole = bytes.trim_ascii_end().len();
        for end in 0..whole {
            let what = format!("{name} cut at byte {end}");
            let read = within_memory(&what, &bytes[..end], read);
            assert!(read.is_err() || is_between(&bytes, end), "{what}");
        }
    }
}

/// Whether a section ends at a byte.
fn is_between(bytes: &[u8], end: usize) -> bool {
    let before = bytes[..end].trim_ascii_end();
    let line = before
        .rsplit(|&byte| byte == b'\n')
        .next()
        .unwrap_or(before);
    line.starts_with(b"$End") && bytes[before.len()].is_ascii_whitespace()
}

#[test]
fn changed_files_are_read_or_refused() {
    let _alone = alone();
    let (mut good, mut bad) = (0, 0);
    for (number, (name, bytes)) in seeds("gmsh").into_iter().enumerate() {
        let mut random = Random::new(number as u64);
        for mutation in 0..MUTATIONS {
            let changed = mutated(&bytes, &mut random);
            let what = format!("{name}, mutation {mutation}");
            match within_memory(&what, &changed, read) {
                Ok(()) => good += 1,
                Err(_) => bad += 1,
            }
        }
    }
    println!("{good} read, {bad} refused");
    // most changes break a file, but not all
    assert!(good > 100 && bad > good);
}

/// Reads and measures the file in which the first `from` is replaced by `to`.
fn refused(name: &str, from: &[u8], to: &[u8]) -> String {
    let seeds = seeds("gmsh");
    let (_, bytes) = seeds.iter().find(|(seed, _)| seed == name).unwrap();
    let at = bytes.windows(from.len()).position(|w| w == from);
    let at = at.unwrap_or_else(|| panic!("{name}: {from:?}"));
    let changed = [&bytes[..at], to, &bytes[at + from.len()..]].concat();
    within_memory(name, &changed, read).unwrap_err()
}

#[test]
fn no_memory_is_reserved_for_counts_that_cannot_be() {
    let _alone = alone();
    for count in ["1000000000000000000", "18446744073709551615"] {
        for (name, before, was) in [
            ("standing.22a.msh", "$Nodes\n", "6"),
            ("standing.22le.msh", "$Nodes\n", "6"),
            ("standing.22be.msh", "$Elements\n", "5"),
            ("standing.41a.msh", "$Entities\n", "6"),
            ("standing.41a.msh", "$Nodes\n10 ", "6"),
        ] {
            let from = format!("{before}{was}");
            let to = format!("{before}{count}");
            let reported = refused(name, from.as_bytes(), to.as_bytes());
            let expected = "are announced, more than the rest of the file can hold";
            assert!(reported.contains(expected), "{name}: {reported}");
        }
    }
    for count in [u64::MAX, 1_000_000_000_000_000_000] {
        for (name, section, before, order) in [
            (
                "standing.41le.msh",
                "$Entities\n",
                0,
                u64::to_le_bytes as fn(u64) -> [u8; 8],
            ),
            ("standing.41be.msh", "$Entities\n", 2, u64::to_be_bytes),
            ("standing.41le.msh", "$Nodes\n", 0, u64::to_le_bytes),
            ("standing.41be.msh", "$Nodes\n", 1, u64::to_be_bytes),
            ("standing.41le.msh", "$Elements\n", 1, u64::to_le_bytes),
        ] {
            let seeds = seeds("gmsh");
            let (_, bytes) = seeds.iter().find(|(seed, _)| seed == name).unwrap();
            let from = section.as_bytes();
            let at = bytes.windows(from.len()).position(|w| w == from).unwrap();
            let at = at + from.len() + 8 * before;
            let changed = [&bytes[..at], &order(count), &bytes[at + 8..]].concat();
            let reported = within_memory(name, &changed, read).unwrap_err();
            let expected = format!("{count} ");
            assert!(
                reported.contains(&expected) && reported.contains("byte"),
                "{name}: {reported}"
            );
        }
    }
}

#[test]
fn bytes_are_not_read_again_in_each_of_many_sections() {
    let _alone = alone();
    // each section announces elements to the end of the file, but ends at once
    let mut bytes = b"$MeshFormat\n2.2 1 8\n\x01\0\0\0\n$EndMeshFormat\n".to_vec();
    for _ in 0..2000 {
        bytes.extend(b"$Elements\n3000\n");
        for number in [15_i32, 3000, 0] {
            bytes.extend(number.to_le_bytes());
        }
        bytes.extend(b"\n$EndElements\n");
    }
    let begin = std::time::Instant::now();
    assert!(within_memory("sections", &bytes, read).is_err());
    // two milliseconds; ten million elements would take a second
    assert!(begin.elapsed().as_secs_f64() < 0.5, "{:?}", begin.elapsed());
}

#[test]
fn the_shortest_text_takes_the_most_memory() {
    let _alone = alone();
    let head = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
    let count = 20_000;
    let nodes: String = (1..=count).map(|tag| format!("{tag} 0 0 0\n")).collect();
    let points: String = (1..=count).map(|tag| format!("{tag} 15 0 1\n")).collect();
    // each point in a separate group, all of them on one node
    let groups: String = (1..=count)
        .map(|tag| format!("{tag} 15 1 {tag} 1\n"))
        .collect();
    // one element of each of many unknown types
    let types: String = (1..=count)
        .map(|tag| format!("{tag} {} 0\n", 1000 + tag))
        .collect();
    for (what, elements) in [("points", points), ("groups", groups), ("types", types)] {
        let text = format!(
            "{head}$Nodes\n{count}\n{nodes}$EndNodes\n$Elements\n{count}\n{elements}$EndElements\n"
        );
        let read = within_memory(what, text.as_bytes(), read);
        assert_eq!(read.is_ok(), what != "types", "{what}");
        let elements = format!("{head}$Elements\n{count}\n{elements}$EndElements\n");
        assert!(within_memory(what, elements.as_bytes(), crate::mesh_files::read).is_err());
    }
}
