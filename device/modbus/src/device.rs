//! What a server stands for: the side of the protocol that the application fills in.

/// One of the four tables of Modbus. Its number is that of the function that reads it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Table {
    /// Bits that can be read and written: functions 1, 5 and 15.
    Coils = 1,
    /// Bits that can be read: function 2.
    DiscreteInputs = 2,
    /// Words that can be read and written: functions 3, 6 and 16.
    HoldingRegisters = 3,
    /// Words that can be read: function 4.
    InputRegisters = 4,
}

impl Table {
    /// Whether it is of words.
    pub fn has_words(self) -> bool {
        self as u8 >= Table::HoldingRegisters as u8
    }
}

/// What a request is about to do with addresses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Access {
    /// Read them.
    Read,
    /// Write them: coils or holding registers.
    Write,
}

/// Addresses of a table that a request is about, in a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Addresses {
    /// Whose they are.
    pub table: Table,
    /// What is to be done with them.
    pub access: Access,
    /// The first of them.
    pub first: u16,
    /// How many there are.
    pub count: u16,
}

/// Why a request is refused: the exception codes of section 7.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Exception {
    /// The function is none of this server's.
    IllegalFunction = 1,
    /// Not all of the addresses exist.
    IllegalDataAddress = 2,
    /// A quantity, value or length that is not allowed.
    IllegalDataValue = 3,
    /// The device failed to do it.
    ServerDeviceFailure = 4,
    /// The device cannot do it now; the client may ask again.
    ServerDeviceBusy = 6,
    /// A gateway has no way to this server.
    GatewayPathUnavailable = 10,
    /// The server behind a gateway does not answer it.
    GatewayTargetSilent = 11,
}

impl Exception {
    /// The exception of this code.
    pub fn of(code: u8) -> Option<Exception> {
        use Exception::*;
        [
            IllegalFunction,
            IllegalDataAddress,
            IllegalDataValue,
            ServerDeviceFailure,
            ServerDeviceBusy,
            GatewayPathUnavailable,
            GatewayTargetSilent,
        ]
        .into_iter()
        .find(|exception| *exception as u8 == code)
    }
}

/// A word as it stands in a frame, the high byte first.
pub type Word = [u8; 2];

/// What the server reads and writes.
///
/// [`Exchange::begin`](crate::Exchange::begin) first asks [`has`](Device::has); it and [`Exchange::fill`](crate::Exchange::fill)
/// then read and write only within what it has affirmed. So every call must be short and none but a check can fail;
/// but between two slices a scan may have run, so a write must bear that what
/// [`check_words`](Device::check_words) saw has changed.
///
/// A 32-bit value that takes two words is read and written without a scan between them where
/// [`words`](Device::words) does both at once.
pub trait Device {
    /// Whether all of these addresses exist. There is at least one, and the last is at most 65535.
    fn has(&self, addresses: &Addresses) -> bool;

    /// Reads the first of these bits, 1 to 8 of them, the first as bit 0; or writes them to coils. What it
    /// gives for a write, and the bits after the last, mean nothing.
    fn bits(&mut self, addresses: &Addresses, count: u8, bits: u8) -> u8;

    /// Reads these words, as many as `words` has; or writes `words` to holding registers, which
    /// [`check_words`](Device::check_words) has accepted, and leaves them as they are. Gives how many
    /// it has done, at least one; the others follow in other calls, before or after a scan.
    fn words(&mut self, addresses: &Addresses, words: &mut [Word]) -> u8;

    /// Whether the holding registers from `first` on may take these words: all of a request.
    ///
    /// # Errors
    /// The exception to answer, mostly [`Exception::IllegalDataValue`]; then nothing is written.
    fn check_words(&self, first: u16, words: &[Word]) -> Result<(), Exception>;

    /// All that a request writes has been written.
    fn is_written(&mut self) {}

    /// Takes a block that function 16 writes from `first` on, 2 to 246 bytes, as it was sent: each word's
    /// high byte first. `None`: no window for blocks begins there, so these are registers, and
    /// [`has`](Device::has) is asked about them.
    ///
    /// It is called once for each request, in [`Exchange::begin`](crate::Exchange::begin), before anything else is asked.
    fn take(&mut self, first: u16, data: &[u8]) -> Option<Result<(), Exception>> {
        let _ = (first, data);
        None
    }

    /// Byte `index` of an identification text: `object` is 0 for the vendor's name, 1 for the product
    /// code, 2 for the version. `None` after its end. It is asked byte by byte, so texts need not stand
    /// in RAM; of a text, the first 80 bytes are sent.
    fn identification(&self, object: u8, index: u8) -> Option<u8>;
}
