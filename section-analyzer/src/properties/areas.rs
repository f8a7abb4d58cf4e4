//! Area, moments of area, perimeter and mass of a section and of its regions.

use super::boundary::Perimeter;
use super::moments::{AreaMoments, SecondMoments};
use crate::mesh::SectionCell;
use crate::section::Section;

/// Geometry and mass of a region, or of the whole section.
///
/// Moments are geometric, not weighted by a modulus; the reference point is the origin of
/// the mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct AreaProperties {
    /// Name of the region.
    pub name: String,
    /// Number of its cells.
    pub cells: usize,
    /// Area \[m^2\].
    pub area: f64,
    /// Centroid of the area (y, z), from the reference point \[m\].
    pub centroid: [f64; 2],
    /// First moments about the reference point, `int y dA` and `int z dA` \[m^3\].
    pub first: [f64; 2],
    /// Second moments about the reference point \[m^4\].
    pub second: SecondMoments,
    /// Second moments about the region's centroid \[m^4\].
    pub central: SecondMoments,
    /// Length of the boundary: outer lines and holes \[m\].
    pub perimeter: Perimeter,
    /// Mass per length of the reference line, `int rho J dA` with J of (S-71) \[kg/m\].
    pub mass: f64,
}

/// [`AreaProperties`] by region, and of the whole section.
#[derive(Debug, Clone, PartialEq)]
pub struct AreaTable {
    /// The regions.
    pub regions: Vec<AreaProperties>,
    /// All cells; named `total`.
    pub total: AreaProperties,
}

impl AreaTable {
    /// The table by physical surface, in the order of [`crate::mesh::SectionMesh::groups`].
    pub fn by_group(section: &Section) -> Self {
        let groups: Vec<_> = section.mesh.cells.iter().map(|cell| cell.group).collect();
        Self::by_region(section, &section.mesh.groups, &groups)
    }

    /// The table by regions called `names`; `region_of_cell` has for each cell the
    /// index of its region.
    ///
    /// The sums of a thin region are taken about its own centroid and then moved to the
    /// reference point, to avoid differences of large numbers.
    pub fn by_region(section: &Section, names: &[String], region_of_cell: &[usize]) -> Self {
        let cells = measured(section);
        let mut parts = vec![Vec::new(); names.len()];
        for (cell, &region) in region_of_cell.iter().enumerate() {
            if let Some(part) = parts.get_mut(region) {
                part.push(cell);
            }
        }
        let all: Vec<_> = (0..cells.len()).collect();
        let regions = names.iter().zip(&parts);
        Self {
            regions: regions
                .map(|(name, part)| properties(section, name, &cells, part))
                .collect(),
            total: properties(section, "total", &cells, &all),
        }
    }
}

/// Moments of a cell about its first node, which keeps the digits of a mesh far from its
/// origin.
struct MeasuredCell {
    node: [f64; 2],
    moments: AreaMoments,
}

fn measured(section: &Section) -> Vec<MeasuredCell> {
    let mesh = &section.mesh;
    let cell = |cell: &SectionCell| {
        let node = mesh.nodes[cell.nodes()[0] as usize];
        let moments = AreaMoments::of_cell(mesh, cell, node);
        MeasuredCell { node, moments }
    };
    mesh.cells.iter().map(cell).collect()
}

/// The properties of the cells `part`, by index.
fn properties(
    section: &Section,
    name: &str,
    cells: &[MeasuredCell],
    part: &[usize],
) -> AreaProperties {
    let sum_about = |point: [f64; 2]| {
        let mut sum = AreaMoments::default();
        for &cell in part {
            let MeasuredCell { node, moments } = &cells[cell];
            sum += moments.moved([node[0] - point[0], node[1] - point[1]]);
        }
        sum
    };
    let base = part.first().map_or([0.0; 2], |&cell| cells[cell].node);
    let first_guess = placed(base, sum_about(base).centroid());
    let near = sum_about(first_guess);
    // again from there: the first guess has the round-off of positions as far as `base`
    let correction = near.centroid();
    let centroid = placed(first_guess, correction);
    let central = near.moved(correction.map(|shift| -shift));
    let about_reference = near.moved(first_guess);
    let line = &section.initial_curvature;
    let mass = |cell: usize| {
        let density = section.materials[section.cells[cell].material].density;
        let MeasuredCell { node, moments } = &cells[cell];
        let [y, z] = moments.first;
        let volume = line.tangent_at(node[0], node[1]).x * moments.area + line.curvature.y * z
            - line.curvature.z * y;
        density * volume
    };
    AreaProperties {
        name: name.to_owned(),
        cells: part.len(),
        area: central.area,
        centroid,
        first: about_reference.first,
        second: about_reference.second,
        central: central.second,
        perimeter: Perimeter::of(&section.mesh, part),
        mass: part.iter().map(|&cell| mass(cell)).sum(),
    }
}

fn placed(origin: [f64; 2], position: [f64; 2]) -> [f64; 2] {
    [origin[0] + position[0], origin[1] + position[1]]
}

#[cfg(test)]
#[path = "areas_tests.rs"]
mod tests;
