//! A pointer to a load is the load.

use super::{Load, LoadError, Piece};
use crate::Scalar;
use crate::pointers::implement_for_pointers;

implement_for_pointers! {
    Load {
        fn force(&self, t: T) -> T;
        fn impulse(&self, t: T) -> T;
        fn fill_impulses(&self, times: &[T], impulses: &mut [T]) -> bool;
        fn force_before(&self, t: T) -> T;
        fn next_knot(&self, t: T) -> Option<T>;
        fn is_linear_between_knots(&self) -> bool;
        fn straight_pieces(&self, times: (T, T), pieces: &mut [Piece<T>]) -> usize;
        fn recession(&self, chi: T, t: T) -> Option<T>;
        fn contradiction(&self, chi: T, t: T) -> Option<LoadError>;
        fn check(&self) -> Result<(), LoadError>;
    }
}
