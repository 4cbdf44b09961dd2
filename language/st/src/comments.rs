//! The comments of Structured Text, and the pragmas of other tools.
//!
//! Owns where they end.

use super::lexer::Lexer;
use unoclp_text::diagnostics::{Code, Span};

/// C in single braces is no longer, in characters.
const LONGEST: usize = 4_000;

impl Lexer<'_, '_> {
    /// `(* … *)`, which may hold others; where that leaves one open to the end of the text, they do not count.
    pub(super) fn comment(&mut self) {
        if self.debug_line() {
            return;
        }
        let start = self.scan.at;
        let (mut depth, mut first) = (0_usize, None);
        while !self.scan.is_at_end() {
            match (self.scan.peek(0), self.scan.peek(1)) {
                (b'(', b'*') => {
                    depth += usize::from(!self.flat || depth == 0);
                    self.scan.at += 2;
                }
                (b'*', b')') => {
                    self.scan.at += 2;
                    depth -= 1;
                    first = first.or(Some(self.scan.at));
                    if depth == 0 {
                        return;
                    }
                }
                _ => self.scan.at += 1,
            }
        }
        match first {
            Some(end) => {
                self.flat = true;
                self.scan.at = end;
            }
            None => self.told_open(start, 2),
        }
    }

    /// Skips a line `(*DBG: … *)`, in which OpenPLC keeps a line of C, whatever that has for comments.
    fn debug_line(&mut self) -> bool {
        let (before, rest) = self.scan.text.split_at(self.scan.at);
        let begins = before.is_empty() || before.ends_with('\n');
        if !begins || !rest.starts_with("(*DBG:") {
            return false;
        }
        let line = rest.lines().next().unwrap_or_default();
        let is = line.trim_end().ends_with("*)");
        if is {
            self.scan.at += line.len();
        }
        is
    }

    /// Skips `{{ … }}`, in which editors keep C.
    pub(super) fn foreign_code(&mut self) {
        let start = self.scan.at;
        match self.scan.rest().find("}}") {
            Some(end) => self.scan.at += end + 2,
            None => {
                self.scan.at += 2;
                let words = ["{{".into(), "}}".into()];
                let span = self.scan.span(start);
                self.found.tell(Code::StNotClosed, span, words);
                self.scan.at = self.scan.text.len();
            }
        }
    }

    /// Skips C in single braces, which stands where a statement may begin and assigns nothing as Structured Text does.
    pub(super) fn code_in_braces(&mut self) -> bool {
        let rest = self.scan.rest();
        let before = self.scan.text.get(..self.behind).unwrap_or_default();
        let before = before.as_bytes();
        let ends = |word: &&str| {
            let last = before.len().checked_sub(word.len());
            let last = last.and_then(|at| before.get(at..));
            last.is_some_and(|last| last.eq_ignore_ascii_case(word.as_bytes()))
        };
        let begins = ["}", ";", ":", "THEN", "ELSE", "DO", "REPEAT", "END_VAR"];
        if !begins.iter().any(ends) {
            return false;
        }
        let mut depth = 0_usize;
        let end = rest.char_indices().take(LONGEST).find(|(_, c)| {
            depth += usize::from(*c == '{');
            depth -= usize::from(*c == '}');
            depth == 0
        });
        let code = end.and_then(|(end, _)| rest.get(..=end));
        let code = code.filter(|code| code.contains('(') && !code.contains(":="));
        self.scan.at += code.map_or(0, str::len);
        code.is_some()
    }

    /// `/* … */`
    pub(super) fn slashed(&mut self) {
        let start = self.scan.at;
        self.scan.at += 2;
        while !self.scan.is_at_end() {
            if (self.scan.peek(0), self.scan.peek(1)) == (b'*', b'/') {
                self.scan.at += 2;
                return;
            }
            self.scan.at += 1;
        }
        self.told_open(start, 2);
    }

    fn told_open(&mut self, start: usize, width: usize) {
        let span = Span {
            start: start as u32,
            end: (start + width) as u32,
        };
        self.found.tell(Code::StCommentOpen, span, []);
    }

    /// Skips `{attribute 'x'}`, `{ S7_Optimized_Access := 'TRUE' }`, `{enable code}`: braces on one line that begin with
    /// such a word, or hold words alone.
    pub(super) fn is_pragma(&mut self) -> bool {
        let rest = self.scan.rest();
        let line = rest
            .as_bytes()
            .iter()
            .take(400)
            .take_while(|byte| **byte != b'\n');
        let Some(end) = line.into_iter().position(|byte| *byte == b'}') else {
            return false;
        };
        let words = rest.get(1..end).unwrap_or_default().trim_start();
        let known = [
            "attribute",
            "region",
            "endregion",
            "warning",
            "info",
            "text",
            "S7_",
            "InstructionName",
            "LibVersion",
            "Extern",
            "EXTERNAL",
        ];
        let alone = words
            .bytes()
            .all(|byte| byte.is_ascii_alphanumeric() || b"_ \t".contains(&byte));
        let is = alone && !words.is_empty() || known.iter().any(|word| words.starts_with(word));
        if is {
            self.scan.at += end + 1;
        }
        is
    }
}
