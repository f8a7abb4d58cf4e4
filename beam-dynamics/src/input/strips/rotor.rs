//! The rotor of a blade: its shaft, and its inflow.

use std::sync::Arc;

use nalgebra::Vector3;
use rotor_aero::inflow::Disk;
use rotor_aero::strip::StripInflow;
use shared_geom::document::Table;

use super::INFLOW_NAME;
use crate::elements::NO_INFLOW;
use crate::elements::strips::{DiskInflow, Ground, RotorDisk, Shaft};
use crate::input::aerodynamics::{DiskDesign, Inflow, InflowKind, StripProblem};
use crate::input::builder::ModelBuilder;

/// Smallest sine of the angle between the shaft and the azimuth zero of the hub.
const ALONG: f64 = 1e-3;
/// Part of the radius of the tip up to which a station is at the axis.
const AT_AXIS: f64 = 1e-9;

/// The rotor of the blades of a card.
#[derive(Debug)]
pub(super) struct Rotor {
    /// Its shaft, in the frame or in the axes of the node that carries it.
    pub shaft: Shaft,
    /// The node that carries the shaft, if it moves.
    pub hub: Option<usize>,
    /// Point and axis of the shaft in the frame, before the model moves.
    start: [Vector3<f64>; 2],
    /// Direction of azimuth zero in the frame; its part across the shaft counts.
    pub zero: Vector3<f64>,
    /// Sense of a positive thrust along the shaft.
    pub side: f64,
    inflow: Option<Inflow>,
}

/// The rotor with the inflow `name` of a card that `user` describes.
pub(super) fn find(
    name: Option<&str>,
    table: &Table<'_>,
    builder: &mut ModelBuilder,
    user: String,
) -> Option<Rotor> {
    let inflow = match name {
        None => None,
        Some(name) => Some(named(name, table, builder, user)?),
    };
    let rotation = builder.hub()?.frame_rotation();
    let (mut hub, mut start) = (builder.hub_node(), [rotation.center, rotation.axis]);
    if let Some(inflow) = &inflow
        && let Some(name) = &inflow.hub
    {
        let user = format!("inflow \"{}\"", inflow.name);
        let node = builder.find_node(name, table, INFLOW_NAME.name(), &user)?;
        let axis = inflow.axis.unwrap_or(rotation.axis);
        (hub, start) = (Some(node), [builder.nodes()[node].position, axis]);
    }
    above_ground(inflow.as_ref(), &start[0], table, builder)?;
    let shaft = match hub.map(|node| &builder.nodes()[node]) {
        None => Shaft {
            center: start[0],
            axis: start[1],
        },
        Some(node) => Shaft {
            center: node.rotation.tr_mul(&(start[0] - node.position)),
            axis: node.rotation.tr_mul(&start[1]),
        },
    };
    let zero = builder.hub()?.axes().column(0).into_owned();
    Some(Rotor {
        shaft,
        hub,
        zero: if start[1].cross(&zero).norm() > ALONG {
            zero
        } else {
            Vector3::ith(start[1].iamin(), 1.0)
        },
        start,
        side: 1.0,
        inflow,
    })
}

fn named(name: &str, table: &Table<'_>, builder: &ModelBuilder, user: String) -> Option<Inflow> {
    // Wrong inflows are reported already.
    let inflows = builder.aerodynamics().inflows.as_ref()?;
    let found = inflows.iter().find(|inflow| inflow.name == name);
    if found.is_none() {
        let known = inflows.iter().map(|inflow| inflow.name.clone());
        let problem = StripProblem::Unknown {
            kind: "inflow",
            name: name.to_owned(),
            user,
            known: known.collect(),
        };
        table.note(&INFLOW_NAME, &problem);
    }
    found.cloned()
}

/// Notes a rotor in ground effect whose center \[m\] is not above the ground.
fn above_ground(
    inflow: Option<&Inflow>,
    center: &Vector3<f64>,
    table: &Table<'_>,
    builder: &ModelBuilder,
) -> Option<()> {
    let Some(Inflow { name, kind, .. }) = inflow else {
        return Some(());
    };
    let ground = match kind {
        InflowKind::Disk(design) => design.ground,
        InflowKind::Annular(annular) => annular.ground,
    };
    let Some(ground) = ground else {
        return Some(());
    };
    let center = builder
        .aerodynamics()
        .air
        .as_ref()?
        .wind()
        .frame
        .up()
        .dot(center);
    if ground < center {
        return Some(());
    }
    let problem = StripProblem::BelowGround {
        name: name.clone(),
        ground,
        center,
    };
    table.note(&INFLOW_NAME, &problem);
    None
}

impl Rotor {
    /// Its name: of its inflow, if it has one.
    pub fn name(&self) -> &str {
        self.inflow
            .as_ref()
            .map_or(NO_INFLOW, |inflow| &inflow.name)
    }

    /// Whether it has an inflow.
    pub fn has_inflow(&self) -> bool {
        self.inflow.is_some()
    }

    /// The inflow, if it is of annuli and does not have the number of blades.
    pub fn without_blades(&self) -> Option<&str> {
        let inflow = self.inflow.as_ref()?;
        match &inflow.kind {
            InflowKind::Annular(annular) if annular.blades.is_none() => Some(&inflow.name),
            _ => None,
        }
    }

    /// Point and axis of its shaft in the frame, before the model moves \[m\].
    pub fn start(&self) -> [Vector3<f64>; 2] {
        self.start
    }

    /// Distance of a point from the shaft before the model moves \[m\].
    pub fn distance(&self, point: &Vector3<f64>) -> f64 {
        let [center, axis] = &self.start;
        let from = point - center;
        (from - axis * axis.dot(&from)).norm()
    }

    /// Its disk, if it has one: of a skewed wake and above the ground one without a model.
    fn design(&self) -> Option<(&str, DiskDesign)> {
        let inflow = self.inflow.as_ref()?;
        let design = match &inflow.kind {
            InflowKind::Disk(design) => *design,
            InflowKind::Annular(annular) => annular.disk()?,
        };
        Some((&inflow.name, design))
    }

    /// Whether the velocities of its annuli are distributed by the skew of the wake.
    fn is_skewed(&self) -> bool {
        let kind = self.inflow.as_ref().map(|inflow| &inflow.kind);
        matches!(kind, Some(InflowKind::Annular(annular)) if annular.is_skewed)
    }

    /// The inflow of its strips, for a number of blades that begin at a radius \[m\].
    pub fn inflow(&self, blades: usize, root: f64) -> Option<StripInflow> {
        Some(match &self.inflow.as_ref()?.kind {
            InflowKind::Annular(annular) => {
                let inflow = annular.of_blades(blades, root);
                if annular.disk().is_some() {
                    StripInflow::Distributed(inflow)
                } else {
                    StripInflow::Annular(inflow)
                }
            }
            InflowKind::Disk(_) => StripInflow::Disk,
        })
    }

    /// A remark on a hub of radius zero, for a blade whose first station is at a radius \[m\]: annuli then reach the
    /// axis, and nothing is lost at the hub.
    pub fn remark_on_hub(&self, blade: &str, first: f64, tip: f64) -> Option<String> {
        let inflow = self.inflow.as_ref()?;
        let InflowKind::Annular(annular) = &inflow.kind else {
            return None;
        };
        let is_zero = annular.stated().1.is_none() && first <= AT_AXIS * tip;
        is_zero.then(|| {
            format!(
                "blade \"{blade}\" begins at the axis of inflow \"{}\", so that its hub has the radius \
                 zero: if the blade begins at a hub, give [[blade]] its \"hub_radius\"",
                inflow.name
            )
        })
    }

    /// Radius of its disk for the radius of the tips \[m\].
    fn radius(design: &DiskDesign, tip: f64) -> f64 {
        design.radius.unwrap_or(tip)
    }

    /// Radius beyond which blades have no lift, for the radius of the tips \[m\].
    pub fn end_of_lift(&self, tip: f64) -> f64 {
        match self.design() {
            Some((_, design)) if design.effective_radius < 1.0 => {
                design.effective_radius * Self::radius(&design, tip)
            }
            _ => f64::INFINITY,
        }
    }

    /// Its disk for the radius of the tips \[m\]; added to the model with the first blade.
    pub fn disk(&self, tip: f64, builder: &mut ModelBuilder) -> Option<Arc<RotorDisk>> {
        let (name, design) = self.design()?;
        if let Some(disk) = builder.disks().get(name) {
            return Some(Arc::clone(disk));
        }
        let air = builder.aerodynamics().air.clone()?;
        let up = air.wind().frame.up();
        let disk = RotorDisk::new(
            name,
            Disk {
                model: design.model,
                radius: Self::radius(&design, tip),
            },
            (self.shaft, &self.start[1]),
            design.ground.map(|level| Ground { up, level }),
        );
        let disk = Arc::new(disk.skewed(self.is_skewed()));
        builder.add_disk(name, Arc::clone(&disk));
        let element = DiskInflow::new(Arc::clone(&disk), self.hub, air);
        builder.add_load(Box::new(element));
        Some(disk)
    }
}
