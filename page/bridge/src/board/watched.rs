//! The program that a board is said to run, and what of it is shown live.

use crate::answer::{answer, spoken};
use crate::program::source;
use crate::words::{self, No, both};
use unoclp_checked::SourceMap;
use unoclp_client::diagnostics::{Kept, Trouble};
use unoclp_client::live::Parts;
use unoclp_client::map::State;
use unoclp_client::watch::{Reading, Scope};
use unoclp_core::isa::Class;
use unoclp_core::{Fault, Image, Inputs, Millis};
use unoclp_draw::{Ladder, Nets, Symbol, time};
use unoclp_exercise::live::{Boxes, Flow, Lines, Mark, Now, Twin};
use unoclp_host_sim::engine::Machine;
use unoclp_program::Source;
use unoclp_program::used::is_real;
use unoclp_workspace::Analysis;

/// A program, to show a board by.
pub struct Watched {
    /// How a board keeps it.
    kept: Kept,
    twin: Twin,
    nets: Nets,
    boxes: Boxes,
    lines: Lines,
    /// The steps of boxes that show a value: the box's last step, the one after which the value is its, and whether that
    /// is a REAL.
    values: Vec<(usize, usize, bool)>,
    map: SourceMap,
    scope: Scope,
    parts: Parts,
}

answer! {
    /// What is shown live.
    pub struct Live as "Live" {
        /// The nets that carry power.
        nets: Vec<u32>,
        /// Steps of timers and counters, their presets and what they have come to.
        boxes: Vec<(usize, String, String)>,
        /// Steps, and the value after them.
        values: Vec<(usize, Number)>,
        /// For each line of the text: null, whether it has power, a number, or the literal of another type: `T#1s`.
        lines: Vec<Shown>,
    }
}

spoken! {
    /// What a box shows.
    enum Number as "number", either {
        Whole(i32),
        Real(f32),
    }
}

spoken! {
    /// What a line shows.
    enum Shown as "boolean | number | string | null", either {
        Power(Option<bool>),
        Value(i32),
        Literal(String),
    }
}

impl Watched {
    /// The program of a text.
    ///
    /// # Errors
    /// That there is none.
    pub fn new(text: &Analysis) -> Result<Watched, No> {
        let source = source(text)?;
        let Some(ladder) = text.ladder() else {
            return Err(both(words::faulty).into());
        };
        let used = &source.size.used;
        // It was a program before.
        let copy = source.checked.copy().map_err(|_| both(words::faulty))?;
        let machine = Machine::new(copy);
        Ok(Watched {
            kept: Kept::of(source.program()),
            boxes: Boxes::new(source.program()),
            lines: Lines::new(source),
            values: values(source, ladder),
            parts: Parts {
                markers: !used.markers.is_empty(),
                analogue: !used.analogue.is_empty(),
                registers: !used.registers.is_empty(),
            },
            scope: Scope {
                registers: source.program().registers() as u16,
                timers: machine.plc().timers(0).count() as u16,
                counters: machine.plc().counters().count() as u16,
            },
            twin: Twin::new(machine),
            nets: ladder.nets.clone(),
            map: source.map.clone(),
        })
    }

    /// How much of a board there is to read for it.
    pub fn scope(&self) -> (Scope, Parts) {
        (self.scope, self.parts)
    }

    /// Whether the board keeps this program.
    pub fn is_on(&self, reading: &Reading) -> bool {
        !self.kept.differs(reading.diagnostics.program)
    }

    /// The line of the text for a fault of this program as it runs.
    pub fn line(&self, trouble: Trouble) -> Option<u32> {
        let code = trouble.line.filter(|_| trouble.is_of_the_run())?;
        self.map.of_code(code).map(|place| place.line as u32)
    }

    /// The program as it stands, to set something in it between two scans.
    pub fn machine(&mut self) -> &mut Machine {
        self.twin.machine_mut()
    }

    /// A scan of it, and what it has done.
    pub fn scan(&mut self, inputs: Inputs, now: Millis) -> (Flow, Result<Image, Fault>) {
        self.twin.scan(inputs, now)
    }

    /// What there is to show of a reading.
    pub fn live(&mut self, reading: &Reading) -> Live {
        let flow = match reading.diagnostics.state {
            Some(State::Fault) => Flow::default(),
            _ => reading.with_snapshot(|board, inputs, now| self.twin.flow(board, inputs, now)),
        };
        self.show(&flow)
    }

    /// What there is to show of a scan.
    pub fn show(&self, flow: &Flow) -> Live {
        let shown = |mark| match mark {
            Mark::Power(power) => Shown::Power(power),
            Mark::Value(None) => Shown::Power(None),
            Mark::Value(Some(value)) => match value.parse() {
                Ok(number) => Shown::Value(number),
                Err(_) => Shown::Literal(value),
            },
        };
        let count = |step| {
            Some(match self.boxes.now(step, flow)? {
                Now::Time { preset, elapsed } => (step, time(preset), time(elapsed)),
                Now::Events { preset, value } => (step, preset.to_string(), value.to_string()),
            })
        };
        let values = self.values.iter();
        Live {
            nets: self.nets.power(&flow.acc).on().collect(),
            boxes: self.boxes.steps().filter_map(count).collect(),
            values: values
                .filter_map(|&(step, behind, is_real)| {
                    let value = flow.value(behind)?;
                    Some((
                        step,
                        match is_real {
                            true => Number::Real(f32::from_bits(value.cast_unsigned())),
                            false => Number::Whole(value),
                        },
                    ))
                })
                .collect(),
            lines: self.lines.marks(flow).into_iter().map(shown).collect(),
        }
    }
}

/// The boxes that work on a number.
fn values(source: &Source, ladder: &Ladder) -> Vec<(usize, usize, bool)> {
    let steps = source.program().steps();
    let steps: Vec<(Class, bool)> = steps
        .map(|step| (step.opcode.class(), is_real(&step, &source.size.used)))
        .collect();
    let is_number = |step: &&usize| {
        steps.get(**step).is_some_and(|(class, _)| {
            matches!(
                class,
                Class::Load | Class::Operation | Class::Comparison | Class::ValueContact
            )
        })
    };
    let boxes = ladder.elements.iter();
    let boxes = boxes.filter(|element| matches!(element.symbol, Symbol::Box { .. }));
    boxes
        .filter_map(|element| {
            let last = *element.steps.last()?;
            let number = *element.steps.iter().rev().find(is_number)?;
            let (_, is_real) = *steps.get(number)?;
            Some((last, number, is_real))
        })
        .collect()
}
