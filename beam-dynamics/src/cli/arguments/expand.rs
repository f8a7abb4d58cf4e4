//! Help texts of `expand`.

/// Help text of the command.
pub(super) const EXPAND: &str = "\
Prints a dynamics file with the cards to which its rotors expand

Each [[rotor]] is replaced by its frames, nodes, bodies, joints, springs, drives and blades; \
all other lines stay as they are. The expanded file gives the same results.";

/// Its example.
pub(super) const EXPAND_EXAMPLE: &str = "\
Example:
  beam-dynamics expand helicopter.dynamics.toml --out expanded.dynamics.toml";
