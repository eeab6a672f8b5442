//! A gap profile known only at run time.

use core::fmt;

use crate::Scalar;
use crate::admissibility::checked_range;
use crate::dispatch::found_or;
use crate::evaluate::double_power::{power_sum, weighted_power_sum};
use crate::evaluate::power::{power_sum_and_log_slope, power_sum_drop, quick_power_sum};
use crate::evaluate::pressure_kernel::{pressure_kernel, quick_pressure_kernel};
use crate::evaluate::slopes_and_drops::fill_slopes_and_drops;
use crate::evaluate::steepness::{
    halved_power_sum_steepness, load_integral_coefficient, load_integral_divisor, plain_power_sum_steepness,
};
use crate::in_double_words;
use crate::numbers::double_word::DoubleWord;
use crate::numbers::exponent::Exponent;
use crate::numbers::halved::Halved;
use crate::pairs::Pairs;
use crate::profile::{GapProfile, ProfileError, RadiusError};
use crate::radius::newton::invert;
use crate::radius::real_powers::radius_of_real_powers;
use crate::scalar::{floor, is_plain_zero};

/// The gap Φ(r) = Σ C r^n given as pairs (C, n), in any storage: an array, a slice, a `Vec`.
///
/// It agrees with the generated solver of the same geometry and has its accuracy; generated solvers are quicker.
/// Exponents are real and above 0, in any order.
///
/// A gap that was measured as points is fitted with a constant term, which is then left out: it tells how far apart the
/// surfaces were measured, and a gap begins with zero. To subtract the point on the axis instead would add its noise to
/// all others. Noise may make the coefficient of the lowest power negative, which is refused as a gap that does not
/// open; fit without it then. Beyond the last point the fit is a guess: with its radius as the end of the range, in
/// [`with_max_radius`](Self::with_max_radius), a contact that grows so wide is refused.
///
/// # Examples
///
/// ```
/// use cartcontact::{GapProfile, Polynomial};
///
/// let patella = Polynomial::new([(0.025, 2.0), (1.09375e-4, 4.0)])?;
/// assert_eq!(patella.gap(2.0), 0.1 + 1.09375e-4 * 16.0);
///
/// let oblate = Polynomial::new([(0.025, 2.0), (-1e-4, 4.0)])?;
/// assert!((oblate.max_radius() - 187.5_f64.sqrt()).abs() < 1e-9);
/// # Ok::<(), cartcontact::ProfileError>(())
/// ```
#[derive(Clone, Copy)]
pub struct Polynomial<T, S> {
    terms: S,
    max_radius: T,
    has_negative_terms: bool,
    has_whole_exponents: bool,
    highest_exponent: T,
}

// Not derived: the terms and the range say everything.
impl<T: fmt::Debug, S: fmt::Debug> fmt::Debug for Polynomial<T, S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut shown = f.debug_struct("Polynomial");
        shown.field("terms", &self.terms).field("max_radius", &self.max_radius).finish_non_exhaustive()
    }
}

impl<T: Scalar, S: Pairs<T>> Polynomial<T, S> {
    /// The profile Σ C r^n over the pairs (C, n), on its whole admissible range.
    ///
    /// # Errors
    ///
    /// [`ProfileError`] if there are no terms, a coefficient is not finite, or too small or too large for the format, an
    /// exponent is outside (0, 1024] or too small for the format, or the gap does not open at r = 0.
    pub fn new(terms: S) -> Result<Self, ProfileError> {
        Self::on_range(terms, None)
    }

    /// The profile Σ C r^n for contact radii up to `max_radius`, in mm. Infinity, which
    /// [`max_radius`](GapProfile::max_radius) gives where there is no limit, means no limit here, too.
    ///
    /// # Errors
    ///
    /// [`ProfileError`] as [`new`](Self::new), if `max_radius` is not positive, and if the geometry is not admissible
    /// up to it.
    ///
    /// # Examples
    ///
    /// ```
    /// # use cartcontact::{GapProfile, Polynomial, ProfileError};
    /// let oblate = [(0.025, 2.0), (-1e-4, 4.0)];
    /// assert_eq!(Polynomial::with_max_radius(oblate, 10.0)?.max_radius(), 10.0);
    /// let beyond = Polynomial::with_max_radius(oblate, 14.0);
    /// assert!(
    ///     matches!(beyond, Err(ProfileError::NotAdmissible { fails_at, .. }) if (fails_at - 13.69306).abs() < 1e-5)
    /// );
    /// # Ok::<(), ProfileError>(())
    /// ```
    pub fn with_max_radius(terms: S, max_radius: T) -> Result<Self, ProfileError> {
        Self::on_range(terms, Some(max_radius))
    }

    fn on_range(terms: S, max_radius: Option<T>) -> Result<Self, ProfileError> {
        let pairs = || terms.as_ref().iter().copied();
        let max_radius = checked_range(&terms, max_radius)?;
        let has_negative_terms = pairs().any(|(c, _)| c < T::zero());
        // A zero that carries a derivative counts.
        let exponents = || pairs().filter(|(c, _)| !is_plain_zero(*c)).map(|(_, n)| n);
        let has_whole_exponents = exponents().all(|n| n == T::constant(f64::from(floor(n))));
        let highest_exponent = exponents().fold(T::zero(), T::max);
        Ok(Self { terms, max_radius, has_negative_terms, has_whole_exponents, highest_exponent })
    }

    /// The pairs (coefficient, exponent) as they were given.
    pub fn terms(&self) -> &[(T, T)] {
        self.terms.as_ref()
    }

    /// A function of the coefficient and the exponent of each term.
    fn map<U>(&self, term: impl Fn(T, T) -> U + Clone) -> impl Iterator<Item = U> + Clone {
        self.terms.as_ref().iter().map(move |&(c, n)| term(c, n))
    }

    /// The radius of any load integral, also where terms have both signs.
    fn general_radius_within(&self, load_integral: T, limit: T) -> Result<T, RadiusError> {
        let terms = self.terms().iter().copied();
        let evaluate = |a| power_sum_and_log_slope(a, self.load_integral_terms());
        invert(load_integral, limit, terms, self.has_negative_terms, evaluate, |a| self.load_integral(a))
    }

    /// The terms of the gap.
    fn powers(&self) -> impl Iterator<Item = (T, Exponent<T>)> + Clone {
        self.map(|c, n| (c, Exponent::of(n)))
    }

    /// The terms of the pressure kernel, a multiple of n C where n is tiny: ε² for n and C n/ε² for C make no difference
    /// then, but keep digits that K would lose, and C a^(n+2) in the format.
    fn powers_of_kernel(&self) -> impl Iterator<Item = (T, Exponent<T>)> + Clone {
        let least = T::default_epsilon() * T::default_epsilon();
        self.map(
            move |c, n| if n < least { (c * (n / least), Exponent::of(least)) } else { (c, Exponent::of(n)) },
        )
    }

    /// The terms of J: (C n/((n+2)(n+4)), n+4).
    fn load_integral_terms(&self) -> impl Iterator<Item = (T, Exponent<T>)> + Clone {
        self.map(|c, n| (c * (n / load_integral_divisor(n)), Exponent::of(n).plus(4)))
    }

    /// The [terms of J](Self::load_integral_terms) with nothing rounded.
    fn precise_load_integral_terms(&self) -> impl Iterator<Item = (Halved<T>, Exponent<T>)> {
        self.map(|c, n| (load_integral_coefficient(c, n), Exponent::of(n).plus(4)))
    }

    /// Σ w(C, n) x^(n+k), rounded once.
    #[inline(always)]
    fn sum<const FUSED: bool>(
        &self,
        x: T,
        k: i32,
        weight: impl Fn(T, T) -> DoubleWord<T, FUSED> + Clone,
    ) -> T {
        weighted_power_sum(x, self.map(|c, n| (weight(c, n), Exponent::of(n).plus(k))))
    }
}

impl<T: Scalar, S: Pairs<T>> GapProfile<T> for Polynomial<T, S> {
    fn gap(&self, r: T) -> T {
        in_double_words!(FUSED => power_sum::<_, _, _, FUSED>(r, self.powers()))
    }

    fn approach(&self, a: T) -> T {
        let two = T::constant(2.0);
        in_double_words!(FUSED => {
            self.sum::<FUSED>(a, 0, |c, n| DoubleWord::of(two * c).over(DoubleWord::sum(n, two)))
        })
    }

    fn approach_slope(&self, a: T) -> T {
        let two = T::constant(2.0);
        in_double_words!(FUSED => {
            // Not the product of c and n first, which may overflow.
            let share = |n| DoubleWord::of(n).over(DoubleWord::sum(n, two));
            self.sum::<FUSED>(a, -1, |c, n| share(n).times_word(two * c))
        })
    }

    fn load_integral(&self, a: T) -> T {
        let (two, four) = (T::constant(2.0), T::constant(4.0));
        in_double_words!(FUSED => {
            let share = |n| DoubleWord::of(n).over(DoubleWord::sum(n, two).times(DoubleWord::sum(n, four)));
            self.sum::<FUSED>(a, 4, |c, n| share(n).times_word(c))
        })
    }

    fn log_kernel(&self, x: T) -> T {
        let two = T::constant(2.0);
        in_double_words!(FUSED => {
            let divisor = |n| DoubleWord::sum(n, two).power(2);
            self.sum::<FUSED>(x, 2, |c, n| DoubleWord::of(c).over(divisor(n)))
        })
    }

    fn pressure_kernel(&self, a: T, r: T) -> T {
        in_double_words!(FUSED => pressure_kernel::<_, _, _, FUSED>(a, r, self.powers_of_kernel()))
    }

    fn excess_on_axis(&self, a: T) -> T {
        let (two, four) = (T::constant(2.0), T::constant(4.0));
        let weight = |c, n| c * (n / ((n + two) * (n + two) * (n + four)));
        quick_power_sum(a, self.map(|c, n| (weight(c, n), Exponent::of(n).plus(4))))
    }

    fn quick_approach(&self, a: T) -> T {
        let two = T::constant(2.0);
        quick_power_sum(a, self.map(|c, n| (two * c / (n + two), Exponent::of(n))))
    }

    fn quick_approach_slope(&self, a: T) -> T {
        let two = T::constant(2.0);
        quick_power_sum(a, self.map(|c, n| (two * c * (n / (n + two)), Exponent::of(n).plus(-1))))
    }

    fn quick_load_integral(&self, a: T) -> T {
        quick_power_sum(a, self.load_integral_terms())
    }

    fn quick_pressure_kernel(&self, a: T, r: T) -> T {
        quick_pressure_kernel(a, r, self.powers_of_kernel())
    }

    fn radius_within(&self, load_integral: T, limit: T) -> Result<T, RadiusError> {
        let found = radius_of_real_powers(
            load_integral,
            limit,
            self.load_integral_terms(),
            #[inline(always)]
            |a, scale| plain_power_sum_steepness(a, scale, self.load_integral_terms()),
            #[inline(always)]
            |a, scale| halved_power_sum_steepness(a, scale, self.precise_load_integral_terms()),
        );
        found_or(found, || self.general_radius_within(load_integral, limit))
    }

    fn max_radius(&self) -> T {
        self.max_radius
    }

    fn load_integral_drop(&self, a: T, depth: T) -> T {
        power_sum_drop(a, depth, self.load_integral_terms())
    }

    fn fill_slopes_and_drops(&self, a: T, places: (&[T], &[T]), values: (&mut [T], &mut [T])) {
        fill_slopes_and_drops(self, a, places, values, self.load_integral_terms());
    }

    fn highest_exponent(&self) -> T {
        self.highest_exponent
    }

    fn is_smooth_at_centre(&self) -> bool {
        self.has_whole_exponents
    }

    fn has_only_positive_terms(&self) -> bool {
        !self.has_negative_terms
    }
}
