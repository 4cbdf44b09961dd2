//! The words of a timing diagram, in the two languages that the tools speak.
//!
//! Owns the words. Must not know of what they tell.

unoclp_words::messages! {
    expected() "expected" "esperado";
    came() "actual" "obtido";
    power_cut() "power cut" "queda de energia";
    seconds(whole, tenths) "{whole}.{tenths} s" "{whole},{tenths} s";
    legend()
        "Red: not as expected. Where nothing is expected, any value passes."
        "Vermelho: diferente do esperado. Onde nada é esperado, qualquer valor serve.";
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_text_says_the_same_in_both_languages() {
        assert_eq!(unoclp_words::gaps(ALL), [""; 0]);
    }
}
