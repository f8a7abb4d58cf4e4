//! Changes of airfoil tables: stall delay, extension to the full circle, compressibility, upside down.

use rotor_aero::airfoil::{AirfoilData, AirfoilProblem, StallDelay, Viterna};
use shared_geom::document::schema::ValueKind::{
    Boolean, NotNegative, Positive, Quantities, Table as OneTable, Word,
};
use shared_geom::document::{ByHand, Table};
use shared_geom::keys;
use shared_geom::units::Dimension;

keys! {
    /// Delay of stall by rotation, of a table of two-dimensional flow, for one station; blades have a
    /// `stall_delay` for all their stations.
    pub(super) STALL_DELAY: ByHand = "stall_delay", [OneTable(&STALL_DELAY_CARD)], optional, "";
    /// Angles between which the line of attached lift is fitted.
    pub(super) FIT: Option<Vec<f64>> = "fit", [Quantities(Dimension::ANGLE)], or "[-5, 5]", "[0, 5]";
    /// Extension of a table to the full circle by Viterna and Corrigan: `true`, or its constants.
    pub(super) VITERNA: ByHand = "viterna", [Boolean, OneTable(&VITERNA_CARD)], or "false", "true";
    /// Factor of Prandtl and Glauert on lift and moment of a table without Mach numbers or of one, or
    /// on linear lift, constant from this Mach number on.
    pub(super) COMPRESSIBLE: Option<f64> = "compressible_to", [Positive(Dimension::NUMBER)], optional, "0.8";
    /// Whether the section is upside down.
    pub(super) MIRROR: bool = "mirror", [Boolean], or "false" = false, "true";
}

keys! {
    /// Constants of the extension of a table to the full circle.
    VITERNA_CARD = "viterna = { ... }";
    /// Aspect ratio of the blade, which gives the drag at 90 deg: 1.11 + 0.018 times the ratio.
    ASPECT_RATIO: f64 = "aspect_ratio", [Positive(Dimension::NUMBER)], or "10" = 10.0, "17";
    /// Coefficient of drag at 90 deg.
    DRAG_90: Option<f64> = "drag_90", [Positive(Dimension::NUMBER)], or "by `aspect_ratio`", "1.3";
    /// Least coefficient of drag of the extension.
    LEAST_DRAG: f64 = "least_drag", [NotNegative(Dimension::NUMBER)], or "0.001" = 0.001, "0.01";
}

keys! {
    /// Delay of stall by rotation, at one station of a rotor.
    STALL_DELAY_CARD = "stall_delay = { ... }";
    /// Law: lift of Du and Selig with drag of Eggers, or lift of Snel.
    LAW: usize = "law", [Word(&["Du-Selig", "Snel"])], or "\"Du-Selig\"" = 0, "\"Snel\"";
    /// Chord over radius of the station.
    CHORD_RATIO: f64 = "chord_ratio", [Positive(Dimension::NUMBER)], required, "0.2";
    /// Radius of the station over radius of the rotor; not for Snel.
    RADIUS_RATIO: f64 = "radius_ratio", [Positive(Dimension::NUMBER)], or "0.5" = 0.5, "0.4";
    /// Speed of the tip by rotation over its speed in the air; not for Snel.
    SPEED_RATIO: f64 = "speed_ratio", [Positive(Dimension::NUMBER)], or "1" = 1.0, "0.98";
    with FIT.schema;
}

/// Changes of a table, in the order in which they are made.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Changes {
    stall_delay: Option<StallDelay>,
    viterna: Option<Viterna>,
    mach_limit: Option<f64>,
    mirror: bool,
}

/// Reads the changes of an airfoil.
pub(super) fn read(table: &Table<'_>) -> Option<Changes> {
    let stall_delay = if table.has(&STALL_DELAY) {
        table
            .table(&STALL_DELAY)
            .and_then(|inner| stall_delay(&inner))
            .map(Some)
    } else {
        Some(None)
    };
    let viterna = match (table.has(&VITERNA), table.is_table(&VITERNA)) {
        (false, _) => Some(None),
        (true, true) => table
            .table(&VITERNA)
            .and_then(|inner| viterna(&inner))
            .map(Some),
        (true, false) => table
            .boolean(VITERNA.name())
            .map(|wanted| wanted.then(|| Viterna::of_aspect_ratio(10.0))),
    };
    let (mach_limit, mirror) = (table.get(&COMPRESSIBLE), table.get(&MIRROR));
    Some(Changes {
        stall_delay: stall_delay?,
        viterna: viterna?,
        mach_limit: mach_limit?,
        mirror: mirror?,
    })
}

fn viterna(table: &Table<'_>) -> Option<Viterna> {
    let (ratio, drag_90) = (table.get(&ASPECT_RATIO), table.get(&DRAG_90));
    let least_drag = table.get(&LEAST_DRAG);
    table.finish();
    Some(Viterna {
        drag_90: drag_90?.unwrap_or(Viterna::of_aspect_ratio(ratio?).drag_90),
        least_drag: least_drag?,
    })
}

fn stall_delay(table: &Table<'_>) -> Option<StallDelay> {
    let (law, chord) = (table.get(&LAW), table.get(&CHORD_RATIO));
    let (radius, speed) = (table.get(&RADIUS_RATIO), table.get(&SPEED_RATIO));
    let fit = fit(table);
    table.finish();
    let (chord, radius, speed) = (chord?, radius?, speed?);
    let delay = match law? {
        0 => StallDelay::du_selig(chord, radius, speed),
        _ => StallDelay::snel(chord),
    };
    Some(delay.with_fit(fit?))
}

/// Reads the angles of a fit \[rad\].
pub(super) fn fit(table: &Table<'_>) -> Option<[f64; 2]> {
    let Some(angles) = table.get(&FIT)? else {
        return Some(StallDelay::USUAL_FIT);
    };
    match angles[..] {
        [from, to] if from < to => Some([from, to]),
        _ => {
            table.wrong(&FIT, "two angles, the smaller one first");
            None
        }
    }
}

impl Changes {
    /// Whether the table has a change.
    pub fn is_any(&self) -> bool {
        self.of_table().is_some() || self.mach_limit.is_some()
    }

    /// Whether its stall is delayed.
    pub fn delays_stall(&self) -> bool {
        self.stall_delay.is_some()
    }

    /// Whether the section is turned upside down.
    pub fn mirrors(&self) -> bool {
        self.mirror
    }

    /// The Mach number from which the factor of compressibility is constant, if it is wanted.
    pub fn mach_limit(&self) -> Option<f64> {
        self.mach_limit
    }

    /// The key of the first change that linear lift does not have, if any.
    pub fn of_table(&self) -> Option<&'static str> {
        let keys = [
            (self.stall_delay.is_some(), STALL_DELAY.name()),
            (self.viterna.is_some(), VITERNA.name()),
            (self.mirror, MIRROR.name()),
        ];
        keys.iter().find(|key| key.0).map(|key| key.1)
    }

    /// The changed table.
    ///
    /// # Errors
    /// Curves that a change cannot use.
    pub fn apply(&self, mut data: AirfoilData) -> Result<AirfoilData, Vec<AirfoilProblem>> {
        if let Some(delay) = &self.stall_delay {
            data = data.with_stall_delay(delay)?;
        }
        if let Some(viterna) = &self.viterna {
            data = data.extended(viterna)?;
        }
        if let Some(limit) = self.mach_limit {
            data = data.with_compressibility(limit)?;
        }
        Ok(if self.mirror { data.mirrored() } else { data })
    }
}
