//! Loads of many steps, held in between or falling as fast as they may, as records of a sampled or staged load are:
//! pressures against the oracle, however the load hands out its pieces.

use cartcontact::ContactError;
use cartcontact::load::{Load, Piece};
use tests::budget;
use tests::condition::edge;
use tests::joint::joint;
use tests::loads::{Announced, Knots, through};
use tests::measure::{Errors, relative_error};
use tests::oracle::Oracle;
use tests::profiles::{Patellofemoral, case};
use tests::random::Stream;

const CHI: f64 = 0.0015;

/// Zero and the times of `count` steps, some `folds` apart.
fn times(stream: &mut Stream, count: usize, folds: f64) -> Vec<f64> {
    let durations = (0..count).map(|_| stream.between(0.2, 1.8) * folds / CHI);
    let ends = durations.scan(0.0, |time, duration| {
        *time += duration;
        Some(*time)
    });
    core::iter::once(0.0).chain(ends).collect()
}

/// Steps of random heights, up to a share of the force; between them the force keeps the share `kept` of what it may
/// lose in that time.
fn steps(stream: &mut Stream, (count, folds): (usize, f64), height: f64, kept: f64) -> Vec<(f64, f64)> {
    let mut force = 60.0;
    let mut knots = vec![(0.0, force)];
    let times = times(stream, count, folds);
    for ends in times.windows(2) {
        let bound = 1.0 / (1.0 + CHI * (ends[1] - ends[0]));
        force *= bound + kept * (1.0 - bound);
        knots.push((ends[1], force));
        // Now and then none at all.
        force *= 1.0 + height * stream.between(-0.2, 1.0).max(0.0);
        knots.push((ends[1], force));
    }
    knots
}

/// When the last step of a load is.
fn end(load: &Knots) -> f64 {
    load.knots().last().map_or(0.0, |&(time, _)| time)
}

/// Staircases and saw teeth with short and long treads, low and high steps.
fn loads(count: usize) -> Vec<Knots> {
    let mut loads = Vec::new();
    for (case, kept) in [(0, 1.0), (1, 0.5), (2, 1e-9)] {
        for (folds, height) in [(1e-9, 0.02), (0.01, 0.05), (0.1, 0.3), (1.0, 2.0)] {
            let mut stream = Stream::of_case(7, case);
            loads.push(through(&steps(&mut stream, (count, folds), height, kept)));
        }
    }
    loads
}

#[test]
fn pressures_after_many_steps_are_exact() -> Result<(), ContactError> {
    let mut errors = Errors::of(budget::PRESSURE);
    for load in loads(9) {
        let contact = joint(Patellofemoral, CHI, &load);
        let oracle = Oracle::new(case("Patellofemoral").oracle(), 0.375, CHI, load.knots());
        for t in [0.99, 1.07].map(|share| share * end(&load)) {
            let now = contact.at(t)?;
            let radii = [0.0, 0.5, 0.99].map(|share| share * now.radius());
            for (r, expected) in radii.into_iter().zip(oracle.pressures(radii, t)) {
                errors.add(now.pressure(r), &expected, edge(now.radius(), r), &(r, t, &load));
            }
        }
    }
    errors.check();
    Ok(())
}

/// A load that hands out its pieces in a way of its own.
struct Handing<'a> {
    load: &'a Knots,
    gives_steps: bool,
    /// The most pieces at a time; with none, the solver has to look for knots.
    most: usize,
}

impl Load<f64> for Handing<'_> {
    fn force(&self, t: f64) -> f64 {
        self.load.force(t)
    }

    fn impulse(&self, t: f64) -> f64 {
        self.load.impulse(t)
    }

    fn force_before(&self, t: f64) -> f64 {
        self.load.force_before(t)
    }

    fn next_knot(&self, t: f64) -> Option<f64> {
        self.load.next_knot(t)
    }

    fn is_linear_between_knots(&self) -> bool {
        true
    }

    fn straight_pieces(&self, times: (f64, f64), pieces: &mut [Piece<f64>]) -> usize {
        let room = self.most.min(pieces.len());
        let count = self.load.straight_pieces(times, &mut pieces[..room]);
        if self.gives_steps {
            return count;
        }
        let mut kept = 0;
        for place in 0..count {
            if pieces[place].start.0 < pieces[place].end.0 {
                pieces[kept] = pieces[place];
                kept += 1;
            }
        }
        kept
    }
}

#[test]
fn steps_may_be_given_or_left_out() -> Result<(), ContactError> {
    for load in loads(40) {
        let contact = joint(Patellofemoral, CHI, &load);
        let announced = joint(Patellofemoral, CHI, Announced { load: &load, is_linear: true });
        let handing = [(false, 0), (false, 1), (true, 2), (false, 5), (true, 5), (false, 99), (true, 99)];
        let handing = handing.map(|(gives_steps, most)| {
            joint(Patellofemoral, CHI, Handing { load: &load, gives_steps, most })
        });
        for t in [0.3, 1.0, 1.07].map(|share| share * end(&load)) {
            let (now, announced) = (contact.at(t)?, announced.at(t)?);
            for share in [0.0, 0.5, 0.99] {
                let r = share * now.radius();
                let allowed = 2.0 * budget::PRESSURE.double * edge(1.0, share);
                let check = |found, what: &str| {
                    let error = relative_error(found, now.pressure(r), f64::EPSILON);
                    assert!(error <= allowed, "{what}, {r}, {t}: {error} ε of {}; {load:?}", now.pressure(r));
                };
                check(announced.pressure(r), "by the provided method");
                for contact in &handing {
                    let Handing { gives_steps, most, .. } = contact.load();
                    check(
                        contact.at(t)?.pressure(r),
                        &format!("{most} at a time, with steps: {gives_steps}"),
                    );
                }
            }
        }
    }
    Ok(())
}
