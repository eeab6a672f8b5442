//! What a solver needs to know about a geometry.

mod error;
mod parameters;
mod pointers;

pub(crate) use error::check_places;
pub use error::{ProfileError, RadiusError, with_parameters};
pub use parameters::Parameters;

use crate::Scalar;
use crate::evaluate::slopes_and_drops::fill_one_by_one;
use crate::quadrature::Rule;

/// A gap profile Φ(r) = Σ C r^n with everything that follows from it in closed form.
///
/// [`#[gap_profile]`](macro@crate::gap_profile) implements it for a geometry known at compile time,
/// [`Polynomial`](crate::Polynomial) for one known at run time. Lengths are in the user's unit, mm throughout
/// this documentation.
///
/// The functions of a radius are plain arithmetic and expect a finite radius ≥ 0; for others their results mean
/// nothing. [`Contact`](crate::Contact) checks what it is given before it calls them.
///
/// Programs call [`gap`](Self::gap), [`approach`](Self::approach) and [its slope](Self::approach_slope),
/// [`load_integral`](Self::load_integral), [`log_kernel`](Self::log_kernel),
/// [`pressure_kernel`](Self::pressure_kernel), [`radius`](Self::radius), [`radii`](Self::radii) and
/// [`max_radius`](Self::max_radius). All others serve the solver, and [`Contact::new`](crate::Contact::new) calls
/// [`check`](Self::check). A profile of your own provides the six functions of a radius, from `gap` to
/// `pressure_kernel`, [`radius_within`](Self::radius_within) and `max_radius`, and
/// [`highest_exponent`](Self::highest_exponent) if it has powers above the 64th. Memory integrals rely on a gap that is
/// smooth between r = 0 and `max_radius`: pressures are off by some 1e-9 where its curvature jumps, as in a quadratic
/// spline, and by some 1e-7 where its slope jumps.
///
/// A reference to a profile is a profile, too; with the feature `std` so are a `Box` and an `Arc`, also of a
/// `dyn GapProfile<T>`.
///
/// # Accuracy
///
/// Sums of powers and the pressure kernel are rounded once, apart from their coefficients, and are within 2 units in
/// the last place, whatever their exponents. Where terms of both signs cancel, this bound is multiplied by the
/// condition number Σ|terms|/|sum|. At the ends of the range of numbers only plain arithmetic is possible, within 8 ε:
/// where a result is above 6e299, or 4e34 in f32, and where a result or a power on the way is hardly larger than the
/// smallest normal number. Digits are lost where a coefficient, which [`check`](Self::check) refuses then, or a result
/// is less than 2 (n+2)² times that, with the exponent n. If terms of both signs overflow, the result is NaN. Beyond
/// radii of 1.3e154, or 1.8e19 in f32, whose squares overflow, results may be infinite that need not be.
///
/// Coefficients that depend on fields are not rounded, if `T` can hold the fields: their products, quotients and powers
/// are computed with twice the digits, except fractional powers of dual numbers. Fractional powers such as a^-1.3 have
/// 19 digits, some of which may be lost in the difference of two that are nearly equal. For contact radii such
/// coefficients are rounded. Intermediate products and quotients below the smallest normal number, as of fields near
/// 1e-160 or 1e160, are refused only where a coefficient would be zero.
///
/// # Examples
///
/// ```
/// use cartcontact::{GapProfile, gap_profile};
///
/// #[gap_profile(0.025 * r^2)]
/// struct Paraboloid;
///
/// let a = Paraboloid.radius(2.0)?;
/// assert!((Paraboloid.load_integral(a) - 2.0_f64).abs() < 1e-14);
/// # Ok::<(), cartcontact::RadiusError>(())
/// ```
///
/// # References
///
/// I. Argatov, Mech. Res. Commun. 38 (2011) 29–33, doi 10.1016/j.mechrescom.2010.11.006.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a gap profile",
    label = "not a gap profile",
    note = "for a geometry known at compile time write `#[gap_profile(...)]` above the struct",
    note = "one known at run time is `Polynomial::new(...)?` of pairs (coefficient, exponent), with `?`"
)]
pub trait GapProfile<T: Scalar> {
    /// The gap Φ(r) between the undeformed surfaces, in mm.
    ///
    /// # Formula
    ///
    /// ```text
    /// Φ(r) = Σ C rⁿ
    /// ```
    ///
    /// # Examples
    ///
    /// ```
    /// # use cartcontact::{GapProfile, gap_profile};
    /// #[gap_profile(0.025 * r^2)]
    /// struct Paraboloid;
    ///
    /// assert!((Paraboloid.gap(4.0) - 0.4_f64).abs() < 1e-15);
    /// ```
    fn gap(&self, r: T) -> T;

    /// The approach δ₀ of the bones at contact radius `a`, in mm: Eq. (10).
    ///
    /// # Formula
    ///
    /// ```text
    /// δ₀(a) = Σ 2 C aⁿ / (n+2)
    /// ```
    ///
    /// # Examples
    ///
    /// ```
    /// # use cartcontact::{GapProfile, gap_profile};
    /// #[gap_profile(0.025 * r^2)]
    /// struct Paraboloid;
    ///
    /// assert!((Paraboloid.approach(4.0) - 0.2_f64).abs() < 1e-15);
    /// ```
    fn approach(&self, a: T) -> T;

    /// The slope of the approach, dimensionless; positive for an admissible geometry.
    ///
    /// # Formula
    ///
    /// ```text
    /// δ₀′(a) = Σ 2 C n aⁿ⁻¹ / (n+2) = (2/a) (Φ(a) − δ₀(a))
    /// ```
    ///
    /// # Examples
    ///
    /// ```
    /// # use cartcontact::{GapProfile, gap_profile};
    /// #[gap_profile(0.025 * r^2)]
    /// struct Paraboloid;
    ///
    /// assert!((Paraboloid.approach_slope(4.0) - 0.1_f64).abs() < 1e-15);
    /// ```
    fn approach_slope(&self, a: T) -> T;

    /// The load integral J, in mm⁵: (π m/4) J(a) is the hereditary load of Eq. (14).
    ///
    /// # Formula
    ///
    /// ```text
    /// J(a) = Σ C n aⁿ⁺⁴ / ((n+2)(n+4)),     J′(a) = a⁴ δ₀′(a) / 2
    /// ```
    ///
    /// # Examples
    ///
    /// ```
    /// # use cartcontact::{GapProfile, gap_profile};
    /// #[gap_profile(0.025 * r^2)]
    /// struct Paraboloid;
    ///
    /// assert!((Paraboloid.load_integral(4.0) - 8.533_333_333_333_333_f64).abs() < 1e-14);
    /// ```
    fn load_integral(&self, a: T) -> T;

    /// The log kernel L of Eq. (28), in mm³.
    ///
    /// # Formula
    ///
    /// ```text
    /// L(x) = ∫₀ˣ Φ(ρ) ρ ln(x/ρ) dρ = Σ C xⁿ⁺² / (n+2)²
    /// ```
    ///
    /// # Examples
    ///
    /// ```
    /// # use cartcontact::{GapProfile, gap_profile};
    /// #[gap_profile(0.025 * r^2)]
    /// struct Paraboloid;
    ///
    /// assert!((Paraboloid.log_kernel(4.0) - 0.4_f64).abs() < 1e-15);
    /// ```
    fn log_kernel(&self, x: T) -> T;

    /// The pressure kernel G of Eq. (28), in mm³; zero for r ≥ a, where its double zero is kept as a factor.
    ///
    /// # Formula
    ///
    /// ```text
    /// G(a, r) = δ₀(a)(a² − r²)/4 + L(r) − L(a) = ¼ ∫ᵣᵃ δ₀′(s)(s² − r²) ds
    /// ```
    ///
    /// # Examples
    ///
    /// ```
    /// # use cartcontact::{GapProfile, gap_profile};
    /// #[gap_profile(0.025 * r^2)]
    /// struct Paraboloid;
    ///
    /// assert!((Paraboloid.pressure_kernel(4.0, 2.0) - 0.225_f64).abs() < 1e-15);
    /// ```
    fn pressure_kernel(&self, a: T, r: T) -> T;

    /// S(a) = a² G(a, 0) − J(a)/2 = ¼ ∫₀ᵃ δ₀′(s) s² (a² − s²) ds: by m S/a² the pressure on the axis exceeds twice the
    /// mean one before anything has drained.
    #[doc(hidden)]
    fn excess_on_axis(&self, a: T) -> T {
        a * a * self.pressure_kernel(a, T::zero()) - T::constant(0.5) * self.load_integral(a)
    }

    /// The [`approach`](Self::approach) and the [`load_integral`](Self::load_integral), which share what they have in
    /// common.
    #[doc(hidden)]
    fn approach_and_load_integral(&self, a: T) -> (T, T) {
        (self.approach(a), self.load_integral(a))
    }

    /// The approach as pressures need it: within 7 ε, which is quicker.
    #[doc(hidden)]
    fn quick_approach(&self, a: T) -> T {
        self.approach(a)
    }

    /// The slope of the approach as pressures need it: within 7 ε, which is quicker.
    #[doc(hidden)]
    fn quick_approach_slope(&self, a: T) -> T {
        self.approach_slope(a)
    }

    /// The load integral as pressures need it: within 7 ε, which is quicker.
    #[doc(hidden)]
    fn quick_load_integral(&self, a: T) -> T {
        self.load_integral(a)
    }

    /// The pressure kernel as pressures need it: within 8 ε, more with fractional and high powers, which is quicker.
    #[doc(hidden)]
    fn quick_pressure_kernel(&self, a: T, r: T) -> T {
        self.pressure_kernel(a, r)
    }

    /// The contact radius `a`, in mm, at which J(a) equals `load_integral`: Eq. (14) solved.
    ///
    /// # Accuracy
    ///
    /// About 1 unit in the last place. Where terms of both signs cancel it is 2 units, times Σ|terms of J|/(a J′) if
    /// that is above 1. It is 4 units where a J′, up to n + 4 times J, overflows, and the radius is found by bisection
    /// instead; a [`Contact`](crate::Contact) refuses that. Where a positive term of J overflows although J does not,
    /// because others are negative, the radius may be too small by some per cent: it is the one at which that term
    /// overflows. A `Contact` refuses that unless J is nearly flat there. It also refuses subnormal load integrals,
    /// whose radius has no more digits than they have.
    ///
    /// # Examples
    ///
    /// ```
    /// use cartcontact::{GapProfile, gap_profile};
    ///
    /// #[gap_profile(0.025 * r^2)]
    /// struct Paraboloid;
    ///
    /// // J(a) = C a⁶/12, Eq. (18).
    /// let a: f64 = Paraboloid.radius(200.0)?;
    /// assert!((a - (12.0 * 200.0 / 0.025_f64).powf(1.0 / 6.0)).abs() < 1e-14);
    /// # Ok::<(), cartcontact::RadiusError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`RadiusError`] for an argument that is negative, not finite, or beyond J of [`max_radius`](Self::max_radius);
    /// up to 30 roundings beyond, by which coefficients that depend on fields may be off, the result is still
    /// `max_radius`. Also where terms of a J′ have both signs and leave the format. If a geometry has no radii at all,
    /// [`check`](Self::check) tells why.
    // Always inlined: otherwise it is a call with its result in memory in one program and not in the next.
    #[inline(always)]
    fn radius(&self, load_integral: T) -> Result<T, RadiusError> {
        self.radius_within(load_integral, self.max_radius())
    }

    /// The contact radius as [`radius`](Self::radius) gives it, for a caller who knows the end of the range:
    /// where coefficients depend on fields, [`max_radius`](Self::max_radius) has to be searched for.
    ///
    /// A geometry that [`check`](Self::check) refuses, or a limit beyond the end of the range, is not noticed: a radius
    /// then means nothing.
    ///
    /// # Errors
    ///
    /// [`RadiusError`] for a negative or non-finite load integral, and beyond J(`limit`); a limit that is not a
    /// positive number lies below every radius but that of a load integral of 0.
    fn radius_within(&self, load_integral: T, limit: T) -> Result<T, RadiusError>;

    /// The contact radii of many load integrals, in mm; `radii[i]` belongs to `load_integrals[i]`.
    ///
    /// It gives what [`radius`](Self::radius) gives, several times quicker for a constant geometry.
    ///
    /// # Errors
    ///
    /// [`RadiusError`] if the slices differ in length, and for the first load integral without a radius; the contents
    /// of `radii` then mean nothing.
    ///
    /// # Examples
    ///
    /// ```
    /// use cartcontact::{GapProfile, gap_profile};
    ///
    /// #[gap_profile(0.025 * r^2 + 1.09375e-4 * r^4)]
    /// struct Patellofemoral;
    ///
    /// let mut radii = [0.0; 3];
    /// Patellofemoral.radii(&[0.0, 100.0, 200.0], &mut radii)?;
    /// assert_eq!(radii[2], Patellofemoral.radius(200.0)?);
    /// # Ok::<(), cartcontact::RadiusError>(())
    /// ```
    fn radii(&self, load_integrals: &[T], radii: &mut [T]) -> Result<(), RadiusError> {
        self.radii_within(load_integrals, self.max_radius(), radii)
    }

    /// The contact radii as [`radii`](Self::radii) gives them, for a caller who knows the end of the range.
    ///
    /// # Errors
    ///
    /// [`RadiusError`] as [`radii`](Self::radii), and beyond J(`limit`).
    fn radii_within(&self, load_integrals: &[T], limit: T, radii: &mut [T]) -> Result<(), RadiusError> {
        check_places(load_integrals, radii)?;
        for (radius, &load_integral) in radii.iter_mut().zip(load_integrals) {
            *radius = self.radius_within(load_integral, limit)?;
        }
        Ok(())
    }

    /// The end of the admissible range of contact radii a, in mm, in which the gap at the edge exceeds its mean over
    /// the contact disc; infinity if it has no end, and 0 if there is no such range.
    ///
    /// # Formula
    ///
    /// ```text
    /// δ₀′(a) > 0,     which is Φ(a) > (2/a²) ∫₀ᵃ Φ r dr
    /// ```
    ///
    /// # Accuracy
    ///
    /// With coefficients known at run time the end is found numerically and never too large. It is too small by the
    /// rounding of logarithms:
    ///
    /// - mostly by less than 100 ε;
    /// - by hundreds where terms nearly cancel on the way, powers are high or coefficients large, and by some thousand
    ///   with coefficients as small as 1e-30 as well;
    /// - by 100 ε over the difference of two exponents, if that is small;
    /// - by the square root of 100 ε where δ₀′ only touches zero.
    ///
    /// # Examples
    ///
    /// ```
    /// # use cartcontact::{GapProfile, Polynomial};
    /// // δ₀′ ∝ C r − (4/3) 1e-4 r³ vanishes at r² = 0.025/(4/3 1e-4).
    /// let oblate = Polynomial::new([(0.025, 2.0), (-1e-4, 4.0)])?;
    /// assert!((oblate.max_radius() - 187.5_f64.sqrt()).abs() < 1e-12);
    /// # Ok::<(), cartcontact::ProfileError>(())
    /// ```
    fn max_radius(&self) -> T;

    /// The drop of the load integral J(a) − J(a − depth) for 0 ≤ depth ≤ a, in mm⁵. For the solver: it tells how long
    /// ago the edge of the contact passed a radius.
    ///
    /// Its relative error does not grow as the depth becomes small; the difference of two values of J, or of
    /// two rounded radii, would lose what they share.
    fn load_integral_drop(&self, a: T, depth: T) -> T {
        let half = T::constant(0.5);
        if depth > a * half {
            return self.load_integral(a) - self.load_integral(a - depth);
        }
        Rule::FINEST.nodes(T::zero(), depth).fold(T::zero(), |sum, (h, weight)| {
            let s = a - h;
            let square = s * s;
            sum + weight * half * square * square * self.quick_approach_slope(s)
        })
    }

    /// δ₀′(s), which has no dimension, and the drops J(a) − J(s), in mm⁵, at radii s = a − depth. For the solver: a
    /// memory integral takes them at its nodes.
    ///
    /// The four slices have the same length. `radii` and `depths` give the same places, each rounded by itself; the
    /// drops, and slopes of high powers, keep the digits of the depths.
    #[inline(always)]
    fn fill_slopes_and_drops(
        &self,
        a: T,
        (radii, depths): (&[T], &[T]),
        (slopes, drops): (&mut [T], &mut [T]),
    ) {
        fill_one_by_one(self, a, (radii, depths), (slopes, drops));
    }

    /// The largest exponent n of the gap, 64 if a profile does not say. For the solver, which chooses quadrature rules
    /// by it: a lower one is quicker, and a profile with higher powers that does not say so loses digits.
    fn highest_exponent(&self) -> T {
        T::constant(64.0)
    }

    /// Whether all exponents are whole, so that the profile is smooth at r = 0. For the solver: where it is not,
    /// integrals that begin there are taken in a variable in which they are smooth.
    fn is_smooth_at_centre(&self) -> bool {
        false
    }

    /// Whether no coefficient is negative. For the solver: where one may be, integrals watch for radii at which δ₀′
    /// nearly vanishes.
    fn has_only_positive_terms(&self) -> bool {
        false
    }

    /// Whether [`radii`](Self::radii) has vector code. Where it has none, memory integrals over many short pieces of a
    /// load find their radii by [`fill_slopes_and_drops`](Self::fill_slopes_and_drops).
    #[doc(hidden)]
    fn has_quick_radii(&self) -> bool {
        false
    }

    /// Checks the values of a geometry whose coefficients are known only at run time.
    ///
    /// # Errors
    ///
    /// [`ProfileError`] if a field that is declared positive is not, a field or a coefficient does not fit the format,
    /// the range is not positive or goes beyond a surface, or the geometry is not admissible.
    fn check(&self) -> Result<(), ProfileError> {
        Ok(())
    }

    /// [`max_radius`](Self::max_radius) of a geometry that passes its [`check`](Self::check): with fields both search the
    /// same range.
    #[doc(hidden)]
    fn checked_max_radius(&self) -> Result<T, ProfileError> {
        self.check().map(|()| self.max_radius())
    }
}
