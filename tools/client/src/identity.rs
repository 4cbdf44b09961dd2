//! What a board says that it is.

use crate::map::PRODUCT;
use std::fmt;
use unoclp_core::Board;
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
    /// The board that it is, by the last word of its product; none that this client does not know.
    pub fn board(&self) -> Option<Board> {
        let [own, _] = PRODUCT.rsplit_once(' ').map(|(own, board)| [own, board])?;
        let name = self.product.strip_prefix(own)?.trim_start();
        Board::ALL
            .into_iter()
            .find(|board| board.has_firmware() && board.name == name)
    }

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
