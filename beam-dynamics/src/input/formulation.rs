//! Formulation and inertia of the beams of a card.
//!
//! Default: the variational beam, with its mass at the nodes by weights. The finite volumes
//! of the thesis come as a set: forces, rigid portions and loads on portions.

use shared_geom::document::Table;
use shared_geom::document::schema::ValueKind::Word;
use shared_geom::keys;
use shared_geom::rotation::parameters::Parametrization;

use super::problem::InputProblem;
use crate::elements::beams::Formulation;

keys! {
    /// Formulation of the beams: variational, or the finite volumes of the thesis, with their own
    /// masses and loads.
    pub(super) FORMULATION: usize = "formulation", [Word(&["variational", "finite-volume"])],
        or "\"variational\"" = 0, "\"finite-volume\"";
    /// Interpolation of rotations in finite-volume beams.
    pub(super) INTERPOLATION: Option<usize> = "interpolation",
        [Word(&["gibbs", "rotation-vector"])], optional, "\"rotation-vector\"";
    /// Inertia of the beams: bodies at the nodes, or consistent, the latter only for the
    /// variational beam.
    pub(super) INERTIA: usize = "inertia", [Word(&["lumped", "consistent"])],
        or "\"lumped\"" = 0, "\"consistent\"";
}

/// Motion of the mass of a beam.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Inertia {
    /// Rigidly with the nodes.
    Lumped,
    /// With the interpolated velocities.
    Consistent,
}

/// The keys `formulation`, `interpolation` and `inertia` of a card.
pub(super) fn read(table: &Table<'_>) -> Option<(Formulation, Inertia)> {
    let formulation = formulation(table);
    let inertia = inertia(table);
    let (formulation, inertia) = (formulation?, inertia?);
    if formulation != Formulation::Variational && inertia == Inertia::Consistent {
        table.note("inertia", &InputProblem::PortionsOnly);
        return None;
    }
    Some((formulation, inertia))
}

fn formulation(table: &Table<'_>) -> Option<Formulation> {
    let (formulation, interpolation) = (table.get(&FORMULATION), table.get(&INTERPOLATION));
    let is_volume = formulation? == 1;
    let Some(word) = interpolation? else {
        return Some(if is_volume {
            Formulation::FiniteVolume(Parametrization::Gibbs)
        } else {
            Formulation::Variational
        });
    };
    if !is_volume {
        table.note("interpolation", &InputProblem::OwnInterpolation);
        return None;
    }
    let all = [Parametrization::Gibbs, Parametrization::RotationVector];
    Some(Formulation::FiniteVolume(all[word]))
}

fn inertia(table: &Table<'_>) -> Option<Inertia> {
    Some([Inertia::Lumped, Inertia::Consistent][table.get(&INERTIA)?])
}

#[cfg(test)]
mod tests {
    use crate::input::test_files::{STRIP, read_beside};
    use crate::model::{Conditions, Equation, Variable};

    /// A blade of one piece with further keys; returns the asymmetry of its tangent.
    fn blade(keys: &str) -> Result<f64, String> {
        let text = format!(
            "units = \"SI\"\n{STRIP}[[blade]]\nname = \"b\"\nproperties = \"strip\"\n\
             {keys}\n\
             [[blade.piece]]\nlength = 1\nelements = 1\n[modes]\nspeeds = [0]\n"
        );
        let system = read_beside(&text, &[])?.model.system;
        let tangent = system.tangent(&system.rest(), &Conditions::at_rest());
        let (row, column) = (Equation::Force.row(), Variable::Position.column());
        let size = 6 * system.nodes().len();
        let entry = |i: usize, j: usize| {
            let index = |k: usize| system.numbering().node(k / 6) + k % 6;
            tangent.by_unknowns.entry(index(i) + row, index(j) + column)
        };
        // Of the free nodes.
        let pairs = (6..size).flat_map(|i| (6..i).map(move |j| (i, j)));
        let (mut largest, mut off) = (0.0_f64, 0.0_f64);
        for (i, j) in pairs {
            largest = largest.max(entry(i, j).abs());
            off = off.max((entry(i, j) - entry(j, i)).abs());
        }
        Ok(off / largest)
    }

    // Round-off, compared with the lever arms of finite volumes, of the order of one.
    #[test]
    fn a_card_chooses_the_formulation() {
        for keys in [
            "",
            "formulation = \"variational\"",
            "inertia = \"consistent\"",
        ] {
            let off = blade(keys).unwrap();
            assert!(off < 1e-14, "{keys}: {off:e}");
        }
        for more in [
            "",
            "interpolation = \"gibbs\"",
            "interpolation = \"rotation-vector\"",
        ] {
            let off = blade(&format!("formulation = \"finite-volume\"\n{more}")).unwrap();
            assert!(off > 1e-3, "{more}: {off:e}");
        }
    }

    #[test]
    fn what_does_not_go_together_is_refused() {
        for (keys, expected) in [
            ("formulation = \"finite volume\"", "finite-volume"),
            (
                "formulation = \"finite-volume\"\ninertia = \"consistent\"",
                "\"consistent\" inertia belongs to the variational beam",
            ),
            (
                "interpolation = \"gibbs\"",
                "the variational beam interpolates by rotation vectors",
            ),
        ] {
            let shown = match blade(keys) {
                Err(shown) => shown,
                Ok(_) => panic!("accepted: {keys}"),
            };
            assert!(shown.contains(expected), "{expected} is not in\n{shown}");
        }
    }
}
