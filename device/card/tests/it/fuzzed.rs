//! Whatever is damaged of what describes a volume: the walk ends soon, writes nothing, and gives the file
//! or an error.

use crate::common::small::{self, Small};
use crate::common::{Card, PROGRAM, Reader, walk};
use std::cell::RefCell;
use std::ops::Range;
use unoclp_card::File;
use unoclp_card::image::Fat;

thread_local! {
    static CARDS: RefCell<[Small; 4]> = RefCell::new([
        small::card(Fat::Fat16, false),
        small::card(Fat::Fat16, true),
        small::card(Fat::Fat32, false),
        small::card(Fat::Fat32, true),
    ]);
}

/// What holds of every damage; the target `card` of `proof/fuzz/` looks for one of which it does not. The first
/// byte chooses the card; of each three more, two choose a place and one is what stands there.
pub fn hold(bytes: &[u8]) {
    let Some((&which, damage)) = bytes.split_first() else {
        return;
    };
    CARDS.with_borrow_mut(|cards| {
        let Small { image, places } = &mut cards[usize::from(which % 4)];
        let mut undo = Vec::new();
        for patch in damage.chunks_exact(3) {
            let place = usize::from(u16::from_le_bytes([patch[0], patch[1]]));
            let at = nth(places, place);
            undo.push((at, image[at]));
            image[at] = patch[2];
        }
        walk_all(image);
        for (at, old) in undo.into_iter().rev() {
            image[at] = old;
        }
    });
}

/// The byte with this number of those in the places, counted round and round.
fn nth(places: &[Range<usize>], number: usize) -> usize {
    let all: usize = places.iter().map(Range::len).sum();
    let mut bytes = places.iter().cloned().flatten();
    bytes.nth(number % all).expect("there are places")
}

/// The file is read, and the place of its first block looked up.
fn walk_all(image: &[u8]) {
    let card = Card::new(image);
    let _ = walk(&card, PROGRAM);
    assert!(card.reads.get() <= small::most_reads(image));

    let card = Card::new(image);
    let mut reader = Reader::new(&card);
    let mut file = File::default();
    if file.open(&mut reader, PROGRAM.iter().copied()).is_ok() {
        let _ = file.first_block(&mut reader);
    }
    assert_eq!(card.writes.get(), 0);
    assert!(card.reads.get() <= small::most_reads(image));
}

#[test]
fn every_file_of_the_corpus() {
    unoclp_testing::each_of_corpus("card", hold);
}
