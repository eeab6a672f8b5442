//! Names that were probably meant as others.

use proc_macro2::{Ident, TokenStream, TokenTree};

use crate::reading::{is_punct, literal};

/// What to write in place of a number that people know by name.
pub(crate) fn known_number(name: &Ident) -> Option<&'static str> {
    let is_one_of = |names: &[&str]| names.iter().any(|known| name == known);
    if is_one_of(&["pi", "PI", "Pi", "π"]) {
        return Some("numbers are kept exact; write it as a decimal, as in `3.141592653589793`");
    }
    if is_one_of(&["flat", "plane"]) {
        return Some("a flat body is `0`, as in `lower = 0`");
    }
    is_one_of(&["inf", "infinity", "INFINITY"])
        .then_some("leave out a range without an end, and write a flat body as `lower = 0`")
}

/// What `r2` is meant as, unless it is a field; `r1` is more likely the first of two radii.
pub(super) fn power_of_r(name: &str) -> Option<String> {
    let exponent = name.strip_prefix('r').filter(|exponent| !["", "0", "1"].contains(exponent))?;
    literal::is_whole(exponent).then(|| format!("r^{exponent}"))
}

/// The known name that differs from this one by the fewest letters, and by at most a third of its own.
pub(crate) fn closest(name: &str, known: Vec<String>) -> Option<String> {
    let name = name.to_lowercase();
    let with_distance = known.into_iter().map(|known| (distance(&name, &known.to_lowercase()), known));
    let similar = with_distance.filter(|(distance, known)| 3 * distance <= known.chars().count());
    similar.min().map(|(_, known)| known)
}

/// Levenshtein's distance, one row of its table for each letter of `left`.
fn distance(left: &str, right: &str) -> usize {
    let mut row: Vec<usize> = (0..=right.chars().count()).collect();
    for (i, a) in left.chars().enumerate() {
        let mut next = vec![i + 1];
        for (b, pair) in right.chars().zip(row.windows(2)) {
            let [diagonal, above] = *pair else { continue };
            let beside = next.last().copied().unwrap_or(0);
            next.push((diagonal + usize::from(a != b)).min(above + 1).min(beside + 1));
        }
        row = next;
    }
    row.last().copied().unwrap_or(0)
}

/// The names in some tokens, except that of the distance r, and whether they may be symbols: names of functions and
/// options and parts of paths may not.
pub(super) fn collect_names(tokens: TokenStream, names: &mut Vec<(Ident, bool)>) {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    for (index, token) in tokens.iter().enumerate() {
        match token {
            TokenTree::Ident(name) => {
                let follows_path = index.checked_sub(1).is_some_and(|before| is_punct(&tokens[before], ':'));
                let is_something_else = tokens.get(index + 1).is_some_and(|next| match next {
                    TokenTree::Punct(next) => ":=.".contains(next.as_char()),
                    next => matches!(next, TokenTree::Group(_)),
                });
                names.push((name.clone(), !follows_path && !is_something_else));
            }
            TokenTree::Group(group) => collect_names(group.stream(), names),
            TokenTree::Literal(literal) => {
                let text = literal.to_string();
                names.extend(
                    literal::with_name(&text).map(|(_, name)| (Ident::new(name, literal.span()), true)),
                );
            }
            TokenTree::Punct(_) => {}
        }
    }
    names.retain(|(name, _)| name != "r");
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_behind_r_is_an_exponent() {
        assert_eq!(power_of_r("r12").as_deref(), Some("r^12"));
        assert!(["r", "r0", "r1", "r2a", "radius", "c2"].into_iter().all(|name| power_of_r(name).is_none()));
    }

    #[test]
    fn the_nearest_of_similar_names_is_meant() {
        assert_eq!((distance("kitten", "sitting"), distance("", "abc")), (3, 3));
        let closest = |name, known: [&str; 2]| closest(name, known.map(str::to_owned).into());
        assert_eq!(closest("ra", ["r", "rad"]).as_deref(), Some("rad"));
        assert_eq!((closest("ab", ["r", "cd"]), closest("ρ", ["κ", "χψ"])), (None, None));
    }
}
