//! Lists of integers as short texts.
//!
//! The numbers of a list are predicted from the ones before them, by a polynomial of the order
//! that makes the shortest code, and the errors e of the prediction are Rice codes: of the number
//! u = 2e, or -2e - 1 if e is negative, u / 2^k one-bits, a zero-bit, and the k low bits of u.
//!
//! ```text
//! order 0: 0,    order 1: a[i-1],    order 2: 2 a[i-1] - a[i-2],    numbers before a[0] are 0
//! ```
//!
//! # References
//! - R. F. Rice, *Some practical universal noiseless coding techniques*, JPL 79-22, 1979.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

/// Orders of prediction.
const ORDERS: u32 = 3;
/// Largest number of low bits.
const MOST_LOW: u32 = 30;
/// One-bits after which all bits of a number follow.
const LONG: u32 = 20;
/// Bits of such a number.
const WHOLE: u32 = 40;

/// Bits, the first one of a byte in its highest place.
#[derive(Debug, Default)]
struct Bits {
    bytes: Vec<u8>,
    /// Bits of the last byte that are free.
    free: u32,
}

impl Bits {
    fn push(&mut self, bit: bool) {
        if self.free == 0 {
            self.bytes.push(0);
            self.free = 8;
        }
        self.free -= 1;
        if let Some(last) = self.bytes.last_mut() {
            *last |= u8::from(bit) << self.free;
        }
    }

    /// The low bits of a number, the highest one first.
    fn number(&mut self, number: u64, count: u32) {
        (0..count)
            .rev()
            .for_each(|bit| self.push(number >> bit & 1 == 1));
    }

    /// The Rice code of a number.
    fn code(&mut self, number: u64, low: u32) {
        let high = number >> low;
        if high >= u64::from(LONG) {
            (0..LONG).for_each(|_| self.push(true));
            self.number(number, WHOLE);
            return;
        }
        (0..high).for_each(|_| self.push(true));
        self.push(false);
        self.number(number, low);
    }
}

/// Lists of integers in one text, in base64: of each list the order of the prediction in 2 bits, k
/// in 5 bits, and the codes. Integers are smaller than 2^36.
pub(super) fn packed(lists: &[Vec<i64>]) -> String {
    let mut bits = Bits::default();
    for list in lists {
        let orders = (0..ORDERS).map(|order| {
            let errors = errors(list, order);
            let low = best_low(&errors);
            (length(&errors, low), order, low)
        });
        let (_, order, low) = orders.min().unwrap_or_default();
        bits.number(order.into(), 2);
        bits.number(low.into(), 5);
        for error in errors(list, order) {
            bits.code(error, low);
        }
    }
    STANDARD.encode(bits.bytes)
}

/// The errors of the prediction, without signs.
fn errors(list: &[i64], order: u32) -> Vec<u64> {
    let (mut last, mut before) = (0, 0);
    let error = |number: &i64| {
        let expected = match order {
            0 => 0,
            1 => last,
            _ => 2 * last - before,
        };
        (before, last) = (last, *number);
        let error = number - expected;
        (error << 1 ^ error >> 63) as u64
    };
    list.iter().map(error).collect()
}

/// The number of low bits that makes the shortest codes: near the bits of the mean.
fn best_low(errors: &[u64]) -> u32 {
    let mean = errors.iter().sum::<u64>() / (errors.len() as u64).max(1);
    let bits = mean.checked_ilog2().unwrap_or(0);
    let near = bits.saturating_sub(2)..=(bits + 1).min(MOST_LOW);
    near.min_by_key(|low| length(errors, *low)).unwrap_or(0)
}

/// Bits of the codes.
fn length(errors: &[u64], low: u32) -> u64 {
    let of = |error: &u64| match error >> low {
        high if high >= u64::from(LONG) => u64::from(LONG + WHOLE),
        high => high + 1 + u64::from(low),
    };
    errors.iter().map(of).sum()
}

#[cfg(test)]
#[path = "../../../tests/common/unpacked.rs"]
pub(super) mod unpacked;

#[cfg(test)]
mod tests {
    use super::packed;
    use super::unpacked::unpacked;

    /// Random lists of numbers from one bit to 36 bits, lines, parabolas, jumps and empty ones are
    /// read again; a line costs a bit a number, a constant list too.
    #[test]
    fn lists_are_read_again() {
        let mut state = 5_u64;
        let mut random = || {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            state
        };
        let mut lists: Vec<Vec<i64>> = Vec::new();
        for size in 0..36 {
            let number = |_| ((random() >> (63 - size)) as i64) - (1 << size);
            lists.push((0..20).map(number).collect());
        }
        lists.push(Vec::new());
        lists.push((0..50).map(|i| 7 * i - 100).collect());
        lists.push((0..50).map(|i| i * i).collect());
        lists.push((0..50).map(|i| if i == 30 { 1 << 35 } else { i }).collect());
        let lengths: Vec<usize> = lists.iter().map(Vec::len).collect();
        assert_eq!(unpacked(&packed(&lists), &lengths), lists);

        for line in [vec![0; 800], (0..800).collect()] {
            let text = packed(&[line]);
            // four letters for three bytes
            assert!(text.len() < 150, "{}", text.len());
        }
    }
}
