//! Switches of annular momentum: `[momentum]`.

use rotor_aero::momentum::{HighInduction, Options};
use rotor_aero::rotor::AnnulusRadius;
use shared_geom::document::Table;
use shared_geom::document::schema::ValueKind::{Boolean, Word};
use shared_geom::keys;

keys! {
    /// Switches of the momentum of each annulus.
    pub(super) CARD = "[momentum]";
    /// Loss at the tips of the blades, by Prandtl.
    TIP_LOSS: bool = "tip_loss", [Boolean], or "true" = true, "false";
    /// Loss at the roots of the blades, by Prandtl.
    HUB_LOSS: bool = "hub_loss", [Boolean], or "true" = true, "false";
    /// Induced velocity around the axis.
    SWIRL: bool = "swirl", [Boolean], or "true" = true, "false";
    /// Drag in the induction along the axis; the loads contain it in any case.
    AXIAL_DRAG: bool = "axial_drag", [Boolean], or "true" = true, "false";
    /// Drag in the induction around the axis; the loads contain it in any case.
    TANGENTIAL_DRAG: bool = "tangential_drag", [Boolean], or "true" = true, "false";
    /// Induction beyond the limits of momentum: Buhl's parabola with the loss inside or outside of
    /// it, the polynomial of HAWC2, or momentum alone.
    HIGH_INDUCTION: usize = "high_induction",
        [Word(&["Buhl", "Buhl outside", "polynomial", "momentum"])], or "\"Buhl\"" = 0,
        "\"polynomial\"";
    /// Variation of the induced velocity over the azimuth by the skew of the wake.
    SKEWED_WAKE: bool = "skewed_wake", [Boolean], or "false" = false, "true";
    /// Radius in solidity and losses: the distance to the shaft, or the distance along the blade,
    /// as in CCBlade. Without precone both are equal.
    RADIUS: usize = "radius", [Word(&["to shaft", "along blade"])], or "\"to shaft\"" = 0,
        "\"along blade\"";
}

/// The switches.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Momentum {
    pub options: Options,
    pub skewed_wake: bool,
    pub radius: AnnulusRadius,
}

/// Reads `[momentum]`: `None` if it is wrong, the defaults if absent.
pub(super) fn read(root: &Table<'_>) -> Option<Momentum> {
    let Some(table) = root.has("momentum").then(|| root.table("momentum")) else {
        return Some(Momentum::default());
    };
    let table = table?;
    let switches = [
        &TIP_LOSS,
        &HUB_LOSS,
        &SWIRL,
        &AXIAL_DRAG,
        &TANGENTIAL_DRAG,
        &SKEWED_WAKE,
    ];
    let switches = switches.map(|key| table.get(key));
    let (law, radius) = (table.get(&HIGH_INDUCTION), table.get(&RADIUS));
    table.finish();
    let [
        tip_loss,
        hub_loss,
        swirl,
        axial_drag,
        tangential_drag,
        skewed_wake,
    ] = switches;
    let laws = [
        HighInduction::Buhl,
        HighInduction::BuhlOutside,
        HighInduction::Polynomial,
        HighInduction::Momentum,
    ];
    Some(Momentum {
        options: Options {
            tip_loss: tip_loss?,
            hub_loss: hub_loss?,
            swirl: swirl?,
            axial_drag: axial_drag?,
            tangential_drag: tangential_drag?,
            high_induction: *laws.get(law?)?,
        },
        skewed_wake: skewed_wake?,
        radius: match radius? {
            0 => AnnulusRadius::ToShaft,
            _ => AnnulusRadius::AlongBlade,
        },
    })
}
