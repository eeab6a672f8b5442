//! The parameters of the annotated struct and their bounds, as an implementation repeats them.

use proc_macro2::{Group, Ident, TokenStream, TokenTree};
use quote::{ToTokens, quote};

use crate::diagnostics::Extent;
use crate::reading::field::condition;
use crate::reading::{between_commas, is_punct, length_before, ungrouped};

/// What stands between `<` and `>`, and after `where`.
#[derive(Clone)]
pub(crate) struct Generics {
    parameters: Vec<Parameter>,
    predicates: Vec<TokenStream>,
}

#[derive(Clone)]
struct Parameter {
    kind: Kind,
    /// `'a`, `T` or `N`.
    name: TokenStream,
    /// With attributes and bounds, but without its default.
    declaration: TokenStream,
    /// The `#[cfg(...)]` before it.
    condition: Option<Extent>,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Lifetime,
    Type,
    Constant,
}

impl Parameter {
    fn of(tokens: &[TokenTree]) -> Option<Self> {
        let declaration = &tokens[..length_before(tokens, |token| is_punct(token, '='))];
        // A lifetime that comes from a macro stands in an invisible group.
        let mut opened = Vec::new();
        for token in declaration {
            opened.extend(ungrouped(token.clone().into()));
        }
        let (kind, name) = match without_attributes(&opened) {
            [quote, TokenTree::Ident(name), ..] if is_punct(quote, '\'') => {
                (Kind::Lifetime, quote!(#quote #name))
            }
            [TokenTree::Ident(word), TokenTree::Ident(name), ..] if word == "const" => {
                (Kind::Constant, name.to_token_stream())
            }
            [TokenTree::Ident(name), ..] => (Kind::Type, name.to_token_stream()),
            _ => return None,
        };
        let condition = condition(tokens);
        Some(Parameter { kind, name, declaration: quote!(#(#declaration)*), condition })
    }

    /// The parameter as an argument. Constants stand in braces, as a name alone would mean the type of that name if
    /// there is one in scope.
    fn argument(&self) -> TokenStream {
        let name = &self.name;
        if self.kind == Kind::Constant { quote!({ #name }) } else { name.clone() }
    }
}

impl Generics {
    /// The parameters at the beginning of some tokens, and what follows them.
    pub(super) fn parameters(tokens: &[TokenTree]) -> (Self, &[TokenTree]) {
        let (mut generics, rest) = (Generics { parameters: Vec::new(), predicates: Vec::new() }, tokens);
        let [first, inner @ ..] = tokens else { return (generics, rest) };
        if !is_punct(first, '<') {
            return (generics, rest);
        }
        let (inner, rest) = inner.split_at(length_before(inner, |token| is_punct(token, '>')));
        generics.parameters = between_commas(inner).into_iter().filter_map(Parameter::of).collect();
        (generics, rest.get(1..).unwrap_or_default())
    }

    /// Adds what follows `where`.
    pub(super) fn add_predicates(&mut self, tokens: &[TokenTree]) {
        self.predicates.extend(between_commas(tokens).iter().map(|predicate| quote!(#(#predicate)*)));
    }

    /// The same with the struct's own type in place of `Self`, which the bounds of a function cannot name.
    pub(super) fn without_self(mut self, ident: &Ident) -> Self {
        let arguments = self.arguments();
        let own = quote!(#ident #arguments);
        let declarations = self.parameters.iter_mut().map(|parameter| &mut parameter.declaration);
        for tokens in declarations.chain(&mut self.predicates) {
            *tokens = with_type_for_self(tokens.clone(), &own);
        }
        self
    }

    /// The first `#[cfg(...)]` before a parameter.
    pub(super) fn condition(&self) -> Option<Extent> {
        self.parameters.iter().find_map(|parameter| parameter.condition)
    }

    /// Whether this is the name of a type parameter.
    pub(crate) fn has_type(&self, name: &Ident) -> bool {
        let mut types = self.parameters.iter().filter(|parameter| parameter.kind == Kind::Type);
        types.any(|parameter| name == &parameter.name.to_string())
    }

    /// The same and a constant parameter.
    pub(crate) fn with_constant(&self, name: &Ident, kind: &TokenStream) -> Self {
        let mut generics = self.clone();
        let (name, declaration) = (name.to_token_stream(), quote!(const #name: #kind));
        generics.parameters.push(Parameter { kind: Kind::Constant, name, declaration, condition: None });
        generics
    }

    /// The same with a bound on a type parameter, which is added if it is not among the parameters.
    pub(crate) fn with_bound(&self, name: &Ident, bound: &TokenStream) -> Self {
        let mut generics = self.clone();
        if !self.has_type(name) {
            let name = name.to_token_stream();
            let parameter = Parameter { kind: Kind::Type, declaration: name.clone(), name, condition: None };
            generics.parameters.push(parameter);
        }
        generics.predicates.push(quote!(#name: #bound));
        generics
    }

    /// `<'a, T: Copy>` or nothing, as it follows `impl`.
    pub(crate) fn declared(&self) -> TokenStream {
        in_angles(self.parameters.iter().map(|parameter| parameter.declaration.clone()).collect())
    }

    /// `<'a, T>` or nothing, as it follows the type.
    pub(crate) fn arguments(&self) -> TokenStream {
        in_angles(self.parameters.iter().map(Parameter::argument).collect())
    }

    /// `where T: Clone`, or nothing.
    pub(crate) fn bounds(&self) -> TokenStream {
        let predicates = &self.predicates;
        if predicates.is_empty() { TokenStream::new() } else { quote!(where #(#predicates),*) }
    }
}

fn with_type_for_self(tokens: TokenStream, own: &TokenStream) -> TokenStream {
    let each = tokens.into_iter().map(|token| match token {
        TokenTree::Ident(name) if name == "Self" => own.clone(),
        TokenTree::Group(group) => {
            let mut replaced = Group::new(group.delimiter(), with_type_for_self(group.stream(), own));
            replaced.set_span(group.span());
            replaced.to_token_stream()
        }
        other => other.into(),
    });
    each.collect()
}

fn in_angles(list: Vec<TokenStream>) -> TokenStream {
    if list.is_empty() { TokenStream::new() } else { quote!(<#(#list),*>) }
}

fn without_attributes(tokens: &[TokenTree]) -> &[TokenTree] {
    match tokens {
        [hash, TokenTree::Group(_), rest @ ..] if is_punct(hash, '#') => without_attributes(rest),
        _ => tokens,
    }
}

#[cfg(test)]
mod tests {
    use quote::{format_ident, quote};

    use super::*;

    #[test]
    fn parameters_are_repeated_without_their_defaults() {
        let tokens = quote! {
            <'a, 'b: 'a, #[doc = "A number."] T: Fn(f64) -> Vec<Vec<T>> + 'b = Vec<f64>, const N: usize = 3,> rest
        };
        let tokens: Vec<TokenTree> = tokens.into_iter().collect();
        let (mut generics, rest) = Generics::parameters(&tokens);
        assert_eq!(quote!(#(#rest)*).to_string(), "rest");
        let declared =
            quote!(<'a, 'b: 'a, #[doc = "A number."] T: Fn(f64) -> Vec<Vec<T>> + 'b, const N: usize>);
        assert_eq!(generics.declared().to_string(), declared.to_string());
        assert_eq!(generics.arguments().to_string(), quote!(<'a, 'b, T, { N }>).to_string());
        assert!(generics.bounds().is_empty());
        let predicates: Vec<TokenTree> = quote!(for<'c> &'c T: Into<f64>, [u8; N]:,).into_iter().collect();
        generics.add_predicates(&predicates);
        let bounded = generics.with_bound(&format_ident!("S"), &quote!(Copy));
        let bounds = quote!(where for<'c> &'c T: Into<f64>, [u8; N]:, S: Copy);
        assert_eq!(bounded.bounds().to_string(), bounds.to_string());
        assert!(bounded.has_type(&format_ident!("S")) && !bounded.has_type(&format_ident!("N")));
        let same = bounded.with_bound(&format_ident!("T"), &quote!(Copy));
        assert_eq!(same.declared().to_string(), bounded.declared().to_string());
    }

    #[test]
    fn bounds_name_the_type_of_the_struct() {
        let tokens: Vec<TokenTree> =
            quote!(<T: Into<Option<(Self, T)>>, const N: usize>).into_iter().collect();
        let (mut generics, _) = Generics::parameters(&tokens);
        let predicates: Vec<TokenTree> = quote!(Self: Sized).into_iter().collect();
        generics.add_predicates(&predicates);
        let generics = generics.without_self(&format_ident!("Ball"));
        let declared = quote!(<T: Into<Option<(Ball<T, { N }>, T)>>, const N: usize>);
        assert_eq!(generics.declared().to_string(), declared.to_string());
        assert_eq!(generics.bounds().to_string(), quote!(where Ball<T, { N }>: Sized).to_string());
    }

    #[test]
    fn what_has_no_parameters_has_no_brackets() {
        let (generics, rest) = Generics::parameters(&[]);
        assert!(rest.is_empty() && generics.declared().is_empty() && generics.arguments().is_empty());
    }
}
