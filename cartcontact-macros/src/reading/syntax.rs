//! What was written, with its place in the source: nothing is evaluated yet.
//!
//! ```text
//! sum     = product (("+" | "-") product)*
//! product = factor (("*" | "/") factor)*
//! factor  = ("-" | "+") factor | power
//! power   = atom ("^" factor)?
//! atom    = number | name | surface | "(" sum ")"
//! surface = "sphere" "(" sum ")" | "conic" "(" sum "," sum ")"
//! ```
//!
//! So `^` binds tighter than a minus in front of it and is right-associative: `-r^2` is `-(r^2)`, `2^3^2` is `2^9`, and
//! `r^-2` needs no parentheses. A sum and a product hold their parts side by side: however long they are, the tree is
//! only as deep as the parentheses.

use proc_macro2::Ident;

use crate::diagnostics::Extent;
use crate::number::Rational;

pub(crate) struct Expression {
    pub(crate) kind: Kind,
    pub(crate) extent: Extent,
}

pub(crate) enum Kind {
    Number(Rational),
    Name(Ident),
    Negative(Box<Expression>),
    Sum(Vec<Summand>),
    Product(Vec<Factor>),
    Power(Box<Expression>, Box<Expression>),
    Surface(Box<Surface>),
    /// An operand that has already been reported.
    Faulty,
}

/// `sphere(R)` or, with a conic constant, `conic(R, k)`.
pub(crate) struct Surface {
    pub(crate) radius: Expression,
    pub(crate) conic_constant: Option<Expression>,
}

pub(crate) struct Summand {
    pub(crate) subtracted: bool,
    pub(crate) expression: Expression,
}

pub(crate) struct Factor {
    pub(crate) divides: bool,
    pub(crate) expression: Expression,
}
