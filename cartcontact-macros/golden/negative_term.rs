///
/// # Derived from the gap profile
///
/// Lengths in mm; equation numbers of I. Argatov, Mech. Res. Commun. 38 (2011) 29–33, doi 10.1016/j.mechrescom.2010.11.006.
///
/// ```text
/// gap, mm               Φ(r)   = 0.05 r² − 0.004 r³ + 2e-4 r⁴
/// approach, mm          δ₀(a)  = 0.025 a² − 0.0016 a³ + (1/15000) a⁴    (10)
/// slope of the approach δ₀′(a) = 0.05 a − 0.0048 a² + (1/3750) a³
/// load integral, mm⁵    J(a)   = (1/240) a⁶ − (3/8750) a⁷ + (1/60000) a⁸    (14)
/// log kernel, mm³       L(x)   = 0.003125 x⁴ − 1.6e-4 x⁵ + (1/180000) x⁶    (28)
/// pressure kernel, mm³  G(a,r) = 0.0015625 a⁴ K(2, r/a) − 8e-5 a⁵ K(3, r/a) + (1/360000) a⁶ K(4, r/a), K(n,q) = n − (n+2) q² + 2 qⁿ⁺²    (28)
/// contact radius, mm    the a with (π m/4) J(a) = F(t) + χ ∫F dτ    (14)
/// ```
///
/// Admissible for every contact radius (the slope of the approach has no positive root); used up to 20 mm.
///
/// The contact radius takes one step from a table of 4096 bytes where J is between 1.4e-14 and 2.6e5; elsewhere it is iterated.
///
/// Operations of a call:
///
/// Double words round a result only once. A × of them takes 24 plain operations, or 9 if the processor multiplies and adds in one; a + takes 11.
///
/// ```text
/// gap                   4 ×, 2 + of double words
/// approach              4 ×, 2 + of double words
/// slope of the approach 3 ×, 2 + of double words
/// load integral         8 ×, 2 + of double words
/// log kernel            6 ×, 2 + of double words
/// pressure kernel       12 ×, 12 + of double words
/// ```
struct MixedSign;
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
            first: -184,
            count: 256,
        },
        single: __cartcontact::Quarters {
            first: -184,
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
        let __value = <T as __cartcontact::Scalar>::constant(0.004166666666666667f64)
            + (<T as __cartcontact::Scalar>::constant(-0.00034285714285714285f64)
                + (<T as __cartcontact::Scalar>::constant(1.6666666666666667e-5f64))
                    * __a) * __a;
        __cartcontact::Steepness {
            power: __cartcontact::integer_power(__a, 6),
            value: __value,
            excess: <T as __cartcontact::Scalar>::constant(0.0f64),
            first: <T as __cartcontact::Scalar>::constant(187.5f64)
                + (<T as __cartcontact::Scalar>::constant(-18.0f64) + __a) * __a,
            half_second: (<T as __cartcontact::Scalar>::constant(3515625.0f64)
                + (<T as __cartcontact::Scalar>::constant(-405000.0f64)) * __a)
                + (<T as __cartcontact::Scalar>::constant(26250.0f64)) * (__a * __a),
            per_unit: <T as __cartcontact::Scalar>::constant(7500.0f64),
        }
    }
    #[automatically_derived]
    impl<T> __cartcontact::GapProfile<T> for MixedSign
    where
        T: __cartcontact::Scalar,
    {
        #[inline]
        fn gap(&self, __r: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { __cartcontact::precise_sum:: < _, _, __FUSED, _ > (__r,
                2u32, [< T as __cartcontact::Scalar > ::constant(0.05f64), < T as
                __cartcontact::Scalar > ::constant(- 0.004f64), < T as
                __cartcontact::Scalar > ::constant(0.0002f64)]) }
            )
        }
        #[inline]
        fn approach(&self, __a: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { __cartcontact::precise_sum:: < _, _, __FUSED, _ > (__a,
                2u32, [< T as __cartcontact::Scalar > ::constant(0.025f64), < T as
                __cartcontact::Scalar > ::constant(- 0.0016f64), < T as
                __cartcontact::Scalar > ::constant(6.666666666666667e-5f64)]) }
            )
        }
        #[inline]
        fn approach_slope(&self, __a: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { __cartcontact::precise_sum:: < _, _, __FUSED, _ > (__a,
                1u32, [< T as __cartcontact::Scalar > ::constant(0.05f64), < T as
                __cartcontact::Scalar > ::constant(- 0.0048f64), < T as
                __cartcontact::Scalar > ::constant(0.0002666666666666667f64)]) }
            )
        }
        #[inline]
        fn load_integral(&self, __a: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { __cartcontact::precise_sum:: < _, _, __FUSED, _ > (__a,
                6u32, [< T as __cartcontact::Scalar >
                ::constant(0.004166666666666667f64), < T as __cartcontact::Scalar >
                ::constant(- 0.00034285714285714285f64), < T as __cartcontact::Scalar >
                ::constant(1.6666666666666667e-5f64)]) }
            )
        }
        #[inline]
        fn log_kernel(&self, __x: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { __cartcontact::precise_sum:: < _, _, __FUSED, _ > (__x,
                4u32, [< T as __cartcontact::Scalar > ::constant(0.003125f64), < T as
                __cartcontact::Scalar > ::constant(- 0.00016f64), < T as
                __cartcontact::Scalar > ::constant(5.555555555555556e-6f64)]) }
            )
        }
        #[inline]
        fn excess_on_axis(&self, __a: T) -> T {
            (<T as __cartcontact::Scalar>::constant(0.0010416666666666667f64)
                + (<T as __cartcontact::Scalar>::constant(-6.857142857142857e-5f64)
                    + (<T as __cartcontact::Scalar>::constant(2.777777777777778e-6f64))
                        * __a) * __a) * __a * __a * __a * __a * __a * __a
        }
        #[inline]
        fn quick_approach(&self, __a: T) -> T {
            (<T as __cartcontact::Scalar>::constant(0.025f64)
                + (<T as __cartcontact::Scalar>::constant(-0.0016f64)
                    + (<T as __cartcontact::Scalar>::constant(6.666666666666667e-5f64))
                        * __a) * __a) * __a * __a
        }
        #[inline]
        fn quick_approach_slope(&self, __a: T) -> T {
            (<T as __cartcontact::Scalar>::constant(0.05f64)
                + (<T as __cartcontact::Scalar>::constant(-0.0048f64)
                    + (<T as __cartcontact::Scalar>::constant(0.0002666666666666667f64))
                        * __a) * __a) * __a
        }
        #[inline]
        fn quick_load_integral(&self, __a: T) -> T {
            (<T as __cartcontact::Scalar>::constant(0.004166666666666667f64)
                + (<T as __cartcontact::Scalar>::constant(-0.00034285714285714285f64)
                    + (<T as __cartcontact::Scalar>::constant(1.6666666666666667e-5f64))
                        * __a) * __a) * __a * __a * __a * __a * __a * __a
        }
        #[inline]
        fn pressure_kernel(&self, __a: T, __r: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { __cartcontact::whole_pressure_kernel:: < _, _, __FUSED, _ >
                (__a, __r, [< T as __cartcontact::Scalar > ::constant(- 0.0f64), < T as
                __cartcontact::Scalar > ::constant(0.0015625f64), < T as
                __cartcontact::Scalar > ::constant(- 8e-5f64), < T as
                __cartcontact::Scalar > ::constant(2.777777777777778e-6f64)]) }
            )
        }
        #[inline(always)]
        fn quick_pressure_kernel(&self, __a: T, __r: T) -> T {
            __cartcontact::quick_whole_pressure_kernel(
                __a,
                __r,
                [
                    <T as __cartcontact::Scalar>::constant(-0.0f64),
                    <T as __cartcontact::Scalar>::constant(0.0015625f64),
                    <T as __cartcontact::Scalar>::constant(-8e-5f64),
                    <T as __cartcontact::Scalar>::constant(2.777777777777778e-6f64),
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
                    __cartcontact::invert(
                        __load_integral,
                        __limit,
                        [
                            (
                                <T as __cartcontact::Scalar>::constant(0.05f64),
                                <T as __cartcontact::Scalar>::constant(2.0f64),
                            ),
                            (
                                <T as __cartcontact::Scalar>::constant(-0.004f64),
                                <T as __cartcontact::Scalar>::constant(3.0f64),
                            ),
                            (
                                <T as __cartcontact::Scalar>::constant(0.0002f64),
                                <T as __cartcontact::Scalar>::constant(4.0f64),
                            ),
                        ],
                        true,
                        |__a| {
                            let __x = __a;
                            let (__value, __slope) = __cartcontact::value_and_slope(
                                __x,
                                [
                                    <T as __cartcontact::Scalar>::constant(
                                        0.004166666666666667f64,
                                    ),
                                    <T as __cartcontact::Scalar>::constant(
                                        -0.00034285714285714285f64,
                                    ),
                                    <T as __cartcontact::Scalar>::constant(
                                        1.6666666666666667e-5f64,
                                    ),
                                ],
                            );
                            let __log_slope = <T as __cartcontact::Scalar>::constant(
                                6.0f64,
                            ) * __value
                                + <T as __cartcontact::Scalar>::constant(1.0f64) * __x
                                    * __slope;
                            (
                                __value * __x * __x * __x * __x * __x * __x,
                                __log_slope * __x * __x * __x * __x * __x * __x,
                            )
                        },
                        |__a| {
                            __cartcontact::in_double_words!(
                                __FUSED => { __cartcontact::precise_sum:: < _, _, __FUSED, _
                                > (__a, 6u32, [< T as __cartcontact::Scalar >
                                ::constant(0.004166666666666667f64), < T as
                                __cartcontact::Scalar > ::constant(-
                                0.00034285714285714285f64), < T as __cartcontact::Scalar >
                                ::constant(1.6666666666666667e-5f64)]) }
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
                __cartcontact::nowhere,
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
                * __cartcontact::divided_difference(
                    __a,
                    __s,
                    __cartcontact::constants::<
                        T,
                        _,
                    >([
                        -0.0,
                        -0.0,
                        -0.0,
                        -0.0,
                        -0.0,
                        -0.0,
                        0.004166666666666667,
                        -0.00034285714285714285,
                        1.6666666666666667e-5,
                    ]),
                )
        }
        #[inline]
        fn max_radius(&self) -> T {
            <T as __cartcontact::Scalar>::constant(20.0f64)
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
            false
        }
    }
    #[allow(unreachable_pub, reason = "a program need not ask for them")]
    impl MixedSign {
        /// The terms of the gap Σ C rⁿ as pairs (C, n), in ascending order of their exponents.
        pub const TERMS: [(::core::primitive::f64, ::core::primitive::f64); 3usize] = [
            (0.05f64, 2.0f64),
            (-0.004f64, 3.0f64),
            (0.0002f64, 4.0f64),
        ];
        /// The largest contact radius that the geometry is proved for, in mm; infinity if there is no limit.
        pub const MAX_RADIUS: ::core::primitive::f64 = 20.0f64;
    }
};
