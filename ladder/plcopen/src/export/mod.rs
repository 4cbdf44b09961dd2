//! A document as a project: each rung as contacts, coils and blocks, with the wires between them; what they have no form
//! for, in Instruction List.
//!
//! - `frame`: what is around all of it; `xml`: the elements as XML; `names`: the variables
//! - `blocks`: the same as a block diagram
//! - `draw`: rungs and their wires; `elements`: what is on them; `counters`, `count`: rungs that are inputs of one block
//! - `numbers`: loads, operations, comparisons and stores
//! - `il`: a program in Instruction List; `same`: what is written is read again; `text`: a text in place of a document

mod blocks;
mod count;
mod counters;
mod draw;
mod elements;
mod frame;
mod il;
mod lost;
mod names;
mod numbers;
mod same;
mod text;
mod xml;

pub use lost::Lost;
pub(crate) use text::chart_body;
pub use text::export_text;

/// A project.
#[derive(Clone, Debug)]
pub struct Exported {
    /// Its file.
    pub text: String,
    /// What no ladder has a form for; where there is any, the program is in Instruction List.
    pub beyond: Vec<Lost>,
}

use draw::Draw;
use names::Variables;
use same::{not_read, says};
use unoclp_core::Board;
use unoclp_draw::edit::Document;
pub(crate) use xml::escaped;

/// A document as a project of one program, which goes by this name; [`import`](crate::import) makes the same codes of it. It
/// says no date of its own.
///
/// # Errors
/// What no project says: a document that is no program.
pub fn export(document: &Document, name: &str, board: Board) -> Result<Exported, Vec<Lost>> {
    let beyond = match drawn(document, name, board, false) {
        Ok(text) => {
            let beyond = Vec::new();
            return Ok(Exported { text, beyond });
        }
        Err(beyond) => beyond,
    };
    for plain in [false, true] {
        let body = il::body(document, board, plain);
        let text = format!(
            "          <IL>\n            <xhtml:p><![CDATA[{}]]></xhtml:p>\n          </IL>\n",
            body.text
        );
        let text = written(document, name, &body.variables, &text);
        if says(&text, document, board) {
            return Ok(Exported { text, beyond });
        }
    }
    Err(beyond)
}

/// The same with its program in FBD. [`Exported::beyond`] says what no block diagram has a form for; where there is any, the
/// program is exported as [`export`] does.
///
/// # Errors
/// What no project says: a document that is no program.
pub fn export_blocks(document: &Document, name: &str, board: Board) -> Result<Exported, Vec<Lost>> {
    match drawn(document, name, board, true) {
        Ok(text) => {
            let beyond = Vec::new();
            Ok(Exported { text, beyond })
        }
        Err(mut beyond) => {
            beyond.iter_mut().for_each(|lost| lost.is_blocks = true);
            let text = export(document, name, board)?.text;
            Ok(Exported { text, beyond })
        }
    }
}

/// A document as a project in LD, or in FBD.
fn drawn(
    document: &Document,
    name: &str,
    board: Board,
    is_blocks: bool,
) -> Result<String, Vec<Lost>> {
    let mut draw = Draw::new(document, is_blocks);
    let rungs: Vec<_> = document.rungs().collect();
    let mut at = 0;
    while let Some(behind) = rungs.get(at..).filter(|behind| !behind.is_empty()) {
        at += draw.rung(behind, at + 1);
    }
    if !draw.lost.is_empty() {
        return Err(draw.lost);
    }
    let tag = if is_blocks { "FBD" } else { "LD" };
    let body = format!("          <{tag}>\n{}          </{tag}>\n", draw.body.text);
    let text = written(document, name, &draw.variables, &body);
    match not_read(document, &text, board) {
        lost if lost.is_empty() => Ok(text),
        lost => Err(lost),
    }
}

/// The file of a project with this body.
fn written(document: &Document, name: &str, variables: &Variables, body: &str) -> String {
    let title = document.title().join("\n");
    let documentation = match title.is_empty() {
        true => String::new(),
        false => format!(
            "        <documentation>\n          <xhtml:p>{}</xhtml:p>\n        </documentation>\n",
            escaped(&title)
        ),
    };
    let types = format!(
        "    <dataTypes/>
    <pous>
      <pou name=\"Main\" pouType=\"program\">
        <interface>
          <localVars>
{}          </localVars>
        </interface>
        <body>
{body}        </body>
{documentation}      </pou>
    </pous>
",
        variables.declared(),
    );
    let run = "            <pouInstance name=\"instance0\" typeName=\"Main\"/>\n";
    frame::project(name, &types, run, "")
}
