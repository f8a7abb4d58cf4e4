//! Effect of a load distributed along the beam, in the report of stresses.

use shared_geom::wrench::COMPONENTS;

use super::round_off::{size, without_round_off};
use super::text::{number, table};
use crate::section::Section;
use crate::solution::DistributedState;

/// The force per length of a load on `section` and the generalized strain that it adds;
/// `acts` describes its parts, `strain` is the reference size for round-off of strains.
pub fn distributed_load(
    section: &Section,
    state: &DistributedState,
    (acts, strain): (&[String], f64),
) -> String {
    let size = size(section);
    let heading = ["", "force per length", "generalized strain"];
    let mut rows = vec![heading.map(str::to_owned).to_vec()];
    let force = without_round_off(&state.force_per_length, size.recip(), state.pressure * size);
    let strain = without_round_off(&state.strain, size, strain);
    for (i, component) in COMPONENTS.iter().enumerate() {
        rows.push(vec![
            (*component).to_owned(),
            number(force[i]),
            number(strain[i]),
        ]);
    }
    let acts = acts.iter().map(|part| format!("  {part}\n"));
    let acts: String = acts.collect();
    format!(
        "Distributed load at the section: force per length about the reference point [N/m, N]\n\
         and the generalized strain that it adds to the strain of the internal force [-, 1/m]\n\
         {acts}{}  \
         (the work of its stresses on the central solutions differs from that strain by {:.1e})\n",
        table(&rows, "lr"),
        state.error
    )
}
