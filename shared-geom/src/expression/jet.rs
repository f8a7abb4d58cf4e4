//! Numbers with their first and second derivative.
//!
//! For a function f of a number a that depends on t (Taylor arithmetic):
//!
//! ```text
//! (a b)'  = a' b + a b'            (a b)''  = a'' b + 2 a' b' + a b''
//! f(a)'   = f_a a'                 f(a)''   = f_aa a'^2 + f_a a''
//! ```

use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number with its derivatives by one variable.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Jet {
    /// The number [its unit].
    pub value: f64,
    /// Its first derivative [its unit/unit of the variable].
    pub first: f64,
    /// Its second derivative [its unit/unit of the variable^2].
    pub second: f64,
}

impl Jet {
    /// A constant number.
    pub fn constant(value: f64) -> Self {
        Self {
            value,
            first: 0.0,
            second: 0.0,
        }
    }

    /// The variable itself.
    pub fn variable(value: f64) -> Self {
        Self {
            value,
            first: 1.0,
            second: 0.0,
        }
    }

    /// A linear number with the slope `first`.
    pub fn line(value: f64, first: f64) -> Self {
        Self {
            value,
            first,
            second: 0.0,
        }
    }

    /// Whether number and derivatives are finite.
    pub fn is_finite(&self) -> bool {
        self.value.is_finite() && self.first.is_finite() && self.second.is_finite()
    }

    fn is_constant(&self) -> bool {
        self.first == 0.0 && self.second == 0.0
    }

    /// A function of it with the value `f`, the slope `f1` and the curvature `f2`.
    pub(super) fn chain(self, f: f64, f1: f64, f2: f64) -> Self {
        if self.is_constant() {
            // Even if the function has no slope.
            return Self::constant(f);
        }
        Self {
            value: f,
            first: f1 * self.first,
            second: f2 * self.first * self.first + f1 * self.second,
        }
    }

    /// Sign just after now: a number that leaves zero has the sign of its change.
    pub(super) fn sign_after(self) -> Ordering {
        let parts = [self.value, self.first, self.second];
        let first = parts.into_iter().find(|part| *part != 0.0).unwrap_or(0.0);
        first.partial_cmp(&0.0).unwrap_or(Ordering::Equal)
    }

    /// One of two powers: `self^exponent`.
    pub(super) fn power(self, exponent: Self) -> Self {
        if !exponent.is_constant() {
            return if self.value == 0.0 && self.is_constant() {
                Self::constant(0.0_f64.powf(exponent.value))
            } else {
                (exponent * self.ln()).exp()
            };
        }
        let (a, n) = (self.value, exponent.value);
        // A factor of zero makes a derivative zero, even if the power is infinite.
        let term = |factor: f64, power: f64| {
            if factor == 0.0 {
                0.0
            } else {
                factor * a.powf(power)
            }
        };
        self.chain(a.powf(n), term(n, n - 1.0), term(n * (n - 1.0), n - 2.0))
    }

    pub(super) fn exp(self) -> Self {
        let e = self.value.exp();
        self.chain(e, e, e)
    }

    pub(super) fn ln(self) -> Self {
        let a = self.value;
        self.chain(a.ln(), 1.0 / a, -1.0 / (a * a))
    }

    pub(super) fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.chain(root, 0.5 / root, -0.25 / (root * self.value))
    }

    /// The angle of the point (x, self) from the axis x.
    pub(super) fn atan2(self, x: Self) -> Self {
        let y = self;
        let square = x.value * x.value + y.value * y.value;
        let turned = x.value * y.first - y.value * x.first;
        let grown = 2.0 * (x.value * x.first + y.value * y.first);
        let bent = x.value * y.second - y.value * x.second;
        if x.is_constant() && y.is_constant() {
            return Self::constant(y.value.atan2(x.value));
        }
        Self {
            value: y.value.atan2(x.value),
            first: turned / square,
            second: bent / square - turned * grown / (square * square),
        }
    }
}

impl Add for Jet {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            value: self.value + other.value,
            first: self.first + other.first,
            second: self.second + other.second,
        }
    }
}

impl Neg for Jet {
    type Output = Self;

    fn neg(self) -> Self {
        Self {
            value: -self.value,
            first: -self.first,
            second: -self.second,
        }
    }
}

impl Sub for Jet {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Jet {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self {
            value: self.value * other.value,
            first: self.first * other.value + self.value * other.first,
            second: self.second * other.value
                + 2.0 * self.first * other.first
                + self.value * other.second,
        }
    }
}

impl Div for Jet {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        // From q b = a: q' = (a' - q b')/b, q'' = (a'' - 2 q' b' - q b'')/b.
        let b = other.value;
        let value = self.value / b;
        if self.is_constant() && other.is_constant() {
            return Self::constant(value);
        }
        let first = (self.first - value * other.first) / b;
        let second = (self.second - 2.0 * first * other.first - value * other.second) / b;
        Self {
            value,
            first,
            second,
        }
    }
}
