//! Evaluation of a program.

use super::functions::{Function, Operation};
use super::{Expression, Jet};

/// Numbers that a program holds at a time, at most.
pub(super) const STACK: usize = 32;

/// The round-off of a corner is found up to 2^24 of that of a number, as that of an
/// argument is in which large numbers cancel.
const DOUBLINGS: usize = 24;

/// Enough to come from there to neighboring numbers.
const HALVINGS: usize = 80;

impl Expression {
    /// The value with the variables that `variable` gives by number.
    pub fn at(&self, variable: impl Fn(usize) -> Jet) -> Jet {
        self.run(variable, |_, _| {})
    }

    /// The first time after `now` behind which a part that is not smooth is on another of
    /// its pieces: there it has a corner or a jump. Infinite when there is none. The
    /// variables are given by number and time, with derivatives by time. It is found for
    /// parts whose argument is made of straight pieces, as in `abs(t - 2)`, and to the last
    /// bit: at the time before it the part is on the piece before.
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
                let place = now + ahead;
                let width = f64::EPSILON * now.abs().max(ahead);
                if place - width >= next || place.is_infinite() {
                    return;
                }
                let is_behind = |time| {
                    let piece = self.piece(number, |index| variable(index, time));
                    piece != function.piece(args)
                };
                let place = match bracket(now, place, width, &is_behind) {
                    Some(ends) => first_behind(ends, &is_behind),
                    // A corner at which one stands comes back within round-off.
                    None if ahead <= 4.0 * width => return,
                    None => place,
                };
                next = next.min(place);
            },
        );
        next
    }

    /// On which of its pieces the function with that number in the program is, from one.
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

/// Two times about `place`, not before `now`, of which the second alone is behind a
/// corner; `place` is known to some times `width`.
fn bracket(
    now: f64,
    place: f64,
    mut width: f64,
    is_behind: &impl Fn(f64) -> bool,
) -> Option<[f64; 2]> {
    let from = is_behind(place);
    for _ in 0..DOUBLINGS {
        let end = match from {
            true => (place - width).max(now),
            false => place + width,
        };
        if is_behind(end) != from {
            return Some(if from { [end, place] } else { [place, end] });
        }
        width *= 2.0;
    }
    None
}

/// The first time behind a corner, by bisection.
fn first_behind([mut before, mut behind]: [f64; 2], is_behind: &impl Fn(f64) -> bool) -> f64 {
    for _ in 0..HALVINGS {
        let middle = 0.5 * (before + behind);
        if middle <= before || middle >= behind {
            break;
        }
        match is_behind(middle) {
            true => behind = middle,
            false => before = middle,
        }
    }
    behind
}
