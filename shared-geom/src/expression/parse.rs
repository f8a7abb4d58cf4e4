//! The reader of expressions: precedence climbing.
//!
//! ```text
//! comparison = sum [("<" | "<=" | ">" | ">=") sum]
//! sum        = product {("+" | "-") product}
//! product    = sign {("*" | "/") sign}
//! sign       = ("-" | "+") sign | power
//! power      = atom ["^" sign]
//! atom       = number | name | function "(" comparison {"," comparison} ")"
//!            | "(" comparison ")"
//! ```

use super::functions::{Function, NAMED, Operation};
use super::run::STACK;
use super::{Expression, ExpressionProblem, Jet};
use crate::error::nearest_name;

/// Deepest nesting that is read: no expression of a person is deeper.
const DEEPEST: usize = 48;
/// Names that a message lists: a file may have a hundred thousand.
const MOST_SHOWN: usize = 20;

/// Names that an expression may contain.
#[derive(Debug, Clone, Copy)]
pub struct Names<'a> {
    /// Names of variables: the number of each is its index in the list.
    pub variables: &'a [&'a str],
    /// Names of known numbers, with the numbers [-], in the order of the names.
    pub constants: &'a [(String, f64)],
}

/// Numbers known to every expression: half a turn, and one degree in radians.
const KNOWN: [(&str, f64); 2] = [
    ("pi", std::f64::consts::PI),
    ("deg", std::f64::consts::PI / 180.0),
];

impl Names<'_> {
    fn find(&self, name: &str) -> Option<Operation> {
        if let Some(index) = self.variables.iter().position(|own| *own == name) {
            return Some(Operation::Variable(index));
        }
        let own = self.constant(name);
        let known = KNOWN.iter().find(|known| known.0 == name);
        let value = own.or(known.map(|known| known.1));
        value.map(Operation::Constant)
    }

    /// The known number of that name, except those known to every expression.
    fn constant(&self, name: &str) -> Option<f64> {
        let index = self
            .constants
            .binary_search_by(|own| own.0.as_str().cmp(name));
        index.ok().map(|index| self.constants[index].1)
    }

    /// Suggestions for an unknown name: the nearest name, or the first of all.
    fn instead_of(&self, name: &str) -> Vec<String> {
        let variables = self.variables.iter().copied();
        let constants = self.constants.iter().map(|own| own.0.as_str());
        let known = KNOWN.iter().map(|known| known.0);
        let all = || {
            variables
                .clone()
                .chain(constants.clone())
                .chain(known.clone())
        };
        match nearest_name(name, all()) {
            Some(near) => vec![near.to_owned()],
            None => all().take(MOST_SHOWN).map(str::to_owned).collect(),
        }
    }
}

/// Whether a text can be a name in an expression: letters, digits and `_`, no digit
/// first; not a name known to every expression.
pub fn is_name(text: &str) -> bool {
    let known = KNOWN.iter().any(|known| known.0 == text)
        || NAMED.iter().any(|function| function.0 == text);
    !known && !text.is_empty() && text.chars().all(continues_name) && begins_name(first(text))
}

fn first(text: &str) -> char {
    text.chars().next().unwrap_or(' ')
}

fn begins_name(letter: char) -> bool {
    letter.is_ascii_alphabetic() || letter == '_'
}

fn continues_name(letter: char) -> bool {
    letter.is_ascii_alphanumeric() || letter == '_'
}

/// Reads a whole text.
pub(super) fn expression(text: &str, names: &Names<'_>) -> Result<Expression, ExpressionProblem> {
    let mut reader = Reader {
        text,
        rest: text,
        names,
        program: Vec::new(),
        known: Vec::new(),
        height: 0,
        depth: 0,
    };
    reader.comparison()?;
    if reader.peek().is_some() {
        return Err(reader.unexpected("an operator or the end"));
    }
    let mut used = Vec::new();
    for operation in &reader.program {
        if let Operation::Variable(index) = *operation {
            used.resize(used.len().max(index + 1), false);
            used[index] = true;
        }
    }
    Ok(Expression {
        text: text.trim().to_owned(),
        program: reader.program,
        used,
        known: reader.known,
    })
}

/// A text that is being read, and the program so far.
struct Reader<'a> {
    text: &'a str,
    rest: &'a str,
    names: &'a Names<'a>,
    program: Vec<Operation>,
    known: Vec<String>,
    /// Numbers on the stack at this point of the program.
    height: usize,
    depth: usize,
}

type Read = Result<(), ExpressionProblem>;

impl Reader<'_> {
    /// The next character that is no space.
    fn peek(&mut self) -> Option<char> {
        self.rest = self.rest.trim_start();
        self.rest.chars().next()
    }

    fn take(&mut self, wanted: &str) -> bool {
        let found = self.peek().is_some() && self.rest.starts_with(wanted);
        if found {
            self.rest = &self.rest[wanted.len()..];
        }
        found
    }

    /// Index of the first remaining letter, from one.
    fn column(&self) -> usize {
        let read = self.text.len() - self.rest.len();
        self.text[..read].chars().count() + 1
    }

    fn unexpected(&mut self, expected: &'static str) -> ExpressionProblem {
        let found = match self.peek() {
            None => "the end".to_owned(),
            Some('*') => "the letter '*' again".to_owned(),
            Some(letter) => format!("{letter:?}"),
        };
        ExpressionProblem::Unexpected {
            text: self.text.trim().to_owned(),
            column: self.column(),
            found,
            expected,
        }
    }

    fn push(&mut self, operation: Operation) -> Read {
        let taken = match operation {
            Operation::Apply(function) => function.arguments(),
            _ => 0,
        };
        self.height = self.height + 1 - taken;
        if self.height > STACK {
            let column = self.column();
            return Err(ExpressionProblem::TooDeep { column });
        }
        self.program.push(operation);
        self.fold(taken);
        Ok(())
    }

    /// Evaluates a step at once if its arguments are numbers.
    fn fold(&mut self, taken: usize) {
        let end = self.program.len();
        let Some(&Operation::Apply(function)) = self.program.last() else {
            return;
        };
        let Some(first) = end.checked_sub(taken + 1) else {
            return;
        };
        let mut args = [Jet::default(); 3];
        for (arg, operation) in args.iter_mut().zip(&self.program[first..end - 1]) {
            let Operation::Constant(value) = operation else {
                return;
            };
            *arg = Jet::constant(*value);
        }
        let value = function.at(&args[..taken]).value;
        self.program.truncate(first);
        self.program.push(Operation::Constant(value));
    }

    fn comparison(&mut self) -> Read {
        self.depth += 1;
        if self.depth > DEEPEST {
            let column = self.column();
            return Err(ExpressionProblem::TooDeep { column });
        }
        self.sum()?;
        let signs = [
            ("<=", Function::LessOrEqual),
            ("<", Function::Less),
            (">=", Function::GreaterOrEqual),
            (">", Function::Greater),
        ];
        if let Some((_, function)) = signs.into_iter().find(|sign| self.take(sign.0)) {
            self.sum()?;
            self.push(Operation::Apply(function))?;
        }
        self.depth -= 1;
        Ok(())
    }

    fn sum(&mut self) -> Read {
        self.product()?;
        loop {
            let function = match self.peek() {
                Some('+') => Function::Add,
                Some('-') => Function::Subtract,
                _ => return Ok(()),
            };
            self.rest = &self.rest[1..];
            self.product()?;
            self.push(Operation::Apply(function))?;
        }
    }

    fn product(&mut self) -> Read {
        self.sign()?;
        loop {
            let function = match self.peek() {
                Some('*') => Function::Multiply,
                Some('/') => Function::Divide,
                _ => return Ok(()),
            };
            self.rest = &self.rest[1..];
            self.sign()?;
            self.push(Operation::Apply(function))?;
        }
    }

    fn sign(&mut self) -> Read {
        let mut negative = false;
        while let Some(letter @ ('+' | '-')) = self.peek() {
            negative ^= letter == '-';
            self.rest = &self.rest[1..];
        }
        self.atom()?;
        if self.take("^") {
            self.depth += 1;
            if self.depth > DEEPEST {
                let column = self.column();
                return Err(ExpressionProblem::TooDeep { column });
            }
            self.sign()?;
            self.depth -= 1;
            self.push(Operation::Apply(Function::Power))?;
        }
        if negative {
            self.push(Operation::Apply(Function::Negative))
        } else {
            Ok(())
        }
    }

    fn atom(&mut self) -> Read {
        match self.peek() {
            Some('(') => {
                self.rest = &self.rest[1..];
                self.comparison()?;
                self.close("\")\" or an operator")
            }
            Some(letter) if letter.is_ascii_digit() || letter == '.' => self.number(),
            Some(letter) if begins_name(letter) => self.name(),
            _ => Err(self.unexpected("a number, a name or \"(\"")),
        }
    }

    fn close(&mut self, expected: &'static str) -> Read {
        if self.take(")") {
            Ok(())
        } else {
            Err(self.unexpected(expected))
        }
    }

    fn number(&mut self) -> Read {
        let digits = |text: &str| text.bytes().take_while(u8::is_ascii_digit).count();
        let mut length = digits(self.rest);
        if self.rest[length..].starts_with('.') {
            length += 1 + digits(&self.rest[length + 1..]);
        }
        if self.rest[length..].starts_with(['e', 'E']) {
            let sign = usize::from(self.rest[length + 1..].starts_with(['+', '-']));
            let power = digits(&self.rest[length + 1 + sign..]);
            if power > 0 {
                length += 1 + sign + power;
            }
        }
        let Ok(number) = self.rest[..length].parse() else {
            return Err(self.unexpected("a number"));
        };
        self.rest = &self.rest[length..];
        self.push(Operation::Constant(number))
    }

    fn name(&mut self) -> Read {
        let column = self.column();
        let length = self.rest.chars().take_while(|&c| continues_name(c)).count();
        let (name, rest) = self.rest.split_at(length);
        let name = name.to_owned();
        let before = std::mem::replace(&mut self.rest, rest);
        if self.take("(") {
            return self.call(&name, column);
        }
        match self.names.find(&name) {
            Some(operation) => {
                if self.names.constant(&name).is_some() {
                    self.known.push(name);
                }
                self.push(operation)
            }
            None if NAMED.iter().any(|function| function.0 == name) => {
                Err(self.unexpected("\"(\" after the name of a function"))
            }
            None => {
                self.rest = before;
                Err(ExpressionProblem::UnknownName {
                    text: self.text.trim().to_owned(),
                    column,
                    known: self.names.instead_of(&name),
                    name,
                })
            }
        }
    }

    fn call(&mut self, name: &str, column: usize) -> Read {
        let text = || self.text.trim().to_owned();
        let Some(&(_, expected, function)) = NAMED.iter().find(|own| own.0 == name) else {
            return Err(ExpressionProblem::UnknownFunction {
                text: text(),
                column,
                name: name.to_owned(),
            });
        };
        let mut found = 0;
        if !self.take(")") {
            loop {
                self.comparison()?;
                found += 1;
                if !self.take(",") {
                    break;
                }
            }
            self.close("\",\", \")\" or an operator")?;
        }
        if found != expected {
            return Err(ExpressionProblem::Arguments {
                text: self.text.trim().to_owned(),
                column,
                name: name.to_owned(),
                found,
                expected,
            });
        }
        self.push(Operation::Apply(function))
    }
}
