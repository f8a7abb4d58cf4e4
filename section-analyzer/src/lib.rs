//! Section properties of beams: computes the 6x6 stiffness and mass per length, the
//! centers and the warping, from which stresses are recovered, from a mesh of the
//! cross-section and its materials.
//!
//! The section may be of any shape and of any anisotropic materials. The method is due to
//! Giavotto et al.: finite elements over the section only, with the exact polynomial
//! solutions along the beam.
//!
//! ```text
//! section  ->  material  ->  element  ->  assembly  ->  solve  ->  properties
//! mesh         laws          cells        domain,       warping     centers,
//!                                         matrices                  axes
//! ```
//!
//! [`analysis::analyze`] runs the flow from a [`section::Section`] to a
//! [`solution::SectionSolution`].
//!
//! # Example
//!
//! ```
//! use section_analyzer::analysis::analyze;
//! use section_analyzer::material::{ElasticLaw, Material};
//! use section_analyzer::mesh::SectionMesh;
//! use section_analyzer::mesh::generate::Rectangle;
//! use section_analyzer::section::{CellMaterial, Section};
//! use shared_geom::error::SourceLocation;
//! use shared_geom::mesh::CellKind;
//! use shared_geom::section::InitialCurvature;
//!
//! // a steel bar, 200 mm wide and 100 mm high
//! let mesh = Rectangle {
//!     width: 0.2,
//!     height: 0.1,
//!     cells_y: 8,
//!     cells_z: 4,
//!     kind: CellKind::Quadrilateral8,
//!     name: "bar".into(),
//! }
//! .generate()
//! .expect("sound measures");
//! let (mesh, _) = SectionMesh::from_mesh(&mesh, 1.0, &SourceLocation::file("bar")).expect("sound mesh");
//! let steel = Material {
//!     name: "steel".into(),
//!     law: ElasticLaw::Isotropic { young: 210e9, poisson: 0.3 },
//!     density: 7850.0,
//!     expansion: None,
//!     electric: None,
//! };
//! let cell = CellMaterial { material: 0, fiber_angle: 0.0, plane_angle: 0.0 };
//! let section = Section {
//!     name: "bar".into(),
//!     cells: vec![cell; mesh.cells.len()],
//!     mesh,
//!     materials: vec![steel],
//!     initial_curvature: InitialCurvature::STRAIGHT,
//!     electrodes: Vec::new(),
//! };
//!
//! let solution = analyze(&section).expect("a sound section");
//! let axial = solution.stiffness[(0, 0)]; // E A = 4.2 GN
//! assert!((axial / 4.2e9 - 1.0).abs() < 1e-12);
//! ```
//!
//! # References
//! - V. Giavotto, M. Borri, P. Mantegazza, G. Ghiringhelli, V. Carmaschi,
//!   G. C. Maffioli, F. Mussi, *Anisotropic beam theory and applications*,
//!   Computers & Structures 16 (1983) 403-413.
//! - P. Masarati, *Comprehensive multibody aeroservoelastic analysis of integrated
//!   rotorcraft active controls*, PhD thesis, Politecnico di Milano, 1999.

pub mod analysis;
pub mod assembly;
pub mod cli;
pub mod element;
pub mod failure;
pub mod input;
pub mod material;
pub mod mesh;
pub mod output;
pub mod properties;
pub mod recovery;
pub mod section;
pub mod sensitivity;
pub mod solution;
pub mod solve;
