//! Code for the instructions that the processor has, and code out of the way.
//!
//! A program is compiled for the oldest processor it may run on. [`wide`] and [`half_wide`] compile their argument once
//! more for each of some vector extensions, [`fused_or_split`] one of two arguments for processors that multiply and
//! add in one instruction; all choose between them when they are called.
//!
//! **Results do not depend on the choice.** Vectors take several values at once, but every value goes through
//! the same operations with the same roundings: no product is fused with a sum, and no sum is reordered. Fused
//! instructions only find the error of a product, which has no other value where it is representable: see
//! [`DoubleWord`](crate::numbers::double_word::DoubleWord).

use crate::Scalar;
use crate::scalar::has_no_derivatives;

/// Runs `work`, whose loops over values may use wide vectors if the feature `simd` is on.
///
/// Only code that is inlined into `work` gains: `work` itself and the functions that its loops call must be
/// `#[inline(always)]`. A call costs some nanoseconds and a copy of the code per extension, so it belongs around loops
/// over many values and around nothing else.
#[cfg_attr(
    feature = "simd",
    multiversion::multiversion(targets("x86_64+avx512f+avx512bw+avx512dq+avx512vl", "x86_64+avx2"))
)]
pub(crate) fn wide<R, W: FnOnce() -> R>(work: W) -> R {
    work()
}

/// [`wide`] for numbers without derivatives. Vectors of numbers with some are filled by shuffles, which take longer than
/// what they save.
#[inline(always)]
pub(crate) fn wide_without_derivatives<T: Scalar, R>(work: impl FnOnce() -> R) -> R {
    if has_no_derivatives::<T>() { wide(work) } else { work() }
}

/// [`wide`] without the widest vectors, for loops over a few dozen values between code that has none.
///
/// Operations of 512 bits close a vector port: they keep other instructions, also those of the code around, from one of
/// three. A panel of a memory integral is quicker with two vectors of 256 bits than with one of 512.
#[cfg_attr(feature = "simd", multiversion::multiversion(targets("x86_64+avx2")))]
pub(crate) fn half_wide<R, W: FnOnce() -> R>(work: W) -> R {
    work()
}

/// Whether every processor of the target multiplies and adds with one rounding in one instruction. Without the standard
/// library that would be a routine.
pub(crate) const FUSES: bool =
    cfg!(all(feature = "std", any(target_feature = "fma", target_arch = "aarch64")));

/// Runs `fused` if the processor multiplies and adds with one rounding in one instruction, otherwise `split`.
///
/// As with `wide`, only code that is inlined into `fused` has that instruction; others call a routine. The choice
/// takes about a nanosecond, but nothing is shared with the code around: coefficients that follow from fields are
/// computed anew in every round of a loop.
#[cfg_attr(feature = "simd", multiversion::multiversion(targets("x86_64+fma")))]
pub fn fused_or_split<R, F: FnOnce() -> R, S: FnOnce() -> R>(fused: F, split: S) -> R {
    #[cfg(feature = "simd")]
    let fuses = FUSES || multiversion::target::target_cfg_f!(target_feature = "fma");
    #[cfg(not(feature = "simd"))]
    let fuses = FUSES;
    if fuses { fused() } else { split() }
}

/// The value of an expression by [`fused_or_split`](crate::generated::fused_or_split). In the expression a constant,
/// named first, says whether double words are `FUSED`.
#[doc(hidden)]
#[macro_export]
macro_rules! in_double_words {
    ($fused:ident => $value:expr) => {
        $crate::generated::fused_or_split(
            #[inline(always)]
            || {
                const $fused: ::core::primitive::bool = true;
                $value
            },
            #[inline(always)]
            || {
                const $fused: ::core::primitive::bool = false;
                $value
            },
        )
    };
}

/// What has been found, otherwise the result of `work`, out of line.
#[inline(always)]
pub fn found_or<T, E>(found: Option<T>, work: impl FnOnce() -> Result<T, E>) -> Result<T, E> {
    match found {
        Some(found) => Ok(found),
        None => out_of_line(work),
    }
}

/// Calls `work` in a cold function of its own, so that the quick path before it stays small.
#[cold]
#[inline(never)]
pub(crate) fn out_of_line<R>(work: impl FnOnce() -> R) -> R {
    work()
}
