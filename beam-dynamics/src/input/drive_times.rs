//! Drives at the times of the analyses, and in analyses without time.

use std::path::Path;

use shared_geom::document::Document;

use super::analyses::Analyses;
use super::builder::ModelBuilder;
use super::control;
use super::drives::Catalog;
use super::number::short_number;
use super::rotors::Rotors;

/// Digits of values.
const DIGITS: usize = 5;

/// Notes problems of loads and drives at the times of the analyses, or at the start.
pub(super) fn check(document: &Document, builder: &ModelBuilder, analyses: Option<&Analyses>) {
    let times = analyses.and_then(Analyses::times);
    if let Some(times) = times {
        builder.drives().check_run(document, times);
        control::check_run(document, builder, times);
    }
    let start = times.map_or(0.0, |[start, _]| start);
    builder.drives().check_start(document, start);
}

/// A remark on drives that change with time, of which equilibria have the value at time zero; but for the
/// pitch of rotors and driven joints in modes, which have their own.
pub(super) fn remark(
    document: &Document,
    rotors: &Rotors,
    drives: &Catalog,
    analyses: &Analyses,
) -> Option<String> {
    let cards = analyses.without_time().into_iter().map(|card| card.0);
    let cards: Vec<_> = cards.filter(|card| *card != "[modes]").collect();
    let rotors = rotors.as_deref().unwrap_or_default();
    let is_pitch = |line: usize| rotors.iter().any(|own| own.pitch_lines().contains(&line));
    let mut changing = drives.changing();
    changing.retain(|(_, line, _)| !is_pitch(*line));
    let (key, line, value) = changing.first().filter(|_| !cards.is_empty())?;
    let others = match changing.len() {
        1 => "changes with time".to_owned(),
        2 => "and 1 more drive change with time".to_owned(),
        count => format!("and {} more drives change with time", count - 1),
    };
    let location = document.location(*line);
    let file = Path::new(&location.file).file_name();
    let file = file.map_or_else(String::new, |name| {
        format!(" of {}", name.to_string_lossy())
    });
    let place = location
        .line
        .map_or_else(String::new, |line| format!(" in line {line}{file}"));
    Some(format!(
        "\"{key}\"{place} {others}: {} {} the value at the time zero, here {} in SI units",
        cards.join(", "),
        if cards.len() == 1 { "has" } else { "have" },
        short_number(*value, DIGITS)
    ))
}
