//! What is said of a file in TOML.

unoclp_words::messages! {
    no_toml()
        "this is not TOML; check quotes, commas and brackets, and whether a key appears twice"
        "isto não é TOML; confira aspas, vírgulas e colchetes, e se uma chave aparece duas vezes";
    no_key(key, known)
        "there is no key `{key}` here; known keys: {known}"
        "não existe a chave `{key}` aqui; chaves conhecidas: {known}";
    missing(key, example)
        "the key `{key}` is missing; write `{key} = {example}`"
        "falta a chave `{key}`; escreva `{key} = {example}`";
    kind(key, example)
        "`{key}` takes a different kind of value; write `{key} = {example}`"
        "`{key}` pede outro tipo de valor; escreva `{key} = {example}`";
    choice(key, given, known)
        "`{key}` cannot be {given}; choose {known}"
        "`{key}` não pode ser {given}; escolha {known}";
}

#[cfg(test)]
mod tests {
    #[test]
    fn every_message_has_both_languages() {
        assert_eq!(unoclp_words::gaps(super::ALL), [""; 0]);
    }
}
