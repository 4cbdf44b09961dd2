//! From the bytes of a file to its codes (NC-2, NC-3, NC-4).
//!
//! Owns line ends, marks, comments and digits; must not know what a code means.

use crate::Cause;

/// What a byte of a file belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// A mark at the head of the file, a blank, or the end of a line.
    Blank,
    /// A code or operand.
    Code,
    /// A comment, its first `/` included.
    Comment,
    /// Nothing that can be read: the rest of a line behind a fault.
    Faulty,
}

/// Where in a line the reader stands.
#[derive(Clone, Copy, PartialEq, Eq)]
enum At {
    /// The first byte of the file, where a mark may stand.
    Start,
    /// After the first byte of a UTF-8 mark.
    Utf8Mark1,
    /// After the first two.
    Utf8Mark2,
    /// After the first byte of a UTF-16 mark: low byte first, or high byte first.
    Utf16LeMark,
    Utf16BeMark,
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

/// The largest magnitude that another digit can be put behind without a wrap.
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
        match core::mem::replace(&mut self.at, At::End) {
            At::Return => Err(Cause::StrayCarriageReturn),
            At::Minus | At::Utf8Mark1 | At::Utf8Mark2 | At::Utf16LeMark | At::Utf16BeMark => {
                Err(Cause::StrayCharacter)
            }
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
        Ok(match (self.at, byte) {
            (At::End, _) => At::End,
            (At::Start, 0xEF) => At::Utf8Mark1,
            (At::Start, 0xFF) => At::Utf16LeMark,
            (At::Start, 0xFE) => At::Utf16BeMark,
            (At::Utf8Mark1, 0xBB) => At::Utf8Mark2,
            (At::Utf8Mark2, 0xBF) => At::Blank,
            (At::Utf16LeMark, 0xFE) | (At::Utf16BeMark, 0xFF) => return Err(Cause::Utf16),
            (At::Minus, b'0'..=b'9') => self.digit(byte)?,
            (At::Utf8Mark1 | At::Utf8Mark2 | At::Utf16LeMark | At::Utf16BeMark | At::Minus, _) => {
                return Err(Cause::StrayCharacter);
            }
            (_, b'\n') => At::Blank,
            (At::Comment | At::Faulty, _) => self.at,
            (At::Return, _) => return Err(Cause::StrayCarriageReturn),
            (At::Digits, b'0'..=b'9') => self.digit(byte)?,
            (At::Start | At::Blank, b'-' | b'0'..=b'9') => {
                self.negative = byte == b'-';
                self.magnitude = 0;
                if self.negative {
                    At::Minus
                } else {
                    self.digit(byte)?
                }
            }
            (_, b'/') => At::Comment,
            (_, b'\r') => At::Return,
            (At::Digits | At::After, b' ' | b'\t') => At::After,
            (_, b' ' | b'\t') => At::Blank,
            _ => return Err(Cause::StrayCharacter),
        })
    }

    fn digit(&mut self, byte: u8) -> Result<At, Cause> {
        let most = i32::MAX.unsigned_abs() + u32::from(self.negative);
        if self.magnitude > BEFORE_LAST_DIGIT {
            return Err(Cause::NumberTooLarge);
        }
        self.magnitude = self.magnitude * 10 + u32::from(byte - b'0');
        if self.magnitude > most {
            return Err(Cause::NumberTooLarge);
        }
        self.has_code = true;
        Ok(At::Digits)
    }

    fn end_of_line(&mut self) -> Result<bool, Cause> {
        let has_code = core::mem::take(&mut self.has_code);
        if has_code && self.negative && self.magnitude == 0 {
            return Err(Cause::MinusZero);
        }
        Ok(has_code)
    }
}
