use std::marker::PhantomData;

use cartcontact::{GapProfile, gap_profile};

#[gap_profile(0.025 * r^2)]
struct Empty();

#[gap_profile(0.025 * r^2)]
struct Numbered(#[allow(dead_code)] u8, pub f64);

#[gap_profile(0.025 * r^2)]
struct Marked<'a, T>(PhantomData<&'a T>)
where
    T: Clone;

fn main() {
    let gaps: [f64; 3] = [Empty().gap(2.0), Numbered(1, 2.0).gap(2.0), Marked::<u8>(PhantomData).gap(2.0)];
    assert_eq!(gaps, [0.1; 3]);
    assert_eq!(Empty::MAX_RADIUS, f64::INFINITY);
}
