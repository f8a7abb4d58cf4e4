//! Sections meshed from their layups: closed forms, public blades, random layups.

#[path = "../../../tests/common/effort.rs"]
mod effort;

mod absent;
mod areas;
mod bar;
mod blades;
mod boxes;
mod closed_forms;
mod command_line;
mod cut_edges;
mod edge_webs;
mod equal;
mod files;
mod fills;
mod holes;
mod invariances;
mod keys;
mod malformed;
mod messages;
mod mirrored;
mod mirrored_stiffness;
mod names;
mod narrow;
mod nose;
mod prevabs;
mod prevabs_files;
mod random;
mod sections;
mod shapes;
mod silent;
mod spars;
mod stations;
mod thin_noses;
mod unlikely;
mod windio;
mod windio_former;
mod windio_rules;
mod windio_span;
mod words;
