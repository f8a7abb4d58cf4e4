//! Help of the command `trim`.

pub(super) const TRIM: &str = "\
Finds controls for which quantities have given values

Reads the dynamics files and the files that they name, and finds the numbers of [[trim.control]] for \
which the quantities of [[trim.target]] have their values: in the mean of a periodic motion, by \
Newton's method or an auto-pilot, or in an equilibrium; with [trim.sweep] at each value of a \
parameter, from the solution before. Prints controls, targets and iterations, and writes into the \
folder DIR:
  NAME.trim.csv          a row for each point: controls, targets, iterations, status
  NAME.trim.txt          the table as printed
  NAME.trim.json         with --json: all points with all digits, for other programs
  NAME.trim.png, .svg    of a sweep: controls and targets over the parameter
and the last motion as the command periodic, or the last equilibrium as the command static, where \
FILE is NAME.dynamics.toml. Targets that are not met are named with the reason, and the exit code is 1.";

pub(super) const TRIM_EXAMPLE: &str = "\
Example:
  cat >> rotor.dynamics.toml <<'END'
  [periodic]
  speed = \"300 rpm\"
  start = \"rotating\"
  [trim]
  [[trim.control]]
  name = \"collective\"
  guess = 8
  [[trim.target]]
  name = \"thrust\"
  signal = \"rotor_thrust\"
  value = 2e4
  scale = 2e4
  END
  beam-dynamics trim rotor.dynamics.toml --json";
