//! Contact of thin biphasic cartilage layers for any gap profile: contact radius, approach and pressure, solved
//! for a geometry that is checked and specialised at compile time.
//!
//! Cartilage is a thin, fluid-filled layer on bone. I. Argatov solved the axisymmetric contact of two such layers
//! in closed form for an arbitrary gap Φ(r) between the undeformed surfaces (Mech. Res. Commun. 38 (2011) 29–33,
//! doi 10.1016/j.mechrescom.2010.11.006). This crate makes that solution practical:
//!
//! ```
//! use cartcontact::{Contact, Layer, Medium, gap_profile, load};
//!
//! /// Patella on the patellar groove, in mm.
//! #[gap_profile(0.025 * r^2 + 1.09375e-4 * r^4)]
//! struct Patellofemoral;
//!
//! let layer = Layer { thickness: 1.0, shear_modulus: 0.25, permeability: 2e-3 };
//! let medium = Medium::between(layer, layer)?;
//! let contact = Contact::new(Patellofemoral, medium, load::Constant(100.0))?;
//! let now = contact.at(200.0)?; // s
//! assert_eq!(format!("{:.3} mm", now.radius()), "7.447 mm");
//! assert_eq!(format!("{:.4} mm", now.approach()), "0.8052 mm");
//! assert_eq!(format!("{:.4} MPa", now.peak_pressure()), "1.6660 MPa");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # How the data flows
//!
//! A geometry ([`GapProfile`]: an item with [`#[gap_profile]`](macro@gap_profile), or a [`Polynomial`] known at run
//! time only), a [`Medium`] made of [`Layer`]s and a [`load`] make a [`Contact`]. For one time it gives a [`Snapshot`],
//! which has the radius and computes approach and pressures when they are asked for; for many times it fills slices.
//!
//! | symbol | meaning | unit | name |
//! |---|---|---|---|
//! | Φ(r) | gap | mm | [`GapProfile::gap`] |
//! | a(t) | contact radius | mm | [`Snapshot::radius`] |
//! | δ₀(t) | approach of the bones | mm | [`Snapshot::approach`] |
//! | P(r, t) | contact pressure | MPa | [`Snapshot::pressure`] |
//! | F(t) | load | N | [`load::Load::force`] |
//! | ∫F dτ | impulse of the load | N s | [`load::Load::impulse`] |
//! | Y(t) | hereditary load F + χ ∫F dτ, which decides the contact radius | N | |
//! | J(a) | load integral, Y/(π m/4) | mm⁵ | [`GapProfile::load_integral`] |
//! | h, μ, k | thickness, shear modulus and permeability of a layer | mm, MPa, mm⁴/(N s) | [`Layer`] |
//! | m | stiffness of the layers | MPa/mm³ | [`Medium::m`] |
//! | χ | rate of drainage | 1/s | [`Medium::chi`] |
//!
//! Any consistent system of units will do. As fluid drains, pressures depend on the whole history of the load, by a
//! *memory integral*. This memory fades as e^(−χ t), by a factor of e in each *e-folding*, a time of 1/χ. A *knot* is a
//! time at which a load jumps or has a kink; a load is *straight* where it is linear in time.
//!
//! # What it assumes
//!
//! Layers that are thin (a ≫ h) and isotropic on rigid bones, small strains, small slopes of the surfaces over the
//! contact, no friction, axial symmetry, times that are short compared with the diffusion of fluid through a layer's
//! thickness, and loads that do not fall faster than e^(−χ t), so that the contact never shrinks. At t = 0⁺ a
//! biphasic layer responds like an incompressible elastic one. Compared with the exact solution for that (a
//! paraboloid on one bonded layer), at loads for which the model gives a/h = 4, 8, 16 and 32, the radius is 48, 21,
//! 10 and 5 % too large, the approach 30, 9, 2.5 and 0.7 % too large, and the peak pressure 29, 10, 3 and 0.7 % too
//! small. To judge a result, compare [`Snapshot::radius`] with the thickness h, and the time with
//! [`Layer::diffusion_time`]; of two different layers take the thicker one, and the shorter time. Where a ball of
//! radius R in a socket hardly wider has a contact of 0.7 R, the slopes make the radius 2 % and the approach 6 % too
//! large if the gap is expanded from `sphere`; with the paraboloid alone the radius is 11 % too large, approach and
//! peak pressure are 10 % too small.
//!
//! # Numbers
//!
//! All numbers of a contact have one type, a [`Scalar`]: f64, f32, or dual numbers, with which every result carries its
//! derivatives with respect to any parameter, for fits and sensitivities. ε is the distance from 1 to the next number,
//! 2⁻⁵² in f64 and 2⁻²³ in f32.
//!
//! # Errors
//!
//! The arguments of every constructor and every time asked for are checked, and each kind of fault has its own type:
//! [`MediumError`], [`load::LoadError`], [`ProfileError`], [`RadiusError`] and [`ContactError`], which may hold one of
//! the others. A message says what is wrong, the value, and what to do. A `main` that returns an error prints its
//! fields instead; to print the message, format the error with `{error}`.
//!
//! # Features
//!
//! | feature | default | what it does |
//! |---|---|---|
//! | `std` | yes | mathematical functions of the standard library |
//! | `libm` | no | mathematical functions of the `libm` crate, for targets without `std` |
//! | `nalgebra` | yes | `Contact::pressure_matrix`, a pressure field as a `DMatrix` of `nalgebra` 0.35 |
//! | `simd` | yes | the widest vectors and the fused multiply-add of an x86-64 processor, chosen at run time |
//!
//! Without `std` the crate needs `libm`; it does not allocate. `nalgebra` and `simd` switch `std` on.
#![cfg_attr(not(any(feature = "std", test)), no_std)]

#[cfg(not(any(feature = "std", feature = "libm")))]
compile_error!("cartcontact needs mathematical functions; enable the feature `std` or `libm`");

// In the order in which data flow:
//
// | what | modules |
// |---|---|
// | the geometry, and how far it is admissible | `profile`, `polynomial`, `generated` (by the macro); `admissibility` |
// | layers and load | `layer`, `medium`, `load` |
// | a contact, its radius and its memory | `contact`, `radius`, `memory` |
// | results at one time, and at many | `snapshot`, `field` |
// | sums of powers and kernels, for all of these | `evaluate` |
// | what knows nothing of contacts | `numbers`, `quadrature`, `scalar`, `pairs`, `pointers`, `shown`, `dispatch` (to instructions); `worse` (for tests) |
mod admissibility;
mod contact;
mod dispatch;
mod evaluate;
mod field;
#[doc(hidden)]
pub mod generated;
mod layer;
pub mod load;
mod medium;
mod memory;
mod numbers;
mod pairs;
mod pointers;
mod polynomial;
#[cfg(doc)]
#[doc = include_str!("printed_formulas.md")]
pub mod printed_formulas {}
mod profile;
mod quadrature;
mod radius;
mod scalar;
mod shown;
mod snapshot;
#[cfg(test)]
mod worse;

#[doc = include_str!("profile_language.md")]
pub use cartcontact_macros::gap_profile;
pub use contact::{Contact, ContactError};
pub use layer::Layer;
pub use medium::{Medium, MediumError};
pub use pairs::Pairs;
pub use polynomial::Polynomial;
pub use profile::{GapProfile, Parameters, ProfileError, RadiusError};
pub use scalar::Scalar;
pub use snapshot::Snapshot;
