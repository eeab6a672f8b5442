//! The time that a result takes.

use std::hint::black_box;
use std::time::{Duration, Instant};

use crate::scenes::{SCENES, Scene};

/// How long a method is repeated.
const PATIENCE: Duration = Duration::from_millis(40);
/// The least duration of a repetition, many times that of reading the clock.
const SHORTEST: Duration = Duration::from_micros(20);

/// The time per result in ns, as a mean over the scenes.
///
/// It is the shortest of many repetitions, because other activity of the machine can only prolong them.
pub(crate) fn nanoseconds(solve: impl Fn(&Scene) -> f64) -> f64 {
    let repetition = |rounds: u32| {
        let start = Instant::now();
        for _ in 0..rounds {
            for scene in &SCENES {
                black_box(solve(black_box(scene)));
            }
        }
        start.elapsed()
    };
    let mut rounds = 1;
    while repetition(rounds) < SHORTEST {
        rounds *= 2;
    }
    let start = Instant::now();
    let mut shortest = Duration::MAX;
    while start.elapsed() < PATIENCE {
        shortest = shortest.min(repetition(rounds));
    }
    1e9 * shortest.as_secs_f64() / (f64::from(rounds) * SCENES.len() as f64)
}
