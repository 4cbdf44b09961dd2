//! The elementary types of IEC 61131-3, table 10.
//!
//! Owns their names, their ranges, which goes into which by itself, and the width in which the arithmetic
//! of each is done. Must not know variables or texts.

use std::fmt;

/// How arithmetic on a type is done: on the board's 32 bits, or on the PC alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Width {
    /// One bit.
    Bit,
    /// 32 bits with a sign: what the board's value accumulator does.
    Signed,
    /// 32 bits without a sign: compares, divides and converts so.
    Unsigned,
    /// 64 bits with a sign; not on the board.
    Signed64,
    /// 64 bits without a sign; not on the board.
    Unsigned64,
    /// IEEE 754 single.
    Single,
    /// IEEE 754 double; not on the board.
    Double,
    /// Text; not on the board.
    Text,
}

/// The generic types: what a function takes. Nobody can declare one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Generic {
    /// Any elementary type.
    Elementary,
    /// Numbers and times.
    Magnitude,
    /// Integers and reals.
    Num,
    /// REAL and LREAL.
    Real,
    /// Integers.
    Int,
    /// BOOL and bit strings.
    Bit,
    /// STRING and WSTRING.
    Text,
    /// DATE, TOD, DT.
    Date,
}

macro_rules! bases {
    ($($name:ident $written:literal $width:ident $bits:literal;)*) => {
        /// An elementary type, or the type of a number in a text, `ANY_INT` and `ANY_REAL`, until it is settled
        /// which it is: a finished tree has none of these two.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Base { $(#[doc = $written] $name,)* }

        impl Base {
            /// All of them, in order.
            pub const ALL: &'static [Base] = &[$(Base::$name,)*];

            /// As it is written.
            pub const fn name(self) -> &'static str {
                match self { $(Base::$name => $written,)* }
            }

            /// In what its arithmetic is done.
            pub const fn width(self) -> Width {
                match self { $(Base::$name => Width::$width,)* }
            }

            /// The bits that a variable of it keeps.
            pub const fn bits(self) -> u32 {
                match self { $(Base::$name => $bits,)* }
            }
        }
    };
}

bases! {
    Bool "BOOL" Bit 1;
    Sint "SINT" Signed 8;
    Int "INT" Signed 16;
    Dint "DINT" Signed 32;
    Lint "LINT" Signed64 64;
    Usint "USINT" Signed 8;
    Uint "UINT" Signed 16;
    Udint "UDINT" Unsigned 32;
    Ulint "ULINT" Unsigned64 64;
    Byte "BYTE" Signed 8;
    Word "WORD" Signed 16;
    Dword "DWORD" Unsigned 32;
    Lword "LWORD" Unsigned64 64;
    Real "REAL" Single 32;
    Lreal "LREAL" Double 64;
    Time "TIME" Signed 32;
    Date "DATE" Unsigned 32;
    Tod "TIME_OF_DAY" Signed 32;
    Dt "DATE_AND_TIME" Unsigned 32;
    Str "STRING" Text 0;
    Wstr "WSTRING" Text 0;
    AnyInt "ANY_INT" Signed64 64;
    AnyReal "ANY_REAL" Double 64;
}

impl fmt::Display for Base {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl Base {
    /// The elementary type of this name, in upper case; `TOD` and `DT` too.
    pub fn named(name: &str) -> Option<Base> {
        match name {
            "TOD" => return Some(Base::Tod),
            "DT" => return Some(Base::Dt),
            "ANY_INT" | "ANY_REAL" => return None,
            _ => {}
        }
        Base::ALL.iter().copied().find(|base| base.name() == name)
    }

    /// SINT to ULINT, and a number that is not settled.
    pub fn is_int(self) -> bool {
        use Base::*;
        matches!(
            self,
            Sint | Int | Dint | Lint | Usint | Uint | Udint | Ulint | AnyInt
        )
    }

    /// REAL, LREAL, and a number with a point that is not settled.
    pub fn is_real(self) -> bool {
        matches!(self, Base::Real | Base::Lreal | Base::AnyReal)
    }

    /// An integer or a real.
    pub fn is_num(self) -> bool {
        self.is_int() || self.is_real()
    }

    /// BYTE, WORD, DWORD, LWORD.
    pub fn is_bits(self) -> bool {
        matches!(self, Base::Byte | Base::Word | Base::Dword | Base::Lword)
    }

    /// The number without a sign of as many bits; none of what is no bit string.
    pub fn counted(self) -> Option<Base> {
        Some(match self {
            Base::Byte => Base::Usint,
            Base::Word => Base::Uint,
            Base::Dword => Base::Udint,
            Base::Lword => Base::Ulint,
            _ => return None,
        })
    }

    /// DATE, TOD or DT.
    pub fn is_date(self) -> bool {
        matches!(self, Base::Date | Base::Tod | Base::Dt)
    }

    /// STRING or WSTRING.
    pub fn is_text(self) -> bool {
        matches!(self, Base::Str | Base::Wstr)
    }

    /// A number of a text whose type is not settled.
    pub fn is_any(self) -> bool {
        matches!(self, Base::AnyInt | Base::AnyReal)
    }

    /// Whether values are negative too.
    pub fn is_signed(self) -> bool {
        use Base::*;
        matches!(self, Sint | Int | Dint | Lint | Time | AnyInt)
    }

    /// A bit, or a whole number, a bit string or a time of at most 32 bits: what Instruction List computes with as DINT.
    pub fn is_plain(self) -> bool {
        let number = self.is_int() || self.is_bits() || self == Base::Time;
        self == Base::Bool || number && self.bits() <= 32
    }

    /// Whether the board has it.
    pub fn is_on_board(self) -> bool {
        !matches!(
            self.width(),
            Width::Signed64 | Width::Unsigned64 | Width::Double | Width::Text
        )
    }

    /// The least and the greatest value of a type whose values are whole numbers; none of a real or a text.
    pub fn range(self) -> Option<(i128, i128)> {
        if self.is_real() || self.is_text() {
            return None;
        }
        let bits = self.bits();
        Some(match self {
            Base::AnyInt => (i64::MIN.into(), u64::MAX.into()),
            Base::Tod => (0, 86_399_999),
            Base::Date => (0, 49_710),
            _ if self.is_signed() => (-(1_i128 << (bits - 1)), (1_i128 << (bits - 1)) - 1),
            _ => (0, (1_i128 << bits) - 1),
        })
    }

    /// Whether each value of this goes into that without loss, so that it does so by itself.
    pub fn widens_to(self, to: Base) -> bool {
        use Base::*;
        if self == to {
            return true;
        }
        match (self, to) {
            (AnyInt, _) => to.is_num() || to.is_bits(),
            (AnyReal, _) => to.is_real(),
            (_, AnyInt | AnyReal) => false,
            (Real, Lreal) => true,
            (Sint | Int | Usint | Uint, Real | Lreal) | (Dint | Udint, Lreal) => true,
            _ if self.is_bits() => to.is_bits() && self.bits() < to.bits(),
            _ if self.is_int() && to.is_int() => match (self.range(), to.range()) {
                (Some((low, high)), Some((least, most))) => least <= low && high <= most,
                _ => false,
            },
            _ => false,
        }
    }

    /// The type in which two operands meet: that of one of them, or the smallest that holds both.
    pub fn common(self, other: Base) -> Option<Base> {
        if self.widens_to(other) {
            return Some(other);
        }
        if other.widens_to(self) {
            return Some(self);
        }
        // LINT and LREAL are not taken unasked: the board has neither.
        let both = [Base::Int, Base::Dint, Base::Real];
        both.into_iter()
            .find(|&base| self.widens_to(base) && other.widens_to(base))
    }

    /// Whether it is of this generic type.
    pub fn is_of(self, generic: Generic) -> bool {
        match generic {
            Generic::Elementary => true,
            Generic::Magnitude => self.is_num() || self == Base::Time,
            Generic::Num => self.is_num(),
            Generic::Real => self.is_real(),
            Generic::Int => self.is_int(),
            Generic::Bit => self.is_bits() || matches!(self, Base::Bool | Base::AnyInt),
            Generic::Text => self.is_text(),
            Generic::Date => self.is_date(),
        }
    }
}

impl Generic {
    /// As the standard writes it.
    pub fn name(self) -> &'static str {
        match self {
            Generic::Elementary => "ANY_ELEMENTARY",
            Generic::Magnitude => "ANY_MAGNITUDE",
            Generic::Num => "ANY_NUM",
            Generic::Real => "ANY_REAL",
            Generic::Int => "ANY_INT",
            Generic::Bit => "ANY_BIT",
            Generic::Text => "ANY_STRING",
            Generic::Date => "ANY_DATE",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_loses_nothing_widens() {
        for (from, to, widens) in [
            (Base::Int, Base::Dint, true),
            (Base::Uint, Base::Int, false),
            (Base::Uint, Base::Dint, true),
            (Base::Int, Base::Real, true),
            (Base::Dint, Base::Real, false),
            (Base::Real, Base::Int, false),
            (Base::Byte, Base::Word, true),
            (Base::Byte, Base::Usint, false),
            (Base::AnyInt, Base::Real, true),
            (Base::AnyReal, Base::Int, false),
        ] {
            assert_eq!(from.widens_to(to), widens, "{from} {to}");
        }
        assert_eq!(Base::Int.common(Base::Uint), Some(Base::Dint));
        assert_eq!(Base::Dint.common(Base::Real), None);
        assert_eq!(Base::Time.common(Base::Int), None);
    }
}
