//! When an expression is written out: before anything changes what it was made from.

use super::{Acc, Lower, MOST_LINKS};
use crate::diagnostics::Span;
use crate::tree::{Bit, Expr, Num, Number};
use unoclp_core::Target;
use unoclp_point::Address;

impl Lower<'_, '_> {
    /// Brings an expression into the board's accumulator, where the text's stays on it.
    pub(super) fn bring(&mut self, expr: Expr, span: Span) {
        self.freeze(span);
        let constant = expr == Expr::Const(true);
        self.rungs.logic(expr, span);
        self.acc = Acc::Bit(if constant {
            Expr::Const(true)
        } else {
            Expr::Live
        });
        self.links = 0;
    }

    /// Before anything changes: what waits for a `)` or in a block is worked out with what holds now.
    pub(super) fn freeze(&mut self, span: Span) {
        let mut frames = std::mem::take(&mut self.frames);
        for frame in &mut frames {
            frame.acc = self.fixed(std::mem::replace(&mut frame.acc, Acc::Unknown), frame.span);
        }
        self.frames = frames;
        self.freeze_branches();
        self.freeze_block(span);
    }

    /// The same value, from where nothing changes it.
    pub(super) fn fixed(&mut self, acc: Acc, span: Span) -> Acc {
        match acc {
            Acc::Bit(expr) => Acc::Bit(self.fixed_bit(expr, span)),
            Acc::Number(Number::Leaf(Num::At(Address::Register(n)), at))
                if self.rungs.temps.is_busy_register(n) =>
            {
                Acc::Number(Number::Leaf(Num::At(Address::Register(n)), at))
            }
            Acc::Number(number) if number.constant().is_none() => {
                self.rungs.number(&number);
                let register = self.rungs.keep(span);
                Acc::Number(Number::Leaf(Num::At(Address::Register(register)), span))
            }
            other => other,
        }
    }

    pub(super) fn fixed_bit(&mut self, expr: Expr, span: Span) -> Expr {
        match expr {
            Expr::Const(_) => return expr,
            Expr::Lit {
                bit: Bit::At(Address::Marker(n)),
                ..
            } if self.rungs.temps.is_busy(n) => return expr,
            _ => {}
        }
        let marker = self.rungs.temps.marker();
        self.rungs.logic(expr, span);
        self.rungs.coil(Target::Marker(marker), false, span);
        Expr::Lit {
            bit: Bit::At(Address::Marker(marker)),
            negated: false,
            span,
        }
    }

    /// Long expressions are written out in parts.
    pub(super) fn link(&mut self, span: Span) {
        self.links += 1;
        if self.links < MOST_LINKS {
            return;
        }
        self.links = 0;
        match std::mem::replace(&mut self.acc, Acc::Unknown) {
            Acc::Bit(expr) => self.bring(expr, span),
            Acc::Number(number) => {
                self.freeze(span);
                self.rungs.number(&number);
                self.acc = Acc::Number(Number::Live);
            }
            other => self.acc = other,
        }
    }
}
