//! Layups: layers by laminae or other layups, or a stacking sequence.

use std::collections::HashMap;

use shared_geom::error::shortened;
use shared_geom::exchange::text::number;

use super::files::{Element, Notes};
use super::materials::{Known, Lamina};

/// Largest number of layers of a layup.
const MOST: usize = 2000;

/// A layer: plies of one lamina and angle.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Ply {
    pub material: String,
    /// Thickness of all plies.
    pub thickness: f64,
    /// Angle of the fiber from x1 toward the direction of the base line \[deg\].
    pub angle: f64,
}

impl Ply {
    fn new(lamina: &Lamina, [angle, count]: [f64; 2]) -> Self {
        Self {
            material: lamina.material.clone(),
            thickness: count * lamina.thickness,
            angle,
        }
    }
}

/// The layers of the layups by their names, from the base line on; `None` for wrong ones.
pub(super) type Layups<'x> = HashMap<&'x str, Option<Vec<Ply>>>;

/// The layups of `<layups>`; notes problems.
pub(super) fn read<'x>(parts: &[Element<'x>], known: &Known<'_>, notes: &mut Notes) -> Layups<'x> {
    let mut layups = HashMap::new();
    for layup in parts.iter().flat_map(|part| part.named("layup")) {
        let Some(name) = layup.required_name(notes) else {
            continue;
        };
        let method = layup
            .attribute("method")
            .unwrap_or("layer list")
            .to_lowercase();
        let plies = match method.as_str() {
            "" | "layer list" | "ll" => listed(layup, known, &layups, notes),
            "stack sequence" | "ss" => sequence(layup, known, notes),
            _ => {
                let what = format!("method of {}", layup.shown());
                let expected = "\"layer list\" or \"stack sequence\"";
                let help = "list the layers, or write <lamina> and <code>";
                notes.wrong(layup, [&what, &format!("\"{method}\""), expected, help]);
                None
            }
        };
        let plies = plies.and_then(|plies| {
            let is_fine = !plies.is_empty() && plies.len() <= MOST;
            if !is_fine {
                let found = format!("{} layers", plies.len());
                let expected = format!("1 to {MOST}");
                let help = "plies of one angle are one layer, angle:count";
                notes.wrong(layup, [&layup.shown(), &found, &expected, help]);
            }
            is_fine.then_some(plies)
        });
        let is_again = layups.insert(name, plies).is_some();
        notes.again(layup, is_again);
    }
    layups
}

/// The layers of a list.
fn listed(
    layup: Element<'_>,
    known: &Known<'_>,
    layups: &Layups<'_>,
    notes: &mut Notes,
) -> Option<Vec<Ply>> {
    let mut plies = Vec::new();
    let mut is_complete = true;
    for layer in layup.named("layer") {
        let more = match (layer.attribute("lamina"), layer.attribute("layup")) {
            (Some(lamina), None) => {
                let lamina = known.lamina(lamina, layer, notes);
                let text = layer.text();
                let numbers = angle_and_count(&text, layer, notes);
                lamina
                    .zip(numbers)
                    .map(|(lamina, numbers)| vec![Ply::new(&lamina, numbers)])
            }
            (None, Some(name)) => match layups.get(name) {
                Some(plies) => plies.clone(),
                None => {
                    let mut names: Vec<&str> = layups.keys().copied().collect();
                    names.sort_unstable();
                    notes.unknown(
                        layer,
                        ["the layup, which stands before this one,", name],
                        &names,
                    );
                    None
                }
            },
            _ => {
                let what = format!("a layer of {}", layup.shown());
                let expected = "lamina=\"...\" or layup=\"...\"";
                notes.wrong(layer, [&what, "both or none", expected, "name its lamina"]);
                None
            }
        };
        is_complete &= more.is_some();
        plies.extend(more.unwrap_or_default());
        if plies.len() > MOST {
            break;
        }
    }
    is_complete.then_some(plies)
}

/// Angle and number of plies of a text `angle:count`; 0 and 1 where it is empty.
fn angle_and_count(text: &str, at: Element<'_>, notes: &mut Notes) -> Option<[f64; 2]> {
    let (angle, count) = text.split_once(':').unwrap_or((text, ""));
    let value = |part: &str, default: f64| match part.trim() {
        "" => Some(default),
        part => number(part),
    };
    let is_count = |count: &f64| *count >= 1.0 && count.fract() == 0.0 && *count < 1e6;
    let found = value(angle, 0.0).zip(value(count, 1.0).filter(is_count));
    if found.is_none() {
        let shown = format!("\"{}\"", shortened(text));
        let help = "such as 45:2 for two plies at 45 deg";
        notes.wrong(at, ["angle and plies", &shown, "angle:count", help]);
    }
    found.map(|(angle, count)| [angle, count])
}

/// The layers of a stacking sequence.
fn sequence(layup: Element<'_>, known: &Known<'_>, notes: &mut Notes) -> Option<Vec<Ply>> {
    let lamina = layup.required("lamina", notes);
    let code = layup.required("code", notes);
    let lamina = lamina.and_then(|(at, name)| known.lamina(&name, at, notes));
    let (at, code) = code?;
    let Some(all) = unfolded(&code) else {
        let found = format!("\"{}\"", shortened(&code));
        let help = "[0/90]2s is 0, 90, 90, 0, 0, 90, 90, 0; groups are (45/-45):2";
        notes.wrong(at, ["the stacking sequence", &found, "[angles]ns", help]);
        return None;
    };
    let lamina = lamina?;
    Some(all.into_iter().map(|one| Ply::new(&lamina, one)).collect())
}

/// Angles and numbers of plies of a stacking sequence `[...]ns`: n times the list and its mirror
/// image, one after the other.
///
/// The number before `s` doubles the list again: `[0/90]2s` is 0, 90, 90, 0, 0, 90, 90, 0.
pub(super) fn unfolded(code: &str) -> Option<Vec<[f64; 2]>> {
    let code: String = code
        .chars()
        .filter(|letter| !letter.is_whitespace())
        .collect();
    let (list, ending) = code.strip_prefix('[')?.split_once(']')?;
    let mut all = group(list)?;
    let times = match ending.strip_suffix(['s', 'S']) {
        None if ending.is_empty() => 0,
        None => return None,
        Some("") => 1,
        Some(times) => times.parse::<u32>().ok().filter(|times| *times <= 10)?,
    };
    for _ in 0..times {
        let mirrored: Vec<[f64; 2]> = all.iter().rev().copied().collect();
        all.extend(mirrored);
        if all.len() > MOST {
            break;
        }
    }
    Some(all)
}

/// The items of a list: `angle`, `angle:count`, `(list):count`.
fn group(list: &str) -> Option<Vec<[f64; 2]>> {
    let mut all = Vec::new();
    let mut rest = list;
    loop {
        let (items, after) = match rest.strip_prefix('(') {
            Some(inner) => {
                let (inner, after) = inner.split_once(')')?;
                let plain = |item: &str| single(item);
                let items: Option<Vec<[f64; 2]>> = inner.split('/').map(plain).collect();
                let end = after.find('/').unwrap_or(after.len());
                let count = match &after[..end] {
                    "" => 1,
                    text => count(text.strip_prefix(':')?)?,
                };
                let items = items?;
                let all = std::iter::repeat_n(items, count);
                (
                    all.flatten().take(MOST + 1).collect::<Vec<_>>(),
                    &after[end..],
                )
            }
            None => {
                let end = rest.find('/').unwrap_or(rest.len());
                (vec![single(&rest[..end])?], &rest[end..])
            }
        };
        all.extend(items);
        match after.strip_prefix('/') {
            Some(more) if all.len() <= MOST => rest = more,
            Some(_) => return Some(all),
            None if after.is_empty() => return Some(all),
            None => return None,
        }
    }
}

/// An angle with its number of plies.
fn single(item: &str) -> Option<[f64; 2]> {
    match item.split_once(':') {
        None => Some([number(item)?, 1.0]),
        Some((angle, plies)) => Some([number(angle)?, count(plies)? as f64]),
    }
}

fn count(text: &str) -> Option<usize> {
    text.parse().ok().filter(|count| (1..=MOST).contains(count))
}

#[cfg(test)]
mod tests {
    use super::unfolded;

    /// The angles of single plies.
    fn angles(code: &str) -> Vec<f64> {
        let all = unfolded(code).unwrap();
        let plies = all
            .into_iter()
            .flat_map(|[angle, count]| vec![angle; count as usize]);
        plies.collect()
    }

    /// The two examples of the manual (guide, stacking sequence code).
    #[test]
    fn sequences_of_the_manual() {
        let expected = [0.0, 90.0, 90.0, 0.0, 0.0, 90.0, 90.0, 0.0];
        assert_eq!(angles("[0/90]2s"), expected);
        let half = [45.0, -45.0, 45.0, -45.0, 0.0, 0.0];
        let whole: Vec<f64> = half.iter().chain(half.iter().rev()).copied().collect();
        assert_eq!(angles("[(45/-45):2/0:2]s"), whole);
        assert_eq!(angles("[ 30 : 2 / 0 ]"), [30.0, 30.0, 0.0]);
    }

    #[test]
    fn other_texts_are_refused() {
        for code in [
            "", "[", "0/90", "[0/90", "[0//90]", "[0/90]x", "[(0/90]", "[0:0]", "[a]",
        ] {
            assert!(unfolded(code).is_none(), "{code}");
        }
        for code in ["[0/90]11s", "[(0/90):9999]", "[0:-1]", "[0/(90)x]"] {
            assert!(unfolded(code).is_none(), "{code}");
        }
    }
}
