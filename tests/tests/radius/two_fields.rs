//! Geometries of two fields, in both formats.

use tests::inversion::Inversion;

/// The terms (C, n) of a geometry, computed in the arithmetic of its scalar, and the geometry.
pub(super) type Found<T> = (Vec<(f64, f64)>, Box<dyn Inversion<T>>);

/// A geometry of two fields.
pub(super) struct OfTwoFields {
    /// In double precision.
    pub(super) double: fn(f64, f64) -> Found<f64>,
    /// In single precision.
    pub(super) single: fn(f32, f32) -> Found<f32>,
}

/// The geometry of two fields that an expression builds, for either scalar.
macro_rules! of_two_fields {
    (|$first:ident, $second:ident| $profile:expr) => {
        $crate::two_fields::OfTwoFields {
            double: |$first, $second| ($profile.terms().to_vec(), Box::new($profile)),
            single: |$first, $second| {
                ($profile.terms().map(|(c, n)| (c.into(), n.into())).to_vec(), Box::new($profile))
            },
        }
    };
}
pub(super) use of_two_fields;
