//! The greatest common divisor of two integer polynomials, and the square-free part.
//!
//! Euclid's algorithm over the integers grows coefficients of tens of thousands of digits. Modulo a prime p nothing
//! grows, and the divisor modulo p is the true one reduced, unless p is one of the finitely many primes that divide a
//! leading coefficient or a certain resultant; those make its degree too large, never too small.
//!
//! So: take primes one after the other, keep the lowest degree seen, scale each result to the leading coefficient
//! `gcd(lead(f), lead(g))`, and join them by the Chinese remainder theorem. Once the product of the primes exceeds
//! twice every coefficient of the true divisor, the joined result stops changing and is that divisor, up to a constant.
//! A result that divides both polynomials is a common divisor of at least the greatest degree, hence the greatest; so
//! the test division proves the answer, and the loop ends because only finitely many primes mislead it. Degree 0 modulo
//! one prime settles the common case, that there is no common divisor.
//!
//! W. S. Brown, On Euclid's algorithm and the computation of polynomial greatest common divisors, J. ACM 18 (1971)
//! 478-504.

use num_bigint::BigInt;
use num_traits::{One, Signed, ToPrimitive, Zero};

use crate::first_zero::integer_polynomial::IntegerPolynomial;
use crate::number::common_factor::common_factor;

/// Primes are taken upward from here. They stay far below 2^32, so that a product of two residues fits into a `u64`,
/// and below 3 215 031 751, so that [`is_prime`] is exact. There are 5 · 10^7 of them up to that number, enough for
/// 10^9 bits.
const FIRST_PRIME_ABOVE: u64 = 1 << 31;

/// The polynomial with the same roots, each of them simple, and the same sign at 0.
///
/// Every root has a multiplicity that is by 1 lower in the divisor that a polynomial shares with its derivative.
pub(crate) fn square_free(polynomial: &IntegerPolynomial) -> IntegerPolynomial {
    let repeated = common_divisor(polynomial, &polynomial.derivative());
    let simple = polynomial.exact_quotient(&repeated).unwrap_or_else(|| polynomial.clone());
    if simple.constant().sign() == polynomial.constant().sign() { simple } else { simple.negated() }
}

/// The greatest common divisor of two polynomials that are not zero, up to a constant.
pub(crate) fn common_divisor(left: &IntegerPolynomial, right: &IntegerPolynomial) -> IntegerPolynomial {
    let leading = common_factor(&left.leading(), &right.leading());
    let mut prime = FIRST_PRIME_ABOVE;
    let mut joined = Joined::nothing();
    loop {
        prime = prime_after(prime);
        let Some((left_residues, right_residues)) = residues(left, prime).zip(residues(right, prime)) else {
            continue;
        };
        let divisor = divisor_modulo(left_residues, right_residues, prime);
        if divisor.len() == 1 {
            return IntegerPolynomial::new(vec![BigInt::one()]);
        }
        if joined.join(&scaled(divisor, reduce(&leading, prime), prime), prime) {
            let candidate = IntegerPolynomial::new(joined.coefficients.clone()).primitive();
            if [left, right].iter().all(|whole| whole.exact_quotient(&candidate).is_some()) {
                return candidate;
            }
        }
    }
}

/// The result of the primes so far, with coefficients in (-modulus/2, modulus/2]; empty before the first.
struct Joined {
    coefficients: Vec<BigInt>,
    modulus: BigInt,
}

impl Joined {
    fn nothing() -> Self {
        Joined { coefficients: Vec::new(), modulus: BigInt::one() }
    }

    /// Takes in the divisor modulo one more prime, whose degree is never too low; returns whether the result stayed the
    /// same.
    fn join(&mut self, residues: &[u64], prime: u64) -> bool {
        if self.coefficients.is_empty() || residues.len() < self.coefficients.len() {
            *self = Joined { coefficients: vec![BigInt::zero(); residues.len()], modulus: BigInt::one() };
        } else if residues.len() > self.coefficients.len() {
            return false;
        }
        let step =
            Step { inverse: inverse(reduce(&self.modulus, prime), prime), modulus: &self.modulus, prime };
        let mut unchanged = true;
        for (coefficient, &residue) in self.coefficients.iter_mut().zip(residues) {
            unchanged &= !step.add(coefficient, residue);
        }
        self.modulus *= prime;
        unchanged
    }
}

/// One more prime.
struct Step<'a> {
    modulus: &'a BigInt,
    /// The inverse of the modulus, modulo the prime.
    inverse: u64,
    prime: u64,
}

impl Step<'_> {
    /// Makes a number agree with its residue modulo the prime; returns whether that changed it.
    fn add(&self, number: &mut BigInt, residue: u64) -> bool {
        let prime = self.prime;
        let missing = (residue + prime - reduce(number, prime)) % prime;
        let step = missing * self.inverse % prime;
        let centred = if step > prime / 2 { BigInt::from(step) - prime } else { BigInt::from(step) };
        *number += centred * self.modulus;
        step != 0
    }
}

/// The coefficients modulo a prime, unless it divides the leading one.
fn residues(polynomial: &IntegerPolynomial, prime: u64) -> Option<Vec<u64>> {
    if reduce(&polynomial.leading(), prime) == 0 {
        return None;
    }
    Some(polynomial.coefficients().iter().map(|coefficient| reduce(coefficient, prime)).collect())
}

/// Euclid's algorithm modulo a prime; the result has the leading coefficient 1.
fn divisor_modulo(mut dividend: Vec<u64>, divisor: Vec<u64>, prime: u64) -> Vec<u64> {
    let mut divisor = monic(divisor, prime);
    while !divisor.is_empty() {
        let rest = remainder(dividend, &divisor, prime);
        dividend = core::mem::replace(&mut divisor, monic(rest, prime));
    }
    dividend
}

/// The remainder of a division by a polynomial with the leading coefficient 1.
fn remainder(mut dividend: Vec<u64>, divisor: &[u64], prime: u64) -> Vec<u64> {
    while dividend.len() >= divisor.len() {
        let Some(leading) = dividend.pop() else { break };
        let factor = prime - leading;
        for (target, coefficient) in dividend.iter_mut().rev().zip(divisor.iter().rev().skip(1)) {
            *target = (*target + factor * coefficient) % prime;
        }
    }
    dividend
}

fn monic(mut polynomial: Vec<u64>, prime: u64) -> Vec<u64> {
    while polynomial.last() == Some(&0) {
        polynomial.pop();
    }
    let leading = polynomial.last().copied().unwrap_or(1);
    scaled(polynomial, inverse(leading, prime), prime)
}

fn scaled(mut polynomial: Vec<u64>, factor: u64, prime: u64) -> Vec<u64> {
    for coefficient in &mut polynomial {
        *coefficient = *coefficient * factor % prime;
    }
    polynomial
}

fn reduce(value: &BigInt, prime: u64) -> u64 {
    let residue = (value.magnitude() % prime).to_u64().unwrap_or(0);
    if value.is_negative() && residue > 0 { prime - residue } else { residue }
}

/// The inverse of a number that the prime does not divide, by Fermat's theorem.
fn inverse(number: u64, prime: u64) -> u64 {
    power_modulo(number, prime - 2, prime)
}

fn power_modulo(base: u64, mut exponent: u64, prime: u64) -> u64 {
    let (mut power, mut result) = (base % prime, 1);
    while exponent > 0 {
        if exponent & 1 == 1 {
            result = result * power % prime;
        }
        power = power * power % prime;
        exponent >>= 1;
    }
    result
}

fn prime_after(start: u64) -> u64 {
    let mut candidate = (start + 1) | 1;
    while !is_prime(candidate) {
        candidate += 2;
    }
    candidate
}

/// The test of Miller and Rabin; these four bases leave no exception below 3 215 031 751 (OEIS A014233).
fn is_prime(odd: u64) -> bool {
    let shift = (odd - 1).trailing_zeros();
    [2, 3, 5, 7].into_iter().all(|base| {
        let mut power = power_modulo(base, (odd - 1) >> shift, odd);
        let mut witness = power != 1 && power != odd - 1;
        for _ in 1..shift {
            power = power * power % odd;
            witness &= power != odd - 1;
        }
        !witness
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn product(roots: &[(i64, u32)]) -> IntegerPolynomial {
        let mut coefficients = vec![BigInt::one()];
        for &(root, multiplicity) in roots {
            for _ in 0..multiplicity {
                let mut next = vec![BigInt::zero(); coefficients.len() + 1];
                for (power, coefficient) in coefficients.iter().enumerate() {
                    next[power] -= coefficient * root;
                    next[power + 1] += coefficient;
                }
                coefficients = next;
            }
        }
        IntegerPolynomial::new(coefficients)
    }

    #[test]
    fn finds_what_two_products_share() {
        let left = product(&[(3, 2), (-5, 1), (123_456_789_012, 3)]);
        let right = product(&[(3, 1), (7, 4), (123_456_789_012, 2)]);
        assert_eq!(common_divisor(&left, &right), product(&[(3, 1), (123_456_789_012, 2)]));
        assert_eq!(common_divisor(&left, &product(&[(1, 9)])).degree(), 0);
    }

    /// x^2 - 1/4 is shared, and the leading coefficients have more than a thousand digits.
    #[test]
    fn short_divisors_of_long_polynomials_are_found() {
        let long = BigInt::from(7).pow(1500);
        let shared = IntegerPolynomial::new([-1, 0, 4].map(BigInt::from).into());
        let multiple =
            |constant: BigInt| IntegerPolynomial::new(vec![-&constant, -&long, &constant * 4, &long * 4]);
        assert_eq!(common_divisor(&multiple(3.into()), &multiple(&long - 5)), shared);
    }

    #[test]
    fn repeated_roots_become_simple() {
        assert_eq!(
            square_free(&product(&[(2, 5), (-1, 1), (9, 2)])).negated(),
            product(&[(2, 1), (-1, 1), (9, 1)])
        );
        assert_eq!(square_free(&product(&[(2, 1), (5, 1)])), product(&[(2, 1), (5, 1)]));
    }

    /// Modulo a prime that divides their difference, two roots are one.
    #[test]
    fn no_prime_misleads() {
        let first = prime_after(FIRST_PRIME_ABOVE);
        let second = prime_after(first);
        for apart in [first, second, first * second].map(|apart| apart as i64) {
            let [near, far] = [3, 3 + apart];
            let simple = product(&[(near, 1), (far, 1)]);
            assert_eq!(square_free(&simple), simple, "{apart}");
            assert_eq!(square_free(&product(&[(near, 2), (far, 1)])).negated(), simple, "{apart}");
            let [left, right] = [near, far].map(|root| product(&[(root, 1), (7, 1)]));
            assert_eq!(common_divisor(&left, &right), product(&[(7, 1)]), "{apart}");
        }
    }

    /// Modulo a prime that divides a leading coefficient, a divisor may have too low a degree.
    #[test]
    fn primes_of_leading_coefficients_are_left_out() {
        let first = BigInt::from(prime_after(FIRST_PRIME_ABOVE));
        let square = IntegerPolynomial::new(vec![BigInt::one(), &first * 2, &first * &first]);
        let shared = IntegerPolynomial::new(vec![BigInt::one(), first]);
        assert_eq!(common_divisor(&shared, &square), shared);
    }

    #[test]
    fn primes_are_found_by_the_test() {
        let by_division = |n: u64| (2..).take_while(|d| d * d <= n).all(|d| !n.is_multiple_of(d));
        assert!((9..4001).step_by(2).all(|n| is_prime(n) == by_division(n)));
        assert_eq!(prime_after(1 << 31), 2_147_483_659);
    }
}
