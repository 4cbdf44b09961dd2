//! Numbers: expressions in the board's value, without temporaries.
//!
//! Owns which instructions an operation takes. Must not know statements; acc stays as it is.

use super::coder::Coder;
use super::fails::may_fail;
use super::operand::bits;
use super::seats::Seat;
use unoclp_core::isa::{Opcode, Operand, Value as Taken};
use unoclp_point::Address;
use unoclp_tree::{Base, Binary, Convert, Expr, ExprKind, Place, Unary, Width};

/// The system reading that is the time stamp of the scan.
const TIME_STAMP: u8 = 2;

impl Coder<'_, '_> {
    /// Brings the first into value, and the second to where an operation can take it from.
    pub(super) fn pair(&mut self, a: &Expr, b: &Expr) -> Taken {
        if let Some(operand) = self.operand(b) {
            self.value(a);
            return operand;
        }
        self.value(a);
        self.pen.plain(Opcode::Push);
        self.value(b);
        Taken::Popped
    }

    fn operation(&mut self, opcode: Opcode, a: &Expr, b: &Expr) {
        let commutes = matches!(
            opcode,
            Opcode::Add
                | Opcode::Multiply
                | Opcode::AndWord
                | Opcode::OrWord
                | Opcode::XorWord
                | Opcode::RealAdd
                | Opcode::RealMultiply
        );
        let exchange = self.operand(b).is_none() && self.operand(a).is_some();
        let (a, b) = if commutes && exchange { (b, a) } else { (a, b) };
        let operand = self.pair(a, b);
        let cell = self.named_operand(operand, b);
        self.pen.operation(opcode, operand, cell);
    }

    fn number(&mut self, opcode: Opcode, number: i32) {
        self.pen.operation(opcode, Taken::Constant(number), None);
    }

    /// Brings a prepared expression into value.
    pub(super) fn value(&mut self, expr: &Expr) {
        self.placed(expr.at, |this| this.value_here(expr));
    }

    fn value_here(&mut self, expr: &Expr) {
        match &expr.kind {
            ExprKind::Constant(value) => {
                self.number(Opcode::Load, bits(value, expr.base));
            }
            ExprKind::Read(place) => self.load(place),
            ExprKind::Convert(how, a) => self.convert(*how, a, expr),
            ExprKind::Unary(op, a) => {
                self.value(a);
                match (op, a.base.is_real()) {
                    (Unary::Negate, false) => self.pen.changes_value(Opcode::Negate),
                    (Unary::Negate, true) => self.pen.changes_value(Opcode::RealNegate),
                    (Unary::Not, _) => self.number(Opcode::XorWord, -1),
                    (Unary::Abs, _) => self.pen.changes_value(Opcode::RealAbsolute),
                    (Unary::Sqrt, true) => self.pen.changes_value(Opcode::RealRoot),
                    (Unary::Sqrt, false) => self.pen.changes_value(Opcode::SquareRoot),
                    (Unary::Order, _) => self.pen.changes_value(Opcode::RealComparable),
                    (Unary::Low(bits, signed), _) => {
                        let opcode = match signed {
                            true => Opcode::ExtendSign,
                            false => Opcode::ExtendZero,
                        };
                        self.pen.numbered(opcode, *bits, None);
                        self.pen.holds = None;
                    }
                }
            }
            ExprKind::Binary(op, a, b) => self.binary(*op, a, b, expr),
            // Nothing else is left of a prepared expression.
            _ => self.number(Opcode::Load, 0),
        }
    }

    fn load(&mut self, place: &Place) {
        let cell = Some(place.offset);
        let seat = self.seats.of.get(&place.offset).copied();
        if let Some(index) = place.indices.first() {
            self.value(&index.subscript);
            let (Some(Seat::At(Address::Register(first))), Ok(length)) =
                (seat, u8::try_from(index.count))
            else {
                return;
            };
            let table = Operand::Table { first, length };
            self.pen.with(Opcode::LoadTable, table, cell);
            self.pen.holds = None;
            return;
        }
        match seat {
            Some(Seat::At(Address::Register(register))) => {
                if self.pen.holds != seat {
                    self.pen
                        .operation(Opcode::Load, Taken::Register(register), cell);
                    self.pen.holds = seat;
                }
            }
            Some(Seat::At(Address::Analogue(n))) => {
                if self.pen.holds != seat {
                    self.pen.numbered(Opcode::LoadAnalogue, n, cell);
                    self.pen.holds = seat;
                }
            }
            Some(Seat::At(Address::Count(n))) => {
                self.pen.numbered(Opcode::LoadCount, n, cell);
                self.pen.holds = None;
            }
            Some(Seat::At(Address::Group(n))) => {
                self.pen.numbered(Opcode::LoadMarkers, n, cell);
                self.pen.holds = None;
            }
            Some(Seat::At(Address::Inputs(_))) => self.pen.changes_value(Opcode::LoadInputs),
            Some(Seat::At(Address::Outputs(_))) => self.pen.changes_value(Opcode::LoadOutputs),
            Some(Seat::Elapsed(timer)) => {
                self.pen.of_timer(Opcode::LoadTimer, timer, cell);
                self.pen.holds = None;
            }
            Some(Seat::Now) => {
                self.pen.numbered(Opcode::LoadSystem, TIME_STAMP, cell);
                self.pen.holds = None;
            }
            _ => self.number(Opcode::Load, 0),
        }
    }

    /// Keeps the bits of a type.
    pub(super) fn narrow(&mut self, base: Base) {
        let bits = base.bits() as u8;
        if bits >= 32 {
            return;
        }
        let opcode = match base.is_signed() {
            true => Opcode::ExtendSign,
            false => Opcode::ExtendZero,
        };
        self.pen.numbered(opcode, bits, None);
        self.pen.holds = None;
    }

    fn convert(&mut self, how: Convert, a: &Expr, expr: &Expr) {
        self.value(a);
        match how {
            Convert::Wrap if !self.is_within(a, expr.base) => self.narrow(expr.base),
            Convert::Float => self.pen.changes_value(match a.base.width() {
                Width::Unsigned => Opcode::RealFromUnsigned,
                _ => Opcode::RealFromSigned,
            }),
            Convert::Round => self.pen.changes_value(Opcode::RealRound),
            Convert::Cut => self.pen.changes_value(Opcode::RealCut),
            // What is not finite becomes 0 by this, and all else stays.
            Convert::Bits if expr.base.is_real() => self.number(Opcode::RealSubtract, 0),
            Convert::Day => self.number(Opcode::UnsignedDivide, 86_400),
            Convert::Clock => {
                self.number(Opcode::UnsignedModulo, 86_400);
                self.number(Opcode::Multiply, 1_000);
            }
            Convert::Midnight => self.number(Opcode::Multiply, 86_400),
            _ => {}
        }
    }

    fn binary(&mut self, op: Binary, a: &Expr, b: &Expr, expr: &Expr) {
        let real = a.base.is_real();
        let unsigned = self.is_unsigned(a);
        let pick = |whole, of_reals| if real { of_reals } else { whole };
        let sign = |signed, without| if unsigned { without } else { signed };
        let opcode = match op {
            Binary::Add => pick(Opcode::Add, Opcode::RealAdd),
            Binary::Subtract => pick(Opcode::Subtract, Opcode::RealSubtract),
            Binary::Multiply => pick(Opcode::Multiply, Opcode::RealMultiply),
            Binary::Divide => pick(
                sign(Opcode::Divide, Opcode::UnsignedDivide),
                Opcode::RealDivide,
            ),
            Binary::Modulo => sign(Opcode::Modulo, Opcode::UnsignedModulo),
            Binary::And => Opcode::AndWord,
            Binary::Or => Opcode::OrWord,
            Binary::Xor => Opcode::XorWord,
            Binary::ShiftLeft | Binary::ShiftRight | Binary::RotateLeft | Binary::RotateRight => {
                self.shift(op, a, b, expr.base);
                return;
            }
            // What is prepared has none of the others.
            _ => return self.number(Opcode::Load, 0),
        };
        self.operation(opcode, a, b);
    }

    /// By a constant.
    fn shift(&mut self, op: Binary, a: &Expr, b: &Expr, base: Base) {
        let ExprKind::Constant(by) = &b.kind else {
            return;
        };
        let bits = i128::from(base.bits());
        let by = by.int();
        let turns = matches!(op, Binary::RotateLeft | Binary::RotateRight);
        if !turns && !(0..bits).contains(&by) {
            if may_fail(a) {
                self.value(a);
            }
            self.number(Opcode::Load, 0);
            return;
        }
        self.value(a);
        let shifted = |this: &mut Self, opcode, by: i128| {
            if by > 0 {
                this.pen.numbered(opcode, by as u8, None);
                this.pen.holds = None;
            }
        };
        match op {
            Binary::ShiftLeft => {
                shifted(self, Opcode::ShiftLeft, by);
                self.narrow(base);
            }
            Binary::ShiftRight => {
                if !self.is_within(a, base) {
                    self.narrow(base);
                }
                shifted(self, Opcode::ShiftRight, by);
            }
            _ => {
                let by = by.rem_euclid(bits);
                let left = if op == Binary::RotateLeft {
                    by
                } else {
                    bits - by
                };
                if by == 0 {
                    return;
                }
                shifted(self, Opcode::ShiftLeft, left);
                self.pen.plain(Opcode::Push);
                self.value(a);
                shifted(self, Opcode::ShiftRight, bits - left);
                self.pen.operation(Opcode::OrWord, Taken::Popped, None);
                self.narrow(base);
            }
        }
    }
}
