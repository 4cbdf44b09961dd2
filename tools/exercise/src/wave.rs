//! The trace of a run for a wave viewer such as GTKWave: a VCD file (IEEE 1364, section 18).

use crate::scenario::points;
use std::collections::BTreeMap;
use std::io::{self, Write};
use unoclp_core::{Board, Image, Inputs, Millis, TimerState};
use unoclp_host_sim::engine::{Cell, Engine, HostEngine, Machine, Outcome, Refusal};
use unoclp_program::used::{Quantity, Used};
use vcd::{IdCode, SimulationCommand, TimescaleUnit, Value};

/// Everything that a trace shows of one scan.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sample {
    /// The board that the program is for.
    pub board: Board,
    /// The inputs that the scan saw.
    pub inputs: Image,
    /// The outputs as it left them.
    pub outputs: Image,
    /// The timers in file order.
    pub timers: Vec<TimerState>,
    /// What else the program uses.
    pub quantities: Vec<Quantity>,
}

impl Sample {
    /// The scan that this machine has just done, with these inputs, at this reading of the clock, of a program that uses
    /// this.
    pub fn of(machine: &Machine, used: &Used, inputs: &Inputs, now: Millis) -> Sample {
        let plc = machine.plc();
        Sample {
            board: *plc.board(),
            inputs: inputs.points,
            quantities: used.quantities(plc, inputs),
            outputs: plc.outputs(),
            timers: plc.timers(now).collect(),
        }
    }

    /// The values of the signals, in the order in which [`declare`] declares them.
    fn values(&self) -> Vec<u32> {
        let inputs = points(self.board.inputs).map(|point| u32::from(self.inputs.get(point)));
        let outputs = points(self.board.outputs).map(|point| u32::from(self.outputs.get(point)));
        let timer = |timer: &TimerState| [u32::from(timer.q), timer.elapsed];
        let timers = self.timers.iter().flat_map(timer);
        let quantities = self
            .quantities
            .iter()
            .map(|quantity| quantity.value.cast_unsigned());
        inputs
            .chain(outputs)
            .chain(timers)
            .chain(quantities)
            .collect()
    }
}

/// Writes the samples of a run: a signal for each input and output, for each timer its output `Q` and its
/// elapsed time in ms, and for each analogue input, PWM, counter, register and marker that the program
/// uses. One time step is 1 ms.
pub struct Recorder<W: Write> {
    writer: vcd::Writer<W>,
    /// The signals with the values they have, once the first sample has come.
    signals: Vec<(Signal, u32)>,
    last: Option<u64>,
    /// What the points are called.
    names: BTreeMap<String, String>,
}

#[derive(Clone, Copy)]
enum Signal {
    Bit(IdCode),
    /// With its width in bits.
    Word(IdCode, u32),
}

impl<W: Write> Recorder<W> {
    /// A recorder that has written nothing yet.
    pub fn new(writer: W) -> Recorder<W> {
        Recorder {
            writer: vcd::Writer::new(writer),
            signals: Vec::new(),
            last: None,
            names: BTreeMap::new(),
        }
    }

    /// The same, with what the program calls its points: `lamp` for `Q1` makes the signal `Q1_lamp`.
    pub fn with_names(self, names: BTreeMap<String, String>) -> Recorder<W> {
        Recorder { names, ..self }
    }

    /// Takes the sample of a scan at this time, in ms after the first. Times rise from call to
    /// call; every sample is of the same program.
    pub fn record(&mut self, at: u64, sample: &Sample) -> io::Result<()> {
        let values = sample.values();
        if self.last.is_none() {
            let signals = declare(&mut self.writer, sample, &self.names)?;
            self.signals = signals.into_iter().zip(values).collect();
            self.writer.timestamp(at)?;
            self.writer.begin(SimulationCommand::Dumpvars)?;
            for &(signal, value) in &self.signals {
                signal.write(&mut self.writer, value)?;
            }
            self.writer.end()?;
        } else {
            let mut stamped = false;
            for ((signal, last), value) in self.signals.iter_mut().zip(values) {
                if *last == value {
                    continue;
                }
                if !stamped {
                    self.writer.timestamp(at)?;
                    stamped = true;
                }
                signal.write(&mut self.writer, value)?;
                *last = value;
            }
        }
        self.last = Some(at);
        Ok(())
    }

    /// Ends the trace 1 ms after the last sample, and writes out what is still held back.
    pub fn finish(&mut self) -> io::Result<()> {
        if let Some(at) = self.last {
            self.writer.timestamp(at.saturating_add(1))?;
        }
        self.writer.flush()
    }
}

/// Writes the head of the file: the time step and the signals.
fn declare<W: Write>(
    writer: &mut vcd::Writer<W>,
    sample: &Sample,
    names: &BTreeMap<String, String>,
) -> io::Result<Vec<Signal>> {
    let called = |point: String| match names.get(&point) {
        // What is no letter, digit or underscore would end the name.
        Some(name) => {
            let name = name.replace(|c: char| !c.is_ascii_alphanumeric(), "_");
            format!("{point}_{name}")
        }
        None => point,
    };
    let mut signals = Vec::new();
    writer.version(concat!("unoclp ", env!("CARGO_PKG_VERSION")))?;
    writer.timescale(1, TimescaleUnit::MS)?;
    writer.add_module("unoclp")?;
    let inputs = points(sample.board.inputs).map(|point| format!("I{}", point.number()));
    let outputs = points(sample.board.outputs).map(|point| format!("Q{}", point.number()));
    for name in inputs.chain(outputs) {
        signals.push(Signal::Bit(writer.add_wire(1, &called(name))?));
    }
    for number in 1..=sample.timers.len() {
        writer.add_module(&called(format!("T{number}")))?;
        signals.push(Signal::Bit(writer.add_wire(1, "Q")?));
        signals.push(Signal::Word(
            writer.add_wire(u32::BITS, "elapsed_ms")?,
            u32::BITS,
        ));
        writer.upscope()?;
    }
    for Quantity { name, bits, .. } in &sample.quantities {
        let id = writer.add_wire(*bits, &called(name.clone()))?;
        signals.push(match bits {
            1 => Signal::Bit(id),
            _ => Signal::Word(id, *bits),
        });
    }
    writer.upscope()?;
    writer.enddefinitions()?;
    Ok(signals)
}

impl Signal {
    fn write<W: Write>(self, writer: &mut vcd::Writer<W>, value: u32) -> io::Result<()> {
        match self {
            Signal::Bit(id) => writer.change_scalar(id, value != 0),
            Signal::Word(id, width) => {
                let bits = (0..width).rev().map(|bit| value >> bit & 1 != 0);
                writer.change_vector(id, bits.map(Value::from))
            }
        }
    }
}

/// The core as an engine for scenarios, with a trace of all its scans.
pub struct RecordedEngine<W: Write> {
    engine: HostEngine,
    /// What its program uses.
    used: Used,
    recorder: Recorder<W>,
    /// The last scan: its reading of the millisecond clock, and its time in ms after the first.
    last: Option<(Millis, u64)>,
}

impl<W: Write> RecordedEngine<W> {
    /// An engine that records to this recorder.
    pub fn new(recorder: Recorder<W>, board: Board) -> RecordedEngine<W> {
        RecordedEngine {
            engine: HostEngine::new(board),
            used: Used::default(),
            recorder,
            last: None,
        }
    }

    /// Ends the trace; see [`Recorder::finish`].
    pub fn finish(&mut self) -> io::Result<()> {
        self.recorder.finish()
    }
}

impl<W: Write> Engine for RecordedEngine<W> {
    type Error = io::Error;

    fn load(&mut self, file: &[u8]) -> io::Result<Result<(), Refusal>> {
        let Ok(loaded) = self.engine.load(file);
        let plc = self.engine.machine().map(Machine::plc);
        self.used = plc.map_or_else(Used::default, |plc| Used::of(plc.needs(), plc.steps()));
        Ok(loaded)
    }

    fn scan(&mut self, inputs: &Inputs, now: Millis) -> io::Result<Outcome> {
        let Ok(outcome) = self.engine.scan(inputs, now);
        let at = match self.last {
            // The clock of the PLC wraps, the time of the trace does not.
            Some((last, at)) => at + u64::from(now.wrapping_sub(last)),
            None => 0,
        };
        self.last = Some((now, at));
        if let Some(machine) = self.engine.machine() {
            self.recorder
                .record(at, &Sample::of(machine, &self.used, inputs, now))?;
        }
        Ok(outcome)
    }

    fn restart(&mut self) -> io::Result<()> {
        let Ok(()) = self.engine.restart();
        Ok(())
    }

    fn look(&mut self, cell: Cell) -> io::Result<i32> {
        let Ok(value) = self.engine.look(cell);
        Ok(value)
    }

    fn poke(&mut self, cell: Cell, value: i32) -> io::Result<()> {
        let Ok(()) = self.engine.poke(cell, value);
        Ok(())
    }

    fn pwm(&mut self, output: u8) -> io::Result<u8> {
        let Ok(duty) = self.engine.pwm(output);
        Ok(duty)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashMap;
    use unoclp_host_sim::random::{Random, random_inputs, random_program};
    use vcd::{Command, Parser};

    /// Reads a trace back: the value of each signal at each time that the file mentions.
    fn read_back(trace: &[u8]) -> Vec<(u64, HashMap<String, u32>)> {
        let mut parser = Parser::new(trace);
        let header = parser.parse_header().unwrap();
        assert_eq!(header.timescale, Some((1, TimescaleUnit::MS)));
        let mut names = HashMap::new();
        let top = header.find_scope(&["unoclp"]).unwrap();
        collect(&top.items, "", &mut names);
        let mut values = HashMap::new();
        let mut moments = Vec::new();
        let mut time = None;
        for command in parser {
            match command.unwrap() {
                Command::Timestamp(at) => {
                    moments.extend(time.map(|time| (time, values.clone())));
                    assert!(time < Some(at), "time goes on");
                    time = Some(at);
                }
                Command::ChangeScalar(id, value) => {
                    values.insert(names[&id].clone(), u32::from(value == Value::V1));
                }
                Command::ChangeVector(id, vector) => {
                    let bits = vector.iter();
                    let value = bits.fold(0, |word, bit| word << 1 | u32::from(bit == Value::V1));
                    values.insert(names[&id].clone(), value);
                }
                _ => {}
            }
        }
        moments.extend(time.map(|time| (time, values)));
        moments
    }

    fn collect(items: &[vcd::ScopeItem], path: &str, names: &mut HashMap<IdCode, String>) {
        for item in items {
            match item {
                vcd::ScopeItem::Var(var) => {
                    names.insert(var.code, format!("{path}{}", var.reference));
                }
                vcd::ScopeItem::Scope(scope) => {
                    collect(&scope.items, &format!("{}.", scope.identifier), names);
                }
                _ => {}
            }
        }
    }

    #[test]
    fn a_trace_reads_back_as_the_run_was() {
        let mut random = Random::new(3);
        for _ in 0..50 {
            let program = random_program(&mut random);
            let mut trace = Vec::new();
            let mut engine = RecordedEngine::new(Recorder::new(&mut trace), Board::UNO);
            engine.load(program.as_bytes()).unwrap().unwrap();
            let mut reference = Machine::new(
                unoclp_program::load(program.as_bytes(), unoclp_core::Board::UNO).unwrap(),
            );
            let used = Used::of(reference.plc().needs(), reference.plc().steps());
            // Across the wrap of the clock.
            let start = Millis::MAX - 20;
            let mut image = Inputs::default();
            let mut run = Vec::new();
            for at in 0..60 {
                image = random_inputs(&mut random, reference.plc().needs(), image);
                let now = start.wrapping_add(at);
                let _ = engine.scan(&image, now).unwrap();
                let _ = reference.scan_observed(image, now, |_, _| ());
                run.push(Sample::of(&reference, &used, &image, now));
            }
            engine.finish().unwrap();

            let moments = read_back(&trace);
            assert_eq!(moments.last().unwrap().0, 60);
            for (at, sample) in run.iter().enumerate() {
                // The file mentions only times at which something changes.
                let moment = moments.iter().rfind(|(time, _)| *time <= at as u64);
                let values = &moment.unwrap().1;
                for point in points(sample.board.inputs) {
                    let name = format!("I{}", point.number());
                    assert_eq!(
                        values[&name] != 0,
                        sample.inputs.get(point),
                        "{name} at {at}"
                    );
                }
                for point in points(sample.board.outputs) {
                    let name = format!("Q{}", point.number());
                    assert_eq!(
                        values[&name] != 0,
                        sample.outputs.get(point),
                        "{name} at {at}"
                    );
                }
                for quantity in &sample.quantities {
                    let bits = u32::MAX >> (32 - quantity.bits);
                    assert_eq!(
                        values[&quantity.name],
                        quantity.value.cast_unsigned() & bits
                    );
                }
                for (number, timer) in (1..).zip(&sample.timers) {
                    assert_eq!(values[&format!("T{number}.Q")] != 0, timer.q);
                    assert_eq!(values[&format!("T{number}.elapsed_ms")], timer.elapsed);
                }
            }
        }
    }
}
