//! How an exchange begins: a request is validated, and answered or left to be done in slices.

use crate::exchange::Exchange;
use crate::frame::{FIXED, Frame, demand, operands, refuse, word};
use crate::{Access, Addresses, Device, Exception, Table, identification};

impl Exchange {
    /// Validates the request in the first `length` bytes of `frame`, from now this one. `None`: it is valid, its
    /// addresses exist, and [`fill`](Exchange::fill) does it. `Some`: it has been answered, by a reply of that length in
    /// the frame, at most 254, the CRC not among them; or by nothing, 0.
    ///
    /// Its address is 0 or the server's own; its CRC was right and is not counted, so `length` is at most
    /// 254. A refusal and the identification are answered here, a block is taken here; all reads and writes,
    /// of one as of several, are for [`fill`](Exchange::fill). What is to be written to registers is checked here, all
    /// of it.
    ///
    /// Of the device it calls [`take`](Device::take), [`has`](Device::has) and
    /// [`check_words`](Device::check_words), each once at most and in this order, or
    /// [`identification`](Device::identification) for each byte of its texts and once after each.
    #[inline(never)]
    pub fn begin<D: Device>(
        &mut self,
        frame: &mut Frame,
        length: u8,
        device: &mut D,
    ) -> Option<u8> {
        let [address, function, ..] = *frame;
        let identifies = function == identification::FUNCTION;
        let reads = function <= Table::InputRegisters as u8 || identifies;
        if length < 2 || address == 0 && reads {
            return Some(0);
        }
        let outcome = if identifies {
            identification::answer(frame, length, device).map(Some)
        } else {
            self.take(frame, length, device).map(|()| None)
        };
        outcome.unwrap_or_else(|exception| Some(refuse(frame, exception)))
    }

    /// Reads and writes: sections 6.1 to 6.6, 6.11 and 6.12.
    fn take<D: Device>(
        &mut self,
        frame: &mut Frame,
        length: u8,
        device: &mut D,
    ) -> Result<(), Exception> {
        let function = frame[1];
        let table = match function {
            1 | 5 | 15 => Table::Coils,
            2 => Table::DiscreteInputs,
            3 | 6 | 16 => Table::HoldingRegisters,
            4 => Table::InputRegisters,
            _ => return Err(Exception::IllegalFunction),
        };
        let words = table.has_words();
        let several = function >= 15;
        let (count, at) = operands(frame);
        // 2000 bits or 125 words to be read, 1968 or 123 to be written: as many bytes.
        let most = if several { 123 } else { 125 };
        let last = count.wrapping_sub(1);
        let (last_byte, most) = if words {
            (last, most)
        } else {
            (last >> 3, 2 * most)
        };
        let mut bytes = (last_byte as u8).wrapping_add(1);
        if words {
            bytes = bytes.wrapping_mul(2);
        }
        let end = if several {
            at.wrapping_add(bytes)
        } else {
            FIXED
        };
        demand(
            last_byte < most
                && length == end
                && match function {
                    5 => matches!(frame[4], 0 | 0xFF) && frame[5] == 0,
                    15 | 16 => frame[6] == bytes,
                    _ => true,
                },
        )?;

        let first = word(frame, 2);
        let reads = function <= Table::InputRegisters as u8;
        self.addresses = Addresses {
            table,
            access: if reads { Access::Read } else { Access::Write },
            first,
            count,
        };
        self.at = at;
        if first.checked_add(last).is_none() {
            return Err(Exception::IllegalDataAddress);
        }
        let data = frame.get(at.into()..length.into()).unwrap_or_default();
        if function == 16
            && let Some(taken) = device.take(first, data)
        {
            self.addresses.count = 0;
            return taken;
        }
        if !device.has(&self.addresses) {
            return Err(Exception::IllegalDataAddress);
        }
        if reads {
            frame[2] = bytes;
            self.at = 3;
        } else if words {
            device.check_words(first, data.as_chunks().0)?;
        }
        Ok(())
    }
}
