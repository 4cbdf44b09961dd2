//! Which points a board has, and what to write for one that it lacks.
//!
//! Owns that for every language, so that all refuse the same points with the same words. Must not know what a text does
//! with a point; how one is written, `unoclp-point` knows.

use crate::Dialect;
use crate::diagnostics::{Code, Diagnostic, Found, Span, Word};
use std::collections::HashMap;
use std::collections::hash_map::Entry;
use unoclp_core::Board;
use unoclp_core::isa::{REGISTERS, SYSTEM_MARKERS};
use unoclp_point::{Address, Count, Kind, Maker, Spelling, Written, read};

impl Dialect {
    /// Whose way of writing points it has.
    pub fn maker(self) -> Maker {
        match self {
            Dialect::Iec | Dialect::S7200 => Maker::Iec,
            Dialect::Mitsubishi => Maker::Mitsubishi,
            Dialect::Omron => Maker::Omron,
            Dialect::Twido => Maker::Twido,
        }
    }

    /// Whether a name is an address here, such as `%IX1` or `T1.Q`, and not a name of somebody's own.
    pub fn is_address(self, name: &str) -> bool {
        read(&name.to_uppercase(), self.maker()).is_some()
    }
}

/// The first and the last point of a kind; none of a kind that is not counted, or not without gaps.
pub fn range(kind: Kind, board: Board) -> Option<(u16, u16)> {
    Some(match kind {
        Kind::Input => (1, board.inputs.into()),
        Kind::Output => (1, board.outputs.into()),
        Kind::Marker => (1, board.markers.into()),
        Kind::System => (1, SYSTEM_MARKERS.into()),
        Kind::Register => (1, REGISTERS.into()),
        Kind::Analogue => (0, u16::from(board.analogue).checked_sub(1)?),
        Kind::Group => (1, board.groups().into()),
        _ => return None,
    })
}

/// Whether a board has this point. Timers and counters are names, which the text's own order numbers.
pub fn exists(address: Address, board: Board) -> bool {
    match range(address.kind(), board) {
        Some((first, last)) => (first..=last).contains(&address.number().into()),
        None if address.kind() == Kind::Pwm => pwm(board).contains(&address.number().into()),
        None => true,
    }
}

/// The point that an address names, where a typed program can have a variable there; in capitals and without blanks.
pub fn variable(key: &str, maker: Maker, board: Board) -> Option<(Address, Written<'_>)> {
    let written = read(key, maker)?;
    let address = written.address.filter(|address| exists(*address, board))?;
    let is_variable = matches!(
        address,
        Address::Input(_)
            | Address::Output(_)
            | Address::Marker(_)
            | Address::System(_)
            | Address::Analogue(_)
            | Address::Pwm(_)
            | Address::Register(_)
    );
    is_variable.then_some((address, written))
}

/// The point that an address names as the standard writes it: `%IX0.4`.
///
/// # Errors
/// What to write, where a program can have no variable there.
pub fn point(written: &str, board: Board) -> Result<Address, Word> {
    let key: String = written.to_uppercase().split_whitespace().collect();
    let point = variable(&key, Maker::Iec, board).filter(|_| key.starts_with('%'));
    let help = || help(written, Maker::Iec, board);
    point.map(|(address, _)| address).ok_or_else(help)
}

/// What is told of a point that the board lacks, as Instruction List tells it; none of one that it has.
pub fn no_such_point(point: Address, board: Board) -> Option<Diagnostic> {
    let name = point.to_string();
    let help = || help(&name, Maker::Iec, board);
    let words = (!exists(point, board)).then(|| vec![name.as_str().into(), help()]);
    words.map(|words| Diagnostic::new(Code::NoSuchPoint, Span::default(), words))
}

/// The outputs that have PWM.
fn pwm(board: Board) -> Vec<u16> {
    board.pwm_outputs().map(u16::from).collect()
}

/// The least and the greatest of them, and how words lead from the one to the other: `1 and 4`, `1 to 99`.
fn pwm_ends(board: Board) -> Option<([&'static str; 2], [u16; 2])> {
    let all = pwm(board);
    let (&first, &last) = (all.first()?, all.last()?);
    let to = match all.len() {
        ..=2 => ["and", "e"],
        _ => ["to", "a"],
    };
    Some((to, [first, last]))
}

/// What the points of a kind are called.
fn plural(kind: Kind) -> (&'static str, &'static str) {
    match kind {
        Kind::Input => ("inputs", "as entradas"),
        Kind::Output => ("outputs", "as saídas"),
        Kind::Marker => ("markers", "as memórias"),
        Kind::System => ("system markers", "as memórias de sistema"),
        Kind::Register => ("registers", "os registradores"),
        Kind::Analogue => ("analogue inputs", "as entradas analógicas"),
        Kind::Group => ("bytes of markers", "os bytes de memórias"),
        _ => ("PWM outputs", "as saídas PWM"),
    }
}

/// What messages call a point: `input 05`.
pub fn named(kind: Kind, number: u16) -> Word {
    let (en, pt) = match kind {
        Kind::Input => ("input", "entrada"),
        Kind::Output => ("output", "saída"),
        Kind::Marker => ("marker", "memória"),
        Kind::Register => ("register", "registrador"),
        Kind::Analogue => ("analogue input A", "entrada analógica A"),
        Kind::System => ("system marker", "memória de sistema"),
        Kind::Inputs => return ("all inputs", "todas as entradas").into(),
        Kind::Outputs => return ("all outputs", "todas as saídas").into(),
        _ => return ("point", "ponto").into(),
    };
    Word::Both(format!("{en} {number:02}"), format!("{pt} {number:02}"))
}

/// How each point of a text is written where it is named first.
#[derive(Debug, Default)]
pub struct Spellings(HashMap<Address, (Spelling, Span)>);

impl Spellings {
    /// Notes how a point is written there. One that is written in two ways, such as `I2` and `%I0.1`, was meant to be
    /// two, which is reported by this code.
    pub fn note(
        &mut self,
        (address, written): (Address, &Written),
        (code, span): (Code, Span),
        text: &str,
        found: &mut Found,
    ) {
        let spelling = written.spelling();
        let (first, at) = match self.0.entry(address) {
            Entry::Vacant(none) => {
                none.insert((spelling, span));
                return;
            }
            Entry::Occupied(held) => held.get().clone(),
        };
        if first == spelling {
            return;
        }
        let (one, other) = match at.start <= span.start {
            true => (at, span),
            false => (span, at),
        };
        let written = |span: Span| -> Word {
            let text = text.get(span.range()).unwrap_or_default();
            text.split_whitespace().collect::<String>().into()
        };
        found.tell(
            code,
            other,
            [
                written(one),
                written(other),
                named(address.kind(), address.number().into()),
            ],
        );
    }
}

/// What to write instead of a name that is no point of the board: its kind's points in the way in which it is written.
pub fn help(name: &str, maker: Maker, board: Board) -> Word {
    let upper: String = name.to_uppercase().split_whitespace().collect();
    let read = read(&upper, maker);
    let more = read.as_ref().and_then(|written| elsewhere(written, board));
    let of = read.and_then(|written| {
        let all = all_like(&written, board)?;
        Some(match written.count {
            Count::Eights => of_byte(&written, all, board),
            _ => all,
        })
    });
    let (mut en, mut pt) = of.unwrap_or_else(|| every(maker, board));
    if let Some((more_en, more_pt)) = more {
        en.push_str(&more_en);
        pt.push_str(&more_pt);
    }
    Word::Both(en, pt)
}

/// Which board has this point, where this one lacks it.
fn elsewhere(written: &Written, board: Board) -> Option<Both> {
    let address = written.address.filter(|point| !exists(*point, board))?;
    let other = Board::ALL
        .into_iter()
        .find(|other| exists(address, *other))?;
    let name = other.name;
    Some((
        format!("; the {name} has this one"),
        format!("; a placa {name} tem este ponto"),
    ))
}

type Both = (String, String);

/// `inputs 01 to 08 are %IX0.0 to %IX0.7`, as this one is written; none where there is nothing to count.
fn all_like(written: &Written, board: Board) -> Option<Both> {
    let (en, pt) = plural(written.kind);
    if written.kind == Kind::Pwm {
        let ([and, e], ends) = pwm_ends(board)?;
        let [one, other] = ends.map(|number| written.like(number).unwrap_or_default());
        let english = format!("{en} are {one} {and} {other}");
        return Some((english, format!("{pt} são {one} {e} {other}")));
    }
    if written.count == Count::Flags {
        let all = ["SM0.0, SM0.1 and SM0.5", "SM0.0, SM0.1 e SM0.5"];
        let [en, pt] = all;
        return Some((format!("there are {en}"), format!("há {pt}")));
    }
    let (first, last) = range(written.kind, board)?;
    let (one, other) = (written.like(first)?, written.like(last)?);
    Some((
        format!("{en} {first:02} to {last:02} are {one} to {other}"),
        format!("{pt} {first:02} a {last:02} são {one} a {other}"),
    ))
}

/// The same where a byte has eight bits: which point that would be, and which was meant where bytes of four were.
fn of_byte(written: &Written, all: Both, board: Board) -> Both {
    let (en, pt) = all;
    let Some(number) = written.number else {
        return (
            format!("the bits of a byte are 0 to 7: {en}"),
            format!("os bits de um byte são 0 a 7: {pt}"),
        );
    };
    let is = named(written.kind, number);
    let Word::Both(is_en, is_pt) = is else {
        return (en, pt);
    };
    let en = format!("a byte has eight bits, so this is {is_en}: {en}");
    let pt = format!("um byte tem oito bits, e este ponto é a {is_pt}: {pt}");
    // The pins of a UNO are two groups of four, and so its points used to be counted.
    let four = written.byte_and_bit().filter(|(_, bit)| *bit < 4);
    let meant = four.and_then(|(group, bit)| {
        let number = group.checked_mul(4)?.checked_add(bit + 1)?;
        let meant = Address::new(written.kind, number.try_into().ok()?);
        (written.kind != Kind::Marker && exists(meant, board)).then_some(meant)
    });
    let meant = meant.and_then(|meant| {
        let number = meant.number().into();
        Some((named(meant.kind(), number), written.like(number)?))
    });
    match meant {
        Some((Word::Both(one, uma), like)) => (
            format!("{en}; for {one} write {like}"),
            format!("{pt}; para a {uma} escreva {like}"),
        ),
        _ => (en, pt),
    }
}

/// The points that a text may name, by their first and last.
fn every(maker: Maker, board: Board) -> Both {
    let letters: &[(&str, Kind)] = match maker {
        Maker::Simuplc => &[
            ("I0.0", Kind::Input),
            ("Q0.0", Kind::Output),
            ("M0.0", Kind::Marker),
            ("AIW0", Kind::Analogue),
        ],
        _ => &[
            ("%IX1", Kind::Input),
            ("%QX1", Kind::Output),
            ("%MX1", Kind::Marker),
            ("%MW1", Kind::Register),
            ("%IW0", Kind::Analogue),
            ("%QW1", Kind::Pwm),
        ],
    };
    let maker = match maker {
        Maker::Simuplc => maker,
        _ => Maker::Iec,
    };
    let mut parts: (Vec<String>, Vec<String>) = Default::default();
    for (name, kind) in letters {
        let Some(written) = read(name, maker) else {
            continue;
        };
        let (en, pt) = plural(*kind);
        let ends = match range(*kind, board) {
            Some((first, last)) => Some((["to", "a"], [first, last])),
            None => pwm_ends(board),
        };
        let Some(([en_to, pt_to], ends)) = ends else {
            continue;
        };
        let [one, other] = ends.map(|number| written.like(number).unwrap_or_default());
        let (are, sao) = match parts.0.is_empty() {
            true => ("are ", "são "),
            false => ("", ""),
        };
        parts.0.push(format!("{en} {are}{one} {en_to} {other}"));
        parts.1.push(format!("{pt} {sao}{one} {pt_to} {other}"));
    }
    if maker == Maker::Simuplc {
        parts.0.push("variables V0, V1, …".to_owned());
        parts.1.push("as variáveis V0, V1, …".to_owned());
    }
    (parts.0.join(", "), parts.1.join(", "))
}
