//! From one document to the next.
//!
//! An operation changes a copy, which shares all rungs that it leaves as they are. What holds for every document is
//! seen to after all of them, in `settle`.

mod alter;
mod block;
mod branch;
mod edge;
mod insert;
mod remove;
mod rungs;
mod settle;

use super::clip::{Clip, Copied, Renamed};
use super::cursor::{Cursor, Selected};
use super::operation::{Along, Operation};
use super::refusal::Refusal;
use super::state::State;
use super::timers;
use std::sync::Arc;

/// What an operation makes of a document, its cursor and what was copied.
///
/// # Errors
/// Why it is refused; then nothing has changed.
pub fn apply(state: &State, operation: &Operation) -> Result<State, Refusal> {
    let mut next = state.clone();
    let pasted = change(&mut next, operation)?;
    if next.document.says_the_same(&state.document) {
        next.document = state.document.clone();
    } else {
        timers::renumber(&state.document, &mut next.document, pasted.as_ref());
        settle::settle(&state.document, &mut next)?;
    }
    Ok(next)
}

fn change(state: &mut State, operation: &Operation) -> Result<Option<Renamed>, Refusal> {
    let cursor = state.cursor;
    let document = &mut state.document;
    match operation {
        Operation::Select(cursor) => {
            document.selected(*cursor)?;
            state.cursor = *cursor;
        }
        Operation::Move(direction) => state.cursor = document.moved(cursor, *direction),
        Operation::Extend(along) => state.cursor = extended(state, *along)?,
        Operation::Insert(draft, place) => {
            let draft = draft.clone().checked()?;
            let id = document.fresh();
            let node = super::document::Node::Element(draft.element(id));
            state.cursor = insert::nodes(document, cursor, vec![node], *place)?;
        }
        Operation::Branch => state.cursor = insert::branch(document, cursor)?,
        Operation::Stretch(along, way) => branch::stretch(document, cursor, *along, *way)?,
        Operation::Delete => state.cursor = remove::selected(document, cursor)?,
        Operation::Copy => state.clip = Some(copy(state)?),
        Operation::Cut => {
            state.clip = Some(copy(state)?);
            state.cursor = remove::selected(&mut state.document, cursor)?;
        }
        Operation::Paste(place) => {
            let clip = state.clip.clone().ok_or(Refusal::NothingCopied)?;
            let (what, renamed) = clip.renamed(document);
            state.cursor = match what {
                Copied::Nodes(nodes) => insert::nodes(document, cursor, nodes, *place)?,
                Copied::Rungs(copied) => rungs::insert(document, cursor, copied, *place)?,
            };
            return Ok(Some(renamed));
        }
        Operation::Carry(to, place) => {
            state.cursor = insert::carried(document, cursor, *to, *place)?;
        }
        Operation::Toggle => alter::toggle(document, cursor)?,
        Operation::Edge(edge) => state.cursor = edge::edge(document, cursor, *edge)?,
        Operation::Enclose(gate) => state.cursor = block::enclose(document, cursor, *gate)?,
        Operation::Dissolve => state.cursor = block::dissolve(document, cursor)?,
        Operation::Coil(coil) => alter::coil(document, cursor, *coil)?,
        Operation::Address(address) => alter::address(document, cursor, *address)?,
        Operation::Line(index, value) => alter::line(document, cursor, *index, *value)?,
        Operation::Replace(draft) => alter::replace(document, cursor, draft.clone())?,
        Operation::Point(point) => alter::point(document, cursor, *point)?,
        Operation::InsertRung(along) => state.cursor = rungs::empty(document, cursor, *along)?,
        Operation::MoveRung(along) => rungs::shift(document, cursor, *along)?,
        Operation::Split => state.cursor = rungs::split(document, cursor)?,
        Operation::Join => rungs::join(document, cursor)?,
        Operation::Comment(lines) => rungs::head(document, cursor, |rung| {
            rung.comment.clone_from(lines);
        })?,
        Operation::Labels(labels) => rungs::head(document, cursor, |rung| {
            rung.labels.clone_from(labels);
        })?,
        Operation::Begin(begin) => rungs::head(document, cursor, |rung| rung.begin = *begin)?,
        Operation::Name(point, row) => alter::name(document, *point, row.clone())?,
        Operation::Title(lines) => document.title = lines.as_slice().into(),
    }
    Ok(None)
}

fn copy(state: &State) -> Result<Arc<Clip>, Refusal> {
    let document = &state.document;
    let what = match document.selected(state.cursor)? {
        Selected::Rungs(rungs) => Copied::Rungs(document.rungs[rungs].to_vec()),
        Selected::Path { .. } => return Err(Refusal::SelectElements),
        Selected::Run(run) => {
            let series = document.rungs[run.rung].series(run.series);
            let nodes = series.and_then(|series| series.get(run.nodes));
            Copied::Nodes(nodes.ok_or(Refusal::NotThere)?.to_vec())
        }
    };
    Ok(Arc::new(Clip::of(document, what)))
}

/// The cursor with its other end one further along its series, or along the rungs.
fn extended(state: &State, along: Along) -> Result<Cursor, Refusal> {
    let document = &state.document;
    let cursor = state.cursor;
    let next = |place: usize| match along {
        Along::Back => place.checked_sub(1),
        Along::Forth => Some(place + 1),
    };
    let to = match document.selected(cursor)? {
        Selected::Path { .. } => None,
        Selected::Rungs(_) => {
            let place = document.position(cursor.to).and_then(next);
            place.and_then(|place| Some(document.rungs.get(place)?.id))
        }
        Selected::Run(run) => {
            let rung = &document.rungs[run.rung];
            let place = rung.place(cursor.to).and_then(|(_, place)| next(place));
            let series = rung.series(run.series);
            place.and_then(|place| Some(series?.get(place)?.id()))
        }
    };
    Ok(Cursor {
        to: to.unwrap_or(cursor.to),
        ..cursor
    })
}
