//! The languages that files are written in, and their names.

use crate::words;
use std::path::Path;
use unoclp_lang::{Lang, TextLanguage};

/// The language of a file that has been read, and not yet checked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WrittenIn {
    /// Numeric code.
    Numeric,
    /// Instruction List.
    Il,
    /// A typed language: Structured Text, InterSCL, LCE.
    Typed(TextLanguage),
    /// A project in PLCopen XML, whose programs are ladder diagrams or texts.
    Xml,
}

impl WrittenIn {
    /// All of them.
    pub fn all() -> Vec<WrittenIn> {
        let typed = TextLanguage::all().into_iter();
        let typed = typed.filter(|language| *language != TextLanguage::Il);
        let others = [WrittenIn::Il, WrittenIn::Xml, WrittenIn::Numeric];
        typed.map(WrittenIn::Typed).chain(others).collect()
    }

    /// Its name for `--language`, by which the names of its files end too; those of numeric code in `.txt`.
    pub const fn name(self) -> &'static str {
        match self {
            WrittenIn::Numeric => "numeric",
            WrittenIn::Il => "il",
            WrittenIn::Typed(language) => language.name(),
            WrittenIn::Xml => "xml",
        }
    }

    /// The end of the names of its files.
    pub const fn end(self) -> &'static str {
        match self {
            WrittenIn::Numeric => "txt",
            language => language.name(),
        }
    }

    /// What people call it.
    pub fn title(self, lang: Lang) -> String {
        match self {
            WrittenIn::Numeric => words::numeric_code(lang),
            WrittenIn::Il => TextLanguage::Il.title(lang).to_owned(),
            WrittenIn::Typed(language) => language.title(lang).to_owned(),
            WrittenIn::Xml => "PLCopen XML".to_owned(),
        }
    }

    /// Those that are compiled, in a sentence: `Instruction List (.il), LCE (.lce) or PLCopen XML (.xml)`.
    pub fn texts(lang: Lang) -> String {
        let mut all = WrittenIn::all();
        all.retain(|language| *language != WrittenIn::Numeric);
        all.sort_by_key(|language| match language {
            WrittenIn::Il => 0,
            WrittenIn::Typed(_) => 1,
            WrittenIn::Xml | WrittenIn::Numeric => 2,
        });
        let titles = all.iter();
        let titles = titles.map(|of| format!("{} (.{})", of.title(lang), of.end()));
        either(&titles.collect::<Vec<_>>(), lang)
    }

    /// The same, and numeric code before them.
    pub fn programs(lang: Lang) -> String {
        let numeric = WrittenIn::Numeric;
        let texts = WrittenIn::texts(lang);
        format!("{} (.{}), {texts}", numeric.title(lang), numeric.end())
    }

    /// The ends of the names of all programs' files, in a sentence: `.txt, .il or .st`.
    pub fn ends(lang: Lang) -> String {
        let ends = WrittenIn::all().into_iter().rev();
        either(
            &ends.map(|of| format!(".{}", of.end())).collect::<Vec<_>>(),
            lang,
        )
    }

    /// Their names as a file gives them, in a sentence: `"st", "lce" or "il"`.
    pub fn names(lang: Lang) -> String {
        let all = WrittenIn::all().into_iter();
        either(
            &all.map(|of| format!("\"{}\"", of.name()))
                .collect::<Vec<_>>(),
            lang,
        )
    }

    /// The language with this name.
    pub fn named(name: &str) -> Option<WrittenIn> {
        WrittenIn::all()
            .into_iter()
            .find(|language| language.name() == name)
    }

    /// The language of the files whose names end so; none where any text may have such a name.
    pub fn of_name(path: &Path) -> Option<WrittenIn> {
        let end = path.extension()?.to_str()?.to_ascii_lowercase();
        WrittenIn::named(&end).filter(|language| *language != WrittenIn::Numeric)
    }
}

/// All of these in a sentence, the last after `or`.
fn either(all: &[String], lang: Lang) -> String {
    match all {
        [others @ .., last] if !others.is_empty() => words::either(lang, others.join(", "), last),
        all => all.concat(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sentence_names_all_languages() {
        let programs = WrittenIn::programs(Lang::En);
        let texts = "Instruction List (.il), Structured Text (.st), SCL (.scl), InterSCL (.iscl), LCE (.lce) or PLCopen XML (.xml)";
        assert_eq!(programs, format!("numeric code (.txt), {texts}"));
        assert!(WrittenIn::texts(Lang::Pt).ends_with("LCE (.lce) ou PLCopen XML (.xml)"));
        assert_eq!(
            WrittenIn::ends(Lang::En),
            ".txt, .xml, .il, .lce, .iscl, .scl or .st"
        );
    }
}
