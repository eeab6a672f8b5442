//! Arithmetic on sums of powers: what generated solvers and [`Polynomial`](crate::Polynomial) are made of.

pub(crate) mod arithmetic;
pub(crate) mod binary;
pub(crate) mod bits;
pub(crate) mod compensated_sum;
pub(crate) mod double_functions;
pub(crate) mod double_word;
pub(crate) mod exponent;
pub(crate) mod exponential;
pub(crate) mod halved;
pub(crate) mod horner;
pub(crate) mod logarithm;
pub(crate) mod power;
pub(crate) mod pressure_kernel;
pub(crate) mod real_exponent_kernel;
mod series;
pub(crate) mod steepness;
