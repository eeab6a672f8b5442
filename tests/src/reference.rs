//! The reference values in `reference/`: inputs in full, results to 25 digits.

use cartcontact::{Contact, ContactError, GapProfile, Medium, Scalar};

use crate::loads::through;
use crate::measure::Exact;
use crate::oracle::decimal;
use crate::profiles::{Case, case};

/// How much smaller the radius of one layer on a rigid body is than in the model, in thicknesses, see `thin_layers`.
pub const SHIFT_OF_EDGE: f64 = 1.46;

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
    pub gap: Exact,
    /// δ₀(a).
    pub approach: Exact,
    /// δ₀′(a).
    pub approach_slope: Exact,
    /// J(a).
    pub load_integral: Exact,
    /// L(a).
    pub log_kernel: Exact,
    /// G(a, r).
    pub pressure_kernel: Exact,
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
    pub a: Exact,
}

/// One row of `contact.csv`.
#[derive(Clone, Debug)]
pub struct ContactRow {
    /// The geometry.
    pub case: Case,
    /// The stiffness.
    pub m: f64,
    /// The rate of drainage.
    pub chi: f64,
    /// The knots (time, force) of the load.
    pub knots: Vec<(f64, f64)>,
    /// A time.
    pub t: f64,
    /// A distance from the axis.
    pub r: f64,
    /// a(t).
    pub radius: Exact,
    /// δ₀(t).
    pub approach: Exact,
    /// P(r, t).
    pub pressure: Exact,
    /// P(0, t).
    pub peak_pressure: Exact,
}

impl ContactRow {
    /// a(t), δ₀(t), P(r, t) and P(0, t) by a solver, from input in some format.
    ///
    /// # Panics
    ///
    /// If there is no such contact.
    pub fn solved<T: Scalar>(&self, profile: &dyn GapProfile<T>, format: fn(f64) -> T) -> [f64; 4] {
        let knots: Vec<(T, T)> = self.knots.iter().map(|&(t, force)| (format(t), format(force))).collect();
        let solve = || {
            let medium = Medium::from_constants(format(self.m), format(self.chi))?;
            let contact = Contact::new(profile, medium, through(&knots))?;
            let now = contact.at(format(self.t))?;
            Ok([now.radius(), now.approach(), now.pressure(format(self.r)), now.peak_pressure()]
                .map(T::value))
        };
        solve().unwrap_or_else(|error: ContactError| unreachable!("{self:?}: {error}"))
    }
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
        let [a, r, results @ ..] = rest;
        let [gap, approach, approach_slope, load_integral, log_kernel, pressure_kernel] = results.map(exact);
        let (case, a, r) = (case(name), number(a), number(r));
        KernelRow { case, a, r, gap, approach, approach_slope, load_integral, log_kernel, pressure_kernel }
    };
    rows(include_str!("../reference/kernels.csv")).map(row).collect()
}

/// All of `radius.csv`.
#[must_use]
pub fn radii() -> Vec<RadiusRow> {
    let row =
        |[name, m, y, a]: [&str; 4]| RadiusRow { case: case(name), m: number(m), y: number(y), a: exact(a) };
    rows(include_str!("../reference/radius.csv")).map(row).collect()
}

/// All of `contact.csv`.
#[must_use]
pub fn contacts() -> Vec<ContactRow> {
    let row = |[name, m, chi, load, rest @ ..]: [&str; 10]| {
        let [t, r, results @ ..] = rest;
        let [radius, approach, pressure, peak_pressure] = results.map(exact);
        let ([m, chi, t, r], knots) = ([m, chi, t, r].map(number), knots(load));
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

/// The rows of a file below its header, cut at commas; lines that begin with `#` are comments.
///
/// # Panics
///
/// If one does not have N columns.
pub fn rows<const N: usize>(text: &str) -> impl Iterator<Item = [&str; N]> {
    text.lines().filter(|line| !line.starts_with('#')).skip(1).map(|line| {
        let columns: Vec<&str> = line.split(',').collect();
        columns.try_into().unwrap_or_else(|columns| unreachable!("not {N} columns: {columns:?}"))
    })
}

/// The knots of a load: `name=time:force;time:force`.
///
/// # Panics
///
/// If one is not such a pair of numbers.
#[must_use]
pub fn knots(text: &str) -> Vec<(f64, f64)> {
    let (_, knots) = text.split_once('=').unwrap_or(("", text));
    let knot = |knot: &str| knot.split_once(':').map(|(time, force)| (number(time), number(force)));
    knots.split(';').map(|text| knot(text).unwrap_or_else(|| unreachable!("{text} is no knot"))).collect()
}

/// A number of a file.
///
/// # Panics
///
/// If it is none.
#[must_use]
pub fn number(text: &str) -> f64 {
    text.parse().unwrap_or_else(|error| unreachable!("{text}: {error}"))
}

fn exact(text: &str) -> Exact {
    Exact::from(&decimal(text))
}
