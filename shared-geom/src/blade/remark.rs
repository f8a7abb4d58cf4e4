//! What is allowed in a blade, and yet looks like a mistake.

use super::Blade;

impl Blade {
    /// What looks like a mistake, in words; empty when nothing does.
    pub fn remarks(&self) -> Vec<String> {
        Vec::new()
    }
}
