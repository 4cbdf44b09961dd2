//! `--board pc`: points that no board has, on this PC and nowhere else.

use crate::common::{empty_folder, file, outcome, outcome_in};

const IL: &str = "LD I99\nAND I17\nST Q65\nLD M99\nST Q1\n";

/// What the UNO lacks is told with its name, and with the board that has it.
#[test]
fn a_point_beyond_the_uno_names_the_board_that_has_it() {
    let program = file("wide.txt", "0\n827399\n877901\n");
    let (code, out, _) = outcome(&["check", &program]);
    assert_eq!(code, 1);
    let help = "the UNO has inputs 01 to 08; the PC has 01 to 99";
    assert!(out.contains(help), "{out}");
    let (_, out, _) = outcome_in(&["check", &program], "pt_BR.UTF-8");
    let help = "o UNO tem as entradas 01 a 08; a placa PC tem 01 a 99";
    assert!(out.contains(help), "{out}");
    let (code, out, _) = outcome(&["check", "--board", "pc", &program]);
    assert_eq!(code, 0, "{out}");
    assert!(out.contains("of 32768 bytes"), "{out}");
}

#[test]
fn each_language_names_the_points_of_a_pc() {
    let texts = [
        ("wide.il", IL),
        (
            "wide.st",
            "PROGRAM p\nVAR a AT %IX12.2 : BOOL; b AT %QX12.2 : BOOL; n AT %IW98 : INT; END_VAR\nb := a AND n > 5;\n\
             END_PROGRAM\n",
        ),
        ("wide.lce", "se (I12.2) { aciona Q12.2; }\n"),
    ];
    for (name, text) in texts {
        let program = file(name, text);
        let (code, out, err) = outcome(&["check", &program]);
        assert_eq!(code, 1, "{name}: {out}{err}");
        for command in ["check", "list", "compile", "run"] {
            let (code, out, err) = outcome(&[command, "--board", "pc", &program]);
            assert_eq!(code, 0, "{command} {name}: {out}{err}");
        }
    }
}

/// As Beremiz numbers the points of what hangs on a bus.
#[test]
fn points_within_points_have_places_of_their_own() {
    let text = "PROGRAM p\nVAR a AT %ID0.0.0 : REAL; b AT %ID0.0.1 : REAL; c AT %QX3.1.7 : BOOL; END_VAR\n\
                c := a + 1.5 > b;\nEND_PROGRAM\n";
    let program = file("within.st", text);
    let (code, out, err) = outcome(&["check", "--board", "pc", &program]);
    assert_eq!(code, 0, "{out}{err}");
    assert!(out.contains("2 registers"), "{out}");
    let (code, out, _) = outcome(&["check", &program]);
    assert_eq!(code, 1, "{out}");
}

#[test]
fn a_scenario_sets_and_expects_points_of_a_pc() {
    let program = file("wide-sim.il", IL);
    let scenario = file(
        "wide.toml",
        "about = \"far points\"\nuntil = 20\n\
         [[step]]\nat = 0\nset = { I99 = 1, I17 = 1, M99 = 1 }\nexpect = { Q65 = 1, Q1 = 1 }\n\
         [[step]]\nat = 10\nset = { I17 = 0 }\nexpect = { Q65 = 0 }\n",
    );
    let run = |board: &[&str]| {
        let arguments = ["sim", "--scenario", &scenario, &program];
        outcome(&[&arguments, board].concat())
    };
    let (code, out, err) = run(&["--board", "pc"]);
    assert_eq!(code, 0, "{out}{err}");
    let (code, out, err) = run(&[]);
    assert_ne!(code, 0, "{out}{err}");
    let grade = ["grade", "--board", "pc", &scenario, &program];
    let (code, out, err) = outcome(&grade);
    assert_eq!(code, 0, "{out}{err}");
}

/// A project names the points of a PC by bytes of eight, and comes back as the same codes.
#[test]
fn a_project_carries_points_of_a_pc() {
    let program = file(
        "wide-out.il",
        "LD I99\nAND I9\nST Q65\nLD I1\nTON T1, 20\nST Q99\n",
    );
    let (code, xml, err) = outcome(&["list", "--board", "pc", "--as", "xml", &program]);
    assert_eq!(code, 0, "{err}");
    for address in ["%IX12.2", "%IX1.0", "%QX8.0", "%QX12.2", "%IX0.0"] {
        assert!(
            xml.contains(&format!("address=\"{address}\"")),
            "{address}: {xml}"
        );
    }
    let project = file("wide-out.xml", &xml);
    let codes = |file: &str| {
        let (code, out, err) = outcome(&["list", "--board", "pc", "--as", "il", file]);
        assert_eq!(code, 0, "{out}{err}");
        let lines = out.lines().skip_while(|line| !line.starts_with("LD"));
        lines.map(str::to_owned).collect::<Vec<_>>()
    };
    assert_eq!(codes(&project), codes(&program));
    let (code, out, err) = outcome(&["check", &project]);
    assert_eq!(code, 1, "{out}{err}");
    assert!(
        out.contains("input 99") && out.contains("the PC has this one"),
        "{out}"
    );
}

/// A card is for a board: what it lacks is told before anything is written.
#[test]
fn a_program_for_a_pc_goes_on_no_card_and_no_board() {
    let program = file("wide-card.il", IL);
    let folder = empty_folder("wide-card");
    let target = folder.display().to_string();
    let (code, out, err) = outcome(&["card", "--board", "pc", &target, &program]);
    assert_ne!(code, 0, "{out}{err}");
    let lacks = "the UNO lacks inputs 17, 99; outputs 65; markers 99";
    assert!(err.contains(lacks), "{out}{err}");
    assert_eq!(folder.read_dir().unwrap().count(), 0);
    let upload = ["upload", "--board", "pc", "--port", "/dev/null", &program];
    let (code, out, err) = outcome(&upload);
    assert_ne!(code, 0);
    assert!(err.contains(lacks), "{out}{err}");
}
