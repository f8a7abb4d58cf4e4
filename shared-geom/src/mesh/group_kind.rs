//! Names of the groups of a mesh in the program that wrote it.

use std::fmt;

/// The form in which the file of a mesh has groups, for messages.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum GroupForm {
    /// Physical groups of gmsh.
    #[default]
    Physical,
    /// Sets of elements and nodes, of Abaqus.
    Sets,
    /// Values of cells in an array, of VTK.
    Values,
}

/// Groups of one dimension: 0 points, 1 curves, 2 surfaces.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct GroupKind {
    /// The form in which the file has them.
    pub form: GroupForm,
    /// Their dimension.
    pub dimension: u8,
}

impl GroupKind {
    /// The same groups of another dimension.
    pub fn with_dimension(self, dimension: u8) -> Self {
        Self { dimension, ..self }
    }
}

impl fmt::Display for GroupKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match (self.form, self.dimension) {
            (GroupForm::Physical, 2) => "physical surface",
            (GroupForm::Physical, 1) => "physical curve",
            (GroupForm::Physical, _) => "physical point",
            (GroupForm::Sets, 2) => "set of cells",
            (GroupForm::Sets, 1) => "set of lines",
            (GroupForm::Sets, _) => "set of points",
            (GroupForm::Values, 2) => "group of cells",
            (GroupForm::Values, 1) => "group of lines",
            (GroupForm::Values, _) => "group of vertices",
        })
    }
}
