//! `VAR RETAIN`: what a variable keeps over a power cut (NC-12, NC-21), or why it cannot.

use super::declare::is_new;
use super::meaning::{Names, Place};
use crate::ast::{UnitKind, Var};
use crate::tree::{Bit, Num};
use unoclp_core::isa::RETENTIVE;
use unoclp_core::{KEPT, Number};
use unoclp_point::Address;
use unoclp_text::diagnostics::{Code, Found, Span};

/// The first of the groups of eight markers that are retentive.
const GROUP: u8 = (RETENTIVE - 1) / 8 + 1;

/// Why a variable cannot be kept.
type Why = (&'static str, &'static str);

const NEW: Why = (
    "it is created again at each call",
    "ela é criada de novo a cada chamada",
);
const MARKER: Why = (
    "only the markers M57 to M64 are retained",
    "só as memórias M57 a M64 são retidas",
);
const TIMER: Why = (
    "the elapsed time of a timer is not retained",
    "o tempo decorrido de um temporizador não é retido",
);
const EDGE: Why = ("an edge is not retained", "uma borda não é retida");
const BLOCK: Why = (
    "write RETAIN in the block itself, in the declarations of the variables to retain",
    "escreva RETAIN no próprio bloco, nas declarações das variáveis a reter",
);
const POINT: Why = (
    "inputs, outputs and PWM are not retained",
    "entradas, saídas e PWM não são retidos",
);
const TOO_MANY: Why = (
    "at most 16 registers and counters are retained, and initial values take a register too",
    "no máximo 16 registradores e contadores são retidos, e os valores iniciais também ocupam um registrador",
);

impl Names<'_> {
    /// Keeps a variable. Its first values are those after the first `before`.
    pub(super) fn retain(
        &mut self,
        place: Place,
        var: &Var,
        kind: UnitKind,
        before: usize,
        found: &mut Found,
    ) {
        let span = var.name.span;
        let begins = std::mem::replace(&mut self.initials, before) > before;
        let number = match is_new(var, kind) {
            true => Err(NEW),
            false => self.retained_as(place),
        };
        let mut kept = number.and_then(|number| self.keep(number, span));
        if kept.is_ok() && begins && !std::mem::replace(&mut self.retained.begun, true) {
            let register = self.temps.named_register();
            self.told_none_left(span, found);
            // The register has no name in the text.
            kept = self.keep(Some(Number::Register(register)), span.empty());
        }
        if let Err(why) = kept {
            let name = self.written(span);
            found.tell(Code::NotRetained, span, [name.into(), why.into()]);
        }
    }

    /// The number that keeps a place; none where it is kept by itself.
    fn retained_as(&self, place: Place) -> Result<Option<Number>, Why> {
        Ok(match place {
            Place::Number(Num::At(Address::Register(register))) => Some(Number::Register(register)),
            Place::Number(Num::At(Address::Count(counter))) => Some(Number::Counter(counter)),
            Place::Counter(counter) => Some(Number::Counter(self.counters[counter].number)),
            // Its marker is a retentive one.
            Place::Latch(..) => None,
            Place::Bit(Bit::At(Address::Marker(marker))) if marker >= RETENTIVE => None,
            Place::Number(Num::At(Address::Group(group))) if group >= GROUP => None,
            // It has been told.
            Place::Unknown | Place::Typed => None,
            Place::Bit(Bit::At(Address::Marker(_))) | Place::Number(Num::At(Address::Group(_))) => {
                return Err(MARKER);
            }
            Place::Timer(_) => return Err(TIMER),
            Place::Trigger(..) => return Err(EDGE),
            Place::Instance(_) => return Err(BLOCK),
            Place::Bit(_) | Place::Number(_) | Place::Always(_) => return Err(POINT),
        })
    }

    fn keep(&mut self, number: Option<Number>, span: Span) -> Result<(), Why> {
        let numbers = &mut self.retained.numbers;
        let Some(number) = number.filter(|new| numbers.iter().all(|(number, _)| number != new))
        else {
            return Ok(());
        };
        if numbers.len() == KEPT.into() {
            return Err(TOO_MANY);
        }
        numbers.push((number, span));
        Ok(())
    }
}
