//! Numbers in decimal.

/// Digits of the largest number.
pub const DIGITS: usize = 10;

/// Writes a number in decimal, blanks in front.
///
/// By doubling decimal digits, a bit of the number at a time: a division of 32 bits would take 1.5 KB
/// of flash, and a table of powers 40 bytes of RAM. At most 0.1 ms for a number of 16 bits.
#[inline(never)]
pub fn decimal(mut number: u32, digits: &mut [u8; DIGITS]) {
    digits.fill(b' ');
    if let Some(last) = digits.last_mut() {
        *last = b'0';
    }
    let mut bits = 32u8;
    while bits > 8 && number >> 24 == 0 {
        number <<= 8;
        bits -= 8;
    }
    while bits > 0 {
        bits -= 1;
        let mut carry = (number >> 31) as u8;
        number <<= 1;
        for digit in digits.iter_mut().rev() {
            if *digit == b' ' {
                // Here the number ends, or grows by a digit.
                if carry != 0 {
                    *digit = b'1';
                }
                break;
            }
            *digit = (*digit - b'0') * 2 + carry;
            carry = 0;
            if *digit >= 10 {
                *digit -= 10;
                carry = 1;
            }
            *digit += b'0';
        }
    }
}
