//! A program that is read back as Instruction List and compiled again is the same program.

use crate::common::{LARGE, Random, large, program};
use std::fs;
use std::path::Path;
use unoclp_core::Board;
use unoclp_core::isa::{Class, Kind, Opcode, Row, TABLE};
use unoclp_lang::{Options, to_il};
use unoclp_testing::{held, rounds};

/// The codes of a program file, without its comments.
fn codes(file: &str) -> Vec<i32> {
    let codes = file
        .lines()
        .map(|line| line.split('/').next().unwrap_or("").trim());
    codes
        .filter(|code| !code.is_empty())
        .map(|code| code.parse().unwrap())
        .collect()
}

fn holds(file: &str, board: Board) -> String {
    let text = to_il(file.as_bytes(), board).unwrap_or_else(|fault| panic!("{fault}\n{file}"));
    let options = Options {
        dialect: None,
        board,
    };
    assert_eq!(
        program(&text, &options).codes(),
        codes(file),
        "{file}\n{text}"
    );
    text
}

#[test]
fn sample_programs() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../programs");
    let mut count = 0;
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|extension| extension != "txt") {
            continue;
        }
        count += 1;
        let text = holds(&fs::read_to_string(&path).unwrap(), Board::UNO);
        // Most of it can be said in Instruction List; branch points cannot.
        let as_they_are = text.lines().filter(|line| line.starts_with("CODE")).count();
        assert!(
            as_they_are * 2 <= text.lines().count(),
            "{}:\n{text}",
            path.display()
        );
    }
    assert!(count > 8);
}

/// A row of one of these classes.
fn row_of(random: &mut Random, classes: &[Class]) -> Row {
    let class = random.pick(classes);
    let of_class = TABLE.iter().filter(|row| row.class == class);
    let rows: Vec<Row> = of_class.copied().collect();
    random.pick(&rows)
}

/// Of which classes the instructions of a rung are; any where none is named. One that Instruction List has no words
/// for has its whole rung written as codes, so most rungs are short, and as a person writes them.
fn classes(random: &mut Random) -> Vec<&'static [Class]> {
    if random.percent(40) {
        return vec![&[]; random.below(10) + 1];
    }
    let mut classes: Vec<&[Class]> = vec![&[Class::Contact, Class::Load]];
    for _ in 0..random.below(4) {
        classes.push(&[Class::Contact, Class::Xor, Class::Logic]);
    }
    classes.push(&[Class::Coil]);
    classes
}

/// A random program of every instruction, in rungs that the loader accepts.
fn random_program(random: &mut Random) -> String {
    let mut lines = vec!["0".to_owned()];
    let mut labels = Vec::new();
    let (mut timers, rungs) = (0, random.below(12) + 1);
    if random.percent(20) {
        let (register, counter) = (random.below(32) + 1, random.below(16) + 1);
        lines.extend([756800 + register, 756700 + counter].map(|code| code.to_string()));
    }
    for rung in 0..rungs {
        if rung > 0 {
            lines.push("787600".to_owned());
        }
        if random.percent(20) {
            labels.push(rung + 1);
            lines.push((766600 + rung + 1).to_string());
        }
        let mut open = 0;
        let mut stored = false;
        for of in classes(random) {
            let row = match of {
                [] => random.pick(TABLE),
                of => row_of(random, of),
            };
            let xx = match row.kind {
                Kind::Input | Kind::Group | Kind::Filter => random.below(4) + 1,
                Kind::Output | Kind::Branch | Kind::System => random.below(4) + 1,
                Kind::Marker => random.below(64) + 1,
                Kind::TimerQ if timers > 0 => random.below(timers) + 1,
                Kind::Counter | Kind::Count => random.below(16) + 1,
                Kind::Register => random.below(32) + 1,
                // Nothing is pushed here.
                Kind::Value | Kind::Real => random.below(33),
                Kind::Move | Kind::Drum | Kind::Table => random.below(8) + 1,
                Kind::Analogue => random.below(5),
                Kind::Reading => random.below(2) + 1,
                Kind::Bit => random.below(32),
                Kind::Time => random.below(100),
                Kind::Jump if !labels.is_empty() && open == 0 => random.pick(&labels),
                // Jumps need their labels, and a pin is PWM or output.
                Kind::TimerQ | Kind::Label | Kind::Jump | Kind::Pwm => continue,
                Kind::None | Kind::Timer | Kind::Scale => 0,
            };
            match row.stored {
                stored if stored == Opcode::NewRung as u8 => continue,
                stored if stored == Opcode::Return as u8 && open > 0 => continue,
                stored if stored == Opcode::ReturnNot as u8 && open > 0 => continue,
                recall if recall == Opcode::RecallBranch as u8 => continue,
                // They stand at the head.
                keep if keep == Opcode::KeepRegister as u8 => continue,
                keep if keep == Opcode::KeepCounter as u8 => continue,
                // These belong together.
                push if push == Opcode::Push as u8 => continue,
                pop if pop == Opcode::StoreTable as u8 => continue,
                part if part >= Opcode::If as u8 => continue,
                store if store == Opcode::StoreBranch as u8 => {
                    let last: i32 = lines.last().unwrap().parse().unwrap();
                    if [40, 6540, 8840].contains(&last) {
                        continue;
                    }
                    stored = true;
                }
                close if close == Opcode::CloseBranch as u8 => {
                    if open == 0 {
                        continue;
                    }
                    open -= 1;
                }
                opening if Opcode::of_stored(opening).unwrap().opens() => {
                    if open == 8 {
                        continue;
                    }
                    open += 1;
                }
                _ => {}
            }
            lines.push((row.code + row.code.signum() * xx as i32).to_string());
            let mut number = |limit| random.below(limit).to_string();
            match row.kind {
                Kind::Timer => {
                    timers += 1;
                    let preset = number(100_000);
                    let target = if number(2) == "0" { 7901 } else { 7740 };
                    lines.extend([preset, target.to_string()]);
                }
                Kind::Value | Kind::Real if xx == 0 => lines.push(number(100_000)),
                Kind::Table => lines.push("3".to_owned()),
                Kind::Count | Kind::Filter => lines.push(number(60_000)),
                Kind::Move => lines.extend(["6820".to_owned(), "3".to_owned()]),
                Kind::Drum => lines.extend(["2", "1001", "0110"].map(str::to_owned)),
                Kind::Scale => lines.extend(["0", "1023", "-10", "10"].map(str::to_owned)),
                _ => {}
            }
            if stored && open == 0 && random.percent(10) {
                lines.extend(["40", "404101", "827301", "41"].map(str::to_owned));
            }
        }
        for _ in 0..open {
            lines.push("41".to_owned());
        }
    }
    // A text without an instruction is none.
    if lines.len() == 1 {
        lines.push("787600".to_owned());
    }
    lines.join("\n") + "\n"
}

/// Texts that come back as they are.
#[test]
fn what_is_pushed_and_what_is_bracketed_is_said() {
    let texts = [
        "LD    D1\nPUSH\nLD    D2\nADD   3\nSUB   POP\nST    D4\n",
        "LD    D1\nPUSH\nLD    IW0\nTABLE_ST D40, 8\n",
        "LD    D1\nTABLE_LD D40, 8\nREAL_MUL -1.5E-10\nREAL_TO_DINT\nSIGNED 16\nST    D98\n",
        "LD    D1\nPUSH\nLD    D2\nREAL_ADD 1.5\nREAL_DIV POP\nREAL_SUB 0.1\nREAL_ORDER\nGT    0\nST    Q1\n",
        "LD    D1\nUDIV  -1\nUGE   D2\nST    Q1\n",
        "LD    I1\nIF\n\nLD    I2\nST    Q1\n\nELSE\nLD    I4\nIF\n\nLD    I3\nST    Q1\n\nEND_IF\n\nEND_IF\n",
    ];
    for text in texts {
        let compiled = program(text, &Options::on(unoclp_core::Board::UNO));
        let file = compiled.file().unwrap();
        let back = to_il(file.as_bytes(), Board::UNO).unwrap();
        let said: Vec<String> = back
            .lines()
            .map(|line| line.trim_end().to_owned())
            .collect();
        assert_eq!(said, text.lines().collect::<Vec<_>>(), "{file}");
    }
}

#[test]
fn random_programs() {
    let (mut count, mut said, programs) = (0, 0, rounds(2_000));
    for seed in 0.. {
        let came = held(|| {
            let file = random_program(&mut Random(seed));
            // A branch point of another rung may be recalled: such a program is none.
            to_il(file.as_bytes(), LARGE)
                .is_ok()
                .then(|| holds(&file, LARGE))
        });
        let Some(text) = came else { continue };
        said += u32::from(text.lines().any(|line| line.starts_with("LD")));
        count += 1;
        if count == programs {
            break;
        }
    }
    assert!(said > programs / 5, "{said}");
}

/// What the compiler makes of a listing is read back as the listing has it.
#[test]
fn listings_come_back_as_they_were() {
    let text = "LD    I1\nAND   I2\nOR(   I3\nANDN  I4\n)\nST    Q1\n";
    let file = program(text, &large()).file().unwrap();
    assert_eq!(to_il(file.as_bytes(), Board::UNO).unwrap(), text);

    let text = "LD    I1\nTON   T1, 20000\nST    Q1\n\nLDN   T1.Q\nCTU   C2, 20\nST    M1\n\nLD    IW4\nGE    500\nS     Q2\n";
    let file = program(text, &large()).file().unwrap();
    assert_eq!(to_il(file.as_bytes(), Board::UNO).unwrap(), text);
}

/// What follows the last that a rung drives has no effect, and no compiler would write it.
#[test]
fn what_has_no_effect_stands_as_codes_and_nothing_else_of_its_rung() {
    for (file, lines) in [
        (
            "0\n827301\n877901\n827302\n",
            [
                "LD    I1",
                "ST    Q1",
                "CODE 827302               (* RI 02 *)",
            ],
        ),
        (
            "0\n827301\n847978\n50\n7901\n-827301\n",
            [
                "TON   T1, 50",
                "ST    Q1",
                "CODE -827301              (* RIN 01 *)",
            ],
        ),
    ] {
        let text = holds(file, Board::UNO);
        for line in lines {
            let has = text
                .lines()
                .any(|own| own.split("(*").next() == line.split("(*").next());
            assert!(has, "{line}\n{text}");
        }
    }
}
