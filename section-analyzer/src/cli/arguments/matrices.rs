//! The help texts of `matrices`.

pub(super) const MATRICES: &str = "\
Solves a section that is given by its matrices

Another finite-element program writes the matrices, as Matrix Market files with a node
table: the blocks M, C, E of the section, or the stiffness of a slice of the beam. FILE
names them; their identities are checked, the section is solved like a section of cells,
and the folder DIR receives
  NAME.properties.json   stiffness, mass, centers: input of the beam program
  NAME.report.txt        the report
  NAME.warping.csv       the warping of the nodes under each unit internal force
  NAME.warping.vtu       the same as fields on points, for ParaView
where FILE is NAME.matrices.toml.";

pub(super) const MATRICES_EXAMPLE: &str = "\
Example, a slice 1 mm thick of a beam along x:
  cat > slice.matrices.toml <<'END'
  nodes = \"nodes.csv\"
  [units]
  length = \"mm\"
  [slice]
  stiffness = \"slice.mtx\"
  thickness = 1
  END
  section-analyzer matrices slice.matrices.toml
where nodes.csv has the heading node,y,z and a row for each node of the face, and the
unknowns are ux, uy, uz of its nodes, then of the nodes of the other face.";
