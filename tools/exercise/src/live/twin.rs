//! The twin of a board: the same program on this PC. A board tells its points only; the twin shows which rungs they
//! energise.

use super::Flow;
use unoclp_core::{Fault, Image, Inputs, Millis, Snapshot};
use unoclp_host_sim::engine::Machine;

/// A program that does what a board does with it.
pub struct Twin {
    machine: Machine,
    /// How many instructions it has.
    steps: usize,
}

impl Twin {
    /// The twin of a board that runs this program.
    pub fn new(machine: Machine) -> Twin {
        Twin {
            steps: machine.plc().steps().count(),
            machine,
        }
    }

    /// The program as it stands after the last flow.
    pub fn machine(&self) -> &Machine {
        &self.machine
    }

    /// The same, to set something in it between two scans.
    pub fn machine_mut(&mut self) -> &mut Machine {
        &mut self.machine
    }

    /// What the program does on the board at the moment: a scan from what was read. Edges are those from reading
    /// to reading.
    pub fn flow(&mut self, board: &Snapshot<'_>, inputs: Inputs, now: Millis) -> Flow {
        self.machine.adopt(board, now);
        // A scan with too many jumps shows how far it has come.
        self.scan(inputs, now).0
    }

    /// A scan of the program as it stands: what it does, and what it ends in.
    pub fn scan(&mut self, inputs: Inputs, now: Millis) -> (Flow, Result<Image, Fault>) {
        let mut flow = Flow::new(self.steps);
        // Before the scan they stand as a board has told them.
        flow.look(self.machine.plc(), now);
        let outcome = self
            .machine
            .scan_observed(inputs, now, |step, after| flow.observe(step, after));
        flow.end(self.machine.plc());
        (flow, outcome)
    }
}
