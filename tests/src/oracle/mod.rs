//! The solution from its definition, to more than 40 digits: the measure of every other result.
//!
//! Nothing here is shared with the library. The integrals of Eqs. (10), (14) and (28) are evaluated by quadrature
//! instead of in closed form, and the memory as it is printed,
//!
//! ```text
//! P(r, t) = m [G(a(t), r) − χ ∫ G(a(τ), r) e^(−χ (t−τ)) dτ],    over τ from where a(τ) reaches r,
//! ```
//!
//! instead of in the form without cancellation; both lose digits, but there are enough of them.
//!
//! # Examples
//!
//! To check a geometry of your own, give its terms (C, n), the constants m and χ, and the knots (time, force) of the
//! load:
//!
//! ```
//! use tests::oracle::{Oracle, Profile, digits};
//!
//! let profile = Profile::of_decimals(&[("0.025", "2"), ("1.09375e-4", "4")]);
//! let oracle = Oracle::new(profile, 0.375, 0.0015, &[(0.0, 100.0)]);
//! assert_eq!(digits(&oracle.radius(200.0), 10), "7.446555161");
//! assert_eq!(digits(&oracle.pressure(0.0, 200.0), 10), "1.666007530");
//! ```
//!
//! # References
//!
//! I. Argatov, Mech. Res. Commun. 38 (2011) 29–33, doi 10.1016/j.mechrescom.2010.11.006.

mod history;
pub mod number;
mod profile;
pub mod quadrature;

pub use history::Oracle;
pub use number::{Real, decimal, digits, double, literal, rounded};
pub use profile::Profile;
