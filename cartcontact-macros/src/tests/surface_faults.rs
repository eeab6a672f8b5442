//! Messages about surfaces and their options, and the remedies that they offer.

use super::{assert_only_fault, on_ball, on_unit};

/// Whatever the options for the surfaces are, as none of them helps.
#[test]
fn a_gap_that_falls_is_the_fault() {
    for (gap, rule) in [
        ("sphere(20) - sphere(10)", "falls from the centre"),
        ("upper = sphere(20), lower = -sphere(10)", "falls from the centre"),
        ("-sphere(10)", "falls from the centre"),
        ("sphere(10) - r", "falls from the centre"),
        ("sphere(10) - 0.04*r^2 - 0.0001*r^6", "no longer exceeds its mean"),
    ] {
        for options in [
            "order = 4",
            "order = 4, max_radius = 5",
            "order = 4, max_radius = 5, tolerance = 1e-3",
            "order = auto, max_radius = 5, tolerance = 1e-3",
        ] {
            let text = format!("{gap}, {options}");
            assert_only_fault(&text, on_unit(&text), rule);
        }
    }
    for (text, rule) in [
        ("sphere(20) - sphere(10), order = 4, max_radius = 12", "falls from the centre"),
        ("conic(5, -5) - 1e-6*r^6, order = 4, max_radius = 50", "r = 2.5, where the series"),
        ("conic(20, 4) - 0.01*r^2.3, order = auto, tolerance = 1e-5, max_radius = 9", "where the series"),
    ] {
        assert_only_fault(text, on_unit(text), rule);
    }
}

/// Fields elsewhere do not change where a range ends.
#[test]
fn a_range_that_reaches_a_rim_whatever_the_fields_are_is_refused() {
    for (text, rule) in [
        (
            "sphere(10) + radius^2*r^2, order = 4, max_radius = 12",
            "below r = 10, where the series of a surface ends; write at most `9.999999`",
        ),
        ("radius*sphere(10) - r^4, order = 4, max_radius = 10", "below r = 10"),
        ("sphere(10) + radius*r^2, order = 4, max_radius = 12, tolerance = 0.1", "below r = 10"),
        (
            "sphere(radius), order = 4, max_radius = radius, positive",
            "below the r with |1 + k| r^2 = R^2 (r = R for a sphere)",
        ),
        ("sphere(radius), order = 4, max_radius = 2*radius", "write a smaller one"),
        ("conic(2*radius + 2, -5), order = 4, max_radius = radius + 1", "write a smaller one"),
        ("conic(1, radius - 1), order = 4, max_radius = radius^-0.5", "write a smaller one"),
    ] {
        assert_only_fault(text, on_ball(text), rule);
    }
    for (text, count) in [
        ("sphere(10) + radius^2*r^2, order = 4, max_radius = 9.999999", 0),
        ("sphere(radius), order = 4, max_radius = 0.9*radius, positive", 0),
        ("sphere(radius) + sphere(10), order = 4, max_radius = 9", 1),
        ("sphere(10), order = 4, max_radius = radius", 1),
        ("conic(10, -1) + sphere(radius), order = 4", 0),
    ] {
        let unchecked = on_ball(text).unwrap().truncation.unwrap().unchecked;
        assert_eq!(unchecked.len(), count, "{text}");
    }
}

/// What follows `option`, up to the next comma or backtick.
fn value_of<'a>(option: &str, text: &'a str) -> Option<&'a str> {
    let value = text.split_once(option)?.1;
    value.split([',', '`']).next()
}

/// The attribute with the option that its message proposes; nothing if the proposal is not a number.
fn mended(text: &str, message: &str) -> Option<String> {
    for (words, option) in
        [("write at most `", "max_radius = "), ("max_radius = ", "max_radius = "), ("`order = ", "order = ")]
    {
        if let Some(value) = value_of(words, message) {
            let replaced = value_of(option, text).map(|own| text.replace(&format!("{option}{own}"), ""));
            return Some(
                format!("{}, {option}{value}", replaced.unwrap_or(text.to_owned())).replace(", ,", ","),
            );
        }
    }
    None
}

#[test]
fn remedies_work() {
    for (text, remedy) in [
        ("sphere(10) - 0.0002*r^4, order = 4", "add `max_radius = 9.999999`, as the series"),
        ("conic(10, -1) - 0.0002*r^4, order = 4", "add `max_radius = 13.69306`"),
        ("upper = sphere(10), lower = -conic(20, 10), order = 4", "write `max_radius = 4.52`, for example"),
        ("conic(15, -0.5) - conic(16.5, 4), order = 4", "`, for example"),
        ("sphere(10) - 0.0002*r^4, order = 4, max_radius = 23", "below r = 10, where"),
        ("sphere(10) - 0.0002*r^4, order = 4, max_radius = 12", "write at most `9.999999`"),
        (
            "sphere(10.06), order = 4, max_radius = 10.08",
            "r = 10.06, where the series of a surface ends; write at most `10.05999`",
        ),
        (
            "conic(10, 1), order = 8, max_radius = 10.08",
            "r = 7.07107, where the series of a surface ends; write at most `7.071067`",
        ),
        ("sphere(10) - sphere(12), order = 4, tolerance = 1e-4, max_radius = 5", "write `order = 12`"),
        (
            "sphere(10) - r^2/20, order = 2",
            "cancel up to r^2, and those behind it are neglected; write `order = 4`",
        ),
        ("sphere(10) - r^2/20, order = 2, tolerance = 1e-3, max_radius = 2", "neglected; write `order = "),
        (
            "sphere(10) - r^2/20 + r^6, order = 2, max_radius = 3",
            "as large as the gap itself before max_radius; write `order = ",
        ),
    ] {
        let messages = on_unit(text).err().unwrap();
        assert!(messages.len() == 1 && messages[0].contains(remedy), "{text}: {messages:?}");
        let mended = mended(text, &messages[0]).unwrap();
        assert!(on_unit(&mended).is_ok(), "{text}: {messages:?}; {mended}: {:?}", on_unit(&mended).err());
    }
}

#[test]
fn each_fault_of_a_surface_is_named() {
    for (text, rule) in [
        ("sphere(10)", "say how far, as in `order = 4`"),
        ("r^2, order = 4", "has no `sphere(R)`"),
        ("r^2, tolerance = 1e-6", "has no `sphere(R)`"),
        ("sphere(10), order = 3", "write `order = 4`"),
        ("sphere(10), order = 0", "write `order = 2`"),
        ("sphere(10), order = -7", "write `order = 2`"),
        ("sphere(10), order = 2.5", "write `order = 4`"),
        ("sphere(10), order = 130", "at most 128"),
        ("sphere(10), order = r", "an even number"),
        ("sphere(10), order = Auto", "or `auto`"),
        ("sphere(10), order = 4, tolerance = r", "between 0 and 1"),
        ("sphere(10), order = 4, tolerance = 1e-400, max_radius = 3", "between 0 and 1"),
        ("sphere(10), tolerance = 1e-6, max_radius = 3", "as in `order = auto`"),
        ("sphere(10), order = auto", "add one, as in `tolerance = 1e-6, max_radius = 6.0`"),
        ("r^2, order = 4, tolerance = 1e-6", "`order` and `tolerance` are for surfaces"),
        ("sphere(10) - sphere(10) + r^2, order = 4", "or they cancel"),
        ("conic{10, -0.5}, order = 4", "write `conic(10, -0.5)`"),
        ("sphere(0), order = 4", "must not be zero"),
        ("sphere(1 - 1), order = 4", "must not be zero"),
        ("sphere(-10), order = 4", "falls from the centre"),
        ("r*sphere(10), order = 4", "does not depend on r"),
        ("sphere(10)*sphere(20), order = 4", "does not depend on r"),
        ("sphere(10)^2, order = 4", "raised to a power"),
        ("r^2/sphere(10), order = 4", "nor be a divisor"),
        ("r^sphere(10), order = 4", "an exponent must be a number"),
        ("sphere(r), order = 4", "must not depend on r"),
        ("sphere(sphere(2)), order = 4", "must not be a surface"),
        ("conic(10, r), order = 4", "must not depend on r"),
        ("conic(, 1), order = 4", "something is missing here"),
        ("sphere(10), order = 4, max_radius = 10", "below r = 10"),
        ("conic(10, -5), order = 4, max_radius = 5", "below r = 5"),
        ("sphere(10), order = 4, tolerance = 0", "between 0 and 1"),
        ("sphere(10), order = 4, tolerance = 1e-6", "as in `max_radius = 6.0`"),
        ("sphere(10), order = auto, max_radius = 6", "add one, as in `tolerance = 1e-6`"),
        ("sphere(10), order = auto, max_radius = 9.99, tolerance = 1e-9", "no order up to 128"),
        (
            "sphere(10) + 1e-9 * r^2.35, order = auto, max_radius = 8, tolerance = 1e-9",
            "no order below 70 is within this tolerance, and what others neglect cannot be compared",
        ),
        (
            "sphere(10) + 1e-9 * r^2.3, order = 4, max_radius = 8, tolerance = 1e-12",
            "order 4 neglects up to 0.0724 of the gap, more than the tolerance of 1e-12; no order below 100",
        ),
        (
            "sphere(10) + 1e-9 * r^2.3547, order = 4, max_radius = 8, tolerance = 1e-9",
            "what order 4 neglects cannot be compared with a tolerance beside these exponents; lower the order",
        ),
        (
            "sphere(10) + 0.01 * r^2.351, order = auto, max_radius = 5, tolerance = 0.1",
            "what order 2 neglects cannot be compared with a tolerance beside these exponents; round the exponents",
        ),
        ("sphere(10) - sphere(9) + 0.01*r^2, order = 2, max_radius = 8.9", "as large as the gap itself"),
        ("sphere(10) + 1/r, order = 4, max_radius = 5, tolerance = 1e-3", "a gap that opens at r = 0"),
        ("sphere(0.0034) + r^128, order = 128", "order 128 has coefficients beyond the range"),
        ("sphere(0.001), order = auto, max_radius = 0.002, tolerance = 1e-3", "must lie below r = 0.001"),
    ] {
        assert_only_fault(text, on_unit(text), rule);
    }
    for (text, rule) in [
        ("sphere(radius), order = 4, max_radius = 1, tolerance = 1e-6", "this gap depends on fields"),
        ("sphere(radius), order = auto, max_radius = 1, tolerance = 1e-6", "write a number for the order"),
        ("sphere(10), order = auto, max_radius = radius, tolerance = 1e-6", "max_radius depends on fields"),
        ("sphere(radius - radius), order = 4", "must not be zero"),
        ("sphere(10), order = radius", "an even number"),
    ] {
        let messages = on_ball(text).err().unwrap();
        assert!(messages.iter().any(|message| message.contains(rule)), "{text}: {messages:?}");
    }
}

/// What is left of the highest powers is too small for an `f64`, though each surface alone is not.
#[test]
fn surfaces_that_nearly_cancel_are_one_fault() {
    let messages = on_unit("sphere(10) - conic(10, -1e-300), order = 128").err().unwrap();
    assert_eq!(messages, ["order 128 has coefficients beyond the range of `f64`; write a lower one"]);
    let messages = on_unit("sphere(10) + 1e-390*r^3, order = 4").err().unwrap();
    assert!(matches!(&messages[..], [only] if only.starts_with("coefficient does not fit")), "{messages:?}");
}
