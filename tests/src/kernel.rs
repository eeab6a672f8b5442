//! The six functions of a geometry, each in all its forms.

use cartcontact::GapProfile;

use crate::budget::{self, Allowance};
use crate::measure::{Errors, Exact};
use crate::oracle::{Profile, Real};
use crate::reference::KernelRow;

/// A function of a contact radius and a distance from the axis.
#[derive(Clone, Copy, Debug)]
pub struct Kernel {
    /// The error that is allowed for it.
    pub allowance: Allowance,
    /// In double precision.
    pub double: fn(&dyn GapProfile<f64>, f64, f64) -> f64,
    /// In single precision.
    pub single: fn(&dyn GapProfile<f32>, f32, f32) -> f32,
    /// By the oracle.
    pub oracle: fn(&Profile, &Real, &Real) -> Real,
    /// In a row of the reference values.
    pub reference: fn(&KernelRow) -> Exact,
}

impl Kernel {
    /// Σ|terms|/|sum| at a contact radius and a distance from the axis, but at least 1; `sizes` is the geometry
    /// [`of_sizes`](crate::condition::of_sizes) of the same terms. 1 where all of them vanish.
    #[must_use]
    pub fn condition(self, sizes: &dyn GapProfile<f64>, (a, r): (f64, f64), sum: f64) -> f64 {
        if sum == 0.0 { 1.0 } else { ((self.double)(sizes, a, r) / sum).max(1.0) }
    }
}

macro_rules! function_of_radius {
    ($name:ident, $allowance:expr) => {
        Kernel {
            allowance: $allowance,
            double: |profile, a, _| profile.$name(a),
            single: |profile, a, _| profile.$name(a),
            oracle: |profile, a, _| profile.$name(a),
            reference: |row| row.$name,
        }
    };
}

/// All of them.
pub const ALL: [Kernel; 6] = [
    function_of_radius!(gap, budget::GAP),
    function_of_radius!(approach, budget::APPROACH),
    function_of_radius!(approach_slope, budget::APPROACH_SLOPE),
    function_of_radius!(load_integral, budget::LOAD_INTEGRAL),
    function_of_radius!(log_kernel, budget::LOG_KERNEL),
    PRESSURE,
];

/// The pressure kernel, the only one that depends on the distance from the axis.
pub const PRESSURE: Kernel = Kernel {
    allowance: budget::PRESSURE_KERNEL,
    double: |profile, a, r| profile.pressure_kernel(a, r),
    single: |profile, a, r| profile.pressure_kernel(a, r),
    oracle: |profile, a, r| profile.pressure_kernel(a, r),
    reference: |row| row.pressure_kernel,
};

/// The errors of all of them in double precision, in the order of [`ALL`].
#[must_use]
pub fn errors() -> [Errors; 6] {
    ALL.map(|kernel| Errors::of(kernel.allowance))
}

/// The errors of all of them in single precision.
#[must_use]
pub fn errors_of_single() -> [Errors; 6] {
    ALL.map(|kernel| Errors::of_single(kernel.allowance))
}
