//! Physical groups, and the sets of groups of elements.

use std::sync::Arc;

/// A physical group of gmsh: a named part of the mesh.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PhysicalGroup {
    /// Dimension: 0 points, 1 curves, 2 surfaces, 3 volumes.
    pub dimension: u8,
    /// Number of the group, within its dimension.
    pub tag: i32,
    /// Name, if the file has one.
    pub name: Option<String>,
}

impl PhysicalGroup {
    /// The name, or the tag if there is no name.
    pub fn label(&self) -> String {
        match &self.name {
            Some(name) => name.clone(),
            None => self.tag.to_string(),
        }
    }
}

/// The physical groups of an element: indices in the list of groups of its mesh,
/// ascending, each once.
///
/// Elements of one entity share one list, so that a copy does not allocate.
///
/// ```
/// use shared_geom::mesh::GroupSet;
///
/// let both: GroupSet = [4, 1, 4].into_iter().collect();
/// assert_eq!(both.as_slice(), [1, 4]);
/// assert!(both.contains(4) && !both.contains(2));
/// assert!(GroupSet::default().is_empty());
/// ```
#[derive(Debug, Clone, Default, PartialEq, Eq, Hash)]
pub struct GroupSet {
    // `None` for no group, so that equality compares the lists
    indices: Option<Arc<[usize]>>,
}

impl GroupSet {
    /// The indices, ascending.
    pub fn as_slice(&self) -> &[usize] {
        self.indices.as_deref().unwrap_or(&[])
    }

    /// The indices, ascending.
    pub fn iter(&self) -> impl Iterator<Item = usize> {
        self.as_slice().iter().copied()
    }

    /// The first group in the order of the mesh.
    pub fn first(&self) -> Option<usize> {
        self.as_slice().first().copied()
    }

    /// Whether `group` is one of them.
    pub fn contains(&self, group: usize) -> bool {
        self.as_slice().binary_search(&group).is_ok()
    }

    /// Whether it is empty.
    pub fn is_empty(&self) -> bool {
        self.indices.is_none()
    }
}

impl From<usize> for GroupSet {
    fn from(group: usize) -> Self {
        Self {
            indices: Some([group].into()),
        }
    }
}

impl FromIterator<usize> for GroupSet {
    fn from_iter<I: IntoIterator<Item = usize>>(groups: I) -> Self {
        let mut indices: Vec<usize> = groups.into_iter().collect();
        indices.sort_unstable();
        indices.dedup();
        Self {
            indices: (!indices.is_empty()).then(|| indices.into()),
        }
    }
}
