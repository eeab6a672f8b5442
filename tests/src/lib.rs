//! What the tests share: geometries, reference values, an error measure, and the table of allowed errors.

pub mod budget;
pub mod condition;
pub mod fractions;
pub mod inversion;
pub mod joint;
pub mod kernel;
pub mod loads;
pub mod measure;
pub mod oracle;
pub mod planted;
pub mod profiles;
pub mod quadrature;
pub mod random;
pub mod reference;
pub mod stress;

/// Runs the examples of the README as tests; they are here because the package of the library holds the file elsewhere.
#[cfg(doctest)]
#[doc = include_str!("../../README.md")]
struct Readme;
