//! Where a file's first block may be overwritten in place: that block, and no other.

use crate::common::raw::{FILE, FOLDER, Raw};
use crate::common::{Card, NoBlock, Reader, bytes};
use unoclp_card::image::{Fat, Image};
use unoclp_card::{Error, File};

const BOTH: [Fat; 2] = [Fat::Fat16, Fat::Fat32];
const STATE: &[u8; 11] = b"STATE   TXT";
const READ_ONLY: u8 = 0x01;

fn first_block(image: &[u8]) -> Result<Option<usize>, Error<NoBlock>> {
    let card = Card::new(image);
    let mut reader = Reader::new(&card);
    let mut file = File::default();
    file.open(&mut reader, STATE.iter().copied())?;
    let place = file.first_block(&mut reader)?;
    assert_eq!(card.writes.get(), 0);
    Ok(place.map(|place| place as usize))
}

#[test]
fn it_is_where_the_file_begins() {
    let mut cases = 0;
    for fat in BOTH {
        for (cluster_blocks, size) in [(1, 512), (1, 513), (2, 512), (8, 5000), (1, 100_000)] {
            let contents = bytes(size);
            let image = Image::new(fat)
                .cluster_blocks(cluster_blocks)
                .file("PROGRAM.TXT", "0\n")
                .file("STATE.TXT", &*contents)
                .file("OTHER.TXT", vec![b'x'; 3000]);
            for image in [image.clone(), image.bare()] {
                let image = image.build().unwrap();
                let place = first_block(&image).unwrap().expect("a place");
                assert_eq!(image[place * 512..][..512], contents[..512]);
                cases += 1;
            }
        }
    }
    println!("{cases} volumes");
}

#[test]
fn not_where_it_is_short_or_read_only() {
    for fat in BOTH {
        for size in [0, 1, 511] {
            let image = Image::new(fat).file("STATE.TXT", bytes(size));
            assert_eq!(first_block(&image.build().unwrap()), Ok(None), "{size} B");
        }
        let mut raw = Raw::new(fat);
        raw.chain(&[10]);
        raw.follow(10, 0x0FFF_FFFF);
        raw.entry(raw.root(), STATE, FILE | READ_ONLY, 10, 512);
        assert_eq!(first_block(&raw.image), Ok(None));
        raw.entry(raw.root(), STATE, FOLDER, 10, 512);
        assert_eq!(first_block(&raw.image), Err(Error::NotFound));
        raw.entry(raw.root(), STATE, FILE, 10, 512);
        assert!(matches!(first_block(&raw.image), Ok(Some(_))));
    }
}

#[test]
fn not_where_the_fat_does_not_hold_the_cluster_for_taken() {
    for fat in BOTH {
        let mut raw = Raw::new(fat);
        raw.entry(raw.root(), STATE, FILE, 10, 512);
        for (next, taken) in [
            (0, false),
            (1, false),
            (0x0FFF_FFF7, false),
            (raw.last_cluster() + 1, false),
            (raw.last_cluster(), true),
            (2, true),
            (0x0FFF_FFF8, true),
            (0x0FFF_FFFF, true),
        ] {
            raw.follow(10, next);
            let place = first_block(&raw.image);
            if taken {
                assert!(matches!(place, Ok(Some(_))), "{fat:?} {next:#x}: {place:?}");
            } else {
                assert_eq!(place, Err(Error::Damaged), "{fat:?} {next:#x}");
            }
        }
        for first in [0, 1, raw.last_cluster() + 1] {
            raw.entry(raw.root(), STATE, FILE, first, 512);
            assert_eq!(first_block(&raw.image), Err(Error::Damaged), "{first}");
        }
    }
}
