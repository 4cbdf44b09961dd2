//! Where the scan may go: parts of IF, jumps and loops, as Structured Text nests them.
//!
//! Owns which steps a part or a loop holds, and which jumps are no more than an IF. Must not know expressions.

use super::why::Why;
use std::collections::HashMap;
use unoclp_core::Instruction;
use unoclp_core::isa::{Kind, Opcode};

/// A loop: what stands between a label and the last jump back to it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Loop {
    pub label: u8,
    pub first: usize,
    pub last: usize,
    /// Its last step is its one jump back, and no other jump leads in or out.
    pub plain: bool,
}

/// The way of a jump.
#[derive(Clone, Copy, Debug)]
struct Jump {
    at: usize,
    to: usize,
}

pub(super) struct Flow {
    pub loops: Vec<Loop>,
    /// Jumps that only leave out what stands up to their label, by their step.
    pub skips: HashMap<usize, usize>,
    /// Labels that other jumps lead to, by their step.
    pub targets: HashMap<usize, u8>,
    jumps: Vec<Jump>,
    ways: Vec<[Option<usize>; 2]>,
}

impl Flow {
    /// # Errors
    /// The first jump that cannot be said.
    pub fn of(steps: &[Instruction<'_>]) -> Result<Flow, (usize, Why)> {
        let (paths, ways) = parts(steps);
        let mut flow = Flow {
            loops: Vec::new(),
            skips: HashMap::new(),
            targets: HashMap::new(),
            jumps: jumps(steps, &ways),
            ways,
        };
        for jump in &flow.jumps {
            if !paths[jump.at].starts_with(&paths[jump.to]) {
                return Err((jump.at, Why::IntoPart));
            }
        }
        flow.find_loops(steps, &paths);
        flow.find_skips(&paths);
        flow.find_targets(steps);
        Ok(flow)
    }

    /// Where the scan may go from a step.
    pub fn next(&self, at: usize) -> [Option<usize>; 2] {
        self.ways[at]
    }

    pub fn in_loop(&self, at: usize) -> bool {
        self.loops.iter().any(|l| (l.first..=l.last).contains(&at))
    }

    /// Whether a jump may be on its way at this step.
    pub fn is_pending(&self, at: usize) -> bool {
        self.others().any(|jump| match jump.to > jump.at {
            true => jump.at < at && at < jump.to,
            false => {
                let back = self.loops.iter().find(|l| l.first == jump.to);
                jump.at < at && back.is_some_and(|back| at <= back.last)
            }
        })
    }

    /// Jumps that no IF and no plain loop says.
    fn others(&self) -> impl Iterator<Item = &Jump> {
        let plain = |jump: &&Jump| {
            let is = |l: &Loop| l.plain && l.last == jump.at;
            !self.skips.contains_key(&jump.at) && !self.loops.iter().any(is)
        };
        self.jumps.iter().filter(plain)
    }

    fn find_loops(&mut self, steps: &[Instruction<'_>], paths: &[Vec<usize>]) {
        for (first, step) in steps.iter().enumerate() {
            let back = self.jumps.iter().filter(|j| j.to == first && j.at >= first);
            let Some(mut last) = back.map(|j| j.at).max() else {
                continue;
            };
            // A jump back out of a part: the loop ends with that part.
            while paths[last] != paths[first] {
                last += 1;
            }
            self.loops.push(Loop {
                label: step.number().unwrap_or_default(),
                first,
                last,
                plain: false,
            });
        }
        // One loop holds another, or both are apart.
        for outer in (0..self.loops.len()).rev() {
            let Loop {
                first, mut last, ..
            } = self.loops[outer];
            for inner in &self.loops[outer + 1..] {
                if inner.first <= last && inner.last > last {
                    last = inner.last;
                }
            }
            let within = first..=last;
            let mut of = self.jumps.iter().filter(|j| j.to == first);
            let one =
                of.clone().count() == 1 && of.all(|j| j.at == last && paths[j.at] == paths[first]);
            let crosses = self.jumps.iter().any(|j| {
                within.contains(&j.at) != within.contains(&j.to) && !(j.at < first && j.to > last)
            });
            let l = &mut self.loops[outer];
            l.last = last;
            l.plain = one && !crosses;
        }
    }

    fn find_skips(&mut self, paths: &[Vec<usize>]) {
        let around = |at: usize| {
            self.loops
                .iter()
                .filter(move |l| (l.first..=l.last).contains(&at))
                .count()
        };
        for jump in &self.jumps {
            let between = jump.at..jump.to;
            let alone = self.jumps.iter().all(|other| {
                let leaves = between.contains(&other.at) && !between.contains(&other.to);
                let enters =
                    !between.contains(&other.at) && (jump.at + 1..=jump.to).contains(&other.to);
                other.at == jump.at || !(leaves && other.to != jump.to || enters)
            });
            let level = jump.to > jump.at
                && paths[jump.at] == paths[jump.to]
                && around(jump.at) == around(jump.to);
            if level && alone {
                self.skips.insert(jump.at, jump.to);
            }
        }
        // Several may end at one label only if all of them are such.
        let skips = self.skips.clone();
        let all = |to: usize| {
            self.jumps
                .iter()
                .all(|j| j.to != to || skips.contains_key(&j.at))
        };
        self.skips.retain(|_, to| all(*to));
    }

    fn find_targets(&mut self, steps: &[Instruction<'_>]) {
        let others: Vec<usize> = self.others().map(|jump| jump.to).collect();
        for to in others {
            self.targets
                .insert(to, steps[to].number().unwrap_or_default());
        }
    }
}

/// The parts of IF around each step, by the steps that begin them; and where the scan may go from each.
fn parts(steps: &[Instruction<'_>]) -> (Vec<Vec<usize>>, Vec<[Option<usize>; 2]>) {
    let mut paths = Vec::new();
    let mut ways: Vec<[Option<usize>; 2]> =
        (1..=steps.len()).map(|next| [Some(next), None]).collect();
    // The IF or ELS of each part that is open.
    let mut open: Vec<usize> = Vec::new();
    for (at, step) in steps.iter().enumerate() {
        match step.opcode {
            Opcode::If => {
                paths.push(open.clone());
                open.push(at);
                continue;
            }
            Opcode::Else => {
                if let Some(begun) = open.pop() {
                    ways[begun][1] = Some(at + 1);
                }
                paths.push(open.clone());
                open.push(at);
                continue;
            }
            Opcode::EndIf => match open.pop() {
                Some(begun) if steps[begun].opcode == Opcode::If => ways[begun][1] = Some(at + 1),
                Some(begun) => ways[begun] = [Some(begun + 1), Some(at + 1)],
                None => {}
            },
            _ => {}
        }
        paths.push(open.clone());
    }
    (paths, ways)
}

fn jumps(steps: &[Instruction<'_>], ways: &[[Option<usize>; 2]]) -> Vec<Jump> {
    debug_assert_eq!(steps.len(), ways.len());
    let labels: HashMap<u8, usize> = steps
        .iter()
        .enumerate()
        .filter(|(_, step)| step.opcode == Opcode::Label)
        .filter_map(|(at, step)| Some((step.number()?, at)))
        .collect();
    let jumps = steps
        .iter()
        .enumerate()
        .filter(|(_, step)| step.opcode.row().kind == Kind::Jump);
    jumps
        .filter_map(|(at, step)| {
            let to = *labels.get(&step.number()?)?;
            Some(Jump { at, to })
        })
        .collect()
}
