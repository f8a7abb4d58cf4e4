//! Switches of annular momentum: `[momentum]`.

use rotor_aero::momentum::Options;
use rotor_aero::rotor::AnnulusRadius;
use shared_geom::document::Table;
use shared_geom::document::schema::ValueKind::{Boolean, Word};
use shared_geom::keys;

use crate::input::aerodynamics::switches;

keys! {
    /// Switches of the momentum of each annulus.
    pub(super) CARD = "[momentum]";
    /// Variation of the induced velocity over the azimuth by the skew of the wake.
    SKEWED_WAKE: bool = "skewed_wake", [Boolean], or "false" = false, "true";
    /// Radius in solidity and losses: the distance to the shaft, or the distance along the blade,
    /// as in CCBlade. Without precone both are equal.
    RADIUS: usize = "radius", [Word(&["to shaft", "along blade"])], or "\"to shaft\"" = 0,
        "\"along blade\"";
    with switches::TIP_LOSS.schema, switches::HUB_LOSS.schema, switches::SWIRL.schema,
        switches::AXIAL_DRAG.schema, switches::TANGENTIAL_DRAG.schema,
        switches::HIGH_INDUCTION.schema;
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
    let options = switches::read(&table);
    let (skewed_wake, radius) = (table.get(&SKEWED_WAKE), table.get(&RADIUS));
    table.finish();
    Some(Momentum {
        options: options?,
        skewed_wake: skewed_wake?,
        radius: match radius? {
            0 => AnnulusRadius::ToShaft,
            _ => AnnulusRadius::AlongBlade,
        },
    })
}
