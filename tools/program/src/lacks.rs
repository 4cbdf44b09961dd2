//! What a board lacks for a program that was checked for another: told before it is sent there.
//!
//! Owns the list of it. Must not know how a program gets to a board.

use crate::{Lang, Source, words};
use std::collections::BTreeSet;
use unoclp_checked::numeric;
use unoclp_core::Board;
use unoclp_core::isa::{Kind, is_real};

/// What points of a kind are called.
type Name = fn(Lang) -> String;

/// What the board lacks for this program, in this language: `the UNO lacks inputs 09 and 12, …`; none where it holds it.
pub fn lacks(source: &Source, board: Board, lang: Lang) -> Option<String> {
    let faults = numeric(&source.code, board).err()?;
    let used = &source.size.used;
    let beyond = |numbers: &BTreeSet<u8>, last: u8| -> Vec<u8> {
        let beyond = numbers.iter().filter(|number| **number > last);
        beyond.copied().collect()
    };
    let pwm: Vec<u8> = board.pwm_outputs().collect();
    let no_pwm = used.pwm.iter().filter(|output| !pwm.contains(output));
    let analogue = used
        .analogue
        .iter()
        .filter(|input| **input >= board.analogue);
    let labels = source.program().steps();
    let labels = labels.filter(|step| step.opcode.row().kind == Kind::Label);
    let labels: BTreeSet<u8> = labels.filter_map(|step| step.number()).collect();
    let shared = used
        .analogue
        .iter()
        .filter_map(|analogue| board.shares(*analogue));
    let shared = shared.filter(|input| used.inputs.contains(input));
    let points: [(Name, Vec<u8>); 8] = [
        (words::lacks_inputs, beyond(&used.inputs, board.inputs)),
        (words::lacks_outputs, beyond(&used.outputs, board.outputs)),
        (words::lacks_pwm, no_pwm.copied().collect()),
        (words::lacks_analogue, analogue.copied().collect()),
        (words::lacks_pins, shared.collect()),
        (words::lacks_markers, beyond(&used.markers, board.markers)),
        (
            words::lacks_counters,
            beyond(&used.counters, board.counters),
        ),
        (words::lacks_labels, beyond(&labels, board.labels)),
    ];
    let mut parts: Vec<String> = Vec::new();
    for (what, numbers) in points
        .into_iter()
        .filter(|(_, numbers)| !numbers.is_empty())
    {
        let numbers: Vec<String> = numbers.iter().map(|n| format!("{n:02}")).collect();
        parts.push(format!("{} {}", what(lang), numbers.join(", ")));
    }
    if !board.real
        && source
            .program()
            .steps()
            .any(|step| is_real(step.opcode as u8))
    {
        parts.push(words::lacks_real(lang));
    }
    let [stored, run] = faults.iter().fold([0; 2], |[stored, run], fault| {
        [stored.max(fault.lacking[0]), run.max(fault.lacking[1])]
    });
    if stored > 0 {
        parts.push(words::lacks_stored(lang, stored));
    }
    if run > 0 {
        parts.push(words::lacks_run(lang, run));
    }
    if let (true, Some(fault)) = (parts.is_empty(), faults.first()) {
        parts.push(crate::diagnosis::cause(fault.fault.cause, lang).to_owned());
    }
    Some(words::lacks(lang, board.name, parts.join("; ")))
}

/// Why a program is not sent to a board, in this language: it was checked for what has no firmware. None where it is.
pub fn not_sent(source: &Source, lang: Lang) -> Option<String> {
    let own = source.board();
    if own.has_firmware() {
        return None;
    }
    let boards = Board::ALL.into_iter().filter(Board::has_firmware);
    let mut lacking = boards.map(|board| lacks(source, board, lang).ok_or(board));
    Some(match lacking.next()? {
        Ok(lacks) => words::not_sent(lang, own.name, lacks),
        Err(board) => words::not_sent(lang, own.name, words::fits(lang, board.name)),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Written;

    fn source(text: &str, board: Board) -> Source {
        let written = Written::new("P.TXT".to_owned(), text.into(), board);
        let Ok(source) = written.check(None) else {
            panic!("{text}");
        };
        source
    }

    #[test]
    fn each_point_that_a_board_lacks_is_told() {
        let text = "0\n827309\n827312\n877905\n787600\n827399\n877765\n";
        let source = source(text, Board::PC);
        let told = lacks(&source, Board::UNO, Lang::En).unwrap();
        assert_eq!(
            told,
            "the UNO lacks inputs 09, 12, 99; outputs 05; markers 65"
        );
        let told = lacks(&source, Board::UNO, Lang::Pt).unwrap();
        assert!(told.contains("as entradas 09, 12, 99"), "{told}");
        assert_eq!(lacks(&source, Board::PC, Lang::En), None);
        let told = not_sent(&source, Lang::En).unwrap();
        assert!(told.contains("the UNO lacks inputs 09"), "{told}");
    }

    #[test]
    fn bytes_that_a_board_lacks_are_told() {
        let text = "0\n".to_owned() + &"827301\n".repeat(1000) + "877901\n";
        let told = lacks(&source(&text, Board::PC), Board::UNO, Lang::En).unwrap();
        assert!(told.contains("101 bytes of program memory"), "{told}");
    }

    #[test]
    fn a_program_for_a_board_is_sent() {
        let text = "0\n827301\n877901\n";
        assert_eq!(not_sent(&source(text, Board::UNO), Lang::En), None);
        let told = not_sent(&source(text, Board::PC), Lang::En).unwrap();
        assert!(told.contains("UNO"), "{told}");
    }
}
