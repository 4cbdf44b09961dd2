//! VAR RETAIN: what a variable keeps over a power cut (NC-12, NC-21), or why it cannot.

use super::{Initial, Names, Place};
use crate::ast::Var;
use crate::diagnostics::{Code, Found, Span};
use crate::tree::{Bit, Num};
use unoclp_core::Number;
use unoclp_core::isa::RETENTIVE;

/// The first of the groups of eight markers that are retentive.
const GROUP: u8 = (RETENTIVE - 1) / 8 + 1;

/// What a text keeps.
#[derive(Debug, Default)]
pub(crate) struct Retained {
    /// Registers and counters, each once.
    pub numbers: Vec<Number>,
    /// Variables that begin with another value than 0 where nothing has been kept.
    pub initials: Vec<Initial>,
    /// The register that is not 0 where something has been kept, and where it is first needed.
    pub begun: Option<(u8, Span)>,
}

impl Names {
    /// Keeps a variable. Its first values are those behind the first `before`.
    pub(super) fn retain(&mut self, place: Place, var: &Var, before: usize, found: &mut Found) {
        let initials = self.initials.split_off(before);
        match self.retained_as(place) {
            Ok(number) => self.keep(number),
            Err(why) => {
                let name = var.name.text.clone();
                found.tell(Code::NotRetained, var.name.span, [name.into(), why.into()]);
            }
        }
        if let (Some(first), None) = (initials.first(), self.retained.begun) {
            let register = self.temps.named_register();
            self.keep(Some(Number::Register(register)));
            self.retained.begun = Some((register, first.span));
        }
        self.retained.initials.extend(initials);
    }

    /// The number that keeps a place; none where it is kept by itself.
    fn retained_as(&self, place: Place) -> Result<Option<Number>, (&'static str, &'static str)> {
        match place {
            Place::Bit(Bit::Marker(marker)) if marker >= RETENTIVE => Ok(None),
            Place::Number(Num::Group(group)) if group >= GROUP => Ok(None),
            Place::Unknown => Ok(None),
            Place::Number(Num::Register(register)) => Ok(Some(Number::Register(register))),
            Place::Number(Num::Count(counter)) => Ok(Some(Number::Counter(counter))),
            Place::Counter(counter) => Ok(Some(Number::Counter(self.counters[counter].number))),
            Place::Bit(Bit::Marker(_)) | Place::Number(Num::Group(_)) => Err((
                "of the markers only M57 to M64 are kept",
                "das memórias, só M57 a M64 são retidas",
            )),
            Place::Timer(_) => Err((
                "the time of a timer is not kept",
                "o tempo de um temporizador não é retido",
            )),
            Place::Trigger(..) => Err(("an edge is not kept", "uma borda não é retida")),
            Place::Instance(_) => Err((
                "declare what the block is to keep in the program",
                "declare no programa o que o bloco deve reter",
            )),
            _ => Err((
                "only M57 to M64, registers and counters are kept",
                "só M57 a M64, registradores e contadores são retidos",
            )),
        }
    }

    fn keep(&mut self, number: Option<Number>) {
        let numbers = &mut self.retained.numbers;
        numbers.extend(number.filter(|number| !numbers.contains(number)));
    }
}
