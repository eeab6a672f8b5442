//! The command lines of the programs: options with whole numbers.

/// The numbers that follow these options, as far as they are given, in the order of their names; nothing if the arguments
/// ask for help.
///
/// # Errors
///
/// The message for an unknown option or one without a number.
pub fn numbers<const N: usize>(
    names: [&str; N],
    mut arguments: impl Iterator<Item = String>,
) -> Result<Option<[Option<u64>; N]>, String> {
    let mut numbers = [None; N];
    while let Some(name) = arguments.next() {
        if name == "--help" || name == "-h" {
            return Ok(None);
        }
        let Some(index) = names.iter().position(|known| *known == name) else {
            return Err(format!("there is no option `{name}`"));
        };
        let text = arguments.next().ok_or_else(|| format!("`{name}` needs a number"))?;
        let number = text
            .replace('_', "")
            .parse()
            .map_err(|_| format!("`{name}` needs a whole number from 0, not `{text}`"))?;
        numbers[index] = Some(number);
    }
    Ok(Some(numbers))
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
    fn faults_are_named() {
        for (line, fault) in [
            ("--seeds 7", "there is no option `--seeds`"),
            ("--seed", "`--seed` needs a number"),
            ("--seed -7", "`--seed` needs a whole number from 0, not `-7`"),
        ] {
            assert_eq!(read(line), Err(fault.to_owned()));
        }
    }
}
