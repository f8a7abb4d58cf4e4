//! Places at which the cells of a wall fail, and remedies there.

use super::super::super::distance;
use super::remedies::Remedies;
use super::wall::{Edge, Wall};

/// Distance on both sides of this place with shorter cells, in lengths of cells.
const AROUND: f64 = 4.0;

/// Adds remedies for a wall whose cells fail at these positions; all its contacts without
/// positions. Returns whether anything is left to try.
pub(super) fn add(remedies: &mut Remedies, wall: &Wall, positions: &[[f64; 2]]) -> bool {
    if !remedies.is_close && wall.has_other_contacts() {
        remedies.search_closely();
        return true;
    }
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
                remedies.fine.push([s - reach, s + reach]);
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
        is_new |= remedies.next(contact);
    }
    is_new
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
