//! Evaluation of a program.

use super::functions::{Function, Operation};
use super::{Expression, Jet};

/// Most numbers that a program holds at a time.
pub(super) const STACK: usize = 32;

/// Doublings of the bracket of a corner: its round-off may be up to 2^24 times the round-off
/// of a number if large numbers cancel in its argument.
const DOUBLINGS: usize = 24;

/// Enough bisections from there to neighboring numbers.
const HALVINGS: usize = 80;

impl Expression {
    /// The value; `variable` returns the variables by number.
    pub fn at(&self, variable: impl Fn(usize) -> Jet) -> Jet {
        self.run(variable, |_, _| {})
    }

    /// The first time after `now` at which a part that is not smooth changes its piece,
    /// with a corner or a jump. Infinite if there is none. The variables are given by
    /// number and time, with derivatives by time. It is found for parts whose argument is
    /// piecewise linear, as in `abs(t - 2)`, and to the last bit: just before it the part
    /// is on the previous piece.
    pub fn next_corner(&self, now: f64, variable: impl Fn(usize, f64) -> Jet) -> f64 {
        let mut next = f64::INFINITY;
        let mut number = 0;
        self.run(
            |index| variable(index, now),
            |function, args| {
                number += 1;
                let Some(ahead) = function.ahead(args).filter(|ahead| *ahead >= 0.0) else {
                    return;
                };
                let position = now + ahead;
                let width = f64::EPSILON * now.abs().max(ahead);
                if position - width >= next || position.is_infinite() {
                    return;
                }
                let is_behind = |time| {
                    let piece = self.piece(number, |index| variable(index, time));
                    piece != function.piece(args)
                };
                let position = match bracket(now, position, width, &is_behind) {
                    Some(ends) => first_behind(ends, &is_behind),
                    // The current corner, found again within round-off.
                    None if ahead <= 4.0 * width => return,
                    None => position,
                };
                next = next.min(position);
            },
        );
        next
    }

    /// The piece of the function with that number in the program, from one.
    fn piece(&self, number: usize, variable: impl Fn(usize) -> Jet) -> Option<f64> {
        let (mut passed, mut piece) = (0, None);
        self.run(variable, |function, args| {
            passed += 1;
            if passed == number {
                piece = function.piece(args);
            }
        });
        piece
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

/// Two times about `position`, not before `now`, of which only the second is after a corner;
/// `position` is known to some times `width`.
fn bracket(
    now: f64,
    position: f64,
    mut width: f64,
    is_behind: &impl Fn(f64) -> bool,
) -> Option<[f64; 2]> {
    let from = is_behind(position);
    for _ in 0..DOUBLINGS {
        let end = if from {
            (position - width).max(now)
        } else {
            position + width
        };
        if is_behind(end) != from {
            return Some(if from {
                [end, position]
            } else {
                [position, end]
            });
        }
        width *= 2.0;
    }
    None
}

/// The first time after a corner, by bisection.
fn first_behind([mut before, mut behind]: [f64; 2], is_behind: &impl Fn(f64) -> bool) -> f64 {
    for _ in 0..HALVINGS {
        let middle = 0.5 * (before + behind);
        if middle <= before || middle >= behind {
            break;
        }
        if is_behind(middle) {
            behind = middle
        } else {
            before = middle
        }
    }
    behind
}
