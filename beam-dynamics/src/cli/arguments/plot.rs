//! Help of the command `plot`.

pub(super) const PLOT: &str = "\
Draws columns of runs in time

Reads tables that `transient` wrote, NAME.transient.csv or NAME.transient.nc, and draws their \
columns over time or over another column, with a panel for each unit. Several tables are drawn \
over each other.";

pub(super) const PLOT_EXAMPLE: &str = "\
Examples:
  beam-dynamics plot results/top.transient.csv
  beam-dynamics plot results/top.transient.nc --columns tip_x,tip_y --out figures/tip
  beam-dynamics plot results/top.transient.nc --columns 'tip*' --from 0.6 --to 0.8
  beam-dynamics plot results/top.transient.csv --x tip_x --columns tip_y --out path.svg
  beam-dynamics plot coarse.transient.csv fine.transient.csv --columns 'energy*'";
