//! The coefficients of the series of artanh and of the exponential, in rows as they are summed side by side.

/// 1/(2k + 1) from a k on.
pub(crate) const fn odd_reciprocals<const WIDTH: usize, const ROWS: usize>(
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

/// 1/k! from a k above 0 on.
pub(crate) const fn inverse_factorials<const WIDTH: usize, const ROWS: usize>(
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
