//! Messages about Structured Text, and about names and types in all typed languages: codes 101 to 299.

macro_rules! st_rows {
    ($next:ident $($rest:tt)*) => {
        $next! { $($rest)*
    101 StStray Error
        "`{0}` is not a valid character in {1}"
        "delete it"
        "`{0}` não é um caractere válido em {1}"
        "apague-o";
    102 StCommentOpen Error
        "this comment is never closed, so the rest of the text is part of it"
        "close the comment with *), or with */ if it begins with /*"
        "este comentário não foi fechado, e o resto do texto faz parte dele"
        "feche o comentário com *), ou com */ se ele começa com /*";
    103 StTextOpen Error
        "this string has no closing {0} on the same line"
        "write {0} at the end of the string"
        "esta string não tem o {0} de fechamento na mesma linha"
        "escreva {0} no fim da string";
    104 StLiteral Error
        "`{0}` is not a valid {1}"
        "write it like {2}"
        "`{0}` não vale como {1}"
        "escreva como {2}";
    105 StOtherWord Error
        "`{0}` should be {1} here"
        "write {1}"
        "`{0}` deve ser {1} aqui"
        "escreva {1}";
    106 StExpected Error
        "{0} is missing before `{1}`"
        "{2}"
        "falta {0} antes de `{1}`"
        "{2}";
    107 StExpectedEnd Error
        "{0} is missing at the end of the text"
        "{1}"
        "falta {0} no fim do texto"
        "{1}";
    108 StNotClosed Error
        "this {0} has no {1}"
        "where this {0} should end, write {1};"
        "este {0} não tem {1}"
        "onde este {0} deve terminar, escreva {1};";
    109 StStrayEnd Error
        "`{0}` has no matching {1}"
        "delete it, or write {1} before it"
        "`{0}` não tem o {1} correspondente"
        "apague-o ou escreva {1} antes dele";
    110 StEqualsForAssign Error
        "`=` compares two values, but an assignment is needed here"
        "write {0} := …"
        "`=` compara dois valores, mas aqui é preciso uma atribuição"
        "escreva {0} := …";
    111 StAssignForEquals Error
        "`:=` assigns a value, but a comparison is needed here"
        "write ="
        "`:=` atribui um valor, mas aqui é preciso uma comparação"
        "escreva =";
    112 StNoEffect Error
        "the value of `{0}` is not used"
        "store it: x := {0};"
        "o valor de `{0}` não é usado"
        "guarde-o: x := {0};";
    113 StTooDeep Error
        "there are too many levels of nesting here"
        "use variables, functions or blocks for parts of the code"
        "há níveis demais de aninhamento aqui"
        "use variáveis, funções ou blocos para partes do código";
    114 StReserved Error
        "`{0}` is a keyword and cannot be a name"
        "choose another name, such as {0}1"
        "`{0}` é uma palavra-chave e não pode ser um nome"
        "escolha outro nome, como {0}1";
    115 StTypeFirst Error
        "in a declaration, the name comes first, then the type"
        "write {1} : {0};"
        "em uma declaração, o nome vem primeiro e depois o tipo"
        "escreva {1} : {0};";
    116 StPassedOver Warning
        "the tasks of this {0} are ignored: each PROGRAM runs once in every scan"
        "the board has no tasks; list the programs here in the order in which they should run"
        "as tarefas desta {0} são ignoradas: cada PROGRAM é executado uma vez por varredura"
        "a placa não tem tarefas; liste aqui os programas na ordem em que devem ser executados";
    117 StUnsupported Error
        "{0} cannot be used here"
        "{1}"
        "{0} não pode ser usado aqui"
        "{1}";
    118 StOutside Error
        "`{0}` is outside any program"
        "move it between PROGRAM and END_PROGRAM"
        "`{0}` está fora de qualquer programa"
        "coloque-o entre PROGRAM e END_PROGRAM";
    119 StLateDeclaration Error
        "`{0}` declares variables, but statements come before it"
        "move it up, before the first statement"
        "`{0}` declara variáveis, mas há comandos antes dele"
        "mova-o para cima, antes do primeiro comando";
    120 StNoProgram Error
        "there is no program: {0}"
        "write PROGRAM main, its statements, and END_PROGRAM"
        "não há programa: {0}"
        "escreva PROGRAM principal, os comandos e END_PROGRAM";
    121 StLongIf Error
        "this IF has too many ELSIF parts"
        "use CASE, or several IF statements: at most {0} can be nested, counting each ELSIF"
        "este IF tem ELSIF demais"
        "use CASE ou vários IF: no máximo {0} podem ser aninhados, contando cada ELSIF";
    122 StLongNames Error
        "the names of all parts of `{0}` are too long in total"
        "use shorter names or a smaller array"
        "os nomes de todas as partes de `{0}`, somados, são longos demais"
        "use nomes mais curtos, ou uma matriz menor";
    123 StForeignUnit Warning
        "`{0}` contains C code; it is ignored, because nothing uses it"
        "no change is needed"
        "`{0}` contém código em C; ele é ignorado, porque nada o usa"
        "não é preciso mudar nada";
    124 StForeignCode Error
        "`{0}` contains C code in braces, which the board does not run"
        "rewrite it in Structured Text, or delete the code that uses it"
        "`{0}` contém código em C entre chaves, que a placa não executa"
        "reescreva-o em Texto Estruturado, ou apague o código que o usa";
    125 StInputWritten Warning
        "this unit changes its own input `{0}`"
        "use a local variable instead: VAR x : INT; END_VAR"
        "esta unidade altera a sua própria entrada `{0}`"
        "use uma variável local: VAR x : INT; END_VAR";
    126 StInputFirst Warning
        "the board sets `{0}`, so its initial value is ignored"
        "remove the initial value: the board reads its inputs before the first scan"
        "a placa define o valor de `{0}`, e por isso o valor inicial é ignorado"
        "retire o valor inicial: a placa lê as entradas antes da primeira varredura";
    127 StMoved Warning
        "no board has the point `{0}`; on the PC it is `{1}`"
        "run unoclp adapt to create a copy with the points of a board"
        "nenhuma placa tem o ponto `{0}`; no PC ele é `{1}`"
        "execute unoclp adapt para criar uma cópia com os pontos de uma placa";
    128 StInputStored Warning
        "`{0}` is an input, and a value stored in it lasts only until the next scan"
        "the board reads its inputs before each scan; use a variable without an address"
        "`{0}` é uma entrada, e um valor guardado nela só dura até a próxima varredura"
        "a placa lê as entradas antes de cada varredura; use uma variável sem endereço";
    129 StLibrary Warning
        "there is no program here: functions and function blocks do nothing until a program calls them"
        "to run them, add PROGRAM main, its statements, and END_PROGRAM"
        "não há programa aqui: funções e blocos de funções não fazem nada até que um programa os chame"
        "para executá-los, acrescente PROGRAM principal, os comandos e END_PROGRAM";
    130 StUndeclared Error
        "`{0}` is not declared"
        "{1}"
        "`{0}` não foi declarado"
        "{1}";
    131 StNameTwice Error
        "`{0}` is declared twice"
        "rename one of the two"
        "`{0}` foi declarado duas vezes"
        "mude o nome em uma das declarações";
    132 StUnknownType Error
        "there is no type `{0}`"
        "{1}"
        "não existe o tipo `{0}`"
        "{1}";
    133 StNoMember Error
        "`{0}` has no member `{1}`"
        "{2}"
        "`{0}` não tem o membro `{1}`"
        "{2}";
    134 StNoValue Error
        "`{0}` is {1} and has no value of its own"
        "{2}"
        "`{0}` é {1} e não tem valor próprio"
        "{2}";
    135 StNotCallable Error
        "`{0}` cannot be called: it is {1}"
        "{2}"
        "`{0}` não pode ser chamado: é {1}"
        "{2}";
    136 StNotWritable Error
        "nothing can be stored in `{0}`: it is {1}"
        "{2}"
        "não se pode guardar nada em `{0}`: é {1}"
        "{2}";
    137 StRecursive Error
        "`{0}` {1} itself, directly or through others, which is not allowed"
        "break the cycle; to repeat, use FOR, WHILE or REPEAT"
        "`{0}` {1} a si mesmo, direta ou indiretamente, o que não é permitido"
        "desfaça o ciclo; para repetir, use FOR, WHILE ou REPEAT";
    138 StBadAddress Error
        "there is no point `{0}` on this board"
        "{1}"
        "não existe o ponto `{0}` nesta placa"
        "{1}";
    139 StAddressType Error
        "`{0}` is {1}, but the variable is {2}"
        "declare it as {3}"
        "`{0}` é {1}, mas a variável é {2}"
        "declare-a como {3}";
    140 StGeneric Error
        "`{0}` is a group of types, but a variable needs one type"
        "write one type, such as INT, REAL or BOOL"
        "`{0}` é um grupo de tipos, mas uma variável precisa de um só tipo"
        "escreva um tipo, como INT, REAL ou BOOL";
    141 StAmbiguous Error
        "`{0}` is a value of more than one enumeration"
        "write its type before it: {1}#{0}"
        "`{0}` é um valor de mais de uma enumeração"
        "escreva o tipo antes dele: {1}#{0}";
    142 StSamePoint Error
        "`{0}` and `{1}` both name {2}"
        "use one notation, or check which point you mean"
        "`{0}` e `{1}` são o mesmo ponto: {2}"
        "use uma só notação, ou confira qual ponto você quer";
    150 StMismatch Error
        "`{0}` is {1}, but {2} is needed here"
        "{3}"
        "`{0}` é {1}, mas aqui é preciso {2}"
        "{3}";
    151 StOperand Error
        "{0} needs {1}, but `{2}` is {3}"
        "{4}"
        "{0} precisa de {1}, mas `{2}` é {3}"
        "{4}";
    152 StNoCommon Error
        "{0} cannot combine {1} and {2}: one of them would lose part of its value"
        "convert one of them: {3}"
        "{0} não pode combinar {1} e {2}: um deles perderia parte do valor"
        "converta um deles: {3}";
    153 StOutOfRange Error
        "{0} does not fit in {1}, which goes from {2} to {3}"
        "use a number in range, or another type"
        "{0} não cabe em {1}, que vai de {2} a {3}"
        "use um valor da faixa ou outro tipo";
    154 StCondition Error
        "a condition must be TRUE or FALSE, but `{0}` is {1}"
        "compare it with a value: {0} {2}"
        "uma condição deve ser TRUE ou FALSE, mas `{0}` é {1}"
        "compare com um valor: {0} {2}";
    155 StDivisionByZero Error
        "this expression divides by 0"
        "use a divisor other than 0"
        "esta expressão divide por 0"
        "use um divisor diferente de 0";
    156 StSubscript Error
        "the subscript {0} is out of the range of `{1}`, which goes from {2} to {3}"
        "use a subscript from {2} to {3}, or declare a larger array"
        "o índice {0} está fora dos limites de `{1}`, que vão de {2} a {3}"
        "use um índice de {2} a {3} ou declare uma matriz maior";
    157 StDimensions Error
        "`{0}` takes {1}, but gets {2} here"
        "write {3}"
        "`{0}` usa {1}, mas aqui há {2}"
        "escreva {3}";
    158 StNotArray Error
        "`{0}` is {1} and takes no subscript"
        "declare it as ARRAY[1..10] OF {1}, or remove the [ ]"
        "`{0}` é {1} e não aceita índice"
        "declare-o como ARRAY[1..10] OF {1} ou tire os [ ]";
    159 StNotConstant Error
        "`{0}` must be a constant"
        "write a number, or a name declared with VAR CONSTANT"
        "`{0}` precisa ser uma constante"
        "escreva um número ou um nome declarado com VAR CONSTANT";
    160 StNoConversion Error
        "there is no conversion `{0}`"
        "{1}"
        "não existe a conversão `{0}`"
        "{1}";
    161 StInitial Error
        "`{0}` cannot have this initial value: {1}"
        "{2}"
        "`{0}` não pode ter este valor inicial: {1}"
        "{2}";
    162 StEmptyRange Error
        "the range {0}..{1} is empty"
        "write the smaller number first: {1}..{0}"
        "o intervalo {0}..{1} está vazio"
        "escreva o menor número primeiro: {1}..{0}";
    163 StTooLarge Error
        "`{0}` is too large: it has {1} values, and all variables together may have {2}"
        "use a smaller array"
        "`{0}` é grande demais: tem {1} valores, e todas as variáveis juntas podem ter {2}"
        "use uma matriz menor";
    164 StCaseTwice Error
        "{0} appears twice in this CASE"
        "delete one"
        "{0} aparece duas vezes neste CASE"
        "apague uma das ocorrências";
    165 StStepZero Error
        "with a step of 0, this loop never ends"
        "write BY 1 or BY -1"
        "com um passo de 0, este laço nunca termina"
        "escreva BY 1 ou BY -1";
    166 StForVariable Error
        "FOR needs a variable of an integer type, but `{0}` is {1}"
        "declare an integer variable for the loop: i : INT;"
        "FOR precisa de uma variável de tipo inteiro, mas `{0}` é {1}"
        "declare uma variável inteira para o laço: i : INT;";
    167 StForChanged Warning
        "`{0}` is the control variable of this FOR loop, so the loop must not change it"
        "change another variable, or write WHILE"
        "`{0}` é a variável de controle deste FOR, e o laço não deve mudá-la"
        "mude outra variável ou escreva WHILE";
    168 StNoLoop Error
        "{0} is not in a loop"
        "write it between FOR, WHILE or REPEAT and the end of the loop; use RETURN to leave the whole unit"
        "{0} não está em nenhum laço"
        "escreva-o entre FOR, WHILE ou REPEAT e o fim do laço; para sair da unidade inteira, use RETURN";
    169 StArguments Error
        "{0} takes {1}, but gets {2}"
        "{3}"
        "{0} recebe {1}, mas aqui há {2}"
        "{3}";
    170 StNoParameter Error
        "{0} has no parameter `{1}`"
        "{2}"
        "{0} não tem o parâmetro `{1}`"
        "{2}";
    171 StParameterTwice Error
        "the parameter `{0}` appears twice"
        "delete one"
        "o parâmetro `{0}` aparece duas vezes"
        "apague uma das ocorrências";
    172 StDirection Error
        "`{0}` is {1} of {2} and must be written with {3}"
        "write {0} {3} …"
        "`{0}` é {1} de {2} e precisa ser usada com {3}"
        "escreva {0} {3} …";
    173 StMixed Error
        "this call mixes parameters with and without names"
        "write the name of each: {0}"
        "esta chamada mistura parâmetros com nome e sem nome"
        "escreva o nome de cada um: {0}";
    174 StNeedsVariable Error
        "`{1}` needs a variable, but `{2}` is not one"
        "pass a variable of the same type"
        "`{1}` precisa de uma variável, mas `{2}` não é uma"
        "passe uma variável do mesmo tipo";
    175 StMissing Error
        "this call of {0} has no variable for `{1}`"
        "write {1} := …"
        "esta chamada de {0} não tem uma variável para `{1}`"
        "escreva {1} := …";
    176 StResultUnused Warning
        "the result of `{0}` is not used"
        "store it: x := {0}(…);"
        "o resultado de `{0}` não é usado"
        "guarde-o: x := {0}(…);";
    177 StNoResult Warning
        "the function `{0}` never stores its result"
        "store it before the end: {0} := …;"
        "a função `{0}` nunca guarda o seu resultado"
        "guarde-o antes do fim: {0} := …;";
    180 StTypeCalled Error
        "{0} is a function block type; a call needs an instance"
        "declare {1} : {0}; and then call {1}(…);"
        "{0} é um tipo de bloco de funções; a chamada precisa de uma instância"
        "declare {1} : {0}; e depois chame {1}(…);";
    181 StStateless Error
        "a function keeps no values between calls, so it cannot contain `{0}`"
        "make the function a FUNCTION_BLOCK"
        "uma função não guarda valores entre chamadas, por isso não pode conter `{0}`"
        "transforme a função em um FUNCTION_BLOCK";
    182 StBlockSubscript Error
        "the subscript of an array of blocks must be a constant"
        "write a number between the [ ]"
        "o índice de uma matriz de blocos deve ser constante"
        "escreva um número entre os [ ]";
    183 StSharedWhole Error
        "`{0}` is {1}; only single values can be compared or used in calculations"
        "use one of its parts: {2}"
        "`{0}` é {1}; só valores simples podem ser comparados ou usados em cálculos"
        "use uma das partes: {2}";
    184 StNothingWritten Warning
        "the program changes nothing: no statement stores a value or calls a block"
        "store a value: lamp := start;"
        "o programa não muda nada: nenhum comando guarda um valor nem chama um bloco"
        "guarde um valor: lampada := liga;";
    201 BoardType Error
        "the board does not support {1}, the type of `{0}`"
        "{2}; unoclp run supports all types"
        "a placa não aceita {1}, o tipo de `{0}`"
        "{2}; o unoclp run aceita todos os tipos";
    202 BoardLacks Error
        "the board does not support {0}"
        "{1}"
        "a placa não aceita {0}"
        "{1}";
    203 BoardNoneLeft Error
        "no {0} is left for {2}: the board has only {1}"
        "use fewer variables, or reuse one"
        "não há mais {0} livre para {2}: a placa só tem {1}"
        "use menos variáveis, ou reaproveite uma";
    204 BoardRow Error
        "`{0}` takes {1}, but the board has only {2} free"
        "make it smaller; an array with a computed subscript takes one register per element"
        "`{0}` ocupa {1}, mas o total livre é {2}"
        "diminua o tamanho; uma matriz com índice calculado ocupa um registrador por elemento";
    205 BoardRetain Error
        "the board cannot retain the {0} through a power cut"
        "store the values that matter in variables with RETAIN"
        "a placa não consegue reter o {0} em uma queda de energia"
        "guarde os valores que importam em variáveis com RETAIN";
    207 BoardLoop Error
        "in one scan, the loops up to this one jump back over {0} bytes of code, but the limit is {1}"
        "limit this loop to {2} iterations per scan, or spread the work over several scans"
        "em uma varredura, os laços até este voltam {0} bytes no código, mas o limite é {1}"
        "limite este laço a {2} voltas por varredura, ou divida o trabalho entre várias varreduras";
    208 BoardLoopOpen Warning
        "this loop has no fixed number of iterations; after about {0} iterations in a scan, the board stops with fault 75"
        "count with FOR between two constants, and leave the loop with EXIT"
        "este laço não tem um número fixo de voltas; depois de cerca de {0} voltas em uma varredura, a placa para com a falha 75"
        "use um FOR entre duas constantes e saia do laço com EXIT";
    209 BoardLabels Error
        "no label is left for this statement: the board has only {0}"
        "use fewer loops, or fewer EXIT, CONTINUE and RETURN statements"
        "não sobrou rótulo para este comando: a placa só tem {0}"
        "use menos laços, ou menos EXIT, CONTINUE e RETURN";
    210 BoardTooLarge Error
        "the program is far too large for the board, because each call copies a whole body"
        "call fewer or smaller blocks and functions"
        "o programa é grande demais para a placa, porque cada chamada copia um corpo inteiro"
        "chame menos blocos e funções, ou blocos e funções menores";
    221 BackNoWords Error
        "line {1}: Structured Text cannot express {0}"
        "list the program as Instruction List or numeric code"
        "linha {1}: o Texto Estruturado não consegue expressar {0}"
        "liste o programa em Lista de Instruções ou código numérico";
    222 BackIntoPart Error
        "line {1}: {0} jumps into a part of an IF, which Structured Text cannot express"
        "put the label before the IF or after its END"
        "linha {1}: {0} desvia para dentro de uma parte de um IF, o que o Texto Estruturado não consegue expressar"
        "ponha o rótulo antes do IF ou depois do seu END";
    223 BackTimerInLoop Error
        "line {1}: {0} is in a loop; the conversion supports timers only outside loops"
        "move the timer out of the loop"
        "linha {1}: {0} está em um laço; a conversão só aceita temporizadores fora de laços"
        "tire o temporizador do laço";
    224 BackEarlyTime Error
        "line {1}: {0} reads a timer before its call in this scan, or the timer's preset changes"
        "read it after the timer's call, and keep the preset constant"
        "linha {1}: {0} lê um temporizador antes da chamada dele nesta varredura, ou a pré-seleção dele muda"
        "leia-o depois da chamada do temporizador, e não mude a pré-seleção";
    225 BackNoRegister Error
        "no register is left for a number that is used both as a whole number and as a REAL"
        "use fewer registers"
        "não sobrou registrador para um número usado como inteiro e como REAL"
        "use menos registradores";
    226 BackPartOfArray Error
        "line {1}: {0} retains a part of a table, but Structured Text retains whole arrays"
        "retain a register outside the table"
        "linha {1}: {0} retém parte de uma tabela, mas o Texto Estruturado retém matrizes inteiras"
        "retenha um registrador fora da tabela";
    241 StNoStep Error
        "`{0}` is not a step of this chart"
        "{1}"
        "`{0}` não é uma etapa deste SFC"
        "{1}";
    242 StNoInitialStep Error
        "this chart has no initial step, so nothing in it would ever run"
        "change STEP to INITIAL_STEP in the step where the chart begins"
        "este SFC não tem etapa inicial, e nada nele seria executado"
        "troque STEP por INITIAL_STEP na etapa em que o SFC começa";
    243 StTwoInitialSteps Error
        "`{0}` and `{1}` are both initial steps of the same chart"
        "change INITIAL_STEP to STEP in one of them; steps that no transition connects to the others form a separate chart"
        "`{0}` e `{1}` são ambas etapas iniciais do mesmo SFC"
        "troque INITIAL_STEP por STEP em uma delas; etapas que nenhuma transição liga às outras formam um SFC à parte";
    244 StStepTwice Error
        "`{0}` appears twice in this list"
        "delete one"
        "`{0}` aparece duas vezes nesta lista"
        "apague uma das ocorrências";
    245 StNoAction Error
        "`{0}` is neither an action of this chart nor a BOOL variable"
        "{1}"
        "`{0}` não é uma ação deste SFC nem uma variável BOOL"
        "{1}";
    246 StQualifier Error
        "`{0}` is not an action qualifier"
        "write N, R, S, L, D, P, P0, P1, SD, DS or SL"
        "`{0}` não é um qualificador de ação"
        "escreva N, R, S, L, D, P, P0, P1, SD, DS ou SL";
    247 StTimeMissing Error
        "the qualifier {0} needs a time"
        "write {1}({0}, T#5s);"
        "o qualificador {0} precisa de um tempo"
        "escreva {1}({0}, T#5s);";
    248 StChartPlace Error
        "`{0}` is not allowed here: {1}"
        "{2}"
        "`{0}` não é permitido aqui: {1}"
        "{2}";
    249 StActionUnused Warning
        "no step uses the action `{0}`, so it is never executed"
        "write {0}(N); between STEP and END_STEP, or delete the action"
        "nenhuma etapa usa a ação `{0}`, e ela nunca é executada"
        "escreva {0}(N); entre STEP e END_STEP, ou apague a ação";
    250 StStepUnreached Warning
        "step `{0}` can never become active"
        "write a TRANSITION that leads to it"
        "a etapa `{0}` nunca fica ativa"
        "escreva uma TRANSITION que leve a ela";
    251 StNeverFires Warning
        "this transition can never fire: its steps ({0}) are never active together"
        "a simultaneous convergence needs a simultaneous divergence before it; after a selection, write one TRANSITION for each branch"
        "esta transição nunca pode disparar: as suas etapas ({0}) nunca estão ativas juntas"
        "uma convergência simultânea precisa de uma divergência simultânea antes; depois de uma seleção, escreva uma TRANSITION para cada ramo";
    252 StTokenDoubled Warning
        "this transition can enter step `{0}` while the step is active, so two sequences become one"
        "end simultaneous sequences together: TRANSITION FROM (a, b) TO c"
        "esta transição pode ativar a etapa `{0}` enquanto ela já está ativa, e duas sequências se fundem em uma"
        "termine juntas as sequências simultâneas: TRANSITION FROM (a, b) TO c";
    253 StChartStuck Warning
        "the chart can get stuck: with {0} active, no transition can ever fire"
        "let each simultaneous sequence reach its last step; do not leave one of them through a selection"
        "o SFC pode travar: com {0} em atividade, nenhuma transição pode disparar"
        "leve cada sequência simultânea até a última etapa; não saia de uma delas por uma seleção";
    254 StChartEnds Warning
        "the chart ends here: no transition leaves {0}"
        "write a TRANSITION that leaves this step, if the cycle is to begin again"
        "o SFC termina aqui: nenhuma transição sai de {0}"
        "escreva uma TRANSITION que saia desta etapa, se o ciclo deve recomeçar";
    255 StChartTooLarge Warning
        "this chart has too many situations to check: lost, doubled or stuck sequences may go unnoticed"
        "divide it into several charts, each in a FUNCTION_BLOCK"
        "este SFC tem situações demais para verificar todas: sequências perdidas, duplicadas ou travadas podem passar despercebidas"
        "divida-o em vários SFC, cada um em um FUNCTION_BLOCK";
    256 StTimeExtra Error
        "the qualifier {0} does not accept a time"
        "write {1}({0}); or a qualifier with a time: L, D, SD, DS, SL"
        "o qualificador {0} não aceita um tempo"
        "escreva {1}({0}); ou um qualificador com tempo: L, D, SD, DS, SL";
    257 StBitsCounted Warning
        "{0} is a bit string, and the standard defines no arithmetic for bit strings: here it is treated as {1}"
        "declare the variable as {1}"
        "{0} é uma cadeia de bits, e a norma não define cálculos com cadeias de bits: aqui ela é tratada como {1}"
        "declare a variável como {1}";
    258 StExternalOwn Warning
        "no VAR_GLOBAL declares `{0}`, so the program keeps its own copy, with the initial value of its type"
        "if another file declares it, add here: {1}"
        "nenhum VAR_GLOBAL declara `{0}`; o programa mantém uma cópia própria, com o valor inicial do seu tipo"
        "se outro arquivo o declara, acrescente aqui: {1}";
    259 StAccess Warning
        "{0} is ignored: other devices read this board over Modbus"
        "no change is needed; Modbus gives access to the points and registers"
        "{0} é ignorado: outros dispositivos leem esta placa por Modbus"
        "não é preciso mudar nada; o Modbus dá acesso aos pontos e registradores";
        }
    };
}
