///
/// # Derived from the gap profile
///
/// Lengths in mm; equation numbers of I. Argatov, Mech. Res. Commun. 38 (2011) 29–33, doi 10.1016/j.mechrescom.2010.11.006.
///
/// ```text
/// gap, mm               Φ(r)   = (1/(2·radius)) r²
/// approach, mm          δ₀(a)  = (1/(4·radius)) a²    (10)
/// slope of the approach δ₀′(a) = (1/(2·radius)) a
/// load integral, mm⁵    J(a)   = (1/(24·radius)) a⁶    (14)
/// log kernel, mm³       L(x)   = (1/(32·radius)) x⁴    (28)
/// pressure kernel, mm³  G(a,r) = (a² − r²)² [1/(32·radius)]    (28)
/// contact radius, mm    the a with (π m/4) J(a) = F(t) + χ ∫F dτ    (14)
/// ```
///
/// Admissibility depends on the fields and is checked when a `Contact` is made.
///
/// The contact radius takes one step from a table of 4096 bytes.
///
/// Operations of a call:
///
/// Double words round a result only once. A × of them takes 24 plain operations, or 9 if the processor multiplies and adds in one; a + takes 11.
///
/// ```text
/// gap                   2 ×, 0 + of double words
/// approach              2 ×, 0 + of double words
/// slope of the approach 2 ×, 0 + of double words
/// load integral         4 ×, 0 + of double words
/// log kernel            3 ×, 0 + of double words
/// pressure kernel       5 ×, 2 + of double words
/// coefficients          1 ×, 0 + of double words, ÷ among the ×, in addition, and a × for each term at the most
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
    fn __coefficients<T>(__profile: &Ball) -> [T; 1usize]
    where
        T: __cartcontact::Scalar,
    {
        let __field_radius = <T as __cartcontact::Scalar>::constant(__profile.radius);
        [<T as __cartcontact::Scalar>::constant(0.5f64) / __field_radius]
    }
    #[inline(always)]
    fn __precise_coefficients<T, const __FUSED: ::core::primitive::bool>(
        __profile: &Ball,
    ) -> [__cartcontact::Precise<T, __FUSED>; 1usize]
    where
        T: __cartcontact::Scalar,
    {
        let __field_radius = <__cartcontact::Precise<
            T,
            __FUSED,
        >>::constant(__profile.radius, 0.0);
        [<__cartcontact::Precise<T, __FUSED>>::constant(0.5, 0.0) / __field_radius]
    }
    static __TABLE: __cartcontact::Roots<8> = __cartcontact::Roots {
        table: __cartcontact::Table {
            quarters: __cartcontact::Quarters {
                first: 0,
                count: 96,
            },
            single: __cartcontact::Quarters {
                first: 0,
                count: 96,
            },
            rows: __cartcontact::Rows(
*b"...",
            ),
        },
        series: [
            0.3333333333333333,
            0.05555555555555555,
            0.11728395061728396,
            0.0375514403292181,
            0.07287379972565158,
            0.02908283798201493,
            0.05343761113651374,
            0.024038695617199273,
        ],
    };
    #[automatically_derived]
    impl<T> __cartcontact::GapProfile<T> for Ball
    where
        T: __cartcontact::Scalar,
    {
        #[inline]
        fn gap(&self, __r: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { let [__c0] : [__cartcontact::Precise < T, __FUSED >; 1usize]
                = __precise_coefficients(self); __cartcontact::precise_even_sum:: < _, _,
                __FUSED, _ > (__r, 2u32, [__c0]) }
            )
        }
        #[inline]
        fn approach(&self, __a: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { let [__c0] : [__cartcontact::Precise < T, __FUSED >; 1usize]
                = __precise_coefficients(self); __cartcontact::precise_even_sum:: < _, _,
                __FUSED, _ > (__a, 2u32, [< __cartcontact::Precise < T, __FUSED > >
                ::scaled(__c0, 0.5f64)]) }
            )
        }
        #[inline]
        fn approach_slope(&self, __a: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { let [__c0] : [__cartcontact::Precise < T, __FUSED >; 1usize]
                = __precise_coefficients(self); __cartcontact::precise_even_sum:: < _, _,
                __FUSED, _ > (__a, 1u32, [__c0]) }
            )
        }
        #[inline]
        fn load_integral(&self, __a: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { let [__c0] : [__cartcontact::Precise < T, __FUSED >; 1usize]
                = __precise_coefficients(self); __cartcontact::precise_even_sum:: < _, _,
                __FUSED, _ > (__a, 6u32, [__c0 * < __cartcontact::Precise < T, __FUSED >
                > ::constant(0.08333333333333333, 4.625929269271485e-18)]) }
            )
        }
        #[inline]
        fn log_kernel(&self, __x: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { let [__c0] : [__cartcontact::Precise < T, __FUSED >; 1usize]
                = __precise_coefficients(self); __cartcontact::precise_even_sum:: < _, _,
                __FUSED, _ > (__x, 4u32, [< __cartcontact::Precise < T, __FUSED > >
                ::scaled(__c0, 0.0625f64)]) }
            )
        }
        #[inline]
        fn excess_on_axis(&self, __a: T) -> T {
            let [__c0]: [T; 1usize] = __coefficients(self);
            let __s = __a * __a;
            (__c0 * <T as __cartcontact::Scalar>::constant(0.020833333333333332f64))
                * __s * __s * __s
        }
        #[inline]
        fn quick_approach(&self, __a: T) -> T {
            let [__c0]: [T; 1usize] = __coefficients(self);
            let __s = __a * __a;
            (__c0 * <T as __cartcontact::Scalar>::constant(0.5f64)) * __s
        }
        #[inline]
        fn quick_approach_slope(&self, __a: T) -> T {
            let [__c0]: [T; 1usize] = __coefficients(self);
            (__c0) * __a
        }
        #[inline]
        fn quick_load_integral(&self, __a: T) -> T {
            let [__c0]: [T; 1usize] = __coefficients(self);
            let __s = __a * __a;
            (__c0 * <T as __cartcontact::Scalar>::constant(0.08333333333333333f64)) * __s
                * __s * __s
        }
        #[inline]
        fn approach_and_load_integral(&self, __a: T) -> (T, T) {
            __cartcontact::in_double_words!(
                __FUSED => { let [__c0] : [__cartcontact::Precise < T, __FUSED >; 1usize]
                = __precise_coefficients(self); (__cartcontact::precise_even_sum:: < _,
                _, __FUSED, _ > (__a, 2u32, [< __cartcontact::Precise < T, __FUSED > >
                ::scaled(__c0, 0.5f64)]), __cartcontact::precise_even_sum:: < _, _,
                __FUSED, _ > (__a, 6u32, [__c0 * < __cartcontact::Precise < T, __FUSED >
                > ::constant(0.08333333333333333, 4.625929269271485e-18)])) }
            )
        }
        #[inline]
        fn pressure_kernel(&self, __a: T, __r: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { let [__c0] : [__cartcontact::Precise < T, __FUSED >; 1usize]
                = __precise_coefficients(self); __cartcontact::even_pressure_kernel:: <
                _, _, __FUSED, _ > (__a, __r, [< __cartcontact::Precise < T, __FUSED > >
                ::scaled(__c0, 0.0625f64)]) }
            )
        }
        #[inline(always)]
        fn quick_pressure_kernel(&self, __a: T, __r: T) -> T {
            let [__c0]: [T; 1usize] = __coefficients(self);
            __cartcontact::quick_even_pressure_kernel(
                __a,
                __r,
                [__c0 * <T as __cartcontact::Scalar>::constant(0.0625f64)],
            )
        }
        #[inline(always)]
        fn radius_within(
            &self,
            __load_integral: T,
            __limit: T,
        ) -> ::core::result::Result<T, __cartcontact::RadiusError> {
            let [__c0]: [T; 1usize] = __coefficients(self);
            __cartcontact::found_or(
                __cartcontact::Roots::radius(
                    &__TABLE,
                    __load_integral,
                    __limit,
                    __cartcontact::SingleTerm::<
                        _,
                        6,
                        1,
                        4,
                    >::of_inverse({
                        let __field_radius = <T as __cartcontact::Scalar>::constant(
                            self.radius,
                        );
                        <T as __cartcontact::Scalar>::constant(2.0f64) * __field_radius
                    }),
                ),
                move || {
                    __cartcontact::invert_one_term(
                        __load_integral,
                        (__c0, <T as __cartcontact::Scalar>::constant(2.0f64)),
                        __limit,
                    )
                },
            )
        }
        #[inline(always)]
        fn radius(
            &self,
            __load_integral: T,
        ) -> ::core::result::Result<T, __cartcontact::RadiusError> {
            let [__c0]: [T; 1usize] = __coefficients(self);
            let __limit = <T as __cartcontact::Scalar>::infinity();
            __cartcontact::found_or(
                __cartcontact::Roots::radius(
                    &__TABLE,
                    __load_integral,
                    __limit,
                    __cartcontact::SingleTerm::<
                        _,
                        6,
                        1,
                        4,
                    >::of_inverse({
                        let __field_radius = <T as __cartcontact::Scalar>::constant(
                            self.radius,
                        );
                        <T as __cartcontact::Scalar>::constant(2.0f64) * __field_radius
                    }),
                ),
                move || {
                    let __limit = __cartcontact::GapProfile::max_radius(self);
                    __cartcontact::GapProfile::radius_within(
                        self,
                        __load_integral,
                        __limit,
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
            let [__c0]: [T; 1usize] = __coefficients(self);
            __cartcontact::Roots::radii(
                &__TABLE,
                (__load_integrals, __radii),
                __limit,
                __cartcontact::SingleTerm::<
                    _,
                    6,
                    1,
                    4,
                >::of_inverse({
                    let __field_radius = <T as __cartcontact::Scalar>::constant(
                        self.radius,
                    );
                    <T as __cartcontact::Scalar>::constant(2.0f64) * __field_radius
                }),
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
            let [__c0]: [T; 1usize] = __coefficients(self);
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
            let [__c0]: [T; 1usize] = __coefficients(self);
            __cartcontact::fill_by_functions(
                self,
                __a,
                __places,
                __values,
                #[inline(always)]
                |__r| { (__c0) * __r },
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
                            ],
                        )
                },
            )
        }
        #[inline]
        fn max_radius(&self) -> T {
            let [__c0]: [T; 1usize] = __coefficients(self);
            ::core::result::Result::unwrap_or(
                __cartcontact::checked_range(
                    [(__c0, <T as __cartcontact::Scalar>::constant(2.0f64))],
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
            __cartcontact::check_range_of_fields::<T, _>(&["radius"], [self.radius])?;
            let [__c0]: [T; 1usize] = __coefficients(self);
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
                    .and_then(|()| __cartcontact::checked_range(
                        [(__c0, <T as __cartcontact::Scalar>::constant(2.0f64))],
                        ::core::option::Option::None,
                    )),
                &["radius"],
                [__field_radius],
            )
        }
        #[inline]
        fn highest_exponent(&self) -> T {
            <T as __cartcontact::Scalar>::constant(2.0f64)
        }
        #[inline]
        fn is_smooth_at_centre(&self) -> ::core::primitive::bool {
            true
        }
        #[inline]
        fn has_only_positive_terms(&self) -> ::core::primitive::bool {
            let [__c0]: [T; 1usize] = __coefficients(self);
            __c0 >= <T as __cartcontact::Scalar>::constant(0.0f64)
        }
    }
    #[allow(unreachable_pub, reason = "a program need not ask for them")]
    impl Ball {
        /// The terms of the gap Σ C rⁿ as pairs (C, n), in ascending order of their exponents.
        pub fn terms<T: __cartcontact::Scalar>(&self) -> [(T, T); 1usize] {
            let [__c0]: [T; 1usize] = __coefficients(self);
            [(__c0, <T as __cartcontact::Scalar>::constant(2.0f64))]
        }
    }
};
