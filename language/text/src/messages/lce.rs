//! Messages about LCE only: codes 401 to 499. What it shares with Structured Text is in `st`.

macro_rules! lce_rows {
    ($next:ident $($rest:tt)*) => {
        $next! { $($rest)*
    401 LceNoName Warning
        "this {0} has no name"
        "write a name after it: {0} portao"
        "este {0} não tem nome"
        "escreva um nome depois dele: {0} portao";
    402 LceBehind Error
        "`{0}` comes after {1}, which ends the program"
        "move it up, before {1}"
        "`{0}` vem depois de {1}, que encerra o programa"
        "mova-o para cima, antes de {1}";
    403 LceConstant Error
        "`{0}` is a constant, but a variable is needed here"
        "{1}"
        "`{0}` é uma constante, mas aqui é preciso uma variável"
        "{1}";
    404 LceUndeclared Error
        "the name `{0}` is not defined"
        "{1}"
        "o nome `{0}` não foi definido"
        "{1}";
    405 LceNoPoint Error
        "there is no point `{0}` on this board"
        "{1}"
        "não existe o ponto `{0}` nesta placa"
        "{1}";
    406 LceInput Error
        "nothing can be stored in `{0}`: only a sensor can change an input"
        "use an output (Q0.0), a marker (M0.0) or a variable (V0)"
        "não se pode guardar nada em `{0}`: só um sensor pode mudar uma entrada"
        "use uma saída (Q0.0), uma memória (M0.0) ou uma variável (V0)";
    407 LceTypeApart Error
        "the type `{0}` is separated from its operator"
        "write {0}{1} without a space"
        "o tipo `{0}` está separado do seu operador"
        "escreva {0}{1} sem espaço";
    408 LceSpace Warning
        "a space is missing next to `{0}`"
        "write one between an operator and each of its operands: V0 {0} V1"
        "falta um espaço ao lado de `{0}`"
        "deixe um entre o operador e cada operando: V0 {0} V1";
    409 LceRealLogic Error
        "`R{0}` does not exist: {0} works on bits, and R is not a bit type"
        "write {0}, or W{0} or B{0} for 16 or 8 bits"
        "`R{0}` não existe: {0} opera sobre bits, e R não é um tipo de bits"
        "escreva {0}, ou W{0} ou B{0} para 16 ou 8 bits";
    410 LceVarForm Error
        "`{0}` does not name a place"
        "{1}"
        "`{0}` não dá nome a um lugar"
        "{1}";
    411 LceSwapped Error
        "after var, write the place first, then its name"
        "write {1} = {0};"
        "depois de var, escreva primeiro o lugar e depois o nome"
        "escreva {1} = {0};";
    412 LceLateVar Error
        "var gives names, but statements come before it"
        "move it up, before the first statement"
        "var dá nomes, mas há comandos antes dele"
        "mova-o para cima, antes do primeiro comando";
    413 LceCut Warning
        "`{0}` loses its fraction: `{1}` takes whole numbers"
        "write R{2}"
        "`{0}` perde as casas decimais: `{1}` trabalha com números inteiros"
        "escreva R{2}";
    414 LceRange Error
        "{0} does not fit in D, which ranges from -2147483648 to 2147483647"
        "write it as R, with a decimal point: {0}.0"
        "{0} não cabe em D, que vai de -2147483648 a 2147483647"
        "escreva-o como R, com ponto decimal: {0}.0";
    415 LceNegative Error
        "`-{0}` is not allowed: numbers with 2# and 16# take no minus sign"
        "write it as a decimal number: -{1}"
        "`-{0}` não é permitido: números com 2# e 16# não recebem sinal de menos"
        "escreva em decimal: -{1}";
    416 LceSignApart Warning
        "a space separates this sign from its number"
        "write -{0}"
        "um espaço separa este sinal do número"
        "escreva -{0}";
    417 LceSignOfName Error
        "a sign can only be written before a number, not before `{0}`"
        "subtract it from 0: 0 - {0}"
        "um sinal só pode ser escrito antes de um número, e não antes de `{0}`"
        "subtraia de 0: 0 - {0}";
    418 LceTwoCoils Warning
        "this is another coil of `{0}`; only the last one takes effect"
        "combine the conditions with |, or write liga and desliga"
        "esta é mais uma bobina de `{0}`; só a última tem efeito"
        "junte as condições com | ou escreva liga e desliga";
    419 LceBraces Error
        "write the statements of `{0}` between {1}"
        "write {0} … {2} aciona Q0.0; {3}"
        "escreva os comandos de `{0}` entre {1}"
        "escreva {0} … {2} aciona Q0.0; {3}";
    420 LceLacks Error
        "LCE has no `{0}`"
        "{1}"
        "a LCE não tem `{0}`"
        "{1}";
    421 LceLetter Error
        "`{0}` is not an LCE type"
        "use R, D, W or B, in capitals: {1}"
        "`{0}` não é um tipo da LCE"
        "use R, D, W ou B, em maiúscula: {1}";
    422 LceChained Error
        "`{0}` is true or false and cannot be compared again"
        "write ({0}) & ({1} {2} …)"
        "`{0}` é verdadeiro ou falso e não pode ser comparado outra vez"
        "escreva ({0}) & ({1} {2} …)";
    423 LceComma Error
        "`{0}` has a decimal comma"
        "use a decimal point: {1}"
        "`{0}` tem vírgula decimal"
        "use ponto decimal: {1}";
    424 LceComment Warning
        "comments in LCE begin with //, but this one begins with {0}"
        "write // before each line"
        "um comentário da LCE começa com //, mas este começa com {0}"
        "escreva // antes de cada linha";
        }
    };
}
