//! The loop of the simulator: frames out, key events in.

use super::app::App;
use super::buttons::KeyUp;
use super::view;
use crate::{ascii, screen};
use ratatui::DefaultTerminal;
use ratatui::crossterm::event::{
    self, Event, KeyboardEnhancementFlags, PopKeyboardEnhancementFlags,
    PushKeyboardEnhancementFlags,
};
use ratatui::crossterm::{execute, terminal};
use std::io::{self, stdout};
use std::panic;
use std::time::{Duration, Instant};

/// Time from frame to frame.
const FRAME: Duration = Duration::from_millis(33);

/// Runs the simulator in this terminal until the person leaves; virtual time follows real time.
///
/// The terminal is put back as it was, after a panic too. An error comes from the terminal or
/// from the recording.
pub fn run(mut app: App) -> io::Result<()> {
    let mut terminal = ratatui::try_init()?;
    let outcome = with_key_releases(|key_up| {
        app.set_key_up(key_up);
        frames(&mut app, &mut terminal)
    });
    let restored = ratatui::try_restore();
    outcome.and(app.finish()).and(restored)
}

fn frames(app: &mut App, terminal: &mut DefaultTerminal) -> io::Result<()> {
    let mut advanced = Instant::now();
    let is_ascii = ascii::is_ascii();
    while !app.quit() {
        terminal.draw(|frame| {
            view::draw(app, frame);
            if is_ascii {
                screen::to_ascii(frame.buffer_mut());
            }
        })?;
        let frame = Instant::now();
        loop {
            let event = event::poll(FRAME.saturating_sub(frame.elapsed()))?;
            let now = Instant::now();
            app.advance(now - advanced)?;
            advanced = now;
            if !event {
                break;
            }
            if let Event::Key(key) = event::read()? {
                app.key(key)?;
            }
        }
    }
    Ok(())
}

/// Asks the terminal to tell when keys go up while `body` runs (the Kitty keyboard protocol; the
/// console of Windows does so by itself), and tells `body` whether it will.
fn with_key_releases(body: impl FnOnce(KeyUp) -> io::Result<()>) -> io::Result<()> {
    if cfg!(windows) {
        return body(KeyUp::Told);
    }
    if !terminal::supports_keyboard_enhancement().unwrap_or(false) {
        return body(KeyUp::Guessed);
    }
    // Terminals keep this setting for each screen, so it must be undone on this one: before the
    // hook that ratatui has set leaves it.
    let restore = panic::take_hook();
    panic::set_hook(Box::new(move |info| {
        let _ = execute!(stdout(), PopKeyboardEnhancementFlags);
        restore(info);
    }));
    let flags = KeyboardEnhancementFlags::DISAMBIGUATE_ESCAPE_CODES
        | KeyboardEnhancementFlags::REPORT_EVENT_TYPES
        | KeyboardEnhancementFlags::REPORT_ALTERNATE_KEYS;
    execute!(stdout(), PushKeyboardEnhancementFlags(flags))?;
    let outcome = body(KeyUp::Told);
    execute!(stdout(), PopKeyboardEnhancementFlags)?;
    outcome
}
