//! Many scenes, and the worst findings in them.

use std::panic::{AssertUnwindSafe, catch_unwind};

use super::examine::{Depth, examine};
use super::finding::{Fault, Findings, Quantity, Tally};
use super::precision::Precision;
use super::region::Region;
use super::scene::Scene;
use crate::budget::Allowance;
use crate::random::Stream;

/// Every so many cases, memory and balance are examined as well.
const DEEP: u64 = 23;

/// The format in which a case is computed.
#[derive(Clone, Copy, Debug)]
pub enum Format {
    /// `f64`.
    Double,
    /// `f32`.
    Single,
}

impl Format {
    fn of(case: u64) -> Self {
        if case % 4 == 3 { Self::Single } else { Self::Double }
    }

    /// Its name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Double => "f64",
            Self::Single => "f32",
        }
    }

    /// The error that the table allows, in units of ε.
    #[must_use]
    pub fn allowed(self, allowance: Allowance) -> f64 {
        match self {
            Self::Double => f64::allowed(allowance),
            Self::Single => f32::allowed(allowance),
        }
    }
}

/// Scenes from a seed.
#[derive(Clone, Copy, Debug)]
pub struct Campaign {
    /// Determines every scene.
    pub seed: u64,
}

/// The worst error of one quantity in one region.
#[derive(Clone, Copy, Debug, Default)]
pub struct Worst {
    /// The error as a share of the allowed one.
    pub share: f64,
    /// The case in which it occurred.
    pub case: u64,
    /// How many errors were measured.
    pub count: u64,
}

/// Faults of one kind in one region.
#[derive(Clone, Debug, Default)]
pub struct Faults {
    /// How many.
    pub count: u64,
    /// The case of the first one and its description.
    pub first: Option<(u64, String)>,
}

impl Worst {
    fn merge(&mut self, other: Self) {
        let is_worse = other.share > self.share || other.share == self.share && other.case < self.case;
        let worse = if is_worse { other } else { *self };
        *self = Self { count: self.count + other.count, ..worse };
    }
}

impl Faults {
    fn merge(&mut self, other: Self) {
        self.count += other.count;
        let first = [self.first.take(), other.first].into_iter().flatten();
        self.first = first.min_by_key(|first| first.0);
    }
}

/// The findings in one format.
#[derive(Clone, Debug)]
pub struct Ledger {
    /// The format.
    pub format: Format,
    /// By region and quantity.
    pub errors: [[Worst; Quantity::ALL.len()]; Region::ALL.len()],
    /// By region and fault.
    pub faults: [[Faults; Fault::ALL.len()]; Region::ALL.len()],
    /// Counts by region and tally.
    pub tallies: [[u64; Tally::ALL.len()]; Region::ALL.len()],
}

/// The findings in both formats.
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
        let ledgers = [Format::Double, Format::Single].map(|format| Ledger {
            format,
            errors: Default::default(),
            faults: Default::default(),
            tallies: Default::default(),
        });
        Report { ledgers, cases: 0, seed: self.seed }
    }

    /// Examines one case: of every four, three are in f64 and one in f32, and they go through all regions.
    pub fn run(&self, case: u64, report: &mut Report) {
        let is_deep = case.is_multiple_of(DEEP);
        self.run_to(Depth { memory: is_deep, balance: is_deep }, case, report);
    }

    /// Examines one case, including memory and balance.
    pub fn run_closely(&self, case: u64, report: &mut Report) {
        self.run_to(Depth { memory: true, balance: true }, case, report);
    }

    fn run_to(&self, depth: Depth, case: u64, report: &mut Report) {
        let [double, single] = &mut report.ledgers;
        match Format::of(case) {
            Format::Double => self.run_in::<f64>(depth, case, double),
            Format::Single => self.run_in::<f32>(depth, case, single),
        }
        report.cases += 1;
    }

    /// The numbers of a case, as text.
    #[must_use]
    pub fn shown(&self, case: u64) -> String {
        match Format::of(case) {
            Format::Double => format!("{:?}", self.scene::<f64>(case).1),
            Format::Single => format!("{:?}", self.scene::<f32>(case).1),
        }
    }

    /// A number that tells the scene of a case from others.
    #[must_use]
    pub fn fingerprint(&self, case: u64) -> u32 {
        match Format::of(case) {
            Format::Double => self.scene::<f64>(case).1.fingerprint(),
            Format::Single => self.scene::<f32>(case).1.fingerprint(),
        }
    }

    /// The region of a case, and its scene.
    fn scene<T: Precision>(&self, case: u64) -> (usize, Scene<T>) {
        let mut stream = Stream::of_case(self.seed, case);
        let region = Region::of_case(case);
        (region as usize, region.draw::<T>(&mut stream).rounded())
    }

    fn run_in<T: Precision>(&self, depth: Depth, case: u64, ledger: &mut Ledger) {
        let (region, scene) = self.scene::<T>(case);
        let mut entry = Entry { ledger, region, case };
        // A panic must not end the campaign, nor lose what was found before it.
        if let Err(panic) = catch_unwind(AssertUnwindSafe(|| examine(&scene, depth, &mut entry))) {
            let text = panic.downcast_ref::<&str>().map(|text| (*text).to_owned());
            let text = text.or_else(|| panic.downcast_ref::<String>().cloned());
            entry.fault(Fault::Panic, &text.unwrap_or_default());
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
    fn count(&mut self, tally: Tally) {
        self.ledger.tallies[self.region][tally as usize] += 1;
    }

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
    /// Adds the findings in other cases of the same campaign; the order does not matter.
    pub fn merge(&mut self, other: Self) {
        self.cases += other.cases;
        for (ledger, other) in self.ledgers.iter_mut().zip(other.ledgers) {
            for (worst, other) in ledger.errors.iter_mut().flatten().zip(other.errors.into_iter().flatten()) {
                worst.merge(other);
            }
            for (faults, other) in ledger.faults.iter_mut().flatten().zip(other.faults.into_iter().flatten())
            {
                faults.merge(other);
            }
            for (count, other) in ledger.tallies.iter_mut().flatten().zip(other.tallies.as_flattened()) {
                *count += other;
            }
        }
    }

    /// The count of a tally, over all regions and formats.
    #[must_use]
    pub fn count(&self, tally: Tally) -> u64 {
        self.ledgers.iter().flat_map(|ledger| &ledger.tallies).map(|row| row[tally as usize]).sum()
    }

    /// Whether anything was examined, every error is within its bound, and there are no faults.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.count(Tally::Solved) + self.count(Tally::Unsolved) > 0 && self.is_within_bounds()
    }

    /// Whether every error is within its bound and there are no faults, even if nothing was examined.
    #[must_use]
    pub fn is_within_bounds(&self) -> bool {
        self.ledgers.iter().all(|ledger| {
            let worst = ledger.errors.iter().flatten().all(|worst| worst.share <= 1.0);
            worst && ledger.faults.iter().flatten().all(|faults| faults.count == 0)
        })
    }
}
