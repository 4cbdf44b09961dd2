//! Function 43/14, Read Device Identification.

use crate::common::answer;
use unoclp_modbus::{Access, Exception, Points, Table};

/// A device of nothing but texts.
struct Named([Vec<u8>; 3]);

impl Points for Named {
    fn has(&self, _: Table, _: u16, _: u16, _: Access) -> bool {
        panic!("nothing is read or written")
    }

    fn bit(&self, _: Table, _: u16) -> bool {
        panic!("nothing is read")
    }

    fn word(&self, _: Table, _: u16) -> u16 {
        panic!("nothing is read")
    }

    fn set_bit(&mut self, _: u16, _: bool) {
        panic!("nothing is written")
    }

    fn check_word(&self, _: u16, _: u16) -> Result<(), Exception> {
        panic!("nothing is written")
    }

    fn set_word(&mut self, _: u16, _: u16) {
        panic!("nothing is written")
    }

    fn identification(&self, object: u8, index: u8) -> Option<u8> {
        self.0[usize::from(object)].get(usize::from(index)).copied()
    }
}

fn ask(texts: [&str; 3], code: u8, object: u8) -> Vec<u8> {
    let mut device = Named(texts.map(|text| text.as_bytes().to_vec()));
    answer(&mut device, &[7, 43, 14, code, object]).unwrap()
}

/// A reply with these objects.
fn reply(code: u8, objects: &[(u8, &str)]) -> Vec<u8> {
    let mut reply = vec![7, 43, 14, code, 0x81, 0, 0, objects.len() as u8];
    for (object, text) in objects {
        reply.extend([*object, text.len() as u8]);
        reply.extend(text.bytes());
    }
    reply
}

const TEXTS: [&str; 3] = ["unoclp", "UNO", "0.1.0"];
const ALL: [(u8, &str); 3] = [(0, "unoclp"), (1, "UNO"), (2, "0.1.0")];

#[test]
fn a_stream_has_all_objects_from_the_one_asked_for() {
    for object in 0..3 {
        assert_eq!(ask(TEXTS, 1, object), reply(1, &ALL[object.into()..]));
    }
}

#[test]
fn a_stream_from_an_object_that_does_not_exist_starts_at_the_first() {
    for object in 3..=255 {
        assert_eq!(ask(TEXTS, 1, object), reply(1, &ALL));
    }
}

#[test]
fn regular_and_extended_identification_is_the_basic_one() {
    assert_eq!(ask(TEXTS, 2, 0), reply(2, &ALL));
    assert_eq!(ask(TEXTS, 3, 1), reply(3, &ALL[1..]));
}

#[test]
fn each_object_by_itself() {
    for object in 0..3 {
        let index = usize::from(object);
        assert_eq!(ask(TEXTS, 4, object), reply(4, &ALL[index..=index]));
    }
    for object in 3..=255 {
        assert_eq!(ask(TEXTS, 4, object), [7, 0xAB, 2]);
    }
}

#[test]
fn other_codes_are_refused_before_the_object_is_looked_at() {
    for code in (5..=255).chain([0]) {
        for object in [0, 2, 3, 255] {
            assert_eq!(ask(TEXTS, code, object), [7, 0xAB, 3]);
        }
    }
}

#[test]
fn other_mei_types_are_refused() {
    for mei in (0..=255).filter(|mei| *mei != 14) {
        for request in [
            &[7, 43, mei][..],
            &[7, 43, mei, 1, 0],
            &[7, 43, mei, 0, 0, 0],
        ] {
            let reply = answer(&mut Named(Default::default()), request);
            assert_eq!(reply.as_deref(), Some(&[7, 0xAB, 1][..]));
        }
    }
}

#[test]
fn the_longest_texts_fit_one_frame_and_longer_ones_are_cut() {
    let long = "x".repeat(300);
    let cut = &long[..80];
    for text in [cut, &long[..81], &long] {
        let expected = reply(1, &[(0, cut), (1, cut), (2, cut)]);
        assert_eq!(expected.len(), 254);
        assert_eq!(ask([text; 3], 1, 0), expected);
        assert_eq!(ask([text; 3], 4, 2), reply(4, &[(2, cut)]));
    }
    assert_eq!(ask([""; 3], 1, 0), reply(1, &[(0, ""), (1, ""), (2, "")]));
}
