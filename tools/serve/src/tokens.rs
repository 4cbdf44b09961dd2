//! Who may watch, and who may control.

use std::fmt::Write;
use subtle::ConstantTimeEq;

/// A visitor: a number that no other has.
pub(crate) type Visitor = u64;

/// How a visitor's requests go to a board.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Role {
    /// As those of one who only reads.
    Watch,
    /// As those of one who may write: they go first.
    Control,
}

impl Role {
    /// Its name between page and gateway.
    pub fn name(self) -> &'static str {
        match self {
            Role::Watch => "watch",
            Role::Control => "control",
        }
    }
}

/// The two secrets of one run: 128 random bits each, as 32 hexadecimal digits.
#[derive(Clone, Debug)]
pub struct Tokens {
    /// For whoever may watch.
    pub watch: String,
    /// For whoever may control.
    pub control: String,
}

impl Tokens {
    /// Two that nobody can guess.
    ///
    /// # Errors
    /// Where the system has no random numbers.
    pub fn random() -> Result<Tokens, getrandom::Error> {
        Ok(Tokens {
            watch: token()?,
            control: token()?,
        })
    }

    /// What this token lets do. Takes as long for a wrong one as for a right one.
    pub fn role(&self, token: &str) -> Option<Role> {
        let is = |secret: &str| bool::from(secret.as_bytes().ct_eq(token.as_bytes()));
        match (is(&self.control), is(&self.watch)) {
            (true, _) => Some(Role::Control),
            (false, true) => Some(Role::Watch),
            (false, false) => None,
        }
    }
}

fn token() -> Result<String, getrandom::Error> {
    let mut bytes = [0; 16];
    getrandom::fill(&mut bytes)?;
    let mut text = String::new();
    for byte in bytes {
        // To a string nothing fails.
        let _ = write!(text, "{byte:02x}");
    }
    Ok(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_token_lets_do_its_own() {
        let tokens = Tokens::random().unwrap();
        assert_eq!(tokens.role(&tokens.watch), Some(Role::Watch));
        assert_eq!(tokens.role(&tokens.control), Some(Role::Control));
        for wrong in [
            "",
            "x",
            &tokens.watch[1..],
            &tokens.control.to_uppercase().replace(char::is_numeric, "G"),
        ] {
            assert_eq!(tokens.role(wrong), None, "{wrong}");
        }
        assert_ne!(tokens.watch, Tokens::random().unwrap().watch);
    }
}
