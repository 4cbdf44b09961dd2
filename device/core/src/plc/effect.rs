//! What each instruction does.

use super::scan::{Next, Pass};
use super::value::{
    divide, extend_sign, extend_zero, modulo, scale, square_root, unsigned_divide, unsigned_modulo,
};
use super::{Plc, smooth};
use crate::isa::{Opcode, Operand, Value};
use crate::timer::{Delay, Target, TimerBlock};
use crate::{Instruction, real};
use core::mem;

impl Plc<'_> {
    /// Runs one instruction: one arm for each, so that the compiler names one that is missing.
    pub(super) fn run(&mut self, pass: &mut Pass, instruction: Instruction<'_>) -> Next {
        let Instruction { opcode, operand } = instruction;
        let xx = instruction.number().unwrap_or_default();
        let number = match operand {
            // The value is the operand, and what was pushed the value.
            Operand::Value(Value::Popped) => {
                let pushed = pass.pop();
                mem::replace(&mut pass.value, pushed)
            }
            _ => self.operand(operand),
        };
        let (acc, now, value) = (pass.acc, pass.now, pass.value);
        match opcode {
            Opcode::NewRung => pass.acc = true,
            Opcode::OpenBranch | Opcode::OpenAnd | Opcode::OpenXor => pass.open(opcode),
            Opcode::CloseBranch => pass.close(),
            Opcode::StoreBranch => {
                pass.points &= !mask(xx);
                pass.points |= if acc { mask(xx) } else { 0 };
            }
            Opcode::RecallBranch => pass.acc = pass.points & mask(xx) != 0,
            Opcode::Not => pass.acc = !acc,
            Opcode::RisingEdge => pass.acc = acc & !self.acc_before(pass),
            Opcode::FallingEdge => pass.acc = !acc & self.acc_before(pass),

            Opcode::InputContact => pass.acc &= self.input(xx),
            Opcode::InputContactNot => pass.acc &= !self.input(xx),
            Opcode::OutputContact => pass.acc &= self.output(xx),
            Opcode::OutputContactNot => pass.acc &= !self.output(xx),
            Opcode::MarkerContact => pass.acc &= self.marker(xx),
            Opcode::MarkerContactNot => pass.acc &= !self.marker(xx),
            Opcode::SystemContact => pass.acc &= self.system(pass, xx),
            Opcode::SystemContactNot => pass.acc &= !self.system(pass, xx),
            Opcode::TimerContact => pass.acc &= self.with_timer(xx, |timer| timer.q()),
            Opcode::TimerContactNot => pass.acc &= !self.with_timer(xx, |timer| timer.q()),
            Opcode::CounterContact => pass.acc &= self.with_counter(xx, |c| c.is_reached()),
            Opcode::CounterContactNot => pass.acc &= !self.with_counter(xx, |c| c.is_reached()),
            Opcode::ZeroContact => pass.acc &= self.with_counter(xx, |c| c.is_zero()),
            Opcode::ZeroContactNot => pass.acc &= !self.with_counter(xx, |c| c.is_zero()),
            Opcode::XorInput => pass.acc ^= self.input(xx),
            Opcode::XorInputNot => pass.acc ^= !self.input(xx),
            Opcode::XorOutput => pass.acc ^= self.output(xx),
            Opcode::XorOutputNot => pass.acc ^= !self.output(xx),
            Opcode::XorMarker => pass.acc ^= self.marker(xx),
            Opcode::XorMarkerNot => pass.acc ^= !self.marker(xx),

            Opcode::Coil => self.set_output(xx, acc),
            Opcode::NegatedCoil => self.set_output(xx, !acc),
            Opcode::MarkerCoil => self.set_marker(xx, acc),
            Opcode::NegatedMarkerCoil => self.set_marker(xx, !acc),
            Opcode::SetCoil | Opcode::ResetCoil if !acc => {}
            Opcode::SetCoil => self.set_output(xx, true),
            Opcode::ResetCoil => self.set_output(xx, false),
            Opcode::SetMarker | Opcode::ResetMarker if !acc => {}
            Opcode::SetMarker => self.set_marker(xx, true),
            Opcode::ResetMarker => self.set_marker(xx, false),
            Opcode::ResetTimer | Opcode::ResetCounter | Opcode::LoadCounter if !acc => {}
            Opcode::ResetTimer => self.with_timer(xx, |timer| timer.reset()),
            Opcode::ResetCounter => self.with_counter(xx, |c| c.value = 0),
            Opcode::LoadCounter => self.with_counter(xx, |c| c.value = c.preset),

            Opcode::OnDelay => self.timer_block(pass, Delay::On, operand),
            Opcode::OffDelay => self.timer_block(pass, Delay::Off, operand),
            Opcode::Pulse => self.timer_block(pass, Delay::Pulse, operand),
            Opcode::RetentiveOnDelay => self.timer_block(pass, Delay::Retentive, operand),
            Opcode::CountUp => pass.acc = self.with_counter(xx, |c| c.up(acc)),
            Opcode::CountDown => pass.acc = self.with_counter(xx, |c| c.down(acc)),

            Opcode::Load => pass.value = number,
            Opcode::LoadAnalogue => {
                let reading = pass.analogue.get(usize::from(xx)).copied();
                pass.value = reading.unwrap_or_default().into();
            }
            Opcode::LoadTimer => pass.value = self.elapsed(xx, now).cast_signed(),
            Opcode::LoadCount => pass.value = self.with_counter(xx, |c| c.value),
            Opcode::LoadSystem if xx == 1 => pass.value = pass.scan_time.into(),
            Opcode::LoadSystem => pass.value = now.cast_signed(),
            Opcode::LoadMarkers => pass.value = i32::from((self.state.markers >> group(xx)) as u8),
            Opcode::LoadInputs => pass.value = (self.state.inputs.image().0 as u8).into(),
            Opcode::LoadOutputs => pass.value = (self.state.outputs.0 as u8).into(),
            Opcode::LoadBit => pass.value = acc.into(),

            Opcode::Store | Opcode::StoreCount | Opcode::StorePwm if !acc => {}
            Opcode::Store => self.set_register(xx, value),
            Opcode::StoreCount => self.with_counter(xx, |c| c.value = value),
            Opcode::StorePwm => {
                if let Some(pwm) = self.state.pwm.get_mut(usize::from(xx).wrapping_sub(1)) {
                    *pwm = value.clamp(0, 255) as u8;
                }
            }
            Opcode::StoreMarkers | Opcode::StoreOutputs if !acc => {}
            Opcode::StoreMarkers => {
                let (mask, first) = (0xFF << group(xx), group(xx));
                let markers = self.state.markers & !mask | u128::from(value as u8) << first;
                self.state.markers = markers & !(!0 << self.board.markers);
            }
            Opcode::StoreOutputs => self.set_outputs(value as u8, 8),
            Opcode::PresetCounter | Opcode::PresetTimer if !acc => {}
            Opcode::PresetCounter => self.with_counter(xx, |c| c.preset = value.max(0)),
            Opcode::PresetTimer => {
                let preset = value.max(0).cast_unsigned();
                self.with_timer(xx, |timer| timer.set_preset(preset));
            }

            Opcode::Negate => pass.value = value.wrapping_neg(),
            Opcode::SquareRoot => pass.take(square_root(value)),
            Opcode::Add => pass.value = value.wrapping_add(number),
            Opcode::Subtract => pass.value = value.wrapping_sub(number),
            Opcode::Multiply => pass.value = value.wrapping_mul(number),
            Opcode::Divide => pass.take(divide(value, number)),
            Opcode::Modulo => pass.take(modulo(value, number)),
            Opcode::AndWord => pass.value = value & number,
            Opcode::OrWord => pass.value = value | number,
            Opcode::XorWord => pass.value = value ^ number,
            Opcode::ShiftLeft => pass.value = value << (xx & 31),
            Opcode::ShiftRight => pass.value = (value.cast_unsigned() >> (xx & 31)).cast_signed(),
            Opcode::Greater => pass.acc &= value > number,
            Opcode::GreaterOrEqual => pass.acc &= value >= number,
            Opcode::Equal => pass.acc &= value == number,
            Opcode::NotEqual => pass.acc &= value != number,
            Opcode::LessOrEqual => pass.acc &= value <= number,
            Opcode::Less => pass.acc &= value < number,
            Opcode::BitContact => pass.acc &= value >> (xx & 31) & 1 != 0,
            Opcode::BitContactNot => pass.acc &= value >> (xx & 31) & 1 == 0,

            Opcode::Move | Opcode::Drum if !acc => {}
            Opcode::Move => self.move_registers(operand),
            Opcode::Drum => self.drum(operand),
            Opcode::Scale => {
                if let Operand::Scale { from, to } = operand {
                    pass.value = scale(value, from, to);
                }
            }
            Opcode::Filter => self.filter(pass, operand),
            Opcode::Integrate => self.integrate(pass, xx),

            Opcode::Jump | Opcode::JumpNot if acc == opcode.is_inverted() => {}
            Opcode::Jump | Opcode::JumpNot => return jump(operand),
            Opcode::Return | Opcode::ReturnNot if acc == opcode.is_inverted() => {}
            Opcode::Return | Opcode::ReturnNot => return Next::End,
            Opcode::Push => pass.push(),
            Opcode::RealAdd => pass.take(real::add(value, number)),
            Opcode::RealSubtract => pass.take(real::subtract(value, number)),
            Opcode::RealMultiply => pass.take(real::multiply(value, number)),
            Opcode::RealDivide => pass.take(real::divide(value, number)),
            Opcode::RealFromSigned => pass.take(real::from_signed(value)),
            Opcode::RealFromUnsigned => pass.take(real::from_unsigned(value)),
            Opcode::RealRound => pass.take(real::round(value)),
            Opcode::RealCut => pass.take(real::cut(value)),
            Opcode::RealNegate => pass.take(real::negate(value)),
            Opcode::RealAbsolute => pass.take(real::absolute(value)),
            Opcode::RealRoot => pass.take(real::square_root(value)),
            Opcode::RealComparable => pass.value = real::comparable(value),
            Opcode::LoadTable => {
                let found = self.place(operand, value).map(|place| self.register(place));
                pass.take((found.unwrap_or(0), found.is_none()));
            }
            Opcode::StoreTable => {
                let place = self.place(operand, pass.pop());
                match place {
                    Some(_) if !acc => {}
                    Some(place) => self.set_register(place, value),
                    None => pass.error |= acc,
                }
            }
            Opcode::ExtendSign => pass.value = extend_sign(value, xx),
            Opcode::ExtendZero => pass.value = extend_zero(value, xx),
            Opcode::UnsignedDivide => pass.take(unsigned_divide(value, number)),
            Opcode::UnsignedModulo => pass.take(unsigned_modulo(value, number)),
            Opcode::UnsignedGreaterOrEqual => {
                pass.acc &= value.cast_unsigned() >= number.cast_unsigned();
            }
            Opcode::UnsignedLess => pass.acc &= value.cast_unsigned() < number.cast_unsigned(),

            Opcode::If if acc => pass.acc = true,
            Opcode::If => return Next::Behind(Opcode::Else),
            // The part before it has been run.
            Opcode::Else => return Next::Behind(Opcode::EndIf),
            Opcode::EndIf => pass.acc = true,
            // A place to jump to; and what is set before the first scan.
            Opcode::Label | Opcode::InputFilter => {}
            Opcode::KeepRegister | Opcode::KeepCounter => {}
        }
        Next::Step
    }

    /// The register at this index of a table; none outside of it.
    fn place(&self, operand: Operand<'_>, index: i32) -> Option<u8> {
        let Operand::Table { first, length } = operand else {
            return None;
        };
        let index = u8::try_from(index).ok()?;
        (index < length).then_some(first.wrapping_add(index))
    }

    /// What an operation, a load or a comparison works with; 0 for what has no such operand.
    fn operand(&self, operand: Operand<'_>) -> i32 {
        match operand {
            Operand::Value(Value::Constant(number)) => number,
            Operand::Value(Value::Register(register)) => self.register(register),
            _ => 0,
        }
    }

    /// acc as this edge had it in the scan before; the edge keeps acc as it is.
    fn acc_before(&mut self, pass: &Pass) -> bool {
        match self.own.get_mut(pass.own) {
            Some(before) => mem::replace(before, pass.acc.into()) != 0,
            None => false,
        }
    }

    fn timer_block(&mut self, pass: &mut Pass, delay: Delay, operand: Operand<'_>) {
        let Operand::Timer(TimerBlock { preset, target }) = operand else {
            return;
        };
        let (acc, now) = (pass.acc, pass.now);
        if let Target::Timer(number) = target {
            pass.acc = self.with_timer(number, |timer| {
                timer.set_preset(preset);
                timer.scan(delay, acc, now)
            });
            return;
        }
        pass.acc = self.with_timer(pass.timers + 1, |timer| timer.scan(delay, acc, now));
        match target {
            Target::Output(output) => self.set_output(output, pass.acc),
            Target::Marker(marker) => self.set_marker(marker, pass.acc),
            Target::Timer(_) => {}
        }
    }

    fn move_registers(&mut self, operand: Operand<'_>) {
        let Operand::Move { from, to, count } = operand else {
            return;
        };
        let from = usize::from(from).wrapping_sub(1);
        let to = usize::from(to).wrapping_sub(1);
        let count = usize::from(count);
        let registers = &mut self.state.registers;
        // The loader has checked that both blocks end within the registers.
        if from + count <= registers.len() && to + count <= registers.len() {
            registers.copy_within(from..from + count, to);
        }
    }

    fn drum(&mut self, operand: Operand<'_>) {
        let Operand::Drum { register, steps } = operand else {
            return;
        };
        let step = usize::try_from(self.register(register)).ok();
        let outputs = step.and_then(|step| steps.get(step)).copied();
        self.set_outputs(outputs.unwrap_or(0), 4);
    }

    fn filter(&mut self, pass: &mut Pass, operand: Operand<'_>) {
        let Operand::Filter { strength, time } = operand else {
            return;
        };
        if let Some(data) = own(self.own, pass) {
            pass.value = smooth::filter(data, pass.value, strength, time, pass.now);
        }
    }

    fn integrate(&mut self, pass: &Pass, register: u8) {
        let index = usize::from(register).wrapping_sub(1);
        let register = self.state.registers.get_mut(index);
        if let (Some(register), Some(data)) = (register, own(self.own, pass)) {
            smooth::integrate(data, register, pass.value, pass.acc, pass.now);
        }
    }
}

impl Pass {
    fn push(&mut self) {
        self.pushed.rotate_right(1);
        self.pushed[0] = self.value;
        self.depth = self.depth.saturating_add(1).min(8);
    }

    fn pop(&mut self) -> i32 {
        let value = self.pushed[0];
        self.pushed.rotate_left(1);
        self.depth = self.depth.saturating_sub(1);
        value
    }

    /// A branch or block opens.
    fn open(&mut self, opcode: Opcode) {
        self.open = self.open << 1 | u8::from(self.acc);
        self.opened.rotate_right(1);
        self.opened[0] = opcode;
        self.acc = true;
    }

    /// The innermost branch or block closes, as what has opened it says.
    fn close(&mut self) {
        let before = self.open & 1 != 0;
        self.open >>= 1;
        let opened = self.opened[0];
        self.opened.rotate_left(1);
        self.acc = if opened == Opcode::OpenAnd {
            before & self.acc
        } else if opened == Opcode::OpenXor {
            before ^ self.acc
        } else {
            before | self.acc
        };
    }

    /// Takes a result, and whether it was an arithmetic error.
    fn take(&mut self, (value, error): (i32, bool)) {
        self.value = value;
        self.error |= error;
    }
}

/// Where a jump leads.
fn jump(operand: Operand<'_>) -> Next {
    match operand {
        Operand::Jump { label, line } => Next::Label { label, line },
        _ => Next::Step,
    }
}

/// The data of the instruction that is run.
fn own<'p, const N: usize>(own: &'p mut [u8], pass: &Pass) -> Option<&'p mut [u8; N]> {
    own.get_mut(pass.own..)?.first_chunk_mut()
}

/// The bit of a branch point.
fn mask(number: u8) -> u8 {
    1 << (number.wrapping_sub(1) & 7)
}

/// The index of the first marker of a group.
fn group(number: u8) -> u8 {
    (number.wrapping_sub(1) & 15) * 8
}
