//! Who somebody is, by the token that is shown.
//!
//! Owns who is let in, and how often somebody may try. Must not know what is asked afterwards.

use crate::tokens::{Role, Tokens};
use crate::tries::Tries;
use ring::digest::{SHA256, digest};
use std::fmt;
use std::net::IpAddr;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Instant;
use subtle::ConstantTimeEq;
use tokio::sync::Semaphore;
use unoclp_site::{Role as May, User};

/// Who is let in.
#[derive(Clone, Debug)]
pub enum Guard {
    /// Everybody on this PC, who may do all. The server is bound to this PC then.
    ThisPc,
    /// Who has one of two tokens.
    Tokens(Tokens),
    /// Who is a user of the site.
    Users(Users),
}

/// Somebody who is let in.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Who {
    /// A user's name, or what stands for it: no user's name begins with `$`.
    pub name: Arc<str>,
    /// What this one may do.
    pub may: May,
}

/// Why somebody is not let in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Stays {
    /// The token is none.
    Wrong,
    /// There were too many tries from this address.
    Often,
}

impl Who {
    fn of(name: &str, may: May) -> Who {
        Who {
            name: name.into(),
            may,
        }
    }

    /// How its requests go to a board.
    pub fn role(&self) -> Role {
        match self.may {
            May::Watch => Role::Watch,
            May::Operate | May::Engineer => Role::Control,
        }
    }
}

impl Guard {
    /// Who shows this token, from this address.
    pub(crate) async fn who(&self, token: &str, from: IpAddr) -> Result<Who, Stays> {
        match self {
            Guard::ThisPc => Ok(Who::of("$local", May::Engineer)),
            Guard::Tokens(tokens) => match tokens.role(token) {
                Some(Role::Control) => Ok(Who::of("$control", May::Engineer)),
                Some(Role::Watch) => Ok(Who::of("$watch", May::Watch)),
                None => Err(Stays::Wrong),
            },
            Guard::Users(users) => users.who(token, from).await,
        }
    }
}

/// The users of a site.
#[derive(Clone)]
pub struct Users(Arc<Shared>);

struct Shared {
    users: Vec<User>,
    /// Stands for the key of who is no user, so that a try takes as long.
    nobody: String,
    /// What the tokens that were right come to, each with the number of its user: to compare a token with a key takes long.
    known: Mutex<Vec<([u8; 32], usize)>>,
    tries: Mutex<Tries>,
    /// One token is compared with a key at a time: it takes memory, and a processor.
    one: Semaphore,
}

impl fmt::Debug for Users {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Users")
    }
}

impl Users {
    /// These.
    ///
    /// # Errors
    /// Where the system has no random numbers, or no memory.
    pub fn new(users: Vec<User>) -> Result<Users, unoclp_key::NotMade> {
        Ok(Users(Arc::new(Shared {
            users,
            nobody: unoclp_key::make("nobody")?.key,
            known: Mutex::default(),
            tries: Mutex::default(),
            one: Semaphore::new(1),
        })))
    }

    async fn who(&self, token: &str, from: IpAddr) -> Result<Who, Stays> {
        let sum = sum(token);
        if let Some(user) = self.known(&sum) {
            return Ok(user);
        }
        // Nobody needs to try without a token.
        let name = unoclp_key::name(token).ok_or(Stays::Wrong)?;
        let Ok(_one) = self.0.one.acquire().await else {
            return Err(Stays::Wrong);
        };
        if !lock(&self.0.tries).may_try(from, Instant::now()) {
            return Err(Stays::Often);
        }
        let number = self.0.users.iter().position(|user| user.name == name);
        let user = number.and_then(|number| self.0.users.get(number));
        let key = user.map_or(&self.0.nobody, |user| &user.key.0).clone();
        let token = token.to_owned();
        let fits = tokio::task::spawn_blocking(move || unoclp_key::fits(&token, &key));
        let fits = fits.await.unwrap_or(false);
        match (fits, number) {
            (true, Some(number)) => {
                let mut known = lock(&self.0.known);
                known.retain(|(_, of)| *of != number);
                known.push((sum, number));
                drop(known);
                lock(&self.0.tries).was_right(from);
                self.user(number).ok_or(Stays::Wrong)
            }
            _ => Err(Stays::Wrong),
        }
    }

    /// Whose token comes to this, if it was right before. All are compared, whichever it is.
    fn known(&self, sum: &[u8; 32]) -> Option<Who> {
        let mut found = None;
        for (of, number) in &*lock(&self.0.known) {
            if bool::from(of.ct_eq(sum)) {
                found = Some(*number);
            }
        }
        self.user(found?)
    }

    fn user(&self, number: usize) -> Option<Who> {
        let user = self.0.users.get(number)?;
        Some(Who::of(&user.name, user.role))
    }
}

fn sum(token: &str) -> [u8; 32] {
    let mut sum = [0; 32];
    let digest = digest(&SHA256, token.as_bytes());
    for (to, from) in sum.iter_mut().zip(digest.as_ref()) {
        *to = *from;
    }
    sum
}

fn lock<T>(of: &Mutex<T>) -> MutexGuard<'_, T> {
    of.lock().unwrap_or_else(PoisonError::into_inner)
}
