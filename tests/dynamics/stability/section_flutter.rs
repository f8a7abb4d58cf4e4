//! Classical flutter of a wing section on springs against the roots of its two equations.
//!
//! The section plunges by h and turns by theta about an elastic axis that is e behind the quarter chord; its
//! mass center is s behind the axis. With the lift at the angle of the three-quarter chord (Bisplinghoff,
//! Ashley, Halfman, Aeroelasticity, 1955, chapters 5 and 9),
//!
//! ```text
//! m (h'' - s theta'') + k_h h = L                  L = q S a (theta - (h' - (c/2 - e) theta')/U)
//! (I + m s^2) theta'' - m s h'' + k_t theta = L e
//! ```

use nalgebra::Matrix2;
use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::{Rng, SeedableRng};

use beam_dynamics::result::{BoundaryKind, StableSide};

use super::{analyzed, assert_boundaries, largest_growth};
use crate::effort::cases;

const DENSITY: f64 = 1.225;
const SLOPE: f64 = 5.7;
const CHORD: f64 = 0.4;
const SPAN: f64 = 2.0;
const MASS: f64 = 10.0;
const INERTIA: f64 = 0.3;

/// A section by e, s \[m\] and its stiffness \[N/m, N m\].
struct Wing {
    ahead: f64,
    behind: f64,
    stiffness: [f64; 2],
}

impl Wing {
    /// The largest growth of its four roots at a speed \[1/s\].
    fn growth(&self, speed: f64) -> f64 {
        let coupling = -MASS * self.behind;
        let inertia = INERTIA + MASS * self.behind.powi(2);
        let mass = Matrix2::new(MASS, coupling, coupling, inertia);
        let lift = 0.5 * DENSITY * speed * speed * SPAN * CHORD * SLOPE;
        let [h, theta] = self.stiffness;
        // Forces on the right by (h, theta) and by their rates.
        let arms = nalgebra::Vector2::new(1.0, self.ahead);
        let by_motion = arms * nalgebra::RowVector2::new(0.0, lift);
        let rates = nalgebra::RowVector2::new(-1.0, 0.5 * CHORD - self.ahead) * (lift / speed);
        let stiffness = Matrix2::new(h, 0.0, 0.0, theta) - by_motion;
        largest_growth([mass, -(arms * rates), stiffness])
    }

    /// The speed of divergence \[m/s\].
    fn divergence(&self) -> f64 {
        let area = SPAN * CHORD;
        (2.0 * self.stiffness[1] / (DENSITY * area * SLOPE * self.ahead)).sqrt()
    }

    /// The lowest speed of flutter below 0.9 of divergence, by bisection to round-off.
    fn flutter(&self) -> Option<f64> {
        let end = 0.9 * self.divergence();
        let speeds = (1..=200).map(|k| end * f64::from(k) / 200.0);
        let mut high = speeds.into_iter().find(|speed| self.growth(*speed) > 0.0)?;
        let mut low = high - end / 200.0;
        if low <= 0.0 || self.growth(low) > 0.0 {
            return None;
        }
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            match self.growth(middle) > 0.0 {
                true => high = middle,
                false => low = middle,
            }
        }
        Some(low)
    }

    fn cards(&self, [from, to]: [f64; 2]) -> String {
        let Self {
            ahead,
            behind,
            stiffness: [h, theta],
        } = self;
        let end = 0.5 * SPAN;
        format!(
            "[parameters]\nwind = {from:?}\n[air]\ndensity = {DENSITY}\nwind = [\"= wind\", 0, 0]\n\
             [airfoils.wing]\nslope = {SLOPE}\n\
             [[node]]\nname = \"wing\"\nposition = [0, 0, 0]\n\
             [[body]]\nname = \"wing\"\nnode = \"wing\"\nmass = {MASS}\noffset = [{behind:?}, 0, 0]\n\
             inertia = [1, 1, {INERTIA}]\n\
             [[joint]]\nkind = \"in-line\"\nnodes = [\"wing\"]\naxis = [0, 1, 0]\n\
             [[joint]]\nkind = \"plane-rotation\"\nnodes = [\"wing\"]\naxis = [0, 0, 1]\n\
             [[spring]]\nname = \"springs\"\nnode = \"wing\"\nstiffness = [0, {h:?}, 0]\n\
             rotational_stiffness = [0, 0, {theta:?}]\n\
             [[strip]]\nname = \"air\"\nnode = \"wing\"\nsection = \"quasi_steady\"\nstrips = 1\n\
             from = [-{ahead:?}, 0, -{end:?}]\nto = [-{ahead:?}, 0, {end:?}]\nforward = [-1, 0, 0]\n\
             stations = [{{ at = 0, chord = {CHORD}, airfoil = \"wing\" }},\n\
             {{ at = {SPAN}, chord = {CHORD}, airfoil = \"wing\" }}]\n\
             [modes]\nspeeds = [0]\ncount = 2\n\
             [stability]\nparameter = \"wind\"\nfrom = {from:?}\nto = {to:?}\nsteps = 8\ntolerance = 1e-9\n"
        )
    }
}

// The speed of flutter of random sections. Growth below the residual of an eigenvector, at most 1e-7 of
// the distance of its value from the shift, counts as zero (D-340): 3e-6 1/s here. It rises by 0.03 1/s or more
// per m/s, so that the speed, of 3 m/s or more, is found to 3e-5 of it.
#[test]
fn flutter_of_a_section_has_its_closed_form() {
    let mut random = Pcg64Mcg::seed_from_u64(31);
    let mut between = |low: f64, high: f64| {
        low + (high - low) * (random.next_u64() >> 11) as f64 * 0.5_f64.powi(53)
    };
    let mut found = 0;
    while found < cases(30) {
        let frequencies = [between(8.0, 15.0), between(16.0, 40.0)];
        let wing = Wing {
            ahead: between(0.03, 0.1),
            behind: between(0.02, 0.12),
            stiffness: [
                MASS * frequencies[0].powi(2),
                INERTIA * frequencies[1].powi(2),
            ],
        };
        let Some(speed) = wing.flutter().filter(|speed| *speed > 3.0) else {
            continue;
        };
        let to = (1.2 * speed).min(0.95 * wing.divergence());
        if wing.growth(to) <= 0.0 {
            continue;
        }
        let result = analyzed(&wing.cards([0.6 * speed, to]));
        let expected = [(speed, BoundaryKind::Flutter, StableSide::Below)];
        assert_boundaries(&result, &expected, 3e-5 * speed);
        found += 1;
    }
}
