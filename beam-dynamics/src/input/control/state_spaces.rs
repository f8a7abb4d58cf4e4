//! Linear systems of states: `[[state_space]]`.
//!
//! The matrices are in the card or in a file, or follow from transfer functions. The
//! outputs are names that expressions read, also the inputs of these cards.

use std::collections::BTreeMap;

use nalgebra::DMatrix;
use shared_geom::document::{ByHand, Document, Key, Table};
use shared_geom::units::Dimension;

use crate::elements::control::{Matrices, Sampled, StateSpace};
use crate::elements::{Element, Input};
use crate::input::builder::ModelBuilder;
use crate::input::drives::{self, Catalog, Measure, Read};
use crate::input::ends;
use crate::model::{Scalar, ScalarStart};

mod keys;
mod problem;
mod sampled;

pub(in crate::input) use keys::STATE_SPACE;
use keys::{
    A, B, C, D, DENOMINATOR, FILE, INPUT, INPUTS, NAME, NUMERATOR, OUTPUT, OUTPUTS, START, TRANSFER,
};
pub use problem::StateSpaceProblem;

/// Largest number of samples of a run.
const MOST_SAMPLES: f64 = 1e8;
/// Keys of the matrices.
const MATRICES: [&Key<ByHand>; 4] = [&A, &B, &C, &D];

/// A card whose outputs have names.
pub(super) struct Named<'a> {
    table: Table<'a>,
    label: String,
    /// Names of the outputs.
    names: Vec<String>,
    /// The outputs; `None` if their names are wrong.
    outputs: Option<Vec<Scalar>>,
}

/// Makes the outputs of every `[[state_space]]` readable by expressions.
pub(super) fn declare<'a>(root: &Table<'a>, drives: &mut Catalog) -> Vec<Named<'a>> {
    let tables = root.tables("state_space").into_iter().enumerate();
    let named = tables.map(|(number, table)| {
        let label = ends::label(&table, &NAME, "state space", number);
        let names = table.get(&OUTPUTS);
        Named {
            outputs: (names.as_deref()).and_then(|names| outputs(&table, &label, names, drives)),
            names: names.unwrap_or_default(),
            table,
            label,
        }
    });
    named.collect()
}

/// Adds every `[[state_space]]` to the model.
pub(super) fn read(named: Vec<Named<'_>>, builder: &mut ModelBuilder) {
    for card in named {
        let is_new = builder.take_label("state space", &card.label, &card.table);
        let element = element(&card, builder);
        card.table.finish();
        let Some((element, period)) = element else {
            builder.note_broken();
            continue;
        };
        if let Some(period) = period {
            builder.add_sampling(card.table.line_of(&sampled::SAMPLE_TIME), period);
        }
        if is_new {
            builder.add_control(element)
        } else {
            builder.note_broken()
        }
    }
}

/// Notes systems with too many samples in a run from and to the given `times` \[s\].
pub(super) fn check_run(document: &Document, builder: &ModelBuilder, [from, to]: [f64; 2]) {
    for &(line, period) in builder.samplings() {
        let samples = (to - from) / period;
        if samples > MOST_SAMPLES {
            document.note(line, &StateSpaceProblem::ManySamples { samples });
        }
    }
}

/// The outputs, by names that expressions may read from now on.
fn outputs(
    table: &Table<'_>,
    label: &str,
    names: &[String],
    drives: &mut Catalog,
) -> Option<Vec<Scalar>> {
    let mut complete = true;
    let mut outputs = Vec::new();
    for name in names {
        let scalar = StateSpace::output(label, name);
        if !drives.is_free(name, table, OUTPUTS.name()) {
            complete = false;
            continue;
        }
        let input = Input {
            scalar: scalar.clone(),
            unit: 1.0,
        };
        drives.add_readable(
            name.clone(),
            Some(Read {
                input,
                measure: Measure::Plain,
            }),
        );
        outputs.push(scalar);
    }
    complete.then_some(outputs)
}

/// The element of a card, and its sample time if it samples \[s\].
fn element(card: &Named<'_>, builder: &ModelBuilder) -> Option<(Box<dyn Element>, Option<f64>)> {
    let table = &card.table;
    let inputs = table.require_item(&INPUTS, "a list of numbers, drives or expressions");
    let inputs = inputs.map(|item| {
        let items = item.list().unwrap_or_else(|| vec![item]);
        let number = Dimension::NUMBER;
        let signals = items
            .iter()
            .map(|item| drives::signal_of(item, number, builder.drives()));
        // All are read, so that all problems are noted.
        signals.collect::<Vec<_>>()
    });
    let count = inputs.as_ref().map(Vec::len);
    let names = &card.names;
    let matrices = matrices(table, (count, names));
    let states = matrices.as_ref().map(|found| found.a.nrows());
    let start = start(table, states);
    let sampled = sampled::read(table, names.len());
    let inputs: Option<Vec<_>> = inputs?.into_iter().collect();
    let (inputs, outputs) = (inputs?, card.outputs.clone()?);
    let (label, matrices, start) = (&card.label, matrices?, start?);
    Some(match sampled? {
        None => {
            let element = StateSpace::new(label, matrices, inputs, outputs, &start);
            (Box::new(element), None)
        }
        Some((sampling, limits)) => {
            let start = start.into_iter().map(|start| match start {
                ScalarStart::Value(value) | ScalarStart::Constant(value) => value,
                ScalarStart::Settled => 0.0,
            });
            let outputs = outputs.into_iter().zip(limits).collect();
            let law = (matrices, sampling);
            let element = Sampled::new(label, law, inputs, outputs, start.collect());
            (Box::new(element), Some(sampling.period))
        }
    })
}

/// The numbers of a list under `key`; notes a value that is not a list.
fn list(table: &Table<'_>, key: &str, expected: &str) -> Option<Vec<f64>> {
    if !table.is_list(key) {
        table.wrong(key, expected);
        return None;
    }
    table.quantities(key, Dimension::NUMBER)
}

/// Initial states: zero unless they are given, or taken from equilibrium.
fn start(table: &Table<'_>, states: Option<usize>) -> Option<Vec<ScalarStart>> {
    const KEY: &str = START.name();
    if !table.has(KEY) {
        return Some(vec![ScalarStart::Value(0.0); states?]);
    }
    if table.is_text(KEY) {
        table.word(KEY, &["settled"])?;
        if table.has(&sampled::SAMPLE_TIME) {
            table.note(KEY, &StateSpaceProblem::Sampled);
            return None;
        }
        return Some(vec![ScalarStart::Settled; states?]);
    }
    let numbers = list(table, KEY, "a list of numbers, or \"settled\"");
    let (numbers, states) = (numbers?, states?);
    if numbers.len() != states {
        let found = numbers.len();
        table.note(KEY, &StateSpaceProblem::Starts { found, states });
        return None;
    }
    Some(numbers.into_iter().map(ScalarStart::Value).collect())
}

/// The matrices, which a card must give in exactly one way.
fn matrices(table: &Table<'_>, sizes: (Option<usize>, &[String])) -> Option<Matrices> {
    let has_matrices = MATRICES.iter().any(|key| table.has(key));
    let transfer_keys = [&NUMERATOR, &DENOMINATOR].map(|key| table.has(key));
    let has_transfer = transfer_keys.contains(&true);
    let ways = [
        ("\"a\" to \"d\"", has_matrices),
        ("\"file\"", table.has(&FILE)),
        ("\"numerator\" and \"denominator\"", has_transfer),
        ("\"transfer\"", table.has(&TRANSFER)),
    ];
    let given = ways.iter().filter(|way| way.1).map(|way| way.0);
    let given: Vec<_> = given.collect();
    let &[_] = &given[..] else {
        table.note("", &StateSpaceProblem::Ways { given });
        return None;
    };
    if has_matrices {
        return from_keys(table, sizes);
    }
    if table.has(&FILE) {
        let written = table.get(&FILE)?;
        let path = table.existing(&FILE, &written)?;
        let document = Document::read(&path);
        let document = table.document().keep(document)?;
        let root = document.root();
        if !MATRICES.iter().any(|key| root.has(key)) {
            root.note("", &StateSpaceProblem::Ways { given: Vec::new() });
        }
        let found = from_keys(&root, sizes);
        root.finish();
        return table.document().keep(document.finish(found));
    }
    let (inputs, outputs) = (sizes.0?, sizes.1);
    if has_transfer {
        if [inputs, outputs.len()] != [1, 1] {
            let found = [inputs, outputs.len()];
            table.note(&NUMERATOR, &StateSpaceProblem::NotSingle { found });
            return None;
        }
        return transfer(table);
    }
    from_transfers(table, inputs, outputs)
}

/// Matrices under "a" to "d": omitted ones are zero.
fn from_keys(table: &Table<'_>, (inputs, names): (Option<usize>, &[String])) -> Option<Matrices> {
    let states = table.row_count(&A).unwrap_or(0);
    let (inputs, outputs) = (inputs?, names.len());
    let read = |key: &Key<ByHand>, rows: usize, columns: usize| {
        if table.has(key) {
            let found = table.rows(key.name(), rows, columns)?;
            let numbers = found.into_iter().flatten();
            Some(DMatrix::from_row_iterator(rows, columns, numbers))
        } else {
            Some(DMatrix::zeros(rows, columns))
        }
    };
    // All are read, so that all problems are noted.
    let (a, b) = (read(&A, states, states), read(&B, states, inputs));
    let (c, d) = (read(&C, outputs, states), read(&D, outputs, inputs));
    Some(Matrices {
        a: a?,
        b: b?,
        c: c?,
        d: d?,
    })
}

/// "numerator" over "denominator".
fn transfer(table: &Table<'_>) -> Option<Matrices> {
    let coefficients = |key: &Key<Vec<f64>>| {
        let is_list = !table.has(key) || table.is_list(key);
        table.get_if(key, |_| is_list, key.schema.expected)
    };
    let (numerator, denominator) = (coefficients(&NUMERATOR), coefficients(&DENOMINATOR));
    let (numerator, denominator) = (numerator?, denominator?);
    let found = Matrices::transfer(&numerator, &denominator);
    if found.is_none() {
        let degrees = [numerator, denominator].map(|of| of.len());
        table.note(&NUMERATOR, &StateSpaceProblem::Improper { degrees });
    }
    found
}

/// `[[state_space.transfer]]`: one per output and input that it connects.
fn from_transfers(table: &Table<'_>, inputs: usize, outputs: &[String]) -> Option<Matrices> {
    let mut entries: Vec<Vec<_>> = vec![vec![None; inputs]; outputs.len()];
    let mut lines = BTreeMap::new();
    let mut complete = true;
    let cards = table.tables(&TRANSFER);
    if cards.is_empty() {
        table.note(&TRANSFER, &StateSpaceProblem::Ways { given: Vec::new() });
        return None;
    }
    for card in cards {
        let known: Vec<_> = outputs.iter().map(String::as_str).collect();
        let output = card
            .get(&OUTPUT)
            .and_then(|_| card.word(OUTPUT.name(), &known));
        let expected = format!("the index of an input, 1 to {inputs}");
        let input = card.get_if(&INPUT, |input| *input <= inputs, &expected);
        let found = transfer(&card);
        card.finish();
        let (Some(i), Some(j), Some(found)) = (output, input, found) else {
            complete = false;
            continue;
        };
        if let Some(line) = lines.insert((i, j), card.line()) {
            let line = table.document().line_words(line);
            card.note(&OUTPUT, &StateSpaceProblem::Doubled { line });
            complete = false;
        }
        entries[i][j - 1] = Some(found);
    }
    complete.then(|| Matrices::of_entries(&entries, inputs))
}
