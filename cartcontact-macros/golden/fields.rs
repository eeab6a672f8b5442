///
/// # Derived from the gap profile
///
/// Lengths in mm; equation numbers of I. Argatov, Mech. Res. Commun. 38 (2011) 29–33, doi 10.1016/j.mechrescom.2010.11.006.
///
/// ```text
/// gap, mm               Φ(r)   = 1/(2·radius) r² + 1/(8·radius^3) r⁴
/// approach, mm          δ₀(a)  = 1/(4·radius) a² + 1/(24·radius^3) a⁴    (10)
/// slope of the approach δ₀′(a) = 1/(2·radius) a + 1/(6·radius^3) a³
/// load integral, mm⁵    J(a)   = 1/(24·radius) a⁶ + 1/(96·radius^3) a⁸    (14)
/// log kernel, mm³       L(x)   = 1/(32·radius) x⁴ + 1/(288·radius^3) x⁶    (28)
/// pressure kernel, mm³  G(a,r) = (a² − r²)² [1/(32·radius) + 1/(288·radius^3) (2 a² + r²)]    (28)
/// contact radius, mm    the a with (π m/4) J(a) = F(t) + χ ∫F dτ    (14)
/// ```
///
/// Admissibility depends on the fields and is checked when a `Contact` is made.
///
/// Operations of a call, as generated:
///
/// ```text
/// gap                   3 × or ÷, 1 + or −
/// approach              5 × or ÷, 1 + or −
/// slope of the approach 4 × or ÷, 1 + or −
/// load integral         7 × or ÷, 1 + or −
/// log kernel            6 × or ÷, 1 + or −
/// pressure kernel       8 × or ÷, 5 + or −
/// coefficients          4 × or ÷, 0 + or −, in addition
/// ```
struct Ball {
    radius: f64,
    limit: f32,
    name: String,
}
const _: () = {
    #[allow(
        clippy::multiple_bound_locations,
        reason = "the struct may bound its parameter in place"
    )]
    #[inline]
    fn coefficients<T>(__profile: &Ball) -> [T; 2usize]
    where
        T: crate::renamed::Scalar,
    {
        let __field_radius = <T as crate::renamed::Scalar>::constant(__profile.radius);
        [
            <T as crate::renamed::Scalar>::constant(0.5f64) / __field_radius,
            <T as crate::renamed::Scalar>::constant(0.125f64)
                / ({
                    let __base = __field_radius;
                    __base * __base * __base
                }),
        ]
    }
    #[automatically_derived]
    impl<T> crate::renamed::GapProfile<T> for Ball
    where
        T: crate::renamed::Scalar,
    {
        #[inline]
        fn gap(&self, __r: T) -> T {
            let [__c0, __c1]: [T; 2usize] = coefficients(self);
            let __s = __r * __r;
            (__c0 + (__c1) * __s) * __s
        }
        #[inline]
        fn approach(&self, __a: T) -> T {
            let [__c0, __c1]: [T; 2usize] = coefficients(self);
            let __s = __a * __a;
            (__c0 * <T as crate::renamed::Scalar>::constant(0.5f64)
                + (__c1 * <T as crate::renamed::Scalar>::constant(0.3333333333333333f64))
                    * __s) * __s
        }
        #[inline]
        fn approach_slope(&self, __a: T) -> T {
            let [__c0, __c1]: [T; 2usize] = coefficients(self);
            let __s = __a * __a;
            (__c0
                + (__c1 * <T as crate::renamed::Scalar>::constant(1.3333333333333333f64))
                    * __s) * __a
        }
        #[inline]
        fn load_integral(&self, __a: T) -> T {
            let [__c0, __c1]: [T; 2usize] = coefficients(self);
            let __s = __a * __a;
            (__c0 * <T as crate::renamed::Scalar>::constant(0.08333333333333333f64)
                + (__c1
                    * <T as crate::renamed::Scalar>::constant(0.08333333333333333f64))
                    * __s) * __s * __s * __s
        }
        #[inline]
        fn log_kernel(&self, __x: T) -> T {
            let [__c0, __c1]: [T; 2usize] = coefficients(self);
            let __s = __x * __x;
            (__c0 * <T as crate::renamed::Scalar>::constant(0.0625f64)
                + (__c1
                    * <T as crate::renamed::Scalar>::constant(0.027777777777777776f64))
                    * __s) * __s * __s
        }
        #[inline]
        fn pressure_kernel(&self, __a: T, __r: T) -> T {
            let [__c0, __c1]: [T; 2usize] = coefficients(self);
            if __r >= __a {
                return <T as crate::renamed::Scalar>::constant(0.0f64);
            }
            let (__a_squared, __r_squared) = (__a * __a, __r * __r);
            let __t1 = __a_squared + __r_squared;
            let __s2 = __a_squared + __t1;
            let __inset = (__a - __r) * (__a + __r);
            __inset
                * (__c0 * <T as crate::renamed::Scalar>::constant(0.0625f64)
                    + __c1
                        * <T as crate::renamed::Scalar>::constant(
                            0.027777777777777776f64,
                        ) * __s2) * __inset
        }
        #[inline]
        fn radius_within(
            &self,
            load_integral: T,
            limit: T,
        ) -> ::core::result::Result<T, crate::renamed::RadiusError> {
            let [__c0, __c1]: [T; 2usize] = coefficients(self);
            crate::renamed::generated::invert(
                load_integral,
                limit,
                crate::renamed::generated::positive_terms([
                    (__c0, <T as crate::renamed::Scalar>::constant(2.0f64)),
                    (__c1, <T as crate::renamed::Scalar>::constant(4.0f64)),
                ]),
                __c0 < <T as crate::renamed::Scalar>::constant(0.0f64)
                    || __c1 < <T as crate::renamed::Scalar>::constant(0.0f64),
                |a| {
                    let x = a * a;
                    let (value, slope) = crate::renamed::generated::value_and_slope(
                        x,
                        [
                            __c0
                                * <T as crate::renamed::Scalar>::constant(
                                    0.08333333333333333f64,
                                ),
                            __c1
                                * <T as crate::renamed::Scalar>::constant(
                                    0.08333333333333333f64,
                                ),
                        ],
                    );
                    let log_slope = <T as crate::renamed::Scalar>::constant(6.0f64)
                        * value
                        + <T as crate::renamed::Scalar>::constant(2.0f64) * x * slope;
                    (value * x * x * x, log_slope * x * x * x)
                },
            )
        }
        #[inline]
        fn load_integral_drop(&self, a: T, depth: T) -> T {
            let [__c0, __c1]: [T; 2usize] = coefficients(self);
            let s = a - depth;
            depth
                * ((a + s)
                    * crate::renamed::generated::divided_difference(
                        a * a,
                        s * s,
                        [
                            <T as crate::renamed::Scalar>::constant(0.0f64),
                            <T as crate::renamed::Scalar>::constant(0.0f64),
                            <T as crate::renamed::Scalar>::constant(0.0f64),
                            __c0
                                * <T as crate::renamed::Scalar>::constant(
                                    0.08333333333333333f64,
                                ),
                            __c1
                                * <T as crate::renamed::Scalar>::constant(
                                    0.08333333333333333f64,
                                ),
                        ],
                    ))
        }
        fn max_radius(&self) -> T {
            let [__c0, __c1]: [T; 2usize] = coefficients(self);
            match crate::renamed::generated::checked_range(
                ::core::iter::IntoIterator::into_iter([
                    (__c0, <T as crate::renamed::Scalar>::constant(2.0f64)),
                    (__c1, <T as crate::renamed::Scalar>::constant(4.0f64)),
                ]),
                ::core::option::Option::Some({
                    let __field_limit = <T as crate::renamed::Scalar>::constant(
                        <f64 as ::core::convert::From<f32>>::from(self.limit),
                    );
                    __field_limit
                }),
            ) {
                ::core::result::Result::Ok(__end) => __end,
                ::core::result::Result::Err(_) => {
                    <T as crate::renamed::Scalar>::constant(0.0f64)
                }
            }
        }
        fn check(&self) -> ::core::result::Result<(), crate::renamed::ProfileError> {
            let [__c0, __c1]: [T; 2usize] = coefficients(self);
            match crate::renamed::generated::checked_range(
                ::core::iter::IntoIterator::into_iter([
                    (__c0, <T as crate::renamed::Scalar>::constant(2.0f64)),
                    (__c1, <T as crate::renamed::Scalar>::constant(4.0f64)),
                ]),
                ::core::option::Option::Some({
                    let __field_limit = <T as crate::renamed::Scalar>::constant(
                        <f64 as ::core::convert::From<f32>>::from(self.limit),
                    );
                    __field_limit
                }),
            ) {
                ::core::result::Result::Ok(_) => ::core::result::Result::Ok(()),
                ::core::result::Result::Err(__error) => {
                    ::core::result::Result::Err({
                        let __field_radius = <T as crate::renamed::Scalar>::constant(
                            self.radius,
                        );
                        let __field_limit = <T as crate::renamed::Scalar>::constant(
                            <f64 as ::core::convert::From<f32>>::from(self.limit),
                        );
                        crate::renamed::generated::with_parameters(
                            __error,
                            &["radius", "limit"],
                            [__field_radius, __field_limit],
                        )
                    })
                }
            }
        }
        #[inline]
        fn highest_exponent(&self) -> T {
            <T as crate::renamed::Scalar>::constant(4.0f64)
        }
        #[inline]
        fn is_smooth_at_centre(&self) -> bool {
            true
        }
    }
    #[allow(dead_code, unreachable_pub, reason = "a program need not ask for them")]
    impl Ball {
        /// The terms of the gap Σ C rⁿ as pairs (C, n), in ascending order of their exponents.
        pub fn terms<T: crate::renamed::Scalar>(&self) -> [(T, T); 2usize] {
            let [__c0, __c1]: [T; 2usize] = coefficients(self);
            [
                (__c0, <T as crate::renamed::Scalar>::constant(2.0f64)),
                (__c1, <T as crate::renamed::Scalar>::constant(4.0f64)),
            ]
        }
    }
};
