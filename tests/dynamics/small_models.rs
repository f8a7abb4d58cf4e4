//! Motion in time of small models.

mod beside;
mod bipendulum;
mod failing;
mod flexible;
mod following;
mod gravity;
#[path = "../../beam-dynamics/src/analysis/transient/tests/models.rs"]
mod models;
mod rigid;
mod sampled;
mod scalars;
mod speeds;
mod stalling;
mod starting;
mod unknowing;
mod variable;
mod winding;
