//! Numbers of the machine and their functions, which know nothing of geometries.
//!
//! | what | modules |
//! |---|---|
//! | digits and exponents of numbers | `bits` (of f32 and f64, without branches), `binary` (of every scalar, subnormals too), `exponent` |
//! | numbers with more digits | `halved` (an error of ε/1000), `double_word` (of ε²), `compensated_sum` |
//! | functions | `exponential`, `logarithm` (plain words, for vector loops), `double_functions` (double words), `series` |
//! | numbers known beforehand | `tabled` (in both formats), `cosines` |

pub(crate) mod binary;
pub(crate) mod bits;
pub(crate) mod compensated_sum;
pub(crate) mod cosines;
pub(crate) mod double_functions;
pub(crate) mod double_word;
pub(crate) mod exponent;
pub(crate) mod exponential;
pub(crate) mod halved;
pub(crate) mod logarithm;
pub(crate) mod series;
pub(crate) mod tabled;
