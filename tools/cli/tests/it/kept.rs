//! What is told of the numbers that a program keeps over a power cut (NC-21), in both languages.

use crate::common::{file, outcome, outcome_in};

/// A program that keeps so many registers, with so many contacts.
fn keeping(registers: usize, codes: &str) -> String {
    let kept: String = (1..=registers).map(|n| format!("7568{n:02}\n")).collect();
    format!("0\n{kept}{codes}877901\n")
}

#[test]
fn check_tells_how_old_a_kept_number_may_be() {
    // Room for 79, 54, 6 and 2 records.
    for (registers, contacts, english, portuguese) in [
        (
            2,
            26,
            "2 numbers, at most 1 minute old",
            "2 números, gravados no máximo 1 minuto antes",
        ),
        (
            1,
            516,
            "1 number, at most 1 minute old",
            "1 número, gravado no máximo 1 minuto antes",
        ),
        (
            16,
            465,
            "16 numbers, at most 9 minutes old",
            "16 números, gravados no máximo 9 minutos antes",
        ),
        (
            16,
            733,
            "16 numbers, at most 27 minutes old",
            "16 números, gravados no máximo 27 minutos antes",
        ),
    ] {
        let program = file(
            "keeping.txt",
            &keeping(registers, &"827301\n".repeat(contacts)),
        );
        let (code, out, _) = outcome(&["check", &program]);
        assert_eq!(code, 0, "{out}");
        let expected = format!("\n  after a power cut: {english}\n");
        assert!(out.ends_with(&expected), "{out}");
        let (code, out, _) = outcome_in(&["check", &program], "pt_BR.UTF-8");
        assert_eq!(code, 0, "{out}");
        let expected = format!("\n  após uma queda de energia: {portuguese}\n");
        assert!(out.ends_with(&expected), "{out}");
    }
}

#[test]
fn nothing_is_told_where_nothing_is_kept() {
    let program = file("keeping-nothing.txt", &keeping(0, "827301\n"));
    assert!(!outcome(&["check", &program]).1.contains("kept"));
    let (_, out, _) = outcome_in(&["check", &program], "pt_BR.UTF-8");
    assert!(!out.contains("queda"), "{out}");
}

#[test]
fn a_program_without_room_for_two_records_is_refused_with_what_is_lacking() {
    for (codes, english, portuguese) in [
        (
            "827301\n".repeat(734),
            "; 1 more byte of program memory is needed.",
            "; falta 1 byte de memória de programa.",
        ),
        (
            "827301\n".repeat(745),
            "; 12 more bytes of program memory are needed.",
            "; faltam 12 bytes de memória de programa.",
        ),
        (
            ["827301\n".repeat(700), "6985\n".repeat(200)].concat(),
            "; 167 more bytes of program memory and 140 of run memory are needed.",
            "; faltam 167 bytes de memória de programa e 140 de memória de execução.",
        ),
    ] {
        let program = file("lacking.txt", &keeping(16, &codes));
        let (code, out, _) = outcome(&["check", &program]);
        assert_eq!(code, 1, "{out}");
        assert!(
            out.starts_with("error[41]") && out.contains(english),
            "{out}"
        );
        assert!(
            out.contains("kept values need room for two records"),
            "{out}"
        );
        let (code, out, _) = outcome_in(&["check", &program], "pt_BR.UTF-8");
        assert_eq!(code, 1, "{out}");
        assert!(
            out.starts_with("erro[41]") && out.contains(portuguese),
            "{out}"
        );
    }
}

/// A text that keeps two numbers, with so many contacts. What nothing uses is not kept.
fn retaining(contacts: usize) -> String {
    let and = "AND I1\n".repeat(contacts);
    let uses = "LD b\nADD 1\nST a\nLD a\nADD 1\nST b\n";
    format!("VAR RETAIN a, b : DINT; END_VAR\nLD I1\n{and}ST Q1\n{uses}")
}

#[test]
fn check_and_compile_tell_it_of_instruction_list_too() {
    let text = file("retaining.il", &retaining(700));
    let english = "after a power cut: 2 numbers, at most 4 minutes old\n";
    let portuguese = "após uma queda de energia: 2 números, gravados no máximo 4 minutos antes\n";
    for (lang, told) in [("C", english), ("pt_BR.UTF-8", portuguese)] {
        let (code, out, _) = outcome_in(&["check", &text], lang);
        assert!(code == 0 && out.contains(&format!("\n  {told}")), "{out}");
        let (code, _, err) = outcome_in(&["compile", &text], lang);
        assert_eq!(code, 0, "{err}");
        assert!(err.ends_with(&format!("\n{text}: {told}")), "{err}");
    }
    let text = file("retaining-nothing.il", "LD I1\nST Q1\n");
    assert!(!outcome(&["compile", &text]).2.contains("kept"));
}

#[test]
fn instruction_list_without_room_for_two_records_is_refused_with_what_is_lacking() {
    let text = file("retaining-too-much.il", &retaining(900));
    for (lang, lacking, room) in [
        (
            "C",
            "; 41 more bytes of program memory are needed.",
            "retain fewer numbers: each retained number is stored twice",
        ),
        (
            "pt_BR.UTF-8",
            "; faltam 41 bytes de memória de programa.",
            "retenha menos números: cada número retido é guardado duas vezes",
        ),
    ] {
        for command in ["check", "compile"] {
            let (code, out, err) = outcome_in(&[command, &text], lang);
            let told = out + &err;
            assert_eq!(code, 1, "{told}");
            assert!(told.contains("IL-71") && told.contains(lacking), "{told}");
            assert!(told.contains(room), "{told}");
        }
    }
}
