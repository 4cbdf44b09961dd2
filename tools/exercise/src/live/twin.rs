//! The twin of a board: the same program on this PC. A board tells its points only; the twin shows which rungs they
//! energise.

use super::Flow;
use unoclp_core::{Inputs, Millis, Snapshot};
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

    /// The program as it stands behind the last flow.
    pub fn machine(&self) -> &Machine {
        &self.machine
    }

    /// What the program does on the board at the moment: a scan from what was read. Edges are those from reading
    /// to reading.
    pub fn flow(&mut self, board: &Snapshot<'_>, inputs: Inputs, now: Millis) -> Flow {
        self.machine.adopt(board, now);
        let mut flow = Flow::new(self.steps);
        // Before the scan they stand as the board has told them.
        flow.look(self.machine.plc(), now);
        // A scan with too many jumps shows how far it has come.
        let _ = self
            .machine
            .scan_observed(inputs, now, |step, after| flow.observe(step, after));
        flow.end(self.machine.plc());
        flow
    }
}
