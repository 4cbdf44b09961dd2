//! Firmware on its way to a board, through its boot loader.

use crate::answer::answer;
use crate::clock::{NEVER, time, whole_ms};
use crate::words::{self, Both, both};
use unoclp_boot::{Image, Model, Next, Stage, Writer};

/// The one that is written now; a page has one line.
#[derive(Default)]
pub struct Flash(Option<Writer>);

answer! {
    /// A step of it.
    pub struct Step as "FlashStep" {
        /// First reset the board, and throw away what has come before.
        reset: bool,
        /// Then send this.
        send: Vec<u8>,
        /// The next step comes at this time, in whole ms, or as soon as bytes have come.
        until: u64,
        stage: &'static str => "\"meeting\" | \"writing\" | \"comparing\" | \"finishing\"",
        /// So many requests of so many have been answered.
        progress: [usize; 2],
        /// Whether it is over.
        over: bool,
        /// Why the firmware is not on the board.
        failure: Option<Both>,
    }
}

impl Flash {
    /// Begins; gives the rate of the boot loader in bits per second.
    ///
    /// # Errors
    /// Where there is no such board, or the file is not for it.
    pub fn begin(&mut self, hex: &str, model: &str) -> Result<u32, Both> {
        let model = Model::named(model).ok_or_else(|| both(|lang| words::no_model(lang, model)))?;
        let image = Image::read(hex.as_bytes(), model);
        let image = image.map_err(|unfit| both(|lang| unfit.text(lang)))?;
        self.0 = Some(Writer::new(&image));
        Ok(model.rate())
    }

    /// Goes on, at this time in ms, with what has come since the last step.
    ///
    /// # Errors
    /// Where nothing has begun.
    pub fn step(&mut self, now: f64, came: &[u8]) -> Result<Step, Both> {
        let writer = self.0.as_mut().ok_or_else(|| both(words::no_flash))?;
        let step = writer.step(time(now), came);
        let progress = writer.progress();
        let (until, over, failure) = match step.next {
            Next::Wait(until) => (whole_ms(until), false, None),
            Next::Done(Ok(())) => (NEVER, true, None),
            Next::Done(Err(failure)) => (NEVER, true, Some(both(|lang| failure.text(lang)))),
        };
        Ok(Step {
            reset: step.reset,
            send: step.send,
            until,
            stage: match progress.stage {
                Stage::Meeting => "meeting",
                Stage::Writing => "writing",
                Stage::Comparing => "comparing",
                Stage::Finishing => "finishing",
            },
            progress: [progress.done, progress.of],
            over,
            failure,
        })
    }

    /// The port is gone, and why: the next step says what the board holds.
    pub fn lose(&mut self, why: String) {
        if let Some(writer) = &mut self.0 {
            writer.lose(why);
        }
    }
}
