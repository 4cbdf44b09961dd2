//! The two languages that the tools speak: tables of texts, and the words of the system's errors.
//!
//! Owns the form of such a table, in which no text is without its twin. Must not know what the texts say.

use std::io::ErrorKind;

/// The language in which a text speaks.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Lang {
    /// English.
    #[default]
    En,
    /// Brazilian Portuguese.
    Pt,
}

/// A text in both languages.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Both {
    /// English.
    pub en: String,
    /// Brazilian Portuguese.
    pub pt: String,
}

/// What is said in each language.
pub fn both(say: impl Fn(Lang) -> String) -> Both {
    Both {
        en: say(Lang::En),
        pt: say(Lang::Pt),
    }
}

/// Makes a function of each row `name(value, …) "English" "Portuguese";`, and for tests the table `ALL` of name, English
/// and Portuguese, which [`gaps`] looks through.
///
/// The functions take the language before the values; after `in spoken;` they ask `spoken()` for it.
#[macro_export]
macro_rules! messages {
    (in $spoken:ident; $($name:ident($($value:ident),*) $english:literal $portuguese:literal;)*) => {
        $(
            #[doc = $english]
            pub fn $name($($value: impl ::std::fmt::Display),*) -> String {
                match $spoken() {
                    $crate::Lang::En => format!($english),
                    $crate::Lang::Pt => format!($portuguese),
                }
            }
        )*
        $crate::messages!(all $($name $english $portuguese;)*);
    };
    (all $($name:ident $english:literal $portuguese:literal;)*) => {
        /// All of them: name, English, Portuguese.
        #[cfg(test)]
        pub const ALL: &[(&str, &str, &str)] = &[$((stringify!($name), $english, $portuguese)),*];
    };
    ($($name:ident($($value:ident),*) $english:literal $portuguese:literal;)*) => {
        $(
            #[doc = $english]
            pub fn $name(lang: $crate::Lang $(, $value: impl ::std::fmt::Display)*) -> String {
                match lang {
                    $crate::Lang::En => format!($english),
                    $crate::Lang::Pt => format!($portuguese),
                }
            }
        )*
        $crate::messages!(all $($name $english $portuguese;)*);
    };
}

/// The names of the texts of a table that do not say the same in both languages, as far as that can be seen: the values
/// differ, or Portuguese is missing or is the English text.
pub fn gaps<'t>(table: &[(&'t str, &str, &str)]) -> Vec<&'t str> {
    let is_gap = |(_, english, portuguese): &&(&str, &str, &str)| {
        values(english) != values(portuguese)
            || portuguese.trim().is_empty()
            || english == portuguese
    };
    table.iter().filter(is_gap).map(|row| row.0).collect()
}

/// The values that a text names, in order of their names.
fn values(text: &str) -> Vec<&str> {
    let parts = text.split('{').skip(1);
    let mut names: Vec<&str> = parts
        .map(|part| part.split(['}', ':']).next().unwrap_or_default())
        .collect();
    names.sort_unstable();
    names.dedup();
    names
}

/// An error of the system, which says `told` of itself in English, with its number after it.
pub fn system(lang: Lang, kind: ErrorKind, told: &str) -> String {
    let portuguese = match kind {
        _ if lang == Lang::En => {
            return told.split(" (os error ").next().unwrap_or(told).to_owned();
        }
        // An error that a program has made says what the program has put into words.
        ErrorKind::Other => return told.to_owned(),
        ErrorKind::NotFound => "não existe",
        ErrorKind::PermissionDenied => "sem permissão",
        ErrorKind::IsADirectory => "é uma pasta",
        ErrorKind::NotADirectory => "o caminho passa por um arquivo",
        ErrorKind::AlreadyExists => "já existe",
        ErrorKind::InvalidData => "não é texto em UTF-8",
        ErrorKind::StorageFull => "o disco está cheio",
        ErrorKind::QuotaExceeded => "o espaço deste usuário no disco acabou",
        ErrorKind::FileTooLarge => "o arquivo ficaria grande demais",
        ErrorKind::ReadOnlyFilesystem => "o disco só permite leitura",
        ErrorKind::BrokenPipe => "a conexão foi fechada do outro lado",
        ErrorKind::UnexpectedEof => "terminou antes do esperado",
        ErrorKind::TimedOut => "demorou demais",
        ErrorKind::ResourceBusy => "está em uso",
        ErrorKind::InvalidFilename => "o nome não é válido",
        ErrorKind::WriteZero => "não foi possível gravar tudo",
        ErrorKind::Unsupported => "o sistema não permite isso",
        // The system knows more errors than have words here; its number at least says which.
        _ => return format!("erro do sistema: {told}"),
    };
    portuguese.to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_without_its_twin_is_a_gap() {
        let table = [
            ("right", "{file} is there", "{file} existe"),
            ("english", "{file} is there", "{file} is there"),
            ("missing", "is there", " "),
            ("values", "{file} is {kind}", "{file} existe"),
            ("form", "{sum:04X} of {file}", "{file}: {sum}"),
        ];
        assert_eq!(gaps(&table), ["english", "missing", "values"]);
    }

    #[test]
    fn errors_of_the_system_are_told_in_both_languages() {
        let told = |lang| system(lang, ErrorKind::NotFound, "No such file (os error 2)");
        assert_eq!(told(Lang::En), "No such file");
        assert_eq!(told(Lang::Pt), "não existe");
    }
}
