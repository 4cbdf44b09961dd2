//! A stream of random numbers that its seed decides.

/// From this seed on.
#[derive(Clone, Debug)]
pub struct Random(pub u64);

impl Random {
    /// The next 64 random bits.
    pub fn bits(&mut self) -> u64 {
        unoclp_random::bits(&mut self.0)
    }

    /// A number from 0 to `limit` − 1; 0 where the limit is 0.
    pub fn below(&mut self, limit: usize) -> usize {
        ((u128::from(self.bits()) * limit as u128) >> 64) as usize
    }

    /// One of these.
    ///
    /// # Panics
    /// Where there are none.
    pub fn pick<T: Copy>(&mut self, from: &[T]) -> T {
        from[self.below(from.len())]
    }

    /// True in this many of a hundred cases.
    pub fn percent(&mut self, cases: usize) -> bool {
        self.below(100) < cases
    }

    /// Which of so many inputs turn over, as bits from 0 on: each in this many of a hundred cases.
    pub fn turns(&mut self, inputs: usize, cases: usize) -> u128 {
        (0..inputs).fold(0, |bits, input| {
            bits | u128::from(self.percent(cases)) << input
        })
    }
}
