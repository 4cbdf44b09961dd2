//! A scan in slow motion: keys go in, where it stands comes out.

use super::{App, advance, press, screen, source};

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

#[test]
fn a_restart_begins_with_a_whole_scan() {
    let mut app = app();
    press(&mut app, 'e');
    press(&mut app, 'e');
    press(&mut app, 'r');
    assert_eq!(app.scans, 0);
    assert!(shown(&mut app)[0].starts_with("─ Text ─"));
}
