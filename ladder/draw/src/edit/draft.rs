//! An element that is yet to be inserted.

use super::document::{Element, Id};
use super::refusal::Refusal;
use super::step::Step;
use super::which::{self, Coil};
use unoclp_core::Target;
use unoclp_core::isa::{Class, Opcode};
use unoclp_point::Address;

/// An element that is yet to be inserted: what it does, and of a comparison what it looks at.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Draft {
    /// The load of what a comparison looks at.
    pub load: Option<Step>,
    /// What it does.
    pub step: Step,
}

impl From<Step> for Draft {
    fn from(step: Step) -> Draft {
        Draft { load: None, step }
    }
}

impl Draft {
    /// A contact of this point, or of one that is yet to be named; normally closed or open.
    ///
    /// # Errors
    /// [`Refusal::NotThatAddress`] where that has no contact.
    pub fn contact(point: Option<Address>, closed: bool) -> Result<Draft, Refusal> {
        let opcode = match closed {
            true => Opcode::InputContactNot,
            false => Opcode::InputContact,
        };
        Ok(which::with_address(&Step::new(opcode), point)?.into())
    }

    /// A coil of this point, or of one that is yet to be named.
    ///
    /// # Errors
    /// [`Refusal::NotThatAddress`] or [`Refusal::NoSuchCoil`] where that has no such coil.
    pub fn coil(point: Option<Address>, coil: Coil) -> Result<Draft, Refusal> {
        let step = which::with_address(&Step::new(Opcode::Coil), point)?;
        match coil {
            Coil::Normal => Ok(step.into()),
            coil => Ok(which::with_coil(&step, coil)?.into()),
        }
    }

    /// A timer of this kind ([`Opcode::OnDelay`] and the like), its preset in ms, and what it drives.
    ///
    /// # Errors
    /// [`Refusal::NotAnElement`] where that is no timer.
    pub fn timer(
        kind: Opcode,
        preset: Option<i32>,
        target: Option<Target>,
    ) -> Result<Draft, Refusal> {
        let lines = [preset, target.map(Target::code)];
        let is_timer = kind.class() == Class::Timer;
        let draft = is_timer.then(|| Step::new(kind).with_lines(lines).into());
        draft.ok_or(Refusal::NotAnElement)
    }

    /// A counter that counts up, or down.
    pub fn counter(down: bool, counter: Option<u8>, preset: Option<i32>) -> Draft {
        let opcode = if down {
            Opcode::CountDown
        } else {
            Opcode::CountUp
        };
        let step = Step::new(opcode).with_number(counter);
        step.with_lines([preset]).into()
    }

    /// A comparison ([`Opcode::Greater`] and the like) of what a load gives with a register or a constant, which
    /// `operand` has already.
    ///
    /// # Errors
    /// [`Refusal::NotAnElement`] where that is no load or no comparison.
    pub fn comparison(load: Option<Step>, operand: Step) -> Result<Draft, Refusal> {
        let draft = Draft {
            load,
            step: operand,
        };
        draft.checked()
    }

    /// It, if it is what an element can be.
    pub(crate) fn checked(self) -> Result<Draft, Refusal> {
        let may_load = matches!(self.step.class(), Class::Comparison | Class::ValueContact);
        let is_load = |load: &Step| load.class() == Class::Load && may_load;
        let is_wire = match self.step.class() {
            Class::Rung | Class::Label | Class::Part | Class::Close => true,
            Class::StorePoint | Class::RecallPoint => true,
            class => class.opens(),
        };
        let fine = !is_wire && self.load.as_ref().is_none_or(is_load);
        fine.then_some(self).ok_or(Refusal::NotAnElement)
    }

    /// It as an element.
    pub(crate) fn element(self, id: Id) -> Element {
        let Draft { load, step } = self;
        Element { id, load, step }
    }
}
