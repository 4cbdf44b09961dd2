//! A scan in slow motion: keys go in, where it stands comes out.

use super::{App, advance, draw, event, press, screen, source};
use ratatui::crossterm::event::{KeyCode, KeyEventKind};
use ratatui::style::Modifier;

/// Line 3 makes no code.
const LINES: &str = "LD I1\nST Q1\n(* the second *)\nLD I2\nANDN I3\nST Q2\n";

fn app() -> App {
    App::new(source("slow.il", LINES)).unwrap()
}

/// The title of the text, and its lines.
fn shown(app: &mut App) -> Vec<String> {
    let lines = screen(app, 80, 16);
    let from = lines.iter().position(|line| line.starts_with("─ Text"));
    lines[from.unwrap()..].to_vec()
}

#[test]
fn a_scan_goes_on_by_elements_rungs_and_lines() {
    let mut app = app();
    press(&mut app, '1');
    advance(&mut app, 5);
    let scans = app.scans;
    press(&mut app, 'e');
    assert!(shown(&mut app)[0].starts_with("─ Text: next line 1  acc 1  value 0 ─"));
    press(&mut app, 'e');
    let lines = shown(&mut app);
    assert!(
        lines[0].starts_with("─ Text: next line 2  acc 1"),
        "{lines:?}"
    );
    // What has been run has its mark, and nothing else.
    assert_eq!(
        lines[1..4],
        ["   1 ● LD I1", "  2▶   ST Q1", "   3   (* the second *)"]
    );
    assert!(
        lines
            .last()
            .unwrap()
            .starts_with(" e element  g rung  l line")
    );
    press(&mut app, 'g');
    assert!(shown(&mut app)[0].starts_with("─ Text: next line 4"));
    press(&mut app, 'l');
    assert!(shown(&mut app)[0].starts_with("─ Text: next line 5  acc 0"));
    assert_eq!(app.scans, scans, "the scan is not over");
    press(&mut app, 's');
    assert_eq!(app.scans, scans + 1);
    assert!(shown(&mut app)[0].starts_with("─ Text ─"));
}

#[test]
fn a_breakpoint_stops_the_program_that_runs() {
    let mut app = app();
    press(&mut app, 'e');
    press(&mut app, 'g');
    press(&mut app, 'b');
    let scans = app.scans;
    press(&mut app, ' ');
    advance(&mut app, 100);
    assert_eq!(app.scans, scans + 1, "it stops in the next scan");
    let lines = shown(&mut app);
    assert!(lines[0].starts_with("─ Text: next line 4"), "{lines:?}");
    // Taken away, it runs on.
    press(&mut app, 'b');
    press(&mut app, ' ');
    advance(&mut app, 100);
    assert_eq!(app.scans, scans + 101);
}

fn go(app: &mut App, by: KeyCode) {
    event(app, by, KeyEventKind::Press);
}

/// What stands where the margin is reversed: the number of the line or rung that a person points to.
fn pointed(app: &mut App) -> String {
    let buffer = draw(app, 80, 16);
    let cells = (1..15).flat_map(|y| (0..4).map(move |x| (x, y)));
    let reversed = cells.filter_map(|place| buffer.cell(place));
    let reversed = reversed.filter(|cell| cell.modifier.contains(Modifier::REVERSED));
    reversed.map(|cell| cell.symbol()).collect()
}

#[test]
fn a_person_points_to_a_line_and_the_scan_goes_there() {
    let mut app = app();
    assert_eq!(pointed(&mut app), "");
    press(&mut app, 'e');
    assert_eq!(pointed(&mut app), "  1▶");
    // Line 3 makes no code, and is passed over.
    for (key, line) in [
        (KeyCode::Down, "   2"),
        (KeyCode::Down, "   4"),
        (KeyCode::Up, "   2"),
        (KeyCode::End, "   6"),
        (KeyCode::Down, "   6"),
        (KeyCode::Home, "  1▶"),
    ] {
        go(&mut app, key);
        assert_eq!(pointed(&mut app), line);
    }
    go(&mut app, KeyCode::PageDown);
    let scans = app.scans;
    press(&mut app, 'h');
    advance(&mut app, 100);
    assert!(shown(&mut app)[0].starts_with("─ Text: next line 6"));
    assert_eq!((app.scans, app.running), (scans, false));
    // Once more: through the end of the scan. It is no breakpoint.
    press(&mut app, 'h');
    advance(&mut app, 100);
    assert_eq!((app.scans, app.running), (scans + 1, false));
    press(&mut app, ' ');
    advance(&mut app, 100);
    assert_eq!(app.scans, scans + 101);
}

#[test]
fn a_breakpoint_is_set_where_a_person_points_to() {
    let mut app = app();
    press(&mut app, 'e');
    go(&mut app, KeyCode::Down);
    go(&mut app, KeyCode::Down);
    press(&mut app, 'b');
    let lines = shown(&mut app);
    assert_eq!(lines[1], "  1▶   LD I1");
    assert_eq!(lines[4], "  4■   LD I2");
    press(&mut app, ' ');
    advance(&mut app, 100);
    assert!(shown(&mut app)[0].starts_with("─ Text: next line 4"));
    // In the ladder by rungs: the breakpoint is on the second.
    press(&mut app, 'v');
    go(&mut app, KeyCode::Up);
    assert_eq!(pointed(&mut app), "  1 ");
    press(&mut app, 'h');
    advance(&mut app, 100);
    assert_eq!(pointed(&mut app), "  1▶");
    let lines = screen(&mut app, 80, 16);
    assert!(
        lines.iter().any(|line| line.starts_with("  2■")),
        "{lines:?}"
    );
    go(&mut app, KeyCode::Down);
    press(&mut app, 'b');
    let lines = screen(&mut app, 80, 16);
    assert!(
        lines.iter().all(|line| !line.starts_with("  2■")),
        "{lines:?}"
    );
}

#[test]
fn where_it_stands_is_on_the_screen() {
    let text: String = (0..40).map(|_| "LD I1\nST Q1\n").collect();
    let mut app = App::new(source("long.il", &text)).unwrap();
    press(&mut app, 'e');
    press(&mut app, 'v');
    assert_eq!(pointed(&mut app), "  1▶");
    for rung in 2..30 {
        press(&mut app, 'g');
        assert_eq!(pointed(&mut app), format!("{rung:>3}▶"));
    }
    press(&mut app, 'v');
    assert_eq!(pointed(&mut app), " 57▶");
    go(&mut app, KeyCode::Home);
    assert_eq!(pointed(&mut app), "   1");
}

#[test]
fn a_restart_begins_with_a_whole_scan() {
    let mut app = app();
    press(&mut app, 'e');
    press(&mut app, 'e');
    press(&mut app, 'r');
    assert_eq!(app.scans, 0);
    assert!(shown(&mut app)[0].starts_with("─ Text ─"));
}
