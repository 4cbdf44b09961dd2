//! The card model against a driver that is not ours: embedded-sdmmc, over a host SPI device.

use embedded_hal::delay::DelayNs;
use embedded_hal::spi::{ErrorKind, ErrorType, Operation, SpiDevice};
use embedded_sdmmc::sdcard::spi::AcquireOpts;
use embedded_sdmmc::{Block, BlockDevice, BlockIdx, SdCard as Driver, SdCardError};
use std::cell::RefCell;
use std::rc::Rc;
use unoclp_uno_sim::sd::{At, Kind, SdCard, Timing, What};

const KINDS: [Kind; 3] = [Kind::SdV1, Kind::SdscV2, Kind::Sdhc];

/// How the host uses chip select.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Select {
    /// Low for each transaction, as `SpiDevice` asks for.
    EachTransfer,
    /// Low all the time, as the firmware does.
    Held,
}

/// The host's end of the bus. The other end stays in the test's hands.
struct Bus {
    card: Rc<RefCell<SdCard>>,
    select: Select,
}

impl ErrorType for Bus {
    type Error = ErrorKind;
}

impl SpiDevice for Bus {
    fn transaction(&mut self, operations: &mut [Operation<'_, u8>]) -> Result<(), ErrorKind> {
        let mut card = self.card.borrow_mut();
        card.select(true);
        for operation in operations {
            match operation {
                Operation::Read(to) => to.iter_mut().for_each(|byte| *byte = card.exchange(0xFF)),
                Operation::Write(from) => from.iter().for_each(|&byte| {
                    card.exchange(byte);
                }),
                Operation::Transfer(to, from) => {
                    for at in 0..to.len().max(from.len()) {
                        let miso = card.exchange(from.get(at).copied().unwrap_or(0xFF));
                        if let Some(to) = to.get_mut(at) {
                            *to = miso;
                        }
                    }
                }
                Operation::TransferInPlace(bytes) => {
                    bytes
                        .iter_mut()
                        .for_each(|byte| *byte = card.exchange(*byte));
                }
                Operation::DelayNs(_) => {}
            }
        }
        if self.select == Select::EachTransfer {
            card.select(false);
        }
        Ok(())
    }
}

struct NoDelay;

impl DelayNs for NoDelay {
    fn delay_ns(&mut self, _: u32) {}
}

type Shared = Rc<RefCell<SdCard>>;

/// An image whose every block tells which one it is.
fn numbered_image(blocks: usize) -> Vec<u8> {
    (0..blocks).flat_map(numbered_block).collect()
}

fn numbered_block(number: usize) -> [u8; 512] {
    std::array::from_fn(|at| (number * 7 + at) as u8)
}

/// A driver on a card that has seen its 74 clocks, and the card.
fn attach(card: SdCard, select: Select) -> (Driver<Bus, NoDelay>, Shared) {
    let card = Rc::new(RefCell::new(card));
    for _ in 0..10 {
        card.borrow_mut().exchange(0xFF);
    }
    let bus = Bus {
        card: Rc::clone(&card),
        select,
    };
    let options = AcquireOpts {
        use_crc: true,
        acquire_retries: 3,
    };
    (Driver::new_with_options(bus, NoDelay, options), card)
}

fn card(kind: Kind) -> SdCard {
    SdCard::new(kind, numbered_image(64)).expect("64 blocks fit any card")
}

fn read(driver: &Driver<Bus, NoDelay>, block: u32) -> Result<[u8; 512], SdCardError> {
    let mut blocks = [Block::new()];
    driver.read(&mut blocks, BlockIdx(block))?;
    Ok(blocks[0].contents)
}

fn write(
    driver: &Driver<Bus, NoDelay>,
    block: u32,
    contents: [u8; 512],
) -> Result<(), SdCardError> {
    let mut data = Block::new();
    data.contents = contents;
    driver.write(&[data], BlockIdx(block))
}

#[test]
fn every_kind_of_card_is_read_and_written() {
    for kind in KINDS {
        for select in [Select::EachTransfer, Select::Held] {
            let (driver, card) = attach(card(kind), select);
            let bytes = card.borrow().image().len() as u64;
            assert_eq!(
                driver.num_bytes().expect("CSD"),
                bytes,
                "{kind:?}, {select:?}"
            );
            for block in [0, 1, 63] {
                assert_eq!(
                    read(&driver, block).expect("read"),
                    numbered_block(block as usize)
                );
            }

            let mut many: [Block; 5] = std::array::from_fn(|_| Block::new());
            driver.read(&mut many, BlockIdx(3)).expect("CMD18");
            for (at, block) in many.iter().enumerate() {
                assert_eq!(block.contents, numbered_block(3 + at));
            }

            write(&driver, 9, [0xA5; 512]).expect("write");
            assert_eq!(read(&driver, 9).expect("read back"), [0xA5; 512]);
            assert_eq!(
                read(&driver, 10).expect("its neighbour"),
                numbered_block(10)
            );

            let card = card.borrow();
            assert_eq!(card.log().blocks_read, 3 + 5 + 2);
            assert_eq!(card.log().blocks_written, 1);
            assert_eq!(
                (
                    card.log().count(17),
                    card.log().count(18),
                    card.log().count(24)
                ),
                (5, 1, 1)
            );
            assert_eq!(&card.image()[9 * 512..10 * 512], [0xA5; 512]);
        }
    }
}

#[test]
fn a_slow_card_is_waited_for() {
    let timing = Timing {
        response_delay: 8,
        init_polls: 200,
        data_delay: 2000,
        write_busy: 3000,
        stop_busy: 100,
    };
    for kind in KINDS {
        let (driver, card) = attach(card(kind).with_timing(timing), Select::Held);
        assert_eq!(read(&driver, 5).expect("read"), numbered_block(5));
        let mut two = [Block::new(), Block::new()];
        driver.read(&mut two, BlockIdx(1)).expect("CMD18");
        write(&driver, 5, [1; 512]).expect("write");
        assert_eq!(read(&driver, 5).expect("read"), [1; 512]);
        let polls = card
            .borrow()
            .log()
            .commands
            .iter()
            .filter(|command| command.app)
            .count();
        assert_eq!(polls, 201, "200 times idle, then ready");
    }
}

#[test]
fn reading_beyond_the_end_is_refused() {
    for kind in KINDS {
        let (driver, card) = attach(card(kind), Select::EachTransfer);
        let end = (card.borrow().image().len() / 512) as u32;
        assert!(read(&driver, end).is_err(), "{kind:?}");
        let mut two = [Block::new(), Block::new()];
        assert!(
            driver.read(&mut two, BlockIdx(end - 1)).is_err(),
            "{kind:?}"
        );
        assert_eq!(card.borrow().log().blocks_read, 1, "only the last block");
    }
}

#[test]
fn a_card_without_its_power_up_clocks_is_not_found() {
    let card = Rc::new(RefCell::new(card(Kind::Sdhc)));
    let bus = Bus {
        card: Rc::clone(&card),
        select: Select::Held,
    };
    let options = AcquireOpts {
        use_crc: true,
        acquire_retries: 2,
    };
    let driver = Driver::new_with_options(bus, NoDelay, options);
    assert!(matches!(read(&driver, 0), Err(SdCardError::CardNotFound)));
    assert!(
        card.borrow()
            .log()
            .commands
            .iter()
            .all(|command| command.answer.is_none())
    );
}

/// The place in the command log of the first read of a block, on a card without faults.
fn first_read(kind: Kind) -> At {
    let (driver, card) = attach(card(kind), Select::Held);
    read(&driver, 0).expect("no fault");
    let log = card.borrow().log().clone();
    At::Command(
        log.commands
            .iter()
            .position(|command| command.index == 17)
            .expect("CMD17"),
    )
}

/// What the driver made of a read of block 0.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Outcome {
    RightData,
    WrongData,
    NoResponse,
    NoToken,
    ErrorToken,
    WrongCrc,
    Other,
}

fn outcome(result: Result<[u8; 512], SdCardError>) -> Outcome {
    match result {
        Ok(data) if data == numbered_block(0) => Outcome::RightData,
        Ok(_) => Outcome::WrongData,
        Err(SdCardError::TimeoutCommand(_)) => Outcome::NoResponse,
        Err(SdCardError::TimeoutReadBuffer) => Outcome::NoToken,
        Err(SdCardError::ReadError) => Outcome::ErrorToken,
        Err(SdCardError::CrcError(..)) => Outcome::WrongCrc,
        Err(_) => Outcome::Other,
    }
}

#[test]
fn each_fault_of_a_read_is_seen_in_its_place() {
    // The fault, the outcome where it stands at the block, the same at the command, and whether the card lives on.
    let table = [
        (What::NoAnswer, Outcome::NoToken, Outcome::NoResponse, true),
        (What::WrongCrc, Outcome::WrongCrc, Outcome::WrongCrc, true),
        (
            What::WrongToken,
            Outcome::ErrorToken,
            Outcome::ErrorToken,
            true,
        ),
        (What::Garbage, Outcome::WrongData, Outcome::WrongData, true),
        (
            What::Busy(300),
            Outcome::RightData,
            Outcome::RightData,
            true,
        ),
        (What::Removed, Outcome::WrongCrc, Outcome::NoResponse, false),
        // A line that stays low reads as R1 = 0 and then as a token that is none.
        (What::Stuck, Outcome::ErrorToken, Outcome::ErrorToken, false),
    ];
    for kind in KINDS {
        for (what, at_block, at_command, lives) in table {
            for (at, expected) in [(At::Block(0), at_block), (first_read(kind), at_command)] {
                let (driver, _) = attach(card(kind).with_fault(at, what), Select::Held);
                assert_eq!(
                    outcome(read(&driver, 0)),
                    expected,
                    "{kind:?}, {what:?} at {at:?}"
                );
                let next = read(&driver, 1);
                assert_eq!(
                    next.is_ok(),
                    lives,
                    "{kind:?}, {what:?} at {at:?}, the read after it"
                );
            }
        }
    }
}

#[test]
fn each_fault_of_a_write_is_seen() {
    // The fault, whether the driver sees an error, and whether the block arrives unharmed.
    let table = [
        (What::NoAnswer, true, false),
        (What::WrongCrc, true, false),
        (What::WrongToken, true, false),
        (What::Garbage, false, false),
        (What::Busy(300), false, true),
        (What::Removed, true, false),
        (What::Stuck, true, true),
    ];
    for kind in KINDS {
        for (what, fails, stored) in table {
            let (driver, card) = attach(
                card(kind).with_fault(At::Block(0), what),
                Select::EachTransfer,
            );
            assert_eq!(
                write(&driver, 4, [0x5A; 512]).is_err(),
                fails,
                "{kind:?}, {what:?}"
            );
            let card = card.borrow();
            assert_eq!(
                card.image()[4 * 512..5 * 512] == [0x5A; 512],
                stored,
                "{kind:?}, {what:?}"
            );
            assert_eq!(
                card.image()[..4 * 512],
                numbered_image(4),
                "{kind:?}, {what:?}"
            );
        }
    }
}

#[test]
fn a_card_that_never_leaves_idle_is_given_up() {
    for kind in KINDS {
        let (driver, card) = attach(
            card(kind).with_fault(At::Command(0), What::NeverReady),
            Select::Held,
        );
        assert!(
            matches!(read(&driver, 0), Err(SdCardError::TimeoutACommand(_))),
            "{kind:?}"
        );
        assert!(!card.borrow().is_ready());
    }
}

#[test]
fn a_card_pulled_and_put_back_is_found_again() {
    for kind in KINDS {
        let (driver, card) = attach(
            card(kind).with_fault(At::Block(1), What::Removed),
            Select::Held,
        );
        assert_eq!(read(&driver, 0).expect("before"), numbered_block(0));
        assert!(read(&driver, 1).is_err());
        {
            let mut card = card.borrow_mut();
            card.power_cycle();
            card.select(false);
            (0..10).for_each(|_| {
                card.exchange(0xFF);
            });
        }
        driver.mark_card_uninit();
        assert_eq!(read(&driver, 1).expect("after"), numbered_block(1));
    }
}
