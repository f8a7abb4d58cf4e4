//! Help of the command `periodic`.

pub(super) const PERIODIC: &str = "\
Finds motion that repeats, and its stability

Reads the dynamics files and the files that they name, finds the motion that repeats after the \
period of [periodic] by Newton's method or by period after period, and with [periodic.floquet] the \
multipliers and exponents of small motions about it. With [trim] it finds the controls, too; the \
command trim reports these. Prints iterations and multipliers, and writes into the \
folder DIR:
  NAME.periodic.csv      a row for each step of a period: the columns of [output]
  NAME.periodic.nc       the same as NetCDF, which Python reads with names and units
  NAME.periodic.txt      the text as printed
  NAME.periodic.png, .svg    all columns over the period
  NAME.harmonics.csv     mean, cosines and sines of each column
  NAME.floquet.csv       multipliers, growth, frequencies, damping, error, dominant motion
  NAME.floquet.png, .svg     the multipliers and the unit circle
where FILE is NAME.dynamics.toml.";

pub(super) const PERIODIC_EXAMPLE: &str = "\
Examples:
  cat >> rotor.dynamics.toml <<'END'
  [periodic]
  speed = \"300 rpm\"
  start = \"rotating\"
  [periodic.floquet]
  count = 10
  END
  beam-dynamics periodic rotor.dynamics.toml";
