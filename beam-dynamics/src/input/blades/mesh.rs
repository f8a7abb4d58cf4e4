//! Ends of the elements of a blade.
//!
//! At positions that must be element ends (jumps of the properties, kinks of the line,
//! point masses), and unless a number of elements is requested also at the stations, except
//! where an element would become very short; long intervals are divided evenly.

/// Shortest element between stations, as part of the blade: stations nearer to another
/// element end than this are ignored.
const SHORTEST: f64 = 1e-3;
/// Longest element, as part of the blade. A mode of four half waves then has five elements
/// per half wave, with an error of the order of 1e-5.
const LONGEST: f64 = 0.05;
/// An interval that is longer than a whole number of longest elements by less than this
/// part of one gets no further element: files of other tools have ramps of 1e-9 to 1e-8 of
/// the blade instead of jumps, and the elements should be the same as for jumps.
const LONGER: f64 = 1e-6;
/// Positions nearer than this part of the blade are the same.
const SAME: f64 = 1e-9;

/// Constraints on the elements of a blade.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Ends<'a> {
    /// Length of the blade \[m\].
    pub length: f64,
    /// Positions that must be element ends \[m\].
    pub fixed: &'a [f64],
    /// Positions of stations \[m\].
    pub stations: &'a [f64],
}

impl Ends<'_> {
    /// Element ends from the root to the tip, at the stations.
    pub fn at_stations(&self) -> Vec<f64> {
        let mut ends = vec![0.0];
        for pair in self.fixed_positions().windows(2) {
            let mut from = pair[0];
            let near = SHORTEST * self.length;
            let inside = |position: &&f64| **position > pair[0] && **position < pair[1] - near;
            let mut stations: Vec<_> = self.stations.iter().filter(inside).copied().collect();
            stations.sort_by(f64::total_cmp);
            for position in stations
                .into_iter()
                .filter(|position| *position > pair[0] + near)
            {
                if position > from + near {
                    divide(&mut ends, [from, position], self.pieces(position - from));
                    from = position;
                }
            }
            divide(&mut ends, [from, pair[1]], self.pieces(pair[1] - from));
        }
        ends
    }

    /// Ends of `elements` elements, as equal as the fixed positions allow; if there are too
    /// few, the number that is needed at least.
    pub fn of_number(&self, elements: usize) -> Result<Vec<f64>, usize> {
        let fixed = self.fixed_positions();
        let lengths: Vec<_> = fixed.windows(2).map(|pair| pair[1] - pair[0]).collect();
        if elements < lengths.len() {
            return Err(lengths.len());
        }
        let mut counts = vec![1; lengths.len()];
        for _ in lengths.len()..elements {
            let size = |i: &usize| lengths[*i] / counts[*i] as f64;
            let longest = (0..lengths.len()).max_by(|a, b| size(a).total_cmp(&size(b)));
            // A line whose length is not a number has no pieces.
            if let Some(count) = longest.and_then(|i| counts.get_mut(i)) {
                *count += 1;
            }
        }
        let mut ends = vec![0.0];
        for (pair, count) in fixed.windows(2).zip(counts) {
            divide(&mut ends, [pair[0], pair[1]], count);
        }
        Ok(ends)
    }

    /// The positions that must be ends, with root and tip, in order and each once.
    fn fixed_positions(&self) -> Vec<f64> {
        let near = SAME * self.length;
        let inside = |position: &&f64| **position > near && **position < self.length - near;
        let mut positions: Vec<_> = self.fixed.iter().filter(inside).copied().collect();
        positions.sort_by(f64::total_cmp);
        positions.insert(0, 0.0);
        positions.push(self.length);
        positions.dedup_by(|b, a| *b - *a <= near);
        positions
    }

    /// Elements in an interval of the given length.
    fn pieces(&self, length: f64) -> usize {
        ((length / (LONGEST * self.length) - LONGER).ceil() as usize).max(1)
    }
}

/// Adds the ends of `count` equal elements of an interval whose first end is included already.
fn divide(ends: &mut Vec<f64>, [from, to]: [f64; 2], count: usize) {
    let inside = (1..count).map(|k| from + (to - from) * k as f64 / count as f64);
    ends.extend(inside);
    ends.push(to);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ends<'a>(length: f64, fixed: &'a [f64], stations: &'a [f64]) -> Ends<'a> {
        Ends {
            length,
            fixed,
            stations,
        }
    }

    // On 100 m the longest element is 5 m, the shortest between stations 0.1 m.
    #[test]
    fn elements_end_at_stations_unless_they_are_very_near() {
        let stations: Vec<_> = (0..=25).map(|k| 4.0 * f64::from(k)).collect();
        assert_eq!(ends(100.0, &[], &stations).at_stations(), stations);
        let mut more = stations.clone();
        more.extend([4.05, 7.95, 30.0]);
        let found = ends(100.0, &[], &more).at_stations();
        assert!(found.contains(&4.0) && !found.contains(&4.05));
        // 7.95 comes first from the root, so that 8 is ignored.
        assert!(found.contains(&7.95) && !found.contains(&8.0));
        assert!(found.contains(&30.0));
    }

    #[test]
    fn fixed_positions_are_ends_whatever_is_near() {
        let found = ends(100.0, &[50.0, 50.05, 99.99], &[0.0, 49.96, 100.0]).at_stations();
        for position in [0.0, 50.0, 50.05, 99.99, 100.0] {
            assert!(found.contains(&position), "{position}: {found:?}");
        }
        assert!(!found.contains(&49.96));
        assert!(
            found
                .windows(2)
                .all(|pair| pair[1] > pair[0] && pair[1] - pair[0] <= 5.0)
        );
    }

    #[test]
    fn long_intervals_are_divided_evenly() {
        assert_eq!(ends(20.0, &[], &[0.0, 20.0]).at_stations().len(), 21);
        let found = ends(10.0, &[], &[0.0, 1.5, 10.0]).at_stations();
        assert_eq!(&found[..4], [0.0, 0.5, 1.0, 1.5]);
    }

    // Jumps at 40 and 70 m, and ramps of 1e-9 and 1e-8 of the blade instead of them.
    #[test]
    fn ramps_make_no_other_elements_than_jumps() {
        let positions = [40.0, 70.0];
        let jumps = ends(100.0, &positions, &positions).at_stations();
        for ramp in [1e-7, 1e-6] {
            let sides = [40.0 - ramp, 40.0, 70.0 - ramp, 70.0];
            let ramps = ends(100.0, &[], &sides).at_stations();
            assert_eq!(ramps.len(), jumps.len());
            let apart = ramps.iter().zip(&jumps).map(|(a, b)| (a - b).abs());
            assert!(apart.fold(0.0, f64::max) <= 1.001 * ramp);
        }
    }

    #[test]
    fn a_number_of_elements_is_shared_by_length() {
        let fixed = [1.0, 4.0];
        let found = ends(10.0, &fixed, &[2.0]).of_number(6).unwrap();
        assert_eq!(found, [0.0, 1.0, 2.5, 4.0, 6.0, 8.0, 10.0]);
        assert_eq!(ends(10.0, &fixed, &[]).of_number(2), Err(3));
        assert_eq!(
            ends(10.0, &fixed, &[]).of_number(3).unwrap(),
            [0.0, 1.0, 4.0, 10.0]
        );
    }
}
