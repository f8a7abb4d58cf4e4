//! Properties given in the card, by stiffnesses and inertias about their centers.

use nalgebra::{Vector2, Vector6};
use shared_geom::document::Table;
use shared_geom::document::schema::Family;
use shared_geom::document::schema::ValueKind::{NotNegative, Positive, Vector};
use shared_geom::keys;
use shared_geom::section::{Centers, Engineering, Provenance, SectionProperties};
use shared_geom::units::Dimension;

use super::beam_section::{Properties, usable};
use super::damping;

/// Properties given by numbers.
pub(super) const NUMBERS: Family = Family {
    name: "numbers",
    meaning: "By stiffnesses and inertias about their centers.",
    keys: &[
        EA.schema,
        GAY.schema,
        GAZ.schema,
        GJ.schema,
        EIY.schema,
        EIZ.schema,
        M.schema,
        IY.schema,
        IZ.schema,
        TENSION_CENTER.schema,
        SHEAR_CENTER.schema,
        MASS_CENTER.schema,
        THERMAL_FORCE.schema,
    ],
};

keys! {
    /// Axial stiffness.
    EA: f64 = "ea", [Positive(Dimension::FORCE)], required, "3e6";
    /// Shear stiffness along y.
    GAY: f64 = "gay", [Positive(Dimension::FORCE)], required, "9.5e5";
    /// Shear stiffness along z.
    GAZ: f64 = "gaz", [Positive(Dimension::FORCE)], required, "9.5e5";
    /// Torsional stiffness.
    GJ: f64 = "gj", [Positive(Dimension::BENDING_STIFFNESS)], required, "2.8";
    /// Bending stiffness about y, flap.
    EIY: f64 = "eiy", [Positive(Dimension::BENDING_STIFFNESS)], required, "0.64";
    /// Bending stiffness about z, lag.
    EIZ: f64 = "eiz", [Positive(Dimension::BENDING_STIFFNESS)], required, "160";
    /// Mass per length.
    M: f64 = "m", [NotNegative(Dimension::MASS_PER_LENGTH)], required, "0.11";
    /// Moment of inertia per length about y through the mass center.
    IY: f64 = "iy", [NotNegative(Dimension::INERTIA_PER_LENGTH)], required, "2.4e-8";
    /// Moment of inertia per length about z through the mass center; the polar one is the sum.
    IZ: f64 = "iz", [NotNegative(Dimension::INERTIA_PER_LENGTH)], required, "5.9e-6";
    /// Tension center, y and z from the reference point.
    TENSION_CENTER: [f64; 2] = "tension_center", [Vector(2, Dimension::LENGTH)]
        as "an array of 2, y and z, each a length", or "[0, 0]" = [0.0; 2],
        "[0.3, -0.1]";
    /// Shear center, y and z from the reference point.
    SHEAR_CENTER: [f64; 2] = "shear_center", [Vector(2, Dimension::LENGTH)]
        as "an array of 2, y and z, each a length", or "[0, 0]" = [0.0; 2],
        "[-0.2, 0.05]";
    /// Mass center, y and z from the reference point.
    MASS_CENTER: [f64; 2] = "mass_center", [Vector(2, Dimension::LENGTH)]
        as "an array of 2, y and z, each a length", or "[0, 0]" = [0.0; 2],
        "[0.1, 0.02]";
    /// Internal force of the restrained beam per declared unit of temperature, forces and moments
    /// in declared units.
    THERMAL_FORCE: Option<[f64; 6]> = "thermal_force", [Vector(6, Dimension::NUMBER)]
        as "an array of 6 numbers, forces and moments per declared unit of temperature", optional,
        "[-80, 0, 0, 0, 0.4, 0]";
}

/// Reads a table `[properties.NAME]` without a file.
pub(super) fn read(name: &str, table: &Table<'_>) -> Option<Properties> {
    // All keys are read, so that all problems are reported.
    let stiffness = [&EA, &GAY, &GAZ, &GJ, &EIY, &EIZ].map(|key| table.get(key));
    let mass = [&M, &IY, &IZ].map(|key| table.get(key));
    let centers = [&TENSION_CENTER, &SHEAR_CENTER, &MASS_CENTER];
    let centers = centers.map(|key| table.get(key).map(Vector2::from));
    let damping = damping::read(table);
    let thermal_force = thermal_force(table);
    let [ea, gay, gaz, gj, eiy, eiz] = stiffness;
    let [m, iy, iz] = mass;
    let [tension, shear, mass_center] = centers;
    let written = Engineering {
        stiffness: [ea?, gay?, gaz?, gj?, eiy?, eiz?],
        mass: [m?, iy?, iz?],
        centers: Centers {
            tension: tension?,
            shear: shear?,
            mass: mass_center?,
        },
        stiffness_angle: 0.0,
        inertia_angle: 0.0,
    };
    let section = SectionProperties {
        damping: damping?,
        thermal_force: thermal_force?,
        ..written.section(name, provenance())
    };
    usable(name, table, "", &section)
}

/// Internal force per kelvin of the restrained beam, about the reference point;
/// `Some(None)` if absent.
fn thermal_force(table: &Table<'_>) -> Option<Option<Vector6<f64>>> {
    let Some(numbers) = table.get(&THERMAL_FORCE)? else {
        return Some(None);
    };
    let units = [Dimension::THERMAL_FORCE, Dimension::THERMAL_MOMENT];
    let units = units.map(|dimension| table.document().factor(dimension));
    Some(Some(Vector6::from_fn(|i, _| numbers[i] * units[i / 3])))
}

/// Provenance of properties made by this program.
fn provenance() -> Provenance {
    Provenance {
        program: env!("CARGO_PKG_NAME").to_owned(),
        version: env!("CARGO_PKG_VERSION").to_owned(),
        input_hash: String::new(),
        nodes: 0,
        cells: 0,
        history: Vec::new(),
        sections: Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector3;
    use shared_geom::document::Document;

    const TEXT: &str = "ea = 7e6\ngay = 2e6\ngaz = 1e6\ngj = 30\neiy = 40\neiz = 900\n\
        m = 2\niy = 0.01\niz = 0.04\n\
        tension_center = [0.3, -0.1]\nshear_center = [-0.2, 0.05]\nmass_center = [0.1, 0.02]\n";

    fn properties(text: &str) -> Result<Properties, String> {
        let document = Document::parse(text, "a.toml").unwrap();
        let root = document.root();
        let found = read("p", &root);
        root.finish();
        document
            .finish(found)
            .map_err(|problems| problems.to_string())
    }

    /// Generalized strain of an internal force `f` that acts at the point (y, z):
    /// its moments about the reference point are p x f.
    fn strain(p: &Properties, f: [f64; 3], y: f64, z: f64) -> Vector6<f64> {
        let (f, arm) = (Vector3::from(f), Vector3::new(0.0, y, z));
        let moment = arm.cross(&f);
        let load = Vector6::new(f.x, f.y, f.z, moment.x, moment.y, moment.z);
        p.stiffness.try_inverse().unwrap() * load
    }

    // Meaning of the centers: an axial force at the tension center stretches by 1/EA and
    // does not bend; a shear force at the shear center does not twist. Strains of 1e-7
    // from an inverse with entries up to 1/30: a few roundings, 1e-15.
    #[test]
    fn forces_at_their_centers_cause_no_bending_and_no_twist() {
        let p = properties(TEXT).unwrap();
        let stretched = strain(&p, [1.0, 0.0, 0.0], 0.3, -0.1);
        assert!(stretched.fixed_rows::<2>(4).amax() < 1e-15, "{stretched}");
        let sheared = strain(&p, [0.0, 1.0, 1.0], -0.2, 0.05);
        assert!(sheared[3].abs() < 1e-15, "{sheared}");
        assert!((sheared[1] - 0.5e-6).abs() < 1e-15 && (sheared[2] - 1e-6).abs() < 1e-15);
        // At other points they do: EA at y = 0.3 bends about z by -0.3 F / EIz.
        let away = strain(&p, [1.0, 0.0, 0.0], 0.0, 0.0);
        assert!((away[5] - 0.3 / 900.0).abs() < 1e-12, "{away}");
    }

    // Momentum for a rotation about z through the reference point: the mass center at
    // y = 0.1 moves with v_x = -0.1, and Steiner gives Iz + m y^2.
    #[test]
    fn mass_is_taken_from_its_center() {
        let p = properties(TEXT).unwrap();
        let turning = p.mass * Vector6::new(0.0, 0.0, 0.0, 0.0, 0.0, 1.0);
        assert!((turning[0] + 2.0 * 0.1).abs() < 1e-15, "{turning}");
        assert!(
            (turning[5] - (0.04 + 2.0 * 0.01)).abs() < 1e-15,
            "{turning}"
        );
    }

    #[test]
    fn every_wrong_number_is_reported_by_its_key() {
        let text = TEXT
            .replace("gj = 30", "gj = 0")
            .replace("m = 2\n", "m = -2\n");
        let text = text
            .replace("ea = 7e6", "eaa = 1")
            .replace("[0.1, 0.02]", "[1, 2, 3]");
        let shown = properties(&text).unwrap_err();
        for expected in [
            "a.toml:1: the file has no \"ea\", expected a force",
            "a.toml:4: \"gj\" is 0, expected a bending or torsional stiffness greater than zero",
            "a.toml:7: \"m\" is -2, expected a mass per length, zero or more",
            "a.toml:12: \"mass_center\" is an array of 3, expected an array of 2, y and z, each a length",
            "a.toml:1: unknown key \"eaa\"",
        ] {
            assert!(shown.contains(expected), "{expected} is not in\n{shown}");
        }
    }
}
