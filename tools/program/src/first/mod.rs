//! The language that a text's first words tell: how it begins, and its first statement after the declarations.
//!
//! Owns the signs by which the languages differ. Must not know what a statement means, nor whether it is right: a text
//! with mistakes is taken for what it was meant to be, and a text that is no program for none.
//!
//! - `words`: a text as words and signs, without its comments
//! - `instructions`: lines of Instruction List

mod instructions;
mod words;

use crate::written_in::WrittenIn;
use instructions::{is_instruction, is_instructions};
use unoclp_lang::TextLanguage;
use words::{Words, without_comments};

pub(crate) const ST: WrittenIn = WrittenIn::Typed(TextLanguage::St);
const SCL: WrittenIn = WrittenIn::Typed(TextLanguage::Scl);
const ISCL: WrittenIn = WrittenIn::Typed(TextLanguage::Iscl);
const LCE: WrittenIn = WrittenIn::Typed(TextLanguage::Lce);

/// The language that this text is in; none if it is in none.
pub(crate) fn first_words(text: &str) -> Option<WrittenIn> {
    let mut all = TextLanguage::all().into_iter();
    if let Some(language) = all.find(|language| language.begins(text)) {
        return Some(WrittenIn::Typed(language));
    }
    let code = without_comments(text);
    let words = Words::new(&code);
    let structured = || match has_local_names(&code) {
        true => SCL,
        false => ST,
    };
    small(&words)
        .or_else(|| match statement(&words) {
            Sign::Structured => Some(structured()),
            Sign::Lce => Some(LCE),
            Sign::Instruction => Some(WrittenIn::Il),
            Sign::None(Begins::Unit) => Some(structured()),
            Sign::None(Begins::Anyhow) => None,
        })
        .or_else(|| is_instructions(&code).then_some(WrittenIn::Il))
}

/// Lines of a text that are looked at where its name tells its language in most cases.
const MOST_LINES: usize = 1_000;

/// Whether this is Instruction List without doubt: what comes first in it is an instruction, and so is another line.
pub(crate) fn is_list(text: &str) -> bool {
    let ends = text.match_indices('\n').nth(MOST_LINES);
    let text = ends.map_or(text, |(at, _)| &text[..at]);
    let instructions = text.lines().filter(|line| is_instruction(line));
    instructions.take(2).count() == 2 && first_words(text) == Some(WrittenIn::Il)
}

/// InterSCL and LCE by how they begin.
fn small(words: &Words<'_>) -> Option<WrittenIn> {
    let [first, second, third] = [0, 1, 2].map(|at| words.upper(at));
    let is_name = |at: usize| words.is_word(at);
    match first.as_str() {
        "BLOCO" | "BLOCK" => {
            let begins = matches!(
                second.as_str(),
                "" | ";" | "INT" | "REAL" | "BOOL" | "IF" | "WHILE" | "FOR" | "PRINT" | "END_BLOCK"
            );
            (begins || words.has(":=") || words.has("END_BLOCK")).then_some(ISCL)
        }
        "INT" | "REAL" | "BOOL" if is_name(1) => {
            matches!(third.as_str(), ";" | "AT" | ":=" | ",").then_some(ISCL)
        }
        "CLP" | "PLC" => {
            let begins = matches!(
                third.as_str(),
                "" | "VAR" | "REDE" | "NETWORK" | "FIM" | "END"
            );
            let is_code = words.has(":=") || words.has("{") || words.has(";");
            (begins || is_code || words.has("FIM")).then_some(LCE)
        }
        "VAR" if is_name(1) && (third == "=" || third == "." && words.at(4) == "=") => Some(LCE),
        "REDE" if words.has(";") => Some(LCE),
        _ => None,
    }
}

/// What the first statement after all declarations is.
enum Sign {
    /// One of Structured Text.
    Structured,
    /// One of LCE.
    Lce,
    /// An instruction of Instruction List.
    Instruction,
    /// There is none, or it may be of more languages than one; how the text begins.
    None(Begins),
}

/// How a text begins.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Begins {
    /// With what begins a unit of IEC 61131-3, or with declarations.
    Unit,
    Anyhow,
}

fn statement(words: &Words<'_>) -> Sign {
    let (mut at, mut begins) = (0, Begins::Anyhow);
    while at < words.len() {
        let first = words.upper(at);
        let behind = match first.as_str() {
            "PROGRAM" | "FUNCTION_BLOCK" | "FUNCTION" | "ORGANIZATION_BLOCK" => {
                words.behind_head(at)
            }
            "TYPE" => words.behind("END_TYPE", at),
            "CONFIGURATION" => words.behind("END_CONFIGURATION", at),
            "BEGIN" => at + 1,
            // A pragma.
            "{" => words.behind("}", at),
            word if word.starts_with("END_") && begins == Begins::Unit => at + 1,
            word if word == "VAR" || word.starts_with("VAR_") => words.behind("END_VAR", at),
            // What stands before a line, and names it or counts it: `0 LD I1`, `again: LD I1`.
            word if words.begins_line(at) && word.bytes().all(|byte| byte.is_ascii_digit()) => {
                at + 1
            }
            _ if words.is_word(at) && words.at(at + 1) == ":" => at + 2,
            // A call, of either: `;` after it tells, or else what follows.
            _ if words.is_word(at) && words.at(at + 1) == "(" && begins == Begins::Unit => {
                match words.behind_call(at) {
                    Some(behind) if words.at(behind) == ";" => return Sign::Structured,
                    Some(behind) => behind,
                    None => return one(words, at, begins),
                }
            }
            _ => return one(words, at, begins),
        };
        if begins == Begins::Anyhow && words.is_unit(at) {
            begins = Begins::Unit;
        }
        at = behind;
    }
    Sign::None(begins)
}

/// The sign that the statement which begins with this word is.
fn one(words: &Words<'_>, at: usize, begins: Begins) -> Sign {
    let first = words.upper(at);
    let undeclared = begins == Begins::Anyhow;
    let is_code = words.has(":=") || words.ends;
    if undeclared && is_lce(words, at) {
        return Sign::Lce;
    }
    let structured = match first.as_str() {
        // An IF of Instruction List stands alone.
        "IF" | "FOR" | "WHILE" | "CASE" | "REPEAT" => {
            is_code && (!words.begins_line(at + 1) || first == "REPEAT")
        }
        "RETURN" | "EXIT" | "CONTINUE" => words.at(at + 1) == ";",
        ";" => words.has(":="),
        "#" | "\"" => words.is_word(at + 1) && words.touches(at + 1) && is_code,
        _ if !words.is_word(at) => false,
        _ => match words.at(at + 1) {
            ":=" => true,
            // As who means `:=` writes it.
            "=" => words.at(at + 3) == ";" || words.has(";") && !undeclared,
            "." | "[" => words.touches(at + 1) && words.is_stored(at),
            "(" => words.behind_call(at).is_some_and(|at| words.at(at) == ";"),
            _ => false,
        },
    };
    if structured {
        return Sign::Structured;
    }
    match words.is_word(at) && is_instruction(words.line(at)) {
        _ if !undeclared && words.line(at).trim_end().ends_with(';') => Sign::Structured,
        // A sentence may begin like an instruction: without declarations the other lines say more.
        true if !undeclared => Sign::Instruction,
        _ => Sign::None(begins),
    }
}

/// `V0 R:= 1.5`, `V0 := 1`, `Q0.0 := I0.0`, `liga x`, `se (x) {`: as LCE alone writes it.
fn is_lce(words: &Words<'_>, at: usize) -> bool {
    let [first, second, third] = [0, 1, 2].map(|more| words.upper(at + more));
    let numbered = |letters: &[char]| {
        let number = first.strip_prefix(letters).unwrap_or_default();
        number.starts_with(|c: char| c.is_ascii_digit())
    };
    let (braces, ends) = (words.has("{"), words.has(";"));
    match first.as_str() {
        "SE" | "SENAO" | "ENQUANTO" | "ELSE" | "WHILE" if braces => true,
        "SE" => second == "(" && ends,
        "IF" => second == "(" && braces && !words.has("THEN"),
        "ACIONA" | "LIGA" | "DESLIGA" | "OPERATE" | "TURN_ON" | "TURN_OFF" => {
            ends && !matches!(second.as_str(), ":=" | "=" | "." | "[" | "(")
        }
        _ if first.starts_with("AIW") || numbered(&['V']) => words.has(":=") || words.has("="),
        _ if numbered(&['I', 'Q', 'M']) && second == "." => words.upper(at + 3) == ":=",
        _ => matches!(second.as_str(), "R" | "D" | "W" | "B") && third == ":=",
    }
}

/// Whether names begin with `#`, as SCL writes those of a block.
fn has_local_names(text: &str) -> bool {
    let bytes = text.as_bytes();
    let is_letter = |at: usize| bytes.get(at).is_some_and(u8::is_ascii_alphabetic);
    let is_word = |at: Option<usize>| {
        at.and_then(|at| bytes.get(at))
            .is_some_and(|byte| byte.is_ascii_alphanumeric() || *byte == b'_')
    };
    text.match_indices('#')
        .any(|(at, _)| is_letter(at + 1) && !is_word(at.checked_sub(1)))
        || text
            .trim_start()
            .to_uppercase()
            .starts_with("ORGANIZATION_BLOCK")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn first_words_tell_the_language() {
        for (text, language) in [
            ("(* x *) bloco INT x; END_BLOCK", "iscl"),
            ("BLOCO\n", "iscl"),
            ("INT x; x := 1;", "iscl"),
            ("plc gate end", "lce"),
            ("V0 R:= 100000.125;\nV1 := V0;", "lce"),
            ("// first\nclp teste\nfim", "lce"),
            ("clp x se (I0.0) { liga Q0.0; } fim", "lce"),
            ("V0 := 5;", "lce"),
            ("Q0.0 := I0.0;", "lce"),
            ("se (I0.0) { liga Q0.0; }", "lce"),
            ("var\nV0 = nivel;", "lce"),
            ("liga Q0.0;", "lce"),
            ("VAR R : INT; END_VAR R:= 1;", "st"),
            ("VAR V0 : INT; END_VAR V0 := 1;", "st"),
            ("PROGRAM main\nEND_PROGRAM", "st"),
            ("PROGRAM\nVAR x : INT; END_VAR\nx := 1;", "st"),
            ("VAR x : INT; END_VAR x := 1;", "st"),
            ("VAR t : TON; END_VAR\nt(IN := TRUE,\n PT := T#1s);", "st"),
            (
                "TYPE c : (a, b); END_TYPE\nVAR x : c; END_VAR\nIF TRUE THEN x := a; END_IF",
                "st",
            ),
            (
                "FUNCTION f : INT\nVAR_INPUT x : INT; END_VAR\nf := x;\nEND_FUNCTION",
                "st",
            ),
            (
                "CONFIGURATION c END_CONFIGURATION\nPROGRAM p VAR S : BOOL; END_VAR S := TRUE; END_PROGRAM",
                "st",
            ),
            ("x := INT#5;", "st"),
            ("x = 5;\ny = 6;", "st"),
            ("a[1].x := 5;", "st"),
            ("IF x > 1 THEN y := 2; END_IF;", "st"),
            ("FOR i := 1 TO 5 DO s := s + i; END_FOR", "st"),
            ("#x := 1;", "scl"),
            (
                "FUNCTION_BLOCK \"Motor\"\nVAR_INPUT run : Bool; END_VAR\nBEGIN\n#q := #run;\nEND_FUNCTION_BLOCK",
                "scl",
            ),
            (
                "ORGANIZATION_BLOCK Main\nBEGIN\nEND_ORGANIZATION_BLOCK",
                "scl",
            ),
            ("LD I1\nST Q1", "il"),
            ("// lamp\n0 LD I1\n1 ST Q1\n", "il"),
            ("(* lamp *)\nagain: LD I1\nJMP again\n", "il"),
            (
                "PROGRAM p\nVAR x AT %IX1 : BOOL; END_VAR\nLD x\nST %QX1\nEND_PROGRAM",
                "il",
            ),
            (
                "FUNCTION_BLOCK b\nVAR_INPUT x : BOOL; END_VAR\nVAR t : TON; END_VAR\nCAL t (IN := x, PT := T#5s)\nEND_FUNCTION_BLOCK",
                "il",
            ),
            (
                "VAR t : TON; END_VAR\nt (IN := I1,\n PT := T#5s)\nLD t.Q\nST Q1",
                "il",
            ),
            ("NETWORK 1\nA I 0.0\nAN I 0.1\n= Q 0.0\n", "il"),
            ("LDI X0\nOUT T0 K50\nMPS\nAND X1\nOUT Y0\nMPP\nEND", "il"),
            ("LD I1\nAND( I2\nOR I3\n)\nST Q1", "il"),
            ("LOAD I1\nSTO Q1", "il"),
        ] {
            assert_eq!(
                first_words(text).map(WrittenIn::name),
                Some(language),
                "{text}"
            );
        }
    }

    #[test]
    fn sentences_are_no_program() {
        for text in [
            "A lamp is lit.\nAnd then it goes off.",
            "Program the board with the tool.\nIt takes a minute; no more.",
            "For the board it is all one: a loop ends.",
            "If you like it, then say so.",
            "Block diagram of the board",
            "CLP de baixo custo",
            "[a link](there.md)",
            "Var is a river.",
            "Type this: it helps.",
            "about = \"\"\nprogram = \"a.txt\"",
            "use std::fs;\n\nfn main() {}\n",
            "{\"json\": [1, 2, 3]}",
            "<svg xmlns=\"x\"></svg>",
            "= - * / ( ) [ ] :",
        ] {
            assert_eq!(first_words(text), None, "{text}");
        }
    }
}
