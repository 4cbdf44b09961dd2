//! The scan: one pass through the program.

use super::value::{compare, operate, scale, square_root};
use super::{Inputs, Plc, smooth};
use crate::isa::{JUMP_BUDGET, Operand, Value};
use crate::timer::{Delay, Target};
use crate::{Cause, Fault, Image, Instruction, Millis, Needs, Steps, isa::Opcode};

/// What lives as long as one scan.
struct Pass<'c> {
    steps: Steps<'c>,
    now: Millis,
    analogue: [u16; 5],
    scan_time: u16,
    /// The result of the rung so far (NC-6).
    acc: bool,
    /// The integer accumulator (NC-16).
    value: i32,
    /// One bit for each open branch, the innermost in bit 0: acc as it was when the branch opened. Eight
    /// are enough, because the loader allows no deeper nesting.
    open: u8,
    /// What closes each of them: its opening code's byte.
    closing: [u8; 8],
    /// One bit for each branch point of the rung.
    points: u8,
    /// Timers that have been passed, and bytes of own data.
    timers: u8,
    own: usize,
    /// What is left for jumps back (NC-19).
    budget: u16,
    /// S 04: an arithmetic error in this scan.
    error: bool,
}

impl Plc<'_> {
    /// One scan (NC-5): runs the program once on these inputs with this time stamp, and gives the
    /// output image.
    ///
    /// # Errors
    /// [`Cause::TooManyJumps`] with the line of the jump, the one thing that no check can know before
    /// (NC-19). All outputs are 0 then.
    pub fn scan(&mut self, inputs: impl Into<Inputs>, now: Millis) -> Result<Image, Fault> {
        self.scan_observed(inputs, now, |_, _| ())
    }

    /// A scan that tells an observer the index of each instruction that was run, in the order of
    /// [`Plc::steps`], and acc behind it.
    ///
    /// # Errors
    /// As [`Plc::scan`].
    pub fn scan_observed(
        &mut self,
        inputs: impl Into<Inputs>,
        now: Millis,
        mut observe: impl FnMut(usize, bool),
    ) -> Result<Image, Fault> {
        let inputs = inputs.into();
        let first = self.state.first;
        let Needs { filter, .. } = self.needs;
        let points = Image(inputs.points.0 & u16::from(self.needs.digital()));
        self.state.inputs.scan(points, filter, first, now);
        self.state.clocks.scan(first, now);
        let code = self.code;
        let mut pass = Pass {
            steps: Steps::new(code),
            now,
            analogue: inputs.analogue,
            scan_time: inputs.scan_time,
            acc: true,
            value: 0,
            open: 0,
            closing: [0; 8],
            points: 0,
            timers: 0,
            own: 0,
            budget: JUMP_BUDGET,
            error: false,
        };
        let mut index = 0;
        while let Some(instruction) = pass.steps.next() {
            let step = index;
            index += 1;
            match self.jump(&pass, instruction) {
                Jump::None => self.run(&mut pass, instruction),
                Jump::End => {
                    observe(step, pass.acc);
                    break;
                }
                Jump::To(label) => {
                    observe(step, pass.acc);
                    let from = pass.steps.at();
                    index = pass.go_to(code, label);
                    // What lies between is what has been passed over to come back here.
                    let line = match instruction.operand {
                        Operand::Jump { line, .. } => line,
                        _ => 0,
                    };
                    if let Some(back) = from.checked_sub(pass.steps.at()) {
                        match pass.budget.checked_sub(back as u16) {
                            Some(left) => pass.budget = left,
                            None => return Err(self.too_many_jumps(line)),
                        }
                    }
                    continue;
                }
            }
            if Delay::of(instruction.opcode).is_some() {
                pass.timers += 1;
            }
            pass.own += instruction.opcode.own_data();
            observe(step, pass.acc);
        }
        self.state.first = false;
        Ok(self.state.outputs)
    }

    fn too_many_jumps(&mut self, line: u16) -> Fault {
        self.state.outputs = Image(0);
        Fault {
            cause: Cause::TooManyJumps,
            line: Some(line.into()),
        }
    }

    fn jump(&self, pass: &Pass<'_>, instruction: Instruction<'_>) -> Jump {
        let label = instruction.number().unwrap_or_default();
        match instruction.opcode {
            Opcode::Jump if pass.acc => Jump::To(label),
            Opcode::JumpNot if !pass.acc => Jump::To(label),
            Opcode::Return if pass.acc => Jump::End,
            Opcode::ReturnNot if !pass.acc => Jump::End,
            _ => Jump::None,
        }
    }

    /// One instruction that does not jump.
    fn run(&mut self, pass: &mut Pass<'_>, instruction: Instruction<'_>) {
        let xx = instruction.number().unwrap_or_default();
        match instruction.operand {
            Operand::None => self.run_plain(pass, instruction.opcode),
            Operand::Number(_) => self.run_numbered(pass, instruction.opcode, xx),
            Operand::Timer(block) => {
                let (acc, now) = (pass.acc, pass.now);
                if let Some(delay) = Delay::of(instruction.opcode) {
                    pass.acc =
                        self.with_timer(pass.timers + 1, |timer| timer.scan(delay, acc, now));
                }
                match block.target {
                    Target::Output(output) => self.set_output(output, pass.acc),
                    Target::Marker(marker) => self.set_marker(marker, pass.acc),
                }
            }
            Operand::Value(operand) => {
                let operand = match operand {
                    Value::Constant(number) => number,
                    Value::Register(register) => self.register(register),
                };
                if let Some(holds) = compare(instruction.opcode, pass.value, operand) {
                    pass.acc &= holds;
                } else {
                    let (value, error) = operate(instruction.opcode, pass.value, operand);
                    pass.value = value;
                    pass.error |= error;
                }
            }
            Operand::Count { counter, .. } => {
                let acc = pass.acc;
                let up = instruction.opcode == Opcode::CountUp;
                pass.acc = self.with_counter(counter, |counter| match up {
                    true => counter.up(acc),
                    false => counter.down(acc),
                });
            }
            Operand::Move { from, to, count } if pass.acc => {
                let from = usize::from(from).wrapping_sub(1);
                let to = usize::from(to).wrapping_sub(1);
                let registers = &mut self.state.registers;
                // The loader has checked that both blocks end within the registers.
                if from + usize::from(count) <= registers.len()
                    && to + usize::from(count) <= registers.len()
                {
                    registers.copy_within(from..from + usize::from(count), to);
                }
            }
            Operand::Drum { register, steps } if pass.acc => {
                let step = usize::try_from(self.register(register)).ok();
                let outputs = step.and_then(|step| steps.get(step)).copied();
                self.set_outputs(outputs.unwrap_or(0));
            }
            Operand::Scale { from, to } => pass.value = scale(pass.value, from, to),
            Operand::Filter { strength, time } => {
                if let Some(data) = self
                    .own
                    .get_mut(pass.own..)
                    .and_then(|own| own.first_chunk_mut())
                {
                    pass.value = smooth::filter(data, pass.value, strength, time, pass.now);
                }
            }
            Operand::Move { .. } | Operand::Drum { .. } | Operand::Jump { .. } => {}
        }
    }

    fn run_plain(&mut self, pass: &mut Pass<'_>, opcode: Opcode) {
        match opcode {
            Opcode::NewRung => pass.acc = true,
            Opcode::OpenBranch | Opcode::OpenAnd | Opcode::OpenXor => {
                pass.open = pass.open << 1 | u8::from(pass.acc);
                pass.closing.rotate_right(1);
                pass.closing[0] = opcode as u8;
                pass.acc = true;
            }
            Opcode::CloseBranch => {
                let popped = pass.open & 1 != 0;
                pass.open >>= 1;
                let closing = pass.closing[0];
                pass.closing.rotate_left(1);
                pass.acc = match Opcode::of_stored(closing) {
                    Some(Opcode::OpenAnd) => popped & pass.acc,
                    Some(Opcode::OpenXor) => popped ^ pass.acc,
                    _ => popped | pass.acc,
                };
            }
            Opcode::Not => pass.acc = !pass.acc,
            Opcode::RisingEdge | Opcode::FallingEdge => {
                if let Some(before) = self.own.get_mut(pass.own) {
                    let was = *before != 0;
                    *before = pass.acc.into();
                    pass.acc = match opcode {
                        Opcode::RisingEdge => pass.acc && !was,
                        _ => was && !pass.acc,
                    };
                }
            }
            Opcode::Negate => pass.value = pass.value.wrapping_neg(),
            Opcode::SquareRoot => {
                let (root, error) = square_root(pass.value);
                pass.value = root;
                pass.error |= error;
            }
            Opcode::LoadInputs => pass.value = self.state.inputs.image().0.into(),
            Opcode::LoadOutputs => pass.value = self.state.outputs.0.into(),
            Opcode::LoadBit => pass.value = pass.acc.into(),
            Opcode::StoreOutputs if pass.acc => self.set_outputs(pass.value as u8),
            _ => {}
        }
    }

    fn run_numbered(&mut self, pass: &mut Pass<'_>, opcode: Opcode, xx: u8) {
        let (acc, now, value) = (pass.acc, pass.now, pass.value);
        match opcode {
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
            Opcode::SetCoil if acc => self.set_output(xx, true),
            Opcode::ResetCoil if acc => self.set_output(xx, false),
            Opcode::MarkerCoil => self.set_marker(xx, acc),
            Opcode::NegatedMarkerCoil => self.set_marker(xx, !acc),
            Opcode::SetMarker if acc => self.set_marker(xx, true),
            Opcode::ResetMarker if acc => self.set_marker(xx, false),
            Opcode::StoreBranch => {
                pass.points &= !mask(xx);
                pass.points |= if acc { mask(xx) } else { 0 };
            }
            Opcode::RecallBranch => pass.acc = pass.points & mask(xx) != 0,
            Opcode::ResetTimer if acc => self.with_timer(xx, |timer| timer.reset()),
            Opcode::ResetCounter if acc => self.with_counter(xx, |c| c.value = 0),
            Opcode::LoadCounter if acc => self.with_counter(xx, |c| c.value = c.preset),
            Opcode::LoadAnalogue => {
                let reading = pass.analogue.get(usize::from(xx)).copied();
                pass.value = reading.unwrap_or_default().into();
            }
            Opcode::LoadTimer => pass.value = self.elapsed(xx, now).cast_signed(),
            Opcode::LoadCount => pass.value = self.with_counter(xx, |c| c.value),
            Opcode::LoadSystem if xx == 1 => pass.value = pass.scan_time.into(),
            Opcode::LoadSystem => pass.value = now.cast_signed(),
            Opcode::LoadMarkers => pass.value = i32::from((self.state.markers >> group(xx)) as u8),
            Opcode::StoreMarkers if acc => {
                self.state.markers &= !(0xFF << group(xx));
                self.state.markers |= u64::from(value as u8) << group(xx);
            }
            Opcode::Store if acc => self.set_register(xx, value),
            Opcode::StoreCount if acc => self.with_counter(xx, |c| c.value = value),
            Opcode::StorePwm if acc => {
                if let Some(pwm) = self.state.pwm.get_mut(usize::from(xx).wrapping_sub(1)) {
                    *pwm = value.clamp(0, 255) as u8;
                }
            }
            Opcode::PresetCounter if acc => self.with_counter(xx, |c| c.preset = value.max(0)),
            Opcode::PresetTimer if acc => {
                let preset = value.max(0).cast_unsigned();
                self.with_timer(xx, |timer| timer.set_preset(preset));
            }
            Opcode::ShiftLeft => pass.value = value << (xx & 31),
            Opcode::ShiftRight => {
                pass.value = (value.cast_unsigned() >> (xx & 31)).cast_signed();
            }
            Opcode::BitContact => pass.acc &= value >> (xx & 31) & 1 != 0,
            Opcode::BitContactNot => pass.acc &= value >> (xx & 31) & 1 == 0,
            Opcode::Integrate => {
                let register = self
                    .state
                    .registers
                    .get_mut(usize::from(xx).wrapping_sub(1));
                let data = self
                    .own
                    .get_mut(pass.own..)
                    .and_then(|own| own.first_chunk_mut());
                if let (Some(register), Some(data)) = (register, data) {
                    smooth::integrate(data, register, value, acc, now);
                }
            }
            _ => {}
        }
    }

    fn input(&self, number: u8) -> bool {
        self.state.inputs.image().0 & wide(number) != 0
    }

    fn output(&self, number: u8) -> bool {
        self.state.outputs.0 & wide(number) != 0
    }

    fn set_output(&mut self, number: u8, state: bool) {
        self.state.outputs.0 &= !wide(number);
        self.state.outputs.0 |= if state { wide(number) } else { 0 };
    }

    /// All outputs at once, but for those that are PWM.
    fn set_outputs(&mut self, outputs: u8) {
        self.state.outputs = Image(u16::from(outputs & 0x0F & !self.needs.pwm));
    }

    fn marker(&self, number: u8) -> bool {
        self.state.markers >> (number.wrapping_sub(1) & 63) & 1 != 0
    }

    fn system(&self, pass: &Pass<'_>, number: u8) -> bool {
        match number {
            1 => self.state.first,
            2 => self.state.clocks.slow(),
            3 => self.state.clocks.fast(),
            _ => pass.error,
        }
    }

    fn register(&self, number: u8) -> i32 {
        let index = usize::from(number).wrapping_sub(1);
        self.state.registers.get(index).copied().unwrap_or_default()
    }

    fn elapsed(&mut self, number: u8, now: Millis) -> Millis {
        let index = usize::from(number).wrapping_sub(1);
        let timer = self.timers(now).nth(index);
        timer.map_or(0, |timer| timer.elapsed)
    }
}

/// Where a scan goes on behind an instruction.
enum Jump {
    /// With the next instruction.
    None,
    /// At a label, where a new rung begins.
    To(u8),
    /// It ends.
    End,
}

impl<'c> Pass<'c> {
    /// Goes on behind a label, where a new rung begins; gives the index of the instruction there. The
    /// loader has seen to it that the label exists; the program would end where it did not.
    fn go_to(&mut self, code: &'c [u8], label: u8) -> usize {
        self.steps = Steps::new(code);
        (self.timers, self.own, self.acc) = (0, 0, true);
        let mut index = 0;
        loop {
            let at = self.steps.clone();
            let Some(step) = self.steps.next() else {
                return index;
            };
            if step.opcode == Opcode::Label && step.number() == Some(label) {
                self.steps = at;
                return index;
            }
            index += 1;
            self.timers += u8::from(Delay::of(step.opcode).is_some());
            self.own += step.opcode.own_data();
        }
    }
}

/// The bit of a branch point.
fn mask(number: u8) -> u8 {
    1 << (number.wrapping_sub(1) & 7)
}

/// The bit of an input or output.
fn wide(number: u8) -> u16 {
    1 << (number.wrapping_sub(1) & 15)
}

/// The index of the first marker of a group.
fn group(number: u8) -> u8 {
    (number.wrapping_sub(1) & 7) * 8
}
