///
/// # Derived from the gap profile
///
/// Lengths in mm; equation numbers of I. Argatov, Mech. Res. Commun. 38 (2011) 29–33, doi 10.1016/j.mechrescom.2010.11.006.
///
/// ```text
/// gap, mm               Φ(r)   = 0.01 r^1.5 + 0.003 r^2.5
/// approach, mm          δ₀(a)  = (1/175) a^1.5 + (1/750) a^2.5    (10)
/// slope of the approach δ₀′(a) = (3/350) a^0.5 + (1/300) a^1.5
/// load integral, mm⁵    J(a)   = (3/3850) a^5.5 + (1/3900) a^6.5    (14)
/// log kernel, mm³       L(x)   = (1/1225) x^3.5 + (1/6750) x^4.5    (28)
/// pressure kernel, mm³  G(a,r) = (1/2450) a^3.5 K(1.5, r/a) + (1/13500) a^4.5 K(2.5, r/a), K(n,q) = n − (n+2) q² + 2 qⁿ⁺²    (28)
/// contact radius, mm    the a with (π m/4) J(a) = F(t) + χ ∫F dτ    (14)
/// ```
///
/// Admissible for every contact radius: all coefficients are positive.
///
/// The contact radius takes one step from a table of 4096 bytes where J is between 1.5e-11 and 2.7e8; elsewhere it is iterated.
///
struct Halves;
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
            first: -144,
            count: 256,
        },
        single: __cartcontact::Quarters {
            first: -144,
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
        let (__power, __lost) = __cartcontact::power_of_half_digits(__a, 11);
        let __value = <T as __cartcontact::Scalar>::constant(0.0007792207792207792f64)
            + (<T as __cartcontact::Scalar>::constant(0.0002564102564102564f64)) * __s;
        __cartcontact::Steepness {
            power: __power,
            value: __value,
            excess: __lost * __value,
            first: <T as __cartcontact::Scalar>::constant(2.5714285714285716f64) + __s,
            half_second: <T as __cartcontact::Scalar>::constant(3857.1428571428573f64)
                + (<T as __cartcontact::Scalar>::constant(1800.0f64)) * __s,
            per_unit: <T as __cartcontact::Scalar>::constant(300.0f64),
        }
    }
    #[automatically_derived]
    impl<T> __cartcontact::GapProfile<T> for Halves
    where
        T: __cartcontact::Scalar,
    {
        #[inline]
        fn gap(&self, __r: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { __cartcontact::power_sum:: < _, _, _, __FUSED > (__r, [(< T
                as __cartcontact::Scalar > ::constant(0.01f64),
                __cartcontact::Exponent::in_parts(1, 0.5, 0.0)), (< T as
                __cartcontact::Scalar > ::constant(0.003f64),
                __cartcontact::Exponent::in_parts(2, 0.5, 0.0))]) }
            )
        }
        #[inline]
        fn approach(&self, __a: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { __cartcontact::power_sum:: < _, _, _, __FUSED > (__a, [(< T
                as __cartcontact::Scalar > ::constant(0.005714285714285714f64),
                __cartcontact::Exponent::in_parts(1, 0.5, 0.0)), (< T as
                __cartcontact::Scalar > ::constant(0.0013333333333333333f64),
                __cartcontact::Exponent::in_parts(2, 0.5, 0.0))]) }
            )
        }
        #[inline]
        fn approach_slope(&self, __a: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { __cartcontact::power_sum:: < _, _, _, __FUSED > (__a, [(< T
                as __cartcontact::Scalar > ::constant(0.008571428571428572f64),
                __cartcontact::Exponent::in_parts(0, 0.5, 0.0)), (< T as
                __cartcontact::Scalar > ::constant(0.0033333333333333335f64),
                __cartcontact::Exponent::in_parts(1, 0.5, 0.0))]) }
            )
        }
        #[inline]
        fn load_integral(&self, __a: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { __cartcontact::power_sum:: < _, _, _, __FUSED > (__a, [(< T
                as __cartcontact::Scalar > ::constant(0.0007792207792207792f64),
                __cartcontact::Exponent::in_parts(5, 0.5, 0.0)), (< T as
                __cartcontact::Scalar > ::constant(0.0002564102564102564f64),
                __cartcontact::Exponent::in_parts(6, 0.5, 0.0))]) }
            )
        }
        #[inline]
        fn log_kernel(&self, __x: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { __cartcontact::power_sum:: < _, _, _, __FUSED > (__x, [(< T
                as __cartcontact::Scalar > ::constant(0.0008163265306122449f64),
                __cartcontact::Exponent::in_parts(3, 0.5, 0.0)), (< T as
                __cartcontact::Scalar > ::constant(0.00014814814814814815f64),
                __cartcontact::Exponent::in_parts(4, 0.5, 0.0))]) }
            )
        }
        #[inline]
        fn excess_on_axis(&self, __a: T) -> T {
            let __of_quarter2 = {
                (<T as __cartcontact::Scalar>::constant(0.00022263450834879406f64)
                    + (<T as __cartcontact::Scalar>::constant(5.698005698005698e-5f64))
                        * __a) * __a * __a * __a * __a * __a
            };
            __cartcontact::quarter_root::<_, 2>(__a) * __of_quarter2
        }
        #[inline]
        fn quick_approach(&self, __a: T) -> T {
            let __of_quarter2 = {
                (<T as __cartcontact::Scalar>::constant(0.005714285714285714f64)
                    + (<T as __cartcontact::Scalar>::constant(0.0013333333333333333f64))
                        * __a) * __a
            };
            __cartcontact::quarter_root::<_, 2>(__a) * __of_quarter2
        }
        #[inline]
        fn quick_approach_slope(&self, __a: T) -> T {
            let __of_quarter2 = {
                (<T as __cartcontact::Scalar>::constant(0.008571428571428572f64)
                    + (<T as __cartcontact::Scalar>::constant(0.0033333333333333335f64))
                        * __a)
            };
            __cartcontact::quarter_root::<_, 2>(__a) * __of_quarter2
        }
        #[inline]
        fn quick_load_integral(&self, __a: T) -> T {
            let __of_quarter2 = {
                (<T as __cartcontact::Scalar>::constant(0.0007792207792207792f64)
                    + (<T as __cartcontact::Scalar>::constant(0.0002564102564102564f64))
                        * __a) * __a * __a * __a * __a * __a
            };
            __cartcontact::quarter_root::<_, 2>(__a) * __of_quarter2
        }
        #[inline]
        fn pressure_kernel(&self, __a: T, __r: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { __cartcontact::pressure_kernel:: < _, _, _, __FUSED > (__a,
                __r, [(< T as __cartcontact::Scalar > ::constant(0.01f64),
                __cartcontact::Exponent::in_parts(1, 0.5, 0.0)), (< T as
                __cartcontact::Scalar > ::constant(0.003f64),
                __cartcontact::Exponent::in_parts(2, 0.5, 0.0))]) }
            )
        }
        #[inline(always)]
        fn quick_pressure_kernel(&self, __a: T, __r: T) -> T {
            __cartcontact::quick_pressure_kernel_in_root::<
                _,
                2,
                5,
                _,
            >(
                __a,
                __r,
                [
                    (
                        <T as __cartcontact::Scalar>::constant(
                            0.00020408163265306123f64,
                        ),
                        3,
                    ),
                    (<T as __cartcontact::Scalar>::constant(3.7037037037037037e-5f64), 5),
                ],
                [
                    (
                        <T as __cartcontact::Scalar>::constant(0.01f64),
                        __cartcontact::Exponent::in_parts(1, 0.5, 0.0),
                    ),
                    (
                        <T as __cartcontact::Scalar>::constant(0.003f64),
                        __cartcontact::Exponent::in_parts(2, 0.5, 0.0),
                    ),
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
                    __cartcontact::RootOf::<_, 2>(__cartcontact::OwnUnits),
                    |__a| __steepness(__a, []),
                ),
                move || {
                    __cartcontact::found_or(
                        __cartcontact::radius_of_real_powers(
                            __load_integral,
                            __limit,
                            ::core::iter::IntoIterator::into_iter([
                                (
                                    <T as __cartcontact::Scalar>::constant(
                                        0.0007792207792207792f64,
                                    ),
                                    __cartcontact::Exponent::in_parts(5, 0.5, 0.0),
                                ),
                                (
                                    <T as __cartcontact::Scalar>::constant(
                                        0.0002564102564102564f64,
                                    ),
                                    __cartcontact::Exponent::in_parts(6, 0.5, 0.0),
                                ),
                            ]),
                            |__a, __scale| __cartcontact::plain_power_sum_steepness(
                                __a,
                                __scale,
                                [
                                    (
                                        <T as __cartcontact::Scalar>::constant(
                                            0.0007792207792207792f64,
                                        ),
                                        __cartcontact::Exponent::in_parts(5, 0.5, 0.0),
                                    ),
                                    (
                                        <T as __cartcontact::Scalar>::constant(
                                            0.0002564102564102564f64,
                                        ),
                                        __cartcontact::Exponent::in_parts(6, 0.5, 0.0),
                                    ),
                                ],
                            ),
                            |__a, __scale| __cartcontact::scaled_power_sum_steepness(
                                __a,
                                __scale,
                                [
                                    (
                                        <T as __cartcontact::Scalar>::constant(
                                            0.0007792207792207792f64,
                                        ),
                                        __cartcontact::Exponent::in_parts(5, 0.5, 0.0),
                                    ),
                                    (
                                        <T as __cartcontact::Scalar>::constant(
                                            0.0002564102564102564f64,
                                        ),
                                        __cartcontact::Exponent::in_parts(6, 0.5, 0.0),
                                    ),
                                ],
                            ),
                        ),
                        move || {
                            __cartcontact::invert(
                                __load_integral,
                                __limit,
                                [
                                    (
                                        <T as __cartcontact::Scalar>::constant(0.01f64),
                                        <T as __cartcontact::Scalar>::constant(1.5f64),
                                    ),
                                    (
                                        <T as __cartcontact::Scalar>::constant(0.003f64),
                                        <T as __cartcontact::Scalar>::constant(2.5f64),
                                    ),
                                ],
                                false,
                                |__a| {
                                    __cartcontact::power_sum_and_log_slope(
                                        __a,
                                        [
                                            (
                                                <T as __cartcontact::Scalar>::constant(
                                                    0.0007792207792207792f64,
                                                ),
                                                __cartcontact::Exponent::in_parts(5, 0.5, 0.0),
                                            ),
                                            (
                                                <T as __cartcontact::Scalar>::constant(
                                                    0.0002564102564102564f64,
                                                ),
                                                __cartcontact::Exponent::in_parts(6, 0.5, 0.0),
                                            ),
                                        ],
                                    )
                                },
                                |__a| {
                                    __cartcontact::in_double_words!(
                                        __FUSED => { __cartcontact::power_sum:: < _, _, _, __FUSED >
                                        (__a, [(< T as __cartcontact::Scalar >
                                        ::constant(0.0007792207792207792f64),
                                        __cartcontact::Exponent::in_parts(5, 0.5, 0.0)), (< T as
                                        __cartcontact::Scalar >
                                        ::constant(0.0002564102564102564f64),
                                        __cartcontact::Exponent::in_parts(6, 0.5, 0.0))]) }
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
                __cartcontact::RootOf::<_, 2>(__cartcontact::OwnUnits),
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
            __cartcontact::drop_by_roots(
                __a,
                __depth,
                (
                    [],
                    [],
                    [
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(0.0007792207792207792f64),
                        <T as __cartcontact::Scalar>::constant(0.0002564102564102564f64),
                    ],
                    [],
                ),
                [
                    (
                        <T as __cartcontact::Scalar>::constant(0.0007792207792207792f64),
                        __cartcontact::Exponent::in_parts(5, 0.5, 0.0),
                    ),
                    (
                        <T as __cartcontact::Scalar>::constant(0.0002564102564102564f64),
                        __cartcontact::Exponent::in_parts(6, 0.5, 0.0),
                    ),
                ],
            )
        }
        #[inline(always)]
        fn fill_slopes_and_drops(
            &self,
            __a: T,
            __places: (&[T], &[T]),
            __values: (&mut [T], &mut [T]),
        ) {
            __cartcontact::fill_by_roots(
                self,
                __a,
                __places,
                __values,
                |__r| {
                    let __of_quarter2 = {
                        (<T as __cartcontact::Scalar>::constant(0.008571428571428572f64)
                            + (<T as __cartcontact::Scalar>::constant(
                                0.0033333333333333335f64,
                            )) * __r)
                    };
                    __cartcontact::quarter_root::<_, 2>(__r) * __of_quarter2
                },
                (
                    [],
                    [],
                    [
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(0.0007792207792207792f64),
                        <T as __cartcontact::Scalar>::constant(0.0002564102564102564f64),
                    ],
                    [],
                ),
            )
        }
        #[inline]
        fn max_radius(&self) -> T {
            <T as __cartcontact::Scalar>::infinity()
        }
        #[inline]
        fn highest_exponent(&self) -> T {
            <T as __cartcontact::Scalar>::constant(2.5f64)
        }
        #[inline]
        fn is_smooth_at_centre(&self) -> ::core::primitive::bool {
            false
        }
        #[inline]
        fn has_only_positive_terms(&self) -> ::core::primitive::bool {
            true
        }
    }
    #[allow(unreachable_pub, reason = "a program need not ask for them")]
    impl Halves {
        /// The terms of the gap Σ C rⁿ as pairs (C, n), in ascending order of their exponents.
        pub const TERMS: [(::core::primitive::f64, ::core::primitive::f64); 2usize] = [
            (0.01f64, 1.5f64),
            (0.003f64, 2.5f64),
        ];
        /// The largest contact radius that the geometry is proved for, in mm; infinity if there is no limit.
        pub const MAX_RADIUS: ::core::primitive::f64 = ::core::primitive::f64::INFINITY;
    }
};
