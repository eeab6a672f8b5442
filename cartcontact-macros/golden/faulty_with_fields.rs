struct Ball<S> {
    radius: S,
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
            "`raduis` is unknown; did you mean `radius`?"
        }
    };
    #[allow(unreachable_pub, reason = "a program need not ask for them")]
    impl<S> Ball<S>
    where
        S: __cartcontact::Scalar,
    {
        /// The terms of the gap Σ C rⁿ as pairs (C, n), in ascending order of their exponents.
        pub fn terms(&self) -> [(S, S); __FAULTS] {
            loop {}
        }
    }
    #[automatically_derived]
    impl<S> __cartcontact::GapProfile<S> for Ball<S>
    where
        S: __cartcontact::Scalar,
    {
        fn gap(&self, _: S) -> S {
            loop {}
        }
        fn approach(&self, _: S) -> S {
            loop {}
        }
        fn approach_slope(&self, _: S) -> S {
            loop {}
        }
        fn load_integral(&self, _: S) -> S {
            loop {}
        }
        fn log_kernel(&self, _: S) -> S {
            loop {}
        }
        fn pressure_kernel(&self, _: S, _: S) -> S {
            loop {}
        }
        fn radius_within(
            &self,
            _: S,
            _: S,
        ) -> ::core::result::Result<S, __cartcontact::RadiusError> {
            loop {}
        }
        fn max_radius(&self) -> S {
            loop {}
        }
    }
};
