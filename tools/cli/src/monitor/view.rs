//! From the app to the screen. Whatever colour says, a symbol says too: `●` is 1, `!` is forced.

use super::app::App;
use super::program::{Program, read};
use crate::lamps::{Lamp, Lamps, Sides};
use crate::panel::Marked;
use crate::variables::lines;
use crate::{messages, screen};
use ratatui::Frame;
use ratatui::layout::{Constraint, Layout, Rect};
use ratatui::style::{Color, Modifier, Style};
use ratatui::text::{Line, Span};
use ratatui::widgets::{Block, Borders, Paragraph};
use unoclp_client::map::{State, flag};
use unoclp_client::watch::{Forces, Meter, Reading, Side};
use unoclp_program::used::real;

/// Header and footer.
const BAR: Style = Style::new().add_modifier(Modifier::REVERSED);
/// What is 1.
const ON: Style = Style::new().fg(Color::Green).add_modifier(Modifier::BOLD);
/// What a person should see.
const WARNING: Style = Style::new().fg(Color::Yellow).add_modifier(Modifier::BOLD);

/// The most columns of the name of a timer or counter.
const LONGEST_NAME: usize = 12;
/// Columns of a timer or counter.
const METER: u16 = 38;
/// From this width on inputs and outputs stand side by side.
const SIDE_BY_SIDE: u16 = 76;

/// Draws the app, and tells it how many lines of the rungs fit.
pub(super) fn draw(app: &mut App, frame: &mut Frame) {
    if screen::is_too_small(frame) {
        return;
    }
    let width = frame.area().width;
    let mut panels = Vec::new();
    // The columns of the first of two that stand side by side.
    let mut share = width;
    if let Some(reading) = &app.reading {
        let inputs = lamps(
            app,
            'I',
            app.board.inputs,
            reading.inputs,
            reading.forced_inputs,
        );
        let outputs = lamps(
            app,
            'Q',
            app.board.outputs,
            reading.outputs,
            reading.forced_outputs,
        );
        let sides = Sides::new(&inputs, &outputs, SIDE_BY_SIDE, frame.area());
        let inputs = (inputs_title(app), sides.inputs);
        let outputs = (outputs_title(app), sides.outputs);
        match sides.share {
            Some(columns) => {
                share = columns;
                panels.push(vec![inputs, outputs]);
            }
            None => panels.extend([vec![inputs], vec![outputs]]),
        }
        panels.push(vec![(messages::board(), board(app, reading, width))]);
        let program = app.program.as_ref().filter(|_| !app.differs());
        let memory = match program {
            Some(program) if program.variables.any() => {
                let watched = program.variables.watched(|spot| read(reading, spot));
                panels.push(vec![(messages::watched(), lines(watched, width.into()))]);
                let mut others = program.variables.analogue(|spot| read(reading, spot));
                others.extend(program.variables.others(|spot| read(reading, spot)));
                (messages::variables(), lines(others, width.into()))
            }
            Some(program) => (messages::memory(), memory_of(program, reading, width)),
            None => (messages::memory(), memory(reading, width)),
        };
        panels.push(vec![memory]);
        panels.retain(|panels| panels.iter().any(|(_, lines)| !lines.is_empty()));
        let meters = meters(app, reading, width);
        if !meters.is_empty() {
            panels.push(vec![(messages::timers_and_counters(), meters)]);
        }
    } else {
        let text = app.lost.clone().unwrap_or_else(messages::waiting);
        panels.push(vec![(messages::board(), wrap(text.split(' '), " ", width))]);
    }
    let heights = panels.iter().map(|row| {
        let lines = row.iter().map(|(_, lines)| lines.len()).max();
        Constraint::Length(lines.unwrap_or_default() as u16 + 1)
    });
    let bar = || [Constraint::Length(1)];
    let heights = bar()
        .into_iter()
        .chain(heights)
        .chain([Constraint::Min(0)])
        .chain(bar());
    let areas = Layout::vertical(heights).split(frame.area());
    header(app, frame, areas[0]);
    for (row, &area) in panels.into_iter().zip(&areas[1..]) {
        let first = if row.len() > 1 { share } else { width };
        let widths = [Constraint::Length(first), Constraint::Fill(1)];
        let columns = Layout::horizontal(widths).split(area);
        for ((title, lines), &column) in row.into_iter().zip(columns.iter()) {
            panel(title, lines, frame, column);
        }
    }
    rungs(app, frame, areas[areas.len() - 2]);
    footer(app, frame, areas[areas.len() - 1]);
}

fn header(app: &App, frame: &mut Frame, area: Rect) {
    let state = match (&app.lost, &app.reading) {
        (Some(_), _) => messages::no_board(),
        (None, None) => "…".to_owned(),
        (None, Some(reading)) => {
            let board = &reading.diagnostics;
            let state = match board.waits_for_program() {
                true => messages::empty_board(),
                false => board.state.map_or("?", State::name).to_owned(),
            };
            let forced = if board.has(flag::FORCED) {
                messages::forced_flag()
            } else {
                String::new()
            };
            let seconds = board.uptime / 1000;
            format!("{forced}{state}  {seconds} s")
        }
    };
    let right = Line::raw(format!("{state} "));
    let at = messages::at(&app.identity, &app.place);
    let name = match &app.program {
        Some(program) => format!(" {}  {at}", program.name()),
        None => format!(" {at}"),
    };
    let widths = [
        Constraint::Fill(1),
        Constraint::Length(right.width() as u16),
    ];
    let [left, right_area] = Layout::horizontal(widths).areas(area);
    frame.render_widget(Line::raw(name).style(BAR), left);
    frame.render_widget(right.style(BAR), right_area);
}

/// The keys, the most important first: a narrow screen cuts the others off.
fn footer(app: &App, frame: &mut Frame, area: Rect) {
    let state = app.reading.as_ref().and_then(|r| r.diagnostics.state);
    let run = match state {
        Some(State::Run) => messages::stop(),
        _ => messages::run(),
    };
    let other = match app.side {
        Side::Inputs => messages::to_outputs(),
        Side::Outputs => messages::to_inputs(),
    };
    let view = match &app.program {
        Some(program) => format!("  v {}", program.drawn.other()),
        None => String::new(),
    };
    let keys = messages::monitor_keys(run, other, view);
    frame.render_widget(Line::raw(keys).style(BAR), area);
}

/// A titled rule, and lines below it.
fn panel(title: String, lines: Vec<Line<'static>>, frame: &mut Frame, area: Rect) {
    let block = Block::new()
        .borders(Borders::TOP)
        .title(format!("─ {title} "));
    frame.render_widget(Paragraph::new(lines).block(block), area);
}

fn inputs_title(app: &App) -> String {
    match app.side {
        Side::Inputs => messages::inputs_force(app.board.inputs),
        Side::Outputs => messages::inputs(),
    }
}

fn outputs_title(app: &App) -> String {
    match app.side {
        Side::Outputs => messages::outputs_force(app.board.outputs),
        Side::Inputs => messages::outputs(),
    }
}

/// ` I1● start  I2○!stop`
fn lamps(app: &App, letter: char, count: u8, image: u32, forces: Forces) -> Lamps {
    let program = app.program.as_ref().filter(|_| !app.differs());
    let lamp = |index: u8| {
        let point = format!("{letter}{}", index + 1);
        let forced = if forces.get(index).is_some() {
            "!"
        } else {
            " "
        };
        Lamp {
            name: program.and_then(|program| program.names().get(&point).cloned()),
            shown: vec![
                Span::raw(format!(" {point}")),
                lamp(image >> index & 1 != 0),
                Span::styled(forced, WARNING),
            ],
        }
    };
    Lamps((0..count).map(lamp).collect())
}

fn lamp(on: bool) -> Span<'static> {
    if on {
        Span::styled("●", ON)
    } else {
        Span::raw("○")
    }
}

/// What the board says of itself, and what a person should know.
fn board(app: &App, reading: &Reading, width: u16) -> Vec<Line<'static>> {
    let board = &reading.diagnostics;
    let [last, least, most] = board.scan_times.map(micros);
    let volts = messages::volts(board.supply);
    let figures = messages::figures(last, least, most, volts, board.free_stack);
    let history = messages::history(messages::start(board.cause), board.restarts, board.faults);
    let mut lines = vec![Line::raw(figures), Line::raw(history)];
    let mut warn = |text: String| {
        let wrapped = wrap(text.split(' '), " ", width);
        lines.extend(wrapped.into_iter().map(|line| line.style(WARNING)));
    };
    if let Some(why) = &app.lost {
        warn(messages::lost(why));
    }
    if board.waits_for_program() {
        warn(messages::no_program_yet());
    } else if let Some(trouble) = board.trouble {
        let own = app.program.as_ref().filter(|_| !app.differs());
        let (of, trouble) = match (board.state, own) {
            (Some(State::Fault), Some(program)) => (String::new(), program.in_text(trouble)),
            (Some(State::Fault), None) => (String::new(), trouble),
            _ => (messages::last_upload(), trouble),
        };
        warn(format!("{of}{}", messages::trouble(trouble)));
        if let Some(stands) = own.and_then(|program| program.stands(trouble)) {
            warn(stands);
        }
    }
    for (flag, text) in [
        (flag::STOP_SWITCH, messages::switch_closed()),
        (flag::UPLOAD, messages::upload_under_way()),
        (flag::CARD_FAILED, messages::card_failed()),
    ] {
        if board.has(flag) {
            warn(text);
        }
    }
    let is_other = app.differs() && !board.waits_for_program();
    if let Some(program) = app.program.as_ref().filter(|_| is_other) {
        warn(messages::another_program(
            program.name(),
            board.program.bytes,
            format!("{:04X}", board.program.sum),
            program.kept.bytes,
            format!("{:04X}", program.kept.sum),
        ));
    }
    if app.lingering != 0 {
        let outputs = (0..app.board.outputs).filter(|index| app.lingering >> index & 1 != 0);
        let outputs: Vec<String> = outputs.map(|index| format!("Q{}", index + 1)).collect();
        let outputs = outputs.join(" ");
        let is_known = app.program.is_some() && !app.differs();
        warn(match is_known {
            true => messages::stays_on(outputs),
            false => messages::may_stay_on(outputs),
        });
    }
    if let Some(said) = &app.said {
        warn(said.clone());
    }
    lines
}

/// A scan time; more than the board can tell is told so.
fn micros(time: u16) -> String {
    if time >= 0x7FFF {
        messages::over(32766)
    } else {
        time.to_string()
    }
}

/// Markers, analogue inputs, and the registers that are not 0.
fn memory(reading: &Reading, width: u16) -> Vec<Line<'static>> {
    let mut lines = Vec::new();
    if let Some(markers) = reading.markers {
        let groups: Vec<Vec<Span>> = (0..64)
            .step_by(8)
            .map(|first| group(markers, first))
            .collect();
        // 14 columns each.
        let per_line = usize::from(width / 14).clamp(1, 8);
        lines.extend(groups.chunks(per_line).map(|groups| groups.concat().into()));
    }
    let analogue = (0..).zip(&reading.analogue);
    let mut values: Vec<String> = analogue.map(|(n, value)| format!("A{n} {value}")).collect();
    let registers = (1..).zip(&reading.registers);
    let set = registers.filter(|(_, value)| **value != 0);
    values.extend(set.map(|(n, value)| format!("D{n} {value}")));
    if !reading.registers.is_empty() && reading.registers.iter().all(|&value| value == 0) {
        values.push(messages::all_registers());
    }
    lines.extend(wrap(values.iter().map(String::as_str), "  ", width));
    lines
}

/// What this program uses, by the names that it gives, and what else is not 0.
fn memory_of(program: &Program, reading: &Reading, width: u16) -> Vec<Line<'static>> {
    let used = program.used();
    let called = |point: String| program.names().get(&point).unwrap_or(&point).clone();
    let bit = |number: u8| reading.markers.unwrap_or_default() >> (number - 1) & 1 != 0;
    let markers = (1..=64).filter(|number| used.markers.contains(number) || bit(*number));
    let markers = markers.filter(|_| reading.markers.is_some()).map(|number| {
        let lamp = if bit(number) { '●' } else { '○' };
        format!("{} {lamp}", called(format!("M{number}")))
    });
    let analogue = (0..).zip(&reading.analogue);
    let analogue = analogue.filter(|(n, value)| used.analogue.contains(n) || **value != 0);
    let analogue = analogue.map(|(n, value)| format!("{} {value}", called(format!("A{n}"))));
    let registers = (1..).zip(&reading.registers);
    let registers = registers.filter(|(n, value)| used.registers.contains(n) || **value != 0);
    let registers = registers.map(|(n, value)| {
        let name = called(format!("D{n}"));
        match used.reals.contains(&n) {
            true => format!("{name} {}", real(*value)),
            false => format!("{name} {value}"),
        }
    });
    let all: Vec<String> = markers.chain(analogue).chain(registers).collect();
    wrap(all.iter().map(String::as_str), "  ", width)
}

/// ` M1  ○○○○●○○○`
fn group(markers: u64, first: u8) -> Vec<Span<'static>> {
    let name = Span::raw(format!(" M{:<3} ", first + 1));
    let lamps = (first..first + 8).map(|index| lamp(markers >> index & 1 != 0));
    [name].into_iter().chain(lamps).collect()
}

/// The timers and counters of the program, where the board has as many.
fn meters(app: &App, reading: &Reading, width: u16) -> Vec<Line<'static>> {
    let Some(program) = app.program.as_ref().filter(|_| !app.differs()) else {
        return Vec::new();
    };
    let timers = reading.timers.iter().zip(&program.timers).zip(1..);
    let called = |point: String| -> String {
        let name = program.names().get(&point).unwrap_or(&point);
        name.chars().take(LONGEST_NAME).collect()
    };
    let timers = timers.map(|((meter, delay), n)| {
        let name = called(format!("T{n}"));
        meter_text(&format!("{name} {}", delay.letters()), *meter)
    });
    let counters = reading.counters.iter().zip(1..);
    let counters = counters.map(|(meter, n)| meter_text(&called(format!("C{n}")), *meter));
    let all: Vec<String> = timers.chain(counters).collect();
    let per_line = usize::from(width / METER).max(1);
    let lines = all
        .chunks(per_line)
        .map(|meters| Line::raw(meters.concat()));
    // The rungs show them all.
    lines.take(6).collect()
}

/// ` T1 TON   ████░░░░░ 1200/5000`, of 38 columns.
fn meter_text(name: &str, meter: Meter) -> String {
    let Meter { value, preset } = meter;
    let figures = format!("{value}/{preset}");
    let wide = name.chars().count().max(9);
    let bar = usize::from(METER).saturating_sub(2 + wide + figures.len() + 2);
    let (done, all) = (
        i64::from(value.clamp(0, preset.max(0))),
        i64::from(preset.max(1)),
    );
    let filled = (bar as i64 * done / all) as usize;
    let (full, empty) = ("█".repeat(filled), "░".repeat(bar - filled));
    format!(" {name:<9} {full}{empty} {figures} ")
}

fn rungs(app: &mut App, frame: &mut Frame, area: Rect) {
    let Some(program) = app
        .program
        .as_ref()
        .filter(|_| app.reading.is_some() && !app.differs())
    else {
        return;
    };
    let read = |point| {
        app.reading
            .as_ref()
            .and_then(|reading| read(reading, point))
    };
    let width = usize::from(area.width);
    let (lines, _) = program
        .drawn
        .lines(&app.flow, &Marked::default(), width, read);
    let what = program.drawn.title(read);
    let height = usize::from(area.height.saturating_sub(1));
    app.page = height.saturating_sub(1).max(1);
    app.top = app.top.min(lines.len().saturating_sub(height));
    let count = lines.len();
    let title = if count > height && height > 0 {
        messages::lines_of(what, app.top + 1, app.top + height, count)
    } else {
        what
    };
    let shown = lines.into_iter().skip(app.top).take(height).collect();
    panel(title, shown, frame, area);
}

/// These parts in lines of this width, none broken unless it is wider, with a blank before each line.
fn wrap<'p>(parts: impl Iterator<Item = &'p str>, gap: &str, width: u16) -> Vec<Line<'static>> {
    let mut lines: Vec<String> = Vec::new();
    let columns = |text: &str| text.chars().count();
    for part in parts {
        match lines.last_mut() {
            Some(line) if columns(line) + columns(gap) + columns(part) <= usize::from(width) => {
                line.push_str(gap);
                line.push_str(part);
            }
            _ => lines.push(format!(" {part}")),
        }
    }
    lines.into_iter().map(Line::raw).collect()
}
