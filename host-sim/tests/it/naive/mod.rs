//! An interpreter written from docs/numeric-code.md alone, as plainly as can be: numbers of 64 bits, time
//! that never wraps, every instruction looked up by its letters.

pub mod read;
pub mod real;
mod timer;

use read::Step;
use std::collections::HashMap;
use timer::Timer;
use unoclp_core::Board;

/// What comes into a scan.
pub struct World {
    /// Inputs, 01 first.
    pub inputs: [bool; 99],
    /// Readings of A 00 and those after it.
    pub analogue: [i64; 99],
}

#[derive(Clone, Default)]
pub struct Counter {
    pub value: i64,
    pub preset: i64,
    /// acc when CTU and CTD last reached it.
    before: HashMap<String, bool>,
}

/// What a filter or an integration remembers.
struct Smooth {
    since: i64,
    /// 256ths, or thousandths.
    sum: i64,
}

/// A program and all that it remembers. Points, markers, registers and the like are counted from 1; index 0
/// is nothing.
pub struct Naive {
    steps: Vec<Step>,
    pub timers: Vec<Timer>,
    pub counters: Vec<Counter>,
    /// What has the points.
    board: Board,
    pub outputs: [bool; 100],
    /// As many as there are groups of eight for.
    pub markers: [bool; 105],
    pub registers: [i64; 99],
    pub pwm: [i64; 100],
    inputs: [bool; 100],
    /// Since when each input has been seen at its other level.
    differs: [Option<i64>; 100],
    filter: i64,
    /// acc at an edge or an integration, by its place.
    before: HashMap<usize, bool>,
    smooth: HashMap<usize, Smooth>,
    first: bool,
    clock_since: i64,
    clock_phase: i64,
}

/// What lives as long as a scan.
struct Pass<'w> {
    world: &'w World,
    now: i64,
    acc: bool,
    value: i64,
    pushed: Vec<i64>,
    error: bool,
    open: Vec<(String, bool)>,
    points: [bool; 9],
}

impl Naive {
    pub fn new(text: &str, board: Board) -> Naive {
        Naive::of(read::read(text), board)
    }

    /// A power cut: M 57 to M 64 and what is named to be kept outlast it.
    pub fn restart(&mut self) {
        let steps = std::mem::take(&mut self.steps);
        let before = std::mem::replace(self, Naive::of(steps, self.board));
        self.markers[57..=64].copy_from_slice(&before.markers[57..=64]);
        for step in &self.steps {
            match step.letters.as_str() {
                "KD" => self.registers[step.xx] = before.registers[step.xx],
                "KC" => self.counters[step.xx].value = before.counters[step.xx].value,
                _ => {}
            }
        }
    }

    fn of(steps: Vec<Step>, board: Board) -> Naive {
        let timers = steps.iter().filter(|step| step.is_own_timer());
        let timers = timers
            .map(|step| Timer::new(&step.letters, step.lines[0]))
            .collect();
        let mut counters = vec![Counter::default(); 100];
        for step in &steps {
            if step.letters == "CTU" || step.letters == "CTD" {
                counters[step.xx].preset = step.lines[0];
            }
        }
        let filter = steps.iter().rfind(|step| step.letters == "FI");
        Naive {
            timers,
            counters,
            filter: filter.map_or(0, |step| step.xx as i64),
            steps,
            board,
            outputs: [false; 100],
            markers: [false; 105],
            registers: [0; 99],
            pwm: [0; 100],
            inputs: [false; 100],
            differs: [None; 100],
            before: HashMap::new(),
            smooth: HashMap::new(),
            first: true,
            clock_since: 0,
            clock_phase: 0,
        }
    }

    /// One scan at this time; where it jumps back too often, the line of the jump.
    pub fn scan(&mut self, world: &World, now: i64) -> Result<(), u32> {
        self.take_inputs(world, now);
        self.take_clocks(now);
        let mut pass = Pass {
            world,
            now,
            acc: true,
            value: 0,
            pushed: Vec::new(),
            error: false,
            open: Vec::new(),
            points: [false; 9],
        };
        let mut budget = 2_000;
        let mut at = 0;
        while at < self.steps.len() {
            let (xx, line) = (self.steps[at].xx, self.steps[at].line);
            let taken = match self.steps[at].letters.as_str() {
                "JMP" | "RET" => pass.acc,
                "-JMP" | "-RET" => !pass.acc,
                "IF" | "ELS" | "END" => {
                    let goes_on = match self.steps[at].letters.as_str() {
                        "IF" => pass.acc,
                        // What stood before has been done.
                        "ELS" => false,
                        _ => true,
                    };
                    at = if goes_on {
                        at + 1
                    } else {
                        self.behind_part(at)
                    };
                    pass.acc = true;
                    continue;
                }
                _ => {
                    self.step(at, &mut pass);
                    at += 1;
                    continue;
                }
            };
            if !taken {
                at += 1;
                continue;
            }
            if self.steps[at].letters.ends_with("RET") {
                break;
            }
            let is_label = |step: &Step| step.letters == "LB" && step.xx == xx;
            let label = self.steps.iter().position(is_label).unwrap();
            if label < at {
                budget -= self.steps[label..=at]
                    .iter()
                    .map(|step| step.bytes)
                    .sum::<i64>();
                if budget < 0 {
                    self.outputs = [false; 100];
                    return Err(line);
                }
            }
            at = label;
            pass.acc = true;
        }
        self.first = false;
        Ok(())
    }

    /// Where the scan goes on that does not do what this IF or ELS begins: after its END, or of an IF
    /// after its ELS where it has one.
    fn behind_part(&self, at: usize) -> usize {
        let is_if = self.steps[at].letters == "IF";
        let mut depth = 0;
        for (index, step) in self.steps.iter().enumerate().skip(at + 1) {
            match step.letters.as_str() {
                "IF" => depth += 1,
                "ELS" if depth == 0 && is_if => return index + 1,
                "END" if depth == 0 => return index + 1,
                "END" => depth -= 1,
                _ => {}
            }
        }
        panic!("an IF without END");
    }

    fn take_inputs(&mut self, world: &World, now: i64) {
        let named = |xx: usize| {
            let reads = |step: &&Step| matches!(&*step.letters, "RI" | "-RI" | "XI" | "-XI");
            self.steps.iter().filter(reads).any(|step| step.xx == xx)
        };
        let shared = match self.board.shared_from {
            0 => usize::MAX,
            first => first.into(),
        };
        for xx in 1..=self.board.inputs.into() {
            let level = world.inputs[xx - 1] && (xx < shared || named(xx));
            let since = *self.differs[xx].get_or_insert(now);
            if self.first || self.inputs[xx] == level || now - since >= self.filter {
                (self.inputs[xx], self.differs[xx]) = (level, None);
            }
        }
    }

    fn take_clocks(&mut self, now: i64) {
        if self.first {
            self.clock_since = now;
        } else if now - self.clock_since >= 50 {
            self.clock_since += 50;
            self.clock_phase += 1;
        }
    }

    fn system(&self, xx: usize, pass: &Pass<'_>) -> bool {
        match xx {
            1 => self.first,
            2 => self.clock_phase / 10 % 2 == 1,
            3 => self.clock_phase % 2 == 1,
            _ => pass.error,
        }
    }

    fn is_pwm(&self, output: usize) -> bool {
        self.steps
            .iter()
            .any(|step| step.letters == "STP" && step.xx == output)
    }

    fn step(&mut self, at: usize, pass: &mut Pass<'_>) {
        let step = &self.steps[at];
        let (xx, acc, now) = (step.xx, pass.acc, pass.now);
        let lines = step.lines.clone();
        let letters = step.letters.clone();
        let (name, inverse) = match letters.strip_prefix('-') {
            Some(name) => (name, true),
            None => (letters.as_str(), false),
        };
        if step.takes_number {
            let operand = match (xx, lines.first()) {
                (0, Some(constant)) => *constant,
                (99, _) => {
                    let pushed = pass.pushed.pop().unwrap();
                    std::mem::replace(&mut pass.value, pushed)
                }
                _ => self.registers[xx],
            };
            return pass.operate(name, operand);
        }
        match name {
            "NL" => pass.acc = true,
            "(" | "A(" | "X(" => {
                pass.open.push((letters, acc));
                pass.acc = true;
            }
            ")" => {
                let (opened, popped) = pass.open.pop().unwrap();
                pass.acc = match opened.as_str() {
                    "(" => popped | acc,
                    "A(" => popped & acc,
                    _ => popped ^ acc,
                };
            }
            "()" => match at
                .checked_sub(1)
                .map(|before| self.steps[before].letters.as_str())
            {
                Some("(" | "A(" | "X(") => pass.acc = pass.points[xx],
                _ => pass.points[xx] = acc,
            },
            "NOT" => pass.acc = !acc,
            "EU" | "ED" => {
                let before = self.before.insert(at, acc).unwrap_or(false);
                pass.acc = acc != before && acc == (name == "EU");
            }
            "RI" => pass.acc &= self.inputs[xx] != inverse,
            "RO" => pass.acc &= self.outputs[xx] != inverse,
            "RM" => pass.acc &= self.markers[xx] != inverse,
            "RS" => pass.acc &= self.system(xx, pass) != inverse,
            "RT" => pass.acc &= self.timers[xx - 1].q != inverse,
            "RC" => pass.acc &= (self.counters[xx].value >= self.counters[xx].preset) != inverse,
            "RZ" => pass.acc &= (self.counters[xx].value <= 0) != inverse,
            "XI" => pass.acc ^= self.inputs[xx] != inverse,
            "XO" => pass.acc ^= self.outputs[xx] != inverse,
            "XM" => pass.acc ^= self.markers[xx] != inverse,
            "BIT" => pass.acc &= (pass.value >> xx & 1 == 1) != inverse,
            "WO" => self.outputs[xx] = acc != inverse,
            "WM" => self.markers[xx] = acc != inverse,
            "TON" | "TOF" | "TOR" | "TP" => {
                let before = self.steps[..at].iter().filter(|step| step.is_own_timer());
                let number = (lines[1] % 100) as usize;
                let index = match lines[1] / 100 {
                    84 => {
                        self.timers[number - 1].preset = lines[0];
                        number - 1
                    }
                    _ => before.count(),
                };
                pass.acc = self.timers[index].reach(acc, now);
                match lines[1] / 100 {
                    79 => self.outputs[number] = pass.acc,
                    77 => self.markers[number] = pass.acc,
                    _ => {}
                }
            }
            "CTU" | "CTD" => {
                let counter = &mut self.counters[xx];
                let before = counter.before.insert(letters.clone(), acc).unwrap_or(false);
                let way = if name == "CTU" { 1 } else { -1 };
                if acc && !before {
                    let next = counter.value + way;
                    counter.value = next.clamp(i32::MIN.into(), i32::MAX.into());
                }
                pass.acc = match name {
                    "CTU" => counter.value >= counter.preset,
                    _ => counter.value <= 0,
                };
            }
            "LDA" => pass.value = pass.world.analogue[xx],
            "LDT" => pass.value = self.timers[xx - 1].elapsed(now),
            "LDC" => pass.value = self.counters[xx].value,
            // No time is told of a scan here.
            "LDS" => pass.value = if xx == 1 { 0 } else { wrap(now) },
            "LDM" => pass.value = number(&self.markers[xx * 8 - 7..=xx * 8]),
            "LDI" => pass.value = number(&self.inputs[1..=8]),
            "LDO" => pass.value = number(&self.outputs[1..=8]),
            "LDB" => pass.value = acc.into(),
            "NEG" => pass.value = wrap(-pass.value),
            "SQR" => {
                pass.error |= pass.value < 0;
                pass.value = pass.value.max(0).isqrt();
            }
            "SHL" => pass.value = wrap(pass.value << xx),
            "SHR" => pass.value = wrap((pass.value & 0xFFFF_FFFF) >> xx),
            "PSH" => pass.pushed.push(pass.value),
            "ITR" | "UTR" | "RND" | "TRC" | "RNG" | "RAB" | "RRT" | "CMR" => {
                pass.take(real::change(name, pass.value));
            }
            "SXT" if xx == 0 => pass.value = 0,
            "SXT" => {
                let low = pass.value.rem_euclid(1 << xx);
                let negative = low >= 1 << (xx - 1);
                pass.value = if negative { low - (1 << xx) } else { low };
            }
            "ZXT" => pass.value = pass.value.rem_euclid(1 << xx),
            "LDX" => {
                let inside = (0..lines[0]).contains(&pass.value);
                let place = xx as i64 + pass.value;
                pass.take(inside.then(|| self.registers[place as usize]));
            }
            "STX" => {
                let index = pass.pushed.pop().unwrap();
                if acc && (0..lines[0]).contains(&index) {
                    self.registers[xx + index as usize] = pass.value;
                } else {
                    pass.error |= acc;
                }
            }
            "SCL" => pass.value = scale(pass.value, &lines),
            "FLT" => pass.value = self.filter(at, pass.value, xx, lines[0], now),
            "INT" => self.integrate(at, pass.value, xx, acc, now),
            // A place to jump to, and what is not done in a scan.
            "LB" | "FI" | "KD" | "KC" => {}
            _ if acc => self.store(name, xx, &lines, pass.value),
            _ => {}
        }
    }

    /// What is done only where acc is 1.
    fn store(&mut self, name: &str, xx: usize, lines: &[i64], value: i64) {
        match name {
            "SWO" => self.outputs[xx] = true,
            "RWO" => self.outputs[xx] = false,
            "SWM" => self.markers[xx] = true,
            "RWM" => self.markers[xx] = false,
            "RWT" => self.timers[xx - 1].reset(),
            "RWC" => self.counters[xx].value = 0,
            "SWC" => self.counters[xx].value = self.counters[xx].preset,
            "ST" => self.registers[xx] = value,
            "STC" => self.counters[xx].value = value,
            "STP" => self.pwm[xx] = value.clamp(0, 255),
            "STM" => {
                for marker in xx * 8 - 7..=(xx * 8).min(self.board.markers.into()) {
                    self.markers[marker] = value >> ((marker - 1) % 8) & 1 == 1;
                }
            }
            "STO" => {
                let bits = usize::from(self.board.outputs.min(8));
                let states = (0..bits).map(|bit| value >> bit & 1 == 1);
                self.set_outputs(states.collect());
            }
            "PVC" => self.counters[xx].preset = value.max(0),
            "PVT" => self.timers[xx - 1].preset = value.max(0),
            "MOV" => {
                let (to, count) = (lines[0] as usize - 6800, lines[1] as usize);
                let read: Vec<i64> = self.registers[xx..xx + count].to_vec();
                self.registers[to..to + count].copy_from_slice(&read);
            }
            "DRM" => {
                let step = usize::try_from(self.registers[xx]).ok();
                let step = step
                    .and_then(|step| lines[1..].get(step))
                    .copied()
                    .unwrap_or(0);
                let digits = [1000, 100, 10, 1];
                self.set_outputs(digits.map(|digit| step / digit % 10 == 1).to_vec());
            }
            _ => panic!("{name}: say in tests/naive what it does"),
        }
    }

    fn set_outputs(&mut self, outputs: Vec<bool>) {
        for (output, state) in (1..).zip(outputs) {
            if !self.is_pwm(output) {
                self.outputs[output] = state;
            }
        }
    }

    fn filter(&mut self, at: usize, value: i64, strength: usize, time: i64, now: i64) -> i64 {
        let value = value.clamp(-4_194_304, 4_194_303) * 256;
        let filter = self.smooth.entry(at).or_insert(Smooth {
            since: i64::MAX,
            sum: value,
        });
        if filter.since == i64::MAX {
            filter.since = now;
        } else if now - filter.since >= time {
            filter.since = now;
            filter.sum += (value - filter.sum).div_euclid(1 << strength);
        }
        (filter.sum + 128).div_euclid(256)
    }

    fn integrate(&mut self, at: usize, value: i64, xx: usize, acc: bool, now: i64) {
        let before = self.before.insert(at, acc).unwrap_or(false);
        let integral = self
            .smooth
            .entry(at)
            .or_insert(Smooth { since: now, sum: 0 });
        if acc && before {
            let time = (now - integral.since).min(32_767);
            integral.sum += value.clamp(-32_768, 32_767) * time;
            self.registers[xx] = wrap(self.registers[xx] + integral.sum / 1000);
            integral.sum %= 1000;
        }
        integral.since = now;
    }
}

impl Pass<'_> {
    fn operate(&mut self, name: &str, operand: i64) {
        let value = self.value;
        let result = match name {
            "GT" => return self.acc &= value > operand,
            "GE" => return self.acc &= value >= operand,
            "EQ" => return self.acc &= value == operand,
            "NE" => return self.acc &= value != operand,
            "LE" => return self.acc &= value <= operand,
            "LT" => return self.acc &= value < operand,
            "UGE" => return self.acc &= unsigned(value) >= unsigned(operand),
            "ULT" => return self.acc &= unsigned(value) < unsigned(operand),
            "RAD" | "RSU" | "RMU" | "RDI" => {
                return self.take(real::operate(name, value, operand));
            }
            "LD" => operand,
            "ADD" => value + operand,
            "SUB" => value - operand,
            "MUL" => value * operand,
            "DIV" | "MOD" | "UDV" | "UMO" if operand == 0 => {
                self.error = true;
                0
            }
            "DIV" => value / operand,
            "MOD" => value % operand,
            "UDV" => unsigned(value) / unsigned(operand),
            "UMO" => unsigned(value) % unsigned(operand),
            "AND" => value & operand,
            "OR" => value | operand,
            "XOR" => value ^ operand,
            _ => panic!("{name}: say in tests/naive what it does"),
        };
        self.value = wrap(result);
    }

    /// Takes a result; where there is none, 0 and an arithmetic error.
    fn take(&mut self, result: Option<i64>) {
        self.error |= result.is_none();
        self.value = result.unwrap_or(0);
    }
}

/// The same 32 bits as a number without a sign.
fn unsigned(number: i64) -> i64 {
    number.rem_euclid(1 << 32)
}

/// The number of 32 bits with a sign that this comes to.
fn wrap(number: i64) -> i64 {
    (number + (1 << 31)).rem_euclid(1 << 32) - (1 << 31)
}

fn number(bits: &[bool]) -> i64 {
    bits.iter()
        .rev()
        .fold(0, |number, &bit| number * 2 + i64::from(bit))
}

fn scale(value: i64, lines: &[i64]) -> i64 {
    let value = value.clamp(lines[0], lines[1]);
    lines[2] + (value - lines[0]) * (lines[3] - lines[2]) / (lines[1] - lines[0])
}
