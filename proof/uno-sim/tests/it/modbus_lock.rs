//! What a hostile or forgotten client cannot do: what is locked, broadcasts, forces that nobody lets go, and writing
//! the settings until their cells are worn out.

use crate::common::modbus::{
    ask, bits, exchange, input, serving, to_serving, with_crc, words, write, write_coil,
    write_words,
};
use crate::common::ms_until;
use unoclp_modbus::eeprom::settings;
use unoclp_testing::cases;
use unoclp_uno_sim::Uno;

/// Output 01 is input 01; output 02 is written by no rung.
const TEXT: &str = "0\n827301\n877901\n";
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

type Request = fn(&mut Uno) -> Result<(), u8>;

/// Requests, the lock that each falls under, and what it is answered without.
const REQUESTS: [(&str, u16, Request, Result<(), u8>); 11] = [
    (
        "a coil",
        LOCKED_WRITING,
        |uno| write_coil(uno, 1, true),
        Ok(()),
    ),
    ("coils", LOCKED_WRITING, |uno| many_coils(uno), Ok(())),
    ("a register", LOCKED_WRITING, |uno| write(uno, 1, 7), Ok(())),
    (
        "registers",
        LOCKED_WRITING,
        |uno| write_words(uno, 0, &[0, 7]),
        Ok(()),
    ),
    ("a force", LOCKED_WRITING, |uno| write(uno, 402, 0), Ok(())),
    (
        "forces",
        LOCKED_WRITING,
        |uno| write_words(uno, 402, &[0; 5]),
        Ok(()),
    ),
    (
        "a setting",
        LOCKED_SETTINGS,
        |uno| write(uno, 410, 1),
        Ok(()),
    ),
    (
        "a command",
        LOCKED_COMMANDS,
        |uno| write(uno, 400, STOP),
        Ok(()),
    ),
    (
        "a command in a row",
        LOCKED_COMMANDS,
        |uno| write_words(uno, 400, &[STOP]),
        Ok(()),
    ),
    // No upload is under way.
    (
        "a block",
        LOCKED_UPLOAD,
        |uno| write_words(uno, 1000, &[0, 0]),
        Err(4),
    ),
    (
        "an upload",
        LOCKED_UPLOAD,
        |uno| write_words(uno, 400, &[UPLOAD]),
        Ok(()),
    ),
];

fn many_coils(uno: &mut Uno) -> Result<(), u8> {
    let reply = ask(uno, &[1, 15, 0, 16, 0, 3, 1, 5]).expect("a reply");
    if reply[1] == 15 {
        Ok(())
    } else {
        Err(reply[2])
    }
}

#[test]
fn a_lock_refuses_what_it_says_and_nothing_else() {
    for lock in cases(0..16_u16) {
        let mut uno = locked(lock);
        for (name, bit, request, otherwise) in REQUESTS {
            let outcome = request(&mut uno);
            let expected = if lock & bit != 0 {
                Err(ILLEGAL_FUNCTION)
            } else {
                otherwise
            };
            assert_eq!(outcome, expected, "{name}, lock {lock:04b}");
        }
        // All can be read.
        assert_eq!(words(&mut uno, 3, LOCK, 1), [lock]);
        let uploading = input(&mut uno, 17) >> 3 & 1 != 0;
        assert_eq!(uploading, lock & LOCKED_UPLOAD == 0);
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
    // All else is done.
    assert_eq!(
        exchange(&mut uno, &with_crc(&[0, 5, 0, 16, 0xFF, 0]), 8),
        None
    );
    assert_eq!(bits(&mut uno, 1, 16, 1), 1);
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

/// Sixteen at once, whatever starts anew in between but the power; then one in 53 minutes.
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
    assert!(wear[cells].iter().all(|&writes| writes <= 17), "{wear:?}");

    // What a minute gives is one part of 53.
    let left = uno.symbol("SETTINGS_LEFT").unwrap().address;
    assert_eq!(uno.read_ram(left, 2).unwrap(), [0, 0]);
    uno.run_ms(61_000).unwrap();
    assert_eq!(uno.read_ram(left, 2).unwrap(), [1, 0]);
    uno.power_up();
    to_serving(&mut uno);
    write(&mut uno, 400, STOP).unwrap();
    write(&mut uno, 413, 0).unwrap();
}
