//! What a variable begins with: values, elements, members.

use super::super::ast::{Init, Name, Node};
use super::Checker;
use std::sync::Arc;
use unoclp_text::diagnostics::{Code, Span, Word};
use unoclp_tree::build::{Section, both};
use unoclp_tree::{Initial, Kind, TypeId};

type Elements = Vec<(u32, Option<Arc<Initial>>)>;

impl Checker<'_, '_, '_> {
    /// The first value of the variable of this name; none if it is wrong, which is told.
    pub(super) fn initial(&mut self, name: &Name, init: &Init, ty: TypeId) -> Option<Arc<Initial>> {
        match (init, self.builder.tree.types.kind(ty).clone()) {
            (Init::Value(node), _) if self.builder.tree.types.is_scalar(ty) => {
                let expr = self.expr(node, Some(ty));
                self.builder.initial(expr, ty)
            }
            (Init::Elements(all, at), Kind::Array { of, .. }) => {
                self.elements(name, all, ty, of, *at)
            }
            (
                Init::Members(all, _),
                kind @ (Kind::Struct(_) | Kind::Standard(_) | Kind::Block(_)),
            ) => self.members(name, all, &kind),
            (Init::Value(node), Kind::Array { .. }) => self.told_form(name, node.span, "[1, 2, 3]"),
            (Init::Value(node), _) => self.told_form(name, node.span, "(x := 1, y := 2)"),
            (Init::Elements(_, at), Kind::Struct(_)) => {
                self.told_form(name, *at, "(x := 1, y := 2)")
            }
            (Init::Elements(_, at), Kind::Standard(_) | Kind::Block(_)) => {
                self.told_form(name, *at, "(x := 1)")
            }
            (Init::Members(_, at), Kind::Array { .. }) => self.told_form(name, *at, "[1, 2, 3]"),
            (Init::Elements(_, at) | Init::Members(_, at), _) => self.told_form(name, *at, "1"),
        }
    }

    fn told_form(&mut self, name: &Name, at: Span, like: &str) -> Option<Arc<Initial>> {
        let why = (
            "the value does not match the type of the variable",
            "o valor não corresponde ao tipo da variável",
        );
        let help = both(
            format!("write it like {like}"),
            format!("escreva como {like}"),
        );
        self.told(name, at, why.into(), help)
    }

    fn told(&mut self, name: &Name, at: Span, why: Word, help: Word) -> Option<Arc<Initial>> {
        self.builder
            .tell(Code::StInitial, at, [name.text.as_str().into(), why, help]);
        None
    }

    fn elements(
        &mut self,
        name: &Name,
        all: &[(Option<Node>, Option<Init>)],
        ty: TypeId,
        of: TypeId,
        at: Span,
    ) -> Option<Arc<Initial>> {
        let types = &self.builder.tree.types;
        let size = types.get(of).cells;
        let most = types.get(ty).cells.checked_div(size).unwrap_or(0);
        let mut elements = Elements::new();
        let mut count = 0_u64;
        self.push_elements(name, all, of, &mut elements, &mut count)?;
        if count > u64::from(most) {
            let why = both(
                format!("{count} values are listed here, but the array has {most} elements"),
                format!("há {count} valores aqui, mas a matriz tem {most} elementos"),
            );
            let help = (
                "delete some, or declare a larger array",
                "apague alguns ou declare uma matriz maior",
            );
            return self.told(name, at, why, help.into());
        }
        Some(Arc::new(Initial::Elements(elements)))
    }

    fn push_elements(
        &mut self,
        name: &Name,
        all: &[(Option<Node>, Option<Init>)],
        of: TypeId,
        elements: &mut Elements,
        count: &mut u64,
    ) -> Option<()> {
        let is_array = matches!(self.builder.tree.types.kind(of), Kind::Array { .. });
        for (times, init) in all {
            let times = match times {
                Some(node) => self.constant(node)?.clamp(0, i128::from(u32::MAX)) as u32,
                None => 1,
            };
            // Rows in brackets of their own are elements in a row.
            if let (Some(Init::Elements(row, _)), false) = (init, is_array) {
                let mut inner = Elements::new();
                let mut within = 0;
                self.push_elements(name, row, of, &mut inner, &mut within)?;
                *count = count.saturating_add(within.saturating_mul(times.into()));
                for _ in 0..times.min(unoclp_tree::build::MOST_CELLS) {
                    if elements.len() as u32 > unoclp_tree::build::MOST_CELLS {
                        break;
                    }
                    elements.extend_from_slice(&inner);
                }
                continue;
            }
            *count = count.saturating_add(times.into());
            let init = match init {
                Some(init) => Some(self.initial(name, init, of)?),
                None => None,
            };
            elements.push((times, init));
        }
        Some(())
    }

    fn members(&mut self, name: &Name, all: &[(Name, Init)], kind: &Kind) -> Option<Arc<Initial>> {
        let mut members = Vec::new();
        for (member, init) in all {
            let key = self.builder.key(&member.text);
            let found = match kind {
                Kind::Struct(of) => {
                    let mut of = of.iter().filter(|one| self.builder.key(&one.name) == key);
                    of.next().map(|one| (one.offset, one.ty))
                }
                Kind::Standard(block) => {
                    let part = block.part(&key);
                    part.map(|(offset, part)| (offset, TypeId::of(part.1)))
                }
                Kind::Block(unit) => self.builder.draft(*unit).and_then(|draft| {
                    let mut params = draft.params.iter();
                    let param = params.find(|param| {
                        self.builder.key(&param.name) == key && param.section != Section::InOut
                    });
                    param.map(|param| (param.offset, param.ty))
                }),
                _ => None,
            };
            let Some((offset, ty)) = found else {
                let help = (
                    "write the name of a member of its type",
                    "escreva o nome de um membro do tipo dela",
                );
                let words = [
                    name.text.as_str().into(),
                    member.text.as_str().into(),
                    help.into(),
                ];
                self.builder.tell(Code::StNoMember, member.span, words);
                return None;
            };
            let initial = self.initial(member, init, ty)?;
            members.push((offset, ty, initial));
        }
        Some(Arc::new(Initial::Members(members)))
    }
}
