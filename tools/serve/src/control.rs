//! Which requests of a visitor go to the board: reading ones of everybody, others of one visitor at a time.

use crate::tokens::Role;
use std::time::{Duration, Instant};
use unoclp_modbus::Exception;
use unoclp_modbus::client::Request;

/// How long nobody else may control behind the last request of who does: an upload is over by then, and a visitor who
/// has left without a word is forgotten.
const HELD: Duration = Duration::from_secs(15);

/// A visitor: a number that no other has.
pub(crate) type Visitor = u64;

/// Who controls at present.
#[derive(Debug, Default)]
pub(crate) struct Control {
    holder: Option<(Visitor, Instant)>,
}

impl Control {
    /// Whether this request may go to the board at this address; else the exception that refuses it.
    pub fn admit(
        &mut self,
        visitor: Visitor,
        role: Role,
        request: &Request,
        address: u8,
        now: Instant,
    ) -> Result<(), Exception> {
        if request.server() != address {
            return Err(Exception::GatewayPathUnavailable);
        }
        if request.only_reads() {
            return Ok(());
        }
        if role != Role::Control {
            return Err(Exception::IllegalFunction);
        }
        match self.holder {
            Some((holder, until)) if holder != visitor && now < until => {
                Err(Exception::ServerDeviceBusy)
            }
            _ => {
                self.holder = Some((visitor, now + HELD));
                Ok(())
            }
        }
    }

    /// A visitor has left.
    pub fn leave(&mut self, visitor: Visitor) {
        self.holder = self.holder.filter(|&(holder, _)| holder != visitor);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use unoclp_modbus::Table;

    #[test]
    fn one_controls_at_a_time_and_all_may_read() {
        let mut control = Control::default();
        let begin = Instant::now();
        let read = Request::read(1, Table::Coils, 0, 4);
        let write = Request::write_word(1, 400, 2);
        let elsewhere = Request::read(2, Table::Coils, 0, 4);
        let (watch, rule) = (Role::Watch, Role::Control);
        let s = Duration::from_secs;
        for (visitor, role, request, after, expected) in [
            (1, watch, &read, s(0), Ok(())),
            (1, watch, &write, s(0), Err(Exception::IllegalFunction)),
            (
                1,
                rule,
                &elsewhere,
                s(0),
                Err(Exception::GatewayPathUnavailable),
            ),
            (2, rule, &write, s(1), Ok(())),
            (3, rule, &write, s(2), Err(Exception::ServerDeviceBusy)),
            (3, rule, &read, s(2), Ok(())),
            (2, rule, &write, s(14), Ok(())),
            (3, rule, &write, s(28), Err(Exception::ServerDeviceBusy)),
            (3, rule, &write, s(29), Ok(())),
            (2, rule, &write, s(30), Err(Exception::ServerDeviceBusy)),
        ] {
            let admitted = control.admit(visitor, role, request, 1, begin + after);
            assert_eq!(admitted, expected, "visitor {visitor} after {after:?}");
        }
        control.leave(2);
        assert!(control.admit(2, rule, &write, 1, begin + s(30)).is_err());
        control.leave(3);
        assert!(control.admit(2, rule, &write, 1, begin + s(30)).is_ok());
    }
}
