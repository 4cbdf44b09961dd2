//! Problems of a text, with their places as an editor in a browser counts them: in UTF-16 units.

use crate::answer::answer;
use crate::words::{self, Both, both};
use unoclp_lang::{Colour, Diagnostic, Lines, Severity, Span, Told};
use unoclp_program::diagnosis::tell;
use unoclp_program::{Lang, Refused, Seal, Source, WrittenIn};

answer! {
    /// What is wrong with a text, or worth a second look.
    pub struct Problem as "Problem" {
        /// `IL-11`, `ST-101`, or the number of a fault.
        number: String,
        /// `error` or `warning`.
        severity: &'static str => "\"error\" | \"warning\"",
        /// From 1; a column is a character.
        line: u32,
        column: u32,
        /// Units of UTF-16 from the beginning of the text.
        from: usize,
        to: usize,
        message: Both,
        /// What to do; empty where there is nothing to say.
        help: Both,
    }
}

/// The problems of a text that is no program, and how many more there are.
pub fn problems(text: &str, refused: &Refused) -> (Vec<Problem>, usize) {
    match refused {
        Refused::NoProgram { why, .. } => {
            let nothing = Problem {
                number: String::new(),
                severity: "error",
                line: 1,
                column: 1,
                from: 0,
                to: 0,
                message: both(|lang| words::no_program(lang, *why)),
                help: both(|lang| words::languages(lang, WrittenIn::programs(lang))),
            };
            (vec![nothing], 0)
        }
        Refused::Text {
            text, diagnostics, ..
        } => told(text, diagnostics),
        Refused::Numeric { written, faults } => {
            let starts = LineStarts::new(text);
            let problems = faults.iter().take(MOST).map(|fault| {
                let [en, pt] = [Lang::En, Lang::Pt].map(|lang| tell(&written.bytes, fault, lang));
                let line = en.line.unwrap_or(1);
                let (from, to) = starts.span(line, en.columns.start, en.columns.end);
                Problem {
                    number: fault.fault.cause.number().to_string(),
                    severity: "error",
                    line,
                    column: en.columns.start as u32 + 1,
                    from,
                    to,
                    message: Both {
                        en: en.message.to_owned(),
                        pt: pt.message.to_owned(),
                    },
                    help: Both {
                        en: en.help.unwrap_or_default(),
                        pt: pt.help.unwrap_or_default(),
                    },
                }
            });
            (problems.collect(), faults.len().saturating_sub(MOST))
        }
    }
}

/// The first error of such a text: its line, and what it says, with what to do.
pub fn first_error(text: &str, refused: &Refused) -> Option<(u32, Both)> {
    let (problems, _) = problems(text, refused);
    let first = problems.into_iter().find(|one| one.severity == "error")?;
    let whole = |message: String, help: String| match help.is_empty() {
        true => message,
        false => format!("{message} ({help})"),
    };
    let Problem { message, help, .. } = first;
    let told = Both {
        en: whole(message.en, help.en),
        pt: whole(message.pt, help.pt),
    };
    Some((first.line, told))
}

/// What is worth a second look in a program, and how much more of it there is.
pub fn warnings(source: &Source) -> (Vec<Problem>, usize) {
    match source.language.warnings() {
        Some(warnings) => told(&source.text, warnings),
        None => (seal(source).into_iter().collect(), 0),
    }
}

/// That the seal of a program file does not hold, told in its last line.
fn seal(source: &Source) -> Option<Problem> {
    let seal = source.seal();
    let [en, pt] = [Lang::En, Lang::Pt].map(|lang| seal.told(lang));
    let ([en, en_help], [pt, pt_help]) = (en?, pt?);
    let line = source.text.lines().count().max(1) as u32;
    let (from, to) = LineStarts::new(&source.text).span(line, 0, usize::MAX);
    Some(Problem {
        number: String::new(),
        severity: if seal == Seal::Cut {
            "error"
        } else {
            "warning"
        },
        line,
        column: 1,
        from,
        to,
        message: Both { en, pt },
        help: Both {
            en: en_help,
            pt: pt_help,
        },
    })
}

/// Parts of a text, each by three numbers: the units since the end of the one before, its own units, and what it is: 0 a
/// comment, 1 a text, 2 a point, 3 a number, 4 a word of the language.
pub fn colours(text: &str, parts: &[(Span, Colour)]) -> Vec<u32> {
    let mut units = Units::new(text);
    let mut behind = 0;
    let mut numbers = Vec::with_capacity(3 * parts.len());
    for (span, colour) in parts {
        let [start, end] = [span.start, span.end].map(|byte| units.of(byte as usize));
        numbers.extend([start - behind, end - start].map(|units| units as u32));
        numbers.push(match colour {
            Colour::Comment => 0,
            Colour::Text => 1,
            Colour::Point => 2,
            Colour::Number => 3,
            Colour::Word => 4,
        });
        behind = end;
    }
    numbers
}

/// More faults than this are only counted.
const MOST: usize = 100;

fn told(text: &str, told: &Told) -> (Vec<Problem>, usize) {
    let lines = Lines::new(text);
    let mut units = Units::new(text);
    let problem = |diagnostic: &Diagnostic| {
        let span = diagnostic.span;
        let (line, column) = lines.place(text, span.start);
        Problem {
            number: diagnostic.code.to_string(),
            severity: match diagnostic.severity() {
                Severity::Error => "error",
                Severity::Warning => "warning",
            },
            line,
            column,
            from: units.of(span.start as usize),
            to: Units { ..units }.of(span.end as usize),
            message: both(|lang| diagnostic.message(lang)),
            help: both(|lang| diagnostic.help(lang)),
        }
    };
    (told.iter().map(problem).collect(), told.more)
}

/// Counts the units of UTF-16 before a byte, from the byte that was asked for last.
#[derive(Clone, Copy)]
pub struct Units<'t> {
    text: &'t str,
    byte: usize,
    unit: usize,
}

impl<'t> Units<'t> {
    /// Of this text, from its beginning on.
    pub fn new(text: &'t str) -> Units<'t> {
        Units {
            text,
            byte: 0,
            unit: 0,
        }
    }

    /// The units before this byte.
    pub fn of(&mut self, byte: usize) -> usize {
        if byte < self.byte {
            (self.byte, self.unit) = (0, 0);
        }
        let between = self.text.get(self.byte..byte).unwrap_or_default();
        self.unit += between.encode_utf16().count();
        self.byte = byte;
        self.unit
    }
}

/// The byte at which a unit of UTF-16 begins; the text's end where it has not so many.
#[cfg(feature = "full")]
pub fn byte(text: &str, unit: usize) -> u32 {
    let mut units = 0;
    for (at, character) in text.char_indices() {
        if units >= unit {
            return at as u32;
        }
        units += character.len_utf16();
    }
    text.len() as u32
}

/// Where the lines of a text begin.
struct LineStarts<'t>(Vec<(usize, &'t str)>);

impl<'t> LineStarts<'t> {
    fn new(text: &'t str) -> LineStarts<'t> {
        let mut unit = 0;
        let line = |line: &'t str| {
            let start = unit;
            unit += line.encode_utf16().count();
            (start, line)
        };
        LineStarts(text.split_inclusive('\n').map(line).collect())
    }

    /// Units from the beginning of the text, for characters of a line.
    fn span(&self, line: u32, from: usize, to: usize) -> (usize, usize) {
        let index = (line as usize).saturating_sub(1);
        let Some(&(start, line)) = self.0.get(index).or(self.0.last()) else {
            return (0, 0);
        };
        let at = |column| {
            line.chars()
                .take(column)
                .map(char::len_utf16)
                .sum::<usize>()
        };
        (start + at(from), start + at(to))
    }
}
