//! A row of engineering properties (`BEAMTYPE` 0 and 1) and its 6x6 matrices.
//!
//! The axes of the table are X along the chord, to the trailing edge, and Y across it: in the
//! file of the NREL 5 MW in QBlade's documentation `EIx` is the flap and `EIy` the edge
//! stiffness. QBlade's export of sections puts the half chord at 0.5 less the part of the thread
//! axis, and the converter of WEIS puts BeamDyn's y into X. A row is then a classic row of HAWC2
//! with x = -X, in meters:
//!
//! ```text
//! EA, EIx, EIy at the elastic center   KSX GA, KSY GA, GJ at the shear center
//! m (RGX c)^2, m (RGY c)^2 about the elastic center
//! ```
//!
//! The public description does not define the sign of Y and of `STRPIT`: rows with one of them
//! are refused. Euler beams (`BEAMTYPE` 0) have no shear strain: their shear stiffness is the
//! substitute of [`crate::blade::rigid_force`].

use nalgebra::{Matrix6, Vector2};

use crate::blade::rigid_force;
use crate::exchange::frame::Convention;
use crate::exchange::hawc2::{Classic, Inertia, PrincipalAxes};

/// Engineering properties of a row.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Properties {
    /// Mass per length [kg/m].
    pub mass: f64,
    /// Bending stiffness about X and Y: flap, edge [N m^2].
    pub bending: [f64; 2],
    /// Axial stiffness [N].
    pub axial: f64,
    /// Torsional stiffness [N m^2].
    pub torsion: f64,
    /// Shear stiffness along X and Y; `None` for Euler beams [N].
    pub shear: Option<[f64; 2]>,
    /// Radii of gyration about X and Y, as parts of the chord [-].
    pub radii: [f64; 2],
    /// X of the centers of mass, elasticity and shear, as parts of the chord [-].
    pub centers: [f64; 3],
}

/// Stiffness and mass in Helicoid's axes about the line, of a section with a `chord` [m] of a
/// blade of a `length` [m]; and whether a radius of gyration is too small for the distance of
/// mass and elastic center.
pub(super) fn matrices(
    of: &Properties,
    chord: f64,
    length: f64,
) -> (Matrix6<f64>, Matrix6<f64>, bool) {
    let at = |part: f64| Vector2::new(-part * chord, 0.0);
    let [mass_center, elastic, shear_center] = of.centers.map(at);
    let axes = PrincipalAxes {
        elastic,
        pitch: 0.0,
    };
    let [flap, edge] = of.bending;
    let bending = Matrix6::from_diagonal(&[0.0, 0.0, 0.0, 0.0, flap, edge].into());
    let rigid = rigid_force(&bending, length);
    let classic = Classic {
        axial: of.axial,
        bending: of.bending.into(),
        torsion: of.torsion,
        shear: of.shear.unwrap_or([rigid; 2]).into(),
        shear_center,
    };
    let inertia = Inertia {
        mass: of.mass,
        center: mass_center,
        radii: Vector2::from(of.radii) * chord,
    };
    let (mass, is_small) = inertia.matrix(axes);
    let convention = Convention::Hawc2;
    let stiffness = convention.to_ours(&classic.matrix(axes));
    (stiffness, convention.to_ours(&mass), is_small)
}

/// Remark on radii of gyration that are too small at some of all stations.
pub(super) fn small_radii(count: usize, all: usize) -> Option<String> {
    (count > 0).then(|| {
        format!(
            "radii of gyration (RGX, RGY) are about the elastic center; at {count} of {all} \
             stations one is smaller than the distance of mass and elastic center: the moment \
             about the mass center is zero there"
        )
    })
}
