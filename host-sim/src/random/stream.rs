//! Random numbers.

/// A stream of random numbers that its seed decides.
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// The stream of this seed.
    pub fn new(seed: u64) -> Random {
        Random(seed)
    }

    /// The next 64 random bits.
    pub fn bits(&mut self) -> u64 {
        unoclp_random::bits(&mut self.0)
    }

    /// A number from 0 to `limit` − 1; 0 where the limit is 0.
    pub fn below(&mut self, limit: u32) -> u32 {
        // The high word of the product is below the limit.
        ((u64::from(limit) * (self.bits() >> 32)) >> 32) as u32
    }

    /// True in this many of a hundred cases.
    pub fn percent(&mut self, cases: u32) -> bool {
        self.below(100) < cases
    }

    /// One of these; none where there are none.
    pub fn pick<T: Copy>(&mut self, from: &[T]) -> Option<T> {
        from.get(self.below(from.len() as u32) as usize).copied()
    }

    /// A number from `first` to `last`.
    pub(super) fn number(&mut self, first: u8, last: u8) -> u8 {
        let count = u32::from(last.saturating_sub(first)) + 1;
        first + self.below(count) as u8
    }
}
