//! A text in Structured Text as a project: its units with their variables, their bodies as they are written, its charts
//! drawn.
//!
//! - `types`: types and first values as XML; `variables`: what is declared
//! - `chart`: a chart with its steps where they are drawn

mod chart;
mod types;
mod variables;

use super::frame;
use super::xml::escaped;
use std::fmt::Write as _;
use unoclp_lang::parts::{Parts, Unit, parts};
use unoclp_lang::typed::UnitKind;
use unoclp_sfc::Document;

/// A text in Structured Text as a project that goes by this name; [`import`](crate::import) makes the same program of it. It
/// says no date of its own. Comments between its units are left out.
pub fn export_text(text: &str, name: &str) -> String {
    let parts = parts(text);
    let mut charts = Document::all(text).into_iter();
    let mut pous = String::new();
    for unit in &parts.units {
        let chart = unit.chart.as_ref().and_then(|_| charts.next());
        pou(text, unit, chart.as_ref(), &mut pous);
    }
    frame::project(
        name,
        &format!(
            "{}    <pous>\n{pous}    </pous>\n",
            types::all(text, &parts)
        ),
        &runs(&parts),
        &variables::globals(text, &parts),
    )
}

/// The body of a unit that is a chart, with its actions and the transitions that have names.
pub(crate) fn chart_body(chart: &Document) -> String {
    let mut body = String::new();
    chart::body(chart, &mut body);
    body
}

/// The programs, in the order in which they run.
fn runs(parts: &Parts) -> String {
    let programs = parts
        .units
        .iter()
        .filter(|unit| unit.kind == UnitKind::Program);
    let run = |(number, unit): (usize, &Unit)| {
        let name = escaped(&unit.name.text);
        format!("            <pouInstance name=\"instance{number}\" typeName=\"{name}\"/>\n")
    };
    programs.enumerate().map(run).collect()
}

fn pou(text: &str, unit: &Unit, chart: Option<&Document>, to: &mut String) {
    let kind = match unit.kind {
        UnitKind::Program => "program",
        UnitKind::Function => "function",
        UnitKind::Block => "functionBlock",
    };
    let name = escaped(&unit.name.text);
    let _ = write!(
        to,
        "      <pou name=\"{name}\" pouType=\"{kind}\">
        <interface>\n"
    );
    if let Some(result) = unit.result {
        let result = types::written(text.get(result.range()).unwrap_or_default());
        let _ = writeln!(to, "          <returnType>{result}</returnType>");
    }
    unit.variables
        .iter()
        .for_each(|section| variables::section(text, section, to));
    to.push_str("        </interface>\n");
    match chart {
        Some(chart) => chart::body(chart, to),
        None => {
            let body = text.get(unit.body.range()).unwrap_or_default();
            let _ = write!(
                to,
                "        <body>\n          <ST>\n            <xhtml:p>{}</xhtml:p>\n          </ST>\n        </body>\n",
                escaped(body)
            );
        }
    }
    to.push_str("      </pou>\n");
}
