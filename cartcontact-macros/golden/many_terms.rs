///
/// # Derived from the gap profile
///
/// Lengths in mm; equation numbers of I. Argatov, Mech. Res. Commun. 38 (2011) 29–33, doi 10.1016/j.mechrescom.2010.11.006.
///
/// ```text
/// gap, mm               Φ(r)   = 0.075 r² + 1.40625e-4 r⁴ + 6.4453125e-7 r⁶ + 3.936767578125e-9 r⁸ + 2.739715576171875e-11 r¹⁰ + 2.0517826080322267e-13 r¹² + 1.6115248203277588e-15 r¹⁴ + 1.309244055300951e-17 r¹⁶ + 1.0910117416642606e-19 r¹⁸ + 9.273546740587335e-22 r²⁰ + 8.00896072814794e-24 r²² + 7.007838130931532e-26 r²⁴
/// approach, mm          δ₀(a)  = 0.0375 a² + 4.6875e-5 a⁴ + 1.611328125e-7 a⁶ + 7.87353515625e-10 a⁸ + 4.566192626953125e-12 a¹⁰ + 2.931118011474609e-14 a¹² + 2.0144060254096985e-16 a¹⁴ + 1.4547156170010567e-18 a¹⁶ + 1.0910117416642607e-20 a¹⁸ + 8.430497036897578e-23 a²⁰ + 6.674133940123284e-25 a²² + 5.390644716101178e-27 a²⁴    (10)
/// slope of the approach δ₀′(a) = 0.075 a + 1.875e-4 a³ + 9.66796875e-7 a⁵ + 6.298828125e-9 a⁷ + 4.566192626953125e-11 a⁹ + 3.517341613769531e-13 a¹¹ + 2.8201684355735777e-15 a¹³ + 2.3275449872016907e-17 a¹⁵ + 1.9638211349956691e-19 a¹⁷ + 1.6860994073795155e-21 a¹⁹ + 1.4683094668271224e-23 a²¹ + 1.2937547318642829e-25 a²³
/// load integral, mm⁵    J(a)   = 0.00625 a⁶ + 1.171875e-5 a⁸ + 4.833984375e-8 a¹⁰ + 2.62451171875e-10 a¹² + 1.6307830810546874e-12 a¹⁴ + 1.0991692543029785e-14 a¹⁶ + 7.833801209926605e-17 a¹⁸ + 5.818862468004227e-19 a²⁰ + 4.4632298522628844e-21 a²² + 3.512707098707324e-23 a²⁴ + 2.82367205159062e-25 a²⁶ + 2.310276306900505e-27 a²⁸    (14)
/// log kernel, mm³       L(x)   = 0.0046875 x⁴ + 3.90625e-6 x⁶ + 1.007080078125e-8 x⁸ + 3.936767578125e-11 x¹⁰ + 1.9025802612304688e-13 x¹² + 1.046827861240932e-15 x¹⁴ + 6.295018829405308e-18 x¹⁶ + 4.040876713891824e-20 x¹⁸ + 2.7275293541606515e-22 x²⁰ + 1.9160220538403586e-24 x²² + 1.3904445708590175e-26 x²⁴ + 1.0366624454040728e-28 x²⁶    (28)
/// pressure kernel, mm³  G(a,r) = 0.00234375 a⁴ K(2, r/a) + 1.953125e-6 a⁶ K(4, r/a) + 5.035400390625e-9 a⁸ K(6, r/a) + 1.9683837890625e-11 a¹⁰ K(8, r/a) + 9.512901306152344e-14 a¹² K(10, r/a) + 5.23413930620466e-16 a¹⁴ K(12, r/a) + 3.147509414702654e-18 a¹⁶ K(14, r/a) + 2.020438356945912e-20 a¹⁸ K(16, r/a) + 1.3637646770803257e-22 a²⁰ K(18, r/a) + 9.580110269201793e-25 a²² K(20, r/a) + 6.952222854295087e-27 a²⁴ K(22, r/a) + 5.183312227020364e-29 a²⁶ K(24, r/a), K(n,q) = n − (n+2) q² + 2 qⁿ⁺²    (28)
/// contact radius, mm    the a with (π m/4) J(a) = F(t) + χ ∫F dτ    (14)
/// ```
///
/// Admissible for every contact radius (all coefficients are positive); used up to 5 mm.
///
/// Surfaces are expanded in powers of r up to r²⁴. Up to r = 5 mm this changes the gap by at most 6.06e-10 of its value.
///
/// The contact radius is a polynomial from a table of 24576 bytes, in single precision of 8192, where J is between 6.9e-18 and 1.3e2; elsewhere it is iterated.
///
/// Operations of a call:
///
/// Double words round a result only once. A × of them takes 24 plain operations, or 9 if the processor multiplies and adds in one; a + takes 11.
///
/// ```text
/// gap                   13 ×, 11 + of double words
/// approach              13 ×, 11 + of double words
/// slope of the approach 13 ×, 11 + of double words
/// load integral         15 ×, 11 + of double words
/// log kernel            14 ×, 11 + of double words
/// pressure kernel       37 ×, 35 + of double words
/// ```
struct Spheres;
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
            first: -228,
            count: 256,
        },
        single: __cartcontact::Quarters {
            first: -228,
            count: 0,
        },
        rows: __cartcontact::Rows(
*b"...",
        ),
    };
    static __CURVES_OF_SINGLE: __cartcontact::SingleCurves = __cartcontact::Table {
        quarters: __cartcontact::Quarters {
            first: -228,
            count: 256,
        },
        single: __cartcontact::Quarters {
            first: -228,
            count: 256,
        },
        rows: __cartcontact::Rows(
*b"...",
        ),
    };
    #[inline(always)]
    fn __quick_steepness<T: __cartcontact::Scalar>(
        __a: T,
        [__j0,
        __j1,
        __j2,
        __j3,
        __j4,
        __j5,
        __j6,
        __j7,
        __j8,
        __j9,
        __j10,
        __j11,
        ]: [T; 12usize],
    ) -> __cartcontact::Steepness<T> {
        let __s = __a * __a;
        let __value = (__j0 + (__j1) * __s)
            + ((__j2 + (__j3) * __s)
                + ((__j4 + (__j5) * __s)
                    + ((__j6 + (__j7) * __s)
                        + ((__j8 + (__j9) * __s) + (__j10 + (__j11) * __s) * (__s * __s))
                            * (__s * __s)) * (__s * __s)) * (__s * __s)) * (__s * __s);
        __cartcontact::Steepness {
            power: __cartcontact::integer_power(__s, 3),
            value: __value,
            excess: <T as __cartcontact::Scalar>::constant(0.0f64),
            first: <T as __cartcontact::Scalar>::constant(6.0f64) * __j0
                + (<T as __cartcontact::Scalar>::constant(8.0f64) * __j1
                    + (<T as __cartcontact::Scalar>::constant(10.0f64) * __j2
                        + (<T as __cartcontact::Scalar>::constant(12.0f64) * __j3
                            + (<T as __cartcontact::Scalar>::constant(14.0f64) * __j4
                                + (<T as __cartcontact::Scalar>::constant(16.0f64) * __j5
                                    + (<T as __cartcontact::Scalar>::constant(18.0f64) * __j6
                                        + (<T as __cartcontact::Scalar>::constant(20.0f64) * __j7
                                            + (<T as __cartcontact::Scalar>::constant(22.0f64) * __j8
                                                + (<T as __cartcontact::Scalar>::constant(24.0f64) * __j9
                                                    + (<T as __cartcontact::Scalar>::constant(26.0f64) * __j10
                                                        + (<T as __cartcontact::Scalar>::constant(28.0f64) * __j11)
                                                            * __s) * __s) * __s) * __s) * __s) * __s) * __s) * __s)
                            * __s) * __s) * __s,
            half_second: <T as __cartcontact::Scalar>::constant(15.0f64) * __j0
                + (<T as __cartcontact::Scalar>::constant(28.0f64) * __j1
                    + (<T as __cartcontact::Scalar>::constant(45.0f64) * __j2
                        + (<T as __cartcontact::Scalar>::constant(66.0f64) * __j3
                            + (<T as __cartcontact::Scalar>::constant(91.0f64) * __j4
                                + (<T as __cartcontact::Scalar>::constant(120.0f64) * __j5
                                    + (<T as __cartcontact::Scalar>::constant(153.0f64) * __j6
                                        + (<T as __cartcontact::Scalar>::constant(190.0f64) * __j7
                                            + (<T as __cartcontact::Scalar>::constant(231.0f64) * __j8
                                                + (<T as __cartcontact::Scalar>::constant(276.0f64) * __j9
                                                    + (<T as __cartcontact::Scalar>::constant(325.0f64) * __j10
                                                        + (<T as __cartcontact::Scalar>::constant(378.0f64) * __j11)
                                                            * __s) * __s) * __s) * __s) * __s) * __s) * __s) * __s)
                            * __s) * __s) * __s,
            per_unit: <T as __cartcontact::Scalar>::constant(1.0f64),
        }
    }
    #[inline(always)]
    fn __last_steepness<T: __cartcontact::Scalar>(
        __a: T,
        [__j0,
        __j1,
        __j2,
        __j3,
        __j4,
        __j5,
        __j6,
        __j7,
        __j8,
        __j9,
        __j10,
        __j11,
        ]: [T; 12usize],
    ) -> __cartcontact::Steepness<T> {
        let __s = __a * __a;
        let __value = __j0
            + (__j1
                + (__j2
                    + (__j3
                        + (__j4
                            + (__j5
                                + (__j6
                                    + (__j7
                                        + (__j8 + (__j9 + (__j10 + (__j11) * __s) * __s) * __s)
                                            * __s) * __s) * __s) * __s) * __s) * __s) * __s) * __s;
        __cartcontact::Steepness {
            power: __cartcontact::integer_power(__s, 3),
            value: __value,
            excess: <T as __cartcontact::Scalar>::constant(0.0f64),
            first: <T as __cartcontact::Scalar>::constant(6.0f64) * __j0
                + (<T as __cartcontact::Scalar>::constant(8.0f64) * __j1
                    + (<T as __cartcontact::Scalar>::constant(10.0f64) * __j2
                        + (<T as __cartcontact::Scalar>::constant(12.0f64) * __j3
                            + (<T as __cartcontact::Scalar>::constant(14.0f64) * __j4
                                + (<T as __cartcontact::Scalar>::constant(16.0f64) * __j5
                                    + (<T as __cartcontact::Scalar>::constant(18.0f64) * __j6
                                        + (<T as __cartcontact::Scalar>::constant(20.0f64) * __j7
                                            + (<T as __cartcontact::Scalar>::constant(22.0f64) * __j8
                                                + (<T as __cartcontact::Scalar>::constant(24.0f64) * __j9
                                                    + (<T as __cartcontact::Scalar>::constant(26.0f64) * __j10
                                                        + (<T as __cartcontact::Scalar>::constant(28.0f64) * __j11)
                                                            * __s) * __s) * __s) * __s) * __s) * __s) * __s) * __s)
                            * __s) * __s) * __s,
            half_second: <T as __cartcontact::Scalar>::constant(15.0f64) * __j0
                + (<T as __cartcontact::Scalar>::constant(28.0f64) * __j1
                    + (<T as __cartcontact::Scalar>::constant(45.0f64) * __j2
                        + (<T as __cartcontact::Scalar>::constant(66.0f64) * __j3
                            + (<T as __cartcontact::Scalar>::constant(91.0f64) * __j4
                                + (<T as __cartcontact::Scalar>::constant(120.0f64) * __j5
                                    + (<T as __cartcontact::Scalar>::constant(153.0f64) * __j6
                                        + (<T as __cartcontact::Scalar>::constant(190.0f64) * __j7
                                            + (<T as __cartcontact::Scalar>::constant(231.0f64) * __j8
                                                + (<T as __cartcontact::Scalar>::constant(276.0f64) * __j9
                                                    + (<T as __cartcontact::Scalar>::constant(325.0f64) * __j10
                                                        + (<T as __cartcontact::Scalar>::constant(378.0f64) * __j11)
                                                            * __s) * __s) * __s) * __s) * __s) * __s) * __s) * __s)
                            * __s) * __s) * __s,
            per_unit: <T as __cartcontact::Scalar>::constant(1.0f64),
        }
    }
    #[automatically_derived]
    impl<T> __cartcontact::GapProfile<T> for Spheres
    where
        T: __cartcontact::Scalar,
    {
        #[inline]
        fn gap(&self, __r: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { __cartcontact::precise_even_sum:: < _, _, __FUSED, _ > (__r,
                2u32, __cartcontact::constants:: < T, _ > ([0.075, 0.000140625,
                6.4453125e-7, 3.936767578125e-9, 2.739715576171875e-11,
                2.0517826080322267e-13, 1.6115248203277588e-15, 1.309244055300951e-17,
                1.0910117416642606e-19, 9.273546740587335e-22, 8.00896072814794e-24,
                7.007838130931532e-26])) }
            )
        }
        #[inline]
        fn approach(&self, __a: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { __cartcontact::precise_even_sum:: < _, _, __FUSED, _ > (__a,
                2u32, __cartcontact::constants:: < T, _ > ([0.0375, 4.6875e-5,
                1.611328125e-7, 7.87353515625e-10, 4.566192626953125e-12,
                2.931118011474609e-14, 2.0144060254096985e-16, 1.4547156170010567e-18,
                1.0910117416642607e-20, 8.430497036897578e-23, 6.674133940123284e-25,
                5.390644716101178e-27])) }
            )
        }
        #[inline]
        fn approach_slope(&self, __a: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { __cartcontact::precise_even_sum:: < _, _, __FUSED, _ > (__a,
                1u32, __cartcontact::constants:: < T, _ > ([0.075, 0.0001875,
                9.66796875e-7, 6.298828125e-9, 4.566192626953125e-11,
                3.517341613769531e-13, 2.8201684355735777e-15, 2.3275449872016907e-17,
                1.9638211349956691e-19, 1.6860994073795155e-21, 1.4683094668271224e-23,
                1.2937547318642829e-25])) }
            )
        }
        #[inline]
        fn load_integral(&self, __a: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { __cartcontact::precise_even_sum:: < _, _, __FUSED, _ > (__a,
                6u32, __cartcontact::constants:: < T, _ > ([0.00625, 1.171875e-5,
                4.833984375e-8, 2.62451171875e-10, 1.6307830810546874e-12,
                1.0991692543029785e-14, 7.833801209926605e-17, 5.818862468004227e-19,
                4.4632298522628844e-21, 3.512707098707324e-23, 2.82367205159062e-25,
                2.310276306900505e-27])) }
            )
        }
        #[inline]
        fn log_kernel(&self, __x: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { __cartcontact::precise_even_sum:: < _, _, __FUSED, _ > (__x,
                4u32, __cartcontact::constants:: < T, _ > ([0.0046875, 3.90625e-6,
                1.007080078125e-8, 3.936767578125e-11, 1.9025802612304688e-13,
                1.046827861240932e-15, 6.295018829405308e-18, 4.040876713891824e-20,
                2.7275293541606515e-22, 1.9160220538403586e-24, 1.3904445708590175e-26,
                1.0366624454040728e-28])) }
            )
        }
        #[inline]
        fn excess_on_axis(&self, __a: T) -> T {
            __cartcontact::quick_even_sum(
                __a,
                6u32,
                __cartcontact::constants::<
                    T,
                    _,
                >([
                    0.0015625,
                    1.953125e-6,
                    6.04248046875e-9,
                    2.62451171875e-11,
                    1.3589859008789064e-13,
                    7.851208959306989e-16,
                    4.896125756204128e-18,
                    3.232701371113459e-20,
                    2.231614926131442e-22,
                    1.5966850448669654e-24,
                    1.1765300214960916e-26,
                    8.885678103463481e-29,
                ]),
            )
        }
        #[inline]
        fn quick_approach(&self, __a: T) -> T {
            __cartcontact::quick_even_sum(
                __a,
                2u32,
                __cartcontact::constants::<
                    T,
                    _,
                >([
                    0.0375,
                    4.6875e-5,
                    1.611328125e-7,
                    7.87353515625e-10,
                    4.566192626953125e-12,
                    2.931118011474609e-14,
                    2.0144060254096985e-16,
                    1.4547156170010567e-18,
                    1.0910117416642607e-20,
                    8.430497036897578e-23,
                    6.674133940123284e-25,
                    5.390644716101178e-27,
                ]),
            )
        }
        #[inline]
        fn quick_approach_slope(&self, __a: T) -> T {
            __cartcontact::quick_even_sum(
                __a,
                1u32,
                __cartcontact::constants::<
                    T,
                    _,
                >([
                    0.075,
                    0.0001875,
                    9.66796875e-7,
                    6.298828125e-9,
                    4.566192626953125e-11,
                    3.517341613769531e-13,
                    2.8201684355735777e-15,
                    2.3275449872016907e-17,
                    1.9638211349956691e-19,
                    1.6860994073795155e-21,
                    1.4683094668271224e-23,
                    1.2937547318642829e-25,
                ]),
            )
        }
        #[inline]
        fn quick_load_integral(&self, __a: T) -> T {
            __cartcontact::quick_even_sum(
                __a,
                6u32,
                __cartcontact::constants::<
                    T,
                    _,
                >([
                    0.00625,
                    1.171875e-5,
                    4.833984375e-8,
                    2.62451171875e-10,
                    1.6307830810546874e-12,
                    1.0991692543029785e-14,
                    7.833801209926605e-17,
                    5.818862468004227e-19,
                    4.4632298522628844e-21,
                    3.512707098707324e-23,
                    2.82367205159062e-25,
                    2.310276306900505e-27,
                ]),
            )
        }
        #[inline]
        fn pressure_kernel(&self, __a: T, __r: T) -> T {
            __cartcontact::in_double_words!(
                __FUSED => { __cartcontact::even_pressure_kernel:: < _, _, __FUSED, _ >
                (__a, __r, __cartcontact::constants:: < T, _ > ([0.0046875, 3.90625e-6,
                1.007080078125e-8, 3.936767578125e-11, 1.9025802612304688e-13,
                1.046827861240932e-15, 6.295018829405308e-18, 4.040876713891824e-20,
                2.7275293541606515e-22, 1.9160220538403586e-24, 1.3904445708590175e-26,
                1.0366624454040728e-28])) }
            )
        }
        #[inline(always)]
        fn quick_pressure_kernel(&self, __a: T, __r: T) -> T {
            __cartcontact::quick_high_even_pressure_kernel(
                __a,
                __r,
                __cartcontact::constants::<
                    T,
                    _,
                >([
                    0.0046875,
                    3.90625e-6,
                    1.007080078125e-8,
                    3.936767578125e-11,
                    1.9025802612304688e-13,
                    1.046827861240932e-15,
                    6.295018829405308e-18,
                    4.040876713891824e-20,
                    2.7275293541606515e-22,
                    1.9160220538403586e-24,
                    1.3904445708590175e-26,
                    1.0366624454040728e-28,
                ]),
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
                        __cartcontact::WholePowers::radius(
                            &__cartcontact::WholePowers::<_, _, _, 12usize, 1> {
                                coefficients: [
                                    <T as __cartcontact::Scalar>::constant(0.00625f64),
                                    <T as __cartcontact::Scalar>::constant(1.171875e-5f64),
                                    <T as __cartcontact::Scalar>::constant(4.833984375e-8f64),
                                    <T as __cartcontact::Scalar>::constant(
                                        2.62451171875e-10f64,
                                    ),
                                    <T as __cartcontact::Scalar>::constant(
                                        1.6307830810546874e-12f64,
                                    ),
                                    <T as __cartcontact::Scalar>::constant(
                                        1.0991692543029785e-14f64,
                                    ),
                                    <T as __cartcontact::Scalar>::constant(
                                        7.833801209926605e-17f64,
                                    ),
                                    <T as __cartcontact::Scalar>::constant(
                                        5.818862468004227e-19f64,
                                    ),
                                    <T as __cartcontact::Scalar>::constant(
                                        4.4632298522628844e-21f64,
                                    ),
                                    <T as __cartcontact::Scalar>::constant(
                                        3.512707098707324e-23f64,
                                    ),
                                    <T as __cartcontact::Scalar>::constant(
                                        2.82367205159062e-25f64,
                                    ),
                                    <T as __cartcontact::Scalar>::constant(
                                        2.310276306900505e-27f64,
                                    ),
                                ],
                                powers: [6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28],
                                steepness: __quick_steepness,
                                last_steepness: __last_steepness,
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
                                        <T as __cartcontact::Scalar>::constant(0.075f64),
                                        <T as __cartcontact::Scalar>::constant(2.0f64),
                                    ),
                                    (
                                        <T as __cartcontact::Scalar>::constant(0.000140625f64),
                                        <T as __cartcontact::Scalar>::constant(4.0f64),
                                    ),
                                    (
                                        <T as __cartcontact::Scalar>::constant(6.4453125e-7f64),
                                        <T as __cartcontact::Scalar>::constant(6.0f64),
                                    ),
                                    (
                                        <T as __cartcontact::Scalar>::constant(
                                            3.936767578125e-9f64,
                                        ),
                                        <T as __cartcontact::Scalar>::constant(8.0f64),
                                    ),
                                    (
                                        <T as __cartcontact::Scalar>::constant(
                                            2.739715576171875e-11f64,
                                        ),
                                        <T as __cartcontact::Scalar>::constant(10.0f64),
                                    ),
                                    (
                                        <T as __cartcontact::Scalar>::constant(
                                            2.0517826080322267e-13f64,
                                        ),
                                        <T as __cartcontact::Scalar>::constant(12.0f64),
                                    ),
                                    (
                                        <T as __cartcontact::Scalar>::constant(
                                            1.6115248203277588e-15f64,
                                        ),
                                        <T as __cartcontact::Scalar>::constant(14.0f64),
                                    ),
                                    (
                                        <T as __cartcontact::Scalar>::constant(
                                            1.309244055300951e-17f64,
                                        ),
                                        <T as __cartcontact::Scalar>::constant(16.0f64),
                                    ),
                                    (
                                        <T as __cartcontact::Scalar>::constant(
                                            1.0910117416642606e-19f64,
                                        ),
                                        <T as __cartcontact::Scalar>::constant(18.0f64),
                                    ),
                                    (
                                        <T as __cartcontact::Scalar>::constant(
                                            9.273546740587335e-22f64,
                                        ),
                                        <T as __cartcontact::Scalar>::constant(20.0f64),
                                    ),
                                    (
                                        <T as __cartcontact::Scalar>::constant(
                                            8.00896072814794e-24f64,
                                        ),
                                        <T as __cartcontact::Scalar>::constant(22.0f64),
                                    ),
                                    (
                                        <T as __cartcontact::Scalar>::constant(
                                            7.007838130931532e-26f64,
                                        ),
                                        <T as __cartcontact::Scalar>::constant(24.0f64),
                                    ),
                                ],
                                false,
                                |__a| {
                                    let __x = __a * __a;
                                    let (__value, __slope) = __cartcontact::value_and_slope(
                                        __x,
                                        __cartcontact::constants::<
                                            T,
                                            _,
                                        >([
                                            0.00625,
                                            1.171875e-5,
                                            4.833984375e-8,
                                            2.62451171875e-10,
                                            1.6307830810546874e-12,
                                            1.0991692543029785e-14,
                                            7.833801209926605e-17,
                                            5.818862468004227e-19,
                                            4.4632298522628844e-21,
                                            3.512707098707324e-23,
                                            2.82367205159062e-25,
                                            2.310276306900505e-27,
                                        ]),
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
                                        __FUSED, _ > (__a, 6u32, __cartcontact::constants:: < T, _ >
                                        ([0.00625, 1.171875e-5, 4.833984375e-8, 2.62451171875e-10,
                                        1.6307830810546874e-12, 1.0991692543029785e-14,
                                        7.833801209926605e-17, 5.818862468004227e-19,
                                        4.4632298522628844e-21, 3.512707098707324e-23,
                                        2.82367205159062e-25, 2.310276306900505e-27])) }
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
                #[inline(always)]
                |__load_integral, __more| __cartcontact::WholePowers::solve(
                    &__cartcontact::WholePowers::<_, _, _, 12usize, 1> {
                        coefficients: [
                            <T as __cartcontact::Scalar>::constant(0.00625f64),
                            <T as __cartcontact::Scalar>::constant(1.171875e-5f64),
                            <T as __cartcontact::Scalar>::constant(4.833984375e-8f64),
                            <T as __cartcontact::Scalar>::constant(2.62451171875e-10f64),
                            <T as __cartcontact::Scalar>::constant(
                                1.6307830810546874e-12f64,
                            ),
                            <T as __cartcontact::Scalar>::constant(
                                1.0991692543029785e-14f64,
                            ),
                            <T as __cartcontact::Scalar>::constant(
                                7.833801209926605e-17f64,
                            ),
                            <T as __cartcontact::Scalar>::constant(
                                5.818862468004227e-19f64,
                            ),
                            <T as __cartcontact::Scalar>::constant(
                                4.4632298522628844e-21f64,
                            ),
                            <T as __cartcontact::Scalar>::constant(
                                3.512707098707324e-23f64,
                            ),
                            <T as __cartcontact::Scalar>::constant(
                                2.82367205159062e-25f64,
                            ),
                            <T as __cartcontact::Scalar>::constant(
                                2.310276306900505e-27f64,
                            ),
                        ],
                        powers: [6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28],
                        steepness: __quick_steepness,
                        last_steepness: __last_steepness,
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
                    __cartcontact::constants::<
                        T,
                        _,
                    >([
                        -0.0,
                        -0.0,
                        -0.0,
                        0.00625,
                        1.171875e-5,
                        4.833984375e-8,
                        2.62451171875e-10,
                        1.6307830810546874e-12,
                        1.0991692543029785e-14,
                        7.833801209926605e-17,
                        5.818862468004227e-19,
                        4.4632298522628844e-21,
                        3.512707098707324e-23,
                        2.82367205159062e-25,
                        2.310276306900505e-27,
                    ]),
                )
        }
        #[inline]
        fn fill_slopes_and_drops(
            &self,
            __a: T,
            __places: (&[T], &[T]),
            __values: (&mut [T], &mut [T]),
        ) {
            __cartcontact::fill_long_sums::<
                _,
                true,
                _,
                _,
            >(
                __a,
                __places,
                __values,
                (
                    __cartcontact::constants::<
                        T,
                        _,
                    >([
                        0.075,
                        0.0001875,
                        9.66796875e-7,
                        6.298828125e-9,
                        4.566192626953125e-11,
                        3.517341613769531e-13,
                        2.8201684355735777e-15,
                        2.3275449872016907e-17,
                        1.9638211349956691e-19,
                        1.6860994073795155e-21,
                        1.4683094668271224e-23,
                        1.2937547318642829e-25,
                    ]),
                    __cartcontact::constants::<
                        T,
                        _,
                    >([
                        -0.0,
                        -0.0,
                        -0.0,
                        0.00625,
                        1.171875e-5,
                        4.833984375e-8,
                        2.62451171875e-10,
                        1.6307830810546874e-12,
                        1.0991692543029785e-14,
                        7.833801209926605e-17,
                        5.818862468004227e-19,
                        4.4632298522628844e-21,
                        3.512707098707324e-23,
                        2.82367205159062e-25,
                        2.310276306900505e-27,
                    ]),
                ),
            )
        }
        #[inline]
        fn max_radius(&self) -> T {
            <T as __cartcontact::Scalar>::constant(5.0f64)
        }
        #[inline]
        fn highest_exponent(&self) -> T {
            <T as __cartcontact::Scalar>::constant(24.0f64)
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
    impl Spheres {
        /// The terms of the gap Σ C rⁿ as pairs (C, n), in ascending order of their exponents.
        pub const TERMS: [(::core::primitive::f64, ::core::primitive::f64); 12usize] = [
            (0.075f64, 2.0f64),
            (0.000140625f64, 4.0f64),
            (6.4453125e-7f64, 6.0f64),
            (3.936767578125e-9f64, 8.0f64),
            (2.739715576171875e-11f64, 10.0f64),
            (2.0517826080322267e-13f64, 12.0f64),
            (1.6115248203277588e-15f64, 14.0f64),
            (1.309244055300951e-17f64, 16.0f64),
            (1.0910117416642606e-19f64, 18.0f64),
            (9.273546740587335e-22f64, 20.0f64),
            (8.00896072814794e-24f64, 22.0f64),
            (7.007838130931532e-26f64, 24.0f64),
        ];
        /// The largest contact radius that the geometry is proved for, in mm; infinity if there is no limit.
        pub const MAX_RADIUS: ::core::primitive::f64 = 5.0f64;
        /// How much of the exact gap the expansion of its surfaces neglects, at most, up to `MAX_RADIUS`.
        pub const TRUNCATION_ERROR: ::core::primitive::f64 = 6.06e-10f64;
    }
};
