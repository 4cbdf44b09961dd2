//! Listings: those of the samples as they shall be, and what holds for those of all programs.

use crate::common::{file, outcome, outcome_in};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use unoclp_core::isa::{Kind, Opcode};
use unoclp_draw::{Ladder, Medium, NARROWEST, Names, Style};
use unoclp_host_sim::random::{Random, random_program};
use unoclp_program::list::{Form, svg};
use unoclp_program::{Lang, Source, Written, load};
use unoclp_testing::held;

/// What every program can be listed as.
fn list(source: &Source, form: Form, width: usize, lang: Lang) -> String {
    unoclp_program::list::list(source, form, width, lang).unwrap()
}

fn folder(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

fn numeric(file: impl Into<Vec<u8>>) -> Source {
    let written = Written::new("p.txt".to_owned(), file.into(), unoclp_core::Board::UNO);
    assert!(!written.is_text());
    written
        .check(None)
        .unwrap_or_else(|refused| panic!("{refused:?}"))
}

/// The stored form of a program file.
fn stored(file: &[u8]) -> Vec<u8> {
    load(file, unoclp_core::Board::UNO)
        .unwrap()
        .program()
        .stored()
        .to_vec()
}

#[test]
fn samples_are_listed_as_they_shall_be() {
    let mut names = BTreeSet::new();
    for entry in fs::read_dir(folder("../../programs")).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap().to_owned();
        if path.extension().is_none_or(|extension| extension != "txt") {
            continue;
        }
        let listing = list(
            &numeric(fs::read(&path).unwrap()),
            Form::Ladder,
            80,
            Lang::En,
        );
        let expected = folder("tests/listings").join(&name);
        let expected = fs::read_to_string(&expected).unwrap_or_default();
        assert_eq!(
            listing, expected,
            "if this is right: cargo run -- list programs/{name} > tools/cli/tests/listings/{name}\n{listing}"
        );
        names.insert(name);
    }
    for entry in fs::read_dir(folder("tests/listings")).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        assert!(names.contains(&name), "{name} is a listing of nothing");
    }
}

/// The lines of an instruction of this opcode, with operands that a program may have.
fn codes(opcode: Opcode) -> String {
    let row = opcode.row();
    let xx = match row.kind {
        Kind::None | Kind::Timer | Kind::Scale | Kind::Value | Kind::Real => 0,
        Kind::Analogue => 4,
        _ => 1,
    };
    let code = row.code + row.code.signum() * xx;
    let lines = match row.kind {
        Kind::Timer => "\n5000\n7702",
        Kind::Table => "\n8",
        Kind::Count | Kind::Value | Kind::Real => "\n1234",
        Kind::Move => "\n6808\n4",
        Kind::Drum => "\n3\n1000\n0100\n0010",
        Kind::Scale => "\n-32768\n32767\n-32767\n32766",
        Kind::Filter => "\n30000",
        _ => "",
    };
    format!("{code}{lines}\n")
}

#[test]
fn every_instruction_is_listed() {
    for &opcode in Opcode::ALL {
        let step = codes(opcode);
        let (program, shown) = match opcode {
            Opcode::OpenBranch | Opcode::CloseBranch => {
                ("0\n827301\n40\n827302\n41\n".to_owned(), "┘")
            }
            Opcode::OpenAnd => (format!("0\n827301\n{step}827302\n41\n"), "┤ I1 ├──┤ I2 ├"),
            Opcode::OpenXor => (format!("0\n827301\n{step}827302\n41\n"), "[ XOR ]"),
            Opcode::RecallBranch => (
                "0\n827301\n404101\n827302\n40\n404101\n41\n".to_owned(),
                "┬",
            ),
            // What is pushed is taken, and an IF has its END.
            Opcode::Push => (format!("0\n{step}65686899\n"), "[ PUSH ]"),
            Opcode::StoreTable => (format!("0\n808372\n{step}"), "[ ST TABLE D1-8 ]"),
            Opcode::If => (format!("0\n827301\n{step}697868\n"), "[ IF ]"),
            Opcode::Else => (format!("0\n7370\n{step}877901\n697868\n"), "ELSE:"),
            Opcode::EndIf => (format!("0\n7370\n{step}"), "END_IF:"),
            // A jump needs its label, a contact of a timer its timer.
            Opcode::Jump | Opcode::JumpNot => (format!("0\n766601\n{step}"), ">> L1"),
            Opcode::Label => (format!("0\n{step}"), "L1:"),
            Opcode::NewRung => (format!("0\n827301\n{step}"), "Rung 2"),
            _ if opcode.row().kind == Kind::TimerQ => {
                (format!("0\n{step}787600\n847978\n1\n7901\n"), "T1")
            }
            _ => (format!("0\n{step}"), ""),
        };
        let ladder = list(&numeric(program.as_bytes()), Form::Ladder, 80, Lang::En);
        assert!(ladder.contains(shown), "{opcode:?}:\n{ladder}");
        let first = ladder.lines().find(|line| line.starts_with('├')).unwrap();
        let alone = matches!(opcode, Opcode::Label);
        assert!(
            alone || !first.trim_matches(['├', '─', '│', ' ']).is_empty(),
            "{opcode:?}:\n{ladder}"
        );
        let letters = opcode.row().letters;
        let numeric = list(&numeric(program.as_bytes()), Form::Numeric, 80, Lang::En);
        assert!(
            numeric.contains(&format!("/ {letters}")),
            "{opcode:?}:\n{numeric}"
        );
        assert!(!numeric.contains("XX"), "{opcode:?}:\n{numeric}");
    }
}

#[test]
fn random_programs_keep_every_step_once_at_every_width() {
    let run = |seed: u64| {
        let random = &mut Random::new(seed);
        let file = random_program(random);
        let checked = load(file.as_bytes(), unoclp_core::Board::UNO).unwrap();
        let program = checked.program();
        let ladder = Ladder::new(program.steps());
        let mut shown: Vec<usize> = Vec::new();
        for rung in &ladder.rungs {
            shown.extend(ladder.shown(rung));
        }
        shown.sort_unstable();
        let all: Vec<usize> = (0..program.steps().count()).collect();
        assert_eq!(shown, all, "{file}");

        let width = NARROWEST + random.below(200) as usize;
        let style = Style {
            width,
            names: &Names::new(),
            medium: Medium::PLAIN,
        };
        let drawing = ladder.draw(&style);
        let mut symbols = Vec::new();
        for picture in &drawing.rungs {
            for row in &picture.rows {
                assert!(
                    row.len() == drawing.width && row.len() <= width,
                    "{picture}"
                );
                let elements = row.chunk_by(|one, other| one.element == other.element);
                symbols.extend(elements.filter_map(|cells| cells[0].element));
            }
        }
        symbols.sort_unstable();
        // Each symbol is drawn once; each that shows steps, at all.
        assert!(symbols.windows(2).all(|pair| pair[0] != pair[1]), "{file}");
        for (index, element) in ladder.elements.iter().enumerate() {
            let drawn = symbols.binary_search(&index).is_ok();
            assert!(drawn || element.steps.is_empty(), "{element:?}\n{file}");
        }

        let listing = list(&numeric(file.as_bytes()), Form::Ladder, width, Lang::En);
        let widest = listing.lines().map(|line| line.chars().count()).max();
        assert!(widest <= Some(width), "{listing}");
        let listed = list(&numeric(file.as_bytes()), Form::Numeric, width, Lang::En);
        assert_eq!(plain(&listed), plain(&file), "seed {seed}");
        assert!(svg(&numeric(file.as_bytes()), width, Lang::En).starts_with("<svg"));
    };
    (0..400).for_each(|seed| held(|| run(seed)));
}

/// A program's stored form, without the lines that its jumps remember.
fn plain(file: &str) -> Vec<String> {
    let checked = load(file.as_bytes(), unoclp_core::Board::UNO).unwrap();
    let program = checked.program();
    program.steps().map(|step| step.to_string()).collect()
}

#[test]
fn a_numeric_listing_is_the_same_program() {
    for name in ["motor", "twohand", "figure6"] {
        let file = fs::read(folder("../../programs").join(name).with_extension("txt")).unwrap();
        let listing = list(&numeric(&*file), Form::Numeric, 80, Lang::En);
        assert_eq!(stored(listing.as_bytes()), stored(&file), "{listing}");
        // A listing of a listing is the same once more.
        assert_eq!(
            list(&numeric(listing.as_bytes()), Form::Numeric, 80, Lang::En),
            listing
        );
    }
    let expected = "\
/ Motor

0        /         program start

/ Forward
827301   / RI 01   contact, normally open: acc := acc AND input 01
847978   / TON     on-delay timer: IN = acc; acc := Q; output := Q
500      /         preset: 500 ms
7901     /         drives O 01

787600   / NL      new rung: acc := 1; the branch points of the previous rung are cleared
-827902  / -RO 02  contact: acc := acc AND NOT output 02, as it is now in the image
716900   / GE 00   comparison: acc := acc AND (value >= -5)
-5       /         the constant
";
    let file =
        "/ Motor\n\n 0\n/ Forward\n827301\n847978 / TON\n500\n7901\n787600\n-827902\n716900\n-5";
    assert_eq!(
        list(&numeric(file.as_bytes()), Form::Numeric, 80, Lang::En),
        expected
    );
}

#[test]
fn a_listing_is_told_in_portuguese_and_means_the_same() {
    for &opcode in Opcode::ALL {
        let program = format!("0\n827301\n40\n827302\n41\n{}", codes(opcode));
        // Some codes stand at the head of a rung only, or beside others.
        let Ok(source) = Written::new(
            "p.txt".to_owned(),
            program.into_bytes(),
            unoclp_core::Board::UNO,
        )
        .check(None) else {
            continue;
        };
        let listed = |lang| list(&source, Form::Numeric, 80, lang);
        let (english, portuguese) = (listed(Lang::En), listed(Lang::Pt));
        assert_eq!(stored(portuguese.as_bytes()), stored(english.as_bytes()));
        assert!(portuguese.contains("início do programa"), "{portuguese}");
        for word in [
            "input", "output", "value", "register", "marker", " the ", "operand ",
        ] {
            assert!(!portuguese.contains(word), "{word} in\n{portuguese}");
        }
    }
    let program = numeric("/ Lâmpada\n0\n827301\n877901\n787600\n827302\n877902\n");
    let ladder = list(&program, Form::Ladder, 80, Lang::Pt);
    assert!(ladder.contains("\nDegrau 1, linhas 3 a 4\n"), "{ladder}");
    assert!(
        svg(&program, 80, Lang::Pt).contains(">Degrau 2, linhas 5 a 7<"),
        "{ladder}"
    );
}

#[test]
fn a_drawing_in_ascii_leaves_nothing_out() {
    for name in ["motor", "stardelta", "twohand", "figure6"] {
        let file = folder("../../programs").join(name).with_extension("txt");
        let listed = |lang| outcome_in(&["list", file.to_str().unwrap(), "--width", "56"], lang).1;
        let (drawn, plain) = (listed("C.UTF-8"), listed("C"));
        assert!(plain.is_ascii() && !plain.contains("-?"), "{plain}");
        let widths =
            |text: &str| -> Vec<usize> { text.lines().map(|line| line.chars().count()).collect() };
        assert_eq!(widths(&plain), widths(&drawn));
        let unknown = |text: &str| text.matches('?').count();
        assert_eq!(unknown(&plain), unknown(&drawn), "{plain}");
    }
}

#[test]
fn a_chart_is_listed_and_drawn_in_both_looks() {
    let program = folder("../../programs/charts/filling.st");
    let program = program.to_str().unwrap();
    let (code, norm, errors) = outcome(&["list", program, "--as", "sfc"]);
    assert_eq!((code, errors.as_str()), (0, ""));
    for part in ["Wait", "Settle.T >= T#500ms", "L T#2s", "ready"] {
        assert!(norm.contains(part), "{part}: {norm}");
    }
    let (_, grafcet, _) = outcome(&["list", program, "--as", "grafcet"]);
    assert!(grafcet.contains("500ms/XSettle"), "{grafcet}");
    let svg = file("chart.svg", "");
    let drawn = outcome(&["list", program, "--as", "sfc", "--svg", &svg, "--force"]);
    assert_eq!(drawn.0, 0, "{drawn:?}");
    let drawn = fs::read_to_string(&svg).unwrap();
    assert_eq!(drawn.matches("data-id=\"s").count(), 5, "{drawn}");
    // The ladder that it becomes stays what is listed where nobody asks for the chart.
    assert!(outcome(&["list", program]).1.contains("Fill.X"));
    for arguments in [
        &["--as", "sfc"][..],
        &["--as", "grafcet", "--svg", &svg, "--force"],
    ] {
        let all = [&["list", "../../programs/and.txt"], arguments].concat();
        let (code, _, errors) = outcome(&all);
        assert!(
            code != 0 && errors.contains("the program has no chart"),
            "{errors}"
        );
    }
}

/// A project with a chart is listed as one, and what is exported is the chart again.
#[test]
fn a_chart_of_a_project_is_listed_too() {
    let program = folder("../../programs/charts/cylinders.st");
    let program = program.to_str().unwrap();
    let (_, project, errors) = outcome(&["list", program, "--as", "xml"]);
    assert_eq!(errors, "");
    let project = file("chart.xml", &project);
    let charts = [program, &project].map(|file| outcome(&["list", file, "--as", "sfc"]));
    assert_eq!(charts[0], charts[1]);
    let codes = [program, &project].map(|file| {
        let out = outcome(&["compile", file]).1;
        let lines = out.lines().filter_map(|line| line.split('/').next());
        lines.map(|line| line.trim().to_owned()).collect::<Vec<_>>()
    });
    assert_eq!(codes[0], codes[1]);
}
