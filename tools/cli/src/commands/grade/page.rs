//! The rows as a page for a browser or a printer, which needs no other file.

use super::course::{Course, Task};
use super::row::{Fail, Row, Shown, Work};
use crate::messages;
use maud::{DOCTYPE, Markup, PreEscaped, html};
use unoclp_program::Lang;

const STYLE: &str = include_str!("page.css");

/// The page: a table for each exercise, then what each program is and why it did not pass.
pub fn html(rows: &[Row<'_>], course: &Course) -> String {
    let lang = messages::spoken();
    let name = match lang {
        Lang::En => "en",
        Lang::Pt => "pt-BR",
    };
    let all: Vec<(usize, &Row<'_>)> = rows.iter().enumerate().collect();
    let title = match course.only() {
        Some(task) => task.exercise.title.text(lang).to_owned(),
        None => messages::grade_class(),
    };
    let page = html! {
        (DOCTYPE)
        html lang=(name) {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                title { (title) }
                style { (PreEscaped(STYLE)) }
            }
            body {
                @if let Some(task) = course.only() { (exercise(&all, task)) } @else {
                    h1 { (title) }
                    @for task in &course.tasks {
                        @let own: Vec<_> = all.iter().copied().filter(|(_, row)| row.is_of(task)).collect();
                        @if !own.is_empty() { (exercise(&own, task)) }
                    }
                    @let lost: Vec<_> = all.iter().copied().filter(|(_, row)| row.task.is_none()).collect();
                    @if !lost.is_empty() {
                        h1 { (messages::not_graded()) }
                        (table(&lost, None))
                    }
                }
                @for &(index, row) in &all { (program(index, row)) }
            }
        }
    };
    page.into_string()
}

/// What an exercise asks, and how each did.
fn exercise(rows: &[(usize, &Row<'_>)], task: &Task) -> Markup {
    let lang = messages::spoken();
    let title = task.exercise.title.text(lang);
    let passed = rows.iter().filter(|(_, row)| row.is_passed()).count();
    html! {
        h1 { (title) }
        @if let Some(task) = &task.exercise.task { p { (task.text(lang)) } }
        p { (messages::programs_passed(title, passed, rows.len())) }
        (table(rows, Some(task)))
    }
}

/// A line for each program, which leads to what it is.
fn table(rows: &[(usize, &Row<'_>)], task: Option<&Task>) -> Markup {
    let has_machine = task.is_some_and(|task| task.plant.is_some());
    let is_find = task.is_some_and(|task| task.exercise.find.is_some());
    let has_names = rows.iter().any(|(_, row)| row.student.is_some());
    html! {
        table {
            thead {
                tr {
                    th { (if has_names { messages::grade_name() } else { messages::grade_file() }) }
                    @if has_names { th { (messages::grade_minutes()) } }
                    th { (if is_find { messages::grade_tries() } else { messages::grade_cases() }) }
                    @if has_machine { th { (messages::grade_machine()) } }
                    th { (messages::grade_failing()) }
                }
            }
            tbody {
                @for (index, row) in rows {
                    tr {
                        td { a href=(format!("#p{index}")) { (row.who()) } }
                        @if has_names {
                            td { @if let Some(minutes) = row.student.as_ref().and_then(|it| it.minutes) { (minutes) } }
                        }
                        @match row.tries {
                            Some(tries) => td { (tries) },
                            None => td { (row.passed) "/" (row.cases()) },
                        }
                        @if has_machine {
                            @match &row.machine {
                                None => td.yes { (messages::passed()) },
                                Some(why) => td.no { (why) },
                            }
                        }
                        @match &row.fail {
                            None => td.yes { (messages::passed()) },
                            Some(fail) => td.no { (fail.case) },
                        }
                    }
                }
            }
        }
    }
}

/// A program: why it did not pass, and the program itself.
fn program(index: usize, row: &Row<'_>) -> Markup {
    let lang = messages::spoken();
    let title = row.task.map(|task| task.exercise.title.text(lang));
    html! {
        section id=(format!("p{index}")) {
            h2 { (row.who()) @if let Some(title) = title { ": " (title) } }
            @if let Some(student) = &row.student {
                p { (row.file) @if !student.number.is_empty() { " · " (student.number) } }
            }
            @if row.is_boast() { p.no { (messages::says_passed(&row.file)) } }
            @if let Some(fail) = &row.fail { (failing(row, fail)) }
            @match &row.work {
                Some(Work::Ladder(svg)) => figure.ladder { (PreEscaped(svg)) },
                Some(Work::Text(text)) => pre { (text) },
                None => {}
            }
        }
    }
}

/// The first case that a program did not pass.
fn failing(row: &Row<'_>, fail: &Fail) -> Markup {
    let diagram = row.task.and_then(|task| fail.shown.diagram(&task.exercise));
    html! {
        @match (diagram, &fail.shown) {
            (Some(svg), _) => (PreEscaped(svg)),
            (None, Shown::Excerpt(excerpt)) => {
                p { (fail.case) ": " (fail.why) }
                @if !excerpt.is_empty() { pre { (excerpt) } }
            }
            (None, Shown::Run(_)) => p { (fail.why) },
        }
    }
}
