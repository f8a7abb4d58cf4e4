//! Remedies where the cells of a wall fold or overlap: there alone, contacts reach farther and cells
//! are shorter, so that the rest of the section keeps its mesh.

use super::super::super::distance;
use super::wall::{Edge, Wall};

/// What is tried at a contact, one after the other: factors of its reach and of the length of cells.
const TRIED: [(f64, f64); 6] = [
    (1.0, 1.0),
    (2.0, 1.0),
    (1.0, 0.5),
    (2.0, 0.5),
    (0.5, 0.5),
    (4.0, 0.5),
];
/// Factor of the length of cells around a place without a contact.
pub(super) const FINE: f64 = 0.5;
/// Distance on both sides of this place with shorter cells, in lengths of cells.
const AROUND: f64 = 4.0;

/// The remedies of a wall.
#[derive(Debug, Clone, Default)]
pub(in super::super) struct Remedies {
    /// Numbers of contacts, and how many were tried there.
    contacts: Vec<(usize, usize)>,
    /// Intervals of the arc length with shorter cells.
    pub fine: Vec<[f64; 2]>,
}

impl Remedies {
    /// Factors of the reach and of the length of cells at a contact.
    pub fn of(&self, contact: usize) -> (f64, f64) {
        let mut known = self.contacts.iter();
        let step = known.find(|one| one.0 == contact).map_or(0, |one| one.1);
        TRIED[step]
    }

    /// Adds remedies for a wall whose cells fail at these positions; all its contacts without
    /// positions. Returns whether anything is left to try.
    pub fn add(&mut self, wall: &Wall, positions: &[[f64; 2]]) -> bool {
        let mut contacts: Vec<usize> = Vec::new();
        let mut is_new = false;
        let samples = wall.samples();
        for position in positions {
            let off = |point: &&(f64, [f64; 2])| distance(point.1, *position);
            let nearest = samples.iter().min_by(|a, b| off(a).total_cmp(&off(b)));
            let Some((s, _)) = nearest else {
                continue;
            };
            match contact_at(wall, *s) {
                Some(contact) => contacts.push(contact),
                None if !wall.is_fine(*s) => {
                    let reach = AROUND * wall.size;
                    self.fine.push([s - reach, s + reach]);
                    is_new = true;
                }
                None => {}
            }
        }
        if positions.is_empty() {
            contacts.extend(0..wall.contacts.len());
        }
        contacts.sort_unstable();
        contacts.dedup();
        for contact in contacts {
            is_new |= self.next(contact);
        }
        is_new
    }

    /// The next remedy at a contact; whether there is one.
    fn next(&mut self, contact: usize) -> bool {
        match self.contacts.iter_mut().find(|one| one.0 == contact) {
            Some((_, step)) => {
                *step += 1;
                let is_left = *step < TRIED.len();
                *step = (*step).min(TRIED.len() - 1);
                is_left
            }
            None => {
                self.contacts.push((contact, 1));
                true
            }
        }
    }
}

/// Number of the contact whose columns lean at an arc length.
fn contact_at(wall: &Wall, s: f64) -> Option<usize> {
    if wall.edge == Edge::Smooth {
        return None;
    }
    let x = wall.pairs.x(usize::from(s > wall.outline.nose()), s);
    let zone = wall
        .zones
        .iter()
        .find(|zone| x >= zone[0] && x <= zone[1])?;
    let contacts = wall.contacts.iter().enumerate();
    let inside = contacts.filter(|(_, one)| one[0] >= zone[0] && one[1] <= zone[1]);
    let off = |one: &[f64; 2]| (one[0] - x).max(x - one[1]).max(0.0);
    let nearest = inside.min_by(|a, b| off(a.1).total_cmp(&off(b.1)));
    nearest.map(|(number, _)| number)
}
