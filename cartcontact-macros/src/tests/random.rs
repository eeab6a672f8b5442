//! Random tokens: whatever is written, the macro answers with a solver or with messages.
//!
//! `GAP_PROFILE_INPUTS` sets the number of inputs, `GAP_PROFILE_SEED` the seed.

use std::env;

use proc_macro2::TokenStream;
use quote::quote;

use crate::expand;

/// The words that an input is put together from; common ones are repeated.
const WORDS: &str = "r r r r ^ ^ ^ + + - * * / ( ) ( ) 2 0.5 3 1e-300 1e300 7 64 radius radius name ** 2r , max_radius = \
                     crate . < 'a \"s\" [ ] 1024 sphere conic sphere(3) conic(radius,-0.5) ,order=4 ,order=auto \
                     ,tolerance=1e-3 ,max_radius=1 upper= lower=";

/// With these, surfaces occur more often than word by word.
const BEGINNINGS: [&str; 6] = ["", "", "", "sphere(3) + ", "sphere(2) - sphere(", "lower = r^2, upper = "];

/// The initial state; any number but zero would do.
pub(super) const SEED: u64 = 0x9E37_79B9_7F4A_7C15;

pub(super) struct Random(pub(super) u64);

impl Random {
    /// Marsaglia's xorshift.
    pub(super) fn below(&mut self, limit: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 33) as usize % limit
    }
}

fn setting(name: &str, otherwise: u64) -> u64 {
    env::var(name).ok().and_then(|value| value.parse().ok()).unwrap_or(otherwise)
}

#[test]
fn no_text_makes_it_panic() {
    let inputs = setting("GAP_PROFILE_INPUTS", 20_000);
    let mut random = Random(setting("GAP_PROFILE_SEED", SEED).max(1));
    let all: Vec<&str> = WORDS.split_whitespace().collect();
    let (mut read, mut solved) = (0_u64, 0_u64);
    for _ in 0..inputs {
        let length = 1 + random.below(14);
        let words: Vec<&str> = (0..length).map(|_| all[random.below(all.len())]).collect();
        let text = format!("{} {}", BEGINNINGS[random.below(BEGINNINGS.len())], words.join(" "));
        let Ok(tokens) = text.parse::<TokenStream>() else { continue };
        read += 1;
        let item = quote!(
            struct Ball {
                radius: f64,
                name: String,
            }
        );
        solved += u64::from(!expand(tokens, item).to_string().contains("compile_error"));
    }
    println!("{inputs} inputs: {read} are tokens, {solved} have a solver");
    assert!(read > inputs / 4 && solved > inputs / 400);
}
