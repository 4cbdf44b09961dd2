//! Tokens of the users of a site: made, hashed by Argon2id, and compared (`docs/site.md`).
//!
//! A token is `NAME.SECRET`, the secret 128 random bits. Who has the token is let in; who reads the site file has its hash
//! alone, the *key*.
//!
//! Owns the form of tokens and keys. Must not know what a user may do, nor how a token came.

#![forbid(unsafe_code)]

use argon2::password_hash::phc::PasswordHash;
use argon2::{Argon2, Params, PasswordHasher, PasswordVerifier};
use std::fmt::Write;

/// The most memory that comparing with a key may take, KiB.
const MEMORY: u32 = 1 << 20;
/// The most passes over it.
const PASSES: u32 = 100;
/// The longest token, bytes: a name of 32, a point, and a secret of 32.
pub const LONGEST: usize = 80;

/// A new token and its key.
#[derive(Clone, PartialEq, Eq)]
pub struct Made {
    /// For the user alone.
    pub token: String,
    /// For the site file.
    pub key: String,
}

/// Why no token is made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NotMade(pub String);

/// Makes a token for the user of this name, and its key.
///
/// # Errors
/// Where the system has no random numbers, or no memory.
pub fn make(name: &str) -> Result<Made, NotMade> {
    let mut bytes = [0; 16];
    getrandom::fill(&mut bytes).map_err(|why| NotMade(why.to_string()))?;
    let mut token = format!("{name}.");
    for byte in bytes {
        // To a string nothing fails.
        let _ = write!(token, "{byte:02x}");
    }
    let key = Argon2::default().hash_password(token.as_bytes());
    let key = key.map_err(|why| NotMade(why.to_string()))?.to_string();
    Ok(Made { token, key })
}

/// The name of the user whose token this claims to be.
pub fn name(token: &str) -> Option<&str> {
    let name = token.split_once('.').map(|(name, _)| name);
    name.filter(|_| token.len() <= LONGEST)
}

/// Whether this is a key, and comparing with it takes no more memory and time than it should.
pub fn is_key(key: &str) -> bool {
    let Ok(hash) = PasswordHash::new(key) else {
        return false;
    };
    let is_ours = hash.algorithm.as_str() == "argon2id" && hash.hash.is_some();
    let params = Params::try_from(&hash);
    is_ours && params.is_ok_and(|params| params.m_cost() <= MEMORY && params.t_cost() <= PASSES)
}

/// Whether a token is that of this key. It takes as long for a wrong one as for a right one.
pub fn fits(token: &str, key: &str) -> bool {
    let hash = PasswordHash::new(key).ok().filter(|_| is_key(key));
    hash.is_some_and(|hash| {
        Argon2::default()
            .verify_password(token.as_bytes(), &hash)
            .is_ok()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_key_fits_its_token_and_no_other() {
        let made = make("ana").unwrap();
        assert_eq!(name(&made.token), Some("ana"));
        assert!(is_key(&made.key), "{}", made.key);
        assert!(fits(&made.token, &made.key));
        for wrong in [
            "",
            "ana.",
            &made.token.replace("ana", "eva"),
            &made.token[..made.token.len() - 1],
        ] {
            assert!(!fits(wrong, &made.key), "{wrong}");
        }
        let other = make("ana").unwrap();
        assert!(other.token != made.token && !fits(&other.token, &made.key));
    }

    #[test]
    fn what_is_no_key_lets_nobody_in() {
        let made = make("ana").unwrap();
        let too_much = made.key.replace("m=19456", "m=4000000");
        assert_ne!(too_much, made.key);
        for key in [
            "",
            "secret",
            "$argon2id$",
            "$argon2id$v=19$m=19456,t=2,p=1$c2FsdHNhbHQ",
            &made.key.replace("argon2id", "argon2i"),
            &too_much,
        ] {
            assert!(!is_key(key) && !fits(&made.token, key), "{key}");
        }
        assert_eq!(name("ana"), None);
        assert_eq!(name(&format!("ana.{}", "0".repeat(99))), None);
    }
}
