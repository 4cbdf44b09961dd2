//! The scenario format: what a file says is what runs, and what is wrong is told with its line.

use std::fs;
use std::path::PathBuf;
use unoclp_exercise::scenario::{
    Exercise, ProgramFile, Scenario, Verdict, check, grade as grade_of,
};
use unoclp_host_sim::engine::{HostEngine, Refusal};
use unoclp_program::Lang;

/// Writes a scenario file for one test.
fn file(name: &str, source: &str) -> PathBuf {
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    fs::write(&path, source).unwrap();
    path
}

fn load(name: &str, source: &str) -> Scenario {
    Scenario::load(&file(name, source), unoclp_core::Board::UNO)
        .unwrap_or_else(|error| panic!("{error}"))
}

/// I1 to Q1.
const HEAD: &str = "about = \"Q1 follows I1.\"\ntext = \"0\\n827301\\n877901\\n\"\n";

#[test]
fn what_is_wrong_is_told_with_file_line_and_remedy() {
    #[rustfmt::skip]
    let cases = [
        // (after the head, the line, the message)
        ("[[step]]\nat = 0\nexpect = { Q5 = 1 }", 5, "a test cannot check Q5; use Q1 to Q4, M1 to M64, D1 to D98, P1 or P4"),
        ("[[step]]\nat = 0\nexpect = { I1 = 1 }", 5, "a test cannot check I1; use Q1 to Q4, M1 to M64, D1 to D98, P1 or P4"),
        ("[[step]]\nat = 0\nset = { I0 = 1 }", 5, "I0 cannot be set; set I1 to I8, A0 to A4, M1 to M64 or D1 to D98"),
        ("[[step]]\nat = 0\nset = { I01 = 1 }", 5, "I01 cannot be set; set I1 to I8, A0 to A4, M1 to M64 or D1 to D98"),
        ("[[step]]\nat = 0\n[step.set]\nI1 = 1\nI9 = 0", 7, "I9 cannot be set; set I1 to I8, A0 to A4, M1 to M64 or D1 to D98"),
        ("[[step]]\nat = 0\nset = { I1 = 2 }", 5, "I1 must be 0 or 1"),
        ("[[step]]\nat = 0\nset = { I1 = \"any\" }", 5, "I1 must be 0 or 1"),
        ("[[step]]\nat = 0\nexpect = { Q1 = true }", 5, "Q1 must be 0 or 1, or \"any\""),
        ("[[step]]\nat = 0\nexpect = { Q1 = \"all\" }", 5, "Q1 must be 0 or 1, or \"any\""),
        ("until = 1000000000\n[[step]]\nat = 0", 3, "this scenario would take 1000000001 scans, but all cases of a file together may take 2000000; end it earlier (`until`), or increase `scan_ms`"),
        ("names = { Q1 = 1 }\n[[step]]\nat = 0", 3, "write text as \"…\" or { en = \"…\", pt = \"…\" }, or with only one of the two languages"),
        ("names = { Q1 = {} }\n[[step]]\nat = 0", 3, "write text as \"…\" or { en = \"…\", pt = \"…\" }, or with only one of the two languages"),
        ("[[step]]\nat = 5\n[[step]]\nat = 4", 6, "the step at 4 ms is not later than the one at 5 ms; put the steps in chronological order"),
        ("[[step]]\nat = 5\n[[step]]\nat = 5", 6, "the step at 5 ms is not later than the one at 5 ms; put the steps in chronological order"),
        ("scan_ms = 7\n[[step]]\nat = 15", 5, "no scan starts at 15 ms; scans start every 7 ms (`scan_ms`)"),
        ("scan_ms = 0\n[[step]]\nat = 0", 3, "`scan_ms` must be 1 or more"),
        ("until = 4\n[[step]]\nat = 5", 3, "`until` comes before the last step, at 5 ms"),
        ("[[step]]\nat = 5\nuntil = 9", 5, "unknown field `until`, expected one of `at`, `restart`, `set`, `expect`; put file-wide keys above the first [[step]]"),
        ("speed = 3", 3, "unknown field `speed`, expected one of `about`, `title`, `board`, `task`, `hints`, `names`, `normally_closed`, `equivalent`, `program`, `plant`, `seeds`, `text`, `given`, `answer_in`, `find`, `start_ms`, `scan_ms`, `within_ms`, `until`, `fault`, `stops`, `step`, `case`"),
        ("[[case]]\ntitle = { en = \"a\", pt = \"b\" }", 3, "nothing happens in this scenario; write a [[step]] or the expected `fault`"),
        ("[[case]]\nstep = [{ at = 0 }]", 3, "missing field `title`"),
        ("until = 5\n[[case]]\ntitle = { en = \"a\", pt = \"b\" }\nstep = [{ at = 0 }]", 4, "in a file with [[case]], the steps and `until` belong in the cases; move them there"),
        ("[[case]]\ntitle = { en = \"a\", pt = \"b\" }\nstep = [{ at = 9, expect = { Q1 = 2 } }]", 5, "Q1 must be 0 or 1, or \"any\""),
        ("names = { X1 = { en = \"a\", pt = \"b\" } }\nuntil = 5", 3, "X1 is not a point; the points are I1 to I8, A0 to A4, Q1 to Q4, P1, P4, M1 to M64 and D1 to D98"),
        ("scan_ms = 10\nwithin_ms = 25\nuntil = 5", 4, "no scan starts at 25 ms; scans start every 10 ms (`scan_ms`)"),
        ("until = 12\nwithin_ms = 10\n[[step]]\nat = 5\nexpect = { Q1 = 1 }", 3, "`until` comes before the last step, at 15 ms"),
        ("program = \"x.txt\"\n[[step]]\nat = 0", 2, "`program` and `text` both give a program; keep one of them"),
        ("given = \"LD I1\\nST Q1\\n\"\nuntil = 5", 3, "write `given` and `answer_in` together: a program, and the language for the answer"),
        ("answer_in = \"st\"\nuntil = 5", 3, "write `given` and `answer_in` together: a program, and the language for the answer"),
        ("given = \"LD I1\\nST Q1\\n\"\nanswer_in = \"cobol\"\nuntil = 5", 4, "`answer_in` names no language; write \"st\", \"scl\", \"iscl\", \"lce\", \"il\", \"xml\" or \"numeric\""),
        ("given = \"LD I9\\n\"\nanswer_in = \"st\"\nuntil = 5", 3, "the program in `given` has errors; `unoclp check` shows them"),
        ("find = { part = \"k1\", is = \"welded\" }\nuntil = 5", 3, "[find] hides a fault; name its machine with `plant`"),
        ("seeds = [1]\nuntil = 5", 3, "`seeds` are random seeds of a machine; name the machine with `plant`"),
        ("plant = \"m.toml\"\nseeds = [1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1]\nuntil = 5", 4, "`seeds` has more than 20 numbers; remove some"),
        ("equivalent = [{ was = \"LD I1\", is = \"\" }]\nuntil = 5", 3, "missing field `why`"),
        ("fault = { number = 24 }\nuntil = 5", 3, "a scenario that expects a `fault` does not run its program; remove `fault`, or the steps and `until`"),
        ("fault = { number = 24 }\n[[step]]\nat = 0", 3, "a scenario that expects a `fault` does not run its program; remove `fault`, or the steps and `until`"),
        ("fault = { number = 99 }", 3, "there is no fault 99; docs/faults.md lists them"),
        ("fault = { number = 24, line = 0 }", 3, "count lines from 1; omit `line` if the fault has no line"),
        ("fault = { number = 24, code = 1 }", 3, "unknown field `code`, expected `number` or `line`"),
        ("[[step]]\nat = 0\nset = { A5 = 1 }", 5, "A5 cannot be set; set I1 to I8, A0 to A4, M1 to M64 or D1 to D98"),
        ("[[step]]\nat = 0\nset = { P1 = 1 }", 5, "P1 cannot be set; set I1 to I8, A0 to A4, M1 to M64 or D1 to D98"),
        ("[[step]]\nat = 0\nset = { A0 = 1024 }", 5, "A0 must be a number from 0 to 1023"),
        ("[[step]]\nat = 0\nset = { M1 = 2 }", 5, "M1 must be 0 or 1"),
        ("[[step]]\nat = 0\nset = { D1 = 2147483648 }", 5, "D1 must be a number from -2147483648 to 2147483647"),
        ("[[step]]\nat = 0\nexpect = { M65 = 1 }", 5, "a test cannot check M65; use Q1 to Q4, M1 to M64, D1 to D98, P1 or P4"),
        ("[[step]]\nat = 0\nexpect = { P2 = 1 }", 5, "a test cannot check P2; use Q1 to Q4, M1 to M64, D1 to D98, P1 or P4"),
        ("[[step]]\nat = 0\nexpect = { P4 = 256 }", 5, "P4 must be a number from 0 to 255, or \"any\""),
        ("[[step]]\nat = 0\nrestart = 1", 5, "invalid type: integer `1`, expected a boolean"),
        ("stops = { at = 5, number = 75 }\nuntil = 5", 3, "the run ends at `stops`; remove `until` and later steps"),
        ("stops = { at = 5, number = 75 }\n[[step]]\nat = 6", 3, "the run ends at `stops`; remove `until` and later steps"),
        ("scan_ms = 2\nstops = { at = 5, number = 75 }", 4, "no scan starts at 5 ms; scans start every 2 ms (`scan_ms`)"),
        ("stops = { at = 5, number = 99 }", 3, "there is no fault 99; docs/faults.md lists them"),
        ("fault = { number = 24 }\nstops = { at = 5, number = 75 }", 3, "a scenario that expects a `fault` does not run its program; remove `fault`, or the steps and `until`"),
        ("[[step]]\nat = -1", 4, "invalid value: integer `-1`, expected u32"),
        ("[[step]]\nset = { I1 = 1 }", 3, "missing field `at`"),
        ("about = \"again\"", 3, "duplicate key"),
    ];
    for (index, (source, line, message)) in cases.into_iter().enumerate() {
        let path = file(&format!("wrong-{index}.toml"), &format!("{HEAD}{source}\n"));
        let told = match Scenario::load(&path, unoclp_core::Board::UNO) {
            Ok(_) => panic!("accepted: {source}"),
            Err(error) => error.to_string(),
        };
        assert_eq!(
            told,
            format!("{}:{line}: {message}", path.display()),
            "{source}"
        );
    }
}

#[test]
fn what_is_wrong_with_the_whole_file_is_told_without_a_line() {
    #[rustfmt::skip]
    let cases = [
        ("about = \"\"\n[[step]]\nat = 0", "the scenario names no program; give a file: `sim FILE --scenario S.toml`"),
        ("text = \"0\"\nuntil = 5", "missing field `about`"),
        ("about = \"\"\ntext = \"0\"\n[[case]]\ntitle = { en = \"a\", pt = \"b\" }\nstep = [{ at = 0 }]\n[[case]]\ntitle = { en = \"a\", pt = \"b\" }\nstep = [{ at = 0 }]", "the scenario has 2 cases, but only one can run here"),
        (HEAD, "nothing happens in this scenario; write a [[step]] or the expected `fault`"),
    ];
    for (index, (source, message)) in cases.into_iter().enumerate() {
        let path = file(&format!("whole-{index}.toml"), source);
        let told = Scenario::load(&path, unoclp_core::Board::UNO)
            .map(|_| ())
            .unwrap_err()
            .to_string();
        assert_eq!(told, format!("{}: {message}", path.display()));
    }
}

#[test]
fn files_that_are_missing_are_named() {
    let missing = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("no-such.toml");
    let told = Scenario::load(&missing, unoclp_core::Board::UNO)
        .map(|_| ())
        .unwrap_err()
        .to_string();
    let start = format!("{}: the file cannot be read: ", missing.display());
    assert!(told.starts_with(&start), "{told}");

    let path = file(
        "no-program.toml",
        "about = \"\"\nprogram = \"no-such.txt\"\n",
    );
    let told = Scenario::load(&path, unoclp_core::Board::UNO)
        .map(|_| ())
        .unwrap_err()
        .to_string();
    let program = path.with_file_name("no-such.txt");
    let start = format!(
        "{}:2: the program {} cannot be read: ",
        path.display(),
        program.display()
    );
    assert!(told.starts_with(&start), "{told}");
}

#[test]
fn the_program_is_named_relative_to_the_scenario() {
    file("relative.txt", "0\n827301\n877901\n");
    let source = "about = \"\"\nprogram = \"relative.txt\"\nuntil = 3\n";
    let scenario = load("relative.toml", source);
    assert_eq!(scenario.program().bytes, b"0\n827301\n877901\n");
    assert_eq!(scenario.about(Lang::En), "");
    assert_eq!(scenario.expected_refusal(), None);
}

#[test]
fn an_expectation_is_in_force_until_its_point_is_named_again() {
    let steps = "until = 30\n\
        [[step]]\nat = 0\nexpect = { Q1 = 0, Q2 = 0 }\n\
        [[step]]\nat = 10\nset = { I1 = 1 }\nexpect = { Q1 = 1 }\n\
        [[step]]\nat = 20\nset = { I1 = 0 }\nexpect = { Q1 = \"any\" }\n";
    let scenario = load("in-force.toml", &format!("{HEAD}{steps}"));
    let report = check(&scenario, &mut HostEngine::new(unoclp_core::Board::UNO));
    // Q1 in the scans 0 to 19, Q2 in all of 0 to 30.
    assert_eq!(
        report.verdict,
        Verdict::Met {
            comparisons: 20 + 31
        }
    );
    let times: Vec<_> = report.changes.iter().map(|change| change.at).collect();
    assert_eq!(times, [0, 10, 20]);
}

#[test]
fn scans_run_every_scan_ms_up_to_until() {
    let source =
        format!("{HEAD}scan_ms = 7\nuntil = 30\n[[step]]\nat = 7\nexpect = {{ Q1 = 0 }}\n");
    let report = check(
        &load("period.toml", &source),
        &mut HostEngine::new(unoclp_core::Board::UNO),
    );
    // At 7, 14, 21 and 28 ms.
    assert_eq!(report.verdict, Verdict::Met { comparisons: 4 });
}

#[test]
fn a_fault_is_expected_with_or_without_a_line() {
    for (line, expected) in [("", None), (", line = 3", Some(3))] {
        let source = format!("{HEAD}fault = {{ number = 24{line} }}\n");
        let scenario = load("fault.toml", &source);
        let refusal = Refusal {
            number: 24,
            line: expected,
        };
        assert_eq!(scenario.expected_refusal(), Some(refusal));
    }
}

#[test]
fn memory_is_set_and_compared() {
    // D1 + A0 to D2, M1 to M2, and D1 as PWM of output 04.
    let program =
        "0\\n766801\\n83848004\\n".to_owned() + "76686500\\n65686801\\n838402\\n827701\\n877702\\n";
    let head = format!("about = \"Sums.\"\ntext = \"{program}\"\n");
    let steps = "until = 3\n\
        [[step]]\nat = 0\nexpect = { D2 = 0, M2 = 0, P4 = 0 }\n\
        [[step]]\nat = 1\nset = { D1 = 300, A0 = 7, M1 = 1 }\nexpect = { D2 = 307, M2 = 1, P4 = 255 }\n\
        [[step]]\nat = 2\nset = { D1 = -9 }\nexpect = { D2 = -2, P4 = 1 }\n";
    let scenario = load("memory.toml", &format!("{head}{steps}"));
    assert!(scenario.is_for_lockstep());
    let report = check(&scenario, &mut HostEngine::new(unoclp_core::Board::UNO));
    let told = report.to_string();
    let table = "        ms  I1  I2  I3  I4    A0    Q1  Q2  Q3  Q4   M2          D2          P4    1 = closed, on; · = open, off
         0   ·   ·   ·   ·     0     ·   ·   ·   ·    ·           0           0
         1   ·   ·   ·   ·     7     ·   ·   ·   ·    1         307         255
         2   ·   ·   ·   ·     7     ·   ·   ·   ·    1          -2           0

FAIL
  P4 at 2 ms: expected 1, got 0 (until 3 ms)";
    assert!(told.ends_with(table), "{told}");
}

#[test]
fn a_restart_keeps_retentive_markers_alone() {
    let program = "text = \"0\\n828301\\n877903\\n\"\n";
    let steps = "step = [\n\
        { at = 0, set = { M56 = 1, M57 = 1, M64 = 1, D1 = 5 }, expect = { Q3 = 1 } },\n\
        { at = 1, expect = { Q3 = 0, M56 = 1, M57 = 1, M64 = 1, D1 = 5 } },\n\
        { at = 2, restart = true, expect = { Q3 = 1, M56 = 0, M57 = 1, M64 = 1, D1 = 0 } },\n\
        { at = 3, expect = { Q3 = 0 } },\n]\n";
    let scenario = load("restart.toml", &format!("about = \"\"\n{program}{steps}"));
    let report = check(&scenario, &mut HostEngine::new(unoclp_core::Board::UNO));
    assert_eq!(report.verdict.to_string(), "PASS");
}

#[test]
fn a_run_may_end_in_a_fault() {
    // Jumps back forever while I1 is closed.
    let head = "about = \"\"\ntext = \"0\\n766601\\n827301\\n74778001\\n787600\\n877901\\n\"\n";
    let step = "[[step]]\nat = 3\nset = { I1 = 1 }\n";
    let told = |name: &str, stops: &str| {
        let scenario = load(name, &format!("{head}{stops}\n{step}"));
        let report = check(&scenario, &mut HostEngine::new(unoclp_core::Board::UNO));
        report.verdict.to_string()
    };
    let fault = "fault 75, line 4: too many backward jumps in one scan (NC-19)";
    assert_eq!(
        told("stops.toml", "stops = { at = 3, number = 75, line = 4 }"),
        format!("PASS: stopped as expected at 3 ms: {fault}")
    );
    assert_eq!(
        told(
            "stops-later.toml",
            "stops = { at = 5, number = 75, line = 4 }"
        ),
        format!("FAIL\n  expected at 5 ms {fault}\n  got      at 3 ms {fault}")
    );
    assert_eq!(
        told("stops-not.toml", "until = 4"),
        format!("FAIL\n  expected the program to keep running\n  got      at 3 ms {fault}")
    );
    let runs_on = load(
        "runs-on.toml",
        &format!("{head}stops = {{ at = 2, number = 75, line = 4 }}\n"),
    );
    let report = check(&runs_on, &mut HostEngine::new(unoclp_core::Board::UNO));
    assert_eq!(
        report.verdict.to_string(),
        format!("FAIL\n  expected at 2 ms {fault}\n  but the program kept running")
    );
}

#[test]
fn a_text_may_be_given_by_its_parts() {
    let source = |text: &str| format!("about = \"\"\ntext = {text}\nfault = {{ number = 24 }}\n");
    let path = file(
        "parts.toml",
        &source(r#"["0\n", { repeat = 3, text = "40\n" }, { repeat = 0, text = "5" }, "41\n"]"#),
    );
    let scenario =
        Scenario::load(&path, unoclp_core::Board::UNO).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(scenario.program().bytes, b"0\n40\n40\n40\n41\n");

    let kind = "write `text` as a string, or as a list of strings and { repeat = 3, text = \"…\" }";
    #[rustfmt::skip]
    let cases = [
        ("5", kind),
        (r#"["0\n", 5]"#, kind),
        (r#"[{ repeat = -1, text = "" }]"#, kind),
        (r#"[{ repeat = 1, text = "", line = 3 }]"#, kind),
        (r#"["0\n", { repeat = 1048575, text = "\n" }]"#, "`text` is longer than 1048576 bytes"),
        (r#"[{ repeat = 9223372036854775807, text = "123" }]"#, "`text` is longer than 1048576 bytes"),
    ];
    for (index, (text, message)) in cases.into_iter().enumerate() {
        let path = file(&format!("wrong-parts-{index}.toml"), &source(text));
        let told = Scenario::load(&path, unoclp_core::Board::UNO)
            .map(|_| ())
            .unwrap_err()
            .to_string();
        assert_eq!(told, format!("{}:2: {message}", path.display()), "{text}");
    }
}

/// What is told of a scenario in Portuguese has no word of English.
#[test]
fn what_is_wrong_is_told_in_portuguese() {
    let step = |rest: &str| format!("{HEAD}[[step]]\nat = 0\n{rest}\n");
    #[rustfmt::skip]
    let cases = [
        (step("expect = { Q5 = 1 }"), ":5: um teste não pode verificar Q5; use Q1 a Q4, M1 a M64, D1 a D98, P1 ou P4"),
        (step("expect = { Q1 = 2 }"), ":5: Q1 deve ser 0 ou 1, ou \"any\""),
        (step("until = 9"), ":5: não existe a chave `until` aqui; chaves conhecidas: `at`, `restart`, `set`, `expect`; ponha as chaves gerais do arquivo acima do primeiro [[step]]"),
        (step("restart = 1"), ":5: este valor não é do tipo que a chave pede"),
        (format!("{HEAD}board = \"due\""), ":3: não existe a placa \"due\"; placas conhecidas: uno, nano, mega, pc"),
        (format!("{HEAD}[[step]]"), ":3: falta a chave `at`"),
        (format!("{HEAD}about = \"\""), ":3: esta chave aparece duas vezes"),
        (format!("{HEAD}[["), ":3: isto não é TOML válido; confira aspas, vírgulas e colchetes"),
        ("about = \"\"\ntext = 5".to_owned(), ":2: escreva `text` como uma string, ou como uma lista de strings e { repeat = 3, text = \"…\" }"),
    ];
    for (index, (source, message)) in cases.into_iter().enumerate() {
        let path = file(&format!("errado-{index}.toml"), &source);
        let error = Scenario::load(&path, unoclp_core::Board::UNO)
            .map(|_| ())
            .unwrap_err();
        let expected = format!("{}{message}", path.display());
        assert_eq!(error.text(Lang::Pt), expected, "{source}");
    }
}

#[test]
fn a_report_is_told_in_portuguese() {
    let source = format!("{HEAD}until = 3\n[[step]]\nat = 1\nexpect = {{ Q1 = 1 }}\n");
    let scenario = load("relato.toml", &source);
    let report = check(&scenario, &mut HostEngine::new(unoclp_core::Board::UNO));
    let expected = "Q4    1 = fechada, ligada; · = aberta, desligada
         0   ·   ·   ·   ·     ·   ·   ·   ·

FALHOU
  Q1 aos 1 ms: esperado 1, obtido 0 (até 3 ms)";
    let told = report.text(Lang::Pt);
    assert!(told.ends_with(expected), "{told}");
    let scenario = load("recusa.toml", &format!("{HEAD}fault = {{ number = 24 }}\n"));
    let told = check(&scenario, &mut HostEngine::new(unoclp_core::Board::UNO)).text(Lang::Pt);
    let expected = "FALHOU\n  esperado: falha 24: código inexistente\n  mas o programa foi aceito";
    assert!(told.ends_with(expected), "{told}");
}

#[test]
fn a_text_without_end_is_refused_at_once() {
    let hole = |name: &str| {
        let path = file(name, "");
        let file = fs::File::options().write(true).open(&path).unwrap();
        file.set_len(50_000_000).unwrap();
        path
    };
    let says = "is longer than 1048576 bytes; no program or scenario is that long";
    let path = hole("long.toml");
    let error = Scenario::load(&path, unoclp_core::Board::UNO).unwrap_err();
    assert_eq!(
        error.to_string(),
        format!("{}: the file {says}", path.display())
    );

    let program = hole("long.txt");
    let path = file(
        "long-program.toml",
        "about = \"\"\nprogram = \"long.txt\"\n",
    );
    let error = Scenario::load(&path, unoclp_core::Board::UNO).unwrap_err();
    let program = program.display();
    let expected = format!("{}:2: the program {program} {says}", path.display());
    assert_eq!(error.to_string(), expected);
    assert!(error.text(Lang::Pt).contains("passa de 1048576 bytes"));

    // As one text it has the same limit as in parts.
    let text = format!("about = \"\"\ntext = \"{}\"\n", "/".repeat(1 << 20));
    let error =
        Scenario::load(&file("long-text.toml", &text), unoclp_core::Board::UNO).unwrap_err();
    assert!(error.to_string().contains("is longer than 1048576 bytes"));
}

/// A step that expects Q1 to follow I1.
const FOLLOWS: &str = "[[step]]\nat = 0\nset = { I1 = 1 }\nexpect = { Q1 = 1 }\n[[step]]\nat = 5\nset = { I1 = 0 }\nexpect = { Q1 = 0 }\n";

#[test]
fn a_scenario_names_instruction_list_which_is_compiled() {
    file("lamp.il", "LD I1\nST Q1\n");
    let source = format!("about = \"\"\nprogram = \"lamp.il\"\n{FOLLOWS}");
    let scenario = load("names-il.toml", &source);
    assert!(scenario.program().name.ends_with("lamp.il"));
    let report = check(&scenario, &mut HostEngine::new(unoclp_core::Board::UNO));
    assert!(report.passed(), "{report}");

    file("lamp-wrong.il", "LDN I1\nST Q1\n");
    let scenario = load(
        "names-wrong-il.toml",
        &source.replace("lamp.il", "lamp-wrong.il"),
    );
    let report = check(&scenario, &mut HostEngine::new(unoclp_core::Board::UNO));
    assert!(!report.passed(), "{report}");

    file("lamp-faulty.il", "LD I9\nST Q1\n");
    let path = file(
        "names-faulty-il.toml",
        &source.replace("lamp.il", "lamp-faulty.il"),
    );
    let error = Scenario::load(&path, unoclp_core::Board::UNO)
        .unwrap_err()
        .to_string();
    assert!(
        error.contains(":2: the program ")
            && error.ends_with("has errors; `unoclp check` shows them"),
        "{error}"
    );
}

#[test]
fn a_scenario_may_name_no_program_and_then_needs_one() {
    let path = file("names-none.toml", &format!("about = \"\"\n{FOLLOWS}"));
    let error = Scenario::load(&path, unoclp_core::Board::UNO)
        .unwrap_err()
        .to_string();
    assert!(
        error.contains("the scenario names no program; give a file"),
        "{error}"
    );
    assert_eq!(
        Exercise::load(&path, unoclp_core::Board::UNO)
            .unwrap()
            .program,
        None
    );
    let program = ProgramFile {
        name: "mine".to_owned(),
        bytes: b"0\n827301\n877901\n".to_vec(),
    };
    let scenario = Scenario::load_for(&path, program, unoclp_core::Board::UNO).unwrap();
    let report = check(&scenario, &mut HostEngine::new(unoclp_core::Board::UNO));
    assert!(report.passed(), "{report}");
}

const EXERCISE: &str = "program = \"lamp.il\"\n\
    title = { en = \"A lamp\", pt = \"Uma lâmpada\" }\n\
    task = { en = \"Light it.\", pt = \"Acenda.\" }\n\
    hints = [{ en = \"Look.\", pt = \"Olhe.\" }]\n\
    within_ms = 10\n\
    names = { I1 = { en = \"button\", pt = \"botão\" } }\n\
    [[case]]\ntitle = { en = \"On\", pt = \"Liga\" }\n\
    step = [{ at = 0, set = { I1 = 1 }, expect = { Q1 = 1 } }]\n\
    [[case]]\ntitle = { en = \"Off\", pt = \"Desliga\" }\nhidden = true\n\
    step = [{ at = 0, expect = { Q1 = 0 } }]\nuntil = 20\n";

#[test]
fn an_exercise_says_what_to_do_and_has_cases() {
    let exercise = Exercise::of_text("lamp.toml", EXERCISE, unoclp_core::Board::UNO).unwrap();
    assert_eq!(exercise.title.text(Lang::Pt), "Uma lâmpada");
    assert_eq!(exercise.task.as_ref().unwrap().text(Lang::En), "Light it.");
    assert_eq!(exercise.hints.len(), 1);
    assert_eq!(exercise.names["I1"].pt, "botão");
    let cases: Vec<_> = exercise.cases().iter().collect();
    assert_eq!([cases[0].hidden, cases[1].hidden], [false, true]);
    assert_eq!(cases[1].title.en, "Off");
    let program = ProgramFile {
        name: "mine".to_owned(),
        bytes: b"0\n827301\n877901\n".to_vec(),
    };
    let grade = grade_of(
        &exercise,
        &program,
        &mut HostEngine::new(unoclp_core::Board::UNO),
    );
    assert!(grade.is_passed() && grade.count() == 2, "{grade:?}");
    let always = ProgramFile {
        name: "always".to_owned(),
        bytes: b"0\n787600\n877901\n".to_vec(),
    };
    let grade = grade_of(
        &exercise,
        &always,
        &mut HostEngine::new(unoclp_core::Board::UNO),
    );
    assert_eq!(grade.passed, [true, false]);
    assert_eq!(grade.failing.unwrap().case, 1);
}

/// The second press comes before what the first has to bring about is due.
#[test]
fn what_is_expected_may_come_within_a_time() {
    let steps = "scan_ms = 10\nwithin_ms = 50\nuntil = 300\n\
        [[step]]\nat = 0\nexpect = { Q1 = 0, Q2 = 0 }\n\
        [[step]]\nat = 100\nset = { I1 = 1 }\nexpect = { Q1 = 1, Q2 = 0 }\n\
        [[step]]\nat = 130\nset = { I1 = 0 }\nexpect = { Q1 = 0 }\n";
    let plan = load("within.toml", &format!("{HEAD}{steps}")).plan();
    let courses: Vec<_> = plan.expected.into_values().collect();
    let q1 = vec![
        (0, None),
        (50, Some(0)),
        (100, None),
        (130, None),
        (180, Some(0)),
    ];
    assert_eq!(courses, [q1, vec![(0, None), (50, Some(0))]]);
}

#[test]
fn one_language_is_enough_for_a_text() {
    for (title, en, pt) in [
        (
            "{ en = \"A bell\", pt = \"Uma campainha\" }",
            "A bell",
            "Uma campainha",
        ),
        (
            "{ pt = \"Uma campainha\" }",
            "Uma campainha",
            "Uma campainha",
        ),
        ("{ en = \"A bell\" }", "A bell", "A bell"),
        ("\"A bell\"", "A bell", "A bell"),
    ] {
        let source = format!("title = {title}\n[[step]]\nat = 0\n");
        let exercise = Exercise::of_text("bell.toml", &source, unoclp_core::Board::UNO).unwrap();
        let told = [Lang::En, Lang::Pt].map(|lang| exercise.title.text(lang).to_owned());
        assert_eq!(told, [en, pt], "{title}");
    }
}
