/// A paraboloid.
///
/// # Derived from the gap profile
///
/// Lengths in mm; equation numbers of I. Argatov, Mech. Res. Commun. 38 (2011) 29–33, doi 10.1016/j.mechrescom.2010.11.006.
///
/// ```text
/// gap, mm               Φ(r)   = 0.025 r²
/// approach, mm          δ₀(a)  = 0.0125 a²    (10)
/// slope of the approach δ₀′(a) = 0.025 a
/// load integral, mm⁵    J(a)   = 1/480 a⁶    (14)
/// log kernel, mm³       L(x)   = 0.0015625 x⁴    (28)
/// pressure kernel, mm³  G(a,r) = (a² − r²)² [0.0015625]    (28)
/// contact radius, mm    the a with (π m/4) J(a) = F(t) + χ ∫F dτ    (14)
/// ```
///
/// Admissible for every contact radius: all coefficients are positive.
///
/// Operations of a call, as generated:
///
/// ```text
/// gap                   a routine of the run-time crate
/// approach              a routine of the run-time crate
/// slope of the approach 1 × or ÷, 0 + or −
/// load integral         a routine of the run-time crate
/// log kernel            a routine of the run-time crate
/// pressure kernel       a routine of the run-time crate
/// ```
pub struct Paraboloid;
const _: () = {
    #[automatically_derived]
    impl<T> ::cartcontact::GapProfile<T> for Paraboloid
    where
        T: ::cartcontact::Scalar,
    {
        #[inline]
        fn gap(&self, r: T) -> T {
            ::cartcontact::generated::precise_even_sum(
                r,
                2u32,
                [<T as ::cartcontact::Scalar>::constant(0.025f64)],
            )
        }
        #[inline]
        fn approach(&self, a: T) -> T {
            ::cartcontact::generated::precise_even_sum(
                a,
                2u32,
                [<T as ::cartcontact::Scalar>::constant(0.0125f64)],
            )
        }
        #[inline]
        fn approach_slope(&self, a: T) -> T {
            (<T as ::cartcontact::Scalar>::constant(0.025f64)) * a
        }
        #[inline]
        fn load_integral(&self, a: T) -> T {
            ::cartcontact::generated::precise_even_sum(
                a,
                6u32,
                [<T as ::cartcontact::Scalar>::constant(0.0020833333333333333f64)],
            )
        }
        #[inline]
        fn log_kernel(&self, x: T) -> T {
            ::cartcontact::generated::precise_even_sum(
                x,
                4u32,
                [<T as ::cartcontact::Scalar>::constant(0.0015625f64)],
            )
        }
        #[inline]
        fn quick_approach(&self, a: T) -> T {
            let s = a * a;
            (<T as ::cartcontact::Scalar>::constant(0.0125f64)) * s
        }
        #[inline]
        fn quick_load_integral(&self, a: T) -> T {
            let s = a * a;
            (<T as ::cartcontact::Scalar>::constant(0.0020833333333333333f64)) * s * s
                * s
        }
        #[inline]
        fn pressure_kernel(&self, a: T, r: T) -> T {
            ::cartcontact::generated::even_pressure_kernel(
                a,
                r,
                [<T as ::cartcontact::Scalar>::constant(0.0015625f64)],
            )
        }
        #[inline]
        fn quick_pressure_kernel(&self, a: T, r: T) -> T {
            ::cartcontact::generated::quick_even_pressure_kernel(
                a,
                r,
                [<T as ::cartcontact::Scalar>::constant(0.0015625f64)],
            )
        }
        #[inline]
        fn radius_within(
            &self,
            load_integral: T,
            limit: T,
        ) -> ::core::result::Result<T, ::cartcontact::RadiusError> {
            ::cartcontact::generated::invert_one_term(
                load_integral,
                ::cartcontact::generated::PositiveTerm::of(
                    <T as ::cartcontact::Scalar>::constant(0.025f64),
                    <T as ::cartcontact::Scalar>::constant(2.0f64),
                ),
                limit,
            )
        }
        #[inline]
        fn load_integral_drop(&self, a: T, depth: T) -> T {
            let s = a - depth;
            depth
                * ((a + s)
                    * ::cartcontact::generated::divided_difference(
                        a * a,
                        s * s,
                        [
                            <T as ::cartcontact::Scalar>::constant(0.0f64),
                            <T as ::cartcontact::Scalar>::constant(0.0f64),
                            <T as ::cartcontact::Scalar>::constant(0.0f64),
                            <T as ::cartcontact::Scalar>::constant(
                                0.0020833333333333333f64,
                            ),
                        ],
                    ))
        }
        #[inline]
        fn max_radius(&self) -> T {
            <T as ::cartcontact::Scalar>::infinity()
        }
        #[inline]
        fn highest_exponent(&self) -> T {
            <T as ::cartcontact::Scalar>::constant(2.0f64)
        }
        #[inline]
        fn is_smooth_at_centre(&self) -> bool {
            true
        }
    }
    #[allow(dead_code, unreachable_pub, reason = "a program need not ask for them")]
    impl Paraboloid {
        /// The terms of the gap Σ C rⁿ as pairs (C, n), in ascending order of their exponents.
        pub const TERMS: [(::core::primitive::f64, ::core::primitive::f64); 1usize] = [
            (0.025f64, 2.0f64),
        ];
        /// The largest contact radius that the geometry is proved for, in mm; infinity if there is no limit.
        pub const MAX_RADIUS: ::core::primitive::f64 = ::core::primitive::f64::INFINITY;
    }
};
