//! Reads the packed lists of the report of a blade, bit by bit.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

/// Lists of integers of these lengths. Of each list: the order of the prediction in 2 bits, the
/// number k of low bits in 5, then for each number the error e of the prediction as u = 2e, or
/// -2e - 1: u / 2^k ones, a zero, and the low bits; or 20 ones and u in 40 bits.
pub fn unpacked(text: &str, lengths: &[usize]) -> Vec<Vec<i64>> {
    let bytes = STANDARD.decode(text).expect("base64");
    let bits: String = bytes.iter().map(|byte| format!("{byte:08b}")).collect();
    let mut rest = bits.as_str();
    let mut number = |count: usize| {
        let (bits, after) = rest.split_at(count);
        rest = after;
        i64::from_str_radix(&format!("0{bits}"), 2).expect("bits")
    };
    let mut lists = Vec::new();
    for &length in lengths {
        let (order, low) = (number(2), number(5) as usize);
        let mut list: Vec<i64> = vec![0, 0];
        for _ in 0..length {
            let mut ones = 0;
            while ones < 20 && number(1) == 1 {
                ones += 1;
            }
            let code = match ones {
                20 => number(40),
                _ => (ones << low) + number(low),
            };
            let error = if code % 2 == 0 {
                code / 2
            } else {
                -(code + 1) / 2
            };
            let [before, last] = [list[list.len() - 2], list[list.len() - 1]];
            let expected = [0, last, 2 * last - before][order as usize];
            list.push(expected + error);
        }
        lists.push(list.split_off(2));
    }
    assert!(rest.len() < 8, "{} bits are left", rest.len());
    lists
}
