//! The requests of a page, answered.

use crate::ask::{Answer, First, MORE};
use crate::board::{Boards, Open, orders};
use crate::draw;
use crate::facts::Facts;
use crate::given::{Given, wrong};
use crate::json::json;
use crate::program::{self, known};
use crate::words::No;

/// Answers a request, in JSON.
///
/// # Errors
/// Why there is no answer.
pub fn answer(mut given: Given, boards: &mut Boards) -> Result<String, No> {
    let name = given.text("ask")?;
    if let Some(ask) = First::read(&name, &mut given)? {
        return Ok(json(first(ask, boards)?));
    }
    #[cfg(feature = "full")]
    if let Some(ask) = crate::ask::More::read(&name, &mut given)? {
        return Ok(json(crate::more::answer(ask, boards)?));
    }
    Err(match MORE.contains(&name.as_str()) {
        true => No::More,
        false => wrong(&name).into(),
    })
}

fn first(ask: First, boards: &mut Boards) -> Result<Answer, No> {
    let workspace = &mut boards.workspace;
    Ok(match ask {
        First::Board { board } => Answer::Board(Facts::of(board)),
        First::Text { name, text, board } => {
            Answer::Text(workspace.set_text(program::written(name, text, board)?).0)
        }
        First::Check { version } => {
            Answer::Check(Box::new(program::check(&*known(version, workspace)?)?))
        }
        First::Ladder {
            version,
            width,
            is_blocks,
            speak,
        } => {
            let analysis = known(version, workspace)?;
            Answer::Ladder(draw::ladder(
                &analysis,
                width.0,
                draw::look(is_blocks),
                speak,
            )?)
        }
        First::Open {
            version,
            reset,
            core,
            board,
            address,
            rate,
            parity,
        } => {
            let known = |version| known(version, workspace);
            let open = Open {
                core: core.unwrap_or_default().then_some(board),
                program: version.map(known).transpose()?,
                reset,
                address,
                rate,
                parity,
            };
            Answer::Open(boards.open(open)?)
        }
        First::Step { board, now, came } => Answer::Step(boards.step(board, now, &came)?),
        First::Order { board, mut order } => {
            let order = orders::read(&mut order, workspace)?;
            Answer::Order(boards.order(board, order)?)
        }
        First::Lose { board, why } => Answer::Lose(boards.lose(board, why)?),
        First::Close { board } => {
            boards.close(board);
            Answer::Close(())
        }
    })
}
