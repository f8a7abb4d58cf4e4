//! Remedies where the cells of a wall fold or overlap: there alone, contacts reach farther and cells
//! are shorter, so that the rest of the section keeps its mesh.

/// Remedies at a contact, tried one after the other: factors of its reach and of the length of cells.
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
/// The remedies of a wall.
#[derive(Debug, Clone, Default)]
pub(in super::super) struct Remedies {
    /// Numbers of contacts, and how many were tried there.
    contacts: Vec<(usize, usize)>,
    /// Intervals of the arc length with shorter cells.
    pub fine: Vec<[f64; 2]>,
    /// Whether contacts are searched closely.
    pub is_close: bool,
}

impl Remedies {
    /// Factors of the reach and of the length of cells at a contact.
    pub fn of(&self, contact: usize) -> (f64, f64) {
        let mut known = self.contacts.iter();
        let step = known.find(|one| one.0 == contact).map_or(0, |one| one.1);
        TRIED[step]
    }

    /// A closer search of contacts, in the place of remedies at others, whose numbers change.
    pub fn search_closely(&mut self) {
        self.is_close = true;
        self.contacts.clear();
    }

    /// The next remedy at a contact; whether there is one.
    pub fn next(&mut self, contact: usize) -> bool {
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
