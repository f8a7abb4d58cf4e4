//! Stations at equal distances between hub and tip, in place of the given ones: files of
//! propellers often have few stations.

use rotor_aero::airfoil::{Blend, BlendProblem, Section};
use rotor_aero::rotor::Station;

/// Stations at the ends of `count` pieces of equal length from hub to tip \[m\], without the ends
/// themselves, which have no load. All is linear between the given stations and constant outside.
///
/// # Errors
/// Airfoils that cannot be blended.
pub(super) fn refined(
    stations: &[Station<Section>],
    [hub, tip]: [f64; 2],
    count: usize,
) -> Result<Vec<Station<Section>>, BlendProblem> {
    let placed = stations.iter().map(|it| (it.radius, it.section.clone()));
    let sections = Blend::along_span(placed.collect())?;
    let mut found = Vec::with_capacity(count);
    for index in 1..count {
        let radius = hub + (tip - hub) * index as f64 / count as f64;
        let after = stations.partition_point(|it| it.radius <= radius);
        let high = stations.get(after).or(stations.last());
        let low = after.checked_sub(1).and_then(|it| stations.get(it));
        let (Some(low), Some(high)) = (low.or(stations.first()), high) else {
            continue;
        };
        let width = high.radius - low.radius;
        let part = match width > 0.0 {
            true => (radius - low.radius) / width,
            false => 0.0,
        };
        let mix = |a: f64, b: f64| a + part * (b - a);
        found.push(Station {
            radius,
            chord: mix(low.chord, high.chord),
            twist: mix(low.twist, high.twist),
            prebend: mix(low.prebend, high.prebend),
            section: sections.section(low.radius + part * width)?,
        });
    }
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::*;
    use rotor_aero::airfoil::{Airfoil, LinearLift};
    use std::sync::Arc;

    #[test]
    fn stations_are_linear_between_the_given_ones_and_constant_outside() {
        let airfoil = Arc::new(Airfoil::linear(LinearLift::default()));
        let station = |radius: f64, chord: f64| Station {
            radius,
            chord,
            twist: 0.1 * radius,
            prebend: 0.0,
            section: Section::single(Arc::clone(&airfoil)),
        };
        let given = [station(2.0, 1.0), station(4.0, 0.5)];
        let found = refined(&given, [1.0, 5.0], 8).unwrap();
        let shape: Vec<_> = found.iter().map(|it| (it.radius, it.chord)).collect();
        let expected = [
            (1.5, 1.0),
            (2.0, 1.0),
            (2.5, 0.875),
            (3.0, 0.75),
            (3.5, 0.625),
            (4.0, 0.5),
            (4.5, 0.5),
        ];
        assert_eq!(shape, expected);
        assert!((found[3].twist - 0.3).abs() < 1e-15);
        assert_eq!(found[3].section.parts().count(), 1);
    }
}
