//! The help texts of `stress`.

pub(super) const STRESS: &str = "\
Recovers the stresses of a section under given internal forces

Solves the section, prints the report of each load, and writes into the folder DIR:
  NAME.LOAD.stress.txt         load, extreme stresses and failure indices by region
  NAME.LOAD.stress.csv         strains, stresses and indices at integration points
  NAME.LOAD.stress_cells.csv   means of the cells
  NAME.LOAD.stress_nodes.csv   smoothed values at nodes, by region
  NAME.LOAD.stress.vtu         all of it as fields on the mesh, for ParaView
  NAME.LOAD.stress_xx.png, .svg  plots; also shear, von_mises, and failure with strengths
The load is given on the command line; if not, all [load.NAME] of the file are used.
A plain number is in N or N m; \"1 kN\" and \"3 lbf in\" carry their own units.";

pub(super) const STRESS_EXAMPLE: &str = "\
Example, 1 kN of tension and 2 N m of torsion:
  section-analyzer stress blade/root.section.toml --axial 1e3 --torsion \"2 N m\"";
