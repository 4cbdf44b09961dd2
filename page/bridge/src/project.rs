//! Projects on a page: their units, the tables of their variables, their bodies; and changed, which gives another text.
//!
//! Owns the form in which a page asks for that. Must not know what an element of a file means: `unoclp-plcopen` does.

use crate::answer::answer;
use crate::given::wrong;
use crate::tell::Units;
use crate::words::{No, both};
use unoclp_assist as assist;
use unoclp_lang::Span;
use unoclp_plcopen::{
    Change, Outline, Row, Touch, Where, add, alter, draw, erase, outline, remove, retain, shown,
    touch, write_body,
};
use unoclp_workspace::Analysis;

answer! {
    /// A project.
    pub struct Project as "Project" {
        name: String,
        types: Vec<String>,
        globals: Vec<ProjectRow>,
        units: Vec<ProjectUnit>,
    }
}

answer! {
    /// A program, a function block or a function.
    pub struct ProjectUnit as "ProjectUnit" {
        name: String,
        /// `program`, `functionBlock`, `function`.
        kind: String,
        /// `LD`; empty where it has no body.
        language: String,
        /// What a function gives.
        gives: Option<String>,
        comment: String,
        variables: Vec<ProjectRow>,
        /// Where it begins in the file, units of UTF-16.
        from: usize,
    }
}

answer! {
    /// A variable.
    pub struct ProjectRow as "ProjectRow" {
        name: String,
        /// The element that declares it and others: `localVars`.
        section: String,
        kind: String,
        first: Option<String>,
        place: Option<String>,
        retained: bool,
        constant: bool,
        comment: String,
        /// Where it stands in the file, units of UTF-16.
        from: usize,
        to: usize,
    }
}

answer! {
    /// The body of a unit.
    pub struct UnitShown as "UnitShown" {
        language: String,
        /// Of ST and IL.
        text: String,
        /// Of LD and FBD.
        svg: String,
        elements: Vec<UnitElement>,
    }
}

answer! {
    /// An element of a drawn body.
    pub struct UnitElement as "UnitElement" {
        /// Its number in the file.
        id: String,
        /// The name of its element: `contact`.
        kind: String,
        written: String,
        negated: bool,
        /// `rising`, `falling`; else empty.
        edge: String,
        /// `set`, `reset`; else empty.
        storage: String,
        /// Where it stands in the file, units of UTF-16.
        from: usize,
        to: usize,
    }
}

/// The units of a project.
///
/// # Errors
/// Where the text is none.
pub fn project(analysis: &Analysis) -> Result<Project, No> {
    let text = analysis.written().text();
    let Outline {
        name,
        types,
        globals,
        units,
    } = outline(&text).map_err(|_| both(no_project))?;
    let at = &mut Units::new(&text);
    let globals = globals.into_iter().map(|of| row(of, at)).collect();
    let units = units.into_iter().map(|unit| ProjectUnit {
        from: at.of(unit.at.start as usize),
        name: unit.name,
        kind: unit.kind,
        language: unit.language,
        gives: unit.gives,
        comment: unit.comment,
        variables: unit.variables.into_iter().map(|of| row(of, at)).collect(),
    });
    let units = units.collect();
    Ok(Project {
        name,
        types,
        globals,
        units,
    })
}

fn row(of: Row, at: &mut Units<'_>) -> ProjectRow {
    let [from, to] = place(of.at, at);
    ProjectRow {
        name: of.name,
        section: of.section,
        kind: of.kind,
        first: of.first,
        place: of.place,
        retained: of.retained,
        constant: of.constant,
        comment: of.comment,
        from,
        to,
    }
}

fn place(of: Span, at: &mut Units<'_>) -> [usize; 2] {
    [of.start, of.end].map(|byte| at.of(byte as usize))
}

/// The body of a unit; null where it has none.
pub fn unit(analysis: &Analysis, name: &str) -> Option<UnitShown> {
    let text = analysis.written().text();
    let shown = shown(&text, name)?;
    let at = &mut Units::new(&text);
    let elements = shown.elements.into_iter().map(|of| {
        let [from, to] = place(of.at, at);
        UnitElement {
            id: of.id,
            kind: of.kind,
            written: of.written,
            negated: of.negated,
            edge: of.edge,
            storage: of.storage,
            from,
            to,
        }
    });
    Some(UnitShown {
        language: shown.language,
        text: shown.text,
        svg: shown.svg,
        elements: elements.collect(),
    })
}

/// A project in which something of a unit, or of the global variables, is another.
///
/// # Errors
/// Where there is no such thing, or it cannot be so.
pub fn altered(
    analysis: &Analysis,
    unit: Option<&str>,
    (what, at): (&str, &str),
    to: &str,
) -> Result<String, No> {
    let text = &analysis.written().text();
    let filled = || Some(to.trim().to_owned()).filter(|to| !to.is_empty());
    let of_row = |change: Change| alter(text, unit, at, &change);
    let own = unit.unwrap_or_default();
    let of_element = |change: Touch| touch(text, own, at, &change);
    let drawn = |place: Where| draw(text, own, place, at, to);
    let is = to == "true";
    let after = match what {
        "name" => return renamed(analysis, unit, at, &named(to)?),
        "kind" => of_row(Change::Kind(filled().ok_or_else(|| wrong("to"))?)),
        "first" => of_row(Change::First(filled())),
        "place" => of_row(Change::Place(filled())),
        "comment" => of_row(Change::Comment(to.trim().to_owned())),
        "retained" => retain(text, unit, at, is),
        "add" => add(text, unit, at, &named(to)?, "BOOL"),
        "remove" => remove(text, unit, at),
        "body" => write_body(text, own, to),
        "before" => drawn(Where::Before),
        "after" => drawn(Where::After),
        "beside" => drawn(Where::Beside),
        "below" => drawn(Where::Below),
        "erase" => erase(text, own, at),
        "written" => of_element(Touch::Written(filled().ok_or_else(|| wrong("to"))?)),
        "negated" => of_element(Touch::Negated(is)),
        "edge" => of_element(Touch::Edge(to.to_owned())),
        "storage" => of_element(Touch::Storage(to.to_owned())),
        _ => return Err(wrong("what").into()),
    };
    after.ok_or_else(|| both(not_so).into())
}

/// A project in which a variable has another name, wherever it is used.
fn renamed(analysis: &Analysis, unit: Option<&str>, at: &str, to: &str) -> Result<String, No> {
    let written = analysis.written();
    let byte = assist::declared(written, unit, at).ok_or_else(|| both(not_so))?;
    let edits = assist::rename(analysis, byte, to);
    let edits = edits.map_err(|why| No::Told(both(|lang| why.message(lang))))?;
    Ok(assist::edited(&written.text(), &edits))
}

fn named(to: &str) -> Result<String, No> {
    let name = to.trim();
    match unoclp_lang::is_name(name) {
        true => Ok(name.to_owned()),
        false => Err(both(|lang| no_name(lang, name)).into()),
    }
}

unoclp_words::messages! {
    no_project() "this is not a PLCopen XML project" "isto não é um projeto PLCopen XML";
    not_so() "this part of the project cannot be changed here" "esta parte do projeto não pode ser mudada aqui";
    no_name(name) "`{name}` is not a name: write letters, digits and `_`, with no space" "`{name}` não é um nome: escreva letras, algarismos e `_`, sem espaço";
}

#[cfg(test)]
mod tests {
    #[test]
    fn every_text_says_the_same_in_both_languages() {
        assert_eq!(unoclp_words::gaps(super::ALL), [""; 0]);
    }
}
