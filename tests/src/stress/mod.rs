//! Random scenes from every corner of the accepted input, each compared with a solution in 31 digits.

pub mod campaign;
mod condition;
mod exact;
mod examine;
mod fields;
pub mod finding;
mod history;
pub mod precision;
pub mod region;
mod report;
mod scene;
mod solver;
pub mod soundness;
mod units;
mod usable;
pub mod wide;
