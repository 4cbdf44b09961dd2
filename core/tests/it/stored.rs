//! A stored program comes back as itself, or not at all.

use unoclp_core::{Crc16, Loader, Profile, Program};

const TEXT: &str = "0\n827301\n404101\n40\n404101\n-827902\n41\n83877901\n787600\n847978\n70000\n7902\n\
     787600\n766601\n65686800\n-5\n836776\n-300\n-7\n32767\n-32768\n68827702\n2\n1000\n11\n\
     77798601\n6803\n30\n74778001\n";

fn loaded(memory: &mut [u8]) -> Program<'_> {
    let mut loader = Loader::new(memory, Profile::UNO);
    TEXT.bytes().for_each(|byte| loader.push(byte).unwrap());
    loader.finish().unwrap()
}

#[test]
fn the_check_sum_is_the_published_one() {
    // The check value of CRC-16/CCITT-FALSE.
    assert_eq!(Crc16::of(b"123456789").value(), 0x29B1);
}

#[test]
fn a_stored_program_comes_back() {
    let (mut first, mut second) = ([0; 100], [0; 100]);
    let program = loaded(&mut first);
    let mut loader = Loader::new(&mut second, Profile::UNO);
    loader
        .restore(&mut program.stored().iter().copied())
        .unwrap();
    let restored = loader.finish().unwrap();
    assert_eq!(restored.stored(), program.stored());
    assert_eq!(restored.codes(), program.codes());
    assert_eq!(restored.timers(), program.timers());
}

/// Any byte may be anything: what comes back is refused, or the check sum of what was taken tells
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
            let mut loader = Loader::new(&mut memory, Profile::UNO);
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
