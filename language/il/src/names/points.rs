//! The points of the board that addresses name, and the parts of timers and counters.

use super::meaning::{Counter, Names, Place};
use crate::tree::{Bit, Num};
use unoclp_core::isa::Opcode;
use unoclp_point::{Address, Kind, Written};
use unoclp_text::diagnostics::{Code, Found, Span};
use unoclp_text::points::{self, exists};

impl Names<'_> {
    /// What a point of the text means. What is wrong with it is told.
    pub(super) fn point(&mut self, written: &Written, span: Span, found: &mut Found) -> Place {
        let is_block = matches!(written.kind, Kind::Timer | Kind::Counter);
        if is_block && written.number.is_some() {
            return self.block(written, span, found);
        }
        let address = written.address;
        let Some(address) = address.filter(|address| exists(*address, self.board)) else {
            self.told_no_point(span, found);
            return Place::Unknown;
        };
        let place = match address {
            Address::Always(_) => Place::Always(true),
            bit if bit.is_bit() => Place::Bit(Bit::At(bit)),
            number => Place::Number(Num::At(number)),
        };
        let here = (Code::SamePoint, span);
        self.points.note((address, written), here, self.text, found);
        place
    }

    /// A timer or counter by its name, made where that is named first, or a part of it.
    fn block(&mut self, written: &Written, span: Span, found: &mut Found) -> Place {
        let key = written.name();
        let block = match self.global.get(&key) {
            Some(&place) => place,
            None => {
                let place = match written.kind {
                    Kind::Timer => self.new_timer(key.clone(), None, None),
                    _ => {
                        let counter = self.new_counter(key.clone(), None, None);
                        self.told_none_left(span, found);
                        counter
                    }
                };
                self.global.insert(key.clone(), place);
                place
            }
        };
        match written.member {
            Some(member) => self.member(block, &key, member, span, found),
            None => block,
        }
    }

    /// Tells that the board has no such point, and what to write.
    pub(super) fn told_no_point(&self, span: Span, found: &mut Found) {
        let written = self.written(span);
        let help = points::help(&written, self.dialect.maker(), self.board);
        found.tell(Code::NoSuchPoint, span, [written.into(), help]);
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
                        "Q" if down => Some(Place::Bit(Bit::At(Address::AtZero(number)))),
                        "Q" | "QU" | "D" => Some(Place::Bit(Bit::At(Address::Reached(number)))),
                        "QD" => Some(Place::Bit(Bit::At(Address::AtZero(number)))),
                        "CV" | "V" => Some(Place::Number(Num::At(Address::Count(number)))),
                        "PV" | "P" => Some(Place::Number(Num::At(Address::CountPreset(number)))),
                        _ => None,
                    },
                    "Q, QU, QD, D, CV, PV, CU, CD, R, LD",
                )
            }
            Place::Trigger(_, marker) if member == "Q" => {
                (Some(Place::Bit(Bit::At(Address::Marker(marker)))), "Q")
            }
            Place::Trigger(..) => (None, "Q, CLK"),
            Place::Latch(_, marker) if matches!(member, "Q1" | "Q") => {
                (Some(Place::Bit(Bit::At(Address::Marker(marker)))), "Q1")
            }
            Place::Latch(true, _) => (None, "Q1, S1, R"),
            Place::Latch(false, _) => (None, "Q1, S, R1"),
            Place::Typed => return Place::Typed,
            Place::Instance(instance) => {
                let names = &self.instances[instance].names;
                let first = member.split('.').next().unwrap_or(member);
                let typed = names.get(first).filter(|place| **place == Place::Typed);
                let place = names.get(member).or(typed);
                (place.copied(), "VAR_INPUT, VAR_OUTPUT")
            }
            Place::Unknown => return Place::Unknown,
            _ => (None, ""),
        };
        place.unwrap_or_else(|| {
            let help = match has {
                "" => (
                    "only timers, counters and blocks have members".to_owned(),
                    "só temporizadores, contadores e blocos têm membros".to_owned(),
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
