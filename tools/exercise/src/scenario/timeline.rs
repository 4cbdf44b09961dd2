//! From the steps of a file to the scans of a run.
//!
//! Owns which steps, settings and expectations are right. Must not know files, nor what a run is for.

use super::keys::{FileKeys, Slip, StepKeys, StopKeys, slip};
use super::{Given, MOST_SCANS, Place, Setting, Step, Stop, Timeline, Wrong, within};
use std::num::NonZeroU32;
use std::ops::{Range, RangeInclusive};
use toml::Spanned;
use unoclp_core::{Board, Cause, Millis, Point};
use unoclp_host_sim::engine::{Cell, Refusal};
use unoclp_point::Address;

/// A fault that there is, with a line that there can be.
pub(super) fn known_fault(
    number: u8,
    line: Option<u32>,
    place: Range<usize>,
) -> Result<Refusal, Slip> {
    if !Cause::ALL.iter().any(|cause| cause.number() == number) {
        return Err(slip(Some(place), Wrong::NoFault { number }));
    }
    if line == Some(0) {
        return Err(slip(Some(place), Wrong::LineZero));
    }
    Ok(Refusal { number, line })
}

/// How the scans of a file's runs follow each other.
#[derive(Clone, Copy)]
pub(super) struct Rhythm<'k> {
    /// Reading of the millisecond clock at the first scan.
    start: Millis,
    /// ms from scan to scan.
    period: NonZeroU32,
    /// ms that a place has to become as expected.
    within: Millis,
    /// The board whose points its steps name.
    board: Board,
    /// The program that a run is to be like.
    given: Option<&'k Given>,
}

impl<'k> Rhythm<'k> {
    /// That of a file; its runs are to be like this program, where there is one.
    pub(super) fn of(
        keys: &FileKeys,
        board: Board,
        given: Option<&'k Given>,
    ) -> Result<Rhythm<'k>, Slip> {
        let period = match &keys.scan_ms {
            None => NonZeroU32::MIN,
            Some(ms) => NonZeroU32::new(*ms.get_ref())
                .ok_or_else(|| slip(Some(ms.span()), Wrong::NoPeriod))?,
        };
        let within = match &keys.within_ms {
            None => 0,
            Some(ms) if *ms.get_ref() % period != 0 => {
                return Err(slip(Some(ms.span()), no_scan(*ms.get_ref(), period)));
            }
            Some(ms) => *ms.get_ref(),
        };
        Ok(Rhythm {
            start: keys.start_ms.as_ref().map_or(0, |ms| *ms.get_ref()),
            period,
            within,
            board,
            given,
        })
    }

    /// A run: its steps, its end, and the fault that it ends in, all as the file has them.
    pub(super) fn timeline(
        self,
        step: &[Spanned<StepKeys>],
        until: Option<&Spanned<Millis>>,
        stops: Option<&Spanned<StopKeys>>,
    ) -> Result<Timeline, Slip> {
        let Rhythm {
            start,
            period,
            within,
            board,
            given,
        } = self;
        let mut steps = steps(step, period, board)?;
        if let Some(given) = given {
            let last = steps.last().map(|step| step.at);
            let until = until.map(|until| *until.get_ref()).or(last).unwrap_or(0);
            let until = until.min(MOST_SCANS as Millis);
            steps = given.expect(steps, (start, period.get(), until), board);
        }
        let steps = within::allow(steps, within);
        let last = steps.last().map(|step| step.at);
        let stop = match stops {
            Some(stop) => Some(self::stop(stop, until.is_some(), last, period)?),
            None => None,
        };
        let last = last.max(stop.map(|stop| stop.at));
        let until = match (until, last) {
            (Some(until), Some(last)) if *until.get_ref() < last => {
                return Err(slip(Some(until.span()), Wrong::EndsEarly { last }));
            }
            (Some(until), _) => *until.get_ref(),
            (None, Some(last)) => last,
            (None, None) => return Err(slip(None, Wrong::NothingHappens)),
        };
        Ok(Timeline {
            start,
            period,
            steps,
            until,
            stop,
            board,
        })
    }
}

impl Timeline {
    /// The same, whose scans are added to those of the runs before.
    ///
    /// # Errors
    /// If all of them come to more than [`MOST_SCANS`].
    pub(super) fn within(self, scans: &mut u64) -> Result<Timeline, Slip> {
        *scans += u64::from(self.until / self.period) + 1;
        match *scans > MOST_SCANS {
            true => Err(slip(None, Wrong::TooManyScans { scans: *scans })),
            false => Ok(self),
        }
    }
}

/// The fault that a run ends in.
fn stop(
    stop: &Spanned<StopKeys>,
    has_end: bool,
    last: Option<Millis>,
    period: NonZeroU32,
) -> Result<Stop, Slip> {
    let &StopKeys { at, number, line } = stop.get_ref();
    if has_end || last > Some(at) {
        return Err(slip(Some(stop.span()), Wrong::GoesOn));
    }
    if at % period != 0 {
        return Err(slip(Some(stop.span()), no_scan(at, period)));
    }
    let refusal = known_fault(number, line, stop.span())?;
    Ok(Stop { at, refusal })
}

fn no_scan(at: Millis, period: NonZeroU32) -> Wrong {
    let period = period.get();
    Wrong::NoScan { at, period }
}

fn steps(keys: &[Spanned<StepKeys>], period: NonZeroU32, board: Board) -> Result<Vec<Step>, Slip> {
    let mut steps: Vec<Step> = Vec::new();
    for step in keys {
        let StepKeys {
            at,
            restart,
            set,
            expect,
        } = step.get_ref();
        let (place, at) = (Some(at.span()), *at.get_ref());
        if let Some(last) = steps.last().filter(|last| last.at >= at) {
            let last = last.at;
            return Err(slip(place, Wrong::Order { at, last }));
        }
        if at % period != 0 {
            return Err(slip(place, no_scan(at, period)));
        }
        let set = set
            .iter()
            .map(|pair| setting(pair, board))
            .collect::<Result<_, Slip>>()?;
        let expect = expect
            .iter()
            .map(|pair| expectation(pair, board))
            .collect::<Result<_, Slip>>()?;
        steps.push(Step {
            at,
            restart: *restart,
            set,
            expect,
        });
    }
    Ok(steps)
}

/// A name, and the value that it is to have: `I1 = 1`.
type Pair<'k> = (&'k Spanned<String>, &'k Spanned<toml::Value>);

/// What is set: `I1 = 1`, `A0 = 512`, `M2 = 1`, `D3 = -5`.
fn setting(pair: Pair<'_>, board: Board) -> Result<Setting, Slip> {
    let name = pair.0.get_ref();
    let input = (1..=board.inputs).find(|number| *name == format!("I{number}"));
    if let Some(point) = input.and_then(|number| Point::new(number, board.inputs)) {
        return Ok(Setting::Input(point, number(pair, 0..=1)? == 1));
    }
    if let Some(input) = (0..board.analogue).find(|number| *name == format!("A{number}")) {
        return Ok(Setting::Analogue(input, number(pair, 0..=1023)? as u16));
    }
    match Place::of_name(name, board).and_then(Place::cell) {
        Some(cell @ Cell::Marker(_)) => Ok(Setting::Cell(cell, number(pair, 0..=1)?)),
        Some(cell) => Ok(Setting::Cell(cell, number(pair, i32::MIN..=i32::MAX)?)),
        None => {
            let name = name.clone();
            Err(slip(
                Some(pair.0.span()),
                Wrong::NotSet {
                    name,
                    board: board.into(),
                },
            ))
        }
    }
}

/// What is expected: `Q1 = 1`, `M2 = 0`, `D3 = -5`, `P4 = 128`, each also `"any"`.
fn expectation(pair: Pair<'_>, board: Board) -> Result<(Place, Option<i32>), Slip> {
    let name = pair.0.get_ref();
    let Some(place) = Place::of_name(name, board) else {
        let name = name.clone();
        return Err(slip(
            Some(pair.0.span()),
            Wrong::NotExpected {
                name,
                board: board.into(),
            },
        ));
    };
    if pair.1.get_ref().as_str() == Some("any") {
        return Ok((place, None));
    }
    let range = match place.point() {
        _ if place.is_bit() => 0..=1,
        Address::Pwm(_) => 0..=255,
        _ => i32::MIN..=i32::MAX,
    };
    let number = number(pair, range).map_err(|mut slip| {
        if let Wrong::Value { or_any, .. } = &mut slip.wrong {
            *or_any = true;
        }
        slip
    })?;
    Ok((place, Some(number)))
}

/// A number of this range.
fn number((name, value): Pair<'_>, range: RangeInclusive<i32>) -> Result<i32, Slip> {
    let number = value.get_ref().as_integer();
    let number = number.and_then(|number| i32::try_from(number).ok());
    number
        .filter(|number| range.contains(number))
        .ok_or_else(|| {
            let (from, to) = range.into_inner();
            let wrong = Wrong::Value {
                name: name.get_ref().clone(),
                from,
                to,
                or_any: false,
            };
            slip(Some(value.span()), wrong)
        })
}
