struct Knee<T> {
    radius: T,
}
#[allow(
    deprecated,
    single_use_lifetimes,
    reason = "they concern the struct, which is repeated here"
)]
#[allow(clippy::approx_constant, reason = "a coefficient near a famous number is none")]
#[allow(
    clippy::multiple_bound_locations,
    reason = "the struct may bound its parameter in place"
)]
#[allow(
    clippy::possible_missing_comma,
    reason = "generated operators seem to span an attribute's lines"
)]
const _: () = {
    use ::cartcontact::generated::root as __cartcontact;
    const __FAULTS: ::core::primitive::usize = {
        ::core::compile_error! {
            "`2r` reads as one literal; write `2 * r`"
        }
        ::core::compile_error! {
            "`x` is unknown; write `r` or a field of `Knee`"
        }
    };
    #[allow(unreachable_pub, reason = "a program need not ask for them")]
    impl<T> Knee<T> {
        #[doc(hidden)]
        pub const TERMS: [(::core::primitive::f64, ::core::primitive::f64); __FAULTS] = [(
            0.0,
            0.0,
        ); __FAULTS];
        #[doc(hidden)]
        pub const MAX_RADIUS: ::core::primitive::f64 = __FAULTS
            as ::core::primitive::f64;
        #[doc(hidden)]
        pub const TRUNCATION_ERROR: ::core::primitive::f64 = __FAULTS
            as ::core::primitive::f64;
    }
    #[automatically_derived]
    impl<T, T_> __cartcontact::GapProfile<T_> for Knee<T>
    where
        T_: __cartcontact::Scalar,
    {
        fn gap(&self, _: T_) -> T_ {
            loop {}
        }
        fn approach(&self, _: T_) -> T_ {
            loop {}
        }
        fn approach_slope(&self, _: T_) -> T_ {
            loop {}
        }
        fn load_integral(&self, _: T_) -> T_ {
            loop {}
        }
        fn log_kernel(&self, _: T_) -> T_ {
            loop {}
        }
        fn pressure_kernel(&self, _: T_, _: T_) -> T_ {
            loop {}
        }
        fn radius_within(
            &self,
            _: T_,
            _: T_,
        ) -> ::core::result::Result<T_, __cartcontact::RadiusError> {
            loop {}
        }
        fn max_radius(&self) -> T_ {
            loop {}
        }
    }
};
