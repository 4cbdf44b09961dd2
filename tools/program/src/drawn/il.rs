//! A document as Instruction List, with its names declared.

use super::parts::named;
use std::collections::BTreeMap;
use std::fmt::Write;
use unoclp_core::Board;
use unoclp_core::isa::{Class, Opcode};
use unoclp_draw::edit::{Emitted, Row};
use unoclp_lang::{Dialect, Options, TextLanguage, compile, instructions_to_il, spelled};
use unoclp_point::Address;

/// The rungs under what they are about, with the names of points, as far as that can be told without compiling it.
pub(super) fn text(emitted: &Emitted<'_>) -> String {
    written(emitted, &spelled(emitted.steps()), &names(emitted))
}

/// The same, compiled until it comes to the codes of the document: with the names that Instruction List takes.
pub(super) fn compiled(emitted: &Emitted<'_>, board: Board) -> String {
    let plain = instructions_to_il(emitted.steps(), board);
    let wanted = codes(&plain, board);
    let all: Vec<Name<'_>> = names(emitted);
    let points: Vec<Name<'_>> = all.iter().filter(|name| name.is_bit()).copied().collect();
    // A name that means something else in the language stays out, and with it those that are likewise.
    for names in [&all[..], &points, &[]] {
        let text = written(emitted, &plain, names);
        if wanted.is_some() && codes(&text, board) == wanted {
            return text;
        }
    }
    plain
}

/// Whether this can be declared as the name of a point.
pub fn is_name(name: &str) -> bool {
    let begins = name
        .chars()
        .next()
        .is_some_and(|first| first.is_alphabetic() || first == '_');
    let goes_on = name.chars().all(|ch| ch.is_alphanumeric() || ch == '_');
    let text = format!("VAR {name} AT I1 : BOOL; END_VAR\nLD {name}\nST Q1\n");
    // What a name means is the same on each board.
    let [board, ..] = Board::ALL;
    let is_point = Address::parse(name).is_some();
    begins
        && goes_on
        && !is_point
        && codes(&text, board).is_some_and(|own| Some(own) == codes("LD I1\nST Q1\n", board))
}

/// The name that words can be: `stop_2` of `stop 2`, `botao` of `botão (NA)`; none where nothing is left of them.
pub fn name_of(words: &str) -> Option<String> {
    let words = words.split('(').next().unwrap_or_default().trim();
    let plain = |letter: char| match letter {
        'á' | 'à' | 'â' | 'ã' => 'a',
        'é' | 'ê' => 'e',
        'í' => 'i',
        'ó' | 'ô' | 'õ' => 'o',
        'ú' => 'u',
        'ç' => 'c',
        letter if letter.is_ascii_alphanumeric() => letter,
        _ => '_',
    };
    let letters: String = words.to_lowercase().chars().map(plain).collect();
    let parts: Vec<&str> = letters.split('_').filter(|part| !part.is_empty()).collect();
    let name = parts.join("_");
    let behind = format!("{name}_");
    [name, behind].into_iter().find(|name| is_name(name))
}

/// A text without an instruction: what it is about, and the names of points.
pub fn blank_text<'r>(title: &str, rows: impl Iterator<Item = (Address, &'r Row)>) -> String {
    let mut text = String::new();
    comment(&mut text, title);
    let kind = |point| match point {
        Address::Register(_) | Address::Analogue(_) => "INT",
        _ => "BOOL",
    };
    let names = rows.map(|(point, row)| Name {
        point,
        row,
        kind: kind(point),
    });
    declare(&mut text, &names.collect::<Vec<_>>());
    text
}

/// What a text compiles to; none where it has errors.
fn codes(text: &str, board: Board) -> Option<Vec<i32>> {
    let options = Options {
        dialect: Some(Dialect::Iec),
        board,
    };
    let compiled = compile(text, TextLanguage::Il, &options);
    (!compiled.has_errors()).then(|| compiled.codes())
}

/// A name, and what it stands for in the text.
#[derive(Clone, Copy)]
struct Name<'d> {
    point: Address,
    row: &'d Row,
    /// What it is declared as.
    kind: &'static str,
}

impl Name<'_> {
    fn is_bit(&self) -> bool {
        self.kind == "BOOL"
    }

    /// How Instruction List spells its point.
    fn spelled(&self) -> String {
        match self.point {
            Address::Analogue(number) => format!("IW{number}"),
            point => point.to_string(),
        }
    }
}

/// The names of the points that the program uses, and of all inputs, outputs and markers.
fn names<'e>(emitted: &'e Emitted<'_>) -> Vec<Name<'e>> {
    let mut kinds: BTreeMap<Address, &'static str> = BTreeMap::new();
    let mut timers = 0;
    for step in emitted.steps() {
        match (step.opcode.class(), step.opcode, Address::of(step)) {
            (Class::Timer, opcode, _) if step.is_own_timer() => {
                timers += 1;
                kinds.insert(Address::Timer(timers), timer(opcode));
            }
            (Class::Count, Opcode::CountDown, Some(point)) => {
                kinds.entry(point).or_insert("CTD");
            }
            (Class::Count, _, Some(point)) => {
                kinds.insert(point, "CTU");
            }
            (_, _, Some(point @ (Address::Register(_) | Address::Analogue(_)))) => {
                kinds.insert(point, "INT");
            }
            _ => {}
        }
    }
    let kind = |point| match point {
        Address::Input(_) | Address::Output(_) | Address::Marker(_) | Address::System(_) => {
            Some("BOOL")
        }
        Address::Label(_) => None,
        other => kinds.get(&other).copied(),
    };
    named(emitted.document())
        .filter_map(|(point, row)| {
            let kind = kind(point)?;
            Some(Name { point, row, kind })
        })
        .collect()
}

fn timer(opcode: Opcode) -> &'static str {
    match opcode {
        Opcode::OffDelay => "TOF",
        Opcode::Pulse => "TP",
        Opcode::RetentiveOnDelay => "TONR",
        _ => "TON",
    }
}

fn written(emitted: &Emitted<'_>, plain: &str, names: &[Name<'_>]) -> String {
    let document = emitted.document();
    let mut text = String::new();
    for line in document.title() {
        comment(&mut text, line);
    }
    if !names.is_empty() || !document.title().is_empty() {
        declare(&mut text, names);
        text.push('\n');
    }
    let called: BTreeMap<String, &str> = names
        .iter()
        .map(|name| (name.spelled(), name.row.name.as_str()))
        .collect();
    let mut rungs = emitted.rungs();
    for (index, lines) in plain.split("\n\n").enumerate() {
        if index > 0 {
            text.push('\n');
        }
        for line in rungs.next().iter().flat_map(|(rung, _)| &rung.comment) {
            comment(&mut text, line);
        }
        for line in lines.lines() {
            text += &with_names(line, &called);
            text.push('\n');
        }
    }
    text
}

/// The declarations of these names.
fn declare(text: &mut String, names: &[Name<'_>]) {
    *text += "VAR\n";
    for name in names {
        let Row {
            name: called,
            comment,
        } = name.row;
        let _ = write!(text, "    {called} AT {} : {};", name.spelled(), name.kind);
        match comment.is_empty() {
            true => text.push('\n'),
            false => {
                text.push(' ');
                self::comment(text, comment);
            }
        }
    }
    *text += "END_VAR\n";
}

fn comment(text: &mut String, line: &str) {
    let line = line.replace("*)", "* )").replace("(*", "( *");
    let _ = writeln!(text, "(* {line} *)");
}

/// A line with names in place of points; one of codes as they are stays.
fn with_names(line: &str, called: &BTreeMap<String, &str>) -> String {
    if line.starts_with("CODE") {
        return line.to_owned();
    }
    let is_word = |ch: char| ch.is_ascii_alphanumeric() || ch == '_';
    let mut text = String::new();
    let mut rest = line;
    while let Some(start) = rest.find(is_word) {
        let end = rest[start..]
            .find(|ch| !is_word(ch))
            .map_or(rest.len(), |end| start + end);
        let word = &rest[start..end];
        text += &rest[..start];
        text += called.get(word).copied().unwrap_or(word);
        rest = &rest[end..];
    }
    text + rest
}
