//! Contact of thin biphasic cartilage layers for any gap profile: contact radius, approach and pressure.
#![cfg_attr(not(feature = "std"), no_std)]

mod admissibility;
mod contact;
mod error;
mod evaluate;
mod field;
#[doc(hidden)]
pub mod generated;
mod inversion;
pub mod load;
#[cfg(feature = "nalgebra")]
mod matrix;
mod medium;
mod memory;
mod polynomial;
mod profile;
mod scalar;
mod snapshot;

pub use cartcontact_macros::gap_profile;
pub use contact::{Contact, ContactError};
pub use medium::{Layer, Medium, MediumError};
pub use polynomial::Polynomial;
pub use profile::{GapProfile, ProfileError, RadiusError};
pub use scalar::Scalar;
pub use snapshot::Snapshot;
