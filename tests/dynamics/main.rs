//! Validation of beam-dynamics against closed forms and published solutions.

mod beam_statics;
mod rotating_beam;
mod uniform_beam;
