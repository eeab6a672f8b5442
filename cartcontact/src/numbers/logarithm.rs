//! ln of the ratio of two lengths without branches and tables, for loops over many values that compile to vector code.

use core::f64::consts::{LN_2, SQRT_2};

use super::bits::{exponent, fraction};
use super::series::{four_terms, odd_reciprocals};
use crate::Scalar;
use crate::scalar::{is_same, smallest_normal};

/// ln(1 − depth) from the depth and the `ratio` 1 − depth, both in (0, 1] and one of them exact. Within 2.5 ε, the
/// error where ln f takes half of ln 2 away again.
///
/// ratio = 2^e f with 1/√2 ≤ f < √2. Next to 1 the depth has the digits that the ratio has lost: f − 1 is −depth where
/// e = 0. ln f = 2 artanh t with t = (f − 1)/(f + 1), |t| ≤ 0.172. The series leaves out 8e-23 after t²⁵, and 4e-10
/// after t⁹ in single precision.
#[inline(always)]
pub(crate) fn log_of_ratio<T: Scalar>(ratio: T, depth: T) -> T {
    let (one, two) = (T::one(), T::constant(2.0));
    let ratio = ratio.max(smallest_normal());
    let (octaves, fraction) = (exponent(ratio), fraction(ratio));
    let is_upper = fraction >= T::constant(SQRT_2);
    let octaves = octaves + i32::from(is_upper);
    let fraction = if is_upper { fraction * T::constant(0.5) } else { fraction };
    let beyond = if octaves == 0 { -depth } else { fraction - one };
    let t = beyond / (beyond + two);
    let square = t * t;
    let fourth = square * square;
    let row = |k: usize| four_terms(&ARTANH[k], square, fourth);
    let rest = if is_same::<T, f32>() {
        row(0)
    } else {
        let eighth = fourth * fourth;
        row(0) + eighth * (row(1) + eighth * row(2))
    };
    T::from_subset(&(octaves as f32)) * T::constant(LN_2) + two * (t + t * (square * rest))
}

/// 1/(2k + 1) from k = 1 on.
const ARTANH: [[f64; 4]; 3] = odd_reciprocals(1);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::worse::worse;

    /// The largest error of ln(1 − size) and ln(size), where these are not zero, over sizes from `smallest` to 1, in
    /// units of ε.
    fn largest_error<T: Scalar>(smallest: f64) -> f64 {
        let (one, epsilon) = (T::one(), T::default_epsilon().value());
        let mut largest = 0.0_f64;
        for k in 1..=200_000 {
            let size = T::constant(smallest.powf(f64::from(k) / 2e5));
            let mut compare = |ratio: T, depth: T, exact: f64| {
                let error = (log_of_ratio(ratio, depth).value() - exact).abs();
                largest = worse(largest, error / (exact.abs() * epsilon));
            };
            compare(size, one - size, size.value().ln());
            // If the ratio is small, the ratio is the exact one.
            if size < T::constant(0.5) {
                compare(one - size, size, (-size.value()).ln_1p());
            }
        }
        largest
    }

    #[test]
    fn logarithms_are_those_of_the_library() {
        for error in [largest_error::<f64>(1e-18), largest_error::<f32>(1e-18)] {
            assert!(error <= 2.5, "{error}");
        }
        assert_eq!((log_of_ratio(1.0, 0.0), log_of_ratio(1.0_f32, 0.0)), (0.0, 0.0));
        assert!(log_of_ratio(0.0, 1.0) < -708.0);
    }
}
