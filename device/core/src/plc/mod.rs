//! The running PLC: images, timers, counters, registers and the scan.

mod adopt;
mod clocks;
mod counter;
mod effect;
mod inputs;
mod keep;
mod points;
mod scan;
mod smooth;
mod value;

pub use adopt::Snapshot;
pub use clocks::Clocks;
pub use inputs::{Debounce, Inputs};
pub use scan::{After, Scan};

use crate::isa::{COUNTER_DATA, Operand, REGISTERS, RETENTIVE, TIMER_DATA};
use crate::timer::{Delay, Target, Timer};
use crate::{Board, Image, Millis, Needs, Point, Program, Steps};
use counter::Counter;

/// A program with everything it needs to run.
#[derive(Debug)]
pub struct Plc<'m> {
    code: &'m [u8],
    timers: &'m mut [[u8; TIMER_DATA]],
    counters: &'m mut [[u8; COUNTER_DATA]],
    /// Of edges, filters and integrations, in file order.
    own: &'m mut [u8],
    needs: Needs,
    board: Board,
    state: State,
}

/// What is not in run memory.
#[derive(Clone, Copy, Debug)]
struct State {
    inputs: Debounce,
    outputs: Image,
    /// Bit 0 is M 01.
    markers: u128,
    registers: [i32; REGISTERS as usize],
    /// PWM of the output with this index.
    pwm: [u8; Point::MOST as usize],
    clocks: Clocks,
    first: bool,
}

/// A timer as an observer sees it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TimerState {
    /// TON, TOF, TP or TOR.
    pub delay: Delay,
    /// What follows Q.
    pub target: Target,
    /// The preset as it stands, ms.
    pub preset: Millis,
    /// Elapsed time in ms, at most the preset.
    pub elapsed: Millis,
    /// The timer's output.
    pub q: bool,
}

/// A counter as an observer sees it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CounterState {
    /// What it has counted to.
    pub value: i32,
    /// The preset as it stands.
    pub preset: i32,
    /// Whether it has reached its preset.
    pub q: bool,
}

impl<'m> Plc<'m> {
    /// Makes a checked program ready to run: all outputs 0 (NC-7), no timer started. The program's memory
    /// is to be of [`Board::plc_bytes`]; in a shorter one, timers and counters
    /// that find no room do nothing.
    pub fn new(program: Program<'m>) -> Plc<'m> {
        let (code, data) = program
            .memory
            .split_at_mut_checked(program.code_bytes)
            .unwrap_or_default();
        let (timers, data) = data
            .split_at_mut_checked(usize::from(program.timers) * TIMER_DATA)
            .unwrap_or_default();
        let (counters, own) = data
            .split_at_mut_checked(usize::from(program.counters) * COUNTER_DATA)
            .unwrap_or_default();
        let mut plc = Plc {
            code,
            timers: timers.as_chunks_mut().0,
            counters: counters.as_chunks_mut().0,
            own,
            needs: program.needs,
            board: program.held.board(),
            state: State::new(),
        };
        plc.own.fill(0);
        plc.counters.fill([0; COUNTER_DATA]);
        plc.restart();
        plc
    }

    /// Starts again, as after power-up: all outputs 0 (NC-7), no timer started; but retentive markers
    /// keep their states, and numbers that are kept stay what they are.
    pub fn restart(&mut self) {
        let retained = self.state.markers & RETAINED;
        let snapshot = self.save();
        self.state = State::new();
        self.state.markers = retained;
        if let Some(own) = self.own.get_mut(snapshot..) {
            own.fill(0);
        }
        let steps = Steps::new(self.code);
        let blocks = steps.clone().filter_map(|step| step.timer());
        let blocks = blocks.filter(|block| block.is_own());
        for (timer, block) in self.timers.iter_mut().zip(blocks) {
            *timer = Timer::new(block.preset).store();
        }
        self.counters.fill([0; COUNTER_DATA]);
        for step in steps {
            if let Operand::Count { counter, preset } = step.operand {
                self.with_counter(counter, |counter| counter.preset = preset);
            }
        }
        self.recall();
    }

    /// The stored form of the program, as it stands in run memory.
    pub fn stored(&self) -> &[u8] {
        self.code
    }

    /// The board that the program has been checked for.
    pub fn board(&self) -> &Board {
        &self.board
    }

    /// What the program asks of the board's pins.
    pub fn needs(&self) -> Needs {
        self.needs
    }

    /// The output image as the last scan left it.
    pub fn outputs(&self) -> Image {
        self.state.outputs
    }

    /// The markers as the last scan left them: bit 0 is M 01.
    pub fn markers(&self) -> u128 {
        self.state.markers
    }

    /// Sets a marker from outside, between two scans.
    pub fn set_marker(&mut self, number: u8, state: bool) {
        let bit = 1 << (number.wrapping_sub(1) & 127);
        if state {
            self.state.markers |= bit;
        } else {
            self.state.markers &= !bit;
        }
    }

    /// The retentive markers, bit 0 M 57: what a board keeps over a power cut (NC-12).
    pub fn retained(&self) -> u8 {
        (self.state.markers >> (RETENTIVE - 1)) as u8
    }

    /// Brings back what was kept over a power cut, before the first scan.
    pub fn retain(&mut self, markers: u8) {
        self.state.markers &= !RETAINED;
        self.state.markers |= u128::from(markers) << (RETENTIVE - 1);
    }

    /// The registers, D 01 first.
    pub fn registers(&self) -> &[i32; REGISTERS as usize] {
        &self.state.registers
    }

    /// Sets a register from outside, between two scans.
    pub fn set_register(&mut self, number: u8, value: i32) {
        if let Some(register) = self
            .state
            .registers
            .get_mut(usize::from(number).wrapping_sub(1))
        {
            *register = value;
        }
    }

    /// PWM of the output with this number, from 1: 0 to 255; 0 where it is not PWM.
    pub fn pwm(&self, output: u8) -> u8 {
        let index = usize::from(output).wrapping_sub(1);
        self.state.pwm.get(index).copied().unwrap_or_default()
    }

    /// The instructions in order.
    pub fn steps(&self) -> Steps<'_> {
        Steps::new(self.code)
    }

    /// The timers in file order, as they stand at this time.
    pub fn timers(&self, now: Millis) -> impl Iterator<Item = TimerState> {
        let blocks = self
            .steps()
            .filter_map(|step| Some((Delay::of(step.opcode)?, step.timer()?)));
        blocks
            .filter(|(_, block)| block.is_own())
            .zip(self.timers.iter())
            .map(move |((delay, block), data)| {
                let timer = Timer::load(*data);
                TimerState {
                    delay,
                    target: block.target,
                    preset: timer.preset(),
                    elapsed: timer.elapsed(delay, now),
                    q: timer.q(),
                }
            })
    }

    /// The counters, C 01 first, up to the highest that the program names.
    pub fn counters(&self) -> impl Iterator<Item = CounterState> {
        self.counters.iter().map(|data| {
            let counter = Counter::load(*data);
            CounterState {
                value: counter.value,
                preset: counter.preset,
                q: counter.is_reached(),
            }
        })
    }

    /// Uses a counter; what was changed is kept. The loader has seen to it that every counter that is
    /// named has its data.
    fn with_counter<T: Default>(&mut self, number: u8, with: impl FnOnce(&mut Counter) -> T) -> T {
        let index = usize::from(number).wrapping_sub(1);
        let Some(data) = self.counters.get_mut(index) else {
            return T::default();
        };
        let mut counter = Counter::load(*data);
        let result = with(&mut counter);
        *data = counter.store();
        result
    }

    /// Likewise a timer.
    fn with_timer<T: Default>(&mut self, number: u8, with: impl FnOnce(&mut Timer) -> T) -> T {
        let index = usize::from(number).wrapping_sub(1);
        let Some(data) = self.timers.get_mut(index) else {
            return T::default();
        };
        let mut timer = Timer::load(*data);
        let result = with(&mut timer);
        *data = timer.store();
        result
    }
}

/// The retentive markers among all.
const RETAINED: u128 = 0xFF << (RETENTIVE - 1);

impl State {
    fn new() -> State {
        State {
            inputs: Debounce::new(),
            outputs: Image(0),
            markers: 0,
            registers: [0; REGISTERS as usize],
            pwm: [0; Point::MOST as usize],
            clocks: Clocks::new(),
            first: true,
        }
    }
}
