///
/// # Derived from the gap profile
///
/// Lengths in mm; equation numbers of I. Argatov, Mech. Res. Commun. 38 (2011) 29–33, doi 10.1016/j.mechrescom.2010.11.006.
///
/// ```text
/// gap, mm               Φ(r)   = c r² + (1/c^0.5) r^2.5
/// approach, mm          δ₀(a)  = (c/2) a² + (4/(9·c^0.5)) a^2.5    (10)
/// slope of the approach δ₀′(a) = c a + (10/(9·c^0.5)) a^1.5
/// load integral, mm⁵    J(a)   = (c/12) a⁶ + (10/(117·c^0.5)) a^6.5    (14)
/// log kernel, mm³       L(x)   = (c/16) x⁴ + (4/(81·c^0.5)) x^4.5    (28)
/// pressure kernel, mm³  G(a,r) = (c/32) a⁴ K(2, r/a) + (2/(81·c^0.5)) a^4.5 K(2.5, r/a), K(n,q) = n − (n+2) q² + 2 qⁿ⁺²    (28)
/// contact radius, mm    the a with (π m/4) J(a) = F(t) + χ ∫F dτ    (14)
/// ```
///
/// Admissibility depends on the fields and is checked when a `Contact` is made.
///
/// The contact radius takes one step from a table of 4096 bytes where J in units of the geometry's own is between 3.5e-18 and 6.4e1; elsewhere it is iterated.
///
struct Any<'a, S: Copy, T>
where
    T: Clone,
{
    c: S,
    tag: &'a T,
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
    fn __coefficients<'a, S: Copy, T>(__profile: &Any<'a, S, T>) -> [S; 2usize]
    where
        T: Clone,
        S: __cartcontact::Scalar,
    {
        let __field_c = __profile.c;
        [
            __field_c,
            __cartcontact::real_power(
                __field_c,
                __cartcontact::Exponent::in_parts(-1, 0.5, 0.0),
            ),
        ]
    }
    #[inline(always)]
    fn __precise_coefficients<'a, S: Copy, T, const __FUSED: ::core::primitive::bool>(
        __profile: &Any<'a, S, T>,
    ) -> [__cartcontact::Precise<S, __FUSED>; 2usize]
    where
        T: Clone,
        S: __cartcontact::Scalar,
    {
        let __field_c = <__cartcontact::Precise<S, __FUSED>>::of(__profile.c);
        [__field_c, __field_c.power(__cartcontact::Exponent::in_parts(-1, 0.5, 0.0))]
    }
    static __TABLE: __cartcontact::Table = __cartcontact::Table {
        quarters: __cartcontact::Quarters {
            first: -232,
            count: 256,
        },
        single: __cartcontact::Quarters {
            first: -176,
            count: 200,
        },
        rows: __cartcontact::Rows(
*b"...",
        ),
    };
    #[inline(always)]
    fn __steepness<S: __cartcontact::Scalar>(
        __a: S,
        [__c0,
        __c1,
        ]: [S; 2usize],
    ) -> __cartcontact::Steepness<S> {
        let (__power, __lost) = __cartcontact::power_of_half_digits(__a, 12);
        let __value = __c0 * <S as __cartcontact::Scalar>::constant(0.15234375f64)
            + (__c1 * <S as __cartcontact::Scalar>::constant(0.15625f64)) * __a;
        __cartcontact::Steepness {
            power: __power,
            value: __value,
            excess: __lost * __value,
            first: __c0 * <S as __cartcontact::Scalar>::constant(1.828125f64)
                + (__c1 * <S as __cartcontact::Scalar>::constant(2.03125f64)) * __a,
            half_second: __c0 * <S as __cartcontact::Scalar>::constant(10.0546875f64)
                + (__c1 * <S as __cartcontact::Scalar>::constant(12.1875f64)) * __a,
            per_unit: <S as __cartcontact::Scalar>::constant(1.0f64),
        }
    }
    #[inline(always)]
    fn __quick_steepness<S: __cartcontact::Scalar>(
        __a: S,
        [__j0,
        __j1,
        ]: [S; 2usize],
    ) -> __cartcontact::Steepness<S> {
        let __value = __j0 + (__j1) * __a;
        __cartcontact::Steepness {
            power: __cartcontact::integer_power(__a, 12),
            value: __value,
            excess: <S as __cartcontact::Scalar>::constant(0.0f64),
            first: <S as __cartcontact::Scalar>::constant(12.0f64) * __j0
                + (<S as __cartcontact::Scalar>::constant(13.0f64) * __j1) * __a,
            half_second: <S as __cartcontact::Scalar>::constant(66.0f64) * __j0
                + (<S as __cartcontact::Scalar>::constant(78.0f64) * __j1) * __a,
            per_unit: <S as __cartcontact::Scalar>::constant(1.0f64),
        }
    }
    #[inline(always)]
    fn __last_steepness<S: __cartcontact::Scalar>(
        __a: S,
        [__j0,
        __j1,
        ]: [S; 2usize],
    ) -> __cartcontact::Steepness<S> {
        __quick_steepness(__a, [__j0, __j1]).with_exact_power::<12>(__a)
    }
    #[automatically_derived]
    impl<'a, S: Copy, T> __cartcontact::GapProfile<S> for Any<'a, S, T>
    where
        T: Clone,
        S: __cartcontact::Scalar,
    {
        #[inline]
        fn gap(&self, __r: S) -> S {
            __cartcontact::in_double_words!(
                __FUSED => { let [__c0, __c1] : [__cartcontact::Precise < S, __FUSED >;
                2usize] = __precise_coefficients(self); __cartcontact::power_sum:: < _,
                _, _, __FUSED > (__r, [(__c0, __cartcontact::Exponent::whole(2)), (__c1,
                __cartcontact::Exponent::in_parts(2, 0.5, 0.0))]) }
            )
        }
        #[inline]
        fn approach(&self, __a: S) -> S {
            __cartcontact::in_double_words!(
                __FUSED => { let [__c0, __c1] : [__cartcontact::Precise < S, __FUSED >;
                2usize] = __precise_coefficients(self); __cartcontact::power_sum:: < _,
                _, _, __FUSED > (__a, [(< __cartcontact::Precise < S, __FUSED > >
                ::scaled(__c0, 0.5f64), __cartcontact::Exponent::whole(2)), (__c1 * <
                __cartcontact::Precise < S, __FUSED > > ::constant(0.4444444444444444,
                2.4671622769447922e-17), __cartcontact::Exponent::in_parts(2, 0.5,
                0.0))]) }
            )
        }
        #[inline]
        fn approach_slope(&self, __a: S) -> S {
            __cartcontact::in_double_words!(
                __FUSED => { let [__c0, __c1] : [__cartcontact::Precise < S, __FUSED >;
                2usize] = __precise_coefficients(self); __cartcontact::power_sum:: < _,
                _, _, __FUSED > (__a, [(__c0, __cartcontact::Exponent::whole(1)), (__c1 *
                < __cartcontact::Precise < S, __FUSED > > ::constant(1.1111111111111112,
                - 4.9343245538895844e-17), __cartcontact::Exponent::in_parts(1, 0.5,
                0.0))]) }
            )
        }
        #[inline]
        fn load_integral(&self, __a: S) -> S {
            __cartcontact::in_double_words!(
                __FUSED => { let [__c0, __c1] : [__cartcontact::Precise < S, __FUSED >;
                2usize] = __precise_coefficients(self); __cartcontact::power_sum:: < _,
                _, _, __FUSED > (__a, [(__c0 * < __cartcontact::Precise < S, __FUSED > >
                ::constant(0.08333333333333333, 4.625929269271485e-18),
                __cartcontact::Exponent::whole(6)), (__c1 * < __cartcontact::Precise < S,
                __FUSED > > ::constant(0.08547008547008547, - 1.6605899940974564e-18),
                __cartcontact::Exponent::in_parts(6, 0.5, 0.0))]) }
            )
        }
        #[inline]
        fn log_kernel(&self, __x: S) -> S {
            __cartcontact::in_double_words!(
                __FUSED => { let [__c0, __c1] : [__cartcontact::Precise < S, __FUSED >;
                2usize] = __precise_coefficients(self); __cartcontact::power_sum:: < _,
                _, _, __FUSED > (__x, [(< __cartcontact::Precise < S, __FUSED > >
                ::scaled(__c0, 0.0625f64), __cartcontact::Exponent::whole(4)), (__c1 * <
                __cartcontact::Precise < S, __FUSED > > ::constant(0.04938271604938271,
                2.741291418827547e-18), __cartcontact::Exponent::in_parts(4, 0.5, 0.0))])
                }
            )
        }
        #[inline]
        fn excess_on_axis(&self, __a: S) -> S {
            let [__c0, __c1]: [S; 2usize] = __coefficients(self);
            let __of_quarter0 = {
                let __s = __a * __a;
                (__c0 * <S as __cartcontact::Scalar>::constant(0.020833333333333332f64))
                    * __s * __s * __s
            };
            let __of_quarter2 = {
                let __s = __a * __a;
                (__c1 * <S as __cartcontact::Scalar>::constant(0.01899335232668566f64))
                    * __s * __s * __s
            };
            __of_quarter0 + __cartcontact::quarter_root::<_, 2>(__a) * __of_quarter2
        }
        #[inline]
        fn quick_approach(&self, __a: S) -> S {
            let [__c0, __c1]: [S; 2usize] = __coefficients(self);
            let __of_quarter0 = {
                let __s = __a * __a;
                (__c0 * <S as __cartcontact::Scalar>::constant(0.5f64)) * __s
            };
            let __of_quarter2 = {
                let __s = __a * __a;
                (__c1 * <S as __cartcontact::Scalar>::constant(0.4444444444444444f64))
                    * __s
            };
            __of_quarter0 + __cartcontact::quarter_root::<_, 2>(__a) * __of_quarter2
        }
        #[inline]
        fn quick_approach_slope(&self, __a: S) -> S {
            let [__c0, __c1]: [S; 2usize] = __coefficients(self);
            let __of_quarter0 = { (__c0) * __a };
            let __of_quarter2 = {
                (__c1 * <S as __cartcontact::Scalar>::constant(1.1111111111111112f64))
                    * __a
            };
            __of_quarter0 + __cartcontact::quarter_root::<_, 2>(__a) * __of_quarter2
        }
        #[inline]
        fn quick_load_integral(&self, __a: S) -> S {
            let [__c0, __c1]: [S; 2usize] = __coefficients(self);
            let __of_quarter0 = {
                let __s = __a * __a;
                (__c0 * <S as __cartcontact::Scalar>::constant(0.08333333333333333f64))
                    * __s * __s * __s
            };
            let __of_quarter2 = {
                let __s = __a * __a;
                (__c1 * <S as __cartcontact::Scalar>::constant(0.08547008547008547f64))
                    * __s * __s * __s
            };
            __of_quarter0 + __cartcontact::quarter_root::<_, 2>(__a) * __of_quarter2
        }
        #[inline]
        fn approach_and_load_integral(&self, __a: S) -> (S, S) {
            __cartcontact::in_double_words!(
                __FUSED => { let [__c0, __c1] : [__cartcontact::Precise < S, __FUSED >;
                2usize] = __precise_coefficients(self); (__cartcontact::power_sum:: < _,
                _, _, __FUSED > (__a, [(< __cartcontact::Precise < S, __FUSED > >
                ::scaled(__c0, 0.5f64), __cartcontact::Exponent::whole(2)), (__c1 * <
                __cartcontact::Precise < S, __FUSED > > ::constant(0.4444444444444444,
                2.4671622769447922e-17), __cartcontact::Exponent::in_parts(2, 0.5,
                0.0))]), __cartcontact::power_sum:: < _, _, _, __FUSED > (__a, [(__c0 * <
                __cartcontact::Precise < S, __FUSED > > ::constant(0.08333333333333333,
                4.625929269271485e-18), __cartcontact::Exponent::whole(6)), (__c1 * <
                __cartcontact::Precise < S, __FUSED > > ::constant(0.08547008547008547, -
                1.6605899940974564e-18), __cartcontact::Exponent::in_parts(6, 0.5,
                0.0))])) }
            )
        }
        #[inline]
        fn pressure_kernel(&self, __a: S, __r: S) -> S {
            __cartcontact::in_double_words!(
                __FUSED => { let [__c0, __c1] : [__cartcontact::Precise < S, __FUSED >;
                2usize] = __precise_coefficients(self); __cartcontact::pressure_kernel::
                < _, _, _, __FUSED > (__a, __r, [(__c0,
                __cartcontact::Exponent::whole(2)), (__c1,
                __cartcontact::Exponent::in_parts(2, 0.5, 0.0))]) }
            )
        }
        #[inline(always)]
        fn quick_pressure_kernel(&self, __a: S, __r: S) -> S {
            let [__c0, __c1]: [S; 2usize] = __coefficients(self);
            __cartcontact::quick_pressure_kernel_in_root::<
                _,
                2,
                5,
                _,
            >(
                __a,
                __r,
                [
                    (__c0 * <S as __cartcontact::Scalar>::constant(0.015625f64), 4),
                    (
                        __c1
                            * <S as __cartcontact::Scalar>::constant(
                                0.012345679012345678f64,
                            ),
                        5,
                    ),
                ],
                [
                    (__c0, __cartcontact::Exponent::whole(2)),
                    (__c1, __cartcontact::Exponent::in_parts(2, 0.5, 0.0)),
                ],
            )
        }
        #[inline(always)]
        fn radius_within(
            &self,
            __load_integral: S,
            __limit: S,
        ) -> ::core::result::Result<S, __cartcontact::RadiusError> {
            let [__c0, __c1]: [S; 2usize] = __coefficients(self);
            __cartcontact::found_or(
                __cartcontact::Table::radius(
                    &__TABLE,
                    __load_integral,
                    __limit,
                    __cartcontact::RootOf::<
                        _,
                        2,
                    >(
                        __cartcontact::EqualTerms::of(
                            (
                                __c0
                                    * <S as __cartcontact::Scalar>::constant(0.15234375f64),
                                <S as __cartcontact::Scalar>::constant(12.0f64),
                            ),
                            (
                                __c1 * <S as __cartcontact::Scalar>::constant(0.15625f64),
                                <S as __cartcontact::Scalar>::constant(13.0f64),
                            ),
                            [],
                            <S as __cartcontact::Scalar>::constant(1.828125f64),
                        ),
                    ),
                    |__a| __steepness(__a, [__c0, __c1]),
                ),
                move || {
                    __cartcontact::found_or(
                        __cartcontact::WholePowers::radius(
                            &__cartcontact::WholePowers::<_, _, _, 2usize, 2> {
                                coefficients: [
                                    __c0
                                        * <S as __cartcontact::Scalar>::constant(0.15234375f64),
                                    __c1 * <S as __cartcontact::Scalar>::constant(0.15625f64),
                                ],
                                powers: [12, 13],
                                steepness: __quick_steepness,
                                last_steepness: __last_steepness,
                                denominator: <S as __cartcontact::Scalar>::constant(
                                    1.828125f64,
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
                                    (__c0, <S as __cartcontact::Scalar>::constant(2.0f64)),
                                    (__c1, <S as __cartcontact::Scalar>::constant(2.5f64)),
                                ],
                                __c0 < <S as __cartcontact::Scalar>::constant(0.0f64),
                                |__a| {
                                    __cartcontact::power_sum_and_log_slope(
                                        __a,
                                        [
                                            (
                                                __c0
                                                    * <S as __cartcontact::Scalar>::constant(
                                                        0.08333333333333333f64,
                                                    ),
                                                __cartcontact::Exponent::whole(6),
                                            ),
                                            (
                                                __c1
                                                    * <S as __cartcontact::Scalar>::constant(
                                                        0.08547008547008547f64,
                                                    ),
                                                __cartcontact::Exponent::in_parts(6, 0.5, 0.0),
                                            ),
                                        ],
                                    )
                                },
                                |__a| {
                                    __cartcontact::in_double_words!(
                                        __FUSED => { __cartcontact::power_sum:: < _, _, _, __FUSED >
                                        (__a, [(__c0 * < S as __cartcontact::Scalar >
                                        ::constant(0.08333333333333333f64),
                                        __cartcontact::Exponent::whole(6)), (__c1 * < S as
                                        __cartcontact::Scalar > ::constant(0.08547008547008547f64),
                                        __cartcontact::Exponent::in_parts(6, 0.5, 0.0))]) }
                                    )
                                },
                            )
                        },
                    )
                },
            )
        }
        #[inline(always)]
        fn radius(
            &self,
            __load_integral: S,
        ) -> ::core::result::Result<S, __cartcontact::RadiusError> {
            let [__c0, __c1]: [S; 2usize] = __coefficients(self);
            let __limit = <S as __cartcontact::Scalar>::infinity();
            __cartcontact::found_or(
                __cartcontact::Table::radius(
                    &__TABLE,
                    __load_integral,
                    __limit,
                    __cartcontact::RootOf::<
                        _,
                        2,
                    >(
                        __cartcontact::EqualTerms::of(
                            (
                                __c0
                                    * <S as __cartcontact::Scalar>::constant(0.15234375f64),
                                <S as __cartcontact::Scalar>::constant(12.0f64),
                            ),
                            (
                                __c1 * <S as __cartcontact::Scalar>::constant(0.15625f64),
                                <S as __cartcontact::Scalar>::constant(13.0f64),
                            ),
                            [],
                            <S as __cartcontact::Scalar>::constant(1.828125f64),
                        ),
                    ),
                    |__a| __steepness(__a, [__c0, __c1]),
                ),
                move || {
                    let [__c0, __c1]: [S; 2usize] = __coefficients(self);
                    let __limit = __cartcontact::GapProfile::max_radius(self);
                    __cartcontact::found_or(
                        __cartcontact::WholePowers::radius(
                            &__cartcontact::WholePowers::<_, _, _, 2usize, 2> {
                                coefficients: [
                                    __c0
                                        * <S as __cartcontact::Scalar>::constant(0.15234375f64),
                                    __c1 * <S as __cartcontact::Scalar>::constant(0.15625f64),
                                ],
                                powers: [12, 13],
                                steepness: __quick_steepness,
                                last_steepness: __last_steepness,
                                denominator: <S as __cartcontact::Scalar>::constant(
                                    1.828125f64,
                                ),
                            },
                            __load_integral,
                            __limit,
                        ),
                        move || {
                            __cartcontact::GapProfile::radius_within(
                                self,
                                __load_integral,
                                __limit,
                            )
                        },
                    )
                },
            )
        }
        fn radii_within(
            &self,
            __load_integrals: &[S],
            __limit: S,
            __radii: &mut [S],
        ) -> ::core::result::Result<(), __cartcontact::RadiusError> {
            let [__c0, __c1]: [S; 2usize] = __coefficients(self);
            __cartcontact::Table::radii(
                &__TABLE,
                (__load_integrals, __radii),
                __limit,
                __cartcontact::RootOf::<
                    _,
                    2,
                >(
                    __cartcontact::EqualTerms::of(
                        (
                            __c0 * <S as __cartcontact::Scalar>::constant(0.15234375f64),
                            <S as __cartcontact::Scalar>::constant(12.0f64),
                        ),
                        (
                            __c1 * <S as __cartcontact::Scalar>::constant(0.15625f64),
                            <S as __cartcontact::Scalar>::constant(13.0f64),
                        ),
                        [],
                        <S as __cartcontact::Scalar>::constant(1.828125f64),
                    ),
                ),
                #[inline(always)]
                move |__a| __steepness(__a, [__c0, __c1]),
                #[inline(always)]
                |__load_integral, __more| __cartcontact::WholePowers::solve(
                    &__cartcontact::WholePowers::<_, _, _, 2usize, 2> {
                        coefficients: [
                            __c0 * <S as __cartcontact::Scalar>::constant(0.15234375f64),
                            __c1 * <S as __cartcontact::Scalar>::constant(0.15625f64),
                        ],
                        powers: [12, 13],
                        steepness: __quick_steepness,
                        last_steepness: __last_steepness,
                        denominator: <S as __cartcontact::Scalar>::constant(1.828125f64),
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
            __cartcontact::GapProfile::<S>::has_only_positive_terms(self)
        }
        #[inline]
        fn load_integral_drop(&self, __a: S, __depth: S) -> S {
            let [__c0, __c1]: [S; 2usize] = __coefficients(self);
            __cartcontact::drop_by_roots(
                __a,
                __depth,
                (
                    [
                        <S as __cartcontact::Scalar>::constant(-0.0f64),
                        <S as __cartcontact::Scalar>::constant(-0.0f64),
                        <S as __cartcontact::Scalar>::constant(-0.0f64),
                        <S as __cartcontact::Scalar>::constant(-0.0f64),
                        <S as __cartcontact::Scalar>::constant(-0.0f64),
                        <S as __cartcontact::Scalar>::constant(-0.0f64),
                        __c0
                            * <S as __cartcontact::Scalar>::constant(
                                0.08333333333333333f64,
                            ),
                    ],
                    [],
                    [
                        <S as __cartcontact::Scalar>::constant(-0.0f64),
                        <S as __cartcontact::Scalar>::constant(-0.0f64),
                        <S as __cartcontact::Scalar>::constant(-0.0f64),
                        <S as __cartcontact::Scalar>::constant(-0.0f64),
                        <S as __cartcontact::Scalar>::constant(-0.0f64),
                        <S as __cartcontact::Scalar>::constant(-0.0f64),
                        __c1
                            * <S as __cartcontact::Scalar>::constant(
                                0.08547008547008547f64,
                            ),
                    ],
                    [],
                ),
                [
                    (
                        __c0
                            * <S as __cartcontact::Scalar>::constant(
                                0.08333333333333333f64,
                            ),
                        __cartcontact::Exponent::whole(6),
                    ),
                    (
                        __c1
                            * <S as __cartcontact::Scalar>::constant(
                                0.08547008547008547f64,
                            ),
                        __cartcontact::Exponent::in_parts(6, 0.5, 0.0),
                    ),
                ],
            )
        }
        #[inline(always)]
        fn fill_slopes_and_drops(
            &self,
            __a: S,
            __places: (&[S], &[S]),
            __values: (&mut [S], &mut [S]),
        ) {
            let [__c0, __c1]: [S; 2usize] = __coefficients(self);
            __cartcontact::fill_by_roots(
                self,
                __a,
                __places,
                __values,
                |__r| {
                    let __of_quarter0 = { (__c0) * __r };
                    let __of_quarter2 = {
                        (__c1
                            * <S as __cartcontact::Scalar>::constant(
                                1.1111111111111112f64,
                            )) * __r
                    };
                    __of_quarter0
                        + __cartcontact::quarter_root::<_, 2>(__r) * __of_quarter2
                },
                (
                    [
                        <S as __cartcontact::Scalar>::constant(-0.0f64),
                        <S as __cartcontact::Scalar>::constant(-0.0f64),
                        <S as __cartcontact::Scalar>::constant(-0.0f64),
                        <S as __cartcontact::Scalar>::constant(-0.0f64),
                        <S as __cartcontact::Scalar>::constant(-0.0f64),
                        <S as __cartcontact::Scalar>::constant(-0.0f64),
                        __c0
                            * <S as __cartcontact::Scalar>::constant(
                                0.08333333333333333f64,
                            ),
                    ],
                    [],
                    [
                        <S as __cartcontact::Scalar>::constant(-0.0f64),
                        <S as __cartcontact::Scalar>::constant(-0.0f64),
                        <S as __cartcontact::Scalar>::constant(-0.0f64),
                        <S as __cartcontact::Scalar>::constant(-0.0f64),
                        <S as __cartcontact::Scalar>::constant(-0.0f64),
                        <S as __cartcontact::Scalar>::constant(-0.0f64),
                        __c1
                            * <S as __cartcontact::Scalar>::constant(
                                0.08547008547008547f64,
                            ),
                    ],
                    [],
                ),
            )
        }
        #[inline]
        fn max_radius(&self) -> S {
            let [__c0, __c1]: [S; 2usize] = __coefficients(self);
            ::core::result::Result::unwrap_or(
                __cartcontact::checked_range(
                    [
                        (__c0, <S as __cartcontact::Scalar>::constant(2.0f64)),
                        (__c1, <S as __cartcontact::Scalar>::constant(2.5f64)),
                    ],
                    ::core::option::Option::None,
                ),
                <S as __cartcontact::Scalar>::constant(0.0f64),
            )
        }
        fn check(&self) -> ::core::result::Result<(), __cartcontact::ProfileError> {
            __cartcontact::GapProfile::<S>::checked_max_radius(self).map(|_| ())
        }
        fn checked_max_radius(
            &self,
        ) -> ::core::result::Result<S, __cartcontact::ProfileError> {
            let [__c0, __c1]: [S; 2usize] = __coefficients(self);
            let __field_c = self.c;
            __cartcontact::with_parameters(
                __cartcontact::check_product(
                        (__c1, <S as __cartcontact::Scalar>::constant(2.5f64)),
                        || __cartcontact::real_power(
                            __field_c,
                            __cartcontact::Exponent::in_parts(-1, 0.5, 0.0),
                        ),
                        [],
                        [__field_c],
                    )
                    .and_then(|()| __cartcontact::checked_range(
                        [
                            (__c0, <S as __cartcontact::Scalar>::constant(2.0f64)),
                            (__c1, <S as __cartcontact::Scalar>::constant(2.5f64)),
                        ],
                        ::core::option::Option::None,
                    )),
                &["c"],
                [__field_c],
            )
        }
        #[inline]
        fn highest_exponent(&self) -> S {
            <S as __cartcontact::Scalar>::constant(2.5f64)
        }
        #[inline]
        fn is_smooth_at_centre(&self) -> ::core::primitive::bool {
            false
        }
        #[inline]
        fn has_only_positive_terms(&self) -> ::core::primitive::bool {
            let [__c0, __c1]: [S; 2usize] = __coefficients(self);
            __c0 >= <S as __cartcontact::Scalar>::constant(0.0f64)
        }
    }
    #[allow(unreachable_pub, reason = "a program need not ask for them")]
    impl<'a, S: Copy, T> Any<'a, S, T>
    where
        T: Clone,
        S: __cartcontact::Scalar,
    {
        /// The terms of the gap Σ C rⁿ as pairs (C, n), in ascending order of their exponents.
        pub fn terms(&self) -> [(S, S); 2usize] {
            let [__c0, __c1]: [S; 2usize] = __coefficients(self);
            [
                (__c0, <S as __cartcontact::Scalar>::constant(2.0f64)),
                (__c1, <S as __cartcontact::Scalar>::constant(2.5f64)),
            ]
        }
    }
};
