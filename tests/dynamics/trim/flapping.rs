//! A rotor of rigid blades on central flap hinges, whose loads are the integrals of linear lift over
//! the radius, as expressions of flap angle and rate.
//!
//! With the radius, the moment of inertia about the hinge and the speed one, `m = mu sin psi`, `c = cos
//! beta` and `p = l c + mu sin beta cos psi`, sections have the velocities `U_T = r c + m` and `U_P = r
//! beta' + p`, and the thrust and the moment about the hinge are
//!
//! ```text
//! F = int ( theta U_T^2 - U_P U_T ) dr ,     M = int r ( theta U_T^2 - U_P U_T ) dr
//! ```
//!
//! times the Lock number over two for M, and solidity and slope over two for the thrust coefficient.

use std::f64::consts::TAU;

/// A rotor.
#[derive(Debug, Clone)]
pub struct Flapping {
    pub blades: usize,
    pub lock: f64,
    /// Solidity times lift slope.
    pub sigma_a: f64,
    /// Twist over the radius [rad].
    pub twist: f64,
    pub advance: f64,
    /// Total inflow; `None`: a state that follows the thrust.
    pub inflow: Option<f64>,
    /// Steps in a period.
    pub steps: usize,
}

impl Flapping {
    /// Nodes, bodies, joints, sensors, loads, with the controls `t0`, `t1c` and `t1s`, the thrust
    /// coefficient `ct`, and the flap angles `b1` and so on; and `[periodic]`.
    pub fn cards(&self) -> String {
        let mut text = format!(
            "[[node]]\nname = \"hub\"\nposition = [0, 0, 0]\nangular_velocity = [0, 0, 1]\n\
             [[body]]\nname = \"hub\"\nnode = \"hub\"\nmass = 1\ninertia = [1, 1, 1]\n\
             [[joint]]\nname = \"shaft\"\nkind = \"revolute\"\nnodes = [\"hub\"]\nat = [0, 0, 0]\n\
             axis = [0, 0, 1]\nangle = \"= t\"\n\
             [periodic]\nspeed = 1\nsteps = {}\n",
            self.steps
        );
        for k in 0..self.blades {
            text += &self.blade(k);
        }
        text + &self.air()
    }

    /// Azimuth of a blade, as an expression.
    fn azimuth(&self, k: usize) -> String {
        format!("(t + {:?})", TAU * k as f64 / self.blades as f64)
    }

    fn blade(&self, k: usize) -> String {
        let (sin, cos) = (TAU * k as f64 / self.blades as f64).sin_cos();
        let turn = TAU * k as f64 / self.blades as f64;
        let (i, axis) = (k + 1, format!("[{sin:?}, {:?}, 0]", -cos));
        // Mass 3, center at half the radius, moments about the hinge 0.001, 1, 1.001.
        format!(
            "[[node]]\nname = \"blade {i}\"\nposition = [{:?}, {:?}, 0]\n\
             orientation = [0, 0, {turn:?}]\nangular_velocity = [0, 0, 1]\n\
             velocity = [{:?}, {:?}, 0]\n\
             [[body]]\nname = \"blade {i}\"\nnode = \"blade {i}\"\nmass = 3\n\
             inertia = [0.001, 0.25, 0.251]\n\
             [[joint]]\nname = \"hinge {i}\"\nkind = \"revolute\"\nnodes = [\"hub\", \"blade {i}\"]\n\
             at = [0, 0, 0]\naxis = {axis}\n\
             [sensors.b{i}]\nquantity = \"joint_angle\"\nof = \"hinge {i}\"\nunit = \"rad\"\n\
             [sensors.b{i}_rate]\nquantity = \"angular_velocity\"\nof = \"blade {i}\"\n\
             against = \"hub\"\nin = \"blade {i}\"\ncomponent = \"y\"\nunit = \"rad/s\"\n\
             [[load]]\nname = \"lift {i}\"\nnode = \"blade {i}\"\nmoment = {axis}\n\
             follower = true\ndrive = \"= {:?}*({})\"\n",
            0.5 * cos,
            0.5 * sin,
            -0.5 * sin,
            0.5 * cos,
            0.5 * self.lock,
            self.sums(k)[1]
        )
    }

    /// F and M of a blade.
    fn sums(&self, k: usize) -> [String; 2] {
        let (i, twist, mu, psi) = (k + 1, self.twist, self.advance, self.azimuth(k));
        let theta = format!("(t0 + t1c*cos{psi} + t1s*sin{psi})");
        let c = format!("cos(b{i})");
        let m = format!("({mu:?}*sin{psi})");
        let p = format!("(l*{c} + {mu:?}*sin(b{i})*cos{psi})");
        // The sensor is about y of the blade, downward.
        let rate = format!("(-b{i}_rate)");
        [
            format!(
                "{theta}*({c}^2/3 + {c}*{m} + {m}^2) + {twist:?}*({c}^2/4 + 2*{c}*{m}/3 + {m}^2/2) \
                 - {rate}*({c}/3 + {m}/2) - {p}*({c}/2 + {m})"
            ),
            format!(
                "{theta}*({c}^2/4 + 2*{c}*{m}/3 + {m}^2/2) \
                 + {twist:?}*({c}^2/5 + {c}*{m}/2 + {m}^2/3) - {rate}*({c}/4 + {m}/3) \
                 - {p}*({c}/3 + {m}/2)"
            ),
        ]
    }

    /// Thrust coefficient and inflow.
    fn air(&self) -> String {
        let thrusts = (0..self.blades).map(|k| format!("cos(b{})*({})", k + 1, self.sums(k)[0]));
        let sum = thrusts.collect::<Vec<_>>().join(" + ");
        let factor = 0.5 * self.sigma_a / self.blades as f64;
        let mu = self.advance;
        let inflow = match self.inflow {
            Some(inflow) => format!("[parameters]\nl = {inflow:?}\n"),
            None => format!(
                "[[state_space]]\nname = \"inflow\"\noutputs = [\"l\"]\na = [[0]]\nb = [[1]]\n\
                 c = [[1]]\nstart = [0.03]\n\
                 inputs = [\"= 1.5*(ct - 2*l*sqrt({:?} + l^2))\"]\n",
                mu * mu
            ),
        };
        format!(
            "{inflow}[[state_space]]\nname = \"thrust\"\noutputs = [\"ct\"]\nd = [[1]]\n\
             inputs = [\"= {factor:?}*({sum})\"]\n"
        )
    }
}

/// The cards of the three controls, with their first guesses.
pub fn controls(guesses: [f64; 3]) -> String {
    let names = ["t0", "t1c", "t1s"].into_iter().zip(guesses);
    let card = |(name, guess)| {
        format!("[[trim.control]]\nname = \"{name}\"\nguess = {guess:?}\nscale = 0.1\n")
    };
    names.map(card).collect()
}

/// The card of a target.
pub fn target(name: &str, signal: &str, [value, scale]: [f64; 2]) -> String {
    format!(
        "[[trim.target]]\nname = \"{name}\"\nsignal = \"= {signal}\"\nvalue = {value:?}\n\
         scale = {scale:?}\n"
    )
}
