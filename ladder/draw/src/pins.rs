//! The pins of a timer's or a counter's box, and what stands beside them.

use crate::words::{NO_PRESET, amount};
use std::fmt::Write;
use unicode_width::UnicodeWidthStr;
use unoclp_core::Instruction;
use unoclp_core::isa::{Opcode, Operand};

/// A box with pins: the first on each side is on the wire.
#[derive(Clone, Debug)]
pub(crate) struct Pins {
    /// What it is: `TON`.
    pub(crate) title: &'static str,
    /// The names on the left.
    pub(crate) inputs: [&'static str; 2],
    /// The names on the right.
    pub(crate) outputs: [&'static str; 2],
    /// Its preset, beside the second input.
    pub(crate) preset: String,
}

impl Pins {
    /// Those of an instruction that has some.
    pub(crate) fn of(instruction: Instruction<'_>) -> Option<Pins> {
        let title = instruction.opcode.row().letters;
        match instruction.operand {
            Operand::Timer(block) => Some(Pins {
                title,
                inputs: ["IN", "PT"],
                outputs: ["Q", "ET"],
                preset: match block.preset.cast_signed() {
                    NO_PRESET => amount(NO_PRESET),
                    _ => time(block.preset),
                },
            }),
            Operand::Count { preset, .. } => Some(Pins {
                title,
                inputs: match instruction.opcode {
                    Opcode::CountDown => ["CD", "PV"],
                    _ => ["CU", "PV"],
                },
                outputs: ["Q", "CV"],
                preset: amount(preset),
            }),
            _ => None,
        }
    }

    /// The columns of the box.
    pub(crate) const BOX: usize = 8;

    /// The box in characters: its place on the wire.
    pub(crate) fn text() -> String {
        format!("[{}]", " ".repeat(Pins::BOX - 2))
    }

    /// The columns before the box: those of the preset but for the wire that leads there.
    pub(crate) fn before(&self) -> usize {
        self.preset.width()
    }

    /// The columns after the box, for what it has come to: of a time also its milliseconds.
    pub(crate) fn behind(&self) -> usize {
        self.preset.width() + if self.outputs[1] == "ET" { 3 } else { 1 }
    }
}

/// A time as a literal: `T#2.5s`, `T#1m30s`.
pub fn time(ms: u32) -> String {
    let mut text = String::from("T#");
    if ms < 1000 {
        let _ = write!(text, "{ms}ms");
        return text;
    }
    let mut rest = ms;
    for (unit, size) in [("d", 86_400_000), ("h", 3_600_000), ("m", 60_000)] {
        if rest >= size {
            let _ = write!(text, "{}{unit}", rest / size);
            rest %= size;
        }
    }
    match (rest / 1000, rest % 1000) {
        (0, 0) => {}
        (seconds, 0) => _ = write!(text, "{seconds}s"),
        (seconds, ms) => {
            let part = format!("{ms:03}");
            let _ = write!(text, "{seconds}.{}s", part.trim_end_matches('0'));
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::time;

    #[test]
    fn a_time_is_as_short_as_it_can_be() {
        for (ms, text) in [
            (0, "T#0ms"),
            (250, "T#250ms"),
            (1000, "T#1s"),
            (2500, "T#2.5s"),
            (61_005, "T#1m1.005s"),
            (90_000, "T#1m30s"),
            (3_600_000, "T#1h"),
            (86_400_500, "T#1d0.5s"),
        ] {
            assert_eq!(time(ms), text);
        }
    }
}
