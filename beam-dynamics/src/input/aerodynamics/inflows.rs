//! Inflow of rotors: `[[inflow]]`.

use shared_geom::document::Table;
use shared_geom::document::schema::ValueKind::{Boolean, Count, NotNegative, Text, Word};
use shared_geom::keys;
use shared_geom::units::Dimension;

use rotor_aero::momentum::{HighInduction, Options};
use rotor_aero::strip::{AnnularInflow, Wake};
use rotor_aero::wake::TimeScale;

use crate::input::problem::InputProblem;

keys! {
    /// Velocity that a rotor induces at its blades.
    pub(in crate::input) CARD = "[[inflow]]";
    /// Its name.
    NAME: String = "name", [Text], required, "\"rotor\"";
    /// Kind: momentum of each annulus.
    KIND: usize = "kind", [Word(&["annular momentum"])], or "\"annular momentum\"" = 0,
        "\"annular momentum\"";
    /// Number of blades of the rotor.
    BLADES: Option<usize> = "blades", [Count(100)], or "the number of blades of the card that uses it", "3";
    /// Radius at which the blades begin.
    HUB_RADIUS: Option<f64> = "hub_radius", [NotNegative(Dimension::LENGTH)],
        or "the radius of the first station", "1.5";
    /// Loss at the tips of the blades, by Prandtl.
    TIP_LOSS: bool = "tip_loss", [Boolean], or "true" = true, "false";
    /// Loss at the roots of the blades, by Prandtl.
    HUB_LOSS: bool = "hub_loss", [Boolean], or "true" = true, "false";
    /// Induced velocity around the axis.
    SWIRL: bool = "swirl", [Boolean], or "true" = true, "false";
    /// Induction beyond the limits of momentum: Buhl's parabola with the loss inside or outside of
    /// it, the polynomial of HAWC2, or momentum alone.
    HIGH_INDUCTION: usize = "high_induction",
        [Word(&["Buhl", "Buhl outside", "polynomial", "momentum"])], or "\"Buhl\"" = 0,
        "\"polynomial\"";
    /// Wake: in equilibrium with the loads at all times, or with the two lags of Oye and his time
    /// constants (`dynamic`), or with the time in which the air passes the radius (`hover`), or with
    /// the velocities of the equilibrium in modes and runs (`frozen`).
    WAKE: usize = "wake", [Word(&["equilibrium", "dynamic", "hover", "frozen"])],
        or "\"equilibrium\"" = 0,
        "\"dynamic\"";
}

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
    /// Number of blades, if given.
    pub blades: Option<usize>,
    /// Radius at which the blades begin, if given \[m\].
    pub hub_radius: Option<f64>,
    /// Switches.
    pub options: Options,
    /// Wake.
    pub wake: Wake,
}

impl Inflow {
    /// The inflow of an annulus for a number of blades that begin at a radius \[m\], unless it has
    /// its own.
    pub fn annular(&self, blades: usize, hub_radius: f64) -> AnnularInflow {
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
    let name = table.get(&NAME);
    let kind = table.get(&KIND);
    let (blades, hub_radius) = (table.get(&BLADES), table.get(&HUB_RADIUS));
    let switches = [&TIP_LOSS, &HUB_LOSS, &SWIRL].map(|key| table.get(key));
    let (law, wake) = (table.get(&HIGH_INDUCTION), table.get(&WAKE));
    let _annular = kind?;
    let [tip_loss, hub_loss, swirl] = switches;
    Some(Inflow {
        name: name?,
        blades: blades?,
        hub_radius: hub_radius?,
        options: Options {
            tip_loss: tip_loss?,
            hub_loss: hub_loss?,
            swirl: swirl?,
            high_induction: [
                HighInduction::Buhl,
                HighInduction::BuhlOutside,
                HighInduction::Polynomial,
                HighInduction::Momentum,
            ][law?],
            ..Options::default()
        },
        wake: [
            Wake::Equilibrium,
            Wake::Dynamic(TimeScale::Turbine),
            Wake::Dynamic(HOVER),
            Wake::Dynamic(TimeScale::Frozen),
        ][wake?],
    })
}
