//! The compiler's messages about faulty profiles, one fault per file; `TRYBUILD=overwrite` renews them.

use trybuild::TestCases;

#[test]
fn faults_are_explained_where_they_are() {
    let cases = TestCases::new();
    for concern in [
        "syntax",
        "symbols",
        "exponents",
        "admissibility",
        "surfaces",
        "options",
        "positive",
        "items",
        "several",
        "traits",
    ] {
        cases.compile_fail(format!("tests/ui/{concern}/*.rs"));
    }
    cases.pass("tests/ui/pass/*.rs");
}
