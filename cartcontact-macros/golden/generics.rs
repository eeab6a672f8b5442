///
/// # Derived from the gap profile
///
/// Lengths in mm; equation numbers of I. Argatov, Mech. Res. Commun. 38 (2011) 29–33, doi 10.1016/j.mechrescom.2010.11.006.
///
/// ```text
/// gap, mm               Φ(r)   = c r² + 1/c^0.5 r^2.5
/// approach, mm          δ₀(a)  = c/2 a² + 4/(9·c^0.5) a^2.5    (10)
/// slope of the approach δ₀′(a) = c a + 10/(9·c^0.5) a^1.5
/// load integral, mm⁵    J(a)   = c/12 a⁶ + 10/(117·c^0.5) a^6.5    (14)
/// log kernel, mm³       L(x)   = c/16 x⁴ + 4/(81·c^0.5) x^4.5    (28)
/// pressure kernel, mm³  G(a,r) = c/32 a⁴ K(2, r/a) + 2/(81·c^0.5) a^4.5 K(2.5, r/a), K(n,q) = n − (n+2) q² + 2 qⁿ⁺²    (28)
/// contact radius, mm    the a with (π m/4) J(a) = F(t) + χ ∫F dτ    (14)
/// ```
///
/// Admissibility depends on the fields and is checked when a `Contact` is made.
///
struct Any<'a, S: Copy, T>
where
    T: Clone,
{
    c: S,
    tag: &'a T,
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
    fn coefficients<'a, S: Copy, T>(profile: &Any<'a, S, T>) -> [S; 2usize]
    where
        T: Clone,
        S: ::cartcontact::Scalar,
    {
        let c = profile.c;
        [
            c,
            ::cartcontact::generated::real_power(
                c,
                <S as ::cartcontact::Scalar>::constant(-0.5f64),
            ),
        ]
    }
    #[automatically_derived]
    impl<'a, S: Copy, T> ::cartcontact::GapProfile<S> for Any<'a, S, T>
    where
        T: Clone,
        S: ::cartcontact::Scalar,
    {
        #[inline]
        fn gap(&self, r: S) -> S {
            let [c0, c1]: [S; 2usize] = coefficients(self);
            ::cartcontact::generated::power_sum(
                r,
                [
                    (c0, <S as ::cartcontact::Scalar>::constant(2.0f64)),
                    (c1, <S as ::cartcontact::Scalar>::constant(2.5f64)),
                ],
            )
        }
        #[inline]
        fn approach(&self, a: S) -> S {
            let [c0, c1]: [S; 2usize] = coefficients(self);
            ::cartcontact::generated::power_sum(
                a,
                [
                    (
                        c0 * <S as ::cartcontact::Scalar>::constant(0.5f64),
                        <S as ::cartcontact::Scalar>::constant(2.0f64),
                    ),
                    (
                        c1
                            * <S as ::cartcontact::Scalar>::constant(
                                0.4444444444444444f64,
                            ),
                        <S as ::cartcontact::Scalar>::constant(2.5f64),
                    ),
                ],
            )
        }
        #[inline]
        fn approach_slope(&self, a: S) -> S {
            let [c0, c1]: [S; 2usize] = coefficients(self);
            ::cartcontact::generated::power_sum(
                a,
                [
                    (c0, <S as ::cartcontact::Scalar>::constant(1.0f64)),
                    (
                        c1
                            * <S as ::cartcontact::Scalar>::constant(
                                1.1111111111111112f64,
                            ),
                        <S as ::cartcontact::Scalar>::constant(1.5f64),
                    ),
                ],
            )
        }
        #[inline]
        fn load_integral(&self, a: S) -> S {
            let [c0, c1]: [S; 2usize] = coefficients(self);
            ::cartcontact::generated::power_sum(
                a,
                [
                    (
                        c0
                            * <S as ::cartcontact::Scalar>::constant(
                                0.08333333333333333f64,
                            ),
                        <S as ::cartcontact::Scalar>::constant(6.0f64),
                    ),
                    (
                        c1
                            * <S as ::cartcontact::Scalar>::constant(
                                0.08547008547008547f64,
                            ),
                        <S as ::cartcontact::Scalar>::constant(6.5f64),
                    ),
                ],
            )
        }
        #[inline]
        fn log_kernel(&self, x: S) -> S {
            let [c0, c1]: [S; 2usize] = coefficients(self);
            ::cartcontact::generated::power_sum(
                x,
                [
                    (
                        c0 * <S as ::cartcontact::Scalar>::constant(0.0625f64),
                        <S as ::cartcontact::Scalar>::constant(4.0f64),
                    ),
                    (
                        c1
                            * <S as ::cartcontact::Scalar>::constant(
                                0.04938271604938271f64,
                            ),
                        <S as ::cartcontact::Scalar>::constant(4.5f64),
                    ),
                ],
            )
        }
        #[inline]
        fn pressure_kernel(&self, a: S, r: S) -> S {
            let [c0, c1]: [S; 2usize] = coefficients(self);
            ::cartcontact::generated::pressure_kernel(
                a,
                r,
                [
                    (c0, <S as ::cartcontact::Scalar>::constant(2.0f64)),
                    (c1, <S as ::cartcontact::Scalar>::constant(2.5f64)),
                ],
            )
        }
        #[inline]
        fn radius_within(
            &self,
            load_integral: S,
            limit: S,
        ) -> ::core::result::Result<S, ::cartcontact::RadiusError> {
            let [c0, c1]: [S; 2usize] = coefficients(self);
            ::cartcontact::generated::invert(
                load_integral,
                limit,
                ::cartcontact::generated::positive_terms([
                    (c0, <S as ::cartcontact::Scalar>::constant(2.0f64)),
                    (c1, <S as ::cartcontact::Scalar>::constant(2.5f64)),
                ]),
                c0 < <S as ::cartcontact::Scalar>::constant(0.0f64),
                |a| {
                    ::cartcontact::generated::power_sum_and_log_slope(
                        a,
                        [
                            (
                                c0
                                    * <S as ::cartcontact::Scalar>::constant(
                                        0.08333333333333333f64,
                                    ),
                                <S as ::cartcontact::Scalar>::constant(6.0f64),
                            ),
                            (
                                c1
                                    * <S as ::cartcontact::Scalar>::constant(
                                        0.08547008547008547f64,
                                    ),
                                <S as ::cartcontact::Scalar>::constant(6.5f64),
                            ),
                        ],
                    )
                },
            )
        }
        #[inline]
        fn load_integral_drop(&self, a: S, depth: S) -> S {
            let [c0, c1]: [S; 2usize] = coefficients(self);
            ::cartcontact::generated::power_sum_drop(
                a,
                depth,
                [
                    (
                        c0
                            * <S as ::cartcontact::Scalar>::constant(
                                0.08333333333333333f64,
                            ),
                        <S as ::cartcontact::Scalar>::constant(6.0f64),
                    ),
                    (
                        c1
                            * <S as ::cartcontact::Scalar>::constant(
                                0.08547008547008547f64,
                            ),
                        <S as ::cartcontact::Scalar>::constant(6.5f64),
                    ),
                ],
            )
        }
        fn max_radius(&self) -> S {
            let [c0, c1]: [S; 2usize] = coefficients(self);
            match ::cartcontact::generated::checked_range(
                ::core::iter::IntoIterator::into_iter([
                    (c0, <S as ::cartcontact::Scalar>::constant(2.0f64)),
                    (c1, <S as ::cartcontact::Scalar>::constant(2.5f64)),
                ]),
                ::core::option::Option::None,
            ) {
                ::core::result::Result::Ok(end) => end,
                ::core::result::Result::Err(_) => {
                    <S as ::cartcontact::Scalar>::constant(0.0f64)
                }
            }
        }
        fn check(&self) -> ::core::result::Result<(), ::cartcontact::ProfileError> {
            let [c0, c1]: [S; 2usize] = coefficients(self);
            match ::cartcontact::generated::checked_range(
                ::core::iter::IntoIterator::into_iter([
                    (c0, <S as ::cartcontact::Scalar>::constant(2.0f64)),
                    (c1, <S as ::cartcontact::Scalar>::constant(2.5f64)),
                ]),
                ::core::option::Option::None,
            ) {
                ::core::result::Result::Ok(_) => ::core::result::Result::Ok(()),
                ::core::result::Result::Err(error) => {
                    ::core::result::Result::Err({
                        let c = self.c;
                        ::cartcontact::generated::with_parameters(error, &["c"], [c])
                    })
                }
            }
        }
        #[inline]
        fn highest_exponent(&self) -> S {
            <S as ::cartcontact::Scalar>::constant(2.5f64)
        }
        #[inline]
        fn is_smooth_at_centre(&self) -> bool {
            false
        }
    }
    #[allow(dead_code, unreachable_pub, reason = "a program need not ask for them")]
    impl<'a, S: Copy, T> Any<'a, S, T>
    where
        T: Clone,
        S: ::cartcontact::Scalar,
    {
        /// The terms of the gap Σ C rⁿ as pairs (C, n), in ascending order of their exponents.
        pub fn terms(&self) -> [(S, S); 2usize] {
            let [c0, c1]: [S; 2usize] = coefficients(self);
            [
                (c0, <S as ::cartcontact::Scalar>::constant(2.0f64)),
                (c1, <S as ::cartcontact::Scalar>::constant(2.5f64)),
            ]
        }
    }
};
