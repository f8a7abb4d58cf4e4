//! Analyses: the code of each follows its method, one call per step.

mod bending;
mod branches;
pub mod buckling;
mod critical;
mod fewer_modes;
mod first_order;
mod growing;
mod modal_damping;
pub mod modes;
pub mod statics;
pub mod steady;
pub mod transient;

mod arc;
mod balance;
mod path;
mod settling;

#[cfg(test)]
mod slow_charge_tests;
