//! A message about how many bytes a program is too long.

use crate::diagnostics::Lang;

/// `; 12 more bytes of program memory and 3 of run memory are needed`, of bytes of both; empty where none are.
pub fn lacking(bytes: [usize; 2], lang: Lang) -> String {
    let [program, run] = match lang {
        Lang::En => ["of program memory", "of run memory"],
        Lang::Pt => ["de memória de programa", "de memória de execução"],
    };
    let (and, one, more) = match lang {
        Lang::En => ("and", "is needed", "are needed"),
        Lang::Pt => ("e", "falta", "faltam"),
    };
    let more_of = match lang {
        Lang::En => "more ",
        Lang::Pt => "",
    };
    let counted = |bytes, memory| match bytes {
        1 => format!("1 {more_of}byte {memory}"),
        _ => format!("{bytes} {more_of}bytes {memory}"),
    };
    let what = match bytes {
        [0, 0] => return String::new(),
        [stored, 0] => counted(stored, program),
        [0, linked] => counted(linked, run),
        [stored, linked] => format!("{} {and} {linked} {run}", counted(stored, program)),
    };
    let verb = match bytes {
        [1, 0] | [0, 1] => one,
        _ => more,
    };
    match lang {
        Lang::En => format!("; {what} {verb}"),
        Lang::Pt => format!("; {verb} {what}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_lacking_is_told_of_each_memory() {
        for (bytes, english, portuguese) in [
            ([0, 0], "", ""),
            (
                [1, 0],
                "; 1 more byte of program memory is needed",
                "; falta 1 byte de memória de programa",
            ),
            (
                [0, 27],
                "; 27 more bytes of run memory are needed",
                "; faltam 27 bytes de memória de execução",
            ),
            (
                [1, 3],
                "; 1 more byte of program memory and 3 of run memory are needed",
                "; faltam 1 byte de memória de programa e 3 de memória de execução",
            ),
        ] {
            assert_eq!(lacking(bytes, Lang::En), english);
            assert_eq!(lacking(bytes, Lang::Pt), portuguese);
        }
    }
}
