//! The points of the board that addresses name, and the parts of timers and counters.

use super::ADDRESS_HELP;
use super::meaning::{Counter, Names, Place};
use crate::address::{Address, spelling};
use crate::diagnostics::{Code, Found, Span, Word};
use crate::tree::{Bit, Num};
use unoclp_core::isa::{ANALOGUE, MARKERS, Opcode, REGISTERS, SYSTEM_MARKERS};

impl Names<'_> {
    pub(super) fn address(
        &mut self,
        address: Address,
        name: &str,
        span: Span,
        found: &mut Found,
    ) -> Place {
        let within = |n: u32, first: u32, last: u8| {
            (first..=u32::from(last)).contains(&n).then_some(n as u8)
        };
        let board = self.board;
        let place = match address.clone() {
            Address::Input(n) => within(n, 1, board.inputs).map(|n| Place::Bit(Bit::Input(n))),
            Address::Output(n) => within(n, 1, board.outputs).map(|n| Place::Bit(Bit::Output(n))),
            Address::Marker(n) => within(n, 1, MARKERS).map(|n| Place::Bit(Bit::Marker(n))),
            Address::System(n) => within(n, 1, SYSTEM_MARKERS).map(|n| Place::Bit(Bit::System(n))),
            Address::Always => Some(Place::Always(true)),
            Address::Analogue(n) => {
                within(n, 0, ANALOGUE - 1).map(|n| Place::Number(Num::Analogue(n)))
            }
            Address::Pwm(n) => [1, 4]
                .contains(&n)
                .then_some(Place::Number(Num::Pwm(n as u8))),
            Address::Register(n) => {
                within(n, 1, REGISTERS).map(|n| Place::Number(Num::Register(n)))
            }
            Address::Group(n) => within(n, 1, 8).map(|n| Place::Number(Num::Group(n))),
            Address::Inputs => Some(Place::Number(Num::Inputs)),
            Address::Outputs => Some(Place::Number(Num::Outputs)),
            Address::Timer(key, member) => {
                let timer = match self.global.get(&key) {
                    Some(&place) => place,
                    None => {
                        let place = self.new_timer(key.clone(), None, None);
                        self.global.insert(key.clone(), place);
                        place
                    }
                };
                return match member {
                    Some(member) => self.member(timer, &key, &member, span, found),
                    None => timer,
                };
            }
            Address::Counter(key, member) => {
                let counter = match self.global.get(&key) {
                    Some(&place) => place,
                    None => {
                        let place = self.new_counter(key.clone(), None, None);
                        self.told_none_left(span, found);
                        self.global.insert(key.clone(), place);
                        place
                    }
                };
                return match member {
                    Some(member) => self.member(counter, &key, &member, span, found),
                    None => counter,
                };
            }
        };
        let Some(place) = place else {
            let written = self.written(span);
            found.tell(
                Code::NoSuchPoint,
                span,
                [written.into(), ADDRESS_HELP.into()],
            );
            return Place::Unknown;
        };
        self.one_spelling(address, name, span, place, found);
        place
    }

    /// One point that is written in two ways, such as `%I0.4` and `%I1.0`, was meant to be two.
    fn one_spelling(
        &mut self,
        address: Address,
        name: &str,
        span: Span,
        place: Place,
        found: &mut Found,
    ) {
        let spelling = spelling(name);
        let (first, at) = match self.points.get(&address) {
            None => {
                self.points.insert(address, (spelling, span));
                return;
            }
            Some((first, at)) => (first, *at),
        };
        if *first == spelling {
            return;
        }
        let (one, other) = match at.start <= span.start {
            true => (at, span),
            false => (span, at),
        };
        let words = [
            self.written(one).into(),
            self.written(other).into(),
            point_words(place),
        ];
        found.tell(Code::SamePoint, other, words);
    }

    /// What a block keeps under this name: `T1.Q`, `C2.CV`.
    pub(crate) fn member(
        &mut self,
        block: Place,
        name: &str,
        member: &str,
        span: Span,
        found: &mut Found,
    ) -> Place {
        if let Some(input) = self.input(block, member) {
            self.told_none_left(span, found);
            return input;
        }
        let (place, has) = match block {
            Place::Timer(timer) => (
                match member {
                    "Q" => Some(Place::Bit(Bit::Timer(timer))),
                    "ET" | "V" => Some(Place::Number(Num::Elapsed(timer))),
                    "PT" | "P" => Some(Place::Number(Num::TimerPreset(timer))),
                    _ => None,
                },
                "Q, ET, PT, IN",
            ),
            Place::Counter(counter) => {
                let Counter { number, kind, .. } = self.counters[counter];
                let down = kind == Some(Opcode::CountDown);
                (
                    match member {
                        "Q" if down => Some(Place::Bit(Bit::Zero(number))),
                        "Q" | "QU" | "D" => Some(Place::Bit(Bit::Reached(number))),
                        "QD" => Some(Place::Bit(Bit::Zero(number))),
                        "CV" | "V" => Some(Place::Number(Num::Count(number))),
                        "PV" | "P" => Some(Place::Number(Num::CountPreset(number))),
                        _ => None,
                    },
                    "Q, QU, QD, D, CV, PV, CU, CD, R, LD",
                )
            }
            Place::Trigger(_, marker) if member == "Q" => {
                (Some(Place::Bit(Bit::Marker(marker))), "Q")
            }
            Place::Trigger(..) => (None, "Q, CLK"),
            Place::Latch(_, marker) if matches!(member, "Q1" | "Q") => {
                (Some(Place::Bit(Bit::Marker(marker))), "Q1")
            }
            Place::Latch(true, _) => (None, "Q1, S1, R"),
            Place::Latch(false, _) => (None, "Q1, S, R1"),
            Place::Instance(instance) => (
                self.instances[instance].names.get(member).copied(),
                "VAR_INPUT, VAR_OUTPUT",
            ),
            Place::Unknown => return Place::Unknown,
            _ => (None, ""),
        };
        place.unwrap_or_else(|| {
            let help = match has {
                "" => (
                    "only timers, counters and blocks have parts".to_owned(),
                    "só temporizadores, contadores e blocos têm partes".to_owned(),
                ),
                has => (format!("it has {has}"), format!("tem {has}")),
            };
            let written = self.written(span);
            let (block, member) = written.rsplit_once('.').unwrap_or((name, member));
            found.tell(
                Code::NoSuchMember,
                span,
                [block.into(), member.into(), help.into()],
            );
            Place::Unknown
        })
    }
}

/// What messages call a point of the board.
fn point_words(place: Place) -> Word {
    let (en, pt, n) = match place {
        Place::Bit(Bit::Input(n)) => ("input", "entrada", n),
        Place::Bit(Bit::Output(n)) => ("output", "saída", n),
        Place::Bit(Bit::Marker(n)) => ("marker", "memória", n),
        Place::Number(Num::Register(n)) => ("register", "registrador", n),
        Place::Number(Num::Analogue(n)) => ("analogue input A", "entrada analógica A", n),
        Place::Number(Num::Inputs) => return ("thing, all inputs", "todas as entradas").into(),
        Place::Number(Num::Outputs) => return ("thing, all outputs", "todas as saídas").into(),
        Place::Bit(Bit::System(n)) => ("system marker", "memória do sistema", n),
        _ => return ("point", "ponto").into(),
    };
    Word::Both(format!("{en} {n:02}"), format!("{pt} {n:02}"))
}
