//! Boards that run programs in typed languages.

use super::*;

/// A monitor of this program, whose board has these registers, with its first input and its second marker at 1.
fn showing_typed(name: &str, text: &str, registers: &[i32]) -> App {
    let program = Program::new(source(name, text)).unwrap();
    let kept = program.kept;
    let mut app = app(Some(program));
    app.hear(News::Read(Box::new(Reading {
        diagnostics: Diagnostics {
            program: kept,
            ..reading().diagnostics
        },
        registers: registers.to_vec(),
        markers: Some(0b10),
        analogue: vec![7, 0, 0, 0, 0],
        outputs: 0,
        counters: Vec::new(),
        timers: vec![Meter {
            value: 1500,
            preset: 5000,
        }],
        ..reading()
    })));
    app
}

#[test]
fn a_board_shows_variables_by_name_and_type() {
    let text = "VAR go AT %IX1 : BOOL; lamp AT %QX1 : BOOL; raw AT %IW0 : INT; level : REAL; wait : TIME; n : UDINT; pause : TON; END_VAR\nlevel := level + 0.5;\nIF raw > 9 THEN lamp := TRUE; END_IF;\nwait := wait + T#1ms;\nn := n + 1;\npause(IN := go, PT := T#5s);\nlamp := pause.Q;\n";
    let registers = [2.5_f32.to_bits().cast_signed(), 90_000, -1];
    let shown = screen(&mut showing_typed("tank.st", text, &registers), 80, 24);
    for part in [
        "I1● go",
        "Q1○ lamp",
        "\n raw 7   level 2.5   wait T#1m30s   n 4294967295\n",
        " pause TON ",
        // The text shows what the scan that comes next stores.
        "level := level + 0.5;  = 3.0",
        "wait := wait + T#1ms;  = T#1m30s1ms",
    ] {
        assert!(shown.contains(part), "{part}: {shown}");
    }
}

#[test]
fn a_board_shows_what_print_marks_first() {
    let text = "BLOCO\nBOOL go AT %IX1; BOOL odd; INT n; REAL half; INT other;\nn := n + 1; half := n * 0.5; other := n;\nIF go THEN odd := NOT odd; END_IF;\nPRINT(half); PRINT(go);\nEND_BLOCK\n";
    let registers = [5, 2.5_f32.to_bits().cast_signed(), 5];
    let shown = screen(&mut showing_typed("half.iscl", text, &registers), 80, 24);
    let watched = shown.find("─ Watched (PRINT) ─").unwrap_or(usize::MAX);
    let others = shown.find("─ Variables ─").unwrap_or_default();
    assert!(watched < others, "{shown}");
    assert!(shown.contains("\n go ●   half 2.5\n"), "{shown}");
    assert!(shown.contains(" n 5   other 5\n"), "{shown}");
}

#[test]
fn a_board_with_another_program_shows_no_variables() {
    let program = Program::new(source("x.lce", "V0 := V0 + 1;")).unwrap();
    let mut app = app(Some(program));
    app.hear(News::Read(Box::new(reading())));
    let shown = screen(&mut app, 80, 24);
    assert!(
        shown.contains("─ Memory ─") && !shown.contains("V0"),
        "{shown}"
    );
}

#[test]
fn a_line_shows_the_condition_that_it_tests() {
    let text = "VAR go AT %IX1 : BOOL; stop AT %IX2 : BOOL; level : REAL; n : INT; END_VAR\nlevel := level * 1.0;\nIF level < 10.0 THEN\nn := 1;\nEND_IF;\nIF stop THEN n := 2; END_IF;\nIF go THEN\nn := n + 1;\nEND_IF;\n";
    let registers = [50.05_f32.to_bits().cast_signed(), 7];
    let shown = screen(&mut showing_typed("tank.st", text, &registers), 80, 24);
    for part in [
        "   2   level := level * 1.0;  = 50.05\n",
        "   3 ○ IF level < 10.0 THEN\n",
        "   4   n := 1;\n",
        "   6 ○ IF stop THEN n := 2; END_IF;\n",
        "   7 ● IF go THEN\n",
        "   8   n := n + 1;  = 8\n",
    ] {
        assert!(shown.contains(part), "{part}: {shown}");
    }
}

#[test]
fn a_board_shows_the_active_steps_of_a_chart() {
    let text = "VAR go AT %IX1 : BOOL; lamp AT %QX1 : BOOL; END_VAR\nINITIAL_STEP Wait: END_STEP\nSTEP Shine: lamp(N); END_STEP\nTRANSITION FROM Wait TO Shine := go; END_TRANSITION\nTRANSITION FROM Shine TO Wait := NOT go; END_TRANSITION\n";
    let shown = screen(&mut showing_typed("lamp.st", text, &[]), 80, 50);
    assert!(
        shown.contains("● Wait") != shown.contains("● Shine"),
        "{shown}"
    );
    assert!(shown.contains("─┼── go"), "{shown}");
}
