//! Random numbers that a seed decides: what is simulated and tested comes again.
//!
//! Owns the generator, SplitMix64. Must not know what its numbers are for.

#![no_std]
#![forbid(unsafe_code)]

#[cfg(feature = "tape")]
extern crate std;
#[cfg(feature = "tape")]
pub mod tape;

/// The next 64 random bits of this state, whose first value is the seed.
pub fn bits(state: &mut u64) -> u64 {
    let own = split_mix(state);
    #[cfg(feature = "tape")]
    let own = tape::next(own);
    own
}

/// Steele, Lea and Flood, 2014.
fn split_mix(state: &mut u64) -> u64 {
    *state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
    let z = *state;
    let z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests {
    /// The first numbers of the seed 0, as its authors give them.
    #[test]
    fn it_is_splitmix64() {
        let mut state = 0;
        let first = [(); 3].map(|()| super::split_mix(&mut state));
        let given = [
            0xE220_A839_7B1D_CDAF,
            0x6E78_9E6A_A1B9_65F4,
            0x06C4_5D18_8009_454F,
        ];
        assert_eq!(first, given);
    }
}
