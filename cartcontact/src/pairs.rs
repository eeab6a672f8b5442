//! Pairs of numbers in any storage.

/// Pairs of numbers: the terms of a [`Polynomial`](crate::Polynomial), or the knots of a
/// [`PiecewiseLinear`](crate::load::PiecewiseLinear) load.
///
/// Everything that is an `AsRef<[(T, T)]>` implements it, such as arrays, slices and `Vec`s of pairs; there is nothing
/// left to implement. It has a name of its own so that the compiler can say what is wrong with other arguments.
///
/// # Examples
///
/// ```
/// use cartcontact::Pairs;
///
/// fn first<T: Copy>(pairs: impl Pairs<T>) -> Option<(T, T)> {
///     pairs.as_ref().first().copied()
/// }
/// assert_eq!(first([(0.025, 2.0), (1e-4, 4.0)]), Some((0.025, 2.0)));
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not hold pairs of numbers of one type",
    label = "not an array, a slice or a `Vec` of pairs",
    note = "a gap is pairs (coefficient, exponent), as in `[(0.025, 2.0), (1e-4, 4.0)]`, and a load pairs (time, force), \
            as in `[(0.0, 20.0), (0.5, 100.0)]`: in parentheses, and with decimal points"
)]
pub trait Pairs<T>: AsRef<[(T, T)]> {}

// Otherwise the compiler would report nothing but the bound itself.
#[diagnostic::do_not_recommend]
impl<T, S: AsRef<[(T, T)]> + ?Sized> Pairs<T> for S {}
