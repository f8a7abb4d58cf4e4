//! Looks of the lines of modes: a color for each kind, shades and dashes for the modes of one kind,
//! and broader lines below those that cover them.

use shared_geom::figure::{BLACK, CATEGORIES, Color, WHITE};

use crate::result::ModeKind;

/// Patterns of lines, the solid one included.
const PATTERNS: usize = 4;
/// Shades of a color: the part by which it is mixed with another color.
const SHADES: [(f64, Color); 3] = [(0.0, BLACK), (0.45, BLACK), (0.35, WHITE)];
/// Color of the modes without strain.
const NO_STRAIN: Color = Color(120, 120, 120);
/// Difference of two lines, as part of the largest value of all, up to which they coincide.
pub(super) const SAME_LINE: f64 = 0.004;
/// Number of covering lines beyond which a line does not become broader.
const MOST_COVERS: usize = 3;

/// Kind and name, without pattern, of the mode of a line.
pub(super) type Stem<'a> = (ModeKind, &'a str);

/// The color of a kind of mode.
pub(super) fn color(kind: ModeKind) -> Color {
    match kind {
        ModeKind::Flap => CATEGORIES[0],
        ModeKind::Lag => CATEGORIES[1],
        ModeKind::Torsion => CATEGORIES[2],
        ModeKind::Axial => CATEGORIES[3],
        ModeKind::Lateral | ModeKind::ForeAft => CATEGORIES[4],
        ModeKind::SideSide => CATEGORIES[6],
        ModeKind::Coupled => CATEGORIES[5],
        ModeKind::Rigid => NO_STRAIN,
    }
}

/// The shade `number` of the color of a kind, from zero.
fn shade(kind: ModeKind, number: usize) -> Color {
    let (part, other) = SHADES[number % SHADES.len()];
    color(kind).mixed(other, part)
}

/// Colors of lines: a shade for each name of a kind.
pub(super) fn colors(stems: &[Stem<'_>]) -> Vec<Color> {
    let numbers = numbers(stems).into_iter().zip(stems);
    numbers
        .map(|([name, _], stem)| shade(stem.0, name))
        .collect()
}

/// Colors and patterns of lines. If several lines have a name, a shade for each name and a pattern
/// for each of its lines; else patterns for the names of a kind, then another shade.
pub(super) fn looks(stems: &[Stem<'_>]) -> Vec<(Color, usize)> {
    let numbers = numbers(stems);
    let have_one = numbers.iter().all(|[_, line]| *line == 0);
    let look = |([name, line], stem): ([usize; 2], &Stem<'_>)| match have_one {
        true => (shade(stem.0, name / PATTERNS), name % PATTERNS),
        false => (shade(stem.0, name), line % PATTERNS),
    };
    numbers.into_iter().zip(stems).map(look).collect()
}

/// Of each line the number of its name among the names of its kind, and its number among the lines
/// of its name, both from zero.
fn numbers(stems: &[Stem<'_>]) -> Vec<[usize; 2]> {
    let mut names: Vec<Stem<'_>> = Vec::new();
    let mut numbers = Vec::with_capacity(stems.len());
    for (k, stem) in stems.iter().enumerate() {
        if !names.contains(stem) {
            names.push(*stem);
        }
        let of_kind = names.iter().filter(|known| known.0 == stem.0);
        let name = of_kind.take_while(|known| *known != stem).count();
        let line = stems[..k].iter().filter(|known| *known == stem).count();
        numbers.push([name, line]);
    }
    numbers
}

/// Of each line, a color with its values, the number of later ones in another color, drawn over it,
/// that coincide with it at half of its points or more: so much broader it is drawn, to be seen
/// below them.
pub(super) fn covers(lines: &[(Color, &[Option<f64>])]) -> Vec<usize> {
    let values = lines.iter().flat_map(|line| line.1.iter().flatten());
    let same = SAME_LINE * values.fold(0.0, |most, value| value.abs().max(most));
    let is_covered = |below: &[Option<f64>], above: &[Option<f64>]| {
        let pairs = below.iter().zip(above);
        let common = pairs.filter(|(a, b)| a.zip(**b).is_some_and(|(a, b)| (a - b).abs() <= same));
        let common = common.count();
        common > 0 && 2 * common >= below.iter().flatten().count()
    };
    let count = |(k, below): (usize, &(Color, &[Option<f64>]))| {
        let above = lines[k + 1..].iter().filter(|above| above.0 != below.0);
        let covers = above.filter(|above| is_covered(below.1, above.1)).count();
        covers.min(MOST_COVERS)
    };
    lines.iter().enumerate().map(count).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const KINDS: [ModeKind; 7] = [
        ModeKind::Flap,
        ModeKind::Lag,
        ModeKind::Torsion,
        ModeKind::Axial,
        ModeKind::Lateral,
        ModeKind::Coupled,
        ModeKind::Rigid,
    ];

    // Twelve modes of each kind; colors of two kinds differ in every shade.
    #[test]
    fn no_two_modes_look_alike() {
        let numbers = 0..PATTERNS * SHADES.len();
        let names: Vec<_> = numbers.map(|number| number.to_string()).collect();
        let of_kind = |kind| names.iter().map(move |name| (kind, name.as_str()));
        let stems: Vec<_> = KINDS.into_iter().flat_map(of_kind).collect();
        let looks = looks(&stems);
        let all: Vec<_> = stems.iter().map(|stem| stem.0).zip(looks).collect();
        for (i, (kind, look)) in all.iter().enumerate() {
            for (other, known) in &all[i + 1..] {
                assert_ne!(look, known, "{kind:?} {other:?}");
                assert!(kind == other || look.0 != known.0, "{kind:?} {other:?}");
            }
        }
    }

    // Three patterns of a mode and two of another: a shade for each mode.
    #[test]
    fn patterns_of_a_mode_have_one_color() {
        let names = ["flap 1", "flap 2", "flap 1", "flap 1", "flap 2"];
        let stems = names.map(|name| (ModeKind::Flap, name));
        let [one, two] = [0, 1].map(|number| shade(ModeKind::Flap, number));
        let expected = [(one, 0), (two, 0), (one, 1), (one, 2), (two, 1)];
        assert_eq!(looks(&stems), expected);
        assert_eq!(colors(&stems), expected.map(|look| look.0));
    }

    // The second line follows the first one to half of its points, the third one is near a single
    // point of it, the last one has no point in common with the second. Below a line of the same
    // color a broader one would not be seen.
    #[test]
    fn covered_lines_are_found() {
        let values: [&[Option<f64>]; 4] = [
            &[Some(1.0), Some(2.0), Some(3.0), Some(10.0)],
            &[Some(1.0), Some(2.01), Some(3.2), None],
            &[Some(1.1), Some(2.1), Some(3.01), Some(9.0)],
            &[None, None, None, Some(10.02)],
        ];
        let mut lines = [0, 1, 2, 3].map(|k| (CATEGORIES[k], values[k]));
        assert_eq!(covers(&lines), [1, 0, 0, 0]);
        lines[1].0 = CATEGORIES[0];
        assert_eq!(covers(&lines), [0; 4]);
        let equal = [0, 1, 2, 3, 4, 5].map(|k| (CATEGORIES[k], values[0]));
        assert_eq!(covers(&equal), [3, 3, 3, 2, 1, 0]);
    }
}
