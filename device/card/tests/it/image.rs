//! Card images are what their builder says.

use unoclp_card::image::{Fat, Image, PARTITION_START, UNIT};

const BLOCK: usize = 512;
const START: usize = PARTITION_START as usize * BLOCK;

fn number(bytes: &[u8]) -> usize {
    bytes
        .iter()
        .rev()
        .fold(0, |n, &byte| n << 8 | usize::from(byte))
}

/// The clusters of a FAT16 file, from the FAT itself.
fn clusters(volume: &[u8], first: usize) -> Vec<usize> {
    let fat = number(&volume[14..16]) * BLOCK;
    let mut clusters = vec![first];
    loop {
        let entry = fat + 2 * clusters[clusters.len() - 1];
        match number(&volume[entry..entry + 2]) {
            0xFFF8.. => return clusters,
            next => clusters.push(next),
        }
    }
}

/// The entries of a FAT16 root folder up to the first unused one.
fn root_entries(volume: &[u8]) -> Vec<&[u8]> {
    let root = (number(&volume[14..16]) + 2 * number(&volume[22..24])) * BLOCK;
    volume[root..]
        .chunks(32)
        .take_while(|entry| entry[0] != 0)
        .collect()
}

#[test]
fn a_partition_table_or_none() {
    for (fat, kind, sizes) in [
        (Fat::Fat16, 0x0E, 2 << 20..4 << 20),
        (Fat::Fat32, 0x0C, 33 << 20..36 << 20),
    ] {
        let partitioned = Image::new(fat).file("A.TXT", "a").build().unwrap();
        assert_eq!(partitioned[510..512], [0x55, 0xAA]);
        assert_eq!(partitioned[..446], [0; 446]);
        assert_eq!(partitioned[446 + 4], kind);
        assert_eq!(
            number(&partitioned[446 + 8..446 + 12]),
            PARTITION_START as usize
        );
        let blocks = number(&partitioned[446 + 12..446 + 16]);
        assert_eq!(partitioned[462..510], [0; 48]);

        let volume = &partitioned[START..];
        let total = number(&volume[19..21]).max(number(&volume[32..36]));
        assert!(total <= blocks);
        assert!(START + blocks * BLOCK <= partitioned.len());
        assert_eq!(number(&volume[28..32]), PARTITION_START as usize);
        if fat == Fat::Fat32 {
            assert_eq!(volume[6 * BLOCK..7 * BLOCK], volume[..BLOCK]);
        }

        let bare = Image::new(fat).bare().file("A.TXT", "a").build().unwrap();
        assert_eq!(bare[446..510], [0; 64]);
        assert_eq!(number(&bare[28..32]), 0);

        for image in [partitioned, bare] {
            assert_eq!(image.len() % UNIT, 0);
            assert!(sizes.contains(&image.len()), "{}", image.len());
        }
    }
}

#[test]
fn the_same_calls_give_the_same_bytes() {
    let image = Image::new(Fat::Fat16)
        .fragmented_file("PROGRAM.TXT", vec![7; 5000])
        .deleted_file("OLD.TXT", "old");
    assert!(image.build().unwrap() == image.clone().build().unwrap());
}

#[test]
fn clusters_lie_as_asked() {
    let bytes = vec![7; 10 * BLOCK];
    let image = Image::new(Fat::Fat16)
        .file("WHOLE.TXT", bytes.clone())
        .fragmented_file("PARTS.TXT", bytes)
        .build()
        .unwrap();
    let volume = &image[START..];
    let chain = |name: &[u8]| {
        let entries = root_entries(volume);
        let entry = entries.iter().find(|entry| &entry[..11] == name).unwrap();
        clusters(volume, number(&entry[26..28]))
    };
    let steps = |chain: Vec<usize>| -> Vec<_> { chain.windows(2).map(|w| w[1] - w[0]).collect() };
    assert_eq!(steps(chain(b"WHOLE   TXT")), [1; 9]);
    assert_eq!(steps(chain(b"PARTS   TXT")), [2; 9]);
    assert_eq!(steps(chain(b"SPACER  1  ")), [2; 9]);
}

#[test]
fn deleted_files_leave_their_entries_in_front() {
    let image = Image::new(Fat::Fat16)
        .deleted_file("OLD.TXT", "old")
        .file("PROGRAM.TXT", "0")
        .build()
        .unwrap();
    let entries = root_entries(&image[START..]);
    let names: Vec<_> = entries
        .iter()
        .filter(|entry| entry[11] & 0x0F != 0x0F)
        .map(|entry| &entry[..11])
        .collect();
    assert_eq!(names, [b"\xE5LD     TXT", b"PROGRAM TXT"]);
}

#[test]
fn what_cannot_be_built_is_refused() {
    let image = Image::new(Fat::Fat16);
    for (wrong, says) in [
        (image.clone().cluster_blocks(0), "not 0"),
        (image.clone().cluster_blocks(3), "not 3"),
        (image.clone().cluster_blocks(128), "not 128"),
        (image.clone().file("A/B", "b"), "A/B"),
        (image.clone().file("WHAT?.TXT", ""), "WHAT?.TXT"),
        (image.clone().file("", ""), "name"),
        (
            image.clone().file("A.TXT", "1").file("a.txt", "2"),
            "a.txt is twice",
        ),
        (
            image.clone().file("BIG", vec![0; 33 << 20]),
            "larger clusters",
        ),
        (
            (0..300).fold(image, |image, n| image.file(format!("{n}.TXT"), "")),
            ".TXT",
        ),
    ] {
        let error = wrong.build().map(drop).unwrap_err().to_string();
        assert!(error.contains(says), "{error:?} does not say {says:?}");
    }
}
