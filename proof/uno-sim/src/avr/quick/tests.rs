//! Each quick opcode against simavr.

use super::kind::{KINDS, Kind};
use super::{Avr, Far};
use crate::avr::reg;
use crate::chip::FLASH_LEN;
use simavr_ffi as ffi;
use unoclp_testing::Random;

const SPMCSR: usize = reg::SPMCSR as usize;
const SP: usize = reg::SP as usize;
const SREG: usize = 95;
/// What may stand after a skip, one word and each of two, and places in RAM.
const NEXT: [u16; 10] = [
    0x0000, 0x0123, 0x0456, 0x9000, 0x91F0, 0x9200, 0x940E, 0x95FF, 0x940C, 0x9408,
];

/// Registers, flags, RAM and flash as they are told; cycle 1,000 of a chip that runs.
fn set(avr: &mut Avr, data: &[u8], flags: [u8; 8], pc: u32, words: [u16; 2]) {
    avr.data_mut().copy_from_slice(data);
    let at = pc as usize;
    avr.flash_mut()[at..at + 2].copy_from_slice(&words[0].to_le_bytes());
    avr.flash_mut()[at + 2..at + 4].copy_from_slice(&words[1].to_le_bytes());
    // SAFETY: the chip is alive, and nobody else has it.
    let chip = unsafe { &mut *avr.as_ptr().as_ptr() };
    (chip.sreg, chip.pc, chip.cycle) = (flags, pc, 1_000);
    chip.state = ffi::cpu_Running as i32;
    // Nothing is due.
    chip.cycle_timers.timer = std::ptr::null_mut();
    chip.interrupt_state = 0;
}

fn flags(avr: &Avr) -> [u8; 8] {
    // SAFETY: as above.
    unsafe { (*avr.as_ptr().as_ptr()).sreg }
}

#[test]
fn each_quick_opcode_does_what_simavr_does() {
    let mut random = Random(0x5EED);
    let [mut ours, mut theirs] = [(); 2].map(|()| Avr::new(FLASH_LEN).unwrap());
    let mut compared = [0; 256];
    for opcode in 0..=u16::MAX {
        let kind = KINDS[usize::from(opcode)];
        // Jumps and returns have few opcodes.
        let rounds = if opcode >> 9 == 0x4A { 30 } else { 3 };
        for round in (0..rounds).map(|round| round % 3) {
            let mut data: Vec<u8> = (0..0x900).map(|_| random.bits() as u8).collect();
            // Pointers to RAM and a flash that is only read, but for one round; numbers that carry and overflow in another.
            if round < 2 {
                data[SPMCSR] = 0;
                for high in [27, 29, 31] {
                    data[high] = 1 + random.below(7) as u8;
                }
            }
            if round == 1 {
                data[..26].fill_with(|| random.pick(&[0, 1, 0x7F, 0x80, 0xFF]));
            }
            data[SP + 1] = 1 + random.below(7) as u8;
            let bits = random.bits();
            let mut before: [u8; 8] = std::array::from_fn(|bit| (bits >> bit & 1) as u8);
            // No interrupt comes.
            before[7] = 0;
            let pc = 2 * (2_000 + random.below(4_000)) as u32;
            let words = [opcode, random.pick(&NEXT)];
            set(&mut ours, &data, before, pc, words);
            let far = Far {
                end: 1_001,
                stop: None,
                code_end: FLASH_LEN as u32,
            };
            let low = ours.run_quickly(far);
            let text = format!("{opcode:04X} {:04X}, round {round}", words[1]);
            if low.is_none() {
                assert!(ours.data() == data, "{text}");
                assert_eq!((flags(&ours), ours.pc()), (before, pc), "{text}");
                continue;
            }
            assert_ne!(kind, Kind::Slow);
            set(&mut theirs, &data, before, pc, words);
            theirs.step();
            assert_eq!(
                (ours.pc(), ours.cycle()),
                (theirs.pc(), theirs.cycle()),
                "{text}"
            );
            assert_eq!(flags(&ours), flags(&theirs), "{text}");
            let [mut here, mut there] = [&ours, &theirs].map(|avr| avr.data().to_vec());
            // simavr puts SREG together when it is read.
            here[SREG] = 0;
            there[SREG] = 0;
            let unlike = |at: &usize| here[*at] != there[*at];
            let unlike: Vec<_> = (0..here.len()).filter(unlike).collect();
            assert_eq!(unlike, [0; 0], "{text}");
            let sp = |data: &[u8]| u16::from_le_bytes([data[SP], data[SP + 1]]);
            let deeper = sp(&here) < sp(&data);
            assert_eq!(
                low,
                Some(if deeper { sp(&here) } else { u16::MAX }),
                "{text}"
            );
            compared[kind as usize] += 1;
        }
    }
    for kind in KINDS.iter().filter(|&&kind| kind != Kind::Slow) {
        assert!(compared[*kind as usize] > 0, "{kind:?} was never quick");
    }
}

/// `inc r16`, `rjmp` to it: three cycles a round.
fn counting() -> Avr {
    let mut avr = Avr::new(FLASH_LEN).unwrap();
    set(&mut avr, &[0; 0x900], [0; 8], 0x100, [0x9503, 0xCFFE]);
    avr
}

#[test]
fn it_ends_at_the_cycle_at_the_address_and_at_the_end_of_the_program() {
    let far = Far {
        end: 1_031,
        stop: None,
        code_end: 0x200,
    };
    let ended = |far| {
        let mut avr = counting();
        let low = avr.run_quickly(far);
        (low.is_some(), avr.pc(), avr.cycle())
    };
    assert_eq!(ended(far), (true, 0x102, 1_031));
    let stop = Some(0x100);
    assert_eq!(ended(Far { stop, ..far }), (true, 0x100, 1_003));
    assert_eq!(
        ended(Far {
            code_end: 0x104,
            ..far
        }),
        (false, 0x100, 1_000)
    );
    assert_eq!(ended(Far { end: 1_000, ..far }), (false, 0x100, 1_000));
}
