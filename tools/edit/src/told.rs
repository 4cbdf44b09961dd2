//! What the ladder editor refuses and what it finds wrong, in words. `docs/editor-messages.md` and its translation say
//! under each number what to do.

use unoclp_draw::edit::{Refusal, Wrong};
use unoclp_lang::Lang;
use unoclp_program::diagnosis::cause;

unoclp_words::messages! {
    not_there() "the selected element no longer exists" "o elemento selecionado já não existe";
    not_one_series() "select elements of one series" "selecione elementos da mesma série";
    select_elements() "select an element first" "selecione antes um elemento";
    select_one() "select a single element" "selecione um único elemento";
    no_opposite() "this element has no inverted form" "este elemento não tem forma invertida";
    no_such_coil() "this point cannot have that kind of coil" "este ponto não aceita esse tipo de bobina";
    not_that_address() "this element cannot have that address" "este elemento não aceita esse endereço";
    contacts_only() "only a contact can detect an edge" "só um contato pode detectar uma borda";
    if_ends_rung() "an IF must be the last element of its rung, outside of branches" "um IF deve ser o último elemento do degrau, fora de ramos";
    not_an_element() "this element cannot be inserted here" "este elemento não pode ser inserido aqui";
    too_deep() "too many nested branches" "há ramos aninhados demais";
    nothing_copied() "nothing has been copied; copy an element first" "nada foi copiado; copie antes um elemento";
    into_itself() "an element cannot move into itself" "um elemento não pode ir para dentro de si mesmo";
    no_further() "no further move is possible in this direction" "não é possível mover mais o elemento nesta direção";
    cannot_join() "no rung below can be joined to this one" "nenhum degrau abaixo pode ser unido a este";
    out_of_range() "the number is out of range" "o número está fora da faixa";
    nothing_to_undo() "there is nothing to undo" "não há nada a desfazer";
    nothing_to_redo() "there is nothing to redo" "não há nada a refazer";
    name_taken() "another point has that name" "outro ponto já tem esse nome";
    select_block() "select a block first" "selecione antes um bloco";
    missing() "an address or an operand is missing" "falta um endereço ou um operando";
    no_point_left() "this rung needs more than 8 branch points" "este degrau precisa de mais de 8 pontos de ramificação";
    bridge() "this path is empty, so its parallel elements have no effect" "este caminho está vazio; por isso os elementos em paralelo não têm efeito";
    leads_nowhere() "no coil comes after this element, so it has no effect" "nenhuma bobina vem depois deste elemento; por isso ele não tem efeito";
}

/// Why an operation is refused.
pub fn refusal(lang: Lang, refusal: Refusal) -> String {
    match refusal {
        Refusal::NotThere => not_there(lang),
        Refusal::NotOneSeries => not_one_series(lang),
        Refusal::SelectElements => select_elements(lang),
        Refusal::SelectOne => select_one(lang),
        Refusal::NoOpposite => no_opposite(lang),
        Refusal::NoSuchCoil => no_such_coil(lang),
        Refusal::NotThatAddress => not_that_address(lang),
        Refusal::ContactsOnly => contacts_only(lang),
        Refusal::IfEndsRung => if_ends_rung(lang),
        Refusal::NotAnElement => not_an_element(lang),
        Refusal::TooDeep => too_deep(lang),
        Refusal::NothingCopied => nothing_copied(lang),
        Refusal::IntoItself => into_itself(lang),
        Refusal::NoFurther => no_further(lang),
        Refusal::CannotJoin => cannot_join(lang),
        Refusal::OutOfRange => out_of_range(lang),
        Refusal::NothingToUndo => nothing_to_undo(lang),
        Refusal::NothingToRedo => nothing_to_redo(lang),
        Refusal::NameTaken => name_taken(lang),
        Refusal::SelectBlock => select_block(lang),
    }
}

/// What is wrong with an element.
pub fn wrong(lang: Lang, wrong: Wrong) -> String {
    match wrong {
        Wrong::Missing => missing(lang),
        Wrong::NoPointLeft => no_point_left(lang),
        Wrong::Bridge => bridge(lang),
        Wrong::LeadsNowhere => leads_nowhere(lang),
        Wrong::Fault(of) => cause(of, lang).to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::{Lang, Refusal, Wrong, refusal, wrong};

    #[test]
    fn every_text_says_the_same_in_both_languages() {
        assert_eq!(unoclp_words::gaps(super::ALL), [""; 0]);
    }

    #[test]
    fn both_pages_have_every_number_with_its_text() {
        let pages = [
            (Lang::En, include_str!("../../../docs/editor-messages.md")),
            (
                Lang::Pt,
                include_str!("../../../docs/editor-messages.pt-BR.md"),
            ),
        ];
        for (lang, page) in pages {
            let rows = page.lines().filter(|line| line.starts_with("| ")).count();
            let own = [
                Wrong::Missing,
                Wrong::NoPointLeft,
                Wrong::Bridge,
                Wrong::LeadsNowhere,
            ];
            let own = own.map(|of| (of.number(), wrong(lang, of)));
            let refused = Refusal::ALL
                .iter()
                .map(|of| (of.number(), refusal(lang, *of)));
            let all: Vec<_> = refused.chain(own).collect();
            for (number, text) in &all {
                assert!(
                    page.contains(&format!("| {number} | {text} | ")),
                    "{number} {text}"
                );
            }
            // Two tables, each with a heading and a line below it.
            assert_eq!(rows, all.len() + 4);
        }
    }
}
