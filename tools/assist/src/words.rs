//! What an editor is told in words.

use unoclp_lang::Lang;
use unoclp_lang::typed::Standard;

unoclp_words::messages! {
    nothing_to_rename() "there is no declared name here; put the cursor on one" "não há um nome declarado aqui; ponha o cursor em um";
    no_name(name) "`{name}` cannot be a name; use letters, digits and _, and no keyword" "`{name}` não serve de nome; use letras, dígitos e _, e nenhuma palavra reservada";
    taken(name) "`{name}` is already used; choose another name" "`{name}` já está em uso; escolha outro nome";
    another(name) "the name `{name}` would change the program; choose another name" "o nome `{name}` mudaria o programa; escolha outro nome";
    place(points) "is at {points}" "fica em {points}";
    used(times, written) "used {times} times, written {written} times" "usado {times} vezes, escrito {written} vezes";
    never_written(times) "used {times} times, never written" "usado {times} vezes, nunca escrito";
    never_used() "never used" "nunca usado";
    costs(bytes) "this line takes {bytes} bytes of program memory" "esta linha ocupa {bytes} bytes da memória de programa";
    input_of(block) "an input of {block}" "uma entrada de {block}";
    output_of(block) "an output of {block}" "uma saída de {block}";
    parameter_of(function) "a parameter of {function}" "um parâmetro de {function}";
    from_to(low, high) "from {low} to {high}" "de {low} a {high}";
    point_of_board(point) "{point}, a point of the board" "{point}, um ponto da placa";
    write_instead(word) "Write `{word}`" "Escrever `{word}`";
    delete_it(word) "Delete `{word}`" "Apagar `{word}`";
    insert_it(word) "Insert `{word}`" "Inserir `{word}`";
    declare(name, ty) "Declare `{name}` as {ty}" "Declarar `{name}` como {ty}";
    program() "program" "programa";
    function_block() "function block" "bloco de funções";
    function() "function" "função";
    a_type() "type" "tipo";
    value_of() "value of an enumeration" "valor de uma enumeração";
    step() "step" "etapa";
    transition() "transition" "transição";
    action() "action" "ação";
    label() "label" "rótulo";
    sr() "keeps a bit: S1 sets it and wins, R resets it" "guarda um bit: S1 liga e vence, R desliga";
    rs() "keeps a bit: S sets it, R1 resets it and wins" "guarda um bit: S liga, R1 desliga e vence";
    rising() "Q is 1 for one scan when CLK rises" "Q fica em 1 por uma varredura quando CLK sobe";
    falling() "Q is 1 for one scan when CLK falls" "Q fica em 1 por uma varredura quando CLK cai";
    up() "counts up when CU rises; Q is 1 when CV is PV or more; R clears CV" "conta para cima quando CU sobe; Q fica em 1 quando CV é PV ou maior; R zera CV";
    down() "counts down when CD rises; Q is 1 when CV is 0 or less; LD loads PV" "conta para baixo quando CD sobe; Q fica em 1 quando CV é 0 ou menor; LD carrega PV";
    both_ways() "counts up with CU and down with CD; R clears CV, LD loads PV" "conta para cima com CU e para baixo com CD; R zera CV, LD carrega PV";
    pulse() "Q is 1 for the time PT after IN rises" "Q fica em 1 durante o tempo PT a partir da subida de IN";
    on_delay() "Q becomes 1 once IN has been 1 for the time PT" "Q vai a 1 quando IN fica em 1 durante o tempo PT";
    off_delay() "Q stays 1 for the time PT after IN falls" "Q fica em 1 durante o tempo PT depois da descida de IN";
    retentive() "Q becomes 1 once IN has been 1 for PT in total; a reset clears the time" "Q vai a 1 quando IN soma o tempo PT em 1; um reset zera o tempo";
}

/// What a function block of the standard does.
pub(crate) fn block(block: Standard, lang: Lang) -> String {
    match block.plain() {
        Standard::Sr => sr(lang),
        Standard::Rs => rs(lang),
        Standard::RTrig => rising(lang),
        Standard::FTrig => falling(lang),
        Standard::Ctu => up(lang),
        Standard::Ctd => down(lang),
        Standard::Tp => pulse(lang),
        Standard::Ton => on_delay(lang),
        Standard::Tof => off_delay(lang),
        Standard::Tonr => retentive(lang),
        _ => both_ways(lang),
    }
}
