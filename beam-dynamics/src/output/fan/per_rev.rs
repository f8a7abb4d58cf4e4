//! Multiples of the rotor speed: thin lines, labeled where the plot is free.

use shared_geom::figure::{Anchor, Axes, Color, Drawing, Label, SMALL, Stroke, WHITE, text_width};

use super::boxes::{Box2, Obstacles};
use crate::case::FrequencyUnit;

/// Line of a multiple.
pub(super) const STROKE: Stroke = Stroke {
    color: Color(175, 175, 175),
    width: 2.0,
    pattern: 0,
};
const DARK_GRAY: Color = Color(105, 105, 105);
const LETTERS: f64 = 0.85 * SMALL;

/// A line that leaves the frame before this part of the speeds is left out.
const FIRST_EXIT: f64 = 0.25;

/// A multiple of the rotor speed within the frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Multiple {
    number: f64,
    /// Positions at which the line enters and leaves the frame.
    ends: [[f64; 2]; 2],
}

/// The chosen multiples that cross the frame; if none are chosen, the first ten, then fewer, up to
/// the first that leaves the frame early.
pub(super) fn multiples(axes: &Axes, unit: FrequencyUnit, chosen: Option<&[u32]>) -> Vec<Multiple> {
    if let Some(chosen) = chosen {
        let lines = chosen
            .iter()
            .filter_map(|number| multiple((axes, unit), *number, 0.0));
        return lines.collect();
    }
    let numbers = (1..=10).chain([15, 20, 30, 50, 100]);
    numbers
        .map_while(|number| multiple((axes, unit), number, FIRST_EXIT))
        .collect()
}

/// The line of n per revolution within the frame; `None` if it leaves it before `part` of the
/// speeds.
fn multiple((axes, unit): (&Axes, FrequencyUnit), number: u32, part: f64) -> Option<Multiple> {
    let [low, high] = axes.x;
    let highest = axes.y[1];
    let number = f64::from(number);
    // The line over the speed; per revolution it is horizontal.
    let slope = match unit {
        FrequencyUnit::PerRevolution => 0.0,
        FrequencyUnit::RadiansPerSecond => number,
        unit => unit.value(number / 60.0, 0.0)?,
    };
    let exit = match slope > 0.0 {
        true => high.min(highest / slope),
        false if number > highest => low,
        false => high,
    };
    let height = |speed: f64| if slope > 0.0 { slope * speed } else { number };
    (exit - low > part * (high - low)).then(|| Multiple {
        number,
        ends: [low, exit].map(|speed| axes.position([speed, height(speed)])),
    })
}

/// Draws the lines.
pub(super) fn draw_lines(drawing: &mut Drawing, multiples: &[Multiple]) {
    for multiple in multiples {
        STROKE.draw(drawing, &multiple.ends);
    }
}

/// Writes `1P`, `2P` and so on at the lines, as far out as they cover nothing: over the line, or
/// else below or above it. Labels without a free position are omitted.
pub(super) fn draw_labels(
    drawing: &mut Drawing,
    axes: &Axes,
    multiples: &[Multiple],
    obstacles: &mut Obstacles,
) {
    let frame = Box2 {
        low: [axes.left, axes.top],
        high: [axes.right, axes.bottom],
    };
    for multiple in multiples {
        let text = format!("{}P", multiple.number);
        let width = text_width(&text, Label::new(LETTERS));
        let mut in_the_way = obstacles.clone();
        for other in multiples.iter().filter(|other| *other != multiple) {
            in_the_way.add_line(&other.ends);
        }
        let candidates = multiple
            .candidates(width)
            .filter(|position| position.label.is_within(&frame));
        let best = candidates.min_by_key(|position| in_the_way.covered(&position.needs));
        let Some(position) = best.filter(|position| in_the_way.is_free(&position.needs)) else {
            continue;
        };
        obstacles.add_box(position.label);
        drawing.polygon(&position.label.corners(), WHITE);
        let label = Label::new(LETTERS)
            .anchored(Anchor::Middle)
            .colored(DARK_GRAY);
        drawing.text(&text, position.label.center(), label);
    }
}

/// A position for a label.
struct Candidate {
    label: Box2,
    /// Required free area: the label, and the space between it and its line.
    needs: Box2,
}

impl Multiple {
    /// Positions for a label of `width`, in order of preference.
    fn candidates(&self, width: f64) -> impl Iterator<Item = Candidate> {
        let [a, b] = self.ends;
        // At this height the label is clear of the line.
        let slope = ((b[1] - a[1]) / (b[0] - a[0])).abs();
        let clear = slope * (0.5 * width + 0.2 * LETTERS) + 0.5 * LETTERS + 3.0;
        [0.0, clear, -clear].into_iter().flat_map(move |beside| {
            (10..100).rev().map(move |percent| {
                let s = f64::from(percent) / 100.0;
                let on_line = [a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])];
                let label = Box2::around([on_line[0], on_line[1] + beside], width, LETTERS);
                Candidate {
                    label,
                    needs: label.with_height(on_line[1]),
                }
            })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn axes(highest: f64) -> Axes {
        Axes {
            left: 0.0,
            right: 1000.0,
            top: 0.0,
            bottom: 1000.0,
            x: [0.0, 600.0],
            y: [0.0, highest],
        }
    }

    fn first(highest: f64) -> Vec<Multiple> {
        multiples(&axes(highest), FrequencyUnit::Hertz, None)
    }

    // At 600 rpm = 10 Hz, 3P is 30 Hz: it leaves a frame of 40 Hz at three quarters of
    // its height, 5P at four fifths of its width.
    #[test]
    fn lines_end_at_the_frame() {
        let found = first(40.0);
        assert_eq!(found[2].ends, [[0.0, 1000.0], [1000.0, 250.0]]);
        assert_eq!(found[4].ends, [[0.0, 1000.0], [800.0, 0.0]]);
    }

    #[test]
    fn chosen_multiples_are_drawn_in_each_unit() {
        let ends = |unit, highest| {
            let lines = multiples(&axes(highest), unit, Some(&[3, 50]));
            lines.iter().map(|line| line.ends).collect::<Vec<_>>()
        };
        // 3P of 600 rpm is 30 Hz = 1800 rpm; 50P leaves 2400 rpm at 48 rpm.
        let expected = [
            [[0.0, 1000.0], [1000.0, 250.0]],
            [[0.0, 1000.0], [80.0, 0.0]],
        ];
        assert_eq!(ends(FrequencyUnit::Hertz, 40.0), expected);
        assert_eq!(ends(FrequencyUnit::Rpm, 2400.0), expected);
        let level = [[[0.0, 250.0], [1000.0, 250.0]]];
        assert_eq!(ends(FrequencyUnit::PerRevolution, 4.0), level);
    }

    #[test]
    fn after_ten_they_are_thinned() {
        let numbers: Vec<_> = first(400.0).iter().map(|m| m.number).collect();
        assert_eq!(numbers[8..], [9.0, 10.0, 15.0, 20.0, 30.0, 50.0, 100.0]);
        // 15P leaves a frame of 40 Hz at 160 of 600 rpm, 20P at 120.
        assert_eq!(first(40.0).len(), 11);
        assert_eq!(first(2.0), []);
    }

    #[test]
    fn labels_beside_a_line_clear_it() {
        let line = first(40.0)[2];
        let mut obstacles = Obstacles::default();
        obstacles.add_line(&line.ends);
        let beside = |position: &Candidate| obstacles.is_free(&position.label);
        assert_eq!(line.candidates(30.0).filter(beside).count(), 180);
    }
}
