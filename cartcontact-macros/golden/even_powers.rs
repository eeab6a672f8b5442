///
/// # Derived from the gap profile
///
/// Lengths in mm; equation numbers of I. Argatov, Mech. Res. Commun. 38 (2011) 29–33, doi 10.1016/j.mechrescom.2010.11.006.
///
/// ```text
/// gap, mm               Φ(r)   = 0.025 r² + 1.09375e-4 r⁴
/// approach, mm          δ₀(a)  = 0.0125 a² + (7/192000) a⁴    (10)
/// slope of the approach δ₀′(a) = 0.025 a + (7/48000) a³
/// load integral, mm⁵    J(a)   = (1/480) a⁶ + (7/768000) a⁸    (14)
/// log kernel, mm³       L(x)   = 0.0015625 x⁴ + (7/2304000) x⁶    (28)
/// pressure kernel, mm³  G(a,r) = (a² − r²)² [0.0015625 + (7/2304000) (2 a² + r²)]    (28)
/// contact radius, mm    the a with (π m/4) J(a) = F(t) + χ ∫F dτ    (14)
/// ```
///
/// Admissible for every contact radius: all coefficients are positive.
///
/// The contact radius takes one step from a table of 4096 bytes where J is between 9.1e-13 and 1.7e7; elsewhere it is iterated.
///
/// Operations of a call:
///
/// Double words round a result only once. A × of them takes 24 plain operations, or 9 if the processor multiplies and adds in one; a + takes 11.
///
/// ```text
/// gap                   3 ×, 1 + of double words
/// approach              3 ×, 1 + of double words
/// slope of the approach 3 ×, 1 + of double words
/// load integral         5 ×, 1 + of double words
/// log kernel            4 ×, 1 + of double words
/// pressure kernel       7 ×, 5 + of double words
/// ```
struct Patellofemoral;
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
    static __TABLE: __cartcontact::Table = __cartcontact::Table {
        quarters: __cartcontact::Quarters {
            first: -160,
            count: 256,
        },
        single: __cartcontact::Quarters {
            first: -160,
            count: 256,
        },
        rows: __cartcontact::Rows(
*b"...",
        ),
    };
    #[inline(always)]
    fn __steepness<T: __cartcontact::Scalar>(
        __a: T,
        []: [T; 0usize],
    ) -> __cartcontact::Steepness<T> {
        let __s = __a * __a;
        let __value = <T as __cartcontact::Scalar>::constant(0.0020833333333333333f64)
            + (<T as __cartcontact::Scalar>::constant(9.114583333333334e-6f64)) * __s;
        __cartcontact::Steepness {
            power: __cartcontact::integer_power(__s, 3),
            value: __value,
            excess: <T as __cartcontact::Scalar>::constant(0.0f64),
            first: <T as __cartcontact::Scalar>::constant(171.42857142857142f64) + __s,
            half_second: <T as __cartcontact::Scalar>::constant(5877551.020408163f64)
                + (<T as __cartcontact::Scalar>::constant(48000.0f64)) * __s,
            per_unit: <T as __cartcontact::Scalar>::constant(13714.285714285714f64),
        }
    }
    #[inline(always)]
    fn __quick_steepness<T: __cartcontact::Scalar>(
        __a: T,
        [__j0,
        __j1,
        ]: [T; 2usize],
    ) -> __cartcontact::Steepness<T> {
        let __s = __a * __a;
        let __value = __j0 + (__j1) * __s;
        __cartcontact::Steepness {
            power: __cartcontact::integer_power(__s, 3),
            value: __value,
            excess: <T as __cartcontact::Scalar>::constant(0.0f64),
            first: <T as __cartcontact::Scalar>::constant(6.0f64) * __j0
                + (<T as __cartcontact::Scalar>::constant(8.0f64) * __j1) * __s,
            half_second: <T as __cartcontact::Scalar>::constant(15.0f64) * __j0
                + (<T as __cartcontact::Scalar>::constant(28.0f64) * __j1) * __s,
            per_unit: <T as __cartcontact::Scalar>::constant(1.0f64),
        }
    }
    #[automatically_derived]
    impl<T> __cartcontact::GapProfile<T> for Patellofemoral
    where
        T: __cartcontact::Scalar,
    {
        #[inline]
        fn gap(&self, __r: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { __cartcontact::precise_even_sum:: < _, _, __FUSED, _ > (__r,
                2u32, [< T as __cartcontact::Scalar > ::constant(0.025f64), < T as
                __cartcontact::Scalar > ::constant(0.000109375f64)]) }
            )
        }
        #[inline]
        fn approach(&self, __a: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { __cartcontact::precise_even_sum:: < _, _, __FUSED, _ > (__a,
                2u32, [< T as __cartcontact::Scalar > ::constant(0.0125f64), < T as
                __cartcontact::Scalar > ::constant(3.6458333333333336e-5f64)]) }
            )
        }
        #[inline]
        fn approach_slope(&self, __a: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { __cartcontact::precise_even_sum:: < _, _, __FUSED, _ > (__a,
                1u32, [< T as __cartcontact::Scalar > ::constant(0.025f64), < T as
                __cartcontact::Scalar > ::constant(0.00014583333333333335f64)]) }
            )
        }
        #[inline]
        fn load_integral(&self, __a: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { __cartcontact::precise_even_sum:: < _, _, __FUSED, _ > (__a,
                6u32, [< T as __cartcontact::Scalar >
                ::constant(0.0020833333333333333f64), < T as __cartcontact::Scalar >
                ::constant(9.114583333333334e-6f64)]) }
            )
        }
        #[inline]
        fn log_kernel(&self, __x: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { __cartcontact::precise_even_sum:: < _, _, __FUSED, _ > (__x,
                4u32, [< T as __cartcontact::Scalar > ::constant(0.0015625f64), < T as
                __cartcontact::Scalar > ::constant(3.0381944444444443e-6f64)]) }
            )
        }
        #[inline]
        fn excess_on_axis(&self, __a: T) -> T {
            let __s = __a * __a;
            (<T as __cartcontact::Scalar>::constant(0.0005208333333333333f64)
                + (<T as __cartcontact::Scalar>::constant(1.5190972222222221e-6f64))
                    * __s) * __s * __s * __s
        }
        #[inline]
        fn quick_approach(&self, __a: T) -> T {
            let __s = __a * __a;
            (<T as __cartcontact::Scalar>::constant(0.0125f64)
                + (<T as __cartcontact::Scalar>::constant(3.6458333333333336e-5f64))
                    * __s) * __s
        }
        #[inline]
        fn quick_approach_slope(&self, __a: T) -> T {
            let __s = __a * __a;
            (<T as __cartcontact::Scalar>::constant(0.025f64)
                + (<T as __cartcontact::Scalar>::constant(0.00014583333333333335f64))
                    * __s) * __a
        }
        #[inline]
        fn quick_load_integral(&self, __a: T) -> T {
            let __s = __a * __a;
            (<T as __cartcontact::Scalar>::constant(0.0020833333333333333f64)
                + (<T as __cartcontact::Scalar>::constant(9.114583333333334e-6f64))
                    * __s) * __s * __s * __s
        }
        #[inline]
        fn pressure_kernel(&self, __a: T, __r: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { __cartcontact::even_pressure_kernel:: < _, _, __FUSED, _ >
                (__a, __r, [< T as __cartcontact::Scalar > ::constant(0.0015625f64), < T
                as __cartcontact::Scalar > ::constant(3.0381944444444443e-6f64)]) }
            )
        }
        #[inline(always)]
        fn quick_pressure_kernel(&self, __a: T, __r: T) -> T {
            __cartcontact::quick_even_pressure_kernel(
                __a,
                __r,
                [
                    <T as __cartcontact::Scalar>::constant(0.0015625f64),
                    <T as __cartcontact::Scalar>::constant(3.0381944444444443e-6f64),
                ],
            )
        }
        #[inline]
        fn radius_within(
            &self,
            __load_integral: T,
            __limit: T,
        ) -> ::core::result::Result<T, __cartcontact::RadiusError> {
            __cartcontact::found_or(
                __cartcontact::Table::radius(
                    &__TABLE,
                    __load_integral,
                    __limit,
                    __cartcontact::OwnUnits,
                    |__a| __steepness(__a, []),
                ),
                move || {
                    __cartcontact::found_or(
                        __cartcontact::WholePowers::radius(
                            &__cartcontact::WholePowers::<_, _, _, 2usize, 1> {
                                coefficients: [
                                    <T as __cartcontact::Scalar>::constant(
                                        0.0020833333333333333f64,
                                    ),
                                    <T as __cartcontact::Scalar>::constant(
                                        9.114583333333334e-6f64,
                                    ),
                                ],
                                powers: [6, 8],
                                steepness: __quick_steepness,
                                last_steepness: __quick_steepness,
                                denominator: <T as __cartcontact::Scalar>::constant(1.0f64),
                            },
                            __load_integral,
                            __limit,
                        ),
                        move || {
                            __cartcontact::invert(
                                __load_integral,
                                __limit,
                                [
                                    (
                                        <T as __cartcontact::Scalar>::constant(0.025f64),
                                        <T as __cartcontact::Scalar>::constant(2.0f64),
                                    ),
                                    (
                                        <T as __cartcontact::Scalar>::constant(0.000109375f64),
                                        <T as __cartcontact::Scalar>::constant(4.0f64),
                                    ),
                                ],
                                false,
                                |__a| {
                                    let __x = __a * __a;
                                    let (__value, __slope) = __cartcontact::value_and_slope(
                                        __x,
                                        [
                                            <T as __cartcontact::Scalar>::constant(
                                                0.0020833333333333333f64,
                                            ),
                                            <T as __cartcontact::Scalar>::constant(
                                                9.114583333333334e-6f64,
                                            ),
                                        ],
                                    );
                                    let __log_slope = <T as __cartcontact::Scalar>::constant(
                                        6.0f64,
                                    ) * __value
                                        + <T as __cartcontact::Scalar>::constant(2.0f64) * __x
                                            * __slope;
                                    (__value * __x * __x * __x, __log_slope * __x * __x * __x)
                                },
                                |__a| {
                                    __cartcontact::in_double_words!(
                                        __FUSED => { __cartcontact::precise_even_sum:: < _, _,
                                        __FUSED, _ > (__a, 6u32, [< T as __cartcontact::Scalar >
                                        ::constant(0.0020833333333333333f64), < T as
                                        __cartcontact::Scalar >
                                        ::constant(9.114583333333334e-6f64)]) }
                                    )
                                },
                            )
                        },
                    )
                },
            )
        }
        fn radii_within(
            &self,
            __load_integrals: &[T],
            __limit: T,
            __radii: &mut [T],
        ) -> ::core::result::Result<(), __cartcontact::RadiusError> {
            __cartcontact::Table::radii(
                &__TABLE,
                (__load_integrals, __radii),
                __limit,
                __cartcontact::OwnUnits,
                #[inline(always)]
                move |__a| __steepness(__a, []),
                #[inline(always)]
                |__load_integral, __more| __cartcontact::WholePowers::solve(
                    &__cartcontact::WholePowers::<_, _, _, 2usize, 1> {
                        coefficients: [
                            <T as __cartcontact::Scalar>::constant(
                                0.0020833333333333333f64,
                            ),
                            <T as __cartcontact::Scalar>::constant(
                                9.114583333333334e-6f64,
                            ),
                        ],
                        powers: [6, 8],
                        steepness: __quick_steepness,
                        last_steepness: __quick_steepness,
                        denominator: <T as __cartcontact::Scalar>::constant(1.0f64),
                    },
                    __load_integral,
                    __more,
                ),
                |__load_integral| __cartcontact::GapProfile::radius_within(
                    self,
                    __load_integral,
                    __limit,
                ),
            )
        }
        #[inline]
        fn has_quick_radii(&self) -> ::core::primitive::bool {
            true
        }
        #[inline]
        fn load_integral_drop(&self, __a: T, __depth: T) -> T {
            let __s = __a - __depth;
            __depth
                * __cartcontact::even_divided_difference(
                    __a,
                    __s,
                    [
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(0.0020833333333333333f64),
                        <T as __cartcontact::Scalar>::constant(9.114583333333334e-6f64),
                    ],
                )
        }
        #[inline]
        fn max_radius(&self) -> T {
            <T as __cartcontact::Scalar>::infinity()
        }
        #[inline]
        fn highest_exponent(&self) -> T {
            <T as __cartcontact::Scalar>::constant(4.0f64)
        }
        #[inline]
        fn is_smooth_at_centre(&self) -> ::core::primitive::bool {
            true
        }
        #[inline]
        fn has_only_positive_terms(&self) -> ::core::primitive::bool {
            true
        }
    }
    #[allow(unreachable_pub, reason = "a program need not ask for them")]
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
