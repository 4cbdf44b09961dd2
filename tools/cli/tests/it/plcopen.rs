//! Projects in PLCopen XML on the command line.

use crate::common::{file, outcome, outcome_in};

/// A motor that seals itself in.
const SEAL_IN: [&str; 7] = ["0", "827301", "40", "827901", "41", "-827302", "877901"];

/// The codes that a project becomes.
fn codes(project: &str) -> Vec<String> {
    let (_, codes, _) = outcome(&["compile", project]);
    let first = |line: &str| {
        line.split('/')
            .next()?
            .split_whitespace()
            .next()
            .map(str::to_owned)
    };
    codes.lines().filter_map(first).collect()
}

#[test]
fn a_program_is_listed_as_a_project_and_taken_again_by_every_command() {
    let program = file("to-project.il", "LD start\nOR motor\nANDN stop\nST motor\n");
    let text =
        "VAR start AT %IX0.0 : BOOL; stop AT %IX0.1 : BOOL; motor AT %QX0.0 : BOOL; END_VAR\n";
    let body = std::fs::read_to_string(&program).unwrap();
    let program = file("to-project.il", &format!("{text}{body}"));
    let (code, project, errors) = outcome(&["list", &program, "--as", "xml"]);
    assert_eq!((code, errors.as_str()), (0, ""), "{project}");
    // By its name, and by how it begins.
    for name in ["project.xml", "project.txt"] {
        let project = file(name, &project);
        let (code, out, errors) = outcome(&["check", &project]);
        assert_eq!((code, errors.as_str()), (0, ""), "{out}");
        assert!(out.contains("PLCopen XML"), "{out}");
        let (code, out, _) = outcome(&["list", &project]);
        assert!(code == 0 && out.contains("motor"), "{out}");
        assert_eq!(codes(&project), SEAL_IN);
    }
}

#[test]
fn what_no_ladder_of_a_project_has_is_named_and_becomes_instruction_list() {
    let program = file("no-ladder.txt", "0\n827301\n7370\n877901\n697868\n");
    for (lang, told) in [
        (
            "en",
            "XML-523: rung 1: a PLCopen XML ladder cannot express `IF`",
        ),
        (
            "pt-BR",
            "XML-523: degrau 1: um ladder do PLCopen XML não tem `IF`",
        ),
    ] {
        let (code, out, errors) = outcome_in(&["list", &program, "--as", "xml"], lang);
        assert_eq!(code, 0, "{errors}");
        assert!(errors.contains(told), "{errors}");
        let project = file("in-list.xml", &out);
        let codes = outcome(&["compile", &project]).1;
        let codes: Vec<&str> = codes
            .lines()
            .filter_map(|line| line.split('/').next())
            .collect();
        let codes: Vec<&str> = codes.iter().map(|code| code.trim()).collect();
        let codes = codes.into_iter().filter(|code| !code.is_empty());
        assert_eq!(
            codes.collect::<Vec<_>>(),
            ["0", "827301", "7370", "877901", "697868"]
        );
    }
}

#[test]
fn a_file_that_is_no_project_is_told_at_its_line() {
    let project = file("broken.xml", "<?xml version='1.0'?>\n<project>\n</wrong>\n");
    let (code, out, _) = outcome(&["check", &project]);
    assert_eq!(code, 1);
    assert!(
        out.contains("error[XML-501]") && out.contains("broken.xml:3"),
        "{out}"
    );
}

#[test]
fn the_units_of_a_project_are_listed_in_the_words_of_the_norm() {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../ladder/plcopen/tests/alike/diagrams.xml"
    );
    let (code, out, errors) = outcome(&["units", path]);
    assert_eq!((code, errors.as_str()), (0, ""));
    for line in [
        "FUNCTION_BLOCK Latch (FBD)\n  VAR_INPUT go : BOOL\n",
        "FUNCTION Double : INT (FBD)\n  VAR_INPUT x : INT\n  VAR_INPUT most : INT := 40\n",
        "PROGRAM main (FBD)\n  VAR i0 AT %IX0.0 : BOOL\n",
    ] {
        assert!(out.contains(line), "{line}\n{out}");
    }
    let text = file("no-units.il", "LD I1\nST Q1\n");
    let (code, out, _) = outcome(&["units", &text]);
    assert_eq!(code, 1);
    assert!(out.contains("error[XML-501]"), "{out}");
}

#[test]
fn a_program_is_listed_as_blocks_and_as_a_project_in_fbd() {
    let program = file(
        "to-blocks.txt",
        "0\n827301\n40\n827901\n41\n-827302\n877901\n",
    );
    let (code, drawn, errors) = outcome(&["list", &program, "--as", "fbd"]);
    assert_eq!((code, errors.as_str()), (0, ""), "{drawn}");
    assert!(drawn.contains(">1") && drawn.contains('&'), "{drawn}");
    let (code, project, errors) = outcome(&["list", &program, "--as", "xml-fbd"]);
    assert_eq!((code, errors.as_str()), (0, ""), "{project}");
    assert!(
        project.contains("<FBD>") && !project.contains("<contact"),
        "{project}"
    );
    let project = file("in-blocks.xml", &project);
    assert_eq!(codes(&project), SEAL_IN);
    // What a block diagram has no form for is named, and stands in LD or a list.
    let program = file("no-blocks.txt", "0\n827301\n7370\n877901\n697868\n");
    let (code, project, errors) = outcome(&["list", &program, "--as", "xml-fbd"]);
    assert!(code == 0 && project.contains("<IL>"), "{project}");
    assert!(errors.contains("XML-544: rung 1:"), "{errors}");
}

#[test]
fn a_bad_project_is_told_with_place_reason_and_remedy() {
    let cases = include_str!("../../../../ladder/plcopen/tests/bad.toml");
    let cases: toml::Table = cases.parse().unwrap();
    for case in cases["case"].as_array().unwrap() {
        let of = |of: &toml::Value, name: &str| of[name].as_str().unwrap().to_owned();
        let path = file("bad.xml", &of(case, "text"));
        let words = [
            ("C", "en", "error", "help"),
            ("pt_BR", "pt", "erro", "ajuda"),
        ];
        for (locale, lang, error, help) in words {
            let (code, out, errors) = outcome_in(&["check", &path], locale);
            let said = [
                format!(
                    "{error}[{}]: {}\n",
                    of(case, "code"),
                    of(&case[lang], "message")
                ),
                format!("--> {path}:{}\n", of(case, "at")),
                format!("= {help}: {}\n", of(&case[lang], "help")),
            ];
            assert_eq!(code, 1, "{out}{errors}");
            for said in said {
                assert!(out.contains(&said), "{}\n{said}\n{out}", case["about"]);
            }
        }
    }
}

#[test]
fn a_project_of_100_megabytes_is_refused_in_words() {
    let path = file("large.xml", "<?xml version=\"1.0\"?>\n");
    let large = std::fs::File::options().write(true).open(&path).unwrap();
    // What follows has no place on the disk.
    large.set_len(100 << 20).unwrap();
    for (lang, said) in [
        ("C", "is longer than 1048576 bytes"),
        ("pt_BR", "passa de 1048576 bytes"),
    ] {
        for command in ["check", "units", "list", "compile"] {
            let (code, out, errors) = outcome_in(&[command, &path], lang);
            assert_eq!((code, &*out), (2, ""));
            assert!(errors.contains(&path) && errors.contains(said), "{errors}");
        }
    }
    std::fs::remove_file(path).unwrap();
}

#[test]
fn what_no_ladder_expresses_is_exported_as_it_is_written() {
    let text = "FUNCTION Any : BOOL\nVAR_INPUT x, y : BOOL; END_VAR\nIF x THEN Any := TRUE; ELSE Any := y; END_IF;\nEND_FUNCTION\nPROGRAM main\nVAR a AT %IX1 : BOOL; b AT %IX2 : BOOL; q AT %QX1 : BOOL; r : REAL; END_VAR\nr := r + 0.5;\nq := Any(a, b) AND r > 3.0;\nEND_PROGRAM\n";
    let program = file("own-words.st", text);
    let (code, project, errors) = outcome(&["list", &program, "--as", "xml"]);
    assert_eq!((code, &*errors), (0, ""));
    assert!(
        project.contains("pouType=\"function\"") && !project.contains("<IL>"),
        "{project}"
    );
    let again = file("own-words.xml", &project);
    assert_eq!(codes(&again), codes(&program));
    // And so is a project.
    let (code, same, errors) = outcome(&["list", &again, "--as", "xml"]);
    assert_eq!((code, &*errors), (0, ""));
    assert_eq!(same, project);
}
