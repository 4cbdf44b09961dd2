//! What lies between a conversation and its page.

use super::news::News;
use super::order::Order;
use super::watched::Watched;
use std::cell::RefCell;
use std::collections::VecDeque;

/// What lies between a conversation and its page.
#[derive(Default)]
pub struct Desk {
    pub orders: RefCell<VecDeque<(u32, Order)>>,
    pub news: RefCell<Vec<News>>,
    pub watched: RefCell<Option<Watched>>,
}

impl Desk {
    /// Tells the page something with the next step.
    pub fn tell(&self, news: News) {
        self.news.borrow_mut().push(news);
    }
}
