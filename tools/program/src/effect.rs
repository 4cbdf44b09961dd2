//! What each instruction does, in the two languages that the tools speak: in English the instruction table says it.

use unoclp_core::isa::Opcode;
use unoclp_lang::Lang;

/// What an instruction does, with `XX`, `register XX` and `operand` as in the instruction table, in Portuguese
/// `registrador XX` and `operando`.
pub(crate) const fn effect(opcode: Opcode, lang: Lang) -> &'static str {
    match lang {
        Lang::En => opcode.row().effect,
        Lang::Pt => portuguese(opcode),
    }
}

/// One arm for each, so that the compiler names one that is missing.
const fn portuguese(opcode: Opcode) -> &'static str {
    match opcode {
        Opcode::NewRung => {
            "novo degrau: acc := 1; apaga os pontos de ramificação do degrau anterior"
        }
        Opcode::OpenBranch => "abre um ramo OR: empilha acc; acc := 1",
        Opcode::CloseBranch => {
            "fecha o ramo: acc := valor desempilhado OR acc; depois de 6540 AND, depois de 8840 XOR"
        }
        Opcode::OnDelay => "retardo na energização: IN = acc; acc := Q; saída := Q",
        Opcode::OffDelay => "retardo na desenergização: IN = acc; acc := Q; saída := Q",
        Opcode::Not => "acc := NOT acc",
        Opcode::RisingEdge => "acc := 1 se acc subiu desde a última vez neste código",
        Opcode::FallingEdge => "acc := 1 se acc desceu desde a última vez neste código",
        Opcode::OpenAnd => "abre um bloco AND: empilha acc; acc := 1",
        Opcode::OpenXor => "abre um bloco XOR: empilha acc; acc := 1",
        Opcode::Return => {
            "retorno: se acc = 1, o resto do programa não é executado nesta varredura"
        }
        Opcode::ReturnNot => {
            "retorno: se acc = 0, o resto do programa não é executado nesta varredura"
        }
        Opcode::Negate => "valor := -valor",
        Opcode::SquareRoot => {
            "valor := raiz quadrada inteira do valor; se for negativo: 0, e S 04 := 1"
        }
        Opcode::Pulse => "pulso: IN = acc; acc := Q; saída := Q",
        Opcode::InputContact => "contato normalmente aberto: acc := acc AND entrada XX",
        Opcode::InputContactNot => "contato normalmente fechado: acc := acc AND NOT entrada XX",
        Opcode::OutputContact => "contato: acc := acc AND saída XX, como está agora na imagem",
        Opcode::OutputContactNot => {
            "contato: acc := acc AND NOT saída XX, como está agora na imagem"
        }
        Opcode::Coil => "bobina: saída XX := acc",
        Opcode::SetCoil => "bobina de set: se acc = 1, saída XX := 1",
        Opcode::ResetCoil => "bobina de reset: se acc = 1, saída XX := 0",
        Opcode::StoreBranch => "guarda acc como ponto de ramificação XX",
        Opcode::RecallBranch => {
            "logo depois de 40, 6540 ou 8840: acc := conteúdo do ponto de ramificação XX"
        }
        Opcode::RetentiveOnDelay => {
            "retardo na energização retentivo: IN = acc; acc := Q; saída := Q"
        }
        Opcode::NegatedCoil => "bobina negada: saída XX := NOT acc",
        Opcode::MarkerContact => "contato: acc := acc AND memória XX",
        Opcode::MarkerContactNot => "contato: acc := acc AND NOT memória XX",
        Opcode::SystemContact => "contato: acc := acc AND memória de sistema XX",
        Opcode::SystemContactNot => "contato: acc := acc AND NOT memória de sistema XX",
        Opcode::TimerContact => "contato: acc := acc AND Q do temporizador XX",
        Opcode::TimerContactNot => "contato: acc := acc AND NOT Q do temporizador XX",
        Opcode::CounterContact => "contato: acc := acc AND (contador XX chegou à sua pré-seleção)",
        Opcode::CounterContactNot => {
            "contato: acc := acc AND NOT (contador XX chegou à sua pré-seleção)"
        }
        Opcode::ZeroContact => "contato: acc := acc AND (contador XX é 0 ou menos)",
        Opcode::ZeroContactNot => "contato: acc := acc AND NOT (contador XX é 0 ou menos)",
        Opcode::XorInput => "acc := acc XOR entrada XX",
        Opcode::XorInputNot => "acc := acc XOR NOT entrada XX",
        Opcode::XorOutput => "acc := acc XOR saída XX, como está agora na imagem",
        Opcode::XorOutputNot => "acc := acc XOR NOT saída XX, como está agora na imagem",
        Opcode::XorMarker => "acc := acc XOR memória XX",
        Opcode::XorMarkerNot => "acc := acc XOR NOT memória XX",
        Opcode::MarkerCoil => "bobina: memória XX := acc",
        Opcode::NegatedMarkerCoil => "bobina negada: memória XX := NOT acc",
        Opcode::SetMarker => "bobina de set: se acc = 1, memória XX := 1",
        Opcode::ResetMarker => "bobina de reset: se acc = 1, memória XX := 0",
        Opcode::ResetTimer => "reset: se acc = 1, o temporizador XX volta ao estado inicial",
        Opcode::ResetCounter => "reset: se acc = 1, contador XX := 0",
        Opcode::LoadCounter => "carga: se acc = 1, contador XX := sua pré-seleção",
        Opcode::CountUp => {
            "contador crescente: se acc subiu, contador XX + 1; acc := (contador XX chegou à sua pré-seleção)"
        }
        Opcode::CountDown => {
            "contador decrescente: se acc subiu, contador XX - 1; acc := (contador XX é 0 ou menos)"
        }
        Opcode::Load => "valor := registrador XX",
        Opcode::LoadAnalogue => "valor := entrada analógica A XX, 0 a 1023",
        Opcode::LoadTimer => "valor := tempo decorrido do temporizador XX, ms",
        Opcode::LoadCount => "valor := contador XX",
        Opcode::LoadSystem => {
            "valor := leitura do sistema XX: 01 duração da última varredura em µs, 02 instante desta varredura em ms"
        }
        Opcode::LoadMarkers => "valor := oito memórias como bits: o grupo 01 é M 01 a M 08",
        Opcode::LoadInputs => "valor := todas as entradas como bits, a entrada 01 no bit 0",
        Opcode::LoadOutputs => "valor := todas as saídas como bits, a saída 01 no bit 0",
        Opcode::LoadBit => "valor := acc",
        Opcode::Store => "se acc = 1, registrador XX := valor",
        Opcode::StoreCount => "se acc = 1, contador XX := valor",
        Opcode::StorePwm => "se acc = 1, PWM da saída XX := valor, limitado entre 0 e 255",
        Opcode::StoreMarkers => "se acc = 1, oito memórias := bits 0 a 7 do valor",
        Opcode::StoreOutputs => "se acc = 1, todas as saídas := bits do valor, a partir do bit 0",
        Opcode::PresetCounter => "se acc = 1, pré-seleção do contador XX := valor, no mínimo 0",
        Opcode::PresetTimer => "se acc = 1, pré-seleção do temporizador XX := valor, no mínimo 0",
        Opcode::Add => "valor := valor + operando",
        Opcode::Subtract => "valor := valor - operando",
        Opcode::Multiply => "valor := valor * operando",
        Opcode::Divide => "valor := valor / operando, sem a fração; divisão por 0: 0, e S 04 := 1",
        Opcode::Modulo => "valor := resto de valor / operando; divisão por 0: 0, e S 04 := 1",
        Opcode::AndWord => "valor := valor AND operando, bit a bit",
        Opcode::OrWord => "valor := valor OR operando, bit a bit",
        Opcode::XorWord => "valor := valor XOR operando, bit a bit",
        Opcode::ShiftLeft => "valor := valor deslocado XX bits para a esquerda",
        Opcode::ShiftRight => "valor := valor deslocado XX bits para a direita; entram zeros",
        Opcode::Greater => "comparação: acc := acc AND (valor > operando)",
        Opcode::GreaterOrEqual => "comparação: acc := acc AND (valor >= operando)",
        Opcode::Equal => "comparação: acc := acc AND (valor = operando)",
        Opcode::NotEqual => "comparação: acc := acc AND (valor <> operando)",
        Opcode::LessOrEqual => "comparação: acc := acc AND (valor <= operando)",
        Opcode::Less => "comparação: acc := acc AND (valor < operando)",
        Opcode::BitContact => "contato: acc := acc AND bit XX do valor",
        Opcode::BitContactNot => "contato: acc := acc AND NOT bit XX do valor",
        Opcode::Move => "cópia em bloco: se acc = 1, copia registradores a partir de XX",
        Opcode::Drum => {
            "sequenciador: se acc = 1, saídas 01-04 := passo indicado pelo registrador XX"
        }
        Opcode::Scale => "escala linear: converte o valor de uma faixa para outra",
        Opcode::Filter => "filtro de primeira ordem: suaviza o valor com intensidade XX",
        Opcode::Integrate => "integração: se acc = 1, soma ao registrador XX o valor por segundo",
        Opcode::InputFilter => {
            "filtro de entrada: uma mudança só vale depois que a entrada mantém o nível por XX ms"
        }
        Opcode::Label => "rótulo XX, no início de um degrau",
        Opcode::Jump => "desvio: se acc = 1, continua no rótulo XX",
        Opcode::JumpNot => "desvio: se acc = 0, continua no rótulo XX",
        Opcode::KeepRegister => {
            "o registrador XX mantém o seu valor em STOP e em uma queda de energia"
        }
        Opcode::KeepCounter => {
            "o contador XX mantém a sua contagem em STOP e em uma queda de energia"
        }
        Opcode::Push => {
            "empilha o valor; uma operação com o número 99 o usa como operando esquerdo"
        }
        Opcode::RealAdd => "REAL: valor := valor + operando; se não for finito: 0, e S 04 := 1",
        Opcode::RealSubtract => {
            "REAL: valor := valor - operando; se não for finito: 0, e S 04 := 1"
        }
        Opcode::RealMultiply => {
            "REAL: valor := valor * operando; se não for finito: 0, e S 04 := 1"
        }
        Opcode::RealDivide => "REAL: valor := valor / operando; se não for finito: 0, e S 04 := 1",
        Opcode::RealFromSigned => "converte o valor, um inteiro com sinal, em REAL",
        Opcode::RealFromUnsigned => "converte o valor, um inteiro sem sinal, em REAL",
        Opcode::RealRound => {
            "arredonda o valor, um REAL, ao inteiro mais próximo, e uma metade ao par; além de 32 bits: 0, e S 04 := 1"
        }
        Opcode::RealCut => "corta a fração do valor, um REAL; além de 32 bits: 0, e S 04 := 1",
        Opcode::RealNegate => "REAL: valor := -valor",
        Opcode::RealAbsolute => "REAL: valor := valor sem o sinal",
        Opcode::RealRoot => {
            "REAL: valor := raiz quadrada do valor; se for negativo: 0, e S 04 := 1"
        }
        Opcode::RealComparable => "valor := um inteiro que conserva a ordem dos números REAL",
        Opcode::LoadTable => "valor := registrador XX + valor; fora da tabela: 0, e S 04 := 1",
        Opcode::StoreTable => {
            "se acc = 1, registrador XX + o valor empilhado := valor; fora da tabela: S 04 := 1"
        }
        Opcode::ExtendSign => "valor := seus XX bits menos significativos; o mais alto é o sinal",
        Opcode::ExtendZero => "valor := seus XX bits menos significativos",
        Opcode::UnsignedDivide => {
            "valor := valor / operando, ambos sem sinal; divisão por 0: 0, e S 04 := 1"
        }
        Opcode::UnsignedModulo => {
            "valor := resto de valor / operando, ambos sem sinal; divisão por 0: 0, e S 04 := 1"
        }
        Opcode::UnsignedGreaterOrEqual => {
            "comparação: acc := acc AND (valor >= operando), ambos sem sinal"
        }
        Opcode::UnsignedLess => "comparação: acc := acc AND (valor < operando), ambos sem sinal",
        Opcode::If => {
            "se acc = 1, continua aqui; senão, continua depois do ELS ou END correspondente; novo degrau"
        }
        Opcode::Else => "se acc era 0 no IF correspondente, continua aqui; novo degrau",
        Opcode::EndIf => "o fim de um IF; novo degrau",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_translated_page_has_every_effect() {
        let page = include_str!("../../../docs/numeric-code.pt-BR.md");
        for &opcode in Opcode::ALL {
            let (text, stored) = (effect(opcode, Lang::Pt), opcode.row().stored);
            let cells = format!("| {text} | `{stored:02X}` |");
            assert!(
                page.contains(&cells),
                "docs/numeric-code.pt-BR.md has no {cells}"
            );
        }
    }

    #[test]
    fn every_effect_has_the_operands_of_its_twin() {
        for &opcode in Opcode::ALL {
            let (english, portuguese) = (effect(opcode, Lang::En), effect(opcode, Lang::Pt));
            for [one, other] in [["XX", "XX"], ["operand", "operando"], ["acc", "acc"]] {
                let counts = [
                    english.matches(one).count(),
                    portuguese.matches(other).count(),
                ];
                assert_eq!(counts[0], counts[1], "{one} in {english}\n{portuguese}");
            }
        }
    }
}
