//! A document of a project as a board checks it, and where its steps are in the XML.

use crate::found::Found;
use std::collections::HashMap;
use std::fmt::Write;
use std::sync::Arc;
use unoclp_checked::{Checked, Diagnosis, SourceMap, numeric};
use unoclp_core::isa::Opcode;
use unoclp_core::{Board, Cause};
use unoclp_draw::edit::{Document, Id, visit};
use unoclp_lang::{Code, Lang, Lines, Span, lacking};
use unoclp_point::Address;

/// Where what is in a document came from.
pub(crate) struct Origins<'t> {
    /// The XML.
    pub text: &'t str,
    /// The place in it, and the program, of each rung, element and path.
    pub origins: HashMap<Id, (Span, usize)>,
    /// What the programs are called.
    pub units: Vec<Arc<str>>,
}

impl Origins<'_> {
    fn of(&self, id: Id) -> (Span, usize) {
        self.origins.get(&id).copied().unwrap_or_default()
    }

    /// The numeric code of a document, checked for this board; none, with a message, where something is wrong.
    pub(crate) fn check(
        &self,
        document: &Document,
        board: Board,
        found: &mut Found,
    ) -> Option<(String, (Checked, SourceMap))> {
        let instructions = match document.instructions() {
            Ok(instructions) => instructions,
            Err(mistakes) => {
                for mistake in mistakes {
                    let (at, unit) = mistake.at.map_or_else(Default::default, |id| self.of(id));
                    let name = self.units.get(unit).map_or("", |unit| unit);
                    found.tell_at(Code::XmlTangle, at, [format!("`{name}`").into()]);
                }
                return None;
            }
        };
        let mut file = String::from("0         / program start\n");
        let mut owners = vec![Id(0)];
        for (id, lines) in &instructions {
            for (at, line) in lines.iter().enumerate() {
                let letters = letters(lines[0]).filter(|_| at == 0);
                let row = match letters {
                    Some(letters) => format!("{line:<10}/ {letters}"),
                    None => line.to_string(),
                };
                let _ = writeln!(file, "{row}");
                owners.push(*id);
            }
        }
        match numeric(file.as_bytes(), board) {
            Ok((checked, map)) => {
                let map = self.placed(document, &instructions, &checked, map);
                Some((file, (checked, map)))
            }
            Err(faults) => {
                for fault in &faults {
                    let line = fault.fault.line.map_or(0, |line| line as usize);
                    let owner = owners.get(line.saturating_sub(1));
                    let at = owner.map_or_else(Default::default, |id| self.of(*id)).0;
                    refuse(fault, at, board, found);
                }
                None
            }
        }
    }

    /// The map of the code, as one of the XML.
    fn placed(
        &self,
        document: &Document,
        instructions: &[(Id, Vec<i32>)],
        checked: &Checked,
        mut map: SourceMap,
    ) -> SourceMap {
        let lines = Lines::new(self.text);
        let names = document.table().names();
        let mut rung_of: HashMap<Id, usize> = HashMap::new();
        for (index, rung) in document.rungs().enumerate() {
            rung_of.insert(rung.id, index);
            visit(&rung.series, &mut |node| {
                rung_of.insert(node.id(), index);
                rung_of.extend(node.paths().iter().map(|path| (path.id, index)));
            });
        }
        let mut comments = document.rungs().map(|rung| rung.comment.clone());
        let mut told = None;
        let steps = map.steps.iter_mut().zip(checked.program().steps());
        for ((place, step), (id, _)) in steps.zip(instructions) {
            let (at, unit) = self.of(*id);
            let (line, column) = lines.place(self.text, at.start);
            (place.line, place.column) = (line as usize, column as usize);
            place.last = place.line;
            place.unit = self
                .units
                .get(unit)
                .filter(|_| self.units.len() > 1)
                .cloned();
            place.name = Address::of(step).and_then(|point| names.get(&point).cloned());
            place.comments.clear();
            let rung = rung_of.get(id);
            if rung != told {
                place.comments = comments.next().unwrap_or_default();
                told = rung;
            }
        }
        map.title = document.title().to_vec();
        map
    }
}

/// What a code spells: `RI 01`.
fn letters(line: i32) -> Option<String> {
    let number = |opcode: Opcode| {
        let row = opcode.row();
        let most = if row.kind.has_number() { 99 } else { 0 };
        let number = line.abs() - row.code.abs();
        let fits = line.signum() == row.code.signum() && (0..=most).contains(&number);
        fits.then_some(number)
    };
    let (opcode, number) = Opcode::ALL
        .iter()
        .find_map(|opcode| Some((*opcode, number(*opcode)?)))?;
    let row = opcode.row();
    Some(match row.kind.has_number() {
        true => format!("{} {number:02}", row.letters),
        false => row.letters.to_owned(),
    })
}

/// Tells what the loader says of the program.
fn refuse(fault: &Diagnosis, at: Span, board: Board, found: &mut Found) {
    let cause = fault.fault.cause;
    match cause {
        Cause::ProgramFull | Cause::RunMemoryFull => {
            let both = [Lang::En, Lang::Pt].map(|lang| lacking(fault.lacking, lang));
            let [en, pt] = both;
            let words = [
                board.stored_bytes.to_string().into(),
                board.linked_bytes.to_string().into(),
                (en, pt).into(),
            ];
            // Once is enough: its place is where the program no longer fits.
            if !found.is_too_long() {
                found.tell_at(Code::DoesNotFit, at, words);
            }
        }
        cause => {
            let words = [cause.number().to_string().into(), cause.text().into()];
            found.tell_at(Code::Refused, at, words);
        }
    }
}
