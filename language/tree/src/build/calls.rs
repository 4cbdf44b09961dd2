//! Calls of functions and of instances of blocks.

use super::arguments::{Argument, Params};
use super::builder::Builder;
use super::named::Named;
use super::places::Target;
use super::words::both;
use crate::standard::Standard;
use crate::{Base, Call, Expr, ExprKind, Kind, Output, Stmt, StmtKind, Store, TypeId, UnitKind};
use unoclp_text::diagnostics::{Code, Span};

impl Builder<'_, '_> {
    /// A call of a function of the text: its value.
    pub fn call(&mut self, unit: u32, arguments: Vec<Argument>, name_at: Span, at: Span) -> Expr {
        let Some((call, result)) = self.made_call(unit, arguments, name_at, at) else {
            return self.wrong(at);
        };
        let Some(base) = self.tree.types.base(result) else {
            let (written, what) = (self.written(name_at), self.what_type(result));
            let part = format!("x := {written}(…)");
            self.tell(Code::StSharedWhole, at, [written.into(), what, part.into()]);
            return self.wrong(at);
        };
        Expr {
            kind: ExprKind::Call(Box::new(call)),
            base,
            ty: result,
            at,
        }
    }

    /// A call of a function of the text as a statement.
    pub fn call_statement(
        &mut self,
        unit: u32,
        arguments: Vec<Argument>,
        name_at: Span,
        at: Span,
    ) -> Option<Stmt> {
        let (call, _) = self.made_call(unit, arguments, name_at, at)?;
        if call.lent.is_empty() && call.outputs.is_empty() {
            let name = self.written(name_at);
            self.tell(Code::StResultUnused, at, [name.into()]);
        }
        Some(Stmt {
            kind: StmtKind::Call(call),
            at,
        })
    }

    /// A call whose result, with parts, is stored: `x := F(…)`.
    pub fn call_into(
        &mut self,
        unit: u32,
        arguments: Vec<Argument>,
        target: Target,
        at: Span,
    ) -> Option<Stmt> {
        let name_at = at;
        let (mut call, result) = self.made_call(unit, arguments, name_at, at)?;
        if !self.tree.types.same(target.ty, result) {
            let wrong = Expr {
                kind: ExprKind::Read(Box::new(target.place)),
                base: Base::Bool,
                ty: result,
                at,
            };
            self.told_mismatch(&wrong, target.ty);
            return None;
        }
        let to = self.writable(target)?;
        call.outputs.push(Output {
            from: 0,
            cells: self.tree.types.get(result).cells,
            to: to.place,
            value: None,
        });
        Some(Stmt {
            kind: StmtKind::Call(call),
            at,
        })
    }

    fn made_call(
        &mut self,
        unit: u32,
        arguments: Vec<Argument>,
        name_at: Span,
        at: Span,
    ) -> Option<(Call, TypeId)> {
        let draft = self.draft(unit)?;
        let name = draft.unit.name.clone();
        let result = draft.result?;
        let params: Params = draft.params.iter().map(|p| (p.clone(), false)).collect();
        self.lenient = draft.incomplete;
        if let Some(here) = self.current {
            self.edges.push((here as u32, unit, name_at));
        }
        let mut call = Call {
            unit,
            instance: None,
            inputs: Vec::new(),
            lent: Vec::new(),
            outputs: Vec::new(),
            at,
        };
        self.pass(&name, params, arguments, None, &mut call, at)?;
        self.writes |= !call.lent.is_empty() || !call.outputs.is_empty();
        Some((call, result))
    }

    pub(super) fn told_other_type(&mut self, target: &Target, needed: TypeId) {
        let (written, is) = (self.written(target.at), self.tree.types.name(target.ty));
        let name = self.tree.types.name(needed);
        let help = both(
            format!("pass a variable of type {name}"),
            format!("passe uma variável do tipo {name}"),
        );
        let words = [written.into(), is.into(), name.into(), help];
        self.tell(Code::StMismatch, target.at, words);
    }

    /// What is called by this name.
    pub fn callee(&mut self, name: &str, at: Span) -> Option<u32> {
        match self.find(name).cloned() {
            Some(Named::Unit(unit)) => {
                let kind = self.draft(unit)?.unit.kind;
                if kind == UnitKind::Function {
                    return Some(unit);
                }
                None
            }
            Some(Named::Type(ty))
                if matches!(self.tree.types.kind(ty), Kind::Standard(_) | Kind::Block(_)) =>
            {
                let instance = format!("{name}1");
                self.tell(Code::StTypeCalled, at, [name.into(), instance.into()]);
                self.told_name(name);
                None
            }
            Some(named) => {
                let what = self.what(&named);
                let help = (
                    "only functions and instances of function blocks can be called",
                    "só se podem chamar funções e instâncias de blocos de funções",
                );
                self.tell(Code::StNotCallable, at, [name.into(), what, help.into()]);
                self.told_name(name);
                None
            }
            None => {
                if Standard::named(&name.to_uppercase()).is_some() {
                    let instance = format!("{name}1");
                    self.tell(Code::StTypeCalled, at, [name.into(), instance.into()]);
                    return None;
                }
                let help = (
                    "declare an instance of a function block, or write a FUNCTION of this name",
                    "declare uma instância de um bloco de funções ou escreva uma FUNCTION com esse nome",
                );
                let help = self.near(name, help.into());
                self.tell(Code::StUndeclared, at, [name.into(), help]);
                self.told_name(name);
                None
            }
        }
    }

    /// How a value of this type is stored.
    pub(super) fn store_of(&self, ty: TypeId) -> Store {
        match self.tree.types.kind(ty) {
            Kind::Range { base, low, high } => Store::Within(*base, *low, *high),
            Kind::Text { most, .. } => Store::Text(*most),
            Kind::Base(base) if base.is_text() => Store::Text(254),
            _ => Store::Narrow(self.tree.types.base(ty).unwrap_or(Base::Bool)),
        }
    }
}
