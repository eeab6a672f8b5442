//! The contact at one time.

use core::fmt;

use crate::Scalar;
use crate::contact::Contact;
use crate::dispatch::wide;
use crate::load::Load;
use crate::memory::{Edge, Late, Stage, faded_folds, march, not_negative};
use crate::profile::GapProfile;
use crate::scalar::{has_no_derivatives, is_plain_zero};

/// The state of a [`Contact`] at one time: its radius, and on demand what follows from it.
///
/// # Examples
///
/// ```
/// use cartcontact::{Contact, Medium, Polynomial, load};
///
/// let medium = Medium::from_constants(0.375, 0.0015)?;
/// let contact = Contact::new(Polynomial::new([(0.025, 2.0)])?, medium, load::Constant(100.0))?;
/// let now = contact.at(0.0)?;
/// let a = now.radius();
/// assert_eq!((now.time(), now.force()), (0.0, 100.0));
/// // For a paraboloid C r² before anything has drained: δ₀ = C a²/2 and P = (m C/16) (a² − r²)².
/// assert!((now.approach() - 0.025 * a * a / 2.0_f64).abs() < 1e-15);
/// assert!((now.pressure(3.0) - 0.375 * 0.025 / 16.0 * (a * a - 9.0_f64).powi(2)).abs() < 1e-14);
/// assert_eq!((now.peak_pressure(), now.pressure(a)), (now.pressure(0.0), 0.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Snapshot<'a, T, P, L> {
    contact: &'a Contact<T, P, L>,
    edge: Edge<T>,
}

impl<'a, T: Scalar, P: GapProfile<T>, L: Load<T>> Snapshot<'a, T, P, L> {
    pub(crate) fn new(contact: &'a Contact<T, P, L>, edge: Edge<T>) -> Self {
        Self { contact, edge }
    }

    /// The time t, in s.
    pub fn time(&self) -> T {
        self.edge.time
    }

    /// The contact radius a(t), in mm.
    ///
    /// # References
    ///
    /// Eq. (14), doi 10.1016/j.mechrescom.2010.11.006.
    pub fn radius(&self) -> T {
        self.edge.radius
    }

    /// The approach δ₀(t) of the bones, in mm.
    ///
    /// It is that for the exact contact radius, not for the rounded one, so that high powers do not magnify the
    /// rounding.
    ///
    /// # Formula
    ///
    /// ```text
    /// δ₀(t) = Σ 2 C a(t)ⁿ / (n+2)
    /// ```
    ///
    /// over the terms C rⁿ of the gap.
    ///
    /// # Accuracy
    ///
    /// Within 3/2 + a δ₀′/δ₀ units in the last place, times the condition number of J where terms of both signs cancel:
    /// of one term rⁿ, within 3/2 + n.
    ///
    /// # Examples
    ///
    /// ```
    /// # use cartcontact::{Contact, Medium, Polynomial, load};
    /// let medium = Medium::from_constants(0.375, 0.0015)?;
    /// let contact = Contact::new(Polynomial::new([(0.025, 2.0)])?, medium, load::Constant(100.0))?;
    /// let now = contact.at(200.0)?;
    /// // That of a paraboloid C r² is C a²/2.
    /// let (a, approach): (f64, f64) = (now.radius(), now.approach());
    /// assert!((approach - 0.025 * a * a / 2.0).abs() < 1e-15);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # References
    ///
    /// Eq. (10), doi 10.1016/j.mechrescom.2010.11.006.
    pub fn approach(&self) -> T {
        self.contact.approach(self.contact.loading(self.edge.time), self.edge)
    }

    /// The load F(t), in N; it equals 2π ∫₀ᵃ P r dr.
    pub fn force(&self) -> T {
        self.contact.load().force(self.edge.time)
    }

    /// The contact pressure P(r, t) at the distance |r| from the axis, in MPa; zero outside the contact.
    ///
    /// It is the normal traction between the surfaces, of fluid and solid together; in the fluid alone the pressure is
    /// lower by a share of the order of (h/a)². If `r` is not a number, neither is the result.
    /// [`Contact::pressure_field`] checks its radii instead.
    ///
    /// # Formula
    ///
    /// ```text
    /// P(r, t) = m G(a₀, r) e^(−χ t) + (m/4) ∫ δ₀′(s) (s² − r²) e^(−χ (t − τ(s))) ds
    /// ```
    ///
    /// over s from max(r, a₀) to a(t), where τ(s) is the time at which the contact radius is s and a₀ = a(0).
    ///
    /// # Accuracy
    ///
    /// Within 8 units in the last place times 1 + 2a/(a − r), which is how far rounding the radius alone moves the
    /// result. Where terms of both signs cancel, that is multiplied by the largest Σ|terms of J|/(a J′) of the radii so
    /// far and, once the load has fallen, by Y/F as well. Digits are lost where P/m is less than 2 (n+2)² times the
    /// smallest normal number, with the highest exponent n.
    ///
    /// # Examples
    ///
    /// ```
    /// # use cartcontact::{Contact, Medium, Polynomial, load};
    /// let medium = Medium::from_constants(0.375, 0.0015)?;
    /// let contact = Contact::new(Polynomial::new([(0.025, 2.0)])?, medium, load::Constant(100.0))?;
    /// let now = contact.at(200.0)?;
    /// assert!(now.pressure(0.0) > now.pressure(3.0) && now.pressure(3.0) > 0.0);
    /// assert_eq!((now.pressure(-3.0), now.pressure(now.radius())), (now.pressure(3.0), 0.0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # References
    ///
    /// Eq. (28), doi 10.1016/j.mechrescom.2010.11.006.
    pub fn pressure(&self, r: T) -> T {
        let r = r.abs();
        if r >= self.edge.radius {
            return T::zero();
        }
        if self.is_undrained() {
            // e^(−χ t): a zero may carry a derivative.
            let decay = T::one() - self.folds();
            return self.undrained_pressure(self.contact.stage(self.edge), r) * decay;
        }
        let start = self.first_stage();
        let change = march(self.contact, start, self.edge, r);
        change.apply(self.initial_pressure(start, r), r)
    }

    /// The pressure P(0, t) on the axis, the largest one, in MPa. It is within 8 units in the last place, a third of
    /// the bound of [`pressure`](Self::pressure) at r = 0; where terms of both signs cancel, with the same factors.
    ///
    /// In single precision it is within 16 units under a user-defined load that falls for more than twenty e-foldings,
    /// step by step, because the decay over each step is rounded.
    ///
    /// # Examples
    ///
    /// ```
    /// # use cartcontact::{Contact, Medium, Polynomial, load};
    /// let medium = Medium::from_constants(0.375, 0.0015)?;
    /// let contact = Contact::new(Polynomial::new([(0.025, 2.0)])?, medium, load::Constant(100.0))?;
    /// let [first, last] = [contact.at(0.0)?, contact.at(200.0)?];
    /// // The contact spreads, and the same force is carried by a wider disc.
    /// assert!(first.peak_pressure() > last.peak_pressure());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # References
    ///
    /// Eq. (28) at r = 0, doi 10.1016/j.mechrescom.2010.11.006.
    pub fn peak_pressure(&self) -> T {
        self.pressure(T::zero())
    }

    /// The time and the contact radius.
    pub(crate) fn edge(&self) -> Edge<T> {
        self.edge
    }

    /// χ t.
    #[inline(always)]
    fn folds(&self) -> T {
        self.contact.medium().chi() * self.edge.time
    }

    /// Whether nothing has drained, and no history has to be followed. What drains by the time 0, or at a rate of zero, may
    /// have derivatives; steps along a load that is not straight need a rate.
    #[inline(always)]
    fn is_undrained(&self) -> bool {
        let needs_rate = || !self.edge.time.is_zero() && !self.contact.load().is_linear_between_knots();
        self.folds().is_zero() && (has_no_derivatives::<T>() || needs_rate())
    }

    /// The pressures at many radii, finite and not negative, with one memory integral for all radii that were
    /// covered from the start.
    pub(crate) fn pressures(&self, radii: &[T], pressures: &mut [T]) {
        let is_undrained = self.is_undrained();
        if is_undrained && !has_no_derivatives::<T>() {
            // Nothing drains that could carry derivatives.
            pressures.iter_mut().zip(radii).for_each(|(pressure, &r)| *pressure = self.pressure(r));
            return;
        }
        let start = if is_undrained { self.contact.stage(self.edge) } else { self.first_stage() };
        let from_start = march(self.contact, start, self.edge, start.radius);
        // A loop without branches; its values beyond the radius at the start mean nothing and are replaced by the next
        // loop.
        let (profile, m) = (self.contact.profile(), self.contact.medium().m());
        let is_whole_history = is_undrained || start.time.is_zero();
        let (a, strip) = (start.radius, start.strip(self.contact.integral_per_load()));
        let initial = &mut *pressures;
        wide(
            #[inline(always)]
            move || {
                for (pressure, &r) in initial.iter_mut().zip(radii) {
                    let initial = if is_whole_history {
                        m * kernel_with_strip(profile, (a, strip), r)
                    } else {
                        T::zero()
                    };
                    *pressure = from_start.apply(initial, r);
                }
            },
        );
        let is_late = |r: T| start.radius < r && r < self.edge.radius;
        let count = radii.iter().filter(|&&r| is_late(r)).count();
        let mut late = Late::between(self.contact, start, self.edge, count);
        for (pressure, &r) in pressures.iter_mut().zip(radii) {
            if is_late(r) {
                *pressure = late.pressure(r);
            } else if r >= self.edge.radius {
                *pressure = T::zero();
            }
        }
    }

    /// The pressure at the start of the memory that still counts.
    fn initial_pressure(&self, start: Stage<T>, r: T) -> T {
        if start.time.is_zero() && r < start.radius { self.undrained_pressure(start, r) } else { T::zero() }
    }

    /// m G(a, r), the pressure before anything has drained.
    fn undrained_pressure(&self, stage: Stage<T>, r: T) -> T {
        if is_plain_zero(r) {
            return self.undrained_peak(stage);
        }
        let strip = stage.strip(self.contact.integral_per_load());
        let kernel = kernel_with_strip(self.contact.profile(), (stage.radius, strip), r);
        not_negative(self.contact.medium().m() * kernel)
    }

    /// m G(a, 0) as (2 Y/π + m S(a))/a², where 2 Y/π is m J/2 of the exact radius. There the derivative by a is zero: of
    /// a rounded radius this is the pressure of the exact one, and S has the share 2/(n+4) in it.
    fn undrained_peak(&self, Stage { time, radius: a, impulse, .. }: Stage<T>) -> T {
        let loading = self.contact.loading_of_impulse(time, impulse.value);
        let twice_mean = T::constant(core::f64::consts::FRAC_2_PI) * loading.hereditary;
        let excess = self.contact.medium().m() * self.contact.profile().excess_on_axis(a);
        (twice_mean + excess) / (a * a)
    }

    /// The time before which the history no longer counts: 0, or where it has faded below rounding.
    ///
    /// F e^(χ τ) never falls, so the pressures at τ now carry at most F(τ) e^(−χ (t−τ)) of F(t).
    pub(crate) fn start_of_memory(&self) -> T {
        let (load, chi) = (self.contact.load(), self.contact.medium().chi());
        let folds = faded_folds::<T>();
        let present = self.force();
        let mut past = folds;
        while past < chi * self.edge.time {
            // One rounding of the time more, so that no fewer e-foldings are left when the difference is rounded.
            let time = self.edge.time - (past / chi + self.edge.time * T::default_epsilon());
            if time <= T::zero() {
                break;
            }
            // False also where that is not a number, so that the search ends.
            let counts = load.force(time) * (folds - past).exp() > present;
            if !counts {
                return time;
            }
            past += folds;
        }
        T::zero()
    }

    /// The stage at which the memory starts; its radius is admissible because that of the snapshot is.
    fn first_stage(&self) -> Stage<T> {
        let time = self.start_of_memory();
        let loading = self.contact.loading(time);
        let radius = self.contact.radius_under_loading(loading).unwrap_or(T::zero());
        self.contact.stage_with_loading(loading, Edge { time, radius })
    }
}

// Not derived, because neither profile nor load need be `Copy`.
impl<T: Copy, P, L> Clone for Snapshot<'_, T, P, L> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T: Copy, P, L> Copy for Snapshot<'_, T, P, L> {}

impl<T: fmt::Debug, P, L> fmt::Debug for Snapshot<'_, T, P, L> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Snapshot")
            .field("time", &self.edge.time)
            .field("radius", &self.edge.radius)
            .finish_non_exhaustive()
    }
}

/// G of the exact contact radius at r: that of the rounded one, and what the [strip](Stage::strip) between them adds.
#[inline(always)]
fn kernel_with_strip<T: Scalar>(profile: &impl GapProfile<T>, (a, strip): (T, T), r: T) -> T {
    profile.quick_pressure_kernel(a, r) + strip * T::constant(0.25) * ((a - r) * (a + r))
}
