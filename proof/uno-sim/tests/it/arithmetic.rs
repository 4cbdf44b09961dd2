//! Arithmetic on the firmware and on the core, with random numbers and those at the edges.

use crate::common;
use unoclp_core::Inputs;
use unoclp_core::isa::{Class, Kind, REGISTERS, TABLE};
use unoclp_host_sim::engine::{Cell, Engine, HostEngine};
use unoclp_host_sim::random::Random;
use unoclp_testing::rounds;
use unoclp_uno_sim::engine::{Clock, UnoEngine};

const CASES: u32 = 5_000;
/// Numbers at which something changes.
const EDGES: &[i32] = &[
    0,
    1,
    -1,
    2,
    -2,
    3,
    7,
    -10,
    255,
    256,
    257,
    999,
    1000,
    -1000,
    32767,
    32768,
    -32768,
    -32769,
    65535,
    65536,
    0x3F_FFFF,
    0x40_0000,
    -0x40_0000,
    -0x40_0001,
    46_340 * 46_340,
    46_340 * 46_340 - 1,
    i32::MAX,
    i32::MAX - 1,
    i32::MIN,
    i32::MIN + 1,
];

/// The codes of this class and kind: whatever the instruction table has, is tried.
fn codes(class: Class, kind: Kind) -> impl Iterator<Item = i32> {
    let rows = TABLE
        .iter()
        .filter(move |row| row.class == class && row.kind == kind);
    rows.map(|row| row.code)
}

const LOAD: u32 = 766_800;
const STORE: u32 = 838_400;
/// What is pushed has to be taken back.
const PUSH: i32 = 808_372;

/// D 03 and on: what comes of D 01 and D 02 by each operation. Then comparisons, bits of D 01 and S 04 in
/// markers, and what takes D 01 alone.
fn program(random: &mut Random) -> String {
    let mut text = String::from("0\n");
    let mut result = 3;
    let mut store = |text: &mut String| {
        assert!(result < 98, "INT has D 98");
        *text += &format!("{}\n787600\n", STORE + result);
        result += 1;
    };
    let load = format!("{}\n", LOAD + 1);
    for operation in codes(Class::Operation, Kind::Value) {
        text += &format!("{load}{}\n", operation + 2);
        store(&mut text);
        text += &format!("{load}{operation}\n{}\n", number(random));
        store(&mut text);
    }
    // NEG, SQR, and shifts.
    for code in codes(Class::Operation, Kind::None).filter(|code| *code != PUSH) {
        text += &format!("{load}{code}\n");
        store(&mut text);
    }
    for shift in codes(Class::Operation, Kind::Bit) {
        text += &format!("{load}{}\n", shift + random.below(32) as i32);
        store(&mut text);
    }
    // SCL, FLT, INT into D 98.
    let low = random.below(60_000) as i32 - 32_768;
    let high = low + 1 + random.below((32_767 - low) as u32) as i32;
    let bound = |random: &mut Random| random.below(65_536) as i32 - 32_768;
    text += &format!(
        "{load}836776\n{low}\n{high}\n{}\n{}\n",
        bound(random),
        bound(random)
    );
    store(&mut text);
    text += &format!(
        "{load}{}\n{}\n",
        70_768_401 + random.below(8),
        random.below(30)
    );
    store(&mut text);
    text += &format!("787600\n827301\n{load}73788498\n");
    let mut marker = 1;
    for comparison in codes(Class::Comparison, Kind::Value) {
        for (code, line) in [
            (comparison + 2, String::new()),
            (comparison, { format!("{}\n", number(random)) }),
        ] {
            text += &format!("787600\n{load}{code}\n{line}{}\n", 877_700 + marker);
            marker += 1;
        }
    }
    for sign in ["", "-"] {
        text += &format!(
            "787600\n{load}{sign}{}\n{}\n",
            66_738_400 + random.below(32),
            877_700 + marker
        );
        marker += 1;
    }
    // S 04.
    text += &format!("787600\n828304\n{}\n", 877_700 + marker);
    text
}

fn number(random: &mut Random) -> i32 {
    if random.percent(40) {
        EDGES[random.below(EDGES.len() as u32) as usize]
    } else {
        // Of any size.
        (random.below(u32::MAX) as i32) >> random.below(32)
    }
}

#[test]
fn random_numbers_come_out_alike() {
    let random = &mut Random::new(0xA217);
    let mut uno = UnoEngine::new(common::firmware(), Clock::Lockstep).unwrap();
    let mut host = HostEngine::new(unoclp_core::Board::UNO);
    let mut text = String::new();
    let mut now = 0_u32;
    for case in 0..rounds(CASES) {
        if case % 100 == 0 {
            text = program(random);
            let Ok(accepted) = host.load(text.as_bytes());
            assert_eq!(accepted, Ok(()), "{text}");
            let accepted = uno.load(text.as_bytes()).unwrap();
            assert_eq!(accepted, Ok(()), "{text}");
        }
        let (a, b) = (number(random), number(random));
        for (cell, number) in [(Cell::Register(1), a), (Cell::Register(2), b)] {
            let Ok(()) = host.poke(cell, number);
            uno.poke(cell, number).unwrap();
        }
        let mut inputs = Inputs::default();
        inputs.points.0 = u128::from(random.percent(90));
        now = now.wrapping_add(if random.percent(5) {
            random.below(100_000)
        } else {
            random.below(50)
        });
        let Ok(expected) = host.scan(&inputs, now);
        assert_eq!(uno.scan(&inputs, now).unwrap(), expected);
        for cell in (1..=REGISTERS)
            .map(Cell::Register)
            .chain((1..=20).map(Cell::Marker))
        {
            let Ok(expected) = host.look(cell);
            let came = uno.look(cell).unwrap();
            assert_eq!(came, expected, "{a}, {b}: {cell:?} in\n{text}");
        }
    }
}
