//! Arithmetic on many values with the widest vectors that the processor has.
//!
//! A program is compiled for the oldest processor it may run on. [`wide`] compiles its argument once more for each of
//! the vector extensions below, and chooses between them when it is called.
//!
//! **Results do not depend on the choice.** Vectors take several values at once, but every value goes through
//! the same operations with the same roundings: no product is fused with a sum, and no sum is reordered.

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

/// [`wide`] without the widest vectors, for loops over a few dozen values between code that has none.
///
/// Instructions for vectors of 512 bits keep others, also those of the code around, from one of three ports: a panel of
/// a memory integral is quicker with two vectors of 256 bits than with one of 512.
#[cfg_attr(feature = "simd", multiversion::multiversion(targets("x86_64+avx2")))]
pub(crate) fn half_wide<R, W: FnOnce() -> R>(work: W) -> R {
    work()
}
