//! The steps of a program, and the functions that an expression may call.

use std::cmp::Ordering;

use super::Jet;

/// One step of a program.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Operation {
    /// Puts a number on the stack.
    Constant(f64),
    /// Puts a variable on the stack.
    Variable(usize),
    /// Replaces the last numbers by one.
    Apply(Function),
}

/// Operation on the last numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Function {
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
    Negative,
    Less,
    LessOrEqual,
    Greater,
    GreaterOrEqual,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Atan2,
    Sinh,
    Cosh,
    Tanh,
    Exp,
    Ln,
    Log10,
    Sqrt,
    Abs,
    Sign,
    Step,
    Floor,
    Mod,
    Min,
    Max,
    Hypot,
    If,
}

/// Names and numbers of arguments of the functions.
pub(super) const NAMED: [(&str, usize, Function); 23] = [
    ("sin", 1, Function::Sin),
    ("cos", 1, Function::Cos),
    ("tan", 1, Function::Tan),
    ("asin", 1, Function::Asin),
    ("acos", 1, Function::Acos),
    ("atan", 1, Function::Atan),
    ("atan2", 2, Function::Atan2),
    ("sinh", 1, Function::Sinh),
    ("cosh", 1, Function::Cosh),
    ("tanh", 1, Function::Tanh),
    ("exp", 1, Function::Exp),
    ("ln", 1, Function::Ln),
    ("log10", 1, Function::Log10),
    ("sqrt", 1, Function::Sqrt),
    ("abs", 1, Function::Abs),
    ("sign", 1, Function::Sign),
    ("step", 1, Function::Step),
    ("floor", 1, Function::Floor),
    ("mod", 2, Function::Mod),
    ("min", 2, Function::Min),
    ("max", 2, Function::Max),
    ("hypot", 2, Function::Hypot),
    ("if", 3, Function::If),
];

/// Names of the functions that an expression may call.
pub const FUNCTIONS: [&str; 23] = names();

const fn names() -> [&'static str; 23] {
    let mut names = [""; 23];
    let mut i = 0;
    while i < names.len() {
        names[i] = NAMED[i].0;
        i += 1;
    }
    names
}

impl Function {
    /// Number of arguments.
    pub fn arguments(self) -> usize {
        match self {
            Self::Add | Self::Subtract | Self::Multiply | Self::Divide | Self::Power => 2,
            Self::Less | Self::LessOrEqual | Self::Greater | Self::GreaterOrEqual => 2,
            Self::Negative => 1,
            _ => {
                let named = NAMED.iter().find(|named| named.2 == self);
                named.map_or(1, |named| named.1)
            }
        }
    }

    /// The number whose change of sign causes a corner or a jump.
    fn switch(self, args: &[Jet]) -> Option<Jet> {
        match (self, args) {
            (Self::Abs | Self::Sign | Self::Step, [a]) => Some(*a),
            (Self::If, [condition, ..]) => Some(*condition),
            (
                Self::Min
                | Self::Max
                | Self::Less
                | Self::LessOrEqual
                | Self::Greater
                | Self::GreaterOrEqual,
                [a, b],
            ) => Some(*a - *b),
            _ => None,
        }
    }

    /// The number that causes a jump when it passes a whole number.
    fn stair(self, args: &[Jet]) -> Option<Jet> {
        match (self, args) {
            (Self::Floor, [a]) => Some(*a),
            (Self::Mod, [a, b]) => Some(*a / *b),
            _ => None,
        }
    }

    /// The smooth piece that applies just after this time, if there are pieces.
    pub fn piece(self, args: &[Jet]) -> Option<f64> {
        let side = self
            .switch(args)
            .map(|jet| f64::from(jet.sign_after() as i8));
        side.or_else(|| self.stair(args).map(|jet| jet.value.floor()))
    }

    /// Distance to the end of its piece, if its argument is linear.
    pub fn ahead(self, args: &[Jet]) -> Option<f64> {
        let straight = |jet: &Jet| jet.second == 0.0;
        let zero = self.switch(args).filter(straight);
        let zero = zero.map(|jet| -jet.value / jet.first);
        zero.or_else(|| {
            let stair = self.stair(args).filter(straight)?;
            let end = if stair.first > 0.0 {
                stair.value.floor() + 1.0
            } else {
                stair.value.floor()
            };
            Some((end - stair.value) / stair.first)
        })
    }

    /// Its value; at a jump the value just after.
    pub fn at(self, args: &[Jet]) -> Jet {
        match *args {
            [a] => self.of_one(a),
            [a, b] => self.of_two(a, b),
            [condition, a, b] => {
                if condition.value != 0.0 {
                    a
                } else {
                    b
                }
            }
            _ => Jet::constant(f64::NAN),
        }
    }

    fn of_one(self, a: Jet) -> Jet {
        let x = a.value;
        match self {
            Self::Negative => -a,
            Self::Sin => a.chain(x.sin(), x.cos(), -x.sin()),
            Self::Cos => a.chain(x.cos(), -x.sin(), -x.cos()),
            Self::Tan => {
                let (tan, slope) = (x.tan(), 1.0 + x.tan() * x.tan());
                a.chain(tan, slope, 2.0 * tan * slope)
            }
            Self::Asin | Self::Acos => {
                let root = (1.0 - x * x).sqrt();
                let (slope, bend) = (1.0 / root, x / (root * root * root));
                match self {
                    Self::Asin => a.chain(x.asin(), slope, bend),
                    _ => a.chain(x.acos(), -slope, -bend),
                }
            }
            Self::Atan => {
                let slope = 1.0 / (1.0 + x * x);
                a.chain(x.atan(), slope, -2.0 * x * slope * slope)
            }
            Self::Sinh => a.chain(x.sinh(), x.cosh(), x.sinh()),
            Self::Cosh => a.chain(x.cosh(), x.sinh(), x.cosh()),
            Self::Tanh => {
                let tanh = x.tanh();
                let slope = 1.0 - tanh * tanh;
                a.chain(tanh, slope, -2.0 * tanh * slope)
            }
            Self::Exp => a.exp(),
            Self::Ln => a.ln(),
            Self::Log10 => a.ln() * Jet::constant(std::f64::consts::LOG10_E),
            Self::Sqrt => a.sqrt(),
            _ => a.stepped(self),
        }
    }

    fn of_two(self, a: Jet, b: Jet) -> Jet {
        let order = (a - b).sign_after();
        let flag = |holds: bool| Jet::constant(f64::from(u8::from(holds)));
        match self {
            Self::Add => a + b,
            Self::Subtract => a - b,
            Self::Multiply => a * b,
            Self::Divide => a / b,
            Self::Power => a.power(b),
            Self::Atan2 => a.atan2(b),
            Self::Hypot => {
                if a.value == 0.0 && b.value == 0.0 {
                    Jet::constant(0.0)
                } else {
                    (a * a + b * b).sqrt()
                }
            }
            Self::Mod => a - b * Jet::constant((a.value / b.value).floor()),
            Self::Min if order == Ordering::Greater => b,
            Self::Max if order == Ordering::Less => b,
            Self::Less => flag(order == Ordering::Less),
            Self::LessOrEqual => flag(order != Ordering::Greater),
            Self::Greater => flag(order == Ordering::Greater),
            Self::GreaterOrEqual => flag(order != Ordering::Less),
            _ => a,
        }
    }
}

impl Jet {
    /// Piecewise linear functions.
    fn stepped(self, function: Function) -> Jet {
        let side = self.sign_after();
        match function {
            Function::Abs if side == Ordering::Less => -self,
            Function::Sign => Jet::constant(f64::from(side as i8)),
            Function::Step => Jet::constant(f64::from(u8::from(side != Ordering::Less))),
            Function::Floor => Jet::constant(self.value.floor()),
            _ => self,
        }
    }
}
