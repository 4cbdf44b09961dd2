//! The registry of languages, and the way of a text in one of them to its typed tree and to a program.

use std::fmt;
use std::sync::RwLock;
use unoclp_codegen::{CompiledText, Variable};
use unoclp_core::Board;
use unoclp_text::colour::{Colour, painted};
use unoclp_text::diagnostics::{Found, Lang, Span, Told};
#[cfg(feature = "assist")]
use unoclp_text::outline::Outline;
use unoclp_tree::{FrontEnd, Options, Painted, Tree};

/// A language: a row of the registry, compared by its name.
#[derive(Clone, Copy)]
pub struct TextLanguage(&'static FrontEnd);

/// What has been registered beside ours.
static MORE: RwLock<Vec<TextLanguage>> = RwLock::new(Vec::new());

/// Takes a language from elsewhere into all that asks [`TextLanguage::all`]: commands, help, checks, colours, tests. One
/// with a name that is taken is left out.
pub fn register(front: &'static FrontEnd) {
    let language = TextLanguage(front);
    let mut more = MORE.write().unwrap_or_else(|error| error.into_inner());
    if !TextLanguage::OURS.contains(&language) && !more.contains(&language) {
        more.push(language);
    }
}

#[expect(
    non_upper_case_globals,
    reason = "one reads them like the variants of an enum"
)]
impl TextLanguage {
    /// Structured Text of IEC 61131-3.
    pub const St: TextLanguage = TextLanguage(&FrontEnd {
        name: "st",
        title: ["Structured Text", "Texto Estruturado"],
        begins: weighed,
        colours: |text| unoclp_st::colours(text, unoclp_st::Dialect::Iec),
        #[cfg(feature = "assist")]
        outline: |text| unoclp_st::outline(text, unoclp_st::Dialect::Iec),
        #[cfg(feature = "assist")]
        vocabulary: unoclp_st::vocabulary,
        read: |text, options, found| {
            unoclp_st::check(text, unoclp_st::Dialect::Iec, options.board, found).into()
        },
    });
    /// Structured Text as Siemens writes it: `#name`, `"name"`.
    pub const Scl: TextLanguage = TextLanguage(&FrontEnd {
        name: "scl",
        title: ["SCL", "SCL"],
        begins: weighed,
        colours: |text| unoclp_st::colours(text, unoclp_st::Dialect::Scl),
        #[cfg(feature = "assist")]
        outline: |text| unoclp_st::outline(text, unoclp_st::Dialect::Scl),
        #[cfg(feature = "assist")]
        vocabulary: unoclp_st::vocabulary,
        read: |text, options, found| {
            unoclp_st::check(text, unoclp_st::Dialect::Scl, options.board, found).into()
        },
    });
    /// InterSCL, a small SCL for teaching.
    pub const Iscl: TextLanguage = TextLanguage(&FrontEnd {
        name: "iscl",
        title: ["InterSCL", "InterSCL"],
        begins: weighed,
        colours: unoclp_iscl::colours,
        #[cfg(feature = "assist")]
        outline: unoclp_iscl::outline,
        #[cfg(feature = "assist")]
        vocabulary: unoclp_iscl::vocabulary,
        read: |text, options, found| unoclp_iscl::check(text, options.board, found).into(),
    });
    /// LCE, the language of SimuPLC.
    pub const Lce: TextLanguage = TextLanguage(&FrontEnd {
        name: "lce",
        title: ["LCE", "LCE"],
        begins: weighed,
        colours: unoclp_lce::colours,
        #[cfg(feature = "assist")]
        outline: unoclp_lce::outline,
        #[cfg(feature = "assist")]
        vocabulary: unoclp_lce::vocabulary,
        read: |text, options, found| unoclp_lce::check(text, options.board, found).into(),
    });
    /// Instruction List.
    pub const Il: TextLanguage = TextLanguage(&FrontEnd {
        name: "il",
        title: ["Instruction List", "Lista de Instruções"],
        begins: weighed,
        colours: unoclp_il::colours,
        #[cfg(feature = "assist")]
        outline: unoclp_il::outline,
        #[cfg(feature = "assist")]
        vocabulary: unoclp_il::vocabulary,
        read: unoclp_il::read,
    });

    /// Those that unoclp brings.
    const OURS: [TextLanguage; 5] = [
        TextLanguage::St,
        TextLanguage::Scl,
        TextLanguage::Iscl,
        TextLanguage::Lce,
        TextLanguage::Il,
    ];

    /// Every language: ours, and after them what was [registered](register).
    pub fn all() -> Vec<TextLanguage> {
        let more = MORE.read().unwrap_or_else(|error| error.into_inner());
        [&TextLanguage::OURS[..], &more].concat()
    }

    /// Its name on a command line, by which the names of its files end too: `st`, `scl`, `iscl`, `lce`, `il`.
    pub const fn name(self) -> &'static str {
        self.0.name
    }

    /// What people call it.
    pub fn title(self, lang: Lang) -> &'static str {
        let [en, pt] = self.0.title;
        match lang {
            Lang::En => en,
            Lang::Pt => pt,
        }
    }

    /// Whether a text begins like one in it, and like one in no other.
    pub fn begins(self, text: &str) -> bool {
        (self.0.begins)(text)
    }

    /// The words of a text, and what each is.
    pub fn words(self, text: &str) -> Painted {
        (self.0.colours)(text)
    }

    /// What a text declares, and where: of one with mistakes too.
    #[cfg(feature = "assist")]
    pub fn outline(self, text: &str) -> Outline {
        (self.0.outline)(text)
    }

    /// The words that have a meaning of their own.
    #[cfg(feature = "assist")]
    pub fn vocabulary(self) -> Vec<&'static str> {
        (self.0.vocabulary)()
    }

    /// The language with this name.
    pub fn named(name: &str) -> Option<TextLanguage> {
        let mut all = TextLanguage::all().into_iter();
        all.find(|language| language.name() == name)
    }
}

/// Those that begin alike are told apart all at once, by whoever has files; see `unoclp-program`.
fn weighed(_: &str) -> bool {
    false
}

impl PartialEq for TextLanguage {
    fn eq(&self, other: &TextLanguage) -> bool {
        self.name() == other.name()
    }
}

impl Eq for TextLanguage {}

impl fmt::Debug for TextLanguage {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// The coloured parts of a text in this language, in the order of their places; the rest is names and signs.
pub fn colours(text: &str, language: TextLanguage) -> Vec<(Span, Colour)> {
    painted(text, (language.0.colours)(text))
}

/// What has come of a text.
#[derive(Debug)]
pub struct CheckedText {
    /// What it means; none where there are errors.
    pub tree: Option<Tree>,
    /// What was found in it.
    pub diagnostics: Told,
}

/// Reads a text and checks its names and types. It takes a time in proportion to the text's size.
pub fn check(text: &str, language: TextLanguage, board: Board) -> CheckedText {
    let mut found = Found::default();
    let read = (language.0.read)(text, &Options::on(board), &mut found);
    found.within(text.len());
    CheckedText {
        tree: read.tree.filter(|_| !found.has_errors()),
        diagnostics: found.finish(),
    }
}

/// The same, and its symbols in their order as a board keeps them; none where the board cannot do it. It is read once.
pub fn check_placed(
    text: &str,
    language: TextLanguage,
    board: Board,
) -> (CheckedText, Vec<Variable>) {
    let mut found = Found::default();
    let read = (language.0.read)(text, &Options::on(board), &mut found);
    let mut told = found.clone();
    told.within(text.len());
    let made = unoclp_codegen::compile(text, read, board, found);
    let checked = CheckedText {
        tree: made.tree,
        diagnostics: told.finish(),
    };
    (checked, made.variables)
}

/// Compiles a text. It takes a time in proportion to the text's size, whatever the text is.
pub fn compile(text: &str, language: TextLanguage, options: &Options) -> CompiledText {
    let mut found = Found::default();
    let read = (language.0.read)(text, options, &mut found);
    unoclp_codegen::compile(text, read, options.board, found)
}

/// The same for a board, in what its words look like.
pub fn compile_text(text: &str, language: TextLanguage, board: Board) -> CompiledText {
    compile(text, language, &Options::on(board))
}
