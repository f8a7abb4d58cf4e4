//! The reference line of a layup: as in blade files, or by quantities along the span.

use shared_geom::blade::{LINE_TABLE, read_line};
use shared_geom::document::schema::ValueKind::{
    Positive, Quantities, Quantity, Table as OneTable, Word,
};
use shared_geom::document::schema::{Family, TableSchema};
use shared_geom::document::{ByHand, Key, Table};
use shared_geom::keys;
use shared_geom::line::{Course as LineCourse, LinePoint, ReferenceLine};
use shared_geom::units::Dimension;

use super::angle::is_within_a_turn;
use super::course::{COURSE, Course};
use super::problem::LayupFileProblem;

/// The table `[line]` of a layup.
pub(super) const LINE_OF_LAYUP: TableSchema = TableSchema {
    title: LINE_TABLE.title,
    meaning: LINE_TABLE.meaning,
    keys: LINE_TABLE.keys,
    families: &[
        LINE_TABLE.families[0],
        Family {
            name: "along a length",
            meaning: "If `sweep`, `prebend` or `twist` is a table of positions and values: positions are \
                      parts of the extent along x.",
            keys: &[
                LENGTH.schema,
                SWEEP.schema,
                PREBEND.schema,
                TWIST.schema,
                KIND.schema,
            ],
        },
        Family {
            name: "along the span",
            meaning: "The same, from the first to the last number of `span`.",
            keys: &[
                SPAN.schema,
                SWEEP.schema,
                PREBEND.schema,
                TWIST.schema,
                KIND.schema,
            ],
        },
        LINE_TABLE.families[1],
        LINE_TABLE.families[2],
        LINE_TABLE.families[3],
        LINE_TABLE.families[4],
    ],
};

keys! {
    /// Extent along x.
    LENGTH: f64 = "length", [Positive(Dimension::LENGTH)], required, "190";
    /// First and last position along x, in the place of `length`.
    SPAN: ByHand = "span", [Quantities(Dimension::LENGTH)], required, "[0, 61.5]";
    /// Toward the trailing edge.
    SWEEP: Course = "sweep", [Quantity(Dimension::LENGTH), OneTable(&COURSE)],
        or "0" = Course::constant(0.0), "{ eta = [0, 1], value = [0, 1.5] }";
    /// Toward the upper side.
    PREBEND: Course = "prebend", [Quantity(Dimension::LENGTH), OneTable(&COURSE)],
        or "0" = Course::constant(0.0), "{ file = \"blade.csv\", column = \"prebend [m]\" }";
    /// Twist, nose up.
    TWIST: Course = "twist", [Quantity(Dimension::ANGLE), OneTable(&COURSE)],
        or "0" = Course::constant(0.0), "{ eta = [0, 0.2, 1], value = [13, 11, 0] }";
    /// The line between its points.
    KIND: usize = "course", [Word(&["polyline", "spline"])], or "\"spline\"" = 1, "\"polyline\"";
}

/// Points of the line for each interval of its tables.
const PARTS: usize = 4;

/// Reads the line; notes problems.
pub(super) fn read(table: &Table<'_>) -> Option<ReferenceLine> {
    let along = [&SWEEP, &PREBEND, &TWIST];
    if !along.iter().any(|key| table.is_table(key)) {
        let line = read_line(table)?;
        let turned = line
            .points
            .iter()
            .position(|point| !is_within_a_turn(point.twist));
        let Some(number) = turned else {
            return Some(line);
        };
        let at = line.arc_lengths()[number] / line.length();
        let problem = LayupFileProblem::turned(TWIST.name(), line.points[number].twist, at);
        table.note(TWIST.name(), &problem);
        return None;
    }
    let ends = ends(table);
    let kind = table.get(&KIND);
    let read = |key: &Key<Course>| table.get(key);
    let courses = along.map(read);
    let ([from, to], kind) = (ends?, kind?);
    let [sweep, prebend, twist] = courses;
    let mut courses = [sweep?, prebend?, twist?];
    for course in &mut courses {
        let (last, line) = (course.points().last()?.0, course.lengths());
        if let Some(line) = line.filter(|_| last > (to - from) * (1.0 + 1e-9)) {
            let length = to - from;
            let problem = LayupFileProblem::Beyond {
                found: last,
                length,
            };
            table.document().note(line, &problem);
            return None;
        }
        course.divide_lengths(to - from);
    }
    let [sweep, prebend, twist] = &courses;
    let point = |eta: f64| LinePoint {
        // sweep is positive aft
        position: [from + (to - from) * eta, -sweep.at(eta), prebend.at(eta)].into(),
        twist: twist.at(eta),
    };
    let line = ReferenceLine::through(
        positions(&courses).into_iter().map(point).collect(),
        [LineCourse::Polyline, LineCourse::Spline][kind],
    );
    let problems = line.problems();
    for problem in &problems {
        table.note("", problem);
    }
    problems.is_empty().then_some(line)
}

/// The first and the last position along x \[m\]; notes problems.
fn ends(table: &Table<'_>) -> Option<[f64; 2]> {
    if !table.has(&SPAN) {
        return Some([0.0, table.get(&LENGTH)?]);
    }
    let span = table.quantities(SPAN.name(), Dimension::LENGTH)?;
    match span[..] {
        [from, .., to] if span.is_sorted_by(|a, b| a < b) && !table.has(&LENGTH) => {
            Some([from, to])
        }
        _ => {
            table.wrong(
                &SPAN,
                "the ascending positions of root and tip, without \"length\"",
            );
            None
        }
    }
}

/// Positions of the points of the line, parts of its span.
fn positions(courses: &[Course]) -> Vec<f64> {
    let of_tables = courses.iter().flat_map(|course| course.positions());
    let mut all: Vec<f64> = of_tables.copied().chain([0.0, 1.0]).collect();
    all.sort_by(f64::total_cmp);
    all.dedup_by(|a, b| (*a - *b).abs() < 1e-9);
    let parts = all.windows(2).flat_map(|pair| {
        let part = |k: usize| pair[0] + (pair[1] - pair[0]) * k as f64 / PARTS as f64;
        (0..PARTS).map(part)
    });
    parts.chain([1.0]).collect()
}
