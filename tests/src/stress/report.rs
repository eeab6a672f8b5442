//! A report as text, 80 columns wide.

use core::fmt;

use super::campaign::{Ledger, Report};
use super::finding::{Fault, Quantity, Tally};
use super::region::Region;

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{} cases from seed {}", self.cases, self.seed)?;
        let counted = |ledger: &&Ledger| ledger.tallies.iter().flatten().any(|&count| count > 0);
        self.ledgers.iter().filter(counted).try_for_each(|ledger| tallies(ledger, f))?;
        let measured = |ledger: &&Ledger| ledger.errors.iter().flatten().any(|worst| worst.count > 0);
        for ledger in self.ledgers.iter().filter(measured) {
            shares(ledger, f)?;
            worst(ledger, f)?;
        }
        self.ledgers.iter().try_for_each(|ledger| exceeded(ledger, f))?;
        self.ledgers.iter().try_for_each(|ledger| faults(ledger, f))
    }
}

/// How many scenes were examined and how many were refused, by region.
fn tallies(ledger: &Ledger, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    write!(f, "\n{}, scenes      ", ledger.format.name())?;
    for tally in Tally::ALL {
        write!(f, "{:>11}", tally.name())?;
    }
    writeln!(f)?;
    let line = |f: &mut fmt::Formatter<'_>, name: &str, row: [u64; Tally::ALL.len()]| {
        write!(f, "{name:17}")?;
        row.iter().try_for_each(|count| write!(f, "{count:>11}"))?;
        writeln!(f)
    };
    for (region, &row) in Region::ALL.into_iter().zip(&ledger.tallies) {
        if row.iter().any(|&count| count > 0) {
            line(f, region.name(), row)?;
        }
    }
    line(f, "all", Tally::ALL.map(|tally| ledger.tallies.iter().map(|row| row[tally as usize]).sum()))
}

/// The largest errors as shares of the allowed ones, by region and quantity.
fn shares(ledger: &Ledger, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    write!(f, "\n{}, error/bound", ledger.format.name())?;
    write!(f, "{:1$}", "", 17 - ledger.format.name().len() - 13)?;
    for quantity in Quantity::ALL {
        write!(f, "{:>5}", quantity.symbol())?;
    }
    writeln!(f)?;
    for (region, row) in Region::ALL.into_iter().zip(&ledger.errors) {
        if row.iter().all(|worst| worst.count == 0) {
            continue;
        }
        write!(f, "{:17}", region.name())?;
        for worst in row {
            match worst.share {
                _ if worst.count == 0 => write!(f, "{:>5}", "–")?,
                share if share < 9.995 => write!(f, "{share:>5.2}")?,
                share if share < 9999.5 => write!(f, "{share:>5.0}")?,
                share => write!(f, "{:>5}", format!("{share:.0e}"))?,
            }
        }
        writeln!(f)?;
    }
    Ok(())
}

/// The worst error of every quantity, in units of ε, and the case in which it occurred.
fn worst(ledger: &Ledger, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    writeln!(f, "\n{}, worst       error/ε  allowed     values  case, region", ledger.format.name())?;
    for quantity in Quantity::ALL {
        let column = ledger.errors.iter().map(|row| row[quantity as usize]);
        let count: u64 = column.clone().map(|worst| worst.count).sum();
        if count == 0 {
            continue;
        }
        let allowed = ledger.format.allowed(quantity.allowance());
        let greatest = Region::ALL.into_iter().zip(column).max_by(|x, y| x.1.share.total_cmp(&y.1.share));
        if let Some((region, worst)) = greatest {
            let error = worst.share * allowed;
            let mark = if worst.share > 1.0 { "  exceeded" } else { "" };
            writeln!(
                f,
                "{:12} {error:>12.2} {allowed:>8.1} {count:>10}  {}, {}{mark}",
                quantity.symbol(),
                worst.case,
                region.name()
            )?;
        }
    }
    Ok(())
}

/// The cases in which errors exceed the allowed ones.
fn exceeded(ledger: &Ledger, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    for (region, row) in Region::ALL.into_iter().zip(&ledger.errors) {
        for (quantity, worst) in Quantity::ALL.into_iter().zip(row).filter(|(_, worst)| worst.share > 1.0) {
            let (share, case, symbol) = (worst.share, worst.case, quantity.symbol());
            writeln!(
                f,
                "{}, {}: {symbol} is off by {share:.3e} of its bound in case {case}",
                ledger.format.name(),
                region.name()
            )?;
        }
    }
    Ok(())
}

/// The faults, if there are any.
fn faults(ledger: &Ledger, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    for fault in Fault::ALL {
        for (region, row) in Region::ALL.into_iter().zip(&ledger.faults) {
            let faults = &row[fault as usize];
            if let Some((case, about)) = &faults.first {
                writeln!(
                    f,
                    "\n{}, {}: {} {}, the first in case {case}:\n  {about}",
                    ledger.format.name(),
                    region.name(),
                    faults.count,
                    fault.name()
                )?;
            }
        }
    }
    Ok(())
}
