//! What operation shows and takes: its state, commands, forces, images and the times of scans.
//!
//! Owns what these mean together; must not know who scans, who shows them, or who commands.

#[cfg(not(mega))]
use core::mem;
use unoclp_core::{Fault, Image};

#[cfg(mega)]
pub use crate::wide::{Forces, Images};
pub use unoclp_modbus::map::{Command, State};

/// Operation from one start of the board to the next.
pub struct Operation {
    /// What the board is doing.
    pub state: State,
    /// STOP by command.
    pub stopped: bool,
    /// An upload is under way.
    pub uploading: bool,
    /// What was commanded and has not been done.
    pub command: Option<Command>,
    /// The fault that there is, or that of the last upload.
    pub fault: Option<Fault>,
    /// The card has failed; the state is no longer kept.
    pub card_failed: bool,
    /// What is forced.
    pub forces: Forces,
    /// As the last scan left them.
    pub images: Images,
    /// How long scans take.
    pub times: ScanTimes,
}

impl Operation {
    /// Before the first scan.
    pub fn new() -> Operation {
        Operation {
            state: State::Stop,
            stopped: false,
            uploading: false,
            command: None,
            fault: None,
            card_failed: false,
            forces: Forces::default(),
            images: Images::default(),
            times: ScanTimes::default(),
        }
    }

    /// Takes this command, if it is the one that was given.
    pub fn takes(&mut self, command: Command) -> bool {
        let given = self.command == Some(command);
        if given {
            self.command = None;
        }
        given
    }

    /// No request has come for so many seconds: forcing may end. A forced output is 0 then until a rung writes it.
    #[cfg(not(mega))]
    pub fn silence(&mut self, seconds: u8) {
        let [points @ .., most] = &mut self.forces.0;
        if *most != 0 && seconds > *most {
            let [_, _, forced, _] = mem::take(points);
            let Image(outputs) = self.images.outputs();
            self.images.set_outputs(Image(outputs & !u16::from(forced)));
        }
    }

    /// The same of a board with more points.
    #[cfg(mega)]
    pub fn silence(&mut self, seconds: u8) {
        if let Some(forced) = self.forces.end(seconds) {
            let Image(outputs) = self.images.outputs();
            self.images.set_outputs(Image(outputs & !forced));
        }
    }

    /// The inputs where no scan reads them.
    pub fn read(&mut self, inputs: Image) {
        self.images.set_inputs(self.forces.inputs(inputs));
    }

    /// The output image. In RUN a forced output that is PWM stands there as it is forced, and for the
    /// program alone as 0.
    pub fn outputs(&self) -> Image {
        let outputs = self.images.outputs();
        if self.state == State::Run {
            self.forces.outputs(outputs)
        } else {
            outputs
        }
    }
}

/// Points that are forced, and to what: inputs, values of inputs, outputs, values of outputs, as the Modbus
/// map has them; bit 0 is point 01. Then how many seconds without a request end all forcing, 0 for none.
#[cfg(not(mega))]
#[derive(Clone, Copy, Default)]
pub struct Forces(pub [u8; 5]);

#[cfg(not(mega))]
impl Forces {
    /// Whether there are any.
    #[inline(always)]
    pub fn any(self) -> bool {
        let [inputs, _, outputs, ..] = self.0;
        inputs | outputs != 0
    }

    /// The input image with the forced inputs as they are forced.
    #[inline(always)]
    pub fn inputs(self, image: Image) -> Image {
        let [points, values, ..] = self.0;
        Image((image.0 as u8 & !points | values & points).into())
    }

    /// Which outputs are forced, bit 0 output 01.
    pub fn forced_outputs(self) -> u8 {
        let [_, _, outputs, ..] = self.0;
        outputs
    }

    /// The same of the output image.
    #[inline(always)]
    pub fn outputs(self, image: Image) -> Image {
        let [_, _, points, values, _] = self.0;
        Image((image.0 as u8 & !points | values & points).into())
    }
}

/// Inputs and outputs as a scan left them.
#[cfg(not(mega))]
#[derive(Clone, Copy, Default, PartialEq, Eq)]
pub struct Images {
    /// Inputs 01 to 04 as bits 0 to 3, and outputs 01 to 04 as bits 4 to 7: a scan has them in one register.
    pub points: u8,
    /// Inputs 05 to 08 as bits 4 to 7.
    more: u8,
}

#[cfg(not(mega))]
impl Images {
    /// Inputs 01 to 04 among the points.
    pub const INPUTS: u8 = 0x0F;
    /// The bit of output 01 among the points.
    pub const OUTPUTS_AT: u8 = 4;

    /// The input image.
    pub fn inputs(self) -> Image {
        Image((self.points & Self::INPUTS | self.more).into())
    }

    /// The output image.
    pub fn outputs(self) -> Image {
        Image((self.points >> Self::OUTPUTS_AT).into())
    }

    /// Sets the input image.
    pub fn set_inputs(&mut self, inputs: Image) {
        let inputs = inputs.0 as u8;
        self.points = self.points & !Self::INPUTS | inputs & Self::INPUTS;
        self.more = inputs & !Self::INPUTS;
    }

    /// Sets the output image.
    pub fn set_outputs(&mut self, outputs: Image) {
        self.points = self.points & Self::INPUTS | (outputs.0 as u8) << Self::OUTPUTS_AT;
    }
}

/// How long scans take; 32,767 µs stands for anything longer.
#[derive(Clone, Copy)]
pub struct ScanTimes {
    // Half µs.
    pub last: u16,
    pub least: u16,
    pub most: u16,
}

impl Default for ScanTimes {
    /// Before the first scan has ended: all are 0.
    fn default() -> ScanTimes {
        ScanTimes {
            last: 0,
            least: u16::MAX,
            most: 0,
        }
    }
}

impl ScanTimes {
    /// The last scan, µs.
    pub fn last(&self) -> u16 {
        self.last / 2
    }

    /// The shortest since scanning began, µs.
    pub fn least(&self) -> u16 {
        self.least.min(self.most) / 2
    }

    /// The longest since scanning began, µs.
    pub fn most(&self) -> u16 {
        self.most / 2
    }

    /// Takes the time of another scan, half µs.
    pub fn take(&mut self, time: u16) {
        self.last = time;
        self.least = self.least.min(time);
        self.most = self.most.max(time);
    }
}
