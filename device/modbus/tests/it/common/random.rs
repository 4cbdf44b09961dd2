//! Numbers that look random and are the same in every run.

/// Marsaglia's xorshift, 32 bits.
pub struct Random(u32);

impl Random {
    pub fn new(seed: u32) -> Random {
        assert_ne!(seed, 0);
        Random(seed)
    }

    pub fn next(&mut self) -> u32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 17;
        self.0 ^= self.0 << 5;
        self.0
    }

    /// 0 … limit − 1
    pub fn below(&mut self, limit: u32) -> u32 {
        (self.next() >> 8) % limit
    }

    pub fn byte(&mut self) -> u8 {
        self.below(256) as u8
    }

    pub fn pick<T: Copy>(&mut self, of: &[T]) -> T {
        of[self.below(of.len() as u32) as usize]
    }
}
