//! The keys that cards accept and the keys listed in the book.

use std::collections::BTreeSet;

use super::Folder;
use super::messages::page;

/// A key that no card has, nor a similar one.
const STRANGE: &str = "zqj";
/// Pages that describe keys of cards.
const PAGES: [&str; 5] = [
    "dynamics-input.md",
    "drives.md",
    "laws.md",
    "joints.md",
    "time-output.md",
];

/// Keys of the cards of a file, as listed in the message about an unknown one.
fn known(folder: &Folder, cards: &str) -> BTreeSet<String> {
    let text = format!(
        "units = \"SI\"\n{}\n",
        cards.replace("ZQJ", &format!("{STRANGE} = 1"))
    );
    folder.write("a.dynamics.toml", &text);
    let run = folder.run(&["check", "a.dynamics.toml"]);
    // Long lists have several lines.
    let reported = run.err.replace(",\n    ", ", ");
    let lists = reported
        .lines()
        .filter_map(|line| line.split_once("known keys: "));
    let keys: BTreeSet<_> = lists
        .flat_map(|(_, list)| list.split(", ").map(str::to_owned))
        .collect();
    assert!(!keys.is_empty(), "{cards}\n{}", run.err);
    keys
}

/// Cards of one line each, and cards with kinds.
const CARDS: &[&str] = &[
    "ZQJ",
    "[properties.p]\nZQJ",
    "[hub]\nZQJ",
    "[sensors.s]\nquantity = \"position\"\nof = \"a\"\nZQJ",
    "[[repeat]]\nZQJ",
    "[[frame]]\nname = \"f\"\nZQJ",
    "[[node]]\nZQJ",
    "[[blade]]\nZQJ",
    "[[blade]]\nfile = \"b\"\nZQJ",
    "[[blade]]\n[[blade.piece]]\nZQJ",
    "[[blade]]\n[[blade.mass]]\nZQJ",
    "[[blade]]\nhinges = [{ kind = \"flap\", ZQJ }]",
    "[[beam]]\nZQJ",
    "[[clamp]]\nZQJ",
    "[[body]]\nZQJ",
    "[[hinge]]\nZQJ",
    "[[rigid]]\nZQJ",
    "[[rod]]\nZQJ",
    "[[spring]]\nnode = \"a\"\nZQJ",
    "[[spring]]\nnodes = [\"a\", \"b\"]\nZQJ",
    "[[load]]\nZQJ",
    "[[distributed_load]]\nZQJ",
    "[[imposed]]\nZQJ",
    "[[internal_force]]\nZQJ",
    "[[internal_force]]\ntension = 1\nZQJ",
    "[gravity]\nZQJ",
    "[modes]\nZQJ",
    "[static]\nZQJ",
    "[buckling]\nZQJ",
    "[measured]\nZQJ",
];

/// Kinds of a card, with the text of the card before and after its kind.
const KINDS: &[(&str, &[&str], &str)] = &[
    (
        "[drives.d]\nkind = ",
        &[
            "constant",
            "ramp",
            "step",
            "harmonic",
            "doublet",
            "table",
            "expression",
            "sum",
            "product",
            "random",
        ],
        "",
    ),
    (
        "[[rod]]\nnodes = [\"a\", \"b\"]\nlaw = { ZQJ, kind = ",
        &[
            "linear",
            "viscous",
            "viscoelastic",
            "cubic",
            "bilinear",
            "table",
            "expression",
        ],
        " }",
    ),
    (
        "[[output.column]]\nname = \"c\"\nquantity = ",
        &[
            "position",
            "rotation",
            "euler_angles",
            "internal_force",
            "strain",
            "reaction_force",
            "joint_angle",
            "spring_force",
            "drive",
            "energy",
            "momentum",
            "step_length",
        ],
        "",
    ),
];

const JOINTS: [&str; 15] = [
    "clamp",
    "spherical",
    "revolute",
    "cylindrical",
    "universal",
    "prismatic",
    "in-line",
    "in-plane",
    "plane-rotation",
    "distance",
    "position",
    "rotation",
    "velocity",
    "spin",
    "total",
];

fn joints(folder: &Folder) -> BTreeSet<String> {
    let of = |kind: &&str| known(folder, &format!("[[joint]]\nkind = \"{kind}\"\nZQJ"));
    JOINTS.iter().flat_map(of).collect()
}

const TRANSIENT: &str = "[transient]\nstep = { ZQJ }\nnewton = { ZQJ }\nZQJ";

#[test]
fn every_key_of_the_cards_is_in_the_book() {
    let folder = Folder::new();
    let book: String = PAGES.map(page).concat();
    let mut keys: BTreeSet<String> = joints(&folder);
    for cards in CARDS
        .iter()
        .chain(&[TRANSIENT, "[transient]\n[output]\nZQJ"])
    {
        keys.extend(known(&folder, cards));
    }
    for (head, kinds, tail) in KINDS {
        for kind in *kinds {
            let behind = if tail.is_empty() { "\nZQJ" } else { "" };
            keys.extend(known(&folder, &format!("{head}\"{kind}\"{tail}{behind}")));
        }
    }
    assert!(keys.len() > 120, "{}", keys.len());
    let is_reported = |key: &&String| {
        // `key`, `key = ...`, a card `[key]`, `[[key]]`, or one of { a, key, b }.
        [
            format!("`{key}`"),
            format!("{key} ="),
            format!("[{key}"),
            format!(".{key}]"),
            format!(", {key}, "),
            format!("{{ {key}, "),
            format!(", {key} }}"),
        ]
        .iter()
        .any(|form| book.contains(form.as_str()))
    };
    let missing: Vec<_> = keys.iter().filter(|key| !is_reported(key)).collect();
    assert!(missing.is_empty(), "not in the book: {missing:?}");
}

/// Words in backquotes in column `column` of the first table after a text of a page.
fn listed(page: &str, behind: &str, column: usize) -> BTreeSet<String> {
    let from = page.find(behind).unwrap();
    let rows = page[from..]
        .lines()
        .skip_while(|line| !line.starts_with('|'));
    let rows = rows.take_while(|line| line.starts_with('|')).skip(2);
    rows.flat_map(|row| {
        let cell = row.split('|').nth(column + 1).unwrap_or("");
        cell.split('`')
            .skip(1)
            .step_by(2)
            .map(str::to_owned)
            .collect::<Vec<_>>()
    })
    .collect()
}

#[test]
fn every_key_of_the_book_is_one_of_the_cards() {
    let folder = Folder::new();
    let (input, output) = (page("dynamics-input.md"), page("time-output.md"));
    for (listed, known) in [
        (
            listed(&input, "\n## Motion in time", 0),
            known(&folder, TRANSIENT),
        ),
        (listed(&input, "\n## Joints", 0), joints(&folder)),
        (
            listed(&output, "| key of `[output]`", 0),
            known(&folder, "[transient]\n[output]\nZQJ"),
        ),
        (
            listed(&output, "\n## Columns", 0),
            known(
                &folder,
                "[[output.column]]\nname = \"c\"\nquantity = \"position\"\nof = \"a\"\nZQJ",
            ),
        ),
        (
            listed(&input, "\n## Modes", 0),
            known(&folder, "[modes]\nZQJ"),
        ),
        (
            listed(&input, "| key of `[static]`", 0),
            known(&folder, "[static]\nZQJ"),
        ),
        (
            listed(&input, "| key of `[buckling]`", 0),
            known(&folder, "[buckling]\nZQJ"),
        ),
    ] {
        assert!(listed.len() > 1, "{listed:?}");
        let unknown: Vec<_> = listed.difference(&known).collect();
        assert!(
            unknown.is_empty(),
            "not a key: {unknown:?}; known: {known:?}"
        );
    }
}
