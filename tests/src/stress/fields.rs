//! Geometries whose exponents are known to the compiler but whose coefficients are not.

use cartcontact::{GapProfile, Scalar, gap_profile};

/// Even powers.
#[gap_profile(first * r^2 + second * r^4 + third * r^8)]
#[derive(Clone, Copy, Debug)]
struct Even<T> {
    first: T,
    second: T,
    third: T,
}

/// Even and odd powers.
#[gap_profile(first * r + second * r^2 + third * r^5)]
#[derive(Clone, Copy, Debug)]
struct Whole<T> {
    first: T,
    second: T,
    third: T,
}

/// Powers that are not whole, the last one not even a multiple of 1/4; all are exact in binary.
#[gap_profile(first * r^0.25 + second * r^2.5 + third * r^3.28125)]
#[derive(Clone, Copy, Debug)]
struct Real<T> {
    first: T,
    second: T,
    third: T,
}

/// High powers, far apart.
#[gap_profile(first * r^2 + second * r^12 + third * r^64)]
#[derive(Clone, Copy, Debug)]
struct High<T> {
    first: T,
    second: T,
    third: T,
}

/// The exponents of each geometry.
pub(super) const EXPONENTS: [[f64; 3]; 4] =
    [[2.0, 4.0, 8.0], [1.0, 2.0, 5.0], [0.25, 2.5, 3.28125], [2.0, 12.0, 64.0]];

/// The generated solver of the geometry `index` with these coefficients.
pub(super) fn solver<T: Scalar>(index: usize, [first, second, third]: [T; 3]) -> Box<dyn GapProfile<T>> {
    match index {
        0 => Box::new(Even { first, second, third }),
        1 => Box::new(Whole { first, second, third }),
        2 => Box::new(Real { first, second, third }),
        _ => Box::new(High { first, second, third }),
    }
}
