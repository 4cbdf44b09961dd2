//! What the simulator shows, and how keys and time change it. It knows no terminal and no clock,
//! so tests feed it both.

use super::analogue::Knobs;
use super::buttons::{Buttons, KeyUp};
use super::drawn::Drawn;
use super::listing::Marked;
use super::memory::spans;
use super::slow::{self, Places, Standing, To};
use crate::messages;
use crate::variables::Variables;
use ratatui::crossterm::event::{KeyCode, KeyEvent, KeyEventKind, KeyModifiers};
use ratatui::text::Span;
use std::collections::{BTreeMap, BTreeSet};
use std::io::{self, Write};
use std::time::Duration;
use unoclp_core::{Fault, Image, Inputs, Millis, Plc, Point, TimerState};
use unoclp_exercise::live::{Flow, Followed};
use unoclp_exercise::wave::{Recorder, Sample};
use unoclp_host_sim::engine::Machine;
use unoclp_point::Address;
use unoclp_program::used::Used;
use unoclp_workspace::Ready;

/// Virtual time from scan to scan.
const SCAN: Duration = Duration::from_millis(1);

/// Inputs that every program has buttons for.
const FIRST_INPUTS: u8 = 4;

/// Outputs that every program has lamps for.
const FIRST_OUTPUTS: u8 = 4;

/// Inputs that a program has buttons for that reads one of those beyond: no fewer.
const MORE_INPUTS: u8 = 8;

/// The most time that one update makes up for: after a pause of the whole PC the simulation goes
/// on from where it was.
const MOST_BEHIND: Duration = Duration::from_millis(250);

/// The simulator: a program that runs, and what a person does to it.
pub struct App {
    program: Ready,
    machine: Machine,
    pub(super) drawn: Drawn,
    /// The line that a fault names, in the text of the program.
    pub(super) fault_line: Option<usize>,
    /// Its variables, if its language declares them.
    pub(super) variables: Variables,
    /// What the last scan did.
    pub(super) flow: Flow,
    pub(super) buttons: Buttons,
    pub(super) knobs: Knobs,
    /// What ended the program (NC-19); it runs again after a restart.
    pub(super) fault: Option<Fault>,
    /// Scans since the start, which is also the time in ms of the scan that comes next.
    pub(super) scans: u64,
    pub(super) running: bool,
    /// The scan that stands in slow motion.
    slow: Option<Followed>,
    /// Steps before which it stops.
    breaks: BTreeSet<usize>,
    /// The step before which it stops once.
    here: Option<usize>,
    /// The step that a person points to; none where the scan stands.
    cursor: Option<usize>,
    /// That is to be on the screen.
    pub(super) seeks: bool,
    places: Places,
    pub(super) scroll: Scroll,
    /// The page of the timers, counted from 0.
    pub(super) timer_page: usize,
    /// That of the memory.
    pub(super) memory_page: usize,
    /// Time since the program was opened, in which buttons are held.
    clock: Duration,
    /// Time that has passed and not yet been simulated.
    owed: Duration,
    quit: bool,
    recorder: Option<Recorder<Box<dyn Write>>>,
    /// Time of the next sample of the recording, in ms; a restart does not set it back.
    recorded: u64,
}

impl App {
    /// A simulator that runs this program from now on.
    ///
    /// # Errors
    /// None that the program did not have before.
    pub fn new(program: Ready) -> Result<App, Fault> {
        let drawn = Drawn::new(&program);
        let places = Places::new(&program);
        Ok(App {
            machine: Machine::new(program.checked.copy()?),
            knobs: Knobs::new(program.size.used.analogue.iter().copied()),
            fault: None,
            fault_line: None,
            variables: Variables::new(&program.variables),
            program,
            flow: Flow::default(),
            buttons: Buttons::new(KeyUp::Guessed),
            scans: 0,
            running: true,
            slow: None,
            breaks: BTreeSet::new(),
            here: None,
            cursor: None,
            seeks: false,
            places,
            scroll: Scroll::to(drawn.home()),
            drawn,
            timer_page: 0,
            memory_page: 0,
            clock: Duration::ZERO,
            owed: SCAN,
            quit: false,
            recorder: None,
            recorded: 0,
        })
    }

    /// What the program is called.
    pub(super) fn name(&self) -> &str {
        &self.program.name
    }

    /// What it calls its points.
    pub(super) fn names(&self) -> &BTreeMap<String, String> {
        self.program.symbols()
    }

    /// What it uses.
    fn used(&self) -> &Used {
        &self.program.size.used
    }

    /// Records every scan from now on.
    pub fn record_to(&mut self, recorder: Recorder<Box<dyn Write>>) {
        self.recorder = Some(recorder);
    }

    /// Tells how a momentary button learns that its key was let go.
    pub(super) fn set_key_up(&mut self, key_up: KeyUp) {
        self.buttons = Buttons::new(key_up);
    }

    /// Whether the scans are recorded.
    pub(super) fn recording(&self) -> bool {
        self.recorder.is_some()
    }

    /// Whether the person wants to leave.
    pub(super) fn quit(&self) -> bool {
        self.quit
    }

    /// What the fault is and where it stands: `lamp.il:12: too many backward jumps in one scan (NC-19)`, and that line.
    pub(super) fn faulty(&self) -> Option<[String; 2]> {
        let cause = messages::fault(self.fault?.cause);
        let line = self.fault_line.unwrap_or_default();
        let text = line
            .checked_sub(1)
            .and_then(|index| self.program.text.lines().nth(index));
        Some(match text {
            Some(text) => [
                format!("{}:{line}: {cause}", self.name()),
                text.trim().to_owned(),
            ],
            None => [format!("{}: {cause}", self.name()), String::new()],
        })
    }

    /// The outputs as the last scan left them.
    pub(super) fn outputs(&self) -> Image {
        self.machine.plc().outputs()
    }

    /// The inputs that have buttons, from 01 to this number: those from 05 on only where the program reads them.
    pub(super) fn inputs(&self) -> u8 {
        match self.used().inputs.last() {
            Some(&last) if last > FIRST_INPUTS => {
                let buttons = last.max(MORE_INPUTS);
                buttons.min(self.machine.plc().board().inputs)
            }
            _ => FIRST_INPUTS,
        }
    }

    /// The outputs that have lamps, from 01 to this number: those from 05 on only where the program names them.
    pub(super) fn outputs_shown(&self) -> u8 {
        let last = self.used().outputs.last().max(self.used().pwm.last());
        let most = self.machine.plc().board().outputs;
        last.map_or(FIRST_OUTPUTS, |last| (*last).max(FIRST_OUTPUTS))
            .min(most)
    }

    /// What the program counts and remembers, as it stood in the last scan: each with its name. The variables of one that
    /// declares them are in place of counters, registers and markers.
    pub(super) fn memory(&self) -> Vec<Vec<Span<'static>>> {
        let machine = &self.machine;
        let selected = self.knobs.selected().map(|input| format!("A{input}"));
        let of_points = self.used().quantities(machine.plc(), &self.world());
        let of_points = of_points
            .iter()
            .filter(|of| !self.variables.any() || of.name.starts_with(['A', 'P']));
        let of_points = of_points.map(|of| {
            let name = self.names().get(&of.name).unwrap_or(&of.name);
            spans(name, of, selected.as_ref() == Some(&of.name))
        });
        of_points
            .chain(self.variables.others(|point| self.read(point)))
            .collect()
    }

    /// The variables that PRINT asks to show.
    pub(super) fn watched(&self) -> Vec<Vec<Span<'static>>> {
        self.variables.watched(|point| self.read(point))
    }

    /// What the last scan has left at this point.
    pub(super) fn read(&self, point: Address) -> Option<i32> {
        let plc = self.machine.plc();
        let at = |number: u8| usize::from(number).checked_sub(1);
        let bit = |bits: u128, number: u8| Some((bits >> at(number)? & 1) as i32);
        let timer = |number: u8| self.timers().nth(at(number)?);
        let counter = |number: u8| plc.counters().nth(at(number)?);
        match point {
            Address::Input(n) => bit(self.world().points.0, n),
            Address::Output(n) => bit(plc.outputs().0, n),
            Address::Marker(n) => bit(plc.markers(), n),
            Address::TimerQ(n) => Some(timer(n)?.q.into()),
            Address::Elapsed(n) => Some(timer(n)?.elapsed.cast_signed()),
            Address::Reached(n) => Some(counter(n)?.q.into()),
            Address::AtZero(n) => Some((counter(n)?.value <= 0).into()),
            Address::Count(n) => Some(counter(n)?.value),
            Address::Register(n) => plc.registers().get(at(n)?).copied(),
            Address::Analogue(n) => self.world().analogue.get(usize::from(n)).map(|&v| v.into()),
            Address::Pwm(n) => Some(plc.pwm(n).into()),
            _ => None,
        }
    }

    /// What the next scan reads.
    fn world(&self) -> Inputs {
        let mut inputs = Inputs::from(self.buttons.closed());
        self.knobs.apply(&mut inputs);
        inputs
    }

    /// The timers as they stood in the last scan.
    pub(super) fn timers(&self) -> impl Iterator<Item = TimerState> {
        let last_scan = self.scans.saturating_sub(1) as Millis;
        self.machine.plc().timers(last_scan)
    }

    /// Lets time pass: one scan for each ms while the program runs.
    ///
    /// An error comes from the recording.
    pub fn advance(&mut self, elapsed: Duration) -> io::Result<()> {
        self.clock += elapsed;
        self.buttons.pass(self.clock);
        if !self.running {
            return Ok(());
        }
        self.owed += elapsed.min(MOST_BEHIND);
        while let Some(left) = self.owed.checked_sub(SCAN) {
            self.owed = left;
            self.scan(None)?;
            if !self.running {
                break;
            }
        }
        Ok(())
    }

    /// Where the scan stands in slow motion, and the line of that in the text.
    pub(super) fn standing(&self) -> Option<(Standing, Option<usize>)> {
        let standing = Standing::of(self.slow.as_ref()?.scan());
        let line = slow::line(&self.program.map, standing.step);
        Some((standing, line))
    }

    /// What is marked of a scan in slow motion.
    pub(super) fn marked(&self) -> Marked {
        Marked {
            next: self.standing().map(|(standing, _)| standing.step),
            breaks: self.breaks.clone(),
            cursor: self.pointed(),
        }
    }

    /// The step that a person points to, while a scan stands.
    fn pointed(&self) -> Option<usize> {
        let (standing, _) = self.standing()?;
        Some(self.cursor.unwrap_or(standing.step))
    }

    /// Points to the line or rung so many further on while a scan stands; else scrolls.
    fn go_by(&mut self, by: isize) {
        match (self.pointed(), self.drawn.among()) {
            (Some(step), Some(among)) => {
                let map = &self.program.map;
                self.cursor = Some(self.places.beyond(step, by, among, map));
                self.seeks = true;
            }
            _ => self.scroll.by(by),
        }
    }

    /// Goes on with a scan, or makes one: so far, and to the next breakpoint at most.
    fn scan(&mut self, to: Option<To>) -> io::Result<()> {
        if self.fault.is_some() {
            return Ok(());
        }
        let (places, breaks, here) = (&self.places, &self.breaks, self.here);
        let stops = |step| {
            let is_set = breaks.contains(&step) || here == Some(step);
            is_set || to.is_some_and(|to| to.stops(step, places))
        };
        let mut slow = match self.slow.take() {
            Some(slow) => slow,
            None => {
                // The clock of the PLC wraps (NC-9).
                let (inputs, now) = (self.world(), self.scans as Millis);
                let begin = |plc: &mut Plc<'_>| Followed::begin(plc, inputs, now);
                let slow = self.machine.with_plc(begin);
                if stops(0) {
                    self.stand(slow);
                    return Ok(());
                }
                slow
            }
        };
        let go = |plc: &mut Plc<'_>| slow.go(plc, stops);
        match self.machine.with_plc(go) {
            Ok(true) => {}
            Ok(false) => {
                self.stand(slow);
                return Ok(());
            }
            Err(fault) => {
                self.fault = Some(fault);
                let place = fault.line.and_then(|line| self.program.map.of_code(line));
                self.fault_line = place.map(|place| place.line);
                self.running = false;
            }
        }
        let now = slow.now();
        let mut flow = slow.flow().clone();
        flow.look(self.machine.plc(), now);
        flow.end(self.machine.plc());
        self.flow = flow;
        self.scans += 1;
        if let Some(recorder) = &mut self.recorder {
            recorder.record(
                self.recorded,
                &Sample::of(&self.machine, &self.program.size.used, slow.inputs(), now),
            )?;
            self.recorded += 1;
        }
        Ok(())
    }

    /// The scan stands: what is shown is what it has done so far.
    fn stand(&mut self, slow: Followed) {
        self.running = false;
        self.flow = slow.flow().clone();
        self.slow = Some(slow);
        (self.here, self.cursor) = (None, None);
        self.seeks = true;
    }

    /// Goes on in slow motion.
    fn slowly(&mut self, to: To) -> io::Result<()> {
        self.running = false;
        self.scan(Some(to))
    }

    /// Sets a breakpoint where a person points to, or takes it away.
    fn turn_break(&mut self) {
        if let Some(step) = self.pointed()
            && !self.breaks.remove(&step)
        {
            self.breaks.insert(step);
        }
    }

    /// Runs to where a person points to, at full speed.
    fn run_here(&mut self) {
        self.here = self.pointed();
        if self.here.is_some() {
            self.running = true;
            self.owed = Duration::ZERO;
        }
    }

    /// Takes a key. An error comes from the recording.
    pub fn key(&mut self, key: KeyEvent) -> io::Result<()> {
        match (key.code, key.kind) {
            (KeyCode::Char(digit @ '1'..='9'), kind) => {
                let number = digit as u8 - b'0';
                if let Some(input) = Point::new(number, self.inputs()) {
                    match kind {
                        KeyEventKind::Press => self.buttons.press(input, self.clock),
                        KeyEventKind::Repeat => self.buttons.repeat(input, self.clock),
                        KeyEventKind::Release => self.buttons.release(input),
                    }
                }
            }
            (_, KeyEventKind::Release) => {}
            (KeyCode::Up, _) => self.go_by(-1),
            (KeyCode::Down, _) => self.go_by(1),
            (KeyCode::PageUp, _) => self.go_by(-self.scroll.page()),
            (KeyCode::PageDown, _) => self.go_by(self.scroll.page()),
            (KeyCode::Home, _) => self.go_by(isize::MIN),
            (KeyCode::End, _) => self.go_by(isize::MAX),
            (KeyCode::Tab | KeyCode::Char('a'), KeyEventKind::Press) => self.knobs.select_next(),
            (KeyCode::Char('+' | '='), _) => self.knobs.turn(10),
            (KeyCode::Char('-'), _) => self.knobs.turn(-10),
            (KeyCode::Char('>'), _) => self.knobs.turn(100),
            (KeyCode::Char('<'), _) => self.knobs.turn(-100),
            (KeyCode::Char('s'), _) => {
                self.running = false;
                self.scan(None)?;
            }
            (KeyCode::Char('e'), _) => self.slowly(To::Element)?,
            (KeyCode::Char('g'), _) => self.slowly(To::Rung)?,
            (KeyCode::Char('l'), _) => self.slowly(To::Line)?,
            (_, KeyEventKind::Repeat) => {}
            (KeyCode::Char('b'), _) => self.turn_break(),
            (KeyCode::Char('h'), _) => self.run_here(),
            (KeyCode::Char('c'), _) if key.modifiers == KeyModifiers::CONTROL => self.quit = true,
            (KeyCode::Char('q') | KeyCode::Esc, _) => self.quit = true,
            (KeyCode::Char('m'), _) => self.buttons.switch_mode(),
            (KeyCode::Char('t'), _) => self.timer_page += 1,
            (KeyCode::Char('d'), _) => self.memory_page += 1,
            (KeyCode::Char('r'), _) => self.restart(),
            (KeyCode::Char('v'), _) => {
                self.drawn.turn();
                self.scroll = Scroll::to(self.drawn.home());
                self.seeks = self.slow.is_some();
            }
            (KeyCode::Char(' '), _) if self.fault.is_none() => {
                self.running = !self.running;
                self.here = None;
                self.owed = Duration::ZERO;
            }
            _ => {}
        }
        Ok(())
    }

    /// Starts the program again, as a reset of the board does: retentive markers are kept, and buttons stay
    /// as they are.
    fn restart(&mut self) {
        self.machine.with_plc(|plc: &mut Plc<'_>| plc.restart());
        self.running |= self.fault.take().is_some();
        self.flow = Flow::default();
        self.slow = None;
        (self.here, self.cursor) = (None, None);
        self.scans = 0;
        self.owed = SCAN;
    }

    /// Ends the recording, where there is one.
    pub fn finish(&mut self) -> io::Result<()> {
        match &mut self.recorder {
            Some(recorder) => recorder.finish(),
            None => Ok(()),
        }
    }
}

/// Which lines of a long text are on the screen.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Scroll {
    /// The first line shown, counted from 0.
    top: usize,
    /// Lines of the text.
    lines: usize,
    /// Lines of the screen.
    height: usize,
}

impl Scroll {
    /// From this line on.
    fn to(top: usize) -> Scroll {
        Scroll {
            top,
            ..Scroll::default()
        }
    }

    /// Has this line, counted from 0, be shown where it is not.
    pub(super) fn show(&mut self, line: usize) {
        if line < self.top || line >= self.top + self.height {
            self.top = line.saturating_sub(self.height / 2);
        }
    }

    /// Fits to a text and a screen of so many lines; gives the first line to show.
    pub(super) fn fit(&mut self, lines: usize, height: usize) -> usize {
        self.lines = lines;
        self.height = height;
        self.by(0);
        self.top
    }

    fn by(&mut self, lines: isize) {
        let last = self.lines.saturating_sub(self.height);
        self.top = self.top.saturating_add_signed(lines).min(last);
    }

    /// Lines of a page, less one that stays in sight.
    fn page(&self) -> isize {
        self.height.saturating_sub(1).max(1).cast_signed()
    }
}
