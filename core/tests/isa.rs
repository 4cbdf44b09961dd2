//! The instruction table: what is stored is pinned, what is listed comes back.

use unoclp_core::isa::TABLE;
use unoclp_core::{Instruction, Loader, Plc, Profile};

/// Every instruction in one valid program, in an order that the loader accepts.
const EVERY: &[i32] = &[
    0, 787600, 827301, -827302, 404103, 40, 404103, 827903, -827904, 41, 877901, 83877902,
    82877903, 787600, 847978, 1000, 7904, 787600, 847970, 0x01020304, 7901,
];

/// The stored bytes of that program. They are what a later version may find in a board's memory:
/// a change here is a change of format.
const STORED: &[u8] = &[
    0x01, 0x10, 0x21, 0x82, 0x02, 0x92, 0x32, 0x43, 0x03, 0x50, 0x61, 0x72, 0x01, //
    0x04, 0xE8, 0x03, 0x00, 0x00, 0x03, 0x01, //
    0x05, 0x04, 0x03, 0x02, 0x01, 0x00,
];

fn text(codes: &[i32]) -> String {
    codes.iter().map(|code| format!("{code}\n")).collect()
}

fn load<'m>(memory: &'m mut [u8], text: &str) -> unoclp_core::Program<'m> {
    let mut loader = Loader::new(memory, Profile::UNO);
    for byte in text.bytes() {
        loader.push(byte).unwrap();
    }
    loader.finish().unwrap()
}

#[test]
fn stored_bytes_are_pinned() {
    let mut memory = [0; 100];
    let size = load(&mut memory, &text(EVERY)).stored_bytes();
    assert_eq!(&memory[..size], STORED);
}

#[test]
fn opcode_bytes_are_pinned() {
    let stored: Vec<(i32, &str, u8)> = TABLE
        .iter()
        .map(|row| (row.code, row.letters, row.stored))
        .collect();
    assert_eq!(
        stored,
        [
            (787600, "NL", 0x01),
            (40, "(", 0x02),
            (41, ")", 0x03),
            (847978, "TON", 0x04),
            (847970, "TOF", 0x05),
            (827300, "RI", 0x10),
            (-827300, "-RI", 0x20),
            (827900, "RO", 0x30),
            (-827900, "-RO", 0x40),
            (877900, "WO", 0x50),
            (83877900, "SWO", 0x60),
            (82877900, "RWO", 0x70),
            (404100, "()", 0x80),
            (404100, "()", 0x90),
        ]
    );
}

#[test]
fn a_listing_loads_as_the_same_program() {
    let mut memory = [0; 100];
    let program = load(&mut memory, &text(EVERY));
    let mut codes = vec![0];
    codes.extend(program.steps().flat_map(Instruction::codes));
    assert_eq!(codes, EVERY);
}

#[test]
fn letters_spell_the_code() {
    for row in TABLE {
        let digits = row.code.unsigned_abs().to_string();
        let pairs = if row.operand.is_point() || row.letters == "NL" {
            &digits[..digits.len() - 2]
        } else {
            &digits[..]
        };
        let mut letters: String = if row.code < 0 { "-" } else { "" }.into();
        for pair in pairs.as_bytes().chunks(2) {
            let ascii: u8 = std::str::from_utf8(pair).unwrap().parse().unwrap();
            letters.push(ascii.into());
        }
        assert_eq!(letters, row.letters);
    }
}

#[test]
fn display_gives_letters_and_operands() {
    let mut memory = [0; 100];
    let program = load(&mut memory, &text(EVERY));
    let shown: Vec<String> = program.steps().map(|step| step.to_string()).collect();
    assert_eq!(
        shown,
        [
            "NL",
            "RI 01",
            "-RI 02",
            "() 03",
            "(",
            "() 03",
            "RO 03",
            "-RO 04",
            ")",
            "WO 01",
            "SWO 02",
            "RWO 03",
            "NL",
            "TON 1000 ms O 04",
            "NL",
            "TOF 16909060 ms O 01",
        ]
    );
}

#[test]
fn run_memory_left_by_another_program_starts_no_timer() {
    let mut memory = [0xFF; 100];
    let program = load(&mut memory, "0\n827301\n847970\n1000\n7901\n");
    let mut plc = Plc::new(program);
    assert_eq!(plc.scan(Default::default(), 0).0, 0);
}
