//! Lines of curves, solid or dashed, and the marks on them.

use super::color::Color;
use super::drawing::Drawing;

/// Lengths of dashes and gaps in turn \[figure pixels\]; none for a solid line.
const DASHES: [&[f64]; 4] = [&[], &[24.0, 13.0], &[6.0, 10.0], &[24.0, 9.0, 6.0, 9.0]];

/// Style of a line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stroke {
    /// Color of the line.
    pub color: Color,
    /// Width of the line \[figure pixels, unit of the drawing\].
    pub width: f64,
    /// Number of the pattern of dashes; zero for a solid line.
    pub pattern: usize,
}

impl Stroke {
    /// A solid line of `width` \[figure pixels\].
    pub fn new(width: f64, color: Color) -> Self {
        Self {
            color,
            width,
            pattern: 0,
        }
    }

    /// The same with the dashes of this number.
    pub fn dashed(self, pattern: usize) -> Self {
        Self { pattern, ..self }
    }

    /// Draws the line through these positions; a dot for a single one.
    pub fn draw(&self, drawing: &mut Drawing, positions: &[[f64; 2]]) {
        let dashes = DASHES[self.pattern % DASHES.len()];
        if let [position] = positions {
            drawing.disc(*position, self.width, self.color);
        } else if dashes.is_empty() {
            drawing.line(positions, self.width, self.color);
        } else {
            for dash in dashed(positions, dashes) {
                drawing.line(&dash, self.width, self.color);
            }
        }
    }
}

/// The dashes along the line through `positions`, around its corners.
fn dashed(positions: &[[f64; 2]], pattern: &[f64]) -> Vec<Vec<[f64; 2]>> {
    let mut dashes: Vec<_> = positions.iter().take(1).map(|first| vec![*first]).collect();
    let (mut part, mut left) = (0, pattern[0]);
    for ends in positions.windows(2) {
        let [from, to] = [ends[0], ends[1]];
        let length = (to[0] - from[0]).hypot(to[1] - from[1]);
        let mut done = 0.0;
        while length - done > left {
            done += left;
            let share = done / length;
            let position = [0, 1].map(|k| from[k] + share * (to[k] - from[k]));
            match (part % 2, dashes.last_mut()) {
                (0, Some(dash)) => dash.push(position),
                _ => dashes.push(vec![position]),
            }
            part = (part + 1) % pattern.len();
            left = pattern[part];
        }
        left -= length - done;
        if let (0, Some(dash)) = (part % 2, dashes.last_mut()) {
            dash.push(to);
        }
    }
    dashes.retain(|dash| dash.len() > 1);
    dashes
}

/// Shape of a mark.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mark {
    /// A filled disc.
    Disc,
    /// A filled square.
    Square,
    /// A filled triangle with a corner above.
    Up,
    /// A filled triangle with a corner below.
    Down,
    /// A filled square on a corner.
    Diamond,
    /// Two crossing lines.
    Cross,
    /// A horizontal line.
    Dash,
    /// A circle.
    Ring,
    /// The outline of a square on a corner.
    OpenDiamond,
}

impl Mark {
    /// Draws the mark, about `2 size` wide \[figure pixels\].
    pub fn draw(self, drawing: &mut Drawing, [x, y]: [f64; 2], size: f64, color: Color) {
        let at = |scale: f64| move |[u, v]: [f64; 2]| [x + scale * size * u, y + scale * size * v];
        let up = [[0.0, -1.2], [1.1, 0.8], [-1.1, 0.8]];
        let diamond = [[0.0, -1.0], [1.0, 0.0], [0.0, 1.0], [-1.0, 0.0]];
        let open = 0.2 * size + 0.5;
        match self {
            Self::Disc => drawing.disc([x, y], size, color),
            Self::Square => {
                let square = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
                drawing.polygon(&square.map(at(0.95)), color);
            }
            Self::Up => drawing.polygon(&up.map(at(1.1)), color),
            Self::Down => drawing.polygon(&up.map(|[u, v]| [u, -v]).map(at(1.1)), color),
            Self::Diamond => drawing.polygon(&diamond.map(at(1.35)), color),
            Self::Cross => {
                for arm in [[[-1.0, -1.0], [1.0, 1.0]], [[-1.0, 1.0], [1.0, -1.0]]] {
                    drawing.line(&arm.map(at(1.0)), 0.6 * size, color);
                }
            }
            Self::Dash => {
                let line = [[-1.2, 0.0], [1.2, 0.0]];
                drawing.line(&line.map(at(1.0)), 0.6 * size, color);
            }
            Self::Ring => drawing.ring([x, y], size, open, color),
            Self::OpenDiamond => drawing.outline(&diamond.map(at(1.0)), open, color),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dashes_follow_corners() {
        let positions = [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0]];
        let found = dashed(&positions, &[8.0, 4.0]);
        let expected = [
            vec![[0.0, 0.0], [8.0, 0.0]],
            vec![[10.0, 2.0], [10.0, 10.0]],
        ];
        assert_eq!(found, expected);
        let full: f64 = dashed(&[[0.0, 0.0], [120.0, 0.0]], &[8.0, 4.0])
            .iter()
            .map(|dash| dash[dash.len() - 1][0] - dash[0][0])
            .sum();
        assert_eq!(full, 80.0);
        assert!(dashed(&[], &[8.0, 4.0]).is_empty());
        assert!(dashed(&[[1.0, 1.0], [1.0, 1.0]], &[8.0, 4.0]).len() <= 1);
    }
}
