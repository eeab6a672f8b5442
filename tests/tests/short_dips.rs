//! A user-defined load may dip for a moment within a long history, where no sample may hit the dip.

use cartcontact::load::Load;
use cartcontact::{ContactError, Polynomial};
use tests::budget;
use tests::condition::edge;
use tests::joint::joint;
use tests::measure::Errors;

const CHI: f64 = 0.02;

/// 100 − D/cosh²((t − time)/width); its knots, if it reports any, are no kinks but lie where it varies.
struct Dip {
    depth: f64,
    time: f64,
    width: f64,
    has_knots: bool,
}

impl Load<f64> for Dip {
    fn force(&self, t: f64) -> f64 {
        100.0 - self.depth / ((t - self.time) / self.width).cosh().powi(2)
    }

    fn impulse(&self, t: f64) -> f64 {
        let lost = ((t - self.time) / self.width).tanh() + (self.time / self.width).tanh();
        100.0 * t - self.depth * self.width * lost
    }

    fn next_knot(&self, t: f64) -> Option<f64> {
        let knots = [-9.0, -3.0, -1.5, 0.0, 1.5, 3.0, 9.0].map(|place| self.time + place * self.width);
        knots.into_iter().find(|&knot| self.has_knots && knot > t)
    }
}

const SHARES: [f64; 3] = [0.0, 0.5, 0.9];

fn pressures(load: &Dip, t: f64) -> Result<[f64; 3], ContactError> {
    let contact = joint(Polynomial::new([(0.025, 2.0), (1e-4, 4.0)])?, CHI, load);
    let now = contact.at(t)?;
    Ok(SHARES.map(|share| now.pressure(share * now.radius())))
}

#[test]
fn a_short_dip_counts_whether_or_not_its_time_is_told() -> Result<(), ContactError> {
    let mut errors = Errors::of(budget::PRESSURE);
    for folds in [1.0, 20.0, 1000.0] {
        for age in [0.2, 1.0, 3.0_f64] {
            for width in [1.0, 0.1, 1e-2, 1e-3, 1e-4].map(|folds| folds / 6.0) {
                if folds < age + 6.0 * width {
                    continue;
                }
                // F′ is at most 0.77 D over the width; χ F is 2.
                let depth = 50.0 * width;
                let dip = |has_knots| Dip { depth, time: (folds - age) / CHI, width: width / CHI, has_knots };
                let (found, expected) =
                    (pressures(&dip(false), folds / CHI)?, pressures(&dip(true), folds / CHI)?);
                for ((share, found), expected) in SHARES.into_iter().zip(found).zip(expected) {
                    errors.add(found, expected, edge(1.0, share), &(folds, age, width, share));
                }
            }
        }
    }
    errors.check_worst();
    Ok(())
}
