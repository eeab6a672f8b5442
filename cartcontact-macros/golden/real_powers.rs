///
/// # Derived from the gap profile
///
/// Lengths in mm; equation numbers of I. Argatov, Mech. Res. Commun. 38 (2011) 29–33, doi 10.1016/j.mechrescom.2010.11.006.
///
/// ```text
/// gap, mm               Φ(r)   = 0.01 r^1.5 + 0.002 r^3.25
/// approach, mm          δ₀(a)  = (1/175) a^1.5 + (2/2625) a^3.25    (10)
/// slope of the approach δ₀′(a) = (3/350) a^0.5 + (13/5250) a^2.25
/// load integral, mm⁵    J(a)   = (3/3850) a^5.5 + (13/76125) a^7.25    (14)
/// log kernel, mm³       L(x)   = (1/1225) x^3.5 + (4/55125) x^5.25    (28)
/// pressure kernel, mm³  G(a,r) = (1/2450) a^3.5 K(1.5, r/a) + (2/55125) a^5.25 K(3.25, r/a), K(n,q) = n − (n+2) q² + 2 qⁿ⁺²    (28)
/// contact radius, mm    the a with (π m/4) J(a) = F(t) + χ ∫F dτ    (14)
/// ```
///
/// Admissible for every contact radius: all coefficients are positive.
///
/// The contact radius is a polynomial from a table of 24576 bytes, in single precision of 8192, where J is between 5.7e-14 and 1.0e6; elsewhere it is iterated.
///
struct RealPowers;
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
    static __CURVES: __cartcontact::DoubleCurves = __cartcontact::Table {
        quarters: __cartcontact::Quarters {
            first: -176,
            count: 256,
        },
        single: __cartcontact::Quarters {
            first: -176,
            count: 0,
        },
        rows: __cartcontact::Rows(
*b"...",
        ),
    };
    static __CURVES_OF_SINGLE: __cartcontact::SingleCurves = __cartcontact::Table {
        quarters: __cartcontact::Quarters {
            first: -176,
            count: 256,
        },
        single: __cartcontact::Quarters {
            first: -176,
            count: 256,
        },
        rows: __cartcontact::Rows(
*b"...",
        ),
    };
    #[automatically_derived]
    impl<T> __cartcontact::GapProfile<T> for RealPowers
    where
        T: __cartcontact::Scalar,
    {
        #[inline]
        fn gap(&self, __r: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { __cartcontact::power_sum:: < _, _, _, __FUSED > (__r, [(< T
                as __cartcontact::Scalar > ::constant(0.01f64),
                __cartcontact::Exponent::in_parts(1, 0.5, 0.0)), (< T as
                __cartcontact::Scalar > ::constant(0.002f64),
                __cartcontact::Exponent::in_parts(3, 0.25, 0.0))]) }
            )
        }
        #[inline]
        fn approach(&self, __a: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { __cartcontact::power_sum:: < _, _, _, __FUSED > (__a, [(< T
                as __cartcontact::Scalar > ::constant(0.005714285714285714f64),
                __cartcontact::Exponent::in_parts(1, 0.5, 0.0)), (< T as
                __cartcontact::Scalar > ::constant(0.0007619047619047619f64),
                __cartcontact::Exponent::in_parts(3, 0.25, 0.0))]) }
            )
        }
        #[inline]
        fn approach_slope(&self, __a: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { __cartcontact::power_sum:: < _, _, _, __FUSED > (__a, [(< T
                as __cartcontact::Scalar > ::constant(0.008571428571428572f64),
                __cartcontact::Exponent::in_parts(0, 0.5, 0.0)), (< T as
                __cartcontact::Scalar > ::constant(0.002476190476190476f64),
                __cartcontact::Exponent::in_parts(2, 0.25, 0.0))]) }
            )
        }
        #[inline]
        fn load_integral(&self, __a: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { __cartcontact::power_sum:: < _, _, _, __FUSED > (__a, [(< T
                as __cartcontact::Scalar > ::constant(0.0007792207792207792f64),
                __cartcontact::Exponent::in_parts(5, 0.5, 0.0)), (< T as
                __cartcontact::Scalar > ::constant(0.00017077175697865354f64),
                __cartcontact::Exponent::in_parts(7, 0.25, 0.0))]) }
            )
        }
        #[inline]
        fn log_kernel(&self, __x: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { __cartcontact::power_sum:: < _, _, _, __FUSED > (__x, [(< T
                as __cartcontact::Scalar > ::constant(0.0008163265306122449f64),
                __cartcontact::Exponent::in_parts(3, 0.5, 0.0)), (< T as
                __cartcontact::Scalar > ::constant(7.256235827664399e-5f64),
                __cartcontact::Exponent::in_parts(5, 0.25, 0.0))]) }
            )
        }
        #[inline]
        fn excess_on_axis(&self, __a: T) -> T {
            let __of_quarter1 = {
                let __s = __a * __a;
                (<T as __cartcontact::Scalar>::constant(3.252795371021972e-5f64)) * __s
                    * __s * __s * __a
            };
            let __of_quarter2 = {
                let __s = __a * __a;
                (<T as __cartcontact::Scalar>::constant(0.00022263450834879406f64)) * __s
                    * __s * __a
            };
            __cartcontact::quarter_root::<_, 1>(__a) * __of_quarter1
                + __cartcontact::quarter_root::<_, 2>(__a) * __of_quarter2
        }
        #[inline]
        fn quick_approach(&self, __a: T) -> T {
            let __of_quarter1 = {
                let __s = __a * __a;
                (<T as __cartcontact::Scalar>::constant(0.0007619047619047619f64)) * __s
                    * __a
            };
            let __of_quarter2 = {
                (<T as __cartcontact::Scalar>::constant(0.005714285714285714f64)) * __a
            };
            __cartcontact::quarter_root::<_, 1>(__a) * __of_quarter1
                + __cartcontact::quarter_root::<_, 2>(__a) * __of_quarter2
        }
        #[inline]
        fn quick_approach_slope(&self, __a: T) -> T {
            let __of_quarter1 = {
                let __s = __a * __a;
                (<T as __cartcontact::Scalar>::constant(0.002476190476190476f64)) * __s
            };
            let __of_quarter2 = {
                (<T as __cartcontact::Scalar>::constant(0.008571428571428572f64))
            };
            __cartcontact::quarter_root::<_, 1>(__a) * __of_quarter1
                + __cartcontact::quarter_root::<_, 2>(__a) * __of_quarter2
        }
        #[inline]
        fn quick_load_integral(&self, __a: T) -> T {
            let __of_quarter1 = {
                let __s = __a * __a;
                (<T as __cartcontact::Scalar>::constant(0.00017077175697865354f64)) * __s
                    * __s * __s * __a
            };
            let __of_quarter2 = {
                let __s = __a * __a;
                (<T as __cartcontact::Scalar>::constant(0.0007792207792207792f64)) * __s
                    * __s * __a
            };
            __cartcontact::quarter_root::<_, 1>(__a) * __of_quarter1
                + __cartcontact::quarter_root::<_, 2>(__a) * __of_quarter2
        }
        #[inline]
        fn pressure_kernel(&self, __a: T, __r: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { __cartcontact::pressure_kernel:: < _, _, _, __FUSED > (__a,
                __r, [(< T as __cartcontact::Scalar > ::constant(0.01f64),
                __cartcontact::Exponent::in_parts(1, 0.5, 0.0)), (< T as
                __cartcontact::Scalar > ::constant(0.002f64),
                __cartcontact::Exponent::in_parts(3, 0.25, 0.0))]) }
            )
        }
        #[inline(always)]
        fn quick_pressure_kernel(&self, __a: T, __r: T) -> T {
            __cartcontact::quick_pressure_kernel_in_root::<
                _,
                4,
                13,
                _,
            >(
                __a,
                __r,
                [
                    (
                        <T as __cartcontact::Scalar>::constant(
                            0.00010204081632653062f64,
                        ),
                        6,
                    ),
                    (<T as __cartcontact::Scalar>::constant(9.070294784580499e-6f64), 13),
                ],
                [
                    (
                        <T as __cartcontact::Scalar>::constant(0.01f64),
                        __cartcontact::Exponent::in_parts(1, 0.5, 0.0),
                    ),
                    (
                        <T as __cartcontact::Scalar>::constant(0.002f64),
                        __cartcontact::Exponent::in_parts(3, 0.25, 0.0),
                    ),
                ],
            )
        }
        #[inline(always)]
        fn radius_within(
            &self,
            __load_integral: T,
            __limit: T,
        ) -> ::core::result::Result<T, __cartcontact::RadiusError> {
            __cartcontact::found_or(
                __cartcontact::Curves::radius(
                    __cartcontact::Curves {
                        double: &__CURVES,
                        single: &__CURVES_OF_SINGLE,
                    },
                    __load_integral,
                    __limit,
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
                                        0.00017077175697865354f64,
                                    ),
                                    __cartcontact::Exponent::in_parts(7, 0.25, 0.0),
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
                                            0.00017077175697865354f64,
                                        ),
                                        __cartcontact::Exponent::in_parts(7, 0.25, 0.0),
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
                                            0.00017077175697865354f64,
                                        ),
                                        __cartcontact::Exponent::in_parts(7, 0.25, 0.0),
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
                                        <T as __cartcontact::Scalar>::constant(0.002f64),
                                        <T as __cartcontact::Scalar>::constant(3.25f64),
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
                                                    0.00017077175697865354f64,
                                                ),
                                                __cartcontact::Exponent::in_parts(7, 0.25, 0.0),
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
                                        ::constant(0.00017077175697865354f64),
                                        __cartcontact::Exponent::in_parts(7, 0.25, 0.0))]) }
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
            __cartcontact::Curves::radii(
                __cartcontact::Curves {
                    double: &__CURVES,
                    single: &__CURVES_OF_SINGLE,
                },
                (__load_integrals, __radii),
                __limit,
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
                    [
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(0.00017077175697865354f64),
                    ],
                    [
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(0.0007792207792207792f64),
                    ],
                    [],
                ),
                [
                    (
                        <T as __cartcontact::Scalar>::constant(0.0007792207792207792f64),
                        __cartcontact::Exponent::in_parts(5, 0.5, 0.0),
                    ),
                    (
                        <T as __cartcontact::Scalar>::constant(
                            0.00017077175697865354f64,
                        ),
                        __cartcontact::Exponent::in_parts(7, 0.25, 0.0),
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
                    let __of_quarter1 = {
                        let __s = __r * __r;
                        (<T as __cartcontact::Scalar>::constant(0.002476190476190476f64))
                            * __s
                    };
                    let __of_quarter2 = {
                        (<T as __cartcontact::Scalar>::constant(0.008571428571428572f64))
                    };
                    __cartcontact::quarter_root::<_, 1>(__r) * __of_quarter1
                        + __cartcontact::quarter_root::<_, 2>(__r) * __of_quarter2
                },
                (
                    [],
                    [
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(0.00017077175697865354f64),
                    ],
                    [
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(0.0007792207792207792f64),
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
            <T as __cartcontact::Scalar>::constant(3.25f64)
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
