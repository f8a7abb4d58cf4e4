//! Envelope of the internal forces at points: the largest and smallest value of each component, with
//! the other components at that instant.

use std::cmp::Ordering;

use nalgebra::Vector6;
use shared_geom::wrench::COMPONENTS;

/// Most numbers that name an instant.
pub(super) const LEADS: usize = 2;
/// The ends of a component, and the sign with which each is a largest value.
const ENDS: [(&str, f64); 2] = [("max", 1.0), ("min", -1.0)];

/// An internal force, and the instant at which it acts.
#[derive(Debug, Clone, Copy, PartialEq)]
struct At {
    /// \[N, N m\].
    force: Vector6<f64>,
    /// The numbers of the instant.
    lead: [f64; LEADS],
}

/// Both ends of all components at points.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Envelope {
    /// Of each point and component, without instants `None`.
    extremes: Vec<[[Option<At>; 2]; 6]>,
}

/// A row of the table of an envelope.
#[derive(Debug, PartialEq)]
pub(super) struct EnvelopeRow<'a> {
    /// The component and its end.
    pub case: String,
    /// The point.
    pub point: usize,
    /// All components at the instant of the extreme \[N, N m\].
    pub force: &'a Vector6<f64>,
    /// The numbers of the instant.
    pub lead: &'a [f64; LEADS],
}

/// The order of instants by their numbers.
pub(super) fn compared(a: &[f64; LEADS], b: &[f64; LEADS]) -> Ordering {
    a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1]))
}

impl Envelope {
    /// Without instants, for a number of points.
    pub fn new(points: usize) -> Self {
        Self {
            extremes: vec![[[None; 2]; 6]; points],
        }
    }

    /// Adds the force at a point at an instant; of equal extremes the first one counts.
    pub fn add(&mut self, point: usize, lead: &[f64], force: &Vector6<f64>) {
        let mut now = At {
            force: *force,
            lead: [0.0; LEADS],
        };
        for (own, value) in now.lead.iter_mut().zip(lead) {
            *own = *value;
        }
        for (component, ends) in self.extremes[point].iter_mut().enumerate() {
            for (known, (_, sign)) in ends.iter_mut().zip(ENDS) {
                let is_beyond = known
                    .is_none_or(|known| sign * (force[component] - known.force[component]) > 0.0);
                if is_beyond {
                    *known = Some(now);
                }
            }
        }
    }

    /// Adds the rows of a table of forces: `leads` numbers of the instant, the arc position, six
    /// components; the points of an instant follow each other. Rows without numbers are left out.
    pub fn add_table(&mut self, text: &str, leads: usize) {
        let rows = text.lines().filter_map(|line| {
            let cells = line.split(',').map(str::parse::<f64>);
            cells.collect::<Result<Vec<_>, _>>().ok()
        });
        let points = self.extremes.len().max(1);
        for (index, row) in rows.filter(|row| row.len() == leads + 7).enumerate() {
            let force = Vector6::from_fn(|k, _| row[leads + 1 + k]);
            self.add(index % points, &row[..leads], &force);
        }
    }

    /// The numbers of the instants with an extreme, ascending, each once.
    pub fn instants(&self) -> Vec<[f64; LEADS]> {
        let all = self.extremes.iter().flatten().flatten().flatten();
        let mut instants: Vec<_> = all.map(|at| at.lead).collect();
        instants.sort_by(compared);
        instants.dedup();
        instants
    }

    /// The rows of the table: all points of each component and end.
    pub fn rows(&self) -> impl Iterator<Item = EnvelopeRow<'_>> {
        let cases = (0..6).flat_map(|component| [(component, 0), (component, 1)]);
        cases.flat_map(move |(component, end)| {
            let points = self.extremes.iter().enumerate();
            points.filter_map(move |(point, extremes)| {
                let At { force, lead } = extremes[component][end].as_ref()?;
                Some(EnvelopeRow {
                    case: format!("{} {}", COMPONENTS[component], ENDS[end].0),
                    point,
                    force,
                    lead,
                })
            })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A made-up history in which the extremes are at different instants.
    fn history(instant: usize) -> Vector6<f64> {
        Vector6::from_fn(|k, _| ((2 + k) as f64 * instant as f64).sin() - 0.1 * k as f64)
    }

    // Compared with a search of all instants, without tolerance: no number is changed.
    #[test]
    fn extremes_come_with_their_instant() {
        let mut envelope = Envelope::new(2);
        for instant in 0..50 {
            let lead = [0.5 * instant as f64];
            envelope.add(0, &lead, &history(instant));
            envelope.add(1, &lead, &(3.0 * history(instant)));
        }
        let rows: Vec<_> = envelope.rows().collect();
        assert_eq!(rows.len(), 24);
        for (number, row) in rows.iter().enumerate() {
            let (component, is_min) = (number / 4, number / 2 % 2 == 1);
            let word = if is_min { "min" } else { "max" };
            assert_eq!(row.case, format!("{} {word}", COMPONENTS[component]));
            assert_eq!(row.point, number % 2);
            let factor = [1.0, 3.0][row.point];
            let sign = if is_min { -1.0 } else { 1.0 };
            let best = (0..50).max_by(|a, b| {
                let of = |instant: &usize| sign * history(*instant)[component];
                of(a).total_cmp(&of(b))
            });
            let best = best.unwrap();
            assert_eq!(row.force, &(factor * history(best)));
            assert_eq!(row.lead[0], 0.5 * best as f64);
        }
    }

    // A run that continues has the envelope of the whole run: rows of the table count as instants.
    #[test]
    fn a_table_is_added_as_its_instants() {
        let (mut direct, mut read) = (Envelope::new(3), Envelope::new(3));
        let mut text = "time [s],arc [m],axial [N]\n".to_owned();
        for instant in 0..20 {
            for point in 0..3 {
                let force = (1.0 + point as f64) * history(instant);
                direct.add(point, &[instant as f64], &force);
                let numbers = force.iter().map(|value| format!("{value:?}"));
                let numbers: Vec<_> = numbers.collect();
                text.push_str(&format!("{instant},{point},{}\n", numbers.join(",")));
            }
        }
        read.add_table(&text, 1);
        assert_eq!(direct, read);
    }
}
