//! Pixels as PNG: a file, and an image within an SVG.

use std::io::Write;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

/// Bytes of a pixel: red, green, blue.
const CHANNELS: usize = 3;
const WHITE: [u8; CHANNELS] = [u8::MAX; CHANNELS];

/// Rows of red, green, blue as PNG.
///
/// Pixels of a figure mostly equal the pixels above or next to them, which one filter
/// finds without trying all of them.
pub(super) fn encode(
    output: impl Write,
    (width, height): (u32, u32),
    pixels: &[u8],
    color: png::ColorType,
) -> Result<(), png::EncodingError> {
    let mut encoder = png::Encoder::new(output, width, height);
    encoder.set_color(color);
    encoder.set_compression(png::Compression::Fast);
    encoder.set_filter(png::FilterType::Paeth);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(pixels)?;
    writer.finish()
}

/// The element of an SVG that shows these rows of red, green, blue from this corner on, with `finer` units
/// of the SVG in a pixel: the part that is not white, with white pixels transparent; empty if all are
/// white.
pub(super) fn element(
    (corner, (width, height)): ([u32; 2], (u32, u32)),
    pixels: &[u8],
    finer: u32,
) -> Result<String, png::EncodingError> {
    let pixels = pixels.as_chunks::<CHANNELS>().0;
    let Some(frame) = frame(pixels, width as usize) else {
        return Ok(String::new());
    };
    let [left, top, right, bottom] = frame;
    let rows = pixels.chunks(width as usize).take(height as usize);
    let rows = rows.skip(top).take(bottom - top);
    let shown = rows.flat_map(|row| &row[left..right]).flat_map(|pixel| {
        let [red, green, blue] = *pixel;
        let is_white = *pixel == WHITE;
        [red, green, blue, if is_white { 0 } else { u8::MAX }]
    });
    let mut rgba = Vec::with_capacity(4 * (right - left) * (bottom - top));
    rgba.extend(shown);
    let mut file = Vec::new();
    let size = ((right - left) as u32, (bottom - top) as u32);
    encode(&mut file, size, &rgba, png::ColorType::Rgba)?;
    let [x, y] = [corner[0] + left as u32, corner[1] + top as u32].map(|start| start * finer);
    let (wide, high) = (size.0 * finer, size.1 * finer);
    Ok(format!(
        "<image x=\"{x}\" y=\"{y}\" width=\"{wide}\" height=\"{high}\" \
         xlink:href=\"data:image/png;base64,{}\"/>\n",
        STANDARD.encode(file)
    ))
}

/// Left and upper edge of the part that is not white, and the edges after it; `None` if all is white.
fn frame(pixels: &[[u8; CHANNELS]], width: usize) -> Option<[usize; 4]> {
    let mut frame: Option<[usize; 4]> = None;
    for (y, row) in pixels.chunks(width).enumerate() {
        let Some(first) = row.iter().position(|pixel| *pixel != WHITE) else {
            continue;
        };
        let last = row.iter().rposition(|pixel| *pixel != WHITE);
        let end = last.map_or(first, |last| last + 1);
        let [left, top, right, _] = frame.unwrap_or([first, y, end, y]);
        frame = Some([left.min(first), top, right.max(end), y + 1]);
    }
    frame
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A red and a blue pixel in a white sheet of five by four: an image of three by two at (1, 1).
    #[test]
    fn images_have_the_drawn_part() {
        let (width, height) = (5, 4);
        let mut pixels = vec![u8::MAX; CHANNELS * width * height];
        for (x, y, color) in [(1, 1, [255, 0, 0]), (3, 2, [0, 0, 255])] {
            let at = CHANNELS * (width * y + x);
            pixels[at..at + CHANNELS].copy_from_slice(&color);
        }
        let shown = element(([0; 2], (5, 4)), &pixels, 8).unwrap();
        let begin = "<image x=\"8\" y=\"8\" width=\"24\" height=\"16\" \
                     xlink:href=\"data:image/png;base64,";
        let data = shown.strip_prefix(begin).expect(&shown);
        let file = STANDARD
            .decode(data.strip_suffix("\"/>\n").unwrap())
            .unwrap();
        let mut reader = png::Decoder::new(file.as_slice()).read_info().unwrap();
        let mut found = vec![0; reader.output_buffer_size()];
        reader.next_frame(&mut found).unwrap();
        let none = [255, 255, 255, 0];
        let expected = [[255, 0, 0, 255], none, none, none, none, [0, 0, 255, 255]];
        assert_eq!(found, expected.as_flattened());
        let white = vec![u8::MAX; CHANNELS * width * height];
        assert_eq!(element(([0; 2], (5, 4)), &white, 8).unwrap(), "");
    }
}
