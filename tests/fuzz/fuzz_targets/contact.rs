//! `Polynomial::new`, `Contact::new`, `at` and `pressure` on anything; see `tests::stress::soundness`.

#![no_main]

use libfuzzer_sys::arbitrary::Unstructured;
use libfuzzer_sys::fuzz_target;
use tests::stress::soundness;

fuzz_target!(|data: &[u8]| {
    let mut data = Unstructured::new(data);
    let scene = soundness::scene(&mut || data.arbitrary().unwrap_or_default());
    if let Err(unsound) = soundness::check(&scene) {
        panic!("{unsound}");
    }
});
