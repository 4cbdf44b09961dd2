//! The program `unoclp` itself: exit codes, messages and files.

use crate::common::{file, outcome, outcome_in};
use std::fs;

const FOLLOW: &str = "0\n787600\n827301\n847978\n3\n7901\n";

#[test]
fn check_tells_the_size_of_a_valid_program() {
    let program = file("valid.txt", FOLLOW);
    let (code, out, err) = outcome(&["check", &program]);
    let size = "OK: 4 codes, 8 of 900 bytes (892 free), 1 timer\n  \
                12 of 960 bytes of run memory; pins: I1 Q1";
    assert_eq!(
        (code, out, err),
        (0, format!("{program}: {size}\n"), String::new())
    );
}

#[test]
fn check_tells_what_a_program_uses() {
    // LDA 02, ST 03, PWM of output 04; CTU 01; M 09 to M 16.
    let text = "0\n76686502\n838403\n83848004\n787600\n827305\n67848501\n7\n877903\n83847702\n";
    let program = file("uses.txt", text);
    let (code, out, _) = outcome(&["check", &program]);
    assert_eq!(code, 0, "{out}");
    assert!(
        out.contains("0 timers, 1 counter, 1 register, 8 markers\n"),
        "{out}"
    );
    assert!(out.ends_with("; pins: I5 A2 Q3 P4\n"), "{out}");
    let text = "0\n827709\n877710\n";
    let (code, out, _) = outcome(&["check", &file("no-pins.txt", text)]);
    assert_eq!(code, 0, "{out}");
    assert!(out.ends_with(" bytes of run memory; no pins\n"), "{out}");
}

#[test]
fn faults_are_exit_code_1_in_every_command() {
    let program = file("faulty.txt", "0\n827309\n");
    for command in ["check", "sim", "list"] {
        let (code, out, err) = outcome(&[command, &program]);
        assert_eq!((code, err.as_str()), (1, ""));
        assert!(
            out.starts_with("error[25]: this board has no such input\n"),
            "{out}"
        );
        assert!(
            out.ends_with(": 1 fault; the board will not run this program\n"),
            "{out}"
        );
    }
}

#[test]
fn what_cannot_be_done_is_exit_code_2_and_says_what_to_do() {
    let program = file("untouched.txt", FOLLOW);
    let unknown = file("unknown.toml", "about = \"\"\nspeed = 3\n");
    #[rustfmt::skip]
    let cases: &[(&[&str], &str)] = &[
        (&["check", "no-such.txt"], "error: no-such.txt cannot be read ("),
        (&["sim", "no-such.txt"], "error: no-such.txt cannot be read ("),
        (&["sim", "--scenario", "no-such.toml"], "error: no-such.toml: the file cannot be read: "),
        (&["sim", "--scenario", &unknown], "error: "),
        (&["sim"], "error: nothing to simulate; name a program or a --scenario"),
        (&["sim", &program], "error: the simulator needs a terminal; without one, run a scenario: --scenario"),
        (&["list", "no-such.txt"], "error: no-such.txt cannot be read ("),
        (&["list"], "error: the following required arguments were not provided:\n  <FILE>"),
        (&["list", &program, "--width", "20"], "error: invalid value '20' for '--width <N>': 20 is not in 56..=1000"),
        (&["list", &program, "--as", "numeric", "--svg", "o.svg"], "error: --svg draws a ladder diagram, a block diagram (--as fbd) or a chart (--as sfc, --as grafcet); leave out --as or --svg"),
        (&["list", &program, "--svg", "no-such/o.svg"], "error: no-such/o.svg cannot be written: "),
        (&["fly"], "error: unrecognized subcommand 'fly'"),
        (&[], "The unoclp PLC: check and simulate programs on this PC, upload them to a board and watch it"),
    ];
    for (arguments, message) in cases {
        let (code, out, err) = outcome(arguments);
        assert_eq!((code, out.as_str()), (2, ""), "{arguments:?}");
        assert!(err.starts_with(message), "{arguments:?}: {err}");
    }
}

#[test]
fn the_version_is_told() {
    let (code, out, _) = outcome(&["--version"]);
    assert_eq!(
        (code, out),
        (0, format!("unoclp {}\n", env!("CARGO_PKG_VERSION")))
    );
}

#[test]
fn a_scenario_passes_or_fails_and_leaves_its_trace() {
    file("sampled.txt", FOLLOW);
    let scenario = file(
        "sampled.toml",
        "about = \"Q1 follows I1 after 3 ms.\"\nprogram = \"sampled.txt\"\n\
         [[step]]\nat = 0\nset = { I1 = 1 }\nexpect = { Q1 = 0 }\n\
         [[step]]\nat = 3\nexpect = { Q1 = 1 }\n",
    );
    let trace = file("sampled.vcd", "");
    let (code, out, _) = outcome(&["sim", "--scenario", &scenario, "--vcd", &trace]);
    assert_eq!(code, 0, "{out}");
    assert!(out.ends_with("\n\nPASS\n"), "{out}");
    let trace = fs::read_to_string(trace).unwrap();
    for part in [
        "$timescale 1 ms $end",
        " T1 $end",
        " elapsed_ms $end",
        "\n#3\n",
        "\n#4",
    ] {
        assert!(trace.contains(part), "{part} is missing in\n{trace}");
    }

    // The same scenario on a program whose timer takes longer.
    let slower = file("slower.txt", &FOLLOW.replace("\n3\n", "\n4\n"));
    let (code, out, _) = outcome(&["sim", &slower, "--scenario", &scenario]);
    assert_eq!(code, 1, "{out}");
    assert!(
        out.ends_with("\n\nFAIL\n  Q1 at 3 ms: expected 1, got 0\n"),
        "{out}"
    );
}

#[test]
fn a_program_is_listed_as_text_and_drawn() {
    let program = file("listed.txt", "/ Lamp\n0\n827301\n877901\n");
    let ladder = "\
Lamp

Rung 1, lines 3 to 4
├──┤ I1 ├───────────────────────────────────────( Q1 )─┤
";
    let drawn = |arguments: &[&str], lang: &str, ladder: &str| {
        let outcome = outcome_in(&[&["list", &program][..], arguments].concat(), lang);
        assert_eq!(outcome, (0, ladder.to_owned(), String::new()));
    };
    drawn(&[], "C.UTF-8", ladder);
    drawn(&["--as", "ladder"], "en_US.UTF-8", ladder);
    // A locale without UTF-8 has no lines to draw with.
    let plain = ladder.replace('─', "-").replace(['├', '┤'], "|");
    drawn(&[], "C", &plain);
    drawn(&[], "", &plain);
    let (code, out, _) = outcome(&["list", &program, "--as", "numeric"]);
    assert_eq!(code, 0);
    assert!(
        out.contains("827301  / RI 01  contact, normally open: "),
        "{out}"
    );
    let drawing = file("listed.svg", "");
    let outcome = outcome(&["list", &program, "--svg", &drawing]);
    assert_eq!(outcome, (0, format!("{drawing}: drawn\n"), String::new()));
    let drawing = fs::read_to_string(drawing).unwrap();
    assert!(
        drawing.contains("<svg ") && drawing.contains("Lamp"),
        "{drawing}"
    );
}

#[test]
fn a_scenario_tests_the_file_that_one_names() {
    let steps = "[[step]]\nat = 0\nset = { I1 = 1 }\nexpect = { Q1 = 1 }\n";
    file("tested.il", "LD I1\nST Q1\n");
    let names_il = file(
        "tested.toml",
        &format!("about = \"\"\nprogram = \"tested.il\"\n{steps}"),
    );
    assert_eq!(outcome(&["sim", "--scenario", &names_il]).0, 0);
    // The text changes, and its numeric code beside it does not.
    file("tested.txt", "0\n827301\n877901\n");
    file("tested.il", "LDN I1\nST Q1\n");
    let (code, out, _) = outcome(&["sim", "--scenario", &names_il]);
    assert_eq!(code, 1, "{out}");
    file("tested.il", "LD I1\nST Q9\n");
    let (code, out, _) = outcome(&["sim", "--scenario", &names_il]);
    assert!(
        code == 1 && out.contains("error[IL-") && out.contains("tested.il:2:"),
        "{out}"
    );

    let names_none = file("untied.toml", &format!("about = \"\"\n{steps}"));
    let (code, _, err) = outcome(&["sim", "--scenario", &names_none]);
    assert_eq!(code, 2);
    assert!(
        err.contains("the scenario names no program; give a file"),
        "{err}"
    );
    let mine = file("untied.il", "LD I1\nST Q1\n");
    assert_eq!(outcome(&["sim", &mine, "--scenario", &names_none]).0, 0);
}

#[test]
fn a_fault_while_it_runs_names_the_line_of_the_text() {
    let loops = file("loops.il", "(* waits *)\nagain:\nLD M1\nJMP again\n");
    let steps = "about = \"\"\n[[step]]\nat = 0\nexpect = { Q1 = 0 }\n";
    let scenario = file("loops.toml", steps);
    let (code, out, _) = outcome(&["sim", &loops, "--scenario", &scenario]);
    assert_eq!(code, 1, "{out}");
    let says = format!(
        "  {loops}:4: fault 75: too many backward jumps in one scan (NC-19)\n    JMP again\n"
    );
    assert!(out.ends_with(&says), "{out}");
}

#[test]
fn a_huge_text_is_refused_at_once() {
    let huge = file("huge.il", "");
    // A hole: nothing is written.
    fs::File::options()
        .write(true)
        .open(&huge)
        .unwrap()
        .set_len(50_000_000)
        .unwrap();
    for command in ["check", "list", "sim", "compile"] {
        let (code, out, err) = outcome(&[command, &huge]);
        assert_eq!((code, out.as_str()), (2, ""));
        assert!(
            err.ends_with("is longer than 1048576 bytes; no program or scenario is that long\n"),
            "{err}"
        );
    }
}

#[test]
fn a_huge_scenario_is_refused_at_once_and_so_is_its_program() {
    let hole = |name: &str| {
        let huge = file(name, "");
        let open = fs::File::options().write(true).open(&huge);
        open.unwrap().set_len(50_000_000).unwrap();
        huge
    };
    let (scenario, program) = (hole("huge.toml"), hole("huge-program.txt"));
    let named = "about = \"\"\nprogram = \"huge-program.txt\"\nuntil = 1\n";
    let named = file("names-huge.toml", named);
    for arguments in [
        &["--scenario", &scenario][..],
        &["--scenario", &named],
        &[&program, "--scenario", &named],
    ] {
        let sim = |lang| outcome_in(&[&["sim"][..], arguments].concat(), lang);
        let (code, out, err) = sim("C");
        assert_eq!((code, out.as_str()), (2, ""));
        assert!(
            err.ends_with("is longer than 1048576 bytes; no program or scenario is that long\n"),
            "{err}"
        );
        let (_, _, err) = sim("pt_BR.UTF-8");
        assert!(
            err.ends_with("passa de 1048576 bytes; nenhum programa ou cenário é tão longo\n"),
            "{err}"
        );
    }
}

#[test]
fn a_report_is_plain_where_the_locale_is() {
    let scenario = file(
        "plain.toml",
        "about = \"\"\ntext = \"0\\n827301\\n877901\\n\"\nuntil = 1\n",
    );
    let report = |lang| outcome_in(&["sim", "--scenario", &scenario], lang).1;
    assert!(
        report("C.UTF-8").contains("  ·   ·"),
        "{}",
        report("C.UTF-8")
    );
    assert!(
        report("C").is_ascii() && report("C").contains("  .   ."),
        "{}",
        report("C")
    );
}

#[test]
fn a_trace_has_the_names_of_the_program() {
    let lamp = file(
        "traced.il",
        "VAR\n button AT %IX1 : BOOL;\n lamp AT %QX1 : BOOL;\nEND_VAR\nLD button\nST lamp\n",
    );
    let scenario = file(
        "traced.toml",
        "about = \"\"\n[[step]]\nat = 0\nexpect = { Q1 = 0 }\n",
    );
    let trace = file("traced.vcd", "");
    let (code, out, err) = outcome(&["sim", &lamp, "--scenario", &scenario, "--vcd", &trace]);
    assert_eq!(code, 0, "{out}{err}");
    let trace = fs::read_to_string(trace).unwrap();
    assert!(
        trace.contains(" I1_button $end") && trace.contains(" Q1_lamp $end"),
        "{trace}"
    );
}

#[test]
fn every_way_to_write_a_language_is_understood() {
    let faulty = file("languages.txt", "0\n827309\n");
    for lang in ["pt", "pt-BR", "pt_BR", "pt-br"] {
        let (code, out, _) = outcome(&["check", &faulty, "--lang", lang]);
        assert_eq!(code, 1);
        assert!(
            out.starts_with("erro[25]: esta placa não tem essa entrada\n"),
            "{out}"
        );
        assert!(
            out.contains("ajuda: o UNO tem as entradas 01 a 08"),
            "{out}"
        );
    }
    let (_, _, err) = outcome_in(&["check", "no-such.txt"], "pt_BR.UTF-8");
    assert!(
        err.starts_with("erro: não foi possível ler no-such.txt"),
        "{err}"
    );
}

/// The texts of the faults are those of the page that explains them.
#[test]
fn each_fault_has_the_portuguese_of_its_page() {
    let page = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/faults.pt-BR.md");
    let page = fs::read_to_string(page)
        .unwrap()
        .replace('\n', " ")
        .to_lowercase();
    for &cause in unoclp_core::Cause::ALL {
        let text = unoclp_program::diagnosis::portuguese(cause);
        assert!(
            page.contains(&format!("*{}", text.to_lowercase())),
            "{text}"
        );
        assert_ne!(text, cause.text());
    }
}

#[test]
fn help_and_wrong_arguments_are_told_in_portuguese() {
    let (code, out, _) = outcome_in(&["sim", "--help"], "pt_BR.UTF-8");
    assert_eq!(code, 0);
    assert!(
        out.starts_with("Simula um programa") && out.contains("\nUso: unoclp sim"),
        "{out}"
    );
    for (arguments, says) in [
        (&["fly"][..], "erro: não existe o comando 'fly'\n"),
        (&["list"], "erro: falta indicar: <ARQUIVO>\n"),
        (
            &["list", "a.txt", "--width", "x"],
            "erro: valor inválido 'x' para '--width <N>'",
        ),
        (
            &["sim"],
            "erro: nada a simular; indique um programa ou um --scenario\n",
        ),
    ] {
        let (code, out, err) = outcome_in(arguments, "pt_BR.UTF-8");
        assert_eq!((code, out.as_str()), (2, ""));
        assert!(err.starts_with(says), "{err}");
    }
    assert!(
        outcome(&["list", "--help", "--lang", "pt"])
            .1
            .contains("Uso:")
    );
}

#[test]
fn the_size_of_a_program_is_told_in_portuguese() {
    let program = file("tamanho.txt", "0\n827305\n67848501\n7\n877701\n");
    let (code, out, _) = outcome_in(&["check", &program], "pt_BR.UTF-8");
    assert_eq!(code, 0);
    assert!(
        out.contains(": OK: 4 códigos, ")
            && out.contains(" livres), 0 temporizadores, 1 contador, 1 memória\n"),
        "{out}"
    );
    assert!(
        out.ends_with("; pinos: I5 \n") || out.ends_with("; pinos: I5\n"),
        "{out}"
    );
}
