//! What a part is given, by what its kind asks for.

use crate::keys::{Amiss, Keys, Notes, quantity};
use crate::kind::{Field, Form, Kind};
use crate::mistake::Wrong;
use crate::plant::Part;
use crate::signal::{Contact, Given, Signal, Source};
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::ops::Range;
use unoclp_core::{Board, Point};
use unoclp_point::Address;

/// The parts by name and kind, and the points that are taken.
pub(crate) struct Names<'a> {
    pub board: Board,
    pub known: Vec<(String, &'static Kind)>,
    pub notes: &'a Notes<'a>,
    /// Each input that a part sets, with the name of the part.
    pub taken: RefCell<BTreeMap<Address, String>>,
}

impl Names<'_> {
    /// The number of the part of this name.
    pub fn find(&self, name: &str) -> Option<usize> {
        self.known
            .iter()
            .position(|(known, _)| known.eq_ignore_ascii_case(name))
    }

    /// The same; where there is none, that is told.
    pub fn part(&self, name: &str, place: &Range<usize>) -> Option<usize> {
        let found = self.find(name);
        if found.is_none() {
            let known = self.known.iter().map(|(name, _)| name.as_str()).take(30);
            let wrong = Wrong::NoSuchPart {
                name: name.to_owned(),
                known: known.collect::<Vec<_>>().join(", "),
            };
            self.notes.wrong(place, wrong);
        }
        found
    }

    /// A value of a part that is named `part.value`, or by the part alone, which means its first.
    pub fn value(&self, path: &str, place: &Range<usize>) -> Option<(usize, usize)> {
        let (name, value) = path.split_once('.').unwrap_or((path, ""));
        let part = self.part(name.trim(), place)?;
        let (_, kind) = self.known.get(part)?;
        let seen = || kind.values.iter().filter(|slot| slot.is_seen);
        let found = match value {
            "" => seen().next(),
            value => seen().find(|slot| slot.name.eq_ignore_ascii_case(value)),
        };
        let number = found.and_then(|slot| kind.value(slot.name));
        if number.is_none() {
            let wrong = Wrong::NoSuchValue {
                name: name.to_owned(),
                value: value.to_owned(),
                known: seen().map(|slot| slot.name).collect::<Vec<_>>().join(", "),
            };
            self.notes.wrong(place, wrong);
        }
        Some((part, number?))
    }

    /// The point of the board that this names; one that it lacks is told.
    fn on_board(&self, address: Address, place: &Range<usize>) -> Option<Point> {
        let board = &self.board;
        let (number, most, known) = match address {
            Address::Input(number) => (number, board.inputs, format!("I1–I{}", board.inputs)),
            Address::Output(number) => (number, board.outputs, format!("Q1–Q{}", board.outputs)),
            Address::Analogue(number) => {
                let last = board.analogue.saturating_sub(1);
                let known = format!("A0–A{last}");
                (number.saturating_add(1), board.analogue, known)
            }
            Address::Pwm(number) => {
                let pwm: Vec<u8> = board.pwm_outputs().collect();
                let names = pwm.iter().map(|number| format!("P{number}")).take(8);
                let known = names.collect::<Vec<_>>().join(", ");
                let number = if pwm.contains(&number) { number } else { 0 };
                (number, board.outputs, known)
            }
            _ => (0, 0, String::new()),
        };
        let point = Point::new(number, most);
        if point.is_none() {
            let wrong = Wrong::NoPoint {
                point: address.to_string(),
                board: board.name,
                known,
            };
            self.notes.wrong(place, wrong);
        }
        point
    }

    /// An input is set by this part and by no other.
    fn take(&self, address: Address, part: &str, place: &Range<usize>) {
        let mut taken = self.taken.borrow_mut();
        if let Some(other) = taken.get(&address) {
            let wrong = Wrong::TwoUses {
                point: address.to_string(),
                other: other.clone(),
            };
            self.notes.wrong(place, wrong);
        }
        let shared = |analogue: u8| self.board.shares(analogue);
        let twin = match address {
            Address::Analogue(number) => shared(number).map(Address::Input),
            Address::Input(number) => (0..self.board.analogue)
                .find(|analogue| shared(*analogue) == Some(number))
                .map(Address::Analogue),
            _ => None,
        };
        if let Some(twin) = twin.filter(|twin| taken.contains_key(twin)) {
            let wrong = Wrong::SharedPin {
                point: address.to_string(),
                other: twin.to_string(),
            };
            self.notes.wrong(place, wrong);
        }
        taken.insert(address, part.to_owned());
    }

    fn signal(&self, text: &str, place: &Range<usize>) -> Option<Signal> {
        let (not, name) = match text.trim().split_once(' ') {
            Some((word, name)) if word.eq_ignore_ascii_case("not") => (true, name.trim()),
            _ => (false, text.trim()),
        };
        let digits = |letter: char| {
            let digits = name
                .strip_prefix(letter)
                .or(name.strip_prefix(letter.to_ascii_lowercase()));
            digits.and_then(|digits| digits.parse::<u8>().ok())
        };
        let source = if self
            .find(name.split('.').next().unwrap_or_default())
            .is_some()
        {
            let (part, value) = self.value(name, place)?;
            Source::Value(part, value)
        } else if let Some(number) = digits('Q') {
            Source::Output(self.on_board(Address::Output(number), place)?)
        } else if let Some(number) = digits('P') {
            self.on_board(Address::Pwm(number), place)?;
            Source::Pwm(number)
        } else if name.contains('.') {
            self.value(name, place)?;
            return None;
        } else {
            let given = text.to_owned();
            self.notes.wrong(place, Wrong::NoSignal { given });
            return None;
        };
        Some(Signal { source, not })
    }

    fn contact(&self, text: &str, part: &str, place: &Range<usize>) -> Option<Contact> {
        let (point, normally_closed) = match text.trim().split_once(' ') {
            Some((point, nc)) if nc.trim().eq_ignore_ascii_case("nc") => (point, true),
            _ => (text.trim(), false),
        };
        match Address::parse(point) {
            Some(address @ Address::Input(_)) => {
                let input = self.on_board(address, place)?;
                self.take(address, part, place);
                Some(Contact {
                    input,
                    normally_closed,
                })
            }
            _ => {
                let given = text.to_owned();
                self.notes.wrong(place, Wrong::NoInput { given });
                None
            }
        }
    }

    /// What a part of this kind and name is given.
    pub fn given(&self, kind: &'static Kind, name: &str, keys: &Keys<'_>) -> Vec<Given> {
        let fields = kind.fields.iter();
        fields.map(|field| self.one(field, name, keys)).collect()
    }

    fn one(&self, field: &'static Field, part: &str, keys: &Keys<'_>) -> Given {
        let Some(value) = keys.value(field.name) else {
            return self.without(field, keys);
        };
        let place = value.span();
        let taken = match field.form {
            Form::Number(unit, low, high, _) => {
                quantity(self.notes, field.name, value, unit, low.into(), high.into())
                    .map(Given::Number)
            }
            _ => match value.get_ref().as_str() {
                Some(text) => self.worded(field, text, part, &place),
                None => {
                    let example = example(field.form);
                    let key = field.name;
                    self.notes.wrong(&place, Amiss::Kind { key, example });
                    None
                }
            },
        };
        taken.unwrap_or(Given::Nothing)
    }

    /// What a field means that is not given.
    fn without(&self, field: &'static Field, keys: &Keys<'_>) -> Given {
        match field.form {
            Form::Number(_, _, _, usual) => Given::Number(usual),
            Form::Choice(_) => Given::Choice(0),
            Form::Sense | Form::Reading | Form::MayPart(_) | Form::MayDrive => Given::Nothing,
            // A valve may be turned by hand alone.
            Form::Duty => Given::Signal(Signal {
                source: Source::Nothing,
                not: false,
            }),
            Form::Drive | Form::Part(_) | Form::Value => {
                keys.missing(field.name, example(field.form));
                Given::Nothing
            }
        }
    }

    fn worded(
        &self,
        field: &'static Field,
        text: &str,
        part: &str,
        place: &Range<usize>,
    ) -> Option<Given> {
        match field.form {
            Form::Number(..) => None,
            Form::Drive | Form::MayDrive | Form::Duty => {
                self.signal(text, place).map(Given::Signal)
            }
            Form::Sense => self.contact(text, part, place).map(Given::Contact),
            Form::Reading => match Address::parse(text.trim()) {
                Some(address @ Address::Analogue(number)) => {
                    self.on_board(address, place)?;
                    self.take(address, part, place);
                    Some(Given::Analogue(number))
                }
                _ => {
                    let given = text.to_owned();
                    self.notes.wrong(place, Wrong::NoAnalogue { given });
                    None
                }
            },
            Form::Part(kinds) | Form::MayPart(kinds) => {
                let number = self.part(text, place)?;
                let (name, kind) = self.known.get(number)?;
                if kinds.contains(&kind.name) {
                    return Some(Given::Part(number));
                }
                let wrong = Wrong::OtherKind {
                    name: name.clone(),
                    kind: kind.name,
                    known: kinds.join(", "),
                };
                self.notes.wrong(place, wrong);
                None
            }
            Form::Value => {
                let (part, value) = self.value(text, place)?;
                Some(Given::Value(part, value))
            }
            Form::Choice(words) => {
                let choice = words.iter().position(|word| *word == text);
                if choice.is_none() {
                    let wrong = Amiss::Choice {
                        key: field.name.to_owned(),
                        given: format!("{text:?}"),
                        known: quoted(words),
                    };
                    self.notes.wrong(place, wrong);
                }
                choice.map(Given::Choice)
            }
        }
    }

    /// No output is used both with PWM and without.
    pub fn check_outputs(&self, parts: &[Part], place: impl Fn(usize) -> Range<usize>) {
        let all = || {
            let numbered = parts.iter().enumerate();
            numbered.flat_map(|(number, part)| part.given.iter().map(move |given| (number, given)))
        };
        let sources = || {
            all().filter_map(|(number, given)| match given {
                Given::Signal(signal) => Some((number, signal.source)),
                _ => None,
            })
        };
        for (number, source) in sources() {
            let Source::Pwm(output) = source else {
                continue;
            };
            let plain = |(_, other): (usize, Source)| matches!(other, Source::Output(point) if point.number() == output);
            if sources().any(plain) {
                let point = Address::Output(output).to_string();
                self.notes.wrong(&place(number), Wrong::BothWays { point });
            }
        }
    }
}

/// Words in quotes, for a message.
pub(crate) fn quoted(words: &[&str]) -> String {
    let words = words.iter().map(|word| format!("\"{word}\""));
    words.collect::<Vec<_>>().join(", ")
}

/// What a field takes, as an example.
fn example(form: Form) -> &'static str {
    match form {
        Form::Number(..) => "1",
        Form::Drive | Form::MayDrive | Form::Duty => "\"Q1\"",
        Form::Sense => "\"I1\"",
        Form::Reading => "\"A0\"",
        Form::Part(_) | Form::MayPart(_) => "\"tank\"",
        Form::Value => "\"tank.level\"",
        Form::Choice(_) => "\"red\"",
    }
}
