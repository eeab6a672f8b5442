//! Names, as the compiler knows them.

use proc_macro2::{Ident, TokenTree};

use crate::reading::is_punct;

/// Words that cannot be a name, unless it begins with `r#`; and `_`.
const KEYWORDS: [&str; 48] = [
    "_", "abstract", "as", "async", "await", "become", "box", "break", "const", "continue", "do", "dyn",
    "else", "enum", "extern", "false", "final", "fn", "for", "if", "impl", "in", "let", "loop", "macro",
    "match", "mod", "move", "mut", "override", "priv", "pub", "ref", "return", "static", "struct", "trait",
    "true", "try", "type", "typeof", "unsafe", "unsized", "use", "virtual", "where", "while", "yield",
];

/// The same, except that they may stand in a path.
const KEYWORDS_OF_PATHS: [&str; 4] = ["crate", "self", "Self", "super"];

pub(crate) fn is_keyword(name: &Ident) -> bool {
    KEYWORDS.iter().chain(&KEYWORDS_OF_PATHS).any(|keyword| name == keyword)
}

/// Without the `r#` that lets a keyword be a name.
pub(crate) fn unraw(name: &Ident) -> String {
    let name = name.to_string();
    name.strip_prefix("r#").map_or_else(|| name.clone(), str::to_owned)
}

/// Whether two names are one, as `r#radius` and `radius` are.
pub(crate) fn is_same(one: &Ident, other: &Ident) -> bool {
    unraw(one) == unraw(other)
}

/// The last name of a path without arguments, as `c` is of `::a::b::c`; nothing if the tokens are something else.
pub(crate) fn last_of_path(tokens: &[TokenTree]) -> Option<&Ident> {
    match tokens {
        [TokenTree::Ident(last)] => Some(last).filter(|last| !KEYWORDS.iter().any(|keyword| last == keyword)),
        [TokenTree::Ident(_), first, second, rest @ ..] | [first, second, rest @ ..]
            if is_punct(first, ':') && is_punct(second, ':') =>
        {
            last_of_path(rest)
        }
        _ => None,
    }
}
