//! Statements as they are written.

use unoclp_lang::Span;

/// A part of a text, and where what it says is in the file.
pub(crate) type Piece = (String, Span);

pub(super) fn piece(text: &str, at: Span) -> Piece {
    (text.to_owned(), at)
}

/// What conditions that are one and the same come from: an element, and an output of it.
pub(super) type Group = (usize, String);

/// The opposite of a truth.
pub(super) fn inverted(value: Vec<Piece>, at: Span) -> Vec<Piece> {
    let mut pieces = vec![piece("NOT (", at)];
    pieces.extend(value);
    pieces.push(piece(")", at));
    pieces
}

/// The statements of a body.
#[derive(Default)]
pub(super) struct Sentences {
    all: Vec<Sentence>,
    /// The variables that say where a jump to a label below leaves out what comes now.
    jumps: Vec<String>,
}

/// A statement, or several that have one condition.
struct Sentence {
    /// What is between a jump and its label: done where none of these is TRUE.
    jumps: Vec<String>,
    /// None: always.
    condition: Option<Vec<Piece>>,
    /// What conditions that are one and the same have in common.
    group: Option<Group>,
    does: Vec<Vec<Piece>>,
    otherwise: Vec<Vec<Piece>>,
}

impl Sentences {
    /// What is done always.
    pub(super) fn add(&mut self, does: Vec<Piece>) {
        self.push(None, None, does, None);
    }

    pub(super) fn is_empty(&self) -> bool {
        self.all.is_empty()
    }

    /// From here on nothing is done where this variable is TRUE.
    pub(super) fn jump(&mut self, name: &str) {
        if !self.jumps.iter().any(|jump| jump == name) {
            self.jumps.push(name.to_owned());
        }
    }

    /// From here on that variable counts no longer.
    pub(super) fn land(&mut self, name: &str) {
        self.jumps.retain(|jump| jump != name);
    }

    fn push(
        &mut self,
        condition: Option<Vec<Piece>>,
        group: Option<Group>,
        does: Vec<Piece>,
        otherwise: Option<Vec<Piece>>,
    ) {
        self.all.push(Sentence {
            jumps: self.jumps.clone(),
            condition,
            group,
            does: vec![does],
            otherwise: otherwise.into_iter().collect(),
        });
    }

    /// What is done where this is TRUE.
    pub(super) fn only(&mut self, condition: Vec<Piece>, does: Vec<Piece>) {
        let is_always = matches!(&condition[..], [(text, _)] if text == "TRUE");
        if is_always {
            return self.add(does);
        }
        self.push(Some(condition), None, does, None);
    }

    /// Whether the last condition is that of this group, which need not be asked again.
    fn is_in(&self, group: &Group) -> bool {
        let last = self.all.last();
        last.is_some_and(|last| last.group.as_ref() == Some(group) && last.jumps == self.jumps)
    }

    /// What is done where this is TRUE, and where it is not; conditions of one group right after each other are asked once.
    pub(super) fn grouped(
        &mut self,
        group: Group,
        condition: Vec<Piece>,
        does: Vec<Piece>,
        otherwise: Option<Vec<Piece>>,
    ) {
        if self.is_in(&group)
            && let Some(last) = self.all.last_mut()
        {
            last.does.push(does);
            last.otherwise.extend(otherwise);
            return;
        }
        self.push(Some(condition), Some(group), does, otherwise);
    }

    /// All of them, a line each.
    pub(super) fn pieces(self) -> Vec<Piece> {
        let mut pieces = Vec::new();
        let lines = |all: Vec<Vec<Piece>>, indent: &str, pieces: &mut Vec<Piece>| {
            for line in all {
                let at = line.first().map_or(Span::default(), |(_, at)| *at);
                pieces.push(piece(indent, at));
                pieces.extend(line);
                pieces.push(piece(";\n", at));
            }
        };
        let mut left_out: Vec<String> = Vec::new();
        for sentence in self.all {
            if sentence.jumps != left_out {
                let at = sentence.does.iter().flatten().next();
                let at = at.map_or(Span::default(), |(_, at)| *at);
                if !left_out.is_empty() {
                    pieces.push(piece("END_IF;\n", at));
                }
                if !sentence.jumps.is_empty() {
                    let any = sentence.jumps.join(" OR ");
                    pieces.push(piece(&format!("IF NOT ({any}) THEN\n"), at));
                }
                left_out = sentence.jumps;
            }
            let Some(condition) = sentence.condition else {
                lines(sentence.does, "", &mut pieces);
                continue;
            };
            let at = condition.first().map_or(Span::default(), |(_, at)| *at);
            pieces.push(piece("IF ", at));
            pieces.extend(condition);
            pieces.push(piece(" THEN\n", at));
            lines(sentence.does, "  ", &mut pieces);
            if !sentence.otherwise.is_empty() {
                pieces.push(piece("ELSE\n", at));
                lines(sentence.otherwise, "  ", &mut pieces);
            }
            pieces.push(piece("END_IF;\n", at));
        }
        if !left_out.is_empty() {
            pieces.push(piece("END_IF;\n", Span::default()));
        }
        pieces
    }
}
