//! The identification, function 43/14, which `rmodbus` does not know.

use std::fmt;
use unoclp_modbus::Crc;

/// The function code.
pub(crate) const FUNCTION: u8 = 0x2B;

/// What a board says that it is.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Identity {
    /// The vendor's name.
    pub vendor: String,
    /// The product.
    pub product: String,
    /// The version.
    pub version: String,
}

impl fmt::Display for Identity {
    /// `unoclp UNO 0.1.0`
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let texts = [&*self.product, &*self.version];
        f.write_str(texts.join(" ").trim())
    }
}

impl Identity {
    /// From a whole answer; none where it does not hold all three.
    pub(crate) fn of(reply: &[u8]) -> Option<Identity> {
        let objects = reply.get(8..reply.len().checked_sub(2)?)?;
        let mut texts = Texts(objects).map(|text| String::from_utf8_lossy(text).into_owned());
        Some(Identity {
            vendor: texts.next()?,
            product: texts.next()?,
            version: texts.next()?,
        })
    }
}

/// The request for all three, with its check sum.
pub(crate) fn request(address: u8) -> Vec<u8> {
    let mut request = vec![address, FUNCTION, 14, 1, 0];
    request.extend(Crc::of(&request).to_bytes());
    request
}

/// How many bytes an answer that begins so has; none where that is not yet told.
pub(crate) fn length(reply: &[u8]) -> Option<usize> {
    let &[_, _, _, _, _, _, _, objects, ref rest @ ..] = reply else {
        return None;
    };
    let mut texts = Texts(rest);
    let count = usize::from(objects);
    let all = texts.by_ref().take(count).count() == count;
    all.then(|| reply.len() - texts.0.len() + 2)
}

/// The texts of an identification: number, length, bytes.
struct Texts<'r>(&'r [u8]);

impl<'r> Iterator for Texts<'r> {
    type Item = &'r [u8];

    fn next(&mut self) -> Option<&'r [u8]> {
        let [_, length, rest @ ..] = self.0 else {
            return None;
        };
        let (text, rest) = rest.split_at_checked((*length).into())?;
        self.0 = rest;
        Some(text)
    }
}
