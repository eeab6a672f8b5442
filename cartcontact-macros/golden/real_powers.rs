///
/// # Derived from the gap profile
///
/// Lengths in mm; equation numbers of I. Argatov, Mech. Res. Commun. 38 (2011) 29–33, doi 10.1016/j.mechrescom.2010.11.006.
///
/// ```text
/// gap, mm               Φ(r)   = 0.01 r^1.5 + 0.002 r^3.25
/// approach, mm          δ₀(a)  = 1/175 a^1.5 + 2/2625 a^3.25    (10)
/// slope of the approach δ₀′(a) = 3/350 a^0.5 + 13/5250 a^2.25
/// load integral, mm⁵    J(a)   = 3/3850 a^5.5 + 13/76125 a^7.25    (14)
/// log kernel, mm³       L(x)   = 1/1225 x^3.5 + 4/55125 x^5.25    (28)
/// pressure kernel, mm³  G(a,r) = 1/2450 a^3.5 K(1.5, r/a) + 2/55125 a^5.25 K(3.25, r/a), K(n,q) = n − (n+2) q² + 2 qⁿ⁺²    (28)
/// contact radius, mm    the a with (π m/4) J(a) = F(t) + χ ∫F dτ    (14)
/// ```
///
/// Admissible for every contact radius: all coefficients are positive.
///
struct RealPowers;
const _: () = {
    #[automatically_derived]
    impl<T> ::cartcontact::GapProfile<T> for RealPowers
    where
        T: ::cartcontact::Scalar,
    {
        #[inline]
        fn gap(&self, r: T) -> T {
            ::cartcontact::generated::power_sum(
                r,
                [
                    (
                        <T as ::cartcontact::Scalar>::constant(0.01f64),
                        <T as ::cartcontact::Scalar>::constant(1.5f64),
                    ),
                    (
                        <T as ::cartcontact::Scalar>::constant(0.002f64),
                        <T as ::cartcontact::Scalar>::constant(3.25f64),
                    ),
                ],
            )
        }
        #[inline]
        fn approach(&self, a: T) -> T {
            ::cartcontact::generated::power_sum(
                a,
                [
                    (
                        <T as ::cartcontact::Scalar>::constant(0.005714285714285714f64),
                        <T as ::cartcontact::Scalar>::constant(1.5f64),
                    ),
                    (
                        <T as ::cartcontact::Scalar>::constant(0.0007619047619047619f64),
                        <T as ::cartcontact::Scalar>::constant(3.25f64),
                    ),
                ],
            )
        }
        #[inline]
        fn approach_slope(&self, a: T) -> T {
            ::cartcontact::generated::quick_power_sum(
                a,
                [
                    (
                        <T as ::cartcontact::Scalar>::constant(0.008571428571428572f64),
                        <T as ::cartcontact::Scalar>::constant(0.5f64),
                    ),
                    (
                        <T as ::cartcontact::Scalar>::constant(0.002476190476190476f64),
                        <T as ::cartcontact::Scalar>::constant(2.25f64),
                    ),
                ],
            )
        }
        #[inline]
        fn load_integral(&self, a: T) -> T {
            ::cartcontact::generated::power_sum(
                a,
                [
                    (
                        <T as ::cartcontact::Scalar>::constant(0.0007792207792207792f64),
                        <T as ::cartcontact::Scalar>::constant(5.5f64),
                    ),
                    (
                        <T as ::cartcontact::Scalar>::constant(
                            0.00017077175697865354f64,
                        ),
                        <T as ::cartcontact::Scalar>::constant(7.25f64),
                    ),
                ],
            )
        }
        #[inline]
        fn log_kernel(&self, x: T) -> T {
            ::cartcontact::generated::power_sum(
                x,
                [
                    (
                        <T as ::cartcontact::Scalar>::constant(0.0008163265306122449f64),
                        <T as ::cartcontact::Scalar>::constant(3.5f64),
                    ),
                    (
                        <T as ::cartcontact::Scalar>::constant(7.256235827664399e-5f64),
                        <T as ::cartcontact::Scalar>::constant(5.25f64),
                    ),
                ],
            )
        }
        #[inline]
        fn quick_approach(&self, a: T) -> T {
            ::cartcontact::generated::quick_power_sum(
                a,
                [
                    (
                        <T as ::cartcontact::Scalar>::constant(0.005714285714285714f64),
                        <T as ::cartcontact::Scalar>::constant(1.5f64),
                    ),
                    (
                        <T as ::cartcontact::Scalar>::constant(0.0007619047619047619f64),
                        <T as ::cartcontact::Scalar>::constant(3.25f64),
                    ),
                ],
            )
        }
        #[inline]
        fn quick_load_integral(&self, a: T) -> T {
            ::cartcontact::generated::quick_power_sum(
                a,
                [
                    (
                        <T as ::cartcontact::Scalar>::constant(0.0007792207792207792f64),
                        <T as ::cartcontact::Scalar>::constant(5.5f64),
                    ),
                    (
                        <T as ::cartcontact::Scalar>::constant(
                            0.00017077175697865354f64,
                        ),
                        <T as ::cartcontact::Scalar>::constant(7.25f64),
                    ),
                ],
            )
        }
        #[inline]
        fn pressure_kernel(&self, a: T, r: T) -> T {
            ::cartcontact::generated::pressure_kernel(
                a,
                r,
                [
                    (
                        <T as ::cartcontact::Scalar>::constant(0.01f64),
                        <T as ::cartcontact::Scalar>::constant(1.5f64),
                    ),
                    (
                        <T as ::cartcontact::Scalar>::constant(0.002f64),
                        <T as ::cartcontact::Scalar>::constant(3.25f64),
                    ),
                ],
            )
        }
        #[inline]
        fn quick_pressure_kernel(&self, a: T, r: T) -> T {
            ::cartcontact::generated::quick_pressure_kernel(
                a,
                r,
                [
                    (
                        <T as ::cartcontact::Scalar>::constant(0.01f64),
                        <T as ::cartcontact::Scalar>::constant(1.5f64),
                    ),
                    (
                        <T as ::cartcontact::Scalar>::constant(0.002f64),
                        <T as ::cartcontact::Scalar>::constant(3.25f64),
                    ),
                ],
            )
        }
        #[inline]
        fn radius_within(
            &self,
            load_integral: T,
            limit: T,
        ) -> ::core::result::Result<T, ::cartcontact::RadiusError> {
            ::cartcontact::generated::invert(
                load_integral,
                limit,
                ::core::iter::IntoIterator::into_iter([
                    ::cartcontact::generated::PositiveTerm::of(
                        <T as ::cartcontact::Scalar>::constant(0.01f64),
                        <T as ::cartcontact::Scalar>::constant(1.5f64),
                    ),
                    ::cartcontact::generated::PositiveTerm::of(
                        <T as ::cartcontact::Scalar>::constant(0.002f64),
                        <T as ::cartcontact::Scalar>::constant(3.25f64),
                    ),
                ]),
                false,
                |a| {
                    ::cartcontact::generated::power_sum_and_log_slope(
                        a,
                        [
                            (
                                <T as ::cartcontact::Scalar>::constant(
                                    0.0007792207792207792f64,
                                ),
                                <T as ::cartcontact::Scalar>::constant(5.5f64),
                            ),
                            (
                                <T as ::cartcontact::Scalar>::constant(
                                    0.00017077175697865354f64,
                                ),
                                <T as ::cartcontact::Scalar>::constant(7.25f64),
                            ),
                        ],
                    )
                },
            )
        }
        #[inline]
        fn load_integral_drop(&self, a: T, depth: T) -> T {
            ::cartcontact::generated::power_sum_drop(
                a,
                depth,
                [
                    (
                        <T as ::cartcontact::Scalar>::constant(0.0007792207792207792f64),
                        <T as ::cartcontact::Scalar>::constant(5.5f64),
                    ),
                    (
                        <T as ::cartcontact::Scalar>::constant(
                            0.00017077175697865354f64,
                        ),
                        <T as ::cartcontact::Scalar>::constant(7.25f64),
                    ),
                ],
            )
        }
        #[inline]
        fn max_radius(&self) -> T {
            <T as ::cartcontact::Scalar>::infinity()
        }
        #[inline]
        fn highest_exponent(&self) -> T {
            <T as ::cartcontact::Scalar>::constant(3.25f64)
        }
        #[inline]
        fn is_smooth_at_centre(&self) -> bool {
            false
        }
    }
    #[allow(dead_code, unreachable_pub, reason = "a program need not ask for them")]
    impl RealPowers {
        /// The terms of the gap Σ C rⁿ as pairs (C, n), in ascending order of their exponents.
        pub const TERMS: [(::core::primitive::f64, ::core::primitive::f64); 2usize] = [
            (0.01f64, 1.5f64),
            (0.002f64, 3.25f64),
        ];
        /// The largest contact radius that the geometry is proved for, in mm; infinity if there is no limit.
        pub const MAX_RADIUS: ::core::primitive::f64 = ::core::primitive::f64::INFINITY;
    }
};
