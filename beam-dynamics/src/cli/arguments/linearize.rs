//! Help of the command `linearize`.

pub(super) const LINEARIZE: &str = "\
Writes linear models of small motions: matrices A, B, C and D

Reads the dynamics files and the files that they name, finds the equilibrium in the turning frame, \
or trims it, and linearizes all equations about it. Inputs are drives of the file and controls of \
[trim] by their names, outputs are sensors, outputs of systems, actuators and columns, reactions of \
joints among them. States are as few as the motion has: positions, momenta, and the states of the \
air, of circuits and of control laws. Prints states and eigenvalues, and writes into the folder DIR:
  NAME.linear.json       matrices, names, units and values, eigenvalues
  NAME.linear.csv        [A B; C D] as one table with names and units
  NAME.linear.txt        the report as printed
where FILE is NAME.dynamics.toml. All numbers are in SI units, angles in radians.";

pub(super) const LINEARIZE_EXAMPLE: &str = "\
Example, from the torque of a drive to a sensor and the column of a reaction:
  beam-dynamics linearize rotor.dynamics.toml --input torque --output hinge,bearing_z \\
      --speed \"300 rpm\"";
