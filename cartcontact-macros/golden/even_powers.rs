///
/// # Derived from the gap profile
///
/// Lengths in mm; equation numbers of I. Argatov, Mech. Res. Commun. 38 (2011) 29–33, doi 10.1016/j.mechrescom.2010.11.006.
///
/// ```text
/// gap, mm               Φ(r)   = 0.025 r² + 1.09375e-4 r⁴
/// approach, mm          δ₀(a)  = 0.0125 a² + 7/192000 a⁴    (10)
/// slope of the approach δ₀′(a) = 0.025 a + 7/48000 a³
/// load integral, mm⁵    J(a)   = 1/480 a⁶ + 7/768000 a⁸    (14)
/// log kernel, mm³       L(x)   = 0.0015625 x⁴ + 7/2304000 x⁶    (28)
/// pressure kernel, mm³  G(a,r) = (a² − r²)² [0.0015625 + 7/2304000 (2 a² + r²)]    (28)
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
/// slope of the approach 3 × or ÷, 1 + or −
/// load integral         a routine of the run-time crate
/// log kernel            a routine of the run-time crate
/// pressure kernel       a routine of the run-time crate
/// ```
struct Patellofemoral;
const _: () = {
    #[automatically_derived]
    impl<T> ::cartcontact::GapProfile<T> for Patellofemoral
    where
        T: ::cartcontact::Scalar,
    {
        #[inline]
        fn gap(&self, r: T) -> T {
            ::cartcontact::generated::precise_even_sum(
                r,
                2u32,
                [
                    <T as ::cartcontact::Scalar>::constant(0.025f64),
                    <T as ::cartcontact::Scalar>::constant(0.000109375f64),
                ],
            )
        }
        #[inline]
        fn approach(&self, a: T) -> T {
            ::cartcontact::generated::precise_even_sum(
                a,
                2u32,
                [
                    <T as ::cartcontact::Scalar>::constant(0.0125f64),
                    <T as ::cartcontact::Scalar>::constant(3.6458333333333336e-5f64),
                ],
            )
        }
        #[inline]
        fn approach_slope(&self, a: T) -> T {
            let s = a * a;
            (<T as ::cartcontact::Scalar>::constant(0.025f64)
                + (<T as ::cartcontact::Scalar>::constant(0.00014583333333333335f64))
                    * s) * a
        }
        #[inline]
        fn load_integral(&self, a: T) -> T {
            ::cartcontact::generated::precise_even_sum(
                a,
                6u32,
                [
                    <T as ::cartcontact::Scalar>::constant(0.0020833333333333333f64),
                    <T as ::cartcontact::Scalar>::constant(9.114583333333334e-6f64),
                ],
            )
        }
        #[inline]
        fn log_kernel(&self, x: T) -> T {
            ::cartcontact::generated::precise_even_sum(
                x,
                4u32,
                [
                    <T as ::cartcontact::Scalar>::constant(0.0015625f64),
                    <T as ::cartcontact::Scalar>::constant(3.0381944444444443e-6f64),
                ],
            )
        }
        #[inline]
        fn quick_approach(&self, a: T) -> T {
            let s = a * a;
            (<T as ::cartcontact::Scalar>::constant(0.0125f64)
                + (<T as ::cartcontact::Scalar>::constant(3.6458333333333336e-5f64)) * s)
                * s
        }
        #[inline]
        fn quick_load_integral(&self, a: T) -> T {
            let s = a * a;
            (<T as ::cartcontact::Scalar>::constant(0.0020833333333333333f64)
                + (<T as ::cartcontact::Scalar>::constant(9.114583333333334e-6f64)) * s)
                * s * s * s
        }
        #[inline]
        fn pressure_kernel(&self, a: T, r: T) -> T {
            ::cartcontact::generated::even_pressure_kernel(
                a,
                r,
                [
                    <T as ::cartcontact::Scalar>::constant(0.0015625f64),
                    <T as ::cartcontact::Scalar>::constant(3.0381944444444443e-6f64),
                ],
            )
        }
        #[inline]
        fn quick_pressure_kernel(&self, a: T, r: T) -> T {
            ::cartcontact::generated::quick_even_pressure_kernel(
                a,
                r,
                [
                    <T as ::cartcontact::Scalar>::constant(0.0015625f64),
                    <T as ::cartcontact::Scalar>::constant(3.0381944444444443e-6f64),
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
                        <T as ::cartcontact::Scalar>::constant(0.025f64),
                        <T as ::cartcontact::Scalar>::constant(2.0f64),
                    ),
                    ::cartcontact::generated::PositiveTerm::of(
                        <T as ::cartcontact::Scalar>::constant(0.000109375f64),
                        <T as ::cartcontact::Scalar>::constant(4.0f64),
                    ),
                ]),
                false,
                |a| {
                    let x = a * a;
                    let (value, slope) = ::cartcontact::generated::value_and_slope(
                        x,
                        [
                            <T as ::cartcontact::Scalar>::constant(
                                0.0020833333333333333f64,
                            ),
                            <T as ::cartcontact::Scalar>::constant(
                                9.114583333333334e-6f64,
                            ),
                        ],
                    );
                    let log_slope = <T as ::cartcontact::Scalar>::constant(6.0f64)
                        * value
                        + <T as ::cartcontact::Scalar>::constant(2.0f64) * x * slope;
                    (value * x * x * x, log_slope * x * x * x)
                },
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
                            <T as ::cartcontact::Scalar>::constant(
                                9.114583333333334e-6f64,
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
            <T as ::cartcontact::Scalar>::constant(4.0f64)
        }
        #[inline]
        fn is_smooth_at_centre(&self) -> bool {
            true
        }
    }
    #[allow(dead_code, unreachable_pub, reason = "a program need not ask for them")]
    impl Patellofemoral {
        /// The terms of the gap Σ C rⁿ as pairs (C, n), in ascending order of their exponents.
        pub const TERMS: [(::core::primitive::f64, ::core::primitive::f64); 2usize] = [
            (0.025f64, 2.0f64),
            (0.000109375f64, 4.0f64),
        ];
        /// The largest contact radius that the geometry is proved for, in mm; infinity if there is no limit.
        pub const MAX_RADIUS: ::core::primitive::f64 = ::core::primitive::f64::INFINITY;
    }
};
