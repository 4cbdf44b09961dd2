//! What the data files under `suite/` cannot say: memory sizes, and going on after a fault.

use unoclp_core::{Cause, Fault, Image, Loader, Plc, Profile};

/// All faults that can be told of a text, as number and line.
fn faults(text: &[u8]) -> Vec<(u8, Option<u32>)> {
    let mut memory = [0; 2000];
    let mut loader = Loader::new(&mut memory, Profile::UNO);
    let mut faults: Vec<Fault> = Vec::new();
    for &byte in text {
        faults.extend(loader.push(byte).err());
    }
    while let Err(fault) = loader.end() {
        faults.push(fault);
    }
    match loader.finish() {
        Ok(_) => assert!(faults.is_empty(), "a program in spite of {faults:?}"),
        Err(fault) => assert_eq!(Some(&fault), faults.first()),
    }
    faults
        .iter()
        .map(|fault| (fault.cause.number(), fault.line))
        .collect()
}

#[test]
fn goes_on_after_a_fault() {
    let text = b"827301\n8273 01\n827309\n40\n787600\n847978\n-5\n827301\n-0\n0\n41\n847978\n";
    assert_eq!(
        faults(text),
        [
            (22, Some(1)),  // no start
            (12, Some(2)),  // two codes on a line
            (25, Some(3)),  // no such input
            (32, Some(4)),  // branch left open, told at line 5
            (36, Some(7)),  // bad preset
            (37, Some(8)),  // bad timer output
            (15, Some(9)),  // minus zero
            (23, Some(10)), // second start
            (31, Some(11)), // close without open
            (35, Some(12)), // operands missing, told at the end
        ]
    );
}

#[test]
fn one_mistake_is_told_once() {
    // A stray character in a preset does not make a fault of the lines after it.
    assert_eq!(faults(b"0\n847978\n10x0\n7901\n827301\n"), [(12, Some(3))]);
    // The branches that are closed again after one too many were opened are not too many closes.
    let deep = "0\n".to_string() + &"40\n".repeat(9) + &"41\n".repeat(9);
    assert_eq!(faults(deep.as_bytes()), [(34, Some(10))]);
    // What does not fit is told at the first code that does not.
    let long = "0\n".to_string() + &"827301\n".repeat(1000);
    assert_eq!(faults(long.as_bytes()), [(41, Some(902))]);
    // A UTF-16 file is told as that, not byte by byte.
    assert_eq!(faults(b"\xFF\xFE0\0\n\0x\0"), [(11, Some(1))]);
}

#[test]
fn the_last_line_and_the_end_may_both_be_at_fault() {
    assert_eq!(faults(b"0\n40\n827309"), [(25, Some(3)), (32, Some(2))]);
    assert_eq!(faults(b"0\n40\n827301\r"), [(13, Some(3)), (32, Some(2))]);
}

#[test]
fn a_memory_smaller_than_the_profile_decides() {
    for size in 0..20 {
        let mut memory = vec![0; size];
        let mut loader = Loader::new(&mut memory, Profile::UNO);
        // 1 + 6 + 5 + 1 = 13 bytes of run memory.
        for byte in b"0\n827301\n847978\n5\n7901\n877902" {
            let _ = loader.push(*byte);
        }
        match loader.finish() {
            Ok(program) => {
                assert_eq!(program.linked_bytes(), 13);
                assert!(size >= 13);
                Plc::new(program).scan(Image::default(), 0).unwrap();
            }
            Err(fault) => {
                assert!(size < 13, "{size}: {fault}");
                assert_eq!(fault.cause, Cause::RunMemoryFull);
                let line = match size {
                    0 => 2,
                    1..12 => 3,
                    _ => 6,
                };
                assert_eq!(fault.line, Some(line));
            }
        }
    }
}

#[test]
fn lines_are_counted_beyond_16_bits() {
    let text = "0\n".to_string() + &"\n".repeat(70_000) + "5\n";
    assert_eq!(faults(text.as_bytes()), [(24, Some(70_002))]);
}

#[test]
fn fault_numbers_are_for_ever() {
    let numbers: Vec<u8> = Cause::ALL.iter().map(|cause| cause.number()).collect();
    assert_eq!(
        numbers,
        [
            11, 12, 13, 14, 15, 21, 22, 23, 24, 25, 26, 27, 28, 29, 31, 32, 33, 34, 35, 36, 37, 38,
            39, 41, 42, 43, 51, 52, 53, 54, 55, 56, 57, 61, 62, 63, 64, 65, 66, 71, 72, 73, 74, 75
        ]
    );
    // LED L flashes tens and units: neither may be 0.
    assert!(
        numbers
            .iter()
            .all(|number| number % 10 != 0 && *number > 10)
    );
}

#[test]
fn a_fault_says_number_line_and_text() {
    let line = Fault {
        cause: Cause::UnknownCode,
        line: Some(7),
    };
    assert_eq!(line.to_string(), "fault 24, line 7: no such code");
    let card = Fault::without_line(Cause::VolumeDamaged);
    assert!(card.to_string().starts_with("fault 56: "));
}
