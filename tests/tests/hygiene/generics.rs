//! Structs with type parameters, lifetimes, constants and where clauses.

use core::fmt::Debug;
use core::marker::PhantomData;
use core::ops::Add;

use cartcontact::gap_profile;

use super::{assert_ball, radius};

/// A ball over any scalar.
#[gap_profile(r^2 / (2 * radius))]
struct Any<T> {
    radius: T,
}

/// Bounds where the parameter is declared, and a default.
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

/// A parameter that is named like the scalar of generated code but is not the scalar; a lifetime; a constant.
#[gap_profile(r^2 / (2 * radius))]
struct Labelled<'a, T: ?Sized, const N: usize> {
    radius: f64,
    label: &'a T,
    tags: [u8; N],
}

/// A type with the name of the constant above.
#[derive(Debug)]
struct N;

/// Bounds that name the struct.
#[gap_profile(r^2 / (2 * radius))]
struct Own<S: Labels<Option<Self>>, const N: usize>
where
    Self: Sized,
{
    radius: f64,
    label: S,
}

trait Labels<T> {}

impl<T> Labels<T> for &str {}

/// Parameters that the geometry does not use.
#[gap_profile(r^2 / 40)]
#[derive(Default)]
struct Marked<T, T_ = T>
where
    T: Debug,
{
    marker: PhantomData<(T, T_)>,
}

/// Arrows, brackets in brackets, and defaults of constants.
#[gap_profile(r^2 / (2 * radius))]
struct Nested<S, F: Fn(&[S]) -> Vec<Vec<S>>, const N: usize = { 2 + 1 }, const M: usize = 1>
where
    F: for<'a> Fn(&'a [S]) -> Vec<Vec<S>>,
    [u8; N]: Default,
{
    shape: F,
    pub(super) radius: S,
    tags: [[u8; N]; M],
}

/// Parts of a struct that come from a macro are in invisible groups.
macro_rules! parts {
    ($visibility:vis $name:ident, $lifetime:lifetime, $type:ty, $bounded:ty, $crate_path:path) => {
        #[gap_profile(r^2 / (2 * radius), crate = $crate_path)]
        $visibility struct $name<$lifetime, T: Into<$type>>
        where
            $bounded: Copy,
        {
            $visibility radius: $type,
            other: &$lifetime T,
        }
    };
}

parts!(pub(super) Parts, 'a, f64, &'static dyn Debug, ::cartcontact);

macro_rules! annotated {
    ($item:item) => {
        #[gap_profile(r^2 / (2 * radius))]
        $item
    };
}

annotated! {
    /// With other attributes.
    #[derive(Clone, Copy)]
    pub(super) struct Whole { pub(super) radius: f64 }
}

#[test]
fn structs_of_macros_are_read() {
    let parts = Parts { radius: 20.0, other: &1.0_f32 };
    let whole = Whole { radius: parts.radius };
    assert_eq!(radius::<f64>(&parts), radius::<f64>(&whole));
    assert_eq!(*parts.other, 1.0);
    let nested = Nested { shape: |tags: &[f64]| vec![tags.to_vec()], radius: 20.0, tags: [[0; 3]] };
    assert_eq!(radius(&nested), radius::<f64>(&whole));
    assert_eq!((nested.shape)(&[1.0]).len(), nested.tags.len());
}

#[test]
fn parameters_of_all_kinds_are_kept() {
    assert_eq!(radius(&Any { radius: 20.0_f64 }), radius(&Bounded { radius: 20.0_f64 }));
    assert_eq!(radius(&Any { radius: 20.0_f64 }), radius(&Where { radius: 20.0_f64 }));
    let own = Own::<_, 3> { radius: 20.0, label: "patella" };
    assert_eq!((radius::<f64>(&own), own.label), (radius(&Any { radius: 20.0_f64 }), "patella"));
    let labelled = Labelled { radius: 20.0, label: "patella", tags: [1, 2, 3] };
    assert_eq!(labelled.label.len() + labelled.tags.len(), 10);
    assert_eq!(format!("{N:?}"), "N");
    let marked: Marked<u8> = Marked::default();
    assert_eq!(marked.marker, PhantomData);
    assert_eq!(radius::<f64>(&marked), radius::<f64>(&labelled));
    assert_ball::<f64>(&labelled);
}
