//! `Polynomial::new`, `Contact::new`, `at` and `pressure` on anything; see `tests::stress::soundness`.

#![no_main]

use libfuzzer_sys::arbitrary::Unstructured;
use libfuzzer_sys::fuzz_target;
use tests::stress::soundness;

fuzz_target!(|data: &[u8]| {
    let mut data = Unstructured::new(data);
    let is_single = data.arbitrary().unwrap_or_default();
    let mut word = || data.arbitrary().unwrap_or_default();
    let checked = if is_single {
        soundness::check::<f32>(&soundness::scene(&mut word))
    } else {
        soundness::check::<f64>(&soundness::scene(&mut word))
    };
    if let Err(unsound) = checked {
        panic!("{unsound}");
    }
});
