//! **The contract**: section properties, and their file, the interface of the two
//! programs.
//!
//! Components are ordered as in [`crate::wrench::COMPONENTS`]: axial, shear y,
//! shear z, torsion, bending y, bending z; all of them at the reference point and
//! in the section axes (x along the beam, y and z in the section). SI units.

use nalgebra::{DMatrix, Matrix3, Matrix4, Matrix6, Vector2, Vector3, Vector6};
use serde::{Deserialize, Serialize};

use crate::wrench;
use prestress::strains_of_turned;

mod centers;
mod check;
mod curvature;
mod engineering;
pub(crate) mod file;
mod history;
pub(crate) mod json;
mod prestress;

pub use check::{PropertyProblem, least_eigenvalue, mass_problems};
pub(crate) use check::{matrix_problems, unusable};
pub use curvature::{Agreement, CurvatureMismatch};
pub use engineering::Engineering;
pub use file::{VERSION, parse, read, write};
pub use history::{Change, Step};
pub use prestress::{
    CubicTable, PRESTRESS_COMPONENTS, Prestress, StrainMeasure, among_six, prestress_part,
    strains_of_moved,
};

/// Properties of a cross-section for a beam.
#[derive(Debug, Clone, PartialEq)]
pub struct SectionProperties {
    /// Name, for messages and tables.
    pub name: String,
    /// The reference point (y, z) in the coordinates of the section's mesh [m].
    pub reference_point: Vector2<f64>,
    /// Stiffness, 6x6 symmetric positive definite, internal force per generalized
    /// strain [N, N m, N m^2].
    pub stiffness: Matrix6<f64>,
    /// Mass per length, 6x6 symmetric, momentum per velocity and angular
    /// velocity [kg/m, kg, kg m].
    pub mass: Matrix6<f64>,
    /// Tension, shear and mass centers.
    pub centers: Centers,
    /// Principal axes of bending and of inertia.
    pub principal_axes: PrincipalAxes,
    /// Initial curvature and twist of the beam for which the section was solved;
    /// `None` for a straight beam.
    pub initial_curvature: Option<InitialCurvature>,
    /// Piezoelectric coupling; `None` without electrodes.
    pub piezo: Option<Piezo>,
    /// Internal force per kelvin of a fully restrained section heated evenly, 6 components
    /// [N/K, N m/K]: `theta = K psi + thermal_force T`. `None` if it was not computed.
    pub thermal_force: Option<Vector6<f64>>,
    /// Named states of imposed strain: heat, cure and the like.
    pub imposed: Vec<ImposedState>,
    /// Internal damping; `None` without damping.
    pub damping: Option<Damping>,
    /// Effect of internal forces on the stiffness; `None` if it was not computed.
    pub prestress: Option<Prestress>,
    /// Origin of the numbers.
    pub provenance: Provenance,
}

/// Characteristic points (y, z), relative to the reference point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Centers {
    /// Point at which an axial force causes no bending [m].
    pub tension: Vector2<f64>,
    /// Point at which a shear force causes no twist [m].
    pub shear: Vector2<f64>,
    /// Center of mass [m].
    pub mass: Vector2<f64>,
}

/// Principal directions: angles from +y to the first principal axis, positive
/// about +x.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct PrincipalAxes {
    /// Angle of the bending axes at the tension center [rad].
    pub bending_angle: f64,
    /// Bending stiffness about the first and the second principal axis [N m^2].
    pub bending_stiffness: [f64; 2],
    /// Angle of the inertia axes at the mass center [rad].
    pub inertia_angle: f64,
    /// Moment of inertia per length about the first and the second axis [kg m].
    pub inertia: [f64; 2],
}

/// Constant curvature and twist of the undeformed beam, in section axes.
///
/// Both are derivatives by the parameter of the line, which is its arc length if the
/// slope is a unit vector; stiffness and mass are per unit of the same parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InitialCurvature {
    /// Twist about x, curvature about y and about z [1/m].
    pub curvature: Vector3<f64>,
    /// Slope of the reference line: (1, 0, 0) if it is normal to the section [-].
    pub slope: Vector3<f64>,
}

/// Coupling of the section with the voltages of its electrodes:
/// internal force `theta = K psi + coupling V`.
#[derive(Debug, Clone, PartialEq)]
pub struct Piezo {
    /// Names of the electrodes, in the order of the columns of `coupling`.
    pub electrodes: Vec<String>,
    /// 6 x electrodes [N/V, N m/V].
    pub coupling: DMatrix<f64>,
    /// Electrodes x electrodes, symmetric, charge per length per voltage [F/m].
    pub capacitance: DMatrix<f64>,
}

/// Effect of a state of imposed strain on the section:
/// `theta = K (psi - free_strain) = K psi + restrained_force`.
#[derive(Debug, Clone, PartialEq)]
pub struct ImposedState {
    /// Name, different from the other states'.
    pub name: String,
    /// Internal force at zero generalized strain, 6 components [N, N m].
    pub restrained_force: Vector6<f64>,
    /// Generalized strain at zero internal force, 6 components [-, 1/m].
    pub free_strain: Vector6<f64>,
    /// Change of the stiffness of the section without internal force, over the components
    /// [`PRESTRESS_COMPONENTS`], 4x4 symmetric [N, N m, N m^2]; `None` if it was not
    /// computed.
    pub stiffness_change: Option<Matrix4<f64>>,
}

/// Internal damping of the beam: internal force per rate of generalized strain.
#[expect(
    clippy::large_enum_variant,
    reason = "one a section; a plain value is simpler"
)]
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Damping {
    /// `D = time K`, with the time in [s].
    StiffnessProportional(f64),
    /// `D` as given, 6x6 symmetric positive semidefinite [N s, N m s, N m^2 s].
    Viscous(Matrix6<f64>),
}

/// Origin of the numbers; unknown by default.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Provenance {
    /// Name of the program.
    pub program: String,
    /// Version of the program.
    pub version: String,
    /// Hash of all inputs (`sha256:` and 64 hexadecimal digits), empty for
    /// properties written by hand.
    pub input_hash: String,
    /// Nodes of the mesh.
    pub nodes: usize,
    /// Cells of the mesh.
    pub cells: usize,
    /// Later changes of point and axes, in their order.
    pub history: Vec<Step>,
    /// Files of the sections of a blade, one for each of its stations, or none.
    pub sections: Vec<SectionFile>,
}

/// The file of the section of a station, from which its stresses can be recovered.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SectionFile {
    /// Its path from the folder of the blade file, with `/` between folders.
    pub file: String,
    /// Fingerprint of the file and its mesh.
    pub fingerprint: String,
}

impl SectionProperties {
    /// The same section about the reference point moved by `by` = (y, z) [m].
    ///
    /// Exact: `K' = U K U^T` with [`wrench::shift_matrix`] `U`, mass and viscous
    /// damping likewise, coupling, thermal and restrained forces by `U`, free strains by
    /// `U^-T`, the table of prestress and the changes of the stiffness by
    /// [`strains_of_moved`].
    pub fn shift(&self, by: Vector2<f64>) -> Self {
        let d = Vector3::new(0.0, by.x, by.y);
        let u = wrench::shift_matrix(&d);
        let mut moved = self.transform(|matrix| wrench::shift(matrix, &d), &u);
        moved.reference_point += by;
        moved.set_prestress(&strains_of_moved(by));
        for center in moved.centers.points() {
            *center -= by;
        }
        if let Some(initial) = &mut moved.initial_curvature {
            *initial = initial.shifted(by);
        }
        moved
    }

    /// The same section in axes turned by `angle` about +x [rad].
    ///
    /// Exact: with `Q` the new axes in the old ones, `K' = diag(Q,Q)^T K diag(Q,Q)`.
    pub fn rotate(&self, angle: f64) -> Self {
        let q = rotation_about_x(angle);
        let into = wrench::rotation_matrix(&q).transpose();
        let mut turned = self.transform(|matrix| wrench::rotate(matrix, &q), &into);
        let plane = q.fixed_view::<2, 2>(1, 1).transpose();
        turned.reference_point = plane * turned.reference_point;
        turned.set_prestress(&strains_of_turned(angle));
        for center in turned.centers.points() {
            *center = plane * *center;
        }
        let axes = &mut turned.principal_axes;
        axes.bending_angle = half_turn(axes.bending_angle - angle);
        axes.inertia_angle = half_turn(axes.inertia_angle - angle);
        if let Some(initial) = &mut turned.initial_curvature {
            *initial = initial.rotated(angle);
        }
        turned
    }

    /// Table and changes of the stiffness over the strains p' with `p = V p'`.
    fn set_prestress(&mut self, v: &Matrix4<f64>) {
        let congruent = |change: Matrix4<f64>| {
            let moved = v.transpose() * change * v;
            0.5 * (moved + moved.transpose())
        };
        self.prestress = self.prestress.map(|prestress| Prestress {
            third: prestress.third.transformed(v),
            per_kelvin: prestress.per_kelvin.map(congruent),
            ..prestress
        });
        for state in &mut self.imposed {
            state.stiffness_change = state.stiffness_change.map(congruent);
        }
    }

    /// Applies a congruence to the matrices and `force` to the force-like columns.
    fn transform(
        &self,
        congruence: impl Fn(&Matrix6<f64>) -> Matrix6<f64>,
        force: &Matrix6<f64>,
    ) -> Self {
        let mut result = self.clone();
        result.stiffness = congruence(&self.stiffness);
        result.mass = congruence(&self.mass);
        if let Some(Damping::Viscous(matrix)) = &mut result.damping {
            *matrix = congruence(matrix);
        }
        if let Some(piezo) = &mut result.piezo {
            let force = DMatrix::from_column_slice(6, 6, force.as_slice());
            piezo.coupling = force * &piezo.coupling;
        }
        result.thermal_force = self.thermal_force.map(|thermal| force * thermal);
        // Work is the same: psi' = U^-T psi for theta' = U theta.
        if let Some(strain) = force.transpose().try_inverse() {
            for state in &mut result.imposed {
                state.restrained_force = force * state.restrained_force;
                state.free_strain = strain * state.free_strain;
            }
        }
        result
    }
}

impl Centers {
    fn points(&mut self) -> [&mut Vector2<f64>; 3] {
        [&mut self.tension, &mut self.shear, &mut self.mass]
    }
}

/// Axes turned by `angle` about x, as columns [rad].
fn rotation_about_x(angle: f64) -> Matrix3<f64> {
    let (s, c) = angle.sin_cos();
    Matrix3::new(1.0, 0.0, 0.0, 0.0, c, -s, 0.0, s, c)
}

/// The direction of an axis as an angle in (-pi/2, pi/2] [rad].
pub fn half_turn(angle: f64) -> f64 {
    let turned = angle.rem_euclid(std::f64::consts::PI);
    if turned > std::f64::consts::FRAC_PI_2 {
        turned - std::f64::consts::PI
    } else {
        turned
    }
}

#[cfg(test)]
mod tests;
