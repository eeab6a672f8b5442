//! The numbers the crate computes with.

use core::any::TypeId;

use simba::scalar::{RealField, SupersetOf};

use crate::numbers::bits::nearest_integer;

/// A real number type: every `simba`/`nalgebra` [`RealField`][simba] that is `Copy`.
///
/// `f32` and `f64` are such types, and so are the dual numbers of `num-dual` over them, with which every result carries
/// its derivatives: write the joint as a function of `T: Scalar`, with `T::constant` for its constants, as the example
/// `sensitivities` does; `num_dual::jacobian` takes such a function of an `SVector` as it is. Functions such as `exp`
/// come with the bound, without an import. Dual numbers of dual numbers, and those such as `DualDVec64` whose number of
/// variables is known only at run time, do not qualify. A release of `num-dual` fits if it is made for the same
/// `simba`: 0.15 for 0.10, with `nalgebra` 0.35. It needs the standard library, and its feature `nalgebra`, a default
/// one. A radius with one derivative takes about twice as long as without, a pressure under a held load some four times,
/// eight after thirty e-foldings, and one under a load of a hundred knots seven times. Up to eight derivatives at once,
/// as from `jacobian`, take 0.9 to 2.2 times as many instructions as one run with a `Dual64` for each. Derivatives of
/// radii are right to rounding up to the third, first ones within 7 ε where terms are positive.
///
/// At a knot, derivatives with respect to time are those of what follows it.
///
/// These derivatives, of pressures unless other results are named, may be wrong or NaN:
///
/// - third ones with respect to time at t = 0 or at a knot;
/// - second ones with respect to time less than a millionth of an e-folding after either, or in rows of a field so close
///   to each other: the less the radius has grown, the fewer digits are right;
/// - where χ = 0, under a load that is not straight between knots: second ones, and first ones with respect to χ unless
///   the force is constant;
/// - first ones with respect to r next to the axis, where they vanish: they may be off by as much as ε P/a;
/// - under loads below some 1e-200 N, or in `f32` below 1e-30 N and above 1e15 N, also those of the approach: squares on
///   the way leave the format; second ones in `f64` below 1e-75 N and above 1e75 N, too, where fourth powers do;
/// - with respect to m, also those of radius and approach, where m is outside 1e-150 to 1e150, or 1e-17 to 1e18 in
///   `f32`, and second ones in `f64` outside 1e-75 to 1e75: powers of 1/m leave the format, and the derivatives may be
///   zero or off by a factor as well as NaN. In SI units m is 1e14 to 1e17;
/// - with respect to the coefficient of rⁿ, also those of radius and approach, where aⁿ⁺⁴ comes near the end of the
///   format, as in `f32` in µm for r⁶ and higher powers: NaN;
/// - those of a radius from a load integral below the normal numbers or within a factor 6 of the largest number: zero or
///   infinite, and where they make the radius no number it is refused;
/// - those with respect to a parameter that changes a user-defined force strongly while the force itself hardly varies,
///   such as b in F (1 − b e^(−t/τ)) at b = 0 with a short τ, or bends a force whose value is straight or a parabola,
///   such as p in F t^p at p = 1 (off by 3e-5) or 2 (off by 2e-9, second ones by 1e-7), because the values alone decide
///   how closely a force is followed. A knot where the parameter begins to act and some after it, a small b, or a p next
///   to 1 or 2 remedy that.
///
/// [simba]: https://docs.rs/simba/0.10/simba/scalar/trait.RealField.html
///
/// # Examples
///
/// ```
/// use cartcontact::Scalar;
///
/// fn half<T: Scalar>(x: T) -> T {
///     x * T::constant(0.5)
/// }
/// assert_eq!(half(3.0_f32), 1.5);
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a real number type",
    label = "not a real number",
    note = "write a number with a decimal point, as in `100.0`, and types as `f64` or `f32`",
    note = "dual numbers are those of `num-dual` 0.15, which is made for the same `simba`"
)]
pub trait Scalar: RealField + Copy {
    /// The number nearest to a literal; exact whenever `Self` holds it.
    fn constant(value: f64) -> Self;

    /// The plain value, without derivatives, for messages and for decisions on size.
    fn value(self) -> f64;

    /// Positive infinity.
    fn infinity() -> Self;
}

#[diagnostic::do_not_recommend]
impl<T: RealField + Copy> Scalar for T {
    #[inline(always)]
    fn constant(value: f64) -> Self {
        <T as SupersetOf<f64>>::from_subset(&value)
    }

    #[inline(always)]
    fn value(self) -> f64 {
        <T as SupersetOf<f64>>::to_subset_unchecked(&self)
    }

    #[inline(always)]
    fn infinity() -> Self {
        <T as SupersetOf<f32>>::from_subset(&f32::INFINITY)
    }
}

/// The numbers nearest to literals.
#[inline(always)]
pub fn constants<T: Scalar, const N: usize>(values: [f64; N]) -> [T; N] {
    values.map(T::constant)
}

/// ⌊x⌋ of a number below 2²⁰ in size; dual numbers have no `floor` of their own.
#[inline]
pub(crate) fn floor<T: Scalar>(x: T) -> i32 {
    if !has_no_derivatives::<T>() {
        return floor(x.value());
    }
    let (nearest, integer) = nearest_integer(x);
    integer - i32::from(nearest > x)
}

/// The lesser of two numbers, the first unless it is greater. One instruction, as NaN is not looked for.
#[inline(always)]
pub(crate) fn lesser<T: Scalar>(x: T, y: T) -> T {
    if y < x { y } else { x }
}

/// The greater of two numbers, the first unless it is less.
#[inline(always)]
pub(crate) fn greater<T: Scalar>(x: T, y: T) -> T {
    if y > x { y } else { x }
}

/// Whether a number may be a time, force, impulse or distance: finite and not negative.
#[inline(always)]
pub(crate) fn is_finite_and_not_negative<T: Scalar>(x: T) -> bool {
    (x >= T::zero()) & x.is_finite()
}

/// Whether a number may be a size such as a thickness: finite and above zero.
#[inline(always)]
pub(crate) fn is_finite_and_positive<T: Scalar>(x: T) -> bool {
    (x > T::zero()) & x.is_finite()
}

/// Whether a number is finite, above zero and not subnormal.
#[inline(always)]
pub(crate) fn is_normal_and_positive<T: Scalar>(x: T) -> bool {
    (x >= smallest_normal()) & x.is_finite()
}

/// A number of single precision.
#[inline(always)]
pub fn from_single<T: Scalar>(value: f32) -> T {
    <T as SupersetOf<f32>>::from_subset(&value)
}

/// Whether numbers of this type are nothing but their values; others, such as dual numbers, may carry derivatives.
#[inline]
pub(crate) fn has_no_derivatives<T: Scalar>() -> bool {
    is_same::<T, f64>() || is_same::<T, f32>()
}

/// The plain value of a number of single precision.
#[inline(always)]
pub(crate) fn single_value<T: Scalar>(x: T) -> f32 {
    <T as SupersetOf<f32>>::to_subset_unchecked(&x)
}

/// The highest order of derivatives that numbers of this type may carry, up to the third, which is the highest that
/// `num-dual` has. With derivatives of order k they are made of k + 1 numbers or more.
#[inline(always)]
pub(crate) fn highest_derivative<T: Scalar>() -> usize {
    let plain = if is_single::<T>() { size_of::<f32>() } else { size_of::<f64>() };
    (size_of::<T>() / plain).clamp(1, 4) - 1
}

/// The value alone, as a number without derivatives.
#[inline(always)]
pub(crate) fn without_derivatives<T: Scalar>(x: T) -> T {
    if has_no_derivatives::<T>() { x } else { T::constant(x.value()) }
}

/// The derivatives alone, beside a value of zero.
#[inline(always)]
pub(crate) fn derivatives<T: Scalar>(x: T) -> T {
    x - without_derivatives(x)
}

/// The value of one number with the derivatives of another.
#[inline(always)]
pub(crate) fn with_value<T: Scalar>(value: T, x: T) -> T {
    if has_no_derivatives::<T>() { value } else { without_derivatives(value) + derivatives(x) }
}

/// A function of the values of numbers, each in its own format, without derivatives.
#[inline(always)]
pub(crate) fn of_values<T: Scalar, const N: usize>(
    numbers: [T; N],
    single: impl Fn([f32; N]) -> f32,
    double: impl Fn([f64; N]) -> f64,
) -> T {
    if is_single::<T>() {
        from_single(single(numbers.map(single_value)))
    } else {
        T::constant(double(numbers.map(T::value)))
    }
}

/// Whether a number is zero and cannot carry a derivative.
#[inline]
pub(crate) fn is_plain_zero<T: Scalar>(x: T) -> bool {
    has_no_derivatives::<T>() && x.is_zero()
}

/// The number with its value raised to zero if that is negative; derivatives stay.
#[inline]
pub(crate) fn raised_to_zero<T: Scalar>(x: T) -> T {
    if has_no_derivatives::<T>() {
        x.max(T::zero())
    } else if x < T::zero() {
        derivatives(x)
    } else {
        x
    }
}

/// Whether a number has the digits and the range of single precision, such as f32 and its dual numbers.
#[inline(always)]
pub(crate) fn is_single<T: Scalar>() -> bool {
    T::default_epsilon() > T::constant(1e-10)
}

/// The smallest normal number.
#[inline(always)]
pub(crate) fn smallest_normal<T: Scalar>() -> T {
    T::constant(if is_single::<T>() { f64::from(f32::MIN_POSITIVE) } else { f64::MIN_POSITIVE })
}

/// Whether two types are the same.
///
/// `is_same::<T, f32>` is for what has found that a number [has no derivatives](has_no_derivatives), and says nothing of
/// dual numbers. Where digits and range count, which dual numbers of f32 share, [`is_single`] is right.
#[inline(always)]
pub(crate) fn is_same<T: 'static, U: 'static>() -> bool {
    TypeId::of::<T>() == TypeId::of::<U>()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn floor_rounds_down() {
        let floors = [(2.0, 2), (2.7, 2), (-2.0, -2), (-2.1, -3), (0.25, 0)];
        for (x, expected) in floors {
            assert_eq!((floor::<f64>(x), floor::<f32>(x as f32)), (expected, expected), "{x}");
        }
    }
}
