//! Changes to a file, drawn from a fixed seed.

/// Pseudo-random numbers: splitmix64, of period 2^64.
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number below `end`, which is not zero.
    pub fn below(&mut self, end: usize) -> usize {
        (self.next() % end as u64) as usize
    }

    fn of<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[self.below(choices.len())]
    }
}

/// Texts that replace numbers, mostly invalid ones.
const WORDS: [&str; 14] = [
    "1000000000000000000",
    "18446744073709551615",
    "99999999999999999999",
    "-1",
    "-1000000000000000000",
    "0",
    "nan",
    "NaN",
    "inf",
    "-inf",
    "1e999",
    "1e-999",
    "4294967296",
    "2147483648",
];

const WHOLE: [u64; 8] = [
    0,
    1,
    u64::MAX,
    1_000_000_000_000_000_000,
    1 << 31,
    1 << 32,
    1 << 63,
    7,
];

const REAL: [f64; 6] = [
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::MAX,
    -0.0,
    5e-324,
];

/// The file after one to four changes.
pub fn mutated(seed: &[u8], random: &mut Random) -> Vec<u8> {
    let mut bytes = seed.to_vec();
    for _ in 0..=random.below(4) {
        if bytes.is_empty() {
            break;
        }
        change(&mut bytes, random);
    }
    bytes
}

fn change(bytes: &mut Vec<u8>, random: &mut Random) {
    let at = random.below(bytes.len());
    match random.below(10) {
        0 => bytes[at] ^= 1 << random.below(8),
        1 => bytes[at] = random.next() as u8,
        2 => bytes.truncate(at),
        3 => {
            let end = (at + 1 + random.below(40)).min(bytes.len());
            bytes.drain(at..end);
        }
        4 => {
            let end = (at + 1 + random.below(200)).min(bytes.len());
            let copy = bytes[at..end].to_vec();
            let to = random.below(bytes.len());
            bytes.splice(to..to, copy);
        }
        5 | 6 => replace_word(bytes, at, random),
        7 => {
            let number = random.of(&WHOLE);
            let four = (number as u32).to_le_bytes();
            let eight = number.to_le_bytes();
            let number = if random.below(2) == 0 {
                &four[..]
            } else {
                &eight
            };
            overwrite(bytes, at, number, random);
        }
        8 => overwrite(bytes, at, &random.of(&REAL).to_le_bytes(), random),
        _ => swap_sections(bytes, random),
    }
}

/// Overwrites bytes with a number, in either byte order.
fn overwrite(bytes: &mut [u8], at: usize, number: &[u8], random: &mut Random) {
    let mut number = number.to_vec();
    if random.below(2) == 0 {
        number.reverse();
    }
    for (byte, new) in bytes[at..].iter_mut().zip(number) {
        *byte = new;
    }
}

/// Replaces the word at an index.
fn replace_word(bytes: &mut Vec<u8>, at: usize, random: &mut Random) {
    let is_word = |byte: &u8| byte.is_ascii_alphanumeric() || b".+-".contains(byte);
    let begin = bytes[..at].iter().rposition(|byte| !is_word(byte));
    let begin = begin.map_or(0, |before| before + 1);
    let length = bytes[at..].iter().position(|byte| !is_word(byte));
    let end = length.map_or(bytes.len(), |length| at + length);
    bytes.splice(begin..end, random.of(&WORDS).bytes());
}

/// Exchanges two pieces between lines that begin with `$`, `[` or `{`.
fn swap_sections(bytes: &mut [u8], random: &mut Random) {
    let mut cuts: Vec<usize> = (1..bytes.len())
        .filter(|&i| bytes[i - 1] == b'\n' && b"$[{".contains(&bytes[i]))
        .collect();
    cuts.push(bytes.len());
    let mut ends: Vec<usize> = (0..3).map(|_| random.of(&cuts)).collect();
    ends.sort_unstable();
    let [a, b, c] = [ends[0], ends[1], ends[2]];
    bytes[a..c].rotate_left(b - a);
}
