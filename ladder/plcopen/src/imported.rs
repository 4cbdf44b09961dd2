//! The result of importing a project.

use unoclp_checked::{Checked, SourceMap};
use unoclp_draw::edit::Document;
use unoclp_lang::{Told, Trace, Variable};
use unoclp_sfc::Origin;

/// The result of importing a project.
#[derive(Debug)]
pub struct Imported {
    /// The same as numeric code, with comments; none where there are errors.
    pub code: Option<String>,
    /// The checked program, and where its steps are in the XML.
    pub program: Option<(Checked, SourceMap)>,
    /// The document of a project of ladder diagrams.
    pub document: Option<Document>,
    /// The variables of a project of Structured Text.
    pub variables: Vec<Variable>,
    /// What the lines of such a project show of a scan.
    pub traces: Vec<Trace>,
    /// Its charts.
    pub charts: Vec<unoclp_sfc::Document>,
    /// What of each chart each instruction comes from.
    pub origins: Vec<Vec<Option<Origin>>>,
    /// What was found in the project.
    pub diagnostics: Told,
}
