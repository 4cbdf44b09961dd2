//! No text changes its meaning by an operator that makes it one with types.

use crate::common::{LARGE, Random, large, plc, program};
use unoclp_core::Image;
use unoclp_testing::{held, rounds};

const TYPES: [&str; 6] = ["SINT", "INT", "DINT", "USINT", "UINT", "INT"];
/// Where a text leaves its variables at last.
const FIRST: usize = 40;

/// What may stand beside them: types of Structured Text, and what works on these.
const TYPED: &str = "VAR r : REAL; all : ARRAY[1..3] OF INT; day : DATE; END_VAR\n";
const BESIDE: [&str; 4] = [
    "LD a\nMAX b\nST spare\n",
    "LD r\nADD a\nST r\n",
    "LD b\nST all[2]\nLD all[2]\nST spare\n",
    "LIMIT (MN := a, IN := b + c, MX := d)\nST spare\n",
];

/// Declarations, and lines that compute with variables of one type.
fn text(random: &mut Random) -> (String, String) {
    let ty = random.pick(&TYPES);
    let names = ["a", "b", "c", "d"];
    let declarations = format!("VAR a, b, c : {ty}; d : {ty} := 100; spare : {ty}; END_VAR\n");
    let mut lines = String::new();
    for _ in 0..random.below(12) + 1 {
        lines += &format!("LD {}\n", random.pick(&names));
        for _ in 0..random.below(4) {
            let operator = random.pick(&["ADD", "SUB", "MUL", "DIV", "MOD"]);
            let operand = match random.percent(50) {
                true => random.pick(&names).to_owned(),
                false => (random.below(127) + 1).to_string(),
            };
            lines += &format!("{operator} {operand}\n");
        }
        for _ in 0..random.below(2) + 1 {
            lines += &format!("ST {}\n", random.pick(&names));
        }
    }
    for (name, register) in names.iter().zip(FIRST..) {
        lines += &format!("LD {name}\nST D{register}\n");
    }
    (declarations, lines)
}

fn registers(text: &str) -> Vec<i32> {
    let compiled = program(text, &large());
    let mut memory = vec![0; 8000];
    let mut plc = plc(&compiled.file().unwrap(), &mut memory, LARGE);
    for scan in 0..5 {
        plc.scan(Image(0), scan).unwrap();
    }
    plc.registers()[FIRST - 1..FIRST + 3].to_vec()
}

#[test]
fn no_operator_changes_what_a_text_does() {
    let compare = |seed: u32| {
        let mut random = Random(seed.into());
        let (declarations, lines) = text(&mut random);
        let plain = format!("{declarations}{lines}");
        let beside = random.pick(&BESIDE);
        let typed = format!("{declarations}{TYPED}{beside}{lines}");
        assert_eq!(registers(&plain), registers(&typed), "{typed}");
    };
    (0..rounds(300)).for_each(|seed| held(|| compare(seed)));
}
