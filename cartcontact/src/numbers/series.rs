//! The coefficients of the series of artanh and of the exponential, in rows that are summed side by side.

use crate::Scalar;

/// c₀ + c₁ x + c₂ x² + c₃ x³ from x and x². In pairs, so that few operations wait for each other.
#[inline(always)]
pub(crate) fn four_terms<T: Scalar>(coefficients: &[f64; 4], x: T, square: T) -> T {
    // Not by `map` of the array, which compilers may leave as a call.
    let c = |place: usize| T::constant(coefficients[place]);
    (c(0) + c(1) * x) + (c(2) + c(3) * x) * square
}

/// 1/(2k + 1) for k from `first` on.
pub(super) const fn odd_reciprocals<const WIDTH: usize, const ROWS: usize>(
    first: usize,
) -> [[f64; WIDTH]; ROWS] {
    let mut terms = [[0.0; WIDTH]; ROWS];
    let mut place = 0;
    while place < WIDTH * ROWS {
        terms[place / WIDTH][place % WIDTH] = 1.0 / (2 * (first + place) + 1) as f64;
        place += 1;
    }
    terms
}

/// 1/k! for k from `first` > 0 on.
pub(super) const fn inverse_factorials<const WIDTH: usize, const ROWS: usize>(
    first: usize,
) -> [[f64; WIDTH]; ROWS] {
    let mut terms = [[0.0; WIDTH]; ROWS];
    let (mut term, mut k) = (1.0, 1);
    while k < first + WIDTH * ROWS {
        term /= k as f64;
        if k >= first {
            terms[(k - first) / WIDTH][(k - first) % WIDTH] = term;
        }
        k += 1;
    }
    terms
}
