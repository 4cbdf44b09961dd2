//! The program file that the board should run: what a board does not tell of it.

use crate::panel::Drawn;
use crate::variables::Variables;
use std::collections::BTreeMap;
use unoclp_client::diagnostics::{Kept, Trouble};
use unoclp_client::watch::{Reading, Scope};
use unoclp_core::{Delay, Fault};
use unoclp_exercise::live::{Flow, Twin};
use unoclp_host_sim::engine::Machine;
use unoclp_point::Address;
use unoclp_program::used::Used;
use unoclp_workspace::Ready;

/// A program, to show a board's timers, counters and rungs by.
pub struct Program {
    program: Ready,
    /// How a board keeps it.
    pub(super) kept: Kept,
    pub(super) drawn: Drawn,
    /// What each timer does.
    pub(super) timers: Vec<Delay>,
    counters: u16,
    registers: u16,
    /// Does what the board does, to show which of its rungs are energised: a board tells its points only.
    twin: Twin,
    /// The outputs that it writes, bit 0 output 01.
    pub(super) written: u32,
    /// Its variables, if its language declares them.
    pub(super) variables: Variables,
}

impl Program {
    /// A program whose text is known.
    ///
    /// # Errors
    /// None that the program did not have before.
    pub fn new(program: Ready) -> Result<Program, Fault> {
        let kept = Kept::of(program.program());
        let registers = program.program().registers() as u16;
        let drawn = Drawn::new(&program);
        let machine = Machine::new(program.checked.copy()?);
        let plc = machine.plc();
        let used = &program.size.used;
        let outputs = used.outputs.iter().chain(&used.pwm);
        let written = outputs.fold(0, |bits, output| bits | 1 << (output - 1));
        Ok(Program {
            written,
            variables: Variables::new(&program.variables),
            kept,
            drawn,
            timers: plc
                .steps()
                .filter_map(|step| Delay::of(step.opcode))
                .collect(),
            counters: plc.counters().count() as u16,
            registers,
            twin: Twin::new(machine),
            program,
        })
    }

    /// What it is called.
    pub(super) fn name(&self) -> &str {
        &self.program.name
    }

    /// What it calls its points.
    pub(super) fn names(&self) -> &BTreeMap<String, String> {
        self.program.symbols()
    }

    /// What it uses of the board.
    pub(super) fn used(&self) -> &Used {
        &self.program.size.used
    }

    /// What the program does on the board at the moment: a scan from what was read. Edges are those from reading
    /// to reading.
    pub(super) fn flow(&mut self, reading: &Reading) -> Flow {
        reading.with_snapshot(|board, inputs, now| self.twin.flow(board, inputs, now))
    }

    /// A fault of this program as it runs, in the line of its text in place of that of its code. Other faults
    /// are those of a file that the board has refused.
    pub(super) fn in_text(&self, trouble: Trouble) -> Trouble {
        if !trouble.is_of_the_run() {
            return trouble;
        }
        let place = trouble.line.and_then(|line| self.program.map.of_code(line));
        let line = place.map_or(trouble.line, |place| Some(place.line as u32));
        Trouble { line, ..trouble }
    }

    /// Where a fault of this program stands, if [`in_text`](Program::in_text) has given it a line: `lamp.il:12: JMPC loop`.
    pub(super) fn stands(&self, trouble: Trouble) -> Option<String> {
        let line = trouble.line.filter(|_| trouble.is_of_the_run())?;
        let text = self
            .program
            .text
            .lines()
            .nth((line as usize).checked_sub(1)?)?;
        Some(format!("{}:{line}: {}", self.name(), text.trim()))
    }

    /// How much of a board there is to read for it.
    pub fn scope(&self) -> Scope {
        Scope {
            timers: self.timers.len() as u16,
            counters: self.counters,
            registers: self.registers,
        }
    }
}

/// What a board has at this point, as far as the reading tells.
pub(super) fn read(reading: &Reading, point: Address) -> Option<i32> {
    let at = |number: u8| usize::from(number).checked_sub(1);
    let bit = |bits: u64, number: u8| Some((bits >> at(number)? & 1) as i32);
    let timer = |number: u8| reading.timers.get(at(number)?);
    let counter = |number: u8| reading.counters.get(at(number)?);
    match point {
        Address::Input(n) => bit(reading.inputs.into(), n),
        Address::Output(n) => bit(reading.outputs.into(), n),
        Address::Marker(n) => bit(reading.markers?, n),
        Address::Elapsed(n) => Some(timer(n)?.value),
        Address::Reached(n) => counter(n).map(|meter| (meter.value >= meter.preset).into()),
        Address::AtZero(n) => Some((counter(n)?.value <= 0).into()),
        Address::Count(n) => Some(counter(n)?.value),
        Address::Register(n) => reading.registers.get(at(n)?).copied(),
        Address::Analogue(n) => reading.analogue.get(usize::from(n)).map(|&v| v.into()),
        // What a board does not tell.
        _ => None,
    }
}
