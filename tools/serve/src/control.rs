//! Which requests of a visitor go to the board: readings of everybody, others of one visitor at a time, and the blocks of
//! an upload of whoever has begun it.

use crate::forcing::{Forcing, forces};
use crate::tokens::Visitor;
use crate::written::needs;
use std::time::{Duration, Instant};
use unoclp_modbus::Exception;
use unoclp_modbus::client::Request;
use unoclp_modbus::map::{Command, holding};
use unoclp_site::Role as May;

/// How long nobody else may control after the last request of who does: an upload is over by then, and a visitor who
/// has left without a word is forgotten.
const HELD: Duration = Duration::from_secs(15);

/// Who controls at present.
#[derive(Debug, Default)]
pub(crate) struct Control {
    holder: Option<(Visitor, Instant)>,
    /// Who has begun the last upload. The board cannot tell clients apart, so only this visitor's blocks reach it.
    uploader: Option<Visitor>,
    pub forcing: Forcing,
}

impl Control {
    /// Whether this request may go to the board at this address; else the exception that refuses it.
    pub fn admit(
        &mut self,
        visitor: Visitor,
        may: May,
        request: &Request,
        address: u8,
        now: Instant,
    ) -> Result<(), Exception> {
        if request.server() != address {
            return Err(Exception::GatewayPathUnavailable);
        }
        if request.only_reads() {
            // Once another controls, who forced is no longer waited for.
            if self.holder.is_some_and(|(holder, _)| holder == visitor) {
                self.forcing.hear(visitor, now);
            }
            return Ok(());
        }
        if may < needs(request) {
            return Err(Exception::IllegalFunction);
        }
        let is_block = request.written(holding::UPLOAD).is_some();
        match self.holder {
            Some((holder, until)) if holder != visitor && now < until => {
                return Err(Exception::ServerDeviceBusy);
            }
            _ if is_block && self.uploader != Some(visitor) => {
                return Err(Exception::ServerDeviceBusy);
            }
            _ => self.holder = Some((visitor, now + HELD)),
        }
        match forces(request) {
            true => self.forcing.force(visitor, now),
            false => self.forcing.hear(visitor, now),
        }
        if begins_upload(request) {
            // Until the board has begun it.
            self.uploader = None;
        }
        Ok(())
    }

    /// Whether a visitor controls now.
    pub fn is_held(&self, now: Instant) -> bool {
        self.holder.is_some_and(|(_, until)| now < until)
    }

    /// The board has done what this visitor asked for.
    pub fn done(&mut self, visitor: Visitor, request: &Request) {
        if begins_upload(request) {
            self.uploader = Some(visitor);
        }
    }

    /// A visitor has left.
    pub fn leave(&mut self, visitor: Visitor) {
        self.holder = self.holder.filter(|&(holder, _)| holder != visitor);
        self.uploader = self.uploader.filter(|&uploader| uploader != visitor);
    }
}

fn begins_upload(request: &Request) -> bool {
    request.written(holding::COMMAND) == Some(Command::Upload as u16)
}

#[cfg(test)]
mod tests {
    use super::*;
    use unoclp_modbus::Table;

    const WATCH: May = May::Watch;
    const OPERATE: May = May::Operate;
    const RULE: May = May::Engineer;

    fn s(seconds: u64) -> Duration {
        Duration::from_secs(seconds)
    }

    #[test]
    fn one_controls_at_a_time_and_all_may_read() {
        let mut control = Control::default();
        let begin = Instant::now();
        let read = Request::read(1, Table::Coils, 0, 4);
        let write = Request::write_word(1, 400, 2);
        let upload = Request::write_word(1, 400, 5);
        let elsewhere = Request::read(2, Table::Coils, 0, 4);
        for (visitor, may, request, after, expected) in [
            (1, WATCH, &read, s(0), Ok(())),
            (1, WATCH, &write, s(0), Err(Exception::IllegalFunction)),
            (
                1,
                RULE,
                &elsewhere,
                s(0),
                Err(Exception::GatewayPathUnavailable),
            ),
            (1, OPERATE, &upload, s(0), Err(Exception::IllegalFunction)),
            (2, OPERATE, &write, s(1), Ok(())),
            (3, RULE, &write, s(2), Err(Exception::ServerDeviceBusy)),
            (3, RULE, &read, s(2), Ok(())),
            (2, RULE, &write, s(14), Ok(())),
            (3, RULE, &write, s(28), Err(Exception::ServerDeviceBusy)),
            (3, RULE, &write, s(29), Ok(())),
            (2, RULE, &write, s(30), Err(Exception::ServerDeviceBusy)),
        ] {
            let admitted = control.admit(visitor, may, request, 1, begin + after);
            assert_eq!(admitted, expected, "visitor {visitor} after {after:?}");
        }
        control.leave(2);
        assert!(control.admit(2, RULE, &write, 1, begin + s(30)).is_err());
        control.leave(3);
        assert!(control.admit(2, RULE, &write, 1, begin + s(30)).is_ok());
    }

    #[test]
    fn who_forced_is_heard_until_another_controls() {
        let begin = Instant::now();
        let mut control = Control::default();
        let read = Request::read(1, Table::Coils, 0, 4);
        let force = Request::write_word(1, 402, 1);
        let write = Request::write_word(1, 0, 1);
        for (visitor, may, request, after, heard) in [
            (1, RULE, &force, 0, 0),
            (1, RULE, &read, 5, 5),
            (2, WATCH, &read, 6, 5),
            (2, RULE, &read, 7, 5),
            // It reads on, long after its last write.
            (1, RULE, &read, 40, 40),
            (2, RULE, &write, 41, 40),
            (1, RULE, &read, 42, 40),
            (2, RULE, &force, 43, 43),
        ] {
            let admitted = control.admit(visitor, may, request, 1, begin + s(after));
            assert_eq!(admitted, Ok(()), "after {after}");
            let since = control.forcing.heard();
            assert_eq!(since, Some(begin + s(heard)), "after {after}");
        }
        control.leave(2);
        assert_eq!(control.forcing.heard(), Some(begin + s(43)));
    }

    /// What becomes of an upload: a visitor sends something at a second, or leaves.
    enum Step {
        Done,
        Failed,
        Busy,
        Leaves,
    }

    #[test]
    fn an_upload_is_gone_on_with_by_whoever_began_it() {
        use Step::{Busy, Done, Failed, Leaves};
        let begin = Request::write_word(1, 400, 5);
        let stop = Request::write_word(1, 400, 2);
        let block = Request::write_words(1, 1000, &[0x0001, 0x3100]).unwrap();
        let all: &[&[(Visitor, &Request, u64, Step)]] = &[
            // Who began it is gone: another begins again.
            &[
                (1, &block, 0, Busy),
                (1, &begin, 0, Done),
                (1, &block, 1, Done),
                (1, &block, 2, Leaves),
                (2, &block, 2, Busy),
                (2, &stop, 2, Done),
                (2, &block, 2, Busy),
                (2, &begin, 2, Done),
                (2, &block, 2, Done),
            ],
            // Who began it is silent, and comes back to another's upload.
            &[
                (1, &begin, 0, Done),
                (1, &block, 1, Done),
                (2, &block, 16, Busy),
                (2, &begin, 16, Done),
                (1, &block, 31, Busy),
                (2, &block, 31, Done),
            ],
            // The board does not begin one, as another is under way.
            &[
                (1, &begin, 0, Done),
                (2, &begin, 15, Failed),
                (2, &block, 15, Busy),
                (1, &block, 30, Busy),
            ],
        ];
        for steps in all {
            let mut control = Control::default();
            let start = Instant::now();
            for (index, (visitor, request, after, step)) in steps.iter().enumerate() {
                if matches!(step, Leaves) {
                    control.leave(*visitor);
                    continue;
                }
                let admitted = control.admit(*visitor, RULE, request, 1, start + s(*after));
                let expected = match step {
                    Busy => Err(Exception::ServerDeviceBusy),
                    _ => Ok(()),
                };
                assert_eq!(admitted, expected, "step {index}");
                if matches!(step, Done) {
                    control.done(*visitor, request);
                }
            }
        }
    }
}
