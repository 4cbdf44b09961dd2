//! Charts: what their names mean, and their conditions, times and actions.
//!
//! What a chart does, `unoclp-chart` knows.

use super::super::ast::Chart;
use super::Checker;
use unoclp_chart::{Cells, Net, Parts, lower};
use unoclp_text::diagnostics::{Code, Span};
use unoclp_tree::{Base, ExprKind, Stmt, TypeId};

impl<'a> Checker<'a, '_, '_> {
    fn chart_of(&self, unit: usize) -> Option<&'a Chart> {
        self.file.units.get(unit)?.chart.as_ref()
    }

    /// The steps and actions of a unit's chart, if it has one.
    pub(super) fn declare_chart(&mut self, unit: usize) {
        let Some(chart) = self.chart_of(unit) else {
            return;
        };
        let net = Net::of(chart, &mut self.builder);
        let cells = Cells::declare(&net, &mut self.builder);
        self.charts.insert(unit, (net, cells));
    }

    /// The statements of a unit's chart, if it has one.
    pub(super) fn chart(&mut self, unit: usize) -> Vec<Stmt> {
        let (Some(chart), Some((net, cells))) = (self.chart_of(unit), self.charts.remove(&unit))
        else {
            return Vec::new();
        };
        let mut parts = Parts::default();
        for transition in &chart.transitions {
            let condition = self.condition(&transition.condition);
            let is_right = !matches!(condition.kind, ExprKind::Wrong);
            parts.conditions.push(is_right.then_some(condition));
        }
        let steps = (0..).zip(&chart.steps);
        let all = steps.flat_map(|(step, of)| of.does.iter().enumerate().map(move |of| (step, of)));
        for (step, (nth, does)) in all {
            let Some(time) = &does.time else { continue };
            let time = self.expr(time, None);
            let time = self.builder.coerce(time, TypeId::of(Base::Time));
            parts.times.insert((step, nth), time);
        }
        for action in &chart.actions {
            self.in_action = true;
            let body = self.statements(&action.body);
            self.in_action = false;
            parts.bodies.push(body);
        }
        if !self.builder.found.has_errors() {
            net.look(chart.at, self.builder.found);
        }
        lower(&net, &cells, parts, &mut self.builder)
    }

    pub(super) fn return_in_action(&mut self, at: Span) {
        let why = (
            "an action ends with its last statement",
            "uma ação termina com o seu último comando",
        );
        let help = (
            "put an IF around the statements to skip",
            "ponha um IF em volta dos comandos a pular",
        );
        let words = ["RETURN".into(), why.into(), help.into()];
        self.builder.tell(Code::StChartPlace, at, words);
    }
}
