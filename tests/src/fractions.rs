//! Geometries whose powers are multiples of a common fraction, and so whole powers of a root of the radius.

use cartcontact::gap_profile;

/// Thirds.
#[gap_profile(0.02 * r^(2/3) + 1e-3 * r^2)]
#[derive(Clone, Copy, Debug)]
pub struct Thirds;

/// Quarters, far apart.
#[gap_profile(0.02 * r^0.25 + 1e-3 * r^8.75)]
#[derive(Clone, Copy, Debug)]
pub struct Quarters;

/// Tenths.
#[gap_profile(0.02 * r^1.1 + 1e-3 * r^2.2 + 2e-4 * r^3.3)]
#[derive(Clone, Copy, Debug)]
pub struct Tenths;

/// Twentieths, the smallest fractions for which there is a root.
#[gap_profile(0.02 * r^0.35 + 1e-3 * r^4.05)]
#[derive(Clone, Copy, Debug)]
pub struct Twentieths;

/// The common fraction is too small for a root.
#[gap_profile(0.02 * r^2.37 + 1e-3 * r^3.5)]
#[derive(Clone, Copy, Debug)]
pub struct Hundredths;
