//! Cards that could not be read, and the names of their parts, whose uses are not reported.

use super::ModelBuilder;

impl ModelBuilder {
    /// Notes that a card could not be read.
    pub fn note_broken(&mut self) {
        self.broken = true;
    }

    /// Notes that a blade could not be read: uses of its nodes are not reported.
    pub fn note_broken_blade(&mut self, blade: &str) {
        self.broken = true;
        self.broken_blades.insert(blade.to_owned());
    }

    /// Notes that the rotors of the file, if there are `names`, could not be expanded: uses of their
    /// parts are not reported.
    pub fn note_broken_rotors(&mut self, names: Option<&Vec<String>>) {
        self.broken |= names.is_some();
        self.broken_rotors
            .extend(names.into_iter().flatten().cloned());
    }

    /// Notes that the air or the strips of a card could not be read: uses of strips and of rotors in the
    /// air are not reported.
    pub fn note_broken_air(&mut self) {
        self.broken = true;
        self.broken_air = true;
    }

    /// Whether the air or strips could not be read.
    pub fn has_broken_air(&self) -> bool {
        self.broken_air
    }

    /// Whether a name may be one of a part of a blade or a rotor that could not be read.
    pub fn is_of_broken_part(&self, name: &str) -> bool {
        let mut blades = self.broken_blades.iter();
        let mut rotors = self.broken_rotors.iter();
        let is_of = |blade: &String| name.strip_prefix(blade.as_str());
        blades.any(|blade| is_of(blade).is_some_and(|rest| rest.starts_with('/')))
            || rotors.any(|rotor| {
                let rest = name.strip_prefix(rotor.as_str());
                rest.is_some_and(|rest| rest.is_empty() || rest.starts_with(['/', ' ']))
            })
    }

    /// Whether rotors could not be expanded, or blades could not be read.
    pub fn has_broken_rotors(&self) -> bool {
        !(self.broken_rotors.is_empty() && self.broken_blades.is_empty())
    }

    /// Whether a blade of this name could not be read.
    pub fn is_broken_blade(&self, blade: &str) -> bool {
        self.broken_blades.contains(blade) || self.is_of_broken_part(blade)
    }
}
