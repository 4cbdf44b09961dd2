//! What codes of two digits name beyond the points of a board, on a PC (NC-29).

use unoclp_core::isa::{Opcode, TABLE};
use unoclp_core::{Board, Cause, Image, Inputs, Loader, Plc, Program, Target};

fn loaded<'m>(text: &str, memory: &'m mut [u8], board: Board) -> Result<Program<'m>, Cause> {
    let mut loader = Loader::new(memory, board);
    let mut first = Ok(());
    for byte in text.bytes() {
        first = first.and(loader.push(byte));
    }
    let program = loader.finish().map_err(|fault| fault.cause)?;
    first.map_err(|fault| fault.cause)?;
    Ok(program)
}

#[test]
fn each_board_is_found_by_its_name() {
    for board in Board::ALL {
        assert_eq!(Board::named(board.id()), Some(board));
        assert_eq!(board.id(), board.name.to_ascii_lowercase());
    }
    assert_eq!(Board::named("leonardo"), None);
}

/// Points 01 to 16 stay in one byte. The others take two, of which the first stores none of a board's instructions.
#[test]
fn a_far_point_is_stored_in_two_bytes() {
    let memory = &mut vec![0; Board::PC.plc_bytes()];
    let text = "0\n827316\n-827317\n827999\n-827917\n877916\n877917\n83877918\n82877999\n";
    let program = loaded(text, memory, Board::PC).unwrap();
    let stored = [
        0x1F, 0x89, 17, 0x8A, 99, 0x8B, 17, 0x5F, 0x8C, 17, 0x8D, 18, 0x8E, 99,
    ];
    assert_eq!(program.stored(), stored);
    let numbers: Vec<_> = program.steps().map(|step| step.number()).collect();
    assert_eq!(numbers, [16, 17, 99, 17, 16, 17, 18, 99].map(Some));
    let memory = &mut vec![0; Board::PC.plc_bytes()];
    let mut loader = Loader::new(memory, Board::PC);
    loader.restore(&mut stored.into_iter()).unwrap();
    assert_eq!(loader.finish().unwrap().stored(), stored);
}

/// On a board, and where a point has a byte of its own, they mean what they always did: a branch point that no rung has.
#[test]
fn the_bytes_of_far_points_are_branch_points_elsewhere() {
    for first in 0x88..=0x8E {
        for (board, xx) in [(Board::UNO, 17), (Board::UNO, 1), (Board::PC, 16)] {
            let memory = &mut vec![0; board.plc_bytes()];
            let mut loader = Loader::new(memory, board);
            let fault = loader.restore(&mut [first, xx].into_iter()).unwrap_err();
            assert_eq!(fault.cause, Cause::NoSuchBranchPoint, "{first:x} {xx}");
        }
    }
}

#[test]
fn a_timer_drives_each_output_and_each_marker() {
    for (base, most) in [(7900, Board::PC.outputs), (7700, Board::PC.markers)] {
        for number in 1..=most {
            let memory = &mut vec![0; Board::PC.plc_bytes()];
            let text = format!("0\n847978\n100\n{}\n", base + i32::from(number));
            let program = loaded(&text, memory, Board::PC).unwrap();
            let target = program
                .steps()
                .find_map(|step| step.timer())
                .unwrap()
                .target;
            let wanted = match base {
                7900 => Target::Output(number),
                _ => Target::Marker(number),
            };
            assert_eq!(target, wanted);
            let stored = program.stored().to_vec();
            let memory = &mut vec![0; Board::PC.plc_bytes()];
            let mut loader = Loader::new(memory, Board::PC);
            loader.restore(&mut stored.iter().copied()).unwrap();
            assert_eq!(loader.finish().unwrap().stored(), stored);
        }
        let memory = &mut vec![0; Board::PC.plc_bytes()];
        let none = loaded(&format!("0\n847978\n100\n{base}\n"), memory, Board::PC);
        assert!(matches!(
            none,
            Err(Cause::NoSuchOutput | Cause::NoSuchPoint)
        ));
    }
    for board in [Board::UNO, Board::PC] {
        let memory = &mut vec![0; board.plc_bytes()];
        let refused = loaded("0\n847978\n100\n7900\n", memory, board);
        assert_eq!(refused.unwrap_err(), Cause::NoSuchOutput);
    }
    let memory = &mut vec![0; Board::UNO.plc_bytes()];
    let refused = loaded("0\n847978\n100\n7999\n", memory, Board::UNO);
    assert_eq!(refused.unwrap_err(), Cause::NoSuchOutput);
}

/// Each number of each instruction is a program on a PC, and none beyond.
#[test]
fn each_point_that_a_code_names_is_there() {
    for row in TABLE {
        let Some((first, last)) = Board::PC.numbers(row.kind) else {
            continue;
        };
        if row.kind.first_line(1).is_some()
            || matches!(row.class, unoclp_core::isa::Class::RecallPoint)
        {
            continue;
        }
        for xx in 0..100 {
            let code = row.code + row.code.signum() * i32::from(xx);
            let mut text = format!("0\n{code}\n");
            if row.kind.is_value() && xx == 0 {
                text.push_str("7\n");
            }
            let memory = &mut vec![0; Board::PC.plc_bytes()];
            let found = loaded(&text, memory, Board::PC).err();
            let number_is_wrong = matches!(
                found,
                Some(
                    Cause::NoSuchInput
                        | Cause::NoSuchOutput
                        | Cause::NoSuchPoint
                        | Cause::NoSuchBranchPoint
                )
            );
            let is_there = (first..=last).contains(&xx);
            if !matches!(row.kind, unoclp_core::isa::Kind::TimerQ) {
                assert_eq!(number_is_wrong, !is_there, "{code}: {found:?}");
            }
        }
    }
}

/// Each input drives the output and the marker of its number.
#[test]
fn each_point_has_a_state_of_its_own() {
    let rung = |n: u8| format!("787600\n8273{n:02}\n8779{n:02}\n8777{n:02}\n");
    let text: String = (1..=99).map(rung).collect();
    let memory = &mut vec![0; Board::PC.plc_bytes()];
    let mut plc = Plc::new(loaded(&format!("0\n{text}"), memory, Board::PC).unwrap());
    for input in 0..99 {
        let outputs = plc.scan(Image(1 << input), 0).unwrap();
        assert_eq!(outputs, Image(1 << input));
        assert_eq!(plc.markers(), 1 << input);
    }
}

/// A program that fills what a PC has, and one line more.
#[test]
fn a_program_has_32_kb() {
    let full = "0\n".to_owned() + &"827317\n".repeat(16 * 1024);
    let memory = &mut vec![0; Board::PC.plc_bytes()];
    let program = loaded(&full, memory, Board::PC).unwrap();
    assert_eq!(program.stored_bytes(), 32 * 1024);
    let memory = &mut vec![0; Board::PC.plc_bytes()];
    let more = loaded(&(full + "827301\n"), memory, Board::PC);
    assert_eq!(more.unwrap_err(), Cause::ProgramFull);
}

#[test]
fn analogue_inputs_and_pwm_are_there_beside_each_input() {
    let text = "0\n827399\n766598\n838799\n";
    let read = TABLE
        .iter()
        .find(|row| row.stored == Opcode::LoadAnalogue as u8);
    let write = TABLE
        .iter()
        .find(|row| row.stored == Opcode::StorePwm as u8);
    let text = text
        .replace("766598", &(read.unwrap().code + 98).to_string())
        .replace("838799", &(write.unwrap().code + 99).to_string());
    let memory = &mut vec![0; Board::PC.plc_bytes()];
    let mut plc = Plc::new(loaded(&text, memory, Board::PC).unwrap());
    let mut readings = [0; 99];
    readings[98] = 200;
    let inputs = Inputs::from(Image(1 << 98)).reading(&readings);
    plc.scan(inputs, 0).unwrap();
    assert_eq!(plc.pwm(99), 200);
}
