//! Many scenes, and the worst of what was found in them.

use std::panic::{AssertUnwindSafe, catch_unwind};

use super::examine::{Depth, examine};
use super::finding::{Fault, Findings, Quantity};
use super::precision::Precision;
use super::region::Region;
use super::scene::Scene;
use crate::random::Stream;

/// Every how many cases memory and balance are looked at as well.
const DEEP: u64 = 97;

/// A seed, and how often scenes are looked at closely.
#[derive(Clone, Copy, Debug)]
pub struct Campaign {
    /// Determines every scene.
    pub seed: u64,
}

/// The worst of one kind in one corner.
#[derive(Clone, Copy, Debug, Default)]
pub struct Worst {
    /// As a share of what is allowed.
    pub share: f64,
    /// In which case.
    pub case: u64,
    /// How many were measured.
    pub count: u64,
}

/// Faults of one kind in one corner.
#[derive(Clone, Debug, Default)]
pub struct Faults {
    /// How many.
    pub count: u64,
    /// The first: its case, and what it is about.
    pub first: Option<(u64, String)>,
}

/// What was found in one format.
#[derive(Clone, Debug)]
pub struct Ledger {
    /// The name of the format.
    pub format: &'static str,
    /// By region and quantity.
    pub errors: [[Worst; Quantity::ALL.len()]; Region::ALL.len()],
    /// By region and fault.
    pub faults: [[Faults; Fault::ALL.len()]; Region::ALL.len()],
}

/// What was found in all of them.
#[derive(Clone, Debug)]
pub struct Report {
    /// The ledgers of f64 and f32.
    pub ledgers: [Ledger; 2],
    /// How many cases were examined.
    pub cases: u64,
    /// The seed they were drawn from.
    pub seed: u64,
}

impl Campaign {
    /// An empty report.
    #[must_use]
    pub fn report(&self) -> Report {
        let ledger = |format| Ledger { format, errors: Default::default(), faults: Default::default() };
        Report { ledgers: [ledger(f64::NAME), ledger(f32::NAME)], cases: 0, seed: self.seed }
    }

    /// Examines one case: three in f64, the fourth in f32, through all regions in turn.
    pub fn run(&self, case: u64, report: &mut Report) {
        if case % 4 == 3 { self.run_in::<f32>(case, &mut report.ledgers[1]) } else { self.run_in::<f64>(case, &mut report.ledgers[0]) }
        report.cases += 1;
    }

    /// The region of a case, and its scene.
    #[must_use]
    pub fn scene<T: Precision>(&self, case: u64) -> (usize, Scene<T>) {
        let mut stream = Stream::of_case(self.seed, case);
        let region = (case % Region::ALL.len() as u64) as usize;
        (region, Region::ALL[region].draw::<T>(&mut stream).rounded())
    }

    fn run_in<T: Precision>(&self, case: u64, ledger: &mut Ledger) {
        let (region, scene) = self.scene::<T>(case);
        let is_deep = case % DEEP == 0;
        let depth = Depth { memory: is_deep, balance: is_deep };
        let mut entry = Entry { ledger, region, case };
        // A panic must end neither the campaign nor what was found before it.
        if catch_unwind(AssertUnwindSafe(|| examine(&scene, depth, &mut entry))).is_err() {
            entry.fault(Fault::Panic, &"");
        }
    }
}

/// The place of one case in the ledger.
struct Entry<'a> {
    ledger: &'a mut Ledger,
    region: usize,
    case: u64,
}

impl Findings for Entry<'_> {
    fn error(&mut self, quantity: Quantity, share: f64) {
        let worst = &mut self.ledger.errors[self.region][quantity as usize];
        worst.count += 1;
        if share > worst.share {
            (worst.share, worst.case) = (share, self.case);
        }
    }

    fn fault(&mut self, fault: Fault, about: &dyn core::fmt::Display) {
        let faults = &mut self.ledger.faults[self.region][fault as usize];
        faults.count += 1;
        faults.first.get_or_insert_with(|| (self.case, about.to_string()));
    }
}

impl Report {
    /// Whether every error is within its bound and nothing is at fault.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.ledgers.iter().all(|ledger| {
            let worst = ledger.errors.iter().flatten().all(|worst| worst.share <= 1.0);
            worst && ledger.faults.iter().flatten().all(|faults| faults.count == 0)
        })
    }
}
