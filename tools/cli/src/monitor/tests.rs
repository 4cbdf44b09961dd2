//! The monitor without a terminal and without a board: news and keys go in, wishes and the screen come out.

mod typed;

use super::app::App;
use super::program::Program;
use super::view;
use super::watcher::News;
use crate::messages::{SPOKEN_HERE, left_forced};
use ratatui::Terminal;
use ratatui::backend::TestBackend;
use ratatui::crossterm::event::{KeyCode, KeyEvent, KeyEventKind, KeyModifiers};
use unoclp_client::diagnostics::{Diagnostics, Kept, Trouble};
use unoclp_client::identity::Identity;
use unoclp_client::map::{Command, State, flag};
use unoclp_client::order::Order;
use unoclp_client::watch::{Forces, Meter, Reading, Side};
use unoclp_core::{After, Image, Inputs};
use unoclp_host_sim::engine::Machine;
use unoclp_host_sim::random::Random;
use unoclp_program::{Written, load};
use unoclp_workspace::{Ready, Workspace};

/// I1 sets Q1 through a TON of 20 ms; a counter of I2 sets Q2.
const PROGRAM: &str = "0\n787600\n827301\n847978\n20\n7901\n787600\n827302\n67848501\n3\n877902\n";

/// A program that is right, of this name and text.
fn source(name: &str, text: &str) -> Ready {
    let written = Written::new(name.to_owned(), text.into(), unoclp_core::Board::UNO);
    let analysis = Workspace::default().open(written);
    let refused = || panic!("{:?}", analysis.check());
    analysis.ready().unwrap_or_else(refused)
}

fn program() -> Program {
    Program::new(source("motor.txt", PROGRAM)).unwrap()
}

/// A board that runs the program.
fn reading() -> Reading {
    Reading {
        diagnostics: Diagnostics {
            state: Some(State::Run),
            cause: 1,
            uptime: 12_345,
            scan_times: [214, 180, 0x7FFF],
            free_stack: 120,
            supply: 5006,
            restarts: 2,
            program: program().kept,
            ..Diagnostics::default()
        },
        inputs: 0b01,
        outputs: 0b10,
        markers: Some(1 << 63 | 1),
        analogue: vec![512, 0, 0, 0, 0],
        registers: [0, -7].into_iter().chain([0; 30]).collect(),
        timers: vec![Meter {
            value: 15,
            preset: 20,
        }],
        counters: vec![Meter {
            value: 3,
            preset: 3,
        }],
        ..Reading::default()
    }
}

fn app(program: Option<Program>) -> App {
    let app = App::new(
        "/dev/ttyACM0, address 1".to_owned(),
        unoclp_core::Board::UNO,
        program,
        None,
    );
    found(app)
}

/// The app, which has found the board.
fn found(mut app: App) -> App {
    app.hear(News::Found {
        identity: Identity {
            vendor: "unoclp".to_owned(),
            product: "unoclp UNO".to_owned(),
            version: "0.2.0".to_owned(),
        },
        may_be_reset: false,
    });
    app
}

/// An app that has read this.
fn showing(reading: Reading) -> App {
    let mut app = app(Some(program()));
    app.hear(News::Read(Box::new(reading)));
    app
}

fn press(app: &mut App, code: KeyCode) -> Option<Order> {
    app.key(KeyEvent::new(code, KeyModifiers::NONE))
}

fn screen(app: &mut App, width: u16, height: u16) -> String {
    let mut terminal = Terminal::new(TestBackend::new(width, height)).unwrap();
    terminal.draw(|frame| view::draw(app, frame)).unwrap();
    let buffer = terminal.backend().buffer().clone();
    let cells: Vec<&str> = buffer.content().iter().map(|cell| cell.symbol()).collect();
    let lines = cells.chunks(usize::from(width).max(1));
    let lines: Vec<String> = lines
        .map(|line| line.concat().trim_end().to_owned())
        .collect();
    lines.join("\n")
}

#[test]
fn the_screen_shows_the_board() {
    let expected = " motor.txt  unoclp UNO 0.2.0 at /dev/ttyACM0, address 1               RUN  12 s
─ Inputs: force 1 to 8 ────────────────── Outputs ──────────────────────────────
 I1●  I2○  I3○  I4○  I5○  I6○  I7○  I8○  Q1○  Q2●  Q3○  Q4○
─ Board ────────────────────────────────────────────────────────────────────────
 scan 214 µs (180 to over 32766)  supply 5.01 V  stack 120 bytes free
 last start: power  since power-up: restarts 2, faults 0
─ Memory ───────────────────────────────────────────────────────────────────────
 M1 ●  M64 ●  A0 512  D2 -7
─ Timers (ms) and counters ─────────────────────────────────────────────────────
 T1 TON    ███████████████░░░░░ 15/20  C1        ██████████████████████ 3/3
─ Rungs ────────────────────────────────────────────────────────────────────────
  1 ┣━━┥ I1 ┝━━[ TON T1 15/20 ms ]──────────────────( Q1 )─┤
  2 ┣━━┤ I2 ├──[ CTU C1 3/3 ]━━━━━━━━━━━━━━━━━━━━━━━( Q2 )━┤

 q quit  space stop  1-8 force  o outputs  x free  s scan  r restart  v text  ↑↓";
    assert_eq!(screen(&mut showing(reading()), 80, 15), expected);
}

#[test]
fn without_a_file_it_shows_what_the_board_tells() {
    let mut app = app(None);
    app.hear(News::Read(Box::new(Reading {
        timers: Vec::new(),
        counters: Vec::new(),
        ..reading()
    })));
    let screen = screen(&mut app, 80, 24);
    for part in [" unoclp UNO 0.2.0 at /dev/ttyACM0", "I1●", "M1 ", "D2 -7"] {
        assert!(screen.contains(part), "{part} is missing in\n{screen}");
    }
    for part in ["Rungs", "Timers", "another program"] {
        assert!(!screen.contains(part), "{screen}");
    }
}

#[test]
fn another_program_is_warned_of_and_its_rungs_are_not_shown() {
    let mut other = reading();
    other.diagnostics.program = Kept {
        bytes: 9,
        sum: 0xAB,
        ..Kept::default()
    };
    let screen = screen(&mut showing(other), 100, 24);
    assert!(
        screen.contains(
            "the board runs a program other than motor.txt: 9 bytes, checksum 00AB, not "
        ),
        "{screen}"
    );
    assert!(
        !screen.contains("Rungs") && !screen.contains("Timers"),
        "{screen}"
    );
}

#[test]
fn whatever_a_person_should_know_is_said() {
    let board = |change: fn(&mut Reading)| {
        let mut reading = reading();
        change(&mut reading);
        screen(&mut showing(reading), 80, 24)
    };
    let trouble = Some(Trouble {
        number: 24,
        line: Some(7),
    });
    let faulty = board(|reading| {
        reading.diagnostics.state = Some(State::Fault);
        reading.diagnostics.trouble = Some(Trouble {
            number: 75,
            line: None,
        });
    });
    assert!(faulty.contains("FAULT  12 s"), "{faulty}");
    assert!(
        faulty.contains("\n fault 75: too many backward jumps"),
        "{faulty}"
    );
    let mut stopped = reading();
    (stopped.diagnostics.state, stopped.diagnostics.trouble) = (Some(State::Stop), trouble);
    let stopped = screen(&mut showing(stopped), 80, 24);
    assert!(
        stopped.contains("\n last upload: fault 24, line 7: no such code"),
        "{stopped}"
    );

    let flags = board(|reading| {
        reading.diagnostics.flags =
            flag::STOP_SWITCH | flag::UPLOAD | flag::CARD_FAILED | flag::FORCED;
        reading.forced_inputs = Forces { points: 2, to: 0 };
        reading.diagnostics.state = None;
    });
    for part in [
        "the STOP switch is closed",
        "an upload is in progress",
        "the card failed",
        "FORCED  ?",
        "I2○!",
    ] {
        assert!(flags.contains(part), "{part} is missing in\n{flags}");
    }
}

#[test]
fn a_board_without_a_program_is_not_at_fault() {
    let mut empty = reading();
    empty.diagnostics.state = Some(State::Fault);
    empty.diagnostics.program = Kept::default();
    empty.diagnostics.trouble = Some(Trouble {
        number: 51,
        line: None,
    });
    let shown = screen(&mut showing(empty), 100, 24);
    for part in ["no program yet  12 s", "\n No program on the board yet: "] {
        assert!(shown.contains(part), "{part} is missing in\n{shown}");
    }
    for part in ["FAULT", "fault 51", "another program"] {
        assert!(!shown.contains(part), "{part} in\n{shown}");
    }
}

#[test]
fn a_lost_board_is_told_and_what_was_read_last_stays() {
    let mut app = app(None);
    assert!(screen(&mut app, 80, 24).contains("waiting for the board"));
    app.hear(News::Lost("there is no port /dev/ttyACM0".to_owned()));
    let lost = screen(&mut app, 80, 24);
    assert!(
        lost.contains("there is no port") && lost.contains("NO BOARD"),
        "{lost}"
    );
    app.hear(News::Read(Box::new(reading())));
    assert!(!screen(&mut app, 80, 24).contains("NO BOARD"));
    app.hear(News::Lost("no answer".to_owned()));
    let lost = screen(&mut app, 80, 24);
    assert!(
        lost.contains("connection lost, retrying: no answer") && lost.contains("I1●"),
        "{lost}"
    );
    assert!(lost.contains("NO BOARD"), "{lost}");
}

#[test]
fn a_reset_and_a_refusal_are_said_until_the_next_key() {
    let mut app = showing(reading());
    app.hear(News::Refused("A5 is closed".to_owned()));
    assert!(screen(&mut app, 80, 24).contains("A5 is closed"));
    press(&mut app, KeyCode::Char('x'));
    assert!(!screen(&mut app, 80, 24).contains("A5 is closed"));
    app.hear(News::Found {
        identity: Identity::default(),
        may_be_reset: true,
    });
    assert!(screen(&mut app, 80, 24).contains("has probably reset the board"));
}

#[test]
fn keys_ask_for_what_fits_the_state() {
    let mut app = showing(reading());
    let command = |command| Some(Order::Command(command));
    assert_eq!(press(&mut app, KeyCode::Char(' ')), command(Command::Stop));
    assert_eq!(
        press(&mut app, KeyCode::Char('s')),
        command(Command::SingleScan)
    );
    assert_eq!(
        press(&mut app, KeyCode::Char('r')),
        command(Command::Restart)
    );
    assert_eq!(press(&mut app, KeyCode::Char('x')), Some(Order::Release));
    assert_eq!(press(&mut app, KeyCode::Char('z')), None);
    let mut stopped = reading();
    stopped.diagnostics.state = Some(State::Stop);
    app.hear(News::Read(Box::new(stopped)));
    assert_eq!(press(&mut app, KeyCode::Char(' ')), command(Command::Run));
    assert!(!app.quit());
    press(&mut app, KeyCode::Esc);
    assert!(app.quit());
}

#[test]
fn digits_force_a_point_to_1_then_to_0_and_let_it_go() {
    let mut app = showing(reading());
    let mut reading = reading();
    for to in [Some(true), Some(false), None, Some(true)] {
        let force = Order::Force(Side::Inputs, 7, to);
        assert_eq!(press(&mut app, KeyCode::Char('8')), Some(force));
        reading.forced_inputs.set(7, to);
        app.hear(News::Read(Box::new(reading.clone())));
    }
    assert_eq!(press(&mut app, KeyCode::Char('9')), None);
    press(&mut app, KeyCode::Char('o'));
    let force = Order::Force(Side::Outputs, 0, Some(true));
    assert_eq!(press(&mut app, KeyCode::Char('1')), Some(force));
    assert_eq!(press(&mut app, KeyCode::Char('5')), None, "there are four");
    assert!(screen(&mut app, 80, 24).contains("Outputs: force 1 to 4"));
    press(&mut app, KeyCode::Char('o'));
    assert!(screen(&mut app, 80, 24).contains("Inputs: force 1 to 8"));

    // A key that is held, or goes up, forces nothing more.
    for kind in [KeyEventKind::Repeat, KeyEventKind::Release] {
        let key = KeyEvent::new_with_kind(KeyCode::Char('1'), KeyModifiers::NONE, kind);
        assert_eq!(app.key(key), None);
    }
}

#[test]
fn before_the_first_reading_nothing_is_forced_or_started() {
    let mut app = app(Some(program()));
    for key in ['1', ' '] {
        assert_eq!(press(&mut app, KeyCode::Char(key)), None);
    }
}

#[test]
fn every_screen_is_large_enough() {
    let mut app = showing(reading());
    for (width, height) in [(1, 1), (10, 3), (20, 40), (40, 10), (80, 24), (200, 60)] {
        for key in [
            KeyCode::End,
            KeyCode::PageUp,
            KeyCode::PageDown,
            KeyCode::Home,
        ] {
            press(&mut app, key);
            screen(&mut app, width, height);
        }
    }
}

#[test]
fn there_may_be_nothing_to_scroll() {
    let mut app = app(None);
    for key in [KeyCode::End, KeyCode::Down, KeyCode::PageDown, KeyCode::Up] {
        assert_eq!(press(&mut app, key), None);
        screen(&mut app, 80, 24);
    }
}

#[test]
fn a_board_with_another_stored_form_is_not_said_to_run_another_program() {
    let mut other = reading();
    other.diagnostics.program = Kept {
        version: 3,
        bytes: 9,
        sum: 0xAB,
    };
    let screen = screen(&mut showing(other), 100, 24);
    assert!(!screen.contains("another program"), "{screen}");
}

#[test]
fn rungs_scroll() {
    let rungs = "787600\n827301\n877901\n".repeat(40);
    let file = format!("0\n{rungs}");
    let program = Program::new(source("long.txt", &file)).unwrap();
    let mut reading = reading();
    reading.diagnostics.program = program.kept;
    let mut app = app(Some(program));
    app.hear(News::Read(Box::new(reading)));
    let mut at = |key: Option<KeyCode>| {
        if let Some(key) = key {
            press(&mut app, key);
        }
        let screen = screen(&mut app, 80, 24);
        screen
            .lines()
            .find(|line| line.contains("Rungs"))
            .unwrap()
            .to_owned()
    };
    let first = at(None);
    assert!(
        first.contains("lines 1 to ") && first.contains(" of 40"),
        "{first}"
    );
    assert!(at(Some(KeyCode::Down)).contains("lines 2 to "));
    assert!(at(Some(KeyCode::End)).contains(" to 40 of 40"));
    assert!(at(Some(KeyCode::Up)).contains(" to 39 of 40"));
    assert_eq!(at(Some(KeyCode::Home)), first);
}

/// All kinds of timers, a counter that counts both ways, markers and comparisons; no edge of its own.
const RICH: &str = "0\n\
    827301\n847978\n20\n7901\n787600\n\
    827302\n847970\n15\n7902\n787600\n\
    827303\n8480\n10\n7703\n787600\n\
    827304\n847982\n30\n7704\n787600\n\
    827301\n67848501\n3\n787600\n827302\n67846801\n3\n877705\n787600\n\
    827304\n-828401\n828403\n82876701\n787600\n\
    766867 01\n718400\n1\n877903\n787600\n\
    -827703\n40\n827902\n41\n828404\n877904\n";

#[test]
fn what_is_energised_is_what_the_boards_own_scan_has_made_so() {
    let text = RICH.replace(' ', "");
    let mut board = Machine::new(load(text.as_bytes(), unoclp_core::Board::UNO).unwrap());
    let mut program = Program::new(source("rich.txt", &text)).unwrap();
    let mut random = Random::new(7);
    let mut inputs = Image(0);
    let mut compared = 0;
    for now in 0..20_000 {
        let before = inputs;
        if random.below(12) == 0 {
            inputs.0 ^= 1 << random.below(4);
        }
        let mut acc = Vec::new();
        let observe = |step: usize, after: After| {
            acc.resize(step, None);
            acc.push(Some(after.acc));
        };
        let outputs = board
            .scan_observed(Inputs::from(inputs), now, observe)
            .unwrap();
        // From outside, a TOF that begins just now is one that is over.
        if inputs != before || now == 0 {
            continue;
        }
        let plc = board.plc();
        let reading = Reading {
            diagnostics: Diagnostics {
                uptime: now,
                ..Diagnostics::default()
            },
            inputs: inputs.0 as u32,
            outputs: outputs.0 as u32,
            markers: Some(plc.markers() as u64),
            registers: plc.registers().to_vec(),
            timers: plc
                .timers(now)
                .map(|timer| Meter {
                    value: timer.elapsed.cast_signed(),
                    preset: timer.preset.cast_signed(),
                })
                .collect(),
            counters: plc
                .counters()
                .map(|counter| Meter {
                    value: counter.value,
                    preset: counter.preset,
                })
                .collect(),
            ..Reading::default()
        };
        let flow = program.flow(&reading);
        assert_eq!(flow.acc, acc, "at {now} ms, inputs {inputs:?}");
        compared += 1;
    }
    assert!(compared > 15_000);
}

#[test]
fn instruction_list_is_shown_as_text_or_as_rungs() {
    let text = "VAR\n    button AT %IX1 : BOOL;\nEND_VAR\nLD button\nANDN I2\nST Q1\n";
    let program = Program::new(source("lamp.il", text)).unwrap();
    let mut reading = reading();
    reading.diagnostics.program = program.kept;
    let mut app = app(Some(program));
    app.hear(News::Read(Box::new(reading)));
    let shown = screen(&mut app, 100, 30);
    let text = "\n   4 ● LD button\n   5 ● ANDN I2\n   6 ● ST Q1\n";
    assert!(
        shown.contains("─ Text ─") && shown.contains(text),
        "{shown}"
    );
    assert_eq!(press(&mut app, KeyCode::Char('v')), None);
    let shown = screen(&mut app, 100, 30);
    assert!(
        shown.contains("─ Rungs ─") && shown.contains("button") && shown.contains("v text"),
        "{shown}"
    );
}

#[test]
fn a_fault_of_the_running_program_names_the_line_of_the_text() {
    // Numeric code has the jump in another line.
    let text = "(* a comment *)\n(* and another *)\nbegin: LD I1\nST Q1\nJMP begin\n";
    let program = source("loop.il", text);
    let jump = program.map.steps.last().unwrap().codes.clone();
    assert_ne!(jump, 5..=5);
    let kept = Kept::of(program.program());
    let mut app = app(Some(Program::new(program).unwrap()));
    let mut shown = |kept, number| {
        let mut reading = reading();
        reading.diagnostics.program = kept;
        reading.diagnostics.state = Some(State::Fault);
        let line = Some(*jump.start());
        reading.diagnostics.trouble = Some(Trouble { number, line });
        app.hear(News::Read(Box::new(reading)));
        screen(&mut app, 100, 30)
    };
    let running = shown(kept, 75);
    assert!(running.contains("fault 75, line 5:"), "{running}");
    // The line is one of another file.
    let code_line = format!(", line {}:", jump.start());
    let refused = shown(kept, 24);
    assert!(refused.contains(&code_line), "{refused}");
    let other = shown(Kept::default(), 75);
    assert!(other.contains(&code_line), "{other}");
}

#[test]
fn what_is_forced_is_said_at_the_start_and_at_the_end() {
    let mut forced = reading();
    forced.forced_outputs = Forces {
        points: 0b100,
        to: 0b100,
    };
    let mut app = showing(forced);
    let screen = screen(&mut app, 80, 24);
    assert!(
        screen.contains("already forced: Q3=1; x releases all points"),
        "{screen}"
    );
    press(&mut app, KeyCode::Char('1'));
    // Whoever leaves before the next reading is to know of it.
    press(&mut app, KeyCode::Char('q'));
    assert_eq!(app.forced().to_string(), "I1=1 Q3=1");
}

/// A monitor whose forces end after 10 s, at a board with this end of forcing before.
fn ending(ends: Option<u8>) -> App {
    let app = App::new(
        "/dev/ttyACM0".to_owned(),
        unoclp_core::Board::UNO,
        Some(program()),
        Some(10),
    );
    let mut app = found(app);
    let mut now = reading();
    now.forcing_ends = ends;
    app.hear(News::Read(Box::new(now)));
    app
}

#[test]
fn when_forcing_ends_by_itself_is_said_at_the_end() {
    let mut now = reading();
    now.forced_inputs.set(0, Some(true));
    for (ends, seconds) in [
        (None, None),
        (Some(0), None),
        (Some(255), None),
        (Some(7), Some(7)),
    ] {
        now.forcing_ends = ends;
        let forced = showing(now.clone()).forced();
        assert_eq!(forced.seconds(), seconds);
        let by_itself =
            left_forced(forced).contains("the board releases them 7 s after the last request");
        assert_eq!(by_itself, seconds.is_some());
    }
    // Whoever leaves before the next reading is told what holds then.
    let mut app = ending(Some(0));
    press(&mut app, KeyCode::Char('1'));
    assert_eq!(app.forced().seconds(), Some(10));
    let shown = screen(&mut app, 80, 24);
    assert!(!shown.contains("when the monitor ends"), "{shown}");
}

#[test]
fn a_board_that_cannot_end_forcing_is_said_to_be_so_once() {
    let mut app = ending(None);
    let mut says = |key| {
        let wish = press(&mut app, KeyCode::Char(key));
        assert!(wish.is_some(), "it is forced all the same");
        screen(&mut app, 120, 24).contains("they stay forced when the monitor ends")
    };
    assert!(!says('x'));
    assert!(says('1'));
    assert!(!says('2'));
    assert_eq!(app.forced().seconds(), None);
}

#[test]
fn an_output_that_no_rung_writes_is_said_to_stay_on_when_it_is_let_go() {
    for (program, says) in [
        (
            Some(program()),
            "still on, because no rung writes them: Q3; STOP",
        ),
        (None, "stay on unless the program writes them: Q1 Q3; STOP"),
    ] {
        let mut app = app(program);
        let mut now = reading();
        (now.forced_outputs.points, now.forced_outputs.to) = (0b101, 0b101);
        now.outputs = 0b101;
        app.hear(News::Read(Box::new(now.clone())));
        assert_eq!(press(&mut app, KeyCode::Char('x')), Some(Order::Release));
        now.forced_outputs = Forces::default();
        app.hear(News::Read(Box::new(now.clone())));
        let lit = screen(&mut app, 80, 30);
        assert!(lit.contains(says), "{lit}");
        now.outputs = 0;
        app.hear(News::Read(Box::new(now)));
        let off = screen(&mut app, 80, 30);
        assert!(!off.contains("still on"), "{off}");
    }
}

#[test]
fn a_fault_shows_the_line_of_the_text() {
    let source = source("loops.il", "again:\nLD I1\nST Q1\nJMP again\n");
    let jump = source.map.steps.last().unwrap().codes.clone();
    let program = Program::new(source).unwrap();
    let mut faulty = reading();
    faulty.diagnostics.program = program.kept;
    faulty.diagnostics.state = Some(State::Fault);
    faulty.diagnostics.trouble = Some(Trouble {
        number: 75,
        line: Some(*jump.start()),
    });
    let mut app = app(Some(program));
    app.hear(News::Read(Box::new(faulty)));
    let screen = screen(&mut app, 80, 24);
    assert!(screen.contains("loops.il:4: JMP again"), "{screen}");
}

/// 35 lines, of which those that do something are on the screen, and what they hold.
#[test]
fn a_screen_of_80_by_24_shows_a_program_and_its_values() {
    let head = "VAR\n level AT %MW1 : INT;\n alarm AT %QX1 : BOOL;\nEND_VAR\n";
    let rung = "LD level\nADD 1\nST level\nLD level\nGT 500\nST alarm\n";
    let source = source("tank.il", &format!("{head}{}", rung.repeat(5)));
    let register = source
        .symbols()
        .iter()
        .find_map(|(point, name)| (name == "level").then_some(point))
        .unwrap();
    let index: usize = register[1..].parse().unwrap();
    let program = Program::new(source).unwrap();
    let mut now = reading();
    now.diagnostics.program = program.kept;
    now.registers[index - 1] = 420;
    (now.timers, now.counters, now.markers) = (Vec::new(), Vec::new(), Some(0));
    let mut app = app(Some(program));
    app.hear(News::Read(Box::new(now)));
    let screen = screen(&mut app, 80, 24);
    assert!(screen.contains(" level 420"), "{screen}");
    // A number shows its value in place of a lamp: that of the scan that the monitor makes after it.
    assert!(screen.contains("   5   LD level  = 42"), "{screen}");
    let lines = screen
        .lines()
        .filter(|line| line.contains("LD level") || line.contains("ST alarm"));
    assert!(lines.count() >= 6, "{screen}");
}

#[test]
fn lamps_have_names_and_lines_their_values() {
    let text = "VAR\n start AT %IX1 : BOOL;\n lamp AT %QX2 : BOOL;\n level AT %MW1 : INT;\nEND_VAR\n\
                LD start\nST lamp\nLD level\nADD 3\nST MW2\n";
    let program = Program::new(source("named.il", text)).unwrap();
    let kept = program.kept;
    let mut app = app(Some(program));
    app.hear(News::Read(Box::new(Reading {
        diagnostics: Diagnostics {
            program: kept,
            ..reading().diagnostics
        },
        registers: [40].into_iter().chain([0; 31]).collect(),
        timers: Vec::new(),
        counters: Vec::new(),
        forced_inputs: Forces { points: 1, to: 1 },
        ..reading()
    })));
    let shown = screen(&mut app, 80, 24);
    assert!(
        shown.contains("\n I1●!start   I2○  I3○  I4○  I5○ "),
        "{shown}"
    );
    assert!(shown.contains(" Q1○  Q2● lamp   Q3○  Q4○\n"), "{shown}");
    assert!(shown.contains("   9   ADD 3  = 43\n"), "{shown}");
    // Another program on the board has other names.
    app.hear(News::Read(Box::new(reading())));
    let shown = screen(&mut app, 80, 24);
    assert!(
        shown.contains("I1● ") && !shown.contains("start   I2"),
        "{shown}"
    );
}

#[test]
fn a_screen_that_is_too_small_says_so_and_how_to_leave() {
    let small = screen(&mut showing(reading()), 40, 10);
    let says = "this screen is too small: 40 x 10\nat least 41 x 11 is needed\nq quits\n";
    assert!(small.starts_with(says), "{small}");
}

#[test]
fn the_screen_speaks_portuguese() {
    SPOKEN_HERE.set(Some(unoclp_lang::Lang::Pt));
    let mut now = reading();
    now.forced_outputs = Forces { points: 1, to: 1 };
    now.diagnostics.flags = flag::STOP_SWITCH | flag::UPLOAD | flag::CARD_FAILED;
    let shown = screen(&mut showing(now), 80, 24);
    for part in [
        "Entradas: force 1 a 8",
        "já estavam forçados: Q1=1",
        "varredura 214",
        "fonte 5,01 V",
        "há um envio em andamento",
        " q sai ",
    ] {
        assert!(shown.contains(part), "{part} is missing in\n{shown}");
    }
    for part in [
        "Inputs", "Outputs", "Timers", "quit", "supply", "the ", "since",
    ] {
        assert!(!shown.contains(part), "{part} in\n{shown}");
    }
}

/// Who leaves right after a force is told of it, though the readings on their way know nothing of it yet.
#[test]
fn a_reading_from_before_a_force_does_not_hide_it() {
    let mut app = showing(reading());
    press(&mut app, KeyCode::Char('1'));
    app.hear(News::Read(Box::new(reading())));
    app.hear(News::Read(Box::new(reading())));
    assert!(app.forced().any());
    app.hear(News::Done);
    app.hear(News::Read(Box::new(reading())));
    assert!(!app.forced().any(), "the board knows better");
    press(&mut app, KeyCode::Char('1'));
    app.hear(News::Refused("locked".to_owned()));
    app.hear(News::Read(Box::new(reading())));
    assert!(!app.forced().any());
}
