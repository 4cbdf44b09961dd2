//! What a request gives, by its keys.
//!
//! Each request takes what it needs out of the one tree that the JSON was read into: derived readers, one for each
//! request, would be a quarter of the module.

use crate::words::{self, Both, both};
use serde_json::{Map, Value};

/// The values of a request that nobody has taken yet.
pub struct Given(Map<String, Value>);

impl Given {
    /// Of the text of a request.
    ///
    /// # Errors
    /// Where it is no JSON, or no object.
    pub fn read(request: &[u8]) -> Result<Given, Both> {
        let read = serde_json::from_slice(request);
        let value: Value = read.map_err(|error| both(|lang| words::no_request(lang, &error)))?;
        Given::of(value).ok_or_else(|| both(|lang| words::no_request(lang, "{")))
    }

    /// Of a value of a list; none where it is no object.
    pub fn of(value: Value) -> Option<Given> {
        match value {
            Value::Object(values) => Some(Given(values)),
            _ => None,
        }
    }

    /// What a key has, where it is what is wanted; a key that is null or not there has nothing.
    fn find<T>(&mut self, key: &str, want: fn(Value) -> Option<T>) -> Result<Option<T>, Both> {
        match self.0.remove(key) {
            None | Some(Value::Null) => Ok(None),
            Some(value) => Ok(Some(want(value).ok_or_else(|| wrong(key))?)),
        }
    }

    /// Whether a key has something.
    pub fn is_there(&self, key: &str) -> bool {
        self.0.get(key).is_some_and(|value| !value.is_null())
    }

    /// A text.
    ///
    /// # Errors
    /// Where there is none.
    pub fn text(&mut self, key: &str) -> Result<String, Both> {
        needed(key, self.find(key, of_text))
    }

    /// A text that may be left out.
    ///
    /// # Errors
    /// Where it is something else.
    pub fn text_if(&mut self, key: &str) -> Result<Option<String>, Both> {
        self.find(key, of_text)
    }

    /// A whole number.
    ///
    /// # Errors
    /// Where there is none, or it is out of the range of its type.
    pub fn number<T: TryFrom<i64>>(&mut self, key: &str) -> Result<T, Both> {
        needed(key, self.number_if(key))
    }

    /// A whole number that may be left out.
    ///
    /// # Errors
    /// Where it is something else, or out of the range of its type.
    pub fn number_if<T: TryFrom<i64>>(&mut self, key: &str) -> Result<Option<T>, Both> {
        let number = self.find(key, |value| value.as_i64())?;
        let number = number.map(|number| T::try_from(number).map_err(|_| wrong(key)));
        number.transpose()
    }

    /// A number of columns; what is too large to be one is the largest.
    ///
    /// # Errors
    /// Where there is none.
    pub fn columns(&mut self, key: &str) -> Result<usize, Both> {
        let columns = needed(key, self.find(key, |value| value.as_u64()))?;
        Ok(usize::try_from(columns).unwrap_or(usize::MAX))
    }

    /// A number, which may have a fraction.
    ///
    /// # Errors
    /// Where there is none.
    pub fn real(&mut self, key: &str) -> Result<f64, Both> {
        needed(key, self.find(key, |value| value.as_f64()))
    }

    /// Whether something holds, which may be left out.
    ///
    /// # Errors
    /// Where it is something else.
    pub fn truth_if(&mut self, key: &str) -> Result<Option<bool>, Both> {
        self.find(key, |value| value.as_bool())
    }

    /// Whether something holds.
    ///
    /// # Errors
    /// Where nothing says so.
    pub fn truth(&mut self, key: &str) -> Result<bool, Both> {
        needed(key, self.truth_if(key))
    }

    /// Bytes, as a list of numbers.
    ///
    /// # Errors
    /// Where there are none.
    pub fn bytes(&mut self, key: &str) -> Result<Vec<u8>, Both> {
        let byte = |value: &Value| value.as_u64().and_then(|byte| u8::try_from(byte).ok());
        let list = self.list(key)?;
        let bytes: Option<Vec<u8>> = list.iter().map(byte).collect();
        bytes.ok_or_else(|| wrong(key))
    }

    /// A list.
    ///
    /// # Errors
    /// Where there is none.
    pub fn list(&mut self, key: &str) -> Result<Vec<Value>, Both> {
        needed(
            key,
            self.find(key, |value| match value {
                Value::Array(list) => Some(list),
                _ => None,
            }),
        )
    }

    /// What stands below a key.
    ///
    /// # Errors
    /// Where nothing does.
    pub fn below(&mut self, key: &str) -> Result<Given, Both> {
        needed(key, self.below_if(key))
    }

    /// The same, where it may be left out.
    ///
    /// # Errors
    /// Where it is something else.
    pub fn below_if(&mut self, key: &str) -> Result<Option<Given>, Both> {
        self.find(key, Given::of)
    }
}

fn of_text(value: Value) -> Option<String> {
    match value {
        Value::String(text) => Some(text),
        _ => None,
    }
}

fn needed<T>(key: &str, found: Result<Option<T>, Both>) -> Result<T, Both> {
    found?.ok_or_else(|| wrong(key))
}

/// What is said of a key that has not what it should.
pub fn wrong(key: &str) -> Both {
    both(|lang| words::no_request(lang, key))
}
