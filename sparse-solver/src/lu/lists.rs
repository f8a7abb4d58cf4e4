//! Many short lists in one block of memory, which is returned as a whole.

/// Part of the block that must be in use, or it is not enlarged but compacted [-].
const DENSE: f64 = 0.75;

/// Lists that grow and shrink.
#[derive(Debug)]
pub(super) struct Lists<E> {
    block: Vec<E>,
    spans: Vec<Span>,
}

/// Entries of one list in the block.
#[derive(Debug, Clone, Copy, Default)]
struct Span {
    first: u32,
    length: u32,
    /// Entries for which it has memory.
    capacity: u32,
}

impl<E: Copy> Lists<E> {
    /// Empty lists, with memory for `capacity` entries together.
    pub fn new(count: usize, capacity: usize) -> Self {
        Self {
            block: Vec::with_capacity(capacity),
            spans: vec![Span::default(); count],
        }
    }

    /// Entries of a list.
    pub fn of(&self, list: usize) -> &[E] {
        let Span { first, length, .. } = self.spans[list];
        &self.block[first as usize..(first + length) as usize]
    }

    /// The same, to be changed.
    pub fn of_mut(&mut self, list: usize) -> &mut [E] {
        let Span { first, length, .. } = self.spans[list];
        &mut self.block[first as usize..(first + length) as usize]
    }

    /// Adds an entry to a list.
    pub fn push(&mut self, list: usize, entry: E) {
        let Span {
            length, capacity, ..
        } = self.spans[list];
        if length == capacity {
            self.reserve(list, (2 * capacity).max(4), entry);
        }
        let span = &mut self.spans[list];
        self.block[(span.first + span.length) as usize] = entry;
        span.length += 1;
    }

    /// Removes entry `at` of a list and returns it; the last one takes its index.
    pub fn swap_remove(&mut self, list: usize, at: usize) -> E {
        let entries = self.of_mut(list);
        let last = entries.len() - 1;
        entries.swap(at, last);
        let removed = entries[last];
        self.spans[list].length -= 1;
        removed
    }

    /// Removes entry `at` of a list; the others keep their order.
    pub fn remove(&mut self, list: usize, at: usize) {
        let entries = self.of_mut(list);
        entries.copy_within(at + 1.., at);
        self.spans[list].length -= 1;
    }

    /// Removes all entries of a list, and frees its memory.
    pub fn clear(&mut self, list: usize) {
        self.spans[list] = Span::default();
    }

    /// Provides memory for `capacity` entries of a list, not fewer than it has; those not yet
    /// in use are `any`.
    pub fn reserve(&mut self, list: usize, capacity: u32, any: E) {
        if self.block.len() + capacity as usize > self.block.capacity() {
            self.compact();
            let needed = self.block.len() + capacity as usize;
            if needed as f64 > DENSE * self.block.capacity() as f64 {
                self.block.reserve_exact(needed / 2 + capacity as usize);
            }
        }
        let Span { first, length, .. } = self.spans[list];
        let begin = self.block.len();
        self.block
            .extend_from_within(first as usize..(first + length) as usize);
        self.block.resize(begin + capacity as usize, any);
        let first = begin as u32;
        self.spans[list] = Span {
            first,
            length,
            capacity,
        };
    }

    /// Moves all entries to the begin of the block, in their order there.
    fn compact(&mut self) {
        let used = (0..self.spans.len()).filter(|&list| self.spans[list].length > 0);
        let mut used: Vec<_> = used.map(|list| list as u32).collect();
        used.sort_unstable_by_key(|&list| self.spans[list as usize].first);
        let mut end = 0;
        for list in used {
            let span = &mut self.spans[list as usize];
            let first = span.first as usize;
            let entries = first..first + span.length as usize;
            self.block.copy_within(entries, end as usize);
            (span.first, span.capacity) = (end, span.length);
            end += span.length;
        }
        let empty = self.spans.iter_mut().filter(|span| span.length == 0);
        empty.for_each(|span| *span = Span::default());
        self.block.truncate(end as usize);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The same entries as separate vectors, after each of 200 changes, in 300 random cases.
    #[test]
    fn they_are_vectors() {
        let mut state = 1_u64;
        let mut below = |limit: usize| {
            // The generator of Knuth's MMIX; its upper bits are the most random ones.
            let (factor, sum) = (6_364_136_223_846_793_005, 1_442_695_040_888_963_407);
            state = state.wrapping_mul(factor).wrapping_add(sum);
            (state >> 33) as usize % limit
        };
        for case in 0..300 {
            let mut lists = Lists::new(5, case % 40);
            let mut expected = vec![Vec::new(); 5];
            for number in 0..200 {
                let (list, change) = (below(5), below(9));
                let own: &mut Vec<i32> = &mut expected[list];
                let at = below(own.len().max(1));
                match change {
                    0 => {
                        lists.clear(list);
                        own.clear();
                    }
                    1 if !own.is_empty() => {
                        assert_eq!(lists.swap_remove(list, at), own.swap_remove(at));
                    }
                    2 if !own.is_empty() => {
                        lists.remove(list, at);
                        own.remove(at);
                    }
                    _ => {
                        lists.push(list, number);
                        own.push(number);
                    }
                }
                for (list, entries) in expected.iter().enumerate() {
                    assert_eq!(lists.of(list), &entries[..]);
                }
            }
        }
    }
}
