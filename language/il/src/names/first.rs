//! First values: each is given to what can take it, or told; none is dropped.

use super::meaning::{Names, Place};
use super::widths::narrow_type;
use crate::ast::{Init, Var};
use crate::tree::{Bit, Num};
use unoclp_point::Address;
use unoclp_text::diagnostics::{Code, Found, Span};
use unoclp_text::literal;

/// Why a place cannot begin with a value.
type Why = (&'static str, &'static str);

const CONSTANT: Why = ("it must be a constant", "deve ser uma constante");
const READ_ONLY: Why = ("it can only be read", "ela só pode ser lida");
const NO_VALUE: Why = ("it is a block", "é um bloco");
const PRESET: Why = (
    "a preset goes from 0 to 2147483647",
    "uma pré-seleção vai de 0 a 2147483647",
);

impl Names<'_> {
    /// What a variable begins with.
    pub(super) fn first_value(
        &mut self,
        place: Place,
        var: &Var,
        inits: &[Init],
        found: &mut Found,
    ) {
        if let Place::Instance(instance) = place {
            return self.first_inputs(instance, var, found);
        }
        for init in inits {
            let span = init.value.span;
            let why = match init.value.number() {
                _ if place == Place::Unknown => return,
                None if init.value.is_wrong() => return,
                None if init.value.name().is_some_and(literal::is_fraction) => {
                    let value = self.written(span);
                    found.tell(Code::Fraction, span, [value.into()]);
                    return;
                }
                None => Err(CONSTANT),
                Some(value) => {
                    let value = self.begun(place, var, value, span, found);
                    self.begin(place, var, init, value)
                }
            };
            if let Err(why) = why {
                let name = self.written(var.name.span);
                let value = self.written(init.value.span);
                let words = [name.into(), value.into(), why.into()];
                found.tell(Code::BadInitial, init.value.span, words);
            }
        }
    }

    /// What a number begins with, in the bits of its type.
    fn begun(&self, place: Place, var: &Var, value: i32, span: Span, found: &mut Found) -> i32 {
        let name = self.written(var.name.span);
        match (place, narrow_type(&var.ty.text)) {
            (Place::Number(Num::At(Address::Register(_))), Some(base)) => {
                self.cut((base, &name), value, span, found)
            }
            _ => value,
        }
    }

    fn begin(&mut self, place: Place, var: &Var, init: &Init, value: i32) -> Result<(), Why> {
        let preset = |name: &str| match &init.name {
            Some(word) if word.text != name => Err((
                "only its preset can be declared",
                "só a sua pré-seleção pode ser declarada",
            )),
            _ if value < 0 => Err(PRESET),
            _ => Ok(Some(value)),
        };
        let within = |least, most, why| match (least..=most).contains(&value) {
            true => Ok(()),
            false => Err(why),
        };
        match place {
            Place::Timer(timer) => {
                self.timers[timer].preset = preset("PT")?;
                return Ok(());
            }
            Place::Counter(counter) => {
                self.counters[counter].preset = preset("PV")?;
                return Ok(());
            }
            Place::Bit(Bit::At(Address::Output(_) | Address::Marker(_))) => {
                within(0, 1, ("a BOOL is TRUE or FALSE", "um BOOL é TRUE ou FALSE"))?;
            }
            Place::Number(Num::At(Address::Register(_) | Address::Count(_))) => {}
            Place::Number(Num::At(Address::Group(_))) => {
                within(
                    0,
                    255,
                    (
                        "a value of eight bits goes from 0 to 255",
                        "um valor de oito bits vai de 0 a 255",
                    ),
                )?;
            }
            Place::Number(Num::At(Address::Pwm(_))) => {
                within(0, 255, ("PWM goes from 0 to 255", "o PWM vai de 0 a 255"))?;
            }
            Place::Number(Num::At(Address::Outputs(_))) => {
                within(
                    0,
                    15,
                    (
                        "a group of four outputs goes from 0 to 15",
                        "um grupo de quatro saídas vai de 0 a 15",
                    ),
                )?;
            }
            Place::Trigger(..) | Place::Latch(..) | Place::Instance(_) => return Err(NO_VALUE),
            _ => return Err(READ_ONLY),
        }
        // All begins with 0 by itself, but for retentive markers: another program may have left them 1.
        let left = matches!(
            place,
            Place::Bit(Bit::At(Address::Marker(_))) | Place::Number(Num::At(Address::Group(_)))
        );
        if value != 0 || var.retain && left {
            self.initials += 1;
        }
        Ok(())
    }

    /// `(on := TRUE)`: each name is a variable of the block; its own declaration gives it the value.
    fn first_inputs(&mut self, instance: usize, var: &Var, found: &mut Found) {
        let unit = self.instances[instance].unit;
        for init in &var.init {
            let name = init.name.as_ref().map(|name| (unit, name.text.clone()));
            let known = name.is_some_and(|input| self.inputs_of.contains(&input));
            if !known {
                let name = self.written(init.name.as_ref().map_or(var.name.span, |n| n.span));
                let value = self.written(init.value.span);
                let why = (
                    "the block has no such input",
                    "o bloco não tem essa entrada",
                );
                let words = [name.into(), value.into(), why.into()];
                found.tell(Code::BadInitial, init.value.span, words);
            }
        }
    }
}
