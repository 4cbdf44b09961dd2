//! Where a program is stored while it loads, and what it takes of program and run memory (NC-10).

use crate::held::Held;
use crate::isa::{self, Entry, Kind, Line, Opcode};
use crate::kept;
use crate::needs::Needs;
use crate::{Board, Cause, Program};
use core::mem;

/// Of [`Room::behind`] where so many contacts stand in a row, or more; 0 where nothing does that counts.
const CONTACTS: u8 = 3;
/// A coil of an output.
const COIL: u8 = 4;
/// A rung has just begun.
const RUNG: u8 = 5;

/// What is noted from here on: the code of each timer. Before it the lines of the IFs that are open.
const KINDS: u8 = isa::DEEPEST;
/// How long ago the code was put of a timer whose preset was put last.
const PRESET_BEFORE: usize = 5;

/// The memory of a program that is being loaded.
pub(super) struct Room<'m> {
    memory: &'m mut [u8],
    /// The board that it checks for.
    pub(super) held: Held,
    /// Bytes of the stored form that are reserved, and that have been put.
    reserved: usize,
    put: usize,
    /// Bytes of run memory that are reserved, apart from those of counters and registers.
    run_reserved: usize,
    /// What there is of both.
    stored_most: usize,
    run_most: usize,
    timers: u8,
    /// The highest counter that is named, and the highest register.
    counters: u8,
    registers: u8,
    /// What the code before has left behind in the linked form.
    behind: u8,
    /// How many numbers are kept.
    kept: u8,
    /// Whether something did not fit; what follows is checked, and no longer stored.
    full: bool,
}

impl<'m> Room<'m> {
    pub(super) fn new(memory: &'m mut [u8], board: Board) -> Room<'m> {
        let run_most = memory.len().min(board.linked_bytes.into());
        Room {
            memory,
            held: Held::new(board),
            reserved: 0,
            put: 0,
            run_reserved: 0,
            stored_most: board.stored_bytes.into(),
            run_most,
            timers: 0,
            counters: 0,
            registers: board.engine.near_registers,
            behind: RUNG,
            kept: 0,
            full: false,
        }
    }

    /// Stores an instruction up to its operand lines, and reserves the room of the whole, but for what
    /// its lines will tell. A jump's line is stored with it.
    pub(super) fn instruction(&mut self, entry: &Entry, xx: u8, line: u16) -> Result<(), Cause> {
        let Entry {
            kind, stored, run, ..
        } = *entry;
        let (mut bytes, mut run) = (1, run);
        let holds_point = isa::holds_number(stored, xx);
        if kind.has_number() && !holds_point {
            bytes += 1;
        }
        if !kind.is_value() {
            bytes += entry.line_bytes;
        }
        // A match that tells all kinds apart would take 50 bytes more of the firmware.
        if kind == Kind::Timer {
            self.timers = self.timers.saturating_add(1);
        } else if kind.is_value() {
            bytes += isa::constant_bytes(xx);
            run += self.held.board().engine.operand_bytes(xx);
        }
        if matches!(kind, Kind::Counter | Kind::Count) && xx > self.counters {
            self.counters = xx;
        }
        let near = self.held.near_registers();
        if kind.names_registers() && xx <= isa::REGISTERS {
            if stored == Opcode::Store as u8 && xx > near {
                run += 2;
            }
            self.register(xx);
        }
        run = self.linked(kind, stored, xx, run);
        if kept::declares(stored) {
            bytes += kept::ring_bytes(self.kept == 1);
        }
        self.reserve(bytes, run)?;
        if holds_point {
            self.put(stored | xx.wrapping_sub(1));
            return Ok(());
        }
        self.put(isa::far_row(stored));
        if kind.has_number() {
            self.put(xx);
        }
        if kind == Kind::Jump {
            let [low, high] = line.to_le_bytes();
            self.put(low);
            self.put(high);
        }
        Ok(())
    }

    /// How much of these bytes of run memory an instruction takes, by what stands before it: the rules of the firmware's
    /// linker.
    fn linked(&mut self, kind: Kind, stored: u8, xx: u8, run: u8) -> u8 {
        let engine = self.held.board().engine;
        let before = mem::replace(&mut self.behind, 0);
        if !engine.links {
            return run;
        }
        let begins = stored >= Opcode::If as u8 || stored == Opcode::NewRung as u8;
        if begins || kind == Kind::Label {
            self.behind = RUNG;
            let rung = stored == Opcode::NewRung as u8 || stored == Opcode::Else as u8;
            return if rung && before >= COIL { run - 1 } else { run };
        }
        // The UNO has no such outputs.
        #[cfg(any(not(target_arch = "avr"), mega))]
        if kind == Kind::Output && xx > engine.fast_outputs {
            return run + 1;
        }
        if (isa::FIRST_POINT..Opcode::Coil as u8).contains(&stored) {
            if kind == Kind::Input && xx > engine.fast_inputs {
                return run + 1;
            }
            self.behind = match before {
                ..CONTACTS => before + 1,
                CONTACTS => CONTACTS,
                _ => 1,
            };
            return if before == CONTACTS { 0 } else { run };
        }
        if stored == Opcode::Coil as u8 {
            self.behind = COIL;
        } else if kind == Kind::Time || kept::declares(stored) {
            self.behind = before;
        }
        run
    }

    /// A register that is named; its room is taken with what is reserved next.
    pub(super) fn register(&mut self, register: u8) {
        self.registers = self.registers.max(register);
    }

    /// What a timer drives, as it is stored; or which one is called again: one that stands before, of the same kind.
    pub(super) fn target(&mut self, stored: u8) -> Result<(), Cause> {
        let engine = self.held.board().engine;
        if stored < engine.fast_outputs {
            self.behind = COIL;
        }
        let last = self.timers.wrapping_sub(1);
        // Where something did not fit, no kind is known.
        let kind = self.before(PRESET_BEFORE).unwrap_or(0);
        if stored < isa::TIMER_TARGET {
            self.note(KINDS.saturating_add(last), kind.into());
        } else {
            self.timers = last;
            let timer = stored - isa::TIMER_TARGET;
            let is_known = timer < last && timer < isa::CALLED_AGAIN;
            if kind != 0 && !(is_known && self.noted(KINDS + timer) == kind.into()) {
                return Err(Cause::NoSuchTimer);
            }
        }
        self.reserve(0, engine.line_bytes(Line::Target, stored))
    }

    /// The constant after the code that was put last takes so many bytes as this XX says.
    pub(super) fn constant(&mut self, xx: u8) -> Result<(), Cause> {
        if let (false, Some(last)) = (self.full, self.memory.get_mut(self.put.wrapping_sub(1))) {
            *last = xx;
        }
        let more = isa::constant_bytes(xx).saturating_sub(1);
        self.reserve(more, self.linked_only(more))
    }

    /// So many bytes, where the board links; none where run memory holds data alone.
    pub(super) fn linked_only(&self, run: u8) -> u8 {
        match self.held.board().engine.links {
            true => run,
            false => 0,
        }
    }

    /// Notes a line where no stored byte comes, at the end of the memory.
    pub(super) fn note(&mut self, index: u8, line: u16) {
        if let Some([low, high]) = self.noted_at(index) {
            [*low, *high] = line.to_le_bytes();
        }
    }

    /// The line that was noted.
    pub(super) fn noted(&mut self, index: u8) -> u16 {
        self.noted_at(index)
            .map_or(0, |line| u16::from_le_bytes(*line))
    }

    fn noted_at(&mut self, index: u8) -> Option<&mut [u8; 2]> {
        let (_, free) = self.memory.split_at_mut_checked(self.stored_most)?;
        free.as_chunks_mut().0.get_mut(usize::from(index))
    }

    /// Another number is kept: before it stand no other codes (NC-21).
    pub(super) fn keep(&mut self) -> Result<(), Cause> {
        if self.full {
            return Ok(());
        }
        if self.kept == kept::KEPT || self.put != 2 * usize::from(self.kept) {
            return Err(Cause::CannotKeep);
        }
        self.kept += 1;
        Ok(())
    }

    /// Reserves so many bytes more of the stored form and of run memory.
    pub(super) fn reserve(&mut self, stored: u8, run: u8) -> Result<(), Cause> {
        // Counted beyond what fits too: a tool tells how much is lacking.
        self.reserved = self.reserved.wrapping_add(stored.into());
        self.run_reserved = self.run_reserved.wrapping_add(run.into());
        if self.full {
            return Ok(());
        }
        self.full = true;
        if self.reserved > self.stored_most {
            return Err(Cause::ProgramFull);
        }
        // Both forms stand in run memory, one after the other.
        if self.run_bytes() > self.run_most || self.reserved > self.run_most {
            return Err(Cause::RunMemoryFull);
        }
        self.full = false;
        Ok(())
    }

    /// Bytes of run memory for what has been reserved, with counters and registers up to the highest.
    fn run_bytes(&self) -> usize {
        let registers = usize::from(self.registers - self.held.near_registers());
        self.run_reserved
            .wrapping_add(isa::COUNTER_DATA * usize::from(self.counters))
            .wrapping_add(isa::REGISTER_BYTES * registers)
    }

    /// Bytes of program memory and of run memory that the program would need beyond what there is.
    pub(super) fn lacking(&self) -> [usize; 2] {
        [
            self.reserved
                .saturating_sub(self.stored_most.min(self.run_most)),
            self.run_bytes().saturating_sub(self.run_most),
        ]
    }

    /// Puts a byte where room has been reserved for it.
    pub(super) fn put(&mut self, byte: u8) {
        if self.full {
            return;
        }
        if let Some(place) = self.memory.get_mut(self.put) {
            *place = byte;
            self.put += 1;
        }
    }

    /// The byte that was put so many ago, 1 the last; none where something did not fit.
    pub(super) fn before(&self, ago: usize) -> Option<u8> {
        if self.full {
            return None;
        }
        self.memory.get(self.put.wrapping_sub(ago)).copied()
    }

    pub(super) fn timers(&self) -> u8 {
        self.timers
    }

    /// The stored form so far; empty where something did not fit.
    pub(super) fn stored(&self) -> &[u8] {
        if self.full {
            return &[];
        }
        self.memory.get(..self.put).unwrap_or_default()
    }

    /// The program that the room holds: that of a loader that is done. Its memory is none from then on.
    pub(super) fn program(&mut self, codes: u16, needs: Needs) -> Program<'m> {
        Program {
            held: self.held,
            memory: mem::take(&mut self.memory),
            code_bytes: self.put,
            run_bytes: self.run_bytes(),
            timers: self.timers,
            counters: self.counters,
            registers: self.registers,
            kept: self.kept,
            codes,
            needs,
        }
    }
}
