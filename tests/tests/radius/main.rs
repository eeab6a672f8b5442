//! The contact radius as a function of the load integral: its laws, and geometries for which it is found in different
//! ways, against the oracle.

mod any_power;
mod both_signs;
mod checks;
mod common_fractions;
mod laws;
mod one_term;
mod outside_tables;
mod own_units;
mod single_precision;
mod sums;
mod three_fields;
mod two_fields;
