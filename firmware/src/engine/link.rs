//! From checked instructions to linked bytes.

use super::{POINTS, TIMER_BYTES};
use unoclp_core::isa::{self, Opcode};
use unoclp_core::{Linking, Program};

// SAFETY: these are the handlers of `handlers.s`. They are not called from here: only their
// addresses are used.
unsafe extern "C" {
    fn engine_contact();
    fn engine_contact_not();
    fn engine_contacts();
    fn engine_coil();
    fn engine_coil_new_rung();
    fn engine_set_coil();
    fn engine_reset_coil();
    fn engine_store_branch();
    fn engine_recall_branch();
    fn engine_open_branch();
    fn engine_close_branch();
    fn engine_new_rung();
    fn engine_on_delay();
    fn engine_off_delay();
    fn engine_end();
}

/// The byte for a handler: the word address, which lies below 256.
macro_rules! handler {
    ($name:ident) => {
        $name as *const () as usize as u8
    };
    // One of a row of handlers, each of so many words.
    ($name:ident, $words:literal, $index:expr) => {
        handler!($name) + $words * $index
    };
}

/// What has been read and not been put yet: it depends on what follows.
#[derive(Clone, Copy)]
enum Pending {
    /// Nothing, and acc is 1: a scan or a rung begins.
    Rung,
    /// A coil of this output.
    Coil(u8),
    /// So many contacts in a row, in any order: images that must be 1, and that must be 0.
    Contacts(u8, u8, u8),
    /// Nothing.
    Nothing,
}

struct Linker<'m> {
    program: Linking<'m>,
    pending: Pending,
    timers: usize,
}

/// Links a program in place; gives its code and the data of its timers.
///
/// The linked form is never longer than the stored form: a row of contacts is put as one only where
/// it has more than two of them. The end takes the byte behind it.
#[inline(never)]
pub fn link(program: Program<'_>) -> Option<(&[u8], &mut [u8])> {
    let mut linker = Linker {
        program: program.link(),
        pending: Pending::Rung,
        timers: 0,
    };
    while let Some(byte) = linker.program.next() {
        linker.take(byte)?;
    }
    linker.put(handler!(engine_end));
    let (code, rest) = linker.program.finish()?;
    Some((code, rest.get_mut(..linker.timers * TIMER_BYTES)?))
}

impl Linker<'_> {
    /// Takes the instruction that begins with this byte.
    // Apart from the loop: there, the address of each handler would have a register for itself.
    #[inline(never)]
    fn take(&mut self, byte: u8) -> Option<()> {
        let point = byte % POINTS;
        let branch = byte % isa::BRANCH_POINTS;
        let linked = match Opcode::of_stored(byte)? {
            Opcode::NewRung => {
                self.new_rung();
                return Some(());
            }
            Opcode::InputContact => return self.contact(point, true),
            Opcode::InputContactNot => return self.contact(point, false),
            Opcode::OutputContact => return self.contact(POINTS + point, true),
            Opcode::OutputContactNot => return self.contact(POINTS + point, false),
            Opcode::Coil => return self.coil(point),
            Opcode::OnDelay => return self.timer(handler!(engine_on_delay)),
            Opcode::OffDelay => return self.timer(handler!(engine_off_delay)),
            Opcode::SetCoil => handler!(engine_set_coil, 4, point),
            Opcode::ResetCoil => handler!(engine_reset_coil, 4, point),
            Opcode::StoreBranch => handler!(engine_store_branch, 3, branch),
            Opcode::RecallBranch => handler!(engine_recall_branch, 3, branch),
            Opcode::OpenBranch => handler!(engine_open_branch),
            Opcode::CloseBranch => handler!(engine_close_branch),
        };
        self.put(linked);
        Some(())
    }

    fn new_rung(&mut self) {
        match self.pending {
            Pending::Rung => {}
            Pending::Coil(output) => {
                self.program.put(handler!(engine_coil_new_rung, 4, output));
            }
            _ => self.put(handler!(engine_new_rung)),
        }
        self.pending = Pending::Rung;
    }

    /// A contact of the bit with this index in the images' register: of a 1, or of a 0.
    fn contact(&mut self, index: u8, one: bool) -> Option<()> {
        let (count, mut ones, mut zeros) = match self.pending {
            Pending::Contacts(count, ones, zeros) => (count, ones, zeros),
            _ => {
                self.flush();
                (0, 0, 0)
            }
        };
        let bit = 1 << index;
        if one {
            ones |= bit;
        } else {
            zeros |= bit;
        }
        self.pending = Pending::Contacts(count.saturating_add(1), ones, zeros);
        Some(())
    }

    fn coil(&mut self, output: u8) -> Option<()> {
        self.flush();
        self.pending = Pending::Coil(output);
        Some(())
    }

    fn timer(&mut self, handler: u8) -> Option<()> {
        self.put(handler);
        for _ in 0..4 {
            let byte = self.program.next()?;
            self.program.put(byte);
        }
        self.timers += 1;
        let output = self.program.next()?;
        self.coil(output % POINTS)
    }

    /// Puts a byte, after what is pending.
    fn put(&mut self, byte: u8) {
        self.flush();
        self.program.put(byte);
    }

    fn flush(&mut self) {
        match core::mem::replace(&mut self.pending, Pending::Nothing) {
            Pending::Rung | Pending::Nothing => {}
            Pending::Coil(output) => self.program.put(handler!(engine_coil, 3, output)),
            Pending::Contacts(count, ones, zeros) => self.contacts(count, ones, zeros),
        }
    }

    fn contacts(&mut self, count: u8, ones: u8, zeros: u8) {
        if count > 2 {
            self.program.put(handler!(engine_contacts));
            // A point that must be 1 and 0: what is asked for leaves it out, so it is never 1.
            self.program.put(ones ^ zeros);
            self.program.put(ones);
            return;
        }
        for image in 0..8 {
            if ones >> image & 1 != 0 {
                self.program.put(handler!(engine_contact, 4, image));
            }
            if zeros >> image & 1 != 0 {
                self.program.put(handler!(engine_contact_not, 4, image));
            }
        }
    }
}
