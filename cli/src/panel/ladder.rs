//! The ladder diagram of a running program, energised parts with heavy lines: `┣━━┥ I1 ┝━━┤/I2 ├──( Q1 )─┤`.

use super::ON;
use ratatui::style::Style;
use ratatui::text::{Line, Span};
use std::collections::BTreeMap;
use unoclp_core::isa::Operand;
use unoclp_core::{CounterState, Delay, Instruction, Plc, TimerState};
use unoclp_ladder::{Address, Cell, Ladder, Names, Picture, Power, Style as Drawn};
use unoclp_source::{Source, names};

/// The columns before the left rail, for the number of the rung.
const MARGIN: usize = 4;

/// The rungs of a program.
pub struct Rungs {
    ladder: Ladder,
    names: Names,
    /// What the box of each step counts.
    counts: Vec<Option<Count>>,
}

/// What a box counts.
#[derive(Clone, Copy)]
enum Count {
    /// The time of the timer with this index.
    Time(usize),
    /// The counter with this index, up or down.
    Events(usize, &'static str),
}

/// What a program does at the moment, for its rungs to show.
#[derive(Clone, Debug, Default)]
pub struct Flow {
    /// acc behind each instruction that the last scan has run; empty before the first scan.
    pub acc: Vec<Option<bool>>,
    /// The timers as they stand.
    timers: Vec<TimerState>,
    /// The counters as they stand.
    counters: Vec<CounterState>,
    /// The registers as they stand, D 01 first.
    registers: Vec<i32>,
    /// The value behind the steps of which it is shown.
    pub values: BTreeMap<usize, i32>,
}

impl Flow {
    /// Takes up timers and counters as they stand at this time.
    pub fn look(&mut self, plc: &Plc<'_>, now: u32) {
        self.timers = plc.timers(now).collect();
        self.counters = plc.counters().collect();
        self.registers = plc.registers().to_vec();
    }
}

impl Flow {
    /// The value behind this step, if the last scan has run it.
    pub fn value(&self, step: usize) -> Option<i32> {
        self.acc.get(step).copied().flatten()?;
        self.values.get(&step).copied()
    }

    /// What this point holds, if it is a register or a counter.
    pub fn number(&self, point: Address) -> Option<i32> {
        let index = |number: u8| usize::from(number).checked_sub(1);
        match point {
            Address::Register(number) => self.registers.get(index(number)?).copied(),
            Address::Counter(number) => Some(self.counters.get(index(number)?)?.value),
            _ => None,
        }
    }
}

impl Rungs {
    /// The rungs of this program.
    pub fn new(program: &Source) -> Rungs {
        let steps = program.program().steps();
        let mut timers = 0..;
        let count = |step: Instruction<'_>| match step.operand {
            Operand::Count { counter, .. } => {
                let index = usize::from(counter).saturating_sub(1);
                Some(Count::Events(index, step.opcode.row().letters))
            }
            _ if Delay::of(step.opcode).is_some() => timers.next().map(Count::Time),
            _ => None,
        };
        let ladder = Ladder::new(steps.clone());
        Rungs {
            names: names(&program.map, &ladder),
            counts: steps.map(count).collect(),
            ladder,
        }
    }

    /// All rungs as lines of text, of this width where that is enough for them.
    pub fn lines(&self, flow: &Flow, width: usize) -> Vec<Line<'static>> {
        let live = |step: usize| self.live(step, flow);
        let drawing = self.ladder.draw(&Drawn {
            width: width.saturating_sub(MARGIN),
            names: &self.names,
            live: &live,
        });
        let power = self.ladder.nets.power(&flow.acc);
        let mut lines = Vec::new();
        for (index, picture) in drawing.rungs.iter().enumerate() {
            let head = &self.ladder.rungs[index];
            let part = head.part.map(unoclp_ladder::picture);
            lines.extend(part.map(|part| Line::raw(format!("    {part}:"))));
            let labels = head.labels.iter();
            lines.extend(labels.map(|label| Line::raw(format!("    L{label}:"))));
            lines.extend(rung(index + 1, picture, &power));
        }
        lines
    }

    /// `TON T1  120/5000 ms`, `CTU C1 3/10`
    fn live(&self, step: usize, flow: &Flow) -> Option<String> {
        match (*self.counts.get(step)?)? {
            Count::Time(index) => {
                let TimerState {
                    delay,
                    preset,
                    elapsed,
                    ..
                } = flow.timers.get(index)?;
                let digits = preset.to_string().len();
                let letters = delay.letters();
                let number = index + 1;
                Some(format!(
                    "{letters} T{number} {elapsed:>digits$}/{preset} ms"
                ))
            }
            Count::Events(index, letters) => {
                let CounterState { value, preset, .. } = flow.counters.get(index)?;
                let digits = preset.to_string().len();
                let number = index + 1;
                Some(format!("{letters} C{number} {value:>digits$}/{preset}"))
            }
        }
    }
}

/// The lines of a rung, its number before its first wire.
fn rung(number: usize, picture: &Picture, power: &Power) -> Vec<Line<'static>> {
    let line = |(row, cells): (usize, &Vec<Cell>)| {
        let margin = match row == picture.axis {
            true => format!("{number:>3} "),
            false => " ".repeat(MARGIN),
        };
        let mut spans = vec![Span::raw(margin)];
        let alike = |one: &Cell, other: &Cell| one.shown(power).1 == other.shown(power).1;
        for cells in cells.chunk_by(alike) {
            let shown = cells.iter().filter(|cell| cell.ch != '\0');
            let text: String = shown.map(|cell| cell.shown(power).0).collect();
            let style = match cells.first().is_some_and(|cell| cell.shown(power).1) {
                true => ON,
                false => Style::new(),
            };
            spans.push(Span::styled(text, style));
        }
        Line::from(spans)
    };
    picture.rows.iter().enumerate().map(line).collect()
}
