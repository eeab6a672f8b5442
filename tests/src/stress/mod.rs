//! Random scenes from every corner of the accepted input, each compared with a solution in 31 digits.

pub mod campaign;
mod condition;
pub mod exact;
pub mod examine;
pub mod fields;
pub mod finding;
pub mod history;
pub mod precision;
pub mod region;
mod report;
pub mod scene;
mod solver;
pub mod soundness;
mod units;
mod usable;
pub mod wide;
