//! Messages about InterSCL only: codes 301 to 399. What it shares with Structured Text is in `st`.

macro_rules! iscl_rows {
    ($next:ident $($rest:tt)*) => {
        $next! { $($rest)*
    301 IsclOutside Error
        "`{0}` is outside BLOCO … END_BLOCK"
        "move it between the two: the whole program is one block"
        "`{0}` está fora de BLOCO … END_BLOCK"
        "coloque-o entre os dois: o programa inteiro é um bloco";
    302 IsclNamed Error
        "a block has no name in InterSCL, so `{0}` is not allowed here"
        "delete it: the program begins with BLOCO"
        "um bloco não tem nome no InterSCL; por isso `{0}` não é permitido aqui"
        "apague-o: o programa começa com BLOCO";
    303 IsclTypeFirst Error
        "in a declaration, the type comes before `{1}`"
        "write {0} {1};"
        "em uma declaração, o tipo vem antes de `{1}`"
        "escreva {0} {1};";
    304 IsclOneName Error
        "a declaration has only one name, but `{2}` follows the comma"
        "write {0} {1}; {0} {2};"
        "uma declaração tem um só nome, mas `{2}` vem depois da vírgula"
        "escreva {0} {1}; {0} {2};";
    305 IsclFirstValue Error
        "a declaration cannot give `{1}` a value: all variables start at 0"
        "write {0} {1}; and, as a statement, {1} := {2};"
        "uma declaração não pode dar valor a `{1}`: todas as variáveis começam em 0"
        "escreva {0} {1}; e, como comando, {1} := {2};";
    306 IsclLate Error
        "`{0}` declares a variable, but statements come before it"
        "move it up, before the first statement"
        "`{0}` declara uma variável depois de um comando"
        "mova a declaração para cima, antes do primeiro comando";
    307 IsclUndeclared Error
        "`{0}` is not declared"
        "{1}"
        "`{0}` não foi declarado"
        "{1}";
    308 IsclNoElsif Error
        "InterSCL has no {0}"
        "write ELSE, a second IF inside it, and an END_IF for each: ELSE IF … THEN … END_IF; END_IF"
        "o InterSCL não tem {0}"
        "escreva ELSE, um segundo IF dentro dele, e um END_IF para cada um: ELSE IF … THEN … END_IF; END_IF";
    309 IsclLacks Error
        "InterSCL has no `{0}`"
        "{1}"
        "o InterSCL não tem `{0}`"
        "{1}";
    310 IsclNoType Error
        "there is no type `{0}` in InterSCL"
        "use INT, REAL or BOOL"
        "não existe o tipo `{0}` no InterSCL"
        "use INT, REAL ou BOOL";
    311 IsclPrint Error
        "PRINT takes the name of a variable, but `{0}` is not a variable"
        "{1}"
        "PRINT recebe o nome de uma variável, mas `{0}` não é uma variável"
        "{1}";
    312 IsclSeparator Warning
        "a `;` is missing after this {0}"
        "write {0};"
        "falta um `;` depois deste {0}"
        "escreva {0};";
    313 IsclEndFor Warning
        "this END_FOR ends a WHILE"
        "write END_WHILE"
        "este END_FOR encerra um WHILE"
        "escreva END_WHILE";
    314 IsclWrongEnd Error
        "`{0}` does not end this {1}"
        "write {2}"
        "`{0}` não encerra este {1}"
        "escreva {2}";
    315 IsclChained Error
        "`{0}` is TRUE or FALSE and cannot be compared again"
        "write {0} AND {1} {2} …"
        "`{0}` é TRUE ou FALSE e não pode ser comparado outra vez"
        "escreva {0} AND {1} {2} …";
    316 IsclMismatch Error
        "the types differ: `{0}` is {1}, but `{2}` is {3}"
        "{4}"
        "os tipos são diferentes: `{0}` é {1}, mas `{2}` é {3}"
        "{4}";
    317 IsclOperand Error
        "{0} takes {1}, but `{2}` is {3}"
        "{4}"
        "{0} recebe {1}, mas `{2}` é {3}"
        "{4}";
    318 IsclForVariable Error
        "FOR needs an INT, but `{0}` is {1}"
        "declare INT {0};"
        "FOR precisa de um INT, mas `{0}` é {1}"
        "declare INT {0};";
    319 IsclComma Error
        "`{0}` has a decimal comma"
        "use a decimal point: {1}"
        "`{0}` tem vírgula decimal"
        "use ponto decimal: {1}";
    320 IsclComment Warning
        "comments in InterSCL begin with //, but this one begins with {0}"
        "write // before each line"
        "um comentário do InterSCL começa com //, mas este começa com {0}"
        "escreva // antes de cada linha";
        }
    };
}
