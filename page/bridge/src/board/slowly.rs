//! The core in slow motion: a scan that is under way while the page's time stands.
//!
//! Owns where such a scan stops, and that it ends before the next begins. Must not know what a page shows of it.

use super::core::{Core, State};
use super::under_way::Slow;
use crate::machine::Machine;
use crate::slow::Stood;
use crate::words::{self, Both, both};
use unoclp_core::isa::Opcode;
use unoclp_exercise::live::Followed;

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
                    if stops(&slow.heads, to, 0) {
                        return Ok(Some(self.keep(slow)));
                    }
                    slow
                }
            };
            let Slow {
                followed, heads, ..
            } = &mut slow;
            match self.with_plc(|plc| followed.go(plc, |next| stops(heads, to, next))) {
                Some(Ok(true)) => {}
                Some(Ok(false)) => return Ok(Some(self.keep(slow))),
                Some(Err(fault)) => {
                    self.fail(fault);
                    return Ok(Some(self.stood(&slow, true)));
                }
                None => return Err(both(words::none_runs)),
            }
            self.end_slowly(&slow);
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
        match self.with_plc(|plc| slow.followed.go(plc, |_| false)) {
            Some(Err(fault)) => self.fail(fault),
            _ => self.end_slowly(&slow),
        }
        true
    }

    fn keep(&mut self, slow: Slow) -> Stood {
        let stood = self.stood(&slow, false);
        self.slow = Some(slow);
        stood
    }

    fn begin_slowly(&mut self) -> Option<Slow> {
        let (inputs, now) = (self.read(), self.now());
        self.with_plc(|plc| Slow {
            followed: Followed::begin(plc, inputs, now),
            heads: plc
                .steps()
                .map(|step| step.opcode == Opcode::NewRung)
                .collect(),
            driven: plc.outputs().0 as u32,
        })
    }

    fn end_slowly(&mut self, slow: &Slow) {
        if let Some(image) = self.with_plc(|plc| plc.outputs()) {
            self.take(slow.followed.flow().clone(), image);
        }
    }

    fn stood(&mut self, slow: &Slow, is_over: bool) -> Stood {
        let image = self.with_plc(|plc| plc.outputs()).unwrap_or_default();
        let scan = slow.followed.scan();
        let found = scan.found();
        let step = scan.next();
        Stood {
            step: (!is_over).then_some(step),
            until: step + 1,
            acc: found.acc,
            value: found.value,
            pushed: scan.pushed().to_vec(),
            inputs: slow.followed.inputs().points.0 as u32,
            closed: self.closed().0 as u32,
            outputs: image.0 as u32,
            driven: if is_over { image.0 as u32 } else { slow.driven },
            live: self.show(slow.followed.flow()),
        }
    }
}

/// Whether one that goes to one of these instructions, or to any, stops before this one.
fn stops(heads: &[bool], to: Option<&[usize]>, next: usize) -> bool {
    match to {
        Some(to) => to.contains(&next),
        None => !heads.get(next).copied().unwrap_or_default(),
    }
}
