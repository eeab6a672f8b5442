//! The memory of the pressure: what a load history leaves behind, K⁻¹ of Eq. (28) without cancellation.
//!
//! Between two times t₁ < t₂ the pressure at a radius r covered throughout obeys
//!
//! ```text
//! P(r, t₂) = E P(r, t₁) + (m/4) ∫ₐ₍ₜ₁₎^ₐ₍ₜ₂₎ δ₀′(s) (s² − r²) e^(−χ (t₂ − τ(s))) ds,    E = e^(−χ (t₂ − t₁))
//! ```
//!
//! with τ(s) the time at which the contact radius is s; a radius covered only later starts at s = r. Every
//! term is positive. Writing s² − r² = (s² − c²) + (c² − r²) leaves two integrals that do not depend on r.
//!
//! Source: I. Argatov, Mech. Res. Commun. 38 (2011), Eqs. (25), (28), doi 10.1016/j.mechrescom.2010.11.006,
//! integrated by parts.
//!
//! | module | what it does |
//! |---|---|
//! | `stage`, `transition`, `increment` | a time with its radius; how pressures change from one to another; what a stretch adds to them |
//! | `march` | goes from one time to another, knot by knot; `march::steps`: where the load is not straight |
//! | `batch`, `radii_below` | many short straight pieces of the load at once (`batch::rule`: which are short enough); their radii, where a profile has no quick way to many |
//! | `late` | radii that are reached late, one section of time after the other |
//! | `stretch` | one stretch without a knot: by `radius_form` (steps, and straight loads that do not fall) or `time_form` (most others) |
//! | `held` | the integral over the radius of a held load, in one panel |
//! | `nodes` | the nodes of an integral over the radius |
//! | `line`, `fading` | how long ago Y was smaller, along a straight load; what is left after some e-foldings |
//! | `degree` | a J′/J, by which errors of J are divided in a radius |
//!
//! Terms used throughout: an *edge* is a time with its contact radius, and a *stage* adds what follows from the load;
//! the *age* of a radius is the time since the edge passed it; a *fold* is one e-folding, a duration of 1/χ; a
//! *deficit* is the amount by which Y was smaller than at the end of a stretch, and the *surplus* of a stage the amount
//! by which Y exceeds that of its rounded radius; the *strip* is the ring between the rounded radius and the exact one;
//! the *reach* of a transition is the largest radius that it holds for.

mod batch;
mod degree;
mod fading;
mod held;
mod increment;
mod late;
mod line;
mod march;
mod nodes;
mod radii_below;
mod radius_form;
mod stage;
mod stretch;
mod time_form;
mod transition;

use increment::Increment;

pub(crate) use fading::{FEW_FOLDS, decay_gain, faded_folds};
pub(crate) use late::Late;
pub(crate) use line::Line;
pub(crate) use march::march;
pub(crate) use radius_form::share_that_counts;
use stage::surplus_that_counts;
pub(crate) use stage::{Edge, Stage};
pub(crate) use transition::{Transition, not_negative};
