//! Arithmetic on sums of powers: what generated solvers and [`Polynomial`](crate::Polynomial) are made of.
//!
//! | what | modules |
//! |---|---|
//! | digits and exponents of numbers | `bits` (of f32 and f64, without branches), `binary` (of every scalar, subnormals too), `exponent` |
//! | numbers with more digits | `halved` (an error of ε/1000), `double_word` (of ε²), `compensated_sum`; `coefficient` (from fields); `arithmetic` is a trait of plain and double words |
//! | functions | `exponential`, `logarithm` (plain words, for vector loops), `double_functions` (double words), `series` |
//! | sums of powers | `horner` (all powers of a polynomial), `power` (any exponents), `double_power` (the same, rounded once), `steepness` (a sum with its derivatives) |
//! | pressure kernels | `pressure_kernel`, `kernel_of_term`, `real_exponent_kernel` |

pub(crate) mod arithmetic;
pub(crate) mod binary;
pub(crate) mod bits;
pub(crate) mod coefficient;
pub(crate) mod compensated_sum;
pub(crate) mod double_functions;
pub(crate) mod double_power;
pub(crate) mod double_word;
pub(crate) mod exponent;
pub(crate) mod exponential;
pub(crate) mod halved;
pub(crate) mod horner;
mod kernel_of_term;
pub(crate) mod logarithm;
pub(crate) mod power;
pub(crate) mod pressure_kernel;
pub(crate) mod real_exponent_kernel;
pub(crate) mod series;
pub(crate) mod steepness;
