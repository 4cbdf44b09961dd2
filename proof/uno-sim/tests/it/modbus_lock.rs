//! What a hostile or forgotten client cannot do: what is locked, broadcasts, forces that nobody lets go, and writing
//! the settings until their cells are worn out.

use crate::common::modbus::{
    bits, exchange, input, serving, to_serving, with_crc, words, write, write_words,
};
use crate::common::{ms_until, place};
use crate::modbus_upload::upload;
use unoclp_modbus::Table;
use unoclp_modbus::eeprom::settings;
use unoclp_modbus::map::{ALL, Rights, Span, Width};
use unoclp_testing::cases;
use unoclp_uno_sim::{Slot, Uno};

/// Output 01 is input 01; output 02 is written by no rung. There are a timer, a counter, and all registers D.
const TEXT: &str = "0\n827301\n877901\n787600\n827302\n847978\n60000\n7703\n\
    787600\n827303\n67848501\n3\n877704\n787600\n766898\n838497\n";
const STOP: u16 = 2;
const RESTART: u16 = 4;
const UPLOAD: u16 = 5;
const LOCK: u16 = 414;
const ILLEGAL_FUNCTION: u8 = 1;

const LOCKED_UPLOAD: u16 = 1;
const LOCKED_SETTINGS: u16 = 2;
const LOCKED_COMMANDS: u16 = 4;
const LOCKED_WRITING: u16 = 8;

/// In STOP, with this lock, which has been kept: nothing was before.
fn locked(lock: u16) -> Uno {
    let mut uno = serving(TEXT);
    write(&mut uno, 400, STOP).unwrap();
    write(&mut uno, LOCK, lock).unwrap();
    uno.run_ms(10).unwrap();
    uno
}

/// The bit that refuses the writing of a span, by what stands there.
fn refused_by(span: &Span) -> u16 {
    match span.name {
        "command" => LOCKED_COMMANDS,
        "[settings](#settings)" => LOCKED_SETTINGS,
        "[upload](#upload)" => LOCKED_UPLOAD,
        _ => LOCKED_WRITING,
    }
}

/// Writes a value that is sound at this address of a span: alone, and by the function for several.
fn writes(span: &Span, address: u16, lock: u16) -> [Vec<u8>; 2] {
    let value = match address {
        400 => STOP,
        410 => 1,
        411 => 1152,
        LOCK => lock,
        _ => 0,
    };
    let [high, low] = address.to_be_bytes();
    let [more, less] = value.to_be_bytes();
    match span.table {
        Table::Coils => [vec![5, high, low, 0, 0], vec![15, high, low, 0, 1, 1, 0]],
        _ => [
            vec![6, high, low, more, less],
            vec![16, high, low, 0, 1, 2, more, less],
        ],
    }
}

/// What becomes of a request for this board: done, or the exception.
fn outcome(uno: &mut Uno, request: &[u8]) -> Result<(), u8> {
    let frame = with_crc(&[&[1], request].concat());
    let reply = exchange(uno, &frame, 5_000).expect("a reply");
    match reply[1] {
        function if function == request[0] => Ok(()),
        _ => Err(reply[2]),
    }
}

/// At both ends of every span of the map: with a lock that has its bit nothing is written, with any other
/// everything is as without a lock.
#[test]
fn a_lock_refuses_what_it_says_and_nothing_else() {
    let spans = || ALL.iter().filter(|span| span.rights != Rights::Read);
    let ask = |lock: u16| -> Vec<(String, u16, Result<(), u8>)> {
        let mut uno = locked(lock);
        let mut outcomes = Vec::new();
        for span in spans() {
            for address in [span.first, span.end() - 1] {
                for request in writes(span, address, lock) {
                    let told = outcome(&mut uno, &request);
                    let name = format!("{} {address}, function {}", span.name, request[0]);
                    outcomes.push((name, refused_by(span), told));
                }
            }
        }
        // All can be read.
        assert_eq!(words(&mut uno, 3, LOCK, 1), [lock]);
        let began = write(&mut uno, 400, UPLOAD);
        outcomes.push(("an upload".into(), LOCKED_UPLOAD, began));
        outcomes
    };
    let unlocked = ask(0);
    assert!(unlocked.len() > 50, "{unlocked:?}");
    assert!(unlocked.iter().all(|told| told.2 != Err(ILLEGAL_FUNCTION)));
    for lock in cases(1..16_u16) {
        for ((name, bit, told), (_, _, without)) in ask(lock).into_iter().zip(&unlocked) {
            let expected = match lock & bit {
                0 => *without,
                _ => Err(ILLEGAL_FUNCTION),
            };
            assert_eq!(told, expected, "{name}, lock {lock:04b}");
        }
    }
}

/// Whatever span they write: each is done, in its place.
#[test]
fn a_broadcast_writes_every_span_of_points() {
    let mut uno = locked(0);
    for span in ALL
        .iter()
        .filter(|span| span.rights != Rights::Read && refused_by(span) == LOCKED_WRITING)
    {
        // Of two words the low one.
        let address = match span.width {
            Width::Long => span.first + 1,
            _ => span.first,
        };
        let [high, low] = address.to_be_bytes();
        let function = match span.table {
            Table::Coils => 5,
            _ => 6,
        };
        let value = match function {
            5 => [0xFF, 0],
            _ => [0, 1],
        };
        let request = [[0, function, high, low], [value[0], value[1], 0, 0]].concat();
        assert_eq!(exchange(&mut uno, &with_crc(&request[..6]), 8), None);
        let written = match function {
            5 => bits(&mut uno, 1, address, 1).into(),
            _ => words(&mut uno, 3, address, 1)[0],
        };
        assert_eq!(written, 1, "{span:?}");
    }
}

#[test]
fn a_lock_grows_over_modbus_and_is_lifted_by_the_pins() {
    let mut uno = locked(LOCKED_UPLOAD);
    assert_eq!(write(&mut uno, LOCK, 0), Err(3));
    assert_eq!(write(&mut uno, LOCK, LOCKED_COMMANDS), Err(3));
    assert_eq!(write(&mut uno, LOCK, 16), Err(3));
    write(&mut uno, LOCK, LOCKED_UPLOAD | LOCKED_SETTINGS).unwrap();
    assert_eq!(write(&mut uno, LOCK, 15), Err(ILLEGAL_FUNCTION));
    write(&mut uno, 400, RESTART).unwrap();
    to_serving(&mut uno);
    assert_eq!(words(&mut uno, 3, LOCK, 1), [3]);
    uno.power_up();
    to_serving(&mut uno);
    write(&mut uno, 400, STOP).unwrap();
    assert_eq!(words(&mut uno, 3, LOCK, 1), [3]);
    assert_eq!(write(&mut uno, 400, UPLOAD), Err(ILLEGAL_FUNCTION));

    uno.set_stop(true);
    uno.set_inputs(0b1111);
    uno.reset();
    ms_until(&mut uno, &["STOP\r\n"]);
    uno.run_ms(5).unwrap();
    assert_eq!(words(&mut uno, 3, LOCK, 1), [0]);
    // Any of them that is written keeps all.
    write(&mut uno, 410, 1).unwrap();
    uno.set_stop(false);
    uno.reset();
    to_serving(&mut uno);
    assert_eq!(words(&mut uno, 3, LOCK, 1), [0]);
}

#[test]
fn a_broadcast_never_changes_settings_and_never_uploads() {
    let mut uno = locked(0);
    let before = uno.eeprom_writes().len();
    let mut all = vec![0, 16, 1, 0x9A, 0, 5, 10];
    all.extend([0, 9, 4, 0x80, 0, 0, 0, 0, 0, 15]);
    for broadcast in [
        vec![0, 6, 1, 0x9A, 0, 9],
        all,
        vec![0, 6, 1, 0x90, 0, 5],
        vec![0, 16, 1, 0x90, 0, 1, 2, 0, 5],
    ] {
        assert_eq!(exchange(&mut uno, &with_crc(&broadcast), 8), None);
        assert_eq!(words(&mut uno, 3, 410, 5), [1, 1152, 0, 0, 0]);
        assert_eq!(input(&mut uno, 17) >> 3 & 1, 0, "{broadcast:02x?}");
    }
    assert_eq!(uno.eeprom_writes()[before..], []);
    // Blocks neither: the next one of the client who uploads is still the first.
    write(&mut uno, 400, UPLOAD).unwrap();
    let block = [16, 3, 0xE8, 0, 2, 4, 0, 1, b'0', 0];
    assert_eq!(
        exchange(&mut uno, &with_crc(&[&[0], &block[..]].concat()), 8),
        None
    );
    assert_eq!(write_words(&mut uno, 1000, &[1 << 8 | 1, 0x3000]), Err(3));
    write_words(&mut uno, 1000, &[1, 0x3000]).unwrap();
    write(&mut uno, 400, STOP).unwrap();
}

/// Forces output 02 until so many seconds have passed without a request.
fn forced(seconds: u16) -> Uno {
    let mut uno = serving(TEXT);
    write_words(&mut uno, 404, &[2, 2, seconds]).unwrap();
    uno.run_ms(10).unwrap();
    assert_eq!(uno.outputs(), 2);
    uno
}

#[test]
fn a_force_ends_where_the_client_is_silent() {
    let mut uno = forced(2);
    for _ in 0..4 {
        uno.run_ms(1_500).unwrap();
        assert_eq!(uno.outputs(), 2);
        assert_eq!(words(&mut uno, 3, 404, 3), [2, 2, 2]);
    }
    uno.run_ms(1_900).unwrap();
    assert_eq!(uno.outputs(), 2);
    uno.run_ms(1_300).unwrap();
    assert_eq!(uno.outputs(), 0);
    assert_eq!(words(&mut uno, 3, 402, 5), [0, 0, 0, 0, 2]);
    // In STOP too.
    write_words(&mut uno, 402, &[1, 1]).unwrap();
    write(&mut uno, 400, STOP).unwrap();
    uno.run_ms(3_200).unwrap();
    assert_eq!(bits(&mut uno, 2, 0, 1), 0);
}

#[test]
fn a_force_stays_where_no_time_is_given() {
    let mut uno = forced(0);
    uno.run_ms(5_000).unwrap();
    assert_eq!(uno.outputs(), 2);
    assert_eq!(write(&mut uno, 406, 256), Err(3));
}

/// Sixteen at once, whatever starts again in between but the power; then one in 53 minutes.
#[test]
fn no_client_wears_the_settings_out() {
    let mut uno = locked(0);
    for n in 1..16_u16 {
        assert_eq!(write(&mut uno, 413, n % 2), Ok(()), "{n}");
        if n % 5 == 4 {
            write(&mut uno, 400, RESTART).unwrap();
            to_serving(&mut uno);
            write(&mut uno, 400, STOP).unwrap();
        }
    }
    assert_eq!(write(&mut uno, 413, 0), Err(6));
    uno.reset();
    to_serving(&mut uno);
    write(&mut uno, 400, STOP).unwrap();
    assert_eq!(write(&mut uno, 413, 0), Err(6));
    assert_eq!(words(&mut uno, 3, 410, 5), [1, 1152, 0, 1, 0]);
    let wear = uno.eeprom_wear();
    let cells = settings::OLD.into()..settings::END.into();
    assert!(wear[cells].iter().all(|&writes| writes <= 16), "{wear:?}");

    // What a minute gives is one part of 53.
    let used = uno.symbol("SETTINGS_USED").unwrap().address;
    assert_eq!(uno.read_ram(used, 2).unwrap(), (16 * 53_u16).to_le_bytes());
    uno.run_ms(61_000).unwrap();
    assert_eq!(
        uno.read_ram(used, 2).unwrap(),
        (16 * 53 - 1_u16).to_le_bytes()
    );
    uno.power_up();
    to_serving(&mut uno);
    write(&mut uno, 400, STOP).unwrap();
    write(&mut uno, 413, 0).unwrap();
}

/// Both slots of the settings, as they are kept.
fn slots(uno: &Uno) -> Vec<u8> {
    let bytes = settings::END - settings::FIRST;
    uno.read_eeprom(place(settings::FIRST), bytes.into())
        .unwrap()
}

/// Whichever bit of the two slots is turned over, the other slot counts, and mends it at the next start.
#[test]
fn no_flipped_bit_opens_the_lock() {
    // Kept for the first time, and over others.
    for locks in [&[LOCKED_WRITING][..], &[LOCKED_WRITING, 15]] {
        let mut uno = serving(TEXT);
        write(&mut uno, 400, STOP).unwrap();
        for lock in locks {
            write_words(&mut uno, 412, &[0, 1, *lock]).unwrap();
        }
        let lock = locks[locks.len() - 1];
        uno.run_ms(10).unwrap();
        let kept = slots(&uno);
        assert_eq!(kept.len(), 26);
        for bit in cases(0..kept.len() * 8) {
            let mut damaged = kept.clone();
            damaged[bit / 8] ^= 1 << (bit % 8);
            uno.write_eeprom(place(settings::FIRST), &damaged).unwrap();
            uno.power_up();
            to_serving(&mut uno);
            let told = words(&mut uno, 3, 410, 5);
            assert_eq!(told, [1, 1152, 0, 1, lock], "bit {bit}, {locks:?}");
            assert_eq!(write(&mut uno, 402, 0), Err(ILLEGAL_FUNCTION), "bit {bit}");
            assert_eq!(slots(&uno), kept, "bit {bit}, {locks:?}");
        }
    }
}

/// The firmware before this one kept them once: in one slot, while the other did not count.
#[test]
fn settings_that_stand_in_one_slot_are_kept_in_both_from_the_next_start_on() {
    let mut uno = locked(LOCKED_UPLOAD);
    let kept = slots(&uno);
    let (first, second) = kept.split_at(settings::SLOT_BYTES.into());
    let blank = vec![0xFF; first.len()];
    let mut other = second.to_vec();
    other[0] = settings::INVALID;
    for one in [
        [first, &blank],
        [first, &other],
        [&blank, second],
        [&other, second],
    ] {
        uno.write_eeprom(place(settings::FIRST), &one.concat())
            .unwrap();
        uno.power_up();
        to_serving(&mut uno);
        assert_eq!(words(&mut uno, 3, LOCK, 1), [LOCKED_UPLOAD]);
        assert_eq!(slots(&uno), kept);
    }
}

/// So many programs may be stored while the supply stays, each for 53: as many as are written.
#[test]
fn no_client_wears_the_mark_of_the_program_out() {
    const COST: u16 = 53;
    let mut uno = locked(0);
    let used = uno.symbol("PROGRAMS_USED").unwrap().address;
    let programs = |uno: &Uno| {
        let bytes = uno.read_ram(used, 2).unwrap();
        let used = u16::from_le_bytes([bytes[0], bytes[1]]);
        assert_eq!(used % COST, 0);
        used / COST
    };
    let texts = ["0\n877902\n", "0\n877903\n"];
    // The card's was the first.
    assert_eq!(programs(&uno), 1);
    upload(&mut uno, [texts[0]; 2], 100).unwrap();
    assert_eq!(programs(&uno), 2);
    // The same again is not written.
    upload(&mut uno, [texts[0]; 2], 100).unwrap();
    assert_eq!(programs(&uno), 2);

    uno.write_ram(used, &(1_199 * COST).to_le_bytes()).unwrap();
    let wear = uno.eeprom_wear()[0];
    upload(&mut uno, [texts[1]; 2], 100).unwrap();
    assert_eq!((programs(&uno), uno.eeprom_wear()[0]), (1_200, wear + 2));
    assert_eq!(write(&mut uno, 400, UPLOAD), Err(6));
    // Without a card, which would take its program's place; nothing else is refused, and no restart gives more.
    uno.swap_slot(Slot::Empty);
    for restart in [true, false] {
        if restart {
            write(&mut uno, 400, RESTART).unwrap();
        } else {
            uno.reset();
        }
        to_serving(&mut uno);
        write(&mut uno, 400, STOP).unwrap();
        assert_eq!(write(&mut uno, 400, UPLOAD), Err(6));
    }
    uno.power_up();
    to_serving(&mut uno);
    assert_eq!(programs(&uno), 0);
    write(&mut uno, 400, STOP).unwrap();
    upload(&mut uno, [texts[0]; 2], 100).unwrap();
    assert_eq!(programs(&uno), 1);
}
