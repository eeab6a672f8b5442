///
/// # Derived from the gap profile
///
/// Lengths in mm; equation numbers of I. Argatov, Mech. Res. Commun. 38 (2011) 29–33, doi 10.1016/j.mechrescom.2010.11.006.
///
/// ```text
/// gap, mm               Φ(r)   = (1/(2·radius)) r² + (1/(8·radius^3)) r⁴
/// approach, mm          δ₀(a)  = (1/(4·radius)) a² + (1/(24·radius^3)) a⁴    (10)
/// slope of the approach δ₀′(a) = (1/(2·radius)) a + (1/(6·radius^3)) a³
/// load integral, mm⁵    J(a)   = (1/(24·radius)) a⁶ + (1/(96·radius^3)) a⁸    (14)
/// log kernel, mm³       L(x)   = (1/(32·radius)) x⁴ + (1/(288·radius^3)) x⁶    (28)
/// pressure kernel, mm³  G(a,r) = (a² − r²)² [1/(32·radius) + (1/(288·radius^3)) (2 a² + r²)]    (28)
/// contact radius, mm    the a with (π m/4) J(a) = F(t) + χ ∫F dτ    (14)
/// ```
///
/// Admissibility up to 6 mm depends on the fields and is checked when a `Contact` is made.
///
/// Surfaces are expanded in powers of r up to r⁴. How much this neglects depends on the radius and is not bounded here.
///
/// The contact radius takes one step from a table of 4096 bytes where J in units of the geometry's own is between 5.7e-14 and 1.0e6; elsewhere it is iterated.
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
/// coefficients          3 ×, 0 + of double words, ÷ among the ×, in addition, and a × for each term at the most
/// ```
struct Ball {
    radius: f64,
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
    fn __coefficients<T>(__profile: &Ball) -> [T; 2usize]
    where
        T: __cartcontact::Scalar,
    {
        let __field_radius = <T as __cartcontact::Scalar>::constant(__profile.radius);
        [
            <T as __cartcontact::Scalar>::constant(0.5f64) / __field_radius,
            <T as __cartcontact::Scalar>::constant(0.125f64)
                / ({
                    let __base = __field_radius;
                    __base * __base * __base
                }),
        ]
    }
    #[inline(always)]
    fn __precise_coefficients<T, const __FUSED: ::core::primitive::bool>(
        __profile: &Ball,
    ) -> [__cartcontact::Precise<T, __FUSED>; 2usize]
    where
        T: __cartcontact::Scalar,
    {
        let __field_radius = <__cartcontact::Precise<
            T,
            __FUSED,
        >>::constant(__profile.radius, 0.0);
        let __inverse_radius = <__cartcontact::Precise<T, __FUSED>>::constant(1.0, 0.0)
            / __field_radius;
        [
            <__cartcontact::Precise<T, __FUSED>>::scaled(__inverse_radius, 0.5f64),
            <__cartcontact::Precise<T, __FUSED>>::scaled(__inverse_radius, 0.125f64)
                * __inverse_radius * __inverse_radius,
        ]
    }
    static __TABLE: __cartcontact::Table = __cartcontact::Table {
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
    #[inline(always)]
    fn __steepness<T: __cartcontact::Scalar>(
        __a: T,
        [__c0,
        __c1,
        ]: [T; 2usize],
    ) -> __cartcontact::Steepness<T> {
        let __s = __a * __a;
        let __value = __c0 * <T as __cartcontact::Scalar>::constant(0.125f64)
            + (__c1 * <T as __cartcontact::Scalar>::constant(0.125f64)) * __s;
        __cartcontact::Steepness {
            power: __cartcontact::integer_power(__s, 3),
            value: __value,
            excess: <T as __cartcontact::Scalar>::constant(0.0f64),
            first: __c0 * <T as __cartcontact::Scalar>::constant(0.75f64) + (__c1) * __s,
            half_second: __c0 * <T as __cartcontact::Scalar>::constant(1.875f64)
                + (__c1 * <T as __cartcontact::Scalar>::constant(3.5f64)) * __s,
            per_unit: <T as __cartcontact::Scalar>::constant(1.0f64),
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
    impl<T> __cartcontact::GapProfile<T> for Ball
    where
        T: __cartcontact::Scalar,
    {
        #[inline]
        fn gap(&self, __r: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { let [__c0, __c1] : [__cartcontact::Precise < T, __FUSED >;
                2usize] = __precise_coefficients(self); __cartcontact::precise_even_sum::
                < _, _, __FUSED, _ > (__r, 2u32, [__c0, __c1]) }
            )
        }
        #[inline]
        fn approach(&self, __a: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { let [__c0, __c1] : [__cartcontact::Precise < T, __FUSED >;
                2usize] = __precise_coefficients(self); __cartcontact::precise_even_sum::
                < _, _, __FUSED, _ > (__a, 2u32, [< __cartcontact::Precise < T, __FUSED >
                > ::scaled(__c0, 0.5f64), __c1 * < __cartcontact::Precise < T, __FUSED >
                > ::constant(0.3333333333333333, 1.850371707708594e-17)]) }
            )
        }
        #[inline]
        fn approach_slope(&self, __a: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { let [__c0, __c1] : [__cartcontact::Precise < T, __FUSED >;
                2usize] = __precise_coefficients(self); __cartcontact::precise_even_sum::
                < _, _, __FUSED, _ > (__a, 1u32, [__c0, __c1 * < __cartcontact::Precise <
                T, __FUSED > > ::constant(1.3333333333333333, 7.401486830834377e-17)]) }
            )
        }
        #[inline]
        fn load_integral(&self, __a: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { let [__c0, __c1] : [__cartcontact::Precise < T, __FUSED >;
                2usize] = __precise_coefficients(self); __cartcontact::precise_even_sum::
                < _, _, __FUSED, _ > (__a, 6u32, [__c0 * < __cartcontact::Precise < T,
                __FUSED > > ::constant(0.08333333333333333, 4.625929269271485e-18), __c1
                * < __cartcontact::Precise < T, __FUSED > >
                ::constant(0.08333333333333333, 4.625929269271485e-18)]) }
            )
        }
        #[inline]
        fn log_kernel(&self, __x: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { let [__c0, __c1] : [__cartcontact::Precise < T, __FUSED >;
                2usize] = __precise_coefficients(self); __cartcontact::precise_even_sum::
                < _, _, __FUSED, _ > (__x, 4u32, [< __cartcontact::Precise < T, __FUSED >
                > ::scaled(__c0, 0.0625f64), __c1 * < __cartcontact::Precise < T, __FUSED
                > > ::constant(0.027777777777777776, 1.5419764230904951e-18)]) }
            )
        }
        #[inline]
        fn excess_on_axis(&self, __a: T) -> T {
            let [__c0, __c1]: [T; 2usize] = __coefficients(self);
            let __s = __a * __a;
            (__c0 * <T as __cartcontact::Scalar>::constant(0.020833333333333332f64)
                + (__c1
                    * <T as __cartcontact::Scalar>::constant(0.013888888888888888f64))
                    * __s) * __s * __s * __s
        }
        #[inline]
        fn quick_approach(&self, __a: T) -> T {
            let [__c0, __c1]: [T; 2usize] = __coefficients(self);
            let __s = __a * __a;
            (__c0 * <T as __cartcontact::Scalar>::constant(0.5f64)
                + (__c1 * <T as __cartcontact::Scalar>::constant(0.3333333333333333f64))
                    * __s) * __s
        }
        #[inline]
        fn quick_approach_slope(&self, __a: T) -> T {
            let [__c0, __c1]: [T; 2usize] = __coefficients(self);
            let __s = __a * __a;
            (__c0
                + (__c1 * <T as __cartcontact::Scalar>::constant(1.3333333333333333f64))
                    * __s) * __a
        }
        #[inline]
        fn quick_load_integral(&self, __a: T) -> T {
            let [__c0, __c1]: [T; 2usize] = __coefficients(self);
            let __s = __a * __a;
            (__c0 * <T as __cartcontact::Scalar>::constant(0.08333333333333333f64)
                + (__c1 * <T as __cartcontact::Scalar>::constant(0.08333333333333333f64))
                    * __s) * __s * __s * __s
        }
        #[inline]
        fn approach_and_load_integral(&self, __a: T) -> (T, T) {
            __cartcontact::in_double_words!(
                __FUSED => { let [__c0, __c1] : [__cartcontact::Precise < T, __FUSED >;
                2usize] = __precise_coefficients(self);
                (__cartcontact::precise_even_sum:: < _, _, __FUSED, _ > (__a, 2u32, [<
                __cartcontact::Precise < T, __FUSED > > ::scaled(__c0, 0.5f64), __c1 * <
                __cartcontact::Precise < T, __FUSED > > ::constant(0.3333333333333333,
                1.850371707708594e-17)]), __cartcontact::precise_even_sum:: < _, _,
                __FUSED, _ > (__a, 6u32, [__c0 * < __cartcontact::Precise < T, __FUSED >
                > ::constant(0.08333333333333333, 4.625929269271485e-18), __c1 * <
                __cartcontact::Precise < T, __FUSED > > ::constant(0.08333333333333333,
                4.625929269271485e-18)])) }
            )
        }
        #[inline]
        fn pressure_kernel(&self, __a: T, __r: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { let [__c0, __c1] : [__cartcontact::Precise < T, __FUSED >;
                2usize] = __precise_coefficients(self);
                __cartcontact::even_pressure_kernel:: < _, _, __FUSED, _ > (__a, __r, [<
                __cartcontact::Precise < T, __FUSED > > ::scaled(__c0, 0.0625f64), __c1 *
                < __cartcontact::Precise < T, __FUSED > >
                ::constant(0.027777777777777776, 1.5419764230904951e-18)]) }
            )
        }
        #[inline(always)]
        fn quick_pressure_kernel(&self, __a: T, __r: T) -> T {
            let [__c0, __c1]: [T; 2usize] = __coefficients(self);
            __cartcontact::quick_even_pressure_kernel(
                __a,
                __r,
                [
                    __c0 * <T as __cartcontact::Scalar>::constant(0.0625f64),
                    __c1
                        * <T as __cartcontact::Scalar>::constant(0.027777777777777776f64),
                ],
            )
        }
        #[inline(always)]
        fn radius_within(
            &self,
            __load_integral: T,
            __limit: T,
        ) -> ::core::result::Result<T, __cartcontact::RadiusError> {
            let [__c0, __c1]: [T; 2usize] = __coefficients(self);
            __cartcontact::found_or(
                __cartcontact::Table::radius(
                    &__TABLE,
                    __load_integral,
                    __limit,
                    __cartcontact::EqualTerms::of(
                        (
                            __c0 * <T as __cartcontact::Scalar>::constant(0.125f64),
                            <T as __cartcontact::Scalar>::constant(6.0f64),
                        ),
                        (
                            __c1 * <T as __cartcontact::Scalar>::constant(0.125f64),
                            <T as __cartcontact::Scalar>::constant(8.0f64),
                        ),
                        [],
                        <T as __cartcontact::Scalar>::constant(1.5f64),
                    ),
                    |__a| __steepness(__a, [__c0, __c1]),
                ),
                move || {
                    __cartcontact::found_or(
                        __cartcontact::WholePowers::radius(
                            &__cartcontact::WholePowers::<_, _, _, 2usize, 1> {
                                coefficients: [
                                    __c0 * <T as __cartcontact::Scalar>::constant(0.125f64),
                                    __c1 * <T as __cartcontact::Scalar>::constant(0.125f64),
                                ],
                                powers: [6, 8],
                                steepness: __quick_steepness,
                                last_steepness: __quick_steepness,
                                denominator: <T as __cartcontact::Scalar>::constant(1.5f64),
                            },
                            __load_integral,
                            __limit,
                        ),
                        move || {
                            __cartcontact::invert(
                                __load_integral,
                                __limit,
                                [
                                    (__c0, <T as __cartcontact::Scalar>::constant(2.0f64)),
                                    (__c1, <T as __cartcontact::Scalar>::constant(4.0f64)),
                                ],
                                __c0 < <T as __cartcontact::Scalar>::constant(0.0f64)
                                    || __c1 < <T as __cartcontact::Scalar>::constant(0.0f64),
                                |__a| {
                                    let __x = __a * __a;
                                    let (__value, __slope) = __cartcontact::value_and_slope(
                                        __x,
                                        [
                                            __c0
                                                * <T as __cartcontact::Scalar>::constant(
                                                    0.08333333333333333f64,
                                                ),
                                            __c1
                                                * <T as __cartcontact::Scalar>::constant(
                                                    0.08333333333333333f64,
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
                                        __FUSED, _ > (__a, 6u32, [__c0 * < T as
                                        __cartcontact::Scalar > ::constant(0.08333333333333333f64),
                                        __c1 * < T as __cartcontact::Scalar >
                                        ::constant(0.08333333333333333f64)]) }
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
            let [__c0, __c1]: [T; 2usize] = __coefficients(self);
            __cartcontact::Table::radii(
                &__TABLE,
                (__load_integrals, __radii),
                __limit,
                __cartcontact::EqualTerms::of(
                    (
                        __c0 * <T as __cartcontact::Scalar>::constant(0.125f64),
                        <T as __cartcontact::Scalar>::constant(6.0f64),
                    ),
                    (
                        __c1 * <T as __cartcontact::Scalar>::constant(0.125f64),
                        <T as __cartcontact::Scalar>::constant(8.0f64),
                    ),
                    [],
                    <T as __cartcontact::Scalar>::constant(1.5f64),
                ),
                #[inline(always)]
                move |__a| __steepness(__a, [__c0, __c1]),
                #[inline(always)]
                |__load_integral, __more| __cartcontact::WholePowers::solve(
                    &__cartcontact::WholePowers::<_, _, _, 2usize, 1> {
                        coefficients: [
                            __c0 * <T as __cartcontact::Scalar>::constant(0.125f64),
                            __c1 * <T as __cartcontact::Scalar>::constant(0.125f64),
                        ],
                        powers: [6, 8],
                        steepness: __quick_steepness,
                        last_steepness: __quick_steepness,
                        denominator: <T as __cartcontact::Scalar>::constant(1.5f64),
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
            let [__c0, __c1]: [T; 2usize] = __coefficients(self);
            let __s = __a - __depth;
            __depth
                * __cartcontact::even_divided_difference(
                    __a,
                    __s,
                    [
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        <T as __cartcontact::Scalar>::constant(-0.0f64),
                        __c0
                            * <T as __cartcontact::Scalar>::constant(
                                0.08333333333333333f64,
                            ),
                        __c1
                            * <T as __cartcontact::Scalar>::constant(
                                0.08333333333333333f64,
                            ),
                    ],
                )
        }
        #[inline]
        fn fill_slopes_and_drops(
            &self,
            __a: T,
            __places: (&[T], &[T]),
            __values: (&mut [T], &mut [T]),
        ) {
            let [__c0, __c1]: [T; 2usize] = __coefficients(self);
            __cartcontact::fill_by_functions(
                self,
                __a,
                __places,
                __values,
                #[inline(always)]
                |__r| {
                    let __s = __r * __r;
                    (__c0
                        + (__c1
                            * <T as __cartcontact::Scalar>::constant(
                                1.3333333333333333f64,
                            )) * __s) * __r
                },
                #[inline(always)]
                |__depth| {
                    let __s = __a - __depth;
                    __depth
                        * __cartcontact::even_divided_difference(
                            __a,
                            __s,
                            [
                                <T as __cartcontact::Scalar>::constant(-0.0f64),
                                <T as __cartcontact::Scalar>::constant(-0.0f64),
                                <T as __cartcontact::Scalar>::constant(-0.0f64),
                                __c0
                                    * <T as __cartcontact::Scalar>::constant(
                                        0.08333333333333333f64,
                                    ),
                                __c1
                                    * <T as __cartcontact::Scalar>::constant(
                                        0.08333333333333333f64,
                                    ),
                            ],
                        )
                },
            )
        }
        #[inline]
        fn max_radius(&self) -> T {
            let [__c0, __c1]: [T; 2usize] = __coefficients(self);
            ::core::result::Result::unwrap_or(
                __cartcontact::inside_surfaces(
                    __cartcontact::checked_range(
                        [
                            (__c0, <T as __cartcontact::Scalar>::constant(2.0f64)),
                            (__c1, <T as __cartcontact::Scalar>::constant(4.0f64)),
                        ],
                        ::core::option::Option::Some(
                            <T as __cartcontact::Scalar>::constant(6.0f64),
                        ),
                    ),
                    [
                        (
                            {
                                let __field_radius = <T as __cartcontact::Scalar>::constant(
                                    self.radius,
                                );
                                __field_radius
                            },
                            <T as __cartcontact::Scalar>::constant(1.0f64),
                        ),
                    ],
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
            __cartcontact::check_range_of_fields::<T, _>(&["radius"], [self.radius])?;
            let [__c0, __c1]: [T; 2usize] = __coefficients(self);
            let __field_radius = <T as __cartcontact::Scalar>::constant(self.radius);
            __cartcontact::with_parameters(
                __cartcontact::check_product(
                        (__c0, <T as __cartcontact::Scalar>::constant(2.0f64)),
                        || {
                            <T as __cartcontact::Scalar>::constant(0.5f64)
                                / __field_radius
                        },
                        [],
                        [__field_radius],
                    )
                    .and(
                        __cartcontact::check_product(
                            (__c1, <T as __cartcontact::Scalar>::constant(4.0f64)),
                            || {
                                <T as __cartcontact::Scalar>::constant(0.125f64)
                                    / ({
                                        let __base = __field_radius;
                                        __base * __base * __base
                                    })
                            },
                            [],
                            [__field_radius],
                        ),
                    )
                    .and_then(|()| __cartcontact::inside_surfaces(
                        __cartcontact::checked_range(
                            [
                                (__c0, <T as __cartcontact::Scalar>::constant(2.0f64)),
                                (__c1, <T as __cartcontact::Scalar>::constant(4.0f64)),
                            ],
                            ::core::option::Option::Some(
                                <T as __cartcontact::Scalar>::constant(6.0f64),
                            ),
                        ),
                        [
                            (
                                {
                                    let __field_radius = <T as __cartcontact::Scalar>::constant(
                                        self.radius,
                                    );
                                    __field_radius
                                },
                                <T as __cartcontact::Scalar>::constant(1.0f64),
                            ),
                        ],
                    )),
                &["radius"],
                [__field_radius],
            )
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
            let [__c0, __c1]: [T; 2usize] = __coefficients(self);
            __c0 >= <T as __cartcontact::Scalar>::constant(0.0f64)
                && __c1 >= <T as __cartcontact::Scalar>::constant(0.0f64)
        }
    }
    #[allow(unreachable_pub, reason = "a program need not ask for them")]
    impl Ball {
        /// The terms of the gap Σ C rⁿ as pairs (C, n), in ascending order of their exponents.
        pub fn terms<T: __cartcontact::Scalar>(&self) -> [(T, T); 2usize] {
            let [__c0, __c1]: [T; 2usize] = __coefficients(self);
            [
                (__c0, <T as __cartcontact::Scalar>::constant(2.0f64)),
                (__c1, <T as __cartcontact::Scalar>::constant(4.0f64)),
            ]
        }
    }
};
