//! What a board says that it is.

use std::fmt;
use unoclp_modbus::client::Texts;

/// The identification of a board.
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
    /// From the texts of an answer; none if they are not all three.
    pub fn of(texts: Texts<'_>) -> Option<Identity> {
        let mut texts = texts.map(|text| String::from_utf8_lossy(text).into_owned());
        Some(Identity {
            vendor: texts.next()?,
            product: texts.next()?,
            version: texts.next()?,
        })
    }
}
