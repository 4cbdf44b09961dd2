//! What is said about Instruction List: codes 11 to 99.

macro_rules! il_rows {
    ($next:ident $($rest:tt)*) => {
        $next! { $($rest)*
    11 StrayCharacter Error
        "`{0}` means nothing in Instruction List"
        "delete it"
        "`{0}` não significa nada em Lista de Instruções"
        "apague-o";
    12 CommentOpen Error
        "this comment is never closed, so all that follows is swallowed"
        "write *) at its end"
        "este comentário nunca fecha e por isso engole tudo o que vem depois"
        "escreva *) no fim dele";
    13 CommentSpaced Warning
        "the comment was closed at `* )`, which has a space in it"
        "write *) without the space"
        "o comentário foi fechado em `* )`, que tem um espaço"
        "escreva *) sem o espaço";
    14 BadNumber Error
        "`{0}` is not a number that fits 32 bits, and not a time"
        "numbers are like 20, 2#1010 or 16#FF; times like T#20s or T#1h2m3s4ms"
        "`{0}` não é um número de até 32 bits nem um tempo"
        "números são como 20, 2#1010 ou 16#FF; tempos como T#20s ou T#1h2m3s4ms";
    15 Fraction Error
        "`{0}` has a fraction, and the board's numbers are whole"
        "count in smaller parts, 25 tenths for 2.5; a point like 0.00 is OMRON's, whose words choose that dialect"
        "`{0}` tem casas decimais, e os números da placa são inteiros"
        "conte em partes menores, 25 décimos para 2,5; um ponto como 0.00 é da OMRON, cujas palavras escolhem esse dialeto";
    16 TimePrefix Error
        "`{0}` is a time, and a time begins with T#"
        "write {1}"
        "`{0}` é um tempo, e um tempo começa com T#"
        "escreva {1}";
    17 TimeUnit Error
        "`{0}` does not say its unit"
        "write {0}s for seconds, or {0}ms for milliseconds"
        "`{0}` não diz a sua unidade"
        "escreva {0}s para segundos ou {0}ms para milissegundos";
    18 DecimalComma Error
        "`{0}` has a comma where a point belongs"
        "write {1}"
        "`{0}` tem uma vírgula onde deve haver um ponto"
        "escreva {1}";
    19 Commented Warning
        "`{0}` is not done: what stands behind ; is a comment"
        "put it on a line of its own, or write (* before it and *) behind it if it is a comment"
        "`{0}` não é executado: o que fica depois de ; é comentário"
        "ponha-o em uma linha própria ou, se for comentário, escreva (* antes e *) depois";
    20 OtherWord Error
        "`{0}` is {1} in Instruction List"
        "write {1}"
        "`{0}` é {1} em Lista de Instruções"
        "escreva {1}";
    21 UnknownOperator Error
        "there is no operator `{0}`"
        "{1}"
        "não existe o operador `{0}`"
        "{1}";
    22 OperandMissing Error
        "{0} needs to know what it works on"
        "write an operand behind it, like {1}"
        "falta dizer com que {0} deve trabalhar"
        "escreva um operando depois dele, como {1}";
    23 Unexpected Error
        "`{0}` was not expected here"
        "each instruction stands on a line of its own: operator, operand, comment"
        "`{0}` não era esperado aqui"
        "cada instrução fica na sua própria linha: operador, operando, comentário";
    24 BadModifier Error
        "{0} cannot have the modifier {1}"
        "N inverts an operand, C makes a jump conditional, ( defers an operation"
        "{0} não aceita o modificador {1}"
        "N inverte um operando, C torna um desvio condicional, ( adia uma operação";
    25 BadLabel Error
        "`{0}` is no label: a letter, then letters, digits or _, at most 16 characters"
        "choose a shorter, simpler name"
        "`{0}` não serve de rótulo: uma letra, depois letras, números ou _, no máximo 16 caracteres"
        "escolha um nome mais curto e simples";
    26 LabelTwice Error
        "the label `{0}` stands twice, so a jump would not know where to go"
        "give one of them another name"
        "o rótulo `{0}` aparece duas vezes e um desvio não saberia para onde ir"
        "dê outro nome a um deles";
    27 NoSuchLabel Error
        "there is no label `{0}` here to jump to"
        "{1}"
        "não há aqui um rótulo `{0}` para onde desviar"
        "{1}";
    28 LabelColon Warning
        "`{0}` was taken as a label, but a colon is missing"
        "write `{0}:`"
        "`{0}` foi entendido como rótulo, mas faltam os dois-pontos"
        "escreva `{0}:`";
    29 Structure Error
        "{0} stands alone: its other half is missing"
        "{1}"
        "{0} está sozinho: falta o seu par"
        "{1}";
    30 CommaMissing Error
        "a comma is missing before `{0}`"
        "write a comma between operands: TON T1, 100"
        "falta uma vírgula antes de `{0}`"
        "escreva uma vírgula entre operandos: TON T1, 100";
    31 CloseWithoutOpen Error
        "this ) closes nothing: no operation has been deferred"
        "delete it, or write the ( that belongs to it"
        "este ) não fecha nada: nenhuma operação foi adiada"
        "apague-o ou escreva o ( que falta";
    32 LeftOpen Error
        "this ( is never closed, so the deferred operation is never done"
        "write ) on a line of its own where it ends"
        "este ( nunca é fechado e a operação adiada nunca é feita"
        "escreva ) em uma linha própria onde ela termina";
    33 TooDeep Error
        "more than 8 operations are deferred in one another"
        "store a part of it in a marker first: ST M1"
        "há mais de 8 operações adiadas umas dentro das outras"
        "guarde antes uma parte em uma memória: ST M1";
    34 InParentheses Error
        "{0} cannot stand between ( and )"
        "close the deferred operation first"
        "{0} não pode ficar entre ( e )"
        "feche antes a operação adiada";
    35 NothingLoaded Error
        "the accumulator holds nothing here for {0} to work on"
        "begin with LD or LDN"
        "o acumulador não contém nada com que {0} possa trabalhar aqui"
        "comece com LD ou LDN";
    36 ColonMissing Error
        "a colon is missing before `{0}`"
        "{1}"
        "faltam os dois-pontos antes de `{0}`"
        "{1}";
    40 SamePoint Error
        "`{0}` and `{1}` are the same {2}"
        "write it in one way only, or count again which point is meant"
        "`{0}` e `{1}` são o mesmo ponto: {2}"
        "escreva-o de um só modo, ou conte de novo qual ponto se quer";
    41 NoSuchPoint Error
        "there is no point `{0}` on this board"
        "{1}"
        "não existe o ponto `{0}` nesta placa"
        "{1}";
    42 Undeclared Warning
        "nothing says what `{0}` is; it was made a marker, {1}"
        "{2}"
        "nada diz o que é `{0}`; virou uma memória, {1}"
        "{2}";
    43 NameTwice Error
        "`{0}` is declared twice"
        "give one of them another name"
        "`{0}` foi declarado duas vezes"
        "dê outro nome a um deles";
    44 UnknownType Error
        "there is no type `{0}`"
        "use BOOL, INT, DINT, TIME, TON, TOF, TP, TONR, CTU, CTD, CTUD, R_TRIG, F_TRIG, SR, RS or a FUNCTION_BLOCK of this file"
        "não existe o tipo `{0}`"
        "use BOOL, INT, DINT, TIME, TON, TOF, TP, TONR, CTU, CTD, CTUD, R_TRIG, F_TRIG, SR, RS ou um FUNCTION_BLOCK deste arquivo";
    45 NoSuchMember Error
        "{0} has nothing called `{1}`"
        "{2}"
        "{0} não tem nada chamado `{1}`"
        "{2}";
    46 NotCallable Error
        "`{0}` cannot be called"
        "{1}"
        "`{0}` não pode ser chamado"
        "{1}";
    47 NotWritable Error
        "nothing can be stored in {0}"
        "outputs, markers and registers can be written, like Q1, M1 or D1"
        "não se pode armazenar nada em {0}"
        "saídas, memórias e registradores podem ser escritos, como Q1, M1 ou D1";
    48 StoreToInput Warning
        "{0} is an input: only its sensor can change it, so this store is left out"
        "store to an output (Q1) or a marker (M1)"
        "{0} é uma entrada: só o seu sensor pode mudá-la, por isso este armazenamento foi deixado de fora"
        "armazene em uma saída (Q1) ou em uma memória (M1)";
    49 NoneLeft Error
        "the board has no {0} left for this"
        "the program uses all of them; do with fewer"
        "não sobrou {0} na placa para isto"
        "o programa já usa todos; use menos";
    50 BadInitial Error
        "`{0}` cannot begin with `{1}`: {2}"
        "change the value, or store it in the program while S1 is 1, in the first scan"
        "`{0}` não pode começar com `{1}`: {2}"
        "mude o valor ou armazene-o no programa enquanto S1 for 1, na primeira varredura";
    51 WrongType Error
        "{0} is {1}, but {2} is needed here"
        "a comparison (GT, GE, EQ …) turns numbers into true or false"
        "{0} é {1}, mas aqui é preciso {2}"
        "uma comparação (GT, GE, EQ …) transforma números em verdadeiro ou falso";
    52 NoSuchParameter Error
        "{0} has no parameter `{1}`"
        "{2}"
        "{0} não tem o parâmetro `{1}`"
        "{2}";
    53 ParameterMissing Error
        "{0} needs {1}"
        "write it: CAL T1 (IN:=%IX1, PT:=T#20s), or CAL C1 (CU:=%IX1, R:=%IX2, PV:=20)"
        "{0} precisa de {1}"
        "escreva-o: CAL T1 (IN:=%IX1, PT:=T#20s), ou CAL C1 (CU:=%IX1, R:=%IX2, PV:=20)";
    54 PresetAssumed Warning
        "nothing says the preset of {0}; it was taken to be {1}, as a Twido would"
        "declare it: VAR {0} : {2} END_VAR"
        "nada diz a pré-seleção de {0}; foi tomada como {1}, como em um Twido"
        "declare-a: VAR {0} : {2} END_VAR";
    55 RetentiveNumber Warning
        "on an S7-200, {0} is a retentive timer (TONR); here it is an on-delay timer as TON says"
        "use T37 for an on-delay timer of 100 ms steps, or write TONR"
        "no S7-200, {0} é um temporizador retentivo (TONR); aqui ele é um retardo na energização, como diz TON"
        "use T37 para um temporizador TON em passos de 100 ms, ou escreva TONR";
    56 Recursive Error
        "{0} calls itself, directly or by way of another, and would never end"
        "a function may only call others; use a jump back for a loop"
        "{0} chama a si mesma, direta ou indiretamente, e nunca terminaria"
        "uma função só pode chamar outras; para repetir, use um desvio para trás";
    57 BadValue Error
        "{0} must be {1}"
        "change the number"
        "{0} deve ser {1}"
        "mude o número";
    58 NeverCalled Error
        "{0} is read, but nothing ever starts it"
        "call it: CAL {0} (IN:=%IX1, PT:=T#20s)"
        "{0} é lido, mas nada o aciona"
        "chame-o: CAL {0} (IN:=%IX1, PT:=T#20s)";
    59 CallsTooDeep Error
        "calls go too deep here, or there are too many: each puts a body into the program"
        "call fewer functions from one another"
        "as chamadas vão fundo demais aqui, ou são muitas: cada uma põe um corpo no programa"
        "chame menos funções umas das outras";
    60 Stateless Error
        "a function keeps nothing from one call to the next, so {0} cannot stand in it"
        "make it a FUNCTION_BLOCK, and declare one instance for each place"
        "uma função não guarda nada de uma chamada para a outra, por isso {0} não pode ficar nela"
        "faça dela um FUNCTION_BLOCK e declare uma instância para cada lugar";
    61 WrittenTwice Warning
        "{0} is written again here; only the last store in a scan is seen at the output"
        "combine the conditions with OR and write it once, or use S and R"
        "{0} é escrito outra vez aqui; só o último armazenamento da varredura aparece na saída"
        "junte as condições com OR e escreva uma só vez, ou use S e R";
    62 TimerTwice Error
        "{0} is called again here, and a timer has one place in the program"
        "call it once, with its conditions joined by OR, or use another timer here"
        "{0} é chamado outra vez aqui, e um temporizador tem um só lugar no programa"
        "chame-o uma só vez, com as condições unidas por OR, ou use outro temporizador aqui";
    63 NeverRead Warning
        "the input `{0}` is declared, but the program never reads it"
        "read it with LD {0}, or delete the declaration"
        "a entrada `{0}` foi declarada, mas o programa nunca a lê"
        "leia-a com LD {0} ou apague a declaração";
    64 Unreachable Warning
        "nothing ever comes here: the program has jumped away above"
        "write a label before it, or delete it"
        "o programa nunca chega aqui: um desvio acima o levou para outro lugar"
        "escreva um rótulo antes desta linha ou apague-a";
    65 ResultUnused Warning
        "the result of this is never used: no ST follows before the next LD or the end"
        "store it, or use AND or OR in place of the LD that follows"
        "o resultado disto nunca é usado: não há ST antes do próximo LD ou do fim"
        "armazene-o, ou use AND ou OR no lugar do LD que segue";
    66 Configuration Warning
        "CONFIGURATION was passed over: the board runs one program, in every scan"
        "delete it; what its VAR_GLOBAL declares is kept"
        "CONFIGURATION foi ignorada: a placa executa um só programa, em cada varredura"
        "apague-a; o que o VAR_GLOBAL dela declara foi mantido";
    67 PresetZero Warning
        "nothing says the preset of {0}, so it is 0"
        "write it in the call, as {1}, or declare it: VAR {0} : {2}; END_VAR"
        "nada diz a pré-seleção de {0}, por isso ela é 0"
        "escreva-a na chamada, como {1}, ou declare-a: VAR {0} : {2}; END_VAR";
    68 NoGlobal Warning
        "no VAR_GLOBAL of this text declares `{0}`, so it was given a place of its own"
        "declare it in VAR_GLOBAL … END_VAR, before PROGRAM, where it may also have an address"
        "nenhum VAR_GLOBAL deste texto declara `{0}`, por isso ela ganhou um lugar próprio"
        "declare-a em VAR_GLOBAL … END_VAR, antes de PROGRAM, onde também pode ter um endereço";
    69 Narrowed Warning
        "{0} does not fit `{1}`, which is {2}: it keeps {3}"
        "declare `{1}` as DINT, or store a number that {2} holds"
        "{0} não cabe em `{1}`, que é {2}: ela fica com {3}"
        "declare `{1}` como DINT ou armazene um número que {2} comporte";
    71 DoesNotFit Error
        "from here on the program does not fit the board"
        "it holds {0} bytes of program and has {1} bytes to run it{2}. Timers and counters take the most; what is kept takes room for two records"
        "daqui em diante o programa não cabe na placa"
        "ela guarda {0} bytes de programa e tem {1} bytes para executá-lo{2}. Temporizadores e contadores ocupam mais; o que é retido precisa de lugar para duas gravações";
    72 Refused Error
        "a code that comes of this cannot stand here: fault {0}, {1}"
        "mend the codes behind CODE, or leave REAL out for a Nano; docs/faults.md explains the fault"
        "um código que resulta disto não pode ficar aqui: falha {0}, {1}"
        "corrija os códigos depois de CODE, ou tire REAL se for para um Nano; docs/faults.pt-BR.md explica a falha";
    73 PinTwice Error
        "the pin of `{0}` is used in another way too"
        "I5 to I8 are the pins of IW0 to IW3, Q1 and Q4 those of QW1 and QW4: use each pin in one way"
        "o pino de `{0}` também é usado de outro modo"
        "I5 a I8 são os pinos de IW0 a IW3, e Q1 e Q4 os de QW1 e QW4: use cada pino de um só modo";
    81 NoProgram Error
        "there is no program: {0}"
        "write at least an LD and an ST: LD I1, and ST Q1 on the next line"
        "não há programa: {0}"
        "escreva pelo menos um LD e um ST: LD I1 e, na linha seguinte, ST Q1";
    82 NothingWritten Warning
        "the program writes nothing: no output, marker or register ever changes"
        "store the result: ST Q1"
        "o programa não escreve nada: nenhuma saída, memória ou registrador muda"
        "armazene o resultado: ST Q1";
    83 StructuredText Error
        "`{0}` is Structured Text, and Instruction List is read here"
        "write one operation on each line: LD I1, AND I2 and ST Q1 for Q1 := I1 AND I2"
        "`{0}` é Texto Estruturado, e aqui se lê Lista de Instruções"
        "escreva uma operação por linha: LD I1, AND I2 e ST Q1 para Q1 := I1 AND I2";
    84 NumericCode Error
        "`{0}` is numeric code, and Instruction List is read here"
        "give the file a name that ends in .txt, or write CODE {0} for a code in a text"
        "`{0}` é código numérico, e aqui se lê Lista de Instruções"
        "dê ao arquivo um nome que termine em .txt, ou escreva CODE {0} para um código em um texto";
    85 NotRetained Error
        "`{0}` cannot be RETAIN: {1}"
        "declare it with VAR; a number, a counter, and a BOOL without an address can be kept"
        "`{0}` não pode ser RETAIN: {1}"
        "declare com VAR; podem ser retidos um número, um contador e um BOOL sem endereço";
        }
    };
}
