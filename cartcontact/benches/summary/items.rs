//! The ratios: dividends, divisors and targets.

use std::collections::BTreeSet;

use crate::measurements::Measurements;

/// A line of the table.
pub(crate) struct Item {
    pub(crate) result: &'static str,
    pub(crate) asked: Option<Asked>,
    /// None if dividend or divisor was not measured.
    pub(crate) ratio: Option<f64>,
}

#[derive(Clone, Copy)]
pub(crate) enum Asked {
    AtMost(f64),
    AtLeast(f64),
}
use Asked::{AtLeast, AtMost};

impl Asked {
    pub(crate) fn holds(self, ratio: f64) -> bool {
        match self {
            AtMost(bound) => ratio <= bound,
            AtLeast(bound) => ratio >= bound,
        }
    }
}

/// The throughput of the power function in double precision.
const POWF: &str = "radius f64/throughput/powf";

/// The result, its target, the measurement, and its divisor.
type Line = (&'static str, Option<Asked>, &'static str, &'static str);

/// The divisor where the result is a time in nanoseconds, not a ratio.
const NANOSECOND: &str = "";

#[rustfmt::skip]
const LINES: &[Line] = &[
    ("radius, one term", Some(AtMost(1.0)), "radius f64/throughput/one term", POWF),
    ("radius, one term, of a slice", Some(AtMost(0.25)), "radius f64/slice/one term", POWF),
    ("radius, one term, r^2.3", Some(AtMost(1.0)), "radius f64/throughput/one term, r^2.3", POWF),
    ("radius, one term, r^2.3, of a slice", Some(AtMost(0.25)), "radius f64/slice/one term, r^2.3", POWF),
    ("radius, one term, a cone", Some(AtMost(1.0)), "radius f64/throughput/one term, a cone", POWF),
    ("radius, one term, a cone, of a slice", Some(AtMost(0.25)), "radius f64/slice/one term, a cone", POWF),
    ("radius, one term with a field", Some(AtMost(1.0)), "radius f64/throughput/one term with a field", POWF),
    ("radius, one term with a field, of a slice", Some(AtMost(0.25)), "radius f64/slice/one term with a field", POWF),
    ("radius, two terms", Some(AtMost(0.25)), "radius f64/throughput/two terms", POWF),
    ("radius, two terms, latency over that of `powf`", Some(AtMost(0.7)), "radius f64/latency/two terms", "radius f64/latency/powf"),
    ("radius, two terms, of a slice", Some(AtMost(0.12)), "radius f64/slice/two terms", POWF),
    ("radius, three terms", Some(AtMost(0.25)), "radius f64/throughput/three terms", POWF),
    ("radius, three terms, latency over that of `powf`", Some(AtMost(0.7)), "radius f64/latency/three terms", "radius f64/latency/powf"),
    ("radius, three terms, of a slice", Some(AtMost(0.12)), "radius f64/slice/three terms", POWF),
    ("radius, two terms, fractional powers", Some(AtMost(0.25)), "radius f64/throughput/two terms, fractional powers", POWF),
    ("radius, two terms, fractional powers, latency over that of `powf`", Some(AtMost(0.7)), "radius f64/latency/two terms, fractional powers", "radius f64/latency/powf"),
    ("radius, two terms, fractional powers, of a slice", Some(AtMost(0.12)), "radius f64/slice/two terms, fractional powers", POWF),
    ("radius, two terms, powers such as r^2.37", Some(AtMost(0.25)), "radius f64/throughput/two terms, powers such as r^2.37", POWF),
    ("radius, two terms, powers such as r^2.37, of a slice", Some(AtMost(0.12)), "radius f64/slice/two terms, powers such as r^2.37", POWF),
    ("radii at many times, two terms, constant load", Some(AtMost(0.12)), "radius f64/slice/two terms, Contact::radii", POWF),
    ("radii at many times, three terms, constant load", Some(AtMost(0.12)), "radius f64/slice/three terms, Contact::radii", POWF),
    ("radius at one time, two terms, constant load", None, "radius f64/throughput/two terms, Contact::at", POWF),
    ("radius, four terms", None, "radius f64/throughput/four terms", POWF),
    ("radius, four terms, of a slice", None, "radius f64/slice/four terms", POWF),
    ("radius, two terms with a field, the end of its range included", None, "radius f64/throughput/two terms with a field", POWF),
    ("radius, two terms with a field, of a slice", None, "radius f64/slice/two terms with a field", POWF),
    ("radius, two terms with a field, outside the table", None, "radius f64/throughput/two terms with a field, outside the table", POWF),
    ("radius, two terms with a field, outside the table, of a slice", None, "radius f64/slice/two terms with a field, outside the table", POWF),
    ("radius, three terms with a field, the end of its range included", None, "radius f64/throughput/three terms with a field", POWF),
    ("radius, three terms with a field, of a slice", None, "radius f64/slice/three terms with a field", POWF),
    ("radius, three terms with three fields", None, "radius f64/throughput/three terms with three fields", POWF),
    ("radius, three terms with three fields, of a slice", None, "radius f64/slice/three terms with three fields", POWF),
    ("radius, three terms with three fields, powers with 1/2", None, "radius f64/throughput/three halves with three fields", POWF),
    ("radius, three terms with three fields, powers with 1/2, of a slice", None, "radius f64/slice/three halves with three fields", POWF),
    ("radius, two terms, `Polynomial`", None, "radius f64/throughput/two terms, Polynomial", POWF),
    ("radius, two terms, by the crate `roots`", None, "radius f64/throughput/two terms, roots", POWF),
    ("radius, two terms, f32, over `powf` in f32", None, "radius f32/throughput/two terms", "radius f32/throughput/powf"),
    ("radius, two terms, f32, of a slice, over `powf` in f32", None, "radius f32/slice/two terms", "radius f32/throughput/powf"),
    ("one pressure, radius included, constant load", Some(AtMost(15.0)), "pressure/generated, constant load", POWF),
    ("one pressure, constant load, after 30 e-foldings", Some(AtMost(15.0)), "pressure/constant load, after 30 e-foldings", POWF),
    ("one pressure, three terms, constant load", Some(AtMost(15.0)), "pressure/three terms", POWF),
    ("one pressure, a cone, constant load", Some(AtMost(15.0)), "pressure/a cone", POWF),
    ("one pressure, two terms with a field, constant load", Some(AtMost(15.0)), "pressure/two terms with a field", POWF),
    ("one pressure, fractional powers, constant load", Some(AtMost(15.0)), "pressure/fractional powers", POWF),
    ("one pressure, powers such as r^2.37, constant load", Some(AtMost(15.0)), "pressure/powers such as r^2.37", POWF),
    ("one pressure, two terms, `Polynomial`, constant load", None, "pressure/Polynomial, constant load", POWF),
    ("one pressure under a load of 100 knots that all count", Some(AtMost(40.0)), "pressure/generated, 100 knots that count", POWF),
    ("one pressure under a load of 100 knots, of which 10 count", Some(AtMost(40.0)), "pressure/generated, 100 knots, 10 that count", POWF),
    ("one pressure, formulas as printed, `gauss-quad`, `roots`", None, "pressure/as printed (25)-(27), gauss-quad and roots", POWF),
    ("1000 × 1000 pressures over filling the memory", Some(AtMost(1.5)), "field/pressure_field/1000 x 1000", "field/fill with a constant/1000 x 1000"),
    ("250 × 4000 pressures over filling the memory", Some(AtMost(1.5)), "field/pressure_field/250 x 4000", "field/fill with a constant/250 x 4000"),
    ("4000 × 250 pressures over filling the memory", Some(AtMost(2.5)), "field/pressure_field/4000 x 250", "field/fill with a constant/4000 x 250"),
    ("(26)–(27) at every point over 1000 × 1000 pressures", Some(AtLeast(300.0)), "field/as printed (26)-(27) at every point/100 x 100", "field/pressure_field/1000 x 1000"),
    ("`Contact::new` for a new patient", Some(AtMost(30.0)), "scenes/Contact::new", POWF),
    ("a scene of a parametric study, ns", Some(AtMost(500.0)), "scenes/study", NANOSECOND),
    ("radius over the same by hand", Some(AtMost(1.05)), "radius f64/throughput/two terms", "radius f64/throughput/two terms, by hand"),
    ("radius over the same by hand, latency", Some(AtMost(1.05)), "radius f64/latency/two terms", "radius f64/latency/two terms, by hand"),
    ("radius over the same by hand, of a slice", Some(AtMost(1.05)), "radius f64/slice/two terms", "radius f64/slice/two terms, by hand"),
    ("radius over Newton's method by hand", None, "radius f64/throughput/two terms", "radius f64/throughput/two terms, by hand, Newton"),
    ("approach, rounded once, over plain arithmetic by hand", None, "evaluators f64/throughput/approach", "evaluators f64/throughput/approach, by hand"),
    ("approach, rounded once, over plain arithmetic by hand, latency", None, "evaluators f64/latency/approach", "evaluators f64/latency/approach, by hand"),
    ("load integral, rounded once, over plain arithmetic by hand", None, "evaluators f64/throughput/load integral", "evaluators f64/throughput/load integral, by hand"),
    ("load integral, rounded once, over plain arithmetic by hand, latency", None, "evaluators f64/latency/load integral", "evaluators f64/latency/load integral, by hand"),
    ("pressure kernel, rounded once, over plain arithmetic by hand", None, "evaluators f64/throughput/pressure kernel", "evaluators f64/throughput/pressure kernel, by hand"),
    ("pressure kernel, rounded once, over plain arithmetic by hand, latency", None, "evaluators f64/latency/pressure kernel", "evaluators f64/latency/pressure kernel, by hand"),
    ("drainage: (χ = 0.0015/s) ÷ (χ = 0: no memory)", None, "skipping/drainage/chi = 0.0015/s", "skipping/drainage/chi = 0: no memory"),
    ("even powers: (in r) ÷ (in the square of r)", None, "skipping/even powers/in r", "skipping/even powers/in the square of r"),
    ("faded history: (9900 s of knots, the last 800 s count) ÷ (900 s of knots, the last 800 s count)", None, "skipping/faded history/9900 s of knots, the last 800 s count", "skipping/faded history/900 s of knots, the last 800 s count"),
    ("memory: (t = 200 s) ÷ (t = 0: none)", None, "skipping/memory/t = 200 s", "skipping/memory/t = 0: none"),
    ("on demand: (radius, approach and peak pressure) ÷ (radius only)", None, "skipping/on demand/radius, approach and peak pressure", "skipping/on demand/radius only"),
    ("one term: (with a second one) ÷ (alone)", None, "skipping/one term/with a second one", "skipping/one term/alone"),
    ("outside the contact: (inside) ÷ (outside: zero)", None, "skipping/outside the contact/inside", "skipping/outside the contact/outside: zero"),
    ("straight load: (does not say so) ÷ (says so)", None, "skipping/straight load/does not say so", "skipping/straight load/says so"),
    ("whole powers: (exponentials) ÷ (multiplications)", None, "skipping/whole powers/exponentials", "skipping/whole powers/multiplications"),
];

pub(crate) fn items(measurements: &Measurements) -> Vec<Item> {
    let item = |&(result, asked, measured, unit): &Line| {
        let unit = if unit == NANOSECOND { Some(1.0) } else { measurements.time(unit) };
        let ratio = measurements.time(measured).zip(unit).map(|(time, unit)| time / unit);
        Item { result, asked, ratio }
    };
    LINES.iter().map(item).collect()
}

/// The benchmarks of the lines above that are missing: their names have changed, or they were not run.
pub(crate) fn missing(measurements: &Measurements) -> Vec<&'static str> {
    let names: BTreeSet<_> = LINES.iter().flat_map(|&(_, _, measured, unit)| [measured, unit]).collect();
    names.into_iter().filter(|&name| name != NANOSECOND && measurements.time(name).is_none()).collect()
}
