//! The requests of a page.

use crate::board::{Boards, Open, Order};
use crate::draw;
#[cfg(feature = "full")]
use crate::draw::As;
use crate::draw::Speak;
use crate::facts::{self, Facts};
use crate::given::{Given, wrong};
use crate::program::{self, Text};
use crate::words::No;
#[cfg(feature = "full")]
use crate::words::{self, both};
#[cfg(feature = "full")]
use crate::{adapt, card, edit, edit::Drawing, exercise, machine, machine::Machine, replay};
use serde::Serialize;

/// Answers a request, in JSON. What there is to ask is in `ask`, what it takes beside that: `page/web/src/tools/answers.ts`
/// has the types of both.
///
/// # Errors
/// Why there is no answer.
pub fn answer(mut given: Given, boards: &mut Boards) -> Result<String, No> {
    let ask = given.text("ask")?;
    Ok(match ask.as_str() {
        // What a board has: each limit of its points and its memory, so that a page needs to know none.
        "board" => json(Facts::of(facts::board(&mut given)?)),
        // What there is to say of a text: its problems, or its program.
        "check" => json(program::check(Text::of(&mut given)?)?),
        // Its ladder, for a page that shows it live, in so many columns where that is enough.
        "ladder" => {
            let text = Text::of(&mut given)?;
            let speak = Speak::of(&mut given)?;
            json(draw::ladder(text, given.columns("width")?, speak)?)
        }
        // A conversation with a board.
        "open" => json(boards.open(Open::of(&mut given)?)?),
        // A step of it: what has come since the last one, at this time in ms since any moment.
        "step" => {
            let (board, now) = (given.number("board")?, given.real("now")?);
            json(boards.step(board, now, &given.bytes("came")?)?)
        }
        // Something to be done by the board.
        "order" => {
            let order = Order::of(given.below("order")?)?;
            json(boards.order(given.number("board")?, order)?)
        }
        // The line is gone, and why.
        "lose" => json(boards.lose(given.number("board")?, given.text("why")?)?),
        // The end of a conversation.
        "close" => {
            boards.close(given.number("board")?);
            json(())
        }
        other => more(other, given, boards)?,
    })
}

/// A trace has no more ms: ten minutes.
#[cfg(feature = "full")]
const LONGEST_TRACE: u32 = 600_000;

/// What takes the module that has everything.
#[cfg(feature = "full")]
fn more(ask: &str, mut given: Given, boards: &mut Boards) -> Result<String, No> {
    Ok(match ask {
        // Its program in another form. Instruction List that is made is compiled again, by all that there is.
        "list" => {
            let text = Text::of(&mut given)?;
            let (form, speak) = (As::of(&mut given)?, Speak::of(&mut given)?);
            json(draw::listed(text, form, given.columns("width")?, speak)?)
        }
        // Its text with its points on its board.
        "adapt" => json(adapt::adapt(Text::of(&mut given)?)?),
        // It on pages of paper.
        "pages" => {
            let text = Text::of(&mut given)?;
            let (letter, speak) = (given.truth("letter")?, Speak::of(&mut given)?);
            json(draw::paged(text, letter, given.columns("width")?, speak)?)
        }
        // What an exercise asks.
        "sheet" => json(exercise::sheet(
            &given.text("title")?,
            &given.text("scenario")?,
            facts::board(&mut given)?,
        )?),
        // Whether its program does what the cases of a scenario file expect, and its machine too.
        "exercise" => {
            let text = Text::of(&mut given)?;
            let (title, scenario) = (given.text("title")?, given.text("scenario")?);
            let machine = match (given.text_if("plant")?, given.text_if("plantText")?) {
                (Some(name), Some(text)) => Some((name, text)),
                _ => None,
            };
            json(exercise::exercise(text, &title, &scenario, machine)?)
        }
        // Whether its program does what a machine asks, through the script of that.
        "trial" => {
            let text = Text::of(&mut given)?;
            let (name, machine) = (given.text("plant")?, given.text("plantText")?);
            json(exercise::trial(text, &name, &machine)?)
        }
        // A number for all that a machine is with it in each of so many ms.
        "trace" => {
            let text = Text::of(&mut given)?;
            let (name, machine) = (given.text("plant")?, given.text("plantText")?);
            let span: u32 = given.number("ms")?;
            json(exercise::trace(
                text,
                &name,
                &machine,
                span.min(LONGEST_TRACE).into(),
            )?)
        }
        // What a machine did with it about a time at which something went wrong.
        "replay" => {
            let text = Text::of(&mut given)?;
            let (name, machine) = (given.text("plant")?, given.text("plantText")?);
            let scenario = given.text_if("scenario")?;
            let at: u32 = given.number("at")?;
            let (why, speak) = (given.text("why")?, Speak::of(&mut given)?);
            json(replay::replay(
                text,
                (&name, &machine),
                scenario.as_deref(),
                (at.into(), &why),
                speak.into(),
            )?)
        }
        // The picture of a machine that stands.
        "picture" => {
            let (name, text) = (given.text("name")?, given.text("text")?);
            let lang = Speak::of(&mut given)?.into();
            json(machine::standing(
                &name,
                &text,
                facts::board(&mut given)?,
                lang,
            )?)
        }
        // The image of a card with this PROGRAM.TXT.
        "card" => {
            let text = Text {
                name: "PROGRAM.TXT".to_owned(),
                text: given.text("program")?,
                board: facts::board(&mut given)?,
            };
            json(card::card(text, given.truth("state")?)?)
        }
        // A file of a card, by its name, from the blocks that are not empty.
        "read" => json(card::read(card::blocks(&mut given)?, &given.text("name")?)),
        // Bytes that are free on a card, from the blocks that are not empty.
        "free" => json(card::free(card::blocks(&mut given)?)),
        // A machine to control, from its file; it stands until it is stepped.
        "machine" => {
            let (name, text) = (given.text("name")?, given.text("text")?);
            let lang = Speak::of(&mut given)?.into();
            // The same again, in another language, goes on.
            let kept = match given.truth_if("keep")? {
                Some(true) => boards.machine.take(),
                _ => None,
            };
            let find = given.text_if("find")?;
            let mut machine = match kept {
                Some(machine) => machine,
                None => {
                    let board = facts::board(&mut given)?;
                    let hidden = find.map(|find| exercise::hidden(&find, board));
                    let hidden = hidden.transpose()?;
                    Machine::open(&name, &text, board, lang, hidden.as_ref())?
                }
            };
            let known = json(machine.known(lang));
            boards.machine = Some(machine);
            known
        }
        // What has changed of its picture.
        "machineLook" => json(machine(boards)?.look()),
        // A person there changes something.
        "machineHand" => {
            let (part, value, to) = (
                given.number("part")?,
                given.number("value")?,
                given.number("to")?,
            );
            machine(boards)?.hand(part, value, to);
            json(())
        }
        // A part of it fails, or is mended.
        "machineFault" => {
            let (part, fault) = (given.number("part")?, given.text("fault")?);
            let is = given.truth("is")?;
            machine(boards)?.fault(part, &fault, is);
            json(())
        }
        // A person forces a point of the board: a step of a search.
        "machineForced" => {
            machine(boards)?.forced();
            json(())
        }
        // A person names the fault that is hidden in it; how far they are.
        "machineName" => {
            let (part, fault) = (given.number("part")?, given.text("fault")?);
            json(machine(boards)?.name(part, &fault))
        }
        // As it was at first.
        "machineReset" => {
            machine(boards)?.reset();
            json(())
        }
        // There is none any longer.
        "machineClose" => {
            boards.machine = None;
            json(())
        }
        // Firmware for a board, as Intel hex; the answer is the rate of its boot loader.
        "flash" => {
            let hex = given.text("hex")?;
            json(boards.flash.begin(&hex, &given.text("model")?)?)
        }
        // A step of that.
        "flashStep" => {
            let now = given.real("now")?;
            json(boards.flash.step(now, &given.bytes("came")?)?)
        }
        // The line is gone meanwhile, and why.
        "flashLose" => {
            boards.flash.lose(given.text("why")?);
            json(())
        }
        // The elements that can be drawn.
        "palette" => json(edit::palette()),
        // A drawing, of a text and what was done to it.
        "draw" => {
            let mut drawing = Drawing::open(&mut given)?;
            let view = json(drawing.view(&mut given)?);
            boards.drawing = Some(drawing);
            view
        }
        // Something done to it; what a page shows of it then.
        "edit" => {
            let drawing = drawing(boards)?;
            if let Some(act) = given.below_if("act")? {
                drawing.act(edit::Act::of(act)?)?;
            }
            json(drawing.view(&mut given)?)
        }
        // Its text in another form.
        "drawn" => json(drawing(boards)?.text(&given.text("as")?)?),
        // What of it has these words in it.
        "find" => json(drawing(boards)?.find(&given.text("words")?)),
        other => return Err(wrong(other).into()),
    })
}

/// The machine that is open.
#[cfg(feature = "full")]
fn machine(boards: &mut Boards) -> Result<&mut Machine, No> {
    let none = || both(words::machine_first).into();
    boards.machine.as_mut().ok_or_else(none)
}

/// The drawing that is open.
#[cfg(feature = "full")]
fn drawing(boards: &mut Boards) -> Result<&mut Drawing, No> {
    let none = || both(edit::no_drawing).into();
    boards.drawing.as_mut().ok_or_else(none)
}

/// What takes the module that has everything.
#[cfg(not(feature = "full"))]
fn more(ask: &str, _: Given, _: &mut Boards) -> Result<String, No> {
    match ask {
        "list" | "adapt" | "pages" | "sheet" | "exercise" | "trial" | "trace" | "replay"
        | "picture" | "card" | "read" | "free" | "flash" | "flashStep" | "flashLose" => {
            Err(No::More)
        }
        "palette" | "draw" | "edit" | "drawn" | "find" => Err(No::More),
        "machine" | "machineLook" | "machineHand" | "machineFault" | "machineForced"
        | "machineName" | "machineReset" | "machineClose" => Err(No::More),
        other => Err(wrong(other).into()),
    }
}

/// As JSON. What is answered has no keys but texts, and so always is.
fn json(answer: impl Serialize) -> String {
    serde_json::to_string(&answer).unwrap_or_default()
}
