//! The cosines of sixteenths of π, the abscissas of interpolation by Chebyshev polynomials.

/// cos(π k/16) for k from 0 to 8, rounded from 40 digits.
const QUARTER_TURN: [f64; 9] = [
    1.0,
    0.980_785_280_403_230_4,
    0.923_879_532_511_286_7,
    0.831_469_612_302_545_2,
    core::f64::consts::FRAC_1_SQRT_2,
    0.555_570_233_019_602_2,
    0.382_683_432_365_089_8,
    0.195_090_322_016_128_28,
    0.0,
];

/// cos(π k/16) of any k.
pub(crate) const fn cosine_of_sixteenths(k: usize) -> f64 {
    let turn = k % 32;
    let half = if turn > 16 { 32 - turn } else { turn };
    if half <= 8 { QUARTER_TURN[half] } else { -QUARTER_TURN[16 - half] }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cosines_are_those_of_the_library() {
        for k in 0..100 {
            let cosine = (core::f64::consts::PI / 16.0 * k as f64).cos();
            // The library has the cosine of a rounded angle.
            let rounding = f64::EPSILON * (1.0 + k as f64 / 4.0);
            assert!((cosine_of_sixteenths(k) - cosine).abs() <= rounding, "{k}: {cosine}");
        }
    }
}
