//! `unoclp run`: texts in typed languages on this PC.

use crate::common::{file, outcome, outcome_in};
use std::io::Write;
use std::process::{Command, Stdio};

const SQUARES: &str = "VAR s, i : INT; END_VAR\nFOR i := 1 TO 10 DO s := s + i * i; END_FOR;\n";

#[test]
fn a_file_runs_once_and_shows_its_symbols() {
    let program = file("squares.st", SQUARES);
    let table = "name  type  value  place\ns     INT   385    D 01\ni     INT   11     D 02\n";
    assert_eq!(
        outcome(&["run", &program]),
        (0, table.to_owned(), String::new())
    );
    let (code, out, _) = outcome_in(&["run", &program], "pt_BR.UTF-8");
    assert_eq!(
        (code, out.lines().next()),
        (0, Some("nome  tipo  valor  lugar"))
    );
}

#[test]
fn json_is_one_object() {
    let text = "VAR s : INT := 385; b : BOOL := TRUE; t : TIME := T#1s; r : REAL := 2.5; d : DATE; END_VAR s := s;";
    let (code, out, err) = outcome(&["run", "--json", "--text", text]);
    let expected = concat!(
        r#"{"scans": 1, "printed": [], "symbols": ["#,
        r#"{"name": "s", "type": "INT", "value": 385, "place": "D 01"}, "#,
        r#"{"name": "b", "type": "BOOL", "value": true, "place": null}, "#,
        r#"{"name": "t", "type": "TIME", "value": 1000, "place": null}, "#,
        r#"{"name": "r", "type": "REAL", "value": 2.5, "place": null}, "#,
        r#"{"name": "d", "type": "DATE", "value": "D#1970-01-01", "place": null}]}"#,
        "\n"
    );
    assert_eq!((code, out.as_str(), err.as_str()), (0, expected, ""));
}

/// The same text for the board.
#[test]
fn every_command_takes_structured_text() {
    let program = file(
        "lamp.st",
        "VAR start AT %IX1 : BOOL; lamp AT %QX1 : BOOL; n : DINT; END_VAR\nlamp := start OR %IX2;\nn := n + 10;\n",
    );
    let (code, out, err) = outcome(&["check", &program]);
    assert_eq!((code, err.as_str()), (0, ""));
    assert!(
        out.contains("OK: ") && out.contains("Structured Text"),
        "{out}"
    );
    let (code, out, _) = outcome(&["compile", &program]);
    assert_eq!(code, 0);
    assert!(out.contains("827301    / RI 01    start, line 2"), "{out}");
    let (code, out, _) = outcome(&["list", &program]);
    assert_eq!(code, 0);
    assert!(
        out.contains("Rung 1, line") && out.contains("lamp"),
        "{out}"
    );
    let wrong = file("text.st", "VAR s : STRING; END_VAR\ns := 'a';\n");
    let (code, out, _) = outcome(&["check", &wrong]);
    assert_eq!(code, 1);
    assert!(
        out.contains("ST-201") && out.contains("text.st:1:5"),
        "{out}"
    );
}

#[test]
fn standard_input_is_read() {
    let mut child = Command::new(env!("CARGO_BIN_EXE_unoclp"))
        .args(["run", "-"])
        .env("LC_ALL", "C")
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    child
        .stdin
        .take()
        .unwrap()
        .write_all(SQUARES.as_bytes())
        .unwrap();
    let output = child.wait_with_output().unwrap();
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.contains("s     INT   385"), "{text}");
}

#[test]
fn inputs_are_set_and_scans_are_counted() {
    let text = "VAR t : TON; go : BOOL; n : INT; END_VAR t(IN := go, PT := T#20ms); IF t.Q THEN n := n + 1; END_IF;";
    let arguments = [
        "run", "--text", text, "--scans", "5", "--every", "10", "--set", "go=true", "--set",
        "N = 7",
    ];
    let (code, out, err) = outcome(&arguments);
    assert_eq!((code, err.as_str()), (0, ""));
    assert!(out.contains("\nn     INT   10 "), "{out}");
}

#[test]
fn what_is_wrong_is_told_with_its_place() {
    let (code, out, err) = outcome(&["run", "--text", "VAR x : INT; END_VAR x := y;"]);
    assert_eq!((code, err.as_str()), (1, ""));
    assert!(
        out.starts_with("error[ST-130]: `y` is not declared\n --> the text:1:27\n"),
        "{out}"
    );
    assert!(
        out.ends_with("the text: 1 error; there is no program\n"),
        "{out}"
    );
    let (code, out, err) = outcome(&["run", "--json", "--text", "x := ;"]);
    assert_eq!((code, out.as_str()), (1, ""));
    assert!(err.starts_with("error[ST-106]"), "{err}");
}

#[test]
fn a_loop_without_end_is_stopped() {
    let text = "VAR x : INT; END_VAR\nWHILE TRUE DO x := x + 1; END_WHILE;";
    for (lang, told) in [
        (
            "C",
            "the text:2:1: this scan does not end; unoclp stopped it here after 20000000 steps. ",
        ),
        (
            "pt_BR",
            "o texto:2:1: esta varredura não termina; o unoclp a parou aqui depois de 20000000 passos. ",
        ),
    ] {
        let (code, out, err) = outcome_in(&["run", "--text", text], lang);
        assert_eq!((code, out.as_str()), (1, ""));
        assert!(err.starts_with(told), "{err}");
    }
}

#[test]
fn what_cannot_be_run_is_exit_code_2() {
    for (arguments, told) in [
        (
            vec!["run"],
            "error: name what to run: a file, - for standard input, or --text \"…\"\n",
        ),
        (vec!["run", "no.st"], "error: no.st cannot be read ("),
        (
            vec!["run", "--text", "x := 1;", "--language", "basic"],
            "error: invalid value 'basic'",
        ),
        (
            vec![
                "run",
                "--text",
                "VAR x : INT; END_VAR x := 1;",
                "--set",
                "x",
            ],
            "error: --set takes NAME=VALUE",
        ),
        (
            vec![
                "run",
                "--text",
                "VAR x : INT; END_VAR x := 1;",
                "--set",
                "y=1",
            ],
            "error: the program has no variable y; it has x\n",
        ),
        (
            vec![
                "run",
                "--text",
                "VAR x : INT; END_VAR x := 1;",
                "--set",
                "x=1.5",
            ],
            "error: 1.5 is not a valid value for x, which is of type INT\n",
        ),
    ] {
        let (code, out, err) = outcome(&arguments);
        assert_eq!((code, out.as_str()), (2, ""), "{arguments:?}");
        assert!(err.starts_with(told), "{arguments:?}: {err}");
    }
}

#[test]
fn a_value_that_cannot_be_computed_is_told() {
    let (code, out, err) = outcome(&["run", "--text", "VAR x, y : INT; END_VAR x := 1 / y;"]);
    assert_eq!(code, 0);
    assert!(out.contains("x     INT   0"), "{out}");
    assert!(
        err.contains(":1:30: this value could not be computed, and S 04 was set"),
        "{err}"
    );
}

/// The lines of the language's own page give its own values.
#[test]
fn lce_runs_by_extension_by_first_word_and_by_language() {
    let lines = "V0 R:= 100000.125;\nV1 R:= V0;\nV2 := V0; V3 W:= V0; V4 B:= V0;\n";
    let table = concat!(
        "name  type  value       place\n",
        "V0    REAL  100000.125  D 01\n",
        "V1    REAL  100000.125  D 02\n",
        "V2    DINT  100000      D 03\n",
        "V3    DINT  34464       D 04\n",
        "V4    DINT  160         D 05\n",
    );
    let named = file("typed.lce", lines);
    let begun = format!("clp teste\n{lines}fim\n");
    let begun = file("typed.txt", &begun);
    for arguments in [
        vec!["run", &named],
        vec!["run", &begun],
        vec!["run", "--text", lines],
        vec!["run", "--language", "lce", "--text", lines],
    ] {
        let expected = (0, table.to_owned(), String::new());
        assert_eq!(outcome(&arguments), expected, "{arguments:?}");
    }
}

#[test]
fn a_variable_of_mixed_kinds_is_what_it_holds() {
    let text = "clp x se (I0.0) { V0 R:= 2.5; } senao { V0 := 7; } fim";
    for (set, json) in [
        ("I0.0=1", r#""type": "REAL", "value": 2.5"#),
        ("I0.0=0", r#""type": "DINT", "value": 7"#),
    ] {
        let (code, out, err) = outcome(&["run", "--json", "--set", set, "--text", text]);
        assert_eq!((code, err.as_str()), (0, ""));
        assert!(out.contains(&format!(r#"{{"name": "V0", {json}"#)), "{out}");
    }
    let text = "clp x se (I0.0) { V0 R:= 2.5; V0 := 7; } V1 R:= V0; fim";
    for (set, json) in [
        ("V0=1.5", r#""type": "REAL", "value": 1.5"#),
        ("V0=3", r#""type": "DINT", "value": 3"#),
    ] {
        let (code, out, err) = outcome(&["run", "--json", "--set", set, "--text", text]);
        assert_eq!((code, err.as_str()), (0, ""));
        assert!(out.contains(&format!(r#"{{"name": "V0", {json}"#)), "{out}");
    }
    let (code, _, err) = outcome(&["run", "--set", "V0=x", "--text", text]);
    assert_eq!(code, 2);
    assert!(
        err.starts_with("error: x is not a valid value for V0, which is of type REAL/DINT"),
        "{err}"
    );
}

#[test]
fn every_command_takes_interscl_and_lce() {
    let block = "BLOCO\nBOOL start AT %IX1; BOOL lamp AT %QX1; INT n;\nlamp := start AND NOT (n > 100);\nn := n + 1;\nEND_BLOCK\n";
    let lines = "clp motor\nvar V0 = cont;\nse (I0.0) { liga Q0.0; V0 := V0 + 1; }\nse (I0.1) { desliga Q0.0; }\nfim\n";
    for (name, text, language) in [
        ("commands.iscl", block, "InterSCL"),
        ("commands.lce", lines, "LCE"),
    ] {
        let text = file(name, text);
        let (code, out, err) = outcome(&["check", &text]);
        assert_eq!((code, err.as_str()), (0, ""), "{out}");
        assert!(out.contains(&format!("\n  {language}")), "{out}");
        let (code, out, _) = outcome(&["compile", &text]);
        assert!(
            code == 0 && out.starts_with("0         / program start"),
            "{out}"
        );
        let (code, out, _) = outcome(&["list", &text]);
        assert!(code == 0 && out.contains("[ ADD 1 ]"), "{out}");
    }
}

/// Members and elements are symbols of their own, and every type has its form.
#[test]
fn json_has_every_member_element_and_type() {
    let text = "TYPE c : (Red, Green); END_TYPE\nVAR q : STRUCT x : REAL; on : BOOL; END_STRUCT; a : ARRAY[0..1,0..1] OF DINT; t : TIME := T#2s; s : STRING := 'a'; l : LREAL := 0.5; w : WORD := 16#FF; k : c := Green; i : INT; tod : TOD := TOD#12:00:00; END_VAR\nq.x := 1.5; q.on := TRUE; a[1,0] := 7; s := 'a';\n";
    let (code, out, err) = outcome(&["run", "--json", "--text", text]);
    assert_eq!((code, err.as_str()), (0, ""));
    for symbol in [
        r#"{"name": "q.x", "type": "REAL", "value": 1.5, "place": null}"#,
        r#"{"name": "q.on", "type": "BOOL", "value": true, "place": null}"#,
        r#"{"name": "a[0,0]", "type": "DINT", "value": 0, "place": null}"#,
        r#"{"name": "a[1,0]", "type": "DINT", "value": 7, "place": null}"#,
        r#"{"name": "t", "type": "TIME", "value": 2000, "place": null}"#,
        r#"{"name": "s", "type": "STRING", "value": "a", "place": null}"#,
        r#"{"name": "l", "type": "LREAL", "value": 0.5, "place": null}"#,
        r#"{"name": "w", "type": "WORD", "value": 255, "place": null}"#,
        r#"{"name": "k", "type": "c", "value": "Green", "place": null}"#,
        r#"{"name": "i", "type": "INT", "value": 0, "place": null}"#,
        r#"{"name": "tod", "type": "TIME_OF_DAY", "value": "TOD#12:00:00", "place": null}"#,
    ] {
        assert!(out.contains(symbol), "{symbol}\n{out}");
    }
    // What the board can do has its place there.
    let text = text
        .replace("s : STRING := 'a'; l : LREAL := 0.5; ", "")
        .replace(" s := 'a';", "");
    let (_, out, _) = outcome(&["run", "--json", "--text", &text]);
    for symbol in [
        r#"{"name": "q.x", "type": "REAL", "value": 1.5, "place": "D 0"#,
        r#"{"name": "q.on", "type": "BOOL", "value": true, "place": "M 0"#,
        r#"{"name": "a[1,0]", "type": "DINT", "value": 7, "place": "D 0"#,
    ] {
        assert!(out.contains(symbol), "{symbol}\n{out}");
    }
}

/// Instruction List and numeric code run as the board runs them.
#[test]
fn instruction_list_and_numeric_code_run_too() {
    let text = "VAR\n  go AT %IX1 : BOOL;\n  lamp AT %QX1 : BOOL;\n  n : INT;\nEND_VAR\nLD n\nADD 2\nST n\nLD go\nST lamp\n";
    let program = file("run.il", text);
    for arguments in [
        vec!["run", "--scans", "3", "--set", "go=TRUE", &program],
        vec!["run", "--scans", "3", "--set", "i1=1", &program],
        vec!["run", "--scans", "3", "--set", "go=TRUE", "--text", text],
        vec![
            "run",
            "--scans",
            "3",
            "--set",
            "go=1",
            "--language",
            "il",
            "--text",
            text,
        ],
    ] {
        let table = "name  type  value  place\ngo    BOOL  TRUE   I 01\nlamp  BOOL  TRUE   Q 01\nn     DINT  6      D 01\n";
        assert_eq!(
            outcome(&arguments),
            (0, table.to_owned(), String::new()),
            "{arguments:?}"
        );
    }
    let code = file("run.txt", "0\n766801\n787602\n1\n838401\n");
    let (exit, out, _) = outcome(&["compile", &program]);
    assert_eq!(exit, 0);
    let compiled = file("run-compiled.txt", &out);
    let (exit, out, _) = outcome(&["run", "--json", "--set", "D1=40", &compiled]);
    let expected = r#"{"scans": 1, "printed": [], "symbols": [{"name": "I1", "type": "BOOL", "value": false, "place": "I 01"}, {"name": "Q1", "type": "BOOL", "value": false, "place": "Q 01"}, {"name": "D1", "type": "DINT", "value": 42, "place": "D 01"}]}"#;
    assert_eq!((exit, out.trim_end()), (0, expected));
    // Its faults are those of `check`.
    let (exit, out, _) = outcome(&["run", &code]);
    assert_eq!((exit, out), (1, outcome(&["check", &code]).1));
    let endless = file("endless.il", "again: LD I1\nST Q1\nJMP again\n");
    for (lang, told) in [
        ("C", "endless.il:3: fault 75: "),
        ("pt_BR", "endless.il:3: falha 75: "),
    ] {
        let (exit, out, err) = outcome_in(&["run", &endless], lang);
        assert_eq!((exit, out.as_str()), (1, ""));
        assert!(err.contains(told), "{err}");
    }
}

#[test]
fn interscl_runs_by_extension_by_first_word_and_by_language() {
    let block = "BLOCO\n  INT i; INT s;\n  FOR i := 1 TO 10 DO s := s + i * i; END_FOR;\n  PRINT(s);\nEND_BLOCK\n";
    let expected =
        "385\nname  type  value  place\ni     INT   11     D 01\ns     INT   385    D 02\n";
    let named = file("squares.iscl", block);
    for arguments in [
        vec!["run", &named],
        vec!["run", "--text", block],
        vec!["run", "--language", "iscl", "--text", block],
    ] {
        let expected = (0, expected.to_owned(), String::new());
        assert_eq!(outcome(&arguments), expected, "{arguments:?}");
    }
    let (code, out, _) = outcome(&["run", "--json", "--scans", "2", "--text", block]);
    assert_eq!(code, 0);
    assert!(
        out.starts_with(r#"{"scans": 2, "printed": [385, 770], "#),
        "{out}"
    );
}

#[test]
fn what_is_wrong_in_interscl_and_lce_is_told_in_both_languages() {
    for (text, lang, told) in [
        (
            "BLOCO INT a, b; END_BLOCK",
            "C",
            "error[ISCL-304]: a declaration has only one name, but `b` follows the comma\n --> the text:1:12\n",
        ),
        (
            "BLOCO INT a, b; END_BLOCK",
            "pt_BR",
            "erro[ISCL-304]: uma declaração tem um só nome, mas `b` vem depois da vírgula\n --> o texto:1:12\n",
        ),
        (
            "clp x 5 := V0; fim",
            "C",
            "error[LCE-403]: `5` is a constant, but a variable is needed here\n --> the text:1:7\n",
        ),
        (
            "clp x 5 := V0; fim",
            "pt_BR",
            "erro[LCE-403]: `5` é uma constante, mas aqui é preciso uma variável\n --> o texto:1:7\n",
        ),
    ] {
        let (code, out, err) = outcome_in(&["run", "--text", text], lang);
        assert_eq!((code, err.as_str()), (1, ""));
        assert!(out.starts_with(told), "{out}");
    }
}
