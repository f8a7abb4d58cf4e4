//! Motion in time of small models.

mod beside;
mod bipendulum;
mod failing;
mod flexible;
mod following;
mod gimbal;
mod gravity;
mod linkages;
#[path = "../../beam-dynamics/src/analysis/transient/tests/models.rs"]
mod models;
mod rigid;
mod sampled;
mod scalars;
mod speeds;
mod stalling;
mod starting;
mod strip;
mod variable;
mod winding;
