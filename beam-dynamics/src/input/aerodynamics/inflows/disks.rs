//! Models of the disk of a rotor, one disk for each `[[inflow]]`.

use std::collections::BTreeMap;
use std::sync::Arc;

use shared_geom::document::Table;

use rotor_aero::inflow::{InflowModel, Without};

use super::{EFFECTIVE_RADIUS, GROUND, RADIUS};
use crate::elements::strips::RotorDisk;
use crate::input::aerodynamics::StripProblem;

/// A disk before its rotor is known.
#[derive(Debug, Clone, Copy)]
pub(in crate::input) struct DiskDesign {
    /// The model.
    pub model: InflowModel,
    /// Radius, if given \[m\].
    pub radius: Option<f64>,
    /// Part of the radius with lift \[-\].
    pub effective_radius: f64,
    /// Coordinate of the ground along the vertical, if there is one \[m\].
    pub ground: Option<f64>,
}

impl DiskDesign {
    /// A disk without a model of its own.
    pub fn without_model(ground: Option<f64>) -> Self {
        Self {
            model: InflowModel::Without(Without),
            radius: None,
            effective_radius: 1.0,
            ground,
        }
    }
}

/// The disks of the inflows that blades use, by the names of the inflows.
pub(in crate::input) type Disks = BTreeMap<String, Arc<RotorDisk>>;

/// The disk of a model; its keys are read without a model, too.
pub(super) fn read(table: &Table<'_>, model: Option<InflowModel>) -> Option<DiskDesign> {
    let (radius, ground) = (table.get(&RADIUS), table.get(&GROUND));
    let effective_radius = table.get(&EFFECTIVE_RADIUS)?;
    if effective_radius > 1.0 {
        let found = effective_radius;
        table.note(&EFFECTIVE_RADIUS, &StripProblem::EffectiveRadius { found });
        return None;
    }
    Some(DiskDesign {
        model: model?,
        radius: radius?,
        effective_radius,
        ground: ground?,
    })
}
