//! Types as they are declared: by their names, or where they are used.

use super::super::ast::{Name, Node, SpecKind, TypeSpec};
use super::{Checker, MOST_WITHIN, State};
use unoclp_text::diagnostics::{Code, Word};
use unoclp_tree::build::both;
use unoclp_tree::{Base, Expr, ExprKind, Generic, Kind, Standard, Type, TypeId};

impl Checker<'_, '_, '_> {
    /// The type of this name; told if there is none.
    pub(super) fn type_named(&mut self, name: &Name) -> Option<TypeId> {
        let key = self.builder.key(&name.text);
        if let Some(base) = Base::named(&key) {
            return Some(TypeId::of(base));
        }
        if let Some(&at) = self.types.get(&key) {
            return self.declared_type(at, name);
        }
        if let Some(&at) = self.blocks.get(&key) {
            return self.block_type(at, name);
        }
        let standard = Standard::named(&key).or_else(|| Standard::overloaded(&key));
        if let Some(block) = standard {
            let cells = block.cells();
            return Some(
                self.builder
                    .tree
                    .types
                    .add_kind(Kind::Standard(block), cells),
            );
        }
        // The blocks of a list are declared by its own reader.
        if self.maker.is_some()
            && let Some(ty) = self.builder.find_type(&key)
        {
            return Some(ty);
        }
        if self.is_foreign(name) {
            return None;
        }
        let generics = [
            Generic::Elementary,
            Generic::Magnitude,
            Generic::Num,
            Generic::Real,
            Generic::Int,
            Generic::Bit,
            Generic::Text,
            Generic::Date,
        ];
        let generic = generics.iter().any(|generic| generic.name() == key);
        if generic || matches!(key.as_str(), "ANY" | "ANY_DERIVED") {
            self.builder
                .tell(Code::StGeneric, name.span, [name.text.as_str().into()]);
            return None;
        }
        let help = self.type_help(name, &key);
        self.builder.tell(
            Code::StUnknownType,
            name.span,
            [name.text.as_str().into(), help],
        );
        None
    }

    fn type_help(&mut self, name: &Name, key: &str) -> Word {
        let write = |ty: &str| both(format!("write {ty}"), format!("escreva {ty}"));
        match key {
            "INTEGER" | "INTEIRO" | "SHORT" | "INT16" | "INT16_T" => return write("INT"),
            "LONG" | "INT32" | "INT32_T" => return write("DINT"),
            "BOOLEAN" | "BOOLEANO" | "BIT" | "LOGICO" => return write("BOOL"),
            "FLOAT" | "SINGLE" | "DECIMAL" => return write("REAL"),
            "DOUBLE" => return write("LREAL"),
            "CHAR" | "TEXT" | "STR" => return write("STRING"),
            "TIMER" | "IEC_TIMER" => return write("TON"),
            "COUNTER" | "IEC_COUNTER" => return write("CTU"),
            "UNSIGNED" | "UINT16" | "UINT16_T" => return write("UINT"),
            "UINT8" | "UINT8_T" => return write("USINT"),
            "UINT32" | "UINT32_T" => return write("UDINT"),
            _ => {}
        }
        let bases = Base::ALL.iter().map(|base| base.name());
        let blocks = Standard::ALL.iter().map(|block| block.name());
        let own = self.file.types.iter().map(|ty| ty.name.text.as_str());
        let units = self.file.units.iter().map(|unit| unit.name.text.as_str());
        // A file with very many types is not a student's.
        let own = own.chain(units).take(200);
        let near = unoclp_text::near::nearest(&name.text, bases.chain(blocks).chain(own));
        match near {
            Some(near) => Word::Near(near.to_string()),
            None => (
                "use BOOL, INT, DINT, REAL, TIME or another standard type, a block such as TON or CTU, or a type from TYPE or FUNCTION_BLOCK",
                "use BOOL, INT, DINT, REAL, TIME ou outro tipo da norma, um bloco como TON ou CTU, ou um tipo de TYPE ou FUNCTION_BLOCK",
            )
                .into(),
        }
    }

    /// A type of TYPE, made out once.
    pub(super) fn declared_type(&mut self, at: usize, used: &Name) -> Option<TypeId> {
        match self.type_states[at] {
            State::Done(ty) => return ty,
            State::Begun => {
                let name = used.text.as_str().into();
                let contains = ("contains", "contém").into();
                self.builder
                    .tell(Code::StRecursive, used.span, [name, contains]);
                return None;
            }
            State::Not => {}
        }
        self.type_states[at] = State::Begun;
        let ty = self.make_type(at, used);
        self.type_states[at] = State::Done(ty);
        if let (None, SpecKind::Enum(values)) = (ty, &self.file.types[at].spec.kind) {
            let before = self.builder.outside();
            for (name, _) in values {
                self.builder.hide(&name.text);
            }
            self.builder.back(before);
        }
        ty
    }

    fn make_type(&mut self, at: usize, used: &Name) -> Option<TypeId> {
        let declaration = &self.file.types[at];
        if self.within >= MOST_WITHIN {
            self.builder.tell(Code::StTooDeep, used.span, []);
            return None;
        }
        self.within += 1;
        let of = self.spec(&declaration.spec);
        self.within -= 1;
        let of = of?;
        let plain = self.builder.tree.types.get(of).clone();
        let initial = match &declaration.initial {
            Some(init) => self.initial(&declaration.name, init, of),
            None => None,
        };
        let ty = self.builder.tree.types.add(Type {
            name: Some(declaration.name.text.clone()),
            kind: plain.kind,
            cells: plain.cells,
            initial,
            alias: Some(of),
        });
        let name = &declaration.name;
        let ty = self.not_too_deep(ty, name.span)?;
        self.builder.name_type(&name.text, ty, name.span);
        if matches!(declaration.spec.kind, SpecKind::Enum(_)) {
            self.builder.name_values(ty);
        }
        Some(ty)
    }

    /// The type that stands in a declaration; told if it is none.
    pub(super) fn spec(&mut self, spec: &TypeSpec) -> Option<TypeId> {
        match &spec.kind {
            SpecKind::Named(name) => self.type_named(name),
            SpecKind::Text(base, None) => Some(TypeId::of(*base)),
            SpecKind::Text(base, Some(most)) => {
                let most = self.constant(most)?.clamp(0, 4096) as u32;
                let base = *base;
                Some(
                    self.builder
                        .tree
                        .types
                        .add_kind(Kind::Text { base, most }, 1),
                )
            }
            SpecKind::Enum(values) => self.enumeration(values),
            SpecKind::Range(name, bounds) => self.range(name, bounds),
            SpecKind::Array(bounds, of) => self.array(spec, bounds, of),
            SpecKind::Struct(decls) => self.structure(spec, decls),
        }
    }

    /// A whole number that is known.
    pub(super) fn constant(&mut self, node: &Node) -> Option<i128> {
        let expr = self.expr(node, None);
        self.known(expr)
    }

    pub(super) fn known(&mut self, expr: Expr) -> Option<i128> {
        match &expr.kind {
            ExprKind::Constant(value) if expr.base.is_int() => Some(value.int()),
            ExprKind::Wrong => None,
            _ => {
                let written = self.builder.written(expr.at);
                self.builder
                    .tell(Code::StNotConstant, expr.at, [written.into()]);
                None
            }
        }
    }
}
