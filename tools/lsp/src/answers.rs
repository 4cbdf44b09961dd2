//! What an editor asks, and what is known of it.

use crate::documents::{Documents, Open};
use crate::problems;
use lsp_server::ErrorCode;
use lsp_types::{
    CodeAction, CodeActionKind, CodeActionParams, CompletionItem, CompletionItemKind,
    CompletionParams, CompletionTextEdit, DocumentFormattingParams, DocumentHighlight,
    DocumentHighlightKind, DocumentSymbol, DocumentSymbolParams, Hover, HoverContents, HoverParams,
    Location, MarkupContent, MarkupKind, ReferenceParams, RenameParams, SymbolKind,
    TextDocumentPositionParams, TextEdit, Uri, WorkspaceEdit,
};
use serde::de::DeserializeOwned;
use serde_json::{Value, json};
use std::collections::HashMap;
use unoclp_assist as assist;
use unoclp_assist::{Edit, Kind, Symbol};
use unoclp_lang::Lang;
use unoclp_lang::outline::What;

/// What cannot be answered, and why, in the words of the protocol.
type Refusal = (ErrorCode, String);

/// All that is asked.
pub(crate) struct Answers<'d> {
    pub documents: &'d mut Documents,
    pub lang: Lang,
}

impl Answers<'_> {
    /// The answer to a request by its name.
    pub fn answer(&mut self, method: &str, params: Value) -> Result<Value, Refusal> {
        match method {
            "textDocument/completion" => self.completion(taken(params)?),
            "textDocument/hover" => self.hover(taken(params)?),
            "textDocument/definition" => self.definition(taken(params)?),
            "textDocument/references" => self.references(taken(params)?),
            "textDocument/documentHighlight" => self.highlight(taken(params)?),
            "textDocument/documentSymbol" => self.symbols(taken(params)?),
            "textDocument/formatting" => self.formatting(taken(params)?),
            "textDocument/prepareRename" => self.prepare(taken(params)?),
            "textDocument/rename" => self.rename(taken(params)?),
            "textDocument/codeAction" => self.actions(taken(params)?),
            _ => {
                let why = format!("unoclp does not answer {method}");
                Err((ErrorCode::MethodNotFound, why))
            }
        }
    }

    /// A text that is open, and the byte at a place of it; none of one that is not.
    fn at(&mut self, place: &TextDocumentPositionParams) -> Option<(Open, u32)> {
        let open = self.documents.get(&place.text_document.uri)?;
        let byte = open.places.byte(place.position);
        Some((open, byte))
    }

    fn completion(&mut self, asked: CompletionParams) -> Result<Value, Refusal> {
        let Some((open, byte)) = self.at(&asked.text_document_position) else {
            return Ok(Value::Null);
        };
        let (span, offers) = assist::complete(open.analysis.written(), byte, self.lang);
        let range = open.places.range(span);
        let item = |(at, offer): (usize, assist::Offer)| CompletionItem {
            kind: Some(match offer.kind {
                Kind::Variable => CompletionItemKind::VARIABLE,
                Kind::Member => CompletionItemKind::FIELD,
                Kind::Function => CompletionItemKind::FUNCTION,
                Kind::Type => CompletionItemKind::CLASS,
                Kind::Value => CompletionItemKind::ENUM_MEMBER,
                Kind::Place => CompletionItemKind::EVENT,
                Kind::Word => CompletionItemKind::KEYWORD,
            }),
            detail: Some(offer.detail).filter(|detail| !detail.is_empty()),
            // They are told in the order in which they are likely.
            sort_text: Some(format!("{at:05}")),
            text_edit: Some(CompletionTextEdit::Edit(TextEdit {
                range,
                new_text: offer.insert.unwrap_or_else(|| offer.label.clone()),
            })),
            label: offer.label,
            ..CompletionItem::default()
        };
        let items: Vec<CompletionItem> = offers.into_iter().enumerate().map(item).collect();
        Ok(json!(items))
    }

    fn hover(&mut self, asked: HoverParams) -> Result<Value, Refusal> {
        let Some((open, byte)) = self.at(&asked.text_document_position_params) else {
            return Ok(Value::Null);
        };
        let told = assist::hover(&open.analysis, byte, self.lang);
        let hover = told.map(|told| Hover {
            contents: HoverContents::Markup(MarkupContent {
                kind: MarkupKind::Markdown,
                value: format!("```\n{}\n```\n{}", told.head, told.lines.join("\n\n")),
            }),
            range: Some(open.places.range(told.span)),
        });
        Ok(json!(hover))
    }

    fn definition(&mut self, asked: lsp_types::GotoDefinitionParams) -> Result<Value, Refusal> {
        let place = asked.text_document_position_params;
        let Some((open, byte)) = self.at(&place) else {
            return Ok(Value::Null);
        };
        let span = assist::declaration(open.analysis.written(), byte);
        let uri = place.text_document.uri;
        let location = span.map(|span| Location::new(uri, open.places.range(span)));
        Ok(json!(location))
    }

    fn references(&mut self, asked: ReferenceParams) -> Result<Value, Refusal> {
        let place = asked.text_document_position;
        let Some((open, byte)) = self.at(&place) else {
            return Ok(Value::Null);
        };
        let uri = place.text_document.uri;
        let with_declaration = asked.context.include_declaration;
        let uses = assist::uses(open.analysis.written(), byte).into_iter();
        let uses = uses.filter(|own| with_declaration || !own.declares);
        let locations: Vec<Location> = uses
            .map(|own| Location::new(uri.clone(), open.places.range(own.span)))
            .collect();
        Ok(json!(locations))
    }

    fn highlight(&mut self, asked: lsp_types::DocumentHighlightParams) -> Result<Value, Refusal> {
        let Some((open, byte)) = self.at(&asked.text_document_position_params) else {
            return Ok(Value::Null);
        };
        let light = |own: assist::Use| DocumentHighlight {
            range: open.places.range(own.span),
            kind: Some(match own.writes {
                true => DocumentHighlightKind::WRITE,
                false => DocumentHighlightKind::READ,
            }),
        };
        let uses = assist::uses(open.analysis.written(), byte).into_iter();
        let lights: Vec<DocumentHighlight> = uses.map(light).collect();
        Ok(json!(lights))
    }

    fn symbols(&mut self, asked: DocumentSymbolParams) -> Result<Value, Refusal> {
        let Some(open) = self.documents.get(&asked.text_document.uri) else {
            return Ok(Value::Null);
        };
        let all = assist::symbols(open.analysis.written());
        Ok(json!(nested(&open, &all, None)))
    }

    fn formatting(&mut self, asked: DocumentFormattingParams) -> Result<Value, Refusal> {
        let Some(open) = self.documents.get(&asked.text_document.uri) else {
            return Ok(Value::Null);
        };
        let indent = usize::try_from(asked.options.tab_size).ok();
        let edits = assist::format(open.analysis.written(), indent);
        Ok(json!(text_edits(&open, edits)))
    }

    fn prepare(&mut self, asked: TextDocumentPositionParams) -> Result<Value, Refusal> {
        let Some((open, byte)) = self.at(&asked) else {
            return Ok(Value::Null);
        };
        let name = assist::prepare(open.analysis.written(), byte);
        Ok(json!(name.map(|span| open.places.range(span))))
    }

    fn rename(&mut self, asked: RenameParams) -> Result<Value, Refusal> {
        let Some((open, byte)) = self.at(&asked.text_document_position) else {
            return Ok(Value::Null);
        };
        let edits = assist::rename(&open.analysis, byte, &asked.new_name);
        let edits = edits.map_err(|why| (ErrorCode::RequestFailed, why.message(self.lang)))?;
        let uri = asked.text_document_position.text_document.uri;
        Ok(json!(changes(uri, text_edits(&open, edits))))
    }

    fn actions(&mut self, asked: CodeActionParams) -> Result<Value, Refusal> {
        let uri = asked.text_document.uri;
        let Some(open) = self.documents.get(&uri) else {
            return Ok(Value::Null);
        };
        let at = open.places.span(asked.range);
        let told = problems::told(&open.analysis).iter();
        let here = told.filter(|about| about.span.start <= at.end && at.start <= about.span.end);
        let mut actions = Vec::new();
        for about in here {
            let mended = problems::of_text(&open.places, about, self.lang);
            for remedy in assist::remedies(open.analysis.written(), about, self.lang) {
                let edits = text_edits(&open, remedy.edits);
                actions.push(CodeAction {
                    title: remedy.title,
                    kind: Some(CodeActionKind::QUICKFIX),
                    diagnostics: Some(vec![mended.clone()]),
                    edit: Some(changes(uri.clone(), edits)),
                    ..CodeAction::default()
                });
            }
        }
        Ok(json!(actions))
    }
}

/// What a request says, if it says it as the protocol has it.
fn taken<T: DeserializeOwned>(params: Value) -> Result<T, Refusal> {
    serde_json::from_value(params).map_err(|why| (ErrorCode::InvalidParams, why.to_string()))
}

fn text_edits(open: &Open, edits: Vec<Edit>) -> Vec<TextEdit> {
    let edit = |edit: Edit| TextEdit::new(open.places.range(edit.span), edit.text);
    edits.into_iter().map(edit).collect()
}

fn changes(uri: Uri, edits: Vec<TextEdit>) -> WorkspaceEdit {
    WorkspaceEdit::new(HashMap::from([(uri, edits)]))
}

/// What belongs to a declaration, or to none, with what belongs to it.
fn nested(open: &Open, all: &[Symbol], within: Option<usize>) -> Vec<DocumentSymbol> {
    let own = all.iter().enumerate();
    let own = own.filter(|(_, symbol)| symbol.within == within);
    own.map(|(at, symbol)| {
        #[expect(
            deprecated,
            reason = "the protocol's type has the field, which is not used"
        )]
        let symbol = DocumentSymbol {
            name: symbol.name.clone(),
            detail: Some(symbol.detail.clone()).filter(|detail| !detail.is_empty()),
            kind: match symbol.what {
                What::Program => SymbolKind::MODULE,
                What::Block => SymbolKind::CLASS,
                What::Function => SymbolKind::FUNCTION,
                What::Type => SymbolKind::STRUCT,
                What::Variable => SymbolKind::VARIABLE,
                What::Member => SymbolKind::FIELD,
                What::Value => SymbolKind::ENUM_MEMBER,
                What::Step | What::Transition | What::Action => SymbolKind::EVENT,
                What::Label => SymbolKind::KEY,
            },
            tags: None,
            deprecated: None,
            range: open.places.range(symbol.whole),
            selection_range: open.places.range(symbol.at),
            children: Some(nested(open, all, Some(at))).filter(|all| !all.is_empty()),
        };
        symbol
    })
    .collect()
}
