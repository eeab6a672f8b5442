//! Structs in modules, functions, blocks and macros; visibilities, attributes and paths of the crate.

use super::{assert_ball, radius};

/// At the top of a module.
#[cartcontact::gap_profile(r^2 / 40)]
pub(super) struct Plain;

mod inner {
    /// Visible outside, with other attributes around.
    #[derive(Clone, Debug)]
    #[cartcontact::gap_profile(r^2 / (2 * radius))]
    #[derive(PartialEq)]
    #[must_use]
    pub(in super::super) struct Outer {
        /// The radius, in mm.
        pub(in super::super) radius: f64,
    }
}

/// The crate, re-exported by a module of the user.
mod facade {
    pub(super) use cartcontact::*;
}

#[cartcontact::gap_profile(r^2 / 40, crate = crate::renamed)]
struct Renamed;

#[cartcontact::gap_profile(r^2 / 40, crate = facade)]
struct Reexported;

macro_rules! balls {
    ($($name:ident: $radius:expr, $power:literal;)*) => {
        $(#[cartcontact::gap_profile(r^$power / (2 * $radius))] struct $name;)*
    };
}

balls! {
    Written: 4 * 5, 2;
    Computed: 10 + 10, 2;
}

#[test]
fn a_profile_may_stand_in_a_function() {
    #[cartcontact::gap_profile(r^2 / 40)]
    struct Local;

    let inner = {
        #[cartcontact::gap_profile(r^2 / (2 * radius))]
        struct Innermost {
            radius: f64,
        }
        Innermost { radius: 20.0 }
    };
    assert_eq!(radius::<f64>(&Local), radius::<f64>(&Plain));
    assert_ball::<f64>(&inner);
}

#[test]
fn a_profile_may_stand_among_other_attributes() {
    let outer = inner::Outer { radius: 20.0 };
    assert_eq!(outer.clone(), outer);
    assert_ball::<f64>(&outer);
}

#[test]
fn the_crate_may_have_another_name() {
    assert_eq!(radius::<f64>(&Renamed), radius::<f64>(&Plain));
    assert_eq!(radius::<f64>(&Reexported), radius::<f64>(&Plain));
}

#[test]
fn a_profile_may_be_written_by_a_macro() {
    assert_eq!(radius::<f64>(&Written), radius::<f64>(&Plain));
    assert_eq!(radius::<f64>(&Computed), radius::<f64>(&Plain));
}
