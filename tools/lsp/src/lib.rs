//! Editors that speak the Language Server Protocol (LSP 3.17).
//!
//! - [`stdio()`]: the editor at standard input and output; [`serve`]: a conversation with one, to its end
//! - `documents`: the texts that are open there; `lines`: places as the protocol counts them, in units of UTF-16
//! - `answers`: what is asked, and what `unoclp-assist` says of it; `problems`: what is told unasked
//!
//! Owns the protocol. Must not know what a word of a text means, nor files: the editor has them.

#![forbid(unsafe_code)]

mod answers;
mod documents;
mod lines;
mod problems;
mod stdio;

use answers::Answers;
use documents::Documents;
use lsp_server::{Connection, Message, Notification, ProtocolError, Response};
use lsp_types::notification::{
    DidChangeTextDocument, DidCloseTextDocument, DidOpenTextDocument, Notification as _,
    PublishDiagnostics,
};
use lsp_types::{
    CodeActionKind, CodeActionOptions, CodeActionProviderCapability, CompletionOptions,
    HoverProviderCapability, InitializeParams, OneOf, PublishDiagnosticsParams, RenameOptions,
    ServerCapabilities, TextDocumentSyncCapability, TextDocumentSyncKind, Uri,
    WorkDoneProgressOptions,
};
use serde_json::json;
pub use stdio::stdio;
use unoclp_core::Board;
use unoclp_lang::Lang;

/// Speaks with an editor until it says goodbye. `lang`: in which language; none: in the editor's.
///
/// # Errors
/// If the editor does not keep to the protocol, or is gone.
pub fn serve(
    connection: &Connection,
    board: Board,
    lang: Option<Lang>,
) -> Result<(), ProtocolError> {
    let (id, first) = connection.initialize_start()?;
    let first: InitializeParams = serde_json::from_value(first).unwrap_or_default();
    let own = first.locale.as_deref().unwrap_or_default();
    let lang = lang.unwrap_or(match own.to_lowercase().starts_with("pt") {
        true => Lang::Pt,
        false => Lang::En,
    });
    let about = json!({
        "capabilities": capabilities(),
        "serverInfo": { "name": "unoclp", "version": env!("CARGO_PKG_VERSION") },
    });
    connection.initialize_finish(id, about)?;
    let mut documents = Documents::new(board);
    for message in &connection.receiver {
        match message {
            Message::Request(request) => {
                if connection.handle_shutdown(&request)? {
                    return Ok(());
                }
                let id = request.id.clone();
                let mut answers = Answers {
                    documents: &mut documents,
                    lang,
                };
                let answer = match answers.answer(&request.method, request.params) {
                    Ok(answer) => Response::new_ok(id, answer),
                    Err((code, why)) => Response::new_err(id, code as i32, why),
                };
                send(connection, answer.into());
            }
            Message::Notification(told) => {
                if let Some(uri) = heard(&mut documents, told) {
                    publish(connection, &mut documents, uri, lang);
                }
            }
            Message::Response(_) => {}
        }
    }
    Ok(())
}

/// An editor that is gone hears nothing more; the next reading says so.
fn send(connection: &Connection, message: Message) {
    let _ = connection.sender.send(message);
}

/// Takes what an editor tells, and says of which text.
fn heard(documents: &mut Documents, told: Notification) -> Option<Uri> {
    match told.method.as_str() {
        DidOpenTextDocument::METHOD => documents.open(serde_json::from_value(told.params).ok()?),
        DidChangeTextDocument::METHOD => {
            documents.change(serde_json::from_value(told.params).ok()?)
        }
        DidCloseTextDocument::METHOD => documents.close(serde_json::from_value(told.params).ok()?),
        _ => None,
    }
}

/// Tells what is wrong with a text; of one that is closed nothing is.
fn publish(connection: &Connection, documents: &mut Documents, uri: Uri, lang: Lang) {
    let open = documents.get(&uri);
    let version = open.as_ref().map(|open| open.version);
    let diagnostics = open.map_or_else(Vec::new, |open| problems::problems(&open, lang));
    let told = PublishDiagnosticsParams {
        uri,
        diagnostics,
        version,
    };
    let told = Notification::new(PublishDiagnostics::METHOD.to_owned(), told);
    send(connection, told.into());
}

fn capabilities() -> ServerCapabilities {
    ServerCapabilities {
        text_document_sync: Some(TextDocumentSyncCapability::Kind(
            TextDocumentSyncKind::INCREMENTAL,
        )),
        completion_provider: Some(CompletionOptions {
            trigger_characters: Some(vec![".".to_owned(), ":".to_owned(), "(".to_owned()]),
            ..CompletionOptions::default()
        }),
        hover_provider: Some(HoverProviderCapability::Simple(true)),
        definition_provider: Some(OneOf::Left(true)),
        references_provider: Some(OneOf::Left(true)),
        document_highlight_provider: Some(OneOf::Left(true)),
        document_symbol_provider: Some(OneOf::Left(true)),
        document_formatting_provider: Some(OneOf::Left(true)),
        rename_provider: Some(OneOf::Right(RenameOptions {
            prepare_provider: Some(true),
            work_done_progress_options: WorkDoneProgressOptions::default(),
        })),
        code_action_provider: Some(CodeActionProviderCapability::Options(CodeActionOptions {
            code_action_kinds: Some(vec![CodeActionKind::QUICKFIX]),
            ..CodeActionOptions::default()
        })),
        ..ServerCapabilities::default()
    }
}
