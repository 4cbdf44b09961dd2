//! Programs in typed languages: variables by their names and in their types.

use super::*;

const TANK: &str = "\
VAR
  go AT %IX1 : BOOL;
  lamp AT %QX1 : BOOL;
  raw AT %IW0 : INT;
  level : REAL;
  wait : TIME := T#1s;
  a : ARRAY[0..1] OF DINT;
  p : STRUCT y : UDINT; END_STRUCT;
  mode : (Idle, Busy);
  pause : TON;
  parts : CTU;
END_VAR
level := INT_TO_REAL(raw) * 0.5 + level;
level := level + 0.25;
wait := wait + T#1ms;
a[1] := a[1] + 1;
p.y := p.y - 1;
IF go THEN mode := Busy; ELSE mode := Idle; END_IF;
pause(IN := go, PT := T#5s);
parts(CU := go, PV := 3, R := FALSE);
lamp := pause.Q OR parts.Q;
";

#[test]
fn variables_have_their_names_and_types() {
    let mut app = App::new(source("tank.st", TANK)).unwrap();
    press(&mut app, '1');
    advance(&mut app, 1);
    let shown = screen(&mut app, 80, 24);
    assert_eq!(
        shown[1..9].join("\n"),
        "\
─ Inputs: 1 to 4 toggle ─────────────── Outputs ────────────────────────────────
 I1 ● go   I2 ○   I3 ○   I4 ○          Q1 ○ lamp   Q2 ○   Q3 ○   Q4 ○
─ Timers (ms) ──────────────────────────────────────────────────────────────────
 pause TON ░░░░░░░░░░░░    1/5000 M1 ○
─ Variables ────────────────────────────────────────────────────────────────────
 raw 0   level 0.5   wait T#1s2ms   a[1] 2   p.y 4294967294   mode Busy
 parts.CV 1
─ Text: lines 8 to 21 of 21 ────────────────────────────────────────────────────"
    );
    for (line, value) in [
        ("level + 0.25;", "0.5"),
        ("T#1ms;", "T#1s2ms"),
        ("- 1;", "4294967294"),
    ] {
        let expected = format!("{line}  = {value}");
        assert!(
            shown.iter().any(|shown| shown.ends_with(&expected)),
            "{expected}: {shown:#?}"
        );
    }
    press(&mut app, 'v');
    let ladder = screen(&mut app, 80, 50).join("\n");
    for name in [" level ", " a[1] ", " p.y ", " mode ", " pause ", " parts "] {
        assert!(ladder.contains(name), "{name}: {ladder}");
    }
}

#[test]
fn what_print_marks_is_watched_first() {
    let block = "BLOCO\nINT n; REAL half; BOOL odd; INT other;\nn := n + 1; other := n * 2;\nhalf := n * 0.5;\nodd := n > 2;\nIF odd THEN PRINT(half); END_IF;\nPRINT(n); PRINT(odd);\nEND_BLOCK\n";
    let plain = block
        .replace("PRINT(half);", "")
        .replace("PRINT(n); PRINT(odd);", "");
    let mut app = App::new(source("print.iscl", block)).unwrap();
    let marked = source("print.iscl", block);
    assert_eq!(
        marked.size.codes,
        source("plain.iscl", &plain).size.codes,
        "PRINT costs no code"
    );
    advance(&mut app, 4);
    let shown = screen(&mut app, 80, 24);
    assert_eq!(
        shown[3..7].join("\n"),
        "\
─ Watched (PRINT) ──────────────────────────────────────────────────────────────
 n 5   half 2.5   odd ●
─ Variables ────────────────────────────────────────────────────────────────────
 other 10"
    );
}

#[test]
fn variables_of_lce_have_their_own_names_and_hold_what_was_written_last() {
    let text = "clp x\nvar V0 = nivel; Q0.1 = bomba;\nnivel := nivel + 2;\nse (I0.0) { V1 R:= 2.5; liga bomba; } senao { V1 := 7; }\nfim\n";
    let mut app = App::new(source("x.lce", text)).unwrap();
    advance(&mut app, 1);
    let shown = screen(&mut app, 80, 24).join("\n");
    assert!(shown.contains("\n nivel 4   V1 7\n"), "{shown}");
    press(&mut app, '1');
    advance(&mut app, 1);
    let shown = screen(&mut app, 80, 24).join("\n");
    assert!(shown.contains("\n nivel 6   V1 2.5\n"), "{shown}");
    assert!(shown.contains("Q2 ● bomba"), "{shown}");
}

/// A chart is shown as one, with its active steps; then its text, and the ladder that it has become.
#[test]
fn a_chart_is_shown_with_its_active_steps() {
    let text = include_str!("../../../../../programs/charts/filling.st");
    let mut app = App::new(source("filling.st", text)).unwrap();
    advance(&mut app, 1);
    let shown = screen(&mut app, 80, 50).join("\n");
    assert!(shown.contains("─ Chart: ● Wait ─"), "{shown}");
    assert!(
        shown.contains("║●Wait  ║") && shown.contains("●─┼── start"),
        "{shown}"
    );
    press(&mut app, '1');
    advance(&mut app, 5);
    press(&mut app, '2');
    advance(&mut app, 5);
    press(&mut app, '3');
    advance(&mut app, 130);
    let shown = screen(&mut app, 80, 50).join("\n");
    assert!(shown.contains("● Settle 0.1 s"), "{shown}");
    press(&mut app, 'v');
    let shown = screen(&mut app, 80, 50).join("\n");
    assert!(shown.contains("─ Text: ● Settle 0.1 s"), "{shown}");
    press(&mut app, 'v');
    let shown = screen(&mut app, 80, 50).join("\n");
    assert!(shown.contains("─ Rungs: ● Settle 0.1 s"), "{shown}");
    press(&mut app, 'v');
    assert!(screen(&mut app, 80, 50).join("\n").contains("─ Chart: "));
}
