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

/// What a request is about to do with addresses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Access {
    /// Read them.
    Read,
    /// Write them: coils or holding registers.
    Write,
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
        ]
        .into_iter()
        .find(|exception| *exception as u8 == code)
    }
}

/// What the server reads and writes.
///
/// [`begin`](crate::begin) and [`Exchange::fill`](crate::Exchange::fill) first ask
/// [`has`](Device::has), and then read and write only within what it has affirmed. So every call must be
/// short and none can fail; but between two slices a scan may have run, so a `set_word` must bear that
/// what its `check_word` saw has changed.
///
/// A 32-bit value that takes two words, the first at an even address, is read and written without a
/// scan between its words.
pub trait Device {
    /// Whether all of the addresses `first` to `first + (count - 1)` of `table` exist for `access`.
    /// There is at least one, and the last is at most 65535.
    fn has(&self, table: Table, first: u16, count: u16, access: Access) -> bool;

    /// The bit of a coil or discrete input.
    fn bit(&self, table: Table, address: u16) -> bool;

    /// The word of a holding or input register.
    fn word(&self, table: Table, address: u16) -> u16;

    /// Writes a coil.
    fn set_bit(&mut self, address: u16, on: bool);

    /// Whether a holding register may take a value. All words of a request are checked before the first
    /// is written.
    ///
    /// # Errors
    /// The exception to answer, mostly [`Exception::IllegalDataValue`]; then nothing is written.
    fn check_word(&self, address: u16, value: u16) -> Result<(), Exception>;

    /// Writes a holding register with a value that [`check_word`](Device::check_word) has accepted.
    fn set_word(&mut self, address: u16, value: u16);

    /// All words of a request have been written.
    fn words_are_set(&mut self) {}

    /// Takes a block that function 16 writes from `first` on, 2 to 246 bytes, as it was sent: each word's
    /// high byte first. `None`: no window for blocks begins there, so these are registers, and
    /// [`has`](Device::has) is asked about them.
    ///
    /// It is called once for each request, in [`begin`](crate::begin), before anything else is asked.
    fn take(&mut self, first: u16, data: &[u8]) -> Option<Result<(), Exception>> {
        let _ = (first, data);
        None
    }

    /// Byte `index` of an identification text: `object` is 0 for the vendor's name, 1 for the product
    /// code, 2 for the version. `None` behind its end. It is asked byte by byte, so texts need not stand
    /// in RAM; of a text, the first 80 bytes are sent.
    fn identification(&self, object: u8, index: u8) -> Option<u8>;
}
