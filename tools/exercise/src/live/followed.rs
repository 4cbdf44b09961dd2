//! A scan that is followed instruction by instruction, and may stand between two of them.

use super::Flow;
use unoclp_core::{Fault, Inputs, Millis, Plc, Scan};

/// A scan that is under way, and what it has done until now.
#[derive(Clone, Debug)]
pub struct Followed {
    scan: Scan,
    flow: Flow,
    inputs: Inputs,
    now: Millis,
}

impl Followed {
    /// Begins a scan on these inputs with this time stamp.
    pub fn begin(plc: &mut Plc<'_>, inputs: Inputs, now: Millis) -> Followed {
        let mut flow = Flow::new(plc.steps().count());
        flow.look(plc, now);
        Followed {
            scan: plc.begin(inputs, now),
            flow,
            inputs,
            now,
        }
    }

    /// Goes on by one instruction at least, to where `stops` says that it stops before one. Says whether the scan is over.
    ///
    /// # Errors
    /// Where it has made too many jumps back.
    pub fn go(&mut self, plc: &mut Plc<'_>, stops: impl Fn(usize) -> bool) -> Result<bool, Fault> {
        while let Some((step, after)) = plc.step(&mut self.scan)? {
            self.flow.observe(step, after);
            if stops(self.scan.next()) {
                return Ok(false);
            }
        }
        self.flow.end(plc);
        Ok(true)
    }

    /// Where it stands.
    pub fn scan(&self) -> &Scan {
        &self.scan
    }

    /// What it has done.
    pub fn flow(&self) -> &Flow {
        &self.flow
    }

    /// What it runs on.
    pub fn inputs(&self) -> &Inputs {
        &self.inputs
    }

    /// Its time stamp.
    pub fn now(&self) -> Millis {
        self.now
    }
}
