//! The linked form takes the place of the stored form, and never more.

use unoclp_core::{Linking, Loader, Profile};

/// The codes of seven stored bytes: a contact, and a timer block with its six.
const TEXT: &str = "0\n827301\n847978\n70000\n7902\n";
const STORED: [u8; 7] = [0x10, 0x04, 0x70, 0x11, 0x01, 0x00, 0x01];

fn with_linking(memory: &mut [u8], test: impl FnOnce(Linking<'_>)) {
    let mut loader = Loader::new(memory, Profile::UNO);
    TEXT.bytes().for_each(|byte| loader.push(byte).unwrap());
    test(loader.finish().unwrap().link());
}

#[test]
fn it_gives_the_stored_form() {
    with_linking(&mut [0; 20], |linking| {
        assert_eq!(linking.collect::<Vec<_>>(), STORED);
    });
}

#[test]
fn what_has_been_read_may_be_replaced_byte_by_byte() {
    with_linking(&mut [0; 20], |mut linking| {
        while let Some(byte) = linking.next() {
            linking.put(!byte);
        }
        let (code, rest) = linking.finish().unwrap();
        assert_eq!(code, STORED.map(|byte| !byte));
        assert_eq!(rest.len(), 13);
    });
}

#[test]
fn what_is_left_out_makes_room() {
    with_linking(&mut [0; 20], |mut linking| {
        assert_eq!(linking.by_ref().take(3).last(), Some(0x70));
        [1, 2, 3].into_iter().for_each(|byte| linking.put(byte));
        // Nothing unread has been touched.
        assert_eq!(linking.next(), Some(0x11));
        let (code, rest) = linking.finish().unwrap();
        assert_eq!(code, [1, 2, 3]);
        assert_eq!(rest.len(), 17);
    });
}

#[test]
fn what_has_not_been_read_is_never_overwritten() {
    for read in 0..STORED.len() {
        with_linking(&mut [0; 20], |mut linking| {
            assert_eq!(linking.by_ref().take(read).count(), read);
            (0..=read).for_each(|_| linking.put(0xEE));
            assert!(linking.by_ref().eq(STORED[read..].iter().copied()));
            assert_eq!(linking.finish(), None);
        });
    }
}

#[test]
fn behind_the_last_byte_it_may_grow_to_the_end_of_memory() {
    // The timer's data takes 5 bytes of these.
    const MEMORY: usize = 12;
    for (written, fits) in [(8, true), (MEMORY, true), (MEMORY + 1, false)] {
        with_linking(&mut [0; MEMORY], |mut linking| {
            assert_eq!(linking.by_ref().count(), STORED.len());
            (0..written).for_each(|_| linking.put(0xEE));
            let parts = linking.finish();
            assert_eq!(parts.is_some(), fits, "{written}");
            if let Some((code, rest)) = parts {
                assert_eq!((code.len(), rest.len()), (written, MEMORY - written));
            }
        });
    }
}
