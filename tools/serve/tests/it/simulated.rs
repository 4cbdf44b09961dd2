//! Boards in memory at one line: each answers as the firmware does.

#[path = "../../../client/tests/fake/mod.rs"]
#[allow(unused_imports, reason = "each test uses its part")]
mod fake;

use fake::{Board, Fate, Trick, answer};
use std::collections::BTreeMap;
use std::ops::{Deref, DerefMut};
use std::sync::{Arc, Mutex, MutexGuard};
use unoclp_client::diagnostics::Kept;
use unoclp_modbus::client::Request;
use unoclp_serve::NoAnswer;

/// Boards at one line, by their addresses.
#[derive(Clone)]
pub struct Simulated(Arc<Mutex<Boards>>);

struct Boards {
    boards: BTreeMap<u8, Board>,
    is_unplugged: bool,
}

/// One of them, which answers nothing meanwhile.
pub struct One<'s> {
    boards: MutexGuard<'s, Boards>,
    address: u8,
}

/// What the board at this address keeps.
pub fn kept(address: u8) -> Kept {
    Kept {
        sum: address.into(),
        ..Board::default().kept
    }
}

impl Simulated {
    /// Boards at these addresses.
    pub fn at(addresses: &[u8]) -> Simulated {
        let board = |&address: &u8| {
            let mut board = Board::default();
            board.settings[0] = address.into();
            board.kept = kept(address);
            (address, board)
        };
        Simulated(Arc::new(Mutex::new(Boards {
            boards: addresses.iter().map(board).collect(),
            is_unplugged: false,
        })))
    }

    pub fn board(&self, address: u8) -> One<'_> {
        let boards = self.0.lock().unwrap();
        One { boards, address }
    }

    /// The line is gone, or back.
    pub fn unplug(&self, is_unplugged: bool) {
        self.0.lock().unwrap().is_unplugged = is_unplugged;
    }
}

impl Deref for One<'_> {
    type Target = Board;

    fn deref(&self) -> &Board {
        &self.boards.boards[&self.address]
    }
}

impl DerefMut for One<'_> {
    fn deref_mut(&mut self) -> &mut Board {
        self.boards.boards.get_mut(&self.address).unwrap()
    }
}

impl unoclp_serve::Board for Simulated {
    fn find(&mut self, address: u8) -> Result<(), String> {
        let boards = self.0.lock().unwrap();
        match boards.boards.contains_key(&address) && !boards.is_unplugged {
            true => Ok(()),
            false => Err("unplugged".into()),
        }
    }

    fn ask(&mut self, request: &Request) -> Result<Vec<u8>, NoAnswer> {
        let mut boards = self.0.lock().unwrap();
        if boards.is_unplugged {
            return Err(NoAnswer::Gone("unplugged".into()));
        }
        let board = boards.boards.get_mut(&request.server());
        let board = board.ok_or(NoAnswer::Silent)?;
        let mut trick: Trick = Box::new(|_, _| Fate::Answered);
        Ok(answer(board, &mut trick, request.bytes()).1)
    }
}
