//! Evaluation of a program.

use super::functions::{Function, Operation};
use super::{Expression, Jet};

/// Numbers that a program holds at a time, at most.
pub(super) const STACK: usize = 32;

impl Expression {
    /// The value with the variables that `variable` gives by number.
    pub fn at(&self, variable: impl Fn(usize) -> Jet) -> Jet {
        self.run(variable, |_, _| {})
    }

    /// The next value after `now` of the variable that the jets are derived by, at which
    /// a part that is not smooth has a corner or a jump; infinite when there is none. It
    /// is found for parts whose argument is made of straight pieces, as in `abs(t - 2)`.
    pub fn next_corner(&self, now: f64, variable: impl Fn(usize) -> Jet) -> f64 {
        let mut next = f64::INFINITY;
        self.run(variable, |function, args| {
            let straight = |jet: &Jet| jet.second == 0.0;
            let zero = function.switch(args).filter(straight);
            let zero = zero.map(|jet| -jet.value / jet.first);
            let stair = function.stair(args).filter(straight);
            let stair = stair.map(|jet| {
                let up = match jet.first > 0.0 {
                    true => jet.value.floor() + 1.0,
                    false => jet.value.ceil() - 1.0,
                };
                (up - jet.value) / jet.first
            });
            for ahead in zero.into_iter().chain(stair) {
                let place = now + ahead;
                // A corner at which one stands comes back within round-off.
                let rounding = 4.0 * f64::EPSILON * now.abs().max(ahead.abs());
                if ahead > rounding && place < next {
                    next = place;
                }
            }
        });
        next
    }

    fn run(&self, variable: impl Fn(usize) -> Jet, mut watch: impl FnMut(Function, &[Jet])) -> Jet {
        let mut stack = [Jet::default(); STACK];
        let mut height = 0;
        for operation in &self.program {
            let (taken, value) = match *operation {
                Operation::Constant(value) => (0, Jet::constant(value)),
                Operation::Variable(index) => (0, variable(index)),
                Operation::Apply(function) => {
                    let taken = function.arguments();
                    let args = &stack[height - taken..height];
                    watch(function, args);
                    (taken, function.at(args))
                }
            };
            height -= taken;
            stack[height] = value;
            height += 1;
        }
        stack[0]
    }
}
