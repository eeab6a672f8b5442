//! The stress campaign on demand: `cargo run --release -p tests --bin stress -- --cases 1000000`.

use std::io::{IsTerminal, Write, stderr};
use std::process::ExitCode;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use ::tests::stress::campaign::{Campaign, Report};
use clap::{Parser, value_parser};

/// Cases that a worker takes at a time.
const BATCH: u64 = 32;
/// How many cases the estimate of the whole time takes; a multiple of the cycles of regions and formats.
const FIRST: u64 = 2080;
/// How much longer than estimated a campaign may take; the time that it announces includes this factor.
const MARGIN: f64 = 1.3;

/// How many cases are computed by default.
const CASES: u64 = 100_000;

/// Computes random scenes and compares them with what they must be.
#[derive(Debug, Parser)]
struct Request {
    /// How many random scenes to compute, 100000 unless told
    #[arg(long, value_name = "N", value_parser = value_parser!(u64).range(1..), group = "extent")]
    cases: Option<u64>,
    /// Compute as many as take so many seconds
    #[arg(long, value_name = "S", value_parser = value_parser!(u64).range(1..), group = "extent")]
    seconds: Option<u64>,
    /// One scene of a report again: its numbers, and everything about it
    #[arg(long, value_name = "CASE", group = "extent")]
    only: Option<u64>,
    /// Which scenes
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
}

fn main() -> ExitCode {
    let request = Request::parse();
    let report = request.run();
    println!("{report}");
    if report.holds() {
        println!("all within the bounds");
        ExitCode::SUCCESS
    } else if report.is_within_bounds() {
        println!("NOTHING was examined: there is no contact to any of these scenes");
        ExitCode::FAILURE
    } else {
        println!("NOT within the bounds; `--seed {} --only CASE` shows a case again", request.seed);
        ExitCode::FAILURE
    }
}

impl Request {
    fn run(&self) -> Report {
        let campaign = Campaign { seed: self.seed };
        if let Some(case) = self.only {
            println!("{}\nfingerprint {:#010x}", campaign.shown(case), campaign.fingerprint(case));
            let mut report = campaign.report();
            with_panics_in_the_report(|| campaign.run_closely(case, &mut report));
            return report;
        }
        let start = Instant::now();
        let announced = self.seconds.map(Duration::from_secs);
        let cases = self.cases.unwrap_or(if announced.is_some() { u64::MAX } else { CASES });
        let first = cases.min(FIRST);
        // A time beyond the range of the clock is no deadline.
        let deadline = |limit| start.checked_add(limit);
        let run = |cases, deadline| with_panics_in_the_report(|| run_all(&campaign, cases, deadline));
        let mut report = run(0..first, announced.and_then(deadline));
        let per_case = start.elapsed().as_secs_f64() / first as f64;
        let estimate = || Duration::try_from_secs_f64((per_case * cases as f64 * MARGIN).ceil());
        let limit = announced.unwrap_or_else(|| estimate().unwrap_or(Duration::MAX));
        if cases > first {
            eprintln!("at most {}", shown(limit));
            report.merge(run(first..cases, deadline(limit)));
        }
        if report.cases < cases && announced.is_none() {
            println!("stopped at the announced time, after {} of {cases} cases", report.cases);
        }
        report
    }
}

/// Does work whose panics are findings, without printing them.
fn with_panics_in_the_report<R>(work: impl FnOnce() -> R) -> R {
    let usual = std::panic::take_hook();
    std::panic::set_hook(Box::new(|_| {}));
    let result = work();
    std::panic::set_hook(usual);
    result
}

/// Examines the cases on all cores, as many as can be started before the deadline.
fn run_all(campaign: &Campaign, cases: core::ops::Range<u64>, deadline: Option<Instant>) -> Report {
    let next = AtomicU64::new(cases.start);
    let begun = Instant::now();
    let is_over = || deadline.is_some_and(|deadline| Instant::now() >= deadline);
    let work = || {
        let mut report = campaign.report();
        while !is_over() {
            let from = next.fetch_add(BATCH, Ordering::Relaxed);
            if from >= cases.end {
                break;
            }
            for case in from..(from + BATCH).min(cases.end) {
                campaign.run(case, &mut report);
            }
        }
        report
    };
    let count = thread::available_parallelism().map_or(1, core::num::NonZero::get);
    thread::scope(|scope| {
        let workers: Vec<_> = (0..count).map(|_| scope.spawn(work)).collect();
        while stderr().is_terminal() && workers.iter().any(|worker| !worker.is_finished()) {
            let done = next.load(Ordering::Relaxed).min(cases.end) - cases.start;
            show_progress(done, cases.end - cases.start, begun, deadline);
            thread::sleep(Duration::from_millis(200));
        }
        if stderr().is_terminal() {
            eprint!("\r{:79}\r", "");
        }
        let mut report = campaign.report();
        for worker in workers {
            // A worker cannot panic: panics of scenes are caught.
            if let Ok(found) = worker.join() {
                report.merge(found);
            }
        }
        report
    })
}

/// One line of at most 79 columns: a bar, how many cases are done, and the time left.
fn show_progress(done: u64, count: u64, begun: Instant, deadline: Option<Instant>) {
    let elapsed = begun.elapsed();
    let by_count = done as f64 / count as f64;
    let limit = deadline.map(|deadline| deadline.saturating_duration_since(begun));
    let by_time = limit.map_or(0.0, |limit| elapsed.as_secs_f64() / limit.as_secs_f64().max(1e-9));
    // A campaign with a time limit has no last case.
    let share = if count > u64::MAX / 2 { by_time } else { by_count }.min(1.0);
    let left = elapsed.as_secs_f64() * (1.0 - share) / share.max(1e-3);
    let left = limit.map_or(left, |limit| left.min(limit.saturating_sub(elapsed).as_secs_f64()));
    let full = (share * 40.0) as usize;
    let bar = format!("{}{}", "█".repeat(full), "░".repeat(40 - full));
    eprint!(
        "\r{bar} {:3.0} %  {done} cases, {} left   ",
        share * 100.0,
        shown(Duration::from_secs_f64(left))
    );
    // A closed terminal is no reason to stop.
    let _ = stderr().flush();
}

/// A duration in seconds, minutes or hours.
fn shown(duration: Duration) -> String {
    match duration.as_secs() {
        seconds @ 0..=99 => format!("{seconds} s"),
        seconds @ 100..=5999 => format!("{} min", seconds.div_ceil(60)),
        seconds => format!("{:.1} h", seconds as f64 / 3600.0),
    }
}

#[cfg(test)]
mod tests {
    use clap::error::ErrorKind;

    use super::*;

    #[test]
    fn one_kind_of_campaign_is_asked_for() {
        let read = |line: &str| Request::try_parse_from(format!("stress {line}").split(' '));
        for both in ["--cases 70 --seconds 1", "--seconds 1 --cases 70", "--only 3 --cases 70"] {
            assert!(read(both).is_err_and(|error| error.kind() == ErrorKind::ArgumentConflict), "{both}");
        }
        assert!(
            read("--cases 70 --seed 2").is_ok_and(|request| request.cases == Some(70) && request.seed == 2)
        );
    }

    #[test]
    fn no_time_is_too_long() {
        let request = Request { seed: 1, cases: Some(8), seconds: Some(u64::MAX), only: None };
        assert_eq!(request.run().cases, 8);
    }
}
