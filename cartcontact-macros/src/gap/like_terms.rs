//! Sums whose like terms are merged.
//!
//! A sorted list, as sums are short: a tree for each kind of sum was a fifth of the code generated for this crate.

use core::ops::Deref;

use num_traits::Zero;

use crate::number::Rational;

/// What stands before a power, or in its exponent, and is added up.
pub(crate) trait Summable {
    fn add(&mut self, other: Self);
    fn vanishes(&self) -> bool;
}

impl Summable for Rational {
    fn add(&mut self, other: Self) {
        *self += other;
    }

    fn vanishes(&self) -> bool {
        self.is_zero()
    }
}

/// Values by the key that they share, in ascending order; no value is zero.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(test, derive(Debug))]
pub(crate) struct LikeTerms<Key, Value> {
    terms: Vec<(Key, Value)>,
}

impl<Key, Value> Default for LikeTerms<Key, Value> {
    fn default() -> Self {
        LikeTerms { terms: Vec::new() }
    }
}

impl<Key: Ord, Value: Summable> LikeTerms<Key, Value> {
    pub(crate) fn of(key: Key, value: Value) -> Self {
        let mut terms = LikeTerms::default();
        terms.add(key, value);
        terms
    }

    pub(crate) fn add(&mut self, key: Key, value: Value) {
        match self.terms.binary_search_by(|(own, _)| own.cmp(&key)) {
            Ok(index) => {
                self.terms[index].1.add(value);
                if self.terms[index].1.vanishes() {
                    self.terms.remove(index);
                }
            }
            Err(_) if value.vanishes() => {}
            Err(index) => self.terms.insert(index, (key, value)),
        }
    }

    /// Removes and returns a value, if it is there.
    pub(crate) fn take(&mut self, key: &Key) -> Option<Value> {
        let index = self.terms.binary_search_by(|(own, _)| own.cmp(key)).ok()?;
        Some(self.terms.remove(index).1)
    }

    /// Changes every value to another that is not zero.
    pub(crate) fn map(&mut self, value: impl Fn(&mut Value)) {
        for (_, own) in &mut self.terms {
            value(own);
        }
    }
}

impl<Key, Value> Deref for LikeTerms<Key, Value> {
    type Target = [(Key, Value)];

    fn deref(&self) -> &[(Key, Value)] {
        &self.terms
    }
}

impl<Key, Value> IntoIterator for LikeTerms<Key, Value> {
    type Item = (Key, Value);
    type IntoIter = std::vec::IntoIter<(Key, Value)>;

    fn into_iter(self) -> Self::IntoIter {
        self.terms.into_iter()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::integer;

    #[test]
    fn like_terms_merge_and_cancel() {
        let mut sum = LikeTerms::of(2, integer(3));
        for (key, value) in [(4, 1), (1, 0), (2, -3), (1, 5), (4, 1)] {
            sum.add(key, integer(value));
        }
        assert!(*sum == [(1, integer(5)), (4, integer(2))]);
        sum.map(|value| *value = -&*value);
        assert!(sum.into_iter().eq([(1, integer(-5)), (4, integer(-2))]));
    }
}
