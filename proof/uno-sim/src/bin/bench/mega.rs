//! How fast a Mega is, counted from one `scan_begin` to the next. Its tests hold these figures to the same targets.

use anyhow::{Context, Result, ensure};
use unoclp_card::image::{Fat, Image};
use unoclp_core::{Board, Loader};
use unoclp_uno_sim::sd::{Kind, SdCard};
use unoclp_uno_sim::{CYCLES_PER_MS, Program, Slot, Uno};

/// Four contacts in series of these inputs, the output of their coil, and what that rung may take, cycles: 20 where all points
/// are those of a UNO, else 30.
pub const RUNGS: [([u8; 4], u8, u64); 8] = [
    ([1, 2, 3, 4], 1, 20),
    ([5, 6, 7, 8], 4, 20),
    ([2, 4, 5, 7], 2, 20),
    ([1, 2, 3, 4], 5, 30),
    ([5, 6, 7, 8], 8, 30),
    ([9, 10, 11, 12], 9, 30),
    ([13, 14, 15, 16], 1, 30),
    ([17, 20, 22, 24], 16, 30),
];
/// What a whole scan of two contacts and a coil may take, in which all points are read and written, cycles.
pub const SMALL: u64 = 250;
/// So many rungs of four contacts and a coil may take this, cycles.
pub const MANY: usize = 500;
/// See [`MANY`].
pub const LARGE: u64 = CYCLES_PER_MS;
/// From the first instruction to RUN with a program of full size, ms.
pub const START: u64 = 1000;

/// The longest scan that is waited for, cycles, and the longest way from a card to RUN, ms: each byte is kept for a while.
const LONGEST: u64 = 10 * CYCLES_PER_MS;
const LOADS: u64 = 40_000;
/// Scans that are looked at.
const SCANS: usize = 200;

/// What is measured of a Mega.
#[derive(Clone, Copy, Debug)]
pub struct Mega {
    /// The dearest of [`RUNGS`] that have 20 cycles, and of those that have 30.
    pub rungs: [u64; 2],
    /// The mean of a small whole scan, cycles.
    pub small: u64,
    /// That of [`MANY`] rungs.
    pub large: u64,
    /// From the first instruction to RUN, ms.
    pub start: u64,
}

/// Measures it all.
pub fn measure(firmware: &Program) -> Result<Mega> {
    let mut dearest = [0; 2];
    for (inputs, output, most) in RUNGS {
        let place = &mut dearest[usize::from(most > 20)];
        *place = rung(firmware, inputs, output)?.max(*place);
    }
    Ok(Mega {
        rungs: dearest,
        small: small(firmware)?,
        large: large(firmware)?,
        start: start(firmware)?,
    })
}

/// Cycles that one such rung adds to the shortest scans.
pub fn rung(firmware: &Program, inputs: [u8; 4], output: u8) -> Result<u64> {
    let [few, _] = scans(firmware, &rungs(10, inputs, output))?;
    let [many, _] = scans(firmware, &rungs(100, inputs, output))?;
    Ok((many - few) / 90)
}

/// Two contacts and a coil: the mean scan, cycles.
pub fn small(firmware: &Program) -> Result<u64> {
    let [_, mean] = scans(firmware, "0\n827301\n827302\n877901\n")?;
    Ok(mean)
}

/// Five hundred rungs: the mean scan, cycles.
pub fn large(firmware: &Program) -> Result<u64> {
    let [_, mean] = scans(firmware, &rungs(MANY, [9, 10, 11, 12], 9))?;
    Ok(mean)
}

/// From its first instruction to its first scan, with a program of full size that is kept, and no card: ms.
pub fn start(firmware: &Program) -> Result<u64> {
    let begun = "0\n".to_owned() + &"787600\n847978\n100000\n7901\n".repeat(60);
    let room = usize::from(Board::MEGA.stored_bytes) - stored(&begun)?;
    let text = begun + &"827301\n877901\n".repeat(room / 2);
    ensure!(stored(&text)? + 2 > usize::from(Board::MEGA.stored_bytes));
    let mut mega = running(firmware, &text)?;
    mega.swap_slot(Slot::Empty);
    mega.power_up();
    let begun = mega.cycles();
    let scan = scan_begin(&mega)?;
    mega.run_until(scan, 2 * START * CYCLES_PER_MS)?;
    Ok((mega.cycles() - begun) / CYCLES_PER_MS)
}

/// Rungs of four contacts and a coil, of these points.
fn rungs(count: usize, inputs: [u8; 4], output: u8) -> String {
    let contacts = inputs.map(|input| format!("8273{input:02}\n")).concat();
    let rung = format!("787600\n{contacts}8779{output:02}\n");
    format!("0\n{}", rung.repeat(count))
}

/// What a program takes in its stored form, bytes.
fn stored(text: &str) -> Result<usize> {
    let mut memory = vec![0; Board::MEGA.linked_bytes.into()];
    let mut loader = Loader::new(&mut memory, Board::MEGA);
    for &byte in text.as_bytes() {
        let pushed = loader.push(byte);
        ensure!(pushed.is_ok(), "{pushed:?}");
    }
    let program = loader.finish().ok().context("the program has a fault")?;
    Ok(program.stored_bytes())
}

/// A Mega that runs this.
fn running(firmware: &Program, text: &str) -> Result<Uno> {
    let image = Image::new(Fat::Fat16).file("PROGRAM.TXT", text).build()?;
    let card = SdCard::new(Kind::Sdhc, image)?;
    let mut mega = Uno::with_program(firmware.clone(), Slot::Card(card))?;
    for _ in 0..LOADS {
        mega.run_ms(1)?;
        if mega.serial().contains("RUN\r\n") {
            break;
        }
    }
    // A long one is linked first.
    mega.run_ms(200)?;
    Ok(mega)
}

fn scan_begin(mega: &Uno) -> Result<u32> {
    let symbol = mega.symbol("scan_begin");
    Ok(symbol.context("the firmware has no `scan_begin`")?.address)
}

/// Cycles of the shortest scan and of the mean one.
fn scans(firmware: &Program, text: &str) -> Result<[u64; 2]> {
    let mut mega = running(firmware, text)?;
    let begin = scan_begin(&mega)?;
    mega.run_until(begin, LONGEST)?;
    let (mut least, first) = (u64::MAX, mega.cycles());
    for _ in 0..SCANS {
        let begun = mega.cycles();
        mega.run_until(begin, LONGEST)?;
        least = least.min(mega.cycles() - begun);
    }
    Ok([least, (mega.cycles() - first) / SCANS as u64])
}
