//! Cost of a map of the power of a rigid rotor over tip speed ratio and pitch.

use std::fs;
use std::path::Path;

use beam_dynamics::analysis::performance::performance;
use beam_dynamics::input::parse_rotor;
use cpu_time::ThreadTime;

use crate::rows::{SPAN, US};
use crate::table::Row;
use crate::yardstick::Yardstick;

/// Points of the map in both directions.
const SIDE: usize = 50;
/// CP at 8 m/s and a tip speed ratio of 7.55 by an independent script, and the range of the largest CP
/// around it [-].
const LARGEST: [f64; 2] = [0.4789, 0.005];

/// The map of `cases/dynamics/nrel5mw_power`, 17 stations at four azimuths, with 50 x 50 points.
pub fn maps(yardstick: &mut Yardstick) -> Option<Vec<Row>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../cases/dynamics/nrel5mw_power");
    let path = folder.join("nrel5mw.rotor.toml");
    let text = fs::read_to_string(&path).ok()?;
    let text = text.replace("steps = 25 }", &format!("steps = {SIDE} }}"));
    let parsed = parse_rotor(&text, &path);
    let mut case = parsed.map_err(|problems| println!("{problems}")).ok()?;
    case.parts.retain(|part| part.is_map);
    let mut largest = 0.0_f64;
    let mut count = 0;
    let time = yardstick.beside(SPAN, || {
        let begin = ThreadTime::now();
        let found = performance(&case);
        let time = begin.elapsed().as_secs_f64();
        let points = &found.tables.first()?.points;
        count = points.len();
        let power = points.iter().map(|it| it.performance.turbine().power);
        largest = power.fold(0.0, f64::max);
        Some(time)
    })?;
    if count != SIDE * SIDE || (largest - LARGEST[0]).abs() > LARGEST[1] {
        println!("map: {count} points, largest CP {largest}");
        return None;
    }
    let point = time / count as f64;
    Some(vec![Row {
        name: format!("map, {SIDE} x {SIDE} points of a turbine"),
        ratio: point / yardstick.time(),
        limit: 150.0,
        meaning: "a point / yardstick",
        time: format!("{:.0} us, all {time:.2} s on one thread", point / US),
        accuracy: format!("largest CP {largest:.4}"),
    }])
}
