//! The tables `user` of a site file.

use crate::broker::Secret;
use crate::keys::{Amiss, At, Keys};
use crate::mistake::Wrong;
use crate::named::named;
use unoclp_key::is_key;

const EXAMPLE: &str = "[{ name = \"ana\", role = \"operate\", key = \"$argon2id$…\" }]";
const ROLES: &str = "\"watch\", \"operate\", \"engineer\"";

/// Somebody who may do something.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct User {
    /// What this user is called, as no other of the site is.
    pub name: String,
    /// What this user may do.
    pub role: Role,
    /// What tells the user's token from all others: a hash by Argon2id, in the form of PHC.
    pub key: Secret,
}

/// What a user may do.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Role {
    /// Read.
    Watch,
    /// Start, stop, force and write, and acknowledge alarms.
    Operate,
    /// Change programs and settings too.
    Engineer,
}

impl Role {
    /// All of them.
    pub const ALL: [Role; 3] = [Role::Watch, Role::Operate, Role::Engineer];

    /// As the file has it.
    pub fn word(self) -> &'static str {
        match self {
            Role::Watch => "watch",
            Role::Operate => "operate",
            Role::Engineer => "engineer",
        }
    }
}

/// The users, as far as they are right.
pub(crate) fn users(keys: &Keys<'_>) -> Vec<User> {
    let tables = keys.tables("user", EXAMPLE);
    let mut users: Vec<User> = Vec::new();
    for table in &tables.unwrap_or_default() {
        table.known(&["name", "role", "key"]);
        let name = named(table, "\"ana\"");
        if let Some(At { value, place }) = &name
            && users
                .iter()
                .any(|other| other.name.eq_ignore_ascii_case(value))
        {
            let name = value.clone();
            table.notes.wrong(place, Wrong::TwoUsers { name });
        }
        let role = role(table);
        let key = key(table);
        if let (Some(name), Some(role), Some(key)) = (name, role, key) {
            users.push(User {
                name: name.value,
                role,
                key,
            });
        }
    }
    users
}

fn role(table: &Keys<'_>) -> Option<Role> {
    let At { value, place } = table.needed("role", "\"operate\"")?;
    let role = Role::ALL.into_iter().find(|role| role.word() == value);
    if role.is_none() {
        let wrong = Amiss::Choice {
            key: "role".to_owned(),
            given: value,
            known: ROLES.to_owned(),
        };
        table.notes.wrong(&place, wrong);
    }
    role
}

/// A key. What is none is not repeated: it may be a token.
fn key(table: &Keys<'_>) -> Option<Secret> {
    let At { value, place } = table.needed("key", "\"$argon2id$…\"")?;
    if is_key(&value) {
        return Some(Secret(value));
    }
    table.notes.wrong(&place, Wrong::NoKeyOfUser);
    None
}
