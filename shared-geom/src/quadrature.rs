//! Integration rules on the reference line, triangle and quadrilateral.
//!
//! A rule replaces the integral of `f` by the sum of `weight * f(point)`. All points are
//! inside the reference cell and all weights are positive.
//!
//! A request without a rule returns the empty slice (sums over it are zero): check
//! `is_empty()`, or stay within [`LARGEST_TRIANGLE_DEGREE`],
//! [`LARGEST_QUADRILATERAL_RULE`] and [`LARGEST_LINE_RULE`].
//!
//! # References
//! - M. Abramowitz, I. A. Stegun, "Handbook of mathematical functions", 25.4.29
//!   and table 25.4 (Gauss-Legendre).
//! - G. R. Cowper, "Gaussian quadrature formulas for triangles", Int. J. Numerical
//!   Methods in Engineering 7, 1973 (degrees 2, 4, 5).
//! - D. A. Dunavant, "High degree efficient symmetrical Gaussian quadrature rules
//!   for the triangle", Int. J. Numerical Methods in Engineering 21, 1985.

use std::f64::consts::PI;
use std::sync::LazyLock;

/// A point of a plane rule.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlanePoint {
    /// First reference coordinate [-].
    pub r: f64,
    /// Second reference coordinate [-].
    pub s: f64,
    /// Weight, a part of the area of the reference cell [-].
    pub weight: f64,
}

/// Largest polynomial degree for which [`triangle`] has a rule; all lower degrees have
/// one.
pub const LARGEST_TRIANGLE_DEGREE: usize = 5;

/// Largest number of points in each direction for which [`quadrilateral`] has a rule,
/// from one.
pub const LARGEST_QUADRILATERAL_RULE: usize = 4;

/// Largest number of points for which [`line()`] has a rule, from one.
pub const LARGEST_LINE_RULE: usize = 20;

/// Smallest rule that integrates polynomials of total degree `degree` exactly over
/// the triangle (0,0), (1,0), (0,1); the weights sum to its area 1/2.
///
/// 1 point up to degree 1, 3 points for degree 2, 6 points for degrees 3 and 4
/// (the rule of 4 points for degree 3 has a negative weight), 7 points for degree 5. Above 5 there is no rule: the slice is empty.
pub fn triangle(degree: usize) -> &'static [PlanePoint] {
    match degree {
        0 | 1 => &TRIANGLE_1,
        2 => &TRIANGLE_3,
        3 | 4 => &TRIANGLE_6,
        5 => &TRIANGLE_7,
        _ => &[],
    }
}

/// Tensor product of Gauss rules over the square [-1,1] x [-1,1], `r` running fastest.
///
/// With `n` points in each direction, 1 to 4, monomials of degree up to `2n - 1` in
/// each of `r` and `s` are exact; the weights sum to 4. For other numbers there is
/// no rule: the slice is empty.
pub fn quadrilateral(points_per_direction: usize) -> &'static [PlanePoint] {
    match points_per_direction {
        1 => &QUADRILATERAL_1,
        2 => &QUADRILATERAL_4,
        3 => &QUADRILATERAL_9,
        4 => &QUADRILATERAL_16,
        _ => &[],
    }
}

/// Gauss-Legendre rule on [-1,1]: pairs of abscissa and weight, abscissas ascending.
///
/// With `n` points, 1 to 20, polynomials of degree up to `2n - 1` are exact; the
/// weights sum to 2. For other numbers there is no rule: the slice is empty.
pub fn line(points: usize) -> &'static [(f64, f64)] {
    match points {
        1 => &LINE_1,
        2 => &LINE_2,
        3 => &LINE_3,
        4 => &LINE_4,
        5 => &LINE_5,
        6 => &LINE_6,
        _ => LONGER_LINES
            .get(points.wrapping_sub(7))
            .map_or(&[], Vec::as_slice),
    }
}

/// Rules of 7 points and more.
static LONGER_LINES: LazyLock<Vec<Vec<(f64, f64)>>> =
    LazyLock::new(|| (7..=LARGEST_LINE_RULE).map(gauss_legendre).collect());

/// The rule of `n` points, from the roots of the Legendre polynomial by Newton's method:
///
/// ```text
/// k P_k = (2k-1) x P_{k-1} - (k-1) P_{k-2} ,  w = 2 / ((1-x^2) P_n'^2) ,  P_n' = n (P_{n-1} - x P_n)/(1-x^2)
/// ```
fn gauss_legendre(n: usize) -> Vec<(f64, f64)> {
    let size = n as f64;
    let point = |i: usize| {
        let mut x = -(PI * (i as f64 + 0.75) / (size + 0.5)).cos();
        let mut slope = 1.0;
        // The start is correct to four digits: four iterations reach round-off.
        for _ in 0..5 {
            let (mut before, mut p) = (1.0, x);
            for k in 2..=n {
                let k = k as f64;
                (before, p) = (p, ((2.0 * k - 1.0) * x * p - (k - 1.0) * before) / k);
            }
            slope = size * (before - x * p) / (1.0 - x * x);
            x -= p / slope;
        }
        (x, 2.0 / ((1.0 - x * x) * slope * slope))
    };
    (0..n).map(point).collect()
}

const fn point(r: f64, s: f64, weight: f64) -> PlanePoint {
    PlanePoint { r, s, weight }
}

static TRIANGLE_1: [PlanePoint; 1] = [point(1.0 / 3.0, 1.0 / 3.0, 0.5)];

static TRIANGLE_3: [PlanePoint; 3] = orbit(1.0 / 6.0, 2.0 / 3.0, 1.0 / 6.0);

// Two orbits (a, a), (1 - 2a, a), (a, 1 - 2a):
// a = (8 - sqrt 10 +- sqrt(38 - 44 sqrt(2/5)))/18,
// weight = (620 +- sqrt(213125 - 53320 sqrt 10))/7440.
static TRIANGLE_6: [PlanePoint; 6] = {
    let [a, b, c] = orbit(
        0.445_948_490_915_964_9,
        0.108_103_018_168_070_23,
        0.111_690_794_839_005_74,
    );
    let [d, e, f] = orbit(
        0.091_576_213_509_770_74,
        0.816_847_572_980_458_5,
        0.054_975_871_827_660_935,
    );
    [a, b, c, d, e, f]
};

// Centroid with weight 9/80, and two orbits with a = (6 -+ sqrt 15)/21,
// weight = (155 -+ sqrt 15)/2400.
static TRIANGLE_7: [PlanePoint; 7] = {
    let [a, b, c] = orbit(
        0.101_286_507_323_456_34,
        0.797_426_985_353_087_3,
        0.062_969_590_272_413_57,
    );
    let [d, e, f] = orbit(
        0.470_142_064_105_115_1,
        0.059_715_871_789_769_82,
        0.066_197_076_394_253_1,
    );
    let center = point(1.0 / 3.0, 1.0 / 3.0, 9.0 / 80.0);
    [center, a, b, c, d, e, f]
};

/// The three points with two area coordinates `a` and one `b = 1 - 2a`.
const fn orbit(a: f64, b: f64, weight: f64) -> [PlanePoint; 3] {
    [
        point(a, a, weight),
        point(b, a, weight),
        point(a, b, weight),
    ]
}

static QUADRILATERAL_1: [PlanePoint; 1] = tensor_product(&LINE_1);
static QUADRILATERAL_4: [PlanePoint; 4] = tensor_product(&LINE_2);
static QUADRILATERAL_9: [PlanePoint; 9] = tensor_product(&LINE_3);
static QUADRILATERAL_16: [PlanePoint; 16] = tensor_product(&LINE_4);

/// All pairs of points of a line rule; `M` is `N * N`, evaluated by the compiler.
const fn tensor_product<const N: usize, const M: usize>(line: &[(f64, f64); N]) -> [PlanePoint; M] {
    let mut rule = [point(0.0, 0.0, 0.0); M];
    let mut k = 0;
    while k < M {
        let ((r, across), (s, along)) = (line[k % N], line[k / N]);
        rule[k] = point(r, s, across * along);
        k += 1;
    }
    rule
}

const LINE_1: [(f64, f64); 1] = [(0.0, 2.0)];

const LINE_2: [(f64, f64); 2] = [
    (-0.577_350_269_189_625_7, 1.0),
    (0.577_350_269_189_625_7, 1.0),
];

const LINE_3: [(f64, f64); 3] = [
    (-0.774_596_669_241_483_4, 5.0 / 9.0),
    (0.0, 8.0 / 9.0),
    (0.774_596_669_241_483_4, 5.0 / 9.0),
];

const LINE_4: [(f64, f64); 4] = [
    (-0.861_136_311_594_052_6, 0.347_854_845_137_453_85),
    (-0.339_981_043_584_856_26, 0.652_145_154_862_546_1),
    (0.339_981_043_584_856_26, 0.652_145_154_862_546_1),
    (0.861_136_311_594_052_6, 0.347_854_845_137_453_85),
];

const LINE_5: [(f64, f64); 5] = [
    (-0.906_179_845_938_664, 0.236_926_885_056_189_08),
    (-0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
    (0.0, 128.0 / 225.0),
    (0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
    (0.906_179_845_938_664, 0.236_926_885_056_189_08),
];

const LINE_6: [(f64, f64); 6] = [
    (-0.932_469_514_203_152, 0.171_324_492_379_170_36),
    (-0.661_209_386_466_264_5, 0.360_761_573_048_138_6),
    (-0.238_619_186_083_196_9, 0.467_913_934_572_691_04),
    (0.238_619_186_083_196_9, 0.467_913_934_572_691_04),
    (0.661_209_386_466_264_5, 0.360_761_573_048_138_6),
    (0.932_469_514_203_152, 0.171_324_492_379_170_36),
];

#[cfg(test)]
mod tests {
    use super::*;

    fn factorial(n: i32) -> f64 {
        (1..=n).map(f64::from).product()
    }

    /// Rule minus closed form for `r^a s^b` over the triangle: `a! b!/(a + b + 2)!`.
    fn triangle_error(rule: &[PlanePoint], a: i32, b: i32) -> f64 {
        let exact = factorial(a) * factorial(b) / factorial(a + b + 2);
        let sum: f64 = rule
            .iter()
            .map(|p| p.weight * p.r.powi(a) * p.s.powi(b))
            .sum();
        sum - exact
    }

    /// Closed form of the integral of `x^a` over [-1,1].
    fn line_exact(a: i32) -> f64 {
        if a % 2 == 0 {
            2.0 / f64::from(a + 1)
        } else {
            0.0
        }
    }

    // Points are rounded to 1e-16, integrals are below 1/2.
    #[test]
    fn triangle_rules_are_exact_to_their_degree() {
        for degree in 0..=5 {
            for total in 0..=degree {
                for b in 0..=total {
                    let error = triangle_error(triangle(degree as usize), total - b, b);
                    assert!(error.abs() < 2e-16, "degree {degree}: {error}");
                }
            }
        }
    }

    // At the next degree some monomial must be wrong, or the test above is too weak.
    #[test]
    fn triangle_rules_are_not_exact_above_their_degree() {
        for (degree, own) in [(1, 1), (2, 2), (3, 4), (4, 4), (5, 5)] {
            let errors = (0..=own + 1).map(|b| triangle_error(triangle(degree), own + 1 - b, b));
            assert!(errors.fold(0.0, |worst: f64, e| worst.max(e.abs())) > 1e-5);
        }
    }

    #[test]
    fn triangle_rules_are_positive_inside_and_have_the_stated_points() {
        for (degree, count) in [(0, 1), (1, 1), (2, 3), (3, 6), (4, 6), (5, 7)] {
            let rule = triangle(degree);
            assert_eq!(rule.len(), count);
            for p in rule {
                assert!(p.weight > 0.0 && p.r > 0.0 && p.s > 0.0 && p.r + p.s < 1.0);
                // Symmetry: the point with exchanged coordinates is in the rule too.
                assert!(rule.contains(&point(p.s, p.r, p.weight)));
            }
        }
    }

    // Error constant of Gauss-Legendre (Abramowitz and Stegun 25.4.30): for x^2n the rule
    // is too small by 2^(2n+1) (n!)^4 / ((2n+1) ((2n)!)^2), 7e-4 for n = 6, 9e-12 for n = 20.
    #[test]
    fn line_rules_are_exact_to_their_degree_and_miss_the_next_as_known() {
        for n in 1..=LARGEST_LINE_RULE as i32 {
            let sum = |a: i32| -> f64 { line(n as usize).iter().map(|(x, w)| w * x.powi(a)).sum() };
            for a in 0..2 * n {
                assert!((sum(a) - line_exact(a)).abs() < 2e-15, "{n} points, x^{a}");
            }
            let shortfall = 2f64.powi(2 * n + 1) * factorial(n).powi(4)
                / (f64::from(2 * n + 1) * factorial(2 * n).powi(2));
            assert!((line_exact(2 * n) - sum(2 * n) - shortfall).abs() < 2e-15);
        }
    }

    // Roots of the Legendre polynomial by its recurrence, weight 2/((1 - x^2) P'^2):
    // P' reaches 20 at the ends for 6 points and 180 for 20, so P(x) is zero to some 1e-15 and 3e-14.
    #[test]
    fn line_points_are_roots_of_legendre_polynomials() {
        for n in 1..=LARGEST_LINE_RULE {
            assert_eq!(line(n).len(), n);
            let within = if n <= 6 { 3e-15 } else { 5e-14 };
            for &(x, weight) in line(n) {
                let (mut before, mut p) = (1.0, x);
                for k in 2..=n {
                    let k = k as f64;
                    (before, p) = (p, ((2.0 * k - 1.0) * x * p - (k - 1.0) * before) / k);
                }
                let slope = n as f64 * (before - x * p) / (1.0 - x * x);
                assert!(p.abs() < within);
                assert!((weight - 2.0 / ((1.0 - x * x) * slope * slope)).abs() < 3e-15);
            }
        }
    }

    // Integrals up to 4: roundings of some 1e-15.
    #[test]
    fn quadrilateral_rules_are_exact_to_their_degree_and_no_further() {
        for n in 1..=4 {
            let rule = quadrilateral(n as usize);
            assert_eq!(rule.len(), (n * n) as usize);
            let error = |a: i32, b: i32| -> f64 {
                let sum: f64 = rule
                    .iter()
                    .map(|p| p.weight * p.r.powi(a) * p.s.powi(b))
                    .sum();
                (sum - line_exact(a) * line_exact(b)).abs()
            };
            for a in 0..2 * n {
                for b in 0..2 * n {
                    assert!(error(a, b) < 3e-15, "{n} points, r^{a} s^{b}");
                }
            }
            assert!(error(2 * n, 0) > 1e-3 && error(0, 2 * n) > 1e-3);
        }
    }

    #[test]
    fn requests_without_a_rule_are_empty_and_the_stated_ranges_are_not() {
        assert!(triangle(LARGEST_TRIANGLE_DEGREE + 1).is_empty());
        assert!(triangle(usize::MAX).is_empty());
        assert!(
            quadrilateral(0).is_empty() && quadrilateral(LARGEST_QUADRILATERAL_RULE + 1).is_empty()
        );
        assert!(line(0).is_empty() && line(LARGEST_LINE_RULE + 1).is_empty());
        assert!((0..=LARGEST_TRIANGLE_DEGREE).all(|degree| !triangle(degree).is_empty()));
        assert!((1..=LARGEST_QUADRILATERAL_RULE).all(|points| !quadrilateral(points).is_empty()));
        assert!((1..=LARGEST_LINE_RULE).all(|points| !line(points).is_empty()));
    }
}
