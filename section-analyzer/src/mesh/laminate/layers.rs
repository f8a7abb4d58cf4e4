//! The layers of a laminate: levels across its line, and the ply between two of them.

use super::LaminaSide;

/// Levels that differ by less, relative to the thickness of the laminate, are treated as
/// equal.
const SAME: f64 = 1e-9;

/// Side of its line on which a laminate lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Bank {
    Left,
    Right,
    /// On both sides.
    Middle,
}

impl Bank {
    /// The same side, relative to the opposite direction if `along` is false.
    pub fn seen(self, along: bool) -> Self {
        match (self, along) {
            (Self::Left, false) => Self::Right,
            (Self::Right, false) => Self::Left,
            _ => self,
        }
    }
}

/// The layers of a laminate.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Layers {
    /// Distances from the line to its left, ascending [mesh unit].
    pub levels: Vec<f64>,
    /// The ply between each level and the next.
    pub plies: Vec<usize>,
    pub bank: Bank,
}

/// Nodes of a laminate at the two ends of a line, parallel to its levels.
pub(super) type Ends = [Vec<u32>; 2];

impl Layers {
    /// One layer per ply.
    pub fn new(thicknesses: &[f64], side: LaminaSide) -> Self {
        let whole: f64 = thicknesses.iter().sum();
        let (first, bank) = match side {
            LaminaSide::Center => (-0.5 * whole, Bank::Middle),
            LaminaSide::Left => (0.0, Bank::Left),
            LaminaSide::Right => (0.0, Bank::Right),
        };
        let mut levels = vec![first];
        let mut level = first;
        for thickness in thicknesses {
            level += thickness;
            levels.push(level);
        }
        let mut plies: Vec<usize> = (0..thicknesses.len()).collect();
        if side == LaminaSide::Right {
            levels = levels.iter().rev().map(|level| 0.0 - level).collect();
            plies.reverse();
        }
        let mut layers = Self {
            levels,
            plies,
            bank,
        };
        // the middle of a symmetric laminate is exactly the line
        let tolerance = layers.tolerance();
        for level in &mut layers.levels {
            if level.abs() <= tolerance {
                *level = 0.0;
            }
        }
        layers
    }

    /// Distance within which levels are equal [mesh unit].
    pub fn tolerance(&self) -> f64 {
        SAME * self.thickness()
    }

    /// Thickness of all layers [mesh unit].
    pub fn thickness(&self) -> f64 {
        match (self.levels.first(), self.levels.last()) {
            (Some(low), Some(high)) => high - low,
            _ => 0.0,
        }
    }

    /// Largest distance from the line [mesh unit].
    pub fn reach(&self) -> f64 {
        self.levels.iter().fold(0.0, |reach, x| reach.max(x.abs()))
    }

    /// Whether a level may move to `level`: half of each adjacent ply must remain.
    pub fn may_be_at(&self, index: usize, level: f64) -> bool {
        let from = self.levels[index];
        let has_space = |beside: Option<&f64>| {
            beside.is_none_or(|x| (level - from).abs() <= 0.5 * (x - from).abs())
        };
        has_space(index.checked_sub(1).and_then(|i| self.levels.get(i)))
            && has_space(self.levels.get(index + 1))
    }

    /// Divides the layer that contains `level`, unless it is a level already or lies
    /// outside; returns whether it did.
    pub fn cut(&mut self, level: f64) -> bool {
        let tolerance = self.tolerance();
        if self.levels.iter().any(|x| (x - level).abs() <= tolerance) {
            return false;
        }
        let above = self.levels.partition_point(|x| *x < level);
        if above == 0 || above == self.levels.len() {
            return false;
        }
        self.levels.insert(above, level);
        self.plies.insert(above, self.plies[above - 1]);
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn plies_run_outward_from_the_line_or_from_right_to_left() {
        let layers = |side| Layers::new(&[1.0, 2.0], side);
        let left = layers(LaminaSide::Left);
        assert_eq!((left.levels, left.plies), (vec![0.0, 1.0, 3.0], vec![0, 1]));
        let right = layers(LaminaSide::Right);
        assert_eq!(
            (right.levels, right.plies),
            (vec![-3.0, -1.0, 0.0], vec![1, 0])
        );
        let center = layers(LaminaSide::Center);
        assert_eq!(
            (center.levels, center.plies),
            (vec![-1.5, -0.5, 1.5], vec![0, 1])
        );
    }

    #[test]
    fn a_cut_keeps_the_ply_and_is_made_once() {
        let mut layers = Layers::new(&[1.0, 2.0], LaminaSide::Left);
        assert!(layers.cut(2.0) && !layers.cut(2.0) && !layers.cut(1.0 + 1e-12));
        assert!(!layers.cut(4.0) && !layers.cut(-1.0));
        assert_eq!(layers.levels, [0.0, 1.0, 2.0, 3.0]);
        assert_eq!(layers.plies, [0, 1, 1]);
    }
}
