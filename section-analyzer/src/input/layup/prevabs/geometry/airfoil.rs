//! Airfoil files as closed lines, from the trailing edge over the upper surface to the leading
//! edge and back.

use std::path::Path;

use shared_geom::document::read_text;
use shared_geom::error::shortened;
use shared_geom::exchange::text::number;

use super::super::Points;
use super::super::files::{Element, Notes, is_true, word};
use super::{Kind, Line};

/// Fewest points of an airfoil.
const LEAST: usize = 9;

/// The line of an airfoil file; notes problems.
pub(super) fn read(folder: &Path, element: Element<'_>, notes: &mut Notes) -> Option<Line> {
    let (list, name) = element.required("points", notes)?;
    if let Some(data) = list.attribute("data").filter(|data| *data != "file") {
        let found = format!("\"{}\"", shortened(data));
        let help = "name a file of coordinates";
        notes.wrong(list, ["data of <points>", &found, "\"file\"", help]);
        return None;
    }
    refuse_edges(element, notes)?;
    let is_selig = match list.attribute("format").unwrap_or("2").to_lowercase() {
        one if one == "1" || one.starts_with('s') => true,
        two if two == "2" || two.starts_with('l') => false,
        other => {
            let found = format!("\"{}\"", shortened(&other));
            let help = "1 for one list around the airfoil, 2 for a list of each surface";
            notes.wrong(list, ["format of <points>", &found, "1 or 2", help]);
            return None;
        }
    };
    let header = list.attribute("header").map_or(Some(0.0), number);
    let file = folder.join(&name);
    notes.problems.turn_to(element.file);
    if !notes
        .problems
        .finds(&file, "the airfoil file", &name, list.line())
    {
        return None;
    }
    let text = notes.problems.keep(read_text(&file))?;
    let skipped = header.filter(|rows| *rows >= 0.0 && rows.fract() == 0.0);
    let Some(skipped) = skipped else {
        let found = list.attribute("header").unwrap_or_default();
        let help = "the number of rows before the coordinates";
        notes.wrong(
            list,
            ["header of <points>", found, "a number of rows", help],
        );
        return None;
    };
    let blocks = blocks(&text, skipped as usize, &file, notes)?;
    let points = if is_selig {
        blocks.concat()
    } else {
        around(&blocks, list, notes)?
    };
    if points.len() < LEAST {
        let found = format!("{} points", points.len());
        let expected = format!("{LEAST} or more");
        let help = "compare the format and the number of header rows";
        notes.wrong(
            list,
            [&format!("the airfoil \"{name}\""), &found, &expected, help],
        );
        return None;
    }
    changed(points, (element, list), notes)
}

/// Notes coordinates of edges, which split airfoils of other shapes.
fn refuse_edges(element: Element<'_>, notes: &mut Notes) -> Option<()> {
    let mut is_fine = true;
    for name in ["leading_edge", "trailing_edge"] {
        let given = element.child(name).filter(|one| !one.text().is_empty());
        if let Some(one) = given {
            let help = "begin the points at the trailing edge, and leave the coordinates out";
            notes.wrong(one, [&one.shown(), "coordinates", "a name alone", help]);
            is_fine = false;
        }
    }
    is_fine.then_some(())
}

/// Lists of coordinates that blank rows separate, after the header; notes other rows.
fn blocks(text: &str, header: usize, file: &Path, notes: &mut Notes) -> Option<Vec<Points>> {
    let mut blocks: Vec<Points> = vec![Vec::new()];
    let mut is_good = true;
    for (i, row) in text.lines().enumerate().skip(header) {
        let words: Vec<&str> = row
            .split([' ', ',', '\t'])
            .filter(|one| !one.is_empty())
            .collect();
        let values: Vec<f64> = words.iter().filter_map(|word| number(word)).collect();
        match (words.len(), &values[..]) {
            (0, _) => blocks.push(Vec::new()),
            (2, [y, z]) => blocks.last_mut()?.push([*y, *z]),
            // the name of the airfoil, which `header` does not count
            _ if i == 0 && values.is_empty() => {}
            _ => {
                let found = format!("\"{}\"", shortened(row.trim()));
                let help = "header=\"...\" is the number of rows before the coordinates";
                notes.wrong_on(file, i + 1, ["the row", &found, "two numbers", help]);
                is_good = false;
            }
        }
    }
    blocks.retain(|block| !block.is_empty());
    is_good.then_some(blocks)
}

/// One list of the lists of both surfaces, which begin at the leading edge.
fn around(blocks: &[Points], list: Element<'_>, notes: &mut Notes) -> Option<Points> {
    let is_counts = |block: &Points| block.len() == 1 && block[0].iter().all(|n| *n > 1.5);
    let surfaces: Vec<&Points> = blocks.iter().filter(|block| !is_counts(block)).collect();
    let [upper, lower] = surfaces[..] else {
        let found = format!("{} lists of points", surfaces.len());
        let help = "format=\"1\" reads one list around the airfoil";
        notes.wrong(
            list,
            [
                "the airfoil file",
                &found,
                "two, with a blank row between",
                help,
            ],
        );
        return None;
    };
    // the numbers of points may precede the first list
    let upper: Points = if upper[0].iter().all(|n| *n > 1.5) {
        upper[1..].to_vec()
    } else {
        upper.clone()
    };
    Some(
        upper
            .into_iter()
            .rev()
            .chain(lower.iter().copied().skip(1))
            .collect(),
    )
}

/// The points with the changes of the file.
fn changed(
    mut points: Points,
    (element, list): (Element<'_>, Element<'_>),
    notes: &mut Notes,
) -> Option<Line> {
    let is_set = |name: &str, notes: &mut Notes| match element.child(name) {
        Some(one) => is_true(one, notes),
        None => Some(false),
    };
    if is_set("normalize", notes)? {
        let values = || points.iter().map(|point| point[0]);
        let low = values().fold(f64::INFINITY, f64::min);
        let width = values().fold(f64::NEG_INFINITY, f64::max) - low;
        points
            .iter_mut()
            .for_each(|p| *p = [(p[0] - low) / width, p[1] / width]);
    }
    let is_backward = match list.attribute("direction") {
        None => false,
        Some(text) => {
            let words = ["1", "ccw", "forward", "-1", "cw", "reverse"];
            word(list, "direction of <points>", text, &words, notes)? > 2
        }
    };
    if is_set("flip", notes)? {
        let flip = element.child("flip")?;
        let axis = flip.attribute("axis").unwrap_or("2");
        let axis = word(flip, "axis", axis, &["2", "x2", "y", "3", "x3", "z"], notes)? / 3;
        let place = flip.attribute("loc").map_or(Some(0.5), number);
        let Some(place) = place else {
            notes.wrong(
                flip,
                ["loc", "no number", "a number", "the place of the mirror"],
            );
            return None;
        };
        points
            .iter_mut()
            .for_each(|p| p[axis] = 2.0 * place - p[axis]);
    }
    // a closed line, in the order of the file
    if points[0] != points[points.len() - 1] {
        points.push(points[0]);
    }
    if is_backward != is_set("reverse", notes)? {
        points.reverse();
    }
    let kind = Kind::Curve;
    Some(Line { points, kind })
}
