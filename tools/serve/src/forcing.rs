//! Points that are forced, and their end once whoever forced them is gone.
//!
//! The board ends forcing itself where no request has come for as long as its register 406 says. Behind a gateway the
//! requests of others go on. So the gateway counts those of whoever forced, and lets go in the board's stead.

use crate::line::Line;
use crate::tokens::{Role, Visitor};
use std::time::{Duration, Instant};
use unoclp_modbus::Exception;
use unoclp_modbus::client::{NoReply, Request};
use unoclp_modbus::map::{Span, holding};

/// The registers of forcing, in a row.
const REGISTERS: [Span; 5] = [
    holding::FORCED_INPUTS,
    holding::INPUTS_TO,
    holding::FORCED_OUTPUTS,
    holding::OUTPUTS_TO,
    holding::FORCING_ENDS,
];

/// Those of the inputs above 16, which only a board with more inputs than a UNO has.
const MORE: [Span; 2] = [holding::FORCED_MORE, holding::MORE_TO];

/// Who has forced points, and when they are let go.
#[derive(Debug, Default)]
pub(crate) struct Forcing {
    by: Option<Visitor>,
    /// When this visitor was last heard.
    heard: Option<Instant>,
}

/// What a board says of its forcing: the values of [`REGISTERS`], and which inputs above 16 are forced.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Forced([u16; REGISTERS.len()], u16);

impl Forcing {
    /// A request that may change what is forced goes to the board.
    pub fn force(&mut self, visitor: Visitor, now: Instant) {
        self.by = Some(visitor);
        self.heard = Some(now);
    }

    /// This visitor, who controls, is there.
    pub fn hear(&mut self, visitor: Visitor, now: Instant) {
        if self.by == Some(visitor) {
            self.heard = Some(now);
        }
    }

    /// When whoever forced was last heard.
    #[cfg(test)]
    pub fn heard(&self) -> Option<Instant> {
        self.heard
    }

    /// The board says now that this is forced: when it is let go, if ever. Where nobody is known to have forced it, its time
    /// begins.
    pub fn learn(&mut self, forced: Forced, now: Instant) -> Option<Instant> {
        let ends = forced.ends()?;
        Some(*self.heard.get_or_insert(now) + ends)
    }
}

impl Forced {
    /// How long without a request ends it, where something is forced and there is an end.
    fn ends(self) -> Option<Duration> {
        let Forced([inputs, _, outputs, _, ends], more) = self;
        let is_forced = inputs | outputs | more != 0;
        (is_forced && !matches!(ends, 0 | 255)).then(|| Duration::from_secs(ends.into()))
    }

    /// The requests that let go. Outputs are forced to 0 before: they are 0 then until the program writes them, as where
    /// the board itself ends forcing.
    fn releases(self, address: u8) -> impl Iterator<Item = Request> {
        let Forced([inputs, to, outputs, ..], more) = self;
        let [first, of_more] = [REGISTERS[0].first, MORE[0].first];
        let writes = [[inputs, to, outputs, 0], [0; 4]].map(|words| (first, words.to_vec()));
        let more = (more != 0).then(|| (of_more, vec![0; MORE.len()]));
        let writes = more.into_iter().chain(writes);
        writes.filter_map(move |(first, words)| Request::write_words(address, first, &words))
    }
}

/// Whether a request may change what is forced.
pub(crate) fn forces(request: &Request) -> bool {
    let mut registers = REGISTERS.iter().chain(&MORE);
    registers.any(|&span| request.written(span).is_some())
}

/// What the board says; else why it does not.
pub(crate) async fn forced(line: &Line) -> Result<Forced, Exception> {
    let values = read(line, REGISTERS).await?;
    match read(line, MORE).await {
        Ok([more, _]) => Ok(Forced(values, more)),
        // It has no such inputs.
        Err(Exception::IllegalDataAddress) => Ok(Forced(values, 0)),
        Err(exception) => Err(exception),
    }
}

/// The words of these spans, of a word each and in a row.
async fn read<const N: usize>(line: &Line, spans: [Span; N]) -> Result<[u16; N], Exception> {
    let Span { table, first, .. } = spans[0];
    let request = Request::read(line.address(), table, first, N as u16);
    let reply = line.ask(request.clone(), Role::Control).await;
    match request.answer(&reply) {
        Some(Ok(reply)) => {
            let mut values = [0; N];
            for (value, word) in values.iter_mut().zip(reply.words()) {
                *value = word;
            }
            Ok(values)
        }
        Some(Err(NoReply::Refused(exception))) => Err(exception),
        Some(Err(NoReply::Garbled)) | None => Err(Exception::GatewayTargetSilent),
    }
}

/// Lets all of it go. What came of it is seen when the board is asked again.
pub(crate) async fn let_go(line: &Line, forced: Forced) {
    for request in forced.releases(line.address()) {
        line.ask(request, Role::Control).await;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_ends_when_whoever_forced_was_not_heard_for_as_long_as_the_board_says() {
        let s = Duration::from_secs;
        let begin = Instant::now();
        let mut forcing = Forcing::default();
        let forced = |ends| Forced([0, 0, 1, 1, ends], 0);
        // Nobody is known to have forced.
        assert_eq!(forcing.learn(forced(10), begin), Some(begin + s(10)));
        assert_eq!(forcing.learn(forced(10), begin + s(9)), Some(begin + s(10)));
        forcing.force(1, begin + s(20));
        forcing.hear(1, begin + s(21));
        forcing.hear(2, begin + s(25));
        for (words, ends) in [
            (forced(10), Some(31)),
            (forced(254), Some(275)),
            (forced(255), None),
            (forced(0), None),
            (Forced([0, 1, 0, 1, 10], 0), None),
            (Forced([4, 0, 0, 0, 10], 0), Some(31)),
            (Forced([0, 0, 0, 0, 10], 1 << 7), Some(31)),
        ] {
            let due = forcing.learn(words, begin + s(30));
            assert_eq!(due, ends.map(|ends| begin + s(ends)), "{words:?}");
        }
    }

    #[test]
    fn a_request_may_force_where_it_writes_such_a_register() {
        let several = |first| Request::write_words(1, first, &[0, 0, 0]).unwrap();
        for (request, does) in [
            (Request::write_word(1, 402, 1), true),
            (Request::write_word(1, 406, 1), true),
            (Request::write_word(1, 407, 1), true),
            (Request::write_word(1, 408, 1), true),
            (Request::write_word(1, 409, 1), false),
            (Request::write_word(1, 400, 1), false),
            (several(400), true),
            (several(399), false),
            (several(410), false),
            (Request::write_coil(1, 402, true), false),
        ] {
            assert_eq!(forces(&request), does, "{:?}", request.bytes());
        }
    }
}
