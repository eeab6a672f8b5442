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

#[cfg(all(test, feature = "std"))]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::load::{Constant, PiecewiseLinear};
    use crate::{Contact, Medium, Polynomial};

    /// A contact that owns a load chosen at run time.
    fn radius<L: Load<f64> + 'static>(load: L) -> Option<f64> {
        let gap = Polynomial::new([(0.025, 2.0)]).ok()?;
        let medium = Medium::from_constants(0.375, 0.0015).ok()?;
        Contact::new(gap, medium, load).ok()?.at(30.0).ok().map(|now| now.radius())
    }

    #[test]
    fn a_load_may_be_boxed_or_shared() -> Result<(), LoadError> {
        let ramp = PiecewiseLinear::new([(0.0, 20.0), (10.0, 100.0)])?;
        let boxed: [(Box<dyn Load<f64> + Send + Sync>, _); 2] =
            [(Box::new(Constant(100.0)), radius(Constant(100.0))), (Box::new(ramp), radius(ramp))];
        for (load, expected) in boxed {
            assert!(expected.is_some() && radius(load) == expected, "{expected:?}");
        }
        let shared: Arc<dyn Load<f64>> = Arc::new(ramp);
        assert_eq!(radius(shared.clone()), radius(ramp));
        assert!(shared.is_linear_between_knots());
        assert_eq!((shared.next_knot(0.0), shared.force_before(5.0)), (Some(10.0), 60.0));
        assert!(radius(Box::new(Constant(-1.0))).is_none() && Box::new(Constant(-1.0)).check().is_err());
        Ok(())
    }
}
