//! What a scene is checked for, and what the checks can find.

use crate::budget::{self, Allowance};

/// A quantity whose error is measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Φ(r).
    Gap,
    /// δ₀(a).
    Approach,
    /// δ₀′(a).
    ApproachSlope,
    /// J(a).
    LoadIntegral,
    /// L(r).
    LogKernel,
    /// G(a, r).
    PressureKernel,
    /// a(t).
    Radius,
    /// δ₀(t).
    ContactApproach,
    /// P(r, t).
    Pressure,
    /// P(0, t).
    PeakPressure,
    /// A field Pᵢⱼ against a snapshot.
    Field,
    /// 2π ∫ P r dr against F.
    Balance,
}

impl Quantity {
    /// All of them.
    pub const ALL: [Self; 12] = [
        Self::Gap,
        Self::Approach,
        Self::ApproachSlope,
        Self::LoadIntegral,
        Self::LogKernel,
        Self::PressureKernel,
        Self::Radius,
        Self::ContactApproach,
        Self::Pressure,
        Self::PeakPressure,
        Self::Field,
        Self::Balance,
    ];

    /// The error that is allowed for it.
    #[must_use]
    pub fn allowance(self) -> Allowance {
        match self {
            Self::Gap => budget::GAP,
            Self::Approach => budget::APPROACH,
            Self::ApproachSlope => budget::APPROACH_SLOPE,
            Self::LoadIntegral => budget::LOAD_INTEGRAL,
            Self::LogKernel => budget::LOG_KERNEL,
            Self::PressureKernel => budget::PRESSURE_KERNEL,
            Self::Radius => budget::CONTACT_RADIUS,
            Self::ContactApproach => budget::CONTACT_APPROACH,
            Self::Pressure => budget::PRESSURE,
            Self::PeakPressure => budget::PEAK_PRESSURE,
            Self::Field => budget::FIELD,
            Self::Balance => budget::BALANCE,
        }
    }

    /// Its symbol, at most four characters, so that a space is left in columns of five.
    #[must_use]
    pub fn symbol(self) -> &'static str {
        match self {
            Self::Gap => "Φ",
            Self::Approach => "δ₀",
            Self::ApproachSlope => "δ₀′",
            Self::LoadIntegral => "J",
            Self::LogKernel => "L",
            Self::PressureKernel => "G",
            Self::Radius => "a",
            Self::ContactApproach => "δ(t)",
            Self::Pressure => "P(r)",
            Self::PeakPressure => "P(0)",
            Self::Field => "Pᵢⱼ",
            Self::Balance => "∫P=F",
        }
    }
}

/// What must never happen, however large the allowed errors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault {
    /// A panic.
    Panic,
    /// A result that is not a number, or infinite where the exact one is not.
    NotANumber,
    /// A pressure below 0.
    NegativePressure,
    /// A pressure that grows with the distance from the axis.
    RisingPressure,
    /// An error although the contact has a radius that the format holds.
    Refused,
    /// A radius although the contact has none.
    Accepted,
    /// A result that depends on the units, although they differ by powers of two.
    NotInvariant,
}

impl Fault {
    /// All of them.
    pub const ALL: [Self; 7] = [
        Self::Panic,
        Self::NotANumber,
        Self::NegativePressure,
        Self::RisingPressure,
        Self::Refused,
        Self::Accepted,
        Self::NotInvariant,
    ];

    /// Its name in reports.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Panic => "panics",
            Self::NotANumber => "results that are not numbers",
            Self::NegativePressure => "negative pressures",
            Self::RisingPressure => "pressures that rise outwards",
            Self::Refused => "errors without a reason",
            Self::Accepted => "results where there is none",
            Self::NotInvariant => "results that depend on units",
        }
    }
}

/// What is counted, so that nothing passes just because it was not examined.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tally {
    /// Scenes whose results were compared with the exact ones.
    Solved,
    /// Scenes without a radius to compare, as there is no load or the time is refused; both are judged.
    Unsolved,
    /// Scenes without a contact: their geometry, medium or load is refused.
    Refused,
    /// Results compared with those in other units.
    Units,
}

impl Tally {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Solved, Self::Unsolved, Self::Refused, Self::Units];

    /// Its name in reports, at most ten characters.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Solved => "solved",
            Self::Unsolved => "unsolved",
            Self::Refused => "refused",
            Self::Units => "in units",
        }
    }
}

/// Where the findings of a scene go.
pub trait Findings {
    /// The outcome of the scene.
    fn count(&mut self, tally: Tally);

    /// An error, as a share of the allowed one.
    fn error(&mut self, quantity: Quantity, share: f64);

    /// A fault and its description.
    fn fault(&mut self, fault: Fault, about: &dyn core::fmt::Display);
}
