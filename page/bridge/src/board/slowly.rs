//! The core in slow motion: a scan that is under way while the page's time stands.
//!
//! Owns where such a scan stops, and that it ends before the next begins. Must not know what a page shows of it.

use super::core::{Core, State};
use super::under_way::Slow;
use crate::machine::Machine;
use crate::slow::Stood;
use crate::words::{self, Both, both};
use unoclp_core::isa::Opcode;
use unoclp_exercise::live::Flow;

/// Scans that are made for one ask at most.
const MOST: u32 = 200;

impl Core {
    /// Goes on with its scan to where one of these instructions comes next, or any; `through` the ends of scans, 1 ms each,
    /// or else to the end of this one. None where it has not come there yet.
    ///
    /// # Errors
    /// Where it runs no program.
    pub fn slowly(
        &mut self,
        to: Option<&[usize]>,
        through: bool,
        machine: &mut Option<Machine>,
    ) -> Result<Option<Stood>, Both> {
        for _ in 0..MOST {
            if self.state() != State::Run {
                return Err(both(words::none_runs));
            }
            let mut slow = match self.slow.take() {
                Some(slow) => slow,
                None => {
                    let slow = self.begin_slowly().ok_or_else(|| both(words::none_runs))?;
                    if slow.stops(to) {
                        return Ok(Some(self.keep(slow)));
                    }
                    slow
                }
            };
            loop {
                let stepped = self.with_plc(|plc| plc.step(&mut slow.scan));
                match stepped {
                    Some(Ok(Some((step, after)))) => {
                        slow.flow.observe(step, after);
                        if slow.stops(to) {
                            return Ok(Some(self.keep(slow)));
                        }
                    }
                    Some(Ok(None)) => break,
                    Some(Err(fault)) => {
                        self.fail(fault);
                        return Ok(Some(self.stood(&slow, true)));
                    }
                    None => return Err(both(words::none_runs)),
                }
            }
            self.end_slowly(&mut slow);
            let stood = self.stood(&slow, true);
            self.go_by(machine);
            if !through {
                return Ok(Some(stood));
            }
        }
        Ok(None)
    }

    /// Ends the scan that is under way, if there is one; says whether there was.
    pub(super) fn finish(&mut self) -> bool {
        let Some(mut slow) = self.slow.take() else {
            return false;
        };
        loop {
            match self.with_plc(|plc| plc.step(&mut slow.scan)) {
                Some(Ok(Some((step, after)))) => slow.flow.observe(step, after),
                Some(Err(fault)) => {
                    self.fail(fault);
                    return true;
                }
                _ => break,
            }
        }
        self.end_slowly(&mut slow);
        true
    }

    fn keep(&mut self, slow: Slow) -> Stood {
        let stood = self.stood(&slow, false);
        self.slow = Some(slow);
        stood
    }

    fn begin_slowly(&mut self) -> Option<Slow> {
        let (inputs, now) = (self.read(), self.now());
        self.with_plc(|plc| {
            let mut flow = Flow::new(plc.steps().count());
            flow.look(plc, now);
            Slow {
                scan: plc.begin(inputs, now),
                flow,
                inputs,
                heads: plc
                    .steps()
                    .map(|step| step.opcode == Opcode::NewRung)
                    .collect(),
                driven: plc.outputs().0 as u32,
            }
        })
    }

    fn end_slowly(&mut self, slow: &mut Slow) {
        let image = self.with_plc(|plc| {
            slow.flow.end(plc);
            plc.outputs()
        });
        if let Some(image) = image {
            self.take(slow.flow.clone(), image);
        }
    }

    fn stood(&mut self, slow: &Slow, is_over: bool) -> Stood {
        let image = self.with_plc(|plc| plc.outputs()).unwrap_or_default();
        let found = slow.scan.found();
        let step = slow.scan.next();
        Stood {
            step: (!is_over).then_some(step),
            until: step + 1,
            acc: found.acc,
            value: found.value,
            pushed: slow.scan.pushed().to_vec(),
            inputs: slow.inputs.points.0 as u32,
            closed: self.closed().0 as u32,
            outputs: image.0 as u32,
            driven: if is_over { image.0 as u32 } else { slow.driven },
            live: self.show(&slow.flow),
        }
    }
}
