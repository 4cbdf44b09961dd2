//! A boot loader, and what may happen on the way to it.

use crate::bench::{Bench, Chip, Fate, Way, image, image_of};
use std::time::Duration;
use unoclp_boot::{Failure, Model, Stage, Trouble, Writer};

/// 3 pages and a bit.
const SIZE: usize = 400;

fn passes(_: Way) -> Fate {
    Fate::Passes
}

#[test]
fn an_image_is_written_compared_and_started() {
    for size in [106, 128, 129, SIZE, 32_256] {
        let image = image(size);
        let mut bench = Bench::new(passes);
        assert_eq!(bench.write(&image), Ok(()));
        assert_eq!(bench.chip.flash[..size], *image.bytes());
        let end = size.next_multiple_of(128);
        assert!(bench.chip.flash[size..end].iter().all(|&byte| byte == 0xFF));
        assert!(bench.chip.flash[end..].iter().all(|&byte| byte == 0xA5));
        assert!(bench.chip.started);
        assert_eq!(bench.chip.resets, 1);
    }
}

/// Its boot loader erases pages in order alone: it is reset before the first page comes again.
#[test]
fn a_mega_is_written_by_its_own_protocol() {
    for size in [230, 256, 257, 70_001, 253_952] {
        let image = image_of(Model::Mega, size);
        let mut bench = Bench::new(passes);
        bench.chip = Chip::mega();
        assert_eq!(bench.write(&image), Ok(()), "{size}");
        assert_eq!(bench.chip.flash[..size], *image.bytes());
        let end = size.next_multiple_of(256);
        assert!(bench.chip.flash[size..end].iter().all(|&byte| byte == 0xFF));
        assert!(
            bench.chip.flash[0x3_E000..]
                .iter()
                .all(|&byte| byte == 0xA5)
        );
        assert!(bench.chip.started);
        assert_eq!(bench.chip.resets, 2);
    }
}

#[test]
fn a_board_with_another_boot_loader_is_told_by_its_signature() {
    for [own, model] in [[Model::Uno, Model::Mega], [Model::Mega, Model::Uno]] {
        let mut bench = Bench::new(passes);
        let signature = match own {
            Model::Mega => {
                bench.chip = Chip::mega();
                [0x1E, 0x98, 0x01]
            }
            _ => [0x1E, 0x95, 0x0F],
        };
        let failure = bench.write(&image_of(model, SIZE)).unwrap_err();
        let trouble = Trouble::OtherChip { signature, model };
        let stage = Stage::Meeting;
        assert_eq!(failure, Failure { trouble, stage });
        assert!(bench.chip.flash.iter().all(|&byte| byte == 0xA5));
    }
}

#[test]
fn progress_never_goes_back() {
    for model in [Model::Uno, Model::Mega] {
        let mut bench = Bench::new(passes);
        if model == Model::Mega {
            bench.chip = Chip::mega();
        }
        assert_eq!(bench.write(&image_of(model, SIZE)), Ok(()));
        let seen = &bench.seen;
        assert!(seen.is_sorted_by_key(|progress| (progress.stage, progress.done)));
        assert_eq!(seen[0].stage, Stage::Meeting);
        let last = seen.last().unwrap();
        assert_eq!((last.stage, last.done), (Stage::Finishing, last.of));
    }
}

#[test]
fn nobody_there_is_told_within_seven_seconds() {
    let mut bench = Bench::new(|_| Fate::Drops);
    let begun = bench.now;
    let failure = bench.write(&image(SIZE)).unwrap_err();
    assert_eq!(
        (failure.trouble, failure.stage),
        (Trouble::Silent, Stage::Meeting)
    );
    assert_eq!(bench.chip.resets, 5);
    assert!(bench.now - begun < Duration::from_secs(7));
}

#[test]
fn what_is_no_boot_loader_is_told_apart() {
    let mut bench = Bench::new(passes);
    bench.no_reset = true;
    bench.babble = b"\x01\x83\x01\x80\xF0";
    let failure = bench.write(&image(SIZE)).unwrap_err();
    assert_eq!(failure.trouble, Trouble::Foreign);
}

#[test]
fn another_chip_is_left_as_it_is() {
    let mut bench = Bench::new(passes);
    bench.chip.signature = [0x1E, 0x98, 0x01];
    let failure = bench.write(&image(SIZE)).unwrap_err();
    let trouble = Trouble::OtherChip {
        signature: [0x1E, 0x98, 0x01],
        model: Model::Uno,
    };
    assert_eq!(failure.trouble, trouble);
    assert!(bench.chip.flash.iter().all(|&byte| byte == 0xA5));
}

#[test]
fn flash_that_keeps_something_else_is_named_and_never_runs() {
    let image = image(SIZE);
    let address = (128..SIZE).find(|&at| image.bytes()[at] >= 0x80).unwrap();
    let mut bench = Bench::new(passes);
    bench.chip.stuck = Some(address);
    let written = image.bytes()[address];
    let failure = bench.write(&image).unwrap_err();
    let trouble = Trouble::Differs {
        address: address as u32,
        written,
        read: written & 0x7F,
    };
    let stage = Stage::Comparing;
    assert_eq!(failure, Failure { trouble, stage });
    assert_eq!(
        bench.chip.flash[..4],
        [0x00, 0x00, 0xFE, 0xCF],
        "it stands still"
    );
    assert!(!bench.chip.started);
}

#[test]
fn the_boot_loader_is_called_again_where_the_first_reset_was_missed() {
    // The first eight bytes: the calls after two resets.
    let mut bench = Bench::new(|way| match way {
        Way::Out(1..=8) => Fate::Drops,
        _ => Fate::Passes,
    });
    assert_eq!(bench.write(&image(SIZE)), Ok(()));
    assert_eq!(bench.chip.resets, 3);
}

#[test]
fn the_board_is_reset_again_where_its_first_answers_are_cut() {
    // The answer to the first call is two bytes long, the signature five.
    for hit in 3..=7 {
        let mut bench = Bench::new(|way| match way == Way::In(hit) {
            true => Fate::Drops,
            false => Fate::Passes,
        });
        assert_eq!(bench.write(&image(SIZE)), Ok(()), "{hit}");
        assert_eq!(bench.chip.resets, 2, "{hit}");
    }
}

#[test]
fn each_lost_or_changed_byte_is_told_and_the_next_try_works() {
    hit_each_byte(Model::Uno);
}

#[test]
fn each_lost_or_changed_byte_is_told_by_a_mega_too() {
    hit_each_byte(Model::Mega);
}

fn hit_each_byte(model: Model) {
    let page = if model == Model::Mega { 256 } else { 128 };
    let chip = || match model {
        Model::Mega => Chip::mega(),
        _ => Chip::new(),
    };
    let image = image_of(model, SIZE);
    let mut counter = (0, 0);
    let mut bench = Bench::new(|way| {
        match way {
            Way::Out(count) => counter.0 = count,
            Way::In(count) => counter.1 = count,
        }
        Fate::Passes
    });
    bench.chip = chip();
    assert_eq!(bench.write(&image), Ok(()));
    let (out, back) = counter;
    assert!(out > 500 && back > 500, "{counter:?}");
    let ways = (1..=out).map(Way::Out).chain((1..=back).map(Way::In));
    for hit in unoclp_testing::cases(ways) {
        for change in [0, 0x01, 0x80, 0xFF] {
            let mut bench = Bench::new(|way| match (way == hit, change) {
                (false, _) => Fate::Passes,
                (true, 0) => Fate::Drops,
                (true, bits) => Fate::Changes(bits),
            });
            bench.chip = chip();
            let outcome = bench.write(&image);
            let is_whole = bench.chip.flash[..SIZE] == *image.bytes();
            match outcome {
                Ok(()) => assert!(is_whole),
                Err(failure) => {
                    let is_untouched = bench.chip.flash.iter().all(|&byte| byte == 0xA5);
                    assert!(is_untouched || failure.stage > Stage::Meeting);
                    // What was written in part has no beginning.
                    let begins = bench.chip.flash[..page] == image.bytes()[..page];
                    assert!(!begins || failure.stage == Stage::Finishing);
                }
            }
            // The line has had its fault.
            assert_eq!(bench.write(&image), Ok(()));
            assert_eq!(bench.chip.flash[..SIZE], *image.bytes());
        }
    }
}

#[test]
fn a_random_line_never_passes_for_a_good_one() {
    let image = image(SIZE);
    let mut seed = 7_u32;
    for round in 0..unoclp_testing::rounds(400) {
        let often = 20 << (round % 8);
        let mut bench = Bench::new(|_| {
            seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            match seed >> 8 {
                random if random % often != 0 => Fate::Passes,
                random if random % 3 == 0 => Fate::Drops,
                random => Fate::Changes((random >> 12) as u8),
            }
        });
        if bench.write(&image).is_ok() {
            assert_eq!(bench.chip.flash[..128], image.bytes()[..128]);
        }
    }
}

#[test]
fn a_port_that_goes_away_is_told_with_what_the_board_holds() {
    for stage in [
        Stage::Meeting,
        Stage::Writing,
        Stage::Comparing,
        Stage::Finishing,
    ] {
        let mut bench = Bench::new(passes);
        let writer = Writer::new(&image(SIZE));
        let failure = bench.drive(writer, |writer| {
            (writer.progress().stage == stage).then(|| "unplugged".to_owned())
        });
        let trouble = Trouble::Lost("unplugged".to_owned());
        assert_eq!(failure, Err(Failure { trouble, stage }));
    }
}

#[test]
fn behind_its_end_a_writer_waits_for_ever() {
    let mut bench = Bench::new(passes);
    let image = image(SIZE);
    let mut writer = Writer::new(&image);
    writer.lose("gone".to_owned());
    assert!(bench.drive(writer.clone(), |_| None).is_err());
    let _ = writer.step(Duration::ZERO, &[]);
    let step = writer.step(Duration::from_secs(9), b"\x14\x10");
    assert!(!step.reset && step.send.is_empty());
    assert_eq!(step.next, unoclp_boot::Next::Wait(Duration::MAX));
}
