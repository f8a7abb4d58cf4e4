//! Meaning of the marks and of the patterns of lines.

use shared_geom::figure::{Color, Legend, Mark, Sample, Stroke};

use super::{FanPlot, curves, looks, per_rev};
use crate::result::ModeKind;

const GRAY: Color = Color(90, 90, 90);

/// Two legends, the second one below the first one: the marks of the kinds that the plot has, the
/// ring of measured points and the multiples of the rotor speed; the patterns of lines and the
/// mark of critical speeds.
pub(super) fn legends(plot: &FanPlot) -> [Legend; 2] {
    let [mut legend, mut lines] = [Legend::default(), Legend::default()];
    let others = [
        ModeKind::Lateral,
        ModeKind::ForeAft,
        ModeKind::SideSide,
        ModeKind::Coupled,
        ModeKind::Rigid,
    ];
    for kind in ModeKind::PURE.into_iter().chain(others) {
        let mut kinds = plot.curves.iter().flat_map(|curve| &curve.kinds);
        if kinds.any(|found| *found == Some(kind)) {
            let mark = Sample::Mark(curves::mark(kind), curves::MARK, looks::color(kind));
            legend.add(kind.word_in(plot.words), mark);
        }
    }
    if !plot.measured.is_empty() {
        let ring = Sample::Mark(Mark::Ring, curves::RING, curves::BLACK);
        legend.add("measured", ring);
    }
    legend.add("nP: n per revolution", Sample::Line(per_rev::STROKE));
    for (pattern, text) in &plot.patterns {
        let stroke = Stroke::new(curves::LINE, GRAY).dashed(*pattern);
        lines.add(text, Sample::Line(stroke));
    }
    if !plot.critical.is_empty() {
        let size = curves::diamond_size(plot.critical.len());
        let diamond = Sample::Mark(Mark::OpenDiamond, size, curves::BLACK);
        lines.add(&plot.marked, diamond);
    }
    if let Some(text) = &plot.above {
        lines.add(text, Sample::None);
    }
    [legend, lines]
}
