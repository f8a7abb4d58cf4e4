//! Remarks on the materials of a section that is not solved.

use shared_geom::document::Document;

use super::super::{electrodes, material_warnings, materials};
use super::{Layup, LayupMesh};

impl Layup {
    /// The remarks on the materials of a section, as its analysis has them.
    pub fn material_remarks(&self, meshed: &LayupMesh) -> Vec<String> {
        let names = meshed.areas.iter().map(|area| area.name.as_str());
        let used: Vec<&str> = names.filter_map(|name| self.material_of(name)).collect();
        // the constants have been read before
        let Ok(document) = Document::parse(&self.constants, &self.file) else {
            return Vec::new();
        };
        let root = document.root();
        document.declare_units(&root);
        let mut known = materials::read(&root);
        known.retain(|material| used.contains(&material.name.as_str()));
        let each: Vec<usize> = (0..known.len()).collect();
        let warnings = material_warnings::warnings_of(&known, &each, &electrodes::read(&root));
        warnings.iter().map(ToString::to_string).collect()
    }
}
