//! What generated code calls. Not part of the interface: it changes together with the macro of the same version.

// Generated code imports this module by this name and nothing else: a wrong path to the crate is then one error, which
// points to the end of the path. Imported as `generated`, the error would point to the whole attribute.
pub use crate::admissibility::{
    check_coefficients, check_constants, check_positive, check_product, check_range_of_fields, checked_range,
    inside_surfaces, not_above, not_below_zero,
};
pub use crate::dispatch::{found_or, fused_or_split};
pub use crate::evaluate::coefficient::{Precise, finite_or, rounded};
pub use crate::evaluate::dense_kernel::{
    even_pressure_kernel, quick_even_pressure_kernel, quick_high_even_pressure_kernel,
    quick_whole_pressure_kernel, whole_pressure_kernel,
};
pub use crate::evaluate::double_power::power_sum;
pub use crate::evaluate::drops_by_roots::{drop_by_roots, fill_by_roots};
pub use crate::evaluate::horner::{
    divided_difference, even_divided_difference, precise_even_sum, precise_sum, quick_even_sum,
    value_and_slope,
};
pub use crate::evaluate::long_sums::fill_long_sums;
pub use crate::evaluate::power::{
    integer_power, power_of_half_digits, power_sum_and_log_slope, power_sum_drop, quarter_root,
    quick_power_sum, real_power,
};
pub use crate::evaluate::pressure_kernel::{
    pressure_kernel, quick_pressure_kernel, quick_pressure_kernel_in_root,
};
pub use crate::evaluate::slopes_and_drops::{fill_by_functions, fill_slopes_and_drops};
pub use crate::evaluate::steepness::{
    NestedPowers, Steepness, plain_power_sum_steepness, power_sum_steepness, scaled_power_sum_steepness,
};
pub use crate::generated as root;
pub use crate::in_double_words;
pub use crate::numbers::exponent::{Exponent, whole_terms};
pub use crate::profile::with_parameters;
pub use crate::radius::newton::invert;
pub use crate::radius::one_term::invert_one_term;
pub use crate::radius::real_powers::radius_of_real_powers;
pub use crate::radius::table::curves::{Curves, DoubleCurves, SingleCurves};
pub use crate::radius::table::roots::{OwnTerm, Roots, SingleTerm};
pub use crate::radius::table::spans::{AnyPower, Spans};
pub use crate::radius::table::units::{EqualTerms, OwnUnits, RootOf};
pub use crate::radius::table::{Quarters, Rows, Table, nowhere};
pub use crate::radius::whole_powers::{WholePowers, radii_of_whole_powers};
pub use crate::scalar::{constants, from_single};
pub use crate::{GapProfile, ProfileError, RadiusError, Scalar};
