//! The instruction table: what is stored is pinned, what is listed comes back.

use std::collections::BTreeSet;
use unoclp_core::isa::{Class, Kind, Line, Opcode, TABLE};
use unoclp_core::{Board, Delay, Image, Instruction, Loader, Plc};

/// Every instruction in one valid program, in an order that the loader accepts.
const EVERY: &[i32] = &[
    0, 787600, 766632, 847978, 16909060, 7902, 847970, 500, 7712, 787984, 6985, 6968, 826984,
    -826984, 786971, 838182, 8480, 500, 7712, 827301, -827301, 827902, -827902, 877902, 83877902,
    82877902, 847982, 500, 7712, -877902, 827764, -827764, 828304, -828304, 828402, -828402,
    826716, -826716, 829016, -829016, 887301, -887301, 887902, -887902, 887764, -887764, 877764,
    -877764, 83877764, 82877764, 82878402, 82876716, 83876716, 67848516, 70000, 67846816, 70000,
    766832, 766800, -2, 76688402, 76686716, 76688302, 76687708, 76687300, 76687900, 76686600,
    838432, 83846716, 83847708, 83847900, 80866716, 80868402, 65686832, 65686800, -2, 83856632,
    83856600, -2, 77857632, 77857600, -2, 68738632, 68738600, -2, 77796832, 77796800, -2, 65786832,
    65786800, -2, 798232, 798200, -2, 88798232, 88798200, -2, 83727631, 83728231, 718432, 718400,
    -2, 716932, 716900, -2, 698132, 698100, -2, 786932, 786900, -2, 766932, 766900, -2, 768432,
    768400, -2, 66738431, -66738431, 77798631, 6801, 2, 68827701, 2, 1000, 11, 836776, -1, 1023,
    -300, 32767, 70768408, 30000, 73788432, 707320, 74778032, -74778032, 787600, 404103, 40,
    404103, 6540, 404103, 8840, 404103, 41, 41, 41, 83848004, 76686504,
];

/// The stored bytes of that program, as versions before 0.2.0 stored it: each constant in 4 bytes. They are what a later
/// version may find in a board's memory: a change here is a change of format.
#[rustfmt::skip]
const STORED: &[u8] = &[
    0x01, 0xE3, 0x20, 0x04, 0x04, 0x03, 0x02, 0x01, 0x01, 0x05, 0xF4, 0x01, 0x00, 0x00, 0x4B, 0x06,
    0x07, 0x08, 0x0B, 0x0C, 0x0D, 0x0E, 0x0F, 0xF4, 0x01, 0x00, 0x00, 0x4B, 0x10, 0x20, 0x31, 0x41,
    0x51, 0x61, 0x71, 0xA0, 0xF4, 0x01, 0x00, 0x00, 0x4B, 0xA1, 0x02, 0xA2, 0x40, 0xA3, 0x40,
    0xA4, 0x04, 0xA5, 0x04, 0xA6, 0x02, 0xA7, 0x02, 0xA8, 0x10, 0xA9, 0x10, 0xAA, 0x10, 0xAB, 0x10,
    0xAC, 0x01, 0xAD, 0x01, 0xAE, 0x02, 0xAF, 0x02, 0xB0, 0x40, 0xB1, 0x40, 0xB2, 0x40, 0xB3, 0x40,
    0xB4, 0x40, 0xB5, 0x40, 0xB6, 0x02, 0xB7, 0x10, 0xB8, 0x10, 0xB9, 0x10, 0x70, 0x11, 0x01, 0x00,
    0xBA, 0x10, 0x70, 0x11, 0x01, 0x00, 0xBB, 0x20, 0xBB, 0x64, 0xFE, 0xBD, 0x02,
    0xBE, 0x10, 0xBF, 0x02, 0xC0, 0x08, 0xC1, 0xC2, 0xC3, 0xC4, 0x20, 0xC5, 0x10, 0xC7, 0x08, 0xC8,
    0xC9, 0x10, 0xCA, 0x02, 0xCB, 0x20, 0xCB, 0x64, 0xFE, 0xCC, 0x20,
    0xCC, 0x64, 0xFE, 0xCD, 0x20, 0xCD, 0x64, 0xFE, 0xCE, 0x20,
    0xCE, 0x64, 0xFE, 0xCF, 0x20, 0xCF, 0x64, 0xFE, 0xD0, 0x20,
    0xD0, 0x64, 0xFE, 0xD1, 0x20, 0xD1, 0x64, 0xFE, 0xD2, 0x20,
    0xD2, 0x64, 0xFE, 0xD3, 0x1F, 0xD4, 0x1F, 0xD5, 0x20,
    0xD5, 0x64, 0xFE, 0xD6, 0x20, 0xD6, 0x64, 0xFE, 0xD7, 0x20,
    0xD7, 0x64, 0xFE, 0xD8, 0x20, 0xD8, 0x64, 0xFE, 0xD9, 0x20,
    0xD9, 0x64, 0xFE, 0xDA, 0x20, 0xDA, 0x64, 0xFE, 0xDB, 0x1F,
    0xDC, 0x1F, 0xDD, 0x1F, 0x01, 0x02, 0xDE, 0x01, 0x02, 0x01, 0x0C,
    0xDF, 0xFF, 0xFF, 0xFF, 0x03, 0xD4, 0xFE, 0xFF, 0x7F, 0xE0, 0x08, 0x30, 0x75, 0xE1, 0x20,
    0xE2, 0x14, 0xE4, 0x20, 0x88, 0x00, 0xE5, 0x20, 0x89, 0x00, 0x01, 0x82, 0x02, 0x92, 0x09, 0x92,
    0x0A, 0x92, 0x03, 0x03, 0x03, 0xC6, 0x04, 0xBC, 0x04,
];

fn text(codes: &[i32]) -> String {
    codes.iter().map(|code| format!("{code}\n")).collect()
}

fn load<'m>(memory: &'m mut [u8], text: &str) -> unoclp_core::Program<'m> {
    let mut loader = Loader::new(memory, Board::UNO);
    for byte in text.bytes() {
        loader.push(byte).unwrap();
    }
    loader.finish().unwrap()
}

#[test]
fn stored_bytes_are_pinned() {
    // -2 takes one byte now, and is told so in place of the 0.
    const LONG: [u8; 5] = [0x00, 0xFE, 0xFF, 0xFF, 0xFF];
    let mut expected = Vec::new();
    let mut rest = STORED;
    while let Some((&byte, behind)) = rest.split_first() {
        if let Some(behind) = rest.strip_prefix(&LONG) {
            expected.extend([0x64, 0xFE]);
            rest = behind;
        } else {
            expected.push(byte);
            rest = behind;
        }
    }
    let mut memory = [0; 1900];
    assert_eq!(load(&mut memory, &text(EVERY)).stored(), expected);
}

/// ARCHITECTURE.md says so to whoever adds an instruction. A row from 0x10 to 0x9F takes sixteen bytes, one for each point.
#[test]
fn no_stored_byte_is_left_for_another_instruction() {
    let taken = TABLE.iter().flat_map(|row| match row.stored {
        first @ 0x10..0xA0 => first..=first + 15,
        only => only..=only,
    });
    let taken: Vec<u8> = taken.collect();
    assert_eq!(taken, (1..=u8::MAX).collect::<Vec<_>>());
}

#[test]
fn what_older_versions_stored_means_the_same() {
    let (mut first, mut second) = ([0; 1900], [0; 1900]);
    let mut loader = Loader::new(&mut first, Board::UNO);
    loader.restore(&mut STORED.iter().copied()).unwrap();
    let restored = loader.finish().unwrap();
    assert_eq!(restored.stored(), STORED);
    let program = load(&mut second, &text(EVERY));
    assert!(restored.steps().eq(program.steps()));
}

#[test]
fn a_constant_takes_the_bytes_that_it_needs() {
    for (number, bytes) in [
        (0, 3),
        (127, 3),
        (-128, 3),
        (128, 4),
        (-129, 4),
        (32_767, 4),
        (-32_768, 4),
        (32_768, 6),
        (-32_769, 6),
        (i32::MAX, 6),
        (i32::MIN, 6),
    ] {
        let mut memory = [0; 100];
        let program = load(&mut memory, &text(&[0, 65686800, number]));
        assert_eq!(program.stored_bytes(), bytes, "{number}");
        // Where it is from, its bytes, and the addition.
        assert_eq!(program.linked_bytes(), bytes, "{number}");
        assert!(
            program
                .steps()
                .flat_map(|step| step.codes())
                .eq([65686800, number])
        );
    }
}

/// What version 3 has added (NC-22 to NC-28), with constants in each of their sizes.
#[test]
fn stored_bytes_of_version_3_are_pinned() {
    #[rustfmt::skip]
    let cases: &[(&[i32], &[u8])] = &[
        (&[766800, 127], &[0xBB, 0x64, 0x7F]),
        (&[766800, -128], &[0xBB, 0x64, 0x80]),
        (&[766800, 128], &[0xBB, 0x65, 0x80, 0x00]),
        (&[766800, -129], &[0xBB, 0x65, 0x7F, 0xFF]),
        (&[766800, -32768], &[0xBB, 0x65, 0x00, 0x80]),
        (&[766800, 32768], &[0xBB, 0x00, 0x00, 0x80, 0x00, 0x00]),
        (&[766800, -32769], &[0xBB, 0x00, 0xFF, 0x7F, 0xFF, 0xFF]),
        (&[766898], &[0xBB, 0x62]),
        (&[808372, 65686899], &[0xE8, 0xCB, 0x63]),
        (&[82656800, 0], &[0xE9, 0x64, 0x00]),
        (&[82656800, 1_065_353_216], &[0xE9, 0x00, 0x00, 0x00, 0x80, 0x3F]),
        (&[82838501, 82778502, 82687303], &[0xEA, 0x01, 0xEB, 0x02, 0xEC, 0x03]),
        (&[738482, 858482, 827868, 848267], &[0xED, 0xEE, 0xEF, 0xF0]),
        (&[827871, 826566, 828284, 677782], &[0xF1, 0xF2, 0xF3, 0xF4]),
        (&[76688805, 28], &[0xF5, 0x05, 0x1C]),
        (&[808372, 83848805, 28], &[0xE8, 0xF6, 0x05, 0x1C]),
        (&[83888408, 90888431], &[0xF7, 0x08, 0xF8, 0x1F]),
        (&[85688601, 85777901, 85716901, 85768401], &[0xF9, 1, 0xFA, 1, 0xFB, 1, 0xFC, 1]),
        (&[7370, 697683, 697868], &[0xFD, 0xFE, 0xFF]),
    ];
    for (codes, stored) in cases {
        let mut memory = [0; 600];
        let program = load(&mut memory, &format!("0\n{}", text(codes)));
        assert_eq!(program.stored(), *stored, "{codes:?}");
        let listed: Vec<i32> = program.steps().flat_map(Instruction::codes).collect();
        assert_eq!(&listed, codes);
    }
}

/// Those of the first version. What has come later is pinned by the table in `docs/numeric-code.md`.
#[test]
fn opcode_bytes_are_pinned() {
    let stored: Vec<(i32, &str, u8)> = TABLE
        .iter()
        .map(|row| (row.code, row.letters, row.stored))
        .collect();
    let (first, _) = stored.split_at(94);
    assert_eq!(
        first,
        [
            (787600, "NL", 0x01),
            (40, "(", 0x02),
            (41, ")", 0x03),
            (847978, "TON", 0x04),
            (847970, "TOF", 0x05),
            (787984, "NOT", 0x06),
            (6985, "EU", 0x07),
            (6968, "ED", 0x08),
            (6540, "A(", 0x09),
            (8840, "X(", 0x0A),
            (826984, "RET", 0x0B),
            (-826984, "-RET", 0x0C),
            (786971, "NEG", 0x0D),
            (838182, "SQR", 0x0E),
            (8480, "TP", 0x0F),
            (827300, "RI", 0x10),
            (-827300, "-RI", 0x20),
            (827900, "RO", 0x30),
            (-827900, "-RO", 0x40),
            (877900, "WO", 0x50),
            (83877900, "SWO", 0x60),
            (82877900, "RWO", 0x70),
            (404100, "()", 0x80),
            (404100, "()", 0x90),
            (847982, "TOR", 0xA0),
            (-877900, "-WO", 0xA1),
            (827700, "RM", 0xA2),
            (-827700, "-RM", 0xA3),
            (828300, "RS", 0xA4),
            (-828300, "-RS", 0xA5),
            (828400, "RT", 0xA6),
            (-828400, "-RT", 0xA7),
            (826700, "RC", 0xA8),
            (-826700, "-RC", 0xA9),
            (829000, "RZ", 0xAA),
            (-829000, "-RZ", 0xAB),
            (887300, "XI", 0xAC),
            (-887300, "-XI", 0xAD),
            (887900, "XO", 0xAE),
            (-887900, "-XO", 0xAF),
            (887700, "XM", 0xB0),
            (-887700, "-XM", 0xB1),
            (877700, "WM", 0xB2),
            (-877700, "-WM", 0xB3),
            (83877700, "SWM", 0xB4),
            (82877700, "RWM", 0xB5),
            (82878400, "RWT", 0xB6),
            (82876700, "RWC", 0xB7),
            (83876700, "SWC", 0xB8),
            (67848500, "CTU", 0xB9),
            (67846800, "CTD", 0xBA),
            (766800, "LD", 0xBB),
            (76686500, "LDA", 0xBC),
            (76688400, "LDT", 0xBD),
            (76686700, "LDC", 0xBE),
            (76688300, "LDS", 0xBF),
            (76687700, "LDM", 0xC0),
            (76687300, "LDI", 0xC1),
            (76687900, "LDO", 0xC2),
            (76686600, "LDB", 0xC3),
            (838400, "ST", 0xC4),
            (83846700, "STC", 0xC5),
            (83848000, "STP", 0xC6),
            (83847700, "STM", 0xC7),
            (83847900, "STO", 0xC8),
            (80866700, "PVC", 0xC9),
            (80868400, "PVT", 0xCA),
            (65686800, "ADD", 0xCB),
            (83856600, "SUB", 0xCC),
            (77857600, "MUL", 0xCD),
            (68738600, "DIV", 0xCE),
            (77796800, "MOD", 0xCF),
            (65786800, "AND", 0xD0),
            (798200, "OR", 0xD1),
            (88798200, "XOR", 0xD2),
            (83727600, "SHL", 0xD3),
            (83728200, "SHR", 0xD4),
            (718400, "GT", 0xD5),
            (716900, "GE", 0xD6),
            (698100, "EQ", 0xD7),
            (786900, "NE", 0xD8),
            (766900, "LE", 0xD9),
            (768400, "LT", 0xDA),
            (66738400, "BIT", 0xDB),
            (-66738400, "-BIT", 0xDC),
            (77798600, "MOV", 0xDD),
            (68827700, "DRM", 0xDE),
            (836776, "SCL", 0xDF),
            (70768400, "FLT", 0xE0),
            (73788400, "INT", 0xE1),
            (707300, "FI", 0xE2),
            (766600, "LB", 0xE3),
            (74778000, "JMP", 0xE4),
            (-74778000, "-JMP", 0xE5),
        ]
    );
}

/// An instruction's code and lines, with operands that a program may have.
fn sample(opcode: Opcode) -> Vec<i32> {
    let row = opcode.row();
    let last = Board::UNO
        .numbers(row.kind)
        .map_or(0, |(first, _)| first.max(1));
    let code = row.code + row.code.signum() * i32::from(last);
    let lines: &[i32] = match row.kind {
        Kind::Timer => &[500, 7712],
        Kind::Count => &[40000],
        Kind::Move => &[6801, 2],
        Kind::Drum => &[2, 1000, 11],
        Kind::Scale => &[-1, 1023, -300, 32767],
        Kind::Filter => &[30000],
        Kind::Table => &[3],
        Kind::None | Kind::Input | Kind::Output | Kind::Branch | Kind::Marker => &[],
        Kind::System | Kind::TimerQ | Kind::Counter | Kind::Register | Kind::Analogue => &[],
        Kind::Pwm | Kind::Reading | Kind::Group | Kind::Bit | Kind::Time | Kind::Label => &[],
        Kind::Jump | Kind::Value | Kind::Real => &[],
    };
    let mut codes = vec![code];
    codes.extend(lines);
    codes
}

#[test]
fn a_listing_loads_as_the_same_program() {
    let mut memory = [0; 1900];
    let pinned: BTreeSet<Opcode> = load(&mut memory, &text(EVERY))
        .steps()
        .map(|step| step.opcode)
        .collect();
    // What has come after those that are pinned; what is kept is named first.
    let all = Opcode::ALL.iter().copied();
    let (first, last): (Vec<Opcode>, Vec<Opcode>) = all
        .filter(|opcode| !pinned.contains(opcode))
        .partition(|opcode| matches!(opcode, Opcode::KeepRegister | Opcode::KeepCounter));
    let mut every = vec![0];
    every.extend(first.into_iter().flat_map(sample));
    every.extend(&EVERY[1..]);
    every.extend(last.into_iter().flat_map(sample));
    let mut memory = [0; 1900];
    let program = load(&mut memory, &text(&every));
    let mut codes = vec![0];
    codes.extend(program.steps().flat_map(Instruction::codes));
    let used = program.steps().map(|step| step.opcode);
    assert_eq!(
        BTreeSet::from_iter(used).len(),
        Opcode::ALL.len(),
        "every instruction is used"
    );
    assert_eq!(codes, every);
}

/// A register and what was pushed stand in the code itself.
#[test]
fn a_line_follows_only_the_code_of_a_constant() {
    for (kind, line) in [(Kind::Value, Line::Constant), (Kind::Real, Line::Real)] {
        let lines = [0, 1, 99].map(|xx| kind.first_line(xx));
        assert_eq!(lines, [Some(line), None, None], "{kind:?}");
    }
}

#[test]
fn every_timer_has_a_delay() {
    for &opcode in Opcode::ALL {
        let is_timer = opcode.class() == Class::Timer;
        assert_eq!(Delay::of(opcode).is_some(), is_timer, "{opcode:?}");
        assert_eq!(opcode.row().kind == Kind::Timer, is_timer, "{opcode:?}");
    }
}

/// Where a row has the digits of another with a minus, it is the opposite of that.
#[test]
fn negative_codes_are_opposites() {
    for row in TABLE {
        if row.code < 0
            && let Some(plain) = TABLE.iter().find(|plain| plain.code == -row.code)
        {
            assert_eq!((row.class, row.kind), (plain.class, plain.kind), "{row:?}");
        }
    }
}

#[test]
fn letters_spell_the_code() {
    for row in TABLE {
        let digits = row.code.unsigned_abs().to_string();
        let pairs = if row.kind.has_number() || digits.len() > 2 && digits.ends_with("00") {
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
    let cases = [
        (&[787600][..], "NL"),
        (&[827301], "RI 01"),
        (&[-827904], "-RO 04"),
        (&[847978, 1000, 7904], "TON 1000 ms O 04"),
        (&[8480, 16909060, 7712], "TP 16909060 ms M 12"),
        (&[65686803], "ADD D 03"),
        (&[65686800, -12], "ADD -12"),
        (&[808372, 65686899], "ADD popped"),
        (&[82656800, 1_056_964_608], "RAD 0.5"),
        (&[82656804], "RAD D 04"),
        (&[76688803, 5], "LDX 5 from D 03"),
        (&[827301, 7370, 697868], "END"),
        (&[67848502, 7], "CTU 02 7"),
        (&[77798601, 6803, 4], "MOV 4 from D 01 to D 03"),
        (&[68827705, 2, 1000, 11], "DRM D 05 1000 0011"),
        (&[836776, 0, 1023, -5, 5], "SCL 0..1023 to -5..5"),
        (&[70768404, 100], "FLT 04 100 ms"),
        (&[787600, 766603, 74778003], "JMP 03"),
    ];
    for (codes, expected) in cases {
        let mut memory = [0; 100];
        let program = load(&mut memory, &format!("0\n{}", text(codes)));
        let shown = program.steps().last().map(|step| step.to_string());
        assert_eq!(shown.as_deref(), Some(expected));
    }
}

#[test]
fn run_memory_left_by_another_program_starts_no_timer() {
    let mut memory = [0xFF; 100];
    let program = load(&mut memory, "0\n827301\n847970\n1000\n7901\n");
    let mut plc = Plc::new(program);
    assert_eq!(plc.scan(Image::default(), 0).unwrap().0, 0);
}
