//! Inflow of rotors: `[[inflow]]`.

use nalgebra::Vector3;
use shared_geom::document::Table;
use shared_geom::document::schema::TableSchema;
use shared_geom::document::schema::ValueKind::{
    Boolean, Count, NotNegative, Positive, Quantity, Text, Vector, Word,
};
use shared_geom::keys;
use shared_geom::units::Dimension;

use rotor_aero::inflow::InflowModel;
use rotor_aero::momentum::Options;
use rotor_aero::strip::{AnnularInflow, Wake};
use rotor_aero::wake::{Forcing, TimeScale};

use super::problem::StripProblem;
use super::switches::{
    self, AXIAL_DRAG, HIGH_INDUCTION, HUB_LOSS, SWIRL, TANGENTIAL_DRAG, TIP_LOSS,
};
use crate::input::problem::InputProblem;

mod disks;

pub(in crate::input) use disks::{DiskDesign, Disks};

keys! {
    /// Velocity that a rotor induces at its blades.
    pub(in crate::input) CARD = "[[inflow]]";
    /// Its name.
    NAME: String = "name", [Text], required, "\"rotor\"";
    /// Kind: momentum of each annulus, or a model of the whole disk: uniform inflow, with the
    /// distributions of Drees or of Mangler and Squire, or the three states of Pitt and Peters.
    KIND: usize = "kind", [Word(KINDS)], or "\"annular momentum\"" = 0, "\"Pitt-Peters\"";
    /// Node that carries the shaft.
    HUB: Option<String> = "hub", [Text], or "the hub of `[hub]`", "\"mast\"";
    /// Axis of the shaft before the model moves, in the sense of rotation, of any length; only with
    /// `hub`.
    AXIS: Option<Vector3<f64>> = "axis", [Vector(3, Dimension::NUMBER)], or "the axis of `[hub]`",
        "[1, 0, 0]";
    /// Number of blades of the rotor.
    BLADES: Option<usize> = "blades", [Count(100)], or "the number of blades of the card that uses it", "3";
    /// Radius at which the blades begin.
    HUB_RADIUS: Option<f64> = "hub_radius", [NotNegative(Dimension::LENGTH)],
        or "the radius of the first station", "1.5";
    /// Wake: in equilibrium with the loads at all times, or with the two lags of Oye and his time
    /// constants (`dynamic`), or with the time in which the air passes the radius (`hover`), or with
    /// the velocities of the equilibrium in modes and runs (`frozen`).
    WAKE: usize = "wake", [Word(&["equilibrium", "dynamic", "hover", "frozen"])],
        or "\"equilibrium\"" = 0,
        "\"dynamic\"";
    /// Velocities that the lags of a wake `dynamic` or `hover` follow: of momentum at the loads with the
    /// lagged velocities, or of the steady state with static sections at the present pitch, motion and wind.
    FORCING: usize = "forcing", [Word(&["lagged", "steady"])], or "\"lagged\"" = 0, "\"steady\"";
    /// Distribution of the induced velocity over the azimuth by the skew of the wake in yaw.
    SKEW: bool = "skew", [Boolean], or "false" = false, "true";
    /// Radius of the disk.
    RADIUS: Option<f64> = "radius", [Positive(Dimension::LENGTH)], or "the radius of the tip", "7.5";
    /// Part of the radius beyond which blades have no lift: the loss at the tips of a disk.
    EFFECTIVE_RADIUS: f64 = "effective_radius", [Positive(Dimension::NUMBER)], or "1" = 1.0, "0.97";
    /// Coordinate of a level ground along the vertical: ground effect, of all kinds.
    GROUND: Option<f64> = "ground", [Quantity(Dimension::LENGTH)], or "no ground", "-12";
    with TIP_LOSS.schema, HUB_LOSS.schema, SWIRL.schema, AXIAL_DRAG.schema, TANGENTIAL_DRAG.schema,
        HIGH_INDUCTION.schema;
}

/// The inflow of a rotor, which has its name and its shaft.
pub(in crate::input) const OF_ROTOR: TableSchema = TableSchema {
    title: "[rotor.inflow]",
    meaning: "Velocity that the rotor induces at its blades: keys of `[[inflow]]`.",
    keys: &[
        KIND.schema,
        BLADES.schema,
        HUB_RADIUS.schema,
        TIP_LOSS.schema,
        HUB_LOSS.schema,
        SWIRL.schema,
        AXIAL_DRAG.schema,
        TANGENTIAL_DRAG.schema,
        HIGH_INDUCTION.schema,
        WAKE.schema,
        FORCING.schema,
        SKEW.schema,
        RADIUS.schema,
        EFFECTIVE_RADIUS.schema,
        GROUND.schema,
    ],
    families: &[],
};

/// Words of the kinds.
const KINDS: &[&str] = &[
    "annular momentum",
    "uniform",
    "Drees",
    "Mangler-Squire",
    "Pitt-Peters",
];

/// Words of the models of the disk, in the order of [`KINDS`] after the first.
const MODELS: [&str; 4] = ["uniform", "drees", "mangler_squire", "pitt_peters"];

/// Time constant of a wake in hover: at most half a second, for a flow of half a meter per second
/// and more.
const HOVER: TimeScale = TimeScale::Hover {
    least_speed: 0.5,
    cap: 0.5,
};

/// An inflow by its name.
#[derive(Debug, Clone)]
pub(in crate::input) struct Inflow {
    /// Its name.
    pub name: String,
    /// The node of its shaft, if it is not the node of `[hub]`.
    pub hub: Option<String>,
    /// The axis of its shaft, if given: a unit vector.
    pub axis: Option<Vector3<f64>>,
    /// Its kind.
    pub kind: InflowKind,
}

/// A kind of inflow.
#[derive(Debug, Clone)]
pub(in crate::input) enum InflowKind {
    /// By the momentum of each annulus.
    Annular(Annular),
    /// By a model of the disk.
    Disk(DiskDesign),
}

/// Momentum of annuli.
#[derive(Debug, Clone)]
pub(in crate::input) struct Annular {
    /// Number of blades, if given.
    pub blades: Option<usize>,
    /// Radius at which the blades begin, if given \[m\].
    hub_radius: Option<f64>,
    /// Switches.
    options: Options,
    /// Wake.
    wake: Wake,
    /// Whether it varies over the azimuth with the skew of the wake.
    pub is_skewed: bool,
    /// Coordinate of the ground along the vertical, if there is one \[m\].
    pub ground: Option<f64>,
}

impl Inflow {
    /// Whether it is of the momentum of annuli.
    pub fn is_annular(&self) -> bool {
        matches!(self.kind, InflowKind::Annular(_))
    }
}

impl Annular {
    /// Number of blades and radius at which they begin \[m\], if given; it has no radius of a disk.
    pub fn stated(&self) -> (Option<usize>, Option<f64>, Option<f64>) {
        (self.blades, self.hub_radius, None)
    }

    /// A disk without a model, if the velocities at the strips are not the ones of their annuli.
    pub fn disk(&self) -> Option<DiskDesign> {
        let is_other = self.is_skewed || self.ground.is_some();
        is_other.then(|| DiskDesign::without_model(self.ground))
    }

    /// The inflow of an annulus for a number of blades that begin at a radius \[m\], unless it has
    /// its own.
    pub fn of_blades(&self, blades: usize, hub_radius: f64) -> AnnularInflow {
        AnnularInflow {
            blades: self.blades.unwrap_or(blades),
            hub_radius: self.hub_radius.unwrap_or(hub_radius),
            options: self.options,
            wake: self.wake,
        }
    }
}

/// Reads every `[[inflow]]`; `None` if one is wrong.
pub(super) fn read(root: &Table<'_>) -> Option<Vec<Inflow>> {
    let mut inflows: Vec<(Inflow, usize)> = Vec::new();
    let mut sound = true;
    for table in root.tables("inflow") {
        let inflow = inflow(&table);
        table.finish();
        let Some(inflow) = inflow else {
            sound = false;
            continue;
        };
        let line = table.line_of(&NAME);
        match inflows.iter().find(|(other, _)| other.name == inflow.name) {
            None => inflows.push((inflow, line)),
            Some((_, first)) => {
                let problem = InputProblem::DoubledName {
                    kind: "inflow",
                    name: inflow.name,
                    line: table.document().line_words(*first),
                };
                table.note(&NAME, &problem);
                sound = false;
            }
        }
    }
    sound.then(|| inflows.into_iter().map(|one| one.0).collect())
}

fn inflow(table: &Table<'_>) -> Option<Inflow> {
    let (name, kind) = (table.get(&NAME), table.get(&KIND));
    let (hub, axis) = (table.get(&HUB), axis(table));
    let model = kind.and_then(|kind| MODELS.get(kind.checked_sub(1)?));
    let model = model.and_then(|word| InflowModel::of_word(word));
    let (annular, disk) = (annular(table), disks::read(table, model));
    let (name, kind, hub, axis) = (name?, kind?, hub?, axis?);
    if let (Some(_), None) = (axis, &hub) {
        let problem = StripProblem::InflowKey {
            name: name.clone(),
            key: AXIS.name(),
            needed: "a \"hub\", the node that carries this shaft".to_owned(),
        };
        table.note(&AXIS, &problem);
    }
    note_useless(table, &name, kind)?;
    Some(Inflow {
        hub,
        axis,
        kind: match kind {
            0 => InflowKind::Annular(annular?),
            _ => InflowKind::Disk(disk?),
        },
        name,
    })
}

/// Notes a key of another kind of inflow, or without the key that it belongs to.
fn note_useless(table: &Table<'_>, name: &str, kind: usize) -> Option<()> {
    let of_annuli = [
        BLADES.name(),
        HUB_RADIUS.name(),
        TIP_LOSS.name(),
        HUB_LOSS.name(),
        SWIRL.name(),
        AXIAL_DRAG.name(),
        TANGENTIAL_DRAG.name(),
        HIGH_INDUCTION.name(),
        WAKE.name(),
        FORCING.name(),
        SKEW.name(),
    ];
    let of_disks = [RADIUS.name(), EFFECTIVE_RADIUS.name()];
    let mut useless = match kind {
        0 => of_disks.iter(),
        _ => of_annuli.iter(),
    };
    if let Some(&key) = useless.find(|key| table.has(**key)) {
        let needed = match kind {
            0 => format!("a model of the disk as \"kind\": {}", KINDS[1..].join(", ")),
            _ => format!("kind = \"{}\"", KINDS[0]),
        };
        let name = name.to_owned();
        table.note(key, &StripProblem::InflowKey { name, key, needed });
        return None;
    }
    let is_lagged = matches!(table.get(&WAKE), Some(1 | 2));
    let without = [
        (
            FORCING.name(),
            !is_lagged,
            "wake = \"dynamic\" or \"hover\"",
        ),
        (
            HUB_RADIUS.name(),
            table.get(&HUB_LOSS) == Some(false),
            "hub_loss = true",
        ),
        (
            TANGENTIAL_DRAG.name(),
            table.get(&SWIRL) == Some(false),
            "swirl = true",
        ),
    ];
    let useless = without.into_iter().find(|of| of.1 && table.has(of.0));
    if let Some((key, _, needed)) = useless {
        let (name, needed) = (name.to_owned(), needed.to_owned());
        table.note(key, &StripProblem::InflowKey { name, key, needed });
        return None;
    }
    Some(())
}

/// The axis of the shaft, if given: a unit vector.
fn axis(table: &Table<'_>) -> Option<Option<Vector3<f64>>> {
    let Some(axis) = table.get(&AXIS)? else {
        return Some(None);
    };
    let largest = axis.amax();
    if largest == 0.0 {
        table.note(&AXIS, &InputProblem::NoAxis);
        return None;
    }
    Some(Some((axis / largest).normalize()))
}

fn annular(table: &Table<'_>) -> Option<Annular> {
    let (blades, hub_radius) = (table.get(&BLADES), table.get(&HUB_RADIUS));
    let (options, wake, skew) = (switches::read(table), table.get(&WAKE), table.get(&SKEW));
    let ground = table.get(&GROUND);
    let forcing = [Forcing::Lagged, Forcing::Steady][table.get(&FORCING)?];
    Some(Annular {
        is_skewed: skew?,
        ground: ground?,
        blades: blades?,
        hub_radius: hub_radius?,
        options: options?,
        wake: [
            Wake::Equilibrium,
            Wake::Dynamic(TimeScale::Turbine, forcing),
            Wake::Dynamic(HOVER, forcing),
            Wake::Dynamic(TimeScale::Frozen, Forcing::Lagged),
        ][wake?],
    })
}
