//! Charts on a page: drawn, with what a person may change of each part; and changed, which gives another text.
//!
//! Owns the form in which a page asks for that. Must not know what an operation does: `unoclp-sfc` does.

use crate::answer::answer;
use crate::given::wrong;
use crate::tell::Units;
use crate::words::{No, both};
use std::collections::HashMap;
use std::ops::Range;
use unoclp_exercise::live::Charts;
use unoclp_plcopen::{Charts as InProject, is_project, write_chart};
use unoclp_program::{Lang, list::Look};
use unoclp_sfc::edit::{Operation, Refusal, Side};
use unoclp_sfc::{Document, Id, Origin, Qualifier, Sheet, svg};
use unoclp_workspace::Analysis;

answer! {
    /// The charts of a text.
    pub struct Charted as "Charted" {
        charts: Vec<ChartDrawn>,
        /// The text after what was done.
        text: Option<String>,
        /// What is selected then.
        select: Option<String>,
    }
}

answer! {
    /// A chart.
    pub struct ChartDrawn as "ChartDrawn" {
        /// The unit that it is the body of.
        unit: String,
        /// The element.
        svg: String,
        /// What is on it, from top to bottom along its lines.
        parts: Vec<ChartPart>,
        /// The points of each step: whether it is active, and its time; none while the text is no program.
        points: Vec<[Option<String>; 2]>,
    }
}

answer! {
    /// A part of a chart, and what can be changed of it.
    pub struct ChartPart as "ChartPart" {
        id: String,
        kind: &'static str,
        /// Its middle, in the units of the drawing.
        x: f32,
        y: f32,
        /// The step, the action, the step that a jump leads to, or the name of a transition.
        name: String,
        /// A condition, or the body of an action.
        text: String,
        qualifier: &'static str,
        time: String,
        priority: String,
        initial: bool,
        /// The numbers of the steps that a transition leaves.
        from: Vec<usize>,
        /// Where it stands in the text, and where the statements of its action do: units of UTF-16, from and to.
        places: Vec<[usize; 2]>,
        /// The instructions that it has become, from 0; none while the text is no program.
        steps: Vec<usize>,
    }
}

/// What is done.
pub struct Act {
    /// The number of the chart.
    pub chart: u32,
    /// What.
    pub what: String,
    /// To what.
    pub at: String,
    /// What is written.
    pub say: String,
    /// The qualifier and the time of an action.
    pub qualifier: String,
    /// The time.
    pub time: String,
}

/// The charts of a text, after something is done to one of them.
///
/// # Errors
/// Why that is not done.
pub fn charted(analysis: &Analysis, look: &str, act: Option<Act>) -> Result<Charted, No> {
    let look = if look == "grafcet" {
        Look::Grafcet
    } else {
        Look::Norm
    };
    let of = analysis.written().text();
    let is_project = is_project(&of);
    let all = |text: &str| match is_project {
        true => {
            let mut charts = InProject::of(text);
            (std::mem::take(&mut charts.documents), Some(charts))
        }
        false => (Document::all(text), None),
    };
    let (mut documents, mut project) = all(&of);
    let (mut text, mut select) = (None, None);
    if let Some(act) = act {
        let chart = documents
            .get(act.chart as usize)
            .ok_or_else(|| wrong("chart"))?;
        let done = chart.after(&operation(&act)?);
        let (after, id) = done.map_err(|why| both(|lang| refused(lang, why)))?;
        let after = match is_project {
            true => write_chart(&of, &after).ok_or_else(|| both(drawn_parts))?,
            false => after.text(),
        };
        (documents, project) = all(&after);
        (text, select) = (Some(after), Some(id.to_string()));
    }
    // What has just been changed is compiled when the page has its text.
    let source = match text {
        None => analysis.source(),
        Some(_) => None,
    };
    let live = source.map(Charts::new).unwrap_or_default();
    let file = text.as_deref().unwrap_or(&of);
    let project = project.as_ref().map(|project| (project, file));
    let charts = documents.iter().map(|document| {
        let known = source.and_then(|source| {
            let mut charts = source.charts.iter().zip(&source.origins);
            charts.find(|(chart, _)| chart.unit == document.unit)
        });
        let origins = known.map_or(&[][..], |(_, origins)| origins);
        drawn(document, look, &live, project, origins)
    });
    Ok(Charted {
        charts: charts.collect(),
        text,
        select,
    })
}

fn drawn(
    document: &Document,
    look: Look,
    live: &Charts,
    project: Option<(&InProject, &str)>,
    origins: &[Option<Origin>],
) -> ChartDrawn {
    let sheet = Sheet::drawn(document, look);
    let of_unit = |chart: &&unoclp_exercise::live::Chart| chart.document.unit == document.unit;
    let points = live.all().iter().find(of_unit).map_or(Vec::new(), |chart| {
        let name = |point: unoclp_point::Address| point.to_string();
        chart
            .points()
            .map(|points| points.map(|point| point.map(name)))
            .collect()
    });
    let text = document.text();
    let places = document.places();
    // Each kind stands in its order.
    let all = [places.steps, places.transitions, places.actions];
    let [steps, transitions, actions] = match project {
        None => in_units(
            &text,
            all.map(|all| all.into_iter().map(|one| vec![one]).collect()),
        ),
        // It has its charts in another form.
        Some((project, file)) => {
            let in_file = |place: Range<usize>| project.in_file(place);
            in_units(file, all.map(|all| all.into_iter().map(in_file).collect()))
        }
    };
    let placed = |id| match id {
        Id::Step(step) => (steps.get(step), None),
        Id::Does(step, nth) => {
            let does = document.steps.get(step).and_then(|of| of.does.get(nth));
            let action = does.and_then(|does| document.action(&does.action));
            (
                steps.get(step),
                action.and_then(|action| actions.get(action)),
            )
        }
        Id::Transition(of) | Id::Jump(of, _) | Id::Wait(of, _) => (transitions.get(of), None),
    };
    let parts = sheet.items.iter().map(|item| {
        let mut part = part(document, item.id, item.middle());
        let (own, action) = placed(item.id);
        let places = own.into_iter().chain(action).flatten();
        part.places = places.copied().collect();
        let origin = document.origin(item.id);
        let made = origins.iter().enumerate();
        let made = made.filter(|(_, from)| from.is_some() && **from == origin);
        part.steps = made.map(|(step, _)| step).collect();
        part
    });
    let parts = parts.collect();
    ChartDrawn {
        unit: document.unit.clone(),
        svg: svg(document, &sheet, None, &document.unit, true),
        parts,
        points,
    }
}

/// The places of each part of each kind.
type Places<P> = [Vec<Vec<P>>; 3];

/// Places in units of UTF-16.
fn in_units(text: &str, places: Places<Range<usize>>) -> Places<[usize; 2]> {
    let all = places.iter().flatten().flatten();
    let mut bytes: Vec<usize> = all.flat_map(|place| [place.start, place.end]).collect();
    bytes.sort_unstable();
    let mut units = Units::new(text);
    let known: HashMap<usize, usize> = bytes.into_iter().map(|at| (at, units.of(at))).collect();
    let of = |byte: usize| known.get(&byte).copied().unwrap_or(0);
    let place = |place: Range<usize>| [of(place.start), of(place.end)];
    let part = |part: Vec<Range<usize>>| part.into_iter().map(place).collect();
    places.map(|kind| kind.into_iter().map(part).collect())
}

fn part(document: &Document, id: Id, (x, y): (f32, f32)) -> ChartPart {
    let mut part = ChartPart {
        id: id.to_string(),
        kind: "step",
        x,
        y,
        name: String::new(),
        text: String::new(),
        qualifier: "",
        time: String::new(),
        priority: String::new(),
        initial: false,
        from: Vec::new(),
        places: Vec::new(),
        steps: Vec::new(),
    };
    match id {
        Id::Step(step) => {
            if let Some(step) = document.steps.get(step) {
                part.name.clone_from(&step.name);
                part.initial = step.initial;
            }
        }
        Id::Does(step, nth) => {
            part.kind = "does";
            let does = document.steps.get(step).and_then(|step| step.does.get(nth));
            if let Some(does) = does {
                part.name.clone_from(&does.action);
                part.qualifier = does.qualifier.name();
                part.time = does.time.clone().unwrap_or_default();
                let body = document.action(&does.action);
                part.text = body.map_or(String::new(), |body| document.actions[body].body.clone());
            }
        }
        Id::Transition(number) | Id::Jump(number, _) | Id::Wait(number, _) => {
            part.kind = match id {
                Id::Transition(_) => "transition",
                Id::Jump(..) => "jump",
                _ => "wait",
            };
            if let Some(of) = document.transitions.get(number) {
                part.text.clone_from(&of.condition);
                let from = of.from.iter().filter_map(|name| document.step(name));
                part.from = from.collect();
                part.priority = of.priority.map_or(String::new(), |of| of.to_string());
                part.name = match id {
                    Id::Jump(_, nth) => of.to.get(nth).cloned().unwrap_or_default(),
                    _ => of.to.first().cloned().unwrap_or_default(),
                };
            }
        }
    }
    part
}

/// What a page asks for.
fn operation(act: &Act) -> Result<Operation, No> {
    let id: Id = act.at.parse().map_err(|_| wrong("at"))?;
    let say = || act.say.clone();
    Ok(match &*act.what {
        "after" => Operation::StepAfter(id),
        "before" => Operation::StepBefore(id),
        "branch" => Operation::Branch(id),
        "beside" => Operation::Beside(id),
        "jump" => Operation::Jump(id, say()),
        "act" => Operation::Act(id),
        "remove" => Operation::Remove(id),
        "left" => Operation::Move(id, Side::Left),
        "right" => Operation::Move(id, Side::Right),
        "rename" => Operation::Rename(id, say()),
        "condition" => Operation::Condition(id, say()),
        "lead" => Operation::Lead(id, say()),
        "priority" => {
            let number = act.say.trim();
            let number = match number {
                "" => None,
                number => Some(number.parse().map_err(|_| wrong("say"))?),
            };
            Operation::Priority(id, number)
        }
        "initial" => Operation::Initial(id),
        "does" => {
            let qualifier = Qualifier::named(&act.qualifier).ok_or_else(|| wrong("qualifier"))?;
            let time = Some(act.time.clone()).filter(|time| !time.is_empty());
            Operation::Does(id, say(), qualifier, time)
        }
        "body" => Operation::Body(act.at_name(), say()),
        _ => return Err(wrong("what").into()),
    })
}

impl Act {
    /// The name of the action whose body is written: it stands where others have a time.
    fn at_name(&self) -> String {
        self.time.clone()
    }
}

unoclp_words::messages! {
    drawn_parts() "this chart has drawn conditions or actions; change it in the editor that drew it" "este SFC tem condições ou ações desenhadas; mude-o no editor que o desenhou";
    not_there() "the selected element no longer exists" "o elemento selecionado já não existe";
    select_step() "select a step first; no step can be parallel to the initial step" "selecione antes uma etapa; nenhuma etapa pode ser paralela à etapa inicial";
    select_transition() "select a transition first" "selecione antes uma transição";
    last_step() "a chart needs at least one step" "um SFC precisa de pelo menos uma etapa";
    no_name() "this is not a valid name; use letters, digits and _" "este nome não é válido; use letras, algarismos e _";
    name_taken() "another part of the chart has that name" "outra parte do SFC já tem esse nome";
    no_further() "no further move is possible in this direction" "não é possível mover mais o elemento nesta direção";
    missing() "a condition or a time is missing" "falta uma condição ou um tempo";
    not_one_part() "the text in this field ends its part of the chart too early; write only an expression, or statements" "o texto deste campo encerra cedo demais a sua parte do SFC; escreva só uma expressão, ou comandos";
}

/// Why nothing is done.
fn refused(lang: Lang, why: Refusal) -> String {
    match why {
        Refusal::NotThere => not_there(lang),
        Refusal::SelectStep => select_step(lang),
        Refusal::SelectTransition => select_transition(lang),
        Refusal::LastStep => last_step(lang),
        Refusal::NoName => no_name(lang),
        Refusal::NameTaken => name_taken(lang),
        Refusal::NoFurther => no_further(lang),
        Refusal::Missing => missing(lang),
        Refusal::NotOnePart => not_one_part(lang),
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn every_text_says_the_same_in_both_languages() {
        assert_eq!(unoclp_words::gaps(super::ALL), [""; 0]);
    }
}
