//! Numbers in decimal.

/// Digits of the largest number.
pub const DIGITS: usize = 10;

/// Writes a number in decimal, blanks in front.
///
/// Divides by ten a bit at a time, and no more bits than the number has bytes for: a division of 32
/// bits at once would take 1.5 KB of flash. At most 0.1 ms for a number of 16 bits.
#[inline(never)]
pub fn decimal(mut number: u32, digits: &mut [u8; DIGITS]) {
    digits.fill(b' ');
    for digit in digits.iter_mut().rev() {
        let (mut rest, mut bits) = (0, 32u8);
        while bits > 8 && number >> 24 == 0 {
            number <<= 8;
            bits -= 8;
        }
        // The quotient comes in from below as the number goes out above.
        while bits > 0 {
            rest = rest << 1 | (number >> 31) as u8;
            number <<= 1;
            if rest >= 10 {
                rest -= 10;
                number |= 1;
            }
            bits -= 1;
        }
        *digit = b'0' + rest;
        if number == 0 {
            break;
        }
    }
}
