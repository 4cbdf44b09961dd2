//! The panels of a site as they are told, and what may be set there.

use super::answers::{BindOf, ItemOf, NameOf, PanelOf, Texts};
use super::past::No;
use crate::gateway::Gateway;
use crate::poll::Watched;
use std::sync::Arc;
use unoclp_modbus::map::Width;
use unoclp_site::{Bind, Grant, Item, Look, Panel, Text};

/// The panels of a site, and the points that a panel may have.
#[derive(Clone)]
pub(crate) struct Sheets {
    panels: Arc<[Panel]>,
    names: Arc<[NameOf]>,
    /// The units of the boards, in the order of the gateways.
    units: Arc<[u8]>,
}

impl Sheets {
    /// These panels, of boards with these units.
    pub fn new<'b>(
        panels: Vec<Panel>,
        boards: impl Iterator<Item = (u8, &'b Gateway, Option<&'b Watched>)> + Clone,
    ) -> Sheets {
        let names = boards.clone().filter_map(|(_, gateway, watched)| {
            let points = &watched?.points;
            let points = points.recorded(points.program.is_some());
            Some(points.into_iter().map(|point| NameOf {
                board: gateway.name.clone(),
                bit: point.read.width == Width::Bit,
                writes: !point.write.is_empty(),
                point: point.name,
            }))
        });
        Sheets {
            names: names.flatten().collect(),
            panels: panels.into(),
            units: boards.map(|(unit, ..)| unit).collect(),
        }
    }

    /// The points that a panel may have.
    pub fn names(&self) -> Vec<NameOf> {
        self.names.to_vec()
    }

    /// The panels.
    pub fn panels(&self) -> Vec<PanelOf> {
        self.panels.iter().map(panel).collect()
    }

    /// How this value of a point is written.
    pub fn grant(&self, board: &str, point: &str, value: f64) -> Result<&Grant, No> {
        let items = self.panels.iter().flat_map(|panel| &panel.items);
        let of_point = |item: &&Item| item.board == board && item.point == point;
        let mut why = No::Panel;
        for item in items.filter(of_point) {
            let [least, most] = match item.look {
                Look::Set => item.range,
                _ => [0.0, 1.0],
            };
            match &item.grant {
                Some(grant) if (least..=most).contains(&value) => return Ok(grant),
                Some(_) => why = No::Value,
                None => {}
            }
        }
        Err(why)
    }

    /// Which board has this unit.
    pub fn board(&self, unit: u8) -> Option<usize> {
        self.units.iter().position(|of| *of == unit)
    }
}

fn panel(of: &Panel) -> PanelOf {
    PanelOf {
        name: of.name.clone(),
        title: texts(&of.title),
        columns: of.columns,
        drawing: of.drawing.clone(),
        items: of.items.iter().map(item).collect(),
        binds: of.binds.iter().map(bind).collect(),
        made: of.is_made,
    }
}

fn item(of: &Item) -> ItemOf {
    let [least, most] = of.range;
    ItemOf {
        show: of.look.word(),
        board: of.board.clone(),
        point: of.point.clone(),
        label: texts(&of.label),
        unit: of.unit.clone(),
        least,
        most,
        at: of.at,
        size: of.size,
    }
}

fn bind(of: &Bind) -> BindOf {
    let [least, most] = of.range;
    BindOf {
        id: of.id.clone(),
        board: of.board.clone(),
        point: of.point.clone(),
        does: of.does.word(),
        least,
        most,
    }
}

fn texts(of: &Text) -> Texts {
    Texts {
        en: of.en.clone(),
        pt: of.pt.clone(),
    }
}
