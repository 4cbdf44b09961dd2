//! Has the shortened assembly take the compiler's place in the link.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, ensure};

use avr_shorten::{Shortened, shorten};

use crate::budget::thousands;
use crate::shell;

/// How rustc has called the linker.
#[derive(Debug, PartialEq, Eq)]
pub struct Link {
    /// The linker and its arguments.
    words: Vec<String>,
}

impl Link {
    /// Reads what `rustc --print=link-args` has written: a shell's line, every word in quotes, with
    /// variables before the linker.
    ///
    /// # Errors
    /// If that has no words, or names no result.
    pub fn parse(printed: &str) -> Result<Self> {
        let line = printed.lines().next().unwrap_or_default();
        let mut words = Vec::new();
        let mut word: Option<String> = None;
        // Of `NAME="value"` only the value is in quotes; it is followed by the linker.
        let mut variable = false;
        let mut before = ' ';
        let mut characters = line.chars();
        while let Some(c) = characters.next() {
            match (&mut word, c) {
                (None, '"') => {
                    variable = before == '=';
                    word = Some(String::new());
                }
                (None, _) => {}
                (Some(_), '"') => words.extend(word.take().filter(|_| !variable)),
                (Some(word), '\\') => word.extend(characters.next()),
                (Some(word), _) => word.push(c),
            }
            before = c;
        }
        let link = Link { words };
        link.result()?;
        Ok(link)
    }

    /// The file that it has made: the firmware as the compiler left it.
    ///
    /// # Errors
    /// If it has no name.
    pub fn result(&self) -> Result<PathBuf> {
        let at = self.words.iter().position(|word| word == "-o");
        let name = at.and_then(|at| self.words.get(at + 1));
        name.map(PathBuf::from)
            .context("rustc does not print what it has linked")
    }

    /// The assembly of all that the compiler has compiled.
    ///
    /// # Errors
    /// If the compiler's result has no name.
    pub fn assembly(&self) -> Result<PathBuf> {
        Ok(self.result()?.with_extension("s"))
    }

    /// The same link with another object, to another result.
    ///
    /// # Errors
    /// If there is not exactly one object of the compiler's.
    fn command(&self, object: &Path, elf: &Path) -> Result<Command> {
        let compiled = |word: &&String| word.ends_with(".rcgu.o");
        let objects = self.words.iter().filter(compiled).count();
        ensure!(
            objects == 1,
            "the compiler has generated {objects} objects, not one: see [profile.firmware]"
        );
        let result = self.result()?;
        let (linker, arguments) = self.words.split_first().context("no linker")?;
        let mut command = Command::new(linker);
        // avr-gcc does not know `-no-pie`; rustc leaves it out as well, once it has seen that.
        for word in arguments.iter().filter(|word| *word != "-no-pie") {
            match word {
                _ if compiled(&word) => command.arg(object),
                _ if Path::new(word) == result => command.arg(elf),
                _ => command.arg(word),
            };
        }
        Ok(command)
    }
}

/// The compiler's assembly, beside the result of [`link`].
pub fn compiled(elf: &Path) -> PathBuf {
    elf.with_file_name("compiled.s")
}

/// Shortens what the compiler has made, and links it to `elf`, with the assembly before and after and the
/// object beside it.
///
/// # Errors
/// If a file is missing, or the assembler or the linker refuses something.
pub fn link(link: &Link, elf: &Path) -> Result<Shortened> {
    let assembly = link.assembly()?;
    let text = fs::read_to_string(&assembly)
        .with_context(|| format!("cannot read {}", assembly.display()))?;
    let (short, object) = (elf.with_extension("s"), elf.with_extension("o"));
    shell::make_folder_of(elf)?;
    let before = compiled(elf);
    fs::write(&before, &text).with_context(|| format!("cannot write {}", before.display()))?;
    let shortened = shorten(&text);
    fs::write(&short, &shortened.text)
        .with_context(|| format!("cannot write {}", short.display()))?;
    let mut assembler = Command::new("avr-gcc");
    assembler.args(["-mmcu=atmega328p", "-c"]);
    shell::run(assembler.arg(&short).arg("-o").arg(&object))?;
    shell::run(&mut link.command(&object, elf)?)?;
    Ok(shortened)
}

/// A line for each rule: the bytes that it has saved.
pub fn savings(shortened: &Shortened) -> String {
    let all: isize = shortened.saved.iter().map(|(_, bytes)| bytes).sum();
    let of = thousands(shortened.before as u64);
    let mut text = format!("shortened functions of {of} B by {all} B");
    for (name, bytes) in &shortened.saved {
        text.push_str(&format!("\n  {name:<28}{:>7} B", -bytes));
    }
    text
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::Link;

    const PRINTED: &str = r#"LC_ALL="C" PATH="/bin:/usr/bin" "avr-gcc" "/a b/deps/fw-1.fw.2-cgu.0.rcgu.o" "-lgcc" "-o" "/a b/deps/fw-1.elf" "-no-pie" "-Wl,--relax""#;

    #[test]
    fn only_object_and_result_are_replaced() {
        let link = Link::parse(PRINTED).expect("a link");
        assert_eq!(
            link.assembly().expect("a name"),
            Path::new("/a b/deps/fw-1.s")
        );
        let command = link
            .command(Path::new("short.o"), Path::new("short.elf"))
            .expect("a command");
        assert_eq!(command.get_program(), "avr-gcc");
        let arguments: Vec<_> = command.get_args().collect();
        assert_eq!(
            arguments,
            ["short.o", "-lgcc", "-o", "short.elf", "-Wl,--relax"]
        );
    }

    #[test]
    fn several_objects_are_refused() {
        let printed = PRINTED.replace("\"-lgcc\"", "\"other.rcgu.o\"");
        let link = Link::parse(&printed).expect("a link");
        assert!(link.command(Path::new("o"), Path::new("e")).is_err());
    }

    #[test]
    fn a_link_without_a_result_is_refused() {
        assert!(Link::parse("").is_err());
        assert!(Link::parse("\"avr-gcc\" \"-o\"").is_err());
    }
}
