//! What an editor is told in words.

use unoclp_lang::Lang;
use unoclp_lang::typed::Standard;

unoclp_words::messages! {
    nothing_to_rename() "there is no declared name here; put the cursor on one" "não há um nome declarado aqui; ponha o cursor em um";
    no_name(name) "`{name}` cannot be a name; use letters, digits and _, but not a keyword" "`{name}` não serve de nome; use letras, algarismos e _, mas não uma palavra-chave";
    taken(name) "`{name}` is already used; choose another name" "`{name}` já está em uso; escolha outro nome";
    another(name) "the name `{name}` would change the program; choose another name" "o nome `{name}` mudaria o programa; escolha outro nome";
    place(points) "is at {points}" "fica em {points}";
    used(times, written) "uses: {times}, writes: {written}" "usos: {times}, escritas: {written}";
    never_written(times) "uses: {times}, never written" "usos: {times}, nunca escrito";
    never_used() "never used" "nunca usado";
    costs(bytes) "bytes of program memory on this line: {bytes}" "bytes de memória de programa nesta linha: {bytes}";
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
    sr() "stores a bit: S1 sets it and has priority; R resets it" "guarda um bit: S1 o liga e tem prioridade; R o desliga";
    rs() "stores a bit: S sets it; R1 resets it and has priority" "guarda um bit: S o liga; R1 o desliga e tem prioridade";
    rising() "Q is 1 for one scan when CLK rises" "Q fica em 1 por uma varredura quando CLK sobe";
    falling() "Q is 1 for one scan when CLK falls" "Q fica em 1 por uma varredura quando CLK cai";
    up() "counts up when CU rises; Q is 1 while CV is at least PV; R clears CV" "conta para cima quando CU sobe; Q fica em 1 enquanto CV é maior ou igual a PV; R zera CV";
    down() "counts down when CD rises; Q is 1 while CV is 0 or less; LD loads PV into CV" "conta para baixo quando CD sobe; Q fica em 1 enquanto CV é 0 ou menor; LD carrega PV em CV";
    both_ways() "counts up with CU and down with CD; R clears CV; LD loads PV into CV" "conta para cima com CU e para baixo com CD; R zera CV; LD carrega PV em CV";
    pulse() "Q is 1 for the time PT after IN rises" "Q fica em 1 durante o tempo PT a partir da subida de IN";
    on_delay() "Q becomes 1 once IN has been 1 for the time PT" "Q vai a 1 quando IN fica em 1 durante o tempo PT";
    off_delay() "Q stays 1 for the time PT after IN falls" "Q fica em 1 durante o tempo PT depois da descida de IN";
    retentive() "Q becomes 1 once IN has been 1 for a total time of PT; a reset clears the time" "Q vai a 1 quando o tempo total com IN em 1 chega a PT; um reset zera o tempo";
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
