//! What is said about InterSCL alone: codes 301 to 399. What it shares with Structured Text is in `st`.

macro_rules! iscl_rows {
    ($next:ident $($rest:tt)*) => {
        $next! { $($rest)*
    301 IsclOutside Error
        "`{0}` stands outside of BLOCO … END_BLOCK"
        "write it in between: the whole program is one block"
        "`{0}` está fora de BLOCO … END_BLOCK"
        "escreva-o no meio: o programa inteiro é um bloco";
    302 IsclNamed Error
        "a block has no name in InterSCL, and `{0}` is one"
        "delete it: BLOCO alone begins the program"
        "um bloco não tem nome no InterSCL, e `{0}` é um nome"
        "apague-o: BLOCO sozinho começa o programa";
    303 IsclTypeFirst Error
        "in a declaration the type comes first, and then `{1}`"
        "write {0} {1};"
        "em uma declaração o tipo vem primeiro e depois `{1}`"
        "escreva {0} {1};";
    304 IsclOneName Error
        "a declaration has one name, and `{2}` follows behind a comma"
        "write {0} {1}; {0} {2};"
        "uma declaração tem um só nome, e `{2}` vem depois de uma vírgula"
        "escreva {0} {1}; {0} {2};";
    305 IsclFirstValue Error
        "a declaration gives `{1}` no value: all variables begin with 0"
        "write {0} {1}; and, as a command, {1} := {2};"
        "uma declaração não dá valor a `{1}`: todas as variáveis começam com 0"
        "escreva {0} {1}; e, como comando, {1} := {2};";
    306 IsclLate Error
        "`{0}` declares a variable, and commands stand before it"
        "move it up, before the first command"
        "`{0}` declara uma variável, e há comandos antes dela"
        "mova-a para cima, antes do primeiro comando";
    307 IsclUndeclared Error
        "nothing declares `{0}`"
        "{1}"
        "nada declara `{0}`"
        "{1}";
    308 IsclNoElsif Error
        "InterSCL has no {0}"
        "write ELSE, a second IF in it, and END_IF for each: ELSE IF … THEN … END_IF; END_IF"
        "o InterSCL não tem {0}"
        "escreva ELSE, um segundo IF dentro dele, e END_IF para cada um: ELSE IF … THEN … END_IF; END_IF";
    309 IsclLacks Error
        "InterSCL has no `{0}`"
        "{1}"
        "o InterSCL não tem `{0}`"
        "{1}";
    310 IsclNoType Error
        "there is no type `{0}` in InterSCL"
        "take INT, REAL or BOOL"
        "não existe o tipo `{0}` no InterSCL"
        "use INT, REAL ou BOOL";
    311 IsclPrint Error
        "PRINT takes the name of one variable, and `{0}` is none"
        "{1}"
        "PRINT recebe o nome de uma variável, e `{0}` não é um"
        "{1}";
    312 IsclSeparator Warning
        "no `;` follows this {0}"
        "write {0};"
        "falta um `;` depois deste {0}"
        "escreva {0};";
    313 IsclEndFor Warning
        "this END_FOR ends a WHILE"
        "write END_WHILE"
        "este END_FOR encerra um WHILE"
        "escreva END_WHILE";
    314 IsclWrongEnd Error
        "`{0}` does not end a {1}"
        "write {2}"
        "`{0}` não encerra um {1}"
        "escreva {2}";
    315 IsclChained Error
        "`{0}` is TRUE or FALSE, and cannot be compared further"
        "write {0} AND {1} {2} …"
        "`{0}` é TRUE ou FALSE e não se compara outra vez"
        "escreva {0} AND {1} {2} …";
    316 IsclMismatch Error
        "`{0}` is {1}, and `{2}` is {3}"
        "{4}"
        "`{0}` é {1}, e `{2}` é {3}"
        "{4}";
    317 IsclOperand Error
        "{0} takes {1}, and `{2}` is {3}"
        "{4}"
        "{0} recebe {1}, e `{2}` é {3}"
        "{4}";
    318 IsclForVariable Error
        "FOR counts with an INT, and `{0}` is {1}"
        "declare INT {0};"
        "FOR conta com um INT, e `{0}` é {1}"
        "declare INT {0};";
    319 IsclComma Error
        "the decimal sign of `{0}` is a comma"
        "write a point: {1}"
        "o sinal decimal de `{0}` é uma vírgula"
        "escreva um ponto: {1}";
    320 IsclComment Warning
        "a comment of InterSCL begins with //, and this one with {0}"
        "write // before each line of it"
        "um comentário do InterSCL começa com //, e este com {0}"
        "escreva // antes de cada linha dele";
        }
    };
}
