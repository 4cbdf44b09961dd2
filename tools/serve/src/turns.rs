//! Whose request goes to the board next: STOP before other writes, writes before readings, and the readings of who may
//! control in turn with those of all who watch.

use crate::tokens::Role;
use unoclp_modbus::client::Request;
use unoclp_modbus::map::{Command, holding};

/// Requests that wait.
#[derive(Debug)]
pub(crate) struct Turns<J> {
    /// In the order in which they came.
    waiting: Vec<(Precedence, J)>,
    /// The next reading is one of who may control, if one waits.
    control_reads: bool,
}

/// What a request is, the first to go first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Precedence {
    Stop,
    Write,
    Reading(Role),
}

impl Precedence {
    fn of(request: &Request, role: Role) -> Precedence {
        if request.only_reads() {
            Precedence::Reading(role)
        } else if request.written(holding::COMMAND) == Some(Command::Stop as u16) {
            Precedence::Stop
        } else {
            Precedence::Write
        }
    }
}

impl<J> Default for Turns<J> {
    fn default() -> Turns<J> {
        Turns {
            waiting: Vec::new(),
            control_reads: true,
        }
    }
}

impl<J> Turns<J> {
    /// One more waits: a job, for this request of somebody with this role.
    pub fn wait(&mut self, request: &Request, role: Role, job: J) {
        self.waiting.push((Precedence::of(request, role), job));
    }

    /// The next one.
    pub fn next(&mut self) -> Option<J> {
        let first = match self.control_reads {
            true => Role::Control,
            false => Role::Watch,
        };
        let order = |&(_, (precedence, _)): &(usize, &(Precedence, J))| match *precedence {
            Precedence::Reading(role) => (Precedence::Reading(first), role != first),
            other => (other, false),
        };
        let (index, _) = self.waiting.iter().enumerate().min_by_key(order)?;
        let (precedence, job) = self.waiting.remove(index);
        if let Precedence::Reading(role) = precedence {
            self.control_reads = role == Role::Watch;
        }
        Some(job)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use unoclp_modbus::Table;

    #[test]
    fn writes_go_first_and_who_controls_reads_in_turn() {
        let read = Request::read(1, Table::Coils, 0, 4);
        let stop = Request::write_word(1, 400, 2);
        let run = Request::write_word(1, 400, 1);
        let mut turns = Turns::default();
        for (request, role, name) in [
            (&read, Role::Watch, "w1"),
            (&read, Role::Watch, "w2"),
            (&run, Role::Control, "run"),
            (&read, Role::Watch, "w3"),
            (&read, Role::Control, "c1"),
            (&stop, Role::Control, "stop"),
            (&read, Role::Control, "c2"),
            (&read, Role::Control, "c3"),
        ] {
            turns.wait(request, role, name);
        }
        for expected in ["stop", "run", "c1", "w1", "c2"] {
            assert_eq!(turns.next(), Some(expected));
        }
        turns.wait(&stop, Role::Control, "stop");
        for expected in ["stop", "w2", "c3", "w3"] {
            assert_eq!(turns.next(), Some(expected));
        }
        assert_eq!(turns.next(), None);
    }
}
