//! Rows or columns sorted by their number of entries, to find the shortest ones.

const NONE: u32 = u32::MAX;

/// Rule for the first line of each length.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Turn {
    /// The line that got this length last: elimination continues in the same region of memory,
    /// which is in the cache.
    LatestFirst,
    /// The line that got this length first: long chains then fill less.
    EachInTurn,
}

/// Lines in linked lists of equal length.
#[derive(Debug)]
pub(super) struct Lines {
    turn: Turn,
    /// First and last line of each length.
    ends: Vec<[u32; 2]>,
    next: Vec<u32>,
    previous: Vec<u32>,
    length: Vec<u32>,
    /// Stage of each line: lines of later stages than the present one are counted but not
    /// found.
    stages: Vec<u16>,
    stage: u16,
}

impl Lines {
    /// Lines of the given lengths, of which the stage zero is found. At first each list begins
    /// with the first line.
    pub fn new(lengths: impl Iterator<Item = usize>, turn: Turn, stages: Vec<u16>) -> Self {
        let length: Vec<_> = lengths.map(|length| length as u32).collect();
        let n = length.len();
        let mut lines = Self {
            turn,
            ends: vec![[NONE; 2]; n + 1],
            next: vec![NONE; n],
            previous: vec![NONE; n],
            length,
            stages,
            stage: 0,
        };
        lines.insert_stage();
        lines
    }

    /// Makes the lines of the next stage visible from now on; `false` after the last stage.
    pub fn show_next(&mut self) -> bool {
        self.stage += 1;
        self.insert_stage();
        self.stages.iter().any(|stage| *stage >= self.stage)
    }

    /// Whether a line belongs to a later stage.
    pub fn is_hidden(&self, line: usize) -> bool {
        self.stages[line] > self.stage
    }

    fn insert_stage(&mut self) {
        let n = self.length.len();
        for at in 0..n {
            let line = match self.turn {
                Turn::LatestFirst => n - 1 - at,
                Turn::EachInTurn => at,
            };
            if self.stages[line] == self.stage {
                self.insert(line);
            }
        }
    }

    fn insert(&mut self, line: usize) {
        let [head, tail] = &mut self.ends[self.length[line] as usize];
        let own = line as u32;
        let (next, previous) = match self.turn {
            Turn::LatestFirst => (std::mem::replace(head, own), NONE),
            Turn::EachInTurn => (NONE, std::mem::replace(tail, own)),
        };
        (self.next[line], self.previous[line]) = (next, previous);
        match self.previous.get_mut(next as usize) {
            Some(after) => *after = own,
            None => *tail = own,
        }
        match self.next.get_mut(previous as usize) {
            Some(before) => *before = own,
            None => *head = own,
        }
    }

    /// Removes a line.
    pub fn remove(&mut self, line: usize) {
        let [head, tail] = &mut self.ends[self.length[line] as usize];
        let (next, previous) = (self.next[line], self.previous[line]);
        match self.next.get_mut(previous as usize) {
            Some(before) => *before = next,
            None => *head = next,
        }
        match self.previous.get_mut(next as usize) {
            Some(after) => *after = previous,
            None => *tail = previous,
        }
    }

    /// Changes the length of a line.
    pub fn change(&mut self, line: usize, length: usize) {
        if self.is_hidden(line) {
            self.length[line] = length as u32;
        } else if self.length[line] as usize != length {
            self.remove(line);
            self.length[line] = length as u32;
            self.insert(line);
        }
    }

    /// Length of a line.
    pub fn length(&self, line: usize) -> usize {
        self.length[line] as usize
    }

    /// All lines that were not removed, the shortest first.
    pub fn ascending(&self) -> impl Iterator<Item = usize> + '_ {
        let heads = self.ends.iter().map(|ends| ends[0]);
        let lines = heads.flat_map(move |head| {
            let existing = |line: u32| (line != NONE).then_some(line);
            std::iter::successors(existing(head), move |&line| {
                existing(self.next[line as usize])
            })
        });
        lines.map(|line| line as usize)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn order(lines: &Lines) -> Vec<usize> {
        lines.ascending().collect()
    }

    #[test]
    fn lines_come_by_length_and_then_by_number_or_the_latest_first() {
        let mut lines = Lines::new([3, 1, 3, 1, 0].into_iter(), Turn::LatestFirst, vec![0; 5]);
        assert_eq!(order(&lines), [4, 1, 3, 0, 2]);
        lines.change(0, 1);
        lines.remove(4);
        assert_eq!(order(&lines), [0, 1, 3, 2]);
        lines.remove(1);
        lines.change(2, 5);
        assert_eq!(order(&lines), [0, 3, 2]);
    }

    #[test]
    fn lines_that_take_turns_go_to_the_end() {
        let mut lines = Lines::new([3, 1, 3, 1, 0].into_iter(), Turn::EachInTurn, vec![0; 5]);
        assert_eq!(order(&lines), [4, 1, 3, 0, 2]);
        lines.change(0, 1);
        lines.remove(4);
        assert_eq!(order(&lines), [1, 3, 0, 2]);
        lines.remove(3);
        lines.change(1, 3);
        lines.change(0, 3);
        assert_eq!(order(&lines), [2, 1, 0]);
        lines.remove(1);
        assert_eq!(order(&lines), [2, 0]);
    }

    #[test]
    fn hidden_lines_are_counted_and_found_once_they_are_shown() {
        let stages = vec![0, 1, 0];
        let mut lines = Lines::new([2, 2, 3].into_iter(), Turn::LatestFirst, stages);
        lines.change(1, 3);
        assert_eq!(order(&lines), [0, 2]);
        assert_eq!((lines.length(1), lines.is_hidden(1)), (3, true));
        assert!(lines.show_next());
        assert_eq!(order(&lines), [0, 1, 2]);
        assert!(!lines.show_next());
    }
}
