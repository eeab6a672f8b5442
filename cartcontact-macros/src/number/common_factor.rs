//! The greatest common divisor of two integers: Euclid's algorithm, many steps at once while the numbers are long.

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, ToPrimitive, Zero};

/// The greatest common divisor; not negative.
pub(crate) fn common_factor(left: &BigInt, right: &BigInt) -> BigInt {
    if left.magnitude().is_one() || right.magnitude().is_one() {
        return BigInt::one();
    }
    // Numbers that were rounded may have many more zeros than other digits.
    let (Some(left_zeros), Some(right_zeros)) = (left.trailing_zeros(), right.trailing_zeros()) else {
        return (left + right).abs();
    };
    odd_common_factor(left.abs() >> left_zeros, right.abs() >> right_zeros) << left_zeros.min(right_zeros)
}

/// The greatest common divisor of two positive odd numbers.
fn odd_common_factor(mut left: BigInt, mut right: BigInt) -> BigInt {
    if left < right {
        core::mem::swap(&mut left, &mut right);
    }
    loop {
        if let (Some(left), Some(right)) = (left.to_u64(), right.to_u64()) {
            return left.gcd(&right).into();
        }
        if right.is_zero() {
            return left;
        }
        match Steps::of(&left, &right) {
            Some(Steps([[a, b], [c, d]])) => {
                (left, right) = (&left * a + &right * b, left * c + right * d);
            }
            None => {
                let rest = left % &right;
                left = core::mem::replace(&mut right, rest);
            }
        }
    }
}

/// Steps of Euclid's algorithm at once, as a matrix for the two numbers.
struct Steps([[i64; 2]; 2]);

impl Steps {
    /// The steps that the leading 62 bits of two numbers decide, of which the first is not the smaller: as long as the
    /// quotient is the same for the least and the greatest numbers with these bits (D. H. Lehmer, Amer. Math. Monthly
    /// 45 (1938) 227-233; Knuth, section 4.5.2, algorithm L).
    fn of(left: &BigInt, right: &BigInt) -> Option<Self> {
        let excess = left.bits().saturating_sub(62);
        let (mut x, mut y) = ((left >> excess).to_i64()?, (right >> excess).to_i64()?);
        let (mut upper, mut lower) = ([1, 0], [0, 1]);
        while y + lower[0] != 0 && y + lower[1] != 0 {
            let quotient = (x + upper[0]) / (y + lower[0]);
            if quotient != (x + upper[1]) / (y + lower[1]) {
                break;
            }
            (upper, lower) = (lower, [upper[0] - quotient * lower[0], upper[1] - quotient * lower[1]]);
            (x, y) = (y, x - quotient * y);
        }
        (upper[1] != 0).then_some(Steps([upper, lower]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn common_factors_are_the_greatest() {
        let [a, b, c] =
            [1_000_000_007_u64, 998_244_353, 2_147_483_659].map(|prime| BigInt::from(prime).pow(9));
        assert_eq!(common_factor(&(&a * &b), &-(&c * &b)), b);
        assert_eq!(common_factor(&a, &c), BigInt::one());
        assert_eq!(common_factor(&BigInt::zero(), &-&a), a);
        assert_eq!(common_factor(&a, &BigInt::zero()), a);
        assert_eq!(common_factor(&(&a * 12_u32), &18.into()), 6.into());
        assert_eq!(common_factor(&(&a << 300), &((&a * &b) << 70)), &a << 70);
        let mut fibonacci = [BigInt::one(), BigInt::one()];
        for _ in 0..400 {
            let [older, newer] = &fibonacci;
            fibonacci = [newer.clone(), older + newer];
            let [older, newer] = [&fibonacci[0] * &a, &fibonacci[1] * &a];
            assert_eq!(common_factor(&older, &newer), a);
            assert_eq!(
                common_factor(&(&older + &c), &(newer * 6_u32 - &b)),
                (older + &c).gcd(&(&fibonacci[1] * &a * 6_u32 - &b))
            );
        }
    }
}
