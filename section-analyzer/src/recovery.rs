//! Recovery of strain and stress in the section from the internal force.
//!
//! ```text
//! u = X theta      u' = X T' theta      psi = Y theta
//! eps = B1 u' + B0 u + Bpsi psi         sigma = D eps            (S-33)
//! ```
//!
//! A [`Recoverer`] holds the common data of the load cases of a section and returns a
//! [`Recovery`] for each: integration points, means of cells, smoothed nodes, and the
//! resultants as a check. [`region_stresses`] and [`region_failures`] are its summary for
//! reports.
//!
//! All values are in SI units. Vectors of strain and stress have the usual order
//! 11 22 33 23 13 12 with engineering shear strains. In section axes 1 is x along the
//! beam, 2 is y, 3 is z; in material axes 1 is the fiber, 2 the transverse direction
//! in the ply, 3 its normal.
//!
//! # Example
//!
//! ```
//! # use section_analyzer::material::{ElasticLaw, Material};
//! # use section_analyzer::mesh::{SectionMesh, generate::Rectangle};
//! # use section_analyzer::section::{CellMaterial, Section};
//! # use shared_geom::{error::SourceLocation, mesh::CellKind};
//! # use shared_geom::section::InitialCurvature;
//! use nalgebra::Vector6;
//! use section_analyzer::analysis::analyze;
//! use section_analyzer::recovery::{LoadCase, Recoverer};
//!
//! # let mesh = Rectangle {
//! #     width: 0.2,
//! #     height: 0.1,
//! #     cells_y: 4,
//! #     cells_z: 2,
//! #     kind: CellKind::Quadrilateral8,
//! #     name: "bar".into(),
//! # }
//! # .generate()
//! # .expect("sound measures");
//! # let (mesh, _) = SectionMesh::from_mesh(&mesh, 1.0, &SourceLocation::file("bar")).expect("sound mesh");
//! # let law = ElasticLaw::Isotropic { young: 210e9, poisson: 0.3 };
//! # let steel = Material { name: "steel".into(), law, density: 7850.0, expansion: None, electric: None };
//! # let cell = CellMaterial { material: 0, fiber_angle: 0.0, plane_angle: 0.0 };
//! # let section = Section {
//! #     name: "bar".into(),
//! #     cells: vec![cell; mesh.cells.len()],
//! #     mesh,
//! #     materials: vec![steel],
//! #     initial_curvature: InitialCurvature::STRAIGHT,
//! #     electrodes: Vec::new(),
//! # };
//! // a bar, 200 mm wide and 100 mm high, bent about y by 1 kN m
//! let solution = analyze(&section).expect("a sound section");
//! let moment = LoadCase::at_point("bend", &Vector6::ith(4, 1e3), [0.0; 2]);
//! let recoverer = Recoverer::new(&section, &solution);
//!
//! let recovery = recoverer.recover(&moment).expect("stresses that add up");
//! assert!(recovery.resultant_error < 1e-12);
//! // M z / I at the upper face
//! let (_, top) = recoverer.at(&moment, [0.0, 0.05]).expect("a point in the section");
//! assert!((top.stress[0] / 3e6 - 1.0).abs() < 1e-10);
//! ```
//!
//! # References
//! - \[Giavotto1983\]: stresses of the central solutions.

mod added;
mod axes;
mod criteria;
mod electric;
mod envelope;
mod extrapolate;
mod extremes;
pub mod fatigue;
mod force_tree;
pub mod goodman;
mod imposed;
mod locate;
pub mod rainflow;
mod recoverer;
mod resultant;
mod scale;
mod state;
mod unit;

pub use criteria::{Criterion, FailureIndex, Mode, failure_indices};
pub use envelope::{RegionReserve, region_reserves};
pub use extremes::{
    Extreme, Range, RegionFailure, RegionStresses, STRESS_NAMES, criteria_of, region_failures,
    region_stresses,
};
pub use recoverer::{Recoverer, StressBlock, recover};
pub use state::{
    CellState, ElectricRecovery, ElectricState, LoadCase, NodalState, PointState, Recovery, Tensors,
};
pub use unit::UnitPoint;
