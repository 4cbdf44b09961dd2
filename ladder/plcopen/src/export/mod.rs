//! A document as a project: each rung as contacts, coils and blocks, with the wires between them.
//!
//! - `xml`: the elements as XML; `names`: the variables
//! - `draw`: rungs and their wires; `elements`: what stands on them; `counters`, `count`: rungs that are inputs of one block
//! - `numbers`: loads, operations, comparisons and stores
//! - `same`: what is written is read again; `text`: a text in place of a document
//!
//! What PLCopen XML has no element for is told, rung by rung, and then there is no project.

mod count;
mod counters;
mod draw;
mod elements;
mod lost;
mod names;
mod numbers;
mod same;
mod text;
mod xml;

pub use lost::Lost;
pub use text::export_text;

use draw::Draw;
use same::not_read;
use unoclp_core::Board;
use unoclp_draw::edit::Document;
use xml::escaped;

/// A document as a project of one program, which goes by this name; [`import`](crate::import) makes the same codes of it. It
/// says no date of its own.
///
/// # Errors
/// All that cannot be said.
pub fn export(document: &Document, name: &str, board: Board) -> Result<String, Vec<Lost>> {
    let mut draw = Draw::new(document);
    let rungs: Vec<_> = document.rungs().collect();
    let mut at = 0;
    while let Some(behind) = rungs.get(at..).filter(|behind| !behind.is_empty()) {
        at += draw.rung(behind, at + 1);
    }
    if !draw.lost.is_empty() {
        return Err(draw.lost);
    }
    let text = written(document, name, &draw);
    match not_read(document, &text, board) {
        lost if lost.is_empty() => Ok(text),
        lost => Err(lost),
    }
}

/// The file of what has been drawn.
fn written(document: &Document, name: &str, draw: &Draw) -> String {
    let title = document.title().join("\n");
    let documentation = match title.is_empty() {
        true => String::new(),
        false => format!(
            "        <documentation>\n          <xhtml:p>{}</xhtml:p>\n        </documentation>\n",
            escaped(&title)
        ),
    };
    let name = match name.trim() {
        "" => "Main".to_owned(),
        name => escaped(name),
    };
    format!(
        "<?xml version='1.0' encoding='utf-8'?>
<project xmlns:xhtml=\"http://www.w3.org/1999/xhtml\" xmlns:xsd=\"http://www.w3.org/2001/XMLSchema\" xmlns=\"http://www.plcopen.org/xml/tc6_0201\">
  <fileHeader companyName=\"Unknown\" productName=\"unoclp\" productVersion=\"1\" creationDateTime=\"2000-01-01T00:00:00\"/>
  <contentHeader name=\"{name}\" modificationDateTime=\"2000-01-01T00:00:00\">
    <coordinateInfo>
      <fbd>
        <scaling x=\"10\" y=\"10\"/>
      </fbd>
      <ld>
        <scaling x=\"10\" y=\"10\"/>
      </ld>
      <sfc>
        <scaling x=\"10\" y=\"10\"/>
      </sfc>
    </coordinateInfo>
  </contentHeader>
  <types>
    <dataTypes/>
    <pous>
      <pou name=\"Main\" pouType=\"program\">
        <interface>
          <localVars>
{}          </localVars>
        </interface>
        <body>
          <LD>
{}          </LD>
        </body>
{documentation}      </pou>
    </pous>
  </types>
  <instances>
    <configurations>
      <configuration name=\"Config0\">
        <resource name=\"Res0\">
          <task name=\"task0\" priority=\"0\" interval=\"T#20ms\">
            <pouInstance name=\"instance0\" typeName=\"Main\"/>
          </task>
        </resource>
      </configuration>
    </configurations>
  </instances>
</project>
",
        draw.variables.declared(),
        draw.body.text,
    )
}
