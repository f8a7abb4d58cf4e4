//! Help of the command `stability`.

pub(super) const STABILITY: &str = "\
Finds growth and frequency over a parameter, and the boundaries of stability

Reads the dynamics files and the files that they name, and for each value of the parameter of \
[stability] reads them again: with [trim] it finds the controls, and then the roots of small \
motions about the equilibrium of [modes] or the periodic motion of [periodic]. Follows the modes, \
adds values where the number of unstable roots is not explained by them, and finds each boundary: \
flutter, divergence, half rate. Prints the boundaries, and writes into the folder DIR:
  NAME.stability.csv     a row for each value and root: growth, frequency, damping, mode
  NAME.boundaries.csv    a row for each boundary
  NAME.stability.txt     the report as printed, and all roots
  NAME.stability.png, .svg   growth and frequency over the parameter, and the root locus
where FILE is NAME.dynamics.toml. Values that fail are named with the reason, the others are kept, \
and the exit code is 1.";

pub(super) const STABILITY_EXAMPLE: &str = "\
Example, a rotor whose speed is the parameter rpm:
  cat >> rotor.dynamics.toml <<'END'
  [periodic]
  speed = \"= rpm\"
  start = \"rotating\"
  [stability]
  parameter = \"rpm\"
  from = 100
  to = 400
  steps = 13
  by = \"Floquet\"
  END
  beam-dynamics stability rotor.dynamics.toml";
