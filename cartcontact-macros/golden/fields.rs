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
    #[allow(
        clippy::possible_missing_comma,
        reason = "generated operators seem to span an attribute's lines"
    )]
    #[inline]
    fn coefficients<T>(profile: &Ball) -> [T; 2usize]
    where
        T: crate::renamed::Scalar,
    {
        let radius = <T as crate::renamed::Scalar>::constant(profile.radius);
        [
            <T as crate::renamed::Scalar>::constant(0.5f64) / radius,
            <T as crate::renamed::Scalar>::constant(0.125f64)
                / ({
                    let base = radius;
                    base * base * base
                }),
        ]
    }
    #[automatically_derived]
    impl<T> crate::renamed::GapProfile<T> for Ball
    where
        T: crate::renamed::Scalar,
    {
        #[inline]
        fn gap(&self, r: T) -> T {
            let [c0, c1]: [T; 2usize] = coefficients(self);
            let s = r * r;
            (c0 + (c1) * s) * s
        }
        #[inline]
        fn approach(&self, a: T) -> T {
            let [c0, c1]: [T; 2usize] = coefficients(self);
            let s = a * a;
            (c0 * <T as crate::renamed::Scalar>::constant(0.5f64)
                + (c1 * <T as crate::renamed::Scalar>::constant(0.3333333333333333f64))
                    * s) * s
        }
        #[inline]
        fn approach_slope(&self, a: T) -> T {
            let [c0, c1]: [T; 2usize] = coefficients(self);
            let s = a * a;
            (c0
                + (c1 * <T as crate::renamed::Scalar>::constant(1.3333333333333333f64))
                    * s) * a
        }
        #[inline]
        fn load_integral(&self, a: T) -> T {
            let [c0, c1]: [T; 2usize] = coefficients(self);
            let s = a * a;
            (c0 * <T as crate::renamed::Scalar>::constant(0.08333333333333333f64)
                + (c1 * <T as crate::renamed::Scalar>::constant(0.08333333333333333f64))
                    * s) * s * s * s
        }
        #[inline]
        fn log_kernel(&self, x: T) -> T {
            let [c0, c1]: [T; 2usize] = coefficients(self);
            let s = x * x;
            (c0 * <T as crate::renamed::Scalar>::constant(0.0625f64)
                + (c1 * <T as crate::renamed::Scalar>::constant(0.027777777777777776f64))
                    * s) * s * s
        }
        #[inline]
        fn pressure_kernel(&self, a: T, r: T) -> T {
            let [c0, c1]: [T; 2usize] = coefficients(self);
            if r >= a {
                return <T as crate::renamed::Scalar>::constant(0.0f64);
            }
            let (a_squared, r_squared) = (a * a, r * r);
            let t1 = a_squared + r_squared;
            let s2 = a_squared + t1;
            let inset = (a - r) * (a + r);
            inset
                * (c0 * <T as crate::renamed::Scalar>::constant(0.0625f64)
                    + c1
                        * <T as crate::renamed::Scalar>::constant(
                            0.027777777777777776f64,
                        ) * s2) * inset
        }
        #[inline]
        fn radius_within(
            &self,
            load_integral: T,
            limit: T,
        ) -> ::core::result::Result<T, crate::renamed::RadiusError> {
            let [c0, c1]: [T; 2usize] = coefficients(self);
            crate::renamed::generated::invert(
                load_integral,
                limit,
                crate::renamed::generated::positive_terms([
                    (c0, <T as crate::renamed::Scalar>::constant(2.0f64)),
                    (c1, <T as crate::renamed::Scalar>::constant(4.0f64)),
                ]),
                c0 < <T as crate::renamed::Scalar>::constant(0.0f64)
                    || c1 < <T as crate::renamed::Scalar>::constant(0.0f64),
                |a| {
                    let x = a * a;
                    let (value, slope) = crate::renamed::generated::value_and_slope(
                        x,
                        [
                            c0
                                * <T as crate::renamed::Scalar>::constant(
                                    0.08333333333333333f64,
                                ),
                            c1
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
            let [c0, c1]: [T; 2usize] = coefficients(self);
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
                            c0
                                * <T as crate::renamed::Scalar>::constant(
                                    0.08333333333333333f64,
                                ),
                            c1
                                * <T as crate::renamed::Scalar>::constant(
                                    0.08333333333333333f64,
                                ),
                        ],
                    ))
        }
        fn max_radius(&self) -> T {
            let [c0, c1]: [T; 2usize] = coefficients(self);
            match crate::renamed::generated::checked_range(
                ::core::iter::IntoIterator::into_iter([
                    (c0, <T as crate::renamed::Scalar>::constant(2.0f64)),
                    (c1, <T as crate::renamed::Scalar>::constant(4.0f64)),
                ]),
                ::core::option::Option::Some({
                    let limit = <T as crate::renamed::Scalar>::constant(
                        <f64 as ::core::convert::From<f32>>::from(self.limit),
                    );
                    limit
                }),
            ) {
                ::core::result::Result::Ok(end) => end,
                ::core::result::Result::Err(_) => {
                    <T as crate::renamed::Scalar>::constant(0.0f64)
                }
            }
        }
        fn check(&self) -> ::core::result::Result<(), crate::renamed::ProfileError> {
            let [c0, c1]: [T; 2usize] = coefficients(self);
            match crate::renamed::generated::checked_range(
                ::core::iter::IntoIterator::into_iter([
                    (c0, <T as crate::renamed::Scalar>::constant(2.0f64)),
                    (c1, <T as crate::renamed::Scalar>::constant(4.0f64)),
                ]),
                ::core::option::Option::Some({
                    let limit = <T as crate::renamed::Scalar>::constant(
                        <f64 as ::core::convert::From<f32>>::from(self.limit),
                    );
                    limit
                }),
            ) {
                ::core::result::Result::Ok(_) => ::core::result::Result::Ok(()),
                ::core::result::Result::Err(error) => {
                    ::core::result::Result::Err({
                        let radius = <T as crate::renamed::Scalar>::constant(
                            self.radius,
                        );
                        let limit = <T as crate::renamed::Scalar>::constant(
                            <f64 as ::core::convert::From<f32>>::from(self.limit),
                        );
                        crate::renamed::generated::with_parameters(
                            error,
                            &["radius", "limit"],
                            [radius, limit],
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
            let [c0, c1]: [T; 2usize] = coefficients(self);
            [
                (c0, <T as crate::renamed::Scalar>::constant(2.0f64)),
                (c1, <T as crate::renamed::Scalar>::constant(4.0f64)),
            ]
        }
    }
};
