//! What the monitor shows, and which keys ask what of the board. It knows no terminal and no port, so tests
//! feed it both.

use super::program::Program;
use super::watcher::News;
use crate::messages;
use ratatui::crossterm::event::{KeyCode, KeyEvent, KeyEventKind, KeyModifiers};
use unoclp_client::map::{Command, State};
use unoclp_client::order::Order;
use unoclp_client::watch::{Forced, Reading, Side};
use unoclp_core::Board;
use unoclp_exercise::live::Flow;

/// A board, as far as it is known, and what a person does to it.
pub struct App {
    /// What the board there has.
    pub(super) board: Board,
    /// Where the board is.
    pub(super) place: String,
    /// What it says that it is.
    pub(super) identity: String,
    pub(super) program: Option<Program>,
    /// The last reading; none before the first.
    pub(super) reading: Option<Reading>,
    /// What its program does there.
    pub(super) flow: Flow,
    /// Why there is no newer one.
    pub(super) lost: Option<String>,
    /// What the person should know, until the next key.
    pub(super) said: Option<String>,
    /// Outputs that are lit since they were let go, and that no rung is known to write; bit 0 is output 01.
    pub(super) lingering: u32,
    /// Outputs that were let go here since the last reading.
    let_go: u32,
    /// Orders that nothing has come of yet: a reading may have begun before them.
    asked: u32,
    /// The seconds without a request after which the board is to end what is forced here.
    end_forcing: Option<u8>,
    /// It has been said that it cannot.
    is_endless_said: bool,
    /// What the digits force.
    pub(super) side: Side,
    /// The first line of the rungs that is shown.
    pub(super) top: usize,
    /// Lines of the rungs that fit.
    pub(super) page: usize,
    quit: bool,
}

impl App {
    /// A monitor that waits for the board at this place. What it forces ends at the board behind `end_forcing` seconds
    /// without a request, 1 to 254.
    pub fn new(
        place: String,
        board: Board,
        program: Option<Program>,
        end_forcing: Option<u8>,
    ) -> App {
        App {
            place,
            board,
            identity: String::new(),
            top: program.as_ref().map_or(0, |program| program.drawn.home()),
            program,
            reading: None,
            flow: Flow::default(),
            lost: None,
            said: None,
            lingering: 0,
            let_go: 0,
            asked: 0,
            end_forcing,
            is_endless_said: false,
            side: Side::Inputs,
            page: 1,
            quit: false,
        }
    }

    /// Whether the person wants to leave.
    pub(super) fn quit(&self) -> bool {
        self.quit
    }

    /// Whether the board keeps another program than the file's.
    pub(super) fn differs(&self) -> bool {
        match (&self.program, &self.reading) {
            (Some(program), Some(reading)) => program.kept.differs(reading.diagnostics.program),
            _ => false,
        }
    }

    /// Takes up what is new.
    pub fn hear(&mut self, news: News) {
        match news {
            News::Found {
                identity,
                may_be_reset,
            } => {
                self.asked = 0;
                self.identity = identity.to_string();
                self.board = identity.board().unwrap_or(self.board);
                if may_be_reset {
                    self.said = Some(messages::said_reset());
                }
            }
            News::Read(mut reading) => {
                self.lost = None;
                if let Some(before) = self.reading.as_ref().filter(|_| self.asked > 0) {
                    reading.forced_inputs = before.forced_inputs;
                    reading.forced_outputs = before.forced_outputs;
                    reading.forcing_ends = before.forcing_ends;
                }
                if let Some(program) = &mut self.program {
                    self.flow = match reading.diagnostics.state {
                        Some(State::Fault) => Flow::default(),
                        _ => program.flow(&reading),
                    };
                }
                self.note_forces(&reading);
                self.reading = Some(*reading);
            }
            News::Done => self.asked = self.asked.saturating_sub(1),
            News::Refused(why) => {
                self.asked = self.asked.saturating_sub(1);
                self.said = Some(why);
            }
            News::Lost(why) => {
                self.asked = 0;
                self.lost = Some(why);
            }
        }
    }

    /// What is forced at last, as far as this monitor knows.
    pub fn forced(&self) -> Forced {
        let reading = self.reading.as_ref();
        reading.map(Reading::forced).unwrap_or_default()
    }

    /// Sees what this reading's forces have in store for a person.
    fn note_forces(&mut self, now: &Reading) {
        let Some(before) = &self.reading else {
            if now.forced().any() {
                self.said = Some(messages::forced_before(now.forced()));
            }
            return;
        };
        let let_go = before.forced_outputs.points | std::mem::take(&mut self.let_go);
        let unwritten = match &self.program {
            Some(program) if !self.differs() => !program.written,
            _ => u32::MAX,
        };
        let free = !now.forced_outputs.points;
        self.lingering = (self.lingering | let_go) & unwritten & free & now.outputs;
        if now.diagnostics.state != Some(State::Run) {
            self.lingering = 0;
        }
    }

    /// Takes a key; gives what it asks of the board.
    pub fn key(&mut self, key: KeyEvent) -> Option<Order> {
        if key.kind == KeyEventKind::Release {
            return None;
        }
        match key.code {
            KeyCode::Up => self.top = self.top.saturating_sub(1),
            KeyCode::Down => self.top = self.top.saturating_add(1),
            KeyCode::PageUp => self.top = self.top.saturating_sub(self.page),
            KeyCode::PageDown => self.top = self.top.saturating_add(self.page),
            KeyCode::Home => self.top = 0,
            KeyCode::End => self.top = usize::MAX,
            // All others do something once only.
            _ if key.kind == KeyEventKind::Repeat => {}
            KeyCode::Char('c') if key.modifiers == KeyModifiers::CONTROL => self.quit = true,
            KeyCode::Char('q') | KeyCode::Esc => self.quit = true,
            KeyCode::Char('v') => {
                if let Some(program) = &mut self.program {
                    program.drawn.turn();
                    self.top = program.drawn.home();
                }
            }
            KeyCode::Char('o') => {
                self.side = match self.side {
                    Side::Inputs => Side::Outputs,
                    Side::Outputs => Side::Inputs,
                };
            }
            code => {
                self.said = None;
                let order = self.order(code);
                self.asked += u32::from(order.is_some());
                return order;
            }
        }
        None
    }

    fn order(&mut self, code: KeyCode) -> Option<Order> {
        match code {
            KeyCode::Char(digit @ '1'..='9') => self.force(digit as u8 - b'1'),
            KeyCode::Char('x') => {
                self.expect(&Order::Release);
                Some(Order::Release)
            }
            KeyCode::Char('s') => Some(Order::Command(Command::SingleScan)),
            KeyCode::Char('r') => Some(Order::Command(Command::Restart)),
            KeyCode::Char(' ') => {
                let state = self.reading.as_ref()?.diagnostics.state;
                let command = match state {
                    Some(State::Run) => Command::Stop,
                    _ => Command::Run,
                };
                Some(Order::Command(command))
            }
            _ => None,
        }
    }

    /// Takes a force for done until the next reading tells: whoever leaves before that is to know of it.
    fn expect(&mut self, order: &Order) {
        let Some(reading) = &mut self.reading else {
            return;
        };
        let before = reading.forced_outputs.points;
        match order {
            Order::Force(Side::Inputs, index, to) => reading.forced_inputs.set(*index, *to),
            Order::Force(Side::Outputs, index, to) => reading.forced_outputs.set(*index, *to),
            Order::Release => {
                (reading.forced_inputs, reading.forced_outputs) = Default::default();
            }
            _ => {}
        }
        self.let_go |= before & !reading.forced_outputs.points;
        if matches!(order, Order::Force(_, _, Some(_))) && self.end_forcing.is_some() {
            match &mut reading.forcing_ends {
                Some(ends) => *ends = self.end_forcing.unwrap_or(*ends),
                None if self.is_endless_said => {}
                None => {
                    self.is_endless_said = true;
                    self.said = Some(messages::endless());
                }
            }
        }
    }

    /// A point that is free is forced to 1, then to 0, and then let go.
    fn force(&mut self, index: u8) -> Option<Order> {
        let reading = self.reading.as_ref()?;
        let (count, forces) = match self.side {
            Side::Inputs => (self.board.inputs, reading.forced_inputs),
            Side::Outputs => (self.board.outputs, reading.forced_outputs),
        };
        if index >= count {
            return None;
        }
        let to = match forces.get(index) {
            None => Some(true),
            Some(true) => Some(false),
            Some(false) => None,
        };
        let order = Order::Force(self.side, index, to);
        self.expect(&order);
        Some(order)
    }
}
