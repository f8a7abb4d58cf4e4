//! Modes of equal blades that coincide in the turning axes: drawn once, under one name.

use super::looks::SAME_LINE;
use crate::result::{FrequencyTable, ModeBranch, ModePoint};

/// Difference of the damping ratios up to which two lines coincide [-].
pub(super) const SAME_DAMPING: f64 = 2e-3;

/// Branches that coincide.
#[derive(Debug, Clone)]
pub(super) struct Group<'a> {
    /// The first branch, and the others.
    first: &'a ModeBranch,
    others: Vec<&'a ModeBranch>,
}

/// The branches of `table` that have points; branches of one kind and of different patterns of
/// the blades are together if they coincide.
pub(super) fn groups(table: &FrequencyTable) -> Vec<Group<'_>> {
    let points = table
        .branches
        .iter()
        .flat_map(|b| b.points.iter().flatten());
    let highest = points.map(|point| point.frequency).fold(0.0, f64::max);
    let mut groups: Vec<Group<'_>> = Vec::new();
    for branch in &table.branches {
        if branch.points.iter().all(Option::is_none) {
            continue;
        }
        let same = SAME_LINE * highest;
        match groups.iter_mut().find(|group| group.takes(branch, same)) {
            Some(group) => group.others.push(branch),
            None => groups.push(Group {
                first: branch,
                others: Vec::new(),
            }),
        }
    }
    groups
}

impl<'a> Group<'a> {
    /// The first branch.
    pub fn first(&self) -> &'a ModeBranch {
        self.first
    }

    fn all(&self) -> impl Iterator<Item = &'a ModeBranch> + '_ {
        std::iter::once(self.first).chain(self.others.iter().copied())
    }

    /// The mode at a speed, of the first branch that has it.
    pub fn point(&self, speed: usize) -> Option<&'a ModePoint> {
        self.all()
            .find_map(|branch| branch.points.get(speed)?.as_ref())
    }

    /// Whether `branch` has another pattern of the blades and, up to a difference of frequencies
    /// `same` \[Hz\], the same line.
    fn takes(&self, branch: &ModeBranch, same: f64) -> bool {
        let is_other = |own: &ModeBranch| {
            own.harmonic.is_some() && branch.harmonic.is_some() && own.harmonic != branch.harmonic
        };
        branch.kind == self.first.kind && self.all().all(is_other) && self.coincides(branch, same)
    }

    fn coincides(&self, branch: &ModeBranch, same: f64) -> bool {
        let pairs = branch.points.iter().enumerate();
        let mut pairs = pairs
            .filter_map(|(speed, point)| Some((self.point(speed)?, point.as_ref()?)))
            .peekable();
        pairs.peek().is_some()
            && pairs.all(|(a, b)| {
                (a.frequency - b.frequency).abs() <= same
                    && (a.damping_ratio - b.damping_ratio).abs() <= SAME_DAMPING
            })
    }

    /// The name at the last speed: of one branch its own, of all blades `flap 1 (3 blades)`, of
    /// some of their patterns `flap 1 progressive, regressive`.
    pub fn name(&self, table: &FrequencyTable) -> String {
        let words = table.style.words;
        let count = 1 + self.others.len();
        let stem = self.first.stem();
        let name = match count {
            1 => self.first.name.clone(),
            _ if count == table.blades() => format!("{stem} ({count} blades)"),
            _ => joined(stem, self.all().map(|branch| branch.name.as_str())),
        };
        let last = (0..table.speeds.len()).rev();
        let last = last.filter_map(|speed| self.point(speed)).next();
        let now = last.map(|point| self.first.kind_at(point));
        match now.filter(|kind| *kind != self.first.kind) {
            Some(kind) => format!("{name}, now {}", kind.word_in(words)),
            None => name,
        }
    }
}

/// The name of several modes that have `stem` and a pattern: `flap 1 progressive, regressive`.
pub(super) fn joined<'a>(stem: &str, names: impl Iterator<Item = &'a str>) -> String {
    let patterns = names.map(|name| name.strip_prefix(stem).unwrap_or(name).trim());
    format!("{stem} {}", patterns.collect::<Vec<_>>().join(", "))
}
