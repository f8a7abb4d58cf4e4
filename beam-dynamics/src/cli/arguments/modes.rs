//! Help of the command `modes`.

pub(super) const MODES: &str = "\
Finds frequencies and modes over rotor speed

Reads the dynamics files and the files that they name, reports all their problems \
at once, finds equilibrium and modes at each speed, prints the tables, and writes into the \
folder DIR:
  NAME.frequencies.csv   a row for each speed and mode
  NAME.frequencies.txt   the tables as printed
  NAME.comparison.csv    measured and computed frequencies, where there are measurements
  NAME.modes.csv         damping, growth, shares of the energy and whirl of each mode
  NAME.fan.png, .svg     frequencies over rotor speed, with multiples of the speed; damping
  NAME.campbell.csv, .png, .svg   the same in the fixed system, for rotors and shafts
  NAME.critical_speeds.csv   speeds at which a frequency is a multiple of the rotor speed
  NAME.shapes_at_*.png, .svg   shapes along the span at the first and the last speed
  NAME.modes/            with --vtu: a series .pvd of field files for each mode
where FILE is NAME.dynamics.toml.

A FILE can also be a blade file, in any of the known formats: the blade is clamped at its \
root and at rest, unless the options state otherwise.";

pub(super) const MODES_EXAMPLE: &str = "\
Examples:
  beam-dynamics modes rotor/straight.dynamics.toml rotor/swept.dynamics.toml --out rotor/results
  beam-dynamics modes nrel5mw.blade.json
  beam-dynamics modes NREL_5MW_BeamDyn.dat --speeds 0,6.9,12.1 --hub-radius 1.5 --blades 3";
