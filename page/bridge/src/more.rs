//! What takes the module that has everything, answered.

use crate::adapt::adapt;
use crate::ask::{More, MoreAnswer as Answer};
use crate::board::Boards;
use crate::edit::{Act, Drawing};
use crate::machine::{self, Machine};
use crate::program::{known, source};
use crate::words::{self, No, both};
use crate::{assist, card, chart, draw, exercise, project, replay};
use unoclp_program::Written;
use unoclp_workspace::Workspace;

/// A trace has no more ms: ten minutes.
const LONGEST_TRACE: u32 = 600_000;

/// Answers an ask.
///
/// # Errors
/// Why there is no answer.
pub fn answer(ask: More, boards: &mut Boards) -> Result<Answer, No> {
    let workspace = &mut boards.workspace;
    Ok(match ask {
        More::Slow { version, left } => Answer::Slow(boards.stood(version, &left.0)?),
        More::Slowly { board, to, through } => {
            Answer::Slowly(boards.slowly(board, to.0.as_deref(), through)?)
        }
        More::List {
            version,
            form,
            width,
            speak,
        } => {
            let text = known(version, workspace)?;
            Answer::List(draw::listed(source(&text)?, form, width.0, speak)?)
        }
        More::Adapt { version } => Answer::Adapt(adapt(known(version, workspace)?.written())),
        More::Pages {
            version,
            letter,
            width,
            speak,
        } => {
            let text = known(version, workspace)?;
            Answer::Pages(draw::paged(source(&text)?, letter, width.0, speak))
        }
        More::Sheet {
            title,
            scenario,
            board,
        } => Answer::Sheet(exercise::sheet(&title, &scenario, board)?),
        More::Exercise {
            version,
            title,
            scenario,
            plant,
            plant_text,
        } => {
            let text = known(version, workspace)?;
            let machine = plant.zip(plant_text);
            let outcome = exercise::exercise(source(&text)?, &title, &scenario, machine)?;
            Answer::Exercise(outcome)
        }
        More::Trial {
            version,
            plant,
            plant_text,
        } => {
            let text = known(version, workspace)?;
            Answer::Trial(exercise::trial(source(&text)?, &plant, &plant_text)?)
        }
        More::Trace {
            version,
            plant,
            plant_text,
            ms,
        } => {
            let (text, span) = (known(version, workspace)?, ms.min(LONGEST_TRACE).into());
            Answer::Trace(exercise::trace(source(&text)?, &plant, &plant_text, span)?)
        }
        More::Replay {
            version,
            plant,
            plant_text,
            scenario,
            at,
            why,
            speak,
        } => {
            let (text, scenario) = (known(version, workspace)?, scenario.as_deref());
            let (machine, at) = ((&*plant, &*plant_text), (at.into(), &*why));
            let program = source(&text)?;
            Answer::Replay(replay::replay(
                program,
                machine,
                scenario,
                at,
                speak.into(),
            )?)
        }
        More::Picture {
            name,
            text,
            board,
            speak,
        } => Answer::Picture(machine::standing(&name, &text, board, speak.into())?),
        More::Card {
            program,
            state,
            board,
        } => {
            let written = Written::new("PROGRAM.TXT".to_owned(), program.into_bytes(), board);
            Answer::Card(card::card(&workspace.look(written), state)?)
        }
        More::Read { blocks, name } => Answer::Read(card::read(blocks.0, &name)),
        More::Free { blocks } => Answer::Free(card::free(blocks.0)),
        More::Machine {
            name,
            text,
            speak,
            keep,
            find,
            board,
        } => {
            let lang = speak.into();
            // The same again, in another language, goes on.
            let kept = boards.machine.take().filter(|_| keep == Some(true));
            let machine = match kept {
                Some(machine) => machine,
                None => {
                    let hidden = find.map(|find| exercise::hidden(&find, board));
                    let hidden = hidden.transpose()?;
                    Machine::open(&name, &text, board, lang, hidden.as_ref())?
                }
            };
            Answer::Machine(boards.machine.insert(machine).known(lang))
        }
        More::MachineLook {} => Answer::MachineLook(open(boards)?.look()),
        More::MachineHand { part, value, to } => {
            open(boards)?.hand(part, value, to);
            Answer::MachineHand(())
        }
        More::MachineFault { part, fault, is } => {
            open(boards)?.fault(part, &fault, is);
            Answer::MachineFault(())
        }
        More::MachineForced {} => {
            open(boards)?.forced();
            Answer::MachineForced(())
        }
        More::MachineName { part, fault } => Answer::MachineName(open(boards)?.name(part, &fault)),
        More::MachineReset {} => {
            open(boards)?.reset();
            Answer::MachineReset(())
        }
        More::MachineClose {} => {
            boards.machine = None;
            Answer::MachineClose(())
        }
        More::Palette {} => Answer::Palette(unoclp_edit::palette()),
        More::Draw {
            base,
            log,
            name,
            board,
            width,
            is_blocks,
            speak,
        } => {
            let mut drawing = Drawing::open(base.0, log.0, board, workspace)?;
            let view = drawing.view(
                name,
                board,
                (width.0, draw::look(is_blocks), speak),
                workspace,
            );
            boards.drawing = Some(drawing);
            Answer::Draw(Box::new(view))
        }
        More::Edit {
            act,
            name,
            board,
            width,
            is_blocks,
            speak,
        } => {
            let (drawing, workspace) = drawing(boards)?;
            if let Some(act) = act {
                drawing.act(Act::of(act, board)?, workspace)?;
            }
            Answer::Edit(Box::new(drawing.view(
                name,
                board,
                (width.0, draw::look(is_blocks), speak),
                workspace,
            )))
        }
        More::Drawn { form } => Answer::Drawn(drawing(boards)?.0.text(form)?),
        More::Chart {
            version,
            look,
            chart,
            what,
            at,
            say,
            qualifier,
            time,
        } => {
            let act = what.map(|what| chart::Act {
                chart,
                what,
                at: at.unwrap_or_default(),
                say: say.unwrap_or_default(),
                qualifier: qualifier.unwrap_or_default(),
                time: time.unwrap_or_default(),
            });
            let text = known(version, workspace)?;
            let charted = chart::charted(&text, look.as_deref().unwrap_or_default(), act)?;
            Answer::Chart(Box::new(charted))
        }
        More::Project { version } => {
            Answer::Project(Box::new(project::project(&*known(version, workspace)?)?))
        }
        More::Unit { version, unit } => {
            Answer::Unit(project::unit(&*known(version, workspace)?, &unit))
        }
        More::Alter {
            version,
            unit,
            what,
            at,
            to,
        } => {
            let text = known(version, workspace)?;
            Answer::Alter(project::altered(&text, unit.as_deref(), (&what, &at), &to)?)
        }
        More::Find { words } => Answer::Find(drawing(boards)?.0.find(&words)),
        More::Complete { version, at, speak } => {
            Answer::Complete(assist::complete(&*known(version, workspace)?, at, speak))
        }
        More::Meant { version, at, speak } => {
            Answer::Meant(assist::meant(&*known(version, workspace)?, at, speak))
        }
        More::Uses { version, at } => Answer::Uses(assist::uses(&*known(version, workspace)?, at)),
        More::Rename { version, at, to } => {
            Answer::Rename(assist::rename(&*known(version, workspace)?, at, &to)?)
        }
        More::Form { version } => Answer::Form(assist::form(&*known(version, workspace)?)),
        More::Remedies {
            version,
            from,
            to,
            speak,
        } => Answer::Remedies(assist::remedies(
            &*known(version, workspace)?,
            from,
            to,
            speak,
        )),
    })
}

/// The machine that is open.
fn open(boards: &mut Boards) -> Result<&mut Machine, No> {
    let none = || both(words::machine_first).into();
    boards.machine.as_mut().ok_or_else(none)
}

/// The drawing that is open.
fn drawing(boards: &mut Boards) -> Result<(&mut Drawing, &mut Workspace), No> {
    let none = || both(unoclp_edit::no_drawing);
    let drawing = boards.drawing.as_mut().ok_or_else(none)?;
    Ok((drawing, &mut boards.workspace))
}
