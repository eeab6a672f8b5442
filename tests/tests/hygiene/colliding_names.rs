//! Fields named like the variables, functions and parameters of generated code.

use cartcontact::gap_profile;

use super::{OF_BALL, radius};

macro_rules! fields {
    ($($module:ident: $field:ident;)*) => {$(
        mod $module {
            use super::*;

            /// A ball whose radius has another name.
            #[gap_profile(r^2 / (2 * $field))]
            struct One {
                $field: f64,
            }

            /// Several terms and a range, so that Newton's method is used.
            #[gap_profile(r^2 / (2 * $field) + 0 * r^4 / $field + $field^0.5 * r^6 / 1e30, max_radius = $field^3)]
            struct Two {
                $field: f64,
            }

            #[test]
            fn names_of_fields_are_free() {
                for radius in [radius::<f64>(&One { $field: 20.0 }), radius::<f64>(&Two { $field: 20.0 })] {
                    assert!((radius / OF_BALL - 1.0).abs() < 1e-12, "{radius}");
                }
            }
        }
    )*};
}

fields! {
    radius_a: a;
    radius_s: s;
    radius_x: x;
    radius_q: q;
    value: value;
    log_slope: log_slope;
    slope: slope;
    coefficient: c0;
    depth: depth;
    limit: limit;
    end: end;
    error: error;
    base: base;
    square: square;
    profile: profile;
    load_integral: load_integral;
    coefficients: coefficients;
    gap: gap;
    max_radius: max_radius;
    check: check;
    krate: cartcontact;
    core_: core;
    raw: r#type;
}

/// Many names that generated code might bind, in one struct.
#[gap_profile(r^2 / (2 * a * s * x) + value * slope * r^4 / (c0 * depth) + limit * r^5 / load_integral)]
struct Many {
    a: f64,
    s: f64,
    x: f64,
    value: f64,
    slope: f64,
    c0: f64,
    depth: f64,
    limit: f64,
    load_integral: f64,
}

/// Written out, because names that come from a macro cannot collide with those of generated code.
#[gap_profile(r^2 / (2 * error) + r^4 * (profile - end) / 1e30, max_radius = error)]
struct Checked {
    error: f64,
    end: f64,
    profile: f64,
}

#[test]
fn names_of_checked_fields_are_free() {
    let checked = Checked { error: 20.0, end: 1.0, profile: 0.5 };
    assert!((radius::<f64>(&checked) / OF_BALL - 1.0).abs() < 1e-12);
    assert_eq!(cartcontact::GapProfile::<f64>::check(&checked), Ok(()));
}

#[test]
fn names_of_many_fields_are_free() {
    let many = Many {
        a: 2.0,
        s: 2.0,
        x: 5.0,
        value: 1e-20,
        slope: 1.0,
        c0: 1.0,
        depth: 1.0,
        limit: 1e-20,
        load_integral: 1.0,
    };
    assert!((radius::<f64>(&many) / OF_BALL - 1.0).abs() < 1e-14);
}
