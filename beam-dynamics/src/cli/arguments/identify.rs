//! Help of the command `identify`.

pub(super) const IDENTIFY: &str = "\
Finds frequencies and damping of the motions in tables of runs

Takes columns of runs in time, NAME.transient.csv or NAME.transient.nc, and identifies their \
oscillations by methods that do not use the model: Prony's sum of damped oscillations, the moving \
block at their frequencies, and the logarithmic decrement if one oscillation is alone. Agreement \
of the methods with each other, and with modes or exponents of the model, is the check. Growth is \
negative for a decay. Prints the modes of each column, and writes NAME.identified.csv.";

pub(super) const IDENTIFY_EXAMPLE: &str = "\
Example, the decay of a tip after its first second:
  beam-dynamics identify rotor.transient.csv --columns tip_z --from 1";
