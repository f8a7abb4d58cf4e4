//! Elements that MSH 2.2 lists once for each of their physical groups become one,
//! which keeps the tag of the first.

use std::collections::hash_map::Entry;
use std::collections::{HashMap, HashSet};

use super::problem::{Problems, ReadProblem};
use crate::mesh::{Cell, GroupSet, Line, Point};

/// Common data of repeated elements, a necessary condition.
type Key = [u32; 4];

/// The elements that repeat another one, and their treatment.
#[derive(Debug, Default)]
struct Repeats {
    /// First element and further group.
    joined: Vec<(usize, usize)>,
    /// Elements whose group has been joined.
    merged: HashSet<usize>,
    /// Other elements with the key of a first one: their index and its.
    left: Vec<[usize; 2]>,
}

/// Finds repeated elements of keys and groups; `same` decides between equal keys.
fn repeats<'a>(
    elements: impl Iterator<Item = (Key, &'a GroupSet)> + Clone,
    same: impl Fn(usize, usize) -> bool,
) -> Repeats {
    let mut first_of: HashMap<Key, (usize, &GroupSet)> =
        HashMap::with_capacity(elements.size_hint().0);
    let mut found = Repeats::default();
    let mut seen = HashSet::new();
    for (i, (key, groups)) in elements.enumerate() {
        let (first, its_groups) = match first_of.entry(key) {
            Entry::Vacant(vacant) => {
                vacant.insert((i, groups));
                continue;
            }
            Entry::Occupied(known) => *known.get(),
        };
        let further = match (its_groups.first(), groups.first()) {
            (Some(own), Some(group)) if own != group && same(first, i) => Some((first, group)),
            _ => None,
        };
        match further {
            Some(pair) if seen.insert(pair) => {
                found.joined.push(pair);
                found.merged.insert(i);
            }
            _ => found.left.push([i, first]),
        }
    }
    found
}

impl Repeats {
    /// Joins the groups, and drops the elements that were repeated for them.
    fn apply<T>(mut self, elements: &mut Vec<T>, groups: impl Fn(&mut T) -> &mut GroupSet) {
        if self.joined.is_empty() {
            return;
        }
        self.joined.sort_unstable();
        let mut shared: HashMap<GroupSet, GroupSet> = HashMap::new();
        for run in self.joined.chunk_by(|a, b| a.0 == b.0) {
            let groups = groups(&mut elements[run[0].0]);
            let all: GroupSet = groups.iter().chain(run.iter().map(|pair| pair.1)).collect();
            *groups = shared.entry(all.clone()).or_insert(all).clone();
        }
        let mut index = 0..;
        elements.retain(|_| index.next().is_none_or(|i| !self.merged.contains(&i)));
    }
}

/// Merges the points of one node and entity.
pub(super) fn points(points: &mut Vec<Point>) {
    let key = |point: &Point| [point.node, point.entity as u32, 0, 0];
    let found = repeats(
        points.iter().map(|point| (key(point), &point.groups)),
        |_, _| true,
    );
    found.apply(points, |point| &mut point.groups);
}

/// Merges the lines of one entity on the same nodes in the same direction.
pub(super) fn lines(lines: &mut Vec<Line>) {
    let key = |line: &Line| {
        let mut key = [u32::MAX, u32::MAX, u32::MAX, line.entity as u32];
        key[..line.nodes().len()].copy_from_slice(line.nodes());
        key
    };
    let found = repeats(
        lines.iter().map(|line| (key(line), &line.groups)),
        |_, _| true,
    );
    found.apply(lines, |line| &mut line.groups);
}

/// Merges the cells of one entity on the same nodes, if `repeated` permits it; reports
/// the others on the same corners. `locations` are their locations in the file.
pub(super) fn cells(
    cells: &mut Vec<Cell>,
    locations: &[usize],
    repeated: bool,
    problems: &mut Problems,
) {
    let key = |cell: &Cell| {
        let mut key = [u32::MAX; 4];
        key[..cell.corners().len()].copy_from_slice(cell.corners());
        key.sort_unstable();
        key
    };
    let same = |a: usize, b: usize| {
        let (a, b) = (&cells[a], &cells[b]);
        let sorted = |cell: &Cell| {
            let mut nodes = [0; 9];
            nodes[..cell.nodes().len()].copy_from_slice(cell.nodes());
            nodes.sort_unstable();
            nodes
        };
        repeated && a.entity == b.entity && a.kind == b.kind && sorted(a) == sorted(b)
    };
    let found = repeats(cells.iter().map(|cell| (key(cell), &cell.groups)), same);
    for &[cell, first] in &found.left {
        let problem = ReadProblem::RepeatedCell {
            cell: cells[cell].tag,
            first: cells[first].tag,
        };
        problems.push(locations[cell], problem);
    }
    found.apply(cells, |cell| &mut cell.groups);
}
