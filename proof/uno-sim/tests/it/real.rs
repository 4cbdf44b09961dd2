//! REAL operations on the chip and in the core, bit by bit: the engine's own `real.s` with the libraries that
//! the firmware has, and a loop around it that takes its operands from RAM.

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::LazyLock;

use unoclp_core::real;
use unoclp_host_sim::random::Random;
use unoclp_testing::rounds;
use unoclp_uno_sim::{Slot, Uno};

/// How many rows of value, b, result and error `real_rows.s` has room for.
const ROWS: usize = 100;
const ROW: usize = 13;
const RANDOM_PAIRS: u32 = 1_000_000;
const ENOUGH_CYCLES: u64 = 1_000_000;

type Operation = (&'static str, fn(i32, i32) -> (i32, bool));

/// By their numbers in `real_rows.s`: those of two operands, then those of one.
const PAIRS: usize = 4;
const OPERATIONS: [Operation; 12] = [
    ("add", real::add),
    ("subtract", real::subtract),
    ("multiply", real::multiply),
    ("divide", real::divide),
    ("root", |value, _| real::square_root(value)),
    ("from signed", |value, _| real::from_signed(value)),
    ("from unsigned", |value, _| real::from_unsigned(value)),
    ("round", |value, _| real::round(value)),
    ("cut", |value, _| real::cut(value)),
    ("comparable", |value, _| (real::comparable(value), false)),
    ("absolute", |value, _| real::absolute(value)),
    ("negate", |value, _| real::negate(value)),
];

/// Where something changes, without signs.
const EDGES: &[u32] = &[
    0,
    1,
    2,
    3,
    0x007F_FFFE,
    0x007F_FFFF, // the greatest subnormal
    0x0080_0000, // the least normal
    0x0080_0001,
    0x00FF_FFFF,
    0x0100_0000,
    0x1F80_0000, // 2^-64, and its neighbours
    0x2000_0001,
    0x3380_0000, // 2^-24
    0x3E7F_FFFF,
    0x3E80_0000, // a quarter
    0x3EFF_FFFF,
    0x3F00_0000, // a half
    0x3F00_0001,
    0x3F7F_FFFF,
    0x3F80_0000, // 1
    0x3F80_0001,
    0x3FC0_0000, // 1.5
    0x4000_0000,
    0x4020_0000, // 2.5
    0x4040_0000,
    0x4060_0000, // 3.5
    0x4AFF_FFFF, // 8,388,607.5
    0x4B00_0000, // 2^23
    0x4B00_0001,
    0x4B7F_FFFF,
    0x4B80_0000, // 2^24
    0x4B80_0001,
    0x4EFF_FFFF,
    0x4F00_0000, // 2^31
    0x4F00_0001,
    0x4F7F_FFFF,
    0x4F80_0000, // 2^32
    0x4F80_0001,
    0x5F7F_FFFF,
    0x7E80_0000,
    0x7EFF_FFFF,
    0x7F00_0000,
    0x7F7F_FFFF, // the greatest
    0x7F80_0000, // infinity
    0x7F80_0001, // not a number
    0x7F80_0100,
    0x7FC0_0000,
    0x7FFF_FFFF,
];

/// The operations in their loop, made once for all tests.
static ELF: LazyLock<PathBuf> = LazyLock::new(|| {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let workspace = root.ancestors().nth(2).expect("a workspace");
    let elf = Path::new(env!("CARGO_TARGET_TMPDIR")).join("real.elf");
    let mut includes = OsString::from("-Wa,-I");
    includes.push(workspace.join("firmware/src/engine"));
    let status = Command::new("avr-gcc")
        .args(["-mmcu=atmega328p", "-Wl,--relax"])
        .arg(includes)
        .arg("-o")
        .arg(&elf)
        .arg(root.join("tests/data/real_rows.s"))
        .arg("-lm")
        .status();
    assert!(status.expect("avr-gcc").success());
    elf
});

/// The chip with the loop, before its first row.
struct Chip {
    uno: Uno,
    rows: u32,
    done: u32,
}

impl Chip {
    fn new() -> Chip {
        let uno = Uno::new(ELF.as_path(), Slot::Empty).expect("an ELF");
        let symbol = |name| uno.symbol(name).expect(name).address;
        let (rows, done) = (symbol("rows"), symbol("done"));
        let mut chip = Chip { uno, rows, done };
        chip.finish();
        chip
    }

    fn finish(&mut self) {
        self.uno
            .run_until(self.done, ENOUGH_CYCLES)
            .expect("an end");
    }

    fn address(&self, name: &str) -> u32 {
        self.uno.symbol(name).expect(name).address
    }

    fn write(&mut self, number: usize, pairs: &[(i32, i32)]) {
        let mut rows = Vec::with_capacity(ROWS * ROW);
        for (value, b) in pairs {
            rows.extend(value.to_le_bytes());
            rows.extend(b.to_le_bytes());
            rows.extend([0xAA; 5]);
        }
        let (count, operation) = (self.address("count"), self.address("operation"));
        self.uno.write_ram(self.rows, &rows).expect("RAM");
        self.uno
            .write_ram(count, &[pairs.len() as u8])
            .expect("RAM");
        self.uno.write_ram(operation, &[number as u8]).expect("RAM");
        self.uno.step().expect("off `done`");
    }

    /// Has the chip run an operation on each pair, and compares what comes.
    fn compare(&mut self, number: usize, pairs: &[(i32, i32)]) {
        let (name, operation) = OPERATIONS[number];
        for pairs in pairs.chunks(ROWS) {
            self.write(number, pairs);
            self.finish();
            let rows = self
                .uno
                .read_ram(self.rows, pairs.len() * ROW)
                .expect("RAM");
            for (&(value, b), row) in pairs.iter().zip(rows.chunks(ROW)) {
                let came = i32::from_le_bytes([row[8], row[9], row[10], row[11]]);
                assert_ne!(
                    row[12], 0xEE,
                    "{name} of {value:#x}, {b:#x} loses a register"
                );
                let expected = operation(value, b);
                assert_eq!(
                    (came, row[12] != 0),
                    expected,
                    "{name} of {value:#010x}, {b:#010x}: {came:#010x}, not {:#010x}",
                    expected.0
                );
            }
        }
    }
}

fn bits(random: &mut Random) -> i32 {
    random.below(u32::MAX).cast_signed()
}

/// A pair, of any bits, with near exponents, of almost the same size, or with a result near the least.
fn pair(random: &mut Random) -> (i32, i32) {
    let (a, b) = (bits(random), bits(random));
    let sign = bits(random) & i32::MIN;
    let exponent = |bits: i32| bits >> 23 & 0xFF;
    let with = |bits: i32, exponent: i32| bits & !(0xFF << 23) | exponent.clamp(0, 254) << 23;
    let near = random.below(60) as i32 - 30;
    match random.below(6) {
        0 => (a, b),
        1 => (a, with(b, exponent(a) + near)),
        2 => (a, a.wrapping_add(near) ^ sign),
        // Products, then quotients.
        3 => (a, with(b, 127 - exponent(a) + near)),
        4 => (a, with(b, exponent(a) + 127 + near)),
        // Few digits, so that halves are met.
        _ => (a & !0xFFF, with(b & !0xFFF, exponent(a) + near)),
    }
}

/// An operand near the integers.
fn single(random: &mut Random) -> i32 {
    let a = bits(random);
    match random.below(4) {
        0 => a,
        1 => a >> random.below(32),
        2 => a & !(0xFF << 23) | (120 + random.below(40) as i32) << 23,
        _ => ((a >> random.below(32)) as f32 / 4.0)
            .to_bits()
            .cast_signed(),
    }
}

#[test]
fn edges_come_out_alike() {
    let mut chip = Chip::new();
    let edges: Vec<i32> = EDGES
        .iter()
        .flat_map(|&edge| [edge, edge | 1 << 31])
        .map(u32::cast_signed)
        .collect();
    let pairs: Vec<_> = edges
        .iter()
        .flat_map(|&a| edges.iter().map(move |&b| (a, b)))
        .collect();
    for number in 0..PAIRS {
        chip.compare(number, &pairs);
    }
    let singles: Vec<_> = edges.iter().map(|&a| (a, a)).collect();
    for number in PAIRS..OPERATIONS.len() {
        chip.compare(number, &singles);
    }
}

#[test]
fn random_reals_come_out_alike() {
    let mut chip = Chip::new();
    let random = &mut Random::new(0x2EA1);
    for batch in 0..rounds(RANDOM_PAIRS) as usize / ROWS {
        let pairs: Vec<_> = (0..ROWS).map(|_| pair(random)).collect();
        chip.compare(batch % PAIRS, &pairs);
        if batch % 4 == 0 {
            let singles: Vec<_> = (0..ROWS).map(|_| (single(random), 0)).collect();
            chip.compare(PAIRS + batch / 4 % (OPERATIONS.len() - PAIRS), &singles);
        }
    }
}
