//! From the app to the screen. Whatever colour says, a symbol or the weight of a line says too.

use super::ON;
use super::app::App;
use super::memory::MemoryPage;
use super::slow::Standing;
use crate::lamps::{Lamp, Lamps, Sides};
use crate::{messages, screen};
use ratatui::Frame;
use ratatui::layout::{Constraint, Layout, Rect};
use ratatui::style::{Color, Modifier, Style};
use ratatui::text::{Line, Span};
use ratatui::widgets::{Block, Borders, Paragraph};
use std::collections::BTreeMap;
use unoclp_core::{Point, Target, TimerState};
use unoclp_exercise::scenario::points;

/// Header and footer.
const BAR: Style = Style::new().add_modifier(Modifier::REVERSED);

/// What has ended the program.
const FAULT: Style = Style::new().fg(Color::Red).add_modifier(Modifier::BOLD);

/// The fewest columns in which a timer can be read.
const TIMER_WIDTH: u16 = 38;

/// The most columns of a timer's name.
const LONGEST_NAME: usize = 12;

/// Columns of a lamp with its name.
const LAMP_WIDTH: u16 = 8;

/// Draws the app, and tells its scrolling what fits.
pub(super) fn draw(app: &mut App, frame: &mut Frame) {
    if screen::is_too_small(frame) {
        return;
    }
    let timers: Vec<TimerState> = app.timers().collect();
    let page = TimerPage::new(&timers, app.timer_page, frame.area());
    let memory = MemoryPage::new(app.memory(), app.memory_page, frame.area());
    let watched = MemoryPage::new(app.watched(), app.memory_page, frame.area());
    let pages = (page.pages, memory.pages.max(watched.pages));
    let title = match app.buttons.momentary() {
        true => messages::inputs_held(app.inputs()),
        false => messages::inputs_toggle(app.inputs()),
    };
    let columns = 2 * LAMP_WIDTH * u16::from(app.inputs());
    let sides = Sides::new(&input_lamps(app), &output_lamps(app), columns, frame.area());
    let faulty = app.faulty();
    let [
        header,
        buttons,
        fault_area,
        watched_area,
        timer_area,
        memory_area,
        rungs,
        footer,
    ] = Layout::vertical([
        Constraint::Length(1),
        Constraint::Length(sides.height()),
        Constraint::Length(if faulty.is_some() { 2 } else { 0 }),
        Constraint::Length(watched.height()),
        Constraint::Length(page.height()),
        Constraint::Length(memory.height()),
        Constraint::Fill(1),
        Constraint::Length(1),
    ])
    .areas(frame.area());
    let [input_area, output_area] = sides.areas(buttons);

    draw_header(app, frame, header);
    if let Some([fault, text]) = faulty {
        let lines = [format!(" {fault}"), format!("   {text}")];
        let lines = lines.map(|line| Line::raw(line).style(FAULT));
        frame.render_widget(Paragraph::new(lines.to_vec()), fault_area);
    }
    draw_panel(title, sides.inputs, frame, input_area);
    draw_panel(messages::outputs(), sides.outputs, frame, output_area);
    if watched.height() > 0 {
        draw_panel(messages::watched(), watched.lines(), frame, watched_area);
    }
    page.draw(&timers, app.names(), frame, timer_area);
    if memory.height() > 0 {
        let title = match app.variables.any() {
            true => messages::variables(),
            false => messages::memory(),
        };
        draw_panel(title, memory.lines(), frame, memory_area);
    }
    draw_rungs(app, frame, rungs);
    draw_footer(app, pages, frame, footer);
}

/// The keys, the most important first: a narrow screen cuts the others off.
fn draw_footer(app: &App, pages: (usize, usize), frame: &mut Frame, area: Rect) {
    let run = match app.running {
        true => messages::pause(),
        false => messages::run(),
    };
    let mode = match app.buttons.momentary() {
        true => messages::toggle(),
        false => messages::momentary(),
    };
    let timers = (pages.0 > 1).then(messages::t_timers).unwrap_or_default();
    let memory = (pages.1 > 1).then(messages::d_memory).unwrap_or_default();
    let knobs = match app.knobs.selected() {
        Some(input) => messages::turn(input),
        None => String::new(),
    };
    let view = app.drawn.other();
    let keys = match app.standing() {
        Some(_) => messages::slow_keys(),
        None => messages::sim_keys(run, view, mode, format!("{knobs}{timers}{memory}")),
    };
    frame.render_widget(Line::raw(keys).style(BAR), area);
}

fn draw_header(app: &App, frame: &mut Frame, area: Rect) {
    let state = match (&app.fault, app.running) {
        (Some(fault), _) => match app.fault_line {
            Some(line) => messages::fault_in_line(fault.cause.number(), line),
            None => format!("FAULT {}", fault.cause.number()),
        },
        (None, true) => "RUN".to_owned(),
        (None, false) => messages::paused(),
    };
    let recording = match app.recording() {
        true => messages::recording(),
        false => String::new(),
    };
    let (uptime, scans) = (app.scans.saturating_sub(1), app.scans);
    let right = Line::raw(format!(
        "{recording}{state}  {}",
        messages::ran(uptime, scans)
    ));
    let width = u16::try_from(right.width()).unwrap_or(u16::MAX);
    let [left, right_area] =
        Layout::horizontal([Constraint::Fill(1), Constraint::Length(width)]).areas(area);
    frame.render_widget(Line::raw(format!(" {}", app.name())).style(BAR), left);
    frame.render_widget(right.style(BAR), right_area);
}

/// A titled rule, and lines below it.
fn draw_panel(title: String, lines: Vec<Line<'static>>, frame: &mut Frame, area: Rect) {
    let block = Block::new()
        .borders(Borders::TOP)
        .title(format!("─ {title} "));
    frame.render_widget(Paragraph::new(lines).block(block), area);
}

fn input_lamps(app: &App) -> Lamps {
    let closed = app.buttons.closed();
    Lamps(
        points(app.inputs())
            .map(|input| named_lamp(app, format!("I{}", input.number()), closed.get(input)))
            .collect(),
    )
}

fn output_lamps(app: &App) -> Lamps {
    let on = app.outputs();
    let lamp = |output: Point| named_lamp(app, format!("Q{}", output.number()), on.get(output));
    Lamps(points(app.outputs_shown()).map(lamp).collect())
}

fn named_lamp(app: &App, point: String, on: bool) -> Lamp {
    let name = app.names().get(&point).cloned();
    let behind = if name.is_some() { " " } else { "  " };
    Lamp {
        name,
        shown: vec![Span::raw(format!(" {point} ")), lamp(on), Span::raw(behind)],
    }
}

fn lamp(on: bool) -> Span<'static> {
    if on {
        Span::styled("●", ON)
    } else {
        Span::raw("○")
    }
}

/// The timers that are shown at a time; none on a screen too low for them. The rungs show them all.
struct TimerPage {
    columns: u16,
    rows: u16,
    page: usize,
    pages: usize,
}

impl TimerPage {
    fn new(timers: &[TimerState], page: usize, screen: Rect) -> TimerPage {
        let columns = (screen.width / TIMER_WIDTH).max(1);
        let wanted = timers.len().div_ceil(columns.into());
        let wanted = u16::try_from(wanted).unwrap_or(u16::MAX);
        // What the other panels leave is shared with the rungs.
        let rows = wanted.min(screen.height.saturating_sub(6) / 3);
        let per_page = usize::from(columns) * usize::from(rows);
        let pages = timers.len().div_ceil(per_page.max(1)).max(1);
        TimerPage {
            columns,
            rows,
            page: page % pages,
            pages,
        }
    }

    /// Lines of the screen, with the title.
    fn height(&self) -> u16 {
        if self.rows == 0 { 0 } else { self.rows + 1 }
    }

    fn draw(
        &self,
        timers: &[TimerState],
        names: &BTreeMap<String, String>,
        frame: &mut Frame,
        area: Rect,
    ) {
        let per_page = usize::from(self.columns) * usize::from(self.rows);
        let first = self.page * per_page;
        let shown: Vec<_> = timers
            .iter()
            .enumerate()
            .skip(first)
            .take(per_page)
            .collect();
        let title = match self.pages {
            1 => messages::timers(),
            _ => messages::timers_of(first + 1, first + shown.len(), timers.len()),
        };
        let digits = shown
            .iter()
            .map(|(_, timer)| timer.preset.to_string().len());
        let digits = digits.max().unwrap_or(0);
        let width = usize::from(area.width / self.columns);
        let label = |number: usize| timer_name(number, names);
        let labels = shown
            .iter()
            .map(|(index, _)| label(index + 1).chars().count());
        let wide = labels.max().unwrap_or_default().max(4);
        let rows = shown.chunks(self.columns.into()).map(|row| {
            let timers = row.iter();
            timers
                .flat_map(|&(index, timer)| {
                    let label = format!("{:<wide$}", label(index + 1));
                    timer_spans(&label, timer, digits, width)
                })
                .collect()
        });
        draw_panel(title, rows.collect(), frame, area);
    }
}

/// What the program calls a timer, as far as there is room: `pause`; else `T1`.
fn timer_name(number: usize, names: &BTreeMap<String, String>) -> String {
    let own = format!("T{number}");
    let name = names.get(&own).unwrap_or(&own);
    name.chars().take(LONGEST_NAME).collect()
}

/// ` T1   TON ████░░░░░  1200/5000 Q1 ○ `, of this width where there is room.
fn timer_spans(label: &str, timer: &TimerState, digits: usize, width: usize) -> [Span<'static>; 5] {
    let TimerState {
        delay,
        target,
        preset,
        elapsed,
        q,
    } = *timer;
    let left = format!(" {label} {:<3} ", delay.letters());
    let right = format!(" {elapsed:>digits$}/{preset:<digits$} {} ", name(target));
    let bar = width.saturating_sub(left.chars().count() + right.len() + 3);
    let filled = match preset {
        0 => usize::from(q) * bar,
        preset => (bar as u64 * u64::from(elapsed) / u64::from(preset)) as usize,
    };
    [
        Span::raw(left),
        Span::raw("█".repeat(filled) + &"░".repeat(bar - filled)),
        Span::raw(right),
        lamp(q),
        Span::raw("  "),
    ]
}

fn draw_rungs(app: &mut App, frame: &mut Frame, area: Rect) {
    let width = usize::from(area.width);
    let standing = app.standing();
    let (lines, pointed) = app
        .drawn
        .lines(&app.flow, &app.marked(), width, |point| app.read(point));
    let what = app.drawn.title(|point| app.read(point));
    let what = match &standing {
        Some((standing, line)) => format!("{what}: {}", stands(standing, *line)),
        None => what,
    };
    let height = usize::from(area.height.saturating_sub(1));
    let mut top = app.scroll.fit(lines.len(), height);
    if let (true, Some(row)) = (std::mem::take(&mut app.seeks), pointed) {
        app.scroll.show(row);
        top = app.scroll.fit(lines.len(), height);
    }
    let count = lines.len();
    let shown: Vec<Line> = lines.into_iter().skip(top).take(height).collect();
    let title = if count > height && height > 0 {
        messages::lines_of(what, top + 1, top + shown.len(), count)
    } else {
        what
    };
    draw_panel(title, shown, frame, area);
}

/// `next: line 4  acc 1  value 12  stack 3 7`.
fn stands(standing: &Standing, line: Option<usize>) -> String {
    let Standing {
        acc, value, pushed, ..
    } = standing;
    let acc = u8::from(*acc);
    let stack: Vec<String> = pushed.iter().map(i32::to_string).collect();
    let stack = match stack[..] {
        [] => String::new(),
        _ => messages::slow_stack(stack.join(" ")),
    };
    match line {
        Some(line) => messages::slow_next(line, acc, value, stack),
        None => messages::slow_last(acc, value, stack),
    }
}

/// The short name of what a timer drives: `Q1`, `M12`.
fn name(target: Target) -> String {
    match target {
        Target::Output(number) => format!("Q{number}"),
        Target::Marker(number) => format!("M{number}"),
        Target::Timer(number) => format!("T{number}"),
    }
}
