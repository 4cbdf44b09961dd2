//! Assembly as LLVM prints it for AVR: functions of lines, and what stands between them.
//!
//! Only functions of the compiler are taken apart. It ends each of them by a label `.Lfunc_end…`, which
//! hand-written assembly does not have, so that one passes as it is.

use std::fmt;

use super::operands::normalise;

/// The assembly of a whole firmware.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Unit {
    /// In the order of the file.
    pub items: Vec<Item>,
}

/// A piece of a [`Unit`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Item {
    /// Lines that pass as they are: data, directives, hand-written functions.
    Verbatim(Vec<String>),
    /// A function of the compiler's.
    Function(Function),
}

/// A function of the compiler's, in a section of its own.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Function {
    /// Its symbol.
    pub name: String,
    /// From the directive of its section to its own label.
    pub head: Vec<String>,
    /// Its code.
    pub body: Vec<Line>,
    /// Its end label and its size.
    pub foot: Vec<String>,
}

/// A line of a function.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Line {
    /// A label, without its colon.
    Label(String),
    /// An instruction of the compiler's.
    Code(Code),
    /// An instruction of an `asm!` block: no rule changes it, or moves anything past it.
    Fixed(Code),
    /// What takes no room: comments, `.globl`.
    Other(String),
}

/// An instruction: mnemonic and operands.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Code {
    /// Its mnemonic, in small letters.
    pub name: String,
    /// Its operands, each in the one spelling that [`operands`](super::operands) gives it.
    pub operands: Vec<String>,
}

impl Code {
    /// An instruction of its text, as `ldd r24, Y+3`. Comments are dropped, and operands take the spelling
    /// that LLVM prints.
    pub fn parse(text: &str) -> Self {
        let text = text.split(';').next().unwrap_or("").trim();
        let (name, rest) = text.split_once(char::is_whitespace).unwrap_or((text, ""));
        let name = name.to_ascii_lowercase();
        let mut operands: Vec<String> = rest
            .split(',')
            .map(|operand| operand.trim().to_owned())
            .filter(|operand| !operand.is_empty())
            .collect();
        normalise(&name, &mut operands);
        Code { name, operands }
    }

    /// Whether it is exactly this text.
    pub fn is(&self, text: &str) -> bool {
        *self == Code::parse(text)
    }

    /// Its operand `n`, or an empty text.
    pub fn operand(&self, n: usize) -> &str {
        self.operands.get(n).map_or("", String::as_str)
    }
}

impl Line {
    /// An instruction of the compiler's, from its text.
    pub fn code(text: &str) -> Self {
        Line::Code(Code::parse(text))
    }

    /// The instruction on this line, whoever wrote it.
    pub fn instruction(&self) -> Option<&Code> {
        match self {
            Line::Code(code) | Line::Fixed(code) => Some(code),
            Line::Label(_) | Line::Other(_) => None,
        }
    }
}

impl Unit {
    /// Takes assembly apart. Putting it together again gives the same code.
    pub fn parse(text: &str) -> Self {
        let lines: Vec<&str> = text.lines().collect();
        let mut unit = Unit::default();
        let mut between: Vec<String> = Vec::new();
        let mut n = 0;
        while let Some(&line) = lines.get(n) {
            match function_at(&lines, n, &mut between) {
                Some((function, next)) => {
                    if !between.is_empty() {
                        unit.items
                            .push(Item::Verbatim(std::mem::take(&mut between)));
                    }
                    unit.items.push(Item::Function(function));
                    n = next;
                }
                None => {
                    between.push(line.to_owned());
                    n += 1;
                }
            }
        }
        if !between.is_empty() {
            unit.items.push(Item::Verbatim(between));
        }
        unit
    }

    /// The functions of the compiler's, in order.
    pub fn functions(&self) -> impl Iterator<Item = &Function> {
        self.items.iter().filter_map(|item| match item {
            Item::Function(function) => Some(function),
            Item::Verbatim(_) => None,
        })
    }

    /// The same, to be changed.
    pub fn functions_mut(&mut self) -> impl Iterator<Item = &mut Function> {
        self.items.iter_mut().filter_map(|item| match item {
            Item::Function(function) => Some(function),
            Item::Verbatim(_) => None,
        })
    }
}

/// The function whose label is line `n`, and the line after it. Its directives are taken from `between`.
fn function_at(lines: &[&str], n: usize, between: &mut Vec<String>) -> Option<(Function, usize)> {
    let name = label(lines.get(n)?)?;
    let kind = format!("\t.type\t{name},@function");
    let section = between
        .iter()
        .rposition(|line| line.starts_with("\t.section\t"))?;
    if !between.get(section..)?.contains(&kind) {
        return None;
    }
    let size = format!("\t.size\t{name}, ");
    let length = lines.get(n..)?.iter().position(|l| l.starts_with(&size))?;
    let (body, end) = lines.get(n + 1..=n + length)?.split_at(length - 2);
    if !end.first()?.starts_with(".Lfunc_end") {
        return None;
    }
    let function = Function {
        name: name.to_owned(),
        body: body_of(body)?,
        foot: end.iter().map(|line| (*line).to_owned()).collect(),
        head: between
            .drain(section..)
            .chain([format!("{name}:")])
            .collect(),
    };
    Some((function, n + length + 1))
}

/// The lines of a body; `None` if there is a directive among them that takes room.
pub fn body_of(lines: &[&str]) -> Option<Vec<Line>> {
    let mut by_hand = false;
    lines
        .iter()
        .map(|line| {
            let text = line.trim();
            match text {
                ";APP" => by_hand = true,
                ";NO_APP" => by_hand = false,
                _ => {}
            }
            Some(match label(line) {
                Some(name) => Line::Label(name.to_owned()),
                None if text.is_empty() || text.starts_with(';') || text.starts_with(".globl") => {
                    Line::Other((*line).to_owned())
                }
                None if text.starts_with('.') => return None,
                None if by_hand => Line::Fixed(Code::parse(text)),
                None => Line::code(text),
            })
        })
        .collect()
}

/// The label that a line is.
fn label(line: &str) -> Option<&str> {
    let name = line.split(';').next()?.trim_end().strip_suffix(':')?;
    let plain = |c: char| !c.is_whitespace() && c != ':';
    (!name.is_empty() && name.chars().all(plain)).then_some(name)
}

impl fmt::Display for Unit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut write = |lines: &[String]| {
            lines
                .iter()
                .try_for_each(|line| f.write_fmt(format_args!("{line}\n")))
        };
        for item in &self.items {
            match item {
                Item::Verbatim(lines) => write(lines)?,
                Item::Function(function) => {
                    write(&function.head)?;
                    let body: Vec<String> = function.body.iter().map(ToString::to_string).collect();
                    write(&body)?;
                    write(&function.foot)?;
                }
            }
        }
        Ok(())
    }
}

impl fmt::Display for Line {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Line::Label(name) => write!(f, "{name}:"),
            Line::Code(code) | Line::Fixed(code) => write!(f, "\t{code}"),
            Line::Other(text) => f.write_str(text),
        }
    }
}

impl fmt::Display for Code {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.name)?;
        for (n, operand) in self.operands.iter().enumerate() {
            f.write_str(if n == 0 { "\t" } else { ", " })?;
            f.write_str(operand)?;
        }
        Ok(())
    }
}
