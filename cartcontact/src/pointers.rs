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
