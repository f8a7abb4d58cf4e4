//! A series of grids over time, phase or load: the file that ParaView opens.

use super::escape::escaped;

/// Grids of a series and the value of each.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Series {
    entries: Vec<(f64, String)>,
}

impl Series {
    /// Adds the grid in `file`, a path relative to the folder of the series with `/`
    /// between folders, at the next value: time, phase, step \[unit of the series\].
    pub fn add(&mut self, value: f64, file: impl Into<String>) {
        self.entries.push((value, file.into()));
    }

    /// The series as the text of a `.pvd` file.
    pub fn text(&self) -> String {
        let mut text = String::from(
            "<?xml version=\"1.0\"?>\n\
             <VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n\
             \x20 <Collection>\n",
        );
        for (value, file) in &self.entries {
            let file = escaped(file);
            text.push_str(&format!(
                "    <DataSet timestep=\"{value}\" group=\"\" part=\"0\" file=\"{file}\"/>\n"
            ));
        }
        text.push_str("  </Collection>\n</VTKFile>\n");
        text
    }
}
