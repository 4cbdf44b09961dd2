//! Units: their variables, in the order in which they need one another.

use super::super::ast::{self, Decl, Name, SpecKind, Vars};
use super::{Checker, Stage};
use unoclp_text::diagnostics::Code;
use unoclp_tree::build::{Section, Traits, both};
use unoclp_tree::{Base, Kind, Stmt, TypeId, UnitKind};

impl From<ast::Section> for Section {
    fn from(section: ast::Section) -> Section {
        match section {
            ast::Section::Var => Section::Var,
            ast::Section::Input => Section::Input,
            ast::Section::Output => Section::Output,
            ast::Section::InOut => Section::InOut,
            ast::Section::Temp => Section::Temp,
            ast::Section::Global => Section::Global,
            ast::Section::External => Section::External,
        }
    }
}

/// What a section says of its variables.
pub struct Of {
    /// Which section it is.
    pub section: Section,
    /// Whether nothing changes them.
    pub constant: bool,
    /// Whether they outlast a power cut.
    pub retain: bool,
}

impl Checker<'_, '_, '_> {
    /// All that is declared.
    pub(super) fn declare_all(&mut self) {
        let file = self.file;
        for (at, ty) in file.types.iter().enumerate() {
            let key = self.builder.key(&ty.name.text);
            self.types.entry(key).or_insert(at);
        }
        for unit in &file.foreign {
            let key = self.builder.key(&unit.text);
            self.foreign.entry(key).or_insert(false);
        }
        for (at, unit) in file.units.iter().enumerate() {
            let number = self
                .builder
                .unit(&unit.name.text, unit.kind, unit.name.span);
            self.units.push(Stage::Not(number));
            if unit.kind == UnitKind::Block {
                let key = self.builder.key(&unit.name.text);
                self.blocks.entry(key).or_insert(at);
            }
        }
        // Types may be measured by constants, so these come first.
        let (first, then): (Vec<&Vars>, Vec<&Vars>) =
            file.globals.iter().partition(|vars| vars.constant);
        for vars in first {
            self.section(vars);
        }
        for at in 0..file.types.len() {
            self.declared_type(at, &file.types[at].name);
        }
        for vars in then {
            self.section(vars);
        }
        for at in 0..file.units.len() {
            self.declare_unit(at);
        }
    }

    /// The variables of a unit, once.
    pub(super) fn declare_unit(&mut self, at: usize) {
        let declaration = &self.file.units[at];
        let unit = match std::mem::replace(&mut self.units[at], Stage::Begun) {
            Stage::Not(unit) => unit,
            stage => {
                self.units[at] = stage;
                return;
            }
        };
        self.within += 1;
        let before = self.builder.enter(&unit);
        if declaration.kind == UnitKind::Function {
            let name = &declaration.name;
            match &declaration.result {
                Some(spec) => match self.spec(spec) {
                    Some(ty) => self.builder.result(ty, name.span),
                    None => {
                        self.builder.hide(&name.text);
                        self.builder.gives();
                    }
                },
                None => {
                    self.builder.result(TypeId::of(Base::Bool), name.span);
                    self.builder.gives();
                }
            }
        }
        // Constants may measure arrays that stand before them.
        let (first, then): (Vec<&Vars>, Vec<&Vars>) =
            declaration.vars.iter().partition(|vars| vars.constant);
        for vars in first.into_iter().chain(then) {
            self.section(vars);
        }
        self.declare_edges(at);
        self.declare_chart(at);
        self.units[at] = Stage::Done(self.builder.close(unit));
        self.builder.back(before);
        self.within -= 1;
    }

    /// What sees the edges of the inputs that are declared as such.
    fn declare_edges(&mut self, at: usize) {
        let vars = self.file.units[at].vars.iter().chain(&self.file.globals);
        for decl in vars.flat_map(|vars| &vars.decls) {
            let Some(edge) = decl.edge else { continue };
            for name in &decl.names {
                let edge = self.builder.edge_input(&name.text, edge, name.span);
                self.edges.entry(at).or_default().extend(edge);
            }
        }
    }

    fn section(&mut self, vars: &Vars) {
        let of = Of {
            section: Section::from(vars.section),
            constant: vars.constant,
            retain: vars.retain,
        };
        for decl in &vars.decls {
            self.declare(&of, decl);
        }
    }

    pub(super) fn declare(&mut self, of: &Of, decl: &Decl) {
        let Some(ty) = self.spec(&decl.spec) else {
            // What is named of it is not told again.
            for name in &decl.names {
                self.builder.hide(&name.text);
            }
            return;
        };
        if matches!(decl.spec.kind, SpecKind::Enum(_)) {
            self.builder.name_values(ty);
        }
        for name in &decl.names {
            self.declare_one(of, decl, name, ty);
        }
    }

    fn declare_one(&mut self, of: &Of, decl: &Decl, name: &Name, ty: TypeId) {
        let mut initial = None;
        if let Some(init) = &decl.initial {
            initial = self.initial(name, init, ty);
        }
        let point = match &decl.at {
            Some(address) => {
                let point = self.builder.address_for(&address.text, ty, address.span);
                if point.is_none() {
                    self.builder.hide(&name.text);
                    return;
                }
                point
            }
            None => None,
        };
        let block = matches!(
            self.builder.tree.types.kind(ty),
            Kind::Standard(_) | Kind::Block(_)
        );
        if of.constant && block {
            let help = both("declare it with VAR", "declare-o com VAR");
            let what = both(
                format!("CONSTANT for `{}`", name.text),
                format!("CONSTANT para `{}`", name.text),
            );
            self.builder
                .tell(Code::StUnsupported, name.span, [what, help]);
        }
        let traits = Traits {
            initial,
            constant: of.constant,
            retain: of.retain,
            unseen: false,
            point,
        };
        if self
            .builder
            .declare(&name.text, name.span, ty, of.section, traits)
            .is_none()
        {
            self.builder.hide(&name.text);
        }
    }

    /// Whether this is a unit with code for another machine; then that is told.
    pub(super) fn is_foreign(&mut self, name: &Name) -> bool {
        let key = self.builder.key(&name.text);
        let Some(used) = self.foreign.get_mut(&key) else {
            return false;
        };
        *used = true;
        let words = [name.text.as_str().into()];
        self.builder.tell(Code::StForeignCode, name.span, words);
        true
    }

    /// Tells which units with code for another machine nothing uses.
    pub(super) fn unused_foreign(&mut self) {
        // One that is used is told as the mistake, and those that it uses itself are used too.
        if self.foreign.values().any(|is_used| *is_used) {
            return;
        }
        for unit in &self.file.foreign {
            let key = self.builder.key(&unit.text);
            if self.foreign.get(&key) == Some(&false) {
                let words = [unit.text.as_str().into()];
                self.builder.tell(Code::StForeignUnit, unit.span, words);
            }
        }
    }

    /// What each unit does.
    pub(super) fn bodies(&mut self) {
        let units = std::mem::take(&mut self.units);
        for (at, stage) in units.into_iter().enumerate() {
            let Stage::Done(unit) = stage else { continue };
            let before = self.builder.enter(&unit);
            let edges = self.edges.remove(&at).unwrap_or_default();
            let edges = edges
                .into_iter()
                .flat_map(|edge| self.builder.see_edge(edge));
            let mut body: Vec<Stmt> = edges.collect();
            body.extend(self.statements(&self.file.units[at].body));
            body.extend(self.chart(at));
            self.builder.back(before);
            self.builder.body(unit, body);
        }
    }
}
