//! The text of a literal -> an exact number.
//!
//! `0.025` is 1/40, not the `f64` nearest to it.

use crate::number::{self, Rational};
use crate::reading::similar::power_of_r;
use crate::reading::unit::{is_unit, no_units};

const NUMERIC_SUFFIXES: [&str; 16] = [
    "f16", "f32", "f64", "f128", "i8", "i16", "i32", "i64", "i128", "isize", "u8", "u16", "u32", "u64",
    "u128", "usize",
];

/// The suffix of a number in single precision in other languages.
const SINGLE_SUFFIX: &str = "f";

/// The number that a literal stands for, or the rule that it breaks.
pub(crate) fn number(text: &str) -> Result<Rational, String> {
    let (negative, text) = text.strip_prefix('-').map_or((false, text), |text| (true, text));
    if quoted(text).is_some() {
        return Err(format!("{text} is text, not an expression; write it without quotes"));
    }
    if !begins_with_digit(text) {
        return Err(format!("{text} is not a number; a gap is written with numbers, `r` and fields"));
    }
    if has_other_base(text) {
        return Err(format!("`{text}` is not a decimal number; write it in decimal"));
    }
    let Parts { whole, fraction, exponent, suffix } = Parts::of(text);
    if !suffix.is_empty() {
        return Err(wrong_suffix(text, suffix));
    }
    let fraction = without_underscores(fraction);
    let digits = without_underscores(whole) + &fraction;
    let value = number::from_decimal(&digits, fraction.len(), exponent)?;
    Ok(if negative { -value } else { value })
}

/// What to say about a number with something right after it.
fn wrong_suffix(text: &str, suffix: &str) -> String {
    let written = without_suffix(text, suffix);
    if lacks_digits(suffix) {
        "an exponent stands right behind `e`, as in `1e-4`".to_owned()
    } else if is_unit(suffix) {
        let number = if suffix == "mm" { &format!("`{written}`") } else { "it alone" };
        no_units(suffix, &format!("write {number}, or `({written} * {suffix})` if that is a field"))
    } else if NUMERIC_SUFFIXES.contains(&suffix) {
        format!("numbers here are exact and have no type; drop the suffix and write `{written}`")
    } else {
        let product = match power_of_r(suffix) {
            Some(power) => {
                format!("`{written} * {power}`, or `{written} * {suffix}` if `{suffix}` is a field")
            }
            None if suffix == SINGLE_SUFFIX => {
                format!("`{written}`, or `{written} * {suffix}` if `{suffix}` is a field")
            }
            None => format!("`{written} * {}`", factor(suffix)),
        };
        format!("{}; write {product}", reads_as_one(text))
    }
}

/// What stands in the quotes of a string.
pub(super) fn quoted(text: &str) -> Option<&str> {
    let text = text.strip_prefix('r').map_or(text, |raw| raw.trim_matches('#'));
    text.strip_prefix('"')?.strip_suffix('"')
}

/// The number and the name that a literal such as `2R` may be meant as.
pub(super) fn with_name(text: &str) -> Option<(&str, &str)> {
    let suffix = Parts::of(text).suffix;
    let is_word = suffix.chars().all(|letter| letter.is_alphanumeric() || letter == '_');
    let is_other = is_unit(suffix) || NUMERIC_SUFFIXES.contains(&suffix) || lacks_digits(suffix);
    let is_name = !suffix.is_empty() && is_word && !is_other;
    (is_name && begins_with_digit(text) && !has_other_base(text))
        .then(|| (without_suffix(text, suffix), suffix))
}

/// The product that a literal such as `2R` may be meant as, or the literal itself.
pub(super) fn as_product(text: &str) -> String {
    with_name(text).map_or_else(|| text.to_owned(), |(number, name)| format!("{number} * {}", factor(name)))
}

/// What a name right after a number stands for: that of `1.5x10` is the 10 of a power of ten.
pub(super) fn factor(name: &str) -> String {
    if is_times_ten(name) { "10".to_owned() } else { with_stars(name) }
}

/// A name with `*` for the centred dots that names may contain, and formulas have for products.
pub(super) fn with_stars(name: &str) -> String {
    name.split('·').filter(|factor| !factor.is_empty()).collect::<Vec<_>>().join(" * ")
}

pub(super) fn is_times_ten(name: &str) -> bool {
    name.eq_ignore_ascii_case("x10")
}

/// What digits on both sides of a comma may be meant as: the comma is a decimal point, or separates thousands.
pub(super) fn across_comma(before: &str, behind: &str) -> Vec<String> {
    let thousands = are_thousands(before.trim_start_matches('-'), split_digits(behind).0)
        .then(|| format!("{before}{behind}"));
    thousands.into_iter().chain([format!("{before}.{behind}")]).collect()
}

/// Whether some digits, perhaps with a suffix, may stand behind a decimal point.
pub(super) fn may_follow_point(text: &str) -> bool {
    begins_with_digit(text) && !has_other_base(text) && !text.contains('.')
}

/// A whole number with a point after its thousands, as before a decimal comma in `1.000,5`.
pub(super) fn without_points(text: &str) -> Option<String> {
    let (before, behind) = text.split_once('.')?;
    are_thousands(before, behind).then(|| format!("{before}{behind}"))
}

/// Whether some digits may be separated where the thousands end.
fn are_thousands(before: &str, behind: &str) -> bool {
    (1..=3).contains(&before.len()) && !before.starts_with('0') && behind.len() == 3
}

pub(super) fn reads_as_one(text: &str) -> String {
    format!("`{text}` reads as one literal")
}

/// The parts of a number in decimal.
struct Parts<'a> {
    whole: &'a str,
    fraction: &'a str,
    exponent: i64,
    suffix: &'a str,
}

impl<'a> Parts<'a> {
    fn of(text: &'a str) -> Self {
        let (whole, rest) = split_digits(text);
        let (fraction, rest) = rest.strip_prefix('.').map_or(("", rest), split_digits);
        let (exponent, suffix) = split_exponent(rest);
        Parts { whole, fraction, exponent, suffix }
    }
}

/// Whether there are only digits, if anything.
pub(super) fn is_whole(text: &str) -> bool {
    text.chars().all(|digit| digit.is_ascii_digit())
}

fn begins_with_digit(text: &str) -> bool {
    text.starts_with(|first: char| first.is_ascii_digit())
}

fn has_other_base(text: &str) -> bool {
    ["0x", "0o", "0b"].iter().any(|prefix| text.starts_with(prefix))
}

fn without_suffix<'a>(text: &'a str, suffix: &str) -> &'a str {
    text.strip_suffix(suffix).unwrap_or(text).trim_end_matches('_')
}

fn split_digits(text: &str) -> (&str, &str) {
    let end = text.find(|next: char| !next.is_ascii_digit() && next != '_').unwrap_or(text.len());
    text.split_at(end)
}

/// The power of ten at the start of `text`, and what follows it. A power that overflows is as wrong as any large one.
fn split_exponent(text: &str) -> (i64, &str) {
    let Some(after) = text.strip_prefix(['e', 'E']) else { return (0, text) };
    let (negative, unsigned) = match after.strip_prefix('-') {
        Some(unsigned) => (true, unsigned),
        None => (false, after.strip_prefix('+').unwrap_or(after)),
    };
    let (digits, rest) = split_digits(unsigned);
    let digits = without_underscores(digits);
    if digits.is_empty() {
        return (0, text);
    }
    let size = digits.parse().unwrap_or(i64::MAX);
    (if negative { -size } else { size }, rest)
}

/// Whether a suffix begins an exponent without digits, which the compiler reports as well.
fn lacks_digits(suffix: &str) -> bool {
    suffix.trim_end_matches(['+', '-']).eq_ignore_ascii_case("e")
}

fn without_underscores(digits: &str) -> String {
    digits.replace('_', "")
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test stops at the first surprise")]
    use super::*;
    use crate::number::fraction;

    #[test]
    fn decimals_mean_what_is_written() {
        assert_eq!(number("0.025").unwrap(), fraction(1, 40));
        assert_eq!(number("1.09375e-4").unwrap(), fraction(7, 64_000));
        assert_eq!(number("1_000.5_0").unwrap(), fraction(2001, 2));
        assert_eq!(number("1E+2").unwrap(), fraction(100, 1));
        assert_eq!(number("2.").unwrap(), fraction(2, 1));
        assert_eq!(number("1.0e400").unwrap() * number("1e-400").unwrap(), fraction(1, 1));
    }

    #[test]
    fn suffixes_are_explained() {
        assert_eq!(number("1.5r").unwrap_err(), "`1.5r` reads as one literal; write `1.5 * r`");
        assert_eq!(number("1.5x10").unwrap_err(), "`1.5x10` reads as one literal; write `1.5 * 10`");
        assert_eq!(number("2x2").unwrap_err(), "`2x2` reads as one literal; write `2 * x2`");
        assert_eq!(number("2k·r").unwrap_err(), "`2k·r` reads as one literal; write `2 * k * r`");
        let float = "`0.1f` reads as one literal; write `0.1`, or `0.1 * f` if `f` is a field";
        assert_eq!(number("0.1f").unwrap_err(), float);
        for text in ["1e", "1.5E", "1.5e+", "1e-"] {
            assert_eq!(number(text).unwrap_err(), "an exponent stands right behind `e`, as in `1e-4`");
        }
        assert!(number("2_f64").unwrap_err().ends_with("drop the suffix and write `2`"));
        assert!(number("1mm").unwrap_err().ends_with("mm; write `1`, or `(1 * mm)` if that is a field"));
        let of_others =
            "convert the number to that of the others, and write it alone, or `(1 * cm)` if that is a field";
        assert!(number("1cm").unwrap_err().ends_with(of_others));
    }

    #[test]
    fn text_is_a_gap_in_quotes() {
        for text in ["\"r^2\"", "r\"r^2\"", "r#\"r^2\"#"] {
            assert!(number(text).unwrap_err().ends_with("write it without quotes"), "{text}");
        }
    }

    #[test]
    fn three_digits_behind_a_comma_may_be_thousands() {
        assert_eq!(across_comma("12", "500"), ["12500", "12.500"]);
        assert_eq!(across_comma("-1", "000mm"), ["-1000mm", "-1.000mm"]);
        for (before, behind) in [("0", "025"), ("12", "50"), ("1000", "250"), ("12", "5000")] {
            assert_eq!(across_comma(before, behind), [format!("{before}.{behind}")]);
        }
    }

    #[test]
    fn other_literals_and_huge_exponents_are_refused() {
        for text in ["0x1F", "\"two\"", "'r'", "b'1'", "1e999999999", "1e-401", "1e99999999999999999999"] {
            assert!(number(text).is_err(), "{text}");
        }
        assert!(number(&"9".repeat(2000)).is_err());
    }
}
