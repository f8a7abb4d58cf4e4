//! The shapes of the cells, as text.

use super::text::table;
use crate::input::InputSummary;
use crate::mesh::quality::{Grade, MeshQuality, NamedCell, ShapeMeasure};
use shared_geom::figure::tick_label;

/// The worst values of the mesh in two lines.
pub(super) fn quality_in_short(summary: &InputSummary) -> String {
    let quality = &summary.quality;
    let worst = |measure| {
        quality
            .worst_value(measure)
            .map_or(0.0, |value| shown(measure, value))
    };
    let middles = if has_middles(quality) {
        format!(
            ", side middles off by up to {:.2} of the side",
            worst(ShapeMeasure::Middle)
        )
    } else {
        String::new()
    };
    let poor = match quality.poor() {
        0 => "no cell is poor".to_owned(),
        1 => "1 cell is poor".to_owned(),
        count => format!("{count} cells are poor"),
    };
    format!(
        "Cell quality\n  aspect ratios up to {:.1}, corners of {:.1} to {:.1} deg{middles},\n  \
         least over largest Jacobian {:.2} or more: {poor}\n",
        worst(ShapeMeasure::Aspect),
        worst(ShapeMeasure::SmallestAngle),
        worst(ShapeMeasure::LargestAngle),
        worst(ShapeMeasure::Jacobian),
    )
}

/// The measures by region and in the whole mesh, and the worst cells that are not good.
pub(super) fn quality_by_region(summary: &InputSummary) -> String {
    let regions = regions(&summary.quality);
    let grades = grades(&summary.quality);
    let cells = worst_cells(summary);
    format!(
        "Cell quality by region, the worst value (and the mean)\n{regions}\n\
         Cell quality, numbers of cells\n{grades}\n{cells}"
    )
}

/// The measures of which the mesh has values.
fn measures(quality: &MeshQuality) -> impl Iterator<Item = (usize, ShapeMeasure)> {
    let has_middles = has_middles(quality);
    let all = ShapeMeasure::ALL.into_iter().enumerate();
    all.filter(move |(_, measure)| *measure != ShapeMeasure::Middle || has_middles)
}

fn regions(quality: &MeshQuality) -> String {
    let mut heading = vec!["region".to_owned()];
    heading.extend(measures(quality).map(|(_, measure)| measure.short_name().to_owned()));
    heading.push("poor cells".to_owned());
    let mut rows = vec![heading];
    for region in &quality.regions {
        let mut row = vec![region.group.clone()];
        row.extend(measures(quality).map(|(i, measure)| {
            let [worst, mean] = [region.worst[i], region.mean[i]].map(|x| rounded(measure, x));
            format!("{worst} ({mean})")
        }));
        row.push(format!("{} of {}", region.poor, region.cells));
        rows.push(row);
    }
    table(&rows, "lr")
}

fn grades(quality: &MeshQuality) -> String {
    let heading = ["", "poor", "", "fair", "good", ""];
    let mut rows = vec![heading.map(str::to_owned).to_vec()];
    for (i, measure) in measures(quality) {
        let counts = [0, 1, 2].map(|grade| {
            let counts = quality.regions.iter().map(|region| region.grades[i][grade]);
            counts.sum::<usize>().to_string()
        });
        let [poor, good] = measure
            .limits()
            .map(|limit| tick_label(shown(measure, limit), 0.0));
        let (below, above) = if measure.is_better_large() {
            ("below", "from")
        } else {
            ("above", "up to")
        };
        let [few, some, most] = counts;
        let (beyond, within) = (format!("{below} {poor}"), format!("{above} {good}"));
        rows.push(vec![
            measure.name().to_owned(),
            few,
            beyond,
            some,
            most,
            within,
        ]);
    }
    table(&rows, "lrlrrl")
}

fn worst_cells(summary: &InputSummary) -> String {
    let unit = &summary.length_unit;
    let heading = [
        "cell",
        "region",
        &format!("y [{unit}]"),
        &format!("z [{unit}]"),
        "",
    ];
    let mut rows = vec![heading.map(str::to_owned).to_vec()];
    let is_good = |cell: &&NamedCell| cell.worst.measure.grade(cell.worst.value) == Grade::Good;
    for cell in summary.quality.worst.iter().filter(|cell| !is_good(cell)) {
        let [y, z] = cell
            .position
            .map(|x| tick_label(x / summary.length_factor, 0.0));
        rows.push(vec![
            cell.cell.to_string(),
            cell.group.clone(),
            y,
            z,
            cell.worst.to_string(),
        ]);
    }
    if rows.len() == 1 {
        return "All cells are good by every measure\n".to_owned();
    }
    format!(
        "Worst cells, at their centers in the unit of the mesh\n{}",
        table(&rows, "llrrl")
    )
}

/// Angles in degrees.
fn shown(measure: ShapeMeasure, value: f64) -> f64 {
    match measure {
        ShapeMeasure::SmallestAngle | ShapeMeasure::LargestAngle => {
            (value.to_degrees() * 1e9).round() / 1e9
        }
        _ => value,
    }
}

fn rounded(measure: ShapeMeasure, value: f64) -> String {
    let value = shown(measure, value);
    match measure {
        ShapeMeasure::Jacobian | ShapeMeasure::Middle => format!("{value:.3}"),
        _ => format!("{value:.1}"),
    }
}

fn has_middles(quality: &MeshQuality) -> bool {
    quality.regions.iter().any(|region| region.has_middles)
}
