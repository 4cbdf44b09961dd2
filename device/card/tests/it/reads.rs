//! What the walk reads is what was put in, and what embedded-sdmmc's volume manager reads: FAT16
//! and FAT32, with a partition table and without, over layouts and sizes.

use crate::common;
use crate::common::{Card, bytes, reference, walk};
use unoclp_card::image::{Fat, Image};

const BLOCK: usize = 512;

/// Puts a file on a card with what surrounds it.
type Layout = fn(Image, &str, Vec<u8>) -> Image;

const LAYOUTS: &[(&str, Layout)] = &[
    ("in the first clusters", |image, name, bytes| {
        image.file(name, bytes)
    }),
    ("behind other files", |image, name, bytes| {
        image
            .file("FIRST.TXT", vec![b'1'; 3 * BLOCK])
            .file("SECOND.TXT", vec![b'2'; 70_000])
            .file(name, bytes)
    }),
    ("fragmented", |image, name, bytes| {
        image.fragmented_file(name, bytes)
    }),
    (
        "in a root folder of several clusters",
        |image, name, bytes| {
            (0..100)
                .fold(image, |image, n| image.file(format!("FILE{n}.TXT"), "x"))
                .file(name, bytes)
        },
    ),
    ("behind a deleted file", |image, name, bytes| {
        // Deleted, its first letter is gone: the rest is that of PROGRAM.TXT.
        image
            .deleted_file("QROGRAM.TXT", vec![b'!'; 2 * BLOCK])
            .file(name, bytes)
    }),
    ("behind long names", |image, name, bytes| {
        image
            .file("PROGRAM.TXT.TXT", "not this one")
            .file("Program of the second week, revised.txt", "nor this")
            .file(name, bytes)
    }),
    ("with a name in small letters", |image, name, bytes| {
        image.file(name.to_lowercase(), bytes)
    }),
    ("in clusters of two blocks", |image, name, bytes| {
        image.cluster_blocks(2).fragmented_file(name, bytes)
    }),
];

const SIZES: &[usize] = &[
    0,
    1,
    BLOCK - 1,
    BLOCK,
    BLOCK + 1,
    2 * BLOCK,
    2 * BLOCK + 1,
    7 * BLOCK + 100,
    // More clusters than one block of a FAT has entries for.
    300 * BLOCK,
];

fn check(fat: Fat, bare: bool, layouts: &[(&str, Layout)]) {
    for (layout, put) in layouts {
        for &size in SIZES {
            let case = format!("{fat:?}, bare {bare}, {layout}, {size} bytes");
            let image = Image::new(fat);
            let image = if bare { image.bare() } else { image };
            let put_in = bytes(size);
            let image = put(image, "PROGRAM.TXT", put_in.clone())
                .build()
                .unwrap_or_else(|error| panic!("{case}: {error}"));

            let card = Card::new(&image);
            let read = walk(&card, common::PROGRAM).unwrap_or_else(|e| panic!("{case}: {e}"));
            assert!(read == put_in, "{case}");
            assert!(reference(&image, bare, "PROGRAM.TXT") == put_in, "{case}");
        }
    }
}

#[test]
fn fat16_in_a_partition() {
    check(Fat::Fat16, false, LAYOUTS);
}

#[test]
fn fat16_bare() {
    check(Fat::Fat16, true, LAYOUTS);
}

#[test]
fn fat32_in_a_partition() {
    check(Fat::Fat32, false, LAYOUTS);
}

#[test]
fn fat32_bare() {
    check(Fat::Fat32, true, LAYOUTS);
}

/// The largest clusters, and a FAT16 volume of more than 65,535 blocks.
#[test]
fn large_clusters() {
    for blocks in [4, 16, 64] {
        let put_in = bytes(3 * usize::from(blocks) * BLOCK + 1);
        let image = Image::new(Fat::Fat16)
            .cluster_blocks(blocks)
            .fragmented_file("PROGRAM.TXT", put_in.clone())
            .build()
            .unwrap();
        let read = walk(&Card::new(&image), common::PROGRAM);
        assert!(read == Ok(put_in.clone()), "{blocks} blocks");
        let reference = reference(&image, false, "PROGRAM.TXT");
        assert!(reference == put_in, "{blocks} blocks");
    }
}

/// Every file of a card is found by its own name, in either case.
#[test]
fn files_are_told_apart() {
    let image = Image::new(Fat::Fat16)
        .file("PROGRAM.TXT", "program")
        .file("PROGRAM.TX", "tx")
        .file("PROGRA.TXT", "progra")
        .file("A", "a")
        .build()
        .unwrap();
    for (name, content) in [
        (b"PROGRAM TXT", "program"),
        (b"PROGRAM TX ", "tx"),
        (b"PROGRA  TXT", "progra"),
        (b"A          ", "a"),
    ] {
        let read = walk(&Card::new(&image), name);
        assert_eq!(read, Ok(content.into()));
    }
}
