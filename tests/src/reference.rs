//! The reference values in `reference/`: inputs in full, results to 25 digits.
//!
//! A result is rounded to the nearest `f64` when it is read, so a measured error is off by half an ε at most.

use crate::profiles::{Case, case};

/// The results of `kernels.csv` for one contact radius `a` and one distance `r` from the axis.
#[derive(Clone, Copy, Debug)]
pub struct KernelRow {
    /// The geometry.
    pub case: Case,
    /// A contact radius.
    pub a: f64,
    /// A distance from the axis.
    pub r: f64,
    /// Φ(a).
    pub gap: f64,
    /// δ₀(a).
    pub approach: f64,
    /// δ₀′(a).
    pub approach_slope: f64,
    /// J(a).
    pub load_integral: f64,
    /// L(a).
    pub log_kernel: f64,
    /// G(a, r).
    pub pressure_kernel: f64,
}

/// One row of `radius.csv`: (π m/4) J(a) = y.
#[derive(Clone, Copy, Debug)]
pub struct RadiusRow {
    /// The geometry.
    pub case: Case,
    /// The stiffness.
    pub m: f64,
    /// The hereditary load.
    pub y: f64,
    /// The contact radius.
    pub a: f64,
}

/// One row of `contact.csv`.
#[derive(Clone, Debug)]
pub struct ContactRow {
    /// The geometry.
    pub case: Case,
    /// The stiffness.
    pub m: f64,
    /// The rate of the memory.
    pub chi: f64,
    /// The knots (time, force) of the load.
    pub knots: Vec<(f64, f64)>,
    /// A time.
    pub t: f64,
    /// A distance from the axis.
    pub r: f64,
    /// a(t).
    pub radius: f64,
    /// δ₀(t).
    pub approach: f64,
    /// P(r, t).
    pub pressure: f64,
    /// P(0, t).
    pub peak_pressure: f64,
}

/// One row of `finite_element_history.csv`.
#[derive(Clone, Copy, Debug)]
pub struct FiniteElementRow {
    /// The time.
    pub t: f64,
    /// The load.
    pub load: f64,
    /// The contact radius.
    pub radius: f64,
    /// The approach.
    pub approach: f64,
    /// The pressure on the axis.
    pub peak_pressure: f64,
}

/// All of `kernels.csv`.
#[must_use]
pub fn kernels() -> Vec<KernelRow> {
    let row = |[name, rest @ ..]: [&str; 9]| {
        let [a, r, gap, approach, approach_slope, load_integral, log_kernel, pressure_kernel] =
            rest.map(number);
        let case = case(name);
        KernelRow { case, a, r, gap, approach, approach_slope, load_integral, log_kernel, pressure_kernel }
    };
    rows(include_str!("../reference/kernels.csv")).map(row).collect()
}

/// All of `radius.csv`.
#[must_use]
pub fn radii() -> Vec<RadiusRow> {
    let row = |[name, rest @ ..]: [&str; 4]| {
        let [m, y, a] = rest.map(number);
        RadiusRow { case: case(name), m, y, a }
    };
    rows(include_str!("../reference/radius.csv")).map(row).collect()
}

/// All of `contact.csv`.
#[must_use]
pub fn contacts() -> Vec<ContactRow> {
    let row = |[name, m, chi, load, rest @ ..]: [&str; 10]| {
        let [t, r, radius, approach, pressure, peak_pressure] = rest.map(number);
        let (m, chi, knots) = (number(m), number(chi), knots(load));
        ContactRow { case: case(name), m, chi, knots, t, r, radius, approach, pressure, peak_pressure }
    };
    rows(include_str!("../reference/contact.csv")).map(row).collect()
}

/// All of `finite_element_history.csv`.
#[must_use]
pub fn finite_elements() -> Vec<FiniteElementRow> {
    let row = |columns: [&str; 5]| {
        let [t, load, radius, approach, peak_pressure] = columns.map(number);
        FiniteElementRow { t, load, radius, approach, peak_pressure }
    };
    rows(include_str!("../reference/finite_element_history.csv")).map(row).collect()
}

/// The rows below the header, cut at commas; lines that begin with `#` are comments.
fn rows<const N: usize>(text: &str) -> impl Iterator<Item = [&str; N]> {
    text.lines().filter(|line| !line.starts_with('#')).skip(1).map(|line| {
        let columns: Vec<&str> = line.split(',').collect();
        columns.try_into().unwrap_or_else(|columns| unreachable!("not {N} columns: {columns:?}"))
    })
}

/// `name=time:force;time:force`.
fn knots(text: &str) -> Vec<(f64, f64)> {
    let (_, knots) = text.split_once('=').unwrap_or(("", text));
    let knot = |knot: &str| knot.split_once(':').map(|(time, force)| (number(time), number(force)));
    knots.split(';').filter_map(knot).collect()
}

fn number(text: &str) -> f64 {
    text.parse().unwrap_or_else(|error| unreachable!("{text}: {error}"))
}
