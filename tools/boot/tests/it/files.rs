//! Which files are taken for which boards.

use crate::bench::{encode, hex, hex_of, record};
use unoclp_boot::{Image, Model, Unfit};

const OTHER: Unfit = Unfit::OtherChip { model: Model::Uno };

fn read(file: &[u8]) -> Result<Vec<u8>, Unfit> {
    Image::read(file, Model::Uno).map(|image| image.bytes().to_vec())
}

#[test]
fn a_firmware_is_read_from_its_records() {
    let bytes = read(&hex(1_000)).expect("a firmware");
    assert_eq!(bytes.len(), 1_000);
    assert_eq!(bytes[..4], [0x0C, 0x94, 0x34, 0x00]);
    // Neither the line ends nor the order of the records matter.
    let file = String::from_utf8(hex(1_000)).unwrap();
    let mut lines: Vec<&str> = file.lines().collect();
    let end = lines.pop().unwrap();
    lines.reverse();
    let other = format!("\n{}\n{end}", lines.join("\n"));
    assert_eq!(read(other.as_bytes()), Ok(bytes));
}

#[test]
fn what_a_file_leaves_out_is_erased_flash() {
    let file = String::from_utf8(hex(106)).unwrap();
    let file = file.replace(
        ":00000001FF",
        &(record(&[1, 2, 0, 0, 7]) + ":020000020000FC\r\n:0400000300000000F9\r\n:00000001FF"),
    );
    let bytes = read(file.as_bytes()).expect("a firmware");
    assert_eq!(bytes.len(), 0x201);
    assert!(bytes[106..0x200].iter().all(|&byte| byte == 0xFF));
    assert_eq!(bytes[0x200], 7);
}

#[test]
fn each_kind_of_wrong_file_is_refused() {
    let good = String::from_utf8(hex(300)).unwrap();
    let line = |number: usize| good.lines().nth(number - 1).unwrap().to_owned() + "\r\n";
    let end = ":00000001FF\r\n";
    let cases = [
        (String::new(), Unfit::CutShort),
        ("\u{7f}ELF\u{1}\u{1}".to_owned(), Unfit::NotHex { line: 1 }),
        ("00\n40 01\n".to_owned(), Unfit::NotHex { line: 1 }),
        (format!("{good}more\n"), Unfit::NotHex { line: 21 }),
        (format!("{good}{end}"), Unfit::NotHex { line: 21 }),
        (
            good.replacen("100030", "100031", 1),
            Unfit::Damaged { line: 4 },
        ),
        (good.replace(end, ""), Unfit::CutShort),
        (
            good[..good.len() / 2].to_owned(),
            Unfit::Damaged { line: 10 },
        ),
        (
            good.replace(end, &(line(3) + end)),
            Unfit::Twice { address: 0x20 },
        ),
        (end.to_owned(), OTHER),
        // An ARM's flash.
        (
            record(&[2, 0, 0, 4, 8, 0]) + &record(&[2, 0, 0, 0, 1, 2]) + end,
            OTHER,
        ),
    ];
    for (file, expected) in cases {
        assert_eq!(read(file.as_bytes()), Err(expected), "{file}");
    }
    assert_eq!(read(b"\xFF\xFE\0"), Err(Unfit::NotHex { line: 1 }));
}

#[test]
fn other_chips_are_told_by_their_vectors() {
    let jump = [0x0C, 0x94, 0x90, 0x00];
    let relaxed = [0x33, 0xC0, 0x00, 0x00];
    let code = [0x11, 0x24, 0x1F, 0xBE];
    let table = |vectors: usize| [jump.repeat(vectors), code.repeat(100)].concat();
    // A linker may shorten each jump.
    let own = [
        relaxed.to_vec(),
        jump.repeat(24),
        relaxed.to_vec(),
        code.repeat(9),
    ]
    .concat();
    assert!(read(&encode(&own)).is_ok());
    assert!(read(&encode(&table(26))).is_ok());
    // 8515, 88, 644, 1284P, 32U4 and 2560: fewer, shorter or more.
    let short = [[0x33, 0xC0].repeat(26), code.repeat(30)].concat();
    for other in [table(17), short, table(28), table(35), table(43), table(57)] {
        assert_eq!(read(&encode(&other)), Err(OTHER));
    }
}

#[test]
fn a_file_is_refused_where_the_board_has_no_room() {
    for model in Model::ALL {
        let room = model.room();
        let image = Image::read(&hex_of(model, room), model).expect("it just fits");
        assert_eq!(image.model(), model);
        let bytes = room + 1;
        let refused = Image::read(&hex_of(model, bytes), model);
        assert_eq!(refused, Err(Unfit::TooLarge { bytes, model }));
    }
    let rooms = [32_256, 30_720, 30_720, 253_952];
    assert_eq!(Model::ALL.map(Model::room), rooms);
    let rates = [115_200, 115_200, 57_600, 115_200];
    assert_eq!(Model::ALL.map(Model::rate), rates);
}

#[test]
fn the_firmware_of_one_board_is_refused_for_the_other_before_anything_is_written() {
    for [of, model] in [
        [Model::Uno, Model::Mega],
        [Model::Mega, Model::Uno],
        [Model::Mega, Model::Nano],
    ] {
        let refused = Image::read(&hex_of(of, 1_000), model);
        assert_eq!(refused, Err(Unfit::OtherChip { model }));
    }
}

#[test]
fn no_random_file_panics() {
    let good = hex(400);
    let mut seed = 1_u32;
    let mut next = move |below: usize| {
        seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (seed >> 8) as usize % below
    };
    for _ in 0..unoclp_testing::rounds(20_000) {
        let mut file = good.clone();
        for _ in 0..=next(3) {
            let at = next(file.len().max(2) - 1);
            match next(3) {
                0 => file[at] = b":0123456789ABCDEF\n\xFF"[next(19)],
                1 => drop(file.drain(at..=at)),
                _ => file.truncate(at + 2),
            }
        }
        for model in Model::ALL {
            if let Ok(image) = Image::read(&file, model) {
                assert!(image.bytes().len() <= model.room());
            }
        }
    }
}
