//! A program file as it was read: a claim, in one of its languages, until it is checked.
//!
//! Owns which language that is. Must not know what either means: `unoclp-checked` and `unoclp-lang` do.

use crate::{Language, NoProgram, Size, Source, WrittenIn, decode};
use std::path::Path;
use unoclp_checked::{Checked, Diagnosis, SourceMap, numeric};
use unoclp_core::{Board, Fault};
use unoclp_lang::{
    Adapted, Colour, Dialect, Options, Span, TextLanguage, Told, adapt, colours, compile,
};

/// A program file. Its language is known, if it has one, and nothing else.
#[derive(Clone, Debug, PartialEq)]
pub struct Written {
    /// What it is called.
    pub name: String,
    /// The bytes of the file.
    pub bytes: Vec<u8>,
    /// What it is written in.
    pub language: Result<WrittenIn, NoProgram>,
    /// The board that it is checked for.
    pub board: Board,
}

/// Why a file is no program.
#[derive(Debug)]
pub enum Refused {
    /// It is in none of the languages.
    NoProgram {
        /// What the file is called.
        name: String,
        /// What it is instead.
        why: NoProgram,
    },
    /// The faults of numeric code.
    Numeric {
        /// The file that has them.
        written: Box<Written>,
        /// At least one, in the order in which they are found.
        faults: Vec<Diagnosis>,
    },
    /// The errors of a text, and its warnings.
    Text {
        /// What the file is called.
        name: String,
        /// Its text.
        text: String,
        /// At least one error, in the order of their places.
        diagnostics: Told,
    },
}

impl Written {
    /// A file of this name, whose language its name and its text tell, for this board.
    pub fn new(name: String, bytes: Vec<u8>, board: Board) -> Written {
        Written {
            language: WrittenIn::of(Path::new(&name), &bytes),
            name,
            bytes,
            board,
        }
    }

    /// The same in the language that somebody says it is in, if anybody does.
    pub fn or_in(mut self, language: Option<WrittenIn>) -> Written {
        if let Some(language) = language {
            self.language = Ok(language);
        }
        self
    }

    /// What a person reads and changes.
    pub fn text(&self) -> String {
        decode(&self.bytes)
    }

    /// Whether it is a text that is compiled.
    pub fn is_text(&self) -> bool {
        matches!(
            self.language,
            Ok(WrittenIn::Il | WrittenIn::Typed(_) | WrittenIn::Xml)
        )
    }

    /// Compiles and checks it. `dialect` says whose Instruction List it is; none: what the text looks like.
    ///
    /// # Errors
    /// All that is wrong with it.
    pub fn check(self, dialect: Option<Dialect>) -> Result<Source, Refused> {
        match self.language {
            Ok(WrittenIn::Numeric) => self.numeric(),
            Ok(WrittenIn::Il) => self.compiled(TextLanguage::Il, dialect),
            Ok(WrittenIn::Typed(language)) => self.compiled(language, None),
            Ok(WrittenIn::Xml) => self.xml(),
            Err(why) => Err(self.none(why)),
        }
    }

    /// Its text with a free point of the board in the place of each that the board lacks; none in a language whose points
    /// are names of its own.
    ///
    /// # Errors
    /// If it is no program in any of the languages.
    pub fn adapted(&self) -> Result<Option<Adapted>, NoProgram> {
        let text = decode(&self.bytes);
        let language = self.language?;
        if text.trim().is_empty() {
            return Err(NoProgram::Empty);
        }
        Ok(match language {
            WrittenIn::Il => adapt(&text, TextLanguage::Il, self.board),
            WrittenIn::Typed(language) => adapt(&text, language, self.board),
            WrittenIn::Xml => unoclp_plcopen::adapt(&text, self.board),
            WrittenIn::Numeric => None,
        })
    }

    fn none(self, why: NoProgram) -> Refused {
        let name = self.name;
        Refused::NoProgram { name, why }
    }

    /// The same without any compiler: none for a text that takes one.
    ///
    /// # Errors
    /// All that is wrong with it.
    pub fn check_numeric(self) -> Option<Result<Source, Refused>> {
        match self.language {
            Ok(WrittenIn::Numeric) => Some(self.numeric()),
            Ok(_) => None,
            Err(why) => Some(Err(self.none(why))),
        }
    }

    /// The same of Instruction List of the standard, of which it is known what it comes to: its numeric code, and where the
    /// steps of that stand in it.
    ///
    /// # Errors
    /// The first fault of that code.
    pub fn known(self, code: &str, map: SourceMap) -> Result<Source, Fault> {
        let checked = Checked::read(code.as_bytes(), self.board)?;
        Ok(Source {
            name: self.name,
            text: decode(&self.bytes),
            code: code.as_bytes().to_vec(),
            language: Language::Il {
                dialect: Dialect::Iec,
                warnings: Told::default(),
            },
            size: Size::of(checked.program()),
            map,
            variables: Vec::new(),
            traces: Vec::new(),
            charts: Vec::new(),
            origins: Vec::new(),
            checked,
        })
    }

    /// The coloured parts of its text, in the order of their places.
    pub fn colours(&self) -> Vec<(Span, Colour)> {
        match self.language {
            Ok(WrittenIn::Il) => colours(&decode(&self.bytes), TextLanguage::Il),
            Ok(WrittenIn::Typed(language)) => colours(&decode(&self.bytes), language),
            Ok(WrittenIn::Numeric | WrittenIn::Xml) | Err(_) => self.colours_numeric(),
        }
    }

    /// The same of numeric code alone: none for a text in another language.
    pub fn colours_numeric(&self) -> Vec<(Span, Colour)> {
        match self.language {
            Ok(WrittenIn::Numeric) => crate::colours::numeric(&decode(&self.bytes)),
            _ => Vec::new(),
        }
    }

    fn numeric(self) -> Result<Source, Refused> {
        let (checked, map) = match numeric(&self.bytes, self.board) {
            Ok(read) => read,
            Err(faults) => {
                let written = Box::new(self);
                return Err(Refused::Numeric { written, faults });
            }
        };
        Ok(Source {
            name: self.name,
            text: String::from_utf8_lossy(&self.bytes).into_owned(),
            code: self.bytes,
            language: Language::Numeric,
            size: Size::of(checked.program()),
            map,
            variables: Vec::new(),
            traces: Vec::new(),
            charts: Vec::new(),
            origins: Vec::new(),
            checked,
        })
    }

    fn xml(self) -> Result<Source, Refused> {
        let text = decode(&self.bytes);
        let made = unoclp_plcopen::import(&text, self.board);
        let diagnostics = made.diagnostics;
        let (Some(code), Some((checked, map))) = (made.code, made.program) else {
            return Err(Refused::Text {
                name: self.name,
                text,
                diagnostics,
            });
        };
        Ok(Source {
            name: self.name,
            text,
            code: code.into_bytes(),
            language: Language::Xml {
                warnings: diagnostics,
            },
            size: Size::of(checked.program()),
            map,
            variables: made.variables,
            traces: made.traces,
            charts: made.charts,
            origins: made.origins,
            checked,
        })
    }

    fn compiled(self, language: TextLanguage, dialect: Option<Dialect>) -> Result<Source, Refused> {
        let text = decode(&self.bytes);
        let board = self.board;
        let mut made = compile(&text, language, &Options { dialect, board });
        let code = made.file();
        let (variables, traces) = made.take_shown();
        let warnings = made.diagnostics;
        let (Some(code), Some((checked, map))) = (code, made.program) else {
            return Err(Refused::Text {
                name: self.name,
                text,
                diagnostics: warnings,
            });
        };
        let charts = match language == TextLanguage::St {
            true => unoclp_sfc::Document::all(&text),
            false => Vec::new(),
        };
        let origins = charts.iter().map(|of| of.origins(map.at())).collect();
        Ok(Source {
            name: self.name,
            text,
            code: code.into_bytes(),
            language: match made.dialect {
                Some(dialect) => Language::Il { dialect, warnings },
                None => Language::Typed { language, warnings },
            },
            size: Size::of(checked.program()),
            map,
            variables,
            traces,
            charts,
            origins,
            checked,
        })
    }
}
