//! Validation of beam-dynamics against closed forms and published solutions.

#![allow(clippy::unwrap_used, reason = "a test that cannot continue fails")]

mod air_output;
mod articulated;
mod beam_statics;
mod bipendulum;
mod blade_roots;
mod buckling;
mod case_files;
mod chain;
mod control;
mod damped_by_air;
mod damped_in_time;
mod damping;
mod disk_inflow;
mod divergence;
#[path = "../common/effort.rs"]
mod effort;
mod elastic_pendulums;
mod energy_watch;
mod equal_blades;
mod fixed_frame;
mod formats;
mod free_flight;
mod free_modes;
mod heat;
mod heavy_tips;
mod in_the_air;
mod in_time;
mod integrators;
mod joint_guides;
mod joint_rotors;
mod joint_runs;
mod joints;
mod leverage;
mod loads;
mod mbdyn_model;
mod mechanisms;
mod pendulum;
mod periodic;
mod piezo;
mod postbuckling;
mod prestress;
mod random_columns;
mod random_joints;
mod random_mechanisms;
#[path = "../common/record.rs"]
mod record;
mod rotating_beam;
mod rotating_in_time;
mod rotor;
mod rotor_in_time;
mod sensed_energy;
mod spinning_top;
mod statics;
mod strip_cards;
mod superposed;
mod swinging;
mod tm4760;
mod trim;
mod uniform_beam;
mod vacuum;
mod variational_beam;
mod wind_blades;
mod wings;
mod without_rotary_inertia;
