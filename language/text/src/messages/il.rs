//! Messages about Instruction List: codes 11 to 99.

macro_rules! il_rows {
    ($next:ident $($rest:tt)*) => {
        $next! { $($rest)*
    11 StrayCharacter Error
        "`{0}` is not a valid character in Instruction List"
        "delete it"
        "`{0}` não é um caractere válido em Lista de Instruções"
        "apague-o";
    12 CommentOpen Error
        "this comment is never closed, so the rest of the text is part of it"
        "close the comment with *)"
        "este comentário não foi fechado, e o resto do texto faz parte dele"
        "feche o comentário com *)";
    13 CommentSpaced Warning
        "`* )` was read as the end of the comment, although it has a space in it"
        "write *) without the space"
        "`* )` foi lido como o fim do comentário, embora tenha um espaço"
        "escreva *) sem o espaço";
    14 BadNumber Error
        "`{0}` is neither a 32-bit number nor a time"
        "write numbers like 20, 2#1010 or 16#FF, and times like T#20s or T#1h2m3s4ms"
        "`{0}` não é um número de até 32 bits nem um tempo"
        "escreva números como 20, 2#1010 ou 16#FF, e tempos como T#20s ou T#1h2m3s4ms";
    15 Fraction Error
        "`{0}` has a fraction, but a whole number is needed here"
        "use a smaller unit (25 tenths for 2.5) or declare a REAL. For OMRON addresses like 0.00, use OMRON mnemonics"
        "`{0}` tem casas decimais, mas aqui é preciso um número inteiro"
        "use uma unidade menor (25 décimos para 2,5) ou declare um REAL. Para endereços da OMRON, como 0.00, use os mnemônicos dela";
    16 TimePrefix Error
        "`{0}` is a time, and times begin with T#"
        "write {1}"
        "`{0}` é um tempo, e tempos começam com T#"
        "escreva {1}";
    17 TimeUnit Error
        "`{0}` has no unit"
        "write {0}s for seconds, or {0}ms for milliseconds"
        "`{0}` está sem unidade"
        "escreva {0}s para segundos ou {0}ms para milissegundos";
    18 DecimalComma Error
        "`{0}` has a comma instead of a decimal point"
        "write {1}"
        "`{0}` tem uma vírgula no lugar do ponto decimal"
        "escreva {1}";
    19 Commented Warning
        "`{0}` is ignored: everything after ; is a comment"
        "put it on a line of its own; if it is a comment, write (* before it and *) after it"
        "`{0}` não é executado: tudo depois de ; é comentário"
        "ponha-o em uma linha própria; se for um comentário, escreva (* antes e *) depois";
    20 OtherWord Error
        "`{0}` is written {1} in Instruction List"
        "write {1}"
        "`{0}` se escreve {1} em Lista de Instruções"
        "escreva {1}";
    21 UnknownOperator Error
        "there is no operator `{0}`"
        "{1}"
        "não existe o operador `{0}`"
        "{1}";
    22 OperandMissing Error
        "{0} needs an operand"
        "write an operand after it, like {1}"
        "{0} precisa de um operando"
        "escreva um operando depois dele, como {1}";
    23 Unexpected Error
        "`{0}` was not expected here"
        "write each instruction on a line of its own: operator, operand, comment"
        "`{0}` não era esperado aqui"
        "escreva cada instrução em uma linha própria: operador, operando, comentário";
    24 BadModifier Error
        "{0} cannot have the modifier {1}"
        "use N to invert an operand, C with JMP, CAL or RET, and ( to defer an operation"
        "{0} não aceita o modificador {1}"
        "use N para inverter um operando, C com JMP, CAL ou RET e ( para adiar operações";
    25 BadLabel Error
        "`{0}` cannot be a label: use a letter, then letters, digits or _, at most 16 characters"
        "choose a shorter, simpler name"
        "`{0}` não pode ser um rótulo: use uma letra e depois letras, algarismos ou _, no máximo 16 caracteres"
        "escolha um nome mais curto e simples";
    26 LabelTwice Error
        "the label `{0}` appears twice, so a jump to it is ambiguous"
        "give one of them another name"
        "o rótulo `{0}` aparece duas vezes, e um desvio para ele seria ambíguo"
        "dê outro nome a um deles";
    27 NoSuchLabel Error
        "there is no label `{0}` to jump to"
        "{1}"
        "não existe o rótulo `{0}` para este desvio"
        "{1}";
    28 LabelColon Warning
        "`{0}` looks like a label, but its colon is missing"
        "write `{0}:`"
        "`{0}` parece um rótulo, mas faltam os dois-pontos"
        "escreva `{0}:`";
    29 Structure Error
        "the counterpart of {0} is missing"
        "{1}"
        "falta o par de {0}"
        "{1}";
    30 CommaMissing Error
        "a comma is missing before `{0}`"
        "write a comma between operands: TON T1, 100"
        "falta uma vírgula antes de `{0}`"
        "escreva uma vírgula entre operandos: TON T1, 100";
    31 CloseWithoutOpen Error
        "this ) has no matching (, so no operation is deferred here"
        "delete it, or write ( before it"
        "este ) não tem um ( correspondente, e aqui não há operação adiada"
        "apague-o ou escreva ( antes dele";
    32 LeftOpen Error
        "this ( is never closed, so the deferred operation never runs"
        "write ) on a line of its own where the operation ends"
        "este ( nunca é fechado, e a operação adiada nunca é executada"
        "escreva ) em uma linha própria onde a operação termina";
    33 TooDeep Error
        "more than 8 deferred operations are nested"
        "first store an intermediate result in a marker: ST M1"
        "há mais de 8 operações adiadas aninhadas"
        "guarde antes um resultado intermediário em uma memória: ST M1";
    34 InParentheses Error
        "{0} is not allowed between ( and )"
        "close the deferred operation first"
        "{0} não é permitido entre ( e )"
        "feche antes a operação adiada";
    35 NothingLoaded Error
        "the accumulator is empty here, so {0} has no value to work with"
        "begin with LD or LDN"
        "o acumulador está vazio aqui, e {0} não tem valor com que trabalhar"
        "comece com LD ou LDN";
    36 ColonMissing Error
        "a colon is missing before `{0}`"
        "{1}"
        "faltam os dois-pontos antes de `{0}`"
        "{1}";
    40 SamePoint Error
        "`{0}` and `{1}` both name {2}"
        "use one notation, or check which point you mean"
        "`{0}` e `{1}` são o mesmo ponto: {2}"
        "use uma só notação, ou confira qual ponto você quer";
    41 NoSuchPoint Error
        "there is no point `{0}` on this board"
        "{1}"
        "não existe o ponto `{0}` nesta placa"
        "{1}";
    42 Undeclared Warning
        "`{0}` is not declared, so it became the marker {1}"
        "{2}"
        "`{0}` não foi declarado e virou a memória {1}"
        "{2}";
    43 NameTwice Error
        "`{0}` is declared twice"
        "give one of them another name"
        "`{0}` foi declarado duas vezes"
        "dê outro nome a um deles";
    44 UnknownType Error
        "there is no type `{0}`"
        "use a type such as BOOL, INT or REAL, a block such as TON or CTU, or a type or FUNCTION_BLOCK of this file"
        "não existe o tipo `{0}`"
        "use um tipo como BOOL, INT ou REAL, um bloco como TON ou CTU, ou um tipo ou FUNCTION_BLOCK deste arquivo";
    45 NoSuchMember Error
        "{0} has no member `{1}`"
        "{2}"
        "{0} não tem o membro `{1}`"
        "{2}";
    46 NotCallable Error
        "`{0}` cannot be called"
        "{1}"
        "`{0}` não pode ser chamado"
        "{1}";
    47 NotWritable Error
        "nothing can be stored in {0}"
        "write to an output, a marker or a register, like Q1, M1 or D1"
        "não se pode armazenar nada em {0}"
        "escreva em uma saída, memória ou registrador, como Q1, M1 ou D1";
    48 StoreToInput Warning
        "{0} is an input: only its sensor can change it, so this store is ignored"
        "store to an output (Q1) or a marker (M1)"
        "{0} é uma entrada: só o sensor dela pode mudá-la, por isso este armazenamento é ignorado"
        "armazene em uma saída (Q1) ou em uma memória (M1)";
    49 NoneLeft Error
        "no {0} is left on the board for this operand"
        "use fewer names without an address, or fewer counters"
        "não sobrou {0} na placa para este operando"
        "use menos nomes sem endereço ou menos contadores";
    50 BadInitial Error
        "`{0}` cannot have the initial value `{1}`: {2}"
        "change the value, or store it in the program while S1 is 1, in the first scan"
        "`{0}` não pode ter o valor inicial `{1}`: {2}"
        "mude o valor ou armazene-o no programa enquanto S1 for 1, na primeira varredura";
    51 WrongType Error
        "{0} is {1}, but {2} is needed here"
        "to get a bit from a number, compare it: GT, GE, EQ …"
        "{0} é {1}, mas aqui é preciso {2}"
        "para obter um bit de um número, compare-o: GT, GE, EQ …";
    52 NoSuchParameter Error
        "{0} has no parameter `{1}`"
        "{2}"
        "{0} não tem o parâmetro `{1}`"
        "{2}";
    53 ParameterMissing Error
        "{0} needs {1}"
        "write it in the call: CAL T1 (IN:=%IX1, PT:=T#20s), or CAL C1 (CU:=%IX1, R:=%IX2, PV:=20)"
        "{0} precisa de {1}"
        "acrescente o parâmetro à chamada: CAL T1 (IN:=%IX1, PT:=T#20s), ou CAL C1 (CU:=%IX1, R:=%IX2, PV:=20)";
    54 PresetAssumed Warning
        "{0} has no preset; the compiler uses {1}, as on a Twido"
        "declare it: VAR {0} : {2} END_VAR"
        "{0} não tem pré-seleção; o valor usado é {1}, como em um Twido"
        "declare-a: VAR {0} : {2} END_VAR";
    55 RetentiveNumber Warning
        "on an S7-200, {0} is a retentive timer (TONR); here TON makes it an on-delay timer"
        "use T37 for an on-delay timer with steps of 100 ms, or write TONR"
        "no S7-200, {0} é um temporizador retentivo (TONR); aqui TON faz dele um temporizador com retardo na energização"
        "use T37 para um temporizador TON em passos de 100 ms, ou escreva TONR";
    56 Recursive Error
        "{0} calls itself, directly or through others, and would never end"
        "a function may only call others; for a loop, jump back"
        "{0} chama a si mesma, direta ou indiretamente, e nunca terminaria"
        "uma função só pode chamar outras; para formar um laço, use um desvio para trás";
    57 BadValue Error
        "{0} must be {1}"
        "change the number"
        "{0} deve ser {1}"
        "mude o número";
    58 NeverCalled Error
        "the program reads {0} but never starts it"
        "call it: CAL {0} (IN:=%IX1, PT:=T#20s)"
        "o programa lê {0}, mas nunca o aciona"
        "chame-o: CAL {0} (IN:=%IX1, PT:=T#20s)";
    59 CallsTooDeep Error
        "there are too many calls, or they are nested too deeply: each call copies a whole body into the program"
        "call fewer functions from within functions"
        "há chamadas demais, ou aninhadas demais: cada chamada copia um corpo inteiro para o programa"
        "chame menos funções de dentro de funções";
    60 Stateless Error
        "a function keeps no values between calls, so it cannot contain {0}"
        "make it a FUNCTION_BLOCK, and declare one instance for each call"
        "uma função não guarda valores entre chamadas, por isso não pode conter {0}"
        "transforme-a em um FUNCTION_BLOCK e declare uma instância para cada chamada";
    61 WrittenTwice Warning
        "{0} is written again here; only the last value of a scan reaches the output"
        "combine the conditions with OR and write it once, or use S and R"
        "{0} é escrito outra vez aqui; só o último valor da varredura chega à saída"
        "junte as condições com OR e escreva uma só vez, ou use S e R";
    62 TimerTwice Warning
        "{0} is called again here, and each call runs the same timer"
        "call it once, with its conditions joined by OR, or use another timer here"
        "{0} é chamado outra vez aqui, e cada chamada executa o mesmo temporizador"
        "chame-o uma só vez, com as condições unidas por OR, ou use outro temporizador aqui";
    63 NeverRead Warning
        "the input `{0}` is declared, but the program never reads it"
        "read it with LD {0}, or delete the declaration"
        "a entrada `{0}` foi declarada, mas o programa nunca a lê"
        "leia-a com LD {0} ou apague a declaração";
    64 Unreachable Warning
        "the program never gets here: it always jumps, returns or ends first"
        "write a label before this line, or delete the line"
        "o programa nunca chega aqui: antes ele sempre desvia, retorna ou termina"
        "escreva um rótulo antes desta linha ou apague-a";
    65 ResultUnused Warning
        "this result is never used: there is no ST before the next LD or the end"
        "store the result, or write AND or OR in place of the next LD"
        "este resultado nunca é usado: não há ST antes do próximo LD ou do fim"
        "armazene o resultado, ou escreva AND ou OR no lugar do próximo LD";
    66 Configuration Warning
        "CONFIGURATION is ignored: the board runs a single program, once in every scan"
        "delete it, except for its VAR_GLOBAL, which still applies"
        "CONFIGURATION é ignorada: a placa executa um só programa, uma vez por varredura"
        "apague-a, exceto o seu VAR_GLOBAL, que continua valendo";
    67 PresetZero Warning
        "{0} has no preset; the compiler uses 0"
        "write the preset in the call, as {1}, or declare it: VAR {0} : {2}; END_VAR"
        "{0} não tem pré-seleção; o valor usado é 0"
        "escreva a pré-seleção na chamada, como {1}, ou declare-a: VAR {0} : {2}; END_VAR";
    68 NoGlobal Warning
        "no VAR_GLOBAL in this text declares `{0}`, so it becomes a separate variable"
        "declare it in VAR_GLOBAL … END_VAR, before PROGRAM; it may have an address there"
        "nenhum VAR_GLOBAL deste texto declara `{0}`, que se torna uma variável à parte"
        "declare-a em VAR_GLOBAL … END_VAR, antes de PROGRAM; ali ela pode ter um endereço";
    69 Narrowed Warning
        "{0} does not fit in `{1}`, which is {2}; the value becomes {3}"
        "declare `{1}` as DINT, or store a number that fits in {2}"
        "{0} não cabe em `{1}`, que é {2}; o valor passa a ser {3}"
        "declare `{1}` como DINT ou armazene um número que caiba em {2}";
    71 DoesNotFit Error
        "from here on, the program does not fit on the board"
        "the board has {0} bytes of program memory and {1} bytes of run memory{2}. Use fewer timers and counters, or retain fewer numbers: each retained number is stored twice"
        "daqui em diante o programa não cabe na placa"
        "a placa tem {0} bytes de memória de programa e {1} bytes de memória de execução{2}. Use menos temporizadores e contadores, ou retenha menos números: cada número retido é guardado duas vezes";
    72 Refused Error
        "this line generates a code that is not allowed here: fault {0}, {1}"
        "correct the codes after CODE, pair PUSH with POP, or avoid REAL on a Nano; docs/faults.md explains the fault"
        "esta linha gera um código que não é permitido aqui: falha {0}, {1}"
        "corrija os códigos depois de CODE, use um POP para cada PUSH, ou evite REAL em um Nano; docs/faults.pt-BR.md explica a falha";
    73 PinTwice Error
        "the program also uses the pin of `{0}` for something else"
        "Q1 and QW1 share a pin, for example; on a UNO or Nano, so do I5 and IW0: use each pin for one purpose"
        "o programa também usa o pino de `{0}` para outra coisa"
        "Q1 e QW1, por exemplo, usam o mesmo pino; no UNO e no Nano, I5 e IW0 também: use cada pino para um só fim";
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
        "`{0}` is Structured Text, but this text is Instruction List"
        "write one operation on each line: LD I1, AND I2 and ST Q1 for Q1 := I1 AND I2"
        "`{0}` é Texto Estruturado, mas este texto é Lista de Instruções"
        "escreva uma operação por linha: LD I1, AND I2 e ST Q1 para Q1 := I1 AND I2";
    84 NumericCode Error
        "`{0}` is numeric code, but this text is Instruction List"
        "give the file a name that ends in .txt, or write CODE {0} to use one code in Instruction List"
        "`{0}` é código numérico, mas este texto é Lista de Instruções"
        "dê ao arquivo um nome que termine em .txt, ou escreva CODE {0} para usar um código na Lista de Instruções";
    85 NotRetained Error
        "`{0}` cannot be RETAIN: {1}"
        "declare it with VAR. You can retain numbers, counters, bistables, and BOOL variables without an address or at M57 to M64"
        "`{0}` não pode ser RETAIN: {1}"
        "declare-o com VAR. Podem ser retidos números, contadores, biestáveis e variáveis BOOL sem endereço ou em M57 a M64";
        }
    };
}
