//! [`Geometry`] -> Rust code: an implementation of `GapProfile` specialised for it, with documentation.
//!
//! | what | modules |
//! |---|---|
//! | coefficients, as literals or computed from fields | `coefficients`, `expression` |
//! | closed forms | `power_sum`, `pressure_kernel`, `drops`; `operations` counts what they take |
//! | the contact radius | `inversion`, from one of `curves`, `roots`, `seeds` (each with a `table`) and `leading_term`; `steepness` is what steps evaluate |
//! | the admissible range, and what the type itself tells | `range`, `inherent` |
//! | documentation | `documentation` |

mod coefficients;
mod curves;
mod documentation;
mod drops;
mod expression;
mod inherent;
mod inversion;
mod leading_term;
mod operations;
mod power_sum;
mod pressure_kernel;
mod range;
mod roots;
mod seeds;
mod steepness;
mod table;

use proc_macro2::{Ident, Span, TokenStream, TokenTree};
use quote::{format_ident, quote};

use crate::closed_forms::{ClosedForms, PowerSum};
use crate::geometry::Geometry;
use crate::number::{Rational, literal};
use crate::reading::field::FieldKind;
use crate::reading::generics::Generics;
use crate::reading::item::Item;
use crate::reading::name::unraw;
use crate::start::{Start, has_leading_term_beside_table};
use coefficients::Coefficients;
use operations::Operations;

/// A method that evaluates a closed form: its name, its variable and the sum.
type EvaluatorMethod = (&'static str, &'static str, fn(&ClosedForms) -> &PowerSum);

const EVALUATORS: [EvaluatorMethod; 5] = [
    ("gap", "r", |forms| &forms.gap),
    ("approach", "a", |forms| &forms.approach),
    ("approach_slope", "a", |forms| &forms.approach_slope),
    ("load_integral", "a", |forms| &forms.load_integral),
    ("log_kernel", "x", |forms| &forms.log_kernel),
];

/// A variable or parameter of generated code.
///
/// A pattern refers to a constant of the same name if there is one in scope, whatever the span: hygiene covers
/// variables only. So these names are such as nobody gives to a constant.
pub(crate) fn local(name: &str) -> Ident {
    format_ident!("__{name}", span = Span::mixed_site())
}

/// What every part of the generated code refers to.
struct Names {
    /// The run-time crate, as the generated import calls it.
    krate: Ident,
    /// The scalar type.
    scalar: Ident,
    /// The constant that says how double words are multiplied.
    fused: Ident,
    // The parameters of `radius_within` and `radii_within`.
    load_integral: Ident,
    load_integrals: Ident,
    limit: Ident,
    radii: Ident,
}

impl Names {
    fn of(item: &Item) -> Self {
        let [krate, load_integral, load_integrals, limit, radii] =
            ["cartcontact", "load_integral", "load_integrals", "limit", "radii"].map(local);
        let (scalar, fused) = (scalar_of(item), local("FUSED"));
        Names { krate, scalar, fused, load_integral, load_integrals, limit, radii }
    }

    /// The function that turns an `f64` literal into a scalar.
    fn constant(&self) -> TokenStream {
        let (krate, scalar) = (&self.krate, &self.scalar);
        quote!(<#scalar as #krate::Scalar>::constant)
    }

    /// A number as a scalar.
    fn number(&self, value: &Rational) -> TokenStream {
        let (constant, literal) = (self.constant(), literal(value));
        quote!(#constant(#literal))
    }

    /// The value of a block of code that computes in double words.
    fn in_double_words(&self, code: &TokenStream) -> TokenStream {
        let (evaluate, fused) = (self.generated("in_double_words"), &self.fused);
        quote!(#evaluate!(#fused => { #code }))
    }

    /// The solution where a table or the leading term does not lead to the radius.
    fn by_radius_within(&self) -> TokenStream {
        let Names { krate, load_integral, limit, .. } = self;
        quote!(|#load_integral| #krate::GapProfile::radius_within(self, #load_integral, #limit))
    }

    /// A function or type that only generated code uses.
    fn generated(&self, function: &str) -> TokenStream {
        let (krate, function) = (&self.krate, Ident::new(function, Span::call_site()));
        quote!(#krate::#function)
    }
}

/// The annotated item with documentation of what was derived, and its implementation of `GapProfile`.
pub(crate) fn solver(
    input: &TokenStream,
    item: &Item,
    geometry: &Geometry,
    krate: &TokenStream,
) -> TokenStream {
    let names = Names::of(item);
    let import = import(krate, &names);
    let forms = ClosedForms::of(&geometry.gap);
    let coefficients = Coefficients::new(item, geometry, &names);
    let (evaluators, operations) = evaluators(&forms, &coefficients);
    let start = Start::of(geometry, &forms);
    let inversion = inversion::methods(&forms, start.as_ref(), &coefficients);
    let drops = drops::methods(&forms, &coefficients);
    let beside_inversion = beside_inversion(&forms, start.as_ref(), &coefficients);
    let range = range::methods(&coefficients);
    let inherent = inherent::block(&coefficients);
    let quadrature_hints = quadrature_hints(&coefficients);
    let [shared, precise_shared] = coefficients.functions();
    let header = implementation(item, &names);
    let beside = coefficients.operations();
    let lines = documentation::lines(item, geometry, &forms, start.as_ref(), (&operations, beside));
    let documented = documented(input, &lines);
    let scope = scope(
        item,
        &quote! {
            #import
            #shared
            #precise_shared
            #beside_inversion
            #[automatically_derived]
            #header {
                #evaluators
                #inversion
                #drops
                #range
                #quadrature_hints
            }
            #inherent
        },
    );
    quote!(#documented #scope)
}

/// Generated items in a scope of their own, without lints on the struct itself or on numbers that nobody wrote.
fn scope(item: &Item, content: &TokenStream) -> TokenStream {
    let allowed = &item.allowed;
    quote! {
        #allowed
        #[allow(deprecated, single_use_lifetimes, reason = "they concern the struct, which is repeated here")]
        #[allow(clippy::approx_constant, reason = "a coefficient near a famous number is none")]
        #[allow(clippy::multiple_bound_locations, reason = "the struct may bound its parameter in place")]
        #[allow(clippy::possible_missing_comma, reason = "generated operators seem to span an attribute's lines")]
        const _: () = { #content };
    }
}

/// The methods that evaluate closed forms, and the operation counts of those that belong to the interface.
fn evaluators(forms: &ClosedForms, coefficients: &Coefficients<'_>) -> (TokenStream, Vec<Operations>) {
    let names = coefficients.names;
    let scalar = &names.scalar;
    let method = |name: &str, variable: &Ident, body: TokenStream| {
        let name = Ident::new(name, Span::call_site());
        quote! {
            #[inline]
            fn #name(&self, #variable: #scalar) -> #scalar { #body }
        }
    };
    let rounded_once = |name: &str, variable: &str, sum: &PowerSum| {
        let (variable, coefficients) = (local(variable), coefficients.for_rounding_once([sum]));
        let (code, count) = power_sum::value(sum, &variable, &coefficients);
        let preamble = coefficients.preamble();
        (method(name, &variable, names.in_double_words(&quote!(#preamble #code))), count)
    };
    let interface = EVALUATORS.map(|(name, variable, sum)| rounded_once(name, variable, sum(forms)));
    let (mut methods, mut operations): (Vec<_>, Vec<_>) = interface.into_iter().unzip();
    for (name, sum) in [
        ("excess_on_axis", &forms.excess_on_axis),
        ("quick_approach", &forms.approach),
        ("quick_approach_slope", &forms.approach_slope),
        ("quick_load_integral", &forms.load_integral),
    ] {
        let a = local("a");
        let code = power_sum::quick_value(sum, &a, coefficients);
        let preamble = coefficients.preamble();
        methods.push(method(name, &a, quote!(#preamble #code)));
    }
    methods.extend(approach_and_load_integral(forms, coefficients));
    let pressure_kernels = pressure_kernel::methods(forms, coefficients);
    operations.push(pressure_kernel::operations(coefficients.gap()));
    (quote!(#(#methods)* #(#pressure_kernels)*), operations)
}

/// The method that evaluates both with the same coefficients, if these have to be computed.
fn approach_and_load_integral(forms: &ClosedForms, coefficients: &Coefficients<'_>) -> Option<TokenStream> {
    let names = coefficients.names;
    let sums = [&forms.approach, &forms.load_integral];
    let (scalar, a, coefficients) = (&names.scalar, local("a"), coefficients.for_rounding_once(sums));
    let preamble = coefficients.preamble();
    let values = sums.map(|sum| power_sum::value(sum, &a, &coefficients).0);
    let both = names.in_double_words(&quote!(#preamble (#(#values),*)));
    (!preamble.is_empty()).then(|| {
        quote! {
            #[inline]
            fn approach_and_load_integral(&self, #a: #scalar) -> (#scalar, #scalar) { #both }
        }
    })
}

/// What the inversion uses besides methods: a table and the step from it, and the steps from a leading term.
fn beside_inversion(
    forms: &ClosedForms,
    start: Option<&Start>,
    coefficients: &Coefficients<'_>,
) -> Option<TokenStream> {
    let names = coefficients.names;
    let table = match start? {
        Start::Roots(roots) => return Some(roots::item(roots, names)),
        Start::LeadingTerm => return leading_term::items(forms, names),
        Start::Curves(curves) => curves::items(curves, names),
        Start::Seeds(found) => seeds::items(found, &forms.stepped, coefficients),
    };
    let is_beside = has_leading_term_beside_table(coefficients.gap());
    let from_leading_term = is_beside.then(|| leading_term::items(forms, names)).flatten();
    Some(quote!(#table #from_leading_term))
}

/// The run-time crate under the name that generated code has for it.
///
/// All generated code reaches it by this import, as the compiler is silent about what follows from a failed import: a
/// wrong path is one error, where it is written.
fn import(krate: &TokenStream, names: &Names) -> TokenStream {
    let place = krate.clone().into_iter().last().map_or_else(Span::call_site, |end| end.span());
    let generated = Ident::new("generated", Span::call_site().located_at(place));
    let own = &names.krate;
    quote!(use #krate::#generated::root as #own;)
}

/// The annotated item with an implementation that only has the right signatures, so that a faulty profile causes no
/// errors but its own.
pub(crate) fn fallback(
    input: &TokenStream,
    item: &Item,
    errors: &TokenStream,
    krate: &TokenStream,
) -> TokenStream {
    let names = Names::of(item);
    let import = import(krate, &names);
    let Names { krate: root, scalar, .. } = &names;
    let header = implementation(item, &names);
    let evaluators = EVALUATORS.map(|(name, ..)| {
        let name = format_ident!("{name}");
        quote!(fn #name(&self, _: #scalar) -> #scalar { loop {} })
    });
    let inherent = inherent::stub(item, errors, &names);
    let scope = scope(
        item,
        &quote! {
            #import
            #inherent
            #[automatically_derived]
            #header {
                #(#evaluators)*
                fn pressure_kernel(&self, _: #scalar, _: #scalar) -> #scalar { loop {} }
                fn radius_within(
                    &self,
                    _: #scalar,
                    _: #scalar,
                ) -> ::core::result::Result<#scalar, #root::RadiusError> { loop {} }
                fn max_radius(&self) -> #scalar { loop {} }
            }
        },
    );
    quote!(#input #scope)
}

/// The annotated item with documentation of what was derived after its own.
fn documented(item: &TokenStream, lines: &[String]) -> TokenStream {
    let mut tokens = item.clone().into_iter().peekable();
    let mut attributes = TokenStream::new();
    while let Some(TokenTree::Punct(hash)) =
        tokens.next_if(|token| matches!(token, TokenTree::Punct(p) if p.as_char() == '#'))
    {
        attributes.extend([TokenTree::Punct(hash)]);
        attributes.extend(tokens.next());
    }
    let rest: TokenStream = tokens.collect();
    quote!(#attributes #(#[doc = #lines])* #rest)
}

/// The type parameter of the used fields, or one of the implementation's own. As that is visible in documentation, it
/// is `T` unless the struct's parameters or their bounds mean something else by it.
fn scalar_of(item: &Item) -> Ident {
    let own = item.fields.iter().filter(|field| field.used).find_map(|field| match &field.kind {
        FieldKind::TypeParameter(parameter) => Some(parameter.clone()),
        _ => None,
    });
    own.unwrap_or_else(|| {
        let Item { ident, generics, .. } = item;
        let (parameters, bounds) = (generics.declared(), generics.bounds());
        let taken = quote!(#ident #parameters #bounds);
        let mut names = core::iter::successors(Some("T".to_owned()), |name| Some(format!("{name}_")));
        let name = names.find(|name| !names_something(&taken, name)).unwrap_or_default();
        Ident::new(&name, Span::call_site())
    })
}

/// Whether a name occurs in some tokens, as a parameter or as a type in a bound.
fn names_something(tokens: &TokenStream, name: &str) -> bool {
    tokens.clone().into_iter().any(|token| match token {
        TokenTree::Ident(own) => unraw(&own) == name,
        TokenTree::Group(group) => names_something(&group.stream(), name),
        _ => false,
    })
}

/// `impl<..> GapProfile<T> for Item<..> where ..`.
fn implementation(item: &Item, names: &Names) -> TokenStream {
    let Names { krate, scalar, .. } = names;
    let (ident, arguments, generics) =
        (&item.ident, item.generics.arguments(), bounded_generics(item, names));
    let (parameters, bounds) = (generics.declared(), generics.bounds());
    quote!(impl #parameters #krate::GapProfile<#scalar> for #ident #arguments #bounds)
}

/// The item's generics with the scalar type among them, bounded.
fn bounded_generics(item: &Item, names: &Names) -> Generics {
    let Names { krate, scalar, .. } = names;
    item.generics.with_bound(scalar, &quote!(#krate::Scalar))
}

/// What quadrature has to know about the terms.
fn quadrature_hints(coefficients: &Coefficients<'_>) -> TokenStream {
    let (terms, names) = (&coefficients.gap().terms, coefficients.names);
    let (scalar, constant) = (&names.scalar, names.constant());
    let highest = terms.last().map(|term| literal(&term.exponent));
    let truth = quote!(::core::primitive::bool);
    let is_smooth = terms.iter().all(|term| term.exponent.is_integer());
    let has_only_positive = match coefficients.of_uncertain_sign() {
        None => quote!(false),
        Some(none) if none.is_empty() => quote!(true),
        Some(uncertain) => {
            let preamble = coefficients.preamble();
            quote!(#preamble #(#uncertain >= #constant(0.0f64))&&*)
        }
    };
    quote! {
        #[inline]
        fn highest_exponent(&self) -> #scalar { #constant(#highest) }

        #[inline]
        fn is_smooth_at_centre(&self) -> #truth { #is_smooth }

        #[inline]
        fn has_only_positive_terms(&self) -> #truth { #has_only_positive }
    }
}
