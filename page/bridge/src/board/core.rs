//! A board that is none: the core runs the program of a page, a scan each millisecond of the page's clock.
//!
//! Owns its state, its inputs, and what is ordered of it. Must not know lines, nor how its inputs are pressed.

use super::desk::Desk;
use super::news::{News, Seen, Trouble};
use super::order::Ordered;
use super::watched::Watched;
use crate::facts::numbers;
#[cfg(feature = "full")]
use crate::machine::Machine;
use crate::program::source;
use crate::words::{self, Both, both};
use std::collections::{BTreeMap, VecDeque};
use unoclp_client::diagnostics::{self, Kept};
use unoclp_client::map::Command;
use unoclp_client::watch::Side;
use unoclp_client::{Order, words as told};
use unoclp_core::{Board, Fault, Image, Inputs, Millis, Plc, Point, Snapshot};
use unoclp_exercise::live::Flow;
#[cfg(feature = "full")]
use unoclp_plant::Outputs;
use unoclp_point::Address;
use unoclp_workspace::Analysis;

/// The small module has no machines.
#[cfg(not(feature = "full"))]
pub type Machine = std::convert::Infallible;

/// Scans that are made up for at most, where the page was away for longer: its time stood still then.
const MOST: Millis = 250;
/// ms between two pictures of it.
const PICTURE: u64 = 16;

/// What it does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum State {
    Empty,
    Run,
    Stop,
    Fault(Fault),
}

/// The core as a page's board.
pub struct Core {
    board: Board,
    state: State,
    program: Option<Program>,
    /// What is ordered, each with its number.
    orders: VecDeque<(u32, Ordered)>,
    /// ms of the page's clock at the last scan; none before the first step.
    last: Option<u64>,
    /// ms since it began.
    uptime: Millis,
    inputs: Inputs,
    /// What is forced, inputs and outputs, by number.
    forced: [BTreeMap<u8, bool>; 2],
    faults: u16,
    /// The scan that is under way in slow motion.
    #[cfg(feature = "full")]
    pub(super) slow: Option<super::under_way::Slow>,
}

/// A program that it holds.
struct Program {
    watched: Watched,
    kept: Kept,
    flow: Flow,
}

impl Core {
    /// What runs the programs of this board. It has none yet.
    pub fn new(board: Board) -> Core {
        Core {
            board,
            state: State::Empty,
            program: None,
            orders: VecDeque::new(),
            last: None,
            uptime: 0,
            inputs: Inputs::default(),
            forced: Default::default(),
            faults: 0,
            #[cfg(feature = "full")]
            slow: None,
        }
    }

    /// Has something done in the next step; the news speak of it by this number.
    pub fn order(&mut self, number: u32, ordered: Ordered) {
        self.orders.push_back((number, ordered));
    }

    /// Does what was ordered, scans up to this time in ms, and tells what came of it; gives the time of its next step.
    pub fn step(&mut self, now: u64, desk: &Desk, machine: &mut Option<Machine>) -> u64 {
        let passed = now.saturating_sub(*self.last.get_or_insert(now));
        self.last = Some(now);
        while let Some((order, what)) = self.orders.pop_front() {
            desk.tell(match self.fulfil(what) {
                Ok(said) => News::Done { order, said },
                Err(why) => News::Undone { order, why },
            });
        }
        for _ in 0..passed.min(MOST.into()) {
            self.uptime = self.uptime.wrapping_add(1);
            if self.state == State::Run {
                self.scan();
            }
            if let Some(machine) = machine {
                self.drive(machine);
            }
        }
        desk.tell(News::Seen(Box::new(self.seen())));
        now + PICTURE
    }

    /// A machine goes on for 1 ms with the outputs as they are; its inputs are those of the next scan.
    #[cfg(feature = "full")]
    fn drive(&mut self, machine: &mut Machine) {
        let mut outputs = Outputs::default();
        if let (State::Run, Some(program)) = (self.state, &mut self.program) {
            let board = self.board;
            program.with_plc(|plc| {
                outputs.points = plc.outputs();
                for output in board.pwm_outputs() {
                    if let Some(place) = outputs.pwm.get_mut(usize::from(output)) {
                        *place = plc.pwm(output);
                    }
                }
            });
        }
        machine.step(&outputs, 1);
        self.inputs = *machine.inputs();
    }

    #[cfg(not(feature = "full"))]
    fn drive(&mut self, _: &mut Machine) {}

    fn fulfil(&mut self, ordered: Ordered) -> Result<Option<Both>, Both> {
        match ordered {
            Ordered::Board(order, text) => self.fulfil_of_board(&order, text.as_deref())?,
            Ordered::Press(input, closed) => {
                if let Some(point) = Point::new(input, self.board.inputs) {
                    self.inputs.points.set(point, closed);
                }
            }
            Ordered::Turn(input, reading) => {
                if let Some(place) = self.inputs.analogue.get_mut(usize::from(input)) {
                    *place = reading.min(1023);
                }
            }
            // It knows what it runs.
            Ordered::Watch(_) => {}
        }
        Ok(None)
    }

    /// Does what a board at a line would do too.
    fn fulfil_of_board(&mut self, order: &Order, text: Option<&Analysis>) -> Result<(), Both> {
        match order {
            Order::Command(Command::Run | Command::Restart) => self.begin(State::Run),
            Order::Command(Command::Stop) => self.begin(State::Stop),
            Order::Command(Command::SingleScan) => match self.state {
                State::Run | State::Stop => {
                    self.state = State::Stop;
                    self.scan();
                    Ok(())
                }
                _ => Err(both(told::refused_now)),
            },
            #[cfg(feature = "full")]
            Order::Fetch => Err(both(words::own_program)),
            Order::Release => {
                self.forced = Default::default();
                Ok(())
            }
            Order::Force(side, index, to) => {
                self.force(*side == Side::Outputs, index.saturating_add(1), *to)
            }
            Order::Set(point, value) => self.set(*point, *value),
            Order::Upload(upload) => match text {
                Some(text) => self.load(text, upload.stays),
                None => Err(both(words::faulty)),
            },
            Order::Settings => Err(both(words::no_settings)),
            #[cfg(feature = "full")]
            Order::Settle(_) => Err(both(words::no_settings)),
            Order::Command(_) => Err(both(told::refused_now)),
            #[cfg(feature = "full")]
            Order::Flash(_) => Err(both(told::refused_now)),
        }
    }

    fn load(&mut self, text: &Analysis, stay: bool) -> Result<(), Both> {
        let source = source(text)?;
        self.board = source.board();
        self.program = Some(Program {
            kept: Kept::of(source.program()),
            flow: Flow::default(),
            watched: Watched::new(text)?,
        });
        self.begin(if stay { State::Stop } else { State::Run })
    }

    /// The program begins again, and goes on in this state.
    fn begin(&mut self, state: State) -> Result<(), Both> {
        let program = self
            .program
            .as_mut()
            .ok_or_else(|| both(words::none_given))?;
        program.watched.machine().with_plc(|plc| plc.restart());
        program.flow = Flow::default();
        #[cfg(feature = "full")]
        {
            self.slow = None;
        }
        self.state = state;
        Ok(())
    }

    /// A scan with the inputs as they are, or are forced to be.
    fn scan(&mut self) {
        #[cfg(feature = "full")]
        if self.finish() {
            return;
        }
        let Some(program) = &mut self.program else {
            return;
        };
        let [inputs, outputs] = &self.forced;
        let mut now = self.inputs;
        now.points = forced(now.points, inputs);
        let (flow, outcome) = program.watched.scan(now, self.uptime);
        program.flow = flow;
        match outcome {
            Ok(image) => {
                let snapshot = Snapshot {
                    outputs: forced(image, outputs),
                    ..Snapshot::default()
                };
                program.with_plc(|plc| adopt(plc, snapshot, self.uptime));
            }
            Err(fault) => {
                self.state = State::Fault(fault);
                self.faults = self.faults.saturating_add(1);
            }
        }
    }

    /// What it does.
    #[cfg(feature = "full")]
    pub(super) fn state(&self) -> State {
        self.state
    }

    /// ms since it began.
    #[cfg(feature = "full")]
    pub(super) fn now(&self) -> Millis {
        self.uptime
    }

    /// The inputs of a scan, as they are, or are forced to be.
    #[cfg(feature = "full")]
    pub(super) fn read(&self) -> Inputs {
        let mut inputs = self.inputs;
        inputs.points = forced(inputs.points, &self.forced[0]);
        inputs
    }

    /// Its contacts.
    #[cfg(feature = "full")]
    pub(super) fn closed(&self) -> Image {
        self.inputs.points
    }

    /// The PLC of its program, where it has one.
    #[cfg(feature = "full")]
    pub(super) fn with_plc<T>(&mut self, with: impl FnOnce(&mut Plc<'_>) -> T) -> Option<T> {
        self.program.as_mut().map(|program| program.with_plc(with))
    }

    /// What there is to show of a scan.
    #[cfg(feature = "full")]
    pub(super) fn show(&self, flow: &Flow) -> Option<super::Live> {
        self.program
            .as_ref()
            .map(|program| program.watched.show(flow))
    }

    /// A scan is over.
    #[cfg(feature = "full")]
    pub(super) fn take(&mut self, flow: Flow, image: Image) {
        let outputs = forced(image, &self.forced[1]);
        let now = self.uptime;
        if let Some(program) = &mut self.program {
            program.flow = flow;
            let snapshot = Snapshot {
                outputs,
                ..Snapshot::default()
            };
            program.with_plc(|plc| adopt(plc, snapshot, now));
        }
    }

    /// A millisecond goes by.
    #[cfg(feature = "full")]
    pub(super) fn go_by(&mut self, machine: &mut Option<Machine>) {
        self.uptime = self.uptime.wrapping_add(1);
        if let Some(machine) = machine {
            self.drive(machine);
        }
    }

    /// Its program has come to a fault.
    #[cfg(feature = "full")]
    pub(super) fn fail(&mut self, fault: Fault) {
        self.state = State::Fault(fault);
        self.faults = self.faults.saturating_add(1);
    }

    fn force(&mut self, output: bool, number: u8, to: Option<bool>) -> Result<(), Both> {
        let last = if output {
            self.board.outputs
        } else {
            self.board.inputs
        };
        Point::new(number, last).ok_or_else(|| both(told::refused_address))?;
        let [inputs, outputs] = &mut self.forced;
        let forced = if output { outputs } else { inputs };
        match to {
            Some(to) => forced.insert(number, to),
            None => forced.remove(&number),
        };
        Ok(())
    }

    /// Sets a point between two scans; of a timer or counter its preset.
    fn set(&mut self, point: Address, value: i32) -> Result<(), Both> {
        let program = self.program.as_mut();
        let program = program.ok_or_else(|| both(words::none_given))?;
        let (board, now) = (self.board, self.uptime);
        let is_set = program.with_plc(|plc| match point {
            Address::Marker(number) if (1..=board.markers).contains(&number) => {
                plc.set_marker(number, value != 0);
                true
            }
            Address::Register(number) if number >= 1 => {
                plc.set_register(number, value);
                usize::from(number) <= plc.registers().len()
            }
            Address::Output(number) => Point::new(number, board.outputs).is_some_and(|point| {
                let mut outputs = plc.outputs();
                outputs.set(point, value != 0);
                adopt(
                    plc,
                    Snapshot {
                        outputs,
                        ..Snapshot::default()
                    },
                    now,
                );
                true
            }),
            Address::Timer(number) => {
                let timers = plc.timers(now).map(|timer| (timer.elapsed, timer.preset));
                let mut timers: Vec<(Millis, Millis)> = timers.collect();
                let preset = nth(&mut timers, number).map(|(_, preset)| preset);
                let is = preset
                    .map(|preset| *preset = value.max(0).cast_unsigned())
                    .is_some();
                let outputs = plc.outputs();
                adopt(
                    plc,
                    Snapshot {
                        outputs,
                        timers: &timers,
                        ..Snapshot::default()
                    },
                    now,
                );
                is
            }
            Address::Counter(number) => {
                let counters = plc
                    .counters()
                    .map(|counter| (counter.value, counter.preset));
                let mut counters: Vec<(i32, i32)> = counters.collect();
                let preset = nth(&mut counters, number).map(|(_, preset)| preset);
                let is = preset.map(|preset| *preset = value).is_some();
                let outputs = plc.outputs();
                adopt(
                    plc,
                    Snapshot {
                        outputs,
                        counters: &counters,
                        ..Snapshot::default()
                    },
                    now,
                );
                is
            }
            _ => false,
        });
        match is_set {
            true => Ok(()),
            false => Err(both(|lang| told::no_point(lang, point))),
        }
    }

    fn seen(&mut self) -> Seen {
        let [inputs, outputs] = &self.forced;
        let list = |forced: &BTreeMap<u8, bool>| {
            forced.iter().map(|(&number, &to)| (number, to)).collect()
        };
        let mut seen = Seen {
            at: self.uptime,
            state: match self.state {
                State::Empty => "EMPTY",
                State::Run => "RUN",
                State::Stop => "STOP",
                State::Fault(_) => "FAULT",
            },
            faults: self.faults,
            inputs: numbers(forced(self.inputs.points, inputs).0),
            forced_inputs: list(inputs),
            forced_outputs: list(outputs),
            analogue: self.inputs.analogue.to_vec(),
            ..Seen::default()
        };
        let Some(program) = &mut self.program else {
            return seen;
        };
        seen.kept = program.kept.into();
        seen.same = Some(true);
        seen.live = Some(program.watched.show(&program.flow));
        if let State::Fault(fault) = self.state {
            let trouble = diagnostics::Trouble {
                number: fault.cause.number().into(),
                line: fault.line,
            };
            seen.fault = Some(Trouble::of(trouble, program.watched.line(trouble)));
        }
        let now = self.uptime;
        program.with_plc(|plc| {
            seen.outputs = numbers(plc.outputs().0);
            seen.markers = numbers(plc.markers());
            seen.registers = plc.registers().to_vec();
            let signed = |ms: Millis| i32::try_from(ms).unwrap_or(i32::MAX);
            seen.timers = plc
                .timers(now)
                .map(|timer| [signed(timer.elapsed), signed(timer.preset)])
                .collect();
            seen.counters = plc
                .counters()
                .map(|counter| [counter.value, counter.preset])
                .collect();
            let dimmed = self
                .board
                .pwm_outputs()
                .map(|output| (output, plc.pwm(output)));
            seen.dimmed = dimmed.filter(|(_, share)| *share > 0).collect();
        });
        seen
    }
}

impl Program {
    fn with_plc<T>(&mut self, with: impl FnOnce(&mut Plc<'_>) -> T) -> T {
        self.watched.machine().with_plc(with)
    }
}

/// Takes over what is told of the outputs, timers and counters; the markers stay.
fn adopt(plc: &mut Plc<'_>, snapshot: Snapshot<'_>, now: Millis) {
    let markers = plc.markers();
    plc.adopt(
        &Snapshot {
            markers,
            ..snapshot
        },
        now,
    );
}

/// That with this number, from 1.
fn nth<T>(all: &mut [T], number: u8) -> Option<&mut T> {
    all.get_mut(usize::from(number).checked_sub(1)?)
}

/// These points, but for those that are forced.
fn forced(mut image: Image, forced: &BTreeMap<u8, bool>) -> Image {
    for (&number, &to) in forced {
        if let Some(point) = Point::new(number, Point::MOST) {
            image.set(point, to);
        }
    }
    image
}
