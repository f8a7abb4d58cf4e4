//! Tests of expressions: meaning, derivatives, and error messages.

use approx::assert_relative_eq;

use super::{Expression, ExpressionProblem, FUNCTIONS, Jet, Names};
use crate::error::Explain;

fn parse(text: &str) -> Result<Expression, ExpressionProblem> {
    let constants = [("half".to_owned(), 0.5), ("length".to_owned(), 3.0)];
    let names = Names {
        variables: &["t", "speed"],
        constants: &constants,
    };
    Expression::parse(text, &names)
}

/// Value and derivatives by t at `t`, with the speed 2.
fn at(text: &str, t: f64) -> Jet {
    let variable = |index: usize| match index {
        0 => Jet::variable(t),
        _ => Jet::constant(2.0),
    };
    parse(text).unwrap().at(variable)
}

#[test]
fn operators_bind_as_in_mathematics() {
    for (text, expected) in [
        ("1 + 2*3", 7.0),
        ("-2^2", -4.0),
        ("2^-1", 0.5),
        ("2^3^2", 512.0),
        ("(-2)^2", 4.0),
        ("8/4/2", 1.0),
        ("8 - 4 - 2", 2.0),
        ("1 - -1", 2.0),
        ("2*-3", -6.0),
        ("1.5e3 + .5 + 2.", 1502.5),
        ("length*half", 1.5),
        ("sin(90*deg)", 1.0),
        ("atan2(1, -1)/pi", 0.75),
        ("if(1 < 2, 3, 4) + if(1 >= 2, 3, 4)", 7.0),
        ("min(1, 2) + max(1, 2)*10", 21.0),
        ("mod(-1, 3) + floor(2.7)", 4.0),
        ("step(0) + step(-1) + sign(-3)", 0.0),
        ("hypot(3, 4) + sqrt(16) + abs(-2)", 11.0),
        ("ln(exp(2)) + log10(1000)", 5.0),
        (" speed * t ", 14.0),
    ] {
        assert_relative_eq!(at(text, 7.0).value, expected, max_relative = 1e-14);
    }
}

// Central differences with h = 1e-4 of functions of unit size: h^2/6 times a third
// derivative of up to 50, and eps/h^2 = 2e-8 of the second ones.
#[test]
fn derivatives_are_exact() {
    const H: f64 = 1e-4;
    for text in [
        "t^2",
        "t^3*speed - t",
        "t^1.7",
        "2^t",
        "t^t",
        "sin(3*t)*cos(t)",
        "tan(t/2)",
        "asin(t/3) + acos(t/4) + atan(2*t)",
        "atan2(sin(t), 1 + t^2)",
        "sinh(t) - cosh(t/2) + tanh(3*t)",
        "exp(-t^2)",
        "ln(1 + t) + log10(t)",
        "sqrt(1 + t^2) + hypot(t, 2)",
        "1/(1 + t)",
        "t/(2 + sin(t))",
        "abs(t - 5)*min(t, 3)*max(t^2, 0.1)",
        "if(t < 9, t^2, 0) + mod(t^2, 5) + floor(t)",
    ] {
        for t in [0.3, 0.77] {
            let [before, now, after] = [t - H, t, t + H].map(|t| at(text, t));
            let first = (after.value - before.value) / (2.0 * H);
            let second = (after.first - before.first) / (2.0 * H);
            assert_relative_eq!(now.first, first, epsilon = 5e-7, max_relative = 5e-7);
            assert_relative_eq!(now.second, second, epsilon = 2e-6, max_relative = 2e-6);
        }
    }
}

// Cases in which a term of the general rule is infinite or 0 times infinity.
#[test]
fn derivatives_exist_at_zero() {
    assert_eq!(
        at("t^2", 0.0),
        Jet {
            value: 0.0,
            first: 0.0,
            second: 2.0
        }
    );
    assert_eq!(at("t^1", 0.0), Jet::variable(0.0));
    assert_eq!(at("t^0", 0.0), Jet::constant(1.0));
    assert_eq!(at("sqrt(0)*t + 0^2", 0.0), Jet::constant(0.0));
    assert_eq!(at("abs(t)", 0.0).first, 1.0);
    assert_eq!(at("step(t) + 2*step(-t)", 0.0).value, 1.0);
    assert_eq!(at("max(t, 0)", 0.0).first, 1.0);
}

#[test]
fn what_is_wrong_is_reported_with_its_location() {
    for (text, expected) in [
        (
            "2*spead",
            "unknown name \"spead\" at letter 3 of \"2*spead\"",
        ),
        (
            "1 + sine(t)",
            "unknown function \"sine\" at letter 5 of \"1 + sine(t)\"",
        ),
        (
            "atan2(t)",
            "\"atan2\" at letter 1 of \"atan2(t)\" has 1 arguments, expected 2",
        ),
        (
            "2**3",
            "letter 3 of \"2**3\" is the letter '*' again, expected a number, a name or \"(\"",
        ),
        (
            "(1 + 2",
            "letter 7 of \"(1 + 2\" is the end, expected \")\" or an operator",
        ),
        (
            "1 2",
            "letter 3 of \"1 2\" is '2', expected an operator or the end",
        ),
        (
            "",
            "letter 1 of \"\" is the end, expected a number, a name or \"(\"",
        ),
        (
            "sin + 1",
            "letter 5 of \"sin + 1\" is '+', expected \"(\" after the name of a function",
        ),
        (
            "1..2",
            "letter 3 of \"1..2\" is '.', expected an operator or the end",
        ),
    ] {
        assert_eq!(parse(text).unwrap_err().to_string(), expected);
    }
    let help = |text: &str| parse(text).unwrap_err().help();
    assert_eq!(help("2*spead").unwrap(), "did you mean \"speed\"?");
    assert_eq!(help("sine(t)").unwrap(), "did you mean \"sin\"?");
    assert_eq!(help("2**3").unwrap(), "a power is written with ^");
    for text in ["(".repeat(10_000), "-2^".repeat(10_000), "(1+".repeat(40)] {
        assert!(parse(&text).is_err());
    }
    let long = format!("1{}", "+1".repeat(10_000));
    assert_eq!(at(&long, 0.0).value, 10_001.0);
}

// Random mutations of valid texts: each is read or refused, and the read ones can be
// evaluated.
#[test]
fn no_text_makes_it_panic() {
    let seeds = [
        "2*sin(t)^2 - atan2(length, -1e-3)/if(t<=2, min(1,2), .5)",
        "mod(t, 0.5) + speed*(half - t)^-2",
        "max(abs(-t), step(t - 1)) >= \u{e4}",
    ];
    let letters: Vec<char> = "()+-*/^<>=,.0123456789eEtsinlghpd_ \u{e9}\u{1F600}\n\0"
        .chars()
        .collect();
    let mut state = 1_u64;
    let mut random = |below: usize| {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as usize % below
    };
    let mut read = 0;
    for round in 0..30_000 {
        let mut text: Vec<char> = seeds[round % seeds.len()].chars().collect();
        for _ in 0..1 + random(4) {
            let index = random(text.len());
            match random(3) {
                0 => text[index] = letters[random(letters.len())],
                1 => text.insert(index, letters[random(letters.len())]),
                _ => drop(text.remove(index)),
            }
        }
        let text: String = text.into_iter().collect();
        if let Ok(expression) = parse(&text) {
            read += 1;
            for t in [0.0, 1.5, -1e300] {
                let _ = expression.at(|_| Jet::variable(t));
                let _ = expression.next_corner(t, |_, t| Jet::variable(t));
            }
        }
    }
    assert!(read > 1000, "{read}");
}

#[test]
fn every_function_is_listed_once() {
    for name in FUNCTIONS {
        assert!(!super::is_name(name));
        assert_eq!(FUNCTIONS.iter().filter(|own| **own == name).count(), 1);
    }
    assert!(super::is_name("span_2") && super::is_name("_x"));
    for bad in ["2x", "", "a b", "a-b", "pi", "\u{e4}"] {
        assert!(!super::is_name(bad), "{bad}");
    }
}
