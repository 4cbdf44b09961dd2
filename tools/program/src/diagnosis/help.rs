//! What to do about a fault, where more can be said than the fault's own text.

use crate::effect::effect;
use unoclp_core::isa::{Opcode, Row, TABLE, is_real};
use unoclp_core::{Board, Cause};
use unoclp_lang::Lang;

/// Help for a fault at this text of the file, if there is any.
pub(super) fn help(
    cause: Cause,
    text: &str,
    (lacking, board): ([usize; 2], Board),
    lang: Lang,
) -> Option<String> {
    Some(match (cause, lang) {
        (Cause::UnknownCode, _) => return unknown_code(text.parse().ok()?, lang),
        (Cause::NoSuchInput, _) => {
            let count = |board: &Board| board.inputs;
            has(("inputs", "as entradas"), board, &count, text, lang)
        }
        (Cause::NoSuchOutput, _) => {
            let count = |board: &Board| board.outputs;
            has(("outputs", "as saídas"), board, &count, text, lang)
        }
        (Cause::NoStart, Lang::En) => "write a line with 0 above this one".to_owned(),
        (Cause::NoStart, Lang::Pt) => "escreva uma linha com 0 acima desta".to_owned(),
        (Cause::StrayCharacter, _) if !text.starts_with(|c: char| c.is_ascii_digit()) => {
            return None;
        }
        (Cause::StrayCharacter, Lang::En) => {
            "each line holds one code; put this one on a line of its own".to_owned()
        }
        (Cause::StrayCharacter, Lang::Pt) => {
            "cada linha tem um só código; ponha este em uma linha própria".to_owned()
        }
        (Cause::ProgramFull | Cause::RunMemoryFull, _) => full(lacking, board, lang),
        (cause, lang) => return balance(cause, lang).map(str::to_owned),
    })
}

/// How many points of a kind the board has, and which board has the one that this code names.
fn has(
    (inputs, entradas): (&str, &str),
    board: Board,
    count: &dyn Fn(&Board) -> u8,
    code: &str,
    lang: Lang,
) -> String {
    let (name, last) = (board.name, count(&board));
    let digits = code.len().checked_sub(2).and_then(|at| code.get(at..));
    let number = digits.and_then(|digits| digits.parse::<u8>().ok());
    let number = number.filter(|number| *number > 0);
    let larger = number.and_then(|number| {
        let has = |board: &Board| count(board) >= number;
        Board::ALL.into_iter().find(has)
    });
    let mut told = match lang {
        Lang::En => format!("the {name} has {inputs} 01 to {last:02}"),
        Lang::Pt => format!("o {name} tem {entradas} 01 a {last:02}"),
    };
    if let Some(larger) = larger {
        let (name, last) = (larger.name, count(&larger));
        told.push_str(&match lang {
            Lang::En => format!("; the {name} has 01 to {last:02}"),
            Lang::Pt => format!("; a placa {name} tem 01 a {last:02}"),
        });
    }
    told
}

/// What sets pushed values and IFs right.
fn balance(cause: Cause, lang: Lang) -> Option<&'static str> {
    let (english, portuguese) = match cause {
        Cause::NothingPushed => (
            "write 808372 (PSH) after the left operand, or a register 01 to 98 in place of 99",
            "escreva 808372 (PSH) depois do operando esquerdo, ou um registrador de 01 a 98 no lugar de 99",
        ),
        Cause::PushedTooDeep => (
            "store a part of the result in a register",
            "guarde uma parte do resultado em um registrador",
        ),
        Cause::ValueLeftPushed => (
            "before this line, use the value in an operation with XX = 99",
            "antes desta linha, use o valor em uma operação com XX = 99",
        ),
        Cause::NotReal => (
            "1.0 is 1065353216; in Instruction List, write the number itself: REAL_ADD 1.0",
            "1.0 é 1065353216; em Lista de Instruções, escreva o próprio número: REAL_ADD 1.0",
        ),
        Cause::NoIf => (
            "write 7370 (IF) above; an IF has at most one 697683 (ELS)",
            "escreva 7370 (IF) acima; um IF tem no máximo um 697683 (ELS)",
        ),
        Cause::IfTooDeep => (
            "join conditions in one rung before one IF, or close an IF with 697868 (END)",
            "junte as condições em um degrau antes de um só IF, ou feche um IF com 697868 (END)",
        ),
        Cause::IfLeftOpen => (
            "write 697868 (END) where this IF ends",
            "escreva 697868 (END) onde este IF termina",
        ),
        _ => return None,
    };
    Some(match lang {
        Lang::En => english,
        Lang::Pt => portuguese,
    })
}

/// What a program takes too much.
fn full(lacking: [usize; 2], board: Board, lang: Lang) -> String {
    let (name, stored, linked) = (board.name, board.stored_bytes, board.linked_bytes);
    let lacking = unoclp_lang::lacking(lacking, lang);
    match lang {
        Lang::En => format!(
            "the {name} holds {stored} bytes of program and has {linked} bytes to run it{lacking}. Timers, markers and \
             numbers take more run memory than program memory; kept values need room for two records"
        ),
        Lang::Pt => format!(
            "o {name} guarda {stored} bytes de programa e tem {linked} bytes para executá-lo{lacking}. Temporizadores, \
             memórias e números ocupam mais memória de execução que de programa; valores mantidos precisam de espaço para duas cópias"
        ),
    }
}

/// What a code is that a board without REAL numbers refuses; none of another code.
pub fn no_real(code: i32, lang: Lang) -> Option<String> {
    let is_it = |opcode: &&Opcode| {
        let row = opcode.row();
        is_real(row.stored) && pattern(row, code) == row.code
    };
    let opcode = Opcode::ALL.iter().find(is_it)?;
    let letters = opcode.row().letters;
    Some(match lang {
        Lang::En => format!(
            "{code} is {letters}, for REAL numbers, which the firmware of a Nano lacks; use whole numbers, or a UNO"
        ),
        Lang::Pt => format!(
            "{code} é {letters}, para números REAL, que o firmware de um Nano não tem; use números inteiros ou um UNO"
        ),
    })
}

/// The instruction that was probably meant.
fn unknown_code(code: i32, lang: Lang) -> Option<String> {
    if let Some(told) = no_real(code, lang) {
        return Some(told);
    }
    let forgotten_point = |row: &&Row| row.kind.has_number() && row.code / 100 == code;
    if let Some(row) = TABLE.iter().find(forgotten_point) {
        let (example, letters) = (example(row), row.letters);
        return Some(match lang {
            Lang::En => {
                format!("two digits for the point are missing: {example} is {letters} 01")
            }
            Lang::Pt => format!("faltam os dois dígitos do ponto: {example} é {letters} 01"),
        });
    }
    let negated = |row: &&Row| pattern(row, code.wrapping_neg()) == row.code;
    if code < 0 && TABLE.iter().any(|row| negated(&row)) {
        return Some(match lang {
            Lang::En => "this code has no negated form; leave out the -".to_owned(),
            Lang::Pt => "este código não tem forma negada; tire o -".to_owned(),
        });
    }
    let opcode = Opcode::ALL.iter().find(|opcode| {
        let row = opcode.row();
        one_slip(&pattern(row, code).to_string(), &row.code.to_string())
    })?;
    let row = opcode.row();
    let what = effect(*opcode, lang).split(':').next().unwrap_or_default();
    let (example, letters) = (example(row), row.letters);
    Some(match lang {
        Lang::En => format!("did you mean {example}, {letters} ({what})?"),
        Lang::Pt => format!("você quis dizer {example}, {letters} ({what})?"),
    })
}

/// A code as it would stand in the table if it were of the kind of this row: where the row takes
/// a point, with XX = 00.
fn pattern(row: &Row, code: i32) -> i32 {
    if row.kind.has_number() {
        code / 100 * 100
    } else {
        code
    }
}

/// A code of this row, with point 01 where it takes one.
fn example(row: &Row) -> i32 {
    if row.kind.has_number() {
        row.code + row.code.signum()
    } else {
        row.code
    }
}

/// Whether one slip of the hand leads from one text to the other: a digit wrong, missing or too
/// many, or two neighbours exchanged.
fn one_slip(a: &str, b: &str) -> bool {
    let (a, b) = (a.as_bytes(), b.as_bytes());
    let start = a.iter().zip(b).take_while(|(a, b)| a == b).count();
    let (a, b) = (&a[start..], &b[start..]);
    let end = a.iter().rev().zip(b.iter().rev());
    let end = end.take_while(|(a, b)| a == b).count();
    let (a, b) = (&a[..a.len() - end], &b[..b.len() - end]);
    match (a, b) {
        ([w, x], [y, z]) => (w, x) == (z, y),
        _ => a.len().max(b.len()) == 1,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn help_names_the_code_that_was_meant() {
        let cases = [
            (
                "8273",
                "two digits for the point are missing: 827301 is RI 01",
            ),
            ("-877901", "this code has no negated form"),
            ("-787600", "this code has no negated form"),
            (
                "827401",
                "did you mean 827301, RI (contact, normally open)?",
            ),
            (
                "872301",
                "did you mean 827301, RI (contact, normally open)?",
            ),
            ("82733", "did you mean 827301, RI (contact, normally open)?"),
            ("787601", "did you mean 787600, NL (new rung)?"),
            ("84797", "did you mean 847978, TON (on-delay timer)?"),
            ("42", "did you mean 40, ( (open an OR branch)?"),
        ];
        for (code, expected) in cases {
            let help = help(Cause::UnknownCode, code, ([0; 2], Board::UNO), Lang::En);
            let starts = help
                .as_deref()
                .is_some_and(|help| help.starts_with(expected));
            assert!(starts, "{code}: {help:?}");
        }
        let unknown = |code, lang| help(Cause::UnknownCode, code, ([0; 2], Board::UNO), lang);
        let says = "você quis dizer 827301, RI (contato normalmente aberto)?";
        assert_eq!(unknown("827401", Lang::Pt).as_deref(), Some(says));
        assert_eq!(unknown("123456", Lang::En), None);
        assert_eq!(unknown("-2147483648", Lang::En), None);
    }
}
