//! Sums of powers, and of pressure kernels: what generated solvers and [`Polynomial`](crate::Polynomial) are made of.
//!
//! | what | modules |
//! |---|---|
//! | sums of powers | `horner` (all powers of a polynomial), `power` (any exponents), `double_power` (the same, rounded once), `steepness` (a sum with its derivatives) |
//! | δ₀′ and drops of J at many radii | `slopes_and_drops` (any exponents), `drops_by_roots` (multiples of 1/4), `long_sums` (many whole ones) |
//! | pressure kernels | `pressure_kernel` (any exponents), `kernel_of_term`, `real_exponent_kernel`; `dense_kernel` (all whole or even ones) |
//! | what they are made of | `coefficient` (a number, or what follows from fields), `arithmetic` (a trait of plain and double words) |
//!
//! Three words in names say how exact a result is. *Plain*: every operation is rounded. *Quick*: within a few ε, mostly
//! in plain arithmetic, corrected where errors would add up. *Precise*: rounded once. A function without any of these
//! words is rounded once if there is a `quick_` function of the same name; otherwise its documentation says how exact
//! it is.

mod arithmetic;
pub(crate) mod coefficient;
pub(crate) mod dense_kernel;
pub(crate) mod double_power;
pub(crate) mod drops_by_roots;
pub(crate) mod horner;
mod kernel_of_term;
pub(crate) mod long_sums;
pub(crate) mod power;
pub(crate) mod pressure_kernel;
mod real_exponent_kernel;
pub(crate) mod slopes_and_drops;
pub(crate) mod steepness;
