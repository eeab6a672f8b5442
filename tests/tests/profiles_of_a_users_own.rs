//! A geometry of a user's own, which has only the methods that it must have: the solver knows neither its highest power
//! nor its signs, and takes drops of the load integral by a quadrature.

use cartcontact::load::Load;
use cartcontact::{ContactError, GapProfile, RadiusError};
use tests::budget;
use tests::condition::edge;
use tests::loads::{Rise, histories};
use tests::measure::Errors;
use tests::planted;
use tests::profiles::cases;

const CHI: f64 = 0.02;

struct Own<'a>(&'a dyn GapProfile<f64>);

impl GapProfile<f64> for Own<'_> {
    fn gap(&self, r: f64) -> f64 {
        self.0.gap(r)
    }

    fn approach(&self, a: f64) -> f64 {
        self.0.approach(a)
    }

    fn approach_slope(&self, a: f64) -> f64 {
        self.0.approach_slope(a)
    }

    fn load_integral(&self, a: f64) -> f64 {
        self.0.load_integral(a)
    }

    fn log_kernel(&self, x: f64) -> f64 {
        self.0.log_kernel(x)
    }

    fn pressure_kernel(&self, a: f64, r: f64) -> f64 {
        self.0.pressure_kernel(a, r)
    }

    fn radius_within(&self, load_integral: f64, limit: f64) -> Result<f64, RadiusError> {
        self.0.radius_within(load_integral, limit)
    }

    fn max_radius(&self) -> f64 {
        self.0.max_radius()
    }
}

#[test]
fn pressures_are_those_of_a_generated_solver() -> Result<(), ContactError> {
    // Either is off by the error of a pressure.
    let mut errors = Errors::of(budget::FIELD);
    let rise = Rise { start: 10.0, rise: 90.0, rate: 0.5 * CHI };
    let histories = histories(CHI);
    let loads = histories.iter().map(|(name, load)| (*name, load as &dyn Load<f64>));
    for (name, load) in loads.chain([("rise", &rise as &dyn Load<f64>)]) {
        for case in cases() {
            for t in [0.05, 0.7, 3.0, 30.0].map(|folds| folds / CHI) {
                let generated = planted::contact(case.double, load, CHI, 5.0, t)?;
                let own = planted::contact(Own(case.double), load, CHI, 5.0, t)?;
                let (expected, found) = (generated.at(t)?, own.at(t)?);
                assert_eq!(found.radius(), expected.radius(), "{case:?}, {name}, {t}");
                for share in [0.0, 0.5, 0.9, 0.99] {
                    let r = share * expected.radius();
                    let edge = edge(expected.radius(), r);
                    errors.add(found.pressure(r), expected.pressure(r), edge, &(case, name, t, share));
                }
            }
        }
    }
    errors.check();
    Ok(())
}
