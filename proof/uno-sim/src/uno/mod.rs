//! The board: an ATmega328P at 16 MHz with eight inputs, four outputs, the LED L, a card slot and a serial line.

mod around;
mod inside;
mod power;
mod serial;

use crate::avr::{Avr, CLOCK_HZ, Cpu, Far, Irq, Leave, reg};
use crate::chip::Chip;
use crate::pins::{Edge, Levels, Registers};
use crate::program::Program;
use crate::sd::SdCard;
use crate::stack::StackWatch;
use crate::wiring::Wired;
use crate::{Error, Halt};
use std::path::Path;

/// Cycles of one millisecond at 16 MHz.
pub const CYCLES_PER_MS: u64 = CLOCK_HZ as u64 / 1000;

/// Bits of WDTCSR, WDE and WDIE: the watchdog is on.
const WATCHDOG_ON: u8 = 1 << 3 | 1 << 6;

/// An instruction that jumps to itself (`rjmp .-2`), as it lies in flash: for [`Uno::patch_flash`].
pub const STALL: [u8; 2] = [0xFF, 0xCF];

/// What is in the card slot.
#[derive(Clone, Debug)]
#[expect(clippy::large_enum_variant, reason = "there is one of them per board")]
pub enum Slot {
    /// Nothing: MISO stays high.
    Empty,
    /// A card, powered together with the board.
    Card(SdCard),
}

/// A simulated UNO, or a Mega where its program is for one. Times are cycles since it was made, 62.5 ns each; they go on through a reset and a power cut.
pub struct Uno {
    // The chip before the wiring: it is dropped first, and knows the wiring's address.
    avr: Avr,
    wired: Wired,
    program: Program,
    code_end: u32,
    /// The pins of inputs, by their port and bit.
    irqs: Vec<(u8, u8, Irq)>,
    boot_loader: bool,
    pin_registers: Registers,
    levels: Levels,
    edges: Vec<Edge>,
    stack: StackWatch,
    power_ups: u32,
    resets: u32,
    halt: Option<Halt>,
}

impl Uno {
    /// A board with the program of an ELF file, just powered, before its first instruction. All buttons are open. RAM
    /// and working registers hold arbitrary values, the same each time, as a chip promises nothing better.
    ///
    /// # Errors
    /// Where the ELF file is not a program for this chip.
    pub fn new(elf: &Path, slot: Slot) -> Result<Uno, Error> {
        Uno::with_program(Program::read(elf)?, slot)
    }

    /// The same with a program that has been read already, which is quicker for many boards.
    ///
    /// # Errors
    /// Where simavr cannot simulate the chip.
    pub fn with_program(program: Program, slot: Slot) -> Result<Uno, Error> {
        let mut avr = Avr::of(program.chip, program.flash_len)?;
        avr.load_flash(&program.flash);
        avr.set_start(program.start);
        power::scramble(avr.data_mut(), program.chip, 0);
        let mut wired = Wired::new(&mut avr, slot)?;
        wired.eeprom.bytes_mut()[..program.eeprom.len()].copy_from_slice(&program.eeprom);
        let chip = program.chip;
        let mut irqs = Vec::new();
        for (port, _, _) in chip.input_ports(&wired.inputs) {
            for pin in chip.input_pins(port) {
                let irq = avr.irq([b'i', b'o', b'g', port], pin.into())?;
                irqs.push((port, pin, irq));
            }
        }
        Ok(Uno {
            irqs,
            code_end: program.flash.len() as u32,
            stack: StackWatch::new(&avr),
            pin_registers: Registers::of(&avr),
            levels: Levels::default(),
            edges: Vec::new(),
            boot_loader: false,
            power_ups: 0,
            resets: 0,
            halt: None,
            avr,
            wired,
            program,
        })
    }

    /// Executes one instruction, with the interrupts that are due after it.
    ///
    /// # Errors
    /// Where the program has come to an end of its own, now or before; never [`Halt::Timeout`].
    pub fn step(&mut self) -> Result<(), Halt> {
        self.check_halt()?;
        self.wired.leave = Leave::default();
        self.advance();
        self.check_halt()
    }

    /// Runs for at least `cycles` cycles: to the end of the instruction in which they are over.
    ///
    /// # Errors
    /// See [`Uno::step`].
    pub fn run_cycles(&mut self, cycles: u64) -> Result<(), Halt> {
        self.check_halt()?;
        let end = self.cycles().saturating_add(cycles);
        self.wired.leave = Leave { end, stop: None };
        loop {
            self.hurry(end, None);
            if self.cycles() >= end || !self.advance() {
                return self.check_halt();
            }
        }
    }

    /// Runs for at least `ms` milliseconds; see [`Uno::run_cycles`].
    ///
    /// # Errors
    /// See [`Uno::step`].
    pub fn run_ms(&mut self, ms: u64) -> Result<(), Halt> {
        self.run_cycles(ms.saturating_mul(CYCLES_PER_MS))
    }

    /// Runs until the instruction at byte address `pc` is the next one. At least one instruction is executed, so that
    /// the same call again goes once round a loop.
    ///
    /// # Errors
    /// [`Halt::Timeout`] where that takes more than `max_cycles` cycles; else see [`Uno::step`].
    pub fn run_until(&mut self, pc: u32, max_cycles: u64) -> Result<(), Halt> {
        self.check_halt()?;
        let end = self.cycles().saturating_add(max_cycles);
        self.wired.leave = Leave {
            end,
            stop: Some(pc),
        };
        loop {
            let is_there = self.hurry(end.saturating_add(1), Some(pc)) && self.is_over(pc, end);
            let goes_on = is_there || self.advance();
            if !goes_on {
                return self.check_halt();
            }
            if self.avr.pc() == pc {
                return Ok(());
            }
            if self.cycles() > end {
                let place = self.program.place(self.avr.pc());
                return Err(Halt::Timeout {
                    cycles: max_cycles,
                    place,
                });
            }
        }
    }

    /// The chip of the board.
    pub fn chip(&self) -> Chip {
        self.program.chip
    }

    /// Cycles since the board was made.
    #[inline]
    pub fn cycles(&self) -> u64 {
        self.wired.cycles_before + self.avr.cycle()
    }

    /// Byte address of the next instruction.
    pub fn pc(&self) -> u32 {
        self.avr.pc()
    }

    /// Resets since power-up, by the button or the watchdog.
    pub fn resets(&self) -> u32 {
        self.resets
    }

    /// Executes what is quick, up to this cycle or to this address; says whether that was anything.
    #[inline]
    fn hurry(&mut self, end: u64, stop: Option<u32>) -> bool {
        if self.stack.is_between() {
            return false;
        }
        let far = Far {
            end: end.saturating_sub(self.wired.cycles_before),
            stop,
            code_end: self.code_end,
        };
        let low = self.avr.run_quickly(far);
        if let Some(low) = low {
            self.stack.reached(low);
        }
        low.is_some()
    }

    fn is_over(&self, pc: u32, end: u64) -> bool {
        self.avr.pc() == pc || self.cycles() > end
    }

    /// One instruction, and all that is watched; false where the program has come to an end, which `halt` then tells.
    #[inline(always)]
    fn advance(&mut self) -> bool {
        let (pc, cycle) = (self.avr.pc(), self.avr.cycle());
        let cpu = self.avr.step();
        let next = self.avr.pc();
        if self.avr.cycle() < cycle {
            // The watchdog has reset the chip, and simavr counts again.
            self.wired.cycles_before += cycle;
            self.settle_after_reset();
            if self.wired.power_cut {
                self.lose_power();
                return false;
            }
        }
        self.stack.watch(&self.avr, pc);
        self.watch_pins();
        if cpu != Cpu::Alive || next == pc || next >= self.code_end {
            self.look_closer(cpu, pc, next);
            return self.halt.is_none();
        }
        true
    }

    fn check_halt(&self) -> Result<(), Halt> {
        match &self.halt {
            Some(halt) => Err(halt.clone()),
            None => Ok(()),
        }
    }

    #[inline(always)]
    fn watch_pins(&mut self) {
        let registers = Registers::of(&self.avr);
        if registers != self.pin_registers {
            self.pin_registers = registers;
            self.record_pins(registers.levels());
        }
    }

    #[cold]
    fn record_pins(&mut self, levels: Levels) {
        let cycle = self.cycles();
        self.edges.extend(self.levels.edges_to(levels, cycle));
        if levels.card_selected != self.levels.card_selected {
            self.wired.select_card(levels.card_selected);
        }
        self.levels = levels;
    }

    /// The last instruction, at `pc`, was no ordinary one: has the program ended?
    #[cold]
    fn look_closer(&mut self, cpu: Cpu, pc: u32, next: u32) {
        let watchdog_on = self.avr.register(reg::WDTCSR) & WATCHDOG_ON != 0;
        let waits = cpu == Cpu::Alive && next < self.code_end;
        // A write to the EEPROM goes on though the program does not; the power may go with it.
        let writes = self.wired.eeprom.is_busy();
        if waits && (self.avr.interrupts_on() || watchdog_on || writes) {
            let leave = self.wired.chips_leave();
            self.avr.pass_standing(leave);
            return;
        }
        if self.wired.power_cut {
            return self.lose_power();
        }
        let place = self.program.place(pc);
        self.halt = Some(match (cpu, self.wired.bad_opcode) {
            (Cpu::Done, _) => Halt::AsleepForEver { place },
            (Cpu::Crashed, Some(opcode)) => Halt::InvalidOpcode { opcode, place },
            (Cpu::Alive, _) if waits => Halt::Hung { place },
            (Cpu::Crashed | Cpu::Alive, _) => Halt::LeftCode { place },
        });
    }
}

impl std::fmt::Debug for Uno {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Uno")
            .field("cycles", &self.cycles())
            .field("at", &self.program.place(self.pc()))
            .field("inputs", &self.inputs())
            .field("outputs", &self.outputs())
            .field("halt", &self.halt)
            .finish_non_exhaustive()
    }
}
