//! [`Gap`] -> the closed forms that follow from it: Eqs. (10), (14) and (28), exactly.
//!
//! Each is a sum of powers whose coefficients are those of the gap times rational numbers; see I. Argatov, Mech. Res.
//! Commun. 38 (2011), doi 10.1016/j.mechrescom.2010.11.006.

use num_bigint::BigInt;
use num_traits::{One, ToPrimitive};

use crate::gap::coefficient::Coefficient;
use crate::gap::{Gap, Term};
use crate::number::{Rational, common_denominator, integer};

/// A denominator has at most this many binary digits: half of the 53 of an `f64`.
const MOST_DIGITS: u64 = 26;
/// Exponents of two decimals have a root index of 20 or less if they are multiples of 0.05.
const HIGHEST_ROOT: u32 = 20;

/// Σ weight · C · x^exponent, where C is the coefficient of the term of the gap with that index.
pub(crate) struct PowerSum {
    pub(crate) summands: Vec<Summand>,
}

#[derive(Clone)]
pub(crate) struct Summand {
    pub(crate) term: usize,
    pub(crate) factor: Prefactor,
    pub(crate) exponent: Rational,
}

/// weight · C.
#[derive(Clone)]
pub(crate) enum Prefactor {
    /// The product, if C is a constant.
    Constant(Rational),
    /// The weight alone, if C depends on fields.
    Weight(Rational),
}

impl Summand {
    /// The factor of the power in the sums that belong to `gap`.
    pub(crate) fn coefficient(&self, gap: &Gap) -> Coefficient {
        match &self.factor {
            Prefactor::Constant(value) => Coefficient::constant(value.clone()),
            Prefactor::Weight(weight) => gap.terms[self.term].coefficient.scaled(weight),
        }
    }

    /// The weight of the symbol in the factor of the power; nothing if the factor is a constant.
    pub(crate) fn weight(&self) -> Option<&Rational> {
        match &self.factor {
            Prefactor::Constant(_) => None,
            Prefactor::Weight(weight) => Some(weight),
        }
    }

    /// The factor of the power, if it is a constant.
    pub(crate) fn constant(&self) -> Option<&Rational> {
        match &self.factor {
            Prefactor::Constant(value) => Some(value),
            Prefactor::Weight(_) => None,
        }
    }
}

/// J as the steps to the radius take it: with weights of few digits where coefficients are symbols, and as a function of
/// the root of the radius with this index, in which its powers are whole. The index is 1, for the radius itself, if only
/// a root of a high index would do.
pub(crate) struct Stepped {
    /// J times the `denominator`.
    pub(crate) load_integral: PowerSum,
    /// The common denominator of the weights over a power of two: from 1 to 2.
    pub(crate) denominator: Rational,
    pub(crate) root: u32,
}

pub(crate) struct ClosedForms {
    /// Φ(r) = Σ C rⁿ
    pub(crate) gap: PowerSum,
    /// δ₀(a) = Σ 2 C aⁿ/(n+2), Eq. (10)
    pub(crate) approach: PowerSum,
    /// δ₀′(a) = Σ 2 C n aⁿ⁻¹/(n+2)
    pub(crate) approach_slope: PowerSum,
    /// J(a) = Σ C n aⁿ⁺⁴/((n+2)(n+4)), Eq. (14)
    pub(crate) load_integral: PowerSum,
    /// The same as the steps to the radius take it.
    pub(crate) stepped: Stepped,
    /// L(x) = Σ C xⁿ⁺²/(n+2)², the log kernel of Eq. (28)
    pub(crate) log_kernel: PowerSum,
    /// S(a) = a² G(a, 0) − J(a)/2 = Σ C n aⁿ⁺⁴/((n+2)² (n+4))
    pub(crate) excess_on_axis: PowerSum,
}

impl ClosedForms {
    pub(crate) fn of(gap: &Gap) -> Self {
        let two = integer(2);
        let plus = |n: &Rational, k: i32| n + integer(k);
        let load_integral = PowerSum::of(gap, 4, &|n| n / (plus(n, 2) * plus(n, 4)));
        Self {
            stepped: load_integral.stepped(),
            gap: PowerSum::of(gap, 0, &|_| Rational::one()),
            approach: PowerSum::of(gap, 0, &|n| &two / plus(n, 2)),
            approach_slope: PowerSum::of(gap, -1, &|n| &two * n / plus(n, 2)),
            load_integral,
            log_kernel: PowerSum::of(gap, 2, &|n| (plus(n, 2) * plus(n, 2)).recip()),
            excess_on_axis: PowerSum::of(gap, 4, &|n| n / (plus(n, 2) * plus(n, 2) * plus(n, 4))),
        }
    }
}

impl PowerSum {
    /// The same sum with every summand multiplied by a function of its exponent.
    pub(crate) fn weighted(&self, weight: impl Fn(&Rational) -> Rational) -> Self {
        let summands = self.summands.iter().map(|Summand { term, factor, exponent }| {
            let factor = match factor {
                Prefactor::Constant(value) => Prefactor::Constant(value * weight(exponent)),
                Prefactor::Weight(own) => Prefactor::Weight(own * weight(exponent)),
            };
            Summand { term: *term, factor, exponent: exponent.clone() }
        });
        Self { summands: summands.collect() }
    }

    /// The same sum with other exponents.
    fn with_exponents(&self, other: impl Fn(&Rational) -> Rational) -> Self {
        let summands = self.summands.iter().map(|Summand { term, factor, exponent }| Summand {
            term: *term,
            factor: factor.clone(),
            exponent: other(exponent),
        });
        Self { summands: summands.collect() }
    }

    /// The sums of the even powers and of all others.
    pub(crate) fn by_parity(&self) -> [Self; 2] {
        let is_even = |summand: &Summand| (&summand.exponent / integer(2)).is_integer();
        let (even, others) = self.summands.iter().cloned().partition(is_even);
        [even, others].map(|summands| Self { summands })
    }

    /// Sums P_k of whole powers, if the sum is P₀(x) + x^(1/4) P₁(x) + x^(1/2) P₂(x) + x^(3/4) P₃(x) with more than P₀.
    pub(crate) fn in_quarters(&self) -> Option<[Self; 4]> {
        let mut parts = [(); 4].map(|()| Self { summands: Vec::new() });
        let of_whole_powers = self.with_exponents(Rational::floor).summands;
        for (Summand { exponent, .. }, whole) in self.summands.iter().zip(of_whole_powers) {
            let quarters = (exponent - &whole.exponent) * integer(4);
            let index = quarters.is_integer().then(|| quarters.to_usize())??;
            parts[index].summands.push(whole);
        }
        (parts[0].summands.len() < self.summands.len()).then_some(parts)
    }

    /// The least index of a root of x in which all powers are whole, if it is not too high.
    fn root_of_whole_powers(&self) -> Option<u32> {
        let index = common_denominator(self.summands.iter().map(|summand| &summand.exponent));
        index.to_u32().filter(|&index| index <= HIGHEST_ROOT)
    }

    /// The sum with all exponents multiplied by the index: a sum of powers of that root of x.
    pub(crate) fn in_root(&self, index: u32) -> Self {
        self.with_exponents(|exponent| exponent * integer(index))
    }

    fn stepped(&self) -> Stepped {
        let denominator = self.denominator_of_weights();
        let root = self.root_of_whole_powers().unwrap_or(1);
        let load_integral = self.weighted(|_| denominator.clone()).in_root(root);
        Stepped { load_integral, denominator, root }
    }

    /// The common denominator of the weights, made odd by dividing out powers of two and then divided by a power of two
    /// so that it is less than 2: multiplied by it, the weights are small whole numbers times powers of two. 1 if it
    /// has more than half the digits of a number.
    fn denominator_of_weights(&self) -> Rational {
        let common = common_denominator(self.summands.iter().filter_map(Summand::weight));
        let odd = &common >> common.trailing_zeros().unwrap_or(0);
        let digits = odd.bits();
        if digits > MOST_DIGITS { Rational::one() } else { Rational::new(odd, BigInt::one() << (digits - 1)) }
    }

    /// The sum with the exponents n + `shift` and the weights that `weight` gives for n.
    fn of(gap: &Gap, shift: i32, weight: &dyn Fn(&Rational) -> Rational) -> Self {
        let summands = gap.terms.iter().enumerate().map(|(term, Term { coefficient, exponent, .. })| {
            let factor = match coefficient.as_constant() {
                Some(value) => Prefactor::Constant(value * weight(exponent)),
                None => Prefactor::Weight(weight(exponent)),
            };
            Summand { term, factor, exponent: exponent + integer(shift) }
        });
        Self { summands: summands.collect() }
    }
}
