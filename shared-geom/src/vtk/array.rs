//! An array of a field file, and its encoding.

use std::io::{self, Write};

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

use super::escape::escaped;

/// Bytes that are encoded at a time: three of them become four letters.
const PIECE: usize = 3 << 14;

/// Values with a name.
#[derive(Debug)]
pub(super) struct Array {
    name: String,
    /// Values of a point or cell.
    components: u32,
    values: Values,
}

/// Values of one kind.
#[derive(Debug)]
pub(super) enum Values {
    Double(Vec<f64>),
    Single(Vec<f32>),
    Whole(Vec<i64>),
    Natural(Vec<u64>),
    Byte(Vec<u8>),
}

impl Array {
    pub fn new(name: &str, components: u32, values: Values) -> Self {
        Self {
            name: name.to_owned(),
            components,
            values,
        }
    }

    /// Writes the array as an element of XML: the number of its bytes and the bytes, all
    /// encoded as letters.
    pub fn write(&self, out: &mut impl Write) -> io::Result<()> {
        let (kind, name) = (self.values.kind(), escaped(&self.name));
        write!(out, "<DataArray type=\"{kind}\" Name=\"{name}\"")?;
        if self.components != 1 {
            write!(out, " NumberOfComponents=\"{}\"", self.components)?;
        }
        write!(out, " format=\"binary\"")?;
        if let Some((low, high)) = self.values.range() {
            write!(out, " RangeMin=\"{low}\" RangeMax=\"{high}\"")?;
        }
        write!(out, ">")?;
        let mut letters = Letters::new(out);
        self.values.write(&mut letters)?;
        letters.finish()?;
        write!(out, "</DataArray>")
    }
}

impl Values {
    /// Name of the type in the format.
    fn kind(&self) -> &'static str {
        match self {
            Self::Double(_) => "Float64",
            Self::Single(_) => "Float32",
            Self::Whole(_) => "Int64",
            Self::Natural(_) => "UInt64",
            Self::Byte(_) => "UInt8",
        }
    }

    /// The smallest and the largest finite value.
    fn range(&self) -> Option<(f64, f64)> {
        let (low, high) = match self {
            Self::Double(values) => range(values.iter().copied()),
            Self::Single(values) => range(values.iter().copied().map(f64::from)),
            Self::Whole(values) => range(values.iter().map(|value| *value as f64)),
            Self::Natural(values) => range(values.iter().map(|value| *value as f64)),
            Self::Byte(values) => range(values.iter().copied().map(f64::from)),
        };
        (low <= high).then_some((low, high))
    }

    fn write<W: Write>(&self, letters: &mut Letters<'_, W>) -> io::Result<()> {
        match self {
            Self::Double(values) => letters.add(values, f64::to_le_bytes),
            Self::Single(values) => letters.add(values, f32::to_le_bytes),
            Self::Whole(values) => letters.add(values, i64::to_le_bytes),
            Self::Natural(values) => letters.add(values, u64::to_le_bytes),
            Self::Byte(values) => letters.add(values, u8::to_le_bytes),
        }
    }
}

fn range(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let none = (f64::INFINITY, f64::NEG_INFINITY);
    values.fold(none, |(low, high), value| (low.min(value), high.max(value)))
}

/// Encoder of bytes as letters (base 64), a piece at a time.
struct Letters<'a, W> {
    out: &'a mut W,
    bytes: Vec<u8>,
    text: String,
}

impl<'a, W: Write> Letters<'a, W> {
    fn new(out: &'a mut W) -> Self {
        Self {
            out,
            bytes: Vec::with_capacity(PIECE),
            text: String::with_capacity(PIECE / 3 * 4),
        }
    }

    /// Adds the number of bytes of `values`, and the bytes.
    fn add<T: Copy, const N: usize>(
        &mut self,
        values: &[T],
        bytes_of: impl Fn(T) -> [u8; N],
    ) -> io::Result<()> {
        let count = (N * values.len()) as u64;
        self.bytes.extend(count.to_le_bytes());
        let mut rest = values;
        while !rest.is_empty() {
            let space = (PIECE - self.bytes.len()).div_ceil(N);
            let (now, later) = rest.split_at(space.min(rest.len()));
            self.bytes
                .extend(now.iter().flat_map(|value| bytes_of(*value)));
            if self.bytes.len() >= PIECE {
                self.encode(PIECE)?;
            }
            rest = later;
        }
        Ok(())
    }

    /// Writes the first `count` bytes.
    fn encode(&mut self, count: usize) -> io::Result<()> {
        self.text.clear();
        STANDARD.encode_string(&self.bytes[..count], &mut self.text);
        self.bytes.drain(..count);
        self.out.write_all(self.text.as_bytes())
    }

    fn finish(mut self) -> io::Result<()> {
        self.encode(self.bytes.len())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn written(array: &Array) -> String {
        let mut out = Vec::new();
        array.write(&mut out).unwrap();
        String::from_utf8(out).unwrap()
    }

    /// One byte of value 1 after its count, 1 in eight bytes: AQAAAAAAAAAB by the tool
    /// base64.
    #[test]
    fn an_array_has_its_kind_its_range_and_its_bytes() {
        let array = Array::new("a < b", 1, Values::Byte(vec![1]));
        assert_eq!(
            written(&array),
            "<DataArray type=\"UInt8\" Name=\"a &lt; b\" format=\"binary\" \
             RangeMin=\"1\" RangeMax=\"1\">AQAAAAAAAAAB</DataArray>"
        );
        let none = Array::new("none", 3, Values::Double(vec![f64::NAN]));
        let shown = written(&none);
        assert!(shown.contains("Name=\"none\" NumberOfComponents=\"3\" format=\"binary\">CA"));
    }

    /// Arrays that end before, at and after the end of a piece equal arrays encoded at
    /// once.
    #[test]
    fn pieces_do_not_show() {
        for count in [PIECE / 8 - 2, PIECE / 8 - 1, PIECE / 8, 5 * PIECE / 8 + 1] {
            let values: Vec<u64> = (0..count as u64).collect();
            let mut bytes = (8 * count as u64).to_le_bytes().to_vec();
            bytes.extend(values.iter().flat_map(|value| value.to_le_bytes()));
            let shown = written(&Array::new("n", 1, Values::Natural(values)));
            let expected = format!(">{}<", STANDARD.encode(&bytes));
            assert!(shown.contains(&expected), "{count}");
        }
    }
}
