//! Help of the command `transient`.

pub(super) const TRANSIENT: &str = "\
Follows the motion in time

Reads the dynamics files and the files that they name, finds an initial state that fulfills all \
joints, and integrates over the time of [transient]. Tables grow while it runs, so that a \
run that is stopped keeps its rows. Prints steps, iterations and times, and writes into the \
folder DIR:
  NAME.transient.csv     a row for each time: the columns of [output]
  NAME.transient.nc      the same as NetCDF, which Python reads with names and units
  NAME.transient.txt     the text as printed: start, remarks, steps, iterations, time by phase
  NAME.transient.png, .svg   all columns over time
  NAME.transient.pvd     with vtu in [output]: the moving model for ParaView, with its folder
  NAME.transient_air.csv, NAME.disk_1.png, .svg   with air_revolutions in [output]: the air
                         over span and azimuth
  NAME.restart.json      the state from which --restart continues
where FILE is NAME.dynamics.toml.";

pub(super) const TRANSIENT_EXAMPLE: &str = "\
Examples:
  cat >> blade.dynamics.toml <<'END'
  [gravity]
  acceleration = [0, 0, -9.81]
  [transient]
  to = 2
  step = \"1 ms\"
  [output]
  every = 5
  restart_every = \"0.5 s\"
  [[output.column]]
  name = \"tip\"
  quantity = \"displacement\"
  of = \"blade/tip\"
  unit = \"mm\"
  END
  beam-dynamics transient blade.dynamics.toml
  beam-dynamics plot results/blade.transient.csv --columns tip_z

Several files side by side, on two threads and without figures:
  RAYON_NUM_THREADS=2 beam-dynamics transient stiff.dynamics.toml soft.dynamics.toml --no-figures

A stopped run continues from its restart file:
  beam-dynamics transient blade.dynamics.toml --restart results/blade.restart.json";
