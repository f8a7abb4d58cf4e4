//! Sums of controls, as drives: expressions if all of their terms are, else sums of drives.

use shared_geom::document::schema::KeySchema;
use shared_geom::document::{Content, Item, Table};
use shared_geom::expression::{Expression, Jet, Names, words, written};

use super::base::signed;
use super::context::Context;
use crate::elements::Smoothness;

/// The names that a control may use, and the derivatives of it that must be known.
pub(super) type Wanted<'a> = (&'a Context, Smoothness);

/// A number that may change with time, as written.
#[derive(Debug, Clone)]
pub(super) struct Control {
    kind: Kind,
    /// Its key in the file; empty if it is not in the file.
    key: &'static str,
    /// Its line; zero if it is not in the file.
    line: usize,
    /// Whether it senses a quantity.
    senses: bool,
}

/// The forms of a control.
#[derive(Debug, Clone)]
enum Kind {
    /// A number, or an expression, in the declared unit of its key.
    Text(String),
    /// A drive by its name, or a table.
    Drive(Content),
}

impl Control {
    /// An expression of the program.
    fn of_program(text: String) -> Self {
        Self {
            kind: Kind::Text(text),
            key: "",
            line: 0,
            senses: false,
        }
    }

    /// Its value at time zero in the declared unit, if it is known: it may use the constants.
    pub fn at_start(&self, constants: &[(String, f64)]) -> Option<f64> {
        let Kind::Text(text) = &self.kind else {
            return None;
        };
        at_start(text, constants).map(|jet| jet.value)
    }

    /// Its rate at time zero in the declared units, if it is known: it may use the constants.
    pub fn rate_at_start(&self, constants: &[(String, f64)]) -> Option<f64> {
        let Kind::Text(text) = &self.kind else {
            return None;
        };
        let rate = at_start(text, constants)?.first;
        rate.is_finite().then_some(rate)
    }

    /// Whether it is not the number zero.
    pub fn acts(&self) -> bool {
        self.number() != Some(0.0)
    }

    /// Whether its value is another one at other times, but for sensed quantities.
    pub fn changes(&self) -> bool {
        match &self.kind {
            Kind::Text(text) => uses(text, "t"),
            Kind::Drive(_) => true,
        }
    }

    /// Whether it is an expression with the name.
    pub fn uses(&self, name: &str) -> bool {
        matches!(&self.kind, Kind::Text(text) if uses(text, name))
    }

    /// Its line in the file.
    pub fn line(&self) -> usize {
        self.line
    }

    /// Its key in the file.
    pub fn key(&self) -> &'static str {
        self.key
    }

    /// The number, if it is one, in the declared unit.
    pub fn number(&self) -> Option<f64> {
        match &self.kind {
            Kind::Text(text) => text.trim_matches(['(', ')']).parse().ok(),
            Kind::Drive(_) => None,
        }
    }

    /// Its line and key, if it is a drive by name or table.
    pub fn drive(&self) -> Option<(usize, &'static str)> {
        matches!(self.kind, Kind::Drive(_)).then_some((self.line, self.key))
    }
}

/// An expression of time at time zero, which may use the constants; `None` if it uses others or has no
/// finite value.
pub(super) fn at_start(text: &str, constants: &[(String, f64)]) -> Option<Jet> {
    let names = Names {
        variables: &["t"],
        constants,
    };
    let expression = Expression::parse(text, &names).ok()?;
    let jet = expression.at(|_| Jet::variable(0.0));
    jet.value.is_finite().then_some(jet)
}

/// Whether a name is in an expression.
fn uses(text: &str, name: &str) -> bool {
    words(text).any(|word| word == name)
}

/// Reads the control under a declared key; `Some(None)` if it is absent.
pub(super) fn read(
    table: &Table<'_>,
    key: &KeySchema,
    wanted: Wanted<'_>,
) -> Option<Option<Control>> {
    let Some(item) = table.item(key.name) else {
        return Some(None);
    };
    control(&item, key, wanted).map(Some)
}

/// The control of a value of a key. A wrong one is noted under this key and read as zero, so that
/// the parts of the rotor exist and the other cards find them.
fn control(item: &Item<'_>, key: &KeySchema, (context, needed): Wanted<'_>) -> Option<Control> {
    let senses = context.senses(item, key, needed);
    let kind = match senses {
        Some(_) => kind(item, key, context)?,
        None => Kind::Text("0".to_owned()),
    };
    Some(Control {
        kind,
        key: key.name,
        line: item.line(),
        senses: senses.unwrap_or(false),
    })
}

/// The form of a value of a key that is right.
fn kind(item: &Item<'_>, key: &KeySchema, context: &Context) -> Option<Kind> {
    let Some(text) = item.text() else {
        if item.is_table() {
            return Some(Kind::Drive(item.copied()));
        }
        return number(item, key);
    };
    if let Some(text) = written(text) {
        return Some(Kind::Text(format!("({})", text.trim())));
    }
    let name = text.trim();
    let begins = name.chars().next();
    if begins.is_none_or(|letter| letter.is_ascii_digit() || "+-.".contains(letter)) {
        return number(item, key);
    }
    Some(if context.has_drive(name) {
        Kind::Drive(name.into())
    } else {
        // A sensor, an output or an actuator.
        Kind::Text(name.to_owned())
    })
}

/// A number in the declared unit.
fn number(item: &Item<'_>, key: &KeySchema) -> Option<Kind> {
    let found = item.quantity(key.dimension())?;
    let number = found / item.document().factor(key.dimension());
    Some(Kind::Text(signed(number)))
}

/// Reads a list of controls under a declared key; empty if it is absent.
pub(super) fn list(table: &Table<'_>, key: &KeySchema, wanted: Wanted<'_>) -> Option<Vec<Control>> {
    let Some(item) = table.item(key.name) else {
        return Some(Vec::new());
    };
    let Some(items) = item.list().filter(|items| !items.is_empty()) else {
        return item.wrong("a list of drives, one per blade");
    };
    let read = items.iter().map(|item| control(item, key, wanted));
    let read: Vec<_> = read.collect();
    read.into_iter().collect()
}

/// A sum of controls times factors.
#[derive(Debug, Clone, Default)]
pub(super) struct Sum(Vec<(Control, Option<String>)>);

impl Sum {
    /// Adds a control, if there is one, times the expression of a factor, one if `None`.
    pub fn add(&mut self, control: Option<&Control>, factor: Option<String>) {
        self.0
            .extend(control.map(|control| (control.clone(), factor)));
    }

    /// A rotation across the shaft, or a height, of a rotor or of its mirror image, whose side is -1.
    pub fn on_side(&self, side: f64) -> Self {
        if side < 0.0 {
            self.negative()
        } else {
            self.clone()
        }
    }

    /// The sum with the opposite sign.
    fn negative(&self) -> Self {
        let terms = self.0.iter().map(|(control, factor)| {
            let factor = match factor {
                Some(factor) => format!("(-1)*({factor})"),
                None => "(-1)".to_owned(),
            };
            (control.clone(), Some(factor))
        });
        Self(terms.collect())
    }

    /// Whether it has no terms.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The line of its first term in the file; zero without one.
    pub fn line(&self) -> usize {
        let mut lines = self.0.iter().map(|(control, _)| control.line);
        lines.find(|line| *line > 0).unwrap_or(0)
    }

    /// The sum as an expression; `None` if a term is a drive by name or table.
    pub fn text(&self) -> Option<String> {
        let terms = self
            .0
            .iter()
            .map(|(control, factor)| match (&control.kind, factor) {
                (Kind::Text(text), Some(factor)) => Some(format!("{text}*{factor}")),
                (Kind::Text(text), None) => Some(text.clone()),
                (Kind::Drive(_), _) => None,
            });
        let terms: Option<Vec<_>> = terms.collect();
        Some(match terms? {
            terms if terms.is_empty() => "0".to_owned(),
            terms => terms.join(" + "),
        })
    }

    /// The sum as a value of a key, on the line of its first term.
    pub fn content(&self) -> Content {
        self.value().on_line(self.line())
    }

    fn value(&self) -> Content {
        // A single name keeps its unit.
        if let [(control, None)] = self.0.as_slice()
            && let Kind::Text(text) = &control.kind
            && text.starts_with(|letter: char| letter.is_ascii_alphabetic())
        {
            return text.as_str().into();
        }
        if let Some(text) = self.text() {
            return format!("= {text}").into();
        }
        let terms = self.0.iter().map(|(control, factor)| {
            let line = control.line;
            let control = match &control.kind {
                Kind::Text(text) => format!("= {text}").into(),
                Kind::Drive(drive) => drive.clone(),
            };
            let term = match factor {
                None => control,
                Some(factor) => Content::table([
                    ("kind", "product".into()),
                    (
                        "factors",
                        Content::list([control, format!("= {factor}").into()]),
                    ),
                ]),
            };
            term.on_line(line)
        });
        Content::table([("kind", "sum".into()), ("terms", Content::list(terms))])
    }
}

/// Controls of the pitch.
#[derive(Debug, Clone, Default)]
pub(super) struct Pitch {
    /// Mean.
    pub collective: Option<Control>,
    /// Factor of the cosine.
    pub cosine: Option<Control>,
    /// Factor of the sine.
    pub sine: Option<Control>,
    /// Orders of harmonics, with the factors of cosine and sine.
    pub harmonics: Vec<(usize, [Option<Control>; 2])>,
    /// Of each blade; empty if there are none.
    pub individual: Vec<Control>,
    /// Mean in the undeformed model, in the declared unit.
    pub built_in: f64,
}

impl Pitch {
    /// Whether it depends on the azimuth.
    pub fn is_cyclic(&self) -> bool {
        self.cosine.is_some() || self.sine.is_some() || !self.harmonics.is_empty()
    }

    /// All of its controls.
    pub fn all(&self) -> impl Iterator<Item = &Control> {
        let harmonics = self.harmonics.iter().flat_map(|(_, pair)| pair).flatten();
        let first = self.collective.iter().chain(&self.cosine).chain(&self.sine);
        first.chain(harmonics).chain(&self.individual)
    }

    /// The factors of cosines and sines of the azimuth that are not zero.
    pub fn cyclic(&self) -> impl Iterator<Item = &Control> {
        let harmonics = self.harmonics.iter().flat_map(|(_, pair)| pair).flatten();
        let first = self.cosine.iter().chain(&self.sine);
        first.chain(harmonics).filter(|control| control.acts())
    }

    /// The pitch that does not depend on the azimuth, and changes with time.
    pub fn changing(&self) -> impl Iterator<Item = &Control> {
        let steady = self.collective.iter().chain(&self.individual);
        steady.filter(|control| control.changes())
    }

    /// Line and key of a drive by name or table in a sum that senses a quantity, or the azimuth if
    /// it `is_sensed`: a sum of drives cannot sense. A plate tilts by sums of cosine and sine only.
    pub fn drive_in_sensed_sum(
        &self,
        has_plate: bool,
        is_sensed: bool,
    ) -> Option<(usize, &'static str)> {
        let mean = self.collective.iter().filter(|_| !has_plate);
        let harmonics = self.harmonics.iter().flat_map(|(_, pair)| pair).flatten();
        let common = mean.chain(&self.cosine).chain(&self.sine).chain(harmonics);
        let mut blades = 0..self.individual.len().max(1);
        blades.find_map(|k| {
            let mut sum = common.clone().chain(self.individual.get(k));
            let senses = is_sensed || sum.clone().any(|control| control.senses);
            sum.find_map(|control| control.drive().filter(|_| senses))
        })
    }

    /// The pitch of blade `k`, from zero, by the expression of its azimuth \[rad\]:
    ///
    /// ```text
    /// theta0 + theta1c cos psi + theta1s sin psi + sum (c_n cos n psi + s_n sin n psi) + own
    /// ```
    ///
    /// less the pitch that is built in.
    pub fn of_blade(&self, k: usize, azimuth: Option<&str>) -> Sum {
        let mut sum = Sum::default();
        sum.add(self.collective.as_ref(), None);
        if let Some(azimuth) = azimuth {
            let wave = |name: &str, order: usize| match order {
                1 => Some(format!("{name}({azimuth})")),
                _ => Some(format!("{name}({order}*({azimuth}))")),
            };
            sum.add(self.cosine.as_ref(), wave("cos", 1));
            sum.add(self.sine.as_ref(), wave("sin", 1));
            for (order, [cosine, sine]) in &self.harmonics {
                sum.add(cosine.as_ref(), wave("cos", *order));
                sum.add(sine.as_ref(), wave("sin", *order));
            }
        }
        sum.add(self.individual.get(k), None);
        let built_in = (self.built_in != 0.0).then(|| Control::of_program(signed(-self.built_in)));
        sum.add(built_in.as_ref(), None);
        sum
    }
}
