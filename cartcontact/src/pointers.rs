//! Pointers to profiles and to loads are profiles and loads.

/// Implements a trait of a scalar type for pointers to its implementors, by methods that call those of the same names.
macro_rules! implement_for_pointers {
    ($name:ident { $($methods:tt)* }) => {
        implement_for_pointers!($name for &P { $($methods)* });
        #[cfg(feature = "std")]
        implement_for_pointers!($name for std::boxed::Box<P> { $($methods)* });
        #[cfg(feature = "std")]
        implement_for_pointers!($name for std::sync::Arc<P> { $($methods)* });
    };
    ($name:ident for $pointer:ty {
        $($(#[$attribute:meta])? fn $method:ident(&self $(, $argument:ident: $kind:ty)*) $(-> $result:ty)?;)*
    }) => {
        #[deny(clippy::missing_trait_methods, reason = "none may fall back to the provided one")]
        #[diagnostic::do_not_recommend]
        impl<T: Scalar, P: $name<T> + ?Sized> $name<T> for $pointer {
            $(
                $(#[$attribute])?
                fn $method(&self $(, $argument: $kind)*) $(-> $result)? {
                    (**self).$method($($argument),*)
                }
            )*
        }
    };
}

pub(crate) use implement_for_pointers;

#[cfg(all(test, feature = "std"))]
mod tests {
    use std::boxed::Box;
    use std::error::Error;
    use std::sync::Arc;

    use crate::load::{Constant, Load, PiecewiseLinear};
    use crate::{Contact, GapProfile, Medium, Polynomial};

    /// A contact that owns a geometry and a load chosen at run time.
    fn radius(profile: impl GapProfile<f64> + 'static, load: impl Load<f64> + 'static) -> Option<f64> {
        let medium = Medium::from_constants(0.375, 0.0015).ok()?;
        Contact::new(profile, medium, load).ok()?.at(30.0).ok().map(|now| now.radius())
    }

    #[test]
    fn a_profile_may_be_boxed_or_shared() -> Result<(), Box<dyn Error>> {
        let load = Constant(100.0);
        let (paraboloid, steeper) =
            (Polynomial::new([(0.025, 2.0)])?, Polynomial::new([(0.025, 2.0), (1e-4, 4.0)])?);
        let boxed: [(Box<dyn GapProfile<f64> + Send + Sync>, _); 2] =
            [(Box::new(paraboloid), radius(paraboloid, load)), (Box::new(steeper), radius(steeper, load))];
        for (profile, expected) in boxed {
            assert!(expected.is_some() && radius(profile, load) == expected, "{expected:?}");
        }
        let shared: Arc<dyn GapProfile<f64>> = Arc::new(steeper);
        assert_eq!(radius(shared, load), radius(steeper, load));
        Ok(())
    }

    #[test]
    fn a_load_may_be_boxed_or_shared() -> Result<(), Box<dyn Error>> {
        let gap = Polynomial::new([(0.025, 2.0)])?;
        let ramp = PiecewiseLinear::new([(0.0, 20.0), (10.0, 100.0)])?;
        let boxed: [(Box<dyn Load<f64> + Send + Sync>, _); 2] =
            [(Box::new(Constant(100.0)), radius(gap, Constant(100.0))), (Box::new(ramp), radius(gap, ramp))];
        for (load, expected) in boxed {
            assert!(expected.is_some() && radius(gap, load) == expected, "{expected:?}");
        }
        let shared: Arc<dyn Load<f64>> = Arc::new(ramp);
        assert_eq!(radius(gap, shared.clone()), radius(gap, ramp));
        assert!(shared.is_linear_between_knots());
        assert_eq!((shared.next_knot(0.0), shared.force_before(5.0)), (Some(10.0), 60.0));
        let negative = Box::new(Constant(-1.0));
        assert!(radius(gap, negative.clone()).is_none() && negative.check().is_err());
        Ok(())
    }
}
