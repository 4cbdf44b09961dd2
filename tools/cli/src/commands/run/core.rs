//! Instruction List and numeric code, run as the board runs them.

use super::super::open::{checked, running};
use super::ran::{Ran, Row};
use super::what::{What, Work, find};
use crate::messages;
use anstream::eprintln;
use anyhow::anyhow;
use std::collections::{BTreeMap, BTreeSet};
use unoclp_core::{Image, Inputs, Millis};
use unoclp_host_sim::engine::Machine;
use unoclp_lang as lang;
use unoclp_lang::typed::{Base, Value};
use unoclp_point::Address;
use unoclp_program::{Written, used};

/// Runs a program; none where it has faults or a scan jumps back too often, which has been told.
pub(super) fn run(arguments: &What, written: Written) -> anyhow::Result<Option<Ran>> {
    let wording = &arguments.wording;
    let analysis = wording.workspace().open(written);
    let Some(source) = checked(&analysis, wording, arguments.shown())? else {
        return Ok(None);
    };
    // What runs leaves its text behind.
    let copy = source
        .checked
        .copy()
        .map_err(|fault| anyhow!(messages::fault(fault.cause)))?;
    let mut machine = Machine::new(copy);
    let points = points(&machine, &source.size.used, source.symbols());
    let mut inputs = Inputs::default();
    for (name, written) in arguments.settings()? {
        let names = points
            .iter()
            .flat_map(|point| [point.name.clone(), point.point.to_string()]);
        let names: Vec<String> = names.collect();
        let point = &points[find(&names, name)? / 2];
        let value = lang::given(written, point.base, &lang::typed::Enumeration::default());
        let bits = value.and_then(|value| bits(&value));
        let set = bits.and_then(|bits| point.set(bits, &mut machine, &mut inputs));
        set.ok_or_else(|| anyhow!(messages::no_value(written, name, point.type_name())))?;
    }
    let mut work = Work::default();
    for scan in 0..arguments.scans {
        let now = arguments.time(scan) as Millis;
        let mut steps = 0;
        if let Err(fault) = machine.scan_observed(inputs, now, |_, _| steps += 1) {
            eprintln!("{}", running(&source, fault));
            return Ok(None);
        }
        work.scanned(steps)?;
    }
    let last = arguments.scans.saturating_sub(1);
    let now = arguments.time(last) as Millis;
    let symbols = points.iter().map(|point| point.row(&machine, &inputs, now));
    Ok(Some(Ran {
        scans: arguments.scans,
        printed: Vec::new(),
        symbols: symbols.collect(),
    }))
}

/// A point that the program uses, by its name.
struct Used {
    name: String,
    point: Address,
    base: Base,
}

/// What the program uses, in the order of the addresses.
fn points(machine: &Machine, used: &used::Used, names: &BTreeMap<String, String>) -> Vec<Used> {
    let of = |numbers: &BTreeSet<u8>, point: fn(u8) -> Address| -> Vec<Address> {
        numbers.iter().map(|&number| point(number)).collect()
    };
    let timers = machine.plc().timers(0).count() as u8;
    let points = [
        of(&used.inputs, Address::Input),
        of(&used.outputs, Address::Output),
        of(&used.analogue, Address::Analogue),
        of(&used.pwm, Address::Pwm),
        of(&used.markers, Address::Marker),
        of(&used.registers, Address::Register),
        of(&used.counters, Address::Count),
        (1..=timers).map(Address::Elapsed).collect(),
    ];
    let used = |point| {
        let mut point = Used {
            name: String::new(),
            base: match point {
                Address::Input(_) | Address::Output(_) | Address::Marker(_) => Base::Bool,
                Address::Analogue(_) | Address::Pwm(_) => Base::Int,
                Address::Register(number) if used.reals.contains(&number) => Base::Real,
                Address::Elapsed(_) => Base::Time,
                _ => Base::Dint,
            },
            point,
        };
        let address = point.point.to_string();
        point.name = names.get(&address).cloned().unwrap_or(address);
        point
    };
    points.into_iter().flatten().map(used).collect()
}

impl Used {
    fn type_name(&self) -> &'static str {
        self.base.name()
    }

    fn row(&self, machine: &Machine, inputs: &Inputs, now: Millis) -> Row {
        let plc = machine.plc();
        let bit = |bits: u128, number: u8| (bits >> number.saturating_sub(1) & 1) as i32;
        let at = |number: u8| usize::from(number).saturating_sub(1);
        let bits = match self.point {
            Address::Input(n) => bit(inputs.points.0, n),
            Address::Output(n) => bit(plc.outputs().0, n),
            Address::Marker(n) => bit(plc.markers(), n),
            Address::Analogue(n) => inputs.analogue.get(usize::from(n)).map_or(0, |&v| v.into()),
            Address::Pwm(n) => plc.pwm(n).into(),
            Address::Register(n) => plc.registers().get(at(n)).copied().unwrap_or_default(),
            Address::Count(n) => plc.counters().nth(at(n)).map_or(0, |of| of.value),
            Address::Elapsed(n) => {
                let timer = plc.timers(now).nth(at(n));
                timer.map_or(0, |timer| timer.elapsed.cast_signed())
            }
            _ => 0,
        };
        Row {
            name: self.name.clone(),
            type_name: self.type_name().to_owned(),
            value: match self.base {
                Base::Real => Value::Real(f32::from_bits(bits.cast_unsigned()).into()),
                _ => Value::Int(bits.into()),
            },
            base: self.base,
            named: None,
            place: Some(format!("{:#}", self.point)),
        }
    }

    /// Sets it before the first scan; none of what cannot be set.
    fn set(&self, bits: i32, machine: &mut Machine, inputs: &mut Inputs) -> Option<()> {
        match self.point {
            Address::Input(n) => {
                let mask = 1 << n.checked_sub(1)?;
                let points = inputs.points.0 & !mask;
                inputs.points = Image(if bits != 0 { points | mask } else { points });
            }
            Address::Analogue(n) => {
                *inputs.analogue.get_mut(usize::from(n))? = bits.try_into().ok()?
            }
            Address::Marker(n) => machine.with_plc(|plc| plc.set_marker(n, bits != 0)),
            Address::Register(n) => machine.with_plc(|plc| plc.set_register(n, bits)),
            _ => return None,
        }
        Some(())
    }
}

/// The 32 bits of a value.
fn bits(value: &Value) -> Option<i32> {
    match value {
        Value::Int(number) => i32::try_from(*number).ok(),
        Value::Real(number) => Some((*number as f32).to_bits().cast_signed()),
        Value::Text(_) => None,
    }
}
