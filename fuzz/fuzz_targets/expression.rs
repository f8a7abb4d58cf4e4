//! Expressions: accepted ones have a value, maybe not a number, and corners ahead only.
#![no_main]

use libfuzzer_sys::fuzz_target;
use shared_geom::expression::{Expression, Jet, Names};

fuzz_target!(|text: &str| {
    let constants = [("p".to_owned(), 2.0)];
    let names = Names {
        variables: &["t", "x"],
        constants: &constants,
    };
    match Expression::parse(text, &names) {
        Ok(expression) => {
            for value in [-1.0, 0.0, 0.5, 1e300] {
                let _ = expression.at(|_| Jet {
                    value,
                    first: 1.0,
                    second: 0.0,
                });
            }
        }
        Err(problem) => assert!(!problem.to_string().is_empty()),
    }
});
