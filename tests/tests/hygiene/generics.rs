//! Structs with type parameters, lifetimes, constants and where clauses.

use core::fmt::Debug;
use core::marker::PhantomData;
use core::ops::Add;

use cartcontact::gap_profile;

use super::{OF_BALL, radius};

/// A ball over any scalar.
#[gap_profile(r^2 / (2 * radius))]
struct Any<T> {
    radius: T,
}

/// Bounds where they are declared, and a default.
#[gap_profile(r^2 / (2 * radius))]
struct Bounded<S: Copy + Debug = f64> {
    radius: S,
}

/// Bounds in a where clause, with a trailing comma.
#[gap_profile(r^2 / (2 * radius))]
struct Where<S>
where
    S: Add<S, Output = S>,
    Vec<S>: Clone,
{
    radius: S,
}

/// A parameter named like that of generated code, which is not the scalar; a lifetime; a constant.
#[gap_profile(r^2 / (2 * radius))]
struct Labelled<'a, T: ?Sized, const N: usize> {
    radius: f64,
    label: &'a T,
    tags: [u8; N],
}

/// A type with the name of that constant.
#[derive(Debug)]
struct N;

/// Parameters that the geometry does not use.
#[gap_profile(r^2 / 40)]
#[derive(Default)]
struct Marked<T, T_ = T>
where
    T: Debug,
{
    marker: PhantomData<(T, T_)>,
}

#[test]
fn parameters_of_all_kinds_are_kept() {
    assert_eq!(radius(&Any { radius: 20.0_f64 }), radius(&Bounded { radius: 20.0_f64 }));
    assert_eq!(radius(&Any { radius: 20.0_f64 }), radius(&Where { radius: 20.0_f64 }));
    let labelled = Labelled { radius: 20.0, label: "patella", tags: [1, 2, 3] };
    assert_eq!(labelled.label.len() + labelled.tags.len(), 10);
    assert_eq!(format!("{N:?}"), "N");
    let marked: Marked<u8> = Marked::default();
    assert_eq!(marked.marker, PhantomData);
    assert_eq!(radius::<f64>(&marked), radius::<f64>(&labelled));
    assert!((radius::<f64>(&labelled) / OF_BALL - 1.0).abs() < 1e-14);
}
