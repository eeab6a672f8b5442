///
/// # Derived from the gap profile
///
/// Lengths in mm; equation numbers of I. Argatov, Mech. Res. Commun. 38 (2011) 29–33, doi 10.1016/j.mechrescom.2010.11.006.
///
/// ```text
/// gap, mm               Φ(r)   = c r^2.5 + d r⁴ + e r⁵
/// approach, mm          δ₀(a)  = (4·c/9) a^2.5 + (d/3) a⁴ + (2·e/7) a⁵    (10)
/// slope of the approach δ₀′(a) = (10·c/9) a^1.5 + (4·d/3) a³ + (10·e/7) a⁴
/// load integral, mm⁵    J(a)   = (10·c/117) a^6.5 + (d/12) a⁸ + (5·e/63) a⁹    (14)
/// log kernel, mm³       L(x)   = (4·c/81) x^4.5 + (d/36) x⁶ + (e/49) x⁷    (28)
/// pressure kernel, mm³  G(a,r) = (2·c/81) a^4.5 K(2.5, r/a) + (d/72) a⁶ K(4, r/a) + (e/98) a⁷ K(5, r/a), K(n,q) = n − (n+2) q² + 2 qⁿ⁺²    (28)
/// contact radius, mm    the a with (π m/4) J(a) = F(t) + χ ∫F dτ    (14)
/// ```
///
/// Admissibility depends on the fields and is checked when a `Contact` is made.
///
struct Blunt {
    c: f64,
    d: f64,
    e: f64,
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
    #[inline]
    fn __coefficients<T>(__profile: &Blunt) -> [T; 3usize]
    where
        T: __cartcontact::Scalar,
    {
        let __field_c = <T as __cartcontact::Scalar>::constant(__profile.c);
        let __field_d = <T as __cartcontact::Scalar>::constant(__profile.d);
        let __field_e = <T as __cartcontact::Scalar>::constant(__profile.e);
        [__field_c, __field_d, __field_e]
    }
    #[inline(always)]
    fn __precise_coefficients<T, const __FUSED: ::core::primitive::bool>(
        __profile: &Blunt,
    ) -> [__cartcontact::Precise<T, __FUSED>; 3usize]
    where
        T: __cartcontact::Scalar,
    {
        let __field_c = <__cartcontact::Precise<T, __FUSED>>::constant(__profile.c, 0.0);
        let __field_d = <__cartcontact::Precise<T, __FUSED>>::constant(__profile.d, 0.0);
        let __field_e = <__cartcontact::Precise<T, __FUSED>>::constant(__profile.e, 0.0);
        [__field_c, __field_d, __field_e]
    }
    #[inline(always)]
    fn __quick_steepness<T: __cartcontact::Scalar>(
        __a: T,
        [__j0,
        __j1,
        __j2,
        ]: [T; 3usize],
    ) -> __cartcontact::Steepness<T> {
        let __value = (__j0 + (__j1) * __a * __a * __a)
            + (__j2) * (__cartcontact::integer_power(__a, 5));
        __cartcontact::Steepness {
            power: __cartcontact::integer_power(__a, 13),
            value: __value,
            excess: <T as __cartcontact::Scalar>::constant(0.0f64),
            first: <T as __cartcontact::Scalar>::constant(13.0f64) * __j0
                + (<T as __cartcontact::Scalar>::constant(16.0f64) * __j1
                    + (<T as __cartcontact::Scalar>::constant(18.0f64) * __j2) * __a
                        * __a) * __a * __a * __a,
            half_second: <T as __cartcontact::Scalar>::constant(78.0f64) * __j0
                + (<T as __cartcontact::Scalar>::constant(120.0f64) * __j1
                    + (<T as __cartcontact::Scalar>::constant(153.0f64) * __j2) * __a
                        * __a) * __a * __a * __a,
            per_unit: <T as __cartcontact::Scalar>::constant(1.0f64),
        }
    }
    #[inline(always)]
    fn __last_steepness<T: __cartcontact::Scalar>(
        __a: T,
        [__j0,
        __j1,
        __j2,
        ]: [T; 3usize],
    ) -> __cartcontact::Steepness<T> {
        __quick_steepness(__a, [__j0, __j1, __j2]).with_exact_power::<13>(__a)
    }
    #[automatically_derived]
    impl<T> __cartcontact::GapProfile<T> for Blunt
    where
        T: __cartcontact::Scalar,
    {
        #[inline]
        fn gap(&self, __r: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { let [__c0, __c1, __c2] : [T; 3usize] = __coefficients(self);
                __cartcontact::power_sum:: < _, _, _, __FUSED > (__r, [(__c0,
                __cartcontact::Exponent::in_parts(2, 0.5, 0.0)), (__c1,
                __cartcontact::Exponent::whole(4)), (__c2,
                __cartcontact::Exponent::whole(5))]) }
            )
        }
        #[inline]
        fn approach(&self, __a: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { let [__c0, __c1, __c2] : [__cartcontact::Precise < T,
                __FUSED >; 3usize] = __precise_coefficients(self);
                __cartcontact::power_sum:: < _, _, _, __FUSED > (__a, [(__c0 * <
                __cartcontact::Precise < T, __FUSED > > ::constant(0.4444444444444444,
                2.4671622769447922e-17), __cartcontact::Exponent::in_parts(2, 0.5, 0.0)),
                (__c1 * < __cartcontact::Precise < T, __FUSED > >
                ::constant(0.3333333333333333, 1.850371707708594e-17),
                __cartcontact::Exponent::whole(4)), (__c2 * < __cartcontact::Precise < T,
                __FUSED > > ::constant(0.2857142857142857, 1.586032892321652e-17),
                __cartcontact::Exponent::whole(5))]) }
            )
        }
        #[inline]
        fn approach_slope(&self, __a: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { let [__c0, __c1, __c2] : [__cartcontact::Precise < T,
                __FUSED >; 3usize] = __precise_coefficients(self);
                __cartcontact::power_sum:: < _, _, _, __FUSED > (__a, [(__c0 * <
                __cartcontact::Precise < T, __FUSED > > ::constant(1.1111111111111112, -
                4.9343245538895844e-17), __cartcontact::Exponent::in_parts(1, 0.5, 0.0)),
                (__c1 * < __cartcontact::Precise < T, __FUSED > >
                ::constant(1.3333333333333333, 7.401486830834377e-17),
                __cartcontact::Exponent::whole(3)), (__c2 * < __cartcontact::Precise < T,
                __FUSED > > ::constant(1.4285714285714286, - 3.172065784643304e-17),
                __cartcontact::Exponent::whole(4))]) }
            )
        }
        #[inline]
        fn load_integral(&self, __a: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { let [__c0, __c1, __c2] : [__cartcontact::Precise < T,
                __FUSED >; 3usize] = __precise_coefficients(self);
                __cartcontact::power_sum:: < _, _, _, __FUSED > (__a, [(__c0 * <
                __cartcontact::Precise < T, __FUSED > > ::constant(0.08547008547008547, -
                1.6605899940974564e-18), __cartcontact::Exponent::in_parts(6, 0.5, 0.0)),
                (__c1 * < __cartcontact::Precise < T, __FUSED > >
                ::constant(0.08333333333333333, 4.625929269271485e-18),
                __cartcontact::Exponent::whole(8)), (__c2 * < __cartcontact::Precise < T,
                __FUSED > > ::constant(0.07936507936507936, 4.4056469231157e-18),
                __cartcontact::Exponent::whole(9))]) }
            )
        }
        #[inline]
        fn log_kernel(&self, __x: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { let [__c0, __c1, __c2] : [__cartcontact::Precise < T,
                __FUSED >; 3usize] = __precise_coefficients(self);
                __cartcontact::power_sum:: < _, _, _, __FUSED > (__x, [(__c0 * <
                __cartcontact::Precise < T, __FUSED > > ::constant(0.04938271604938271,
                2.741291418827547e-18), __cartcontact::Exponent::in_parts(4, 0.5, 0.0)),
                (__c1 * < __cartcontact::Precise < T, __FUSED > >
                ::constant(0.027777777777777776, 1.5419764230904951e-18),
                __cartcontact::Exponent::whole(6)), (__c2 * < __cartcontact::Precise < T,
                __FUSED > > ::constant(0.02040816326530612, 1.6285159162231251e-18),
                __cartcontact::Exponent::whole(7))]) }
            )
        }
        #[inline]
        fn excess_on_axis(&self, __a: T) -> T {
            let [__c0, __c1, __c2]: [T; 3usize] = __coefficients(self);
            let __of_quarter0 = {
                (__c1 * <T as __cartcontact::Scalar>::constant(0.013888888888888888f64)
                    + (__c2
                        * <T as __cartcontact::Scalar>::constant(
                            0.011337868480725623f64,
                        )) * __a) * __a * __a * __a * __a * __a * __a * __a * __a
            };
            let __of_quarter2 = {
                let __s = __a * __a;
                (__c0 * <T as __cartcontact::Scalar>::constant(0.01899335232668566f64))
                    * __s * __s * __s
            };
            __of_quarter0 + __cartcontact::quarter_root::<_, 2>(__a) * __of_quarter2
        }
        #[inline]
        fn quick_approach(&self, __a: T) -> T {
            let [__c0, __c1, __c2]: [T; 3usize] = __coefficients(self);
            let __of_quarter0 = {
                (__c1 * <T as __cartcontact::Scalar>::constant(0.3333333333333333f64)
                    + (__c2
                        * <T as __cartcontact::Scalar>::constant(0.2857142857142857f64))
                        * __a) * __a * __a * __a * __a
            };
            let __of_quarter2 = {
                let __s = __a * __a;
                (__c0 * <T as __cartcontact::Scalar>::constant(0.4444444444444444f64))
                    * __s
            };
            __of_quarter0 + __cartcontact::quarter_root::<_, 2>(__a) * __of_quarter2
        }
        #[inline]
        fn quick_approach_slope(&self, __a: T) -> T {
            let [__c0, __c1, __c2]: [T; 3usize] = __coefficients(self);
            let __of_quarter0 = {
                (__c1 * <T as __cartcontact::Scalar>::constant(1.3333333333333333f64)
                    + (__c2
                        * <T as __cartcontact::Scalar>::constant(1.4285714285714286f64))
                        * __a) * __a * __a * __a
            };
            let __of_quarter2 = {
                (__c0 * <T as __cartcontact::Scalar>::constant(1.1111111111111112f64))
                    * __a
            };
            __of_quarter0 + __cartcontact::quarter_root::<_, 2>(__a) * __of_quarter2
        }
        #[inline]
        fn quick_load_integral(&self, __a: T) -> T {
            let [__c0, __c1, __c2]: [T; 3usize] = __coefficients(self);
            let __of_quarter0 = {
                (__c1 * <T as __cartcontact::Scalar>::constant(0.08333333333333333f64)
                    + (__c2
                        * <T as __cartcontact::Scalar>::constant(0.07936507936507936f64))
                        * __a) * __a * __a * __a * __a * __a * __a * __a * __a
            };
            let __of_quarter2 = {
                let __s = __a * __a;
                (__c0 * <T as __cartcontact::Scalar>::constant(0.08547008547008547f64))
                    * __s * __s * __s
            };
            __of_quarter0 + __cartcontact::quarter_root::<_, 2>(__a) * __of_quarter2
        }
        #[inline]
        fn approach_and_load_integral(&self, __a: T) -> (T, T) {
            __cartcontact::in_double_words!(
                __FUSED => { let [__c0, __c1, __c2] : [__cartcontact::Precise < T,
                __FUSED >; 3usize] = __precise_coefficients(self);
                (__cartcontact::power_sum:: < _, _, _, __FUSED > (__a, [(__c0 * <
                __cartcontact::Precise < T, __FUSED > > ::constant(0.4444444444444444,
                2.4671622769447922e-17), __cartcontact::Exponent::in_parts(2, 0.5, 0.0)),
                (__c1 * < __cartcontact::Precise < T, __FUSED > >
                ::constant(0.3333333333333333, 1.850371707708594e-17),
                __cartcontact::Exponent::whole(4)), (__c2 * < __cartcontact::Precise < T,
                __FUSED > > ::constant(0.2857142857142857, 1.586032892321652e-17),
                __cartcontact::Exponent::whole(5))]), __cartcontact::power_sum:: < _, _,
                _, __FUSED > (__a, [(__c0 * < __cartcontact::Precise < T, __FUSED > >
                ::constant(0.08547008547008547, - 1.6605899940974564e-18),
                __cartcontact::Exponent::in_parts(6, 0.5, 0.0)), (__c1 * <
                __cartcontact::Precise < T, __FUSED > > ::constant(0.08333333333333333,
                4.625929269271485e-18), __cartcontact::Exponent::whole(8)), (__c2 * <
                __cartcontact::Precise < T, __FUSED > > ::constant(0.07936507936507936,
                4.4056469231157e-18), __cartcontact::Exponent::whole(9))])) }
            )
        }
        #[inline]
        fn pressure_kernel(&self, __a: T, __r: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { let [__c0, __c1, __c2] : [T; 3usize] = __coefficients(self);
                __cartcontact::pressure_kernel:: < _, _, _, __FUSED > (__a, __r, [(__c0,
                __cartcontact::Exponent::in_parts(2, 0.5, 0.0)), (__c1,
                __cartcontact::Exponent::whole(4)), (__c2,
                __cartcontact::Exponent::whole(5))]) }
            )
        }
        #[inline(always)]
        fn quick_pressure_kernel(&self, __a: T, __r: T) -> T {
            let [__c0, __c1, __c2]: [T; 3usize] = __coefficients(self);
            __cartcontact::quick_pressure_kernel_in_root::<
                _,
                2,
                10,
                _,
            >(
                __a,
                __r,
                [
                    (
                        __c0
                            * <T as __cartcontact::Scalar>::constant(
                                0.012345679012345678f64,
                            ),
                        5,
                    ),
                    (
                        __c1
                            * <T as __cartcontact::Scalar>::constant(
                                0.006944444444444444f64,
                            ),
                        8,
                    ),
                    (
                        __c2
                            * <T as __cartcontact::Scalar>::constant(
                                0.00510204081632653f64,
                            ),
                        10,
                    ),
                ],
                [
                    (__c0, __cartcontact::Exponent::in_parts(2, 0.5, 0.0)),
                    (__c1, __cartcontact::Exponent::whole(4)),
                    (__c2, __cartcontact::Exponent::whole(5)),
                ],
            )
        }
        #[inline(always)]
        fn radius_within(
            &self,
            __load_integral: T,
            __limit: T,
        ) -> ::core::result::Result<T, __cartcontact::RadiusError> {
            let [__c0, __c1, __c2]: [T; 3usize] = __coefficients(self);
            __cartcontact::found_or(
                __cartcontact::WholePowers::radius(
                    &__cartcontact::WholePowers::<_, _, _, 3usize, 2> {
                        coefficients: [
                            __c0 * <T as __cartcontact::Scalar>::constant(0.13671875f64),
                            __c1
                                * <T as __cartcontact::Scalar>::constant(0.13330078125f64),
                            __c2 * <T as __cartcontact::Scalar>::constant(0.126953125f64),
                        ],
                        powers: [13, 16, 18],
                        steepness: __quick_steepness,
                        last_steepness: __last_steepness,
                        denominator: <T as __cartcontact::Scalar>::constant(
                            1.599609375f64,
                        ),
                    },
                    __load_integral,
                    __limit,
                ),
                move || {
                    __cartcontact::invert(
                        __load_integral,
                        __limit,
                        [
                            (__c0, <T as __cartcontact::Scalar>::constant(2.5f64)),
                            (__c1, <T as __cartcontact::Scalar>::constant(4.0f64)),
                            (__c2, <T as __cartcontact::Scalar>::constant(5.0f64)),
                        ],
                        __c0 < <T as __cartcontact::Scalar>::constant(0.0f64)
                            || __c1 < <T as __cartcontact::Scalar>::constant(0.0f64)
                            || __c2 < <T as __cartcontact::Scalar>::constant(0.0f64),
                        |__a| {
                            __cartcontact::power_sum_and_log_slope(
                                __a,
                                [
                                    (
                                        __c0
                                            * <T as __cartcontact::Scalar>::constant(
                                                0.08547008547008547f64,
                                            ),
                                        __cartcontact::Exponent::in_parts(6, 0.5, 0.0),
                                    ),
                                    (
                                        __c1
                                            * <T as __cartcontact::Scalar>::constant(
                                                0.08333333333333333f64,
                                            ),
                                        __cartcontact::Exponent::whole(8),
                                    ),
                                    (
                                        __c2
                                            * <T as __cartcontact::Scalar>::constant(
                                                0.07936507936507936f64,
                                            ),
                                        __cartcontact::Exponent::whole(9),
                                    ),
                                ],
                            )
                        },
                        |__a| {
                            __cartcontact::in_double_words!(
                                __FUSED => { __cartcontact::power_sum:: < _, _, _, __FUSED >
                                (__a, [(__c0 * < T as __cartcontact::Scalar >
                                ::constant(0.08547008547008547f64),
                                __cartcontact::Exponent::in_parts(6, 0.5, 0.0)), (__c1 * < T
                                as __cartcontact::Scalar >
                                ::constant(0.08333333333333333f64),
                                __cartcontact::Exponent::whole(8)), (__c2 * < T as
                                __cartcontact::Scalar > ::constant(0.07936507936507936f64),
                                __cartcontact::Exponent::whole(9))]) }
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
            let [__c0, __c1, __c2]: [T; 3usize] = __coefficients(self);
            __cartcontact::radii_of_whole_powers(
                (__load_integrals, __radii),
                __limit,
                #[inline(always)]
                |__load_integral, __more| __cartcontact::WholePowers::solve(
                    &__cartcontact::WholePowers::<_, _, _, 3usize, 2> {
                        coefficients: [
                            __c0 * <T as __cartcontact::Scalar>::constant(0.13671875f64),
                            __c1
                                * <T as __cartcontact::Scalar>::constant(0.13330078125f64),
                            __c2 * <T as __cartcontact::Scalar>::constant(0.126953125f64),
                        ],
                        powers: [13, 16, 18],
                        steepness: __quick_steepness,
                        last_steepness: __last_steepness,
                        denominator: <T as __cartcontact::Scalar>::constant(
                            1.599609375f64,
                        ),
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
            __cartcontact::GapProfile::<T>::has_only_positive_terms(self)
        }
        #[inline]
        fn load_integral_drop(&self, __a: T, __depth: T) -> T {
            let [__c0, __c1, __c2]: [T; 3usize] = __coefficients(self);
            __cartcontact::drop_by_roots(
                __a,
                __depth,
                (
                    [
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        __c1
                            * <T as __cartcontact::Scalar>::constant(
                                0.08333333333333333f64,
                            ),
                        __c2
                            * <T as __cartcontact::Scalar>::constant(
                                0.07936507936507936f64,
                            ),
                    ],
                    [],
                    [
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        __c0
                            * <T as __cartcontact::Scalar>::constant(
                                0.08547008547008547f64,
                            ),
                    ],
                    [],
                ),
                [
                    (
                        __c0
                            * <T as __cartcontact::Scalar>::constant(
                                0.08547008547008547f64,
                            ),
                        __cartcontact::Exponent::in_parts(6, 0.5, 0.0),
                    ),
                    (
                        __c1
                            * <T as __cartcontact::Scalar>::constant(
                                0.08333333333333333f64,
                            ),
                        __cartcontact::Exponent::whole(8),
                    ),
                    (
                        __c2
                            * <T as __cartcontact::Scalar>::constant(
                                0.07936507936507936f64,
                            ),
                        __cartcontact::Exponent::whole(9),
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
            let [__c0, __c1, __c2]: [T; 3usize] = __coefficients(self);
            __cartcontact::fill_by_roots(
                self,
                __a,
                __places,
                __values,
                |__r| {
                    let __of_quarter0 = {
                        (__c1
                            * <T as __cartcontact::Scalar>::constant(
                                1.3333333333333333f64,
                            )
                            + (__c2
                                * <T as __cartcontact::Scalar>::constant(
                                    1.4285714285714286f64,
                                )) * __r) * __r * __r * __r
                    };
                    let __of_quarter2 = {
                        (__c0
                            * <T as __cartcontact::Scalar>::constant(
                                1.1111111111111112f64,
                            )) * __r
                    };
                    __of_quarter0
                        + __cartcontact::quarter_root::<_, 2>(__r) * __of_quarter2
                },
                (
                    [
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        __c1
                            * <T as __cartcontact::Scalar>::constant(
                                0.08333333333333333f64,
                            ),
                        __c2
                            * <T as __cartcontact::Scalar>::constant(
                                0.07936507936507936f64,
                            ),
                    ],
                    [],
                    [
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        __c0
                            * <T as __cartcontact::Scalar>::constant(
                                0.08547008547008547f64,
                            ),
                    ],
                    [],
                ),
            )
        }
        #[inline]
        fn max_radius(&self) -> T {
            let [__c0, __c1, __c2]: [T; 3usize] = __coefficients(self);
            ::core::result::Result::unwrap_or(
                __cartcontact::checked_range(
                    [
                        (__c0, <T as __cartcontact::Scalar>::constant(2.5f64)),
                        (__c1, <T as __cartcontact::Scalar>::constant(4.0f64)),
                        (__c2, <T as __cartcontact::Scalar>::constant(5.0f64)),
                    ],
                    ::core::option::Option::None,
                ),
                <T as __cartcontact::Scalar>::constant(0.0f64),
            )
        }
        fn check(&self) -> ::core::result::Result<(), __cartcontact::ProfileError> {
            __cartcontact::GapProfile::<T>::checked_max_radius(self).map(|_| ())
        }
        fn checked_max_radius(
            &self,
        ) -> ::core::result::Result<T, __cartcontact::ProfileError> {
            __cartcontact::check_range_of_fields::<
                T,
                _,
            >(&["c", "d", "e"], [self.c, self.d, self.e])?;
            let [__c0, __c1, __c2]: [T; 3usize] = __coefficients(self);
            let __field_c = <T as __cartcontact::Scalar>::constant(self.c);
            let __field_d = <T as __cartcontact::Scalar>::constant(self.d);
            let __field_e = <T as __cartcontact::Scalar>::constant(self.e);
            __cartcontact::with_parameters(
                __cartcontact::checked_range(
                    [
                        (__c0, <T as __cartcontact::Scalar>::constant(2.5f64)),
                        (__c1, <T as __cartcontact::Scalar>::constant(4.0f64)),
                        (__c2, <T as __cartcontact::Scalar>::constant(5.0f64)),
                    ],
                    ::core::option::Option::None,
                ),
                &["c", "d", "e"],
                [__field_c, __field_d, __field_e],
            )
        }
        #[inline]
        fn highest_exponent(&self) -> T {
            <T as __cartcontact::Scalar>::constant(5.0f64)
        }
        #[inline]
        fn is_smooth_at_centre(&self) -> ::core::primitive::bool {
            false
        }
        #[inline]
        fn has_only_positive_terms(&self) -> ::core::primitive::bool {
            let [__c0, __c1, __c2]: [T; 3usize] = __coefficients(self);
            __c0 >= <T as __cartcontact::Scalar>::constant(0.0f64)
                && __c1 >= <T as __cartcontact::Scalar>::constant(0.0f64)
                && __c2 >= <T as __cartcontact::Scalar>::constant(0.0f64)
        }
    }
    #[allow(unreachable_pub, reason = "a program need not ask for them")]
    impl Blunt {
        /// The terms of the gap Σ C rⁿ as pairs (C, n), in ascending order of their exponents.
        pub fn terms<T: __cartcontact::Scalar>(&self) -> [(T, T); 3usize] {
            let [__c0, __c1, __c2]: [T; 3usize] = __coefficients(self);
            [
                (__c0, <T as __cartcontact::Scalar>::constant(2.5f64)),
                (__c1, <T as __cartcontact::Scalar>::constant(4.0f64)),
                (__c2, <T as __cartcontact::Scalar>::constant(5.0f64)),
            ]
        }
    }
};
