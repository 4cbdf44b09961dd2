//! Expressions and calls.

use super::super::ast::{Arg, Name, Node, NodeKind, Op, Part, Path};
use super::{Checker, State};
use unoclp_text::diagnostics::{Code, Span};
use unoclp_tree::build::{Argument, Given, Named, Target, both};
use unoclp_tree::{Base, Compare, Expr, Kind, TypeId, Value};

impl Checker<'_, '_, '_> {
    /// An expression; where one of this type is needed, the values of an enumeration are looked for there first.
    pub(super) fn expr(&mut self, node: &Node, hint: Option<TypeId>) -> Expr {
        let at = node.span;
        match &node.kind {
            NodeKind::Wrong => self.builder.wrong(at),
            NodeKind::Literal(base, value) => self.builder.literal(*base, value.clone(), at),
            NodeKind::Member(ty, value) => self.value_of(ty, value, hint, at),
            NodeKind::Path(path) => {
                if let Some(expr) = self.hinted(path, hint) {
                    return expr;
                }
                if let Some((ty, value)) = self.dotted(path) {
                    return self.value_of(ty, value, hint, at);
                }
                if let Some((parts, bit)) = path.bit() {
                    let number = self.part_of(path, parts);
                    return self.builder.bit(number, &bit.text, at);
                }
                let target = self.target(path);
                self.builder.read(target, at)
            }
            NodeKind::Call(path, arguments) => self.called(path, arguments, at),
            NodeKind::Negate(inner) => {
                let inner = self.expr(inner, None);
                self.builder.negate(inner, at)
            }
            NodeKind::Not(inner) => {
                let inner = self.expr(inner, None);
                self.builder.not(inner, at)
            }
            NodeKind::Binary(op, a, b) => self.joined(*op, a, b, at),
        }
    }

    fn joined(&mut self, op: Op, a: &Node, b: &Node, at: Span) -> Expr {
        let first = self.expr(a, None);
        let hint = matches!(op, Op::Compare(_)).then_some(first.ty);
        let second = self.expr(b, hint);
        match op {
            Op::Arithmetic(op) => self.builder.arithmetic(op, first, second, at),
            Op::Logic(op) => self.builder.logic(op, first, second, at),
            Op::Compare(op) => self.builder.compare(op, first, second, at),
            Op::Power => {
                let argument = |expr: Expr| Argument {
                    name: None,
                    out: false,
                    at: expr.at,
                    given: Given::Value(expr),
                };
                let both = vec![argument(first), argument(second)];
                self.builder.function("EXPT", both, at)
            }
        }
    }

    /// A value of the enumeration that is needed.
    fn hinted(&mut self, path: &Path, hint: Option<TypeId>) -> Option<Expr> {
        if !path.parts.is_empty() {
            return None;
        }
        let ty = hint?;
        let Kind::Enum(values) = self.builder.tree.types.kind(ty) else {
            return None;
        };
        let key = self.builder.key(&path.name.text);
        let number = values.number_of(|name| self.builder.key(name) == key)?;
        let mut expr = self
            .builder
            .literal(Base::Int, Value::Int(number.into()), path.span);
        expr.ty = ty;
        Some(expr)
    }

    /// `Color.Red`, where no variable has the name of the type: the type and the value.
    pub(super) fn dotted<'p>(&self, path: &'p Path) -> Option<(&'p Name, &'p Name)> {
        let [Part::Member(value)] = path.parts.as_slice() else {
            return None;
        };
        let is_value = match self.builder.find(&path.name.text) {
            Some(Named::Type(ty)) => matches!(self.builder.tree.types.kind(*ty), Kind::Enum(_)),
            Some(_) => false,
            None => self.types.contains_key(&self.builder.key(&path.name.text)),
        };
        is_value.then_some((&path.name, value))
    }

    /// The type before `#`; none if it is wrong, which is told.
    fn type_of_value(&mut self, ty: &Name, hint: Option<TypeId>) -> Option<TypeId> {
        if let Some(&at) = self.types.get(&self.builder.key(&ty.text)) {
            // In its own declaration it has no name yet: `Color : (Red, Green) := Color#Red`.
            let own = hint.filter(|_| self.type_states[at] == State::Begun);
            return own.or_else(|| self.declared_type(at, ty));
        }
        let known = self.builder.find_type(&ty.text);
        if known.is_none() {
            let help = both(
                "write a standard type, T#, D#, or the name of an enumeration before #",
                "escreva antes de # um tipo da norma, T#, D#, ou o nome de uma enumeração",
            );
            let words = [ty.text.as_str().into(), help];
            self.builder.tell(Code::StUnknownType, ty.span, words);
        }
        known
    }

    /// `Color#Red`
    fn value_of(&mut self, ty: &Name, value: &Name, hint: Option<TypeId>, at: Span) -> Expr {
        let Some(id) = self.type_of_value(ty, hint) else {
            return self.builder.wrong(at);
        };
        let path = Path {
            name: value.clone(),
            parts: Vec::new(),
            span: at,
        };
        if let Some(expr) = self.hinted(&path, Some(id)) {
            return expr;
        }
        let names = match self.builder.tree.types.kind(id) {
            Kind::Enum(values) => values.some(),
            _ => String::new(),
        };
        let help = match names.is_empty() {
            true => both("it is not an enumeration", "ele não é uma enumeração"),
            false => both(format!("it has {names}"), format!("ele tem {names}")),
        };
        let words = [ty.text.as_str().into(), value.text.as_str().into(), help];
        self.builder.tell(Code::StNoMember, value.span, words);
        self.builder.wrong(at)
    }

    /// What a name with its members and subscripts stands for; none if that is wrong, which is told.
    pub(super) fn target(&mut self, path: &Path) -> Option<Target> {
        self.part_of(path, &path.parts)
    }

    /// What a name with these of its members and subscripts stands for.
    pub(super) fn part_of(&mut self, path: &Path, parts: &[Part]) -> Option<Target> {
        if self.builder.is_hidden(&path.name.text) {
            self.subscripts_only(path);
            return None;
        }
        let name = self.address(&path.name.text);
        let mut target = self.builder.name(&name, path.name.span);
        for part in parts {
            match part {
                Part::Bit(bit) => {
                    let what = format!(".{}", bit.text);
                    let help = (
                        "a bit of a number can only be read and stored; use a BOOL variable here",
                        "um bit de um número só pode ser lido e guardado; use aqui uma variável BOOL",
                    );
                    let words = [what.into(), help.into()];
                    self.builder.tell(Code::StUnsupported, bit.span, words);
                    target = None;
                }
                Part::Member(name) => {
                    target = target.and_then(|of| self.builder.member(of, &name.text, name.span));
                }
                Part::Subscripts(nodes, at) => {
                    let subscripts: Vec<Expr> =
                        nodes.iter().map(|node| self.expr(node, None)).collect();
                    target = target.and_then(|of| self.builder.subscript(of, subscripts, *at));
                }
            }
        }
        target
    }

    /// What is wrong within the subscripts of a name that is wrong itself.
    fn subscripts_only(&mut self, path: &Path) {
        for part in &path.parts {
            if let Part::Subscripts(nodes, _) = part {
                for node in nodes {
                    self.expr(node, None);
                }
            }
        }
    }

    /// What stands in the parentheses of a call.
    pub(super) fn arguments(&mut self, arguments: &[Arg]) -> Vec<Argument> {
        let all = arguments.iter();
        all.map(|argument| {
            let given = match &argument.node.kind {
                NodeKind::Path(path) if path.bit().is_none() => match self.target(path) {
                    Some(target) => Given::Place(target),
                    None => Given::Wrong,
                },
                _ => Given::Value(self.expr(&argument.node, None)),
            };
            let name = argument.name.as_ref();
            Argument {
                name: name.map(|name| (name.text.clone(), name.span)),
                out: argument.out,
                given,
                at: argument.node.span,
            }
        })
        .collect()
    }

    /// A call that has a value.
    fn called(&mut self, path: &Path, arguments: &[Arg], at: Span) -> Expr {
        let name = &path.name;
        if !path.parts.is_empty() {
            // Read as an instance, of which the value is one of its outputs.
            let target = self.target(path);
            self.arguments(arguments);
            return self.builder.read(target, path.span);
        }
        if self.calls_itself(name) || self.builder.is_hidden(&name.text) {
            self.arguments(arguments);
            return self.builder.wrong(at);
        }
        match self.builder.find(&name.text).cloned() {
            Some(Named::Variable(variable)) => {
                let block = matches!(
                    self.builder.tree.types.kind(variable.ty),
                    Kind::Standard(_) | Kind::Block(_)
                );
                if block {
                    let target = self.builder.name(&name.text, name.span);
                    return self.builder.read(target, path.span);
                }
            }
            Some(Named::Unit(_)) => {}
            None if self.builder.is_function(&name.text) => {
                let given = self.arguments(arguments);
                return self.builder.function(&name.text, given, at);
            }
            None if self.is_foreign(name) => {
                self.arguments(arguments);
                return self.builder.wrong(at);
            }
            _ => {}
        }
        match self.builder.callee(&name.text, name.span) {
            Some(unit) => {
                let given = self.arguments(arguments);
                self.builder.call(unit, given, name.span, at)
            }
            None => self.builder.wrong(at),
        }
    }

    /// Whether this names the function that it stands in; that is told.
    pub(super) fn calls_itself(&mut self, name: &Name) -> bool {
        let own = self
            .builder
            .name_here()
            .is_some_and(|own| self.builder.key(&own) == self.builder.key(&name.text));
        if own {
            let calls = ("calls", "chama").into();
            let words = [name.text.as_str().into(), calls];
            self.builder.tell(Code::StRecursive, name.span, words);
        }
        own
    }

    /// `IN = x` among what a call takes, where `IN := x` is meant.
    pub(super) fn equals_for_assign(&mut self, ty: TypeId, arguments: &[Arg]) -> bool {
        for argument in arguments {
            let NodeKind::Binary(Op::Compare(Compare::Equal), left, _) = &argument.node.kind else {
                continue;
            };
            let NodeKind::Path(path) = &left.kind else {
                continue;
            };
            let named = argument.name.is_some() || !path.parts.is_empty();
            if !named && self.builder.has_parameter(ty, &path.name.text) {
                let words = [path.name.text.as_str().into()];
                self.builder
                    .tell(Code::StEqualsForAssign, argument.node.span, words);
                return true;
            }
        }
        false
    }
}
