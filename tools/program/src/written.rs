//! A program file as it was read: a claim, in one of its languages, until it is checked.
//!
//! Owns which language that is. Must not know what either means: `unoclp-checked` and `unoclp-lang` do.

use crate::{Language, NoProgram, Size, Source, WrittenIn, decode};
use std::path::Path;
use unoclp_checked::{Diagnosis, numeric};
use unoclp_core::Board;
use unoclp_lang::{
    Adapted, Colour, Dialect, Options, Span, TextLanguage, Told, adapt, colours, colours_of_list,
    compile_text, compile_untyped, has_types,
};

/// A program file. Its language is known, if it has one, and nothing else.
#[derive(Clone, Debug)]
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

/// How a program file becomes a program.
enum Way {
    /// Its codes are read as they are.
    Numeric,
    /// By the compiler of Instruction List.
    List,
    /// By way of the typed tree.
    Typed(TextLanguage),
    /// A project, by what its programs are.
    Xml,
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
        match self.way() {
            Ok(Way::Numeric) => self.numeric(),
            Ok(Way::List) => self.compiled(dialect),
            Ok(Way::Typed(language)) => self.typed(language),
            Ok(Way::Xml) => self.xml(),
            Err(why) => Err(self.none(why)),
        }
    }

    /// Whether it goes by way of the typed tree: a text in a typed language, Instruction List with types, or a project,
    /// which may hold either.
    pub fn is_typed(&self) -> bool {
        matches!(self.way(), Ok(Way::Typed(_) | Way::Xml))
    }

    fn way(&self) -> Result<Way, NoProgram> {
        Ok(match self.language? {
            WrittenIn::Numeric => Way::Numeric,
            WrittenIn::Il if has_types(&decode(&self.bytes)) => Way::Typed(TextLanguage::Il),
            WrittenIn::Il => Way::List,
            WrittenIn::Typed(language) => Way::Typed(language),
            WrittenIn::Xml => Way::Xml,
        })
    }

    /// Its text with a free point of the board in the place of each that the board lacks; none in a language whose points
    /// are names of its own.
    ///
    /// # Errors
    /// If it is no program in any of the languages.
    pub fn adapted(&self) -> Result<Option<Adapted>, NoProgram> {
        let language = match self.language? {
            WrittenIn::Il => TextLanguage::Il,
            WrittenIn::Typed(language) => language,
            WrittenIn::Numeric | WrittenIn::Xml => return Ok(None),
        };
        let text = decode(&self.bytes);
        match text.trim().is_empty() {
            true => Err(NoProgram::Empty),
            false => Ok(adapt(&text, language, self.board)),
        }
    }

    fn none(self, why: NoProgram) -> Refused {
        let name = self.name;
        Refused::NoProgram { name, why }
    }

    /// The same for numeric code and Instruction List alone, without what the typed languages take: none for a text in one
    /// of those.
    ///
    /// # Errors
    /// All that is wrong with it.
    pub fn check_untyped(self) -> Option<Result<Source, Refused>> {
        match self.way() {
            Ok(Way::Numeric) => Some(self.numeric()),
            Ok(Way::List) => Some(self.compiled(None)),
            Ok(Way::Typed(_) | Way::Xml) => None,
            Err(why) => Some(Err(self.none(why))),
        }
    }

    /// The coloured parts of its text, in the order of their places.
    pub fn colours(&self) -> Vec<(Span, Colour)> {
        match self.way() {
            Ok(Way::Typed(language)) => colours(&decode(&self.bytes), language),
            _ => self.colours_untyped(),
        }
    }

    /// The same for numeric code and Instruction List alone: none for a text in another language.
    pub fn colours_untyped(&self) -> Vec<(Span, Colour)> {
        let text = decode(&self.bytes);
        match self.way() {
            Ok(Way::Numeric) => crate::colours::numeric(&text),
            Ok(Way::List) => colours_of_list(&text),
            Ok(Way::Typed(_) | Way::Xml) | Err(_) => Vec::new(),
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
            checked,
        })
    }

    fn typed(self, language: TextLanguage) -> Result<Source, Refused> {
        let text = decode(&self.bytes);
        let made = compile_text(&text, language, self.board);
        let code = made.file();
        let (Some(code), Some((checked, map))) = (code, made.program) else {
            return Err(Refused::Text {
                name: self.name,
                text,
                diagnostics: made.diagnostics,
            });
        };
        Ok(Source {
            name: self.name,
            text,
            code: code.into_bytes(),
            language: Language::Typed {
                language,
                warnings: made.diagnostics,
            },
            size: Size::of(checked.program()),
            map,
            variables: made.variables,
            traces: made.traces,
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
            checked,
        })
    }

    fn compiled(self, dialect: Option<Dialect>) -> Result<Source, Refused> {
        let text = decode(&self.bytes);
        let board = self.board;
        let compiled = compile_untyped(&text, &Options { dialect, board });
        let code = compiled.file();
        let diagnostics = compiled.diagnostics;
        let (Some(code), Some((checked, map))) = (code, compiled.program) else {
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
            language: Language::Il {
                dialect: compiled.dialect,
                warnings: diagnostics,
            },
            size: Size::of(checked.program()),
            map,
            variables: Vec::new(),
            traces: Vec::new(),
            checked,
        })
    }
}
