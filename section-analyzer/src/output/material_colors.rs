//! The colors of the materials of a section, the same in all its figures, and their legend.

use shared_geom::figure::{Color, Drawing, INK, Label, SMALL, category};

use super::figure_parts::boxed;
use crate::section::Section;

/// Maximum number of materials in the legend.
const NAMES: usize = 12;

/// A color for each material that cells use.
#[derive(Debug)]
pub(super) struct MaterialColors {
    /// Color index of each material; materials of no cell have none.
    color_of: Vec<usize>,
    /// Rows of the legend: names in the order of their colors.
    names: Vec<String>,
    /// Number of rows with a color.
    colored: usize,
}

impl MaterialColors {
    /// Colors in the order of the materials.
    pub fn new(section: &Section) -> Self {
        let mut is_used = vec![false; section.materials.len()];
        for made_of in &section.cells {
            is_used[made_of.material] = true;
        }
        let mut names = Vec::new();
        let mut color_of = vec![usize::MAX; section.materials.len()];
        let used = (0..color_of.len()).filter(|&material| is_used[material]);
        for material in used {
            color_of[material] = names.len();
            names.push(section.materials[material].name.clone());
        }
        let mut colored = names.len();
        if colored > NAMES {
            names.truncate(NAMES - 1);
            names.push(format!("and {} more materials", colored - NAMES + 1));
            colored = NAMES - 1;
        }
        Self {
            color_of,
            names,
            colored,
        }
    }

    /// The color of a material.
    pub fn of(&self, material: usize) -> Color {
        category(self.color_of[material])
    }

    /// Rows of the legend.
    pub fn rows(&self) -> usize {
        self.names.len()
    }

    /// Draws the legend, its first row in the middle of `left` and `y`, names in the width
    /// `space`, with the distance `line` of rows \[figure pixels\].
    pub fn draw(&self, drawing: &mut Drawing, [left, y]: [f64; 2], (line, space): (f64, f64)) {
        let label = Label::new(SMALL).colored(INK);
        for (row, name) in self.names.iter().enumerate() {
            let y = y + line * row as f64;
            if row < self.colored {
                let corners = boxed([left, y - 18.0], [left + 56.0, y + 18.0]);
                drawing.polygon(&corners, category(row));
                drawing.outline(&corners, 2.0, INK);
            }
            let name = drawing.shortened(name, label, space - 76.0);
            drawing.text(&name, [left + 76.0, y], label);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::section::samples::of_quadrilaterals;

    /// Of 15 materials cells use all but the second: 11 are named, and 3 are counted.
    #[test]
    fn materials_of_cells_have_colors_and_the_legend_is_limited() {
        let nodes: Vec<[f64; 2]> = (0..32)
            .map(|k| [f64::from(k / 2), f64::from(k % 2)])
            .collect();
        let cells: Vec<[u32; 4]> = (0..15)
            .map(|k| [2 * k, 2 * k + 2, 2 * k + 3, 2 * k + 1])
            .collect();
        let mut section = of_quadrilaterals(&nodes, &cells);
        let material = section.materials[0].clone();
        section.materials = vec![material; 15];
        for (k, made) in section.cells.iter_mut().enumerate() {
            section.materials[k].name = format!("m{k}");
            made.material = if k == 1 { 0 } else { k };
        }
        let colors = MaterialColors::new(&section);
        assert_eq!(colors.names[..2], ["m0", "m2"]);
        assert_eq!(colors.names[10..], ["m11", "and 3 more materials"]);
        assert_eq!((colors.rows(), colors.colored), (12, 11));
        assert_eq!(colors.of(0), category(0));
        assert_eq!(colors.of(14), category(13));
    }
}
