//! The rows as a page for a browser or a printer, which needs nothing but itself.

use super::row::{Fail, Row, Shown};
use crate::messages;
use maud::{DOCTYPE, Markup, PreEscaped, html};
use unoclp_exercise::scenario::Exercise;
use unoclp_program::Lang;

const STYLE: &str = include_str!("page.css");

/// The page.
pub fn html(rows: &[Row], exercise: &Exercise) -> String {
    let lang = messages::spoken();
    let name = match lang {
        Lang::En => "en",
        Lang::Pt => "pt-BR",
    };
    let title = exercise.title.text(lang);
    let passed = rows.iter().filter(|row| row.is_passed()).count();
    let page = html! {
        (DOCTYPE)
        html lang=(name) {
            head {
                meta charset="utf-8";
                title { (title) }
                style { (PreEscaped(STYLE)) }
            }
            body {
                h1 { (title) }
                @if let Some(task) = &exercise.task { p { (task.text(lang)) } }
                p { (messages::programs_passed(title, passed, rows.len())) }
                (table(rows, exercise))
                @for (index, row) in rows.iter().enumerate() {
                    @if let Some(fail) = &row.fail { (failing(index, row, fail, exercise)) }
                }
            }
        }
    };
    page.into_string()
}

/// A line for each program; those that did not pass lead to what shows why.
fn table(rows: &[Row], exercise: &Exercise) -> Markup {
    html! {
        table {
            thead {
                tr {
                    th { (messages::grade_file()) }
                    th { (if exercise.find.is_some() { messages::grade_tries() } else { messages::grade_cases() }) }
                    @if exercise.plant.is_some() { th { (messages::grade_machine()) } }
                    th { (messages::grade_failing()) }
                }
            }
            tbody {
                @for (index, row) in rows.iter().enumerate() {
                    tr {
                        td { (row.file) }
                        @match row.tries {
                            Some(tries) => td { (tries) },
                            None => td { (row.passed) "/" (exercise.cases().len()) },
                        }
                        @if exercise.plant.is_some() {
                            @match &row.machine {
                                None => td.yes { (messages::passed()) },
                                Some(why) => td.no { (why) },
                            }
                        }
                        @match &row.fail {
                            None => td.yes { (messages::passed()) },
                            Some(fail) => td.no { a href=(format!("#p{index}")) { (fail.case) } },
                        }
                    }
                }
            }
        }
    }
}

/// The first case that a program did not pass.
fn failing(index: usize, row: &Row, fail: &Fail, exercise: &Exercise) -> Markup {
    html! {
        section id=(format!("p{index}")) {
            h2 { (row.file) }
            @match (fail.shown.diagram(exercise), &fail.shown) {
                (Some(svg), _) => (PreEscaped(svg)),
                (None, Shown::Excerpt(excerpt)) => {
                    p { (fail.case) ": " (fail.why) }
                    @if !excerpt.is_empty() { pre { (excerpt) } }
                }
                (None, Shown::Run(_)) => p { (fail.why) },
            }
        }
    }
}
