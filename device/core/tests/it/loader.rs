//! What the data files under `proof/suite/` cannot say: memory sizes, and going on after a fault.

use unoclp_core::isa::{Opcode, is_real};
use unoclp_core::{Board, Cause, Fault, Image, Loader, Part, Plc};

/// All faults that can be told of a text, as number and line.
fn faults(text: &[u8]) -> Vec<(u8, Option<u32>)> {
    faults_on(Board::UNO, text)
}

fn faults_on(board: Board, text: &[u8]) -> Vec<(u8, Option<u32>)> {
    let mut memory = [0; 2000];
    let mut loader = Loader::new(&mut memory, board);
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
fn a_board_without_real_numbers_knows_no_code_of_them() {
    // NC-23. Only the code is told; the constant after it is none.
    let text = b"0\n766801\n82656800\n1065353216\n738482\n838402\n";
    assert_eq!(faults_on(Board::UNO, text), []);
    let told = [(24, Some(3)), (24, Some(5))];
    assert_eq!(faults_on(Board::NANO, text), told);
    for opcode in Opcode::ALL {
        let is_named = format!("{opcode:?}").starts_with("Real");
        assert_eq!(is_real(opcode.row().stored), is_named, "{opcode:?}");
    }
    // What is stored is refused as well: `ITR`.
    let mut memory = [0; 100];
    let mut loader = Loader::new(&mut memory, Board::NANO);
    let refused = loader.restore(&mut [0xED].into_iter());
    assert_eq!(
        refused.map_err(|fault| fault.cause),
        Err(Cause::UnknownCode)
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
        let mut loader = Loader::new(&mut memory, Board::UNO);
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

/// The faults of a program of these codes, one on each line from line 2 on.
fn faults_of(codes: &[i32]) -> Vec<(u8, Option<u32>)> {
    let lines: String = codes.iter().map(|code| format!("{code}\n")).collect();
    faults(format!("0\n{lines}").as_bytes())
}

const PSH: i32 = 808372;
const ADD_POPPED: i32 = 65686899;
const IF: i32 = 7370;
const ELS: i32 = 697683;
const END: i32 = 697868;

/// NC-22
#[test]
fn what_is_pushed_is_popped_in_its_rung() {
    assert_eq!(faults_of(&[PSH, ADD_POPPED]), []);
    assert_eq!(faults_of(&[ADD_POPPED]), [(81, Some(2))]);
    assert_eq!(faults_of(&[PSH, ADD_POPPED, ADD_POPPED]), [(81, Some(4))]);
    assert_eq!(faults_of(&[766899]), [(81, Some(2))]);
    assert_eq!(faults_of(&[82656899]), [(81, Some(2))]);
    // STX pops its index; its line is no code.
    assert_eq!(faults_of(&[83848801, 5]), [(81, Some(2))]);
    assert_eq!(faults_of(&[PSH, 83848801, 5]), []);
    // Eight fit, and the ninth and those that pop it are told once.
    assert_eq!(faults_of(&[[PSH; 8], [ADD_POPPED; 8]].concat()), []);
    assert_eq!(
        faults_of(&[[PSH; 9], [ADD_POPPED; 9]].concat()),
        [(82, Some(10))]
    );
    // Told where the rung ends.
    assert_eq!(faults_of(&[PSH, 787600, 827301]), [(83, Some(3))]);
    assert_eq!(
        faults_of(&[PSH, 787600, ADD_POPPED]),
        [(83, Some(3)), (81, Some(4))]
    );
    assert_eq!(faults_of(&[PSH, 827301]), [(83, Some(4))]);
    // An open branch is told before it.
    assert_eq!(faults_of(&[PSH, 40, 787600]), [(32, Some(3))]);
    // No jump and no return may lose it.
    assert_eq!(
        faults_of(&[766601, PSH, 74778001, ADD_POPPED]),
        [(74, Some(4))]
    );
    assert_eq!(faults_of(&[PSH, 826984, ADD_POPPED]), [(74, Some(3))]);
}

/// NC-23
#[test]
fn a_real_constant_is_finite() {
    for bits in [f32::INFINITY, f32::NEG_INFINITY, f32::NAN, -f32::NAN] {
        let bits = bits.to_bits().cast_signed();
        assert_eq!(faults_of(&[82656800, bits]), [(84, Some(3))]);
        // Of whole numbers each is one.
        assert_eq!(faults_of(&[65686800, bits]), []);
    }
    for bits in [f32::MAX, f32::MIN, -0.0, f32::MIN_POSITIVE, 2.0] {
        assert_eq!(faults_of(&[82656800, bits.to_bits().cast_signed()]), []);
    }
    assert_eq!(faults_of(&[82656800]), [(35, Some(2))]);
}

/// NC-24, NC-27
#[test]
fn a_table_ends_with_the_registers() {
    assert_eq!(faults_of(&[76688898, 1]), []);
    assert_eq!(faults_of(&[76688801, 98]), []);
    for (code, length) in [(76688898, 2), (76688801, 99), (76688805, 0), (76688805, -1)] {
        assert_eq!(faults_of(&[code, length]), [(38, Some(3))]);
    }
    assert_eq!(faults_of(&[76688805, 65_537]), [(38, Some(3))]);
    assert_eq!(faults_of(&[76688800, 1]), [(28, Some(2))]);
    assert_eq!(faults_of(&[76688899, 1]), [(28, Some(2))]);
    assert_eq!(faults_of(&[838499]), [(28, Some(2))]);
    assert_eq!(faults_of(&[76688805]), [(35, Some(2))]);
}

/// NC-28
#[test]
fn brackets_are_balanced() {
    assert_eq!(faults_of(&[IF, ELS, END, 766601]), []);
    assert_eq!(faults_of(&[ELS]), [(85, Some(2))]);
    assert_eq!(faults_of(&[END]), [(85, Some(2))]);
    assert_eq!(faults_of(&[IF, END, END]), [(85, Some(4))]);
    assert_eq!(faults_of(&[IF, ELS, ELS, END]), [(85, Some(4))]);
    // The ELS of the inner IF is not one of the outer.
    assert_eq!(faults_of(&[IF, IF, ELS, END, ELS, END]), []);
    assert_eq!(
        faults_of(&[IF, ELS, IF, ELS, END, ELS, END]),
        [(85, Some(7))]
    );
    // The line of the IF, the innermost first.
    assert_eq!(faults_of(&[787600, IF, 787600]), [(87, Some(3))]);
    assert_eq!(
        faults_of(&[IF, IF, END, IF]),
        [(87, Some(5)), (87, Some(2))]
    );
    assert_eq!(faults_of(&[[IF; 8], [END; 8]].concat()), []);
    assert_eq!(faults_of(&[[IF; 9], [END; 9]].concat()), [(86, Some(10))]);
    // A rung ends at each of them, and no branch or value goes on after it.
    assert_eq!(faults_of(&[40, IF, 41])[0], (74, Some(3)));
    assert_eq!(faults_of(&[PSH, IF, ADD_POPPED])[0], (74, Some(3)));
    assert_eq!(faults_of(&[IF, 40, END, 41])[0], (74, Some(4)));
    assert_eq!(faults_of(&[IF, PSH, ELS, ADD_POPPED])[0], (74, Some(4)));
    assert_eq!(
        faults_of(&[404101, IF, 40, 404101, 41, END]),
        [(33, Some(5))]
    );
}

/// A jump is looked for where an instruction begins: a constant may hold its bytes.
#[test]
fn a_constant_is_no_jump() {
    // The bytes of `JMP 09`.
    assert_eq!(faults_of(&[766601, 787600, 766800, 0x09E4, 74778001]), []);
    assert_eq!(faults_of(&[766601, 787600, 74778009]), [(72, Some(4))]);
}

/// What a tool that shows a file is told of each byte, and of how many codes there are.
#[test]
fn each_byte_of_a_file_has_its_part() {
    let mut memory = [0; 100];
    let mut loader = Loader::new(&mut memory, Board::UNO);
    let mut parts = String::new();
    for &byte in b"0 /a\n847978\n-5\n8x1\n" {
        let _ = loader.push(byte);
        parts.push(match loader.part() {
            Part::Blank => ' ',
            Part::Code => 'c',
            Part::Comment => '/',
            Part::Faulty => '!',
        });
    }
    assert_eq!(parts, "c // cccccc cc c!! ");
    assert_eq!(loader.codes(), 2);
}

/// Bytes of run memory of a program of these codes.
fn linked(codes: &[i32]) -> usize {
    let lines: String = codes.iter().map(|code| format!("{code}\n")).collect();
    let mut memory = [0; 2000];
    let mut loader = Loader::new(&mut memory, Board::UNO);
    for byte in format!("0\n{lines}").bytes() {
        loader.push(byte).unwrap();
    }
    loader.finish().unwrap().linked_bytes()
}

/// NC-27: each up to the highest that is named takes 4 bytes, whatever names it, and once.
#[test]
fn far_registers_take_run_memory() {
    assert_eq!(linked(&[766832]), 3);
    assert_eq!(linked(&[766833]), 4 + 4);
    assert_eq!(linked(&[766898]), 4 + 66 * 4);
    assert_eq!(linked(&[766898, 766833]), 4 + 4 + 66 * 4);
    assert_eq!(linked(&[838432]), 2);
    assert_eq!(linked(&[838433]), 4 + 4);
    assert_eq!(linked(&[77798601, 6801, 32]), 7);
    assert_eq!(linked(&[77798601, 6802, 32]), 7 + 4);
    assert_eq!(linked(&[77798603, 6801, 32]), 7 + 8);
    assert_eq!(linked(&[76688831, 2]), 5);
    assert_eq!(linked(&[76688831, 3]), 5 + 4);
    assert_eq!(linked(&[68827734, 1, 1]), 5 + 1 + 8);
    assert_eq!(linked(&[756833]), 6 + 4);
    // A constant and what was pushed are no registers.
    assert_eq!(linked(&[766800, 98]), 3);
    assert_eq!(linked(&[808372, 766899]), 2 + 2);
}

/// A coil before a new rung saves the byte of the rung, before an IF it saves none; a setting stands in no one's way.
#[test]
fn what_stands_before_a_code_may_save_a_byte() {
    let coil = [827301, 877901];
    let behind = |codes: &[i32]| linked(&[&coil, codes].concat()) - linked(&coil);
    assert_eq!(
        behind(&[787600]) + 1,
        linked(&[827301, 787600]) - linked(&[827301])
    );
    let (alone, block) = (linked(&[827301]), [7370, 697868]);
    assert_eq!(
        behind(&block),
        linked(&[&[827301], &block[..]].concat()) - alone
    );
    assert_eq!(linked(&[707305, 787600]) - linked(&[707305]), 0);
}

/// Contacts and rungs count as the linker links them, so both memories are full at about the same time.
#[test]
fn large_programs_fit_the_board() {
    let contacts = [787600, 827301, -827302, 827903, 827301, 877901];
    let timers = [787600, 827301, 847978, 100, 7901];
    let codes = [contacts.repeat(100), timers.repeat(32)].concat();
    assert_eq!(linked(&codes), 100 * 4 + 32 * 12);
}

#[test]
fn lines_are_counted_beyond_16_bits() {
    let text = "0\n".to_string() + &"\n".repeat(70_000) + "5\n";
    assert_eq!(faults(text.as_bytes()), [(24, Some(70_002))]);
    let text = "0\n".to_string() + &"\n".repeat(70_000) + "7370\n827301\n";
    assert_eq!(faults(text.as_bytes()), [(87, Some(70_002))]);
    let text = "0\n".to_string() + &"\n".repeat(65_000) + "40\n" + &"\n".repeat(5_000);
    assert_eq!(faults(text.as_bytes()), [(32, Some(65_002))]);
}

#[test]
fn fault_numbers_are_for_ever() {
    let numbers: Vec<u8> = Cause::ALL.iter().map(|cause| cause.number()).collect();
    assert_eq!(
        numbers,
        [
            11, 12, 13, 14, 15, 21, 22, 23, 24, 25, 26, 27, 28, 29, 31, 32, 33, 34, 35, 36, 37, 38,
            39, 41, 42, 43, 51, 52, 53, 54, 55, 56, 57, 61, 62, 63, 64, 65, 66, 71, 72, 73, 74, 75,
            81, 82, 83, 84, 85, 86, 87
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
