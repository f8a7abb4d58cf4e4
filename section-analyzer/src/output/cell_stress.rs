//! Stresses of the cells of a section per unit internal force, as short numbers.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use nalgebra::Matrix6;
use serde::Serialize;

/// The largest number of 16 bits with its negative.
const LARGEST: f64 = 32767.0;

/// Mean stresses of the cells of a section per unit internal force about the reference point, in
/// material axes. Arrays are little-endian, in base64.
///
/// A stress is its number times the scale of its ply, force and component. The scale is the
/// largest stress there over 32767, so that the error is at most half of the scale.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct CellStress {
    /// Signed integers of 16 bits: by ply, force (the six components of the internal force),
    /// component (11 22 33 23 13 12), cell of the ply.
    pub values: String,
    /// Floats of 32 bits, by ply, force, component \[1/m^2, 1/m^3\].
    pub scales: String,
}

impl CellStress {
    /// The stresses of cells by ply: for each cell six rows of stress, a column per force.
    pub fn new<'a>(plies: impl Iterator<Item = Vec<&'a Matrix6<f64>>>) -> Self {
        let (mut values, mut scales) = (Vec::new(), Vec::new());
        for cells in plies {
            for (force, component) in (0..36).map(|number| (number / 6, number % 6)) {
                let stresses = || cells.iter().map(|cell| cell[(component, force)]);
                let largest = stresses().fold(0.0_f64, |most, stress| most.max(stress.abs()));
                let scale = (largest / LARGEST) as f32;
                scales.extend(scale.to_le_bytes());
                let number = |stress: f64| match scale > 0.0 {
                    true => (stress / f64::from(scale)).round() as i16,
                    false => 0,
                };
                values.extend(stresses().flat_map(|stress| number(stress).to_le_bytes()));
            }
        }
        Self {
            values: STANDARD.encode(values),
            scales: STANDARD.encode(scales),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn decoded<const N: usize, T>(text: &str, number: impl Fn([u8; N]) -> T) -> Vec<T> {
        let bytes = STANDARD.decode(text).unwrap();
        let parts = bytes.chunks_exact(N);
        parts.map(|part| number(part.try_into().unwrap())).collect()
    }

    /// 300 random stresses in plies of 1 to 5 cells, over 12 orders of magnitude: errors are at
    /// most half of the scale, which is the largest stress over 32767 to the round-off of 32
    /// bits (6e-8 of 32767 steps).
    #[test]
    fn errors_are_half_of_the_scale() {
        let mut state = 5_u64;
        let mut random = || {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
        };
        let mut plies: Vec<Vec<Matrix6<f64>>> = Vec::new();
        for number in 0..100 {
            let cell = |_| Matrix6::from_fn(|_, _| random() * 10_f64.powf(6.0 * random()));
            plies.push((0..1 + number % 5).map(cell).collect());
        }
        plies.push(vec![Matrix6::zeros(); 2]);
        let short = CellStress::new(plies.iter().map(|cells| cells.iter().collect()));
        let values = decoded(&short.values, i16::from_le_bytes);
        let scales = decoded(&short.scales, f32::from_le_bytes);
        let mut values = values.into_iter();
        for (ply, cells) in plies.iter().enumerate() {
            for number in 0..36 {
                let scale = f64::from(scales[36 * ply + number]);
                let mut largest = 0.0_f64;
                for cell in cells {
                    let exact = cell[(number % 6, number / 6)];
                    let error = f64::from(values.next().unwrap()) * scale - exact;
                    assert!(error.abs() <= 0.503 * scale, "{ply} {number}: {error}");
                    largest = largest.max(exact.abs());
                }
                assert!((scale * LARGEST - largest).abs() <= 1e-7 * largest);
            }
        }
        assert_eq!((values.next(), scales.len()), (None, 36 * plies.len()));
    }
}
