//! `unoclp compile`.

use super::open::{Il, Shown, open};
use crate::{Outcome, cannot_write};
use anstream::{eprintln, print};
use anyhow::{Context, bail};
use std::fs;
use std::path::Path;
use unoclp_lang::Lang;
use unoclp_source::{Language, kept_en, kept_pt};

/// Compiles Instruction List to numeric code, into this file or to standard output.
pub fn compile(path: &Path, output: Option<&Path>, il: &Il) -> Outcome {
    let Some(program) = open(path, il, Shown::Beside)? else {
        return Ok(false);
    };
    let lang = il.lang();
    let name = &program.name;
    let Language::Il { dialect, warnings } = &program.language else {
        match lang {
            Lang::En => bail!("{name} is numeric code; there is nothing to compile"),
            Lang::Pt => bail!("{name} já é código numérico; não há o que compilar"),
        }
    };
    match output.filter(|output| *output != Path::new("-")) {
        None => print!("{}", String::from_utf8_lossy(&program.code)),
        Some(output) if same(path, output) => match lang {
            Lang::En => bail!("{name} is what is compiled; name another file with -o"),
            Lang::Pt => bail!("{name} é o que se compila; indique outro arquivo com -o"),
        },
        Some(output) => {
            fs::write(output, &program.code).with_context(|| cannot_write(output))?;
        }
    }
    let (dialect, warnings) = (il.dialect(*dialect), warnings.len());
    let codes = program.size.codes;
    eprintln!(
        "{name}: {}",
        match lang {
            Lang::En => format!("{dialect}; codes: {codes}, warnings: {warnings}"),
            Lang::Pt => format!("{dialect}; códigos: {codes}, avisos: {warnings}"),
        }
    );
    if let Some((numbers, minutes)) = program.size.kept {
        match lang {
            Lang::En => eprintln!("{name}: {}", kept_en(numbers, minutes)),
            Lang::Pt => eprintln!("{name}: {}", kept_pt(numbers, minutes)),
        }
    }
    Ok(true)
}

/// Whether two names are those of one file.
fn same(one: &Path, other: &Path) -> bool {
    match (fs::canonicalize(one), fs::canonicalize(other)) {
        (Ok(one), Ok(other)) => one == other,
        _ => false,
    }
}
