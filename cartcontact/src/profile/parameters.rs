//! The parameters of a geometry, for messages.

use core::fmt;

use crate::Scalar;
use crate::shown::Shown;

/// The most parameters that a message can carry without allocation.
const MOST_PARAMETERS: usize = 6;

/// The names and values of the fields that a geometry depends on; an error keeps the first six.
///
/// # Examples
///
/// ```
/// use cartcontact::{GapProfile, ProfileError, gap_profile};
///
/// #[gap_profile(r^2 / (2 * radius))]
/// struct Ball {
///     radius: f64,
/// }
///
/// let checked: Result<(), ProfileError> = GapProfile::<f64>::check(&Ball { radius: -20.0 });
/// let Err(ProfileError::NotOpening { parameters, .. }) = checked else { unreachable!() };
/// assert_eq!(parameters.iter().collect::<Vec<_>>(), [("radius", -20.0)]);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Parameters {
    names: &'static [&'static str],
    values: [f64; MOST_PARAMETERS],
}

impl Parameters {
    pub(crate) fn new<T: Scalar>(
        names: &'static [&'static str],
        values: impl IntoIterator<Item = T>,
    ) -> Self {
        let mut parameters = Self { names, ..Self::default() };
        for (kept, value) in parameters.values.iter_mut().zip(values) {
            *kept = value.value();
        }
        parameters
    }

    /// The names and values, in the order of the fields.
    pub fn iter(&self) -> impl Iterator<Item = (&'static str, f64)> {
        self.names.iter().copied().zip(self.values)
    }
}

/// `with radius = 20, k = 0.001: `, the beginning of a message; nothing without parameters.
impl fmt::Display for Parameters {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, (name, value)) in self.iter().enumerate() {
            let before = if index == 0 { "with " } else { ", " };
            write!(f, "{before}{name} = {}", Shown(value))?;
        }
        f.write_str(match self.names.len() {
            0 => "",
            1..=MOST_PARAMETERS => ": ",
            _ => " and more: ",
        })
    }
}

#[cfg(all(test, feature = "std"))]
mod tests {
    use super::*;

    #[test]
    fn messages_begin_with_the_parameters() {
        assert_eq!(Parameters::default().to_string(), "");
        assert_eq!(
            Parameters::new(&["radius", "k"], [20.0, 1e-5]).to_string(),
            "with radius = 20, k = 1e-5: "
        );
        let many = Parameters::new(&["a", "b", "c", "d", "e", "f", "g"], [1.0; 7]);
        assert_eq!(many.to_string(), "with a = 1, b = 1, c = 1, d = 1, e = 1, f = 1 and more: ");
        assert_eq!(many.iter().count(), 6);
    }
}
