//! The PLC of `unoclp-core` on this PC.

use super::{Cell, Engine, Outcome, Refusal};
use self_cell::{MutBorrow, self_cell};
use std::convert::Infallible;
use unoclp_checked::Checked;
use unoclp_core::{After, Board, Fault, Image, Inputs, Millis, Plc, Snapshot};

self_cell!(
    /// A running program together with the checked one, whose memory a [`Plc`] only borrows.
    struct Owned {
        owner: MutBorrow<Checked>,
        #[covariant]
        dependent: Plc,
    }
);

/// A program that runs on this PC, in run memory of its own.
pub struct Machine(Owned);

impl Machine {
    /// A program that is ready to run.
    pub fn new(program: Checked) -> Machine {
        let program = MutBorrow::new(program);
        Machine(Owned::new(program, |program| {
            Plc::new(program.borrow_mut().lend())
        }))
    }

    /// The PLC, to look at.
    pub fn plc(&self) -> &Plc<'_> {
        self.0.borrow_dependent()
    }

    /// The PLC, to set something in it between two scans.
    pub fn with_plc<T>(&mut self, with: impl FnOnce(&mut Plc<'_>) -> T) -> T {
        self.0.with_dependent_mut(|_, plc| with(plc))
    }

    /// What a cell holds.
    pub fn look(&self, cell: Cell) -> i32 {
        let plc = self.plc();
        match cell {
            Cell::Marker(number) => (plc.markers() >> number.saturating_sub(1) & 1) as i32,
            Cell::Register(number) => {
                let index = usize::from(number).wrapping_sub(1);
                plc.registers().get(index).copied().unwrap_or_default()
            }
        }
    }

    /// Takes over what a board tells; see [`Plc::adopt`].
    pub fn adopt(&mut self, board: &Snapshot<'_>, now: Millis) {
        self.with_plc(|plc| plc.adopt(board, now));
    }

    /// One scan; see [`Plc::scan_observed`].
    pub fn scan_observed(
        &mut self,
        inputs: Inputs,
        now: Millis,
        observe: impl FnMut(usize, After),
    ) -> Result<Image, Fault> {
        self.0
            .with_dependent_mut(|_, plc| plc.scan_observed(inputs, now, observe))
    }
}

/// The core as an engine for scenarios. It cannot fail.
pub struct HostEngine {
    board: Board,
    machine: Option<Machine>,
}

impl HostEngine {
    /// An engine for programs of this board.
    pub fn new(board: Board) -> HostEngine {
        HostEngine {
            board,
            machine: None,
        }
    }

    /// Its PLC, to go through a scan of it; none where there is none.
    pub fn with_plc<T>(&mut self, with: impl FnOnce(&mut Plc<'_>) -> T) -> Option<T> {
        self.machine.as_mut().map(|machine| machine.with_plc(with))
    }

    /// The program that was loaded; none before that, and where it was refused.
    pub fn machine(&self) -> Option<&Machine> {
        self.machine.as_ref()
    }
}

impl Engine for HostEngine {
    type Error = Infallible;

    fn load(&mut self, file: &[u8]) -> Result<Result<(), Refusal>, Infallible> {
        self.machine = None;
        Ok(match Checked::read(file, self.board) {
            Ok(program) => {
                self.machine = Some(Machine::new(program));
                Ok(())
            }
            Err(fault) => Err(fault.into()),
        })
    }

    /// Without a program all outputs are 0 (NC-7).
    fn scan(&mut self, inputs: &Inputs, now: Millis) -> Result<Outcome, Infallible> {
        Ok(match &mut self.machine {
            Some(machine) => machine
                .scan_observed(*inputs, now, |_, _| ())
                .map_err(Refusal::from),
            None => Ok(Image::default()),
        })
    }

    fn restart(&mut self) -> Result<(), Infallible> {
        if let Some(machine) = &mut self.machine {
            machine.with_plc(|plc| plc.restart());
        }
        Ok(())
    }

    fn look(&mut self, cell: Cell) -> Result<i32, Infallible> {
        let machine = self.machine.as_ref();
        Ok(machine.map_or(0, |machine| machine.look(cell)))
    }

    fn poke(&mut self, cell: Cell, value: i32) -> Result<(), Infallible> {
        if let Some(machine) = &mut self.machine {
            machine.with_plc(|plc| match cell {
                Cell::Marker(number) => plc.set_marker(number, value != 0),
                Cell::Register(number) => plc.set_register(number, value),
            });
        }
        Ok(())
    }

    fn pwm(&mut self, output: u8) -> Result<u8, Infallible> {
        let machine = self.machine.as_ref();
        Ok(machine.map_or(0, |machine| machine.plc().pwm(output)))
    }
}
