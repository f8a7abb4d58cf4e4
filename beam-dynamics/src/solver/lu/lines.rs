//! Rows or columns by their number of entries, to find the shortest ones.

const NONE: usize = usize::MAX;

/// Lines in chains of equal length.
#[derive(Debug)]
pub(super) struct Lines {
    /// First line of each length.
    first: Vec<usize>,
    next: Vec<usize>,
    previous: Vec<usize>,
    length: Vec<usize>,
}

impl Lines {
    /// Lines of the given lengths.
    pub fn new(lengths: impl Iterator<Item = usize>) -> Self {
        let length: Vec<_> = lengths.collect();
        let n = length.len();
        let mut lines = Self {
            first: vec![NONE; n + 1],
            next: vec![NONE; n],
            previous: vec![NONE; n],
            length,
        };
        // The last come first into the chains, so that each begins with the first one.
        for line in (0..n).rev() {
            lines.insert(line);
        }
        lines
    }

    fn insert(&mut self, line: usize) {
        let head = &mut self.first[self.length[line]];
        self.next[line] = *head;
        self.previous[line] = NONE;
        if let Some(after) = self.previous.get_mut(*head) {
            *after = line;
        }
        *head = line;
    }

    /// Takes a line out.
    pub fn remove(&mut self, line: usize) {
        let (next, previous) = (self.next[line], self.previous[line]);
        match self.next.get_mut(previous) {
            Some(before) => *before = next,
            None => self.first[self.length[line]] = next,
        }
        if let Some(after) = self.previous.get_mut(next) {
            *after = previous;
        }
    }

    /// Gives a line another length.
    pub fn change(&mut self, line: usize, length: usize) {
        if self.length[line] != length {
            self.remove(line);
            self.length[line] = length;
            self.insert(line);
        }
    }

    /// All lines that were not removed, the shortest first.
    pub fn ascending(&self) -> impl Iterator<Item = usize> + '_ {
        let heads = self.first.iter().copied();
        heads.flat_map(move |head| {
            let existing = |line: usize| (line != NONE).then_some(line);
            std::iter::successors(existing(head), move |&line| existing(self.next[line]))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_come_by_length_and_then_by_number() {
        let mut lines = Lines::new([3, 1, 3, 1, 0].into_iter());
        assert_eq!(lines.ascending().collect::<Vec<_>>(), [4, 1, 3, 0, 2]);
        lines.change(0, 1);
        lines.remove(4);
        assert_eq!(lines.ascending().collect::<Vec<_>>(), [0, 1, 3, 2]);
        lines.remove(1);
        lines.change(2, 5);
        assert_eq!(lines.ascending().collect::<Vec<_>>(), [0, 3, 2]);
    }
}
