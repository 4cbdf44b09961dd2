//! Checks a linked AVR ELF for products that LLVM has made.
//!
//! LLVM may lose the low byte of a product from r0 (`docs/avr-codegen.md`). The flags of the project keep it
//! from making products at all; but a flag can be dropped, or mean something else in another version. So each
//! instruction of the `mul` family must lie in assembly that was written by hand: here, in libgcc, or in avr-libc.
//!
//! LLVM ends each function with its size, and so does the pass that shortens them, and the libraries. Our
//! assembly gives none. So a multiplication within the extent of a function is LLVM's, unless a library is known
//! by that name.

use std::fmt;

use anyhow::{Context, Result, ensure};
use object::{Object, ObjectSection, ObjectSymbol, SectionFlags, SymbolKind, elf};

/// The functions of libgcc and avr-libc that multiply, as far as the linker takes them from there.
const LIBRARIES: [&str; 6] = [
    "__mulsi3",
    "__muluhisi3",
    "__umulhisi3",
    "__usmulhisi3",
    "__mulhisi3",
    "__mulsf3x",
];

/// Where the multiplications of an ELF are.
#[derive(Debug, Default, PartialEq, Eq)]
pub struct Report {
    /// How many there are.
    pub products: usize,
    /// Address and function of those that were not written by hand.
    pub foreign: Vec<(u64, String)>,
}

/// Checks an ELF and prints the result.
///
/// # Errors
/// If LLVM has made a product in it, or it is no AVR ELF with symbols.
pub fn accept(elf: &[u8]) -> Result<()> {
    let report = check(elf)?;
    println!("{report}");
    ensure!(
        report.foreign.is_empty(),
        "the compiler has made products, and may have lost some: see docs/avr-codegen.md. Do not run this \
         build; build it with the flags of .cargo/config.toml"
    );
    Ok(())
}

/// Looks at all code of an ELF.
///
/// # Errors
/// If it is no AVR ELF, or was stripped of its symbols.
pub fn check(bytes: &[u8]) -> Result<Report> {
    let file = object::File::parse(bytes).context("this is no ELF file")?;
    ensure!(
        file.architecture() == object::Architecture::Avr,
        "this ELF is for {:?}, not for AVR",
        file.architecture()
    );
    let mut report = Report::default();
    let mut functions = 0;
    for section in file.sections() {
        let SectionFlags::Elf { sh_flags } = section.flags() else {
            continue;
        };
        if sh_flags & u64::from(elf::SHF_EXECINSTR) == 0 {
            continue;
        }
        // The extents of functions, and of constants.
        let (mut extents, mut constants) = (Vec::new(), Vec::new());
        for symbol in file.symbols() {
            if symbol.section_index() != Some(section.index()) {
                continue;
            }
            let extent = symbol.address()..symbol.address() + symbol.size();
            match symbol.kind() {
                SymbolKind::Data => constants.push(extent),
                _ => extents.push((extent, symbol.name()?)),
            }
            functions += usize::from(symbol.kind() == SymbolKind::Text);
        }
        let is_constant = |at| constants.iter().any(|extent| extent.contains(&at));
        for at in products(section.address(), section.data()?, is_constant) {
            report.products += 1;
            let around = extents.iter().find(|(extent, _)| extent.contains(&at));
            if let Some((_, name)) = around.filter(|(_, name)| !LIBRARIES.contains(name)) {
                let name = format!("{:#}", rustc_demangle::demangle(name));
                report.foreign.push((at, name));
            }
        }
    }
    ensure!(
        functions > 0,
        "this ELF has no function symbols: link it without stripping them"
    );
    Ok(report)
}

/// The addresses of all multiplications in some code.
fn products(start: u64, code: &[u8], is_constant: impl Fn(u64) -> bool) -> Vec<u64> {
    let mut found = Vec::new();
    let mut second = false;
    for (address, word) in (start..).step_by(2).zip(code.as_chunks().0) {
        let word = u16::from_le_bytes(*word);
        if second || is_constant(address) {
            second = false;
            continue;
        }
        second = is_long(word);
        if is_product(word) {
            found.push(address);
        }
    }
    found
}

/// `mul`, `muls`, `mulsu`, `fmul`, `fmuls`, `fmulsu`.
fn is_product(word: u16) -> bool {
    word & 0xFC00 == 0x9C00 || word & 0xFE00 == 0x0200
}

/// `lds`, `sts`, `jmp`, `call` have a second word.
fn is_long(word: u16) -> bool {
    word & 0xFC0F == 0x9000 || word & 0xFE0C == 0x940C
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (address, function) in &self.foreign {
            writeln!(
                f,
                "{address:#06x} in {function}: a product of the compiler's"
            )?;
        }
        let by_hand = self.products - self.foreign.len();
        write!(
            f,
            "{} products, {by_hand} of them written by hand",
            self.products
        )
    }
}

#[cfg(test)]
mod tests {
    use super::products;

    #[test]
    fn every_multiplication_is_found_and_nothing_else() {
        #[rustfmt::skip]
        let cases: [(&str, &[u16], &[u64]); 9] = [
            ("mul r24, r25", &[0x9F89], &[0]),
            ("mul r0, r1; mul r31, r31", &[0x9C01, 0x9FFF], &[0, 2]),
            ("muls r24, r25", &[0x0289], &[0]),
            ("mulsu, fmul, fmuls, fmulsu r16, r17", &[0x0301, 0x0309, 0x0381, 0x0389], &[0, 2, 4, 6]),
            ("movw r24, r0; cpc r1, r1; adc r24, r25", &[0x01C0, 0x0411, 0x1F89], &[]),
            ("the second word of lds r24, 0x9F89", &[0x9180, 0x9F89, 0x9F89], &[4]),
            ("the second word of sts 0x0289, r24", &[0x9380, 0x0289], &[]),
            ("the second word of call, of jmp", &[0x940E, 0x9F89, 0x940C, 0x0289], &[]),
            ("adiw r24, 1; ijmp; ret", &[0x9601, 0x9409, 0x9508], &[]),
        ];
        for (what, words, expected) in cases {
            let code: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
            assert_eq!(products(0, &code, |_| false), expected, "{what}");
        }
    }

    #[test]
    fn constants_are_none() {
        // A constant that looks like `lds`, and one that looks like `mul`; then a `mul`.
        let code = [0x80, 0x91, 0x89, 0x9F, 0x89, 0x9F];
        assert_eq!(products(0x100, &code, |at| at < 0x104), [0x104]);
    }
}
