//! The faces of laminates as physical curves, so that loads along the beam can name them.
//!
//! The outer face of a laminate called NAME is the curve `NAME/outer`; one centered on its
//! line has `NAME/left` and `NAME/right`. A curve of the mesh with the same name is not
//! changed.

use shared_geom::mesh::{Mesh, PhysicalGroup};

use super::WrittenLamina;
use crate::mesh::{Lamina, LaminaFace, LaminaProblem, LaminaSide, Laminated, add_laminae};

const CURVE: u8 = 1;

/// Adds the cells of laminates called `names` to the mesh, and their faces.
///
/// # Errors
/// As [`add_laminae`].
pub(in crate::input) fn add_with_faces(
    mesh: &mut Mesh,
    names: &[Option<String>],
    laminae: &[Lamina],
) -> Result<(Laminated, Faces), Vec<(usize, LaminaProblem)>> {
    let laminated = add_laminae(mesh, laminae)?;
    let faces = Faces::add(mesh, names, laminae, &laminated);
    Ok((laminated, faces))
}

/// The names of faces.
#[derive(Debug, Default)]
pub(in crate::input) struct Faces {
    /// Names of the faces of each laminate, with the label of its curve.
    of_curves: Vec<(String, Vec<String>)>,
    /// Names of laminates that could not be made: their existence is unknown.
    open: Vec<String>,
}

impl Faces {
    /// Names of the faces of the laminates on a curve.
    pub fn on(&self, curve: &str) -> Vec<String> {
        let own = self.of_curves.iter().filter(|(label, _)| label == curve);
        own.flat_map(|(_, names)| names.clone()).collect()
    }

    /// Whether a name may be a face or a ply, although the mesh does not have it.
    pub fn is_open(&self, name: &str) -> bool {
        self.open.iter().any(|known| known == name)
    }

    /// Names of laminates that have a problem.
    pub fn unknown(laminae: &[WrittenLamina]) -> Self {
        let names = laminae.iter().filter_map(|lamina| {
            let name = lamina.called()?;
            let faces = ["outer", "left", "right"].map(|face| format!("{name}/{face}"));
            Some([lamina.labels(), faces.to_vec()].concat())
        });
        Self {
            of_curves: Vec::new(),
            open: names.flatten().collect(),
        }
    }

    /// Adds the faces of `laminated` to the mesh; `names` are the names of the laminates.
    fn add(
        mesh: &mut Mesh,
        names: &[Option<String>],
        found: &[Lamina],
        laminated: &Laminated,
    ) -> Self {
        let mut faces = Self::default();
        for (index, (called, found)) in names.iter().zip(found).enumerate() {
            let of_lamina = laminated.faces.iter().filter(|face| face.lamina == index);
            let of_lamina: Vec<_> = of_lamina.collect();
            let has = |side| of_lamina.iter().any(|face| face.side == side);
            let is_centered = has(LaminaSide::Left) && has(LaminaSide::Right);
            let mut names = Vec::new();
            for side in [LaminaSide::Left, LaminaSide::Right] {
                let own = of_lamina.iter().filter(|face| face.side == side);
                let word = if is_centered { side.name() } else { "outer" };
                let name = called.as_ref().map(|name| format!("{name}/{word}"));
                if let Some(name) = name
                    && add_curve(mesh, &name, own.copied())
                {
                    names.push(name);
                }
            }
            faces
                .of_curves
                .push((mesh.groups[found.curve].label(), names));
        }
        faces
    }
}

/// Adds a curve, unless it has no lines or its name exists in the mesh.
fn add_curve<'a>(mesh: &mut Mesh, name: &str, faces: impl Iterator<Item = &'a LaminaFace>) -> bool {
    let mut lines: Vec<_> = faces.map(|face| face.line.clone()).collect();
    if lines.is_empty() || mesh.group(CURVE, name).is_some() {
        return false;
    }
    let tags = mesh.groups.iter().map(|group| group.tag);
    let group = PhysicalGroup {
        dimension: CURVE,
        tag: tags.max().unwrap_or(0).saturating_add(1),
        name: Some(name.to_owned()),
    };
    for line in &mut lines {
        line.groups = mesh.groups.len().into();
    }
    mesh.groups.push(group);
    mesh.lines.extend(lines);
    true
}
