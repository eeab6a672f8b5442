//! Documentation of the annotated item: what was derived from its profile.

use num_traits::{One, ToPrimitive, Zero};

use super::operations::Operations;
use crate::closed_forms::{ClosedForms, PowerSum};
use crate::gap::Gap;
use crate::gap::coefficient::Coefficient;
use crate::gap::expansion::Truncation;
use crate::gap::range::Range;
use crate::geometry::Geometry;
use crate::number::{Rational, decimal, integer, operand};
use crate::proof::Proof;
use crate::reading::item::Item;
use crate::start::Start;
use crate::start::curves::Curves;
use crate::start::roots::{Reach, Roots, Spans};
use crate::start::table::Table;

/// The lines of the documentation, which follow the item's own.
pub(super) fn lines(
    item: &Item,
    geometry: &Geometry,
    forms: &ClosedForms,
    start: Option<&Start>,
    (operations, shared): (&[Operations], Operations),
) -> Vec<String> {
    let gap = &geometry.gap;
    let [a, x] = [["a", "ρ", "s"], ["x", "ξ", "y"]].map(|names| free(item, names));
    let sum = |sum: &PowerSum, variable: &str| written(sum, gap, variable);
    let text = format!(
        "
# Derived from the gap profile

Lengths in mm; equation numbers of I. Argatov, Mech. Res. Commun. 38 (2011) 29–33, doi 10.1016/j.mechrescom.2010.11.006.

```text
gap, mm               Φ(r)   = {}
approach, mm          δ₀({a})  = {}    (10)
slope of the approach δ₀′({a}) = {}
load integral, mm⁵    J({a})   = {}    (14)
log kernel, mm³       L({x})   = {}    (28)
pressure kernel, mm³  G({a},r) = {}    (28)
contact radius, mm    the {a} with (π m/4) J({a}) = F(t) + χ ∫F dτ    (14)
```

{}{}{}

{}",
        sum(&forms.gap, "r"),
        sum(&forms.approach, a),
        sum(&forms.approach_slope, a),
        sum(&forms.load_integral, a),
        sum(&forms.log_kernel, x),
        kernel(gap, a, free(item, ["K", "κ", "Q"])),
        admissibility(item, geometry),
        truncation(geometry),
        solution(start, gap),
        effort(operations, (!gap.is_constant()).then_some(shared)),
    );
    // A space, as in a comment written by hand.
    text.lines().map(|line| if line.is_empty() { String::new() } else { format!(" {line}") }).collect()
}

/// The first of some names for a variable that no field has: fields stand beside it in coefficients.
fn free<'a>(item: &Item, names: [&'a str; 3]) -> &'a str {
    let is_free = |name: &&str| item.fields.iter().all(|field| field.ident != **name);
    names.into_iter().find(is_free).unwrap_or(names[0])
}

/// The sum with its numbers, such as `0.0125 a² + 7.29167e-5 a⁴`.
fn written(sum: &PowerSum, gap: &Gap, variable: &str) -> String {
    joined(sum.summands.iter().map(|own| (own.coefficient(gap), power(variable, &own.exponent))))
}

/// The products of coefficients and powers with their signs between them.
fn joined(products: impl Iterator<Item = (Coefficient, String)>) -> String {
    let mut text = String::new();
    for (coefficient, power) in products {
        join(&mut text, &coefficient, &power);
    }
    text
}

fn join(text: &mut String, coefficient: &Coefficient, power: &str) {
    let written = coefficient.to_string();
    let size = written.strip_prefix('-').filter(|_| !coefficient.is_sum());
    let negative = size.is_some();
    let size = size.unwrap_or(&written);
    // A fraction could seem to include the power.
    let is_in_parentheses = coefficient.is_sum() || (size.contains('/') && !power.is_empty());
    let size = if is_in_parentheses { format!("({size})") } else { size.to_owned() };
    *text += match (text.is_empty(), negative) {
        (true, false) => "",
        (true, true) => "−",
        (false, false) => " + ",
        (false, true) => " − ",
    };
    let implied = size == "1" && !power.is_empty();
    *text += if implied { "" } else { &size };
    *text += if implied || power.is_empty() { "" } else { " " };
    *text += power;
}

/// The pressure kernel of the contact radius `a`: with its double zero as a factor for even exponents, otherwise
/// written with a function of the name `k`.
fn kernel(gap: &Gap, a: &str, k: &str) -> String {
    let is_even = gap.terms.iter().all(|term| (&term.exponent / integer(2)).is_integer());
    let weight = |n: &Rational, factor: i32| (integer(factor) * (n + integer(2)) * (n + integer(2))).recip();
    if is_even && gap.terms.last().is_some_and(|term| term.exponent <= integer(8)) {
        let products = gap.terms.iter().map(|term| {
            (term.coefficient.scaled(&weight(&term.exponent, 1)), tent(&(&term.exponent / integer(2)), a))
        });
        return format!("({a}² − r²)² [{}]", joined(products));
    }
    let products = gap.terms.iter().map(|term| {
        let raised = power(a, &(&term.exponent + integer(2)));
        (
            term.coefficient.scaled(&weight(&term.exponent, 2)),
            format!("{raised} {k}({}, r/{a})", decimal(&term.exponent)),
        )
    });
    format!("{}, {k}(n,q) = n − (n+2) q² + 2 qⁿ⁺²", joined(products))
}

/// Σ_{j<k} (k − j) r^(2j) a^(2(k−1−j)).
fn tent(k: &Rational, a: &str) -> String {
    let count = k.to_i32().unwrap_or(1);
    if count == 1 {
        return String::new();
    }
    let products = (0..count).map(|j| {
        let (r, a) = (power("r", &integer(2 * j)), power(a, &integer(2 * (count - 1 - j))));
        (Coefficient::constant(integer(count - j)), format!("{r} {a}").trim().to_owned())
    });
    format!("({})", joined(products))
}

fn power(variable: &str, exponent: &Rational) -> String {
    if exponent.is_one() {
        return variable.to_owned();
    }
    if exponent.is_zero() {
        return String::new();
    }
    if !exponent.is_integer() {
        return format!("{variable}^{}", operand(exponent));
    }
    let digits = exponent.to_string();
    let raised = digits.chars().map(|digit| match digit {
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        _ => digit.to_digit(10).and_then(|value| char::from_u32(0x2070 + value)).unwrap_or(digit),
    });
    variable.chars().chain(raised).collect()
}

fn admissibility(item: &Item, geometry: &Geometry) -> String {
    let end = match &geometry.range {
        Range::Unbounded => None,
        Range::Limited(end) => Some(decimal(end)),
        Range::Symbolic(end) => Some(format!("`{end}`")),
    };
    match (&geometry.proof, end) {
        (Proof::AllRadii { by }, None) => {
            format!("Admissible for every contact radius: {}.", reason(item, geometry, by))
        }
        (Proof::AllRadii { by }, Some(end)) => {
            let by = reason(item, geometry, by);
            let unchecked = geometry.truncation.as_ref().is_some_and(|series| !series.unchecked.is_empty());
            let inside = if unchecked { ", if the series of all surfaces go so far" } else { "" };
            format!("Admissible for every contact radius ({by}); used up to {end} mm{inside}.")
        }
        (Proof::OnRange, Some(end)) => format!("Proved admissible for contact radii up to {end} mm."),
        (_, end) => {
            let range = end.map_or_else(String::new, |end| format!(" up to {end} mm"));
            format!("Admissibility{range} depends on the fields and is checked when a `Contact` is made.")
        }
    }
}

/// Why a gap is admissible. What is declared about its fields is part of the reason, as `check` refuses other values.
fn reason(item: &Item, geometry: &Geometry, by: &'static str) -> &'static str {
    let is_declared = item.fields.iter().any(|field| field.used && field.is_positive);
    if is_declared && !geometry.gap.is_constant() {
        "no coefficient can be negative with the fields declared positive"
    } else {
        by
    }
}

/// What the series of surfaces neglect.
fn truncation(geometry: &Geometry) -> String {
    let Some(Truncation { order, error, .. }) = &geometry.truncation else { return String::new() };
    let bound = match (error, &geometry.range) {
        (Some(error), Range::Limited(end)) => format!(
            "Up to r = {} mm this changes the gap by at most {} of its value.",
            decimal(end),
            decimal(error)
        ),
        _ => "How much this neglects depends on the radius and is not bounded here.".to_owned(),
    };
    format!("\n\nSurfaces are expanded in powers of r up to r{}. {bound}", power("", &integer(*order)))
}

/// The bytes of a table of four numbers per row.
const SIZE_OF_TABLE: usize = <Table>::size_in_bytes();

/// How the contact radius is found.
fn solution(start: Option<&Start>, gap: &Gap) -> String {
    let Some(start) = start else { return String::new() };
    let step_from =
        |bytes: usize| format!("\n\nThe contact radius takes one step from a table of {bytes} bytes");
    let step = step_from(SIZE_OF_TABLE);
    let table = match start {
        Start::Roots(Roots { reach: Reach::Window, table, .. }) => table,
        Start::Roots(Roots { reach: Reach::Periods { .. }, .. }) => return format!("{step}."),
        Start::Roots(Roots { reach: Reach::Spans(_), .. }) => {
            return format!("{}.", step_from(SIZE_OF_TABLE + Spans::size_in_bytes()));
        }
        Start::Curves(curves) => return by_curves(curves),
        Start::Seeds(seeds) => &seeds.table,
        Start::LeadingTerm => return String::new(),
    };
    let [from, to] = table.range();
    let unit = if gap.is_constant() { "" } else { " in units of the geometry's own" };
    format!("{step} where J{unit} is between {from:.1e} and {to:.1e}; elsewhere it is iterated.")
}

/// Where the contact radius is a polynomial of the load integral.
fn by_curves(curves: &Curves) -> String {
    let [from, to] = curves.double.range();
    let [double, single] = Curves::SIZES_IN_BYTES;
    format!(
        "\n\nThe contact radius is a polynomial from a table of {double} bytes, in single precision of {single}, where \
         J is between {from:.1e} and {to:.1e}; elsewhere it is iterated."
    )
}

/// The operations of one call of each evaluator, unless all are left to the run-time crate.
fn effort(operations: &[Operations], shared: Option<Operations>) -> String {
    if operations.iter().all(|count| matches!(count, Operations::InLibrary)) {
        return String::new();
    }
    let names =
        ["gap", "approach", "slope of the approach", "load integral", "log kernel", "pressure kernel"];
    let lines = names.iter().zip(operations).map(|(name, count)| format!("{name:21} {count}\n"));
    let beside = shared.map_or_else(String::new, |shared| {
        format!(
            "coefficients          {shared}, ÷ among the ×, in addition, and a × for each term at the most\n"
        )
    });
    let legend = "Double words round a result only once. A × of them takes 24 plain operations, or 9 if the processor \
                  multiplies and adds in one; a + takes 11.";
    format!("Operations of a call:\n\n{legend}\n\n```text\n{}{beside}```", lines.collect::<String>())
}
