//! From the bytes of a file to its codes (NC-2, NC-3, NC-4).
//!
//! Owns line ends, marks, comments and digits; must not know what a code means.

use crate::Cause;
use core::mem;

/// What a byte of a file belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// A mark at the head of the file, a blank, or the end of a line.
    Blank,
    /// A code or operand.
    Code,
    /// A comment, its first `/` included.
    Comment,
    /// Nothing that can be read: the rest of a line after a fault.
    Faulty,
}

/// Where in a line the reader stands.
#[derive(Clone, Copy, PartialEq, Eq)]
enum At {
    /// The first byte of the file, where a mark may stand.
    Start,
    /// In a mark of UTF-8 or UTF-16, whose last byte is the magnitude.
    Mark,
    /// Before the code.
    Blank,
    /// After a `-`, before its digits.
    Minus,
    /// In the digits.
    Digits,
    /// After the code.
    After,
    /// In a comment.
    Comment,
    /// After a CR, before its LF.
    Return,
    /// On a line that has a fault: the rest of it is passed over.
    Faulty,
    /// Past the end of the file, or in a file that has no lines.
    End,
}

/// Reads the codes of a file, one byte at a time.
pub(crate) struct Text {
    at: At,
    /// Whether this line holds a code.
    has_code: bool,
    /// The code that was read last, or as much of it as has come.
    negative: bool,
    magnitude: u32,
}

/// The largest magnitude that another digit can be put after without a wrap.
const BEFORE_LAST_DIGIT: u32 = i32::MIN.unsigned_abs() / 10;

impl Text {
    pub(crate) const fn new() -> Text {
        Text {
            at: At::Start,
            has_code: false,
            negative: false,
            magnitude: 0,
        }
    }

    /// Takes a byte. True where it ends a line that holds a code, which [`Text::code`] then tells.
    ///
    /// After a fault the rest of the line is passed over; the next line is read as usual.
    pub(crate) fn push(&mut self, byte: u8) -> Result<bool, Cause> {
        match self.next(byte) {
            Ok(at) => self.at = at,
            Err(cause) => {
                self.has_code = false;
                self.at = match (cause, byte) {
                    (Cause::Utf16, _) => At::End,
                    (_, b'\n') => At::Blank,
                    _ => At::Faulty,
                };
                return Err(cause);
            }
        }
        if byte == b'\n' {
            self.end_of_line()
        } else {
            Ok(false)
        }
    }

    /// The end of the file: true where a last line that no LF ended holds a code.
    pub(crate) fn end(&mut self) -> Result<bool, Cause> {
        match mem::replace(&mut self.at, At::End) {
            At::Return => Err(Cause::StrayCarriageReturn),
            At::Minus | At::Mark => Err(Cause::StrayCharacter),
            _ => self.end_of_line(),
        }
    }

    /// What the byte taken last belongs to.
    pub(crate) fn part(&self) -> Part {
        match self.at {
            At::Minus | At::Digits => Part::Code,
            At::Comment => Part::Comment,
            At::Faulty | At::End => Part::Faulty,
            _ => Part::Blank,
        }
    }

    /// The code of the line that has just ended.
    pub(crate) fn code(&self) -> i32 {
        let code = self.magnitude.cast_signed();
        if self.negative {
            code.wrapping_neg()
        } else {
            code
        }
    }

    fn next(&mut self, byte: u8) -> Result<At, Cause> {
        if self.at == At::Mark || self.at == At::Start && byte >= 0xEF {
            return self.mark(byte);
        }
        if matches!(self.at, At::Start | At::Blank) {
            self.negative = byte == b'-';
            self.magnitude = 0;
        }
        Ok(match (self.at, byte) {
            (At::End, _) => At::End,
            (At::Minus | At::Digits | At::Start | At::Blank, b'0'..=b'9') => self.digit(byte)?,
            (At::Minus, _) => return Err(Cause::StrayCharacter),
            (_, b'\n') => At::Blank,
            (At::Comment | At::Faulty, _) => self.at,
            (At::Return, _) => return Err(Cause::StrayCarriageReturn),
            (At::Start | At::Blank, b'-') => At::Minus,
            (_, b'/') => At::Comment,
            (_, b'\r') => At::Return,
            (At::Digits | At::After, b' ' | b'\t') => At::After,
            (_, b' ' | b'\t') => At::Blank,
            _ => return Err(Cause::StrayCharacter),
        })
    }

    /// The next byte of a mark: EF BB BF is one of UTF-8, FF FE and FE FF are those of UTF-16.
    #[inline(never)]
    fn mark(&mut self, byte: u8) -> Result<At, Cause> {
        let before = mem::replace(&mut self.magnitude, byte.into()) as u8;
        match (before, byte) {
            (0, 0xEF | 0xFE | 0xFF) | (0xEF, 0xBB) => Ok(At::Mark),
            (0xBB, 0xBF) => Ok(At::Blank),
            (0xFF, 0xFE) | (0xFE, 0xFF) => Err(Cause::Utf16),
            _ => Err(Cause::StrayCharacter),
        }
    }

    fn digit(&mut self, byte: u8) -> Result<At, Cause> {
        if self.magnitude > BEFORE_LAST_DIGIT {
            return Err(Cause::NumberTooLarge);
        }
        self.magnitude = self.magnitude * 10 + u32::from(byte - b'0');
        // -2147483648 is a number, 2147483648 is none.
        let less = self.magnitude.wrapping_sub(self.negative.into());
        if (self.magnitude & less).cast_signed() < 0 {
            return Err(Cause::NumberTooLarge);
        }
        self.has_code = true;
        Ok(At::Digits)
    }

    fn end_of_line(&mut self) -> Result<bool, Cause> {
        let has_code = mem::take(&mut self.has_code);
        if has_code && self.negative && self.magnitude == 0 {
            return Err(Cause::MinusZero);
        }
        Ok(has_code)
    }
}
