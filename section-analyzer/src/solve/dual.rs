//! Dual states, which give the changes of the central solutions for all changes of the
//! section at once.
//!
//! The change of the forces on the face due to a change of the section is required as work
//! on the warping, `Z = X' dPh`. For any state e = (V; x; y), of rate V, warping x and
//! generalized strain y, with the forces P on the face, Q within, theta as resultant, and a
//! change dG of the matrices that changes the central state w = (X T'; X; Y),
//!
//! ```text
//! V' dPh + x' dPh T' = e' dG w + P' dX T' + Q' dX + theta' dY                     (S-115)
//! ```
//!
//! States without resultant whose forces cancel the other terms make Z an integral of known
//! fields, `Z = sum e_m' dG w c_m`, the same for every change. With k = 0 there are two, as
//! T' T' = 0:
//!
//! ```text
//! e1:  V = X        Q = 0       c = I
//! e2:  V = x1       Q = P1      c = -T'                                           (S-116)
//! ```
//!
//! With curvature, `T' = k' + N`: k' turns forces and moments, N gives the moments of
//! forces. Let `p_0`, `p_+`, `p_-` project on v0, v, v* (S-74), with the eigenvalues 0, i
//! w, -i w. The states of an eigenvalue -i w are solved by the system of waves
//! `exp(i w x)`, the states of i w are their conjugates:
//!
//! ```text
//! e1(0):   V = X             Q = 0                 c = p_0
//! e1(-):   V = X + i w x     Q = i w P             c = p_-                        (S-117)
//! e2(0-):  V = x1(0) + i w x  Q = P1(0) + i w P    c = -(p_0 N p_- + p_- N p_0)
//! e2(-):   V = x1(-) + i w x  Q = P1(-) + i w P    c = -p_- N p_-
//! ```
//!
//! e2 of a pair of eigenvalues is the divided difference of e1, hence the same for both
//! orders of the pair, but solved directly, as differences lose their digits when w is
//! small. `p_0 N p_0` and `p_+ N p_-` are zero.
//!
//! # References
//! - [Borri1992]: central solutions of beams with initial curvature, whose duals these are.

use std::ops::Range;

use super::columns::{CentralSystems, Wave};
use super::decouple::Decoupled;
use super::system::CentralSystem;
use crate::assembly::{Domain, Rate, SectionForces, State, largest};
use nalgebra::{Complex, DMatrix, Matrix3, Matrix6, Matrix6xX, Vector3};

/// Maximum number of corrections; the first gives the state.
const CORRECTIONS: usize = 6;

/// Size of a correction, relative to the state, after which the next would be below
/// round-off.
const SMALL_CORRECTION: f64 = 1e-8;

/// Size of a correction, relative to the state, below which the forces are not updated.
const NO_CORRECTION: f64 = 1e-11;

/// Relative error of a solution that does not affect the derivatives.
const GOOD_SOLUTION: f64 = 1e-11;

/// A dual state, and its weight in Z.
#[derive(Debug, Clone)]
pub struct DualState {
    /// The cases whose rows of Z are required; the others are not solved.
    pub columns: Range<usize>,
    /// V: rate, n x 6, in the units of the domain \[-\].
    pub rate: DMatrix<f64>,
    /// x: warping, n x 6, in the units of the domain \[-\].
    pub x: DMatrix<f64>,
    /// y: generalized strain, in the units of the domain \[-\].
    pub y: Matrix6<f64>,
    /// c: `Z = sum e' dG w c`, in the units of the domain \[-\].
    pub weight: Matrix6<f64>,
}

/// The dual states of a section.
#[derive(Debug, Clone)]
pub struct DualStates {
    /// Two of a straight beam, seven of a curved one.
    pub states: Vec<DualState>,
}

impl DualStates {
    /// Finds the dual states of the central solutions with their factored systems; `None`
    /// if memory is insufficient.
    pub fn solve(domain: &Domain, systems: &CentralSystems, central: &Decoupled) -> Option<Self> {
        let states = match &systems.wave {
            None => straight(domain, systems, central)?,
            Some(wave) => curved(domain, systems, wave, central)?,
        };
        Some(Self { states })
    }
}

/// (S-116).
fn straight(
    domain: &Domain,
    systems: &CentralSystems,
    central: &Decoupled,
) -> Option<Vec<DualState>> {
    let system = systems.steady();
    let goal = Goal::with_face(central);
    let first = Steady::find(domain, system, (&central.x, None), 0..6, goal)?;
    // of `e2' dG w T'` the rows that T Z and Z T' have: T' T' = 0, and T' gives moments of
    // forces, no torsion if the line is normal to the section
    let along = domain.line.equilibrium();
    let moments = if along.row(3).amax() == 0.0 { 4 } else { 3 };
    let source = (&first.x, Some(&first.face));
    let second = Steady::find(domain, system, source, moments..6, goal.without_face())?;
    Some(vec![
        DualState {
            columns: 0..6,
            rate: central.x.clone(),
            x: first.x.clone(),
            y: first.y,
            weight: Matrix6::identity(),
        },
        DualState {
            columns: moments..6,
            rate: first.x,
            x: second.x,
            y: second.y,
            weight: -along,
        },
    ])
}

/// (S-117); the conjugates are included as twice the real part.
fn curved(
    domain: &Domain,
    systems: &CentralSystems,
    wave: &Wave,
    central: &Decoupled,
) -> Option<Vec<DualState>> {
    let Weights { steady, turning } = Weights::of(domain, wave);
    let nothing = &DMatrix::zeros(central.x.nrows(), 6);
    let goal = Goal::with_face(central);
    let first = Steady::find(domain, systems.steady(), (&central.x, None), 0..6, goal)?;
    let turned = Turning::find(domain, wave, [&central.x, nothing], [nothing; 2], goal)?;
    let goal = goal.without_face();
    let source = [&first.face, nothing];
    let mixed = Turning::find(domain, wave, [&first.x, nothing], source, goal)?;
    let [x, y] = &turned.x;
    let [p, q] = &turned.face;
    let second = Turning::find(domain, wave, [x, y], [p, q], goal)?;
    let mut states = vec![DualState {
        columns: 0..6,
        rate: central.x.clone(),
        x: first.x,
        y: first.y,
        weight: steady,
    }];
    for (state, weight) in [turned, mixed, second].into_iter().zip(turning) {
        states.extend(state.parts(&weight));
    }
    Some(states)
}

/// The weights c of (S-117): of e1(0), and of e1(-), e2(0-), e2(-).
struct Weights {
    steady: Matrix6<f64>,
    turning: [Matrix6<Complex<f64>>; 3],
}

impl Weights {
    fn of(domain: &Domain, wave: &Wave) -> Self {
        let twice = |p: &Matrix3<Complex<f64>>| {
            let mut both = Matrix6::zeros();
            both.fixed_view_mut::<3, 3>(0, 0).copy_from(p);
            both.fixed_view_mut::<3, 3>(3, 3).copy_from(p);
            both
        };
        let axis = wave.axis.map(Complex::from);
        let back: Vector3<Complex<f64>> = wave.turning.conjugate();
        let steady = twice(&(axis * axis.transpose()));
        let turning = twice(&(back * back.adjoint()));
        let mut moments: Matrix6<f64> = Matrix6::zeros();
        let along = domain.line.equilibrium();
        let block = along.fixed_view::<3, 3>(3, 0);
        moments.fixed_view_mut::<3, 3>(3, 0).copy_from(&block);
        let n = moments.map(Complex::from);
        Self {
            steady: steady.map(|entry| entry.re),
            turning: [
                turning,
                -(steady * n * turning + turning * n * steady),
                -(turning * n * turning),
            ],
        }
    }
}

/// A state of the factored steady system without resultant.
struct Steady {
    x: DMatrix<f64>,
    y: Matrix6<f64>,
    /// P, n x 6.
    face: DMatrix<f64>,
}

impl Steady {
    /// The state of given rate, with given forces Q within, in the columns `columns`.
    fn find(
        domain: &Domain,
        system: &CentralSystem<f64>,
        (rate, within): (&DMatrix<f64>, Option<&DMatrix<f64>>),
        columns: Range<usize>,
        goal: Goal,
    ) -> Option<Self> {
        let n = domain.unknowns();
        let (mut x, mut y) = (DMatrix::zeros(n, 6), Matrix6::zeros());
        let mut forces = SectionForces::none(domain);
        let mut refinement = Refinement::to(goal);
        loop {
            let state = State {
                rate: Rate::Given(rate),
                warping: Some(&x),
                strain: &y,
            };
            forces.measure(domain, state);
            if refinement.is_done() {
                break;
            }
            forces.within.neg_mut();
            if let Some(within) = within {
                forces.within += within;
            }
            let missing = -forces.resultant.columns(columns.start, columns.len());
            let mut dy: Matrix6xX<f64> = missing.into_owned();
            let dq = &mut forces.within.as_mut_slice()[n * columns.start..n * columns.end];
            system.correct(dq, &mut dy)?;
            let dx = forces.within.columns(columns.start, columns.len());
            let mut x_of = x.columns_mut(columns.start, columns.len());
            x_of += &dx;
            let mut y_of = y.columns_mut(columns.start, columns.len());
            y_of += &dy;
            let change = largest(dx.amax(), dy.amax());
            if refinement.is_exact(change, largest(x.amax(), y.amax())) {
                break;
            }
        }
        Some(Self {
            x,
            y,
            face: forces.face,
        })
    }
}

/// A state of the factored system of waves without resultant: real and imaginary part.
struct Turning {
    /// V, n x 6.
    rate: [DMatrix<f64>; 2],
    x: [DMatrix<f64>; 2],
    y: [Matrix6<f64>; 2],
    /// P, n x 6.
    face: [DMatrix<f64>; 2],
}

impl Turning {
    /// The state of rate `V = rate + i w x`, with the forces `Q = within + i w P` within.
    fn find(
        domain: &Domain,
        wave: &Wave,
        rate: [&DMatrix<f64>; 2],
        within: [&DMatrix<f64>; 2],
        goal: Goal,
    ) -> Option<Self> {
        let w = domain.line.curvature.norm();
        let n = domain.unknowns();
        let mut x = [DMatrix::zeros(n, 6), DMatrix::zeros(n, 6)];
        let mut y = [Matrix6::zeros(); 2];
        let mut forces = [SectionForces::none(domain), SectionForces::none(domain)];
        let mut refinement = Refinement::to(goal);
        let rate = loop {
            let turned = [rate[0] - w * &x[1], rate[1] + w * &x[0]];
            for part in 0..2 {
                let state = State {
                    rate: Rate::Given(&turned[part]),
                    warping: Some(&x[part]),
                    strain: &y[part],
                };
                forces[part].measure(domain, state);
            }
            if refinement.is_done() {
                break turned;
            }
            let [re, im] = &forces;
            let mut dq = DMatrix::from_fn(n, 6, |i, k| {
                let at = (i, k);
                let re_missing = within[0][at] - re.within[at] - w * im.face[at];
                let im_missing = within[1][at] - im.within[at] + w * re.face[at];
                Complex::new(re_missing, im_missing)
            });
            let mut dy = Matrix6xX::from_fn(6, |i, k| {
                -Complex::new(re.resultant[(i, k)], im.resultant[(i, k)])
            });
            wave.system.correct(dq.as_mut_slice(), &mut dy)?;
            let parts: [fn(Complex<f64>) -> f64; 2] = [|z| z.re, |z| z.im];
            for (part, of) in parts.into_iter().enumerate() {
                x[part] += dq.map(of);
                y[part] += dy.fixed_columns::<6>(0).map(of);
            }
            let change = largest(dq.camax(), dy.camax());
            let size = |x: &DMatrix<f64>, y: &Matrix6<f64>| largest(x.amax(), y.amax());
            let state = largest(size(&x[0], &y[0]), size(&x[1], &y[1]));
            if refinement.is_exact(change, state) {
                break [rate[0] - w * &x[1], rate[1] + w * &x[0]];
            }
        };
        Some(Self {
            rate,
            x,
            y,
            face: forces.map(|forces| forces.face),
        })
    }

    /// Twice the real part of the work on `weight`, as the work of two real states.
    fn parts(self, weight: &Matrix6<Complex<f64>>) -> [DualState; 2] {
        let [re, im] = [weight.map(|c| 2.0 * c.re), weight.map(|c| -2.0 * c.im)];
        let [rate, im_rate] = self.rate;
        let [x, im_x] = self.x;
        let [y, im_y] = self.y;
        let state = |rate, x, y, weight| DualState {
            columns: 0..6,
            rate,
            x,
            y,
            weight,
        };
        [state(rate, x, y, re), state(im_rate, im_x, im_y, im)]
    }
}

/// Required accuracy and results of a state.
#[derive(Debug, Clone, Copy)]
struct Goal {
    /// Whether a first solution is too inaccurate to be the state.
    is_refined: bool,
    /// Whether its forces on the face are required.
    wants_face: bool,
}

impl Goal {
    fn with_face(central: &Decoupled) -> Self {
        Self {
            is_refined: central.first_correction > GOOD_SOLUTION,
            wants_face: true,
        }
    }

    fn without_face(self) -> Self {
        Self {
            wants_face: false,
            ..self
        }
    }
}

/// Control of the corrections.
struct Refinement {
    goal: Goal,
    rounds: usize,
    last: f64,
    is_open: bool,
}

impl Refinement {
    fn to(goal: Goal) -> Self {
        Self {
            goal,
            rounds: 0,
            last: f64::INFINITY,
            is_open: true,
        }
    }

    /// Whether no further correction is required: the forces belong to the state.
    fn is_done(&self) -> bool {
        !self.is_open || self.rounds == CORRECTIONS
    }

    /// Records a correction; returns whether state and forces are final.
    fn is_exact(&mut self, change: f64, state: f64) -> bool {
        let size = if change == 0.0 { 0.0 } else { change / state };
        self.is_open = self.goal.is_refined && size > SMALL_CORRECTION && size <= self.last;
        self.last = size;
        self.rounds += 1;
        size <= NO_CORRECTION || !(self.is_open || self.goal.wants_face)
    }
}
