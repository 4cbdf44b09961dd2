//! The loop of the monitor: frames out, key events and news in.

use super::app::App;
use super::view;
use super::watcher::News;
use crate::{ascii, messages, screen};
use ratatui::DefaultTerminal;
use ratatui::crossterm::event::{self, Event};
use std::io;
use std::sync::mpsc::{Receiver, Sender};
use std::time::Duration;
use unoclp_client::order::Order;
use unoclp_client::watch::Forced;

/// Time from frame to frame.
const FRAME: Duration = Duration::from_millis(33);

/// Runs the monitor in this terminal until the person leaves; gives what is forced then. The board goes on as it is.
///
/// The terminal is put back as it was, after a panic too. An error comes from the terminal.
pub fn run(mut app: App, order: &Sender<Order>, news: &Receiver<News>) -> io::Result<Forced> {
    let mut terminal = ratatui::try_init()?;
    let outcome = frames(&mut app, &mut terminal, order, news);
    outcome.and(ratatui::try_restore())?;
    Ok(app.forced())
}

fn frames(
    app: &mut App,
    terminal: &mut DefaultTerminal,
    order: &Sender<Order>,
    news: &Receiver<News>,
) -> io::Result<()> {
    let is_ascii = ascii::is_ascii();
    while !app.quit() {
        news.try_iter().for_each(|news| app.hear(news));
        terminal.draw(|frame| {
            view::draw(app, frame);
            if is_ascii {
                screen::to_ascii(frame.buffer_mut());
            }
        })?;
        if event::poll(FRAME)?
            && let Event::Key(key) = event::read()?
            && let Some(ordered) = app.key(key)
            && order.send(ordered).is_err()
        {
            return Err(io::Error::other(messages::watcher_ended()));
        }
    }
    Ok(())
}
