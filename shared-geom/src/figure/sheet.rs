//! A white sheet of pixels, finer than the figure that it becomes.
//!
//! Most of a figure remains white: only the squares of the sheet with drawn pixels need
//! memory and time.

use std::cell::RefCell;

use super::color::Color;
use super::raster;

/// Sheet pixels in one figure pixel, along each side.
pub(super) const OVERSAMPLING: u32 = 2;
/// Sheet pixels along the side of a square.
const SIDE: usize = 32;
/// Figure pixels along the side of a square.
const MEANS: usize = SIDE / OVERSAMPLING as usize;
/// Bytes of a figure pixel: red, green, blue.
const CHANNELS: usize = 3;

/// Red, green and blue.
type Pixel = [u8; CHANNELS];
/// The pixels of a square, row by row.
type Square = [[Pixel; SIDE]; SIDE];

const WHITE: Pixel = [u8::MAX; CHANNELS];
/// Bytes of a white row of a square.
const WHITE_ROW: [u8; CHANNELS * SIDE] = [u8::MAX; CHANNELS * SIDE];
/// Opacity above which a color hides the color below it.
const OPAQUE: f64 = 1.0 - 1.0 / 256.0;

/// Pixels in squares; all-white squares are absent.
#[derive(Debug)]
pub(super) struct Sheet {
    /// Width and height [sheet pixels].
    size: (u32, u32),
    /// Squares in a row of them.
    columns: usize,
    squares: Vec<Option<Box<Square>>>,
}

thread_local! {
    /// Squares of earlier sheets of this thread: the system would have to clear new memory.
    static UNUSED: RefCell<Vec<Option<Box<Square>>>> = const { RefCell::new(Vec::new()) };
}

fn white_square() -> Box<Square> {
    const ALL: Square = [[WHITE; SIDE]; SIDE];
    let unused = UNUSED.try_with(|unused| unused.borrow_mut().pop());
    match unused.ok().flatten().flatten() {
        Some(mut square) => {
            *square = ALL;
            square
        }
        None => Box::new(ALL),
    }
}

impl Drop for Sheet {
    fn drop(&mut self) {
        let squares = self.squares.drain(..).filter(Option::is_some);
        // at the end of the thread they are freed
        let _kept = UNUSED.try_with(|unused| unused.borrow_mut().extend(squares));
    }
}

impl Sheet {
    /// The sheet of a figure of this width and height \[figure pixels\].
    pub fn new((width, height): (u32, u32)) -> Self {
        let size = (width * OVERSAMPLING, height * OVERSAMPLING);
        let [columns, rows] = [size.0, size.1].map(|length| (length as usize).div_ceil(SIDE));
        Self {
            size,
            columns,
            squares: vec![None; columns * rows],
        }
    }

    /// Width and height \[sheet pixels\].
    pub fn size(&self) -> (u32, u32) {
        self.size
    }

    /// Colors the pixels from `start` to before `end` of a row of the sheet.
    pub fn fill(&mut self, row: i32, start: i32, end: i32, color: Pixel) {
        self.each_piece(row, start, end, color == WHITE, |_, pixels| {
            pixels.fill(color);
        });
    }

    /// Fills the polygon with these corners \[sheet pixels\].
    pub fn polygon(&mut self, corners: &[[f64; 2]], color: Color) {
        let (width, height) = self.size;
        raster::each_span(corners, width, height, |span| {
            self.fill(span.row, span.start, span.end, color.bytes());
        });
    }

    /// Sets the pixels from `start` to before `end` of a row of the sheet to the colors
    /// of their columns.
    pub fn shade(&mut self, row: i32, start: i32, end: i32, color: impl Fn(i32) -> Pixel) {
        self.each_piece(row, start, end, false, |first, pixels| {
            for (pixel, column) in pixels.iter_mut().zip(first as i32..) {
                *pixel = color(column);
            }
        });
    }

    /// Calls `draw` with the pixels from `start` to before `end` of a row, square by
    /// square, each with its first column; skips white squares if `is_white` is drawn.
    fn each_piece(
        &mut self,
        row: i32,
        start: i32,
        end: i32,
        is_white: bool,
        mut draw: impl FnMut(usize, &mut [Pixel]),
    ) {
        let (width, height) = (self.size.0 as i32, self.size.1 as i32);
        if !(0..height).contains(&row) {
            return;
        }
        let [mut at, end] = [start, end].map(|column| column.clamp(0, width) as usize);
        let (above, inside) = (row as usize / SIDE, row as usize % SIDE);
        while at < end {
            let (left, first) = (at / SIDE, at % SIDE);
            let stop = end.min((left + 1) * SIDE);
            let square = &mut self.squares[above * self.columns + left];
            if !(is_white && square.is_none()) {
                let square = square.get_or_insert_with(white_square);
                draw(at, &mut square[inside][first..first + stop - at]);
            }
            at = stop;
        }
    }

    /// Mixes `color` into a pixel: fully if `alpha` is one, not at all if it is zero.
    pub fn blend(&mut self, (column, row): (i32, i32), color: Pixel, alpha: f64) {
        if alpha <= 0.0 {
            return;
        }
        if alpha >= OPAQUE {
            return self.fill(row, column, column + 1, color);
        }
        let part = (alpha * 256.0).floor() as i32;
        self.each_piece(row, column, column + 1, false, |_, pixels| {
            for (old, new) in pixels.as_flattened_mut().iter_mut().zip(color) {
                let change = (i32::from(new) - i32::from(*old)) * part / 256;
                *old = (i32::from(*old) + change) as u8;
            }
        });
    }

    /// The figure: the mean color of each square of [`OVERSAMPLING`] pixels, in rows of
    /// red, green, blue, written to `mean`.
    pub fn average(&self, mean: &mut Vec<u8>) {
        let (width, height) = (self.size.0 / OVERSAMPLING, self.size.1 / OVERSAMPLING);
        let (width, height) = (width as usize, height as usize);
        mean.clear();
        mean.resize(CHANNELS * width * height, u8::MAX);
        for (number, square) in self.squares.iter().enumerate() {
            let Some(square) = square else { continue };
            let left = MEANS * (number % self.columns);
            let top = MEANS * (number / self.columns);
            let right = width.min(left + MEANS);
            for row in top..height.min(top + MEANS) {
                let pixels = CHANNELS * (row * width + left)..CHANNELS * (row * width + right);
                let fine = OVERSAMPLING as usize * (row - top);
                average(&mut mean[pixels], [&square[fine], &square[fine + 1]]);
            }
        }
    }

    /// The figure in newly allocated memory.
    #[cfg(test)]
    pub fn averaged(&self) -> Vec<u8> {
        let mut mean = Vec::new();
        self.average(&mut mean);
        mean
    }
}

/// The mean colors of two pixels by two of these rows.
///
/// Most rows of the squares of a figure are white, and so is `mean` before.
fn average(mean: &mut [u8], [above, below]: [&[Pixel; SIDE]; OVERSAMPLING as usize]) {
    if above.as_flattened() == WHITE_ROW && below.as_flattened() == WHITE_ROW {
        return;
    }
    let mut sums = [0_u16; CHANNELS * SIDE];
    let rows = above.as_flattened().iter().zip(below.as_flattened());
    for (sum, (above, below)) in sums.iter_mut().zip(rows) {
        *sum = u16::from(*above) + u16::from(*below);
    }
    let pixels = mean.as_chunks_mut::<CHANNELS>().0.iter_mut();
    for (pixel, pair) in pixels.zip(sums.as_chunks::<{ 2 * CHANNELS }>().0) {
        for channel in 0..CHANNELS {
            pixel[channel] = ((pair[channel] + pair[channel + CHANNELS]) / 4) as u8;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn averaging_takes_the_mean_of_each_square() {
        // Three figure pixels: one half black and half white, one of 200, one white.
        let mut sheet = Sheet::new((3, 1));
        sheet.fill(0, 0, 1, [0; 3]);
        sheet.fill(1, 1, 2, [0; 3]);
        sheet.fill(0, 2, 4, [200; 3]);
        sheet.shade(1, 2, 4, |column| [if column < 4 { 200 } else { 0 }; 3]);
        let expected = [[127; 3], [200; 3], [255; 3]];
        assert_eq!(sheet.averaged(), expected.as_flattened());
    }

    /// Rows and columns beyond the sheet are ignored, on the edge of the last square too.
    #[test]
    fn what_lies_beyond_the_sheet_is_cut_off() {
        let (width, height) = (40, 19);
        let mut sheet = Sheet::new((width, height));
        for row in -5..100 {
            sheet.fill(row, -7, 300, [10, 20, 30]);
        }
        let pixels = sheet.averaged();
        assert_eq!(pixels.len(), 3 * (width * height) as usize);
        assert!(pixels.chunks(3).all(|pixel| pixel == [10, 20, 30]));
    }

    #[test]
    fn white_on_white_takes_no_memory_and_white_on_color_hides_it() {
        let mut sheet = Sheet::new((40, 40));
        sheet.fill(3, 0, 80, WHITE);
        assert!(sheet.squares.iter().all(Option::is_none));
        sheet.fill(3, 0, 80, [0; 3]);
        sheet.fill(3, 0, 80, WHITE);
        assert!(sheet.averaged().iter().all(|value| *value == 255));
    }

    /// A quarter of black on white, a half of white on black.
    #[test]
    fn colors_are_mixed_by_their_parts() {
        let mut sheet = Sheet::new((1, 1));
        for point in [(0, 0), (1, 0), (0, 1), (1, 1)] {
            sheet.blend(point, [0; 3], 0.25);
        }
        assert_eq!(sheet.averaged(), [192; 3]);
        for point in [(0, 0), (1, 0), (0, 1), (1, 1)] {
            sheet.blend(point, [0; 3], 1.0);
            sheet.blend(point, [255; 3], 0.5);
            sheet.blend(point, [9; 3], 0.0);
        }
        assert_eq!(sheet.averaged(), [127; 3]);
    }
}
