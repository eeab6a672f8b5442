//! A contact to compute: the whole input of the library.

use super::precision::Precision;
use super::wide::Wide;
use crate::profiles::cases;

/// Which solver holds the geometry.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Form {
    /// `Polynomial`.
    Polynomial,
    /// The generated solver of a constant geometry, by its index in [`crate::profiles::cases`].
    Constant(usize),
    /// The generated solver of a geometry whose coefficients are fields, by its index in [`super::fields`].
    Fields(usize),
}

/// A geometry, a medium, a load, a time and a place.
#[derive(Clone, Debug)]
pub struct Scene<T> {
    /// Which solver holds the geometry.
    pub(super) form: Form,
    /// The terms (C, n) of the gap.
    pub(super) terms: Vec<(T, T)>,
    /// The declared end of the range, if there is one.
    pub(super) max_radius: Option<T>,
    /// The stiffness.
    pub(super) m: T,
    /// The rate of drainage.
    pub(super) chi: T,
    /// The knots (time, force) of the load.
    pub(super) knots: Vec<(T, T)>,
    /// The time.
    pub(super) time: T,
    /// Where the pressure is taken: 1 − r/a.
    pub(super) inset: f64,
}

impl Scene<f64> {
    /// The scene in another format; loads that would recede there because of rounding are held instead.
    pub(super) fn rounded<T: Precision>(&self) -> Scene<T> {
        let pairs =
            |pairs: &[(f64, f64)]| pairs.iter().map(|&(x, y)| (T::constant(x), T::constant(y))).collect();
        let mut scene = Scene {
            form: self.form,
            terms: pairs(&self.terms),
            max_radius: self.max_radius.map(T::constant),
            m: T::constant(self.m),
            chi: T::constant(self.chi),
            knots: pairs(&self.knots),
            time: T::constant(self.time),
            inset: self.inset,
        };
        scene.hold_where_it_recedes();
        scene
    }
}

impl<T: Precision> Scene<T> {
    /// Replaces a force at which the hereditary load would fall, or nearly fall, by the force before it.
    fn hold_where_it_recedes(&mut self) {
        let chi = self.chi;
        for last in 1..self.knots.len() {
            let ((start, before), (end, after)) = (self.knots[last - 1], self.knots[last]);
            if after < before && !may_fall(chi, (start, before), (end, after)) {
                self.knots[last].1 = before;
            }
        }
    }

    /// The terms with the coefficients as meant: decimals for geometries that the compiler reads.
    pub(super) fn exact_terms(&self) -> Vec<(Wide, f64)> {
        match self.form {
            Form::Constant(index) => cases()[index].exact_terms(),
            _ => self.terms.iter().map(|&(c, n)| (Wide::of(c.value()), n.value())).collect(),
        }
    }

    /// Every number that has a unit.
    pub(super) fn numbers(&self) -> impl Iterator<Item = T> {
        let coefficients = self.terms.iter().map(|&(c, _)| c);
        let knots = self.knots.iter().flat_map(|&(t, force)| [t, force]);
        coefficients.chain(knots).chain([self.m, self.chi, self.time])
    }

    /// A digest that tells the scene from others, of its form and of seven digits of every number: all machines agree
    /// in these, although they do not round powers of ten alike.
    pub(super) fn fingerprint(&self) -> u32 {
        let exponents = self.terms.iter().map(|&(_, n)| n);
        let numbers = self.numbers().chain(exponents).chain(self.max_radius).map(T::value);
        let text: String = numbers.chain([self.inset]).map(|x| format!("{x:.6e} ")).collect();
        // FNV-1a, which no release of the compiler changes.
        format!("{:?} {text}", self.form)
            .bytes()
            .fold(0x811c_9dc5, |digest, byte| (digest ^ u32::from(byte)).wrapping_mul(0x0100_0193))
    }

    /// The scene with lengths, forces and times multiplied by powers of two; none if its exponents do not allow it.
    pub(super) fn in_units(&self, length: i32, force: i32, time: i32) -> Option<Self> {
        let coefficient = |(c, n): (T, T)| {
            let power = f64::from(length) * (1.0 - n.value());
            let exact = power == power.trunc() && power.abs() < 100.0;
            (exact || length == 0).then(|| (c * T::power_of_two(power as i32), n))
        };
        let terms: Option<Vec<_>> = self.terms.iter().copied().map(coefficient).collect();
        let (length, force, time) = (T::power_of_two(length), T::power_of_two(force), T::power_of_two(time));
        let square = length * length;
        Some(Self {
            form: self.form,
            terms: terms?,
            max_radius: self.max_radius.map(|end| end * length),
            m: self.m * force / (square * square * length),
            chi: self.chi / time,
            knots: self.knots.iter().map(|&(t, f)| (t * time, f * force)).collect(),
            time: self.time * time,
            inset: self.inset,
        })
    }
}

/// Whether F′ + χ F stays positive on a falling piece by more than its rounding.
fn may_fall<T: Precision>(chi: T, (start, before): (T, T), (end, after): (T, T)) -> bool {
    let [chi, start, before, end, after] = [chi, start, before, end, after].map(|x| Wide::of(x.value()));
    let fall = before - after;
    let held = chi * (end - start) * after;
    fall.is_below(held * Wide::of(1.0 - 16.0 * T::EPSILON))
}
