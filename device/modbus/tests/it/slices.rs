//! An exchange in slices: the same reply whatever their size, none longer than allowed, no pair torn.

use crate::common::oracle::oracle;
use crate::common::recorder::{Call, Recorder};
use crate::common::{answer_scanning, request, write};
use unoclp_modbus::{Access, Exception, Points, Table};

/// Reads and writes of many lengths, from even and from odd addresses.
fn requests() -> Vec<Vec<u8>> {
    let mut requests = vec![];
    for first in [0x1000, 0xFF85] {
        for count in [1, 2, 3, 4, 5, 8, 9, 16, 17, 31, 64, 122, 123] {
            requests.extend([3, 4].map(|function| request(1, function, [first, count])));
            requests.push(write(1, 16, first, count));
            requests.push(write(0, 16, first, count));
        }
    }
    for first in [0x1000, 0x1001] {
        for count in [1, 2, 7, 8, 9, 15, 16, 17, 100, 1967, 1968] {
            requests.extend([1, 2].map(|function| request(1, function, [first, count])));
            requests.push(write(1, 15, first, count));
        }
        requests.push(request(1, 1, [first, 2000]));
        requests.push(request(1, 3, [first, 125]));
        requests.push(request(1, 5, [first, 0xFF00]));
        requests.push(request(1, 6, [first, 77]));
    }
    requests
}

/// The calls of each slice; the values of a write of words are checked before the first.
fn slices(request: &[u8], most: u8) -> Vec<Vec<Call>> {
    let mut device = Recorder::of(most);
    let reply = answer_scanning(&mut device, request, Recorder::scan);
    let (expected, writes) = oracle(request);
    assert_eq!(reply, expected, "{request:02x?}, {most}");
    assert_eq!(device.writes(), writes, "{request:02x?}, {most}");
    let calls = device.calls();
    let mut slices = calls.split(|call| *call == Call::Scan);
    let before = slices.next().unwrap_or_default();
    let set = count(&calls, |call| matches!(call, Call::SetWord(..)));
    assert!(before.iter().all(|call| matches!(call, Call::Check(_))));
    // Where one is refused, none is written.
    assert!([0, before.len()].contains(&set), "{request:02x?}");
    slices.map(<[Call]>::to_vec).collect()
}

fn count(calls: &[Call], which: fn(&Call) -> bool) -> usize {
    calls.iter().filter(|call| which(call)).count()
}

#[test]
fn slices_of_every_size_give_the_same_reply_and_none_is_longer() {
    for request in requests() {
        for most in 0..=255 {
            let bits = 32;
            let words = usize::from(most.max(2));
            for calls in slices(&request, most) {
                let of_bits = count(&calls, |call| {
                    matches!(call, Call::Bit(_) | Call::SetBit(..))
                });
                let reads = count(&calls, |call| matches!(call, Call::Word(_)));
                let writes = count(&calls, |call| matches!(call, Call::SetWord(..)));
                assert!(of_bits <= bits, "{request:02x?}, {most}");
                for number in [reads, writes] {
                    assert!(number <= words, "{request:02x?}, {most}");
                }
            }
        }
    }
}

#[test]
fn a_slice_does_as_much_as_it_may() {
    let slices_of = |request: &[u8], most| slices(request, most).len();
    assert_eq!(slices_of(&request(1, 3, [0x1000, 125]), 16), 8);
    assert_eq!(slices_of(&request(1, 3, [0x1000, 125]), 255), 1);
    assert_eq!(slices_of(&request(1, 3, [0x1000, 16]), 16), 1);
    // The first ends before an even address.
    assert_eq!(slices_of(&request(1, 3, [0x1001, 16]), 16), 2);
    assert_eq!(slices_of(&request(1, 3, [0x1001, 15]), 16), 1);
    assert_eq!(slices_of(&request(1, 1, [0x1001, 2000]), 10), 63);
    assert_eq!(slices_of(&write(1, 15, 0x1001, 1968), 10), 62);
    assert_eq!(slices_of(&write(1, 16, 0x1000, 20), 10), 2);
}

#[test]
fn no_value_of_two_words_is_torn() {
    let address = |call: &Call| match *call {
        Call::Word(address) | Call::SetWord(address, _) => Some(address),
        _ => None,
    };
    for request in requests() {
        for most in (0..=20).chain([61, 62, 63, 122, 123, 124, 255]) {
            let slices = slices(&request, most);
            let addresses: Vec<Vec<u16>> = slices
                .iter()
                .map(|calls| calls.iter().filter_map(address).collect())
                .filter(|addresses: &Vec<u16>| !addresses.is_empty())
                .collect();
            for pair in addresses.windows(2) {
                let [last, next] = [pair[0].last(), pair[1].first()].map(Option::unwrap);
                assert_eq!(last + 1, *next);
                assert!(next.is_multiple_of(2), "{request:02x?}, {most}: {next:#x}");
            }
        }
    }
}

#[test]
fn what_fits_one_slice_is_written_in_one() {
    for words in [1, 2, 10] {
        let slices = slices(&write(1, 16, 0x1000, words), 10);
        assert_eq!(slices.len(), 1);
        assert_eq!(slices[0].len(), usize::from(words));
    }
}

/// Has every address; counts the words that are set, and is told once when all is written.
#[derive(Default)]
struct Told {
    set: u16,
    told: Vec<u16>,
    /// How many words are done at once.
    most: u8,
}

impl Points for Told {
    fn has(&self, _: Table, _: u16, _: u16, _: Access) -> bool {
        true
    }
    fn bit(&self, _: Table, _: u16) -> bool {
        false
    }
    fn word(&self, _: Table, _: u16) -> u16 {
        0
    }
    fn set_bit(&mut self, _: u16, _: bool) {}
    fn check_word(&self, _: u16, value: u16) -> Result<(), Exception> {
        match value {
            0xFFFF => Err(Exception::IllegalDataValue),
            _ => Ok(()),
        }
    }
    fn set_word(&mut self, _: u16, _: u16) {
        self.set += 1;
    }
    fn at_once(&self) -> u8 {
        self.most
    }
    fn is_written(&mut self) {
        self.told.push(self.set);
    }
    fn identification(&self, _: u8, _: u8) -> Option<u8> {
        None
    }
}

#[test]
fn the_end_of_a_write_is_told_once() {
    for most in [0, 3, 255] {
        let told = |request: &[u8]| {
            let mut device = Told {
                most,
                ..Told::default()
            };
            answer_scanning(&mut device, request, |_| ());
            device.told
        };
        for count in [1, 2, 50, 123] {
            assert_eq!(told(&write(1, 16, 0, count)), [count]);
            assert_eq!(told(&write(0, 16, 0, count)), [count]);
        }
        assert_eq!(told(&request(1, 6, [3, 4])), [1]);
        for bits in [write(1, 15, 0, 9), request(1, 5, [3, 0xFF00])] {
            assert_eq!(told(&bits), [0], "{bits:02x?}");
        }
        // A refusal, a reading.
        for none in [request(1, 6, [3, 0xFFFF]), request(1, 3, [3, 4])] {
            assert_eq!(told(&none), [0; 0], "{none:02x?}");
        }
    }
}
