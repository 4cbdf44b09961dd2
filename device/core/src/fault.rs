//! Everything that can be wrong, each with a stable number and one line of text (NC-11).
//!
//! The tens tell the area: 1 the text of the file, 2 its codes, 3 its structure, 4 its size,
//! 5 the card, 6 the board itself, 7 jumps, 8 pushed values and IFs. LED L flashes the tens long and the units short, so no number ends in 0.
//! A number that has been published never changes its meaning.

use core::fmt;

/// Gives the table of faults to a macro: `$with! { number Name "text"; … }`.
macro_rules! faults {
    ($with:ident) => {
        $with! {
            11 Utf16 "the file is UTF-16 text; save it as UTF-8 or ANSI (NC-3)";
            12 StrayCharacter "not a code: only digits, a leading - and / for a comment (NC-4)";
            13 StrayCarriageReturn "a CR without LF; save with CRLF or LF line ends (NC-3)";
            14 NumberTooLarge "the number does not fit in 32 bits (NC-2)";
            15 MinusZero "-0 is not a code (NC-2)";
            21 EmptyFile "the file contains no code";
            22 NoStart "the first code must be 0, program start";
            23 SecondStart "a second 0; only the first code may be 0";
            24 UnknownCode "no such code";
            25 NoSuchInput "this board has no such input";
            26 NoSuchOutput "this board has no such output";
            27 NoSuchBranchPoint "a branch point must be 01 to 08 (NC-8)";
            28 NoSuchPoint "no such marker, counter, register, channel, bit, label or number";
            29 NoSuchTimer "the program has no timer with that number (NC-14)";
            31 CloseWithoutOpen "41 closes a branch, but none is open (NC-8)";
            32 BranchLeftOpen "this 40 is not closed by 41 in its rung (NC-8)";
            33 RecallBeforeStore "this rung has not stored that branch point (NC-8)";
            34 NestedTooDeep "more than 8 branches open (NC-8)";
            35 OperandsMissing "operand lines are missing after this code";
            36 BadPreset "a preset is 0 to 2147483647 (NC-9, NC-15)";
            37 BadTimerOutput "the preset must be followed by 79XX, 77XX or 84XX (NC-9)";
            38 BadOperand "that operand line is out of its range";
            39 PinUsedTwice "a pin is used in two ways: 05-08 and A 00-03, output and PWM (NC-18)";
            41 ProgramFull "the program does not fit in program memory from here on (NC-10)";
            42 RunMemoryFull "the program does not fit in run memory from here on (NC-10)";
            43 CannotKeep "KD and KC must come first, 16 at most (NC-21)";
            51 NoCard "no card answers; check the slot and the wires at D10 to D13";
            52 CardDead "the card answers but does not become ready; try another (no MMC)";
            53 CardReadError "the card cannot be read; try again or try another";
            54 NoVolume "the card is not FAT16 or FAT32; format it";
            55 NoProgramFile "no PROGRAM.TXT in the root folder (is it PROGRAM.TXT.TXT?)";
            56 VolumeDamaged "the card's FAT is damaged; check or format the card";
            57 FileChanged "the second reading found another program; use another card";
            61 ScanTooLong "a scan took more than 110 ms; press reset to try again";
            62 ProgramDamaged "the program in run memory has changed; press reset";
            63 StackOverflow "the stack has reached run memory; press reset";
            64 SupplyLow "the supply is below 4.3 V; use a better cable or supply";
            65 NoStoredProgram "no card with a program, and no valid program is stored";
            66 StoreFailed "program memory does not keep the data written to it";
            71 LabelTwice "this label appears twice (NC-19)";
            72 NoSuchLabel "the program has no such label (NC-19)";
            73 LabelInRung "a label must be at the start of a rung (NC-19)";
            74 JumpInBranch "no jump, return or IF between 40 and 41 or after PSH (NC-19)";
            75 TooManyJumps "too many backward jumps in one scan (NC-19)";
            81 NothingPushed "no value is pushed here (NC-22)";
            82 PushedTooDeep "more than 8 values pushed (NC-22)";
            83 ValueLeftPushed "a value is still pushed at the end of the rung (NC-22)";
            84 NotReal "not the bits of a finite REAL number (NC-23)";
            85 NoIf "no IF is open here (NC-28)";
            86 IfTooDeep "more than 8 IFs open (NC-28)";
            87 IfLeftOpen "this IF has no END (NC-28)";
        }
    };
}

macro_rules! cause {
    ($($number:literal $name:ident $text:literal;)*) => {
        /// What is wrong. Its discriminant is the fault number.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[repr(u8)]
        pub enum Cause {
            $(#[doc = $text] $name = $number,)*
        }

        impl Cause {
            /// Every cause, in the order of its number.
            pub const ALL: &'static [Cause] = &[$(Cause::$name,)*];

            /// One line of text: what is wrong, and what to do where that is not plain.
            pub const fn text(self) -> &'static str {
                match self {
                    $(Cause::$name => $text,)*
                }
            }
        }
    };
}
faults!(cause);

impl Cause {
    /// The stable number, 11–99.
    pub const fn number(self) -> u8 {
        self as u8
    }
}

/// A cause and its place in the file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fault {
    /// What is wrong.
    pub cause: Cause,
    /// The line, counted from 1 over every line of the file; none where the file as a whole, or
    /// the card, is at fault.
    pub line: Option<u32>,
}

impl Fault {
    /// A fault of the file as a whole or of the card.
    pub const fn without_line(cause: Cause) -> Fault {
        Fault { cause, line: None }
    }
}

impl fmt::Display for Fault {
    /// `fault 24, line 7: no such code`
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "fault {}", self.cause.number())?;
        if let Some(line) = self.line {
            write!(f, ", line {line}")?;
        }
        write!(f, ": {}", self.cause.text())
    }
}

impl core::error::Error for Fault {}
