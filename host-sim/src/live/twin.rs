//! The twin of a board: the same program on this PC. A board tells its points only; the twin shows which rungs they
//! energise.

use super::{Flow, Probe};
use crate::engine::Machine;
use unoclp_core::{Inputs, Millis, Snapshot};

/// A program that does what a board does with it.
pub struct Twin {
    machine: Machine,
    /// The same, to see its values on the way.
    probe: Option<Probe>,
    /// How many instructions it has.
    steps: usize,
}

impl Twin {
    /// The twin of a board that runs this program; `probe` sees the values on the way.
    pub fn new(machine: Machine, probe: Option<Probe>) -> Twin {
        Twin {
            steps: machine.plc().steps().count(),
            machine,
            probe,
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
        let mut flow = Flow::default();
        // Before the scan they stand as the board has told them.
        flow.look(self.machine.plc(), now);
        flow.acc = vec![None; self.steps];
        let observe = |step: usize, on| {
            if let Some(acc) = flow.acc.get_mut(step) {
                *acc = Some(on);
            }
        };
        // A scan with too many jumps shows how far it has come.
        let _ = self.machine.scan_observed(inputs, now, observe);
        if let Some(probe) = &mut self.probe {
            probe.with_plc(|plc| plc.adopt(board, now));
            flow.values = probe.scan(inputs, now);
        }
        flow
    }
}
