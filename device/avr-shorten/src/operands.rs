//! One spelling for each operand, so that rules may compare the text of operands.
//!
//! The assembler takes many spellings: `XL`, `R26`, `26` and `0x1a` name one register, `0x3f` and `63` one
//! place. A rule that missed one of them would take a register that an `asm!` block changes for one that it
//! leaves alone. So [`Code::parse`](super::assembly::Code::parse) brings every operand into the spelling that
//! LLVM prints. One that it cannot read stays as it is, and [`effects`](super::effects::effects) then answers
//! that the instruction may do anything.

/// What an operand is.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Register,
    Number,
    Pointer,
    Label,
}

/// The operands of an instruction. `None` if the mnemonic is not known.
fn kinds(name: &str) -> Option<[Kind; 2]> {
    use Kind::{Label, Number, Pointer, Register};
    Some(match name {
        "mov" | "movw" | "add" | "adc" | "sub" | "sbc" | "and" | "or" | "eor" | "cp" | "cpc"
        | "cpse" | "mul" | "muls" | "mulsu" | "fmul" | "fmuls" | "fmulsu" => [Register, Register],
        "ldi" | "subi" | "sbci" | "andi" | "ori" | "cpi" | "sbr" | "cbr" | "adiw" | "sbiw"
        | "in" | "lds" | "sbrc" | "sbrs" | "bst" | "bld" => [Register, Number],
        "clr" | "ser" | "tst" | "com" | "neg" | "inc" | "dec" | "lsl" | "lsr" | "rol" | "ror"
        | "asr" | "swap" | "push" | "pop" => [Register, Label],
        "out" | "sts" => [Number, Register],
        "sbi" | "cbi" | "sbic" | "sbis" => [Number, Number],
        "bset" | "bclr" => [Number, Label],
        "ld" | "ldd" | "lpm" | "elpm" => [Register, Pointer],
        "st" | "std" => [Pointer, Register],
        _ => return None,
    })
}

/// Brings the operands of an instruction into LLVM's spelling.
pub fn normalise(name: &str, operands: &mut [String]) {
    let Some(kinds) = kinds(name) else {
        return;
    };
    for (operand, kind) in operands.iter_mut().zip(kinds) {
        let spelled = match kind {
            Kind::Register => register(operand).map(|number| format!("r{number}")),
            // `-16` and `240` are the same byte; each is printed as it came.
            Kind::Number => number(operand).map(|number| number.to_string()),
            Kind::Pointer => pointer(operand),
            Kind::Label => None,
        };
        if let Some(spelled) = spelled {
            *operand = spelled;
        }
    }
}

/// The register that an operand names in any spelling.
fn register(text: &str) -> Option<u32> {
    // A pair may be written as `r25:r24`; it is named by its low register.
    let text = text.rsplit(':').next()?.trim().to_ascii_lowercase();
    let found = match text.as_str() {
        "xl" => 26,
        "xh" => 27,
        "yl" => 28,
        "yh" => 29,
        "zl" => 30,
        "zh" => 31,
        "__tmp_reg__" => 0,
        "__zero_reg__" => 1,
        _ => {
            let digits = text.strip_prefix('r').unwrap_or(&text);
            u32::try_from(number(digits)?).ok()?
        }
    };
    (found < 32).then_some(found)
}

/// A number in any of the assembler's bases.
pub fn number(text: &str) -> Option<i32> {
    let text = text.trim();
    if let Some(rest) = text.strip_prefix('-') {
        return number(rest)?.checked_neg();
    }
    let lower = text.to_ascii_lowercase();
    if let Some(digits) = lower.strip_prefix("0x") {
        i32::from_str_radix(digits, 16).ok()
    } else if let Some(digits) = lower.strip_prefix("0b") {
        i32::from_str_radix(digits, 2).ok()
    } else if lower.len() > 1 && lower.starts_with('0') {
        i32::from_str_radix(&lower, 8).ok()
    } else if lower.starts_with(|c: char| c.is_ascii_digit()) {
        lower.parse().ok()
    } else {
        None
    }
}

/// A pointer, as `X`, `-X`, `Z+`, `Y+3`.
fn pointer(text: &str) -> Option<String> {
    let plain: String = text.chars().filter(|c| !c.is_whitespace()).collect();
    let (before, rest) = match plain.strip_prefix('-') {
        Some(rest) => ("-", rest),
        None => ("", plain.as_str()),
    };
    let mut characters = rest.chars();
    let base = characters.next()?.to_ascii_uppercase();
    if !matches!(base, 'X' | 'Y' | 'Z') {
        return None;
    }
    match characters.as_str() {
        "" => Some(format!("{before}{base}")),
        "+" => Some(format!("{base}+")),
        offset => {
            let offset = number(offset.strip_prefix('+')?)?;
            Some(format!("{base}+{offset}"))
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::assembly::Code;
    use crate::effects::effects;

    #[test]
    fn every_spelling_of_an_operand_is_the_same() {
        let cases = [
            ("ldi XL, 0x10", "ldi r26, 16"),
            ("LDI R26, 020", "ldi r26, 16"),
            ("ldi 0x1a, 0b10000", "ldi r26, 16"),
            ("mov r24, __tmp_reg__", "mov r24, r0"),
            ("mov 24, __ZERO_REG__", "mov r24, r1"),
            ("movw r25:r24, r29:r28", "movw r24, r28"),
            ("movw zl, yl", "movw r30, r28"),
            ("in r0, 0x3F", "in r0, 63"),
            ("out 0x3d, YL", "out 61, r28"),
            ("sts 0x60, r1", "sts 96, r1"),
            ("ldd r24, y + 0x3", "ldd r24, Y+3"),
            ("ld r24, -x", "ld r24, -X"),
            ("st z+, R24", "st Z+, r24"),
            ("push yh", "push r29"),
        ];
        for (written, usual) in cases {
            let code = Code::parse(written);
            assert_eq!(code.to_string(), usual.replacen(' ', "\t", 1), "{written}");
            assert!(code.is(usual), "{written}");
        }
    }

    #[test]
    fn a_register_that_cannot_be_read_may_be_any() {
        let code = Code::parse("mov r24, counter");
        assert_eq!(effects(&code).writes, crate::effects::ALL);
        // Numbers and labels that stand where no register does are none.
        assert!(Code::parse("rjmp 24").is("rjmp 24"));
        assert!(Code::parse("ldi r24, lo8(XL)").is("ldi r24, lo8(XL)"));
    }
}
