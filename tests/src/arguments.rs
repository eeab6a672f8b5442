//! The command lines of the programs: `--name N` or `--name=N`, with whole numbers such as 7, 1_000 or 1e6.

/// The numbers of these options, as far as they are given, in the order of their names; nothing if help is asked for.
///
/// # Errors
///
/// The message for an unknown option or one without a number.
pub fn numbers<const N: usize>(
    names: [&str; N],
    mut arguments: impl Iterator<Item = String>,
) -> Result<Option<[Option<u64>; N]>, String> {
    let mut numbers = [None; N];
    while let Some(argument) = arguments.next() {
        if argument == "--help" || argument == "-h" {
            return Ok(None);
        }
        let (name, joined) = match argument.split_once('=') {
            Some((name, text)) => (name, Some(text.to_owned())),
            None => (argument.as_str(), None),
        };
        let Some(index) = names.iter().position(|known| *known == name) else {
            return Err(format!("there is no option `{name}`"));
        };
        let text = joined.or_else(|| arguments.next()).ok_or_else(|| format!("`{name}` needs a number"))?;
        let number =
            whole(&text).ok_or_else(|| format!("`{name}` needs a whole number from 0, not `{text}`"))?;
        numbers[index] = Some(number);
    }
    Ok(Some(numbers))
}

/// A whole number in digits, or in digits and an exponent.
fn whole(text: &str) -> Option<u64> {
    let text = text.replace('_', "");
    let (digits, exponent) = text.split_once(['e', 'E']).unwrap_or((&text, "0"));
    digits.parse::<u64>().ok()?.checked_mul(10_u64.checked_pow(exponent.parse().ok()?)?)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(line: &str) -> Result<Option<[Option<u64>; 2]>, String> {
        numbers(["--cases", "--seed"], line.split_whitespace().map(str::to_owned))
    }

    #[test]
    fn options_are_numbers_in_any_order() {
        assert_eq!(read(""), Ok(Some([None, None])));
        assert_eq!(read("--seed 7 --cases 1_000"), Ok(Some([Some(1000), Some(7)])));
        assert_eq!(read("--seed 7 -h"), Ok(None));
    }

    #[test]
    fn numbers_have_two_spellings_and_options_too() {
        for line in ["--cases 1000000", "--cases 1_000_000", "--cases 1e6", "--cases=1e6", "--cases=10E5"] {
            assert_eq!(read(line), Ok(Some([Some(1_000_000), None])), "{line}");
        }
        assert_eq!(read("--seed=7 --cases 25e17"), Ok(Some([Some(2_500_000_000_000_000_000), Some(7)])));
    }

    #[test]
    fn faults_are_named() {
        for (line, fault) in [
            ("--seeds 7", "there is no option `--seeds`"),
            ("--seed", "`--seed` needs a number"),
            ("--seed=", "`--seed` needs a whole number from 0, not ``"),
            ("--seed -7", "`--seed` needs a whole number from 0, not `-7`"),
            ("--seed=1e-1", "`--seed` needs a whole number from 0, not `1e-1`"),
            ("--seed 1e20", "`--seed` needs a whole number from 0, not `1e20`"),
            ("--seeds=7", "there is no option `--seeds`"),
        ] {
            assert_eq!(read(line), Err(fault.to_owned()));
        }
    }
}
