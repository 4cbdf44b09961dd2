//! The values of an enumeration.
//!
//! Owns which number a name has. Must not know where they are declared.

/// Named numbers of an INT, in the order of the text.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Enumeration(Vec<(String, i16)>);

/// More values than these are not named in a message.
const MOST_NAMED: usize = 12;

impl Enumeration {
    /// These names with their numbers.
    pub fn new(values: Vec<(String, i16)>) -> Enumeration {
        Enumeration(values)
    }

    /// Each value's name and number, in the order of the text.
    pub fn values(&self) -> impl Iterator<Item = (&str, i16)> {
        self.0.iter().map(|(name, number)| (name.as_str(), *number))
    }

    /// The value with which a variable begins: the first one, and 0 where there is none.
    pub fn first(&self) -> (&str, i16) {
        self.values().next().unwrap_or_default()
    }

    /// The name of the value with this number.
    pub fn name_of(&self, number: i128) -> Option<&str> {
        let mut values = self.values();
        let found = values.find(|(_, known)| i128::from(*known) == number);
        found.map(|(name, _)| name)
    }

    /// The number of the value whose name this is, as `is` compares names.
    pub fn number_of(&self, is: impl Fn(&str) -> bool) -> Option<i16> {
        let mut values = self.values();
        values.find(|(name, _)| is(name)).map(|(_, number)| number)
    }

    /// The first names, for a message: `Red, Green`.
    pub fn some(&self) -> String {
        let names: Vec<&str> = self.values().map(|(name, _)| name).collect();
        match names.get(..MOST_NAMED) {
            Some(some) if names.len() > MOST_NAMED => some.join(", ") + " …",
            _ => names.join(", "),
        }
    }
}
