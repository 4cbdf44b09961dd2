//! A stored program comes back as itself, or not at all.

use unoclp_core::{Board, Cause, Crc16, Image, Loader, Plc, Program};

const TEXT: &str = "0\n827301\n404101\n40\n404101\n-827902\n41\n83877901\n787600\n847978\n70000\n7902\n\
     787600\n766601\n65686800\n-5\n836776\n-300\n-7\n32767\n-32768\n68827702\n2\n1000\n11\n\
     77798601\n6803\n30\n74778001\n";

fn loaded(memory: &mut [u8]) -> Program<'_> {
    let mut loader = Loader::new(memory, Board::UNO);
    TEXT.bytes().for_each(|byte| loader.push(byte).unwrap());
    loader.finish().unwrap()
}

#[test]
fn the_check_sum_is_the_published_one() {
    // The check value of CRC-16/CCITT-FALSE.
    let mut sum = Crc16::of(b"1234");
    sum.extend(b"56789");
    assert_eq!(sum.value(), 0x29B1);
    assert_eq!(sum.to_be_bytes(), [0x29, 0xB1]);
}

#[test]
fn a_stored_program_comes_back() {
    let (mut first, mut second) = ([0; 100], [0; 100]);
    let program = loaded(&mut first);
    let mut loader = Loader::new(&mut second, Board::UNO);
    loader
        .restore(&mut program.stored().iter().copied())
        .unwrap();
    let restored = loader.finish().unwrap();
    assert_eq!(restored.stored(), program.stored());
    assert_eq!(restored.codes(), program.codes());
    assert_eq!([restored.timers(), program.timers()], [1, 1]);
}

/// Registers above 32 are there only if a code names one (NC-27): another XX above 32 is none.
#[test]
fn a_marker_makes_no_register() {
    let mut memory = [0; 100];
    let mut loader = Loader::new(&mut memory, Board::UNO);
    let text = "0\n827764\n877901\n";
    text.bytes().for_each(|byte| loader.push(byte).unwrap());
    assert_eq!(loader.finish().unwrap().registers(), 32);
}

/// A tool shows where in the stored form an instruction begins.
#[test]
fn each_step_begins_behind_the_one_before() {
    let mut memory = [0; 100];
    let program = restored(&mut memory, &[0x10, 0xBB, 0, 5, 0, 0, 0, 0xC4, 1, 0x50]);
    let mut steps = program.steps();
    let begins: Vec<usize> =
        std::iter::from_fn(|| Some((steps.at(), steps.next()?)).map(|(at, _)| at)).collect();
    assert_eq!(begins, [0, 1, 7, 9]);
}

fn restored<'m>(memory: &'m mut [u8], stored: &[u8]) -> Program<'m> {
    let mut loader = Loader::new(memory, Board::UNO);
    loader.restore(&mut stored.iter().copied()).unwrap();
    loader.finish().unwrap()
}

/// Older versions stored every constant in 4 bytes. A board that is brought up to date still has such a program.
#[test]
fn constants_of_older_versions_come_back() {
    let old = [
        0xBB, 0, 5, 0, 0, 0, 0xCB, 0, 0xFE, 0xFF, 0xFF, 0xFF, 0xCD, 0, 0xE8, 3, 0, 0, 0xC4, 1,
    ];
    let (mut first, mut second) = ([0; 100], [0; 100]);
    let program = restored(&mut first, &old);
    assert_eq!(program.stored(), old);
    let mut loader = Loader::new(&mut second, Board::UNO);
    for byte in b"0\n766800\n5\n65686800\n-2\n77857600\n1000\n838401\n" {
        loader.push(*byte).unwrap();
    }
    let new = loader.finish().unwrap();
    assert_eq!(
        new.stored(),
        [0xBB, 100, 5, 0xCB, 100, 0xFE, 0xCD, 101, 0xE8, 3, 0xC4, 1]
    );
    assert!(program.steps().eq(new.steps()));
    assert_eq!(program.codes(), new.codes());
    assert!(program.linked_bytes() > new.linked_bytes());
    for program in [program, new] {
        let mut plc = Plc::new(program);
        plc.scan(Image::default(), 0).unwrap();
        assert_eq!(plc.registers()[0], 3000);
    }
}

/// What version 3 has added comes back too, and its faults are told of a stored program.
#[test]
fn brackets_and_pushed_values_are_checked_again() {
    let (mut first, mut second) = ([0; 1900], [0; 1900]);
    let stored = [0x10, 0xFD, 0xE8, 0xE9, 99, 0xFE, 0xE8, 0xF6, 90, 9, 0xFF];
    let program = restored(&mut first, &stored);
    assert_eq!(program.stored(), stored);
    assert_eq!(program.registers(), 98);
    for (stored, cause) in [
        (&[0xE9, 99][..], Cause::NothingPushed),
        (&[0xE8, 1], Cause::ValueLeftPushed),
        (&[0xE9, 0, 0, 0, 0x80, 0x7F], Cause::NotReal),
        (&[0xFF], Cause::NoIf),
        (&[0xF5, 90, 10], Cause::BadOperand),
        (&[0xFD], Cause::IfLeftOpen),
        // No constant takes 3 bytes.
        (&[0xBB, 102, 1, 2, 3], Cause::NoSuchPoint),
    ] {
        let mut loader = Loader::new(&mut second, Board::UNO);
        let _ = loader.restore(&mut stored.iter().copied());
        let fault = loader.finish().err();
        assert_eq!(fault.map(|fault| fault.cause), Some(cause), "{stored:?}");
    }
}

/// Any byte may be anything: what comes back is refused, or the checksum of what was taken tells
/// whether it is the same program.
#[test]
fn a_damaged_stored_program_is_refused_or_itself() {
    let mut memory = [0; 100];
    let stored = loaded(&mut memory).stored().to_vec();
    let mut refused = 0;
    for place in 0..stored.len() {
        for byte in 0..=255 {
            let mut damaged = stored.clone();
            damaged[place] = byte;
            let mut memory = [0; 100];
            let mut loader = Loader::new(&mut memory, Board::UNO);
            let restored = loader.restore(&mut damaged.iter().copied());
            match (restored, loader.finish()) {
                (Ok(()), Ok(program)) => {
                    let same_sum = Crc16::of(program.stored()) == Crc16::of(&stored);
                    assert_eq!(same_sum, program.stored() == stored);
                }
                (Err(_), Err(_)) | (Ok(()), Err(_)) => refused += 1,
                (Err(fault), Ok(_)) => panic!("a program in spite of {fault}"),
            }
        }
    }
    assert!(refused > 1000, "{refused}");
}
