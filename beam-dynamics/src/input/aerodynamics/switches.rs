//! Switches of annular momentum, of `[[inflow]]` and of `[momentum]` of rotor files.

use rotor_aero::momentum::{HighInduction, Options};
use shared_geom::document::Table;
use shared_geom::document::schema::ValueKind::{Boolean, Word};
use shared_geom::keys;

keys! {
    /// Loss at the tips of the blades, by Prandtl.
    pub(in crate::input) TIP_LOSS: bool = "tip_loss", [Boolean], or "true" = true, "false";
    /// Loss at the roots of the blades, by Prandtl.
    pub(in crate::input) HUB_LOSS: bool = "hub_loss", [Boolean], or "true" = true, "false";
    /// Induced velocity around the axis.
    pub(in crate::input) SWIRL: bool = "swirl", [Boolean], or "true" = true, "false";
    /// Drag in the induction along the axis; the loads contain it in any case.
    pub(in crate::input) AXIAL_DRAG: bool = "axial_drag", [Boolean], or "true" = true, "false";
    /// Drag in the induction around the axis; the loads contain it in any case.
    pub(in crate::input) TANGENTIAL_DRAG: bool = "tangential_drag", [Boolean], or "true" = true,
        "false";
    /// Induction beyond the limits of momentum: Buhl's parabola with the loss outside of it, which is
    /// continuous in hover, or inside, as in AeroDyn and CCBlade; the polynomial of HAWC2, or momentum
    /// alone.
    pub(in crate::input) HIGH_INDUCTION: usize = "high_induction",
        [Word(&["Buhl", "Buhl outside", "polynomial", "momentum"])], or "\"Buhl outside\"" = 1,
        "\"polynomial\"";
}

/// The laws, in the order of their words.
const LAWS: [HighInduction; 4] = [
    HighInduction::Buhl,
    HighInduction::BuhlOutside,
    HighInduction::Polynomial,
    HighInduction::Momentum,
];

/// Reads the switches of a table; `None` if one is wrong.
pub(in crate::input) fn read(table: &Table<'_>) -> Option<Options> {
    let switches = [&TIP_LOSS, &HUB_LOSS, &SWIRL, &AXIAL_DRAG, &TANGENTIAL_DRAG];
    let switches = switches.map(|key| table.get(key));
    let law = table.get(&HIGH_INDUCTION);
    let [tip_loss, hub_loss, swirl, axial_drag, tangential_drag] = switches;
    Some(Options {
        tip_loss: tip_loss?,
        hub_loss: hub_loss?,
        swirl: swirl?,
        axial_drag: axial_drag?,
        tangential_drag: tangential_drag?,
        high_induction: *LAWS.get(law?)?,
    })
}

#[cfg(test)]
mod tests {
    use shared_geom::document::Document;

    use super::*;
    use crate::input::test_files::{read_beside, reported};

    /// An option of all.
    type OptionOf = fn(&mut Options) -> &mut bool;

    /// Each key switches one option, in the models of both programs' files.
    #[test]
    fn each_key_is_one_option() {
        let of = |text: &str| {
            let document = Document::parse(text, "a.toml").unwrap();
            let root = document.root();
            let found = read(&root);
            document.finish(found).unwrap()
        };
        let usual = Options::default();
        assert_eq!(of(""), usual);
        let options: [(&str, OptionOf); 5] = [
            ("tip_loss", |options| &mut options.tip_loss),
            ("hub_loss", |options| &mut options.hub_loss),
            ("swirl", |options| &mut options.swirl),
            ("axial_drag", |options| &mut options.axial_drag),
            ("tangential_drag", |options| &mut options.tangential_drag),
        ];
        for (key, of_option) in options {
            let mut expected = usual;
            *of_option(&mut expected) = false;
            assert_eq!(of(&format!("{key} = false\n")), expected, "{key}");
        }
        let polynomial = of("high_induction = \"polynomial\"\n");
        assert_eq!(polynomial.high_induction, HighInduction::Polynomial);
        let shown = reported(read_beside(
            "units = \"SI\"\n[[inflow]]\nname = \"r\"\nkind = \"uniform\"\naxial_drag = false\n",
            &[],
        ));
        assert!(
            shown.contains("\"axial_drag\", which belongs to"),
            "{shown}"
        );
    }
}
