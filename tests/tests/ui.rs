//! What the compiler says about faulty profiles, one fault in a file; `TRYBUILD=overwrite` renews the answers.

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
    cases.pass("tests/ui/hygiene/*.rs");
}
