//! Looks of modes in the figure of stability: a color and a mark for each motion of the blades, a pattern of the
//! line for each way in which it goes around the rotor.
//!
//! Modes of one motion often have one growth. The line of the first pattern is broad and light, the other ones
//! are narrow and darker, so that all are seen on each other.

use shared_geom::figure::{BLACK, CATEGORIES, Color, Drawing, Legend, Mark, Sample, Stroke, WHITE};

/// Width of lines, and of the light ones below others \[figure pixels\].
const LINE: f64 = 4.0;
const BROAD: f64 = 11.0;
/// Half the size of a mark \[figure pixels\].
const MARK: f64 = 7.0;
/// Colors that are clear on white.
const COLORS: usize = 6;
/// Marks, one after the other where the colors repeat.
const MARKS: [Mark; 5] = [
    Mark::Disc,
    Mark::Square,
    Mark::Up,
    Mark::Diamond,
    Mark::Down,
];
/// Parts by which the colors of the patterns after the first one are mixed with black.
const DARKER: [f64; 3] = [0.0, 0.5, 0.75];
/// Part by which the color of the first pattern is mixed with white.
const LIGHTER: f64 = 0.55;
/// Pattern that all rotors have, which is the first one.
const COLLECTIVE: &str = "collective";
/// Color of patterns in the legend.
const GRAY: Color = Color(110, 110, 110);

/// The look of a mode.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Look {
    color: Color,
    mark: Mark,
    width: f64,
    /// Number of the pattern of dashes.
    pattern: usize,
}

impl Look {
    /// Of a color and a mark, for the pattern number `place` or without pattern.
    fn new((color, mark): (Color, Mark), place: Option<usize>) -> Self {
        let (color, width, pattern) = match place {
            None => (color, LINE, 0),
            Some(0) => (color.mixed(WHITE, LIGHTER), BROAD, 0),
            Some(place) => {
                let part = DARKER[(place - 1) % DARKER.len()];
                (color.mixed(BLACK, part), LINE, place)
            }
        };
        Self {
            color,
            mark,
            width,
            pattern,
        }
    }

    pub fn stroke(&self) -> Stroke {
        Stroke::new(self.width, self.color).dashed(self.pattern)
    }

    pub fn draw_mark(&self, drawing: &mut Drawing, at: [f64; 2]) {
        self.mark.draw(drawing, at, MARK, self.color);
    }
}

/// The looks of modes.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Looks {
    /// Names without patterns, each once.
    motions: Vec<String>,
    /// Patterns, if there are several.
    patterns: Vec<String>,
    /// Of each mode.
    all: Vec<Look>,
}

impl Looks {
    /// Of modes with these names.
    pub fn new(names: &[String]) -> Self {
        let parts: Vec<_> = names.iter().map(|name| split(name)).collect();
        let (mut motions, mut patterns) = (Vec::new(), Vec::new());
        for (motion, pattern) in &parts {
            if !motions.contains(motion) {
                motions.push(motion.clone());
            }
            if !pattern.is_empty() && !patterns.contains(pattern) {
                patterns.push(pattern.clone());
            }
        }
        patterns.sort_by_key(|own| (own != COLLECTIVE, own.clone()));
        if patterns.len() < 2 {
            // The names of the modes have it.
            patterns.clear();
            motions = names.to_vec();
        }
        let look = |((motion, pattern), name): (&(String, String), &String)| {
            let own = if patterns.is_empty() { name } else { motion };
            let index = motions.iter().take_while(|known| *known != own).count();
            let place = patterns.iter().position(|known| known == pattern);
            Look::new(base(index), place)
        };
        let all = parts.iter().zip(names).map(look).collect();
        Self {
            motions,
            patterns,
            all,
        }
    }

    /// Looks and indices of the modes in the order in which they are drawn.
    pub fn in_order(&self) -> Vec<(Look, usize)> {
        let mut order: Vec<_> = self.all.iter().copied().zip(0..).collect();
        order.sort_by_key(|(look, _)| (look.width < BROAD, look.pattern));
        order
    }

    /// Legends of the motions and, below it, of the patterns.
    pub fn legends(&self) -> [Legend; 2] {
        let [mut motions, mut patterns] = [Legend::default(), Legend::default()];
        for (index, motion) in self.motions.iter().enumerate() {
            let look = Look::new(base(index), None);
            motions.add(motion, Sample::Marked(look.stroke(), look.mark, MARK));
        }
        for (place, pattern) in self.patterns.iter().enumerate() {
            let look = Look::new((GRAY, Mark::Disc), Some(place));
            patterns.add(pattern, Sample::Line(look.stroke()));
        }
        [motions, patterns]
    }
}

/// Color and mark of a motion by its number.
fn base(index: usize) -> (Color, Mark) {
    let mark = MARKS[index / COLORS % MARKS.len()];
    (CATEGORIES[index % COLORS], mark)
}

/// The motion with its number, and the pattern behind the number.
fn split(name: &str) -> (String, String) {
    let words: Vec<_> = name.split(' ').collect();
    let is_number = |word: &&str| word.parse::<usize>().is_ok();
    match words.iter().rposition(is_number) {
        Some(last) => (words[..=last].join(" "), words[last + 1..].join(" ")),
        None => (name.to_owned(), String::new()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn looks(names: &[&str]) -> Looks {
        let names: Vec<_> = names.iter().map(|name| (*name).to_owned()).collect();
        Looks::new(&names)
    }

    // Thirty modes of ten motions and three patterns, and one of a tower: thirty-one looks, a legend with
    // eleven motions and one with three patterns.
    #[test]
    fn no_two_modes_of_a_rotor_look_alike() {
        let mut names = vec!["tower fore-aft 1".to_owned()];
        for number in 1..=10 {
            for pattern in ["forward", "backward", "collective"] {
                names.push(format!("flap {number} {pattern}"));
            }
        }
        let looks = Looks::new(&names);
        for (index, look) in looks.all.iter().enumerate() {
            assert!(!looks.all[index + 1..].contains(look), "{}", names[index]);
        }
        let counts = looks.legends().map(|legend| legend.entries.len());
        assert_eq!(counts, [11, 3]);
        assert_eq!(looks.legends()[1].entries[0].0, "collective");
    }

    // The broad line of the collective mode is drawn first.
    #[test]
    fn broad_lines_are_below_narrow_ones() {
        let looks = looks(&["edge 1 forward", "edge 1 backward", "edge 1 collective"]);
        let order: Vec<_> = looks.in_order().iter().map(|own| own.1).collect();
        assert_eq!(order, [2, 1, 0]);
    }

    #[test]
    fn modes_without_several_patterns_have_their_names() {
        for names in [
            &["flap 1 collective", "flap 2 collective"][..],
            &["lag", "lag (2)"],
        ] {
            let looks = looks(names);
            let [motions, patterns] = looks.legends();
            let found: Vec<_> = motions.entries.iter().map(|own| own.0.as_str()).collect();
            assert_eq!((found, patterns.entries.len()), (names.to_vec(), 0));
            assert_ne!(looks.all[0], looks.all[1]);
        }
    }
}
