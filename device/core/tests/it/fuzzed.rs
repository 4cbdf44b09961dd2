//! Whatever bytes come as a program file or as a stored program: they are refused, or make a program
//! that keeps within the board.

use unoclp_core::{Board, Cause, Fault, Image, Inputs, Loader, Plc, Program};

const BOARD: Board = Board::UNO;
/// Scans of each accepted program.
const SCANS: u32 = 12;

/// What holds of all bytes; the target `loader` of `proof/fuzz/` looks for those of which it does not.
pub fn hold(bytes: &[u8]) {
    as_text(bytes);
    as_stored(bytes);
}

/// A program file: the first fault told is the one that the loader ends with, at a line of the file.
fn as_text(bytes: &[u8]) {
    let mut memory = vec![0; BOARD.plc_bytes()];
    let mut loader = Loader::new(&mut memory, BOARD);
    let mut first: Option<Fault> = None;
    for &byte in bytes {
        if let Err(fault) = loader.push(byte) {
            first.get_or_insert(fault);
        }
    }
    while let Err(fault) = loader.end() {
        first.get_or_insert(fault);
    }
    match loader.finish() {
        Ok(program) => {
            assert_eq!(first, None);
            let stored = program.stored().to_vec();
            run(program);
            let again = restored(&stored, |program| program.stored().to_vec());
            assert_eq!(again, Some(stored));
        }
        Err(fault) => {
            assert_eq!(first, Some(fault));
            let lines = bytes.iter().filter(|&&byte| byte == b'\n').count() as u32 + 1;
            assert!(fault.line.is_none_or(|line| (1..=lines).contains(&line)));
        }
    }
}

/// A stored program: it never comes back in spite of a fault. What has come back comes back byte for byte;
/// before, a point of a branch may have been stored as recalled where none had been kept.
fn as_stored(bytes: &[u8]) {
    restored(bytes, |program| {
        let stored = program.stored().to_vec();
        run(program);
        let again = restored(&stored, |program| program.stored().to_vec());
        assert_eq!(again, Some(stored));
    });
}

fn restored<T>(bytes: &[u8], act: impl FnOnce(Program<'_>) -> T) -> Option<T> {
    let mut memory = vec![0; BOARD.plc_bytes()];
    let mut loader = Loader::new(&mut memory, BOARD);
    let restored = loader.restore(&mut bytes.iter().copied());
    let program = loader.finish().ok()?;
    assert_eq!(restored, Ok(()));
    Some(act(program))
}

/// It is within the limits of the board, drives no output that the board lacks or that is PWM, and
/// turns all of them off at a fault.
fn run(program: Program<'_>) {
    assert!(program.stored_bytes() <= BOARD.stored_bytes.into());
    assert!(program.linked_bytes() <= BOARD.linked_bytes.into());
    let mut plc = Plc::new(program);
    for scan in 0..SCANS {
        let inputs = Inputs {
            points: Image(u128::from(scan.wrapping_mul(0x9D) as u8)),
            scan_time: scan as u16,
            ..Inputs::default()
        };
        let inputs = inputs.reading(&[0, 1, 511, 512, 1023].map(|reading| reading ^ scan as u16));
        // From shortly before the wrap of the clock to beyond it.
        let now = (u32::MAX - 400).wrapping_add(scan * 77);
        match plc.scan(inputs, now) {
            Ok(outputs) => {
                assert_eq!(outputs.0 >> BOARD.outputs, 0);
                assert_eq!(outputs.0 & plc.needs().pwm, 0);
            }
            Err(fault) => {
                assert_eq!(fault.cause, Cause::TooManyJumps);
                assert_eq!(plc.outputs().0, 0);
                return;
            }
        }
    }
}

#[test]
fn every_file_of_the_corpus() {
    unoclp_testing::each_of_corpus("loader", hold);
}
