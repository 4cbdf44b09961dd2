//! The simulator without a terminal: keys and time go in, the screen comes out.

mod slow;
mod typed;

use super::app::App;
use super::buttons::KeyUp;
use super::view;
use crate::messages::SPOKEN_HERE;
use ratatui::Terminal;
use ratatui::backend::TestBackend;
use ratatui::buffer::Buffer;
use ratatui::crossterm::event::{KeyCode, KeyEvent, KeyEventKind, KeyModifiers};
use std::cell::RefCell;
use std::io::{self, Write};
use std::rc::Rc;
use std::time::Duration;
use unoclp_core::Image;
use unoclp_exercise::wave::Recorder;
use unoclp_host_sim::random::{Random, random_program};
use unoclp_program::Written;
use unoclp_workspace::{Ready, Workspace};

/// I1 sets Q1 through a TON of 20 ms; I2 or not I3, and Q1, to Q2.
const PROGRAM: &str = "0\n787600\n827301\n847978\n20\n7901\n\
    787600\n827302\n40\n-827303\n41\n827901\n877902\n";

/// A program that is right, of this name and text.
fn source(name: &str, text: &str) -> Ready {
    let written = Written::new(name.to_owned(), text.into(), unoclp_core::Board::UNO);
    let analysis = Workspace::default().open(written);
    let refused = || panic!("{:?}", analysis.check());
    analysis.ready().unwrap_or_else(refused)
}

fn app(program: &str) -> App {
    App::new(source("motor.txt", program)).unwrap()
}

fn advance(app: &mut App, ms: u64) {
    app.advance(Duration::from_millis(ms)).unwrap();
}

fn press(app: &mut App, key: char) {
    event(app, KeyCode::Char(key), KeyEventKind::Press);
}

fn event(app: &mut App, code: KeyCode, kind: KeyEventKind) {
    let key = KeyEvent::new_with_kind(code, KeyModifiers::NONE, kind);
    app.key(key).unwrap();
}

fn draw(app: &mut App, width: u16, height: u16) -> Buffer {
    let mut terminal = Terminal::new(TestBackend::new(width, height)).unwrap();
    terminal.draw(|frame| view::draw(app, frame)).unwrap();
    terminal.backend().buffer().clone()
}

/// The lines of the screen, without the blanks at their ends.
fn screen(app: &mut App, width: u16, height: u16) -> Vec<String> {
    let buffer = draw(app, width, height);
    let cells: Vec<&str> = buffer.content().iter().map(|cell| cell.symbol()).collect();
    let lines = cells
        .chunks(usize::from(width).max(1))
        .map(|line| line.concat());
    lines.map(|line| line.trim_end().to_owned()).collect()
}

#[test]
fn the_screen_shows_what_is_energised() {
    let mut app = app(PROGRAM);
    press(&mut app, '1');
    advance(&mut app, 15);
    let expected = " motor.txt                                                 RUN  15 ms  16 scans
─ Inputs: 1 to 4 toggle ───────────────── Outputs ──────────────────────────────
 I1 ●   I2 ○   I3 ○   I4 ○               Q1 ○   Q2 ○   Q3 ○   Q4 ○
─ Timers (ms) ──────────────────────────────────────────────────────────────────
 T1   TON ████████████░░░░░ 15/20 Q1 ○
─ Rungs ────────────────────────────────────────────────────────────────────────
  1 ┣━━┥ I1 ┝━━[ TON T1 15/20 ms ]──────────────────( Q1 )─┤
  2 ┣━━┤ I2 ├──┳━━┤ Q1 ├────────────────────────────( Q2 )─┤
    ┣━━┥/I3 ┝━━┛                                           │

 q quit  space pause  s scan  r restart  v text  m momentary  e slow  ↑↓ scroll";
    assert_eq!(screen(&mut app, 80, 11).join("\n"), expected);

    advance(&mut app, 5);
    let expected = " motor.txt                                                 RUN  20 ms  21 scans
─ Inputs: 1 to 4 toggle ───────────────── Outputs ──────────────────────────────
 I1 ●   I2 ○   I3 ○   I4 ○               Q1 ●   Q2 ●   Q3 ○   Q4 ○
─ Timers (ms) ──────────────────────────────────────────────────────────────────
 T1   TON █████████████████ 20/20 Q1 ●
─ Rungs ────────────────────────────────────────────────────────────────────────
  1 ┣━━┥ I1 ┝━━[ TON T1 20/20 ms ]━━━━━━━━━━━━━━━━━━( Q1 )━┤
  2 ┣━━┤ I2 ├──┳━━┥ Q1 ┝━━━━━━━━━━━━━━━━━━━━━━━━━━━━( Q2 )━┤
    ┣━━┥/I3 ┝━━┛                                           │

 q quit  space pause  s scan  r restart  v text  m momentary  e slow  ↑↓ scroll";
    assert_eq!(screen(&mut app, 80, 11).join("\n"), expected);
}

#[test]
fn what_is_energised_has_a_style_of_its_own() {
    let mut app = app(PROGRAM);
    advance(&mut app, 1);
    let buffer = draw(&mut app, 80, 24);
    let style = |symbol: &str| {
        let cell = buffer.content().iter().find(|cell| cell.symbol() == symbol);
        let cell = cell.unwrap_or_else(|| panic!("{symbol} is not on the screen"));
        (cell.fg, cell.modifier)
    };
    let on = (super::ON.fg.unwrap(), super::ON.add_modifier);
    for symbol in ["┣", "━", "┥", "┝"] {
        assert_eq!(style(symbol), on, "{symbol}");
    }
    for symbol in ["○", "┤", "├"] {
        assert_ne!(style(symbol), on, "{symbol}");
    }
}

#[test]
fn a_scan_runs_for_each_ms() {
    let mut app = app(PROGRAM);
    for (elapsed, scans) in [(0, 1), (1, 2), (99, 101), (100, 201)] {
        advance(&mut app, elapsed);
        assert_eq!(app.scans, scans);
    }
    // Parts of a ms add up.
    for _ in 0..10 {
        app.advance(Duration::from_micros(300)).unwrap();
    }
    assert_eq!(app.scans, 204);
    // A PC that slept does not run an hour of scans.
    advance(&mut app, 3_600_000);
    assert_eq!(app.scans, 454);
}

#[test]
fn a_paused_program_scans_only_when_told() {
    let mut app = app(PROGRAM);
    advance(&mut app, 9);
    press(&mut app, ' ');
    advance(&mut app, 100);
    assert_eq!(app.scans, 10);
    press(&mut app, 's');
    assert_eq!(app.scans, 11);
    assert!(screen(&mut app, 80, 24)[0].ends_with("PAUSED  10 ms  11 scans"));
    press(&mut app, ' ');
    advance(&mut app, 4);
    assert_eq!(app.scans, 15);
    // A single scan pauses.
    press(&mut app, 's');
    advance(&mut app, 100);
    assert_eq!(app.scans, 16);
}

#[test]
fn a_restart_clears_all_but_the_buttons() {
    let mut app = app(PROGRAM);
    press(&mut app, '1');
    advance(&mut app, 50);
    assert_eq!(app.outputs(), Image(0b11));
    press(&mut app, 'r');
    assert_eq!((app.scans, app.outputs()), (0, Image(0)));
    assert_eq!(app.buttons.closed(), Image(1));
    advance(&mut app, 18);
    assert_eq!(app.outputs(), Image(0));
    advance(&mut app, 1);
    assert_eq!((app.scans, app.outputs()), (20, Image(0)));
    advance(&mut app, 1);
    assert_eq!(app.outputs(), Image(0b11));
}

#[test]
fn before_the_first_scan_nothing_is_energised() {
    let mut app = app(PROGRAM);
    let lines = screen(&mut app, 80, 24);
    assert!(lines.iter().all(|line| !line.contains('━')), "{lines:#?}");
}

#[test]
fn a_momentary_button_is_closed_while_its_key_is_held() {
    for (key_up, closed_after_a_second) in [(KeyUp::Told, true), (KeyUp::Guessed, false)] {
        let mut app = app(PROGRAM);
        app.set_key_up(key_up);
        press(&mut app, 'm');
        press(&mut app, '1');
        advance(&mut app, 100);
        assert_eq!(app.buttons.closed(), Image(1));
        assert!(screen(&mut app, 80, 24)[1].contains("hold 1 to 4 to close"));
        advance(&mut app, 900);
        assert_eq!(app.buttons.closed(), Image(closed_after_a_second.into()));
        event(&mut app, KeyCode::Char('1'), KeyEventKind::Release);
        assert_eq!(app.buttons.closed(), Image(0));
    }
}

#[test]
fn a_held_key_toggles_once_where_the_terminal_tells_repeats() {
    let mut app = app(PROGRAM);
    press(&mut app, '2');
    for kind in [
        KeyEventKind::Repeat,
        KeyEventKind::Repeat,
        KeyEventKind::Release,
    ] {
        event(&mut app, KeyCode::Char('2'), kind);
        assert_eq!(app.buttons.closed(), Image(0b10));
    }
}

#[test]
fn keys_without_a_meaning_change_nothing() {
    let mut app = app(PROGRAM);
    advance(&mut app, 10);
    let before = screen(&mut app, 80, 24);
    for key in ['0', '5', '9', 'x', 'Q'] {
        press(&mut app, key);
    }
    event(&mut app, KeyCode::Char('q'), KeyEventKind::Release);
    assert_eq!(screen(&mut app, 80, 24), before);
    assert!(!app.quit());
}

#[test]
fn q_esc_and_ctrl_c_quit() {
    let keys = [
        KeyEvent::from(KeyCode::Char('q')),
        KeyEvent::from(KeyCode::Esc),
        KeyEvent::new(KeyCode::Char('c'), KeyModifiers::CONTROL),
    ];
    for key in keys {
        let mut app = app(PROGRAM);
        assert!(!app.quit());
        app.key(key).unwrap();
        assert!(app.quit());
    }
}

#[test]
fn a_long_program_scrolls() {
    let program = "0\n".to_owned() + &"787600\n827301\n877901\n".repeat(40);
    let mut app = app(&program);
    // 24 lines: header, 2, title of the rungs, 19 rungs, footer.
    let first_rung = |app: &mut App| screen(app, 80, 24)[4].trim_start().to_owned();
    let steps = [
        (KeyCode::Home, "1 "),
        (KeyCode::Up, "1 "),
        (KeyCode::Down, "2 "),
        (KeyCode::PageDown, "20 "),
        (KeyCode::PageDown, "22 "),
        (KeyCode::PageUp, "4 "),
        (KeyCode::End, "22 "),
        (KeyCode::Down, "22 "),
        (KeyCode::Home, "1 "),
    ];
    for (key, expected) in steps {
        screen(&mut app, 80, 24);
        event(&mut app, key, KeyEventKind::Press);
        let first = first_rung(&mut app);
        assert!(first.starts_with(expected), "{key}: {first}");
    }
    assert_eq!(
        screen(&mut app, 80, 24)[3].trim_end_matches('─'),
        "─ Rungs: lines 1 to 19 of 40 "
    );
    // A screen that grows shows all of it.
    event(&mut app, KeyCode::End, KeyEventKind::Press);
    assert!(screen(&mut app, 80, 50)[4].trim_start().starts_with("1 "));
}

#[test]
fn timers_that_do_not_fit_are_on_further_pages() {
    let timer = |number: u32| format!("847970\n{}\n7901\n", 1_000 + number);
    let program = "0\n".to_owned() + &(1..=30).map(timer).collect::<String>();
    let mut app = app(&program);
    let mut pages = Vec::new();
    for _ in 0..4 {
        let lines = screen(&mut app, 80, 24);
        pages.push((
            lines[3].clone(),
            lines[4].contains(" T1 "),
            lines[4].contains(" T13 "),
        ));
        press(&mut app, 't');
    }
    let titles: Vec<_> = pages
        .iter()
        .map(|page| page.0.trim_matches(['─', ' ']))
        .collect();
    let [first, second, third] = [
        "Timers (ms): 1 to 12 of 30",
        "Timers (ms): 13 to 24 of 30",
        "Timers (ms): 25 to 30 of 30",
    ];
    assert_eq!(titles, [first, second, third, first]);
    assert_eq!((pages[0].1, pages[0].2), (true, false));
    assert_eq!((pages[1].1, pages[1].2), (false, true));
}

#[test]
fn branches_are_drawn_and_long_rungs_wrap() {
    let program = "0\n827301\n404102\n40\n404102\n827302\n41\n-827901\n-827304\n\
        83877901\n82877902\n847970\n2147483647\n7903\n877904\n787600\n877901\n";
    let mut app = app(program);
    let lines = screen(&mut app, 64, 16);
    let rungs = [
        "  1 ├──┤ I1 ├──┬──────────┬──┤/Q1 ├──┤/I4 ├──┬──────(S Q1)─┤",
        "    │          └──┤ I2 ├──┘                  ├──────(R Q2)─┤",
        "    │                                        └──→a         │",
        "    │ a→──[ TOF T1 2147483647 ms ]──┬───────────────( Q3 )─┤",
        "    │                               └───────────────( Q4 )─┤",
        "  2 ├───────────────────────────────────────────────( Q1 )─┤",
    ];
    for rung in rungs {
        assert!(lines.iter().any(|line| line == rung), "{rung}\n{lines:#?}");
    }
}

#[test]
fn every_program_fits_every_screen() {
    let mut random = Random::new(11);
    for _ in 0..20 {
        let program = random_program(&mut random);
        let mut app = app(&program);
        advance(&mut app, 10);
        for _ in 0..10 {
            let (width, height) = (random.below(130) as u16, random.below(50) as u16);
            let lines = screen(&mut app, width, height);
            if height > 10 && width > 40 {
                let runs = lines[0].ends_with("RUN  10 ms  11 scans");
                assert!(runs || lines[0].contains("FAULT 75, line "), "{}", lines[0]);
            }
            event(&mut app, KeyCode::PageDown, KeyEventKind::Press);
            press(&mut app, 't');
            press(&mut app, 'd');
        }
    }
}

#[test]
fn the_new_instructions_are_drawn() {
    let program = "0\n766603\n827301\n6985\n787984\n827712\n-828302\n828401\n-826702\n829003\n\
        6540\n887302\n41\n8840\n-887901\n41\n-877702\n83877704\n82876701\n83876701\n\
        787600\n766800\n-5\n65686803\n718400\n7\n838403\n66738431\n67848501\n9\n77798601\n6803\n4\n\
        787600\n8480\n500\n7709\n-74778003\n826984\n76686500\n83848004\n707320\n";
    let mut app = app(program);
    let lines = screen(&mut app, 120, 20);
    let rungs = [
        "    L3:",
        "  1 ├──┤ I1 ├──┤P├──┤NOT├──┤ M12 ├──┤/S2 ├──┤ T1 ├──┤/C2 ├──[ C3 <= 0 ]──[ AND ]──[ XOR ]──┬──(/M2 )─┤",
        "    ├──[ XOR I2 ]───────────────────────────────────────────────────────────┘        │     ├──(S M4)─┤",
        "    ├──[ XOR /Q1 ]───────────────────────────────────────────────────────────────────┘     ├──(R C1)─┤",
        "    │                                                                                      └──(L C1)─┤",
        "  2 ├──[ LD -5 ]──[ ADD D3 ]──[ V > 7 ]──[ ST D3 ]──┤ V.31 ├──[ CTU C1 9 ]──────[ MOV D1-4 to D3-6 ]─┤",
        "  3 ├──[ TP T1 500 ms ]──┬────────────────────────────────────────────────────────────────────( M9 )─┤",
        "    │                    ├──────────────────────────────────────────────────────────────┤NOT├──>> L3─┤",
        "    │                    ├─────────────────────────────────────────────────────────────────────<RET>─┤",
        "    │                    └──[ LD A0 ]──[ ST PWM Q4 ]──[ INPUT FILTER 20 ms ]                         │",
    ];
    for rung in rungs {
        assert!(lines.iter().any(|line| line == rung), "{rung}\n{lines:#?}");
    }
}

#[test]
fn inputs_05_to_08_have_buttons_where_a_program_reads_them() {
    let mut eight = app("0\n827308\n877901\n");
    press(&mut eight, '8');
    press(&mut eight, '9');
    advance(&mut eight, 1);
    let lines = screen(&mut eight, 80, 24);
    assert!(lines[1].contains("Inputs: 1 to 8 toggle"));
    assert!(lines[2].ends_with("I7 ○   I8 ●"), "{}", lines[2]);
    assert!(lines[4].starts_with(" Q1 ●"), "{}", lines[4]);
    let mut four = app("0\n827304\n877901\n");
    press(&mut four, '8');
    assert!(!screen(&mut four, 80, 24)[2].contains('●'));
}

#[test]
fn analogue_inputs_are_turned_and_memory_is_shown() {
    // A0 to D1, A4 to D2 and PWM of output 04; M1 while D1 > 100; C2 counts that.
    let program = "0\n76686500\n838401\n718400\n100\n877701\n67848502\n3\n\
        787600\n76686504\n838402\n83848004\n";
    let mut app = app(program);
    let memory = |app: &mut App| {
        advance(app, 1);
        let lines = screen(app, 80, 24);
        let title = lines.iter().position(|line| line.starts_with("─ Memory"));
        lines[title.unwrap() + 1].clone()
    };
    assert_eq!(
        memory(&mut app),
        " A0 0   A4 0   P4 0   C2 0/3   D1 0   D2 0   M1 ○"
    );
    for key in ['>', '+', '-', '='] {
        press(&mut app, key);
    }
    assert_eq!(
        memory(&mut app),
        " A0 110   A4 0   P4 0   C2 1/3   D1 110   D2 0   M1 ●"
    );
    press(&mut app, 'a');
    for _ in 0..11 {
        press(&mut app, '>');
    }
    let expected = " A0 110   A4 1023   P4 255   C2 1/3   D1 110   D2 1023   M1 ●";
    assert_eq!(memory(&mut app), expected);
    event(&mut app, KeyCode::Tab, KeyEventKind::Press);
    press(&mut app, '<');
    press(&mut app, '<');
    let expected = " A0 0   A4 1023   P4 255   C2 1/3   D1 0   D2 1023   M1 ○";
    assert_eq!(memory(&mut app), expected);
    assert!(screen(&mut app, 80, 24)[23].contains("a A0  +-<> turn"));
}

#[test]
fn a_fault_stops_the_program_until_a_restart() {
    let mut app = app("0\n877901\n787600\n766601\n827301\n74778001\n");
    advance(&mut app, 5);
    assert!(screen(&mut app, 80, 24)[2].contains("Q1 ●"));
    press(&mut app, '1');
    advance(&mut app, 5);
    let lines = screen(&mut app, 80, 24);
    assert!(
        lines[0].ends_with("FAULT 75, line 6  6 ms  7 scans"),
        "{}",
        lines[0]
    );
    assert!(lines[2].contains("Q1 ○"));
    // Only a restart helps.
    for key in [' ', 's'] {
        press(&mut app, key);
        advance(&mut app, 5);
        assert_eq!(screen(&mut app, 80, 24)[0], lines[0]);
    }
    press(&mut app, '1');
    press(&mut app, 'r');
    advance(&mut app, 5);
    let lines = screen(&mut app, 80, 24);
    assert!(
        lines[0].contains("RUN") && lines[2].contains("Q1 ●"),
        "{lines:#?}"
    );
}

#[test]
fn a_restart_keeps_retentive_markers() {
    let mut app = app("0\n827301\n83877757\n83877701\n");
    press(&mut app, '1');
    advance(&mut app, 1);
    press(&mut app, '1');
    press(&mut app, 'r');
    advance(&mut app, 1);
    let lines = screen(&mut app, 80, 24);
    assert!(lines.contains(&" M1 ○   M57 ●".to_owned()), "{lines:#?}");
}

/// A file that a test can read while the recorder owns it.
#[derive(Clone, Default)]
struct Shared(Rc<RefCell<Vec<u8>>>);

impl Write for Shared {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.borrow_mut().write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[test]
fn a_session_is_recorded_across_pause_and_restart() {
    let mut app = app("0\n827301\n877901\n");
    let file = Shared::default();
    app.record_to(Recorder::new(Box::new(file.clone())));
    advance(&mut app, 5);
    press(&mut app, '1');
    press(&mut app, ' ');
    advance(&mut app, 1_000);
    press(&mut app, 's');
    press(&mut app, 'r');
    press(&mut app, '1');
    press(&mut app, 's');
    app.finish().unwrap();
    let trace = String::from_utf8(file.0.take()).unwrap();
    let times: Vec<_> = trace.lines().filter(|line| line.starts_with('#')).collect();
    // The start, the scan with I1 closed, the scan with I1 open again, and the end.
    assert_eq!(times, ["#0", "#6", "#7", "#8"]);
    assert!(screen(&mut app, 80, 24)[0].contains("REC  PAUSED"));
}

/// A branch that goes over lines, and a call whose Q is read later.
const LIST: &str = "(* Lamp *)\nLD I1\nOR( I2\nANDN I3\n)\nST Q1\n\nLD Q1\nTON T1, 20\nST Q2\n";

#[test]
fn lines_of_instruction_list_show_what_they_have_come_to() {
    let program = source("lamp.il", LIST);
    let mut app = App::new(program).unwrap();
    press(&mut app, '2');
    advance(&mut app, 10);
    let shown = screen(&mut app, 80, 20).join("\n");
    let text = "\
─ Text ─────────────────────────────────────────────────────────────────────────
   1   (* Lamp *)
   2 ○ LD I1
   3 ● OR( I2
   4 ● ANDN I3
   5   )
   6 ● ST Q1
   7
   8 ● LD Q1
   9 ○ TON T1, 20
  10 ○ ST Q2
";
    assert!(shown.contains(text), "{shown}");
    assert!(shown.contains("v ladder"), "{shown}");

    press(&mut app, 'v');
    let shown = screen(&mut app, 80, 20).join("\n");
    assert!(
        shown.contains("─ Rungs ─") && shown.contains("┥ I2 ┝"),
        "{shown}"
    );
    assert!(shown.contains("v text"), "{shown}");
}

#[test]
fn lines_of_numeric_code_show_what_they_have_come_to() {
    let text = "/ lamp\n0\n827301 / button\n\n40\n-827302\n41\n877901\n";
    let mut app = app(text);
    press(&mut app, 'v');
    advance(&mut app, 10);
    let shown = screen(&mut app, 80, 20).join("\n");
    let text = "
   1   / lamp
   2   0
   3 ○ 827301 / button
   4
   5 ● 40
   6 ● -827302
   7 ● 41
   8 ● 877901
";
    assert!(shown.contains(text), "{shown}");
}

#[test]
fn a_fault_names_the_line_of_the_text() {
    // Numeric code has the jump in another line.
    let text = "(* a comment *)\n(* and another *)\nbegin: LD I1\nST Q1\nJMP begin\n";
    let mut app = App::new(source("loop.il", text)).unwrap();
    advance(&mut app, 10);
    let shown = screen(&mut app, 80, 20).join("\n");
    assert!(shown.contains("FAULT 75, line 5"), "{shown}");
    let says = " loop.il:5: fault 75: too many backward jumps in one scan (NC-19)\n   JMP begin\n";
    assert!(shown.contains(says), "{shown}");
}

#[test]
fn a_screen_that_is_too_small_says_so_and_how_to_leave() {
    let mut app = app("0\n827301\n877901\n");
    let lines = screen(&mut app, 40, 10);
    assert_eq!(lines[0].trim_end(), "this screen is too small: 40 x 10");
    assert_eq!(lines[2].trim_end(), "q quits");
}

#[test]
fn variables_show_their_names_and_numbers_their_values() {
    let text = "VAR\n speed AT %MW1 : INT;\n fast AT %MX1 : BOOL;\nEND_VAR\nLD speed\nADD 3\nST speed\nGT 10\nST fast\n";
    let mut app = App::new(source("names.il", text)).unwrap();
    advance(&mut app, 3);
    let shown = screen(&mut app, 80, 24).join("\n");
    assert!(
        shown.contains(" speed 12 ") && shown.contains(" fast ●"),
        "{shown}"
    );
    assert!(shown.contains("   7   ST speed  = 12"), "{shown}");
    // The value after it, which is that of the scan and not of the register as it stands.
    assert!(shown.contains("   6   ADD 3  = 12\n"), "{shown}");
    assert!(shown.contains("   9 ● ST fast"), "{shown}");
}

#[test]
fn values_stand_beside_lines_that_name_no_register() {
    let text = "LD 5\nMUL 4\nSUB 1\nST D1\nLD IW0\nDIV 2\nST D2\nLD I1\nJMPCN out\nLD D1\nADD 100\nST D1\n\
                out:\nLD I2\nST Q2\n";
    let mut app = App::new(source("values.il", text)).unwrap();
    app.knobs.select_next();
    app.knobs.turn(100);
    advance(&mut app, 1);
    let shown = screen(&mut app, 80, 30).join("\n");
    for line in [
        "1   LD 5  = 5",
        "2   MUL 4  = 20",
        "3   SUB 1  = 19",
        "5   LD IW0  = 100",
        "6   DIV 2  = 50",
    ] {
        assert!(
            shown.contains(&format!("   {line}\n")),
            "{line} is missing in\n{shown}"
        );
    }
    // The scan did not come there.
    assert!(shown.contains("  11   ADD 100\n"), "{shown}");
    press(&mut app, '1');
    advance(&mut app, 1);
    let shown = screen(&mut app, 80, 30).join("\n");
    assert!(shown.contains("  11   ADD 100  = 119\n"), "{shown}");
}

#[test]
fn inputs_and_outputs_stand_beside_their_names() {
    let text = "VAR\n start AT %IX1 : BOOL;\n emergency_stop AT %IX2 : BOOL;\n pump AT %QX1 : BOOL;\nEND_VAR\n\
                LD start\nANDN emergency_stop\nST pump\n";
    let mut app = App::new(source("named.il", text)).unwrap();
    press(&mut app, '1');
    advance(&mut app, 1);
    let lines = screen(&mut app, 80, 24);
    let lamps = " I1 ● start   I2 ○ emergency_stop   I3 ○   I4 ○ Q1 ● pump   Q2 ○   Q3 ○   Q4 ○";
    assert_eq!(lines[2], lamps);
    // Below that they stand one above the other, and are cut.
    let lines = screen(&mut app, 41, 20);
    assert_eq!(lines[2], " I1 ● start   I2 ○ emergen…   I3 ○   I4 ○");
    assert_eq!(lines[4], " Q1 ● pump   Q2 ○   Q3 ○   Q4 ○");
}

#[test]
fn the_screen_speaks_portuguese() {
    SPOKEN_HERE.set(Some(unoclp_lang::Lang::Pt));
    let mut app = app("0\n827301\n847978\n20\n7901\n");
    let shown = screen(&mut app, 80, 24).join("\n");
    for part in [
        "Entradas: 1 a 4 alternam",
        "Saídas",
        "Temporizadores (ms)",
        "Degraus",
        " q sai  espaço pausa",
    ] {
        assert!(shown.contains(part), "{part} is missing in\n{shown}");
    }
    for part in ["Inputs", "Outputs", "Timers", "Rungs", "quit", "scans"] {
        assert!(!shown.contains(part), "{part} in\n{shown}");
    }
}
