//! A program as a person has written it: as numeric code, or as Instruction List, which is compiled.

use crate::{BOARD, decode};
use unoclp_lang::{Compiled, Dialect, Options, compile};

/// A program with the text that it comes from.
#[derive(Clone, Debug)]
pub struct Written {
    /// What it is called.
    pub name: String,
    /// Its numeric code, as it stands on a card.
    pub bytes: Vec<u8>,
    /// What a person reads and changes.
    pub text: String,
    /// What has come of the text where it is Instruction List.
    pub compiled: Option<Compiled>,
}

impl Written {
    /// A program that was written as numeric code. It may have faults.
    pub fn numeric(name: String, bytes: Vec<u8>) -> Written {
        Written {
            text: String::from_utf8_lossy(&bytes).into_owned(),
            name,
            bytes,
            compiled: None,
        }
    }

    /// A program that was written as Instruction List. It has no code where the text has errors.
    pub fn il(name: String, file: &[u8], dialect: Option<Dialect>) -> Written {
        let text = decode(file);
        let options = Options {
            dialect,
            board: BOARD,
        };
        let compiled = compile(&text, &options);
        Written {
            name,
            bytes: compiled.file().unwrap_or_default().into_bytes(),
            text,
            compiled: Some(compiled),
        }
    }

    /// The line of the text that a line of the numeric code comes from, each from 1.
    pub fn line(&self, code: u32) -> Option<u32> {
        match &self.compiled {
            None => Some(code),
            // The compiler writes one code on each line.
            Some(compiled) => compiled.lines.get((code as usize).checked_sub(1)?)?.source,
        }
    }
}
