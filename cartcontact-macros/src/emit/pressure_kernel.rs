//! The pressure kernel G(a, r) as code.
//!
//! For even exponents up to 8 it is written out. With n = 2 k, A = a², R = r²,
//!
//! ```text
//! G = (A − R)² Σ C/(n+2)² S_k,    S_k = Σ_{j<k} (k − j) R^j A^(k−1−j)
//! S_1 = 1,  T_0 = 1,    T_k = A T_{k−1} + R^k,    S_{k+1} = A S_k + T_k
//! ```
//!
//! which are sums of positive terms, without a division. Higher and other exponents go through the run-time
//! crate's kernel, whose accuracy does not depend on the exponent.

use num_traits::ToPrimitive;
use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::coefficients::Coefficients;
use super::{Names, local};
use crate::gap::Gap;
use crate::number::integer;

const HIGHEST_WRITTEN_OUT: u32 = 8;

pub(super) fn method(gap: &Gap, coefficients: &Coefficients<'_>, names: &Names<'_>) -> TokenStream {
    let scalar = &names.scalar;
    let preamble = coefficients.preamble();
    let (a, r) = (local("a"), local("r"));
    let body = match half_exponents(gap) {
        Some(halves) => written_out(gap, &halves, [&a, &r], coefficients, names),
        None => {
            let (kernel, terms) = (names.generated("pressure_kernel"), coefficients.terms());
            quote!(#kernel(#a, #r, [#(#terms),*]))
        }
    };
    quote! {
        #[inline]
        fn pressure_kernel(&self, #a: #scalar, #r: #scalar) -> #scalar { #preamble #body }
    }
}

/// n/2 for every term, if all n are even and low.
fn half_exponents(gap: &Gap) -> Option<Vec<u32>> {
    let half = |term: &crate::gap::Term| {
        let half = &term.exponent / integer(2);
        half.is_integer().then(|| half.to_u32()).flatten().filter(|half| 2 * half <= HIGHEST_WRITTEN_OUT)
    };
    gap.terms.iter().map(half).collect()
}

fn written_out(
    gap: &Gap,
    halves: &[u32],
    [a, r]: [&Ident; 2],
    coefficients: &Coefficients<'_>,
    names: &Names<'_>,
) -> TokenStream {
    let constant = names.constant();
    let [t, s] = [|k: u32| local(&format!("t{k}")), |k: u32| local(&format!("s{k}"))];
    let (a_squared, r_squared, inset) = (local("a_squared"), local("r_squared"), local("inset"));
    let highest = halves.last().copied().unwrap_or(1);
    let recurrences = (2..=highest).map(|k| {
        let (next_t, next_s) = (t(k - 1), s(k));
        if k == 2 {
            return quote!(let #next_t = #a_squared + #r_squared; let #next_s = #a_squared + #next_t;);
        }
        let (previous_t, previous_s) = (t(k - 2), s(k - 1));
        let factors = (2..k).map(|_| &r_squared);
        quote! {
            let #next_t = #a_squared * #previous_t + #r_squared #(* #factors)*;
            let #next_s = #a_squared * #previous_s + #next_t;
        }
    });
    let terms = gap.terms.iter().enumerate().zip(halves).map(|((index, term), &k)| {
        let shifted = &term.exponent + integer(2);
        let weight = coefficients.times(index, &(&shifted * &shifted).recip());
        let s = s(k);
        if k == 1 { weight } else { quote!(#weight * #s) }
    });
    let squares = (highest > 1).then(|| quote!(let (#a_squared, #r_squared) = (#a * #a, #r * #r);));
    quote! {
        if #r >= #a {
            return #constant(0.0f64);
        }
        #squares
        #(#recurrences)*
        let #inset = (#a - #r) * (#a + #r);
        #inset * (#(#terms)+*) * #inset
    }
}
