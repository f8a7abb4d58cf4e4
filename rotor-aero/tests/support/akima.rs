//! Akima's interpolation (H. Akima, Journal of the ACM 17, 1970), with which CCBlade.jl reads its
//! polars.

/// Step between the rows \[deg\]: monotone cubics between them differ by less than 1e-6.
const STEP: f64 = 0.01;

/// The rows of a polar at small steps of the angle \[deg\], by Akima's cubics.
pub fn akima(mut rows: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    rows.dedup_by(|next, kept| next[0] <= kept[0]);
    let alpha: Vec<f64> = rows.iter().map(|row| row[0]).collect();
    let columns: Vec<Vec<f64>> = (1..rows[0].len())
        .map(|column| {
            let values: Vec<f64> = rows.iter().map(|row| row[column]).collect();
            slopes(&alpha, &values)
        })
        .collect();
    let mut dense = Vec::new();
    for i in 0..rows.len() - 1 {
        let length = alpha[i + 1] - alpha[i];
        let count = (length / STEP).ceil().max(1.0);
        for j in 0..count as usize {
            let at = length * j as f64 / count;
            let value = |(column, slope): (usize, &Vec<f64>)| {
                let [low, high] = [rows[i][column + 1], rows[i + 1][column + 1]];
                let secant = (high - low) / length;
                let second = (3.0 * secant - 2.0 * slope[i] - slope[i + 1]) / length;
                let third = (slope[i] + slope[i + 1] - 2.0 * secant) / length.powi(2);
                low + at * (slope[i] + at * (second + at * third))
            };
            let mut row = vec![alpha[i] + at];
            row.extend(columns.iter().enumerate().map(value));
            dense.push(row);
        }
    }
    dense.extend(rows.pop());
    dense
}

/// Slopes at the knots: of the secants on both sides, weighted by the changes of the secants on the
/// other side; beyond the ends secants change linearly.
fn slopes(x: &[f64], f: &[f64]) -> Vec<f64> {
    let inner = x.windows(2).zip(f.windows(2));
    let inner: Vec<f64> = inner.map(|(x, f)| (f[1] - f[0]) / (x[1] - x[0])).collect();
    let beyond = |end: f64, next: f64, count: f64| end + count * (end - next);
    let last = inner.len() - 1;
    let [first, second] = [inner[0], inner[1]];
    let mut secants = vec![beyond(first, second, 2.0), beyond(first, second, 1.0)];
    secants.extend(&inner);
    secants.extend([1.0, 2.0].map(|count| beyond(inner[last], inner[last - 1], count)));
    let slope = |m: &[f64]| {
        let [before, after] = [(m[1] - m[0]).abs(), (m[3] - m[2]).abs()];
        if before + after > 0.0 {
            (after * m[1] + before * m[2]) / (before + after)
        } else {
            0.5 * (m[1] + m[2])
        }
    };
    secants.windows(4).map(slope).collect()
}
